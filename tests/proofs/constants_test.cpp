// The paper's constants to a thousand digits and more, by routes that share no formula.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "polhode/roots/newton.hpp"
#include "proofs/beta.hpp"
#include "proofs/claim.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"
#include "support/thousand_digits.hpp"

#ifdef POLHODE_HAVE_ARB
#include <arb.h>
#endif

namespace polhode::proofs {
namespace constants_test {

using support::meet;

const constant& named(const std::string& name) {
  const constant* c = find_constant(name);
  if (c == nullptr) throw std::logic_error(name);
  return *c;
}

std::string digits_of(const std::string& name, long digits) {
  return to_decimal_enclosure(enclose_to_digits(named(name), digits), digits).value;
}

/// The first so many significant digits of "0.0289..." or "2.96...".
std::string cut_off(std::string_view decimal, long digits) {
  std::string result;
  long count = 0;
  for (const char c : decimal) {
    if (count == digits) break;
    result += c;
    if (c != '.' && (count > 0 || c != '0')) ++count;
  }
  return result;
}

constexpr std::array names = {"epsilon0_min", "delta_psi_max", "beta"};

TEST(Constants, AreListed) {
  EXPECT_EQ(all_constants().size(), names.size());
  for (const char* name : names) {
    ASSERT_NE(find_constant(name), nullptr);
    EXPECT_EQ(find_constant(name)->name, name);
    EXPECT_GT(estimated_memory(named(name), 1'000'000), 415'000.0);
  }
  EXPECT_EQ(find_constant(""), nullptr);
  EXPECT_EQ(find_constant("Beta"), nullptr);
}

TEST(Constants, HaveTheDigitsOfMpmath) {
  for (const long digits : {1L, 2L, 3L, 10L, 50L, 100L, 333L, 999L, 1000L}) {
    EXPECT_EQ(digits_of("beta", digits), cut_off(support::beta_1000, digits));
    EXPECT_EQ(digits_of("epsilon0_min", digits), cut_off(support::epsilon0_min_1000, digits));
    EXPECT_EQ(digits_of("delta_psi_max", digits), cut_off(support::delta_psi_max_1000, digits));
  }
}

TEST(Constants, KeepTheirDigitsWhenMoreAreAskedFor) {
  support::random_source random(20);
  for (const char* name : names) {
    for (support::repeat trial(40); trial.again();) {
      const long digits = random.between(1, 1500);
      const std::string more = digits_of(name, digits + 37);
      const std::string fewer = digits_of(name, digits);
      EXPECT_EQ(more.substr(0, fewer.size()), fewer) << name << " " << digits;
      const auto count = [](const std::string& text) {
        return std::count_if(text.begin(), text.end(), [](char c) { return c != '.'; });
      };
      EXPECT_EQ(count(more), count(fewer) + 37) << name << " " << digits;
    }
  }
}

TEST(Constants, ShrinkWithThePrecision) {
  for (const char* name : names) {
    for (const precision p : {40L, 64L, 100L, 1000L, 20'000L}) {
      const ball x = named(name).enclose(p);
      EXPECT_TRUE(support::as_narrow_as(x, p - 16)) << name << " " << p;
      EXPECT_TRUE(meet(x, named(name).enclose(2 * p))) << name << " " << p;
    }
  }
}

TEST(Constants, AreGivenWithTheDigitsAskedForOrNotAtAll) {
  // A "constant" of which no precision shows a digit to cut off, an enclosure that holds 1 inside:
  // it is about 1. One that is too wide for that, and one that is undefined.
  const constant nines{
      "nines", "", [](precision p) { return ball(1, p).enlarged(magnitude::power_of_two(-p)); }, 1};
  const decimal_enclosure about_one = to_decimal_enclosure(enclose_to_digits(nines, 5), 5);
  EXPECT_EQ(about_one.value, "1");
  EXPECT_TRUE(about_one.has(5));
  EXPECT_FALSE(about_one.has_cut(5));
  const constant wide{
      "wide", "", [](precision p) { return ball(1, p).enlarged(magnitude::power_of_two(-60)); }, 1};
  EXPECT_TRUE(enclose_to_digits(wide, 5).is_undefined());
  const constant nothing{"nothing", "", [](precision p) { return ball::undefined(p); }, 1};
  EXPECT_TRUE(enclose_to_digits(nothing, 5).is_undefined());
  const constant everything{"everything", "", [](precision p) { return ball::entire(p); }, 1};
  EXPECT_TRUE(enclose_to_digits(everything, 5).is_undefined());
  // 1 + 10^-60: 50 digits of it are certain only with 200 bits and more.
  const constant close{"close", "",
                       [](precision p) {
                         return ball(rational(1 + support::power_of_ten(-60)), p)
                             .enlarged(magnitude::power_of_two(2 - p));
                       },
                       1};
  const ball x = enclose_to_digits(close, 50);
  EXPECT_EQ(to_decimal_enclosure(x, 50).value, "1." + std::string(49, '0'));
  EXPECT_THROW((void)enclose_to_digits(named("beta"), 0), std::invalid_argument);
  EXPECT_THROW((void)enclose_to_digits(named("beta"), -3), std::invalid_argument);
}

/// 1/sqrt(x + cos^2(t/2)), for the complete integral without an AGM.
class inverse_root {
 public:
  explicit inverse_root(rational x) : x_(std::move(x)) {}
  template <scalar T>
  [[nodiscard]] auto evaluator(precision p) const {
    const T shift = scalar_from<T>(rational(2 * x_ + 1), p);
    const T root_two = sqrt(scalar_from<T>(2, p));
    return [=](const T& cosine) -> T { return root_two / sqrt(T(shift + cosine)); };
  }
  [[nodiscard]] std::optional<strip_bound> bound_on_strip(const ball& half_width) const {
    const ball twice_least = rational(2 * x_ + 1) - cosh(half_width);
    if (!certainly_positive(twice_least)) return std::nullopt;
    return strip_bound{half_width, sqrt(2 / twice_least)};
  }

 private:
  rational x_;
};

TEST(Beta, IsTheRootByQuadratureOfKToAThousandDigits) {
  // integral over (0, pi) of (x + cos^2(t/2))^(-1/2) dt = 2 K(1/(1+x))/sqrt(1+x) falls in x, and is
  // 2 pi at beta.
  const rational below = parse_rational(digits_of("beta", 1000));
  const rational above = below + support::power_of_ten(-1001);
  const long bits = bits_for_digits(1000) + 24;
  const auto excess = [&](const rational& x) {
    const periodic_integral q = integrate_periodic(inverse_root(x), bits);
    EXPECT_EQ(q.verdict, status::certified);
    return sign_of(q.enclosure - 2 * pi(bits + 64));
  };
  EXPECT_EQ(excess(below), certain_sign::positive);
  EXPECT_EQ(excess(above), certain_sign::negative);
}

TEST(Beta, IsOneSimpleRootForAnyPrecision) {
  for (const precision p : {2L, 10L, 36L, 64L, 100L, 3400L, 33'000L}) {
    const root_enclosure root = enclose_beta(p);
    EXPECT_EQ(root.verdict, root_verdict::unique) << p;
    EXPECT_TRUE(certainly_positive(root.derivative)) << p;
    EXPECT_TRUE(contains(root.box, root.image)) << p;
    EXPECT_TRUE(meet(root.root, enclose_beta(200).root)) << p;
    // The box is that of 48 bits: the steps are those that double them.
    EXPECT_LE(root.evaluations_of_f, p <= 100 ? 4 : p <= 3400 ? 9 : 13) << p;
  }
  // M(sqrt(1+x), sqrt x) = 1/2 at the root, and crosses it upwards.
  const ball root = enclose_beta(300).root;
  EXPECT_TRUE(contains_zero(agm(sqrt(1 + root), sqrt(root)) - rational(1, 2)));
  const ball step = scale(ball(1, 300), -280);
  EXPECT_TRUE(certainly_negative(agm(sqrt(1 + root - step), sqrt(root - step)) - rational(1, 2)));
  EXPECT_TRUE(certainly_positive(agm(sqrt(1 + root + step), sqrt(root + step)) - rational(1, 2)));
  // f' = M E/(2 x K): the box's enclosure of it holds the difference quotient.
  const ball wide = enclose_beta(64).box;
  const auto f = [](const ball& x) { return agm(sqrt(1 + x), sqrt(x)); };
  const ball low = ball(lower_rational(wide), 300);
  const ball high = ball(upper_rational(wide), 300);
  EXPECT_TRUE(meet((f(high) - f(low)) / (high - low), enclose_beta(64).derivative));
}

TEST(Epsilon0Min, IsTheRootOfItsOwnEquationToAThousandDigits) {
  // log(tan(x/2)) = -pi by interval Newton, where the constant is pi - 2 arctan(e^pi).
  const auto f = [](const ball& x) { return log(tan(scale(x, -1))) + pi(x.precision()); };
  const auto derivative = [](const ball& x) { return 1 / sin(x); };
  const ball box = hull(ball(rational(1, 20), 64), ball(rational(1, 10), 64));
  const root_enclosure root = refine_root(f, derivative, box, bits_for_digits(1000) + 32);
  ASSERT_EQ(root.verdict, root_verdict::unique);
  EXPECT_EQ(to_decimal_enclosure(root.root, 1000).value, digits_of("epsilon0_min", 1000));
  const ball other = pi(3400) - 2 * root.root;
  EXPECT_EQ(to_decimal_enclosure(other, 1000).value, digits_of("delta_psi_max", 1000));
}

#ifdef POLHODE_HAVE_ARB
/// Two Arb balls' worth of digits: x as a ball of this library, outward.
class arb_number {
 public:
  arb_number() { arb_init(x_); }
  arb_number(const arb_number&) = delete;
  arb_number& operator=(const arb_number&) = delete;
  ~arb_number() { arb_clear(x_); }
  [[nodiscard]] arb_ptr get() { return x_; }
  [[nodiscard]] ball to_ball(precision p) {
    support::real low(p);
    support::real high(p);
    arb_get_interval_mpfr(low, high, x_);
    return ball::from_end_points(low, high, p);
  }

 private:
  arb_t x_;
};

TEST(Constants, AreArbsToTenThousandDigits) {
  constexpr long digits = 10'000;
  const precision p = bits_for_digits(digits) + 64;
  arb_number pi_value;
  arb_number x;
  arb_const_pi(pi_value.get(), p);
  arb_neg(x.get(), pi_value.get());
  arb_exp(x.get(), x.get(), p);
  arb_atan(x.get(), x.get(), p);
  arb_mul_2exp_si(x.get(), x.get(), 1);
  EXPECT_EQ(to_decimal_enclosure(x.to_ball(p), digits).value, digits_of("epsilon0_min", digits));
  arb_mul_2exp_si(x.get(), x.get(), 1);
  arb_sub(x.get(), pi_value.get(), x.get(), p);
  EXPECT_EQ(to_decimal_enclosure(x.to_ball(p), digits).value, digits_of("delta_psi_max", digits));
  // beta: Arb's AGM on both sides of the last digit.
  const auto sign_at = [&](const rational& q) {
    arb_number a;
    arb_number b;
    fmpq_t exact;
    fmpq_init(exact);
    fmpq_set_mpq(exact, q.backend().data());
    arb_set_fmpq(b.get(), exact, p);
    fmpq_clear(exact);
    arb_add_ui(a.get(), b.get(), 1, p);
    arb_sqrt(a.get(), a.get(), p);
    arb_sqrt(b.get(), b.get(), p);
    arb_agm(a.get(), a.get(), b.get(), p);
    arb_mul_2exp_si(a.get(), a.get(), 1);
    arb_sub_ui(a.get(), a.get(), 1, p);
    return arb_is_positive(a.get()) != 0 ? 1 : arb_is_negative(a.get()) != 0 ? -1 : 0;
  };
  const rational below = parse_rational(digits_of("beta", digits));
  EXPECT_EQ(sign_at(below), -1);
  EXPECT_EQ(sign_at(below + support::power_of_ten(-digits - 1)), 1);
}
#endif

}  // namespace constants_test
}  // namespace polhode::proofs
