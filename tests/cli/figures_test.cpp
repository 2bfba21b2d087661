// polhode figures: the points against other routes, the files, the pictures, refusals.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "program.hpp"
#include "refusal.hpp"

namespace polhode::test {
namespace figures_test {

// ---------------------------------------------------------------------------------------------
// The data, as read from the files

struct interval_read {
  rational lower;
  rational upper;

  [[nodiscard]] ball enclosure() const { return hull(ball(lower, 200), ball(upper, 200)); }
  [[nodiscard]] bool is_exact() const { return lower == upper; }
};

struct row_read {
  std::string curve;
  int part = 0;
  interval_read x;
  interval_read y;
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

/// The digits are those of every number between the ends.
interval_read read_interval(const std::string& value, const std::string& lower,
                            const std::string& upper) {
  const interval_read result{parse_rational(lower), parse_rational(upper)};
  EXPECT_LE(result.lower, result.upper);
  const rational cut = parse_rational(value);
  EXPECT_LE(abs(cut), abs(cut > 0 ? result.lower : result.upper)) << value;
  return result;
}

/// Every figure's CSV file, by one run of the program with 15 digits.
class figure_data {
 public:
  figure_data() {
    const scratch_directory scratch;
    report_ = certified({"figures", "--data-only", "--out", scratch.path("figures")});
    for (const std::string& name : names_in(scratch.path("figures"))) {
      files_[name] = lines_of(contents(scratch.path("figures") + '/' + name));
    }
  }
  [[nodiscard]] const std::string& report() const { return report_; }
  [[nodiscard]] const std::map<std::string, std::vector<std::string>>& files() const {
    return files_;
  }
  [[nodiscard]] std::vector<row_read> rows(const std::string& figure) const {
    std::vector<row_read> result;
    const std::vector<std::string>& lines = files_.at(figure + ".csv");
    for (auto line = lines.begin() + 1; line != lines.end(); ++line) {
      const std::vector<std::string> c = cells_of(*line);
      EXPECT_EQ(c.size(), 8U) << *line;
      result.push_back({c.at(0), std::stoi(c.at(1)), read_interval(c.at(2), c.at(3), c.at(4)),
                        read_interval(c.at(5), c.at(6), c.at(7))});
    }
    return result;
  }

 private:
  std::string report_;
  std::map<std::string, std::vector<std::string>> files_;
};

const figure_data& data() {
  static const figure_data all;
  return all;
}

/// "12.65" of "a = 12.65"
rational number_in(const std::string& curve) {
  return parse_rational(curve.substr(curve.find("= ") + 2));
}

/// The integral from 0 to `end` of (1 - b cos^2)/sqrt((a + b cos^2)(c + b cos^2)): the paper's eq.
/// (20), by certified quadrature.
ball phase_to(const rational& a, const rational& b, const rational& c, const rational& end) {
  return integrate(
             [&](const auto& psi) {
               const auto squared = b * square(cos(psi));
               return (1 - squared) / sqrt((a + squared) * (c + squared));
             },
             0, end, {.digits = 25})
      .enclosure;
}

/// Whether the phase from psi = 0 to pi/2 - epsilon is pi for some epsilon of the interval.
void expect_twist(const rational& a, const rational& b, const rational& c,
                  const interval_read& epsilon) {
  const ball quarter = scale(pi(200), -1);
  const ball before = phase_to(a, b, c, lower_rational(quarter - epsilon.upper));
  const ball after = phase_to(a, b, c, upper_rational(quarter - epsilon.lower));
  EXPECT_TRUE(certainly_less(before, pi(200))) << a << ' ' << c;
  EXPECT_TRUE(certainly_less(pi(200), after)) << a << ' ' << c;
}

// ---------------------------------------------------------------------------------------------

TEST(Figures, EachHasItsCurves) {
  const std::map<std::string, std::set<std::string>> expected{
      {"physical_region", {"I = 1", "bodies"}},
      {"reduced_phase_space",
       {"c = -0.2", "c = -0.12", "c = -0.06", "c = -0.01", "c = 0", "c = 0.05", "c = 0.15",
        "c = 0.3", "c = 0.5", "c = -0.25"}},
      {"montgomery_oscillating", {"a = 12.65", "a = 18.27", "limit", "2 pi"}},
      {"montgomery_rotating", {"a = 12.65", "a = 18.27", "limit"}},
      {"phase_space",
       {"c = -0.2", "c = -0.12", "c = -0.06", "c = -0.01", "c = 0", "c = 0.05", "c = 0.15",
        "c = 0.3", "c = 0.5", "c = -0.25"}},
      {"first_equation", {"C", "S", "c = -b", "c = a", "C meets S", "epsilon0", "c0"}},
      {"injectivity",
       {"a = 39.95", "a = 18.27", "a = 12.65", "a = 3.1", "S", "C meets S", "epsilon = pi/2",
        "c = 0"}},
      {"varying_a",
       {"a = 12.65", "a = 13.89", "a = 15.38", "a = 18.27", "S", "epsilon0", "c0", "epsilon = 0",
        "c = 0"}},
      {"varying_a_as_printed",
       {"a = 12.65", "a = 13.89", "a = 15.38", "a = 18.27", "S", "epsilon0", "c0", "epsilon = 0",
        "c = 0"}},
      {"limit",
       {"chi = 1", "chi = 0.8", "chi = 0.6", "chi = 0.4", "epsilon0_min", "beta", "epsilon = 0",
        "beta = 0"}}};
  ASSERT_EQ(data().files().size(), expected.size());
  for (const auto& [figure, curves] : expected) {
    std::set<std::string> found;
    for (const row_read& r : data().rows(figure)) found.insert(r.curve);
    EXPECT_EQ(found, curves) << figure;
  }
  // C meets S once for 2/3 <= I < 2, twice for 2/5 <= I < 2/3, and not for I > 2.
  EXPECT_EQ(std::ranges::count(data().rows("injectivity"), "C meets S", &row_read::curve), 4);
}

TEST(Figures, NoEnclosureIsWiderThanIsSaid) {
  for (const std::string& line : lines_of(data().report())) {
    const std::string name = line.substr(0, line.find(".csv"));
    const rational said = parse_rational(line.substr(line.rfind(' ') + 1));
    rational widest = 0;
    for (const row_read& r : data().rows(name)) {
      widest = std::max({widest, rational(r.x.upper - r.x.lower), rational(r.y.upper - r.y.lower)});
    }
    EXPECT_LE(widest, said) << name;
    EXPECT_GT(rational(widest * 11 / 10), said) << name;
    EXPECT_LT(said, parse_rational("1e-14")) << name;
  }
}

TEST(Figures, PhysicalRegion) {
  int points = 0;
  for (const row_read& r : data().rows("physical_region")) {
    ASSERT_TRUE(r.x.is_exact());
    if (r.curve != "I = 1") continue;
    ++points;
    const rational b = 1 / (r.x.lower + 2);
    EXPECT_LE(r.y.lower, b);
    EXPECT_LE(b, r.y.upper);
  }
  EXPECT_GT(points, 100);
}

TEST(Figures, OrbitsHaveTheirFirstIntegral) {
  const rational a(1, 2);
  const rational b(1, 4);
  for (const row_read& r : data().rows("phase_space")) {
    // c = a - sin^2 theta (a + b cos^2 psi), the paper's eq. (10)
    const ball c = a - square(sin(r.y.enclosure())) * (a + b * square(cos(r.x.enclosure())));
    EXPECT_TRUE(contains(c, number_in(r.curve))) << r.curve;
    EXPECT_TRUE(c.radius() < magnitude::power_of_two(-45));
  }
  for (const row_read& r : data().rows("reduced_phase_space")) {
    // (dpsi/dphi)^2 (1 - b cos^2)^2 = (a + b cos^2)(c + b cos^2), eq. (12)
    const ball x = b * square(cos(r.x.enclosure()));
    const ball c = square(r.y.enclosure() * (1 - x)) / (a + x) - x;
    EXPECT_TRUE(contains(c, number_in(r.curve))) << r.curve;
    EXPECT_TRUE(c.radius() < magnitude::power_of_two(-45));
  }
}

TEST(Figures, PhasesAreThoseByQuadrature) {
  const rational b = parse_rational("0.0629");
  int compared = 0;
  int row = 0;
  for (const row_read& r : data().rows("montgomery_rotating")) {
    if (r.curve.rfind("a = ", 0) != 0 || ++row % 20 != 0) continue;
    ++compared;
    ASSERT_TRUE(r.x.is_exact());
    // The whole loop is four times the integral from 0 to pi/2, eq. (17).
    const ball end = scale(pi(200), -1);
    const ball quarter =
        integrate(
            [&](const auto& psi) {
              const auto squared = b * square(cos(psi));
              return (1 - squared) / sqrt((number_in(r.curve) + squared) * (r.x.lower + squared));
            },
            0, end, {.digits = 25})
            .enclosure;
    EXPECT_TRUE(overlaps(4 * quarter, r.y.enclosure())) << r.curve << ' ' << r.x.lower;
    EXPECT_TRUE(contains(r.y.enclosure(), 4 * quarter.middle()));
  }
  EXPECT_GE(compared, 15);
  // Oscillating, under x = cos^2 + u sin^2: 2 G(u), with G as in eq. (14).
  row = 0;
  for (const row_read& r : data().rows("montgomery_oscillating")) {
    if (r.curve.rfind("a = ", 0) != 0 || ++row % 20 != 0) continue;
    ++compared;
    const rational a = number_in(r.curve);
    const rational u(-r.x.lower / b);
    const ball half = integrate(
                          [&](const auto& t) {
                            const auto x = u + (1 - u) * square(cos(t));
                            return 2 * (1 - b * x) / sqrt(b * x * (a + b * x));
                          },
                          0, scale(pi(200), -1), {.digits = 25})
                          .enclosure;
    EXPECT_TRUE(contains(r.y.enclosure(), 2 * half.middle())) << r.curve << ' ' << r.x.lower;
  }
  EXPECT_GE(compared, 30);
}

TEST(Figures, TwistsSolveTheFirstImplicitEquation) {
  int compared = 0;
  for (const std::string figure :
       {"first_equation", "injectivity", "varying_a", "varying_a_as_printed"}) {
    const bool schematic = figure == "first_equation";
    const rational b = parse_rational(schematic                          ? "0.25"
                                      : figure == "varying_a_as_printed" ? "0.06"
                                                                         : "0.0629");
    int row = 0;
    for (const row_read& r : data().rows(figure)) {
      const bool of_c = schematic ? r.curve == "C" : r.curve.rfind("a = ", 0) == 0;
      // The equation holds as far as C meets S; for c > 0 in any case.
      if (!of_c || r.x.lower <= 0 || ++row % 15 != 0) continue;
      ASSERT_TRUE(r.x.is_exact());
      ++compared;
      expect_twist(schematic ? rational(1, 2) : number_in(r.curve), b, r.x.lower, r.y);
    }
  }
  EXPECT_GE(compared, 30);
  // For c < 0 where there is no meeting, I > 2: the whole curve.
  int negative = 0;
  int row = 0;
  for (const row_read& r : data().rows("injectivity")) {
    if (r.curve != "a = 3.1" || r.x.lower >= parse_rational("-0.0001") || ++row % 40 != 0) continue;
    ++negative;
    expect_twist(number_in(r.curve), parse_rational("0.0629"), r.x.lower, r.y);
  }
  EXPECT_GE(negative, 5);
}

TEST(Figures, TheLimitSolvesItsEquation) {
  int compared = 0;
  int row = 0;
  for (const row_read& r : data().rows("limit")) {
    if (r.curve.rfind("chi", 0) != 0 || r.x.lower <= 0 || ++row % 10 != 0) continue;
    ++compared;
    const rational chi = number_in(r.curve);
    // eq. (36): the integral of 1/sqrt(beta + cos^2) from 0 to pi/2 - epsilon is pi sqrt(chi).
    const auto integral_to = [&](const rational& end) {
      return integrate([&](const auto& psi) { return 1 / sqrt(r.x.lower + square(cos(psi))); }, 0,
                       end, {.digits = 25})
          .enclosure;
    };
    const ball quarter = scale(pi(200), -1);
    const ball target = pi(200) * sqrt(ball(chi, 200));
    EXPECT_TRUE(certainly_less(integral_to(lower_rational(quarter - r.y.upper)), target));
    EXPECT_TRUE(certainly_less(target, integral_to(upper_rational(quarter - r.y.lower))));
  }
  EXPECT_GE(compared, 30);
  for (const row_read& r : data().rows("limit")) {
    if (r.curve == "epsilon0_min") {
      EXPECT_LE(r.y.lower, parse_rational("0.0863740970495642522703"));
      EXPECT_GE(r.y.upper, parse_rational("0.0863740970495642522702"));
    }
    if (r.curve == "beta") {
      EXPECT_LE(r.x.lower, parse_rational("0.0289732280378394600897"));
      EXPECT_GE(r.x.upper, parse_rational("0.0289732280378394600896"));
    }
  }
}

// ---------------------------------------------------------------------------------------------
// The command

TEST(FiguresCommand, ListAndHelp) {
  const std::string list = certified({"figures", "--list"});
  for (const char* word :
       {"physical_region", "figure 1", "figure 2", "figure 3 (a)", "figure 3 (b)", "figure 4",
        "figure 5", "figure 6", "figure 7", "figure 8", "b = 0.0629", "schematic"}) {
    EXPECT_NE(list.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(certified({"figures", "limit", "--list"}).find("figure 1"), std::string::npos);
  const std::string third = certified({"figures", "--list", "3"});
  EXPECT_NE(third.find("montgomery_oscillating"), std::string::npos) << third;
  EXPECT_NE(third.find("montgomery_rotating"), std::string::npos) << third;
  EXPECT_EQ(third.find("figure 4"), std::string::npos) << third;
  const std::string help = certified({"figures", "--help"});
  for (const char* word : {"--out", "--data-only", "gnuplot", "all files appear, or none"}) {
    EXPECT_NE(help.find(word), std::string::npos) << word;
  }
}

TEST(FiguresCommand, ChosenByNameInAnyOrderAndOnce) {
  const scratch_directory scratch;
  const std::string report =
      certified({"figures", "limit", "physical_region", "limit", "--data-only", "--digits", "3",
                 "--out", scratch.path("deep/er")});
  EXPECT_EQ(report.find("physical_region.csv: figure 1; "), 0U) << report;
  std::vector<std::string> names = names_in(scratch.path("deep/er"));
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"limit.csv", "physical_region.csv"}));
  const auto lines = lines_of(contents(scratch.path("deep/er/limit.csv")));
  EXPECT_EQ(lines.front(),
            "curve,part,beta,beta_lower,beta_upper,epsilon,epsilon_lower,epsilon_upper");
  EXPECT_EQ(lines.at(1), "chi = 1,1,-0.2,-0.2,-0.2,0.625,0.625732,0.625733");
}

TEST(FiguresCommand, PicturesWhereGnuplotIs) {
  const scratch_directory scratch;
  const outcome result = run({"figures", "varying_a", "--out", scratch.path("f")});
  if (result.status != 0) {
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("gnuplot"), std::string::npos);
    return;
  }
  const std::string svg = contents(scratch.path("f/varying_a.svg"));
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  const std::string said = result.out.substr(result.out.rfind(' ') + 1);
  EXPECT_NE(svg.find("certified to within " + said.substr(0, said.size() - 1)), std::string::npos);
  EXPECT_NE(svg.find("the caption prints b = 0.06"), std::string::npos);
  EXPECT_EQ(contents(scratch.path("f/varying_a.png")).rfind("\x89PNG", 0), 0U);
  EXPECT_EQ(names_in(scratch.path("f")).size(), 3U);
}

TEST(FiguresCommand, WithoutGnuplotNothingIsWritten) {
  for (const std::string gnuplot : {"", "exit 1", "exit 0"}) {
    const scratch_directory scratch;
    std::filesystem::create_directory(scratch.path("bin"));
    if (!gnuplot.empty()) {
      std::ofstream(scratch.path("bin/gnuplot")) << "#!/bin/sh\n" << gnuplot << '\n';
      std::filesystem::permissions(scratch.path("bin/gnuplot"), std::filesystem::perms::owner_all);
    }
    const std::string here = scratch.path("");
    const outcome none = run_script("p=$(command -v polhode); PATH=" + here +
                                    "/bin \"$p\" figures limit --out " + here + "/f");
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(none.out, "");
    EXPECT_NE(none.err.find("gnuplot"), std::string::npos) << none.err;
    EXPECT_NE(none.err.find("--data-only"), std::string::npos) << none.err;
    EXPECT_EQ(std::count(none.err.begin(), none.err.end(), '\n'), 1) << none.err;
    EXPECT_EQ(names_in(here), std::vector<std::string>{"bin"});
    const outcome data_only =
        run_script("p=$(command -v polhode); PATH=" + here +
                   "/bin \"$p\" figures physical_region --data-only --out " + here + "/f");
    EXPECT_EQ(data_only.status, 0) << data_only.err;
    EXPECT_EQ(names_in(here + "/f"), std::vector<std::string>{"physical_region.csv"});
  }
}

TEST(FiguresCommand, RefusesBadInput) {
  const scratch_directory scratch;
  const std::string out = scratch.path("f");
  expect_refused({"figures", "injectivty", "--out", out}, {"nearest is injectivity", "--list"});
  expect_refused({"figures", "", "--out", out}, {"there is no figure"});
  expect_refused({"figures", "9", "--out", out}, {"there is no figure \"9\""});
  expect_refused({"figures", "--digits", "0", "--out", out}, {"--digits"});
  expect_refused({"figures", "--digits", "1000000000", "--out", out}, {"GiB"});
  expect_refused({"figures", "--lst", "--out", out}, {"--list"});
  EXPECT_TRUE(names_in(scratch.path("")).empty());
  std::ofstream(scratch.path("file")) << "in the way";
  for (const std::string& place : {scratch.path("file"), scratch.path("file/f")}) {
    expect_refused({"figures", "limit", "--data-only", "--out", place}, {"is a file", "directory"});
  }
  expect_refused({"figures", "limit", "--data-only", "--out", ""}, {"--out"});
  expect_refused({"figures", "limit", "--data-only", "--out", "/proc/figures"}, {"/proc/figures"});
  // A directory where a file must go.
  std::filesystem::create_directories(scratch.path("f/limit.csv"));
  expect_refused({"figures", "physical_region", "limit", "--data-only", "--out", out},
                 {"limit.csv"});
  EXPECT_EQ(names_in(out), std::vector<std::string>{"limit.csv"});
}

}  // namespace figures_test
}  // namespace polhode::test
