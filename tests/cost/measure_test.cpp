#include "cost/measure.hpp"

#include <cmath>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace {

using namespace polhode;
using namespace polhode::cost;

TEST(Cost, EveryQuantityIsCertifiedByItsFirstMethod) {
  std::set<std::string> names;
  for (const quantity& q : quantities()) {
    EXPECT_TRUE(names.insert(q.name).second) << q.name;
    std::set<std::string> methods;
    for (const method& m : q.methods) EXPECT_TRUE(methods.insert(m.name).second) << m.name;
    ASSERT_FALSE(q.methods.empty()) << q.name;
    EXPECT_TRUE(q.methods.front().certified) << q.name;
    EXPECT_GE(q.methods.front().most_digits, 3000) << q.name;
  }
}

// So that what is compared is the same number.
TEST(Cost, AllMethodsOfAQuantityGiveTheSameNumber) {
  for (const quantity& q : quantities()) {
    const ball value = q.methods.front().compute(30).value;
    for (const method& m : q.methods) {
      const measurement x = measure(m, 16, value, 0);
      ASSERT_TRUE(x.log10_error) << q.name << ", " << m.name;
      // Gauss and Kronrod's rule does not reach its goal where the integrand is singular.
      // Runge and Kutta's steps add up their errors.
      const bool stepping = m.name == "boost dopri5";
      const bool singular = q.name == "root_integral" && m.name == "boost gauss-kronrod";
      const double most = m.certified ? -16 : (singular ? -4 : (stepping ? -8 : -12.5));
      EXPECT_LE(*x.log10_error, most) << q.name << ", " << m.name;
      if (m.certified) {
        EXPECT_TRUE(overlaps(m.compute(16).value, value)) << q.name << ", " << m.name;
      }
    }
  }
}

TEST(Cost, HardMembersAreComputedByTheirFirstMethod) {
  for (const hard_family& f : hard_families()) {
    for (const long k : {f.exponents.front(), f.exponents.back()}) {
      const quantity q = f.member(k);
      const measurement x = measure(q.methods.front(), 30, std::nullopt, 0);
      EXPECT_TRUE(x.has_digits()) << f.name << ' ' << k;
    }
  }
}

TEST(Cost, MemoryIsThatOfTheNumbers) {
  const method& m = quantities().front().methods.front();
  const double small = measure(m, 100, std::nullopt, 0).bytes;
  const double large = measure(m, 10'000, std::nullopt, 0).bytes;
  EXPECT_GT(large, 4 * 10'000 * 0.4153);  // at least four numbers of that many digits
  EXPECT_LT(small, large);
}

TEST(Cost, SaysWhichDigitsAreClaimedAndNotThere) {
  measurement m;
  m.digits = 30;
  m.log10_error = -31;
  m.log10_claimed = -40;
  EXPECT_TRUE(m.has_digits());
  EXPECT_FALSE(m.claims_too_much());
  m.log10_error = -20;
  EXPECT_FALSE(m.has_digits());
  EXPECT_TRUE(m.claims_too_much());
  m.log10_claimed = -20.5;
  EXPECT_FALSE(m.claims_too_much());
  m.log10_claimed.reset();
  EXPECT_FALSE(m.claims_too_much());
}

std::vector<measurement> of_power(double exponent) {
  std::vector<measurement> result;
  for (const long n : {100L, 300L, 1000L, 3000L}) {
    measurement m;
    m.digits = n;
    m.seconds = 1e-6 * std::pow(static_cast<double>(n), exponent);
    result.push_back(m);
  }
  return result;
}

TEST(Cost, FitsPowers) {
  EXPECT_FALSE(growth_exponent({}));
  EXPECT_FALSE(extrapolated_seconds({}, 100));
  for (const double e : {1.25, 2.0, 3.5}) {
    const std::vector<measurement> known = of_power(e);
    EXPECT_NEAR(growth_exponent(known).value(), e, 1e-9);
    EXPECT_NEAR(extrapolated_seconds(known, 30'000).value() / (1e-6 * std::pow(3e4, e)), 1, 1e-9);
  }
}

TEST(Cost, EstimatesWorkFromFewerDigits) {
  std::vector<long> digits;
  const auto work = [&](long n) { digits.push_back(n); };
  ASSERT_TRUE(estimated_seconds(work, 1000, 1e9));
  EXPECT_EQ(std::set<long>(digits.begin(), digits.end()), (std::set<long>{30, 120, 480}));
  // One call that takes long enough ends it.
  digits.clear();
  ASSERT_TRUE(estimated_seconds(work, 1000, -1));
  EXPECT_EQ(digits, (std::vector<long>{30}));
  EXPECT_FALSE(estimated_seconds(work, 60, 1));
  EXPECT_FALSE(estimated_seconds([](long) { throw std::domain_error("never"); }, 1000, 1));
}

TEST(Cost, ModelGoesThroughTheTimesItKnows) {
  const std::vector<std::pair<long, double>> known{{100, 1e-3}, {10'000, 1e-1}};
  const cost_model model(known);
  EXPECT_DOUBLE_EQ(model.seconds(10), 1e-3);
  EXPECT_NEAR(model.seconds(1000) / 1e-2, 1, 1e-9);
  EXPECT_NEAR(model.seconds(10'000) / 1e-1, 1, 1e-9);
  EXPECT_GT(model.seconds(1'000'000), 1e-1);
}

TEST(Cost, EstimatesAreOfKnownQuantities) {
  EXPECT_THROW((void)estimate_cost("gamma", 100), std::invalid_argument);
  EXPECT_GT(estimate_cost("epsilon0_min", 1000), 0);
}

}  // namespace
