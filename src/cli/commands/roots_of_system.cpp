// polhode roots F G --in x=LO..HI --in y=LO..HI: all roots of a system of equations in a box.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options/second_opinion.hpp"
#include "cli/output/errors.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/certificate_of.hpp"
#include "polhode/roots/systems.hpp"
#include "roots_options.hpp"

namespace polhode::cli {
namespace system_roots_impl {
namespace {

/// The equations, and the box in which their roots are looked for.
struct system_given {
  std::vector<std::string> variables;
  std::vector<expression> formulas;
  std::vector<std::string> intervals;
  std::vector<std::pair<std::string, std::string>> ends;  // of the intervals, as they were given
  system_box box;
};

/// The lower (-1) or upper (1) end of an interval; none where it is infinite.
std::optional<rational> face(const std::string& text, int which, const std::string& variable,
                             const let_option& let) {
  if (const int sign = infinite_sign_of(text)) {
    if (sign == which) return std::nullopt;
    throw usage_error(fmt::format("--in: the interval of {} is the wrong way round", variable));
  }
  std::optional<rational> exact = read_formula(text, {}, let).exact_value();
  if (!exact) {
    throw usage_error(fmt::format(
        "--in: the end \"{}\" of the interval of {} is not a rational number; give one near it",
        text, variable));
  }
  return exact;
}

system_given read_system(const roots_options& options) {
  system_given given;
  for (const std::string& text : options.range.in) {
    const std::size_t at = text.find('=');
    if (at == std::string::npos) {
      throw usage_error(fmt::format(
          "--in \"{}\": of a system, give NAME=LO..HI for each variable, such as x=-2..2", text));
    }
    const std::string name = text.substr(0, at);
    check_variable(name);
    if (std::find(given.variables.begin(), given.variables.end(), name) != given.variables.end()) {
      throw usage_error(fmt::format("--in: there are two intervals of {}; give one", name));
    }
    const auto [lower, upper] =
        range_option::ends_of(fmt::format("--in {}=", name), text.substr(at + 1), options.let);
    given.box.emplace_back(face(lower, -1, name, options.let), face(upper, 1, name, options.let));
    given.variables.push_back(name);
    given.intervals.push_back(fmt::format("{}..{}", lower, upper));
    given.ends.emplace_back(lower, upper);
  }
  std::vector<std::string> texts{options.formula};
  for (const auto& text : {options.range.first, options.range.second}) {
    if (text) texts.push_back(*text);
  }
  texts.insert(texts.end(), options.more_formulas.begin(), options.more_formulas.end());
  if (texts.size() != given.variables.size()) {
    throw usage_error(fmt::format(
        "there are {} and {}: of a system, give as many formulas as intervals --in NAME=LO..HI",
        counted(texts.size(), "formula"), counted(given.variables.size(), "interval")));
  }
  for (const std::string& text : texts) {
    given.formulas.push_back(read_equation(text, given.variables, options.let));
  }
  return given;
}

struct system_answer {
  system_root_set roots;
  std::vector<std::vector<ball>> enclosures;
  std::vector<bool> certified;

  [[nodiscard]] bool is_certified() const {
    return roots.complete &&
           std::find(certified.begin(), certified.end(), false) == certified.end();
  }
};

system_answer find_roots(const system_given& given, long digits, double seconds) {
  const progress line;
  line.show("looking for roots");
  const real_system system(given.formulas);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  system_options options;
  options.progress = [&](const isolation_progress& p) {
    line.show(fmt::format("{} boxes examined, {} waiting, {} roots", p.boxes_done, p.boxes_waiting,
                          p.roots));
    return std::chrono::steady_clock::now() < end;
  };
  system_answer a;
  const time_watch watch(2 * seconds);
  a.roots = solve_system(system, given.box, options);
  for (const system_region& r : a.roots.regions) {
    a.enclosures.push_back(r.enclosure);
    bool certified = false;
    if (is_one_root(r.verdict)) {
      // One digit more, so that the last one is not in doubt.
      refined_system_root fine = refine(system, r, digits + 1);
      certified = fine.verdict == status::certified && !r.may_lie_outside;
      a.enclosures.back() = std::move(fine.enclosure);
    }
    a.certified.push_back(certified);
  }
  return a;
}

/// What a certificate is of. Throws input_error for an unbounded box.
system_over_box checkable_box(const system_given& given, const let_option& let) {
  system_over_box what{given.formulas, {}, {}};
  for (std::size_t i = 0; i < given.box.size(); ++i) {
    if (!given.box[i].first || !given.box[i].second) {
      throw input_error(
          fmt::format("no certificate: the interval of {} must be finite", given.variables[i]));
    }
    what.from.push_back(read_formula(given.ends[i].first, {}, let));
    what.to.push_back(read_formula(given.ends[i].second, {}, let));
  }
  expect_checkable(what);
  return what;
}

/// The only second opinion on the roots of a system is the checker's.
printed_opinion verify(const system_given& given, const system_answer& a, long digits,
                       const let_option& let) {
  const progress line;
  line.show("looking for a second opinion");
  printed_opinion result;
  try {
    result.add(checked_again("the roots",
                             fmt::format("the search, {} boxes", a.roots.account.boxes),
                             certificate_of(checkable_box(given, let), a.roots, digits)));
  } catch (const std::invalid_argument& error) {
    printed_route none;
    none.route = "the independent checker, from a certificate";
    none.obstacle = error.what();
    result.add(std::move(none));
  }
  return result;
}

std::string remark_on(const system_region& r) {
  std::string remark = r.remark;
  if (r.may_lie_outside) {
    remark += (remark.empty() ? "" : "; ");
    remark += "on a face of the box, inside or outside";
  }
  return remark;
}

std::string part_text(const ball& x, bool is_root, long digits) {
  if (is_root) return to_text(to_decimal_enclosure(x, digits));
  constexpr long few = 12;
  digits = std::min(digits, few);
  if (x.is_bounded()) {
    const decimal_enclosure d = to_decimal_enclosure(x, digits);
    return fmt::format("from {} to {}", d.lower, d.upper);
  }
  const double_interval ends = double_interval::from_ball(x);
  const auto end = [&](double at) {
    if (std::isinf(at)) return std::string(at < 0 ? "-inf" : "inf");
    return to_text(to_decimal_enclosure(ball::exactly(at, 64), digits));
  };
  return fmt::format("from {} to {}", end(ends.lower()), end(ends.upper()));
}

std::string as_text(const system_given& given, const system_answer& a, long digits) {
  std::string result;
  for (std::size_t i = 0; i < a.roots.regions.size(); ++i) {
    const system_region& r = a.roots.regions[i];
    for (std::size_t j = 0; j < given.variables.size(); ++j) {
      result += fmt::format("{}{} = {}", j == 0 ? "" : ", ", given.variables[j],
                            part_text(a.enclosures[i][j], is_one_root(r.verdict), digits));
    }
    const std::string remark = remark_on(r);
    result +=
        fmt::format("  {}{}\n", to_text(r.verdict), remark.empty() ? "" : " (" + remark + ")");
  }
  const std::string work =
      fmt::format("{} boxes, {} evaluations", a.roots.account.boxes, a.roots.account.evaluations);
  const std::size_t all = a.roots.regions.size();
  if (a.is_certified()) {
    return result + (all == 0 ? fmt::format("certified: no root ({})\n", work)
                              : fmt::format("certified: {}, all there are ({})\n",
                                            counted(all, "root"), work));
  }
  const auto proved =
      static_cast<std::size_t>(std::count(a.certified.begin(), a.certified.end(), true));
  return result + fmt::format("not certified: {} proved, {} left open ({}){}\n",
                              counted(proved, "root"), counted(all - proved, "region"), work,
                              a.roots.complete ? "" : "; a limit was reached");
}

std::string as_csv(const system_given& given, const system_answer& a, long digits) {
  std::string result = "verdict";
  for (const std::string& name : given.variables) result += fmt::format(",{0},{0}_radius", name);
  result += ",remark\n";
  for (std::size_t i = 0; i < a.roots.regions.size(); ++i) {
    result += to_text(a.roots.regions[i].verdict);
    for (const ball& x : a.enclosures[i]) {
      decimal_enclosure d;
      if (x.is_bounded()) d = to_decimal_enclosure(x, digits);
      result += fmt::format(",{},{}", d.value, d.radius);
    }
    result += fmt::format(",\"{}\"\n", remark_on(a.roots.regions[i]));
  }
  return result;
}

json as_json(const system_given& given, const system_answer& a, long digits) {
  json functions = json::array();
  for (const expression& f : given.formulas) functions.push_back(f.to_text());
  json list = json::array();
  for (std::size_t i = 0; i < a.roots.regions.size(); ++i) {
    const system_region& r = a.roots.regions[i];
    json entry{{"verdict", to_text(r.verdict)}};
    const std::string remark = remark_on(r);
    if (!remark.empty()) entry["remark"] = remark;
    for (std::size_t j = 0; j < given.variables.size(); ++j) {
      entry["numbers"][given.variables[j]] = to_json(a.enclosures[i][j], digits);
    }
    list.push_back(std::move(entry));
  }
  return {{"functions", std::move(functions)},
          {"variables", given.variables},
          {"in", given.intervals},
          {"verdict", to_text(a.is_certified() ? status::certified : status::not_certified)},
          {"complete", a.roots.complete},
          {"roots", std::move(list)},
          {"account",
           {{"boxes", a.roots.account.boxes},
            {"evaluations", a.roots.account.evaluations},
            {"precision", a.roots.account.most_bits}}}};
}

}  // namespace
}  // namespace system_roots_impl

exit_status run_system(roots_options& options) {
  using namespace system_roots_impl;
  if (options.range.from || options.range.to) {
    throw usage_error("--from and --to: of a system, give --in NAME=LO..HI for each variable");
  }
  refuse_threads(options, "the roots of a system");
  if (options.given_variable) {
    throw usage_error("--variable: of a system, the names are those of --in NAME=LO..HI");
  }
  const long digits = options.digits.value();
  const system_given given = read_system(options);
  double numbers = 300;
  for (const expression& f : given.formulas) {
    numbers += 3 * static_cast<double>(f.live_numbers() * (given.variables.size() + 1));
  }
  check_memory(options, numbers);
  const double seconds = options.time_limit.limit();
  std::optional<system_over_box> what;
  if (options.certificate.is_given()) what = checkable_box(given, options.let);
  options.certificate.prepare();
  const system_answer a = find_roots(given, digits, seconds);
  std::optional<printed_opinion> opinion;
  if (options.verify.given && a.is_certified()) opinion = verify(given, a, digits, options.let);
  if (what && a.is_certified()) {
    options.certificate.write(certificate_of(*what, a.roots, digits));
  }
  const std::string format = options.format.value();
  if (format == "json") {
    json result = as_json(given, a, digits);
    if (opinion) result["second_opinion"] = opinion->as_json();
    print(json_document_text("roots", result));
  } else {
    print((format == "csv" ? as_csv(given, a, digits) : as_text(given, a, digits)) +
          (opinion ? opinion->as_text() : ""));
  }
  options.certificate.expect_certified(a.is_certified());
  if (opinion) return opinion->status();
  return a.is_certified() ? exit_status::all_certified : exit_status::not_certified;
}

}  // namespace polhode::cli
