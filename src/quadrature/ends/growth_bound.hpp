#pragma once

// How fast a function grows at an end of its range, where it has no series there: found by calling
// it with an growth_bound for its argument.
//
// An growth_bound is a real function v(t) for 0 < t <= r, r < 1, of which it knows that
//
//   c t^a <= |v(t)| <= C t^b,      c >= 0, a >= b,
//
// and its sign, where it has one; and where the function has an end_series, that too. So x^x,
// x^sqrt(2), log(log(1/x)) and 1/(1 + x^pi) are known to be integrable beside 0, though none has
// the form t^m (G_0 + log(t) G_1 + ...). Nothing is said of functions off the real line: it is
// bounds of regions that prove where the function is analytic.
//
// Of what is made of exponentials (exp(1/t), Gamma(1/t)) it knows two factors:
//
//   v(t) = f(t) e^(g(t)),      f and g with bounds as above.
//
// Products, quotients, powers and sums of such functions have such factors again: the exponents
// add, and f1 e^g1 + f2 e^g2 = (f1 + f2 e^(g2 - g1)) e^g1 where e^(g2 - g1) has a bound. Where v
// grows faster than all powers it is blocked, since it has no upper bound; it may have a lower one.
//
// All bounds rest on 0 < t <= r < 1: t^e <= r^(e-f) t^f and t^f >= r^(f-e) t^e for e >= f; and on
// |log t| <= t^-d/(e d) for d > 0, since t^d |log t| has its greatest value, 1/(e d), at t =
// e^(-1/d).

#include <memory>
#include <optional>
#include <string_view>

#include "polhode/arithmetic/elementary.hpp"
#include "quadrature/ends/end_series.hpp"

namespace polhode {

class growth_bound {
 public:
  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;

  /// Blocked.
  growth_bound() = default;
  /// p + s t^q for 0 < t <= r, a power of two below 1; for q < 0 and p = 0, an end at infinity.
  [[nodiscard]] static growth_bound argument(const known_number& p, const known_number& s, long q,
                                             double r);
  /// 1/y, of which it is remembered that 1 divided by it is y.
  [[nodiscard]] static growth_bound reciprocal_of(const growth_bound& y);
  [[nodiscard]] static growth_bound blocked(std::string_view where);
  [[nodiscard]] bool is_blocked() const { return blocked_; }
  /// Blocked, and of no known factors: blocks all that is made of it.
  [[nodiscard]] bool is_unknown() const { return blocked_ && !factors_; }
  /// v(t) is defined for no 0 < t <= r: a square root of a negative number, say, is a part of it.
  /// Then it is blocked, too.
  [[nodiscard]] bool is_nowhere_defined() const { return nowhere_defined_; }
  /// The name of the function that could not be followed; empty where there is none.
  [[nodiscard]] std::string_view where() const { return where_; }

  /// b, and C.
  [[nodiscard]] const rational& exponent() const { return upper_exponent_; }
  [[nodiscard]] magnitude factor() const { return most_.magnitude_upper(); }
  /// a, and c, which is 0 where no lower bound is known. What is blocked may have one.
  [[nodiscard]] const rational& least_exponent() const { return lower_exponent_; }
  [[nodiscard]] magnitude least_factor() const { return least_.magnitude_lower(); }
  /// 1 or -1 for all t; 0 where it is not known to be one.
  [[nodiscard]] int sign() const { return sign_; }

  /// A sine or cosine of what grows as a power is in it: regions will hardly follow its
  /// oscillations to t = 0.
  [[nodiscard]] bool oscillates() const { return oscillates_; }
  /// It is made of what grows faster than all powers, which cancels or stands in a divisor: values
  /// of its parts may be beyond all numbers where it is not small.
  [[nodiscard]] bool has_growing_parts() const { return has_growing_parts_; }
  /// The same bound of a function that oscillates as sin(x) does.
  [[nodiscard]] growth_bound oscillating_as(const growth_bound& x) const;

  friend growth_bound operator+(const growth_bound& x) { return x; }
  friend growth_bound operator-(const growth_bound& x);
  friend growth_bound operator+(const growth_bound& x, const growth_bound& y);
  friend growth_bound operator-(const growth_bound& x, const growth_bound& y) { return x + (-y); }
  friend growth_bound operator*(const growth_bound& x, const growth_bound& y);
  friend growth_bound operator/(const growth_bound& x, const growth_bound& y);
  friend growth_bound pow(const growth_bound& x, long n);
  /// x^y for a constant y; else exp(y log x).
  friend growth_bound pow(const growth_bound& x, const growth_bound& y);
  friend growth_bound sqrt(const growth_bound& x);
  friend growth_bound root(const growth_bound& x, long n);
  friend growth_bound exp(const growth_bound& x);
  friend growth_bound log(const growth_bound& x);
  friend growth_bound sin(const growth_bound& x);
  friend growth_bound cos(const growth_bound& x);
  friend growth_bound tan(const growth_bound& x);
  friend growth_bound atan(const growth_bound& x);
  friend growth_bound tanh(const growth_bound& x);
  friend growth_bound erf(const growth_bound& x);
  friend growth_bound gamma(const growth_bound& x);
  friend growth_bound log_gamma(const growth_bound& x);
  friend growth_bound agm(const growth_bound& x, const growth_bound& y);
  friend growth_bound abs(const growth_bound& x);

  /// A ball that holds v(t) for all 0 < t <= r; undefined where v is not known to be bounded.
  [[nodiscard]] ball values() const;
  /// A function with these values; blocked where they are not bounded.
  [[nodiscard]] growth_bound bounded_like(std::string_view name, const ball& value) const;

  /// A constant beside this one.
  [[nodiscard]] growth_bound constant_like(const rational& q) const;
  [[nodiscard]] growth_bound constant_like(const ball& x) const {
    return constant_like(known_number(x));
  }
  [[nodiscard]] growth_bound constant_like(const known_number& x) const;

 private:
  [[nodiscard]] bool is_zero() const { return !blocked_ && factor().is_zero(); }

  /// f and g in v = f e^g.
  struct factors;

  [[nodiscard]] static growth_bound undefined(std::string_view where);
  /// Of two of which one is blocked: the one that is nowhere defined, if one is.
  [[nodiscard]] static growth_bound blocked_one(const growth_bound& x, const growth_bound& y);
  /// A function of this one, which is blocked.
  [[nodiscard]] growth_bound passed_on() const;
  [[nodiscard]] growth_bound constant_of(const ball& x, end_series series) const;
  /// With these bounds and this series, of which the better ones are kept. Blocked where the bounds
  /// are no numbers and the series is blocked.
  [[nodiscard]] growth_bound made(std::string_view name, const ball& most, const rational& b,
                                  const ball& least, const rational& a, int sign,
                                  end_series series) const;
  void improve_by(const growth_bound& other);
  void improve_by_series();
  void improve_by_term(const end_series& h, int k);
  /// C r^b of a positive function that does not grow towards t = 0, c r^a of one that does not
  /// fall; undefined of others.
  [[nodiscard]] ball greatest_value() const;
  [[nodiscard]] ball least_value() const;
  /// The greatest |v|, from above, where it does not grow towards t = 0; undefined of others.
  [[nodiscard]] ball greatest_size() const;
  /// r^e for e >= 0, upper and lower.
  [[nodiscard]] ball power_of_r(const rational& e) const;
  [[nodiscard]] growth_bound exponential() const;
  [[nodiscard]] std::optional<growth_bound> power_by_series() const;
  /// This one as f e^g; not of what is unknown.
  [[nodiscard]] factors factored() const;
  [[nodiscard]] static std::optional<factors> factors_of_sum(const growth_bound& x,
                                                             const growth_bound& y);
  /// f e^g.
  [[nodiscard]] static growth_bound of_factors(std::string_view name, const factors& v);
  /// The same of a function of what is blocked.
  [[nodiscard]] static growth_bound of_growing(std::string_view name, const factors& v);
  [[nodiscard]] growth_bound with_growing_parts() &&;
  /// An odd function of it, which is flatter the farther from 0.
  [[nodiscard]] growth_bound flattening(std::string_view name, const ball& bound, const ball& m,
                                        const ball& value_at_m, end_series series) const;
  /// log |v|.
  [[nodiscard]] growth_bound logarithm_of_size() const;
  /// With these factors, where they are known.
  [[nodiscard]] growth_bound with(const factors& v) &&;
  /// x^y for x > 0 and every y in the ball.
  [[nodiscard]] growth_bound to_the(const ball& y, std::string_view name, end_series series) const;

  double r_ = 0.5;
  ball most_ = ball(0, 64);   // C
  rational upper_exponent_;   // b
  ball least_ = ball(0, 64);  // c
  rational lower_exponent_;   // a
  int sign_ = 0;
  std::optional<ball> constant_;                 // where it is one
  std::shared_ptr<const growth_bound> inverse_;  // 1 divided by it, where that is remembered
  std::shared_ptr<const factors> factors_;       // where they are known
  end_series series_;                            // blocked where there is none
  end_series one_;                               // the number 1, for constants
  bool blocked_ = true;
  bool nowhere_defined_ = false;
  bool oscillates_ = false;
  bool has_growing_parts_ = false;
  std::string_view where_;
};

}  // namespace polhode
