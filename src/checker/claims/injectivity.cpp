// Whether epsilon(c) is injective.

#include <array>
#include <optional>
#include <string>

#include "answers.hpp"
#include "brackets.hpp"
#include "checker/functions.hpp"
#include "checker/twist.hpp"
#include "list.hpp"
#include "shapes.hpp"
#include "statements/injectivity.hpp"

namespace polhode::checker {
namespace {

/// Bits for the twist defect, which has some 50 at any precision.
constexpr std::array<long, 2> twist_precisions{128, 320};
/// The series are meant for numbers of this size: their cost grows with it, and with the number of
/// points.
constexpr long most_twist_bits = 4000;
constexpr long most_level_bits = 4000;
constexpr std::size_t most_points = 100;

void expect_side(const place& where, const body& rigid, const real& c, const rational& level,
                 int side, const std::string& wrong) {
  const budget::at here = where.working();
  const long size = bit_length(rigid.a) + bit_length(rigid.b) + bit_length(c);
  if (size > most_twist_bits || bit_length(level) > most_level_bits) {
    where.not_checkable("it, c, a and b have too many digits together");
  }
  for (const long bits : twist_precisions) {
    try {
      const long more = 2 * size;
      if (side_of_defect(rigid, c, level, precision(bits + more, where.work())) != side)
        where.refute(wrong);
      return;
    } catch (const undecided&) {  // more bits
    }
  }
  where.not_checkable("the checker's precision does not decide on which side epsilon is");
}

void check_chain(examination& e) {
  const body rigid = body_of(e);
  const place chain = e.witness("chain");
  if (chain.value().is_null()) {
    if (!e.is_missing(statements::chain_of_points)) {
      chain.malformed("it must be a chain of points");
    }
    return;
  }
  if (chain.size() < 3 || chain.size() > most_points) {
    chain.malformed("it must have from 3 to 100 points");
  }
  std::optional<rational> c_before;
  std::optional<rational> epsilon_before;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const place point = chain.at(i);
    point.expect_keys({"c", "lower", "upper"});
    const rational c = point["c"].fraction();
    const rational lower = point["lower"].decimal_value();
    const rational upper = point["upper"].decimal_value();
    if (c <= -rigid.b || c > rigid.a) point["c"].refute("it is not above -b and at most a");
    if (c_before && c >= *c_before) point["c"].refute("it must be below that of the point before");
    if (upper <= lower) point["upper"].refute("it is not above lower");
    if (epsilon_before && lower <= *epsilon_before) {
      point["lower"].not_checkable("it is not above the upper end of the point before");
    }
    expect_side(point["lower"], rigid, c, lower, 1, "epsilon(c) is below it");
    expect_side(point["upper"], rigid, c, upper, -1, "epsilon(c) is above it");
    c_before = c;
    epsilon_before = upper;
  }
  e.fact(statements::fill(statements::increasing_chain, {std::to_string(chain.size())}),
         [&](precision bits) { return below(exactly(*epsilon_before, bits), pi(bits) / 2); });
}

void check_two_c(examination& e) {
  const body rigid = body_of(e);
  const place two = e.witness("two_c");
  if (two.value().is_null()) {
    if (!e.is_missing(statements::pair_of_c)) two.malformed("it must be a pair");
    return;
  }
  two.expect_keys({"epsilon", "u_first", "u_second"});
  const rational level = two["epsilon"].fraction();
  const range first = examination::bracket(two["u_first"]);
  const range second = examination::bracket(two["u_second"]);
  if (first.lower <= 0) two["u_first"]["lower"].refute("it is not above 0");
  if (first.upper > second.lower) two["u_second"]["lower"].refute("it is below u_first");
  if (second.upper >= 1) two["u_second"]["upper"].refute("it is not below 1");
  const auto c_of = [&](const rational& u) { return real(-rigid.b * u); };
  const auto text = [&](const rational& u) { return decimal_for_reading(c_of(u), 12, e.work()); };
  const std::string above = "epsilon is above the level there";
  const std::string under = "epsilon is below the level there";
  expect_side(two["u_first"]["lower"], rigid, c_of(first.lower), level, -1, above);
  expect_side(two["u_first"]["upper"], rigid, c_of(first.upper), level, 1, under);
  expect_side(two["u_second"]["lower"], rigid, c_of(second.lower), level, 1, under);
  // epsilon <= pi/2 + arcsin sqrt(1 - u), as |psi_c| is at most the turning point.
  const auto most_is_below = [&](precision bits) -> tri {
    const interval sine_squared = exactly(rational(1 - second.upper), bits);
    const interval most = pi(bits) / 2 + atan(sqrt(sine_squared / exactly(second.upper, bits)));
    return below(most, exactly(level, bits));
  };
  if (most_is_below(precision(256 + size_of(second), e.work())) != tri(true)) {
    expect_side(two["u_second"]["upper"], rigid, c_of(second.upper), level, -1, above);
  }
  e.fact(statements::fill(statements::two_c_with_one_epsilon,
                          {decimal_for_reading(level, 8, e.work()), text(first.lower),
                           text(first.upper), text(second.lower), text(second.upper)}),
         true, enclosed);
}

void check_injectivity(examination& e) {
  const body rigid = check_body_and_steps(e);
  check_I(e);
  const bool physical = !rigid.is_above_I(1);
  e.fact(statements::fill(statements::injective_or_not,
                          {std::string(physical ? ">=" : "<"), rigid.kind_in_words(),
                           (physical ? "injective" : "not injective")}),
         physical == (rigid.kind() >= 0));
  if (physical) {
    check_chain(e);
  } else {
    check_two_c(e);
  }
}

}  // namespace

claim injectivity_claim() { return {statements::injectivity(), check_injectivity}; }

}  // namespace polhode::checker
