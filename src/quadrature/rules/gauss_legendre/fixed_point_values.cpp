#include "quadrature/rules/gauss_legendre/fixed_point_values.hpp"

#include <algorithm>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail::legendre {

static_assert(GMP_NUMB_BITS == 64, "limbs of 64 bits without nails");

/// At `count` arguments; a number is kept with a limb below it, into which the product's lowest
/// limb goes.
void fixed_point_polynomial::evaluate(const std::uint64_t* arguments, std::size_t count,
                                      std::vector<values>& results) const {
  const mp_size_t limbs_of_one = coefficients_.size;
  const auto size = static_cast<std::size_t>(limbs_of_one);
  const std::size_t room = size + 1;
  limbs value(count * room, 0);
  limbs slope(count * room, 0);
  limbs fresh(room);
  // number = addend + floor(number * argument / 2^64)
  const auto step = [&](mp_limb_t* number, std::uint64_t argument, const mp_limb_t* addend) {
    fresh[0] = 0;
    mpn_copyi(fresh.data() + 1, addend, limbs_of_one);
    fresh[size] += mpn_addmul_1(fresh.data(), number, limbs_of_one, argument);
    // As an unsigned number a negative one is 2^(64 size) too large.
    if ((number[size - 1] >> 63) != 0) fresh[size] -= argument;
    mpn_copyi(number, fresh.data() + 1, limbs_of_one);
  };
  for (long j = 0; j <= degree_; ++j) {
    const mp_limb_t* const coefficient =
        coefficients_.limbs.data() + static_cast<std::size_t>(j) * size;
    for (std::size_t i = 0; i < count; ++i) {
      mp_limb_t* const v = value.data() + i * room;
      if (j > 0) step(slope.data() + i * room, arguments[i], v);
      step(v, arguments[i], coefficient);
    }
  }
  const auto to_ball = [&](mp_limb_t* number, std::uint64_t error) {
    const bool is_negative = (number[size - 1] >> 63) != 0;
    if (is_negative) mpn_neg(number, number, limbs_of_one);
    mp_size_t used = limbs_of_one;
    while (used > 0 && number[used - 1] == 0) --used;
    mpz_t z;
    const precision bits = coefficients_.fraction_bits;
    const ball units(mpz_roinit_n(z, number, is_negative ? -used : used), bits);
    return scale(units, -bits).enlarged(scale(magnitude::from_integer_up(error), -bits));
  };
  const auto m = static_cast<std::uint64_t>(degree_);
  for (std::size_t i = 0; i < count; ++i) {
    results.push_back({to_ball(value.data() + i * room, 2 * (m + 1)),
                       to_ball(slope.data() + i * room, m * (m + 2))});
  }
}

std::vector<fixed_point_polynomial::values> fixed_point_polynomial::at(
    const std::vector<std::uint64_t>& arguments) const {
  constexpr std::size_t together = 8;
  std::vector<values> results;
  results.reserve(arguments.size());
  for (std::size_t first = 0; first < arguments.size(); first += together) {
    evaluate(arguments.data() + first, std::min(together, arguments.size() - first), results);
  }
  return results;
}

}  // namespace polhode::detail::legendre
