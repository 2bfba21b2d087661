// The effects: what they compute, that nothing else is computed, and nothing twice.

#include "polhode/scene/effects.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "polhode/rigid_body/rotor.hpp"
#include "scene/motion.hpp"
#include "support/random.hpp"

namespace polhode {
namespace effects_test {

std::string wanting(const std::vector<std::string>& want) {
  std::string result;
  for (const std::string& name : want) result += (result.empty() ? "\"" : ", \"") + name + '"';
  return "[effects]\npoints = 4\nlisted = 3\nwant = [" + result + "]\n";
}

const std::string racket =
    "[body]\nmoments = [3, 2, 1]\n[state]\nomega = [0.1, 1, 0.3]\n[time]\nto = 20\nsamples = 5\n";

scene_report report_of(const std::string& head, const std::vector<std::string>& want) {
  return compute(read_scene(head + wanting(want), "."));
}

const ball& number(const scene_report& report, const std::string& effect, const std::string& name) {
  const ball* found = report.find(effect)->number(name);
  EXPECT_NE(found, nullptr) << effect << ' ' << name;
  static const ball none = ball::undefined(64);
  return found ? *found : none;
}

std::string word(const scene_report& report, const std::string& effect) {
  return report.find(effect)->words.at(0).second;
}

bool lies_in(const ball& x, const char* low, const char* high) {
  return certainly_less(ball(parse_rational(low), 64), x) &&
         certainly_less(x, ball(parse_rational(high), 64));
}

TEST(EffectGraph, OnlyTheClosureRunsAndEachEffectOnce) {
  std::map<std::string, work_count> alone;
  std::vector<std::string> all;
  for (const effect_description& one : all_effects()) {
    all.push_back(one.name);
    const scene_report report = report_of(racket, {one.name});
    EXPECT_EQ(report.verdict, status::certified) << one.name << ": " << report.find(one.name)->why;
    std::set<std::string> ran;
    for (const effect_result& effect : report.effects) {
      EXPECT_TRUE(ran.insert(effect.name).second) << effect.name << " twice";
    }
    // Whatever is outside the closure has no result, and so no work.
    const std::vector<std::string> closure = closure_of({one.name});
    EXPECT_EQ(ran, std::set<std::string>(closure.begin(), closure.end()));
    for (const std::string& before : one.after) EXPECT_TRUE(ran.contains(before));
    alone[one.name] = report.find(one.name)->work;
  }
  // Together: every one once, with the work it has alone, although most are needed by others.
  const scene_report together = report_of(racket, all);
  ASSERT_EQ(together.effects.size(), all.size());
  for (const effect_result& effect : together.effects)
    EXPECT_EQ(effect.work, alone.at(effect.name)) << effect.name;
  // And each pair has the work of its closure and no more.
  for (const std::string& second : all) {
    const scene_report pair = report_of(racket, {"mean_precession", second});
    EXPECT_EQ(pair.effects.size(), closure_of({"mean_precession", second}).size());
    for (const effect_result& effect : pair.effects) EXPECT_EQ(effect.work, alone.at(effect.name));
  }
}

TEST(EffectGraph, CountsAreThoseOfTheWork) {
  const scene_report report = report_of(racket, {"mean_precession", "tennis_racket", "momentum"});
  EXPECT_EQ(report.find("mean_precession")->work, work_count{});  // a quotient of two results
  EXPECT_EQ(report.find("period")->work.integrals, 1);
  EXPECT_GT(report.find("period")->work.agm_steps, 3);
  EXPECT_EQ(report.find("montgomery_phase")->work.integrals, 1);
  EXPECT_GT(report.find("tennis_racket")->work.newton_steps, 3);
  // Of a series in time: the mean for 2K, the one for the other period, the pole and the start,
  // each at two precisions, whatever the number of samples; the audit has the same at its own.
  EXPECT_EQ(report.find("momentum")->work, (work_count{8, 0, 0}));
  const std::string more = racket + "[effects]\nwant = [\"attitude\"]\n";
  scene many = read_scene(more, ".");
  many.time->samples = 1000;
  EXPECT_EQ(compute(many).find("attitude")->work, (work_count{8, 0, 0}));
  // Nothing is integrated where the motion is steady.
  const std::string steady =
      "[body]\nmoments = [3, 2, 1]\n[state]\nomega = [0, 1, 0]\n[time]\nto = 20\nsamples = 5\n";
  EXPECT_EQ(report_of(steady, {"attitude"}).find("attitude")->work, work_count{});
}

// No input is known that makes a series so wide: the rotor computes again with more bits.
TEST(Effects, ATooWideSampleIsNotCertified) {
  const auto table_with = [](const ball& x) {
    effect_result result;
    effect_table table;
    table.columns = {"t", "j", "omega"};
    table.digits = 20;
    table.first = {0, 1};
    table.rows = {{ball(1, 100), ball(1, 100)}, {ball(0, 100), x}};
    result.table = table;
    return result;
  };
  const std::vector<magnitude> scales{magnitude::from_integer_up(1), magnitude::from_integer_up(8)};
  const auto width = [](long power) { return magnitude::power_of_two(power); };
  const auto bits = static_cast<long>(bits_for_digits(20));
  const auto checked = [&](effect_result result) {
    detail::check_rows(result, {.from = 0, .to = 1, .samples = 2}, scales);
    return result;
  };
  // 8 2^(1 - bits) is allowed of omega, and no more.
  EXPECT_EQ(checked(table_with(ball(0, 100).enlarged(width(4 - bits)))).verdict, status::certified);
  const effect_result wide = checked(table_with(ball(0, 100).enlarged(width(5 - bits))));
  EXPECT_EQ(wide.verdict, status::not_certified);
  EXPECT_EQ(wide.why, "omega at sample 2 has fewer digits than asked for");
  // Of its own size, where that is more than the column's.
  EXPECT_EQ(checked(table_with(ball(64, 100).enlarged(width(7 - bits)))).verdict,
            status::certified);
  EXPECT_EQ(checked(table_with(ball(64, 100).enlarged(width(8 - bits)))).verdict,
            status::not_certified);
  EXPECT_EQ(checked(table_with(ball::undefined(100))).verdict, status::not_certified);
  effect_result doubles = table_with(ball::undefined(100));
  doubles.table->certified = false;
  EXPECT_EQ(checked(doubles).verdict, status::certified);
  // A row for each time, and no other.
  const effect_result good = table_with(ball(0, 100));
  effect_result bad = good;
  bad.table->rows.pop_back();
  EXPECT_THROW(checked(bad), std::logic_error);
  bad = good;
  bad.table->rows[1].pop_back();
  EXPECT_THROW(checked(bad), std::logic_error);
  bad = good;
  bad.table->first[1] = rational(1, 2);
  EXPECT_THROW(checked(bad), std::logic_error);
  bad = good;
  bad.table->first.emplace_back(2);
  bad.table->rows.push_back(bad.table->rows[0]);
  EXPECT_THROW(checked(bad), std::logic_error);
}

TEST(Effects, AgreeWithTheirRooms) {
  const scene_report report = report_of("[body]\nab = [12.65, 0.0629]\n[state]\nc = -0.03\n",
                                        {"montgomery_phase", "period", "tennis_racket"});
  const body rigid(parse_rational("12.65"), parse_rational("0.0629"));
  const rational c = parse_rational("-0.03");
  EXPECT_TRUE(
      overlaps(number(report, "montgomery_phase", "phase"), montgomery_phase(rigid, c, 200)));
  EXPECT_TRUE(
      overlaps(number(report, "montgomery_phase", "geometric"), geometric_phase(rigid, c, 200)));
  EXPECT_TRUE(overlaps(number(report, "period", "natural_period"), rotation_period(rigid, c, 200)));
  EXPECT_TRUE(lies_in(number(report, "tennis_racket", "epsilon0"), "0.113594382341433383",
                      "0.113594382341433384"));
}

TEST(Effects, ConstantsOfAnIrrationalTensor) {
  // The principal moments 4 and (5 +- sqrt 5)/2, of which the triple product is 20, and 5 and (5 +-
  // sqrt 5)/2, planar.
  const scene_report report = report_of(
      "digits = 200\n[body]\ntensor = [[2, 1, 0], [1, 3, 0], [0, 0, 4]]\n", {"inertial_defect"});
  EXPECT_EQ(report.verdict, status::certified);
  const precision p = 1000;
  const ball root = sqrt(ball(5, p));
  const ball x(4, p);
  const ball y = scale(5 + root, -1);
  const ball z = scale(5 - root, -1);
  EXPECT_TRUE(certainly_less(y, x));
  EXPECT_TRUE(overlaps(number(report, "inertial_defect", "a"), (y - z) / z));
  EXPECT_TRUE(overlaps(number(report, "inertial_defect", "b"), (x - y) / x));
  EXPECT_TRUE(overlaps(number(report, "inertial_defect", "I"), sqrt(y * z / ((x - y) * (x - z)))));
  EXPECT_TRUE(
      overlaps(number(report, "inertial_defect", "J"), sqrt(x * y / ((y - z) * (x - z))) - 1));
  const scene_report planar = report_of("[body]\ntensor = [[2, 1, 0], [1, 3, 0], [0, 0, 5]]\n",
                                        {"inertial_defect", "planarity"});
  EXPECT_EQ(planar.verdict, status::certified);
  EXPECT_EQ(planar.find("inertial_defect")->numbers[2].exact, rational(1));
  // A margin that rounding leaves is named, and does not make the body planar.
  const auto remarks_with = [](const char* greatest) {
    return report_of(
               std::string("[body]\nunit = \"kg m^2\"\nmoments = [\"") + greatest + "\", 2, 1]\n",
               {"planarity"})
        .find("planarity")
        ->remarks;
  };
  EXPECT_EQ(remarks_with("3").size(), 1U);
  EXPECT_EQ(remarks_with("2.9999").size(), 1U);
  ASSERT_EQ(remarks_with("2.9999999999999999").size(), 2U);
  EXPECT_NE(remarks_with("2.9999999999999999")[0].find("planar but for 1e-16"), std::string::npos)
      << remarks_with("2.9999999999999999")[0];
  EXPECT_NE(remarks_with("3.0000000000000001")[0].find("planar but for -1e-16"), std::string::npos);
}

TEST(Effects, PeriodIsInTheUnitsOfTheState) {
  const auto period = [](const std::string& state) {
    return number(
        report_of("[body]\nmoments = [3, 2, 1]\nunit = \"kg m^2\"\n[state]\n" + state + "\n",
                  {"period"}),
        "period", "period");
  };
  const ball by_second = period("omega = [1, 2, 4]\nunit = \"rad/s\"");
  EXPECT_TRUE(overlaps(by_second / 60, period("omega = [60, 120, 240]\nunit = \"rad/min\"")));
  EXPECT_TRUE(
      overlaps(by_second / 86400, period("omega = [86400, 172800, 345600]\nunit = \"rad/day\"")));
  // rev/s is 2 pi rad/s; the momentum of (1, 2, 4) rad/s is (3, 4, 4) kg m^2/s.
  EXPECT_TRUE(overlaps(by_second, 2 * pi(200) * period("omega = [1, 2, 4]\nunit = \"rev/s\"")));
  EXPECT_TRUE(
      overlaps(by_second / 60, 2 * pi(200) * period("omega = [1, 2, 4]\nunit = \"rpm\"") / 60));
  EXPECT_TRUE(overlaps(by_second, period("momentum = [3, 4, 4]\nunit = \"kg m^2/s\"")));
  EXPECT_TRUE(overlaps(by_second, period("momentum = [3e7, 4e7, 4e7]\nunit = \"g cm^2/s\"")));
}

TEST(Effects, RegimesWithoutAPeriod) {
  const auto report = [](const std::string& state) {
    return report_of("[body]\nmoments = [3, 2, 1]\n[state]\n" + state + "\n",
                     {"montgomery_phase", "mean_precession", "sensitivity", "flips", "audit"});
  };
  for (const char* state : {"omega = [0, 1, 0]", "omega = [0, 0, -1]", "omega = [1, 0, 0]",
                            "omega = [1, 0, 1.7320508075688772]"}) {
    const scene_report r = report(state);
    EXPECT_EQ(r.verdict, status::certified) << state;
    if (std::string(state).size() < 25) {
      EXPECT_EQ(r.find("montgomery_phase")->number("phase"), nullptr);
      EXPECT_EQ(word(r, "flips"), "never");
    }
  }
  // J^2/(2H) = I_y: ((3 x)^2 + z^2)/(3 x^2 + z^2) = 2 is 3 x^2 = z^2; x = 3, z = 3: none; with
  // moments 6, 5, 2: x = 1, z = 1 is.
  const scene_report on =
      report_of("[body]\nmoments = [6, 5, 2]\n[state]\nomega = [1, -1, 1]\n", {"regime", "flips"});
  EXPECT_EQ(word(on, "regime"), "separatrix");
  EXPECT_NE(on.find("flips"), nullptr);
  // The body turned about its axes has its own rates.
  EXPECT_TRUE(overlaps(number(report("omega = [0, 0, -5]"), "mean_precession", "middle_axis"),
                       ball(5, 64)));
  EXPECT_TRUE(
      overlaps(number(report("omega = [5, 0, 0]"), "mean_precession", "least_axis"), ball(5, 64)));
  EXPECT_TRUE(
      overlaps(number(report("omega = [0, 5, 0]"), "mean_precession", "least_axis"), ball(5, 64)));
}

// Feynman's plate: a disc thrown flat wobbles at twice the rate of its spin. Rates of the axes
// about J against those of a symmetric top, to the first order of what the body differs from it: a
// disc, and a rod spun about its length; and the two regimes against each other, where the axes
// change places.
TEST(Effects, MeanRatesOfTheAxes) {
  const auto rates = [](const std::string& moments, const std::string& omega) {
    const scene_report r =
        report_of("[body]\nmoments = " + moments + "\n[state]\nomega = " + omega + "\n",
                  {"mean_precession", "period"});
    EXPECT_EQ(r.verdict, status::certified);
    return r;
  };
  const auto lies = [](const scene_report& r, const char* name, const char* low, const char* high) {
    EXPECT_TRUE(lies_in(number(r, "mean_precession", name), low, high)) << name;
  };
  const scene_report plate = rates("[2, 1.0001, 1]", "[1, 0.01, 0]");
  lies(plate, "wobble", "1.999", "2.001");
  lies(plate, "greatest_axis", "1.999", "2.001");
  lies(plate, "middle_axis", "0.999", "1.001");
  lies(plate, "least_axis", "0.999", "1.001");
  lies(plate, "wobble_period", "3.140", "3.144");
  const scene_report rod = rates("[10, 9.999, 1]", "[0, 0.01, 1]");
  lies(rod, "wobble", "0.0999", "0.1101");
  lies(rod, "least_axis", "0.0999", "0.1101");
  lies(rod, "middle_axis", "0.999", "1.02");
  lies(rod, "greatest_axis", "0.999", "1.02");
  // The axis around which J goes, and another one, differ by a turn in a period.
  for (const scene_report* r : {&plate, &rod}) {
    const ball turn = 2 * pi(200) / number(*r, "period", "period");
    const bool is_plate = r == &plate;
    const ball around = number(*r, "mean_precession", "wobble");
    const ball other = number(*r, "mean_precession", "middle_axis");
    EXPECT_TRUE(overlaps(is_plate ? around - other : other - around, turn));
  }
}

// At a flip J_y is 0, and of different signs beside it: by the closed form, which shares nothing
// with flips but Euler's equations.
void expect_flips(const triple<rational>& moments, const triple<rational>& omega) {
  const auto listed = [](const triple<rational>& v) {
    return "[\"" + to_text(v[0]) + "\", \"" + to_text(v[1]) + "\", \"" + to_text(v[2]) + "\"]";
  };
  const scene_report report = report_of(
      "[body]\nmoments = " + listed(moments) + "\n[state]\nomega = " + listed(omega) + "\n",
      {"flips"});
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t k) { return moments[i] > moments[k]; });
  const rotor<ball> turning(initial_state::from_angular_velocity(moments, omega), 100);
  int flips = 0;
  for (const effect_number& n : report.find("flips")->numbers) {
    if (n.name.rfind("flip_", 0) != 0) continue;
    ++flips;
    const rational t = n.exact ? *n.exact : lower_rational(n.enclosure.middle());
    const auto y = [&](const rational& time) { return turning.sample(time).momentum[order[1]]; };
    const rational beside(1, 1'000'000);
    const ball before = y(t - beside);
    const ball after = y(t + beside);
    EXPECT_TRUE((certainly_negative(before) && certainly_positive(after)) ||
                (certainly_positive(before) && certainly_negative(after)))
        << listed(omega) << " at " << to_text(t);
    EXPECT_GE(t, 0);
    // None is left out before the first: J_y keeps its sign.
    if (flips == 1 && t > 0 && omega[order[1]] != 0) {
      for (int k = 0; k < 20; ++k) {
        const ball there = y(t * k / 20);
        EXPECT_TRUE(omega[order[1]] > 0 ? certainly_positive(there) : certainly_negative(there))
            << listed(omega);
      }
    }
  }
  const bool separatrix = word(report, "regime") == "separatrix";
  EXPECT_TRUE(separatrix ? flips <= 1 : flips == 3) << flips;
}

TEST(Flips, AreWhereTheIntermediateComponentVanishes) {
  for (const int x : {-1, 1}) {
    for (const int y : {-2, 0, 2}) {
      for (const int z : {-1, 1}) {
        expect_flips({3, 2, 1}, {rational(x), rational(y), rational(z, 3)});   // oscillating
        expect_flips({3, 2, 1}, {rational(x, 10), rational(y), rational(z)});  // rotating
        expect_flips({1, 3, 2},
                     {rational(x, 2), rational(z), rational(y)});  // in other orders of the axes
        expect_flips({2, 1, 3}, {rational(y), rational(x), rational(z, 7)});
        expect_flips({6, 5, 2}, {rational(x), rational(y), rational(z)});  // on the separatrix
      }
    }
  }
  expect_flips({3, 2, 1}, {rational(1, 10), 1, 0});
  expect_flips({3, 2, 1}, {0, 1, rational(1, 10)});
  expect_flips({3, 2, 1}, {0, -1, rational(1, 1'000'000)});
}

TEST(Flips, WithinATime) {
  const auto flips = [](const std::string& time) {
    return report_of("[body]\nmoments = [3, 2, 1]\n[state]\nomega = [1, 0, 0.3]\n[time]\n" + time +
                         "\nsamples = 3\n",
                     {"flips"});
  };
  // From time 0, where J_y is 0 exactly, every half period.
  const scene_report first = flips("to = 10");
  EXPECT_EQ(*first.find("flips")->numbers.at(0).exact,
            1 + static_cast<long>(lower_rational(floor(10 / number(first, "flips", "spacing")))));
  EXPECT_EQ(first.find("flips")->numbers.at(2).name, "flip_1");
  EXPECT_EQ(*first.find("flips")->numbers.at(2).exact, 0);
  const scene_report later = flips("from = 1\nto = 10");
  EXPECT_EQ(*later.find("flips")->numbers.at(0).exact,
            *first.find("flips")->numbers.at(0).exact - 1);
  EXPECT_EQ(*flips("from = 0.1\nto = 0.2").find("flips")->numbers.at(0).exact, 0);
}

TEST(Sensitivity, IsTheSlope) {
  // Between the difference quotients of two neighbours, as T and the phase are convex or concave
  // between them: here by the mean value theorem over a ball of motions, with the exact difference.
  for (const std::string c : {"-0.2", "-0.001", "0.003", "0.7"}) {
    const auto at = [&](const rational& a, const rational& b, const rational& motion) {
      return std::pair{rotation_period(body(a, b), motion, 300),
                       montgomery_phase(body(a, b), motion, 300)};
    };
    const rational a(3, 2);
    const rational b(1, 4);
    const rational motion = parse_rational(c);
    const scene_report report =
        report_of("[body]\nab = [1.5, 0.25]\n[state]\nc = " + c + "\n", {"sensitivity"});
    const rational h = parse_rational("1e-20");
    const auto compare = [&](const std::string& by, const auto& high, const auto& low) {
      // The central quotient is off by h^2/6 of the third derivative: of the order of 1e-40 here,
      // far below 1e-24.
      const ball margin =
          hull(ball(parse_rational("-1e-24"), 300), ball(parse_rational("1e-24"), 300));
      EXPECT_TRUE(overlaps((high.first - low.first) / (2 * h) + margin,
                           number(report, "sensitivity", "dT_d" + by)))
          << by << c;
      EXPECT_TRUE(overlaps((high.second - low.second) / (2 * h) + margin,
                           number(report, "sensitivity", "dphase_d" + by)))
          << by << c;
    };
    compare("a", at(a + h, b, motion), at(a - h, b, motion));
    compare("b", at(a, b + h, motion), at(a, b - h, motion));
    compare("c", at(a, b, motion + h), at(a, b, motion - h));
  }
}

TEST(Sensitivity, InTheMoments) {
  // A tenth of a part in 10^20 on each moment, at fixed momentum.
  const auto period = [](const triple<rational>& m) {
    const scene_report r =
        report_of("digits = 60\n[body]\nmoments = [\"" + to_text(m[0]) + "\", \"" + to_text(m[1]) +
                      "\", \"" + to_text(m[2]) + "\"]\n[state]\nmomentum = [1, 2, 2]\n",
                  {"period", "montgomery_phase"});
    return std::pair{number(r, "period", "period"), number(r, "montgomery_phase", "phase")};
  };
  const scene_report report =
      report_of("[body]\nmoments = [3, 2, 1]\n[state]\nmomentum = [1, 2, 2]\n", {"sensitivity"});
  const triple<rational> moments{3, 2, 1};
  const rational h = parse_rational("1e-20");
  const auto middle = period(moments);
  for (std::size_t i = 0; i < 3; ++i) {
    triple<rational> high = moments;
    triple<rational> low = moments;
    high[i] *= 1 + h;
    low[i] *= 1 - h;
    const auto up = period(high);
    const auto down = period(low);
    const ball margin =
        hull(ball(parse_rational("-1e-24"), 300), ball(parse_rational("1e-24"), 300));
    const std::string axis(1, static_cast<char>('x' + i));
    EXPECT_TRUE(overlaps((up.first - down.first) / (2 * h * middle.first) + margin,
                         number(report, "sensitivity", "dlogT_dlogI" + axis)));
    EXPECT_TRUE(overlaps((up.second - down.second) / (2 * h) + margin,
                         number(report, "sensitivity", "dphase_dlogI" + axis)));
  }
}

// A box turned by 45 degrees has the moments 3, 2, 3/2 about axes along (1, 1, 0), (1, -1, 0) and
// z; one turned by a little more or less has irrational moments beside them, and nearly the same
// motion.
TEST(Effects, OfATurnedBox) {
  const auto of = [](const std::string& xx) {
    return report_of("[body]\ntensor = [[\"" + xx +
                         "\", 0.5, 0], [0.5, 2.5, 0], [0, 0, 1.5]]\n[state]\nomega = [1, 0, 0.3]\n"
                         "[time]\nto = 20\nsamples = 3\n",
                     {"planarity", "signature", "regime", "period", "montgomery_phase",
                      "mean_precession", "sensitivity", "flips", "momentum", "attitude", "audit",
                      "tennis_racket", "intersections"});
  };
  const scene_report box = of("2.5");
  EXPECT_EQ(box.verdict, status::certified);
  const rational square(rational(9, 2) + rational(4, 2) + rational(81, 400));
  const rational c(2 * (rational(3, 2) + rational(2, 2) + rational(27, 200)) / square - 1);
  EXPECT_EQ(box.find("regime")->numbers[0].exact, c);
  const body rigid(rational(1, 3), rational(1, 3));
  EXPECT_TRUE(overlaps(number(box, "montgomery_phase", "phase"), montgomery_phase(rigid, c, 200)));
  const scene_report beside = of("2.5" + std::string(40, '0') + "1");
  EXPECT_EQ(beside.verdict, status::certified);
  EXPECT_EQ(beside.find("audit")->words, box.find("audit")->words);
  const ball apart(parse_rational("1e-35"), 64);
  std::size_t compared = 0;
  for (const effect_result& effect : box.effects) {
    if (effect.name == "audit") continue;
    const effect_result& other = *beside.find(effect.name);
    ASSERT_EQ(effect.numbers.size(), other.numbers.size());
    for (const effect_number& n : effect.numbers) {
      const auto value = [](const effect_number& x) {
        return x.exact ? ball(*x.exact, 200) : x.enclosure;
      };
      const auto same = std::find_if(other.numbers.begin(), other.numbers.end(),
                                     [&](const effect_number& x) { return x.name == n.name; });
      ASSERT_NE(same, other.numbers.end()) << n.name;
      EXPECT_TRUE(certainly_less(abs(value(n) - value(*same)), apart))
          << effect.name << " " << n.name;
      ++compared;
    }
    if (!effect.table) continue;
    for (std::size_t i = 0; i < effect.table->rows.size(); ++i) {
      for (std::size_t k = 0; k < effect.table->rows[i].size(); ++k) {
        EXPECT_TRUE(certainly_less(abs(effect.table->rows[i][k] - other.table->rows[i][k]), apart))
            << effect.name << " " << i << " " << k;
      }
    }
  }
  EXPECT_GT(compared, 40U);
}

// One attitude in every form that a scene takes: a turn by 2 atan(1/2) about z and one by 90
// degrees about x.
TEST(Series, TakeTheAttitudeInEveryForm) {
  const auto attitude = [](const std::string& keys) {
    const scene_report report =
        report_of("[body]\nmoments = [3, 2, 1.5]\n[state]\nomega = [1, 2, 3]\n" + keys +
                      "\n[time]\nto = 1\nsamples = 2\n",
                  {"attitude"});
    EXPECT_EQ(report.verdict, status::certified) << keys;
    return report.find("attitude")->table->rows;
  };
  const auto expect_same = [](const std::vector<std::vector<ball>>& x,
                              const std::vector<std::vector<ball>>& y, const std::string& what) {
    for (std::size_t row = 0; row < 2; ++row) {
      ball product(0, 128);  // of unit quaternions: 1 or -1 where they are one attitude
      for (std::size_t k = 0; k < 4; ++k) product += x[row][k] * y[row][k];
      EXPECT_TRUE(certainly_less(ball(parse_rational("0.9999999999999999999"), 128), abs(product)))
          << what;
    }
  };
  const auto about_z = attitude("quaternion = [2, 0, 0, 1]");
  for (const char* other :
       {"quaternion_xyzw = [0, 0, 1, 2]", "mrp = [0, 0, \"0.2360679774997896964091736687\"]",
        "matrix = [[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]]",
        "matrix = [[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]]\nproject = true",
        "euler = [\"0.92729521800161223242851246292\", 0, 0]\neuler_unit = \"rad\"\n"
        "euler_sequence = \"321\"",
        "euler = [0, 0, \"0.92729521800161223242851246292\"]\neuler_unit = \"rad\""}) {
    expect_same(about_z, attitude(other), other);
  }
  // Yaw, then roll.
  expect_same(attitude("matrix = [[0.6, 0, 0.8], [0.8, 0, -0.6], [0, 1, 0]]"),
              attitude("euler = [\"0.92729521800161223242851246292\", 0, "
                       "\"1.57079632679489661923132169164\"]\neuler_unit = \"rad\"\n"
                       "euler_sequence = \"zyx\""),
              "zyx");
  const scene_report rounded = report_of(
      "[body]\nmoments = [3, 2, 1.5]\n[state]\nomega = [1, 2, 3]\nmatrix = [[0.7071, -0.7071, 0], "
      "[0.7072, 0.7071, 0], [0, 0, 1]]\nproject = true\n[time]\nto = 1\nsamples = 2\n",
      {"attitude"});
  EXPECT_EQ(rounded.verdict, status::certified);
}

TEST(Series, BeginWithTheStateAndKeepTheMomentum) {
  // In degrees, so that the rotor's time is irrational; in axes that are not principal; from a
  // turned attitude.
  const scene_report report = report_of(
      "[body]\ntensor = [[26, 4, -10], [4, 38, -14], [-10, -14, 35]]\n[state]\nomega = [1, 2, "
      "-3]\nunit = \"deg/s\"\nquaternion = [1, 2, 3, 4]\n"
      "[time]\nto = 1000\nsamples = 4\n",
      {"momentum", "attitude"});
  const effect_table& momentum = *report.find("momentum")->table;
  const effect_table& attitude = *report.find("attitude")->table;
  const precision p = 128;
  for (std::size_t i = 0; i < 3; ++i) {  // omega in rad per second
    const rational omega = std::array<rational, 3>{1, 2, -3}[i];
    EXPECT_TRUE(overlaps(momentum.rows[0][3 + i], pi(p) * omega / 180));
  }
  EXPECT_TRUE(overlaps(square(attitude.rows[0][0]) * 30, ball(1, p)));
  EXPECT_TRUE(overlaps(square(attitude.rows[0][3]) * 30, ball(16, p)));
  // R j stays: R by the quaternion.
  const auto in_space = [&](std::size_t row) {
    const auto& q = attitude.rows[row];
    const auto& j = momentum.rows[row];
    const ball& w = q[0];
    const std::array<ball, 3> v{q[1], q[2], q[3]};
    const auto cross = [](const std::array<ball, 3>& x, const std::array<ball, 3>& y) {
      return std::array<ball, 3>{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2],
                                 x[0] * y[1] - x[1] * y[0]};
    };
    const std::array<ball, 3> once = cross(v, {j[0], j[1], j[2]});
    const std::array<ball, 3> twice = cross(v, once);
    return std::array<ball, 3>{j[0] + 2 * (w * once[0] + twice[0]),
                               j[1] + 2 * (w * once[1] + twice[1]),
                               j[2] + 2 * (w * once[2] + twice[2])};
  };
  const auto begin = in_space(0);
  for (std::size_t row = 1; row < 4; ++row) {
    const auto here = in_space(row);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(overlaps(begin[i], here[i])) << row;
      EXPECT_TRUE(certainly_less(abs(here[i] - begin[i]), ball(parse_rational("1e-25"), p)));
    }
  }
  // Not the same all the time.
  EXPECT_FALSE(overlaps(momentum.rows[0][0], momentum.rows[1][0]));
}

TEST(Series, BeginExactly) {
  const scene_report moving = report_of(
      "[body]\nmoments = [4, 3, 2]\n[state]\nomega = [3, 12, 0.5]\nquaternion = [0, 2, 1, 2]\n"
      "[time]\nto = 1\nsamples = 3\n",
      {"momentum", "attitude"});
  const auto& omega = moving.find("momentum")->table->rows;
  EXPECT_TRUE(omega[0][3].is_exact());
  EXPECT_TRUE(contains(omega[0][3], rational(3)));
  EXPECT_TRUE(omega[0][4].is_exact());
  EXPECT_TRUE(contains(omega[0][4], rational(12)));
  EXPECT_TRUE(contains(omega[0][5], rational(1, 2)));
  EXPECT_FALSE(contains(omega[1][3], rational(3)));  // it moves
  const scene_report untold = report_of(racket, {"attitude"});
  const auto& plain = untold.find("attitude")->table->rows;
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_TRUE(plain[0][k].is_exact()) << k;
    EXPECT_TRUE(contains(plain[0][k], rational(k == 0 ? 1 : 0))) << k;
  }
  EXPECT_FALSE(contains(plain[1][4], rational(0)));
}

/// The exact cells of the first row of an effect's table; nothing for the others.
std::vector<std::optional<rational>> exact_start(const std::string& state, const char* effect) {
  const scene_report report = report_of(
      "[body]\nmoments = [3, 2, 1]\n[state]\n" + state + "\n[time]\nto = 1\nsamples = 3\n",
      {effect});
  const effect_table& table = *report.find(effect)->table;
  std::vector<std::optional<rational>> result(table.rows[0].size());
  for (const auto& [cell, value] : table.exact) {
    const auto& [row, column] = cell;
    EXPECT_TRUE(contains(table.rows[row][column], value)) << row << ' ' << column;
    if (row == 0) result[column] = value;
    EXPECT_EQ(row, 0U);
  }
  return result;
}

using exact_row = std::vector<std::optional<rational>>;
const std::optional<rational> irrational;

TEST(Series, BeginExactlyAtRationalNumbersThatAreNotDyadic) {
  EXPECT_EQ(exact_start("omega = [\"1/3\", \"2/7\", 0.1]\nunit = \"rad/s\"", "momentum"),
            (exact_row{irrational, irrational, irrational, rational(1, 3), rational(2, 7),
                       rational(1, 10)}));
  // J = (1, 2, 2): its size is 3. In degrees the angular velocity has a factor pi.
  EXPECT_EQ(exact_start("omega = [\"1/3\", 1, 2]\nunit = \"deg/s\"", "momentum"),
            (exact_row{rational(1, 3), rational(2, 3), rational(2, 3), irrational, irrational,
                       irrational}));
  EXPECT_EQ(exact_start("omega = [\"1/3\", 0, 2]\nunit = \"deg/s\"", "momentum"),
            (exact_row{irrational, rational(0), irrational, irrational, rational(0), irrational}));
}

TEST(Series, BeginExactlyAtGivenMatricesAndAngles) {
  const rational half(1, 2);
  const rational none(0);
  const auto start = [](const std::string& attitude) {
    return exact_start("omega = [0.1, 9, 0.2]\nunit = \"rad/s\"\n" + attitude, "attitude");
  };
  // A half turn about (1, 2, 2).
  EXPECT_EQ(start("matrix = [[\"-7/9\", \"4/9\", \"4/9\"], [\"4/9\", \"-1/9\", \"8/9\"],"
                  " [\"4/9\", \"8/9\", \"-1/9\"]]"),
            (exact_row{none, rational(1, 3), rational(2, 3), rational(2, 3), none}));
  // cos(a/2)^2 = 4/5.
  EXPECT_EQ(start("matrix = [[\"3/5\", \"-4/5\", 0], [\"4/5\", \"3/5\", 0], [0, 0, 1]]"),
            (exact_row{irrational, none, none, irrational, none}));
  EXPECT_EQ(start("quaternion = [1, 1, 1, 1]"), (exact_row{half, half, half, half, none}));
  EXPECT_EQ(start("quaternion = [1, 2, 0, 0]"),
            (exact_row{irrational, irrational, none, none, none}));
  const auto angles = [&](const std::string& three, const char* unit = "deg") {
    return start("euler = [" + three + "]\neuler_unit = \"" + unit + '"');
  };
  EXPECT_EQ(angles("90, 90, 0"), (exact_row{half, half, half, half, none}));
  EXPECT_EQ(angles("90, 0, 0"), (exact_row{irrational, none, none, irrational, none}));
  EXPECT_EQ(angles("90, 60, 30"),
            (exact_row{irrational, irrational, rational(1, 4), rational(3, 4), none}));
  EXPECT_EQ(angles("120, 0, 0"), (exact_row{half, none, none, irrational, none}));
  EXPECT_EQ(angles("0, 1, 0", "rad"), (exact_row{irrational, irrational, none, none, none}));
  EXPECT_EQ(angles("120, 0, 0", "rad"), (exact_row{irrational, none, none, irrational, none}));
  EXPECT_EQ(angles("1, 0, -1", "rad"), (exact_row{rational(1), none, none, none, none}));
}

/// q or -q, whichever has its first component that is known, and not 0, above 0.
exact_row of_first_sign(exact_row q) {
  int sign = 0;
  for (std::optional<rational>& one : q) {
    if (!one) continue;
    if (sign == 0) sign = one->sign();
    if (sign < 0) *one = -*one;
  }
  return q;
}

/// The same rotation as a quaternion and as a matrix begins with the same numbers, to the sign of
/// all.
TEST(Series, BeginAlikeHoweverTheAttitudeIsGiven) {
  support::random_source random(41);
  for (support::repeat trial(30); trial.again();) {
    std::array<long, 4> q{};
    for (long& one : q) one = random.between(-4, 4);
    const auto [w, x, y, z] = q;
    const long square = w * w + x * x + y * y + z * z;
    if (square == 0) continue;
    const auto entry = [&](long n) { return '"' + to_text(rational(n, square)) + '"'; };
    const auto row = [&](long a, long b, long c) {
      return '[' + entry(a) + ", " + entry(b) + ", " + entry(c) + ']';
    };
    const std::string turn = "omega = [0.1, 9, 0.2]\nunit = \"rad/s\"\n";
    const exact_row given =
        exact_start(turn + fmt::format("quaternion = [{}, {}, {}, {}]", w, x, y, z), "attitude");
    const exact_row by_matrix = exact_start(
        turn + "matrix = [" +
            row(w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)) + ", " +
            row(2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)) + ", " +
            row(2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z) + ']',
        "attitude");
    EXPECT_EQ(of_first_sign(given), of_first_sign(by_matrix))
        << w << ' ' << x << ' ' << y << ' ' << z;
    for (std::size_t k = 0; k < 4; ++k) {
      if (given[k]) {
        EXPECT_EQ(*given[k] * *given[k], rational(q[k] * q[k], square));
      }
      if (q[k] == 0) {
        EXPECT_EQ(given[k], rational(0));
      }
    }
  }
}

TEST(Series, SteadyMotionsAreExactAtAllTimes) {
  for (const char* unit : {"rad/s", "deg/s"}) {
    const scene_report report = report_of(
        std::string("[body]\nmoments = [3, 2, 1]\n[state]\nomega = [0, 12, 0]\nunit = \"") + unit +
            "\"\n[time]\nto = 10\nsamples = 4\n",
        {"momentum"});
    for (const std::vector<ball>& row : report.find("momentum")->table->rows) {
      for (const std::size_t k : {0U, 1U, 2U, 3U, 5U}) {
        EXPECT_TRUE(row[k].is_exact()) << unit << ' ' << k;
        EXPECT_TRUE(contains(row[k], rational(k == 1 ? 1 : 0))) << unit << ' ' << k;
      }
      EXPECT_EQ(row[4].is_exact(), std::string(unit) == "rad/s");
      const ball size(12, 256);
      EXPECT_TRUE(overlaps(row[4], std::string(unit) == "rad/s" ? size : pi(256) * size / 180));
    }
  }
}

/// Angles in degrees bring pi into the time: of a body that turns by 1e300 radians between two
/// samples it takes a thousand bits.
TEST(Series, OfAFastBodyHaveTheirDigits) {
  for (const char* speed : {"1e20", "1e60", "1e300"}) {
    SCOPED_TRACE(speed);
    const scene_report report = report_of(
        "digits = 20\n[body]\nmoments = [3, 2, 1]\n[state]\nomega = [\"" + std::string(speed) +
            "\", 1, 2]\nunit = \"deg/s\"\n[time]\nto = 1\nsamples = 3\n",
        {"momentum", "attitude"});
    ASSERT_EQ(report.verdict, status::certified);
    for (const char* name : {"momentum", "attitude"}) {
      for (const std::vector<ball>& row : report.find(name)->table->rows) {
        for (std::size_t k = 0; k < 3; ++k) {
          ASSERT_TRUE(row[k].is_bounded());
          ASSERT_LE(row[k].radius(), magnitude::power_of_two(-67));  // 10^-20
        }
      }
    }
  }
}

/// Near the axis of a needle the two routes to the slope lose half of all digits.
TEST(Audit, RaisesThePrecisionBeforeItBlamesALaw) {
  for (const char* least : {"1e-42", "1e-44", "1e-100"}) {
    SCOPED_TRACE(least);
    const scene_report report =
        report_of("digits = 10\n[body]\nmoments = [3, 2, \"" + std::string(least) +
                      "\"]\n[state]\nmomentum = [1, 1, 1]\n",
                  {"audit"});
    EXPECT_EQ(report.verdict, status::certified);
    EXPECT_EQ(word(report, "audit"), "yes");
  }
}

TEST(Series, OfASymmetricTop) {
  const scene_report report = report_of(
      "[body]\nmoments = [2, 2, 1]\n[state]\nomega = [0, 1, 3]\n[time]\nto = 5\nsamples = 3\n",
      {"momentum", "attitude", "planarity"});
  EXPECT_EQ(report.verdict, status::certified);
  // The momentum (0, 2, 3) goes around the axis at the rate (1/1 - 1/2) * 3: dJ_x/dt = J_y J_z
  // (1/I_z - 1/I_y).
  const ball angle = ball(rational(3, 2) * rational(5, 2), 128);
  EXPECT_TRUE(overlaps(report.find("momentum")->table->rows[1][3], sin(angle)));
  EXPECT_TRUE(overlaps(report.find("momentum")->table->rows[1][4], cos(angle)));
}

TEST(Series, InDouble) {
  const std::string head =
      "[body]\nmoments = [3, 2, 1]\n[state]\nomega = [0.1, 1, 0.3]\n[time]\nto = 20\nsamples = 5\n";
  const scene_report certified = report_of(head, {"momentum", "attitude"});
  const scene_report quick = report_of("precision = \"double\"\n" + head, {"momentum", "attitude"});
  EXPECT_EQ(quick.find("momentum")->verdict, status::not_certified);
  EXPECT_FALSE(quick.find("momentum")->table->certified);
  for (const char* name : {"momentum", "attitude"}) {
    for (std::size_t row = 0; row < 5; ++row) {
      for (std::size_t i = 0; i < 4; ++i) {
        const ball difference =
            certified.find(name)->table->rows[row][i] - quick.find(name)->table->rows[row][i];
        EXPECT_TRUE(certainly_less(abs(difference), ball(parse_rational("1e-13"), 64)));
      }
    }
  }
}

// ---------------------------------------------------------------------------------------------
// The scenes in the tree

scene read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return read_scene({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()},
                    path.parent_path());
}

TEST(Scenes, AllAreRead) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(POLHODE_SCENES_DIR)) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    const scene s = read_file(entry.path());
    EXPECT_FALSE(s.title.empty()) << entry.path();
    EXPECT_FALSE(s.source.empty()) << entry.path();
  }
  EXPECT_GE(scenes, 8);
}

// 5.38 +- 0.03 and 7.40 +- 0.03 days: Y. Zhao, S. Hu, J. Ji, Proc. IAU Symp. 318 (2016) 156.
TEST(Scenes, ToutatisHasThePublishedPeriods) {
  scene s = read_file(std::filesystem::path(POLHODE_SCENES_DIR) / "toutatis.toml");
  s.want = {"period", "mean_precession", "regime"};
  const scene_report report = compute(s);
  EXPECT_EQ(word(report, "regime"), "rotating");
  EXPECT_TRUE(lies_in(number(report, "period", "period"), "5.35", "5.41"));
  EXPECT_TRUE(lies_in(number(report, "mean_precession", "wobble_period"), "7.37", "7.43"));
}

TEST(Scenes, RacketIsUndecidedAndWaterDepends) {
  EXPECT_EQ(
      word(compute(read_file(std::filesystem::path(POLHODE_SCENES_DIR) / "tennis_racket.toml")),
           "planarity"),
      "undecided");
  EXPECT_EQ(word(compute(read_file(std::filesystem::path(POLHODE_SCENES_DIR) / "water.toml")),
                 "planarity"),
            "non-physical");
  EXPECT_EQ(
      word(compute(read_file(std::filesystem::path(POLHODE_SCENES_DIR) / "water_equilibrium.toml")),
           "planarity"),
      "physical");
}

TEST(Scenes, THandleNeverFlipsAndFlips) {
  std::ifstream file(std::filesystem::path(POLHODE_SCENES_DIR) / "t_handle.toml", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const auto flips = [&](const char* departure) {
    scene s = read_scene(text, ".", {{"state.omega[0]", parse_rational(departure)}});
    return compute(s);
  };
  const scene_report exactly = flips("0");
  EXPECT_EQ(word(exactly, "flips"), "never");
  EXPECT_EQ(word(exactly, "regime"), "separatrix");  // on its unstable equilibrium
  const scene_report beside = flips("1e-12");
  EXPECT_EQ(beside.verdict, status::certified);
  EXPECT_TRUE(certainly_positive(number(beside, "flips", "flip_1")));
}

}  // namespace effects_test
}  // namespace polhode
