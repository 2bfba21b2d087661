#include "proofs/printed_values.hpp"

#include <algorithm>
#include <array>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "proofs/claim.hpp"
#include "statements/shared.hpp"

namespace polhode::proofs {
namespace {

/// Rotational constants are inversely proportional to the moments of inertia.
body with_rotational_constants(const std::array<const char*, 3>& constants) {
  std::array<rational, 3> moments;
  for (std::size_t i = 0; i < moments.size(); ++i) moments[i] = 1 / parse_rational(constants[i]);
  return body::from_moments(moments);
}

body water_in_ground_state() { return with_rotational_constants({"9.28", "14.52", "27.88"}); }

int places_of(const std::string& printed) {
  const auto point = printed.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(printed.size() - point - 1);
}

printed_number geometric_constant_of(const std::string& where, const std::string& a,
                                     const std::string& b, const std::string& printed) {
  return {where, "I for a = " + a + ", b = " + b, printed, places_of(printed),
          [rigid = with_ab(a, b)](precision p) { return rigid.geometric_constant(p); }};
}

printed_number geometric_constant_of(const std::string& what, const body& rigid,
                                     const std::string& printed) {
  return {"section 8", "I for water, " + what, printed, places_of(printed),
          [rigid](precision p) { return rigid.geometric_constant(p); }};
}

printed_number paper_constant(const std::string& where, const std::string& name,
                              const std::string& printed) {
  return {where, name, printed, places_of(printed), find_constant(name)->enclose};
}

/// Where a number has so many digits, at most a few times as many bits decide how it rounds.
ball enclosed(const printed_number& n, long digits) {
  return enclose_to_digits(n.value, digits, 15 * bits_for_digits(digits) + 1024);
}

}  // namespace

body with_ab(const std::string& a, const std::string& b) {
  return {parse_rational(a), parse_rational(b)};
}

body water_at_equilibrium() { return with_rotational_constants({"9.5077", "14.5924", "27.2660"}); }

const std::vector<printed_number>& right_numbers() {
  static const std::vector<printed_number> numbers{
      geometric_constant_of("figure 6", "39.95", "0.0629", "0.59"),
      geometric_constant_of("figure 6", "18.27", "0.0629", "0.87"),
      geometric_constant_of("figure 6", "12.65", "0.0629", "1.05"),
      geometric_constant_of("figure 6", "3.1", "0.0629", "2.1"),
      paper_constant("eq. (39)", "epsilon0_min", "0.086374"),
      paper_constant("eq. (40)", "beta", "0.028973"),
      paper_constant("section 7", "delta_psi_max", "2.96884"),
      geometric_constant_of("equilibrium", water_at_equilibrium(), "1.001"),
  };
  return numbers;
}

const std::vector<printed_number>& wrong_numbers() {
  static const std::vector<printed_number> numbers = [] {
    std::vector<printed_number> list{
        geometric_constant_of("figure 7", "12.65", "0.06", "1.045"),
        geometric_constant_of("figure 7", "13.89", "0.06", "1"),
        geometric_constant_of("figure 7", "15.38", "0.06", "0.951"),
        geometric_constant_of("figure 7", "18.27", "0.06", "0.872"),
        geometric_constant_of("ground state", water_in_ground_state(), "0.946"),
    };
    list[1].places = 3;  // "1" beside numbers of three decimals
    return list;
  }();
  return numbers;
}

std::string as_read(const std::string& printed, int places) {
  if (places == places_of(printed)) return printed;
  return printed + " (read as " + printed + "." +
         std::string(static_cast<std::size_t>(places), '0') + ", as its neighbours have " +
         std::to_string(places) + " decimals)";
}

rounding check_rounding(const std::string& printed, int places, const ball& value) {
  const rational decimal = parse_rational(printed);
  const rational half_unit = parse_rational("0.5e-" + std::to_string(places));
  const ball distance = abs(value - decimal);
  const ball limit(half_unit, std::max<precision>(value.precision(), 64));
  if (certainly_less_equal(distance, limit)) return rounding::right;
  if (certainly_less(limit, distance)) return rounding::wrong;
  return rounding::undecided;
}

void add_printed_numbers(certificate& c, const std::vector<printed_number>& numbers,
                         rounding expected, long digits) {
  constexpr long shown_digits = 10;
  for (const printed_number& n : numbers) {
    c.numbers.push_back({n.where + ": " + n.what, enclosed(n, digits), digits});
    const ball value = enclosed(n, shown_digits);
    c.facts.push_back(
        {statements::fill(
             expected == rounding::right ? statements::printed_and_right
                                         : statements::printed_and_wrong,
             {n.where, as_read(n.printed, n.places), n.what, to_decimal(value, shown_digits)}),
         check_rounding(n.printed, n.places, value) == expected, step_kind::enclosed});
  }
}

}  // namespace polhode::proofs
