#pragma once

// What a function is like at infinity where it decays (or grows) exponentially: a bound of its
// tail, found by calling it with a tail_series for its argument.
//
// A tail_series is a real function of t, 0 < t <= r, of the form e^phi(t) h(t) U(t): phi is 0 or an
// end_series with a negative power, such as -1/t^2, h an end_series, and U a function of which only
// an interval is known that holds its values. With x = s/t this describes exp(-x^2), sech x, x^1000
// e^-x sin x for large x. It knows nothing of complex arguments. What does not have this form is
// blocked.
//
// Where U tends to 1, w = U - 1 is a tail_series as well, and is kept: it is what is left where the
// 1 cancels. So 1 - tanh x, log(2 cosh x) - x and erf(x + 1) - erf x decay.

#include <memory>
#include <optional>
#include <string_view>

#include "quadrature/ends/end_series.hpp"

namespace polhode {

class tail_series {
 public:
  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;
  /// Blocked.
  tail_series() = default;
  /// s/t^root for 0 < t <= r; a root of its own makes whole powers of t of broken powers of x. An r
  /// above 1 counts as 1: of y = 1/t it is used that 0 <= log y <= y.
  [[nodiscard]] static tail_series argument(const known_number& s, double r,
                                            int orders = end_series::most_orders, long root = 1);

  [[nodiscard]] tail_series blocked(std::string_view where) const;
  [[nodiscard]] bool is_blocked() const { return h_.is_blocked() || (phi_ && phi_->is_blocked()); }
  [[nodiscard]] std::string_view where() const {
    return h_.is_blocked() || !phi_ ? h_.where() : phi_->where();
  }

  /// a + s t for 0 < t <= r: for a function that vanishes exponentially at a finite end.
  [[nodiscard]] static tail_series argument(const known_number& a, const known_number& s, double r,
                                            int orders = end_series::most_orders);

  /// The sign for 0 < t <= r; 0 where it is not known to be one.
  [[nodiscard]] int sign() const {
    return certainly_positive(u_) ? h_.sign() : certainly_negative(u_) ? -h_.sign() : 0;
  }

  /// |f| tends to infinity at t = 0, and f has one sign: phi > 0 has a negative power, U is away
  /// from 0, and h, which has one sign, is not 0 for all t: it is about c t^e |log t|^k with c not
  /// 0.
  [[nodiscard]] bool tends_to_infinity() const { return sign() != 0 && grows_exponentially(); }

  /// An upper bound of the integral of |f(s y)| over y >= Y, for Y >= 1/r: with |phi| >= c y^mu and
  /// |h U| <= B y^p (log y)^k, k and B summed over the terms of h, log y <= y, P = p + k,
  ///
  ///   integral of B y^P e^(-c y^mu) dy = (B/mu) integral of v^Q e^(-c v) dv over v >= V = Y^mu,
  ///   Q = (P + 1)/mu - 1,  <=  (B/mu) V^Q e^(-c V) / (c - max(Q, 0)/V)   where that is positive:
  ///
  /// the logarithm of v^Q e^(-c v) has the slope Q/v - c <= max(Q, 0)/V - c. Infinite where there
  /// is no exponential decay, or Y is too small.
  ///
  /// With a root: of |f(s y^root)| root y^(root-1), for the argument with this root.
  [[nodiscard]] magnitude integral_beyond(const ball& y, long root = 1) const {
    return multiply_up(integral(y, root - 1), ball(root, 64).magnitude_upper());
  }
  /// The same of |f(t)| over 0 < t <= 1/Y: with t = 1/y, dt = y^-2 dy in size.
  [[nodiscard]] magnitude integral_before(const ball& y) const { return integral(y, -2); }

  friend tail_series operator+(const tail_series& x) { return x; }
  friend tail_series operator-(const tail_series& x);
  friend tail_series operator+(const tail_series& x, const tail_series& y);
  friend tail_series operator-(const tail_series& x, const tail_series& y) { return x + (-y); }
  friend tail_series operator*(const tail_series& x, const tail_series& y);
  friend tail_series operator/(const tail_series& x, const tail_series& y);

  friend tail_series square(const tail_series& x) { return x * x; }
  friend tail_series sqrt(const tail_series& x);
  friend tail_series pow(const tail_series& x, long n);
  friend tail_series pow(const tail_series& x, const rational& e);
  friend tail_series pow(const tail_series& x, const tail_series& y);
  friend tail_series exp(const tail_series& x);
  friend tail_series log(const tail_series& x);
  /// Of what decays, x times a number in a range: (e^v - 1)/v increases from 0.78... to 1.29... and
  /// log(1 + v)/v decreases from 1.38... to 0.81... over -1/2 <= v <= 1/2. The functions sin, tan,
  /// asin, atan, sinh, tanh, asinh, atanh and erf do the same, each with its own range.
  friend tail_series expm1(const tail_series& x);
  friend tail_series log1p(const tail_series& x);
  /// |erf| <= 1, with the sign of x.
  friend tail_series erf(const tail_series& x);
  /// For x > 0, erfc(x) = (2/sqrt(pi)) integral of e^(-s^2) over s >= x <= (2/sqrt(pi)) integral of
  /// (s/x) e^(-s^2) = e^(-x^2)/(x sqrt(pi)); between 0 and 2 else.
  friend tail_series erfc(const tail_series& x);
  friend tail_series sin(const tail_series& x);
  friend tail_series cos(const tail_series& x);
  friend tail_series tan(const tail_series& x);
  friend tail_series asin(const tail_series& x);
  friend tail_series acos(const tail_series& x);
  friend tail_series atan(const tail_series& x);
  friend tail_series sinh(const tail_series& x);
  friend tail_series cosh(const tail_series& x);
  friend tail_series tanh(const tail_series& x);
  friend tail_series asinh(const tail_series& x);
  friend tail_series acosh(const tail_series& x);
  friend tail_series atanh(const tail_series& x);
  friend tail_series agm(const tail_series& x, const tail_series& y);
  friend tail_series abs(const tail_series& x);
  friend tail_series min(const tail_series& x, const tail_series& y);
  friend tail_series max(const tail_series& x, const tail_series& y);
  friend tail_series floor(const tail_series& x);
  friend tail_series ceil(const tail_series& x);

  /// Holds all values for 0 < t <= r; undefined where they are not known to be bounded.
  [[nodiscard]] ball values() const;
  /// A function with these values; blocked where they are not bounded.
  [[nodiscard]] tail_series bounded_like(std::string_view name, const ball& value) const;

  template <detail::series_constant N>
  [[nodiscard]] tail_series constant_like(const N& n) const {
    return {std::nullopt, one_.constant_like(n), one_, double_interval(1), r_};
  }

 private:
  tail_series(std::optional<end_series> phi, end_series h, end_series one, double_interval u,
              double r)
      : phi_(std::move(phi)), h_(std::move(h)), one_(std::move(one)), u_(u), r_(r) {
    settle();
  }
  /// Of |f| y^power over y = 1/t >= Y.
  [[nodiscard]] magnitude integral(const ball& y, long power) const;
  /// e^phi with phi bounded goes into h.
  void settle();
  [[nodiscard]] static tail_series sum(const tail_series& x, const tail_series& y);
  /// w of U = 1 + w, where it is known.
  [[nodiscard]] std::optional<tail_series> excess() const;
  /// The same with U = 1 + w; what is known of w's own U is kept to some depth.
  [[nodiscard]] tail_series with_excess(const tail_series& w) const;
  /// It times a function of which only this range is known.
  [[nodiscard]] tail_series times(double_interval range) const {
    return with(phi_, h_, u_ * range);
  }
  /// Whether it grows exponentially; whether it grows.
  [[nodiscard]] bool grows_exponentially() const {
    return !is_blocked() && phi_ && phi_->sign() > 0;
  }
  [[nodiscard]] bool grows() const {
    return grows_exponentially() || (!is_blocked() && !phi_ && h_.exponent() < 0);
  }
  /// The number 1.
  [[nodiscard]] tail_series one() const { return with(std::nullopt, one_, double_interval(1)); }
  /// h, without the exponential and U.
  [[nodiscard]] tail_series base() const { return with(std::nullopt, h_, double_interval(1)); }
  /// A range of all values, where it is bounded; undefined else.
  [[nodiscard]] double_interval range() const;
  /// f of h (1 + w), which is f(h) + h w f'(xi), where f' lies in `slope` on the whole line.
  template <class F>
  [[nodiscard]] std::optional<tail_series> shifted(F&& f, double_interval slope) const;
  /// e^x for x = e^phi h U of which no range is known, with |h| instead of h and U's sign turned
  /// where h < 0. Without phi, x <= |h| u for u = sup U. Where phi > 0 and u < 0: e^phi >= e phi
  /// (the tangent at 1), and e^phi >= (e phi/2)^2 (the same of phi/2), which is more for phi >=
  /// 4/e: x <= e phi |h| u, x <= (e phi/2)^2 |h| u. With H for that bound the value is e^H times
  /// something in (0, 1].
  [[nodiscard]] tail_series exp_of_growing() const;
  /// A series without logarithms that is at least h for 0 < t <= r, with a negative power of t: the
  /// one of (log t)/t is (log r)/t, so that t^(1/t) is e^((log r)/t) times something in (0, 1].
  /// Nothing where a term has not the sign for that.
  [[nodiscard]] std::optional<end_series> bound_without_logarithms(const end_series& h) const;
  /// It decays exponentially, and is at most 1/2 in size.
  [[nodiscard]] bool is_small() const;
  /// U is 1, and no function of which only a range is known.
  [[nodiscard]] bool has_no_factor() const { return u_.lower() == 1 && u_.upper() == 1; }
  [[nodiscard]] bool is_plain() const { return !phi_ && has_no_factor(); }
  [[nodiscard]] tail_series with(std::optional<end_series> phi, end_series h,
                                 double_interval u) const {
    return {std::move(phi), std::move(h), one_, u, r_};
  }
  template <class F>
  [[nodiscard]] tail_series regular(std::string_view name, F&& f) const;
  template <class F>
  [[nodiscard]] tail_series nearly_itself(double_interval range, F&& f) const;
  /// f of a real number, of which only |f| <= bound is known.
  template <class F>
  [[nodiscard]] tail_series bounded(F&& f, double_interval range) const;
  template <class F>
  [[nodiscard]] tail_series stepping(std::string_view name, F&& f, const ball& beside) const;

  std::optional<end_series> phi_;
  end_series h_;
  end_series one_;
  double_interval u_;
  double r_ = 0;
  /// Where U is 1 + w with a w that is known: w.
  std::shared_ptr<const tail_series> excess_;
  int depth_ = 0;  // how many have an excess in turn
};

template <detail::series_constant N>
[[nodiscard]] tail_series operator+(const tail_series& x, const N& n) {
  return x + x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] tail_series operator+(const N& n, const tail_series& x) {
  return x.constant_like(n) + x;
}
template <detail::series_constant N>
[[nodiscard]] tail_series operator-(const tail_series& x, const N& n) {
  return x - x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] tail_series operator-(const N& n, const tail_series& x) {
  return x.constant_like(n) - x;
}
template <detail::series_constant N>
[[nodiscard]] tail_series operator*(const tail_series& x, const N& n) {
  return x * x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] tail_series operator*(const N& n, const tail_series& x) {
  return x.constant_like(n) * x;
}
template <detail::series_constant N>
[[nodiscard]] tail_series operator/(const tail_series& x, const N& n) {
  return x / x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] tail_series operator/(const N& n, const tail_series& x) {
  return x.constant_like(n) / x;
}

}  // namespace polhode
