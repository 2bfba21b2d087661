#include <cmath>
#include <map>
#include <memory>

#include "boost_methods.hpp"
#include "odeint.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/rigid_body/rotor.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "proofs/claim.hpp"
#include "quantity.hpp"

namespace polhode::cost {
namespace {

constexpr long many_digits = 10'000'000;

/// The paper's body of figure 5, and what is computed of it.
const rational the_a(1265, 100);
const rational the_b(629, 10000);
const body& the_body() {
  static const body rigid(the_a, the_b);
  return rigid;
}

template <class T>
T number(const rational& q) {
  if constexpr (std::same_as<T, double>) {
    return static_cast<double>(q);
  } else {
    return T(q);
  }
}

// ---------------------------------------------------------------------------------------------
// Certified methods

method certified(std::string name, std::string description, long most_digits,
                 std::function<ball(long digits)> compute) {
  return {std::move(name), std::move(description), true, most_digits,
          [compute = std::move(compute)](long digits) {
            return estimate{compute(digits), std::nullopt, 0};
          }};
}
/// To so many digits by raising the precision.
method certified_number(std::string name, std::string description, long most_digits,
                        std::function<certain_number(long digits)> compute) {
  return certified(
      std::move(name), std::move(description), most_digits,
      [compute = std::move(compute)](long digits) { return compute(digits).enclosure; });
}

method of_constant(const std::string& name, std::string method_name, std::string description) {
  return certified(std::move(method_name), std::move(description), many_digits,
                   [name](long digits) {
                     return proofs::enclose_to_digits(*proofs::find_constant(name), digits);
                   });
}

/// The front door with that rule; times 1/sqrt(divisor).
template <class F>
method by_rule(quadrature_rule rule, const F& f, const end_point& from, const end_point& to,
               long most_digits, const std::optional<rational>& divisor = std::nullopt) {
  return {rule == quadrature_rule::automatic ? "integrate" : to_text(rule),
          "certified quadrature" + std::string(rule == quadrature_rule::automatic
                                                   ? ", the rule chosen by the library"
                                                   : " by this rule"),
          true, most_digits, [=](long digits) {
            integrate_options options;
            options.digits = digits + 1;
            options.rule = rule;
            const integral found = integrate(f, from, to, options);
            ball value = found.enclosure;
            if (divisor) value = value / sqrt(ball(*divisor, bits_for_digits(digits) + 64));
            return estimate{value, std::nullopt, found.account.evaluations + found.account.terms};
          }};
}

// --------------------------------------------------------------------------------------------- The
// half phase G(u) = b^(-1/2) integral over 0..pi of (1 - b x)/sqrt(x (a + b x)), x = ((1+u) + (1-u)
// cos t)/2

auto half_phase_kernel(const rational& u) {
  return [a = the_a, b = the_b, mean = rational((1 + u) / 2),
          half = rational((1 - u) / 2)](const auto& t) {
    const auto x = mean + half * cos(t);
    return (1 - b * x) / sqrt(x * (a + b * x));
  };
}

/// 2/sqrt(b (a+b)) ((1-b) R_F(0,u,v) + (b (1-u)/3) R_J(0,u,v,1)), v = (a + b u)/(a + b).
template <class T, class F, class J>
T half_phase_by_carlson(const rational& u, const F& rf, const J& rj) {
  using std::sqrt;
  const T zero = number<T>(0);
  const T one = number<T>(1);
  const T of_u = number<T>(u);
  const T v = number<T>(rational((the_a + the_b * u) / (the_a + the_b)));
  const T first = number<T>(rational(1 - the_b)) * rf(zero, of_u, v);
  const T second = number<T>(rational(the_b * (1 - u) / 3)) * rj(zero, of_u, v, one);
  return T(2 * (first + second)) / sqrt(number<T>(rational(the_b * (the_a + the_b))));
}

integral_maker half_phase_integral(const rational& u) {
  return [u] {
    const mpfr_float a(the_a);
    const mpfr_float b(the_b);
    const mpfr_float mean(rational((1 + u) / 2));
    const mpfr_float half(rational((1 - u) / 2));
    const mpfr_float root = sqrt(b);
    const mpfr_float to = acos(mpfr_float(-1));
    return uncertified_integral{[=](const mpfr_float& t) -> mpfr_float {
                                  const mpfr_float x = mean + half * cos(t);
                                  return (1 - b * x) / (root * sqrt(mpfr_float(x * (a + b * x))));
                                },
                                mpfr_float(0), to};
  };
}

const auto rf_of_boost = [](const auto&... x) { return boost_rf(x...); };
const auto rj_of_boost = [](const auto&... x) { return boost_rj(x...); };
const auto our_rf = [](const auto&... x) { return carlson_rf(x...); };
const auto our_rj = [](const auto&... x) { return carlson_rj(x...); };

quantity half_phase(const rational& u) {
  const auto kernel = half_phase_kernel(u);
  const end_point from(0);
  const end_point to = end_point::pi();
  quantity q;
  q.name = "half_phase";
  q.description = "G(u), half the Montgomery phase of an oscillating body, u = " + to_text(u);
  q.methods = {
      certified(
          "agm-bartky", "arithmetic-geometric mean and Bartky's sum, in balls", many_digits,
          [u](long digits) {
            return scale(
                montgomery_phase_to_digits(the_body(), rational(-the_b * u), digits).enclosure, -1);
          }),
      by_rule(quadrature_rule::taylor_series, kernel, from, to, 30'000, the_b),
      by_rule(quadrature_rule::trapezoid, kernel, from, to, 30'000, the_b),
      by_rule(quadrature_rule::gauss_legendre, kernel, from, to, 10'000, the_b),
      by_rule(quadrature_rule::clenshaw_curtis, kernel, from, to, 3000, the_b),
      in_mpfr_float("agm-bartky, floating", "the same as agm-bartky in mpfr_float, uncertified",
                    many_digits,
                    [u] { return half_phase_by_carlson<mpfr_float>(u, our_rf, our_rj); }),
      in_mpfr_float("boost carlson", "Boost.Math's R_F and R_J, by duplication, over mpfr_float",
                    3000,
                    [u] { return half_phase_by_carlson<mpfr_float>(u, rf_of_boost, rj_of_boost); }),
      boost_tanh_sinh(half_phase_integral(u)),
      boost_gauss_kronrod(half_phase_integral(u)),
      in_double("Boost.Math's R_F and R_J in double",
                [u] { return half_phase_by_carlson<double>(u, rf_of_boost, rj_of_boost); })};
  return q;
}

// ---------------------------------------------------------------------------------------------
// The incomplete integral F(c,u)

const rational the_c(1, 100);
const rational the_u(1, 10);

/// montgomery_phase.hpp has the formula.
template <class T, class F, class J>
T phase_integral_by_carlson(const F& rf, const J& rj) {
  using std::sqrt;
  const rational& a = the_a;
  const rational& b = the_b;
  const T x = number<T>(the_u);
  const T y = number<T>(rational((a + b * the_u) / (a + b)));
  const T z = number<T>(rational((the_c + b * the_u) / (the_c + b)));
  const T first = number<T>(rational(1 - b)) * rf(x, y, z);
  const T second = number<T>(rational(b * (1 - the_u) / 3)) * rj(x, y, z, number<T>(1));
  return T(2 * (first + second)) * sqrt(number<T>(rational((1 - the_u) / ((a + b) * (b + the_c)))));
}

/// With x = 1 - (1-u) y^2: 2 sqrt(1-u) integral over 0..1 of (1 - b x)/sqrt(x (a + b x)(c + b x))
/// dy.
auto phase_kernel() {
  return [a = the_a, b = the_b, c = the_c, rest = rational(1 - the_u)](const auto& y) {
    const auto x = 1 - rest * y * y;
    return (1 - b * x) / sqrt(x * (a + b * x) * (c + b * x));
  };
}
integral_maker phase_kernel_integral() {
  return [] {
    const mpfr_float a(the_a);
    const mpfr_float b(the_b);
    const mpfr_float c(the_c);
    const mpfr_float rest(rational(1 - the_u));
    const mpfr_float factor = 2 * sqrt(rest);
    return uncertified_integral{[=](const mpfr_float& y) -> mpfr_float {
                                  const mpfr_float x = 1 - rest * y * y;
                                  return factor * (1 - b * x) /
                                         sqrt(mpfr_float(x * (a + b * x) * (c + b * x)));
                                },
                                mpfr_float(0), mpfr_float(1)};
  };
}

quantity phase_integral_quantity() {
  const rational divisor(1 / (4 * (1 - the_u)));
  quantity q;
  q.name = "phase_integral";
  q.description = "F(c,u), incomplete, c = " + to_text(the_c) + ", u = " + to_text(the_u);
  q.methods = {
      certified("carlson", "R_F and R_J together, in balls", many_digits,
                [](long digits) {
                  return phase_integral(the_body(), the_c, the_u, bits_for_digits(digits) + 16);
                }),
      by_rule(quadrature_rule::taylor_series, phase_kernel(), 0, 1, 30'000, divisor),
      by_rule(quadrature_rule::gauss_legendre, phase_kernel(), 0, 1, 10'000, divisor),
      by_rule(quadrature_rule::clenshaw_curtis, phase_kernel(), 0, 1, 3000, divisor),
      in_mpfr_float("carlson, floating", "our R_F and R_J in mpfr_float, uncertified", many_digits,
                    [] { return phase_integral_by_carlson<mpfr_float>(our_rf, our_rj); }),
      in_mpfr_float("boost carlson", "Boost.Math's R_F and R_J, by duplication, over mpfr_float",
                    3000,
                    [] { return phase_integral_by_carlson<mpfr_float>(rf_of_boost, rj_of_boost); }),
      boost_tanh_sinh(phase_kernel_integral()),
      boost_gauss_kronrod(phase_kernel_integral()),
      in_double("Boost.Math's R_F and R_J in double",
                [] { return phase_integral_by_carlson<double>(rf_of_boost, rj_of_boost); })};
  return q;
}

// ---------------------------------------------------------------------------------------------
// The others

/// agm(sqrt(1+x), sqrt x) = 1/2 by secants, from 0.029.
template <class T, class Agm>
T beta_by_secants(const Agm& agm, int steps) {
  using std::sqrt;
  const auto f = [&](const T& x) {
    return T(agm(T(sqrt(T(1 + x))), T(sqrt(x))) - number<T>(rational(1, 2)));
  };
  T before = number<T>(rational(28, 1000));
  T x = number<T>(rational(29, 1000));
  T f_before = f(before);
  for (int i = 0; i < steps; ++i) {
    const T value = f(x);
    const T change = value - f_before;
    if (change == 0) break;
    const T next = x - value * (x - before) / change;
    before = x;
    f_before = value;
    x = next;
  }
  return x;
}

quantity beta() {
  quantity q;
  q.name = "beta";
  q.description = "the root of K(1/(1+x)) = pi sqrt(1+x), the paper's beta";
  q.methods = {
      of_constant("beta", "interval newton",
                  "interval Newton on the arithmetic-geometric mean, in balls"),
      in_mpfr_float("secants, floating", "the secant method on mpfr_agm, uncertified", many_digits,
                    [] {
                      const auto agm = [](const mpfr_float& x, const mpfr_float& y) {
                        mpfr_float r = zero_of_precision(precision_of(x));
                        mpfr_agm(r.backend().data(), x.backend().data(), y.backend().data(),
                                 MPFR_RNDN);
                        return r;
                      };
                      constexpr int steps = 40;
                      return beta_by_secants<mpfr_float>(agm, steps);
                    }),
      in_double("the secant method on the mean in double", [] {
        const auto agm = [](double x, double y) {
          for (int i = 0; i < 8; ++i) {
            const double mean = (x + y) / 2;
            y = std::sqrt(x * y);
            x = mean;
          }
          return x;
        };
        return beta_by_secants<double>(agm, 12);
      })};
  return q;
}

quantity epsilon0_min() {
  quantity q;
  q.name = "epsilon0_min";
  q.description = "pi - 2 arctan(e^pi), the paper's least twist defect on the separatrix";
  q.methods = {
      of_constant("epsilon0_min", "elementary", "2 arctan(e^-pi), in balls"),
      in_mpfr_float("elementary, floating",
                    "pi - 2 arctan(e^pi) in mpfr_float as written, uncertified", many_digits,
                    [] {
                      const mpfr_float pi_number = acos(mpfr_float(-1));
                      return mpfr_float(pi_number - 2 * atan(exp(pi_number)));
                    }),
      in_double("pi - 2 arctan(e^pi) in double as written", [] {
        const double pi_number = std::acos(-1.0);
        return pi_number - 2 * std::atan(std::exp(pi_number));
      })};
  return q;
}

quantity montgomery_phase_quantity() {
  quantity q;
  q.name = "montgomery_phase";
  q.description = "the Montgomery phase of a rotating body, c = " + to_text(the_c);
  q.methods = {certified_number(
      "agm-bartky", "arithmetic-geometric mean and Bartky's sum, in balls", many_digits,
      [](long digits) { return montgomery_phase_to_digits(the_body(), the_c, digits); })};
  return q;
}

quantity epsilon() {
  quantity q;
  q.name = "epsilon";
  q.description = "the defect epsilon(c) of the tennis racket effect, c = " + to_text(the_c);
  q.methods = {certified_number(
      "interval newton", "interval Newton on Carlson's integrals, in balls", 30'000,
      [](long digits) { return defect_to_digits(the_body(), the_c, digits); })};
  return q;
}

quantity c0() {
  quantity q;
  q.name = "c0";
  q.description = "the motion c0 of the perfect twist";
  q.methods = {
      certified_number("interval newton", "interval Newton in log c, in balls", 30'000,
                       [](long digits) { return perfect_twist_to_digits(the_body(), digits); })};
  return q;
}

/// A motion that is known, as a scene knows it: each precision's rotor is made once, by the first
/// call.
template <class T>
class attitude_entry {
 public:
  [[nodiscard]] T operator()(precision p) const {
    const auto found = known_->try_emplace(p, start(), p).first;
    return found->second.attitude(time()).matrix[0][0];
  }
  static const initial_state& start() {
    static const initial_state state =
        initial_state::from_momentum({3, 2, 1}, {3, 1, rational(1, 2)});
    return state;
  }
  static rational time() { return 100; }

 private:
  std::shared_ptr<std::map<precision, rotor<T>>> known_ =
      std::make_shared<std::map<precision, rotor<T>>>();
};

quantity attitude() {
  constexpr long most_digits = 10'000;
  constexpr precision guard = 16;
  quantity q;
  q.name = "attitude";
  q.description =
      "an entry of the attitude of a free body at t = 100, one sample of a scene, the body's "
      "motion being known from the first on";
  q.methods = {
      certified("closed form", "theta functions, in balls", most_digits,
                [entry = attitude_entry<ball>()](long digits) {
                  return entry(bits_for_digits(digits) + guard);
                }),
      {"mpfr_float", "the middle of the same computation, uncertified", false, most_digits,
       [entry = attitude_entry<mpfr_float>()](long digits) {
         return estimate{ball(entry(bits_for_digits(digits) + guard)), std::nullopt, 0};
       }},
      in_double("the same in double", [entry = attitude_entry<double>()] { return entry(53); }),
      {"boost dopri5", "Boost.odeint's Runge-Kutta steps in double from t = 0, tolerance 1e-12",
       false, 16, [](long) {
         constexpr double tolerance = 1e-12;
         const auto t = static_cast<double>(attitude_entry<double>::time());
         return estimate{
             ball::exactly(
                 rotation_by_dopri5(attitude_entry<double>::start(), t, tolerance).matrix()[0][0]),
             std::nullopt, 0};
       }}};
  return q;
}

quantity general_integral() {
  const auto f = [](const auto& x) { return sin(x + exp(x)); };
  const integral_maker maker = [] {
    return uncertified_integral{
        [](const mpfr_float& x) -> mpfr_float { return sin(mpfr_float(x + exp(x))); },
        mpfr_float(0), mpfr_float(8)};
  };
  quantity q;
  q.name = "integral";
  q.description = "integral from 0 to 8 of sin(x + e^x), which oscillates 474 times";
  q.methods = {by_rule(quadrature_rule::automatic, f, 0, 8, 3000),
               by_rule(quadrature_rule::clenshaw_curtis, f, 0, 8, 3000), boost_tanh_sinh(maker),
               boost_gauss_kronrod(maker)};
  return q;
}

quantity root_integral() {
  const auto f = [](const auto& x) { return sqrt(x) * exp(x); };
  const integral_maker maker = [] {
    return uncertified_integral{[](const mpfr_float& x) -> mpfr_float { return sqrt(x) * exp(x); },
                                mpfr_float(0), mpfr_float(1)};
  };
  quantity q;
  q.name = "root_integral";
  q.description = "integral from 0 to 1 of sqrt(x) e^x, which is singular at 0";
  q.methods = {by_rule(quadrature_rule::automatic, f, 0, 1, 3000),
               by_rule(quadrature_rule::double_exponential, f, 0, 1, 3000), boost_tanh_sinh(maker),
               boost_gauss_kronrod(maker)};
  return q;
}

rational power_of_ten(long exponent) {
  integer power = 1;
  mpz_ui_pow_ui(power.backend().data(), 10, static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? rational(1, power) : rational(power);
}

}  // namespace

const std::vector<quantity>& quantities() {
  static const std::vector<quantity> all{beta(),
                                         epsilon0_min(),
                                         half_phase(rational(1, 4)),
                                         phase_integral_quantity(),
                                         montgomery_phase_quantity(),
                                         epsilon(),
                                         c0(),
                                         attitude(),
                                         general_integral(),
                                         root_integral()};
  return all;
}

const std::vector<hard_family>& hard_families() {
  static const std::vector<hard_family> all{
      {"half_phase",
       "G(u) for u = 10^-k: the motion comes near to the separatrix",
       {0, 1, 2, 3, 4, 6, 8, 12, 20, 50, 100, 300},
       [](long k) { return half_phase(k == 0 ? rational(1, 2) : power_of_ten(-k)); }},
      {"near_one",
       "G(u) for 1 - u = 10^-k: the motion comes near to the equilibrium",
       {1, 2, 4, 8, 20, 50, 100, 300},
       [](long k) { return half_phase(rational(1 - power_of_ten(-k))); }}};
  return all;
}

}  // namespace polhode::cost
