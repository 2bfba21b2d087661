#pragma once

// Integrals of functions with parameters that are known as intervals.
//
//   const auto f = [](const auto& x, const auto& p) { return exp(p[0] * x); };
//   box_integral i = integrate_box(f, 0, 1, {{1, rational(11, 10)}}, {.digits = 20});
//
// holds { integral of f(x, p) dx from a to b : p in the box }. With I(p) for the integral and P for
// the box, three enclosures are made and what they have in common is returned:
//
//   direct:      f is integrated with the parameters as sets. Its excess is of the order of the
//                widths.
//   mean value:  I(q) + sum over i of D_i (P_i - q_i), q the middle of P and D_i an enclosure of
//                the integrals of df/dp_i over all p in P. Its excess is of the order of the
//                widths' squares.
//   monotone:    where D_i has no negative member, or no positive one, P_i is replaced by its end
//                with the least, and that with the greatest, I. Where all D_i are so, both ends of
//                the enclosure are integrals at points.
//
// Proof of the second: let p be in P, and p(s) = q + s (p - q). For every x between a and b, f(x,
// p(s)) is a function of s with a bounded derivative, the sum of df/dp_i (p_i - q_i), so f(x, p) -
// f(x, q) is its integral over 0 <= s <= 1. Integrate over x and exchange the integrals (Fubini;
// the integrand is bounded and piecewise analytic): I(p) - I(q) = sum of (p_i - q_i) times the mean
// over s of the integral of df/dp_i(x, p(s)) dx, which is in D_i for every s; D_i is an interval,
// so the mean is in it. With q any other point of P that differs from p in p_i alone, it is the
// third. What it asks for is proved, not assumed: the derivatives are jets' (jet.hpp) over regions
// and balls, which are not analytic, or undefined, where f is not differentiable by p_i somewhere
// in P, and those of an f that itself is not analytic there are refused here. Where an integral of
// a derivative is not had, the direct enclosure stands alone.
//
// f is a formula in x and the parameters, or a generic function of x and of a std::vector p with
// the parameters p[0], p[1], ..., as for `integrate`.

#include <functional>
#include <string>
#include <vector>

#include "polhode/arithmetic/certified_answer.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/quadrature/integrate.hpp"

namespace polhode {

/// The numbers from lower to upper, which are exact.
class parameter_range {
 public:
  /// Throws std::invalid_argument where lower > upper.
  parameter_range(rational lower, rational upper);
  /// One number.
  parameter_range(const rational& value)  // NOLINT(google-explicit-constructor): exact
      : parameter_range(value, value) {}
  template <machine_integer N>
  parameter_range(N value)  // NOLINT(google-explicit-constructor): exact
      : parameter_range(rational(value)) {}
  /// The set x. Throws std::invalid_argument where it is not bounded.
  parameter_range(const ball& x);  // NOLINT(google-explicit-constructor): the same set

  [[nodiscard]] const rational& lower() const { return lower_; }
  [[nodiscard]] const rational& upper() const { return upper_; }
  [[nodiscard]] bool is_point() const { return lower_ == upper_; }
  [[nodiscard]] rational middle() const { return (lower_ + upper_) / 2; }
  [[nodiscard]] rational width() const { return upper_ - lower_; }
  /// All of it, with p bits.
  [[nodiscard]] ball enclosure(precision p) const;

 private:
  rational lower_;
  rational upper_;
};

struct box_options {
  /// Of the integrals at points.
  long digits = 15;
  /// The box is cut, where that promises most, into so many at most.
  long most_boxes = 1;
  /// Of each integral.
  long most_evaluations = 50'000;
  /// Called before each integral, with the number of those that are done; may be empty. What it
  /// throws ends the work.
  std::function<void(long)> progress = {};
};

/// The enclosure holds the integral for every p in the box. Certified: it is bounded and proved.
/// How near its ends are to the least and the greatest integral is promised only where `attained`
/// says so.
struct box_integral : certified_answer<ball> {
  /// I was proved monotone in every parameter (on every box, where it was cut): each end of the
  /// enclosure is the least, or greatest, integral, to 10^-digits of it.
  bool attained = false;
  long boxes = 0;      // that make up the result
  long integrals = 0;  // that were computed for it
};

/// Encloses the integral of f(x, p) dx from a to b for every p in the box, f a formula in x and the
/// parameters. Refused, with the reason and the obstacle that `integrate` met, where f is not
/// proved integrable for every p in it. Throws std::invalid_argument for digits or most_boxes below
/// 1, input_error where the box has another number of sides than f has parameters, and as
/// `integrate` does.
[[nodiscard]] box_integral integrate_box(const expression& f, const end_point& a,
                                         const end_point& b,
                                         const std::vector<parameter_range>& box,
                                         const box_options& options = {});

/// The same of a generic function of x and of the parameters, a std::vector, through its formula.
template <class F>
[[nodiscard]] box_integral integrate_box(const F& f, const end_point& a, const end_point& b,
                                         const std::vector<parameter_range>& box,
                                         const box_options& options = {}) {
  return integrate_box(formula_with_parameters(f, box.size()), a, b, box, options);
}

}  // namespace polhode
