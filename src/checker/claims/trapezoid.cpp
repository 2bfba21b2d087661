#include "trapezoid.hpp"

#include <string>

#include "answers.hpp"
#include "checker/elliptic.hpp"
#include "checker/functions.hpp"
#include "statements/shared.hpp"

namespace polhode::checker {

interval check_quadrature(const place& where, const periodic_integrand& f, long extra) {
  constexpr long most_nodes = 200'000;
  const budget::at here = where.working();
  constexpr long most_work =
      30'000'000;  // nodes times bits: what is far beyond a proof's need is refused at once
  where["rule"].expect_text(statements::periodic_rule);
  const long n = where["nodes"].whole(1, most_nodes);
  const rational half_width = where["half_width"].fraction();
  if (half_width <= 0 || half_width > 100 || bit_length(half_width) > 4096) {
    where["half_width"].malformed("it must be a positive rational up to 100, of at most 4096 bits");
  }
  // e^(2 n H) is 2^(2.885... n H).
  const rational exponent(half_width * n * 3);
  const precision bits(
      96 + extra + static_cast<long>(floor_quotient(numerator(exponent), denominator(exponent))),
      where.work());
  if (bits > most_work / n) where["nodes"].not_checkable("it would take too many operations");
  try {
    const interval least = f.supremum(half_width, bits);
    const place given_supremum = where["supremum"];
    if (given_supremum.decimal_value() < least.upper()) {
      given_supremum.refute("the supremum on the strip is not shown to be below it");
    }
    const periodic_integral own = periodic_trapezoid(f.value, n, half_width, least.upper(), bits);
    const place error = where["truncation_error"];
    if (error.decimal_value() < own.truncation_bound.upper()) {
      error.refute("the truncation error is not shown to be below it");
    }
    // They are rounded outward, not bounds of any size.
    const rational slack(1'000'001, 1'000'000);
    if (given_supremum.decimal_value() > least.upper() * slack) {
      given_supremum.refute("it is not the supremum's bound, rounded up");
    }
    if (error.decimal_value() > own.truncation_bound.upper() * rational(11, 10)) {
      error.refute("it is not the truncation error's bound, rounded up");
    }
    return own.value;
  } catch (const undecided& problem) {
    where["half_width"].not_checkable(std::string("no bound is proved on this strip: ") +
                                      problem.what());
  }
}

interval cosh_of(const rational& half_width, precision bits) {
  const interval growth = exp(exactly(half_width, bits));
  return (growth + exactly(1, bits) / growth) / 2;
}

}  // namespace polhode::checker
