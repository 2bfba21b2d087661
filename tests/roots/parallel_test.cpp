// The same search, and the same bits, on any number of threads.

#include <atomic>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "polhode/roots/isolate.hpp"
#include "support/exact_set.hpp"

namespace polhode {
namespace parallel_test {

using support::identical;

void expect_same(const root_set& one, const root_set& other) {
  ASSERT_EQ(one.regions.size(), other.regions.size());
  for (std::size_t i = 0; i < one.regions.size(); ++i) {
    const root_region& r = one.regions[i];
    const root_region& s = other.regions[i];
    EXPECT_EQ(r.verdict, s.verdict);
    EXPECT_TRUE(identical(r.box, s.box));
    EXPECT_TRUE(identical(r.enclosure, s.enclosure));
    EXPECT_EQ(r.multiplicity, s.multiplicity);
    EXPECT_EQ(r.exact, s.exact);
    EXPECT_EQ(r.complex_roots, s.complex_roots);
    EXPECT_EQ(r.may_lie_outside, s.may_lie_outside);
    EXPECT_EQ(r.remark, s.remark);
  }
  ASSERT_EQ(one.singular.size(), other.singular.size());
  for (std::size_t i = 0; i < one.singular.size(); ++i) {
    EXPECT_TRUE(identical(one.singular[i].place, other.singular[i].place));
    EXPECT_EQ(one.singular[i].pole_order, other.singular[i].pole_order);
  }
  EXPECT_EQ(one.identically_zero, other.identically_zero);
  EXPECT_EQ(one.complete, other.complete);
  EXPECT_EQ(one.account.evaluations, other.account.evaluations);
  EXPECT_EQ(one.account.boxes, other.account.boxes);
  EXPECT_EQ(one.account.most_bits, other.account.most_bits);
}

void expect_same_on_any_number(const std::string& name, const real_function& f,
                               const end_point& lower, const end_point& upper,
                               isolate_options options = {}) {
  const root_set one = isolate_roots(f, lower, upper, options);
  for (const int threads : {0, 2, 3, 8}) {
    SCOPED_TRACE(name + ", " + std::to_string(threads));
    options.threads = threads;
    expect_same(one, isolate_roots(f, lower, upper, options));
  }
}

TEST(ParallelRoots, AreTheSameOnAnyNumberOfThreads) {
  const auto infinity = end_point::infinity();
  const auto minus_infinity = -end_point::infinity();
  const auto check = expect_same_on_any_number;
  check("many", [](const auto& x) { return sin(square(x)); }, 0, 20, {});
  check("a point", [](const auto& x) { return sin(1 / x); }, rational(1, 200), 1, {});
  check("common ends", [](const auto& x) { return sinh(x) * (x - 1) * (x - 2); }, -4, 4, {});
  check("poles", [](const auto& x) { return tan(x) - x; }, -10, 10, {});
  check("double roots", [](const auto& x) { return square(sin(x)) * exp(x); }, 2, 10, {});
  check("open", [](const auto& x) { return 1 - cos(x); }, 1, 20, {});
  check("jumps", [](const auto& x) { return floor(x) - rational(1, 2); }, 0, 4, {});
  check("not defined", [](const auto& x) { return sqrt(x) - rational(1, 2); }, -1, 1, {});
  check("tails", [](const auto& x) { return exp(x) - square(x) * 3; }, minus_infinity, infinity,
        {});
  check("polynomial",
        [](const auto& x) { return (x - 1) * pow(square(x) - 2, 3) * (pow(x, 5) - x + 1); },
        minus_infinity, infinity, {});
  check("zero on an interval", [](const auto& x) { return abs(x) - x; }, -1, 1,
        {.most_unresolved = 200});
}

TEST(ParallelRoots, StopAtTheSamePlaceAndGoOn) {
  const auto f = [](const auto& x) { return sin(square(x)) * (x - 1); };
  const auto steps = [&](int threads) {
    root_search s(f, 0, 10);
    std::vector<root_set> results;
    for (const long boxes : {7L, 20L, 1L, 1000L}) {
      s.run({.most_boxes = boxes, .threads = threads});
      results.push_back(s.result());
    }
    EXPECT_TRUE(s.is_finished());
    return results;
  };
  const std::vector<root_set> one = steps(1);
  for (const int threads : {2, 3, 8}) {
    const std::vector<root_set> other = steps(threads);
    for (std::size_t i = 0; i < one.size(); ++i) expect_same(one[i], other[i]);
  }
}

TEST(ParallelRoots, AreRefinedToTheSameBits) {
  const auto f = [](const auto& x) { return sin(square(x)) * (x - rational(1, 3)); };
  const std::vector<root_region> regions = isolate_roots(f, -1, 10).regions;
  for (const int threads : {0, 1, 2, 8}) {
    const std::vector<refined_root> roots = refine(regions, 100, threads);
    ASSERT_EQ(roots.size(), regions.size());
    for (std::size_t i = 0; i < regions.size(); ++i) {
      const refined_root one = refine(regions[i], 100);
      EXPECT_TRUE(identical(roots[i].enclosure, one.enclosure));
      EXPECT_EQ(roots[i].exact, one.exact);
      EXPECT_EQ(roots[i].verdict, status::certified);
    }
  }
}

/// Counts the evaluators that were made, sees to it that each is called by one thread, and how many
/// threads there are.
struct counts {
  std::atomic<long> evaluators = 0;
  std::atomic<long> shared = 0;
  std::atomic<long> elsewhere = 0;
  std::thread::id caller = std::this_thread::get_id();
};

/// f with `seen` called before each value, slope and series of one evaluator.
template <class Seen>
real_function watched(const real_function& f, const Seen& seen) {
  return real_function(
      [f, seen](precision p) {
        function_evaluator e = *f.at(p);
        const auto look = seen();
        e.value = [look, g = e.value](const ball& x) { return look(x), g(x); };
        e.derivative = [look, g = e.derivative](const ball& x) { return look(x), g(x); };
        e.slope = [look, g = e.slope](const ball& x) { return look(x), g(x); };
        e.series = [look, g = e.series](const ball& x, int n) { return look(x), g(x, n); };
        return e;
      },
      64);
}

TEST(ParallelRoots, MakesAnEvaluatorForEachThread) {
  const auto with = [](counts& seen) {
    return watched([](const auto& x) { return sin(square(x)); },
                   [&seen] {
                     ++seen.evaluators;
                     return [&seen, owner = std::make_shared<std::thread::id>()](const ball&) {
                       const auto here = std::this_thread::get_id();
                       if (*owner == std::thread::id()) *owner = here;
                       if (*owner != here) ++seen.shared;
                       if (here != seen.caller) ++seen.elsewhere;
                     };
                   });
  };
  counts seen;
  EXPECT_TRUE(isolate_roots(with(seen), 1, 30, {.threads = 8}).is_resolved());
  EXPECT_GE(seen.evaluators, 1);
  EXPECT_EQ(seen.shared, 0);
  counts alone;
  EXPECT_TRUE(isolate_roots(with(alone), 1, 30).is_resolved());
  EXPECT_EQ(alone.elsewhere, 0);
}

/// More threads come by the place where it throws before its turn.
TEST(ParallelRoots, ThrowWhatTheFunctionThrowsInItsTurn) {
  const real_function f = watched([](const auto& x) { return sin(7 * x); },
                                  [] {
                                    return [](const ball& x) {
                                      if (!x.is_undefined() && certainly_less(ball(3, 64), x)) {
                                        throw std::runtime_error("thrown by the function");
                                      }
                                    };
                                  });
  for (const int threads : {1, 3}) {
    EXPECT_THROW((void)isolate_roots(f, -4, 4, {.threads = threads}), std::runtime_error);
    root_search s(f, -4, 4);
    s.run({.most_boxes = 5, .threads = threads});
    const root_set before = s.result();
    EXPECT_THROW(s.run({.threads = threads}), std::runtime_error);
    expect_same(before, s.result());
  }
}

TEST(ParallelRoots, RefuseANegativeNumberOfThreads) {
  const auto f = [](const auto& x) { return exp(x) - 2; };
  EXPECT_THROW((void)isolate_roots(f, 0, 1, {.threads = -1}), std::invalid_argument);
  EXPECT_THROW((void)refine(std::vector<root_region>{}, 10, -1), std::invalid_argument);
}

}  // namespace parallel_test
}  // namespace polhode
