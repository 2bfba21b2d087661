// The same call gives the same bits on every thread, whatever that thread's defaults are. This is a
// program of its own because it is the one that the thread sanitizer is asked about.

#include <cstddef>
#include <latch>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/exact_set.hpp"
#include "support/functions.hpp"
#include "support/random.hpp"

namespace polhode {
namespace threads_test {

using support::identical;
using support::random_source;

struct record {
  std::vector<ball> balls;
  std::vector<std::string> texts;
};

/// Every operation, on operands that are drawn the same way each time.
record compute() {
  record r;
  random_source random(1000);
  for (int i = 0; i < 150; ++i) {
    const ball x = random.any_ball();
    const ball y = random.any_ball();
    for (const ball& z : {x + y,
                          x - y,
                          x * y,
                          x / y,
                          x + 3L,
                          5L - x,
                          x * 7L,
                          x / 9L,
                          x * rational(1, 7),
                          -x,
                          square(x),
                          sqrt(x),
                          abs(x),
                          scale(x, 5),
                          pow(x, 5),
                          pow(x, -3),
                          hypot(x, y),
                          agm(x, y),
                          hull(x, y),
                          intersection(x, y),
                          x.with_precision(70),
                          x.middle(),
                          sin_cos(x).first,
                          sin_cos(x).second}) {
      r.balls.push_back(z);
    }
    for (const support::elementary_function& f : support::elementary_functions()) {
      r.balls.push_back(f.of(x));
    }
    if (x.is_bounded()) {
      r.balls.emplace_back(midpoint(x));
      r.balls.emplace_back(lower(x));
      r.texts.push_back(to_decimal(x, 20));
      r.texts.push_back(to_text(lower_rational(x)));
    }
    r.balls.push_back(parse_ball("-12.0625e-3", random.any_precision()));
    r.balls.push_back(pi(random.any_precision()));
    r.balls.push_back(log_2(random.any_precision()));
  }
  return r;
}

void expect_same(const record& one, const record& other) {
  ASSERT_EQ(one.balls.size(), other.balls.size());
  for (std::size_t i = 0; i < one.balls.size(); ++i) {
    ASSERT_TRUE(identical(one.balls[i], other.balls[i])) << i;
  }
  EXPECT_EQ(one.texts, other.texts);
}

// What the sanitizer cannot see into: MPFR's caches of pi and log 2, which grow as threads ask for
// more.
TEST(Threads, EachHasItsOwnConstants) { EXPECT_NE(mpfr_buildopt_tls_p(), 0); }

TEST(Threads, DefaultsOfAThreadDoNotChangeABit) {
  const record expected = compute();
  record plain;
  record changed;
  std::thread one([&] { plain = compute(); });
  std::thread other([&] {
    mpfr_float::thread_default_precision(7);
    mpfr_set_default_prec(11);
    mpfr_set_default_rounding_mode(MPFR_RNDU);
    changed = compute();
    mpfr_free_cache();
  });
  one.join();
  other.join();
  expect_same(expected, plain);
  expect_same(expected, changed);
}

TEST(Threads, DefaultsOfThisThreadNeither) {
  const record expected = compute();
  const unsigned digits = mpfr_float::thread_default_precision();
  const mpfr_prec_t bits = mpfr_get_default_prec();
  for (const mpfr_rnd_t rounding : {MPFR_RNDU, MPFR_RNDD, MPFR_RNDZ, MPFR_RNDA}) {
    mpfr_float::thread_default_precision(3 + static_cast<unsigned>(rounding));
    mpfr_set_default_prec(5);
    mpfr_set_default_rounding_mode(rounding);
    expect_same(expected, compute());
  }
  mpfr_set_default_rounding_mode(MPFR_RNDN);
  mpfr_set_default_prec(bits);
  mpfr_float::thread_default_precision(digits);
}

// They wait for each other, so that they start with empty caches at the same time.
TEST(Threads, ManyAtOnce) {
  std::vector<record> records(4);
  std::latch all_here(static_cast<std::ptrdiff_t>(records.size()));
  std::vector<std::thread> threads;
  threads.reserve(records.size());
  for (record& r : records) {
    threads.emplace_back([&r, &all_here] {
      all_here.arrive_and_wait();
      r = compute();
    });
  }
  for (std::thread& t : threads) t.join();
  const record expected = compute();
  for (const record& r : records) expect_same(expected, r);
}

/// A formula, by its evaluators.
struct formula {
  expression f;
  [[nodiscard]] region operator()(const region& x) const { return f(x); }
  [[nodiscard]] ball operator()(const ball& x) const { return f(x); }
  template <class T>
  [[nodiscard]] T operator()(const T& x) const {
    return 1 / (2 + sin(x)) + exp(x);  // as below: what the ends and symmetries are asked with
  }
  template <class T>
  requires std::same_as<T, ball>
  [[nodiscard]] auto evaluator(precision p) const { return f.evaluator<ball>(p); }
};

// Nodes on several threads; and several threads that each do so, with one cache of nodes.
TEST(Threads, IntegralsAreTheSameInside) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "oneTBB as it is distributed is not built for the thread sanitizer";
#endif
  const auto periodic = [](const auto& x) { return sqrt(3 + cos(x) * sin(x)); };
  const auto all = [&](int threads) {
    const integrate_options options{.digits = 120, .threads = threads};
    const formula sum{expression("1/(2+sin(x)) + exp(x)", {{"x"}, {}})};
    record r;
    r.balls.push_back(integrate(sum, 0, 1, options).enclosure);
    r.balls.push_back(integrate(periodic, 0, end_point::pi(), options).enclosure);
    return r;
  };
  const record expected = all(1);
  for (const ball& x : expected.balls) ASSERT_TRUE(x.is_bounded());
  expect_same(expected, all(4));
  std::vector<record> records(2);
  std::vector<std::thread> threads;
  threads.reserve(records.size());
  for (record& r : records) {
    threads.emplace_back([&r, &all] { r = all(3); });
  }
  for (std::thread& t : threads) t.join();
  for (const record& r : records) expect_same(expected, r);
}

}  // namespace threads_test
}  // namespace polhode
