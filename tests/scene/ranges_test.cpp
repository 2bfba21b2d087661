// Effects of bodies with uncertainties: members drawn within them must have what is said of all.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "polhode/arithmetic/text.hpp"
#include "polhode/scene/effects.hpp"
#include "support/random.hpp"

namespace polhode {
namespace ranges_test {

using support::random_source;
using support::repeat;

struct drawn_body {
  std::array<rational, 3> value;
  std::array<rational, 3> sigma;
};

std::string body_text(const std::array<rational, 3>& moments,
                      const std::array<rational, 3>& sigma) {
  std::string result = "[body]\nunit = \"g cm^2\"\nmoments = [";
  for (std::size_t i = 0; i < 3; ++i) {
    result += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", to_text(moments[i]));
  }
  result += "]\n";
  if (sigma[0] == 0 && sigma[1] == 0 && sigma[2] == 0) return result;
  result += "sigma = [";
  for (std::size_t i = 0; i < 3; ++i) {
    result += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", to_text(sigma[i]));
  }
  return result + "]\n";
}

scene_report report_of(const std::string& body, const std::string& state, const std::string& want) {
  return compute(
      read_scene("digits = 12\n" + body + "[state]\n" + state +
                     "[time]\nto = 50\n[effects]\npoints = 3\nc = [\"-1/50\", \"1/50\"]\n"
                     "want = [" +
                     want + "]\n",
                 "."));
}

const std::string wanted =
    R"("regime", "period", "montgomery_phase", "mean_precession", "tennis_racket",)"
    R"( "intersections", "full_turn", "signature", "sensitivity",)"
    R"( "montgomery_curve", "twist_curve")";
/// Where the direction of J is given, too.
const std::string wanted_with_start = wanted + R"(, "flips")";

/// Three different moments in any order, a few percent uncertain or less; some exact.
drawn_body any_body(random_source& random) {
  std::array<rational, 3> sizes{rational(random.between(100, 150), 100),
                                rational(random.between(180, 230), 100),
                                rational(random.between(250, 290), 100)};
  // J is near 1, or I: what is decided by them differs among the corners.
  const bool at_limits = random.one_in(2);
  if (at_limits)
    sizes = {rational(1), rational(177, 100), rational(random.one_in(2) ? 236 : 277, 100)};
  const auto first = static_cast<std::size_t>(random.between(0, 2));
  std::swap(sizes[0], sizes[first]);
  drawn_body result{sizes, {}};
  for (rational& s : result.sigma) {
    if (random.one_in(3)) continue;
    s = rational(random.between(1, 40), at_limits || random.one_in(2) ? 1000 : 100000);
  }
  return result;
}

/// The k-th corner, k < 8, and any member else.
std::array<rational, 3> member(random_source& random, const drawn_body& of, unsigned k) {
  std::array<rational, 3> result = of.value;
  for (std::size_t i = 0; i < 3; ++i) {
    const rational part =
        k < 8 ? rational((k >> i & 1U) != 0 ? 1 : -1) : rational(random.between(-100, 100), 100);
    result[i] += part * of.sigma[i];
  }
  return result;
}

std::string any_state(random_source& random) {
  if (random.one_in(4)) {
    const long c = random.between(1, 20);
    return fmt::format("c = \"{}/1000\"\n", random.one_in(2) ? c : -c);
  }
  const bool momentum = random.one_in(2);
  std::string result =
      momentum ? "unit = \"g cm^2/s\"\nmomentum = [" : "unit = \"rad/s\"\nomega = [";
  for (int i = 0; i < 3; ++i) {
    const rational x(random.one_in(5) ? 0 : random.between(1, 900), random.one_in(3) ? 100 : 10);
    result += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", to_text(x));
  }
  return result + "]\n";
}

/// The range beside each row of a curve holds the member's number.
long compare_rows(const effect_table& ranges, const effect_table& of_member) {
  long compared = 0;
  EXPECT_EQ(ranges.columns.size(), 3U);
  for (std::size_t i = 0; i < ranges.rows.size(); ++i) {
    const auto same = std::ranges::find(of_member.first, ranges.first[i]);
    if (same == of_member.first.end()) continue;
    const auto at = static_cast<std::size_t>(same - of_member.first.begin());
    const ball& range = ranges.rows[i].at(1);
    if (range.is_undefined()) continue;
    ++compared;
    EXPECT_TRUE(overlaps(range, of_member.rows[at].at(0)))
        << ranges.columns[1] << " at c = " << to_text(ranges.first[i]) << ' ' << range;
  }
  return compared;
}

rational exactly(const effect_result& from, const std::string& name) {
  for (const effect_number& n : from.numbers) {
    if (n.name == name && n.exact) return *n.exact;
  }
  ADD_FAILURE() << name;
  return 0;
}

TEST(Ranges, HoldTheNumbersOfEveryMember) {
  random_source random(396);
  long compared = 0;
  long undecided = 0;
  long rows = 0;
  for (repeat trial(15); trial.again();) {
    const drawn_body of = any_body(random);
    const std::string state = any_state(random);
    const auto report = [&](const std::array<rational, 3>& moments,
                            const std::array<rational, 3>& sigma) -> std::optional<scene_report> {
      try {
        return report_of(body_text(moments, sigma), state,
                         state.starts_with("c") ? wanted : wanted_with_start);
      } catch (const input_error&) {  // no motion, or no angular velocity
        return std::nullopt;
      }
    };
    const auto whole = report(of.value, of.sigma);
    if (!whole) continue;
    SCOPED_TRACE(body_text(of.value, of.sigma) + state);
    for (unsigned k = 0; k < 10; ++k) {
      const std::array<rational, 3> moments = member(random, of, k);
      const auto one = report(moments, {});
      if (!one) continue;
      for (const effect_result& effect : whole->effects) {
        const effect_result& same = *one->find(effect.name);
        if (effect.table && same.table && of.sigma != std::array<rational, 3>{}) {
          rows += compare_rows(*effect.table, *same.table);
        }
        for (const char* count : {"count", "crossings"}) {  // all have the middle's, or a range
          if (effect.name != "intersections" || effect.number(count + std::string("_range"))) {
            continue;
          }
          EXPECT_EQ(exactly(effect, count), exactly(same, count)) << count;
        }
        for (const auto& [key, word] : effect.words) {
          if (word == "undecided") {
            ++undecided;
            continue;
          }
          for (const auto& [other, its] : same.words) {
            EXPECT_TRUE(other != key || its == word) << key << ' ' << body_text(moments, {});
          }
        }
        if (effect.name == "flips" && effect.number("spacing_range")) {
          EXPECT_EQ(effect.verdict, status::certified) << effect.why;
          EXPECT_TRUE(!effect.number("flip_1") || effect.number("flip_1_range"));
        }
        for (const effect_number& n : effect.numbers) {
          if (!n.is_range) continue;
          const std::string name = n.name.substr(0, n.name.rfind("_range"));
          for (const effect_number& its : same.numbers) {
            if (its.name != name) continue;
            ++compared;
            EXPECT_TRUE(its.exact ? contains(n.enclosure, *its.exact)
                                  : overlaps(n.enclosure, its.enclosure))
                << name << ' ' << n.enclosure << ' ' << body_text(moments, {});
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 80 * support::effort());
  EXPECT_GT(rows, 120 * support::effort());
  EXPECT_TRUE(support::effort() < 1 || undecided > 0);
}

/// The ranges hold the hull of the corners' numbers, and are at most half wider, or twice as wide;
/// those of derivatives five times.
void expect_close(const std::string& state, long numbers) {
  SCOPED_TRACE(state);
  const std::array<rational, 3> value{3, 2, 1};
  const std::array<rational, 3> sigma{rational(1, 100), rational(1, 100), rational(1, 100)};
  const scene_report report = report_of(body_text(value, sigma), state, wanted_with_start);
  std::map<std::string, ball> corners;
  std::map<std::string, int> occurrences;
  for (unsigned corner = 0; corner < 8; ++corner) {
    random_source unused(0);
    const std::array<rational, 3> moments = member(unused, {value, sigma}, corner);
    for (const effect_result& effect :
         report_of(body_text(moments, {}), state, wanted_with_start).effects) {
      for (const effect_number& n : effect.numbers) {
        const ball x = n.exact ? ball(*n.exact, 64) : n.enclosure;
        const std::string name = effect.name + n.name + "_range";
        ++occurrences[name];
        const auto [at, is_new] = corners.emplace(name, x);
        if (!is_new) at->second = hull(at->second, x);
      }
    }
  }
  long compared = 0;
  for (const effect_result& effect : report.effects) {
    const bool may_be_open = effect.name != "flips";  // the body may be physical or not
    EXPECT_TRUE(may_be_open || effect.verdict == status::certified) << effect.why;
    for (const effect_number& n : effect.numbers) {
      if (!n.is_range || effect.name == "intersections" || n.name == "count_range") continue;
      const std::string name = effect.name + n.name;
      if (occurrences[name] < 8) continue;  // a flip that only some have in the range of time
      ++compared;
      // Times of flips are a difference, and derivatives are sums over cells.
      const long wider = n.name.starts_with("flip_") ? 0 : n.name.starts_with('d') ? 2 : -1;
      const ball& least = corners.at(name);
      const magnitude tiny = multiply_up(least.magnitude_upper(), magnitude::power_of_two(-40));
      EXPECT_TRUE(contains(n.enclosure.enlarged(tiny), least)) << n.name;
      EXPECT_TRUE(contains(
          least.enlarged(multiply_up(least.radius(), magnitude::power_of_two(wider))), n.enclosure))
          << n.name << ' ' << n.enclosure << ' ' << least;
    }
  }
  EXPECT_GE(compared, numbers);
}

TEST(Ranges, AreCloseToThoseOfTheCorners) {
  expect_close("unit = \"rad/s\"\nomega = [0.1, 9, 3]\n", 30);
  // J on each side, and each branch, of its path: before and beyond the turning point.
  for (const char* momentum :
       {"[2, 3, 0.5]", "[2, 3, -0.5]", "[2, -3, 0.5]", "[-2, -3, -0.5]", "[0.5, 3, 2]",
        "[-0.5, 3, 2]", "[-0.5, -3, 2]", "[2, 3, 0]", "[2, 0, 0.5]", "[0, 3, 2]"}) {
    expect_close(std::string("unit = \"g cm^2/s\"\nmomentum = ") + momentum + '\n', 15);
  }
}

TEST(Ranges, AreNotGivenWhereTheMotionsDiffer) {
  const auto report = [](const char* state) {
    return report_of("[body]\nmoments = [\"3 ± 0.1\", \"2 ± 0.1\", \"1 ± 0.1\"]\n", state, wanted);
  };
  // c is near 0: on both sides of the separatrix.
  const scene_report both = report("omega = [1, 9, 1.7]\n");
  EXPECT_EQ(both.find("regime")->words.at(0).second, "undecided");
  EXPECT_EQ(both.find("period")->verdict, status::not_certified);
  EXPECT_EQ(both.find("period")->number("period_range"), nullptr);
  // c = -0.3 is a motion of bodies with b > 0.3 alone.
  const scene_report some = report("c = -0.31\n");
  EXPECT_EQ(some.find("period")->verdict, status::not_certified);
  EXPECT_EQ(some.find("period")->number("natural_period_range"), nullptr);
  // c = 0 is the separatrix of all.
  const scene_report separatrix = report("c = 0\n");
  EXPECT_EQ(separatrix.find("period")->verdict, status::certified);
  EXPECT_EQ(separatrix.find("period")->number("natural_period_range"), nullptr);
  EXPECT_NE(separatrix.find("tennis_racket")->number("epsilon_range"), nullptr);
  // About an axis there is no period of any.
  const scene_report about = report("omega = [0, 0, 1]\n");
  EXPECT_EQ(about.find("period")->verdict, status::certified);
  EXPECT_EQ(about.find("period")->number("period_range"), nullptr);
}

TEST(Ranges, AreNotGivenWhereTheAxesAreUndecided) {
  const scene_report report = report_of(
      "[body]\nmoments = [\"3 ± 0.6\", \"2 ± 0.6\", \"1 ± 0.1\"]\n", "omega = [1, 9, 3]\n", wanted);
  EXPECT_EQ(report.find("period")->verdict, status::not_certified);
  EXPECT_EQ(report.find("period")->number("period_range"), nullptr);
}

}  // namespace ranges_test
}  // namespace polhode
