// Formulas that are 0 on intervals: known ones, and random ones in whole and rational numbers
// against their values at points.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/roots/isolate.hpp"
#include "support/random.hpp"

namespace polhode::test {
namespace zero_intervals_test {

/// "[-2, 0) 1/2": the intervals, and then the roots.
std::string found_by(const std::string& f, const end_point& lower, const end_point& upper) {
  const root_set found = isolate_roots(parse(f), lower, upper);
  const auto text = [](const end_point& x) {
    return x.is_infinite() ? "inf" : x.form() ? to_text(*x.form()) : "irrational";
  };
  std::string result;
  for (const zero_interval& z : found.zero_intervals) {
    result += (result.empty() ? "" : " ") + std::string(z.has_lower ? "[" : "(") + text(z.lower) +
              ", " + text(z.upper) + (z.has_upper ? "]" : ")");
  }
  for (const root_region& r : found.regions) {
    result += result.empty() ? "" : " ";
    result += r.exact ? to_text(*r.exact) : is_one_root(r.verdict) ? "a root" : "open";
  }
  return found.is_resolved() ? result : "not resolved: " + result;
}

TEST(ZeroIntervals, AreFoundWithTheRootsBesideThem) {
  EXPECT_EQ(found_by("max(x,0)", -2, 2), "[-2, 0]");
  EXPECT_EQ(found_by("floor(x)", -2, 2), "[0, 1)");
  EXPECT_EQ(found_by("ceil(x)", -2, 2), "(-1, 0]");
  EXPECT_EQ(found_by("abs(x)-x", -2, 2), "[0, 2]");
  EXPECT_EQ(found_by("max(x,0)*(x-1/2)*(x^2-2)", -2, 2), "[-2, 0] 1/2 a root");
  EXPECT_EQ(found_by("ceil(x)-floor(x)-1", 0, 2), "(0, 1) (1, 2)");
  EXPECT_EQ(found_by("floor(x)*ceil(x-1)*(2*x-3)", 0, 2), "[0, 1] 3/2");
  EXPECT_EQ(found_by("max(x,0)*abs(x-1)", -1, 2), "[-1, 0] 1");
  EXPECT_EQ(found_by("floor(x)/x", -2, 2), "(0, 1)");
  EXPECT_EQ(found_by("max(x,0)/(x+1)", -2, 2), "[-2, 0]");
  EXPECT_EQ(found_by("max(x,0)*(x-2)", -2, 2), "[-2, 0] 2");
  EXPECT_EQ(found_by("min(x^2,0)", -1, 1), "[-1, 1]");
  EXPECT_EQ(found_by("max(x,0)", -end_point::infinity(), end_point::infinity()), "(inf, 0]");
  EXPECT_EQ(found_by("max(abs(x)-1,0)", -end_point::infinity(), 3), "[-1, 1]");
  const end_point root = end_point_of(parse("sqrt(2)", {}));
  EXPECT_EQ(found_by("max(1-x,0)", 0, root), "[1, irrational]");
  EXPECT_EQ(found_by("min(x-1,0)*sin(x)", root, 4), "[irrational, 4]");
  // A break between sqrt(2) and the number beyond it that the pieces are made with.
  EXPECT_EQ(found_by("max(x-7,0)*sin(x)", 1, 7), "[1, 7]");
}

TEST(ZeroIntervals, AreNotTakenForOnesThatAreSmall) {
  EXPECT_EQ(found_by("max(x,0)+1e-40", -1, 1), "");
  EXPECT_EQ(found_by("max(x,0)+1e-40*(x+1/2)", -1, 1), "a root");
  EXPECT_EQ(found_by("max(x,1e-40*x)", -1, 1), "0");
  EXPECT_EQ(found_by("floor(x)+1e-40", 0, 1), "");
  EXPECT_EQ(found_by("floor(x+1e-40)", 0, 2),
            "[0, 9999999999999999999999999999999999999999/"
            "10000000000000000000000000000000000000000)");
}

/// Piecewise linear, or a product of such.
std::string random_formula(support::random_source& random, int depth) {
  const auto number = [&] {
    return "(" + std::to_string(random.between(-6, 6)) + "/" +
           std::to_string(random.between(1, 3)) + ")";
  };
  if (depth == 0) return random.one_in(3) ? number() : "(" + number() + "*x+" + number() + ")";
  const std::string u = random_formula(random, depth - 1);
  const std::string v = random_formula(random, depth - 1);
  switch (random.between(0, 6)) {
    case 0:
      return "max(" + u + "," + v + ")";
    case 1:
      return "min(" + u + ",0)";
    case 2:
      return "max(" + u + ",0)";
    case 3:
      return "(abs(" + u + ")-" + u + ")";
    case 4:
      return "floor(" + u + ")";
    case 5:
      return "(" + u + ")*(" + v + ")";
    default:
      return "(" + u + "-" + v + ")";
  }
}

TEST(ZeroIntervals, OfRandomFormulasHoldExactlyTheirZeros) {
  support::random_source random(28);
  long with_intervals = 0;
  for (support::repeat trial(80); trial.again();) {
    const std::string text = random_formula(random, static_cast<int>(random.between(1, 3)));
    SCOPED_TRACE(text);
    const expression f = parse(text);
    if (f.variables().empty() || f.used_variables().empty()) continue;
    const rational lower = random.between(-4, 0);
    const rational upper = lower + random.between(1, 6);
    const root_set found = isolate_roots(f, lower, upper, {.most_boxes = 500});
    if (!found.zero_intervals.empty()) ++with_intervals;
    const auto is_listed = [&](const rational& x) {
      for (const zero_interval& z : found.zero_intervals) {
        const rational& a = *z.lower.exact();
        const rational& b = *z.upper.exact();
        if ((a < x && x < b) || (x == a && z.has_lower) || (x == b && z.has_upper)) return true;
      }
      return false;
    };
    const auto may_be_root = [&](const rational& x) {
      for (const root_region& r : found.regions) {
        if (overlaps(r.enclosure, ball(x, 256)) && (!r.exact || *r.exact == x)) return true;
      }
      return false;
    };
    std::vector<rational> points{lower, upper};
    for (const zero_interval& z : found.zero_intervals) {
      points.push_back(*z.lower.exact());
      points.push_back(*z.upper.exact());
    }
    for (int k = 0; k < 40; ++k) {
      points.push_back(lower + (upper - lower) * rational(random.between(0, 72), 72));
    }
    for (const rational& x : points) {
      expression_names names = f.names();
      names.variables.clear();
      const auto value = expression(f(symbol(x)), names).rational_value();
      if (!value) continue;
      if (found.identically_zero) {
        EXPECT_EQ(*value, 0);
        continue;
      }
      EXPECT_FALSE(is_listed(x) && *value != 0) << to_text(x);
      EXPECT_FALSE(*value == 0 && !is_listed(x) && !may_be_root(x)) << to_text(x);
      for (const root_region& r : found.regions) {
        EXPECT_FALSE(r.exact == x && is_one_root(r.verdict) && (*value != 0 || is_listed(x)))
            << to_text(x);
      }
    }
  }
  EXPECT_GT(with_intervals, 5 * std::min(1.0, support::effort()));
}

}  // namespace zero_intervals_test
}  // namespace polhode::test
