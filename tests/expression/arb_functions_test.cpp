// The special functions of Arb: values beside Boost.Math's, identities between them, containment
// over sets, derivatives, majorants, and refusals.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/special_functions/airy.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/expint.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/lambert_w.hpp>
#include <boost/math/special_functions/polygamma.hpp>
#include <boost/math/special_functions/zeta.hpp>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"
#include "support/random.hpp"

namespace polhode {
namespace arb_functions_test {

class ArbFunctions : public ::testing::Test {
 protected:
  void SetUp() override {
    if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  }
  support::random_source random{20261129};

  rational between(long low, long high) {
    return low + rational(random.between(0, (high - low) * 1000), 1000);
  }
  /// Of any order of magnitude from 2^-10 to 2^most.
  rational scattered(long most) {
    const long e = random.between(-10, most);
    const rational power = e < 0 ? rational(1, 1L << -e) : rational(1L << e);
    return between(1, 2) * power;
  }
  rational order() {
    switch (random.between(0, 3)) {
      case 0:
        return random.between(0, 3);
      case 1:
        return random.between(-12, 40);
      case 2:
        return rational(random.between(-9, 9), 2);
      default:
        return between(-6, 12);
    }
  }
};

const further_function& named(const std::string& name) {
  return *std::find_if(arb_functions()->begin(), arb_functions()->end(),
                       [&](const further_function& f) { return f.what.name == name; });
}
ball value(const std::string& text, precision p = 200) { return parse(text, {}).value(p); }

TEST_F(ArbFunctions, HaveTheValuesOfBoost) {
  using std::abs;
  const auto expect = [](const ball& ours, double theirs, const std::string& what) {
    const double value = midpoint(ours).convert_to<double>();
    EXPECT_LE(abs(value - theirs), 1e-11 * std::max(abs(theirs), 1e-3)) << what;
  };
  for (support::repeat trial(60); trial.again();) {
    const rational nu(random.between(0, 40), 4);
    const rational x = between(0, 20) + rational(1, 64);
    const auto n = nu.convert_to<double>();
    const auto t = x.convert_to<double>();
    const ball a(nu, 128);
    const ball b(x, 128);
    const std::string at = nu.str() + ", " + x.str();
    const auto of_two = [&](const char* name) { return named(name).value(std::array{a, b}); };
    const auto of_one = [&](const char* name) { return named(name).value(std::array{b}); };
    expect(of_two("besselJ"), boost::math::cyl_bessel_j(n, t), "J " + at);
    expect(of_two("besselY"), boost::math::cyl_neumann(n, t), "Y " + at);
    expect(of_two("besselI"), boost::math::cyl_bessel_i(n, t), "I " + at);
    expect(of_two("besselK"), boost::math::cyl_bessel_k(n, t), "K " + at);
    expect(of_one("airyAi"), boost::math::airy_ai(t), "Ai " + at);
    expect(of_one("airyBi"), boost::math::airy_bi(t), "Bi " + at);
    expect(of_one("airyAiPrime"), boost::math::airy_ai_prime(t), "Ai' " + at);
    expect(of_one("airyBiPrime"), boost::math::airy_bi_prime(t), "Bi' " + at);
    expect(named("airyAi").value(std::array{-b}), boost::math::airy_ai(-t), "Ai -" + at);
    expect(of_one("Ei"), boost::math::expint(t), "Ei " + at);
    expect(named("Ei").value(std::array{-b}), boost::math::expint(-t), "Ei -" + at);
    expect(named("expint").value(std::array{ball(3, 128), b}), boost::math::expint(3U, t),
           "E_3 " + at);
    expect(of_one("lambertW"), boost::math::lambert_w0(t), "W " + at);
    expect(of_one("digamma"), boost::math::digamma(t), "digamma " + at);
    expect(of_one("zeta"), boost::math::zeta(t), "zeta " + at);
    if (nu > 0) {
      expect(of_two("gammaUpper"), boost::math::tgamma(n, t), "upper " + at);
      expect(of_two("gammaLower"), boost::math::tgamma_lower(n, t), "lower " + at);
    }
    expect(named("polygamma").value(std::array{ball(3, 128), b}), boost::math::polygamma(3, t),
           "polygamma " + at);
    expect(named("zeta").value(std::array{-b}), boost::math::zeta(-t), "zeta -" + at);
  }
}

TEST_F(ArbFunctions, AreTiedByIdentities) {
  for (support::repeat trial(40); trial.again();) {
    const ball n(order(), 200);
    const ball x(scattered(5), 200);
    const auto f = [](const char* name, const ball& a, const ball& b) {
      return named(name).value(std::array{a, b});
    };
    const auto g = [](const char* name, const ball& a) { return named(name).value(std::array{a}); };
    // DLMF 10.5.2, 10.28.2, 9.2.7, 8.19.12, 25.12.6.
    EXPECT_TRUE(contains_zero(f("besselJ", n + 1, x) * f("besselY", n, x) -
                              f("besselJ", n, x) * f("besselY", n + 1, x) - 2 / (pi(200) * x)));
    EXPECT_TRUE(contains_zero(f("besselI", n, x) * f("besselK", n + 1, x) +
                              f("besselI", n + 1, x) * f("besselK", n, x) - 1 / x));
    EXPECT_TRUE(contains_zero(g("airyAi", x) * g("airyBiPrime", x) -
                              g("airyAiPrime", x) * g("airyBi", x) - 1 / pi(200)));
    EXPECT_TRUE(contains_zero(n * f("expint", n + 1, x) + x * f("expint", n, x) - exp(-x)));
    EXPECT_TRUE(contains_zero(f("besselIx", n, x) * exp(x) - f("besselI", n, x)));
    EXPECT_TRUE(contains_zero(f("besselKx", n, x) * exp(-x) - f("besselK", n, x)));
    EXPECT_TRUE(contains_zero(f("expintx", n, x) * exp(-x) - f("expint", n, x)));
    EXPECT_TRUE(contains_zero(g("lambertW", x * exp(x)) - x));
    EXPECT_TRUE(contains_zero(g("Ei", -x) + f("expint", ball(1, 200), x)));
    const ball u = x / (1 + x);
    EXPECT_TRUE(contains_zero(g("dilog", u) + g("dilog", 1 - u) + log(u) * log(1 - u) -
                              square(pi(200)) / 6));
    EXPECT_TRUE(contains_zero(g("digamma", x + 1) - g("digamma", x) - 1 / x));
    EXPECT_TRUE(contains_zero(f("gammaUpper", n, x) + f("gammaLower", n, x) - gamma(n)) ||
                !gamma(n).is_bounded());
    EXPECT_TRUE(
        contains_zero(f("gammaUpper", n + 1, x) - n * f("gammaUpper", n, x) - pow(x, n) * exp(-x)));
    EXPECT_TRUE(contains_zero(g("erfcx", x) * exp(-square(x)) - erfc(x)));
    EXPECT_TRUE(contains_zero(g("erfcx", -x) * exp(-square(x)) - 1 - erf(x)));
    EXPECT_TRUE(contains_zero(2 * g("dawson", x) - sqrt(pi(200)) * exp(-square(x)) * g("erfi", x)));
    EXPECT_TRUE(contains_zero(g("Chi", x) + g("Shi", x) - g("Ei", x)));
    // The sums over even and odd k; Riemann's functional equation (DLMF 25.4.1).
    EXPECT_TRUE(contains_zero(f("polylog", n, u) + f("polylog", n, -u) -
                              pow(ball(2, 200), 1 - n) * f("polylog", n, square(u))));
    EXPECT_TRUE(contains_zero(f("polylog", ball(2, 200), -x) - g("dilog", -x)));
    EXPECT_TRUE(contains_zero(g("zeta", 1 - u) - 2 * pow(2 * pi(200), -u) * cos(pi(200) * u / 2) *
                                                     gamma(u) * g("zeta", u)));
  }
  // With all digits.
  EXPECT_LE(value("besselJ(2, 3/7)", 1000).radius(), magnitude::power_of_two(-990));
  EXPECT_LE(value("besselK(30, 50)", 300).radius(), magnitude::power_of_two(-330));
  EXPECT_LE(value("airyAi(40)", 300).radius(), magnitude::power_of_two(-500));
}

TEST_F(ArbFunctions, HaveTheirKnownValues) {
  for (long k = 1; k <= 60; ++k) {
    const rational half(k, 2);
    const ball psi = named("digamma").value(std::array{ball(half, 200)});
    EXPECT_TRUE(overlaps(value("digamma(" + half.str() + ")"), psi)) << half;
    const long n = random.between(1, 20);
    const long m = random.between(1, 20);
    const ball exact = named("polygamma").value(std::array{ball(n, 200), ball(m, 200)});
    const std::string text = "polygamma(" + std::to_string(n) + "," + std::to_string(m) + ")";
    EXPECT_TRUE(overlaps(value(text), exact)) << text;
  }
  EXPECT_EQ(parse("digamma(1)+euler_gamma", {}).rational_value(), rational(0));
  EXPECT_EQ(parse("digamma(5/2)+euler_gamma+2*log(2)", {}).rational_value(), rational(8, 3));
  EXPECT_EQ(parse("polygamma(1,3)-pi^2/6", {}).rational_value(), rational(-5, 4));
  EXPECT_EQ(parse("polygamma(2,1)+2*zeta(3)", {}).rational_value(), rational(0));
}

/// Holds z: what is known at points inside a set is not outside the value over the set.
TEST_F(ArbFunctions, OverSetsHoldTheirValuesAtPoints) {
  const precision p = 128;
  for (const further_function& f : *arb_functions()) {
    SCOPED_TRACE(f.what.name);
    long defined = 0;
    for (support::repeat trial(100); trial.again();) {
      const rational re = random.one_in(2) ? scattered(6) : rational(-scattered(6));
      const rational im = random.one_in(3) ? rational(0) : between(-8, 8);
      const rational half = random.one_in(5) ? rational(abs(re) * random.between(1, 7) / 8)
                                             : rational(scattered(random.between(-8, 3)) / 4);
      const rational height = im == 0 ? rational(0) : half * between(0, 2);
      const auto set = [](const rational& x, const rational& r) {
        return from_end_points(rational(x - r), rational(x + r), p);
      };
      const rational nu = order();
      const auto arguments = [&](const complex_ball& z) {
        return f.arity == 2 ? std::vector{complex_ball(nu, p), z} : std::vector{z};
      };
      const complex_ball over(set(re, half), set(im, height));
      const std::vector<complex_ball> sets = arguments(over);
      std::vector<region> regions;
      for (const complex_ball& z : sets) regions.emplace_back(z);
      const region by_region = f.over_regions(regions);
      const complex_ball by_set =
          f.over_complex ? f.over_complex(sets) : complex_ball::undefined(p);
      const ball by_ball = [&] {
        if (im != 0) return ball::undefined(p);
        std::vector<ball> reals;
        for (const complex_ball& z : sets) reals.push_back(z.re);
        return f.value(reals);
      }();
      for (int k = 0; k < 6; ++k) {
        const auto part = [&] { return rational(random.between(-8, 8), 8); };
        const complex_ball at{ball(rational(re + half * part()), p),
                              ball(rational(im + height * part()), p)};
        std::vector<complex_ball> point = arguments(at);
        if (by_region.is_analytic() && f.over_complex) {
          const complex_ball exact = f.over_complex(point);
          ASSERT_TRUE(exact.is_bounded()) << re << " " << im << " " << half << " " << nu;
          const complex_ball around = by_region.to_complex_ball();
          EXPECT_TRUE(overlaps(around.re, exact.re) && overlaps(around.im, exact.im))
              << re << " " << im << " " << half << " " << nu;
          EXPECT_TRUE(overlaps(by_set.re, exact.re) && overlaps(by_set.im, exact.im));
          ++defined;
        }
        if (by_ball.is_bounded()) {
          std::vector<ball> reals;
          for (const complex_ball& z : point) reals.push_back(z.re);
          EXPECT_TRUE(overlaps(by_ball, f.value(reals))) << re << " " << half << " " << nu;
          ++defined;
        }
      }
    }
    EXPECT_GT(defined, 0);
  }
}

/// Over sets of orders as well, whatever the bits that Arb would lose to them.
TEST_F(ArbFunctions, OverSetsOfOrdersHoldTheirValues) {
  const precision p = 128;
  for (const char* name : {"besselK", "besselKx", "expint", "expintx"}) {
    const further_function& f = named(name);
    for (support::repeat trial(100); trial.again();) {
      const rational nu = random.one_in(2) ? between(-3, 40) : between(0, 3);
      const rational half = scattered(0) / (1L << random.between(4, 60));
      const rational x = scattered(random.between(0, 6));
      const ball set = from_end_points(rational(nu - half), rational(nu + half), p);
      const ball value = f.value(std::array{set, ball(x, p)});
      for (int k = -4; k <= 4; ++k) {
        const ball at(rational(nu + half * k / 4), p);
        const ball exact = f.value(std::array{at.middle(), ball(x, p)});
        EXPECT_TRUE(!value.is_bounded() || overlaps(value, exact)) << name << nu << " " << x;
      }
    }
    const ball third = ball(rational(1, 3), p);
    const ball value = f.value(std::array{third, ball(50, p)});
    EXPECT_LE(value.radius(), scale(value.magnitude_upper(), -100)) << name;
  }
}

/// f(b) - f(a) is b - a times a value of the derivative between them.
TEST_F(ArbFunctions, HaveDerivatives) {
  const precision p = 128;
  for (const further_function& f : *arb_functions()) {
    SCOPED_TRACE(f.what.name);
    long found = 0;
    for (support::repeat trial(60); trial.again();) {
      const rational nu = order();
      const rational a = random.one_in(3) ? rational(-scattered(4)) : scattered(4);
      const rational b = a + scattered(-1) / 8;
      const auto arguments = [&](const ball& x) {
        return f.arity == 2 ? std::vector{ball(nu, p), x} : std::vector{x};
      };
      const ball slope = f.gradient(arguments(from_end_points(a, b, p))).back();
      const ball rise = f.value(arguments(ball(b, p))) - f.value(arguments(ball(a, p)));
      if (!slope.is_bounded() || !rise.is_bounded()) continue;
      EXPECT_TRUE(overlaps(rise, slope * ball(rational(b - a), p))) << nu << " " << a << " " << b;
      ++found;
    }
    EXPECT_GT(found, 0);
  }
}

/// Beside their poles, at them, and over sets.
TEST_F(ArbFunctions, AreQuotientsOfWhatIsAnalytic) {
  const precision p = 128;
  int functions = 0;
  for (const further_function& f : *arb_functions()) {
    if (!f.numerator) continue;
    SCOPED_TRACE(f.what.name);
    ++functions;
    for (support::repeat trial(100); trial.again();) {
      const rational middle = random.one_in(2) ? between(-5, 5) : rational(random.between(-4, 2));
      const rational half = scattered(-2);
      const ball set = from_end_points(rational(middle - half), rational(middle + half), p);
      const rational at = middle + half * rational(random.between(-4, 4), 4);
      const ball x(at, p);
      const auto over = jet<ball, 1>::variable(set);
      const auto point = jet<ball, 1>::variable(x);
      for (const auto& part : {f.numerator, f.divisor}) {
        const jet<ball, 1> values = part(over);
        const jet<ball, 1> value = part(point);
        ASSERT_TRUE(value[0].is_bounded() && value[1].is_bounded()) << x;
        EXPECT_TRUE(overlaps(values[0], value[0])) << x << " " << set;
        EXPECT_TRUE(overlaps(values[1], value[1])) << x << " " << set;
      }
      const ball known = f.value(std::array{x});
      if (!known.is_bounded()) continue;
      const jet<ball, 1> quotient = f.numerator(point) / f.divisor(point);
      EXPECT_TRUE(overlaps(quotient[0], known)) << x;
      EXPECT_TRUE(overlaps(quotient[1], f.gradient(std::array{x}).back())) << x;
    }
  }
  EXPECT_EQ(functions, 2);
}

TEST_F(ArbFunctions, LieBelowTheirMajorants) {
  const precision p = 200;
  for (const further_function& f : *arb_functions()) {
    if (!f.majorant) continue;
    SCOPED_TRACE(f.what.name);
    for (support::repeat trial(60); trial.again();) {
      const int sign = random.one_in(3) ? -1 : 1;
      const rational nu = order();
      const ball x(sign * scattered(7), p);
      std::vector<ball> arguments;
      if (f.arity == 2) arguments.emplace_back(nu, p);
      const auto bound = f.majorant(arguments, sign);
      arguments.push_back(x);
      if (!bound) continue;
      const ball most =
          expression(bound->text, {.variables = argument_names(f.what), .definitions = {}})
              .evaluator<ball>(p)(std::span<const ball>(arguments));
      EXPECT_TRUE(most.is_bounded());
      EXPECT_FALSE(certainly_less(most, abs(f.value(arguments)))) << nu << " " << x;
    }
  }
  // Near 0, where those of order 1 grow.
  for (const char* name : {"expint", "expintx"}) {
    const ball one(1, p);
    const auto bound = parse(named(name).majorant(std::array{one}, 1)->text, {"x"});
    for (long k = 1; k <= 60; ++k) {
      const ball x = scale(one, -k);
      EXPECT_FALSE(
          certainly_less(bound.evaluator<ball>(p)(x), named(name).value(std::array{one, x})));
    }
  }
  // Attained: K of order n + 1/2 is its majorant; |J_0| at 0, Si at pi nearly.
  const std::array half{ball(rational(5, 2), p)};
  const auto k = named("besselK").majorant(half, 1);
  ASSERT_TRUE(k);
  const ball at = parse(k->text, {"x"}).evaluator<ball>(p)(ball(3, p));
  EXPECT_TRUE(overlaps(at, value("besselK(5/2, 3)")));
  EXPECT_LE(at.radius(), magnitude::power_of_two(-180));
}

/// f(x) lies beside its leading term there; false where it has none.
bool lies_beside(const further_function& f, const further_function::leading_formula& near,
                 std::vector<ball> arguments, const ball& x) {
  const precision p = x.precision();
  arguments.push_back(x);
  const auto at_x = [&](const std::string& text) {
    const expression formula(text, {argument_names(f.what), {}, library_functions()});
    return formula.evaluator<ball>(p)(std::span<const ball>(arguments));
  };
  const ball value = f.value(arguments);
  const ball main = at_x(near.main);
  if (!value.is_bounded() || !main.is_bounded()) return value.is_bounded() == main.is_bounded();
  return !certainly_less(at_x(near.rest), abs(value - main));
}

TEST_F(ArbFunctions, LieBesideTheirLeadingTermsAtZero) {
  const precision p = 200;
  int functions = 0;
  for (const further_function& f : *arb_functions()) {
    if (!f.near_zero) continue;
    ++functions;
    for (support::repeat trial(80); trial.again();) {
      const int sign = random.one_in(3) ? -1 : 1;
      const rational nu = random.one_in(2) ? rational(random.between(0, 1)) : order();
      const rational size =
          random.one_in(4) ? rational(1, 2) : between(1, 2) / (integer(4) << random.between(0, 90));
      std::vector<ball> orders;
      if (f.arity == 2) orders.emplace_back(nu, p);
      const auto near = f.near_zero(orders, sign);
      if (!near) continue;
      const ball x(rational(sign * size), p);
      EXPECT_TRUE(lies_beside(f, *near, orders, x)) << f.what.name << " " << nu << " " << x;
    }
  }
  EXPECT_EQ(functions, 22);
}

TEST_F(ArbFunctions, LieBesideTheirLeadingTermsAtInfinity) {
  const precision p = 300;
  int functions = 0;
  for (const further_function& f : *arb_functions()) {
    if (!f.near_infinity) continue;
    ++functions;
    for (support::repeat trial(80); trial.again();) {
      const int sign = random.one_in(3) ? -1 : 1;
      const rational nu = random.one_in(2) ? rational(random.between(0, 5)) : order();
      const rational size =
          random.one_in(4) ? rational(4) : between(4, 5) * (integer(1) << random.between(0, 7));
      std::vector<ball> orders;
      if (f.arity == 2) orders.emplace_back(nu, p);
      const auto near = f.near_infinity(orders, sign);
      if (!near) continue;
      const ball x(rational(sign * size), p);
      EXPECT_TRUE(lies_beside(f, *near, orders, x)) << f.what.name << " " << nu << " " << x;
    }
  }
  EXPECT_EQ(functions, 29);
}

/// Over sets beside and across the end of the domain; of the elliptic functions too.
TEST_F(ArbFunctions, HaveNaturalRangesThatHoldTheirValuesWhereTheyAreDefined) {
  const precision p = 128;
  int functions = 0;
  long trials = 0;
  long crossing = 0;
  for (const further_function& f : *library_functions()) {
    if (!f.natural_range) continue;
    SCOPED_TRACE(f.what.name);
    ++functions;
    for (support::repeat trial(80); trial.again();) {
      ++trials;
      const rational edge = random.one_in(2) ? rational(random.between(0, 1)) : rational(-3, 8);
      const rational half = scattered(2) / (1L << random.between(0, 12));
      const rational middle = edge + half * between(-1, 1);
      std::vector<ball> set;
      for (std::size_t k = 0; k + 1 < f.arity; ++k) {
        set.emplace_back(random.one_in(2) ? rational(random.between(0, 3)) : between(-3, 4), p);
      }
      set.push_back(from_end_points(rational(middle - half), rational(middle + half), p));
      const bool is_carlson = f.what.name.starts_with("carlson");
      if (is_carlson) std::swap(set.front(), set.back());
      const std::optional<ball> range = f.natural_range(set);
      const bool is_bounded = range && range->is_bounded();
      if (is_bounded && !f.value(set).is_bounded()) ++crossing;
      for (int k = -8; k <= 8; ++k) {
        std::vector<ball> at = set;
        (is_carlson ? at.front() : at.back()) = ball(rational(middle + half * k / 8), p);
        const ball value = f.value(at);
        if (!value.is_bounded()) continue;
        EXPECT_TRUE(range && overlaps(value, *range)) << at.front() << " " << at.back();
      }
    }
  }
  EXPECT_EQ(functions, 23);
  EXPECT_GT(50 * crossing, trials);
}

TEST_F(ArbFunctions, IncompleteGammaFunctionsGoOnToZero) {
  const ball s(rational(3, 2), 128);
  const ball from_zero = from_end_points(rational(0), rational(2), 128);
  for (const char* name : {"gammaUpper", "gammaLower"}) {
    const ball values = named(name).value(std::array{s, from_zero});
    for (const rational& x : {rational(0), rational(1, 3), rational(2)}) {
      EXPECT_TRUE(overlaps(values, named(name).value(std::array{s, ball(x, 128)}))) << name << x;
    }
    EXPECT_TRUE(certainly_less(values, ball(1, 64)));
    EXPECT_TRUE(certainly_less(ball(rational(-1, 100), 64), values));
    EXPECT_FALSE(named(name).value(std::array{-s, from_zero}).is_bounded());
    const ball beyond = from_end_points(rational(-1, 8), rational(2), 128);
    EXPECT_FALSE(named(name).value(std::array{s, beyond}).is_bounded());
  }
}

TEST_F(ArbFunctions, AreTheFormulasThatShowTheirPoles) {
  const precision p = 200;
  int functions = 0;
  for (const further_function& f : *arb_functions()) {
    if (!f.at_pole) continue;
    SCOPED_TRACE(f.what.name);
    ++functions;
    for (support::repeat trial(40); trial.again();) {
      std::vector<ball> arguments;
      if (f.arity == 2) arguments.emplace_back(random.between(1, 5), p);
      const long k = random.between(0, 6);
      const auto text = f.at_pole(arguments, k);
      ASSERT_TRUE(text);
      arguments.emplace_back(rational(between(-8, 3) + rational(1, 4096)), p);
      const expression formula(*text, {argument_names(f.what), {}, library_functions()});
      EXPECT_TRUE(overlaps(formula.evaluator<ball>(p)(std::span<const ball>(arguments)),
                           f.value(arguments)))
          << *text << " " << arguments.back();
    }
  }
  EXPECT_EQ(functions, 2);
}

/// Not by the continuation, where the order is not known to be above 1.
TEST_F(ArbFunctions, ThePolylogarithmAtOneNeedsAnOrderAboveOne) {
  const expression f = parse("polylog(x, 1)", {"x"});
  EXPECT_FALSE(f(ball(rational(1, 2), 128)).is_bounded());
  EXPECT_TRUE(overlaps(f(ball(3, 128)), zeta(3, 128)));
  EXPECT_FALSE(parse("polylog(0, x)", {"x"})(ball(2, 128)).is_bounded());
}

/// In the critical strip, where the bound of its second derivative counts.
TEST_F(ArbFunctions, ZetaOverSetsHoldsItsValuesAtPoints) {
  const precision p = 128;
  const auto zeta_at = [&](const ball& re, const ball& im) {
    return named("zeta").over_complex(std::array{complex_ball(re, im)});
  };
  for (support::repeat trial(150); trial.again();) {
    const rational re = between(-1, 3) / 3;
    const rational im = between(1, 40) * (random.one_in(2) ? 1 : -1);
    const rational half = between(1, 2) / (1L << random.between(1, 8));
    const auto side = [&](const rational& x) {
      return from_end_points(rational(x - half), rational(x + half), p);
    };
    const complex_ball over = zeta_at(side(re), side(im));
    for (int k = -8; k <= 8; ++k) {
      for (int l = -8; l <= 8; l += 16) {
        const complex_ball at = random.one_in(2) ? zeta_at(ball(rational(re + half * k / 8), p),
                                                           ball(rational(im + half * l / 8), p))
                                                 : zeta_at(ball(rational(re + half * l / 8), p),
                                                           ball(rational(im + half * k / 8), p));
        EXPECT_TRUE(overlaps(over, at)) << re << " + i " << im << " +- " << half;
      }
    }
  }
}

/// J of an order that may be whole has values for x < 0.
TEST_F(ArbFunctions, AnOrderThatMayBeWholeIsNotExcludedLeftOfZero) {
  const auto& near_zero = named("besselJ").near_zero;
  const ball around_one = ball(1, 64).enlarged(magnitude::power_of_two(-60));
  EXPECT_FALSE(near_zero(std::array{around_one}, -1));
  EXPECT_TRUE(near_zero(std::array{ball(rational(1, 3), 64)}, -1));
}

TEST_F(ArbFunctions, TheDilogarithmIsKnownUpToItsBranchPoint) {
  const ball up_to_one = from_end_points(rational(-3), rational(1), 128);
  const ball values = named("dilog").value(std::array{up_to_one});
  EXPECT_TRUE(contains(values, value("dilog(-3)").middle()));
  EXPECT_TRUE(overlaps(values, square(pi(128)) / 6));
  EXPECT_TRUE(certainly_less(values, ball(rational(165, 100), 64)));
  EXPECT_TRUE(certainly_less(ball(rational(-194, 100), 64), values));
  const ball beyond = from_end_points(rational(0), rational(3, 2), 128);
  EXPECT_TRUE(named("dilog").value(std::array{beyond}).is_undefined());
}

TEST_F(ArbFunctions, AreRefusedWhereTheyAreNotDefined) {
  for (const char* text :
       {"besselY(0, 0)", "besselK(1, -1)", "besselJ(1/2, -3)", "besselJ(-1/2, 0)", "Ei(0)",
        "Ci(-1)", "expint(1, 0)", "dilog(2)", "digamma(-3)"}) {
    EXPECT_THROW((void)parse(text, {}), expression_error) << text;
  }
  EXPECT_EQ(parse("besselJ(0, 0) + besselI(3, 0) + Si(0) + lambertW(0)", {}).exact_value(),
            rational(1));
  EXPECT_TRUE(value("lambertW(-1)").is_undefined());
  EXPECT_TRUE(value("besselY(0, sin(1) - 1)").is_undefined());
  EXPECT_TRUE(named("besselJ").value(std::array{ball::undefined(64), ball(1, 64)}).is_undefined());
  EXPECT_TRUE(named("airyAi").value(std::array{ball::entire(64)}).is_undefined());
  // Off the real line: across a cut, on its far side, and where the order is no single number.
  const auto over = [](const char* name, const rational& n, const complex_ball& z) {
    return named(name).over_regions(std::array{region(complex_ball(n, 64)), region(z)}).why();
  };
  const complex_ball across{from_end_points(rational(-1), rational(1), 64), ball(0, 64)};
  const complex_ball left(-2, 1, 64);
  EXPECT_EQ(over("besselJ", 3, across), obstacle::none);
  EXPECT_EQ(over("besselJ", rational(1, 2), across), obstacle::branch_cut);
  EXPECT_EQ(over("besselY", 3, across), obstacle::branch_cut);
  EXPECT_EQ(over("besselK", 3, left), obstacle::unknown);
  EXPECT_EQ(over("expint", 1, across), obstacle::branch_cut);
}

}  // namespace arb_functions_test
}  // namespace polhode
