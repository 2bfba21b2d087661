#include "count_zeros.hpp"

#include <algorithm>

namespace polhode {
namespace {

magnitude power_up(const magnitude& x, int n) {
  magnitude r = magnitude::power_of_two(0);
  for (int k = 0; k < n; ++k) r = multiply_up(r, x);
  return r;
}
magnitude power_down(const magnitude& x, int n) {
  magnitude r = magnitude::power_of_two(0);
  for (int k = 0; k < n; ++k) r = multiply_down(r, x);
  return r;
}

}  // namespace

std::optional<counted_zeros> count_zeros(const real_function& f, const rational& c,
                                         const rational& least_radius, precision p) {
  constexpr int n = 32;  // coefficients
  constexpr int most_count = 16;
  constexpr int log2_ratio = 3;  // R = 8 r
  constexpr int tries = 12;
  if (f.most_order() < n) return std::nullopt;
  counted_zeros result;
  const jet<ball, dynamic_order> at_c = f.at(p)->series(ball(c, p), n - 1);
  ++result.evaluations;
  // A power of 2 that is more than least_radius.
  const rational positive = std::max(least_radius, rational(1, integer(1) << 400U));
  const mpq_srcptr q = positive.backend().data();
  long exponent = static_cast<long>(mpz_sizeinbase(mpq_numref(q), 2)) -
                  static_cast<long>(mpz_sizeinbase(mpq_denref(q), 2)) + 2;
  // A greater disc, on which the bound is better beside |f_m| r^m, where a small one fails.
  for (int k = 0; k < tries; ++k, exponent += std::max(4L, -exponent / 3)) {
    const magnitude r = magnitude::power_of_two(exponent);
    // The square around the disc of radius R.
    const magnitude big = scale(r, log2_ratio);
    const ball around_zero = ball(0, p).enlarged(big);
    const region square = region::in_balls({ball(c, p).enlarged(big), around_zero});
    const region value = f.over(square);
    ++result.evaluations;
    if (!value.is_analytic()) return std::nullopt;  // nor on a greater one
    const magnitude bound = value.magnitude_upper();
    // B 2^(-3n) / (1 - 1/8), 1 / (1 - 1/8) < 2.
    const magnitude rest = scale(bound, 1 - static_cast<std::int64_t>(log2_ratio) * n);
    for (int m = 0; m <= most_count; ++m) {
      magnitude others = rest;
      for (int j = 0; j < n; ++j) {
        if (j != m) {
          others = add_up(others, multiply_up(at_c[j].magnitude_upper(), power_up(r, j)));
        }
      }
      if (others < multiply_down(at_c[m].magnitude_lower(), power_down(r, m))) {
        result.count = m;
        mpq_set_ui(result.radius.backend().data(), 1, 1);
        if (exponent >= 0) {
          mpq_mul_2exp(result.radius.backend().data(), result.radius.backend().data(),
                       static_cast<mp_bitcnt_t>(exponent));
        } else {
          mpq_div_2exp(result.radius.backend().data(), result.radius.backend().data(),
                       static_cast<mp_bitcnt_t>(-exponent));
        }
        return result;
      }
    }
  }
  return std::nullopt;
}

}  // namespace polhode
