// polhode racket: which twists the tennis racket effect of a body has, and where.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/options/body_option.hpp"
#include "cli/options/count_option.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/motion_option.hpp"
#include "cli/options/options.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/layout.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "polhode/rigid_body/twist_curve.hpp"
#include "proofs/claim.hpp"
#include "uncertain_effects.hpp"

namespace polhode::cli {
namespace racket_impl {
namespace {

struct racket_options {
  body_option which;
  std::optional<std::string> c;
  std::optional<std::string> limit;
  count_option meetings{"--meetings", 20, 0, 1'000'000};
  digits_option digits;
  format_option format{{"text", "json"}};
  memory_limit_option memory_limit;
  time_limit_option time_limit;
};

/// What does not exist is missing; what was not certified has its verdict.
struct answer {
  body_kind kind = body_kind::undecided;
  bool injective = false;
  certain_number epsilon0;
  std::optional<certain_number> perfect_twist;
  std::optional<certain_number> full_turn;
  integer meeting_count;
  integer intersections;
  integer crossings;
  std::vector<meeting> meetings;
  std::optional<rational> c;
  twist at_c;
  /// Whether epsilon0 and c0, about e^(-pi sqrt(ab)) and its square, may be below the exponents
  /// that numbers have.
  bool may_be_too_small = false;
};

answer answer_of(const racket_options& options, const body& rigid, const std::optional<rational>& c,
                 long digits, const progress& line) {
  answer result;
  result.kind = rigid.kind();
  result.injective = is_injective(rigid);
  const rational beyond_exponents("10000000000000");
  result.may_be_too_small = rigid.a() * rigid.b() >= beyond_exponents;
  line.show("computing epsilon0");
  result.epsilon0 = separatrix_defect_to_digits(rigid, digits);
  line.show("computing c0");
  if (has_perfect_twist(rigid)) result.perfect_twist = perfect_twist_to_digits(rigid, digits);
  if (has_full_turn(rigid)) result.full_turn = full_turn_to_digits(rigid, digits);
  result.meeting_count = meeting_count(rigid);
  result.intersections = intersection_count(rigid);
  result.crossings = crossing_count(rigid);
  const integer listed = std::min(result.meeting_count, integer(options.meetings.value()));
  for (integer m = 1; m <= listed; ++m) {
    line.show(fmt::format("computing meeting {} of {}", m.str(), listed.str()));
    result.meetings.push_back(meeting_to_digits(rigid, m, digits));
  }
  if (!c) return result;
  line.show("computing epsilon(c)");
  result.c = c;
  result.at_c = twist_to_digits(rigid, *c, digits);
  return result;
}

/// "precision limit", and where that comes from for numbers of the size e^(-pi sqrt(ab)).
std::string why_not(const answer& a, reason why) {
  if (!a.may_be_too_small || why != reason::precision_limit) return to_text(why);
  return "for so large an a b it may be below the exponents that numbers have here, 2^(-2^30)";
}

/// What was not certified, and why.
std::vector<std::pair<std::string, std::string>> failures_of(const answer& a) {
  std::vector<std::pair<std::string, std::string>> result;
  const auto add = [&](const std::string& what, status verdict, reason why) {
    if (verdict != status::certified) result.emplace_back(what, why_not(a, why));
  };
  add("epsilon0", a.epsilon0.verdict, a.epsilon0.why);
  if (a.perfect_twist) add("c0", a.perfect_twist->verdict, a.perfect_twist->why);
  if (a.full_turn) add("the full turn's c", a.full_turn->verdict, a.full_turn->why);
  for (const meeting& m : a.meetings) {
    add("the c with G(u) = 2 pi/" + m.m.str(), m.verdict, m.why);
  }
  if (a.c && a.at_c.verdict != status::certified) {
    result.emplace_back("epsilon(c)", to_text(a.at_c.why));
  }
  return result;
}

bool is_intersection(const meeting& m) { return m.m % 2 != 0; }

std::string text_of(const answer& a, long digits) {
  const auto decimals = [digits](const ball& x) { return to_decimal(x, digits); };
  std::string result = described(a.kind) + '\n';
  // Nothing for what was not certified: that is said at the end.
  const auto add = [&](const char* what, const certain_number& n) {
    if (n.verdict == status::certified) {
      result += fmt::format("{} = {}\n", what, decimals(n.enclosure));
    }
  };
  result += a.injective ? "epsilon(c) is injective\n" : "epsilon(c) is not injective\n";
  add("epsilon0", a.epsilon0);
  if (a.perfect_twist) {
    add("c0", *a.perfect_twist);
  } else {
    result += "c0: there is no perfect twist, since J >= 2\n";
  }
  if (a.full_turn) {
    add("full turn at c", *a.full_turn);
  } else {
    result += "there is no full turn, since J >= 1\n";
  }
  result += fmt::format("points where C meets S: {}; where it crosses epsilon = pi/2: {}\n",
                        a.intersections.str(), a.crossings.str());
  for (const meeting& m : a.meetings) {
    if (m.verdict != status::certified) continue;
    const std::string at =
        (is_intersection(m) ? "meets S at c = " : "crosses pi/2 at c = ") + decimals(m.c);
    result += at;
    if (is_intersection(m)) {
      const std::string epsilon = "epsilon = " + decimals(m.epsilon);
      const bool fits = at.size() + 2 + epsilon.size() <= terminal_columns;
      result += (fits ? ", " : "\n        ") + epsilon;
    }
    result += '\n';
  }
  const integer more = a.meeting_count - integer(a.meetings.size());
  if (more > 0) result += fmt::format("and {} more, not listed (--meetings N)\n", more.str());
  if (a.c && a.at_c.verdict == status::certified) {
    result += fmt::format("epsilon(c) = {}\n", decimals(a.at_c.epsilon));
    result += fmt::format("d epsilon/dc = {}\n", decimals(a.at_c.slope));
    result += fmt::format("{}, branch {}\n", to_text(a.at_c.motion), a.at_c.branch.str());
  }
  for (const auto& [what, why] : failures_of(a)) {
    result += fmt::format("not certified to {} digits: {}\n  ({})\n", digits, what, why);
  }
  return result;
}

/// An integer as JSON: a number where that has room for it.
json integer_json(const integer& n) {
  constexpr long most = 1L << 53;
  if (n <= most) return static_cast<long>(n);
  return n.str();
}

/// null for what does not exist or was not certified.
std::string json_of(const answer& a, long digits) {
  const auto number = [digits](const std::optional<certain_number>& n) {
    return n && n->verdict == status::certified ? to_json(n->enclosure, digits) : json(nullptr);
  };
  const auto failures = failures_of(a);
  json result{{"kind", to_text(a.kind)},
              {"verdict", to_text(failures.empty() ? status::certified : status::not_certified)},
              {"injective", a.injective},
              {"epsilon0", number(a.epsilon0)},
              {"c0", number(a.perfect_twist)},
              {"full_turn", number(a.full_turn)},
              {"intersections_with_s", integer_json(a.intersections)},
              {"crossings_of_half_pi", integer_json(a.crossings)}};
  for (const auto& [what, why] : failures) {
    result["not_certified"].push_back({{"what", what}, {"why", why}});
  }
  if (!a.perfect_twist) result["remark_on_c0"] = "there is no perfect twist, since J >= 2";
  if (!a.full_turn) result["remark_on_full_turn"] = "there is no full turn, since J >= 1";
  result["meetings"] = json::array();
  for (const meeting& m : a.meetings) {
    const bool known = m.verdict == status::certified;
    json one{{"m", integer_json(m.m)},
             {"kind", is_intersection(m) ? "intersection" : "crossing"},
             {"c", known ? to_json(m.c, digits) : json(nullptr)},
             {"u", known ? to_json(m.u, digits) : json(nullptr)}};
    if (known && is_intersection(m)) one["epsilon"] = to_json(m.epsilon, digits);
    result["meetings"].push_back(std::move(one));
  }
  if (a.c) {
    result["c"] = exact_json(*a.c, digits);
    result["regime"] = to_text(a.at_c.motion);
    const bool known = a.at_c.verdict == status::certified;
    result["branch"] = known ? integer_json(a.at_c.branch) : json(nullptr);
    result["epsilon"] = known ? to_json(a.at_c.epsilon, digits) : json(nullptr);
    result["slope"] = known ? to_json(a.at_c.slope, digits) : json(nullptr);
  }
  return json_document_text("racket", result);
}

// ---------------------------------------------------------------------------------------------
// The limit a -> infinity, b -> 0

struct limit_point {
  rational chi;
  rational beta;
};

limit_point read_limit(const racket_options& options) {
  const std::string& text = *options.limit;
  const body_option& which = options.which;
  if (which.ab || which.moments || which.rotational || which.file || options.c) {
    throw usage_error(fmt::format(
        "--limit {}: it is of no body; leave out --ab, --moments, --rotational, --body and --c",
        in_quotes(text)));
  }
  const auto comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos) {
    throw usage_error(fmt::format("--limit {}: it must be two numbers CHI,BETA such as 0.8,-0.1",
                                  in_quotes(text)));
  }
  limit_point at{read_number("--limit", text.substr(0, comma)),
                 read_number("--limit", text.substr(comma + 1))};
  if (at.chi <= 0) {
    throw usage_error(fmt::format("--limit {}: CHI = ab must be positive", in_quotes(text)));
  }
  if (at.beta <= -1) {
    throw usage_error(fmt::format("--limit {}: BETA = c/b must be above -1", in_quotes(text)));
  }
  return at;
}

/// The claim limit_formula, at one chi and beta.
exit_status run_limit(const racket_options& options) {
  const long digits = options.digits.value();
  const limit_point at = read_limit(options);
  constexpr double bytes_per_digit = 60;
  const std::string what = fmt::format("{} digits of epsilon in the limit", digits);
  options.memory_limit.check({what, bytes_per_digit * static_cast<double>(digits)});
  const certain_number epsilon = [&] {
    const progress line;
    line.expect(options.time_limit.check(
        what, digits, {[&](long fewer) { (void)limit_defect_to_digits(at.chi, at.beta, fewer); }}));
    line.show("computing epsilon");
    const time_watch watch(options.time_limit.limit());
    return limit_defect_to_digits(at.chi, at.beta, digits);
  }();
  const bool certified = epsilon.verdict == status::certified;
  if (options.format.value() == "json") {
    print(json_document_text(
        "racket", {{"chi", exact_json(at.chi, digits)},
                   {"beta", exact_json(at.beta, digits)},
                   {"verdict", to_text(epsilon.verdict)},
                   {"epsilon", certified ? to_json(epsilon.enclosure, digits) : json(nullptr)}}));
  } else if (certified) {
    print(
        fmt::format("limit a -> infinity, b -> 0 with ab -> {}, c/b = {}\nepsilon = {}\n"
                    "(the formula of the limit: polhode certify limit_formula)\n",
                    to_text(at.chi), to_text(at.beta), to_decimal(epsilon.enclosure, digits)));
  } else {
    print(fmt::format("not certified to {} digits: epsilon in the limit\n  ({})\n", digits,
                      to_text(epsilon.why)));
  }
  return certified ? exit_status::all_certified : exit_status::not_certified;
}

exit_status run(const racket_options& options) {
  if (options.limit) return run_limit(options);
  const long digits = options.digits.value();
  const bool json_wanted = options.format.value() == "json";
  if (const auto uncertain = options.which.uncertain()) {
    uncertain_effects of{.moments = *uncertain,
                         .c = {},
                         .want = R"("tennis_racket", "intersections", "full_turn")",
                         .listed = options.meetings.value(),
                         .digits = digits,
                         .seconds = options.time_limit.limit()};
    if (options.c) of.c = read_number("--c", *options.c);
    return print_effects(of, json_wanted);
  }
  const auto listed = static_cast<double>(options.meetings.value());
  const body rigid = options.which.value();
  std::optional<rational> c;
  if (options.c) {
    c = read_motion(*options.c, rigid);
    refuse_equilibrium(rigid, *c, "epsilon(c)");
  }
  constexpr double bytes_per_digit = 60;
  constexpr double bytes_kept = 20;
  const std::string what = fmt::format("{} digits of epsilon0 and c0", digits);
  options.memory_limit.check(
      {what, (bytes_per_digit +
              bytes_kept * std::min(listed, static_cast<double>(meeting_count(rigid)))) *
                 static_cast<double>(digits)});
  const answer a = [&] {
    const progress line;
    line.expect(options.time_limit.check(
        what, digits, {[&](long fewer) { (void)answer_of(options, rigid, c, fewer, line); }}));
    const time_watch watch(options.time_limit.limit());
    return answer_of(options, rigid, c, digits, line);
  }();
  print(json_wanted ? json_of(a, digits) : text_of(a, digits));
  return failures_of(a).empty() ? exit_status::all_certified : exit_status::not_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<racket_options>();
  options->which.declare(app);
  add_option(app, "--c", options->c,
             "A motion, between -b and a: print epsilon(c) and d epsilon/dc, too")
      .type_name("C");
  add_option(app, "--limit", options->limit,
             "No body, but the limit a -> infinity, b -> 0 with ab -> CHI > 0 and\n"
             "c/b = BETA > -1: print epsilon there (claim limit_formula)")
      .type_name("CHI,BETA");
  options->meetings.declare(app,
                            "List at most so many of the points where C meets S or crosses pi/2");
  options->digits.declare(app);
  options->format.declare(app);
  options->memory_limit.declare(app);
  options->time_limit.declare(app);
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace racket_impl

command racket_command() {
  return {
      "racket", "Find the twists of the tennis racket effect: epsilon0, c0, epsilon(c)",
      "  polhode racket --ab 12.65,0.0629\n"
      "  polhode racket --ab 39.95,0.0629 --c -0.03 --digits 100\n"
      "  polhode racket --moments 3,2,1 --format json\n"
      "  polhode racket --moments 3.2±0.01,2,1.5±0.01\n"
      "  polhode racket --limit 1,-0.2\n\n"
      "In one turn about the angular momentum the body's angle psi goes from -pi/2 + epsilon to\n"
      "pi/2 - epsilon. epsilon0 is the defect epsilon on the separatrix, c = 0; c0 the motion of "
      "the\n"
      "perfect twist, epsilon = 0; on the curve C of all (c, epsilon) the body stands at a turning "
      "point\n"
      "where C meets S: c = -b sin^2 epsilon. What exists, and how often, is decided exactly. "
      "Where a\n"
      "number cannot be certified the others are printed all the same (exit status 1). Of moments "
      "with\n"
      "uncertainties the report is that of `polhode scene`, with the range of each number.\n",
      racket_impl::declare};
}

}  // namespace polhode::cli
