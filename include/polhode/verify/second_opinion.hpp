#pragma once

// A second opinion: a result is found again by a route that shares as little with the first as
// there is, and the two are compared.
//
//   const expression f = parse("exp(-x^2)");
//   const integral first = integrate(f, 0, 1, {.digits = 30});
//   const second_opinion second = integral_again(f, 0, 1, first, 30);     // second_integral.hpp
//   if (second.agrees()) std::cout << second.routes().back().route;
//
// Each route proves that the true value lies in a set. Two such sets without a common number are a
// contradiction: one of the proofs is wrong, and contradiction_error is thrown. Where they have
// one, and the second is as narrow as the digits that were asked for, the result is confirmed. A
// route that proves less confirms nothing.

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/magnitude.hpp"
#include "polhode/roots/isolate.hpp"

namespace polhode {

/// Two proofs contradict each other, so that one of them is wrong: a fault in Polhode. what() names
/// both, in several lines.
class contradiction_error : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// What a route proved: that the number lies in the set.
template <class Set>
struct finding {
  std::string route;
  Set enclosure;
};

/// Throws contradiction_error where the two sets have no number in common; `what` is the number:
/// "the integral". A set that is undefined or unbounded holds everything.
void expect_overlap(std::string_view what, const finding<ball>& first, const finding<ball>& second);
void expect_overlap(std::string_view what, const finding<complex_ball>& first,
                    const finding<complex_ball>& second);

/// Throws contradiction_error: the first route proved one thing, and the second another that
/// excludes it.
[[noreturn]] void contradict(std::string_view what, const finding<std::string>& first,
                             const finding<std::string>& second);

/// How wide an enclosure may be to confirm `first` to so many digits: the greater of first's radius
/// and 10^-digits of its size.
[[nodiscard]] magnitude confirming_radius(const ball& first, long digits);
[[nodiscard]] magnitude confirming_radius(const complex_ball& first, long digits);

/// What is proved of a root, as root_region has it.
struct proved_root {
  root_verdict verdict = root_verdict::unresolved;
  long multiplicity = 0;
  ball enclosure;
  bool may_lie_outside = false;

  /// One root of that multiplicity, if it has one, is in the enclosure and in the interval.
  [[nodiscard]] bool is_resolved() const { return is_one_root(verdict) && !may_lie_outside; }
};

/// Every root in the interval lies in one of the enclosures, which ascend.
struct proved_roots {
  bool complete = true;  // else roots may be missing
  bool identically_zero = false;
  std::vector<proved_root> roots;

  [[nodiscard]] bool is_resolved() const;
};

/// What came of one further route.
struct route_report {
  std::string route;     // "Gauss-Legendre, the range cut at 0.3704"
  std::string obstacle;  // why it confirms nothing; empty where it confirms the result
  /// What it found, where it confirms the result.
  std::variant<std::monostate, ball, complex_ball, proved_roots> enclosure;
  std::string work;  // "76 evaluations with 233 bits"; may be empty
  double seconds = 0;

  [[nodiscard]] bool agrees() const { return obstacle.empty(); }
};

/// The routes tried, in their order.
class second_opinion {
 public:
  void add(route_report r) { routes_.push_back(std::move(r)); }
  /// A route confirms the result.
  [[nodiscard]] bool agrees() const;
  [[nodiscard]] const std::vector<route_report>& routes() const { return routes_; }

 private:
  std::vector<route_report> routes_;
};

}  // namespace polhode
