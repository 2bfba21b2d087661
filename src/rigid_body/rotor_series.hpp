#pragma once

// The rotation by theta functions: sn, cn, dn of u, and the angle about J.
//
// Write q for the nome of m, p for that of 1-m, log p log q = pi^2, K = K(m), K' = K(1-m),
// theta_j(z) for the theta functions of nome q and theta_j(z, p) for those of nome p. Since m <=
// 1/2 or 1-m <= 1/2, one of q and p is at most e^-pi = 0.0432...; that one is used, in the
// *circular* form (nome q, for m <= 1/2) or in the *hyperbolic* form (nome p), of which the
// separatrix, p = 0, is a case.
//
// THE ANGLE. With x = J_x^2/(J_x^2+J_y^2) and kappa of rotor.hpp, J_x^2 + J_y^2 = A^2 (1 + kappa
// sn^2) and
//   x = 1 - nu sn^2/(1 + kappa sn^2),   nu = m + kappa (oscillating),
//     1 + kappa (rotating and separatrix):
// oscillating, J_x^2 + J_y^2 = 1 - C^2 cn^2 with A^2 + C^2 = 1, kappa = C^2/A^2; rotating, 1 - C^2
// dn^2 with C^2 m/A^2 = b/a. So
//   phi' = dphi/dt = 1 - b x = 1 - b + (b nu/kappa) kappa sn^2/(1 + kappa sn^2).
// 1 + kappa sn^2 is 0 at u = +-i alpha, sc(alpha | 1-m) = 1/sqrt kappa, 0 < alpha < K'. Let z = pi
// u/(2K), eta = pi alpha/(2K), and Z = theta_1'/theta_1. The function h(z) = (Z(z + i eta) - Z(z -
// i eta))/2 - Z(i eta) has the periods pi and pi tau (Z grows by -2i along the second, DLMF
// 20.2(ii)), two simple poles, at -+i eta, and a double zero at 0, since Z is odd: so it is a
// multiple of kappa sn^2/(1 + kappa sn^2). Where sn is infinite, z = pi tau/2, that is 1 and Z(z +
// .) = -i + theta_4'/theta_4, so
//   h = R kappa sn^2/(1 + kappa sn^2),   R = (theta_4'/theta_4)(i eta) - Z(i eta)
//     = -(2K/pi) cn dn/sn (i alpha)
// (the logarithmic derivative of sn = const theta_1/theta_4), which is (2K/pi) i D, D = dn/(sn cn)
// (alpha | 1-m) by Jacobi's imaginary transformation. Let Y = i Z(i eta), real. Integrated, (Z(z+i
// eta) - Z(z-i eta))/2 is i arg theta_1(z + i eta), which is pi/2 at z = 0:
//   integral of kappa sn^2/(1 + kappa sn^2) dz = (arg theta_1(z + i eta) - pi/2 + Y z)/((2K/pi) D),
// and with t = u/lambda = 2K z/(pi lambda)
//   phi = (1-b) t + (b nu/(kappa lambda D)) (arg theta_1(z + i eta) - pi/2 + Y z).
// The factor is 1: sn^2 = 1/(1+kappa), cn^2 = kappa/(1+kappa), dn^2 = (m+kappa)/(1+kappa) of (alpha
// | 1-m), so D^2 = (m+kappa)(1+kappa)/kappa; oscillating, 1 + kappa = (a+b)/(a-c), m + kappa =
// (b+c)(a+b)/(b(a-c)); rotating, 1 + kappa = (a+b)/a, m + kappa = b(a+b)/(a(b+c)); and with
// lambda^2 of rotor.hpp (b nu/(kappa lambda))^2 = D^2 in both. Hence
//
//   phi = mu t + arg theta_1(z + i eta) - pi/2,      mu = 1 - b + (pi lambda/(2K)) Y,
//     (circular)
//   phi = mu' t + arg theta_1(beta - i v, p),        mu' = 1 - b + (pi lambda/(2K')) Z(beta, p),
//     (hyperbolic)
//
// the second by theta_1(z) = const exp(i tau' z^2/pi) theta_1(tau' z, p), tau' = i K/K' (DLMF
// 20.7.30), where v = pi u/(2K'), beta = pi alpha/(2K') in (0, pi/2): the argument of the
// exponential at z + i eta is -(alpha/K') z, and Y = (K/K')(alpha/K + Z(beta, p)), so that the
// terms in alpha cancel. The argument grows by -gamma with u by 2K: gamma = pi in the circular form
// (theta_1(z + pi) = -theta_1(z)), and pi - 2 beta in the hyperbolic form: theta_1(w - pi tau') =
// -e^(2iw)/p theta_1(w) turns it by 2 beta + pi but for whole turns, and from p = 0, where it is -2
// (pi/2 - beta), these do not change. So with u = 2K(N + w), |w| <= 1/2 or little more, all is had
// at |w|, and arg = -atan2(X, Y) - N gamma.
//
// CIRCULAR SERIES, z = pi w, with e_n = 2 cos 2nz, U_n = sin((2n+1)z)/sin z = U_(n-1) + e_n, V_n =
// cos((2n+1)z)/cos z = e_n - V_(n-1):
//   theta_1/(2 q^(1/4)) = sin z sum (-1)^n q^(n(n+1)) U_n,  theta_2/(2 q^(1/4)) = cos z sum
//   q^(n(n+1)) V_n, theta_3, theta_4 = 1 + sum (+-1)^n q^(n^2) e_n, theta_1(z + i eta)/(2 q^(1/4)
//   cosh eta) = sin z sum (-1)^n h_n U_n + i tanh(eta) cos z sum (-1)^n k_n V_n, h_n = q^(n(n+1))
//   cosh((2n+1)eta)/cosh eta,  k_n = q^(n(n+1)) sinh((2n+1)eta)/sinh eta.
// |U_n|, |V_n| <= 2n+1, |e_n| <= 2; and alpha < K' is e^(2 eta) < 1/q, so that h_n <= q^(n^2), k_n
// <= (2n+1) q^(n^2) (k_n is q^(n(n+1)) times the sum of e^(2k eta) for k from -n to n). For q <=
// 1/16 and from n = 2 on successive terms of these bounds have ratios below 1/2: what is left out
// after n = N-1 is at most twice the bound for n = N.
//
// HYPERBOLIC SERIES, v = w log(1/p), taken for v >= 0 by symmetry; g = e^(-2v), r = p/g, sigma_n =
// 1 + g + ... + g^(2n):
//   2 cosh((2n+1)v) p^(n(n+1)) e^-v = p^(n^2) r^n (1 + g^(2n+1)),
//     2 sinh((2n+1)v) p^(n(n+1)) e^-v = (1-g) p^(n^2) r^n sigma_n,
//   2 cosh(2nv) p^(n^2) = p^(n^2-n) r^n (1 + g^(2n)).
// With S, C, T_3, T_4 the sums of theta_1(iv, p)/i, theta_2, theta_3, theta_4 (iv, p), the first
// two over p^(1/4) e^v, by sn(u|m) = -i sc(iu|1-m) and so on
//   sn = (T_3/T_4)(0) S/C,  cn = (theta_2/theta_4)(0) T_4/(e^v C), dn = (theta_2/theta_3)(0)
//   T_3/(e^v C),
// theta_2(0) here over p^(1/4); and theta_1(beta - iv, p) = the sums with sin((2n+1)beta) cosh and
// -i cos((2n+1)beta) sinh. g <= 1 up to the excess of balls and of |w| over 1/2: it is checked that
// g <= 2 and r <= 2. Then for p <= 1/16 and N >= 2 what is left out is at most 8 2^N p^(N^2), 2
// (2N+1) 2^N p^(N^2) and 4 2^N p^(N(N-1)), as above (a member g > 1 of a ball stands for v < 0,
// where the first form is g times its value at |v|, and the others are those at |v| or less).

#include <vector>

#include "polhode/arithmetic/real_scalar.hpp"

namespace polhode::detail {

// --------------------------------------------------------------------------------------------- The
// scalars: those of real_scalar.hpp, and double, in which the momentum alone is accurate enough.

template <class T>
concept rotor_scalar = elliptic_scalar<T> || std::same_as<T, double>;

[[nodiscard]] inline precision bits_in(double) { return std::numeric_limits<double>::digits; }
[[nodiscard]] inline double square_of(double x) { return x * x; }
[[nodiscard]] inline double exp_of(double x) { return std::exp(x); }
template <rotor_scalar T>
[[nodiscard]] T constant(long n, precision q) {
  if constexpr (std::same_as<T, double>) {
    return static_cast<double>(n);
  } else {
    return whole<T>(n, q);
  }
}
template <rotor_scalar T>
[[nodiscard]] T enclosing(const T& x, const magnitude& error) {
  if constexpr (std::same_as<T, double>) {
    return x;
  } else {
    return with_error(x, error);
  }
}

/// {sin pi w, cos pi w}, |w| at most about 1/2.
template <rotor_scalar T>
[[nodiscard]] std::pair<T, T> of_half_turns(const T& w, const T& pi_number) {
  if constexpr (std::floating_point<T>) {
    if (std::abs(w) <= T(0.25)) {
      const T angle = w * pi_number;
      return {std::sin(angle), std::cos(angle)};
    }
    const T angle = (T(0.5) - std::abs(w)) * pi_number;
    return {std::copysign(std::cos(angle), w), std::sin(angle)};
  } else {
    return sine_cosine(T(pi_number * w));
  }
}

[[nodiscard]] inline bool looks_negative(const ball& x) {
  return mpfr_sgn(midpoint(x).backend().data()) < 0;
}
[[nodiscard]] inline bool looks_negative(const mpfr_float& x) {
  return mpfr_sgn(x.backend().data()) < 0;
}
template <std::floating_point T>
[[nodiscard]] bool looks_negative(T x) {
  return x < 0;
}

/// Whether |x| is below about 1/2: heuristic.
template <rotor_scalar T>
[[nodiscard]] bool is_small(const T& x) {
  if constexpr (std::floating_point<T>) {
    return std::abs(x) < T(0.5);
  } else {
    return exponent_of(x) < -1;
  }
}

[[nodiscard]] inline ball expm1_of(const ball& x) { return expm1(x); }
[[nodiscard]] inline mpfr_float expm1_of(const mpfr_float& x) {
  mpfr_float r = zero_of_precision(precision_of(x));
  mpfr_expm1(r.backend().data(), x.backend().data(), MPFR_RNDN);
  return r;
}
template <std::floating_point T>
[[nodiscard]] T expm1_of(T x) {
  return std::expm1(x);
}

// ---------------------------------------------------------------------------------------------

/// What the series need, at working precision.
template <rotor_scalar T>
struct theta_series {
  bool hyperbolic = false;
  /// Circular pi; hyperbolic log(1/p), or 1 on the separatrix: the argument of the series is this
  /// times w.
  T scale;
  T nome;
  // By n.
  std::vector<T> odd;         // (-1)^n q^(n(n+1)), or (-1)^n p^(n^2)
  std::vector<T> even;        // q^(n^2), or p^(n^2-n)
  std::vector<T> lag_sine;    // (-1)^n h_n, or (-1)^n p^(n^2) cos((2n+1)beta)
  std::vector<T> lag_cosine;  // tanh(eta) (-1)^n k_n, or (-1)^n p^(n^2) sin((2n+1)beta)
  T of_sn, of_cn, of_dn;      // the factors that theta_point leaves out
  magnitude odd_tail, even_tail, lag_sine_tail, lag_cosine_tail;
};

template <rotor_scalar T>
struct theta_point {
  T sn, cn, dn;  // over of_sn, of_cn, of_dn
  T x, y;        // the lag atan2(x, y), y >= 0; where asked for
};

template <bool WithLag, rotor_scalar T>
[[nodiscard]] theta_point<T> circular_point(const theta_series<T>& k, const T& w) {
  const auto [sine, cosine] = of_half_turns(w, k.scale);
  const std::size_t count = k.odd.size();
  const T first = T(2 - 4 * square_of(sine));  // e_1
  T before = constant<T>(2, bits_in(sine));
  T e = first;
  T u = constant<T>(1, bits_in(sine));
  T v = u;
  T s = u;
  T c = u;
  T third = u;
  T fourth = u;
  theta_point<T> r;
  if constexpr (WithLag) {
    r.x = k.lag_sine[0];
    r.y = k.lag_cosine[0];
  }
  for (std::size_t n = 1; n < count; ++n) {
    u = T(u + e);
    v = T(e - v);
    const T sn = T(k.odd[n] * u);
    const T cn = T(k.odd[n] * v);
    const T en = T(k.even[n] * e);
    s = T(s + sn);
    c = n % 2 == 0 ? T(c + cn) : T(c - cn);
    third = T(third + en);
    fourth = n % 2 == 0 ? T(fourth + en) : T(fourth - en);
    if constexpr (WithLag) {
      r.x = T(r.x + k.lag_sine[n] * u);
      r.y = T(r.y + k.lag_cosine[n] * v);
    }
    if (n + 1 == count) break;
    T next = T(first * e - before);
    before = std::move(e);
    e = std::move(next);
  }
  s = enclosing(s, k.odd_tail);
  c = enclosing(c, k.odd_tail);
  third = enclosing(third, k.even_tail);
  const T inverse = T(1 / enclosing(fourth, k.even_tail));
  r.sn = T(s * sine * inverse);
  r.cn = T(c * cosine * inverse);
  r.dn = T(third * inverse);
  if constexpr (WithLag) {
    r.x = T(sine * enclosing(r.x, k.lag_sine_tail));
    r.y = T(cosine * enclosing(r.y, k.lag_cosine_tail));
  }
  return r;
}

template <bool WithLag, rotor_scalar T>
[[nodiscard]] theta_point<T> hyperbolic_point(const theta_series<T>& k, const T& w) {
  const bool negative = looks_negative(w);
  const T v = T(k.scale * w);
  const T exponent = negative ? v : T(-v);
  // e^-|v| and 1 - g, each without cancellation.
  T root = exponent;
  T rest = exponent;
  if (is_small(exponent)) {
    const T shrunk = expm1_of(exponent);
    root = T(1 + shrunk);
    rest = T(-shrunk * (2 + shrunk));
  } else {
    root = exp_of(exponent);
    rest = T(1 - square_of(root));
  }
  const T g = square_of(root);
  const std::size_t count = k.odd.size();
  const T one = constant<T>(1, bits_in(w));
  T c = T(one + g);
  T s = one;
  T third = one;
  T fourth = one;
  theta_point<T> r;
  if constexpr (WithLag) {
    r.x = k.lag_sine[0];
    r.y = T(k.lag_cosine[0] * c);
  }
  if (count > 1) {
    const T ratio = T(k.nome / g);
    if constexpr (std::same_as<T, ball>) {
      const magnitude two = magnitude::from_integer_up(2);
      if (g.magnitude_upper() > two || ratio.magnitude_upper() > two) {
        const ball none = ball::undefined(bits_in(w));
        return {none, none, none, none, none};
      }
    }
    T power = one;  // r^n
    T gn = g;       // g^(2n-1), then g^(2n), g^(2n+1)
    T sigma = one;
    for (std::size_t n = 1; n < count; ++n) {
      power = T(power * ratio);
      sigma = T(sigma + gn);
      gn = T(gn * g);
      const T en = T(k.even[n] * power * (1 + gn));
      sigma = T(sigma + gn);
      gn = T(gn * g);
      const T cosh_part = T(power * (1 + gn));
      const T sinh_part = T(power * sigma);
      const T cn = T(k.odd[n] * cosh_part);
      s = T(s + k.odd[n] * sinh_part);
      c = n % 2 == 0 ? T(c + cn) : T(c - cn);
      third = T(third + en);
      fourth = n % 2 == 0 ? T(fourth + en) : T(fourth - en);
      if constexpr (WithLag) {
        r.x = T(r.x + k.lag_sine[n] * sinh_part);
        r.y = T(r.y + k.lag_cosine[n] * cosh_part);
      }
    }
  }
  const T signed_rest = negative ? T(-rest) : rest;
  const T inverse = T(1 / enclosing(c, k.odd_tail));
  const T decay = T(root * inverse);
  r.sn = T(enclosing(s, k.odd_tail) * signed_rest * inverse);
  r.cn = T(enclosing(fourth, k.even_tail) * decay);
  r.dn = T(enclosing(third, k.even_tail) * decay);
  if constexpr (WithLag) {
    r.x = T(signed_rest * enclosing(r.x, k.lag_sine_tail));
    r.y = enclosing(r.y, k.lag_cosine_tail);
  }
  return r;
}

/// At u = 2K w; in the separatrix's case at u = w.
template <bool WithLag, rotor_scalar T>
[[nodiscard]] theta_point<T> theta_values_at(const theta_series<T>& k, const T& w) {
  return k.hyperbolic ? hyperbolic_point<WithLag>(k, w) : circular_point<WithLag>(k, w);
}

}  // namespace polhode::detail
