// polhode integrate: the integral of a formula, with a proof.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "commands.hpp"
#include "errors.hpp"
#include "formula.hpp"
#include "formula_integrand.hpp"
#include "layout.hpp"
#include "memory_limit.hpp"
#include "options.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/certificate.hpp"
#include "progress.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

struct integrate_command_options {
  std::string formula;
  std::string from;
  std::string to;
  std::string variable = "x";
  let_option let;
  digits_option digits;
  int threads = 1;
  std::string rule = "automatic";
  format_option format{{"text", "json"}};
  memory_limit_option memory_limit;
};

/// A limit as it is given: inf, -inf, or a formula without variables.
limit read_limit(const std::string& text, const let_option& let) {
  if (text == "inf" || text == "+inf") return limit::infinity();
  if (text == "-inf") return -limit::infinity();
  return limit_of(read_formula(text, {}, let));
}

struct named_rule {
  std::string_view name;
  quadrature_rule rule;
};
constexpr std::array known_rules{
    named_rule{"automatic", quadrature_rule::automatic},
    named_rule{"gauss-legendre", quadrature_rule::gauss_legendre},
    named_rule{"clenshaw-curtis", quadrature_rule::clenshaw_curtis},
    named_rule{"trapezoid", quadrature_rule::trapezoid},
    named_rule{"double-exponential", quadrature_rule::double_exponential}};

std::string names_of_rules() {
  std::string names;
  for (const named_rule& r : known_rules)
    names += (names.empty() ? "" : ", ") + std::string(r.name);
  return names;
}

quadrature_rule read_rule(const std::string& text) {
  for (const named_rule& r : known_rules) {
    if (r.name == text) return r.rule;
  }
  throw usage_error(
      fmt::format("--rule {}: it must be one of {}", in_quotes(text), names_of_rules()));
}

/// The integral; a few more digits than were asked for where a digit's end would be undecided.
integral integrate_for(const detail::integrand& f, const limit& a, const limit& b, long digits,
                       integrate_options options) {
  const progress line;
  line.show("integrating");
  integral result;
  for (const long more : {1L, 6L}) {
    options.digits = digits + more;
    result = detail::integrate_function(f, a, b, options);
    if (result.verdict != status::certified) break;
    const decimal_enclosure d = to_decimal_enclosure(result.enclosure, digits);
    if (d.exact || d.digits >= digits) break;
  }
  return result;
}

std::string account_text(const integral& i) {
  const integral_account& a = i.account;
  std::string rules;
  for (const quadrature_rule rule : a.rules) {
    rules += (rules.empty() ? " (" : ", ") + to_text(rule);
  }
  if (!rules.empty()) rules += ')';
  return fmt::format("{} panel{}{}, {} evaluations with {} bits, {} over regions", a.panels,
                     a.panels == 1 ? "" : "s", rules, a.evaluations, a.precision,
                     a.region_evaluations);
}

std::string as_text(const integral& i, long digits) {
  std::string result;
  const bool certified = i.verdict == status::certified;
  if (i.enclosure.is_bounded()) {
    const decimal_enclosure d = to_decimal_enclosure(i.enclosure, digits);
    if (certified && !d.exact && d.digits < digits) {
      // Both ends, with the digits that matter.
      result += fmt::format("from {}\n  to {}\n", d.lower, d.upper);
    } else {
      result += to_decimal(i.enclosure, digits) + '\n';
    }
  } else {
    result += "undefined\n";
  }
  if (certified) return result + fmt::format("certified: {}\n", account_text(i));
  result += fmt::format("not certified: {}", to_text(i.why));
  if (!i.obstacle.empty()) result += fmt::format(" ({})", i.obstacle);
  return result + '\n';
}

std::string as_json(const expression& f, const integrate_command_options& options,
                    const integral& i, long digits) {
  json result{{"integrand", f.to_text()},
              {"variable", options.variable},
              {"from", options.from},
              {"to", options.to},
              {"verdict", to_text(i.verdict)}};
  if (i.verdict != status::certified) {
    result["reason"] = to_text(i.why);
    if (!i.obstacle.empty()) result["remark"] = i.obstacle;
  }
  result["number"] = to_json(i.enclosure, digits);
  json rules = json::array();
  for (const quadrature_rule rule : i.account.rules) rules.push_back(to_text(rule));
  result["account"] = {
      {"evaluations", i.account.evaluations}, {"region_evaluations", i.account.region_evaluations},
      {"panels", i.account.panels},           {"rules", rules},
      {"most_nodes", i.account.most_nodes},   {"precision", i.account.precision}};
  return result.dump(2) + '\n';
}

exit_status run(const integrate_command_options& options) {
  const long digits = options.digits.value();
  const bool json_wanted = options.format.value() == "json";
  const expression f = read_formula(options.formula, {options.variable}, options.let);
  const limit a = read_limit(options.from, options.let);
  const limit b = read_limit(options.to, options.let);
  constexpr double bytes_per_digit = 0.4153 * 64;
  options.memory_limit.check({fmt::format("an integral to {} digits", digits),
                              bytes_per_digit * static_cast<double>(digits) *
                                  std::max(static_cast<double>(digits), 1.0) / 16});
  integrate_options how;
  how.threads = options.threads;
  how.rule = read_rule(options.rule);
  const integral i = integrate_for(integrand_of(f), a, b, digits, how);
  print(json_wanted ? as_json(f, options, i, digits) : as_text(i, digits));
  return i.verdict == status::certified ? exit_status::all_certified : exit_status::not_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<integrate_command_options>();
  app.add_option("EXPR", options->formula, "The integrand, a formula in x")
      ->type_name("")
      ->required();
  app.add_option("--from", options->from, "The lower limit: a formula without variables, or -inf")
      ->type_name("A")
      ->required();
  app.add_option("--to", options->to, "The upper limit: a formula without variables, or inf")
      ->type_name("B")
      ->required();
  app.add_option("--variable", options->variable, "The variable's name, if it is not x")
      ->type_name("NAME");
  app.add_option("--rule", options->rule,
                 "Insist on a rule: gauss-legendre, clenshaw-curtis, trapezoid,\n"
                 "double-exponential [automatic]")
      ->type_name("NAME");
  app.add_option("--threads", options->threads,
                 "Evaluate on so many threads; 0 for all processors. The digits are the same")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  options->let.declare(app);
  options->digits.declare(app);
  options->format.declare(app);
  options->memory_limit.declare(app);
  return [options] { return run(*options); };
}

}  // namespace

command integrate_command() {
  return {
      "integrate", "Integrate a formula, with a proof",
      "  polhode integrate \"exp(-x^2)\" --from -inf --to inf --digits 100\n"
      "  polhode integrate \"log(x)/sqrt(x)\" --from 0 --to 1\n"
      "  polhode integrate \"1/(x^2 + k^2)\" --from 0 --to pi/2 --let k=1e-10\n\n"
      "The integrand may be singular at the limits (powers, logarithms, and what is 0/0 there), "
      "and\n"
      "the limits infinite where it decays. That it is analytic between them is proved, never\n"
      "assumed; where it is not, the answer says so and where. `polhode eval --functions` lists "
      "the\n"
      "functions. Digits are cut off, never rounded. Exit status 1 where nothing is certified.\n",
      declare};
}

}  // namespace polhode::cli
