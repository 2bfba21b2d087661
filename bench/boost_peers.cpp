// Integrals by Polhode, with balls and over mpfr_float, and by the fastest of Boost.Math's rules
// that reaches the digits.
//
// All have the same generic function; Boost's rules are objects that are made once and have made
// their nodes, as ours are made once in a process. The tolerance that a rule is given is the one,
// of 10^-digits and its square root, with which it reaches the digits soonest; that it does is
// measured against the certified value. Behind each row stands which rule it was. Where none
// reaches the digits the row has no ratio, and says so.

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/sinh_sinh.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/quadrature/trapezoidal.hpp>

#include "polhode/real/integrate.hpp"
#include "support/measure.hpp"

namespace {

using namespace polhode::bench;
using polhode::ball;
using polhode::end_point;
using polhode::mpfr_float;

/// A rule of Boost's, for a function over mpfr_float at the thread's precision.
struct boost_rule {
  std::string name;
  std::function<mpfr_float(const mpfr_float& tolerance)> integrate;
};

using real_function = std::function<mpfr_float(const mpfr_float&)>;

/// Those that are for the range.
std::vector<boost_rule> rules_for(const real_function& f, const mpfr_float& a, const mpfr_float& b,
                                  bool is_periodic) {
  using namespace boost::math::quadrature;
  std::vector<boost_rule> rules;
  const bool from_infinity = !isfinite(a);
  const bool to_infinity = !isfinite(b);
  if (from_infinity && to_infinity) {
    const auto rule = std::make_shared<sinh_sinh<mpfr_float>>(12);
    rules.push_back({"sinh_sinh", [=](const mpfr_float& t) { return rule->integrate(f, t); }});
  } else if (to_infinity) {
    const auto rule = std::make_shared<exp_sinh<mpfr_float>>(12);
    rules.push_back({"exp_sinh", [=](const mpfr_float& t) { return rule->integrate(f, a, b, t); }});
  } else {
    const auto rule = std::make_shared<tanh_sinh<mpfr_float>>(15);
    rules.push_back(
        {"tanh_sinh", [=](const mpfr_float& t) { return rule->integrate(f, a, b, t); }});
    rules.push_back({"gauss_kronrod", [=](const mpfr_float& t) {
                       return gauss_kronrod<mpfr_float, 61>::integrate(f, a, b, 6, t);
                     }});
    if (is_periodic) {
      rules.push_back({"trapezoidal", [=](const mpfr_float& t) {
                         return trapezoidal(f, a, b, t, std::size_t{12});
                       }});
    }
  }
  return rules;
}

struct choice {
  std::string name;
  std::function<mpfr_float()> run;
};

/// The fastest that reaches the digits; by one call each.
std::optional<choice> fastest(const std::vector<boost_rule>& rules, const ball& truth,
                              long digits) {
  constexpr double most_seconds = 5;  // of a first try: one that takes longer is not tried again
  std::optional<choice> best;
  double best_seconds = std::numeric_limits<double>::infinity();
  for (const boost_rule& rule : rules) {
    for (const long exponent : {digits / 2, digits}) {
      const mpfr_float tolerance = pow(mpfr_float(10), static_cast<int>(-exponent));
      const auto run = [rule, tolerance] { return rule.integrate(tolerance); };
      try {
        mpfr_float value;
        const auto call = [&] { value = run(); };
        const double first = seconds_of(call, 1);
        const ball off = abs(ball(value) - truth) / abs(truth) * pow(ball(10, 64), digits);
        if (!certainly_less(off, ball(1, 64))) continue;
        const double seconds = first > most_seconds ? first : seconds_of(call, 1);
        if (seconds < best_seconds) {
          best_seconds = seconds;
          best = choice{rule.name, run};
        }
      } catch (const std::exception&) {  // it gives up
      }
    }
  }
  return best;
}

struct problem {
  std::string name;
  std::function<outcome(long digits)> measure;
};

/// For one integrand, measured with so many digits. Contestants: balls, mpfr_float, Boost.
template <class F>
problem make_problem(const std::string& name, F f, const end_point& a, const end_point& b,
                     bool is_periodic = false) {
  return {
      name, [=](long digits) {
        const polhode::precision p = polhode::bits_for_digits(digits + 5);
        const polhode::detail::thread_precision<mpfr_float> scope(p);
        const auto end = [&](const end_point& x) {
          if (!x.is_infinite()) return midpoint(x.at(p));
          return mpfr_float(x.infinite_sign() * std::numeric_limits<mpfr_float>::infinity());
        };
        const auto with_balls = [=] {
          return polhode::integrate<ball>(f, a, b, {.digits = digits}).enclosure;
        };
        polhode::real_integrate_options goal;
        goal.digits = digits;
        const auto in_mpfr = [=] { return polhode::integrate<mpfr_float>(f, a, b, goal).value; };
        const ball truth = polhode::integrate<ball>(f, a, b, {.digits = digits + 5}).enclosure;
        const real_function by_hand = [f](const mpfr_float& x) { return mpfr_float(f(x)); };
        const auto boost = fastest(rules_for(by_hand, end(a), end(b), is_periodic), truth, digits);
        row r;
        r.contestants = {warm(with_balls), warm(in_mpfr)};
        if (boost) r.contestants.push_back(warm(boost->run));
        if (boost) r.ratios = {{0, 2}};
        r.ratios.push_back({0, 1});
        outcome result = polhode::bench::detail::measure(r);
        if (boost) {
          result.remark = "   " + boost->name;
        } else {
          result.ratios.insert(result.ratios.begin(), std::nan(""));
          result.bounds.insert(result.bounds.begin(), std::nullopt);
          result.remark = "   no rule of Boost's reaches the digits";
        }
        return result;
      }};
}

std::vector<problem> problems() {
  const end_point infinity = end_point::infinity();
  const polhode::rational half(1, 2);
  return {
      make_problem(
          "1/(1+x^2)", [](auto x) { return 1 / (1 + x * x); }, 0, 1),
      make_problem(
          "exp(-x^2)", [](auto x) { return exp(-x * x); }, 0, 1),
      make_problem(
          "sin(x+e^x)", [](auto x) { return sin(x + exp(x)); }, 0, 1),
      make_problem(
          "e^-x cos x, half line", [](auto x) { return exp(-x) * cos(x); }, 0, infinity),
      make_problem(
          "sech x, line", [](auto x) { return 1 / cosh(x); }, -infinity, infinity),
      make_problem(
          "sqrt(x) log x", [](auto x) { return sqrt(x) * log(x); }, 0, 1),
      make_problem(
          "log x log(1+x)", [](auto x) { return log(x) * log(1 + x); }, 0, 1),
      make_problem(
          "sqrt(1-x^2)", [](auto x) { return sqrt(1 - x * x); }, 0, 1),
      make_problem(
          "1/(5-4cos x)", [](auto x) { return 1 / (5 - 4 * cos(x)); }, 0, end_point::pi(2), true),
      make_problem(
          "atan(x)/(1+x^4)", [](auto x) { return atan(x) / (1 + x * x * x * x); }, 0, half),
  };
}

struct mean {
  double log_sum = 0;
  long count = 0;
};

}  // namespace

int main(int argc, char** argv) {
  suite benchmarks;
  std::map<long, mean> means;
  for (const long digits : {30L, 50L, 100L, 300L}) {
    table t{"boost/" + std::to_string(digits),
            "integrals to " + std::to_string(digits) +
                " digits: certified, over mpfr_float with the truncation error proved, and by "
                "Boost.Math's fastest rule",
            {"balls", "mpfr_float", "Boost"},
            {"balls/Boost", "price"},
            23};
    for (const problem& one : problems()) {
      benchmarks.add_measured(t, one.name, [=, &means] {
        outcome result = one.measure(digits);
        if (std::isfinite(result.ratios.front())) {
          means[digits].log_sum += std::log(result.ratios.front());
          ++means[digits].count;
        }
        return result;
      });
    }
    benchmarks.add_measured(t, "geometric mean", [digits, &means] {
      outcome result;
      const mean& all = means[digits];
      if (all.count == 0) return result;
      result.ratios = {std::exp(all.log_sum / static_cast<double>(all.count))};
      result.bounds = {digits == 100 ? std::optional(at_most(0.1)) : std::nullopt};
      return result;
    });
  }
  return benchmarks.main(argc, argv);
}
