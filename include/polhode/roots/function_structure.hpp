#pragma once

// What a function is besides its values. Call a generic function with a function_structure, and the
// result has
//   the function as a quotient of products of factors with their powers, over a box: sin(x)^2 (x -
//   1) has
//     the factors sin(x), twice, and x - 1, and tan(x) is sin(x)/cos(x), so that poles are roots of
//     the denominator;
//   its range over that part of the box on which it is defined (natural_domain.hpp); its Taylor
//   coefficients at a point q + r pi, q and r rational, exactly where they are evidently rational.
// This is what multiple roots and poles are proved by: enclosures alone cannot tell a double root
// from two roots or none.

#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "polhode/arithmetic/inexact_operand.hpp"
#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/known_number.hpp"
#include "polhode/arithmetic/natural_domain.hpp"

namespace polhode {

class function_structure {
 public:
  using exact_series = jet<known_number, dynamic_order>;

  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;

  /// g^power, with g and g' over the box, and g at the point in it.
  struct factor {
    long id = 0;  // equal ids, in one evaluation of f, are the same function
    long power = 1;
    jet<ball, 1> over;
    ball at_point;
    /// What is multiplied is sqrt(g), |g| or g^c with c > 0, which has the zeros of g, and no
    /// multiplicity there.
    bool is_branch = false;
  };
  /// A product of the factors and of a function that vanishes nowhere in the box.
  struct product {
    long id = 0;
    std::vector<factor> factors;
    jet<ball, 1> over;  // the whole product
    ball at_point;
    /// Proved: where only one factor vanishes in the box, the product is defined at its zeros.
    bool is_defined_at_zeros = false;
  };

  /// The identity over the box, at the point, which lies in it.
  [[nodiscard]] static function_structure variable(const ball& box, const ball& point);
  /// The identity with its Taylor series at the point c, to the order; p bits where not exact.
  [[nodiscard]] static function_structure variable_at(const known_number& c, int order);
  [[nodiscard]] static function_structure variable_at(const pi_combination& c, int order,
                                                      precision p) {
    return variable_at(known_number(c, p), order);
  }
  [[nodiscard]] static function_structure variable_at(const rational& c, int order, precision p) {
    return variable_at(pi_combination{c, 0}, order, p);
  }

  // As the evaluation of formulas needs them: a constant beside a value.
  [[nodiscard]] function_structure constant_like(const rational& c) const {
    return constant_like(known_number(c, numerator_.at_point.precision()));
  }
  [[nodiscard]] function_structure constant_like(const known_number& c) const;
  [[nodiscard]] function_structure constant_like(const ball& c) const {
    return constant_like(known_number(c));
  }
  template <exact_number N>
  [[nodiscard]] function_structure constant_like(const N& n) const {
    return constant_like(rational(n));
  }

  /// The range where it is defined; std::nullopt where it is defined nowhere in the box.
  [[nodiscard]] const std::optional<ball>& natural_range() const { return natural_; }
  [[nodiscard]] const product& numerator() const { return numerator_; }
  /// std::nullopt where there is none, that is 1.
  [[nodiscard]] const std::optional<product>& denominator() const { return denominator_; }
  /// The function is not defined where this factor vanishes, as it was divided by: in 1/tan(x) =
  /// cos(x)/sin(x) both.
  [[nodiscard]] bool was_divided_by(const factor& g) const { return divisors_.contains(g.id); }
  /// Empty where it is not available.
  [[nodiscard]] const std::optional<exact_series>& series() const { return series_; }
  /// The function and its derivative over the box, undefined where the denominator may vanish.
  [[nodiscard]] jet<ball, 1> over() const;
  [[nodiscard]] ball at_point() const;

  friend function_structure operator+(const function_structure& x) { return x; }
  friend function_structure operator-(const function_structure& x);
  friend function_structure operator+(const function_structure& x, const function_structure& y);
  friend function_structure operator-(const function_structure& x, const function_structure& y);
  friend function_structure operator*(const function_structure& x, const function_structure& y);
  friend function_structure operator/(const function_structure& x, const function_structure& y);
  function_structure& operator+=(const function_structure& y) { return *this = *this + y; }
  function_structure& operator-=(const function_structure& y) { return *this = *this - y; }
  function_structure& operator*=(const function_structure& y) { return *this = *this * y; }
  function_structure& operator/=(const function_structure& y) { return *this = *this / y; }

  /// A new factor f(x): on_jets is called with jets of balls and with balls, natural with balls,
  /// and on_series with exact_series (or it is nullptr, where f has none). never_zero: f has no
  /// zero.
  template <class OnJets, class Natural, class OnSeries>
  [[nodiscard]] static function_structure applied(const function_structure& x, OnJets&& on_jets,
                                                  Natural&& natural, OnSeries&& on_series,
                                                  bool never_zero = false) {
    function_structure r = x.fresh(on_jets(x.over()), on_jets(x.at_point()), never_zero);
    if (x.natural_) r.natural_ = natural(*x.natural_);
    if constexpr (!std::same_as<std::remove_cvref_t<OnSeries>, std::nullptr_t>) {
      if (x.series_) r.series_ = on_series(*x.series_);
    }
    return r;
  }
  /// The same for a function of two.
  template <class OnJets, class Natural, class OnSeries = std::nullptr_t>
  [[nodiscard]] static function_structure applied_to_two(const function_structure& x,
                                                         const function_structure& y,
                                                         OnJets&& on_jets, Natural&& natural,
                                                         OnSeries on_series = nullptr) {
    function_structure r =
        x.fresh(on_jets(x.over(), y.over()), on_jets(x.at_point(), y.at_point()), false);
    r.add_divisors(y.divisors_);
    if (x.natural_ && y.natural_) r.natural_ = natural(*x.natural_, *y.natural_);
    if constexpr (!std::same_as<OnSeries, std::nullptr_t>) {
      if (x.series_ && y.series_) r.series_ = on_series(*x.series_, *y.series_);
    }
    return r;
  }
  /// The same for a function of any number of them, which is given vectors.
  template <class OnJets, class OnBalls, class Natural>
  [[nodiscard]] static function_structure applied_to_many(const std::vector<function_structure>& x,
                                                          OnJets&& on_jets, OnBalls&& on_balls,
                                                          Natural&& natural_of) {
    std::vector<jet<ball, 1>> over;
    std::vector<ball> at_point;
    std::vector<ball> natural;
    for (const function_structure& operand : x) {
      over.push_back(operand.over());
      at_point.push_back(operand.at_point());
      if (operand.natural_) natural.push_back(*operand.natural_);
    }
    function_structure r = x.front().fresh(on_jets(over), on_balls(at_point), false);
    for (const function_structure& operand : x) r.add_divisors(operand.divisors_);
    if (natural.size() == x.size()) r.natural_ = natural_of(natural);
    return r;
  }
  /// This function of u with the factors of u, as its zeros are exactly those of u, and it is
  /// defined there: sqrt(u) or |u|.
  [[nodiscard]] function_structure with_zeros_of(const function_structure& u) &&;
  /// A series with the value alone, for a function with breaks.
  [[nodiscard]] static exact_series value_alone(const exact_series& like,
                                                const known_number& value);

  friend function_structure pow(const function_structure& x, long n);

 private:
  /// Without a natural range (nowhere defined) and series.
  [[nodiscard]] function_structure fresh(jet<ball, 1> over, ball at_point, bool never_zero) const;
  [[nodiscard]] function_structure constant(const ball& c) const;
  void add_divisors(const std::set<long>& ids) { divisors_.insert(ids.begin(), ids.end()); }
  product numerator_;
  std::optional<product> denominator_;
  std::optional<ball> natural_;
  std::optional<exact_series> series_;
  std::set<long> divisors_;    // factors that were divided by
  std::shared_ptr<long> ids_;  // the greatest id given away
};

// With exact numbers and balls.
template <class N>
concept structure_constant = exact_number<N> || std::same_as<N, ball>;
#define POLHODE_WITH_CONSTANTS(sign)                                                        \
  template <structure_constant N>                                                           \
  [[nodiscard]] function_structure operator sign(const function_structure& x, const N& n) { \
    return x sign x.constant_like(n);                                                       \
  }                                                                                         \
  template <structure_constant N>                                                           \
  [[nodiscard]] function_structure operator sign(const N& n, const function_structure& x) { \
    return x.constant_like(n) sign x;                                                       \
  }
POLHODE_WITH_CONSTANTS(+)
POLHODE_WITH_CONSTANTS(-)
POLHODE_WITH_CONSTANTS(*)
POLHODE_WITH_CONSTANTS(/)
#undef POLHODE_WITH_CONSTANTS

[[nodiscard]] function_structure square(const function_structure& x);
[[nodiscard]] function_structure sqrt(const function_structure& x);
[[nodiscard]] function_structure exp(const function_structure& x);
[[nodiscard]] function_structure log(const function_structure& x);
[[nodiscard]] function_structure sin(const function_structure& x);
[[nodiscard]] function_structure cos(const function_structure& x);
[[nodiscard]] function_structure tan(const function_structure& x);
[[nodiscard]] function_structure asin(const function_structure& x);
[[nodiscard]] function_structure acos(const function_structure& x);
[[nodiscard]] function_structure atan(const function_structure& x);
[[nodiscard]] function_structure sinh(const function_structure& x);
[[nodiscard]] function_structure cosh(const function_structure& x);
[[nodiscard]] function_structure tanh(const function_structure& x);
[[nodiscard]] function_structure asinh(const function_structure& x);
[[nodiscard]] function_structure acosh(const function_structure& x);
[[nodiscard]] function_structure atanh(const function_structure& x);
[[nodiscard]] function_structure erf(const function_structure& x);
[[nodiscard]] function_structure erfc(const function_structure& x);
[[nodiscard]] function_structure abs(const function_structure& x);
[[nodiscard]] function_structure floor(const function_structure& x);
[[nodiscard]] function_structure ceil(const function_structure& x);
[[nodiscard]] function_structure min(const function_structure& x, const function_structure& y);
[[nodiscard]] function_structure max(const function_structure& x, const function_structure& y);
namespace detail {
/// The range of x^y where it is defined, or more: as pow(x, y) has it, a whole y for every x.
[[nodiscard]] std::optional<ball> natural_power(const ball& x, const ball& y);
/// The series of x^y for x > 0; where x is 0 and y > 0, the value 0 alone.
[[nodiscard]] function_structure::exact_series exact_power(
    const function_structure::exact_series& x, const function_structure::exact_series& y);
/// x^y, where on_jets computes it over jets and balls.
template <class OnJets>
[[nodiscard]] function_structure power_of(const function_structure& x, const function_structure& y,
                                          OnJets&& on_jets) {
  function_structure r =
      function_structure::applied_to_two(x, y, on_jets, natural_power, exact_power);
  if (!certainly_positive(y.over()[0])) return r;
  return std::move(r).with_zeros_of(x);  // for y > 0, 0^y is 0, and x^y is not 0 for x not 0
}
}  // namespace detail
/// x^y for x > 0.
[[nodiscard]] function_structure pow(const function_structure& x, const function_structure& y);
template <rational_like N>
[[nodiscard]] function_structure pow(const function_structure& x, const N& y) {
  return pow(x, x.constant_like(y));
}

}  // namespace polhode
