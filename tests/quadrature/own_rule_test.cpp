// A rule that is not the library's: made from public headers alone, as a program would.

#include <gtest/gtest.h>

#include <cmath>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/quadrature/clenshaw_curtis.hpp"
#include "polhode/quadrature/error_bounds.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace own_rule_test {

/// Fejer's first rule, with n nodes: even or odd.
class fejer final : public panel_rule {
 public:
  explicit fejer(bool is_odd) : is_odd_(is_odd) {}
  [[nodiscard]] std::string_view name() const override { return "Fejer"; }
  [[nodiscard]] std::string_view purpose() const override { return "on panels"; }
  [[nodiscard]] long nodes_for(double rho, double log2_supremum, double log2_goal) const override {
    const double bits = log2_supremum - log2_goal + 2;
    const auto half = static_cast<long>(std::ceil(std::max(bits, 1.0) / std::log2(rho) / 2));
    return 2 * half + (is_odd_ ? 1 : 2);
  }
  [[nodiscard]] magnitude truncation_error(long n, const ball& rho,
                                           const magnitude& supremum) const override {
    return fejer_error(n, rho, supremum);
  }
  [[nodiscard]] std::shared_ptr<const symmetric_nodes> nodes(long n, precision p) const override {
    return std::make_shared<const symmetric_nodes>(symmetric_half(fejer_rule<ball>(n, p), p));
  }

 private:
  bool is_odd_;
};

/// Three nodes, however many are asked for: its bound says so, and no panel is ever good enough.
class too_few final : public panel_rule {
 public:
  [[nodiscard]] std::string_view name() const override { return "three nodes"; }
  [[nodiscard]] std::string_view purpose() const override { return "for nothing"; }
  [[nodiscard]] long nodes_for(double, double, double) const override { return 3; }
  [[nodiscard]] magnitude truncation_error(long n, const ball& rho,
                                           const magnitude& supremum) const override {
    return fejer_error(n, rho, supremum);
  }
  [[nodiscard]] std::shared_ptr<const symmetric_nodes> nodes(long n, precision p) const override {
    return std::make_shared<const symmetric_nodes>(symmetric_half(fejer_rule<ball>(n, p), p));
  }
};

/// One node, and a weight that is too great by just as much as the bound says: 2^-60.
class off_by_its_bound final : public panel_rule {
 public:
  [[nodiscard]] std::string_view name() const override { return "off by its bound"; }
  [[nodiscard]] std::string_view purpose() const override { return "for constants"; }
  [[nodiscard]] long nodes_for(double, double, double) const override { return 1; }
  [[nodiscard]] magnitude truncation_error(long, const ball&,
                                           const magnitude& supremum) const override {
    return scale(supremum, -60);
  }
  [[nodiscard]] std::shared_ptr<const symmetric_nodes> nodes(long n, precision p) const override {
    symmetric_nodes one;
    one.n = n;
    one.bits = std::max<precision>(p, 100);
    one.nodes = {ball(0, one.bits)};
    one.weights = {2 + scale(ball(1, one.bits), -60)};
    return std::make_shared<const symmetric_nodes>(std::move(one));
  }
};

// On whatever panels: the enclosure ends at the integral.
TEST(OwnRule, CountsTheWholeBoundOfEachPanel) {
  const off_by_its_bound own;
  for (const long length : {1L, 3L, 64L}) {
    const integral i =
        integrate([](const auto& x) { return 0 * x + 1; }, 0, length, {.digits = 10, .rule = own});
    EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
    EXPECT_TRUE(contains(i.enclosure, length)) << length;
    EXPECT_FALSE(contains(i.enclosure, length * (1 - support::power_of_two(-58)))) << length;
  }
}

// With too little memory for one node a panel is bounded by its supremum, which is all of the
// integral of a constant.
TEST(OwnRule, CountsAPanelThatIsNotSummed) {
  const off_by_its_bound own;
  for (const long length : {1L, 3L}) {
    const integral i = integrate([](const auto& x) { return 0 * x + 1; }, 0, length,
                                 {.digits = 10, .most_memory = 1.0, .rule = own});
    EXPECT_NE(i.verdict, status::certified);
    EXPECT_TRUE(contains(i.enclosure, length)) << length;
    EXPECT_TRUE(contains(i.enclosure, 0)) << length;
  }
}

TEST(OwnRule, IntegratesAsTheLibrarysDo) {
  for (const bool is_odd : {false, true}) {
    const fejer own(is_odd);
    for (const long digits : {5L, 30L, 200L}) {
      const integrate_options options{.digits = digits, .rule = own};
      const auto expect = [&](const integral& i, const ball& value) {
        EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
        EXPECT_TRUE(support::meet(i.enclosure, value)) << digits;
        EXPECT_TRUE(options.goal().is_met_by(i.enclosure)) << digits;
        ASSERT_FALSE(i.account.rules.empty());
        EXPECT_EQ(to_text(i.account.rules.front()), "Fejer");
      };
      const precision p = 800;
      expect(integrate([](const auto& x) { return exp(x); }, 0, 1, options), exp(ball(1, p)) - 1);
      expect(integrate([](const auto& x) { return 1 / (1 + 25 * x * x); }, -1, 1, options),
             2 * atan(ball(5, p)) / 5);
      expect(integrate([](const auto& x) { return log(x); }, 0, 1, options), ball(-1, p));
      expect(integrate([](const auto& x) { return exp(-x * x); }, -end_point::infinity(),
                       end_point::infinity(), options),
             sqrt(pi(p)));
    }
  }
}

TEST(OwnRule, IsToldByItsObject) {
  const fejer one(false);
  const fejer other(true);
  EXPECT_TRUE(quadrature_rule(one) == quadrature_rule(one));
  EXPECT_FALSE(quadrature_rule(one) == quadrature_rule(other));
  EXPECT_FALSE(quadrature_rule(one).is_automatic());
  EXPECT_EQ(quadrature_rule(one).word(), "fejer");
  EXPECT_FALSE(quadrature_rule::named("fejer"));
}

TEST(OwnRule, WithTooFewNodesIsNotCertified) {
  const too_few own;
  const integral i =
      integrate([](const auto& x) { return exp(x); }, 0, 1, {.digits = 60, .rule = own});
  EXPECT_NE(i.verdict, status::certified);
  EXPECT_TRUE(support::meet(i.enclosure, exp(ball(1, 300)) - 1));
}

}  // namespace own_rule_test
}  // namespace polhode
