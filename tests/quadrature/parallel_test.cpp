// The same bits on any number of threads.

#include <atomic>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "quadrature/formula/integrand.hpp"
#include "quadrature/known_integrals.hpp"
#include "support/exact_set.hpp"

namespace polhode {
namespace parallel_test {

TEST(ParallelIntegral, HasTheSameBitsOnAnyNumberOfThreads) {
  const auto check = [](const std::string& name, const auto& f, const end_point& a,
                        const end_point& b, quadrature_rule rule = quadrature_rule::automatic) {
    for (const long digits : {40L, 200L}) {
      const integral one = integrate(f, a, b, {.digits = digits, .rule = rule});
      EXPECT_EQ(one.verdict, status::certified) << name;
      for (const int threads : {0, 2, 3, 8}) {
        const integral other =
            integrate(f, a, b, {.digits = digits, .rule = rule, .threads = threads});
        EXPECT_TRUE(support::identical(one.enclosure, other.enclosure)) << name << ", " << threads;
        EXPECT_EQ(one.account.evaluations, other.account.evaluations);
      }
    }
  };
  const end_point infinity = end_point::infinity();
  check(
      "panels", [](const auto& x) { return 1 / (1 + 25 * square(x)) + log(x + 3); }, -1, 1);
  check(
      "a period", [](const auto& x) { return sqrt(3 + cos(x) + sin(2 * x)); }, 0, end_point::pi(2));
  check(
      "an end", [](const auto& x) { return log(x) * cos(x); }, 0, 1);
  check(
      "tails", [](const auto& x) { return exp(-x * x); }, -infinity, infinity,
      quadrature_rule::gauss_legendre);
}

/// Counts the evaluators that were made, and sees to it that each is called by one thread.
struct counts {
  std::atomic<long> evaluators = 0;
  std::atomic<long> shared = 0;
};

TEST(ParallelIntegral, MakesAnEvaluatorForEachThread) {
  counts seen;
  detail::integrand f = integrand_of(formula_of([](const auto& x) { return 1 / (2 + x); }));
  f.evaluator = [&seen, plain = f.evaluator](precision p) -> std::function<ball(const ball&)> {
    ++seen.evaluators;
    return [&seen, g = plain(p), owner = std::make_shared<std::thread::id>()](const ball& x) {
      if (*owner == std::thread::id()) *owner = std::this_thread::get_id();
      if (*owner != std::this_thread::get_id()) ++seen.shared;
      return g(x);
    };
  };
  const integral i = detail::integrate_function(
      f, 0, 1, {.digits = 300, .rule = quadrature_rule::gauss_legendre, .threads = 8});
  EXPECT_EQ(i.verdict, status::certified);
  EXPECT_GE(seen.evaluators, 1);
  EXPECT_EQ(seen.shared, 0);
}

TEST(ParallelIntegral, PassesOnWhatTheIntegrandThrows) {
  detail::integrand f = integrand_of(formula_of([](const auto& x) { return log(x + 2); }));
  f.evaluator = [plain = f.evaluator](precision p) -> std::function<ball(const ball&)> {
    return [g = plain(p)](const ball& x) {
      if (x.precision() > 2000) throw std::runtime_error("thrown by the integrand");
      return g(x);
    };
  };
  for (const int threads : {1, 3}) {
    EXPECT_THROW((void)detail::integrate_function(f, 0, 1, {.digits = 900, .threads = threads}),
                 std::runtime_error);
  }
}

TEST(ParallelIntegral, RefusesANegativeNumberOfThreads) {
  const auto f = [](const auto& x) { return exp(x); };
  EXPECT_THROW((void)integrate(f, 0, 1, {.threads = -1}), std::invalid_argument);
}

}  // namespace parallel_test
}  // namespace polhode
