// polhode racket: which twists the tennis racket effect of a body has, and where.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "body_option.hpp"
#include "commands.hpp"
#include "count_option.hpp"
#include "exact_decimals.hpp"
#include "memory_limit.hpp"
#include "motion_option.hpp"
#include "options.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "progress.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

struct racket_options {
  body_option which;
  std::optional<std::string> c;
  count_option meetings{"--meetings", 20, 0, 1'000'000};
  digits_option digits;
  format_option format{{"text", "json"}};
  memory_limit_option memory_limit;
};

/// What does not exist is missing.
struct answer {
  body_kind kind = body_kind::undecided;
  bool injective = false;
  ball epsilon0;
  std::optional<ball> perfect_twist;
  std::optional<ball> full_turn;
  integer meeting_count;
  integer intersections;
  integer crossings;
  std::vector<meeting> meetings;
  std::optional<rational> c;
  twist at_c;
};

/// As certain(), of a number of the size e^(-pi sqrt(ab)) or its square.
ball certain_small(const certain_number& n, const body& rigid, const char* what, long digits) {
  const rational beyond_exponents("10000000000000");
  if (n.verdict == status::certified || rigid.a() * rigid.b() < beyond_exponents) {
    return certain(n, what, digits);
  }
  throw not_certified_error(
      fmt::format("{} was not certified to {} digits: for so large an a b, {} being about e^(-pi "
                  "sqrt(a b)) or its "
                  "square, it may be below the exponents that numbers have here, 2^(-2^30)",
                  what, digits, what));
}

answer answer_of(const racket_options& options, const body& rigid, const std::optional<rational>& c,
                 long digits) {
  const progress line;
  answer result;
  result.kind = rigid.kind();
  result.injective = is_injective(rigid);
  line.show("computing epsilon0");
  result.epsilon0 =
      certain_small(separatrix_defect_to_digits(rigid, digits), rigid, "epsilon0", digits);
  line.show("computing c0");
  if (has_perfect_twist(rigid)) {
    result.perfect_twist =
        certain_small(perfect_twist_to_digits(rigid, digits), rigid, "c0", digits);
  }
  if (has_full_turn(rigid)) {
    result.full_turn =
        certain_small(full_turn_to_digits(rigid, digits), rigid, "the full turn's c", digits);
  }
  result.meeting_count = meeting_count(rigid);
  result.intersections = intersection_count(rigid);
  result.crossings = crossing_count(rigid);
  const integer listed = std::min(result.meeting_count, integer(options.meetings.value()));
  for (integer m = 1; m <= listed; ++m) {
    line.show(fmt::format("computing meeting {} of {}", m.str(), listed.str()));
    result.meetings.push_back(meeting_to_digits(rigid, m, digits));
    const meeting& last = result.meetings.back();
    if (last.verdict == status::certified) continue;
    throw not_certified_error(
        fmt::format("the c with G(u) = 2 pi/{} was not certified to {} digits ({})", m.str(),
                    digits, to_text(last.why)));
  }
  if (!c) return result;
  line.show("computing epsilon(c)");
  result.c = c;
  result.at_c = twist_to_digits(rigid, *c, digits);
  if (result.at_c.verdict != status::certified) {
    throw not_certified_error(fmt::format("epsilon(c) was not certified to {} digits ({})", digits,
                                          to_text(result.at_c.why)));
  }
  return result;
}

bool is_intersection(const meeting& m) { return m.m % 2 != 0; }

std::string text_of(const answer& a, long digits) {
  const auto decimals = [digits](const ball& x) { return to_decimal(x, digits); };
  std::string result = described(a.kind) + '\n';
  result += a.injective ? "epsilon(c) is injective\n" : "epsilon(c) is not injective\n";
  result += fmt::format("epsilon0 = {}\n", decimals(a.epsilon0));
  result += a.perfect_twist ? fmt::format("c0 = {}\n", decimals(*a.perfect_twist))
                            : "c0: there is no perfect twist, since J >= 2\n";
  result += a.full_turn ? fmt::format("full turn at c = {}\n", decimals(*a.full_turn))
                        : "there is no full turn, since J >= 1\n";
  result += fmt::format("points where C meets S: {}; where it crosses epsilon = pi/2: {}\n",
                        a.intersections.str(), a.crossings.str());
  for (const meeting& m : a.meetings) {
    result += is_intersection(m) ? fmt::format("meets S at c = {}, epsilon = {}\n", decimals(m.c),
                                               decimals(m.epsilon))
                                 : fmt::format("crosses pi/2 at c = {}\n", decimals(m.c));
  }
  const integer more = a.meeting_count - integer(a.meetings.size());
  if (more > 0) result += fmt::format("and {} more, not listed (--meetings N)\n", more.str());
  if (!a.c) return result;
  result += fmt::format("epsilon(c) = {}\n", decimals(a.at_c.epsilon));
  result += fmt::format("d epsilon/dc = {}\n", decimals(a.at_c.slope));
  return result + fmt::format("{}, branch {}\n", to_text(a.at_c.motion), a.at_c.branch.str());
}

/// An integer as JSON: a number where that has room for it.
json integer_json(const integer& n) {
  constexpr long most = 1L << 53;
  if (n <= most) return static_cast<long>(n);
  return n.str();
}

std::string json_of(const answer& a, long digits) {
  const auto number = [digits](const std::optional<ball>& x) {
    return x ? to_json(*x, digits) : json(nullptr);
  };
  json result{{"kind", to_text(a.kind)},
              {"verdict", to_text(status::certified)},
              {"injective", a.injective},
              {"epsilon0", to_json(a.epsilon0, digits)},
              {"c0", number(a.perfect_twist)},
              {"full_turn", number(a.full_turn)},
              {"intersections_with_s", integer_json(a.intersections)},
              {"crossings_of_half_pi", integer_json(a.crossings)}};
  if (!a.perfect_twist) result["remark_on_c0"] = "there is no perfect twist, since J >= 2";
  if (!a.full_turn) result["remark_on_full_turn"] = "there is no full turn, since J >= 1";
  result["meetings"] = json::array();
  for (const meeting& m : a.meetings) {
    json one{{"m", integer_json(m.m)},
             {"kind", is_intersection(m) ? "intersection" : "crossing"},
             {"c", to_json(m.c, digits)},
             {"u", to_json(m.u, digits)}};
    if (is_intersection(m)) one["epsilon"] = to_json(m.epsilon, digits);
    result["meetings"].push_back(std::move(one));
  }
  if (a.c) {
    result["c"] = exact_json(*a.c, digits);
    result["regime"] = to_text(a.at_c.motion);
    result["branch"] = integer_json(a.at_c.branch);
    result["epsilon"] = to_json(a.at_c.epsilon, digits);
    result["slope"] = to_json(a.at_c.slope, digits);
  }
  return result.dump(2) + '\n';
}

exit_status run(const racket_options& options) {
  const long digits = options.digits.value();
  const bool json_wanted = options.format.value() == "json";
  const auto listed = static_cast<double>(options.meetings.value());
  const body rigid = options.which.value();
  std::optional<rational> c;
  if (options.c) {
    c = read_motion(*options.c, rigid);
    refuse_equilibrium(rigid, *c, "epsilon(c)");
  }
  constexpr double bytes_per_digit = 60;
  constexpr double bytes_kept = 20;
  options.memory_limit.check(
      {fmt::format("{} digits of epsilon0 and c0", digits),
       (bytes_per_digit +
        bytes_kept * std::min(listed, static_cast<double>(meeting_count(rigid)))) *
           static_cast<double>(digits)});
  const answer a = answer_of(options, rigid, c, digits);
  print(json_wanted ? json_of(a, digits) : text_of(a, digits));
  return exit_status::all_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<racket_options>();
  options->which.declare(app);
  app.add_option("--c", options->c,
                 "A motion, between -b and a: print epsilon(c) and d epsilon/dc, too")
      ->type_name("C");
  options->meetings.declare(app,
                            "List at most so many of the points where C meets S or crosses pi/2");
  options->digits.declare(app);
  options->format.declare(app);
  options->memory_limit.declare(app);
  return [options] { return run(*options); };
}

}  // namespace

command racket_command() {
  return {
      "racket", "Find the twists of the tennis racket effect: epsilon0, c0, epsilon(c)",
      "  polhode racket --ab 12.65,0.0629\n"
      "  polhode racket --ab 39.95,0.0629 --c -0.03 --digits 100\n"
      "  polhode racket --moments 3,2,1 --format json\n\n"
      "In one turn about the angular momentum the body's angle psi goes from -pi/2 + epsilon to\n"
      "pi/2 - epsilon. epsilon0 is the defect epsilon on the separatrix, c = 0; c0 the motion of "
      "the\n"
      "perfect twist, epsilon = 0; on the curve C of all (c, epsilon) the body stands at a turning "
      "point\n"
      "where C meets S: c = -b sin^2 epsilon. What exists, and how often, is decided exactly.\n",
      declare};
}

}  // namespace polhode::cli
