#include "cost/measure.hpp"

#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace measure_test {

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

TEST(Cost, FitsThePowerOfManyDigits) {
  std::vector<measurement> known = of_power(2);
  // What a call costs whatever the digits does not count where there are three sizes without it.
  measurement few;
  few.digits = 16;
  few.seconds = 1;
  known.insert(known.begin(), few);
  EXPECT_NEAR(growth_exponent(known).value(), 2, 1e-9);
  known.pop_back();
  EXPECT_NEAR(growth_exponent(known).value(), 2, 1e-9);
  known.pop_back();
  EXPECT_LT(growth_exponent(known).value(), 0);
}

TEST(Cost, FitsPowers) {
  EXPECT_FALSE(growth_exponent({}));
  EXPECT_FALSE(growth_exponent({measurement{}, measurement{}}));
  EXPECT_FALSE(extrapolated_seconds({}, 100));
  for (const double e : {1.25, 2.0, 3.5}) {
    const std::vector<measurement> known = of_power(e);
    EXPECT_NEAR(growth_exponent(known).value(), e, 1e-9);
    EXPECT_NEAR(extrapolated_seconds(known, 30'000).value() / (1e-6 * std::pow(3e4, e)), 1, 1e-9);
  }
}

// Times that no clock has a part in: of multiplications as fast as n log n, and of works of the
// kinds there are.

double multiplication(long n) {
  return 1e-10 * static_cast<double>(n) * std::log(static_cast<double>(n) + 2);
}

struct known_work {
  const char* name;
  std::function<double(double n)> multiplications;
  double overhead;  // seconds of a call, whatever the digits
  double within = 2;
};

std::vector<known_work> known_works() {
  return {{"mean", [](double n) { return 20 * std::log(n); }, 1e-5},
          {"newton", [](double) { return 500.0; }, 3e-4},
          {"series", [](double n) { return 10 * std::sqrt(n); }, 1e-5},
          {"quadrature", [](double n) { return 30 * n; }, 1e-5},
          {"quadrature that starts late", [](double n) { return 30 * n; }, 3e-3},
          // Of its calls that are short enough most are overhead.
          {"quadrature with slow functions", [](double n) { return 30 * std::pow(n, 1.4); }, 1e-3,
           2.5}};
}

double seconds_of(const known_work& work, long n) {
  return work.overhead + work.multiplications(static_cast<double>(n)) * multiplication(n);
}

TEST(Cost, EstimatesFromShortCalls) {
  for (const known_work& work : known_works()) {
    for (const long digits : {1000L, 10'000L, 100'000L, 1'000'000L}) {
      const double is = seconds_of(work, digits);
      const double month = 30 * 86'400.0;
      if (is > month) break;
      double spent = 0;
      const auto timed = [&](long n) {
        const double t = seconds_of(work, n);
        spent += t;
        return t;
      };
      const double estimate =
          estimated_seconds(timed, digits, digits / 2, 1, multiplication).value();
      EXPECT_LE(estimate, work.within * is) << work.name << ' ' << digits;
      EXPECT_GE(estimate, is / work.within) << work.name << ' ' << digits;
      // The calls before the last are half as long at most, all but those that are overhead.
      EXPECT_LE(spent, 15 * work.overhead + 2 * std::max(0.03, std::min(1.0, 0.2 * is)))
          << work.name << ' ' << digits;
    }
  }
}

TEST(Cost, CalibrationTakesNoLongCalls) {
  std::vector<long> digits;
  const auto constant = [&](double seconds) {
    digits.clear();
    return [&digits, seconds](long n) {
      digits.push_back(n);
      return seconds;
    };
  };
  EXPECT_TRUE(estimated_seconds(constant(1e-6), 1000, 500, 1, multiplication));
  EXPECT_EQ(digits, (std::vector<long>{30, 60, 120, 240, 480}));
  // The first takes longer than any is to take.
  EXPECT_TRUE(estimated_seconds(constant(2), 1000, 500, 1, multiplication));
  EXPECT_EQ(digits, (std::vector<long>{30}));
  // Nothing to be timed.
  EXPECT_FALSE(estimated_seconds(constant(1), 1000, 29, 1, multiplication));
  EXPECT_TRUE(digits.empty());
  // A coarse clock.
  EXPECT_GT(estimated_seconds(constant(0), 1000, 500, 1, multiplication).value(), 0);
}

TEST(Cost, EstimatesWorkFromFewerDigits) {
  std::set<long> digits;
  ASSERT_TRUE(estimated_seconds_of_work([&](long n) { digits.insert(n); }, 1000));
  EXPECT_EQ(*digits.begin(), 30);
  EXPECT_LE(*digits.rbegin(), 500);
  EXPECT_FALSE(estimated_seconds_of_work([](long) {}, 59));
  EXPECT_FALSE(estimated_seconds_of_work([](long) { throw std::domain_error("never"); }, 1000));
}

TEST(Cost, AFewCallsShowThatWorkIsShort) {
  EXPECT_TRUE(is_short_work([](long) {}, 10'000'000, 1e300));
  EXPECT_FALSE(is_short_work([](long) {}, 10'000'000, -1));
  EXPECT_FALSE(is_short_work([](long) { throw std::domain_error("never"); }, 1000, 1e300));
  std::set<long> digits;
  EXPECT_FALSE(is_short_work([&](long n) { digits.insert(n); }, 2000, -1));
  EXPECT_EQ(*digits.begin(), 30);
  EXPECT_LT(*digits.rbegin(), 2000);
}

TEST(Cost, ModelGoesThroughTheTimesItKnows) {
  const cost_model model({{100, 1e-3}, {10'000, 1e-1}}, multiplication);
  EXPECT_DOUBLE_EQ(model.seconds(10), 1e-3);
  EXPECT_NEAR(model.seconds(1000) / 1e-2, 1, 1e-9);
  EXPECT_NEAR(model.seconds(10'000) / 1e-1, 1, 1e-9);
  EXPECT_THROW(cost_model({}, multiplication), std::invalid_argument);
}

TEST(Cost, ModelIsBoundedFarAway) {
  const auto grows = [](const cost_model& model, long from, long to) {
    return model.seconds(to) / model.seconds(from) / (multiplication(to) / multiplication(from));
  };
  // Times that fall, as those of a program in whose way another was: no less than multiplications
  // and a little more.
  const cost_model falling({{1000, 1.0}, {2000, 0.5}, {4000, 0.1}}, multiplication);
  EXPECT_NEAR(grows(falling, 4000, 16'000), 0.5, 1e-9);
  EXPECT_NEAR(grows(falling, 16'000, 160'000), std::pow(10, 0.1), 1e-9);
  // A last time that is far too great.
  const cost_model rising({{1000, 1e-6}, {2000, 2e-6}, {4000, 1.0}}, multiplication);
  EXPECT_NEAR(grows(rising, 4000, 40'000), 100, 1e-9);
  // One that is too small does not hide how they grew before.
  const cost_model quadrature({{1000, 1000 * multiplication(1000)},
                               {2000, 2000 * multiplication(2000)},
                               {4000, 2000 * multiplication(4000)}},
                              multiplication);
  EXPECT_NEAR(grows(quadrature, 4000, 40'000), std::sqrt(10), 1e-9);
}

TEST(Cost, EstimatesAreOfKnownQuantities) {
  EXPECT_THROW((void)estimate_cost("gamma", 100), std::invalid_argument);
  EXPECT_GT(estimate_cost("epsilon0_min", 1000), 0);
}

}  // namespace measure_test
