#pragma once

// Theta functions of complex arguments.

#include "plane.hpp"

namespace polhode::detail::in_plane {

/// The sum of the definition, DLMF 20.2(i): with l = 2n+1 (theta_1, theta_2) or 2n, the terms are
/// in size at most b_l = 2 |q|^(l^2/4) e^(l |Im z|), times l in the derivative. b_(l+2)/b_l =
/// |q|^(l+1) e^(2 |Im z|) falls; where it is at most 1/6, the terms from l >= 1 on have ratios of
/// at most (l+2)/l/6 <= 1/2, and their sum is at most twice the first.
template <class Z>
Z theta_series(int j, bool derivative, const Z& z, const Z& q) {
  if (j < 1 || j > 4) {
    throw std::invalid_argument("theta functions are numbered 1 to 4, not " + std::to_string(j));
  }
  const bool half = j <= 2;
  const Z quarter_power = half ? plane<Z>::root(plane<Z>::root(q)) : plane<Z>::number(1, q);
  if (!is_known(z) || !is_known(quarter_power)) return plane<Z>::failed(q);
  const magnitude size_of_q = size(q);
  if (!(size_of_q <= scale(magnitude::from_integer_up(63), -6))) return plane<Z>::failed(q);
  const magnitude growth = exp(abs(plane<Z>::set(z).im).with_precision(64)).magnitude_upper();
  const magnitude growth_of_two = multiply_up(growth, growth);
  const Z qq = square(q);
  Z power = 2 * quarter_power;  // 2 q^(l^2/4)
  Z ratio = half ? qq : q;      // q^(l+1)
  Z sum = plane<Z>::number(half || derivative ? 0 : 1, q);
  magnitude bound = multiply_up(size(power), half ? growth : magnitude::power_of_two(0));  // b_l
  magnitude greatest = half ? bound : magnitude::power_of_two(0);
  if (!half) {  // the term of l = 0 is there already
    bound = multiply_up(multiply_up(bound, size(ratio)), growth_of_two);
    power *= ratio;
    ratio *= qq;
    greatest = max(greatest, bound);
  }
  constexpr long most_terms = 400;
  for (long l = half ? 1 : 2; l < most_terms; l += 2) {
    const magnitude next_ratio = multiply_up(size(ratio), growth_of_two);
    const magnitude factor =
        magnitude::from_integer_up(derivative ? static_cast<std::uint64_t>(l) : 1);
    const magnitude first = multiply_up(bound, factor);
    const bool falls =
        next_ratio <= divide_up(magnitude::power_of_two(0), magnitude::from_integer_up(7));
    if (falls && l > 2 && first <= scale(greatest, -plane<Z>::bits(q))) {
      return plane<Z>::enlarged(sum, scale(first, 1));
    }
    if (first.is_infinite()) break;
    const long n = l / 2;
    const bool negative = (j == 1 || j == 4) && n % 2 != 0;
    const Z angle = z * l;
    // d sin(lz) = l cos(lz), d cos(lz) = -l sin(lz)
    const Z wave = (j == 1) != derivative ? sin(angle) : cos(angle);
    Z term = power * wave;
    if (derivative) term = term * (j == 1 ? l : -l);
    sum += negative ? -term : term;
    bound = multiply_up(bound, next_ratio);
    greatest = max(greatest, bound);
    power *= ratio;
    ratio *= qq;
  }
  return plane<Z>::failed(q);
}

}  // namespace polhode::detail::in_plane
