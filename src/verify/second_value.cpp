#include "polhode/verify/second_value.hpp"

#include <cctype>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "base/clock.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/mpfr_functions.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode {
namespace {

constexpr const char* what = "the value";

/// Half as many again, odd.
precision other_bits(precision bits) { return (bits + bits / 2) | 1; }

/// The report of a route that enclosed the value; throws where it has nothing in common with the
/// first.
route_report judged(const finding<ball>& first, const finding<ball>& second, long digits,
                    double seconds) {
  route_report result;
  result.route = second.route;
  result.seconds = seconds;
  expect_overlap(what, first, second);
  magnitude goal = confirming_radius(first.enclosure, digits);
  if (goal.is_zero()) goal = magnitude::power_of_two(-bits_for_digits(digits));  // it is exactly 0
  if (!second.enclosure.is_bounded()) {
    result.obstacle = "it has no enclosure of the value";
  } else if (!(second.enclosure.radius() <= goal)) {
    result.obstacle = "its enclosure is wider than the digits that are asked for";
  } else {
    result.enclosure = second.enclosure;
  }
  return result;
}

route_report in_complex_arithmetic(const expression& f, const finding<ball>& first, precision bits,
                                   long digits) {
  const auto start = detail::clock::now();
  const std::string route = fmt::format("complex arithmetic with {} bits", bits);
  const region value = f.evaluator<region>(bits)(region::in_balls(complex_ball(0, bits)));
  if (!value.is_analytic()) {
    route_report result;
    result.route = route;
    result.seconds = detail::seconds_since(start);
    result.obstacle = value.where().empty() ? "not analytic"
                                            : fmt::format("{} of complex numbers", value.where());
    return result;
  }
  return judged(first, {route, value.to_complex_ball().re}, digits, detail::seconds_since(start));
}

}  // namespace

namespace {

second_opinion in_other_arithmetic(const expression& f, const finding<ball>& known, precision bits,
                                   long digits) {
  const detail::only_mpfr_functions mpfr_functions;
  const precision more = other_bits(bits);
  second_opinion result;
  result.add(in_complex_arithmetic(f, known, more, digits));
  if (result.agrees()) return result;
  const auto start = detail::clock::now();
  const ball value = f.value(more);
  result.add(judged(known, {fmt::format("real arithmetic with {} bits", more), value}, digits,
                    detail::seconds_since(start)));
  return result;
}

}  // namespace

second_opinion value_again(const expression& f, const ball& first, precision bits, long digits) {
  return in_other_arithmetic(f, {fmt::format("real arithmetic with {} bits", bits), first}, bits,
                             digits);
}

second_opinion rational_value_again(const expression& f, const rational& exact, long digits) {
  const precision bits = bits_for_digits(digits) + 64;
  return in_other_arithmetic(f, {"exact rules", ball(exact, bits)}, bits, digits);
}

// ---------------------------------------------------------------------------------------------
// Exact values

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Where the number that begins there ends: digits, a point, an exponent.
std::size_t end_of_number(const std::string& text, std::size_t at) {
  while (at < text.size() && (is_digit(text[at]) || text[at] == '.')) ++at;
  if (at == text.size() || (text[at] != 'e' && text[at] != 'E')) return at;
  std::size_t exponent = at + 1;
  if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
  if (exponent == text.size() || !is_digit(text[exponent])) return at;
  while (exponent < text.size() && is_digit(text[exponent])) ++exponent;
  return exponent;
}

/// The first character from there that is no space; 0 at the end.
char next_character(const std::string& text, std::size_t at) {
  while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at])) != 0) ++at;
  return at < text.size() ? text[at] : '\0';
}

}  // namespace

formula_of_variables with_numbers_as_variables(const std::string& formula) {
  formula_of_variables result;
  constexpr std::size_t longest_number = 1000;
  char before = '\0';  // the last character that is neither a space nor the sign of an exponent
  std::string called;  // the last name
  std::vector<std::string> open;  // the functions whose parentheses are open
  bool second_argument = false;
  for (std::size_t at = 0; at < formula.size();) {
    const char c = formula[at];
    if (is_letter(c)) {
      std::size_t end = at;
      while (end < formula.size() && (is_letter(formula[end]) || is_digit(formula[end]))) ++end;
      called = formula.substr(at, end - at);
      result.text += called;
      before = c;
      at = end;
      continue;
    }
    if (is_digit(c) || c == '.') {
      const std::size_t end = end_of_number(formula, at);
      const std::string number = formula.substr(at, end - at);
      const bool order_of_root = second_argument && !open.empty() && open.back() == "root";
      const std::size_t mark = number.find_first_of("eE");
      const bool is_long =
          number.size() > longest_number || (mark != std::string::npos && number.size() - mark > 5);
      if (before == '^' || order_of_root || is_long || next_character(formula, end) == '!') {
        result.text += number;
      } else {
        result.names.push_back(fmt::format("number_{}", result.names.size() + 1));
        result.values.push_back(parse_rational(number));
        result.text += result.names.back();
      }
      before = '0';
      at = end;
      continue;
    }
    if (c == '(') open.push_back(is_letter(before) ? called : "");
    if (c == ')' && !open.empty()) open.pop_back();
    if (c == ',') second_argument = true;
    if (c == '(' || c == ')') second_argument = false;
    const bool is_power = c == '*' && before == '*';  // ** is ^
    const bool is_sign_of_exponent = (c == '+' || c == '-') && before == '^';
    if (std::isspace(static_cast<unsigned char>(c)) == 0 && !is_sign_of_exponent) {
      before = is_power ? '^' : c;
    }
    result.text += c;
    ++at;
  }
  return result;
}

second_opinion exact_value_again(const std::string& formula,
                                 const std::vector<formula_definition>& definitions,
                                 const rational& exact, long digits) {
  const precision bits = (2 * bits_for_digits(digits) + 256) | 1;
  const std::string route =
      fmt::format("real arithmetic with {} bits, without exact numbers", bits);
  const auto start = detail::clock::now();
  std::optional<ball> value;
  try {
    const formula_of_variables unfolded = with_numbers_as_variables(formula);
    if (!unfolded.names.empty()) {
      const expression f = parse(unfolded.text, unfolded.names, definitions);
      std::vector<ball> values;
      values.reserve(unfolded.values.size());
      for (const rational& q : unfolded.values) values.emplace_back(q, bits);
      value = f.evaluator<ball>(bits)(std::span<const ball>(values));
    }
  } catch (const input_error&) {
    // A number has to be known where it stands: there is no such route.
  }
  second_opinion result;
  if (value) {
    const finding<ball> known{"exact arithmetic of rational numbers", ball(exact, bits)};
    result.add(judged(known, {route, *value}, digits, detail::seconds_since(start)));
  } else {
    route_report none;
    none.route = route;
    none.obstacle = "the formula needs its numbers exactly";
    none.seconds = detail::seconds_since(start);
    result.add(none);
  }
  return result;
}

}  // namespace polhode
