#include "formula_claims.hpp"

namespace polhode::checker {

const std::string& read_variable(const place& where) {
  const std::string& variable = where.text();
  if (!formula::is_variable(variable)) {
    where.malformed("it is " + in_quotes(variable) +
                    "; it must be a name that no function, constant or number has or resembles");
  }
  return variable;
}

range end_of(const formula& f, const place& where) {
  const budget::at here = where.working();
  if (const auto exact = f.exact_value()) return {*exact, *exact};
  const precision bits(region_bits.back(), where.work());
  const interval x = f(interval(rational(0), bits));
  return {x.lower(), x.upper()};
}

formula_inputs formula_inputs::read(const place& inputs, const char* name) {
  inputs.expect_keys({name, "variable", "from", "to"});
  const std::string& variable = read_variable(inputs["variable"]);
  return {formula::read(inputs[name], {variable}), formula::read(inputs["from"], {}),
          formula::read(inputs["to"], {}), variable, inputs};
}

number_ends read_number(const place& number) {
  constexpr long most_digits = 20'000;
  constexpr long most_bits = 80'000;
  const bool rounded = number.has("rounded");
  if (rounded) {
    number.expect_keys(
        {"value", "radius", "lower", "upper", "digits", "rounded", "digits_asked", "dyadic"});
    number["rounded"].expect_true();
  } else {
    number.expect_keys({"value", "radius", "lower", "upper", "digits", "digits_asked", "dyadic"});
  }
  const long asked = number["digits_asked"].whole(1, 1L << 40U);
  if (asked > most_digits) {
    number["digits_asked"].not_checkable("it is more than " + std::to_string(most_digits));
  }
  const range exact = examination::dyadic_range(number["dyadic"]);
  const budget::at here = number.working();
  budget& work = number.work();
  work.rationals(8, bit_length(exact.lower) + bit_length(exact.upper));
  const rational width(exact.upper - exact.lower);
  const long bits = bit_length(integer(denominator(width))) + 16;
  // Numerator and denominator together have twice the bits of the digits.
  if (bits > most_bits || bit_length(exact.lower) > 2 * most_bits ||
      bit_length(exact.upper) > 2 * most_bits) {
    number["dyadic"].not_checkable("its ends have too many digits");
  }
  // The digits that both ends share, cut off; or a value with an error.
  const long digits = number["digits"].whole(rounded ? 0 : 1, asked);
  if (!rounded) {
    const std::string low = decimal(exact.lower, digits, rounding::to_zero, work);
    if (low != decimal(exact.upper, digits, rounding::to_zero, work)) {
      number["digits"].refute("both ends do not share so many digits");
    }
    number["value"].expect_text(low);
  }
  // The decimals are outward, and about as near as the ends are to each other.
  expect_near(number, exact, asked);
  expect_radius(number);
  if (rounded) expect_rounded_digits(number, digits);
  return {exact, bits, digits};
}

}  // namespace polhode::checker
