#pragma once

// Legendre's integrals at numbers, over any scalar of real_scalar.hpp, from Carlson's.

#include "elliptic/carlson_points.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "polhode/elliptic/complete.hpp"

namespace polhode::detail {

// Carlson's integrals of arguments that may be balls with a radius.
[[nodiscard]] inline ball rf_of(const ball& x, const ball& y, const ball& z, precision) {
  return carlson_rf(x, y, z);
}
[[nodiscard]] inline ball rd_of(const ball& x, const ball& y, const ball& z, precision) {
  return carlson_rd(x, y, z);
}
[[nodiscard]] inline ball rj_of(const ball& x, const ball& y, const ball& z, const ball& p,
                                precision) {
  return carlson_rj(x, y, z, p);
}
[[nodiscard]] inline ball rc_of(const ball& x, const ball& y, precision) {
  return carlson_rc(x, y);
}
[[nodiscard]] inline ball rg_of(const ball& x, const ball& y, const ball& z, precision) {
  return carlson_rg(x, y, z);
}
[[nodiscard]] inline carlson_pair rf_rj_of(const ball& x, const ball& y, const ball& z,
                                           const ball& p, precision) {
  return carlson_rf_rj(x, y, z, p);
}
template <elliptic_scalar T>
[[nodiscard]] T rf_of(const T& x, const T& y, const T& z, precision q) {
  return rf_at(x, y, z, q);
}
template <elliptic_scalar T>
[[nodiscard]] T rd_of(const T& x, const T& y, const T& z, precision q) {
  return rd_at(x, y, z, q);
}
template <elliptic_scalar T>
[[nodiscard]] T rj_of(const T& x, const T& y, const T& z, const T& p, precision q) {
  return rj_at(x, y, z, p, q);
}
template <elliptic_scalar T>
[[nodiscard]] T rc_of(const T& x, const T& y, precision q) {
  return rc_point(x, y, q);
}
template <elliptic_scalar T>
[[nodiscard]] T rg_of(const T& x, const T& y, const T& z, precision q) {
  return rg_at(x, y, z, q);
}
template <elliptic_scalar T>
struct value_pair {
  T rf, rj;
};
template <elliptic_scalar T>
[[nodiscard]] value_pair<T> rf_rj_of(const T& x, const T& y, const T& z, const T& p, precision q) {
  std::optional<T> rf;
  const T rj = rj_at(x, y, z, p, q, &rf);
  return {rf ? *rf : rf_at(x, y, z, q), rj};
}

/// m and m1 = 1 - m.
template <elliptic_scalar T>
struct modulus {
  T m, m1;
};
/// The parameter `given` (its complement, where by_complement) with q bits.
template <elliptic_scalar T>
[[nodiscard]] modulus<T> modulus_of(const T& given, bool by_complement, precision q) {
  const T first = raised(given, q);
  T second = T(1 - first);
  if (by_complement) return {std::move(second), first};
  return {first, std::move(second)};
}

/// An amplitude as k pi + psi, |psi| <= pi/2: k, sin psi and cos^2 psi.
template <elliptic_scalar T>
struct amplitude {
  T turns;  // k
  T s;
  T c;
  T X;  // cos^2 psi
};
[[nodiscard]] inline ball nearest_whole(const ball& x) { return round_ties_to_even(x.middle()); }
[[nodiscard]] inline mpfr_float nearest_whole(const mpfr_float& x) {
  mpfr_float r = zero_of_precision(precision_of(x));
  mpfr_rint(r.backend().data(), x.backend().data(), MPFR_RNDN);
  return r;
}
[[nodiscard]] inline long double nearest_whole(long double x) { return std::nearbyint(x); }

/// More bits than this before the point, and the amplitude is refused: pi would be needed to as
/// many.
inline constexpr std::int64_t most_bits_before_point = std::int64_t{1} << 24;

template <elliptic_scalar T>
[[nodiscard]] amplitude<T> amplitude_of(const T& phi, precision q) {
  const std::int64_t before_point = std::max<std::int64_t>(exponent_of(phi) + 1, 0);
  if (before_point > most_bits_before_point) {
    const T none = undefined_of<T>(q);
    return {none, none, none, none};
  }
  T turns = whole<T>(0, q);
  T psi = raised(phi, q);
  if constexpr (std::same_as<T, long double>) {
    // k pi_high is exact for k < 2^32.
    constexpr long double pi_high = 0x1.921fb544p+1L;
    constexpr long double pi_low = 0x85a308d313198a2ep-96L;
    constexpr long double greatest = 0x1p31L;
    constexpr long double below_half_pi = 0x1.921fb5p0L;
    if (std::abs(phi) > below_half_pi && std::abs(phi) < greatest) {
      turns = nearest_whole(phi / pi_of<T>(q));
      psi = (phi - turns * pi_high) - turns * pi_low;
    } else if (std::abs(phi) >= greatest) {  // a long double has too few bits of pi
      const precision bits = q + static_cast<precision>(before_point) + 8;
      const ball exact = ball::exactly(static_cast<double>(phi), bits);
      const ball k = nearest_whole(exact / pi(bits));
      turns = mpfr_get_ld(midpoint(k).backend().data(), MPFR_RNDN);
      psi = mpfr_get_ld(midpoint(exact - k * pi(bits)).backend().data(), MPFR_RNDN);
    }
  } else if (before_point > 0) {
    const precision bits = q + static_cast<precision>(before_point) + 8;
    const T exact = raised(phi, bits);
    turns = nearest_whole(T(exact / pi_of<T>(bits)));
    psi = raised(T(exact - turns * pi_of<T>(bits)), q);
  }
  auto [s, c] = sine_cosine(psi);
  if constexpr (std::same_as<T, ball>) {
    // psi is a narrow set. Where it may reach beyond +-pi/2, that is where cos may be negative,
    // nothing is said: for a number more bits decide.
    if (!not_negative(c)) c = ball::undefined(q);
  }
  const T X = square_of(c);
  return {std::move(turns), std::move(s), std::move(c), X};
}

template <elliptic_scalar T>
[[nodiscard]] T k_at(const modulus<T>& k, precision q) {
  if (sign_in(k.m1) != 1) return undefined_of<T>(q);
  return T(pi_of<T>(q) / (2 * agm_of(whole<T>(1, q), root_of(k.m1))));  // C. F. Gauss; DLMF 19.8.5
}
template <elliptic_scalar T>
[[nodiscard]] T d_at(const modulus<T>& k, precision q) {
  return T(rd_of(whole<T>(0, q), k.m1, whole<T>(1, q), q) / 3);
}
/// E = K (1 - m/2 - sum of 2^(n-1) c_n^2), n >= 1, from the AGM of 1 and sqrt m1 (DLMF 19.8.6):
/// near m = 1 as many bits are lost as log2 K says. What is left out after c_n: see agm_with_sum in
/// complete.hpp.
template <elliptic_scalar T>
[[nodiscard]] T e_at(const modulus<T>& k, precision q) {
  const int sign = sign_in(k.m1);
  if (sign == 0) return whole<T>(1, q);
  if (sign != 1) return undefined_of<T>(q);
  const T one = whole<T>(1, q);
  if constexpr (std::same_as<T, ball>) {
    const agm_sums sums = agm_with_sum(one, sqrt(k.m1));
    return pi(q) * (1 - scale(k.m, -1) - sums.sum) / scale(sums.mean, 1);
  } else {
    const T small = scaled(one, last_difference<T>(q) / 2 - 2);
    T a = one;
    T b = root_of(k.m1);
    T sum = T(1 - scaled(k.m, -1));
    constexpr int most_steps = 100;
    for (int n = 0; n < most_steps; ++n) {
      const T c = scaled(T(a - b), -1);
      sum -= scaled(square_of(c), n);
      const T mean = scaled(T(a + b), -1);
      if (is_below(T(c * c), T(square_of(T(b * small))))) {
        // c' = c^2/(4a) is below the last place but for the mean
        return T(sum * pi_of<T>(q) / (2 * (mean - square_of(c) / (4 * mean))));
      }
      b = root_of(T(a * b));
      a = mean;
    }
    return undefined_of<T>(q);
  }
}

/// (a cos^2 + b sin^2)/(cos^2 + p sin^2) integrated: with v = cot t it is (a v^2 + b)/(v^2 + p),
/// and K the integral of p/(v^2+p) as in carlson_core.hpp, where K(p) + K(kc^2/p) = F. So it is
///   a F + (b/p - a) K(p) = a K(kc^2/p) + (b/p) K(p),   K(p) = p R_J(0, kc^2, 1, p)/3,
/// of which the first is without cancellation where a and b/p - a have the same sign, the second
/// where a and b have.
template <elliptic_scalar T>
[[nodiscard]] T cel_at(const T& m1, const T& p, const T& a, const T& b, precision q) {
  const T zero = whole<T>(0, q);
  const T one = whole<T>(1, q);
  const T rest = T(b - a * p);
  const bool second_is_better =
      sign_in(p) > 0 && sign_in(a) * sign_in(rest) < 0 && sign_in(a) * sign_in(b) > 0;
  if (second_is_better) {
    const T other = T(m1 / p);
    return T((a * other * rj_of(zero, m1, one, other, q) + b * rj_of(zero, m1, one, p, q)) / 3);
  }
  const auto [rf, rj] = rf_rj_of(zero, m1, one, p, q);
  return T(a * rf + rest * rj / 3);
}

template <elliptic_scalar T>
[[nodiscard]] T pi_at(const T& n, const modulus<T>& k, precision q) {
  const T one = whole<T>(1, q);
  if (sign_in(n) == 0) return k_at(k, q);
  return cel_at(k.m1, T(1 - n), one, one, q);
}

/// The integral to psi + k pi from that to psi and the complete one.
template <elliptic_scalar T, class F>
[[nodiscard]] T with_turns(const T& part, const T& turns, const F& complete) {
  if (sign_in(turns) == 0) return part;
  return T(part + 2 * turns * complete());
}

/// The amplitude is beyond pi/2, where F, D and Pi need m < 1.
template <elliptic_scalar T>
[[nodiscard]] bool is_beyond(const amplitude<T>& w, const modulus<T>& k) {
  const int turns = sign_in(w.turns);
  return (turns == 1 || turns == -1) && sign_in(k.m1) <= 0;
}

template <elliptic_scalar T>
[[nodiscard]] T f_at(const T& phi, const modulus<T>& k, precision q) {
  const amplitude<T> w = amplitude_of(phi, q);
  if (is_beyond(w, k)) return undefined_of<T>(q);
  const T Y = T(w.X + k.m1 * square_of(w.s));
  const T part = T(w.s * rf_of(w.X, Y, whole<T>(1, q), q));
  return with_turns(part, w.turns, [&] { return k_at(k, q); });
}
template <elliptic_scalar T>
[[nodiscard]] T d_at(const T& phi, const modulus<T>& k, precision q) {
  const amplitude<T> w = amplitude_of(phi, q);
  if (is_beyond(w, k)) return undefined_of<T>(q);
  const T ss = square_of(w.s);
  const T Y = T(w.X + k.m1 * ss);
  const T part = T(w.s * ss * rd_of(w.X, Y, whole<T>(1, q), q) / 3);
  return with_turns(part, w.turns, [&] { return d_at(k, q); });
}
template <elliptic_scalar T>
[[nodiscard]] T e_at(const T& phi, const modulus<T>& k, precision q) {
  const amplitude<T> w = amplitude_of(phi, q);
  const T ss = square_of(w.s);
  const T Y = T(w.X + k.m1 * ss);
  const T one = whole<T>(1, q);
  const auto complete = [&] { return e_at(k, q); };
  if (sign_in(w.X) == 0 || sign_in(Y) == 0)
    return with_turns(T(w.s * e_at(k, q)), w.turns, complete);
  const auto [rf, rj] = rf_rj_of(w.X, Y, one, one, q);  // R_D(X, Y, 1) = R_J(X, Y, 1, 1)
  return with_turns(T(w.s * (rf - k.m * ss * rj / 3)), w.turns, complete);
}

/// For n < 0, with p = 1 - n > 1 and v = cot t: (v^2+1)/(v^2+p) = 1/p + (1 - 1/p) v^2/(v^2+p), and
/// the integral of the last is F - K(p) = C + K(r), r = m1/p, in the notation of carlson_core.hpp
/// with w^2 = X, a^2 = s^2, b^2 = m1 s^2:
///   Pi = s [ R_F/p + (1 - 1/p) (c R_C(Y, P R) + m1 s^2/(3p) R_J(X,Y,1,R)) ],
/// P = c^2 + p s^2, R = c^2 + m1 s^2/p: for m <= 1 no term is negative.
template <elliptic_scalar T>
[[nodiscard]] T pi_at(const T& n, const T& phi, const modulus<T>& k, precision q) {
  const amplitude<T> w = amplitude_of(phi, q);
  if (is_beyond(w, k)) return undefined_of<T>(q);
  const T one = whole<T>(1, q);
  const T ss = square_of(w.s);
  const T p = T(1 - n);
  const T Y = T(w.X + k.m1 * ss);
  const T P = T(w.X + p * ss);
  const auto complete = [&] { return pi_at(n, k, q); };
  if (sign_in(n) < 0) {
    const T rest = T(k.m1 * ss / p);
    const T R = T(w.X + rest);
    const auto [rf, rj] = rf_rj_of(w.X, Y, one, R, q);
    const T other = T(w.c * rc_of(Y, T(P * R), q) + rest * rj / 3);
    return with_turns(T(w.s * (rf - n * other) / p), w.turns, complete);
  }
  const auto [rf, rj] = rf_rj_of(w.X, Y, one, P, q);
  return with_turns(T(w.s * (rf + n * ss * rj / 3)), w.turns, complete);
}

}  // namespace polhode::detail
