#pragma once

// Carlson's integrals at numbers in their domain, where x <= y <= z has been arranged and
// degenerate cases are apart: two methods, over any scalar of real_scalar.hpp.
//
// DUPLICATION (B. C. Carlson, Numerical computation of real or complex elliptic integrals, Numer.
// Algorithms 10, 1995; DLMF 19.26.18, 19.36.1). With L = sqrt(x y) + sqrt(y z) + sqrt(z x),
//   R_F(x,y,z) = R_F((x+L)/4, (y+L)/4, (z+L)/4),
//   R_J(x,y,z,p) = R_J((x+L)/4, ..., (p+L)/4) / 4 + (6/d) R_C(1, 1+e),
//   d = (sqrt p + sqrt x)(sqrt p + sqrt y)(sqrt p + sqrt z),  e = (p-x)(p-y)(p-z)/d^2.
// Each step divides the differences of the arguments by 4 exactly. Then a series in X_i = 1 -
// x_i/A, where A is the mean of the arguments (p taken twice), so that the X_i add up to 0. With t
// = A/v - A, 0 < v < 1, in the definition t + x_i = (A/v)(1 - v X_i), and so
//   R_F = A^(-1/2) sum of T_N / (2N+1),    R_J = A^(-3/2) sum of 3 T_N / (2N+3),
// where sum of T_N v^N = D(v)^(-1/2), D(v) the product of 1 - v X_i (that of p twice). From 2 D T'
// = -D' T:
//   2N T_N = - sum over j >= 2 of d_j (2N - j) T_(N-j).
// The rest after N < n terms: with x = max |X_i| < 1 the coefficients of D^(-1/2) are in size at
// most those of (1 - x v)^(-c), c = 3/2 for R_F and 5/2 for R_J, which are x^N (c)_N/N!. So the
// terms are at most x^N (1/2)_N/N! <= x^N and x^N (3/2)_N/N! <= (N+1) x^N, for (c)_N/(2N+1) =
// (1/2)_N when c = 3/2, and 3 (c)_N/(2N+3) = (3/2)_N when c = 5/2; their sums from n on are at most
// x^n/(1-x), (n+1) x^n/(1-x)^2.
//
// LANDEN'S TRANSFORMATION, with quadratic convergence. Let x < y < z and P > x, P = p here, and
//   w = sqrt x,  a = sqrt(z-x),  b = sqrt(y-x),  s = sqrt(P-x);
//     with t + x = v^2 in the definitions
//   F = R_F = int_w^oo dv/Y,   K = (P-x) R_J/3 = int_w^oo s^2/(v^2+s^2) dv/Y,
//     Y^2 = (v^2+a^2)(v^2+b^2).
// Put a' = (a+b)/2, b' = sqrt(ab), v' = (v - ab/v)/2, s' = (s + ab/s)/2, e = (s^2-ab)/(s^2+ab).
// Then
//   v'^2 + b'^2 = ((v + ab/v)/2)^2,   v'^2 + a'^2 = (v^2+a^2)(v^2+b^2)/(4 v^2),   dv'/Y' = 2 dv/Y
//     (1)
// by multiplying out. Since v -> v' maps (0, oo) onto the whole line, F(w) = F'(w')/2, where w' may
// be negative; for w < 0 the same holds of the part from -|w|, with w' again from the whole line.
// Also, with r = ab/s,
//   v'^2 + s'^2 = (v^2+s^2)(v^2+r^2)/(4v^2), so  K'/s'^2 = 8 (K(s) - K(r))/(s^2-r^2),        (2)
//   s^2/(v^2+s^2) + r^2/(v^2+r^2) - 1 = (a^2b^2-v^4)/((v^2+s^2)(v^2+r^2)).                   (3)
// H = Y/v has dH = (v^4-a^2b^2)/(v^2 Y) dv, and H^2 + k^2 = (v^2+s^2)(v^2+r^2)/v^2 for k^2 =
// (s^2-a^2)(s^2-b^2)/s^2, so the integral of (3) is K(s) + K(r) - F = - int_H^oo dH/(H^2+k^2) = -C,
// C = atan(k/H)/k. With (2), where (s^2-r^2)/(4 s'^2) = (s-r)/(s+r) = e:
//   K = (F - C)/2 + (e/4) K'.                                                                (4)
// k'= k e/2 (from (2), s'^2-b'^2 = ((s-r)/2)^2), so with Q_0 = 1, Q_(n+1) = Q_n e_n/2, F_n = 2^n F,
// k_n = k Q_n:
//   K = (1/2) [ F sum of Q_n - sum of 2^(-n) atan(k_n/H_n)/k ],   k^2 = (P-z)(P-y)/(P-x);    (5)
// for k^2 < 0 atanh takes the place of atan, and for k = 0 the terms are 2^(-n) Q_n/H_n (R_D, and
// R_G through it). After N steps what is left out of (5) is the product of e_n/4, n < N, times K_N,
// and 0 < K_N < F_N = 2^N F: it is in size at most |Q_N| F. |e_n| < 1, and it falls quadratically,
// since s'^2 - b'^2 = ((s-r)/2)^2. F = 2^(-N) int over v > w_N of dv/Y_N lies between what a_N and
// what b_N in the place of both give, so it is 2^(-N) phi/M for some M in [b_N, a_N], phi the angle
// of (w_N, M) in the turn that F tells. No step divides by w: the point is kept as (c : d : e : o)
// = w : sqrt(w^2+b^2) : sqrt(w^2+a^2) : 1,
//   c' = c^2 - ab o^2,  d' = c^2 + ab o^2,  e' = d e,  o' = 2 c o,   H_n = 2 e_(n+1)/o_(n+1),
// so that w may pass through 0 and oo, and the sum of 2^(-n) atan(k_n/H_n) is 2^(1-N) times the
// angle of the product of (2e + i k o)^(2^(N-n)): one angle of a product made by squaring. In which
// turn it lies, sums of 64 bits tell.
//
// This is J. Landen's (1775) substitution, C. F. Gauss's AGM, F. Bartky's (1938) sum Q, and for the
// incomplete integral what R. Bulirsch's el3 (1969) does, put so that one angle is left to compute.
// Duplication needs of the order of sqrt(q) steps for q bits, this log q.

#include <array>
#include <optional>
#include <utility>

#include "polhode/arithmetic/real_scalar.hpp"

namespace polhode::detail {

/// log2 of a bound is at most this.
[[nodiscard]] inline std::int64_t log2_up(const magnitude& m) {
  if (m.is_zero()) return -(std::int64_t{1} << 40);
  return m.is_infinite() ? std::int64_t{1} << 40 : m.log2_floor() + 1;
}

/// x^n, rounded up.
[[nodiscard]] inline magnitude power_up(magnitude x, long n) {
  magnitude result = magnitude::power_of_two(0);
  for (; n > 0; n >>= 1) {
    if ((n & 1) != 0) result = multiply_up(result, x);
    x = multiply_up(x, x);
  }
  return result;
}

/// sum of (-e)^k/(2k+1): R_C(1, 1+e), for |e| <= 1/4. What is left out after n terms is at most
/// |e|^n/((2n+1)(1-|e|)) <= |e|^n.
template <elliptic_scalar T>
[[nodiscard]] T rc_series(const T& e, precision q) {
  const magnitude size = size_up(e);
  const std::int64_t bits = -log2_up(size);  // at least 1 where |e| <= 1/4
  const long terms =
      size.is_zero() ? 1 : static_cast<long>(q / std::max<std::int64_t>(bits, 1)) + 1;
  T sum = T(whole<T>(1, q) / (2 * terms - 1));
  for (long k = terms - 2; k >= 0; --k) {
    sum = T(whole<T>(1, q) / (2 * k + 1) - e * sum);
  }
  return with_error(sum, power_up(size, terms));
}

/// R_C(1, 1+e) for e > -1: atan(sqrt e)/sqrt e, or atanh t/t with t = sqrt(-e) (DLMF 19.2.18-19),
/// where (1+t)/(1-t) = (1+t)^2/(1+e) with 1+e from the caller, who knows it to full accuracy.
template <elliptic_scalar T, class F>
[[nodiscard]] T rc_of_one(const T& e, const F& one_plus_e, precision q) {
  constexpr long few_terms = 40;
  const std::int64_t bits = -log2_up(size_up(e));
  if (bits >= 2 && (q <= few_terms * bits || sign_in(e) == 2 || sign_in(e) == 0)) {
    return rc_series(e, q);
  }
  if (sign_in(e) > 0) {
    const T root = root_of(e);
    return T(atan_of(root) / root);
  }
  const T root = root_of(T(-e));
  return T(log_of(T(square_of(T(1 + root)) / one_plus_e())) / (2 * root));
}

/// R_C(x, y) for x >= 0, y > 0.
template <elliptic_scalar T>
[[nodiscard]] T rc_at(const T& x, const T& y, precision q) {
  if (sign_in(x) == 0) return T(pi_of<T>(q) / (2 * root_of(y)));
  const T difference = T(y - x);
  const T e = T(difference / x);
  if (log2_up(size_up(e)) <= -2) {
    return T(rc_of_one(
                 e, [&] { return T(y / x); }, q) /
             root_of(x));
  }
  if (is_below(x, y)) {
    const T root = root_of(difference);
    return T(angle_of(root, root_of(x)) / root);
  }
  const T root = root_of(T(-difference));
  return T(log_of(T((root_of(x) + root) / root_of(y))) / root);
}

/// The sum of factor T_N / (2N + factor), N < terms, with d_2 ... d_degree given from d[0] on.
template <std::size_t Count, elliptic_scalar T>
[[nodiscard]] T symmetric_series(const std::array<T, Count>& d, long factor, long terms,
                                 precision q) {
  constexpr auto count = static_cast<long>(Count);
  std::array<T, Count + 2> last;  // T_(N-1), T_(N-2), ...
  last.fill(whole<T>(0, q));
  last[1] = whole<T>(1, q);  // T_0
  T sum = whole<T>(1, q);
  for (long n = 2; n < terms; ++n) {
    T next = whole<T>(0, q);
    for (long j = 2; j < count + 2 && j <= n; ++j) {
      next -= T(d[static_cast<std::size_t>(j - 2)] * times<T>(2 * n - j)) *
              last[static_cast<std::size_t>(j - 1)];
    }
    next = over(next, 2 * n);
    sum += over(T(next * times<T>(factor)), 2 * n + factor);
    for (std::size_t j = Count + 1; j > 0; --j) last[j] = std::move(last[j - 1]);
    last[0] = std::move(next);
  }
  return sum;
}

/// Whether spread 4^(-n)/mean <= 2^wanted: an upper bound of the |X_i| after n steps.
template <elliptic_scalar T>
[[nodiscard]] bool is_close(const magnitude& spread, const T& mean, int n, std::int64_t wanted) {
  return log2_up(divide_up(scale(spread, -2L * n), size_down(mean))) <= wanted;
}
[[nodiscard]] inline bool is_close(long double spread, long double mean, int n,
                                   std::int64_t wanted) {
  return scaled(spread, -2L * n - wanted) <= mean;
}
/// The greatest of |x - mean|.
template <elliptic_scalar T, class... Rest>
[[nodiscard]] auto spread_of(const T& mean, const Rest&... x) {
  if constexpr (std::same_as<T, long double>) {
    return std::max({std::abs(x - mean)...});
  } else {
    magnitude result;
    ((result = max(result, size_up(T(x - mean)))), ...);
    return result;
  }
}
/// A bound of the series' rest, from one of the |X_i|.
template <elliptic_scalar T, class F, class... Rest>
[[nodiscard]] T with_rest(const T& series, const F& bound, const Rest&... x) {
  if constexpr (std::same_as<T, ball>) {
    magnitude size;
    ((size = max(size, x.magnitude_upper())), ...);
    return series.enlarged(bound(size));
  } else {
    return series;
  }
}

/// A limit that is reached only where the arguments lie apart by thousands of orders of magnitude.
inline constexpr int most_duplications = 100'000;

/// Terms of the series for q bits: more make fewer steps.
[[nodiscard]] inline long series_terms(precision q, double step_over_term) {
  return 3 + static_cast<long>(std::sqrt(0.5 * step_over_term * static_cast<double>(q)));
}

template <elliptic_scalar T>
[[nodiscard]] T rf_by_duplication(T x, T y, T z, precision q) {
  const long terms = series_terms(q, 2.5);
  const std::int64_t wanted = -(q / terms) - 1;  // log2 of the greatest |X_i|
  const auto mean_of = [&] { return T((x + y + z) / 3); };
  T mean = mean_of();
  const auto spread = spread_of(mean, x, y, z);
  for (int n = 0; !is_close(spread, mean, n, wanted); ++n) {
    if (n == most_duplications) return undefined_of<T>(q);
    const T rx = root_of(x);
    const T ry = root_of(y);
    const T rz = root_of(z);
    const T lambda = T(rx * (ry + rz) + ry * rz);
    x = scaled(T(x + lambda), -2);
    y = scaled(T(y + lambda), -2);
    z = scaled(T(z + lambda), -2);
    mean = mean_of();
  }
  const T dx = T(1 - x / mean);
  const T dy = T(1 - y / mean);
  const T dz = T(-(dx + dy));
  const T product = T(dx * dy);
  const std::array<T, 2> d{T(product - square_of(dz)), T(-(product * dz))};
  const auto rest = [terms](const magnitude& size) {
    return divide_up(power_up(size, terms), subtract_down(magnitude::power_of_two(0), size));
  };
  return T(with_rest(symmetric_series(d, 1, terms, q), rest, dx, dy, dz) / root_of(mean));
}

/// R_J for p > 0; where p_is_z R_D(x, y, z), and p is not read. It needs of its arguments no order.
template <elliptic_scalar T>
[[nodiscard]] T rj_by_duplication(T x, T y, T z, T p, bool p_is_z, precision q) {
  if (p_is_z) p = z;
  const long terms = series_terms(q, 4);
  const std::int64_t wanted = -(q / terms) - 1;
  const auto mean_of = [&] { return T((x + y + z + 2 * p) / 5); };
  T mean = mean_of();
  const auto spread = spread_of(mean, x, y, z, p);
  T delta = p_is_z ? whole<T>(0, q) : T((p - x) * (p - y) * (p - z));
  T sum = whole<T>(0, q);
  int n = 0;
  for (; !is_close(spread, mean, n, wanted); ++n) {
    if (n == most_duplications) return undefined_of<T>(q);
    const T rx = root_of(x);
    const T ry = root_of(y);
    const T rz = root_of(z);
    const T rp = p_is_z ? rz : root_of(p);
    const T lambda = T(rx * (ry + rz) + ry * rz);
    const T d = T((rp + rx) * (rp + ry) * (rp + rz));
    T term = T(whole<T>(1, q) / d);
    if (!p_is_z) {  // 1+e = 2b/d with b = sqrt p (p + L): d = a + b, where e d^2 = b^2 - a^2
      const auto one_plus_e = [&] { return T(2 * rp * (p + lambda) * term); };
      term = T(term * rc_of_one(T(delta * square_of(term)), one_plus_e, q));
    }
    sum += scaled(term, -2L * n);
    x = scaled(T(x + lambda), -2);
    y = scaled(T(y + lambda), -2);
    z = scaled(T(z + lambda), -2);
    p = p_is_z ? z : scaled(T(p + lambda), -2);
    delta = scaled(delta, -6);
    mean = mean_of();
  }
  const T dx = T(1 - x / mean);
  const T dy = T(1 - y / mean);
  const T dz = T(1 - z / mean);
  const T dp = p_is_z ? dz : scaled(T(-(dx + dy + dz)), -1);
  // Elementary symmetric functions of dx, dy, dz, dp, dp, whose sum is 0, from e2 and e3 of the
  // first three.
  const T xy = T(dx * dy);
  const T e2 = T(xy + (dx + dy) * dz);
  const T e3 = T(xy * dz);
  const T pp = square_of(dp);
  const std::array<T, 4> d{T(e2 - 3 * pp), T(2 * pp * dp - 2 * dp * e2 - e3),
                           T(2 * dp * e3 + pp * e2), T(-(pp * e3))};
  const auto rest = [terms](const magnitude& size) {
    const magnitude below = subtract_down(magnitude::power_of_two(0), size);
    const auto count = magnitude::from_integer_up(static_cast<std::uint64_t>(terms) + 1);
    return divide_up(multiply_up(power_up(size, terms), count), multiply_down(below, below));
  };
  const T series = with_rest(symmetric_series(d, 3, terms, q), rest, dx, dy, dz, dp);
  return T(6 * sum + scaled(T(series / (mean * root_of(mean))), -2L * n));
}

// ---------------------------------------------------------------------------------------------

/// The whole number nearest to the set, where it holds just one.
[[nodiscard]] inline std::optional<ball> only_integer(const ball& x) {
  const ball n = round_ties_to_even(x.middle());
  if (!x.is_bounded() || !n.is_exact() || !(x.radius() <= magnitude::power_of_two(-2))) return {};
  const magnitude off = (x - n).magnitude_upper();
  return off <= magnitude::power_of_two(-1) ? std::optional<ball>(n) : std::nullopt;
}

/// The angle that is `angle` but for whole turns, and of which `rough` is an enclosure (a value).
template <elliptic_scalar T>
[[nodiscard]] std::optional<T> unwrapped(const T& angle, const T& rough, precision q) {
  const T turn = T(2 * pi_of<T>(q));
  const T turns = T((rough - angle) / turn);
  if constexpr (std::same_as<T, ball>) {
    const std::optional<ball> n = only_integer(turns);
    if (!n) return std::nullopt;
    return angle + turn * *n;
  } else if constexpr (std::same_as<T, mpfr_float>) {
    T n = zero_of_precision(precision_of(turns));
    mpfr_rint(n.backend().data(), turns.backend().data(), MPFR_RNDN);
    return T(angle + turn * n);
  } else {
    return T(angle + turn * std::nearbyint(turns));
  }
}

/// R_F and, where P is given, R_J; with the bits that cancellation took from R_J.
template <elliptic_scalar T>
struct landen_values {
  T rf;
  T rj;
  std::int64_t lost = 0;
};

/// log2 of the relative difference at which an AGM of q bits has converged: not the last bits,
/// which rounding errors take, fewer of them from a number than from a ball's radius.
template <elliptic_scalar T>
[[nodiscard]] std::int64_t last_difference(precision q) {
  return (std::same_as<T, ball> ? 12 : 4) - q;
}

/// R_F and R_J for x = 0 < y <= z, P > 0: the same with w = 0, where H = oo in (5), so that K =
/// (1/2) F sum of Q_n, F = pi/(2 M); what is left out is at most |Q_N| F as before. For one step of
/// the AGM, (a+b)/2 >= M >= sqrt(ab) = (a+b)/2 - (sqrt a - sqrt b)^2/2 >= (a+b)/2 - (a-b)^2/(8
/// min(a,b)).
template <elliptic_scalar T>
[[nodiscard]] std::optional<landen_values<T>> complete_by_landen(const T& y, const T& z, const T& P,
                                                                 precision q) {
  const std::int64_t wanted = last_difference<T>(q);
  T a = root_of(z);
  T b = root_of(y);
  T s = root_of(P);
  T weight = whole<T>(1, q);
  T weights = whole<T>(0, q);
  magnitude weight_up = magnitude::power_of_two(0);
  constexpr int most_steps = 200;
  for (int n = 0; n < most_steps; ++n) {
    const magnitude difference = divide_up(size_up(T(a - b)), size_down(b));
    if (2 * log2_up(difference) - 3 <= wanted && log2_up(weight_up) <= wanted) {
      // a >= b/2, also where rounding has hidden which of them is the greater
      const magnitude error =
          scale(multiply_up(multiply_up(difference, difference), size_up(b)), -2);
      const T twice_mean = with_error(T(a + b), scale(error, 1));
      landen_values<T> result{T(pi_of<T>(q) / twice_mean), undefined_of<T>(q), 0};
      const T sum = with_error(weights, scale(weight_up, 1));
      result.lost = bits_lost(sum, whole<T>(1, q), q);
      result.rj = T(3 * result.rf * scaled(sum, -1) / P);
      return result;
    }
    const T ab = T(a * b);
    weights += weight;
    const T r = T(ab / s);
    const T total = T(s + r);
    weight = scaled(T(weight * ((s - r) / total)), -1);
    weight_up = size_up(weight);
    s = scaled(total, -1);
    a = scaled(T(a + b), -1);
    b = root_of(ab);
  }
  return std::nullopt;
}

/// What P is, for x < y < z.
enum class third_kind { absent, general, equals_y_or_z };

/// The steps of (1) to (5) for 0 <= x < y < z, numbers, and P > x: the letters are those of the
/// text at the top.
template <elliptic_scalar T>
class landen_steps {
 public:
  landen_steps(const T& x, const T& y, const T& z, const T& P, third_kind kind, precision q)
      : x_(x),
        y_(y),
        z_(z),
        P_(P),
        third_(kind != third_kind::absent),
        product_wanted_(kind == third_kind::general),
        q_(q),
        wanted_(last_difference<T>(q)),
        a_(root_of(T(z - x))),
        b_(root_of(T(y - x))),
        c_(root_of(x)),
        d_(root_of(y)),
        e_(root_of(z)),
        o_(whole<T>(1, q)),
        s_(third_ ? root_of(T(P - x)) : whole<T>(0, q)),
        kappa_(whole<T>(1, q)),
        weight_(whole<T>(1, q)),
        weights_(whole<T>(0, q)),
        terms_(whole<T>(0, q)),
        re_(whole<T>(1, q)),
        im_(whole<T>(0, q)) {
    if (!product_wanted_) return;
    const T above = T((P - z) * (P - y));
    circular_ = sign_in(above) > 0;
    kappa_ = root_of(T((circular_ ? above : T(-above)) / (P - x)));
    if (!circular_) im_ = whole<T>(1, q);
  }

  /// Nothing where an angle is too near a full turn to be placed.
  [[nodiscard]] std::optional<landen_values<T>> values() {
    constexpr int most_steps = 100;
    for (; !is_found(); step()) {
      if (n_ == most_steps) return std::nullopt;
    }
    return values_here();
  }

 private:
  // Steps square the ratio b/a: there are fewer than 40 for what numbers hold.
  static constexpr precision rough_bits = 64;

  [[nodiscard]] bool is_found() const {
    const bool mean_found = log2_up(divide_up(size_up(T(a_ - b_)), size_down(b_))) <= wanted_;
    return mean_found && (!third_ || log2_up(weight_up_) <= wanted_);
  }

  /// From step n to n + 1.
  void step() {
    const T ab = T(a_ * b_);
    const T cc = square_of(c_);
    const T oo = T(ab * square_of(o_));
    e_ = T(e_ * d_);
    o_ = scaled(T(c_ * o_), 1);
    c_ = T(cc - oo);
    d_ = T(cc + oo);
    keep_in_range(exponent_of(d_), c_, d_, e_, o_);
    if (third_) {
      weights_ += weight_;
      if (product_wanted_) {
        multiply_product();
      } else {
        terms_ += scaled(T(weight_ * o_ / e_), -n_ - 1);
      }
      const T r = T(ab / s_);
      const T sum = T(s_ + r);
      weight_ = scaled(T(weight_ * ((s_ - r) / sum)), -1);
      weight_up_ = size_up(weight_);
      s_ = scaled(sum, -1);
    }
    a_ = scaled(T(a_ + b_), -1);
    b_ = root_of(ab);
    ++n_;
  }
  /// By (2e + i k o), squared as often as steps are left; or, where k^2 < 0, numerator and
  /// denominator by 2e + k o and 2e - k o.
  void multiply_product() {
    const T twice = scaled(e_, 1);
    const T part = T(kappa_ * weight_ * o_);
    if (circular_) {
      terms_ += scaled(angle_of(raised(part, rough_bits), raised(twice, rough_bits)), -n_);
      if (n_ == 0) {
        re_ = twice;
        im_ = part;
      } else {
        const T square_re = T((re_ - im_) * (re_ + im_));
        const T square_im = scaled(T(re_ * im_), 1);
        re_ = T(square_re * twice - square_im * part);
        im_ = T(square_im * twice + square_re * part);
      }
    } else {  // atanh(k/H) = (1/2) log((2e + k o)/(2e - k o))
      re_ = n_ == 0 ? T(twice + part) : T(square_of(re_) * (twice + part));
      im_ = n_ == 0 ? T(twice - part) : T(square_of(im_) * (twice - part));
    }
    keep_in_range(std::max(exponent_of(re_), exponent_of(im_)), re_, im_);
  }

  /// What the sums and the mean give after n steps.
  [[nodiscard]] std::optional<landen_values<T>> values_here() const {
    const T mean = between(b_, a_);
    const T rough = scaled(T(rf_by_duplication(raised(x_, rough_bits), raised(y_, rough_bits),
                                               raised(z_, rough_bits), rough_bits) *
                             raised(a_, rough_bits)),
                           n_);
    const std::optional<T> phi = unwrapped(angle_of(T(mean * o_), c_), rough, q_);
    if (!phi) return std::nullopt;
    landen_values<T> result{scaled(T(*phi / mean), -n_), undefined_of<T>(q_), 0};
    if (!third_) return result;
    const T first = T(result.rf * weights_);
    const std::optional<T> second = sum_of_angles();
    if (!second) return std::nullopt;
    const T difference =
        with_error(T(first - *second), scale(multiply_up(weight_up_, size_up(result.rf)), 1));
    result.lost = bits_lost(difference, first, q_);
    result.rj = T(3 * scaled(difference, -1) / (P_ - x_));
    return result;
  }
  /// The second sum of (5).
  [[nodiscard]] std::optional<T> sum_of_angles() const {
    if (!product_wanted_) return terms_;
    if (!circular_) return T(scaled(log_of(T(re_ / im_)), -n_) / kappa_);
    const std::optional<T> angle = unwrapped(angle_of(im_, re_), scaled(terms_, n_ - 1), q_);
    if (!angle) return std::nullopt;
    return T(scaled(*angle, 1 - n_) / kappa_);
  }

  const T& x_;
  const T& y_;
  const T& z_;
  const T& P_;
  bool third_;
  bool product_wanted_;
  precision q_;
  std::int64_t wanted_;
  T a_, b_, c_, d_, e_, o_, s_;
  T kappa_;   // k
  T weight_;  // Q_n
  T weights_;
  T terms_;    // the second sum for k = 0, or roughly the angles
  T re_, im_;  // the product, or numerator and denominator of the argument of a logarithm
  bool circular_ = true;
  magnitude weight_up_ = magnitude::power_of_two(0);
  int n_ = 0;
};

/// Hypotheses: 0 <= x < y < z, numbers, and P > x. Nothing where an angle is too near a full turn
/// to be placed.
template <elliptic_scalar T>
[[nodiscard]] std::optional<landen_values<T>> by_landen(const T& x, const T& y, const T& z,
                                                        const T& P, third_kind kind, precision q) {
  return landen_steps<T>(x, y, z, P, kind, q).values();
}

}  // namespace polhode::detail
