// polhode eval: the value of a formula, to any number of certain digits.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/options/formula.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/options.hpp"
#include "cli/options/path_option.hpp"
#include "cli/options/second_opinion.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/errors.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/layout.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/goal.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/arithmetic/verdict.hpp"
#include "polhode/certificate/certificate.hpp"
#include "polhode/verify/second_value.hpp"

namespace polhode::cli {
namespace eval_impl {
namespace {

struct eval_options {
  std::optional<std::string> formula;
  bool list_functions = false;
  let_option let;
  digits_option digits;
  format_option format{{"text", "json"}};
  memory_limit_option memory_limit;
  verify_option verify;
  time_limit_option time_limit;
};

// ---------------------------------------------------------------------------------------------
// Values that are rational numbers

/// The decimal 10^n where the formula is a power of ten too long to be worked out: its digits are
/// all 9 below and all 0 above, so that no enclosure but the number itself would show them.
std::optional<std::string> power_of_ten(const expression& f) {
  const auto power = f.exact_power();
  if (!power) return std::nullopt;
  const auto& [base, n] = *power;
  const bool above = denominator(base) == 1;
  const integer size = above ? numerator(base) : denominator(base);
  if (!above && numerator(base) != 1) return std::nullopt;
  const std::string digits = size.str();
  if (size < 10 || digits.find_first_not_of('0', 1) != std::string::npos || digits.front() != '1') {
    return std::nullopt;
  }
  const auto zeros = static_cast<long>(digits.size()) - 1;
  return "1e" + integer(integer(above ? zeros : -zeros) * n).str();
}

json power_json(const std::string& decimal) {
  return json{
      {"value", decimal}, {"digits", 1}, {"lower", decimal}, {"upper", decimal}, {"exact", true}};
}

// ---------------------------------------------------------------------------------------------
// Other values

struct answer {
  ball enclosure;
  precision bits = 0;  // with which it was computed
  reason why = reason::none;
  /// It cannot be told from 0, and has its digits beside the size of the formula's terms.
  bool is_beside_terms = false;
};

/// The precision at which it is given up: cancellation of tens of thousands of digits is seen
/// through, less where functions are in it whose cost grows with the square of the precision or
/// faster.
precision greatest_working_precision(const expression& f, precision needed) {
  switch (f.cost()) {
    case expression_cost::algebraic:
      return 8 * needed + (precision{1} << 20);
    case expression_cost::elementary:
      return 8 * needed + (precision{1} << 18);
    case expression_cost::further:
      return 4 * needed + (precision{1} << 16);
    case expression_cost::special:
      break;
  }
  return 4 * needed + (precision{1} << 12);
}

answer enclose(const expression& f, long digits, const progress& line) {
  const precision needed = bits_for_digits(digits);
  const precision most = greatest_working_precision(f, needed);
  answer result;
  precision guard = 32;
  do {
    result.bits = std::min(needed + guard, most);
    line.show(fmt::format("computing with {} bits", result.bits));
    result.enclosure = f.value(result.bits);
    if (shows_digits(result.enclosure, digits)) return result;
    guard *= 4;
  } while (result.bits < most);
  if (contains_zero(result.enclosure) && result.enclosure.is_bounded()) {
    const ball size = f.sum_of_sizes().value(needed + 64);
    result.is_beside_terms =
        goal{digits}.is_met(result.enclosure.magnitude_upper(), size.magnitude_lower());
    if (result.is_beside_terms) return result;
  }
  result.why = result.enclosure.is_undefined() ? reason::not_defined : reason::precision_limit;
  return result;
}

/// A number of few digits in a narrow enclosure: no precision decides whether it is the value.
std::optional<std::string> possible_exact_value(const ball& x, precision needed) {
  const auto power = [](long n) { return magnitude::power_of_two(n); };
  if (contains_zero(x)) {
    return x.magnitude_upper() <= power(-needed) ? std::optional<std::string>("0") : std::nullopt;
  }
  constexpr long narrow = 128;
  constexpr long moderate = 1000;
  if (!(multiply_up(x.radius(), power(narrow)) <= x.magnitude_lower()) ||
      !(x.magnitude_upper() <= power(moderate)) || !(power(-moderate) <= x.magnitude_lower())) {
    return std::nullopt;
  }
  constexpr long few = 12;
  const rational q = parse_rational(midpoint(x).str(few, std::ios_base::scientific));
  if (!contains(x, q)) return std::nullopt;
  return leading_digits_of(q, few).value;
}

std::string remark_on(const expression& f, const answer& a, long digits) {
  const ball& x = a.enclosure;
  if (a.why == reason::not_defined) {
    if (const auto function = f.undefined_function(bits_for_digits(digits))) {
      return fmt::format(
          "{}({}) is not defined, or is not proved to be, where it is taken; it needs {}",
          function->name, function->arguments, function->domain);
    }
    return "a function in it is not defined, or is not proved to be, where it is taken";
  }
  if (!x.is_bounded()) return "it is beyond the greatest exponent, or a part of it is";
  constexpr long least_exponent = -1'000'000'000;  // MPFR's is -2^30 + 1
  if (x.magnitude_upper() <= magnitude::power_of_two(least_exponent)) {
    return "it is below the least exponent, or a part of it is, or it is 0";
  }
  if (const auto exact = possible_exact_value(x, bits_for_digits(digits))) {
    return fmt::format("computed with {} bits, it may be exactly {}", a.bits, *exact);
  }
  return fmt::format("computed with {} bits", a.bits);
}

std::string as_text(const expression& f, const answer& a, long digits) {
  // Also of what is about 0: a value with its error.
  std::string result =
      (a.enclosure.is_bounded() ? to_text(to_decimal_enclosure(a.enclosure, digits))
                                : to_decimal(a.enclosure, digits)) +
      '\n';
  if (a.is_beside_terms) {
    return result + fmt::format("certified (relative to the size of its terms): {}\n",
                                remark_on(f, a, digits));
  }
  if (a.why == reason::none) return result;
  return result + fmt::format("not certified: {} ({})\n", to_text(a.why), remark_on(f, a, digits));
}

// ---------------------------------------------------------------------------------------------
// Complex values

/// The formula with the imaginary unit i for a variable, where it can be read so.
std::optional<expression> formula_with_unit(const eval_options& options) {
  try {
    return read_formula(*options.formula, {imaginary_unit}, options.let);
  } catch (const usage_error&) {
    return std::nullopt;
  }
}

struct complex_answer {
  complex_ball enclosure;
  precision bits = 0;
  reason why = reason::none;
  /// A part that cannot be told from 0 has its digits beside the absolute value.
  bool is_beside_size = false;
};

complex_answer enclose_complex(const expression& f, long digits, const progress& line) {
  const precision needed = bits_for_digits(digits);
  const precision most = greatest_working_precision(f, needed);
  const auto has_digits = [&](const ball& part) {
    return part.radius().is_zero() || shows_digits(part, digits);
  };
  complex_answer result;
  for (precision guard = 32; result.bits < most; guard *= 4) {
    result.bits = std::min(needed + guard, most);
    line.show(fmt::format("computing with {} bits", result.bits));
    result.enclosure = f.evaluator<complex_ball>(result.bits)(complex_ball::i(result.bits));
    const complex_ball& z = result.enclosure;
    if (z.is_bounded() && has_digits(z.re) && has_digits(z.im)) return result;
    // A part that is 0 has no digits of its own, however many bits are spent.
    constexpr precision ample = 512;
    result.is_beside_size = guard >= ample && goal{digits}.is_met_by(z);
    if (result.is_beside_size) return result;
  }
  result.why = result.enclosure.is_bounded() ? reason::precision_limit : reason::not_defined;
  return result;
}

exit_status print_complex(const expression& f, const eval_options& options) {
  const long digits = options.digits.value();
  if (const auto name = f.function_not_analytic()) {
    throw usage_error(fmt::format("{}: {} is known of real numbers alone, and i is in its argument",
                                  in_quotes(*options.formula), *name));
  }
  if (options.verify.given) {
    throw usage_error("--verify: there is no second route to the value of a formula with i");
  }
  const complex_answer a = [&] {
    const progress line;
    const time_watch watch(options.time_limit.limit());
    return enclose_complex(f, digits, line);
  }();
  const bool is_certified = a.why == reason::none;
  const std::string remark =
      a.why == reason::not_defined
          ? "a function in it is not defined, or not proved to be analytic, where it is taken"
          : fmt::format("computed with {} bits", a.bits);
  if (options.format.value() == "json") {
    json described{{"expression", f.to_text()},
                   {"verdict", to_text(is_certified ? status::certified : status::not_certified)}};
    if (!is_certified) described["reason"] = to_text(a.why);
    if (!is_certified || a.is_beside_size) described["remark"] = remark;
    if (a.is_beside_size) described["relative_to"] = "the absolute value";
    described["number"] = to_json(a.enclosure, digits);
    print(json_document_text("value", described));
  } else {
    print(text_of_parts(a.enclosure, digits) +
          (!is_certified ? fmt::format("not certified: {} ({})\n", to_text(a.why), remark)
           : a.is_beside_size
               ? fmt::format("certified (relative to the absolute value): {}\n", remark)
               : ""));
  }
  return is_certified ? exit_status::all_certified : exit_status::not_certified;
}

// ---------------------------------------------------------------------------------------------
// The command

json as_json(const expression& f, json number, const answer& a, long digits) {
  json result{
      {"expression", f.to_text()},
      {"verdict", to_text(a.why == reason::none ? status::certified : status::not_certified)}};
  if (a.why != reason::none) result["reason"] = to_text(a.why);
  if (a.why != reason::none || a.is_beside_terms) result["remark"] = remark_on(f, a, digits);
  if (a.is_beside_terms) result["relative_to"] = "the size of its terms";
  result["number"] = std::move(number);
  return result;
}

/// How many numbers MPFR's functions hold meanwhile, from above. Measured to 300,000 digits: 15 for
/// quotients and roots, 95 for log and powers, 230 for Catalan's constant.
double numbers_of_mpfr(expression_cost cost) {
  switch (cost) {
    case expression_cost::algebraic:
      return 20;
    case expression_cost::elementary:
      return 100;
    case expression_cost::further:
    case expression_cost::special:
      break;
  }
  return 250;
}

memory_estimate estimate(const expression& f, long digits) {
  constexpr double kept_decimals = 6;
  const double numbers = static_cast<double>(f.live_numbers()) + numbers_of_mpfr(f.cost());
  return {fmt::format("{} digits of this formula", digits),
          (bytes_per_digit * numbers + kept_decimals) * static_cast<double>(digits)};
}

exit_status run(const eval_options& options) {
  const long digits = options.digits.value();
  const bool json_wanted = options.format.value() == "json";
  if (options.list_functions) {
    print(table_of_functions());
    return exit_status::all_certified;
  }
  if (!options.formula) {
    throw usage_error("there is no formula; give one, such as `polhode eval \"sqrt(2)/3\"`");
  }
  std::optional<expression> with_unit;
  const expression f = [&] {
    try {
      return read_formula(*options.formula, {}, options.let);
    } catch (const usage_error&) {
      with_unit = formula_with_unit(options);
      if (!with_unit) throw;
      return *with_unit;
    }
  }();
  if (with_unit) {
    options.memory_limit.check(estimate(f, digits));
    return print_complex(f, options);
  }
  const memory_estimate memory = estimate(f, digits);
  options.memory_limit.check(memory);
  (void)options.time_limit.limit();
  const auto print_with = [&](const std::string& text, json described,
                              const std::optional<printed_opinion>& opinion) {
    if (opinion) described["second_opinion"] = opinion->as_json();
    print(json_wanted ? json_document_text("value", described)
                      : text + (opinion ? opinion->as_text() : ""));
    return opinion ? opinion->status() : exit_status::all_certified;
  };
  if (const auto& q = f.exact_value()) {
    std::optional<printed_opinion> opinion;
    if (options.verify.given) {
      opinion.emplace(exact_value_again(*options.formula, options.let.value(), *q, digits), digits);
    }
    return print_with(exact_answer(*q, digits), as_json(f, exact_json(*q, digits), {}, digits),
                      opinion);
  }
  if (const auto decimal = power_of_ten(f)) {
    return print_with(*decimal + " exactly\n", as_json(f, power_json(*decimal), {}, digits),
                      options.verify.given ? std::optional(printed_opinion()) : std::nullopt);
  }
  if (const auto q = f.rational_value()) {
    std::optional<printed_opinion> opinion;
    if (options.verify.given) opinion.emplace(rational_value_again(f, *q, digits), digits);
    return print_with(exact_answer(*q, digits), as_json(f, exact_json(*q, digits), {}, digits),
                      opinion);
  }
  const answer a = [&] {
    const progress line;
    line.show("estimating");
    line.expect(options.time_limit.check(memory.what, digits,
                                         {[&](long fewer) { (void)enclose(f, fewer, line); }}));
    line.show("evaluating");
    const time_watch watch(options.time_limit.limit());
    return enclose(f, digits, line);
  }();
  const bool certified = a.why == reason::none;
  std::optional<printed_opinion> opinion;
  if (options.verify.given && certified) {
    const progress line;
    line.show("looking for a second opinion");
    const time_watch watch(options.time_limit.limit());
    opinion.emplace(value_again(f, a.enclosure, a.bits, digits), digits);
  }
  const exit_status status = print_with(
      as_text(f, a, digits), as_json(f, to_json(a.enclosure, digits), a, digits), opinion);
  return certified ? status : exit_status::not_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<eval_options>();
  add_option(app, "EXPR", options->formula, "A formula without variables").type_name("");
  options->let.declare(app);
  options->digits.declare(app);
  options->format.declare(app);
  add_flag(app, "--functions", options->list_functions,
           "Print the functions and constants, and exit");
  options->memory_limit.declare(app);
  options->verify.declare(app);
  options->time_limit.declare(app);
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace eval_impl

command eval_command() {
  return {
      "eval", "Evaluate a formula to any number of certain digits",
      "  polhode eval \"exp(pi*sqrt(163)) - 262537412640768744\"\n"
      "  polhode eval \"2*agm(1, k)^-1\" --let \"k=sqrt(2)/2\" --digits 1000\n"
      "  polhode eval \"-2^2\"\n"
      "  polhode eval \"zeta(3)/log(2)\" --verify\n"
      "  polhode eval \"gamma(1/4+i)*exp(i*pi/8)\"\n\n"
      "Operators, from weak to strong: + -, * /, the sign -, ^ (or **) from the right, ! of whole\n"
      "numbers. x^n is defined for every x where n is a whole number, with 0^0 = 1; x^y else for\n"
      "x > 0, and 0^y = 0 for y > 0. A formula with the imaginary unit i has a complex value, of\n"
      "principal branches. Functions:\n\n" +
          names_of_functions() +
          "\nThe precision is raised until the digits are certain: they are the first N of the "
          "true\n"
          "value, cut off, never rounded, or value ± radius where they are not decided (2 ± "
          "1e-52).\n"
          "A sum that no precision tells from 0 is given with N digits beside its terms, and said "
          "to "
          "be.\n"
          "A value that exact rules show to be rational (sin(pi),\n"
          "sqrt(2)^2, log(8)/log(2)) is given exactly. Where neither they nor precision decide, "
          "the\n"
          "enclosure reached is printed as not certified, with exit status 1, as is a formula not "
          "proved\n"
          "to be defined (log(-pi)); one that is certainly not (log(-1), 1/0) is bad input, status "
          "2.\n",
      eval_impl::declare};
}

}  // namespace polhode::cli
