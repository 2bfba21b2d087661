#pragma once

// Jacobi's functions at numbers, over any scalar of real_scalar.hpp. The method is in jacobi.hpp.

#include <vector>

#include "elliptic/legendre_points.hpp"
#include "polhode/elliptic/jacobi.hpp"

namespace polhode::detail {

template <elliptic_scalar T>
[[nodiscard]] jacobi_values<T> undefined_values(precision q) {
  return {undefined_of<T>(q), undefined_of<T>(q), undefined_of<T>(q)};
}

/// {M, e_0, e_1, ...} of the AGM of 1 and sqrt m1: M a ball that holds [b_N, a_N].
template <elliptic_scalar T>
struct agm_ladder {
  T mean;
  std::vector<T> e;
};
template <elliptic_scalar T>
[[nodiscard]] std::optional<agm_ladder<T>> ladder_of(const T& m1, precision q) {
  const std::int64_t wanted = last_difference<T>(q);
  agm_ladder<T> result{whole<T>(1, q), {}};
  T a = whole<T>(1, q);
  T b = root_of(m1);
  constexpr int most_steps = 100;
  for (int n = 0; n < most_steps; ++n) {
    const T half_difference = scaled(T(a - b), -1);
    if (log2_up(divide_up(size_up(half_difference), size_down(b))) < wanted) {
      result.mean = between(b, a);
      return result;
    }
    const T mean = scaled(T(a + b), -1);
    result.e.push_back(T(half_difference * mean));
    b = root_of(T(a * b));
    a = mean;
  }
  return std::nullopt;
}

/// m and m1 with so many bits, which beyond 1 in size the one that is not given does not have.
template <elliptic_scalar T>
[[nodiscard]] modulus<T> with_bits(const modulus<T>& k, precision bits) {
  if constexpr (std::same_as<T, ball>) {
    if (k.m.is_exact()) return modulus_of(k.m, false, bits);
    return k.m1.is_exact() ? modulus_of(k.m1, true, bits) : k;
  } else {
    return modulus_of(exponent_of(k.m1) < -1 ? k.m1 : k.m, exponent_of(k.m1) < -1, bits);
  }
}
/// Bits that M u has before the point: M is at most max(1, sqrt m1).
template <elliptic_scalar T>
[[nodiscard]] std::int64_t bits_before_point(const T& u, const T& m1) {
  return std::max<std::int64_t>(
      exponent_of(u) + 1 + std::max<std::int64_t>(exponent_of(m1) / 2 + 1, 0), 0);
}

/// sn, cn, dn for numbers u and m < 1; M u is set too.
template <elliptic_scalar T>
[[nodiscard]] jacobi_values<T> jacobi_below_one(const T& u, const T& m1, precision q, T& angle) {
  const std::int64_t before_point = bits_before_point(u, m1);
  if (!is_number(u) || before_point > most_bits_before_point) return undefined_values<T>(q);
  const precision more = std::same_as<T, long double> ? 0 : static_cast<precision>(before_point);
  const auto ladder = ladder_of(raised(m1, q + more), q + more);
  if (!ladder) return undefined_values<T>(q);
  angle = T(ladder->mean * raised(u, q + more));
  auto [sine, cosine] = sine_cosine(angle);
  T o = raised(sine, q);
  const T mean = raised(ladder->mean, q);
  T z = T(mean * raised(cosine, q));
  T g = mean;
  T h = mean;
  for (std::size_t n = ladder->e.size(); n-- > 0;) {
    const T hh = square_of(h);
    const T eo = T(raised(ladder->e[n], q) * square_of(o));
    o = T(o * h);
    z = T(z * g);
    g = T(hh - eo);
    h = T(hh + eo);
    keep_in_range(exponent_of(h), o, z, g, h);
  }
  const T sn = T(o / h);
  const T cn = T(z / h);
  const T dn = root_of(T(square_of(cn) + raised(m1, q) * square_of(sn)));
  return {sn, cn, dn};
}

/// The same for u and m < 1; for m < -1, where sn may come with a cancellation of as many bits as
/// sqrt m1 has, by
///   sn(u|m) = sd(r u|M)/r, cn = cd, dn = nd,  r^2 = m1, 1 - M = 1/m1
///     (DLMF 22.17(i)), M u being the same.
template <elliptic_scalar T>
[[nodiscard]] jacobi_values<T> jacobi_of_number(const T& u, const modulus<T>& k, precision q,
                                                T& angle) {
  const std::int64_t more = bits_before_point(u, k.m1);
  if (!is_number(u) || more > most_bits_before_point) return undefined_values<T>(q);
  const T m1 = with_bits(k, q + static_cast<precision>(more)).m1;
  if (!is_below(T(k.m + 1), whole<T>(0, q))) return jacobi_below_one(u, m1, q, angle);
  const T r = root_of(m1);
  const auto w =
      jacobi_below_one(T(r * raised(u, bits_in(m1))), T(whole<T>(1, bits_in(m1)) / m1), q, angle);
  return {T(w.sn / (w.dn * r)), T(w.cn / w.dn), T(1 / w.dn)};
}

template <elliptic_scalar T>
[[nodiscard]] jacobi_values<T> jacobi_at(const T& u, const modulus<T>& k, precision q) {
  const int sign = sign_in(k.m1);
  if (!is_number(u) || sign == 2) return undefined_values<T>(q);
  if (sign == 0) {  // m = 1
    const T sech = T(1 / cosh_of(u));
    return {tanh_of(u), sech, sech};
  }
  T angle = u;
  if (sign > 0) return jacobi_of_number(u, k, q, angle);
  // m > 1: k sn(u|m) = sn(k u | 1/m), cn(u|m) = dn(k u | 1/m), dn(u|m) = cn(k u | 1/m), where 1 -
  // 1/m = -m1/m. With q bits and as many more as k u has before the point, so that those of its
  // argument are enough for the AGM.
  const std::int64_t more = std::max<std::int64_t>(exponent_of(u) + exponent_of(k.m) + 8, 0);
  if (more > most_bits_before_point) return undefined_values<T>(q);
  const precision bits = q + static_cast<precision>(more);
  const modulus<T> w = with_bits(k, bits + static_cast<precision>(more));
  const T root = root_of(raised(w.m, bits));
  const auto values = jacobi_below_one(T(root * raised(u, bits)),
                                       T(-raised(w.m1, bits) / raised(w.m, bits)), q, angle);
  return {T(values.sn / root), values.dn, values.cn};
}

/// |am(u) - M u| <= pi/2, since both are j pi/2 at u = j K and increase: that tells the turn.
template <elliptic_scalar T>
[[nodiscard]] T am_at(const T& u, const modulus<T>& k, precision q) {
  const int sign = sign_in(k.m1);
  if (!is_number(u) || sign < 0 || sign == 2) return undefined_of<T>(q);
  if (sign == 0) return atan_of(sinh_of(u));
  T rough = u;
  const auto values = jacobi_of_number(u, k, q, rough);
  if (!is_number(values.sn) || !is_number(values.cn)) return undefined_of<T>(q);
  const T angle = angle_of(values.sn, values.cn);
  const auto result = unwrapped(angle, rough, bits_in(rough));
  return result ? *result : undefined_of<T>(q);
}

}  // namespace polhode::detail
