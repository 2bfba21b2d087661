#pragma once

// What a function is like at an end of its range, where it may be singular: found by calling it
// with an end_series for its argument.
//
// An end_series is a function of t near t = 0, t > 0, of the form
//
//   h(t) = t^m * (G_0(t) + L G_1(t) + ... + L^K G_K(t)),    L = log t,
//
// with a rational m and functions G_k that are real for real t and analytic on a neighbourhood of
// the square
// |Re t| <= r, |Im t| <= r. Of each G_k it knows two jets: the Taylor coefficients at 0, as real
// balls, and exactly where they are rational numbers of moderate size; and enclosures over the
// whole square, as regions. So 1 - cos t is known to be t^2 times something that is not 0 near 0,
// and log(t) / sqrt(t) is what it looks like. What does not have this form (exp(1/t), t^t, a pole
// inside the square) is *blocked*, with the name of the function that did it, and blocks all that
// is made of it.
//
// h is meant as the analytic continuation from small t > 0: the branch of t^m and log t is the real
// one there, and every function below is the real function of real arguments, continued.
//
// DIVISION BY t. Where G(0) = 0 is known exactly, G(t) = t H(t) with H(t) = integral of G'(s t)
// over 0 <= s <= 1, so that H^(j)(t)/j! = integral of (j+1) s^j [G^(j+1)(s t)/(j+1)!] ds is a mean
// of values of G's coefficient of order j+1 (the square is convex and holds s t): H's coefficients
// at 0 are G's, moved down by one, and over the square they lie in the convex hulls of the sets
// that hold G's.

#include <functional>
#include <memory>
#include <optional>

#include <string_view>
#include <vector>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/known_number.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode {

class end_series {
 public:
  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;
  /// What may help a series that is blocked, to search with.
  enum class remedy {
    unknown,  // perhaps one of those below
    smaller_square,
    more_orders,
    other_root,  // q
    none
  };
  /// How many orders are followed, unless said otherwise.
  static constexpr int most_orders = 8;

  /// Blocked.
  end_series() : blocked_(true) {}
  /// a + s t^q over the square of half-side r, for q > 0; for q < 0 and a = 0, an end at infinity.
  [[nodiscard]] static end_series argument(const known_number& a, const known_number& s, long q,
                                           double r, int orders = most_orders);

  [[nodiscard]] static end_series blocked(std::string_view where, remedy r = remedy::unknown);
  [[nodiscard]] bool is_blocked() const { return blocked_; }
  [[nodiscard]] remedy what_may_help() const { return remedy_; }
  /// The name of the function that could not be continued; empty where there is none.
  [[nodiscard]] std::string_view where() const { return where_; }

  /// m; of a function that is 0 as far as is known, a lower bound of it.
  [[nodiscard]] const rational& exponent() const { return m_; }
  /// K.
  [[nodiscard]] int log_degree() const { return static_cast<int>(terms_.size()) - 1; }
  /// The same function with G_0(0), ..., G_K(0) not all known to be 0, as far as the known orders
  /// go.
  [[nodiscard]] end_series simplified() const;
  /// The same function where it is known from elsewhere to be q at t = 0: G_0(0) is made exact,
  /// where m = 0 = K. Blocked where its enclosure says otherwise.
  [[nodiscard]] end_series with_value_at_0(const rational& q) const;
  /// t^m G_k, simplified; k <= K.
  [[nodiscard]] end_series coefficient(int k) const;
  /// G_0(0), where m = 0 = K.
  [[nodiscard]] std::optional<known_number> value_at_0() const;
  /// G_K(0) is certainly not 0.
  [[nodiscard]] bool leads_surely() const;

  /// An upper bound of |G_K(0)|.
  [[nodiscard]] magnitude size_at_0() const;

  /// An upper bound of |G_k| over the square; infinite where blocked.
  [[nodiscard]] magnitude supremum(int k) const;

  friend end_series operator+(const end_series& x) { return x; }
  friend end_series operator-(const end_series& x);
  friend end_series operator+(const end_series& x, const end_series& y);
  friend end_series operator-(const end_series& x, const end_series& y) { return x + (-y); }
  friend end_series operator*(const end_series& x, const end_series& y);
  friend end_series operator/(const end_series& x, const end_series& y);

  friend end_series square(const end_series& x) { return x * x; }
  friend end_series sqrt(const end_series& x);
  friend end_series pow(const end_series& x, long n);
  friend end_series pow(const end_series& x, const rational& e);
  friend end_series pow(const end_series& x, const end_series& y);
  friend end_series log(const end_series& x);
  friend end_series exp(const end_series& x);
  friend end_series sin(const end_series& x);
  friend end_series cos(const end_series& x);
  friend end_series tan(const end_series& x);
  friend end_series asin(const end_series& x);
  friend end_series acos(const end_series& x);
  friend end_series atan(const end_series& x);
  friend end_series sinh(const end_series& x);
  friend end_series cosh(const end_series& x);
  friend end_series tanh(const end_series& x);
  friend end_series asinh(const end_series& x);
  friend end_series acosh(const end_series& x);
  friend end_series atanh(const end_series& x);
  friend end_series erf(const end_series& x);
  friend end_series erfc(const end_series& x);
  friend end_series abs(const end_series& x);
  friend end_series min(const end_series& x, const end_series& y);
  friend end_series max(const end_series& x, const end_series& y);
  friend end_series floor(const end_series& x);
  friend end_series ceil(const end_series& x);

  /// f of it, for a function f by its value at t = 0, its continuation over the square, and f' over
  /// series: with g = f(x) and h = f'(x), k g_k = the sum of j x_j h_(k-j) over 1 <= j <= k. To few
  /// orders, as f' may cost several values of f. Blocked where x has a pole or a logarithm.
  [[nodiscard]] end_series composed(
      std::string_view name, const std::function<known_number(const known_number&)>& value,
      const std::function<region(const region&)>& over,
      const std::function<end_series(const end_series&)>& slope) const;

  /// The sign for 0 < t <= r; 0 where it is not known to be one.
  [[nodiscard]] int sign() const;
  /// A lower bound of |G_0| over the square, for K = 0.
  [[nodiscard]] magnitude infimum() const;
  /// The range over 0 < t <= r, of a series without logarithms and with m >= 0; else undefined.
  [[nodiscard]] double_interval real_range() const;
  [[nodiscard]] bool tends_to_0() const;
  /// The integer to which it is proved to tend, without logarithms and roots of t.
  [[nodiscard]] std::optional<long> exact_value_at_0() const;
  /// Proved to be 0 everywhere.
  [[nodiscard]] bool is_zero() const;
  /// The rational number that it is proved to be everywhere.
  [[nodiscard]] std::optional<rational> rational_constant() const;

  /// A constant function beside this one.
  template <exact_number N>
  [[nodiscard]] end_series constant_like(const N& n) const {
    return constant(known_number(rational(n)), detail::constant_region(n, region()));
  }
  [[nodiscard]] end_series constant_like(const ball& x) const {
    return constant(known_number(x), region(x));
  }
  [[nodiscard]] end_series constant_like(const known_number& x) const {
    return constant(x, region(x.enclosure()));
  }
  /// A constant c of which |c| <= most is known, real or not: what is made of it by sums and
  /// products is right in its exponent and over the square, for each such c.
  [[nodiscard]] end_series bounded_like(const magnitude& most) const;

 private:
  static constexpr precision bits = known_number::usual_precision;
  using centre_jet = jet<known_number, dynamic_order>;
  using square_jet = jet<region, dynamic_order>;
  /// G_k's two jets. They have the same order, which falls with each division by t.
  struct term {
    centre_jet at_0;
    square_jet over;
  };

  /// The same to so many orders, of those that it has.
  [[nodiscard]] static term with_orders(const term& g, int n);
  [[nodiscard]] end_series constant(const known_number& at_0, const region& over) const;

  /// Not blocked, or the first that is.
  template <class F>
  static end_series regular(const end_series& x, std::string_view name, F&& f);
  [[nodiscard]] end_series checked(std::string_view name) &&;
  /// Blocked, if it is, by what another kind of series may yet help.
  [[nodiscard]] end_series with_any_remedy() const;
  [[nodiscard]] end_series moved(long powers) const;
  static void divide_by_t(term& g);
  /// K = 0 and m such that G_0(0) is certainly not 0 and G_0 has no zero in the square; else
  /// blocked.
  [[nodiscard]] end_series normalised(std::string_view name) const;
  /// m = 0 and K = 0, with t^m multiplied in where m is a natural number; else blocked.
  [[nodiscard]] end_series plain(std::string_view name) const;

  rational m_ = 0;
  double r_ = 0;
  std::vector<term> terms_;
  bool blocked_ = false;
  remedy remedy_ = remedy::unknown;
  std::string_view where_;
};

namespace detail {
template <class N>
concept series_constant = exact_number<N> || std::same_as<N, ball> || std::same_as<N, known_number>;
}  // namespace detail

template <detail::series_constant N>
[[nodiscard]] end_series operator+(const end_series& x, const N& n) {
  return x.is_blocked() ? x : x + x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] end_series operator+(const N& n, const end_series& x) {
  return x + n;
}
template <detail::series_constant N>
[[nodiscard]] end_series operator-(const end_series& x, const N& n) {
  return x.is_blocked() ? x : x - x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] end_series operator-(const N& n, const end_series& x) {
  return x.is_blocked() ? x : x.constant_like(n) - x;
}
template <detail::series_constant N>
[[nodiscard]] end_series operator*(const end_series& x, const N& n) {
  return x.is_blocked() ? x : x * x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] end_series operator*(const N& n, const end_series& x) {
  return x * n;
}
template <detail::series_constant N>
[[nodiscard]] end_series operator/(const end_series& x, const N& n) {
  return x.is_blocked() ? x : x / x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] end_series operator/(const N& n, const end_series& x) {
  return x.is_blocked() ? x : x.constant_like(n) / x;
}

}  // namespace polhode
