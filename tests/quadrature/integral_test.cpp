// Certified integrals: the enclosure, its radius, its price, and every refusal.

#include <gtest/gtest.h>

#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "quadrature/integrands.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"
#include "support/thousand_digits.hpp"

namespace polhode {
namespace integral_test {

using support::agrees;
using support::constant_integrand;
using support::meet;
using support::poisson_kernel;
using support::power_of_cosine;

const oscillating_motion typical{rational(1265, 100), rational(629, 10000), rational(1, 4)};

::testing::AssertionResult certified_to(const periodic_integral& q, long bits) {
  if (q.verdict != status::certified || q.why != reason::none) {
    return ::testing::AssertionFailure() << to_text(q.verdict) << ": " << to_text(q.why);
  }
  if (q.enclosure.radius() <= magnitude::power_of_two(-bits)) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << support::described(q.enclosure);
}

/// G(u) by Bartky's form of the AGM (DLMF 19.22): no quadrature in it.
///   G = pi/(sqrt(b (a+b)) M(sqrt v, sqrt u)) [1 - b + (b/2)(1 - u) sum of Q_n];
/// |Q_(n+1)| <= |Q_n|/2, so what is left after Q_n is at most |Q_n|.
ball half_phase_by_agm(const oscillating_motion& motion, precision bits) {
  const rational& a = motion.a.exact();
  const rational& b = motion.b.exact();
  const rational& u = motion.u;
  ball x = sqrt(ball(rational((a + b * u) / (a + b)), bits));
  ball g = sqrt(ball(u, bits));
  const ball mean = agm(x, g);
  ball pole(1, bits);
  ball term(1, bits);
  ball sum(1, bits);
  const magnitude enough = magnitude::power_of_two(-bits - 8);
  while (!(term.magnitude_upper() <= enough)) {
    const ball square_of_pole = square(pole);
    const ball product = x * g;
    const ball next = (square_of_pole + product) / scale(pole, 1);
    term = scale(term * ((square_of_pole - product) / (square_of_pole + product)), -1);
    sum += term;
    pole = next;
    const ball mean_of_both = scale(x + g, -1);
    g = sqrt(product);
    x = mean_of_both;
    if (term.is_undefined()) break;
  }
  sum = sum.enlarged(term.magnitude_upper());
  return pi(bits) * (rational(1 - b) + scale(rational(b * (1 - u)) * sum, -1)) /
         (sqrt(ball(rational(b * (a + b)), bits)) * mean);
}

TEST(PeriodicIntegral, OfPoissonsKernelIsPi) {
  for (const rational& q : {rational(1, 100), rational(1, 2), rational(9, 10), rational(99, 100)}) {
    for (const long bits : {1L, 2L, 20L, 53L, 64L, 200L, 1000L}) {
      const periodic_integral result = integrate_periodic(poisson_kernel(q), bits);
      EXPECT_TRUE(certified_to(result, bits)) << q << " " << bits;
      EXPECT_TRUE(meet(result.enclosure, pi(bits + 200))) << q << " " << bits;
      // The closed form of the rule, and the proof of what it leaves out.
      const ball left_out =
          rational(1 - poisson_kernel(q).rule_over_pi(result.plan.nodes)) * pi(64);
      EXPECT_TRUE(certainly_less(left_out, result.plan.truncation_error)) << q << " " << bits;
    }
  }
}

TEST(PeriodicIntegral, TakesAsManyNodesAsTheStripAsksFor) {
  // bits log 2/(2 log(1/q)) nodes are needed at least: 27, 500, 175 and 3289. None may be added to
  // these.
  struct row {
    rational q;
    long bits;
    long nodes;
  };
  for (const row& r : {row{rational(1, 2), 53, 33}, row{rational(1, 2), 1000, 514},
                       row{rational(9, 10), 53, 221}, row{rational(9, 10), 1000, 3351}}) {
    const periodic_integral result = integrate_periodic(poisson_kernel(r.q), r.bits);
    EXPECT_TRUE(certified_to(result, r.bits));
    EXPECT_LE(result.plan.nodes, r.nodes) << r.q << " " << r.bits;
    EXPECT_EQ(result.evaluations, result.plan.nodes) << r.q << " " << r.bits;
  }
}

TEST(PeriodicIntegral, OfConstantsAndPolynomials) {
  for (const long bits : {10L, 64L, 500L}) {
    const periodic_integral c = integrate_periodic(constant_integrand(rational(-22, 7)), bits);
    EXPECT_TRUE(certified_to(c, bits));
    EXPECT_TRUE(meet(c.enclosure, rational(-22, 7) * pi(bits + 200)));
    EXPECT_LE(c.plan.nodes, bits / 128 + 2);
    const periodic_integral zero = integrate_periodic(constant_integrand(0), bits);
    EXPECT_TRUE(certified_to(zero, bits));
    EXPECT_TRUE(contains(zero.enclosure, 0L));
    EXPECT_LE(zero.plan.nodes, 2);
    for (const long k : {1L, 2L, 5L, 8L}) {
      const power_of_cosine g(k);
      const periodic_integral result = integrate_periodic(g, bits);
      EXPECT_TRUE(certified_to(result, bits));
      EXPECT_TRUE(meet(result.enclosure, g.integral_over_pi() * pi(bits + 200))) << k;
    }
  }
}

TEST(PeriodicIntegral, GivesAThousandDigitsOfTheHalfPhase) {
  struct row {
    long digits;
    long nodes;
  };
  for (const row& r : {row{20, 24}, row{50, 56}, row{100, 109}, row{333, 355}, row{1000, 1059}}) {
    const long bits = bits_for_digits(r.digits);
    const periodic_integral result = integrate_periodic(half_phase_integrand(typical), bits);
    EXPECT_TRUE(certified_to(result, bits)) << r.digits;
    EXPECT_TRUE(agrees(result.enclosure, support::half_phase_1000, r.digits)) << r.digits;
    EXPECT_TRUE(meet(result.enclosure, half_phase_by_agm(typical, bits + 64))) << r.digits;
    EXPECT_EQ(to_decimal_enclosure(result.enclosure, r.digits - 1).value,
              support::half_phase_1000.substr(0, static_cast<std::size_t>(r.digits)))
        << r.digits;
    EXPECT_LE(result.plan.nodes, r.nodes) << r.digits;
    EXPECT_EQ(result.evaluations, result.plan.nodes) << r.digits;
  }
}

TEST(PeriodicIntegral, OfTheHalfPhaseIsTheAgmsForAnyBody) {
  support::random_source random(2);
  for (support::repeat trial(60); trial.again();) {
    const oscillating_motion motion{rational(random.between(1, 4000), random.between(1, 400)),
                                    rational(random.between(1, 999), 1000),
                                    rational(random.between(1, 1000), 1000)};
    const long bits = random.between(4, 200);
    const periodic_integral result = integrate_periodic(half_phase_integrand(motion), bits);
    EXPECT_TRUE(certified_to(result, bits));
    EXPECT_TRUE(meet(result.enclosure, half_phase_by_agm(motion, bits + 100)))
        << motion.a << " " << motion.b << " " << motion.u;
  }
}

TEST(PeriodicIntegral, AtTheEndsOfU) {
  // u = 1: x = 1 throughout, G = pi (1 - b)/sqrt(b (a + b)), by one node or a few.
  oscillating_motion motion = typical;
  motion.u = 1;
  const periodic_integral at_one = integrate_periodic(half_phase_integrand(motion), 200);
  EXPECT_TRUE(certified_to(at_one, 200));
  EXPECT_LE(at_one.plan.nodes, 2);
  EXPECT_TRUE(agrees(at_one.enclosure,
                     "3.29221487201219790512839704192712880884908772451113321012908", 58));
  // u = 10^-6: 0.35 bits/(2 sqrt u) nodes.
  motion.u = rational(1, 1000000);
  const periodic_integral near_zero = integrate_periodic(half_phase_integrand(motion), 64);
  EXPECT_TRUE(certified_to(near_zero, 64));
  EXPECT_TRUE(meet(near_zero.enclosure, half_phase_by_agm(motion, 200)));
  EXPECT_LE(near_zero.plan.nodes, 14200);
  // u so near 0 that 1 + u is 1 in 64 bits: the strip is still proved, and found too narrow.
  motion.u = parse_rational("1e-30");
  const periodic_integral too_near = integrate_periodic(half_phase_integrand(motion), 64);
  EXPECT_EQ(too_near.verdict, status::not_certified);
  EXPECT_EQ(too_near.why, reason::evaluation_limit);
  EXPECT_TRUE(too_near.enclosure.is_undefined());
}

/// Poisson's kernel with q anywhere in an interval: every member's integral is pi.
class wide_kernel {
 public:
  wide_kernel(rational low, rational high) : low_(std::move(low)), high_(std::move(high)) {}
  template <scalar T>
  [[nodiscard]] auto evaluator(precision p) const {
    const ball q = hull(ball(low_, p), ball(high_, p));
    return [q](const ball& cosine) { return (1 - square(q)) / (1 - 2 * q * cosine + square(q)); };
  }
  [[nodiscard]] std::optional<strip_bound> bound_on_strip(const ball& half_width) const {
    return poisson_kernel(high_).bound_on_strip(half_width);
  }

 private:
  rational low_;
  rational high_;
};

TEST(PeriodicIntegral, TakesIntervalParameters) {
  const wide_kernel g(rational(3, 10), rational(3'000'001, 10'000'000));
  const periodic_integral result = integrate_periodic(g, 15);
  EXPECT_TRUE(certified_to(result, 15));
  EXPECT_TRUE(contains(result.enclosure, pi(200)));
  // No precision makes the parameter narrower: the enclosure is true, and too wide.
  trapezoid_options options;
  options.most_precision = 400;
  const periodic_integral refused = integrate_periodic(g, 60, options);
  EXPECT_EQ(refused.verdict, status::not_certified);
  EXPECT_EQ(refused.why, reason::precision_limit);
  EXPECT_TRUE(contains(refused.enclosure, pi(200)));
}

/// A function that claims to be bounded by 1 on every strip, or on none.
template <bool has_strip, class F>
class bare_integrand {
 public:
  explicit bare_integrand(F f) : f_(std::move(f)) {}
  template <scalar T>
  [[nodiscard]] auto evaluator(precision) const {
    return f_;
  }
  [[nodiscard]] std::optional<strip_bound> bound_on_strip(const ball& half_width) const {
    if (!has_strip) return std::nullopt;
    return strip_bound{half_width, ball(1, half_width.precision())};
  }

 private:
  F f_;
};
template <bool has_strip, class F>
bare_integrand<has_strip, F> bare(F f) {
  return bare_integrand<has_strip, F>(std::move(f));
}

::testing::AssertionResult refused(const periodic_integral& q, reason why) {
  if (q.verdict != status::not_certified || q.why != why) {
    return ::testing::AssertionFailure() << to_text(q.verdict) << ": " << to_text(q.why);
  }
  if (!q.enclosure.is_undefined()) return ::testing::AssertionFailure() << q.enclosure;
  return ::testing::AssertionSuccess();
}

TEST(PeriodicIntegral, RefusesWhatHasNoProof) {
  const auto identity = [](const ball& c) { return c; };
  const periodic_integral no_strip = integrate_periodic(bare<false>(identity), 53);
  EXPECT_TRUE(refused(no_strip, reason::not_analytic));
  EXPECT_EQ(no_strip.plan.nodes, 0);
  EXPECT_EQ(no_strip.evaluations, 0);

  const auto nowhere = [](const ball& c) { return 1 / (c - c); };
  EXPECT_TRUE(refused(integrate_periodic(bare<true>(nowhere), 53), reason::not_defined));

  trapezoid_options options;
  options.most_nodes = 100;
  const periodic_integral many =
      integrate_periodic(half_phase_integrand(typical), bits_for_digits(100), options);
  EXPECT_TRUE(refused(many, reason::evaluation_limit));
  EXPECT_EQ(many.evaluations, 0);
  options.most_nodes = 109;
  EXPECT_EQ(
      integrate_periodic(half_phase_integrand(typical), bits_for_digits(100), options).verdict,
      status::certified);

  options = {};
  options.most_precision = 100;
  EXPECT_TRUE(refused(integrate_periodic(half_phase_integrand(typical), 400, options),
                      reason::precision_limit));
}

/// Bounded by everything.
class unbounded {
 public:
  template <scalar T>
  [[nodiscard]] auto evaluator(precision) const {
    return [](const T& c) -> T { return c; };
  }
  [[nodiscard]] std::optional<strip_bound> bound_on_strip(const ball& half_width) const {
    return strip_bound{half_width, undefined ? ball::undefined(64) : ball::entire(64)};
  }
  bool undefined = false;
};

TEST(PeriodicIntegral, RefusesASupremumThatIsNoNumber) {
  unbounded g;
  EXPECT_TRUE(refused(integrate_periodic(g, 53), reason::not_analytic));
  g.undefined = true;
  EXPECT_TRUE(refused(integrate_periodic(g, 53), reason::not_analytic));
}

TEST(PeriodicPlan, ProvesWhatItPromises) {
  for (const long bits : {-20L, 0L, 1L, 60L, 3400L, 100'000L}) {
    const poisson_kernel g(rational(1, 3));
    const periodic_plan plan = plan_periodic_trapezoid(
        [&](const ball& h) { return g.bound_on_strip(h); }, bits, 1'000'000);
    ASSERT_GT(plan.nodes, 0) << bits;
    EXPECT_EQ(plan.why, reason::none);
    EXPECT_TRUE(plan.truncation_error.magnitude_upper() <= magnitude::power_of_two(-bits));
    EXPECT_TRUE(certainly_positive(plan.strip.half_width));
    // The plan's own strip, asked again, gives its error: the half circle's is half of the
    // circle's.
    EXPECT_TRUE(support::identical(scale(periodic_trapezoid_error(plan.strip, 2 * plan.nodes), -1),
                                   plan.truncation_error));
    // The last node is needed: one sixteenth fewer nodes are not enough with this strip.
    const long fewer = plan.nodes - plan.nodes / 16 - 1;
    if (fewer > 0 && bits > 0) {
      EXPECT_TRUE(scale(periodic_trapezoid_error(plan.strip, 2 * fewer), -1).magnitude_upper() >
                  magnitude::power_of_two(-bits));
    }
  }
}

}  // namespace integral_test
}  // namespace polhode
