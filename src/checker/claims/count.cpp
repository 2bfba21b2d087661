// How often C and S intersect.

#include <string>
#include <utility>

#include "brackets.hpp"
#include "list.hpp"
#include "shapes.hpp"
#include "statements/count.hpp"

namespace polhode::checker {
namespace {

/// Dyadic numbers on both sides of the roots of q's ends, about as long as the lower one.
range roots_around(const range& q) {
  const long bits = bit_length(q.lower);
  const rational four_to_bits = power_of_two(2 * bits);
  const auto root = [&](const rational& x) {
    const rational scaled(x * four_to_bits);
    return floor_root(floor_quotient(numerator(scaled), denominator(scaled)));
  };
  return {rational(root(q.lower)) * power_of_two(-bits),
          rational(root(q.upper) + 1) * power_of_two(-bits)};
}

/// S is c = -b u with u = sin(epsilon)^2, and C is tangent to it: the derivative is -2 b sin cos,
/// where cos(epsilon) is positive for k odd and negative for k even.
void check_slopes(examination& e, int k, const range& u) {
  const auto product = [](const rational& x) { return rational(x * (1 - x)); };
  range products{product(u.lower), product(u.upper)};
  if (products.upper < products.lower) std::swap(products.lower, products.upper);
  if (2 * u.lower < 1 && 2 * u.upper > 1) products.upper = rational(1, 4);
  const bool is_inside = u.lower > 0 && u.upper < 1;
  const rational_neighbours b = neighbours_of(body_of(e).b);
  const range slope = is_inside ? roots_around({rational(4 * b.lower * b.lower * products.lower),
                                                rational(4 * b.upper * b.upper * products.upper)})
                                : products;
  e.fact(statements::fill(statements::slopes_at_meeting,
                          {std::to_string(k), k % 2 == 0 ? "" : "-", in_decimals(slope, e.work())}),
         is_inside);
}

void check_count(examination& e) {
  const body rigid = check_body_and_steps(e);
  check_I(e);
  const integer count = rigid.intersections();
  e.witness("N").expect_text(count.str());
  const auto q = [](const integer& k) { return rational(integer(2), 2 * k - 1); };
  e.fact(statements::fill(statements::number_of_meetings, {counted(count)}),
         (count == 0 || rigid.is_above_I(q(count))) && !rigid.is_above_I(q(count + 1)));
  check_values_of_half_phase(
      e, count, [&](int k) { return q(integer(k)); }, "intersections",
      [&](int k, const range& u) { check_slopes(e, k, u); });
}

}  // namespace

claim count_claim() { return {statements::count(), check_count}; }

}  // namespace polhode::checker
