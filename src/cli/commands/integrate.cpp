// polhode integrate: the integral of a formula, with a proof.

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/options/certificate_option.hpp"
#include "cli/options/count_option.hpp"
#include "cli/options/formula.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/options.hpp"
#include "cli/options/path_option.hpp"
#include "cli/options/range_option.hpp"
#include "cli/options/second_opinion.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/errors.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/layout.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/certificate.hpp"
#include "polhode/certificate/certificate_of.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/integrate_box.hpp"
#include "polhode/verify/second_integral.hpp"

namespace polhode::cli {
namespace integrate_impl {
namespace {

constexpr long greatest_boxes = 100'000;

struct integrate_command_options {
  std::string formula;
  range_option range;
  std::optional<std::string> from;  // the ends of the range, where it has ends
  std::optional<std::string> to;
  std::optional<std::string> along;
  std::optional<std::string> circle;
  count_option boxes{"--boxes", 1, 1, greatest_boxes};
  std::optional<std::string> given_variable;
  std::string variable;  // that of the formula
  let_option let;
  digits_option digits;
  count_option threads{"--threads", 1, 0, most_threads};
  std::string rule = "automatic";
  format_option format{{"text", "json"}};
  memory_limit_option memory_limit;
  certificate_option certificate;
  verify_option verify;
  time_limit_option time_limit;
};

/// A limit as range_option::ends gives it: inf, -inf, or a formula without variables.
end_point read_limit(const std::string& text, const let_option& let) {
  const int sign = infinite_sign_of(text);
  if (sign != 0) return sign > 0 ? end_point::infinity() : -end_point::infinity();
  return end_point_of(read_formula(text, {}, let));
}

std::string names_of_rules() {
  std::string names = quadrature_rule::automatic.word();
  for (const quadrature_rule& r : quadrature_rule::all()) names += ", " + r.word();
  return names;
}

/// Of `--help`: a line a rule.
std::string rules_in_words() {
  std::string text = "Insist on a rule, and refuse where it does not apply [automatic]:";
  for (const quadrature_rule& r : quadrature_rule::all()) {
    text += fmt::format("\n{}: {}", r.word(), r.strategy()->purpose());
  }
  return text;
}

quadrature_rule read_rule(const std::string& text) {
  if (const auto rule = quadrature_rule::named(text)) return *rule;
  throw usage_error(
      fmt::format("--rule {}: it must be one of {}", in_quotes(text), names_of_rules()));
}

/// Whether its first digits are as many, or all that there are.
bool is_decided(const ball& x, long digits) {
  return x.is_bounded() && to_decimal_enclosure(x, digits).has_cut(digits);
}
bool is_decided(const complex_ball& z, long digits) {
  if (!z.is_bounded()) return false;
  const bool real_is_larger = z.im.magnitude_upper() <= z.re.magnitude_upper();
  return is_decided(real_is_larger ? z.re : z.im, digits);
}

/// integral_to(how); a few more digits than were asked for where a digit's end would be undecided.
template <class Integral>
auto integrate_for(const Integral& integral_to, long digits, integrate_options how) {
  how.digits = digits + 1;
  auto result = integral_to(how);
  if (result.verdict == status::certified && !is_decided(result.enclosure, digits)) {
    how.digits = digits + 6;
    result = integral_to(how);
  }
  return result;
}

std::string account_text(const integral_account& a) {
  std::string rules;
  for (const quadrature_rule& rule : a.rules) {
    rules += (rules.empty() ? " (" : ", ") + to_text(rule);
  }
  if (!rules.empty()) rules += ')';
  if (a.panels == 0 && a.evaluations == 0 && a.terms == 0 && !rules.empty()) {
    return fmt::format("by an antiderivative, with {} bits", a.precision);
  }
  const std::string panels = fmt::format("{} panel{}{}", a.panels, a.panels == 1 ? "" : "s", rules);
  if (a.terms > 0) return fmt::format("{}, {} terms with {} bits", panels, a.terms, a.precision);
  return fmt::format("{}, {} evaluations with {} bits, {} over regions", panels, a.evaluations,
                     a.precision, a.region_evaluations);
}

std::string number_text(const ball& x, long digits) {
  return x.is_bounded() ? to_text(to_decimal_enclosure(x, digits)) + '\n' : "undefined\n";
}
std::string number_text(const complex_ball& z, long digits) { return text_of_parts(z, digits); }

/// False of a value that cannot be told from 0.
template <class Integral>
bool has_digits_of_its_own(const Integral& i, long digits) {
  return goal{digits}.is_met_by(i.enclosure);
}

template <class Integral>
std::string as_text(const Integral& i, long digits) {
  const bool certified = i.verdict == status::certified;
  const std::string number = number_text(i.enclosure, digits);
  if (certified) {
    return number +
           fmt::format("certified{}: {}\n",
                       has_digits_of_its_own(i, digits) ? "" : " (relative to the integral of |f|)",
                       account_text(i.account));
  }
  std::string result = number + fmt::format("not certified: {}", to_text(i.why));
  if (!i.obstacle.empty()) result += fmt::format(" ({})", i.obstacle);
  return result + '\n';
}

/// What was asked for, and the verdict.
template <class Integral>
json describe(const expression& f, const integrate_command_options& options, const Integral& i) {
  json result{{"integrand", f.to_text()}, {"variable", options.variable}};
  for (const auto& [name, given] :
       {std::pair("from", options.from), std::pair("to", options.to),
        std::pair("along", options.along), std::pair("circle", options.circle)}) {
    if (given) result[name] = *given;
  }
  result["verdict"] = to_text(i.verdict);
  if (i.verdict != status::certified) {
    result["reason"] = to_text(i.why);
    if (!i.obstacle.empty()) result["remark"] = i.obstacle;
  } else if (!has_digits_of_its_own(i, options.digits.value())) {
    result["relative_to"] = "the integral of |f|";
  }
  return result;
}

json as_json(const integral_account& a) {
  json rules = json::array();
  for (const quadrature_rule& rule : a.rules) rules.push_back(to_text(rule));
  return {{"evaluations", a.evaluations},
          {"region_evaluations", a.region_evaluations},
          {"panels", a.panels},
          {"rules", rules},
          {"terms", a.terms},
          {"most_nodes", a.most_nodes},
          {"precision", a.precision}};
}

template <class Integral>
json as_json(const expression& f, const integrate_command_options& options, const Integral& i,
             long digits) {
  json result = describe(f, options, i);
  result["number"] = to_json(i.enclosure, digits);
  result["account"] = as_json(i.account);
  return result;
}

void check_memory(const integrate_command_options& options, long digits) {
  constexpr double numbers = 64;
  options.memory_limit.check({fmt::format("{} digits of the integral", digits),
                              numbers * bytes_per_digit * static_cast<double>(digits) *
                                  std::max(static_cast<double>(digits), 1.0) / 16});
}

/// The ends of a set, each with as many digits, rounded outward.
std::pair<std::string, std::string> decimal_ends(const ball& x, long digits) {
  const precision p = bits_for_digits(digits) + 64;
  return {to_decimal_enclosure(ball(lower_rational(x), p), digits).lower,
          to_decimal_enclosure(ball(upper_rational(x), p), digits).upper};
}

struct nothing {
  template <class Integral>
  void operator()(const Integral&) const {}
};

/// Prints an integral that integral_to(options) computes, after before_printing(integral). With
/// --verify, verify(integral) is the second opinion of a certified one, and comes first: where it
/// contradicts, nothing is printed.
template <class Integral, class Again, class Then = nothing>
exit_status report(const expression& f, const integrate_command_options& options,
                   const Integral& integral_to, const Again& verify,
                   const std::function<std::string()>& counts = {},
                   const Then& before_printing = {}) {
  const long digits = options.digits.value();
  const bool json_wanted = options.format.value() == "json";
  check_memory(options, digits);
  integrate_options how;
  how.threads = static_cast<int>(options.threads.value());
  how.rule = read_rule(options.rule);
  const auto i = [&] {
    const progress line;
    line.show("integrating");
    line.count(counts);
    line.expect(options.time_limit.check(
        fmt::format("{} digits of the integral", digits), digits,
        {[&](long fewer) { (void)integrate_for(integral_to, fewer, how); }}));
    const time_watch watch(options.time_limit.limit());
    return integrate_for(integral_to, digits, how);
  }();
  const bool certified = i.verdict == status::certified;
  std::optional<printed_opinion> opinion;
  if (options.verify.given && certified) {
    const progress line;
    line.show("looking for a second opinion");
    const time_watch watch(options.time_limit.limit());
    opinion = verify(i);
  }
  before_printing(i);
  if (json_wanted) {
    json result = as_json(f, options, i, digits);
    if (opinion) result["second_opinion"] = opinion->as_json();
    print(json_document_text("integral", result));
  } else {
    print(as_text(i, digits) + (opinion ? opinion->as_text() : ""));
  }
  if (opinion) return opinion->status();
  return certified ? exit_status::all_certified : exit_status::not_certified;
}

/// Exactly one of the ways to say from where to where; reads the ends.
void read_range(integrate_command_options& options) {
  const int ways =
      options.range.ways() + int{options.along.has_value()} + int{options.circle.has_value()};
  if (ways != 1) {
    throw usage_error(fmt::format(
        "{}: give the limits, EXPR A B, or --from A --to B, or --in A..B; or a path in the complex "
        "plane, --along \"0, 1, 1+i\" or --circle \"CENTRE, RADIUS\"",
        ways == 0 ? "there is no range" : "there is more than one range"));
  }
  if (options.range.ways() == 0) return;
  const auto [from, to] = options.range.ends(options.let.numbers());
  options.from = from;
  options.to = to;
}

/// "[LOWER, UPPER]" with rational ends.
parameter_range read_interval(const std::string& name, const std::string& text,
                              const let_option& let) {
  const auto bad = [&](const char* why) {
    return usage_error(fmt::format("--let {}: {}", in_quotes(name + '=' + text), why));
  };
  const std::size_t start = text.find('[');
  const std::size_t end = text.find_last_not_of(' ');
  constexpr const char* form = "an interval must be [LOWER, UPPER], such as a=[1, 1.1]";
  if (text[end] != ']') throw bad(form);
  const auto parts = parts_between_commas(text.substr(start + 1, end - start - 1));
  if (parts.size() != 2) throw bad(form);
  const expression lower = read_formula(parts[0], {}, let);
  const expression upper = read_formula(parts[1], {}, let);
  if (!lower.exact_value() || !upper.exact_value()) {
    throw bad("an interval's ends must be rational numbers");
  }
  if (*lower.exact_value() > *upper.exact_value()) {
    throw bad("the lower end is above the upper end");
  }
  return {*lower.exact_value(), *upper.exact_value()};
}

std::string as_text(const box_integral& i, long digits) {
  if (i.verdict != status::certified) {
    return fmt::format("undefined\nnot certified: {} ({})\n", to_text(i.why), i.obstacle);
  }
  const auto [lower, upper] = decimal_ends(i.enclosure, digits);
  return fmt::format(
      "from {}\n  to {}\ncertified for every parameter in the box: {}\n", lower, upper,
      i.attained ? "both ends are attained" : "the ends may be outside of what is attained");
}

json as_json(const expression& f, const integrate_command_options& options, const box_integral& i,
             long digits) {
  json result = describe(f, options, i);
  for (const auto& [name, interval] : options.let.intervals().value()) {
    result["parameters"][name] = interval;
  }
  if (i.enclosure.is_bounded()) {
    result["range"] = to_json(i.enclosure, digits);
    result["range"]["attained"] = i.attained;
  }
  result["account"] = {{"boxes", i.boxes}, {"integrals", i.integrals}};
  return result;
}

/// With parameters in intervals.
exit_status integrate_over_box(const integrate_command_options& options) {
  const long digits = options.digits.value();
  const bool json_wanted = options.format.value() == "json";
  check_memory(options, digits);
  const let_option numbers = options.let.numbers();
  std::vector<std::string> variables{options.variable};
  std::vector<parameter_range> box;
  for (const auto& [name, text] : options.let.intervals().value()) {
    variables.push_back(name);
    box.push_back(read_interval(name, text, numbers));
  }
  const expression f = read_formula(options.formula, variables, numbers);
  const end_point a = read_limit(*options.from, numbers);
  const end_point b = read_limit(*options.to, numbers);
  const box_integral i = [&] {
    const progress line;
    line.show("integrating over boxes of parameters");
    const time_watch watch(options.time_limit.limit());
    return integrate_box(f, a, b, box, {.digits = digits + 1, .most_boxes = options.boxes.value()});
  }();
  print(json_wanted ? json_document_text("integral", as_json(f, options, i, digits))
                    : as_text(i, digits));
  return i.verdict == status::certified ? exit_status::all_certified : exit_status::not_certified;
}

/// What a certificate is of. Throws usage_error for an infinite range.
formula_over_range checkable_range(const expression& f, const integrate_command_options& options) {
  const auto end_of = [&](const std::string& text) {
    if (read_limit(text, options.let).infinite_sign() != 0) {
      throw usage_error("--certificate: the range must be finite");
    }
    return read_formula(text, {}, options.let);
  };
  formula_over_range what{f, end_of(*options.from), end_of(*options.to)};
  expect_checkable(what);
  return what;
}

/// The checker's opinion, where there is a certificate of the integral; of few digits, as its time
/// grows with their square and more.
void add_checkers_opinion(printed_opinion& result, const expression& f,
                          const integrate_command_options& options, const integral& i) {
  constexpr long most_digits_for_checker = 200;
  const long digits = options.digits.value();
  if (digits > most_digits_for_checker) return;
  std::optional<json> certificate;
  try {
    certificate = certificate_of(checkable_range(f, options), i, digits);
  } catch (const std::invalid_argument&) {
    return;  // no certificate can hold it
  }
  result.add(checked_again("the integral", route_text(i.account), *certificate));
}

/// How often an integrand was called, by any thread, and where its sum is.
struct counted_calls {
  std::atomic<long> over_regions = 0;
  std::atomic<long> at_nodes = 0;
  // Of the sum that is being made:
  std::atomic<long> panel = 0;  // from 1; 0 before there is one
  std::atomic<long> panels = 0;
  std::atomic<long> nodes = 0;
};

prepared_integrand counted(const prepared_integrand& f,
                           const std::shared_ptr<counted_calls>& calls) {
  return f.watched([calls] { calls->over_regions.fetch_add(1, std::memory_order_relaxed); },
                   [calls] { calls->at_nodes.fetch_add(1, std::memory_order_relaxed); });
}

/// "1200 evaluations, 340 over regions, panel 3 of 40 with 64 nodes".
std::string counts_text(const counted_calls& calls) {
  const long nodes = calls.at_nodes.load();
  const long regions = calls.over_regions.load();
  if (nodes + regions == 0) return "";
  std::string result = fmt::format("{} evaluations, {} over regions", nodes, regions);
  const long panel = calls.panel.load();
  if (panel == 0) return result;
  return fmt::format("{}, panel {} of {} with {} nodes", result, panel, calls.panels.load(),
                     calls.nodes.load());
}

/// The integral where it is a rational number, unless a rule, a certificate or a second opinion is
/// asked for.
std::optional<rational> known_integral(const expression& f, const end_point& a, const end_point& b,
                                       const integrate_command_options& options) {
  if (options.certificate.is_given() || options.verify.given ||
      !read_rule(options.rule).is_automatic()) {
    return std::nullopt;
  }
  return exact_integral(f, a, b);
}

exit_status report_exact(const expression& f, const integrate_command_options& options,
                         const rational& value) {
  const long digits = options.digits.value();
  check_memory(options, digits);
  if (options.format.value() != "json") {
    print(exact_answer(value, digits) +
          "certified: by an antiderivative or a symmetry, in rational numbers\n");
    return exit_status::all_certified;
  }
  integral known;
  known.verdict = status::certified;
  json result = describe(f, options, known);
  result["number"] = exact_json(value, digits);
  result["account"] = as_json(known.account);
  print(json_document_text("integral", result));
  return exit_status::all_certified;
}

exit_status integrate_real(integrate_command_options& options) {
  const expression f = read_formula(options.formula, {options.variable}, options.let);
  const end_point a = read_limit(*options.from, options.let);
  const end_point b = read_limit(*options.to, options.let);
  if (const auto value = known_integral(f, a, b, options)) return report_exact(f, options, *value);
  const auto calls = std::make_shared<counted_calls>();
  const auto integrate_to = [g = counted(prepared_integrand(f), calls), a, b,
                             calls](integrate_options goal) {
    goal.progress = [calls](const integration_progress& p) {
      calls->panel = p.panels_done + 1;
      calls->panels = p.panels;
      calls->nodes = p.nodes;
    };
    return integrate(g, a, b, goal);
  };
  const auto verify = [&](const integral& i) {
    const long digits = options.digits.value();
    const int threads = static_cast<int>(options.threads.value());
    printed_opinion result(integral_again(f, a, b, i, digits, threads), digits);
    add_checkers_opinion(result, f, options, i);
    return result;
  };
  const auto counts = [calls] { return counts_text(*calls); };
  if (!options.certificate.is_given()) return report(f, options, integrate_to, verify, counts);
  const formula_over_range what = checkable_range(f, options);
  options.certificate.prepare();
  const auto integrate_closer = [&](integrate_options goal) {
    goal.digits += 4;  // the certificate's number is wider than the enclosure
    return integrate_to(goal);
  };
  bool certified = false;
  const exit_status result =
      report(f, options, integrate_closer, verify, counts, [&](const integral& i) {
        certified = i.verdict == status::certified;
        if (!certified) return;
        options.certificate.write(certificate_of(what, i, options.digits.value()));
      });
  options.certificate.expect_certified(certified);
  return result;
}

exit_status integrate_along_path(const integrate_command_options& options) {
  const auto names = options.let.value();
  const bool taken = options.variable == imaginary_unit ||
                     std::any_of(names.begin(), names.end(), [](const auto& definition) {
                       return definition.first == imaginary_unit;
                     });
  if (taken) {
    throw usage_error("with --along and --circle, i is the imaginary unit; give another name");
  }
  const expression f =
      read_formula(options.formula, {options.variable, imaginary_unit}, options.let);
  const path along = options.along ? read_polygon(*options.along, options.let)
                                   : read_circle(*options.circle, options.let);
  return report(
      f, options, [&](const integrate_options& goal) { return integrate_along(f, along, goal); },
      [&](const contour_integral& i) {
        const long digits = options.digits.value();
        const int threads = static_cast<int>(options.threads.value());
        return printed_opinion(integral_again(f, along, i, digits, threads), digits);
      });
}

exit_status run(integrate_command_options& options) {
  options.variable = variable_or_only_name(options.given_variable, options.formula, options.let);
  read_range(options);
  (void)options.boxes.value();
  (void)options.threads.value();
  (void)options.time_limit.limit();
  const bool has_intervals = !options.let.intervals().texts.empty();
  const bool insists = !read_rule(options.rule).is_automatic();
  if (insists && (!options.from || has_intervals)) {
    throw usage_error("--rule is for limits (--from and --to), and numbers for the parameters");
  }
  if (options.certificate.is_given() && (!options.from || has_intervals)) {
    throw usage_error(
        "--certificate is for limits (--from and --to), and numbers for the parameters");
  }
  if (options.verify.given && has_intervals) {
    throw usage_error("--verify is for numbers as parameters, not for intervals");
  }
  if (has_intervals && options.from) return integrate_over_box(options);
  if (has_intervals) {
    throw usage_error("an interval for a parameter needs limits (--from and --to)");
  }
  return options.from ? integrate_real(options) : integrate_along_path(options);
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<integrate_command_options>();
  add_option(app, "EXPR", options->formula, "The integrand, a formula in x")
      .type_name("")
      .required();
  options->range.declare(app);
  add_option(app, "--along", options->along,
             "In place of limits, a path of straight lines in the complex plane:\n"
             "points, which are formulas with the imaginary unit i, as the\n"
             "integrand then is")
      .type_name("\"P, Q, ...\"");
  add_option(app, "--circle", options->circle,
             "In place of limits, a circle, once around and counterclockwise")
      .type_name("\"CENTRE, RADIUS\"");
  add_option(app, "--variable", options->given_variable,
             "The variable's name, if it is neither x nor the formula's only name")
      .type_name("NAME");
  add_option(app, "--rule", options->rule, rules_in_words()).type_name("NAME");
  options->threads.declare(
      app, "Evaluate on so many threads; 0 for all processors. The digits\nare the same");
  options->boxes.declare(
      app, "Into how many parts the intervals of --let NAME=[LOWER, UPPER] may\nbe cut");
  options->let.declare(app);
  options->digits.declare(app);
  options->format.declare(app);
  options->memory_limit.declare(app);
  options->certificate.declare(app);
  options->verify.declare(app);
  options->time_limit.declare(app);
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace integrate_impl

command integrate_command() {
  return {
      "integrate", "Integrate a formula, with a proof",
      "  polhode integrate \"exp(-x^2)\" -inf inf --digits 100\n"
      "  polhode integrate \"log(x)/sqrt(x)\" 0 1\n"
      "  polhode integrate \"2 sin(x)^2\" --in 0..pi\n"
      "  polhode integrate \"1/(x^2 + k^2)\" --from 0 --to pi/2 --let k=1e-10\n"
      "  polhode integrate \"1/sqrt(1-m*sin(x)^2)\" --from 0 --to pi/2 --let \"m=[0.1, 0.2]\"\n"
      "  polhode integrate \"exp(z)/z^3\" --circle \"0, 1\"\n"
      "  polhode integrate \"sqrt(x)\" --along \"1, 1+i, -1+i\"\n"
      "  polhode integrate \"4/(1+x^2)\" --from 0 --to 1 --certificate pi.json && polhode check "
      "pi.json\n"
      "  polhode integrate \"sin(x)^3*exp(x)\" --from 0 --to 7 --verify\n\n"
      "The integrand may be singular at the limits (powers, logarithms, and what is 0/0 there), "
      "and\n"
      "the limits infinite where it decays. That it is analytic between them is proved, never\n"
      "assumed; where it is not, the answer says so and where. `polhode eval --functions` lists "
      "the\n"
      "functions. Along a path it must be analytic between the corners; a branch cut in the way "
      "is\n"
      "refused. Where the integral is found to be a rational number, by an antiderivative, that is "
      "the\n"
      "answer, unless --rule, --certificate or --verify asks for more.\n"
      "Digits before dots are cut off, never rounded; where they are not decided, the answer is\n"
      "value ± radius, as in 2 ± 1e-52. Exit status 1 where nothing is certified.\n",
      integrate_impl::declare};
}

}  // namespace polhode::cli
