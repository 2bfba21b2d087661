#pragma once

// Carlson's integrals at numbers: the choice of method, over any scalar of real_scalar.hpp. The
// results have about q good bits where nothing cancels; bits_lost and the radius of a ball tell.

#include <algorithm>

#include "elliptic/carlson_core.hpp"

namespace polhode::detail {

/// From so many bits on Landen's transformation is the faster one (bench/elliptic.cpp).
inline constexpr precision least_bits_for_landen_rf = 175;
inline constexpr precision least_bits_for_landen_rj = 240;

template <elliptic_scalar T>
[[nodiscard]] bool are_equal(const T& x, const T& y) {
  return sign_in(T(x - y)) == 0;  // of numbers the difference is 0 only where they are the same
}

template <elliptic_scalar T>
void sort(T& x, T& y, T& z) {
  if (is_below(y, x)) std::swap(x, y);
  if (is_below(z, y)) std::swap(y, z);
  if (is_below(y, x)) std::swap(x, y);
}

/// The differences are so small that duplication has little to do.
template <elliptic_scalar T>
[[nodiscard]] bool are_close(const T& x, const T& z, precision q) {
  return exponent_of(T(z - x)) < exponent_of(z) - q / 8;
}

template <elliptic_scalar T>
[[nodiscard]] T rf_at(T x, T y, T z, precision q) {
  if (!is_number(x) || !is_number(y) || !is_number(z)) return undefined_of<T>(q);
  sort(x, y, z);
  if (sign_in(y) <= 0 || sign_in(x) < 0) return undefined_of<T>(q);
  if (are_equal(y, z)) return rc_at(x, y, q);
  if (are_equal(x, y)) return rc_at(z, x, q);
  if (sign_in(x) == 0) {
    return T(pi_of<T>(q) / (2 * agm_of(root_of(z), root_of(y))));  // C. F. Gauss; DLMF 19.22.1
  } else if (q >= least_bits_for_landen_rf && !are_close(x, z, q)) {
    const auto values = by_landen(x, y, z, z, third_kind::absent, q);
    if (values) return values->rf;
  }
  return rf_by_duplication(x, y, z, q);
}

/// R_J (R_D where p is z or y) for x < y < z, p > x, at full accuracy or by duplication. Where R_F
/// comes with it, *rf is set.
template <elliptic_scalar T>
[[nodiscard]] T rj_of_distinct(const T& x, const T& y, const T& z, const T& p, third_kind kind,
                               precision q, std::optional<T>* rf = nullptr) {
  const bool complete = sign_in(x) == 0;
  const bool worthwhile = (complete || q >= least_bits_for_landen_rj) && !are_close(x, z, q) &&
                          std::abs(exponent_of(T(p - x)) - exponent_of(T(z - x))) < q / 4;
  precision more = 0;
  for (int attempt = 0; worthwhile && attempt < 2; ++attempt) {
    const precision bits = q + more;
    const T X = raised(x, bits);
    const T Y = raised(y, bits);
    const T Z = raised(z, bits);
    const T P = raised(p, bits);
    const auto values =
        complete ? complete_by_landen(Y, Z, P, bits) : by_landen(X, Y, Z, P, kind, bits);
    if (!values) break;
    if (rf != nullptr) *rf = values->rf;
    if (values->lost <= more + 48) return values->rj;
    more = static_cast<precision>(values->lost);
    if (more > q || bits == long_double_bits) break;
  }
  if (kind == third_kind::general) return rj_by_duplication(x, y, z, p, false, q);
  return are_equal(p, z) ? rj_by_duplication(x, y, z, p, true, q)
                         : rj_by_duplication(x, z, y, p, true, q);
}

/// R_J for numbers x <= y <= z, the first one >= 0 and the second > 0, and p > 0.
template <elliptic_scalar T>
[[nodiscard]] T rj_of_sorted(const T& x, const T& y, const T& z, const T& p, precision q,
                             std::optional<T>* rf = nullptr) {
  const bool low = are_equal(p, x);
  const bool middle = are_equal(p, y);
  const bool high = are_equal(p, z);
  const bool distinct = is_below(x, y) && is_below(y, z);
  const bool landen_wanted = q >= least_bits_for_landen_rj || sign_in(x) == 0;
  if (exponent_of(p) - exponent_of(z) > q / 4) {
    // p far above z: with (p-z)(r-z) = (z-x)(z-y), z <= r,
    //   (p-z) R_J(p) = 3 R_F - 3 R_C(xy/z, pr/z) - (r-z) R_J(r)     (DLMF 19.21.12),
    // of which the last two are of the order of (z/p)^(1/2) and z/p beside the first.
    const T above = T((z - x) * (z - y) / (p - z));
    const T r = T(z + above);
    const T rj = rj_by_duplication(x, y, z, r, false, q);
    const T first = rf_at(x, y, z, q);
    if (rf != nullptr) *rf = first;
    return T((3 * (first - rc_at(T(x * y / z), T(p * r / z), q)) - above * rj) / (p - z));
  }
  if (distinct && is_below(x, p) && landen_wanted && !low) {
    return rj_of_distinct(x, y, z, p,
                          middle || high ? third_kind::equals_y_or_z : third_kind::general, q, rf);
  }
  if (distinct && landen_wanted && q > long_double_bits && !are_close(x, z, q)) {
    // p <= x: with (z-p)(z-r) = (z-x)(z-y), y <= r < z,
    //   (z-p) R_J(p) = 3 R_C(xy/z, pr/z) - 3 R_F - (z-r) R_J(r)     (DLMF 19.21.12)
    const T above = T((z - x) * (z - y) / (z - p));
    const T r = T(z - above);
    const T rj = low ? rj_of_distinct(x, y, z, y, third_kind::equals_y_or_z, q)
                     : rj_of_distinct(x, y, z, r, third_kind::general, q);
    const T rc = rc_at(T(x * y / z), T(p * r / z), q);
    const T value = T(3 * (rc - rf_at(x, y, z, q)) - above * rj);
    if (bits_lost(value, T(3 * rc), q) <= 48) return T(value / (z - p));
  }
  if (high) return rj_by_duplication(x, y, z, p, true, q);
  if (middle) return rj_by_duplication(x, z, y, p, true, q);
  if (low) return rj_by_duplication(y, z, x, p, true, q);
  if (!distinct && landen_wanted && q > long_double_bits) {
    // R_J(x,y,y,p) = 3 (R_C(x,y) - R_C(x,p)) / (p - y)     (DLMF 19.20.8)
    const T& single = are_equal(y, z) ? x : z;
    const T first = rc_at(single, y, q);
    const T difference = T(first - rc_at(single, p, q));
    if (bits_lost(difference, first, q) <= 48) return T(3 * difference / (p - y));
  }
  return rj_by_duplication(x, y, z, p, false, q);
}

template <elliptic_scalar T>
[[nodiscard]] T rj_at(T x, T y, T z, const T& p, precision q, std::optional<T>* rf = nullptr) {
  if (!is_number(x) || !is_number(y) || !is_number(z) || !is_number(p)) return undefined_of<T>(q);
  sort(x, y, z);
  const int sign = sign_in(p);
  if (sign_in(y) <= 0 || sign_in(x) < 0 || sign == 0 || sign == 2) return undefined_of<T>(q);
  if (sign > 0) return rj_of_sorted(x, y, z, p, q, rf);
  // p = -s: with r = y + (z-y)(y-x)/(y+s),
  //   (y+s) R_J(-s) = (r-y) R_J(r) - 3 R_F + 3 sqrt(xyz/(xz+rs)) R_C(xz+rs, rs)
  // (Carlson 1995, (2.22); DLMF 19.20.14).
  const T s = T(-p);
  const T above = T((z - y) * (y - x) / (y + s));
  const T r = T(y + above);
  const T rs = T(r * s);
  const T sum = T(x * z + rs);
  T value = T(3 * root_of(T(x * y * z / sum)) * rc_at(sum, rs, q) - 3 * rf_at(x, y, z, q));
  if (sign_in(above) > 0) {
    if (is_below(y, r)) {
      value += above * rj_of_sorted(x, y, z, r, q);
    } else {  // too near y to tell
      value += above * rj_by_duplication(x, y, z, r, false, q);
    }
  }
  return T(value / (y + s));
}

template <elliptic_scalar T>
[[nodiscard]] T rd_at(const T& x, const T& y, const T& z, precision q) {
  if (!is_number(x) || !is_number(y) || !is_number(z)) return undefined_of<T>(q);
  if (sign_in(x) < 0 || sign_in(y) < 0 || sign_in(z) <= 0) return undefined_of<T>(q);
  if (sign_in(x) == 0 && sign_in(y) == 0) return undefined_of<T>(q);
  T a = x;
  T b = y;
  T c = z;
  sort(a, b, c);
  return rj_of_sorted(a, b, c, z, q);
}

/// 2 R_G = y R_F + (z-y)(y-x) R_D(x,z,y)/3 + sqrt(xz/y) for x <= y <= z: no term is negative (DLMF
/// 19.21.10).
template <elliptic_scalar T>
[[nodiscard]] T rg_at(T x, T y, T z, precision q) {
  if (!is_number(x) || !is_number(y) || !is_number(z)) return undefined_of<T>(q);
  sort(x, y, z);
  if (sign_in(x) < 0) return undefined_of<T>(q);
  if (sign_in(y) == 0) return scaled(root_of(z), -1);  // DLMF 19.20.4
  T sum = T(y * rf_at(x, y, z, q) + root_of(T(x * z / y)));
  if (is_below(x, y) && is_below(y, z)) {
    sum += (z - y) * (y - x) * rj_of_sorted(x, y, z, y, q) / 3;
  }
  return scaled(sum, -1);
}

template <elliptic_scalar T>
[[nodiscard]] T rc_point(const T& x, const T& y, precision q) {
  if (!is_number(x) || !is_number(y)) return undefined_of<T>(q);
  const int sign = sign_in(y);
  if (sign_in(x) < 0 || sign == 0 || sign == 2) return undefined_of<T>(q);
  if (sign > 0) return rc_at(x, y, q);
  // R_C(x, -s) = sqrt(x/(x+s)) R_C(x+s, s) (DLMF 19.2.20).
  const T sum = T(x - y);
  return T(root_of(T(x / sum)) * rc_at(sum, T(-y), q));
}

}  // namespace polhode::detail
