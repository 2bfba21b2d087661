#include "cost/budget.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace budget_test {

using namespace polhode::cost;

/// A clock that goes on only while something is "measured": with c n^p seconds a call.
struct played_work {
  double factor = 1e-6;
  double power = 2;
  double calls = 3;
  double now = 1000;
  std::vector<long> begun;

  [[nodiscard]] double seconds(long n) const {
    return factor * std::pow(static_cast<double>(n), power);
  }
  measured_points within(double limit, double extra = 0) {
    const time_budget budget(limit, [this] { return now; });
    return measured_within(
        budget, {16, 30, 100, 300, 1000, 3000, 10'000}, calls, [=](long) { return extra; },
        [this](long n) {
          begun.push_back(n);
          measurement m;
          m.digits = n;
          m.seconds = seconds(n);
          now += calls * m.seconds;
          return m;
        });
  }
};

TEST(TimeBudget, BeginsNothingThatWouldPassTheLimit) {
  for (const double power : {1.0, 1.5, 2.0, 3.0}) {
    for (const double limit : {0.0, 0.001, 0.1, 1.0, 10.0, 1e9}) {
      played_work work;
      work.power = power;
      const double start = work.now;
      const measured_points found = work.within(limit);
      ASSERT_FALSE(found.points.empty());
      EXPECT_EQ(found.points.size() + found.left_out.size(), 7U);
      // The first is taken whatever it costs, and after one alone the growth is not known.
      if (found.points.size() > 2) {
        EXPECT_LE(work.now - start, limit * (1 + 1e-12));
      }
      for (const long n : found.left_out) EXPECT_GT(n, work.begun.back());
      // What was left out would have passed the limit; with one point known it is expected to grow
      // by the square.
      if (!found.left_out.empty()) {
        const long next = found.left_out.front();
        const double last = work.calls * work.seconds(work.begun.back());
        const double ratio = static_cast<double>(next) / static_cast<double>(work.begun.back());
        const double expected = last * std::pow(ratio, found.points.size() == 1 ? 2 : power);
        EXPECT_GT(work.now - start + expected, limit * (1 - 1e-12)) << power << ' ' << limit;
      }
    }
  }
}

TEST(TimeBudget, CountsWhatAReferenceTakes) {
  played_work without;
  played_work with;
  const double limit = 10;
  EXPECT_GT(without.within(limit).points.size(), with.within(limit, limit).points.size());
  EXPECT_EQ(with.begun, std::vector<long>{16});
}

/// A first call takes longer than the later ones that are counted: what the measurement took in all
/// decides.
TEST(TimeBudget, CountsWhatIsNotMeasured) {
  double now = 0;
  const time_budget budget(10.5, [&] { return now; });
  const measured_points found = measured_within(
      budget, {100, 1000, 10'000}, 2, [](long) { return 0; },
      [&](long n) {
        measurement m;
        m.digits = n;
        m.seconds = 1e-9 * static_cast<double>(n);
        now += 1e-3 * static_cast<double>(n);
        return m;
      });
  EXPECT_EQ(found.points.size(), 2U);
  EXPECT_EQ(found.left_out, std::vector<long>{10'000});
}

/// Calls are longer than the clock's time in all where the clock jumped: the greater estimate
/// decides.
TEST(TimeBudget, CountsTheCallsToCome) {
  const time_budget budget(10, [] { return 0.0; });
  std::vector<long> begun;
  (void)measured_within(
      budget, {100, 1000}, 3, [](long) { return 0; },
      [&](long n) {
        begun.push_back(n);
        measurement m;
        m.digits = n;
        m.seconds = 1;
        return m;
      });
  EXPECT_EQ(begun, std::vector<long>{100});
}

TEST(TimeBudget, SharesWhatIsLeft) {
  double now = 0;
  const time_budget all(12, [&] { return now; });
  EXPECT_TRUE(all.share(4).allows(3));
  EXPECT_FALSE(all.share(4).allows(3.1));
  now = 9;  // the first of four took more than its share
  EXPECT_TRUE(all.share(3).allows(1));
  EXPECT_FALSE(all.share(3).allows(1.1));
  EXPECT_TRUE(all.share(1).allows(3));
  now = 13;
  EXPECT_FALSE(all.allows(0));
  EXPECT_FALSE(all.share(2).allows(0));
}

}  // namespace budget_test
