// The proof, in integers: q changes its sign around the zero that was found, and by how much its
// position and its slope can be off.

#include <algorithm>
#include <cstdint>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/quadrature/gauss_legendre.hpp"
#include "quadrature/rules/gauss_legendre/few_limbs/neighbourhood.hpp"

namespace polhode::detail::legendre {

/// Let v be a bound of |T(g)| and of what T leaves out of q, in units, and r u a radius. |T''| <= M
/// = 2 |e_2| + 2^-22 on [g - r u, g + r u], as the other terms add at most 64 (6 * 2^-31 + 12 *
/// 2^-62 + ...); so |T'| >= t = |T'(g)| - r u M there, and where r t >= v, q is of other signs, or
/// 0, at g - r u and g + r u.
///
/// t: with r < 2^48 and F >= 128, r u M < 2^-72, as is what T'(g) is off by; they are less than one
/// unit of 2^-64. y is off by s r/n units, and by less than two for a product and a quotient that
/// are cut off. T' is off by M r units, and by what T'(g) is. That is true for each zero between g
/// - r u and g + r u; the zero's slope is s q'(y) = n T' and what T leaves out of q', times s <= 1.
/// |y - y_0| <= s (|g| + r u)/n, as |g| + r u is less than its first limb and two units of 2^-64.
std::optional<legendre_zero> neighbourhood::proved() {
  const number value = evaluate<false>(w_, last_);
  const number slope = evaluate<true>(w_, last_);
  // The greatest |y - y_0|.
  const auto n = static_cast<std::uint64_t>(shape_.n);
  const magnitude unit = magnitude::power_of_two(-64 * w_);
  const magnitude s = magnitude::from_bits_up(s_[1] + 1, -62);
  const magnitude size_of_g = magnitude::from_bits_up(g_.limbs[w_ - 1] + 2, -64);
  magnitude left_out_of_slope;
  if (last_ < shape_.degree) {
    const magnitude reach = divide_up(multiply_up(s, size_of_g), magnitude::from_integer_down(n));
    const taylor_remainder remainder = legendre_taylor_remainder(shape_.n, last_ + 1, reach);
    if (remainder.of_value > unit) return std::nullopt;
    left_out_of_slope = remainder.of_slope;
  }
  if (used(value.limbs, w_ + 1) > 1 || (value.limbs[0] >> 60) != 0) return std::nullopt;
  const std::uint64_t bound = value.limbs[0] + errors_[0] + 3 + 1;
  const limb least_slope =
      slope.limbs[w_] != 0 ? ~limb{0} : std::max(slope.limbs[w_ - 1], limb{1}) - 1;
  if (least_slope == 0) return std::nullopt;
  const uint128 radius = (uint128{bound} << 64) / least_slope + 1;
  if (radius >> 48 != 0) return std::nullopt;

  // s g / n
  const long size = w_ + 1;
  number y;
  multiply_by_s(y.limbs, g_.limbs, size, 1);
  mpn_divrem_1(y.limbs, 0, y.limbs, size, n);
  y.is_negative = g_.is_negative;
  limb centre[most_limbs + 1];
  mpn_zero(centre, size);
  centre[w_ - 1] = start_;
  add_to(y.limbs, y.is_negative, centre, false, size);
  const auto to_ball = [&](const number& x, const magnitude& error) {
    mpz_t z;
    const long length = used(x.limbs, size);
    const ball units(mpz_roinit_n(z, x.limbs, x.is_negative ? -length : length), 64 * w_);
    return scale(units, -64 * w_).enlarged(error);
  };
  const auto in_units = [&](std::uint64_t count) {
    return scale(magnitude::from_integer_up(count), -64 * w_);
  };
  const auto error_of_square = static_cast<std::uint64_t>((radius * (s_[1] + 1)) >> 62) / n + 3;
  uint128 bend = uint128{1} << 42;  // M in units of 2^-64
  if (last_ >= 2) bend += (uint128{e_[2].limbs[w_]} << 65) + 2 * (uint128{e_[2].limbs[w_ - 1]} + 1);
  const auto error_by_bend = static_cast<std::uint64_t>((radius * bend) >> 64) + 1;
  mpz_t z;
  return legendre_zero{to_ball(y, in_units(error_of_square)),
                       shape_.n * to_ball(slope, add_up(in_units(errors_[1] + 3 + error_by_bend),
                                                        left_out_of_slope)),
                       scale(ball(mpz_roinit_n(z, s_, 2), 128), -126)};
}

}  // namespace polhode::detail::legendre
