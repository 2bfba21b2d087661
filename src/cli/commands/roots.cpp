// polhode roots: all roots of a formula in an interval, each proved.

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/output/duration.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/certificate.hpp"
#include "polhode/certificate/certificate_of.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/roots/isolate.hpp"
#include "polhode/verify/second_roots.hpp"
#include "roots_options.hpp"

namespace polhode::cli {
namespace roots_impl {
namespace {

/// An end of the range, and its formula where it is finite.
struct given_end {
  end_point end;
  std::optional<expression> formula;
};

/// An end as range_option::ends gives it: inf, -inf, or a formula without variables.
given_end read_end(const std::string& text, const let_option& let) {
  const int sign = infinite_sign_of(text);
  if (sign > 0) return {end_point::infinity(), std::nullopt};
  if (sign < 0) return {-end_point::infinity(), std::nullopt};
  const expression f = read_formula(text, {}, let);
  return {end_point_of(f), f};
}

using given_range = std::pair<given_end, given_end>;

/// Throws usage_error where there is not exactly one, or it cannot be read.
given_range read_range(roots_options& options) {
  const range_option& range = options.range;
  if (range.ways() != 1) {
    throw usage_error(fmt::format(
        "{}: give the ends, EXPR A B, or EXPR A..B, or --in A..B, or --from A --to B",
        range.ways() == 0 ? "there is no interval to look in" : "there is more than one interval"));
  }
  const auto [lower, upper] = range.ends(options.let);
  options.interval = lower + ".." + upper;
  return {read_end(lower, options.let), read_end(upper, options.let)};
}

/// A region, with its root to the digits asked for where it is proved.
struct listed_root {
  root_region region;
  ball enclosure;
  std::optional<rational> exact;
  bool has_digits = false;  // as many as were asked for, or all there are
  /// It cannot be told from 0, and is known to the digits of the interval's size: it has no digits
  /// of its own.
  bool is_small = false;

  /// Of a number with so many digits, or of two ends that show as many.
  [[nodiscard]] bool is_certified() const {
    const bool is_settled = region.verdict == root_verdict::infinitely_many ||
                            (is_one_root(region.verdict) && has_digits);
    return is_settled && !region.may_lie_outside;
  }
};

/// The size that stands for a root's own where the root may be 0: the greatest number of the
/// interval, at most 1.
magnitude size_of(const given_range& range) {
  const auto of = [](const end_point& x) {
    const ball at = x.at(64);
    return at.is_bounded() ? at.magnitude_upper() : magnitude::power_of_two(0);
  };
  return min(max(of(range.first.end), of(range.second.end)), magnitude::power_of_two(0));
}

/// The regions with their roots, whose enclosures show the digits where a few more let them.
std::vector<listed_root> listed(const std::vector<root_region>& regions, const magnitude& size,
                                long digits, int threads) {
  // 10^-digits, or less.
  const magnitude goal = scale(size, -static_cast<std::int64_t>(bits_for_digits(digits)));
  std::vector<refined_root> roots = refine(regions, digits + 1, threads);
  std::vector<listed_root> result;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const root_region& r = regions[i];
    result.push_back({r, r.enclosure, std::nullopt, false, false});
    if (!is_one_root(r.verdict)) continue;
    refined_root& root = roots[i];
    const auto shows_digits = [&] {
      return to_decimal_enclosure(root.enclosure, digits).has(digits);
    };
    if (root.verdict == status::certified && !shows_digits()) {
      refined_root finer = refine(r, digits + 6);
      if (finer.verdict == status::certified) root = std::move(finer);
    }
    result.back().enclosure = root.enclosure;
    result.back().exact = root.exact;
    result.back().has_digits = root.verdict == status::certified && shows_digits();
    if (!result.back().has_digits && contains_zero(root.enclosure) &&
        root.enclosure.magnitude_upper() <= goal) {
      result.back().has_digits = result.back().is_small = true;
    }
  }
  return result;
}

struct answer {
  root_set roots;
  std::optional<double>
      ended_after;  // seconds, where the time limit ended the search or the digits
  std::vector<listed_root> list;

  [[nodiscard]] bool is_certified() const {
    return roots.complete && std::all_of(list.begin(), list.end(),
                                         [](const listed_root& r) { return r.is_certified(); });
  }
};

answer find_roots(const expression& f, const given_range& range, long digits, int threads,
                  const time_limit_option& time_limit) {
  const progress line;
  line.show("looking for roots");
  isolate_options options;
  options.threads = threads;
  options.by_period = true;
  // The search ends in time, with what it found; the digits of what it found may take as much time
  // again for each root; roots for which it does not suffice are shown as the search found them.
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(time_limit.limit());
  bool ended_early = false;
  options.progress = [&](const isolation_progress& p) {
    if (std::chrono::steady_clock::now() >= end) {
      ended_early = true;
      return false;
    }
    const std::string share =
        p.share_done ? fmt::format("{:.0f} % of the range done, ", 100 * *p.share_done) : "";
    line.show(fmt::format("{}{} boxes examined, {} waiting, {} roots", share, p.boxes_done,
                          p.boxes_waiting, p.roots));
    return true;
  };
  answer result;
  {
    // For evaluations so long that the search does not come to look at the clock.
    const time_watch watch(2 * time_limit.limit());
    result.roots = isolate_roots(f, range.first.end, range.second.end, options);
  }
  if (ended_early) result.ended_after = time_limit.limit();
  const std::vector<root_region>& regions = result.roots.regions;
  const magnitude size = size_of(range);
  if (!regions.empty()) {
    line.expect(time_limit.check(
        fmt::format("{} digits of {} root{}", digits, regions.size(),
                    regions.size() == 1 ? "" : "s"),
        digits, {[&](long fewer) { (void)listed({regions.front()}, size, fewer, threads); }},
        static_cast<double>(regions.size())));
  }
  const double most_seconds = time_limit.limit(static_cast<double>(regions.size()));
  const auto end_of_digits =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(most_seconds);
  const time_watch watch(2 * most_seconds);  // for one root that takes that long
  const std::ptrdiff_t at_a_time = threads == 1 ? 1 : 64;
  for (auto first = regions.begin(); first != regions.end();) {
    if (std::chrono::steady_clock::now() >= end_of_digits) {  // the others as the search found them
      if (!result.ended_after) result.ended_after = most_seconds;
      for (; first != regions.end(); ++first) {
        result.list.push_back({*first, first->enclosure, std::nullopt, false, false});
      }
      break;
    }
    const auto last = first + std::min(at_a_time, regions.end() - first);
    line.show(fmt::format("computing the digits of root {} of {}", first - regions.begin() + 1,
                          regions.size()));
    for (listed_root& r : listed({first, last}, size, digits, threads)) {
      result.list.push_back(std::move(r));
    }
    first = last;
  }
  return result;
}

// ---------------------------------------------------------------------------------------------
// The formats

std::string verdict_text(const listed_root& r) {
  if (r.region.verdict == root_verdict::multiple) {
    return fmt::format("multiple {}", r.region.multiplicity);
  }
  return to_text(r.region.verdict);
}

std::string remark_on(const listed_root& r) {
  std::string result = r.region.remark;
  const auto append = [&](const std::string& more) {
    result += (result.empty() ? "" : "; ") + more;
  };
  if (r.region.complex_roots) {
    append(fmt::format("{} complex roots near it, counted with multiplicities",
                       *r.region.complex_roots));
  }
  if (r.region.may_lie_outside) append("at an end of the interval, inside or outside");
  if (!is_one_root(r.region.verdict) && r.region.exact) {
    append("a root is " + to_text(*r.region.exact) + ", exactly");
  }
  if (is_one_root(r.region.verdict) && !r.has_digits) append("fewer digits than asked for");
  if (r.is_small) append("it may be 0: no digits of its own, but those of the interval's size");
  return result;
}

/// Its digits; both ends where they share too few.
std::string number_text(const listed_root& r, long digits) {
  if (r.exact) return exact_number_text(*r.exact, digits);
  if (!r.enclosure.is_bounded()) return fmt::format("{}", "unbounded");
  constexpr long few = 12;
  const decimal_enclosure d = to_decimal_enclosure(r.enclosure, digits);
  if (is_one_root(r.region.verdict) && d.digits > 0) return to_text(d);
  // A region that may hold a root, or may not, is no number.
  const decimal_enclosure brief = to_decimal_enclosure(r.enclosure, std::min(digits, few));
  return fmt::format("from {} to {}", brief.lower, brief.upper);
}

bool is_finite(const mpfr_float& end) { return mpfr_number_p(end.backend().data()) != 0; }

/// Of an unbounded set the end that is finite, if one is.
decimal_enclosure decimals_of(const ball& x, long digits) {
  if (x.is_bounded()) return to_decimal_enclosure(x, digits);
  decimal_enclosure d;
  if (x.is_undefined()) return d;
  if (is_finite(lower(x))) d.lower = to_decimal_enclosure(ball(lower(x)), digits).lower;
  if (is_finite(upper(x))) d.upper = to_decimal_enclosure(ball(upper(x)), digits).upper;
  return d;
}
json number_json(const ball& x, long digits) {
  json result = to_json(x, digits);
  if (x.is_bounded()) return result;
  const decimal_enclosure d = decimals_of(x, digits);
  if (!d.lower.empty()) result["lower"] = d.lower;
  if (!d.upper.empty()) result["upper"] = d.upper;
  return result;
}

std::string bound_text(const ball& x) {
  constexpr long few = 12;
  if (x.is_bounded()) return to_decimal(x, few);
  if (x.is_undefined()) return "the whole line";
  if (is_finite(lower(x))) {
    return fmt::format("from {} towards infinity", to_decimal(ball(lower(x)), few));
  }
  if (is_finite(upper(x))) {
    return fmt::format("from {} towards -infinity", to_decimal(ball(upper(x)), few));
  }
  return "the whole line";
}

/// In short where it is not known exactly.
std::string end_text(const end_point& x) {
  constexpr long few = 12;
  if (x.is_infinite()) return x.infinite_sign() < 0 ? "-inf" : "inf";
  return x.form() ? to_text(*x.form()) : to_decimal(x.at(64), few);
}
std::string range_text(const searched_period& one) {
  return end_text(one.lower) + ".." + end_text(one.upper);
}
/// "[-2, 0)".
std::string interval_text(const zero_interval& z) {
  return fmt::format("{}{}, {}{}", z.has_lower ? '[' : '(', end_text(z.lower), end_text(z.upper),
                     z.has_upper ? ']' : ')');
}

std::string summary(const answer& a) {
  const isolation_account& account = a.roots.account;
  const std::string work =
      fmt::format("{} boxes, {} evaluations", account.boxes, account.evaluations);
  if (a.roots.identically_zero) return "certified: the formula is 0 everywhere\n";
  if (a.is_certified() && !a.roots.zero_intervals.empty()) {
    const std::string more = a.list.empty() ? "" : " and " + counted(a.list.size(), "root");
    return fmt::format("certified: {} of roots{}, all there are ({})\n",
                       counted(a.roots.zero_intervals.size(), "interval"), more, work);
  }
  if (a.is_certified()) {
    if (a.list.empty()) return fmt::format("certified: no root ({})\n", work);
    if (const auto& one = a.roots.of_period) {
      return fmt::format(
          "certified: infinitely many roots; these are all in {}, and they have the period {} "
          "({})\n",
          range_text(*one), to_text(one->period), work);
    }
    const auto endless =
        static_cast<std::size_t>(std::ranges::count_if(a.list, [](const listed_root& r) {
          return r.region.verdict == root_verdict::infinitely_many;
        }));
    if (endless > 0) {
      const std::string holders = endless == 1
                                      ? "the region that holds them"
                                      : fmt::format("the {} regions that hold them", endless);
      return fmt::format("certified: infinitely many roots; outside {} {}, all there are ({})\n",
                         holders, counted(a.list.size() - endless, "root"), work);
    }
    return fmt::format("certified: {}, all there are ({})\n", counted(a.list.size(), "root"), work);
  }
  const auto proved = static_cast<std::size_t>(std::count_if(
      a.list.begin(), a.list.end(), [](const listed_root& r) { return r.is_certified(); }));
  const std::string limit =
      a.ended_after ? fmt::format("; the time limit of {} was reached, --time-limit raises it",
                                  duration_text(*a.ended_after))
                    : "";
  const std::string where =
      a.roots.of_period ? " in one period, " + range_text(*a.roots.of_period) : "";
  return fmt::format("not certified: {} proved, {} left open{} ({}){}\n", counted(proved, "root"),
                     counted(a.list.size() - proved, "region"), where, work, limit);
}

std::string as_text(const answer& a, long digits) {
  std::string result;
  for (const zero_interval& z : a.roots.zero_intervals) {
    result += fmt::format("{}  the formula is 0\n", interval_text(z));
  }
  for (const listed_root& r : a.list) {
    const std::string remark = remark_on(r);
    result += fmt::format(
        "{}  {}{}\n", r.enclosure.is_bounded() ? number_text(r, digits) : bound_text(r.enclosure),
        verdict_text(r), remark.empty() ? "" : " (" + remark + ")");
  }
  for (const singular_place& s : a.roots.singular) {
    const std::string place = bound_text(s.place);
    if (s.pole_order > 0) {
      result += fmt::format("no root: a pole of order {} at {}\n", s.pole_order, place);
    } else {
      const bool is_direction = place.rfind("from", 0) == 0;
      result +=
          fmt::format("no root: not defined everywhere {}{}\n", is_direction ? "" : "in ", place);
    }
  }
  return result + summary(a);
}

std::string csv_cell(const std::string& text) {
  return text.find_first_of(",\"") == std::string::npos ? text : '"' + text + '"';
}

std::string as_csv(const answer& a, long digits) {
  std::string result = "verdict,multiplicity,value,radius,lower,upper,digits,exact,remark\n";
  const std::string again =
      a.roots.of_period ? "again after every period, " + to_text(a.roots.of_period->period) : "";
  for (const zero_interval& z : a.roots.zero_intervals) {
    result += fmt::format("interval,,,,{},{},,,{}\n", csv_cell(end_text(z.lower)),
                          csv_cell(end_text(z.upper)), csv_cell("0 in " + interval_text(z)));
  }
  for (const listed_root& r : a.list) {
    std::string remark = remark_on(r);
    if (!again.empty()) remark += (remark.empty() ? "" : "; ") + again;
    const decimal_enclosure d = decimals_of(r.enclosure, digits);
    result += fmt::format("{},{},{},{},{},{},{},{},{}\n", to_text(r.region.verdict),
                          r.region.multiplicity > 0 ? std::to_string(r.region.multiplicity) : "",
                          d.value, d.radius, d.lower, d.upper, d.digits,
                          r.exact ? to_text(*r.exact) : "", csv_cell(remark));
  }
  return result;
}

json as_json(const expression& f, const roots_options& options, const answer& a, long digits) {
  json result{{"function", f.to_text()},
              {"variable", options.variable},
              {"in", options.interval},
              {"verdict", to_text(a.is_certified() ? status::certified : status::not_certified)},
              {"identically_zero", a.roots.identically_zero},
              {"complete", a.roots.complete}};
  json list = json::array();
  for (const listed_root& r : a.list) {
    json entry{{"verdict", to_text(r.region.verdict)}};
    if (r.region.multiplicity > 0) entry["multiplicity"] = r.region.multiplicity;
    if (r.region.complex_roots) entry["complex_roots"] = *r.region.complex_roots;
    const std::string remark = remark_on(r);
    if (!remark.empty()) entry["remark"] = remark;
    entry["number"] = number_json(r.enclosure, digits);
    if (r.exact) entry["number"]["rational"] = to_text(*r.exact);
    list.push_back(std::move(entry));
  }
  result["roots"] = std::move(list);
  json intervals = json::array();
  for (const zero_interval& z : a.roots.zero_intervals) {
    intervals.push_back({{"lower", end_text(z.lower)},
                         {"upper", end_text(z.upper)},
                         {"has_lower", z.has_lower},
                         {"has_upper", z.has_upper}});
  }
  result["zero_intervals"] = std::move(intervals);
  if (const auto& one = a.roots.of_period) {
    result["of_period"] = {{"period", to_text(one->period)}, {"in", range_text(*one)}};
  }
  json places = json::array();
  for (const singular_place& s : a.roots.singular) {
    json entry{{"pole_order", s.pole_order}};
    entry["place"] = to_json(s.place, 15);
    places.push_back(std::move(entry));
  }
  result["singular"] = std::move(places);
  result["account"] = {{"boxes", a.roots.account.boxes},
                       {"evaluations", a.roots.account.evaluations},
                       {"precision", a.roots.account.most_bits}};
  return result;
}

// ---------------------------------------------------------------------------------------------
// The command

/// What a certificate is of. Throws usage_error for an infinite range.
formula_over_range checkable_range(const expression& f, const given_range& range) {
  if (!range.first.formula || !range.second.formula) {
    throw usage_error("--certificate: the range must be finite");
  }
  formula_over_range what{f, *range.first.formula, *range.second.formula};
  expect_checkable(what);
  return what;
}

/// Throws usage_error for an answer that no certificate can hold.
json certificate_for_option(const formula_over_range& what, const answer& a, long digits) {
  try {
    expect_checkable(a.roots);
  } catch (const input_error& error) {
    throw usage_error(fmt::format("--certificate: {}", error.what()));
  }
  return certificate_of(what, a.roots, digits);
}

// ---------------------------------------------------------------------------------------------
// The second opinion

proved_roots as_proved(const answer& a) {
  proved_roots result;
  result.complete = a.roots.complete;
  result.identically_zero = a.roots.identically_zero;
  for (const listed_root& r : a.list) {
    result.roots.push_back(
        {r.region.verdict, r.region.multiplicity, r.enclosure, r.region.may_lie_outside});
  }
  return result;
}

/// The checker's opinion, where there is a certificate of the roots; of few digits, as its time
/// grows with their square and more.
void add_checkers_opinion(printed_opinion& result, const expression& f, const given_range& range,
                          const answer& a, const std::string& first_route, long digits) {
  constexpr long most_digits_for_checker = 1000;
  if (digits > most_digits_for_checker) return;
  std::optional<json> certificate;
  try {
    certificate = certificate_of(checkable_range(f, range), a.roots, digits);
  } catch (const std::invalid_argument&) {
    return;  // no certificate can hold it
  }
  result.add(checked_again("the roots", first_route, *certificate));
}

printed_opinion verify(const expression& f, const given_range& range, const answer& a, long digits,
                       int threads) {
  const progress line;
  line.show("looking for a second opinion");
  const std::string first_route = fmt::format("the search, {} boxes", a.roots.account.boxes);
  const auto& one = a.roots.of_period;
  printed_opinion result(
      roots_again(f, one ? one->lower : range.first.end, one ? one->upper : range.second.end,
                  as_proved(a), first_route, digits, threads),
      digits);
  add_checkers_opinion(result, f, range, a, first_route, digits);
  return result;
}

exit_status run(roots_options& options) {
  const long digits = options.digits.value();
  const std::string format = options.format.value();
  options.verify.expect_format(format);
  const bool is_system = !options.rectangle && !options.complex && options.is_system();
  if (is_system) return run_system(options);
  options.variable = variable_or_only_name(options.given_variable, options.formula, options.let);
  if (options.rectangle) return run_roots_in_rectangle(options);
  if (options.complex) return run_complex_roots(options);
  if (!options.more_formulas.empty()) {
    throw usage_error(
        fmt::format("{} was not expected; of a system, give an interval for each variable, --in "
                    "x=-2..2 --in y=0..1",
                    in_quotes(options.more_formulas.front())));
  }
  const int threads = static_cast<int>(options.threads.value());
  const given_range range = read_range(options);
  const expression f = read_equation(options.formula, {options.variable}, options.let);
  check_memory(options, 3 * static_cast<double>(f.live_numbers()) + 300);
  (void)options.time_limit.limit();
  std::optional<formula_over_range> what;
  if (options.certificate.is_given()) what = checkable_range(f, range);
  options.certificate.prepare();
  const answer a = find_roots(f, range, digits, threads, options.time_limit);
  std::optional<printed_opinion> opinion;
  if (options.verify.given && !a.roots.zero_intervals.empty()) {
    throw usage_error("--verify: there is no second opinion yet on intervals of roots");
  }
  if (options.verify.given && a.is_certified()) {
    opinion = verify(f, range, a, digits, threads);
  }
  if (what && a.is_certified()) options.certificate.write(certificate_for_option(*what, a, digits));
  if (format == "json") {
    json result = as_json(f, options, a, digits);
    if (opinion) result["second_opinion"] = opinion->as_json();
    print(json_document_text("roots", result));
  } else {
    print((format == "csv" ? as_csv(a, digits) : as_text(a, digits)) +
          (opinion ? opinion->as_text() : ""));
  }
  options.certificate.expect_certified(a.is_certified());
  if (opinion) return opinion->status();
  return a.is_certified() ? exit_status::all_certified : exit_status::not_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<roots_options>();
  add_option(app, "EXPR", options->formula, "A formula in x, or an equation such as x^2 = 2")
      .type_name("")
      .required();
  options->range.declare(app);
  add_option(app, "MORE", options->more_formulas, "More formulas of a system").type_name("");
  add_flag(app, "--complex", options->complex,
           "All complex roots of a polynomial, each with its multiplicity");
  add_option(app, "--rectangle", options->rectangle,
             "All complex roots of an analytic function between two corners")
      .type_name("LL..UR");
  add_option(app, "--variable", options->given_variable,
             "The variable's name, if it is neither x nor the formula's only name")
      .type_name("NAME");
  options->threads.declare(
      app, "Search on so many threads; 0 for all processors. The digits are\nthe same");
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
}  // namespace roots_impl

std::string counted(std::size_t n, const std::string& what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

void refuse_options_of_interval(const roots_options& options, const std::string& kind) {
  if (options.verify.given || options.certificate.is_given()) {
    throw usage_error(fmt::format("--verify and --certificate: there are none yet of {}", kind));
  }
  refuse_threads(options, kind);
}

void refuse_threads(const roots_options& options, const std::string& kind) {
  if (options.threads.value() != 1) {
    throw usage_error(fmt::format("--threads: {} are found on one thread", kind));
  }
}

void check_memory(const roots_options& options, double numbers) {
  const long digits = options.digits.value();
  options.memory_limit.check({fmt::format("roots to {} digits", digits),
                              bytes_per_digit * numbers * static_cast<double>(digits)});
}

bool roots_options::is_system() const {
  return std::any_of(range.in.begin(), range.in.end(),
                     [](const std::string& text) { return text.find('=') != std::string::npos; });
}

command roots_command() {
  return {
      "roots", "Find all roots of a formula in an interval, with a proof",
      "  polhode roots \"cos(x) - x\" 0..1 --digits 100\n"
      "  polhode roots \"(x-1)*(x^2-2)^3\" -inf inf\n"
      "  polhode roots \"exp(x) = 3*x\" 0 2\n"
      "  polhode roots \"tan(x) - k*x\" --in -10..10 --let k=1/2 --format csv\n"
      "  polhode roots \"cos(x) - x\" --in 0..1 --certificate root.json && polhode check "
      "root.json\n"
      "  polhode roots \"sin(x^2)*(x^3-2)\" --in -5..5 --verify\n"
      "  polhode roots \"x^5-x-1\" --complex --digits 30\n"
      "  polhode roots \"exp(z)-z\" --rectangle -5-10i..5+10i\n"
      "  polhode roots \"x^2+y^2-1\" \"x-y^3\" --in x=-2..2 --in y=-2..2\n"
      "  polhode roots \"exp(x)=y\" \"x*y=1\" --in x=-inf..inf --in y=0..inf\n\n"
      "Every root in the interval is in the list, or in a region of it with infinitely many. The\n"
      "verdict says what is proved:\n"
      "  unique         a simple root, the only one in its place\n"
      "  multiple M     a root of multiplicity M, the only one in its place\n"
      "  isolated       a root, the only one in its place, at a kink or branch point\n"
      "  at least one   a root, perhaps with others beside it\n"
      "  infinitely many\n"
      "                 roots towards infinity or a point, of which the nearest are listed before\n"
      "  unresolved     perhaps a root, perhaps none; the remark says what is in the way\n"
      "Poles, and places where the formula is not defined, are told apart. The status is 0 where\n"
      "nothing is unresolved and no root is `at least one`.\n",
      roots_impl::declare};
}

}  // namespace polhode::cli
