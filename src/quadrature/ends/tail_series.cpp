#include "quadrature/ends/tail_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {

namespace {

/// The number itself; undefined for an infinity.
ball exactly(const magnitude& x) {
  if (x.is_infinite()) return ball::undefined(64);
  ball r(static_cast<long>(x.fraction()), 64);
  if (!x.is_zero()) scale(r, r, static_cast<long>(x.exponent()));
  return r;
}

double_interval outward(const ball& x) { return double_interval::from_ball(x); }

}  // namespace

tail_series tail_series::argument(const known_number& s, double r, int orders, long root) {
  const double most = std::min(r, 1.0);
  const end_series x = end_series::argument(known_number(), s, -root, most, orders);
  return {std::nullopt, x, x.constant_like(1), double_interval(1), most};
}

tail_series tail_series::argument(const known_number& a, const known_number& s, double r,
                                  int orders) {
  const end_series x = end_series::argument(a, s, 1, r, orders);
  return {std::nullopt, x, x.constant_like(1), double_interval(1), r};
}

tail_series tail_series::blocked(std::string_view where) const {
  return {std::nullopt, end_series::blocked(where), one_, double_interval(1), r_};
}

void tail_series::settle() {
  if (is_blocked()) return;
  if (u_.is_undefined()) {
    h_ = end_series::blocked("a function's range");
    return;
  }
  if (!phi_) return;
  *phi_ = phi_->simplified();
  if (phi_->is_zero()) {
    phi_.reset();
  } else if (phi_->exponent() >= 0) {
    h_ = h_ * exp(*phi_);
    phi_.reset();
  }
}

std::optional<tail_series> tail_series::excess() const {
  if (has_no_factor()) return with(std::nullopt, one_ * 0, double_interval(1));
  if (excess_) return *excess_;
  return std::nullopt;
}

tail_series tail_series::with_excess(const tail_series& w) const {
  constexpr int most_depth = 3;
  if (is_blocked() || w.is_blocked() || has_no_factor()) return *this;
  tail_series result = *this;
  tail_series kept = w;
  if (kept.depth_ + 1 >= most_depth) {
    kept.excess_.reset();
    kept.depth_ = 0;
  }
  result.depth_ = kept.depth_ + 1;
  result.excess_ = std::make_shared<const tail_series>(std::move(kept));
  return result;
}

tail_series operator-(const tail_series& x) {
  tail_series result = x;
  result.h_ = -x.h_;
  return result;
}

/// (1 + w) (1 + v) = 1 + (w + v + w v).
tail_series operator*(const tail_series& x, const tail_series& y) {
  if (x.is_blocked()) return x;
  if (y.is_blocked()) return y;
  std::optional<end_series> phi = x.phi_;
  if (y.phi_) phi = phi ? *phi + *y.phi_ : *y.phi_;
  if (x.has_no_factor() && y.has_no_factor()) {
    return x.with(std::move(phi), x.h_ * y.h_, double_interval(1));
  }
  tail_series product = x.with(std::move(phi), x.h_ * y.h_, x.u_ * y.u_);
  if (x.has_no_factor()) return y.excess_ ? product.with_excess(*y.excess_) : product;
  if (y.has_no_factor()) return x.excess_ ? product.with_excess(*x.excess_) : product;
  if (!x.excess_ || !y.excess_) return product;
  const tail_series& w = *x.excess_;
  const tail_series& v = *y.excess_;
  return product.with_excess(w + v + w * v);
}

/// 1/(1 + w) = 1 - w/(1 + w).
tail_series operator/(const tail_series& x, const tail_series& y) {
  if (y.is_blocked()) return y;
  std::optional<end_series> phi;
  if (y.phi_) phi = -*y.phi_;
  if (y.has_no_factor()) return x * y.with(std::move(phi), 1 / y.h_, double_interval(1));
  const double_interval inverse = 1 / y.u_;
  const tail_series divisor = y.with(std::move(phi), 1 / y.h_, inverse);
  return x * (y.excess_ ? divisor.with_excess(-y.excess_->times(inverse)) : divisor);
}

/// With the greater exponential in front: e^phi h (U + (g/h) V e^delta), where delta = -c y^mu
/// times at least 1 and |g/h| <= B y^P as for integral_beyond, and y^P e^(-c y^mu) decreases for y
/// >= 1/r.
tail_series operator+(const tail_series& x, const tail_series& y) { return tail_series::sum(x, y); }

tail_series tail_series::sum(const tail_series& x, const tail_series& y) {
  if (x.is_blocked()) return x;
  if (y.is_blocked()) return y;
  if (x.h_.is_zero()) return y;
  if (y.h_.is_zero()) return x;
  std::optional<end_series> delta;
  if (x.phi_ || y.phi_) {
    delta = (y.phi_ ? *y.phi_ : y.one_ * 0) - (x.phi_ ? *x.phi_ : x.one_ * 0);
    *delta = delta->simplified();
    if (delta->is_blocked()) return x.blocked("+");
    if (delta->is_zero()) delta.reset();
  }
  if (!delta || delta->exponent() >= 0) {
    // y in terms of x's exponential.
    const end_series h = delta ? y.h_ * exp(*delta) : y.h_;
    if (h.is_blocked()) return x.blocked("+ (of exponentials)");
    if (x.has_no_factor() && y.has_no_factor()) return x.with(x.phi_, x.h_ + h, double_interval(1));
    if (h.is_zero()) return x;
    // h_x (1 + w) + h (1 + v) = (h_x + h) + (h_x w + h v); where h_x + h is 0 it is h_x (w - v).
    const std::optional<tail_series> w = x.excess();
    const std::optional<tail_series> v = y.excess();
    if (w && v) {
      const end_series total = x.h_ + h;
      const tail_series exponential = x.with(x.phi_, x.one_, double_interval(1));
      if (total.is_zero()) return exponential * x.base() * (*w - *v);
      const tail_series rest = x.base() * *w + x.with(std::nullopt, h, double_interval(1)) * *v;
      const tail_series both = sum(x.with(std::nullopt, total, double_interval(1)), rest);
      if (!both.is_blocked()) return exponential * both;
    }
    const double_interval ratio = (h / x.h_).real_range();
    if (!ratio.is_undefined()) return x.with(x.phi_, x.h_, x.u_ + ratio * y.u_);
    const double_interval other = (x.h_ / h).real_range();
    return x.with(x.phi_, h, y.u_ + other * x.u_);
  }
  const int sign = delta->sign();
  if (sign == 0) return x.blocked("+ (of exponentials)");
  if (sign > 0) return sum(y, x);
  const end_series quotient = y.h_ / x.h_;
  if (quotient.is_blocked()) return x.blocked("+");
  tail_series smaller = y.with(std::move(delta), quotient, y.u_);
  const double_interval error = smaller.range();
  if (error.is_undefined()) return x.blocked("+ (of exponentials)");
  if (y.excess_) smaller = smaller.with_excess(*y.excess_);
  tail_series result = x.with(x.phi_, x.h_, x.u_ + error);
  const std::optional<tail_series> w = x.excess();
  return w ? result.with_excess(*w + smaller) : result;
}

/// Where phi < 0, |phi| >= c y^mu and |h| is at most the sum of B y^p (log y)^k, log y <= y, with
/// y^P e^(-c y^mu), P = p + k, decreasing for y >= 1/r.
double_interval tail_series::range() const {
  if (h_.is_zero()) return double_interval(0);
  if (!phi_) return h_.real_range() * u_;
  if (phi_->sign() >= 0) return double_interval::undefined();
  const ball mu(rational(-phi_->exponent()), 64);
  const ball start = 1 / ball::exactly(r_, 64);
  const ball slope = exactly(phi_->infimum()) * pow(start, mu);
  magnitude bound;
  for (int k = 0; k <= h_.log_degree(); ++k) {
    const ball p(rational(k - h_.exponent()), 64);
    if (!certainly_less(p, mu * slope)) return double_interval::undefined();
    const ball size = exactly(h_.supremum(k)) * pow(start, p) * exp(-slope);
    bound = add_up(bound, size.magnitude_upper());
  }
  const double_interval both = outward(ball(0, 64).enlarged(bound));
  const int sign = h_.sign();
  return double_interval(sign > 0 ? 0.0 : both.lower(), sign < 0 ? 0.0 : both.upper()) * u_;
}

ball tail_series::values() const {
  constexpr precision bits = 64;
  if (is_blocked()) return ball::undefined(bits);
  return to_ball(range(), bits);
}

tail_series tail_series::bounded_like(std::string_view name, const ball& value) const {
  if (!value.is_bounded()) return blocked(name);
  return one().times(double_interval::from_ball(value));
}

tail_series sqrt(const tail_series& x) { return pow(x, rational(1, 2)); }

tail_series pow(const tail_series& x, const rational& e) {
  if (x.is_blocked()) return x;
  std::optional<end_series> phi;
  if (x.phi_) phi = *x.phi_ * e;
  double_interval u(1);
  if (!x.has_no_factor()) {
    const bool is_whole = denominator(e) == 1 && abs(numerator(e)) <= 1'000'000'000;
    u = is_whole ? pow(x.u_, static_cast<long>(numerator(e))) : exp(double_interval(e) * log(x.u_));
  }
  tail_series result = x.with(std::move(phi), pow(x.h_, e), u);
  const double_interval between = hull(double_interval(1), x.u_);
  if (!x.excess_ || !certainly_positive(between)) return result;
  // (1 + w)^e = 1 + w e (1 + xi)^(e-1), xi between 0 and w.
  const double_interval slope = double_interval(e) * exp(double_interval(e - 1) * log(between));
  return result.with_excess(x.excess_->times(slope));
}

tail_series pow(const tail_series& x, long n) { return pow(x, rational(n)); }

/// A power with a rational exponent is known. Where x >= 1 and y <= e: x^y = x^e U with
/// U = x^(y - e) in (0, 1]; where 0 < x <= 1, so for y >= e. Else e^(y log x).
tail_series pow(const tail_series& x, const tail_series& y) {
  if (x.is_blocked() || y.is_blocked()) return exp(y * log(x));
  if (const auto e = y.is_plain() ? y.h_.rational_constant() : std::nullopt) return pow(x, *e);
  const double_interval exponents = y.is_plain() ? y.h_.real_range() : double_interval::undefined();
  if (exponents.is_undefined() || !x.is_plain() || x.h_.sign() <= 0) return exp(y * log(x));
  constexpr double places = 1024;  // of e: it stays short
  constexpr double most = 0x1p40;
  if (!(exponents.upper() < most && exponents.lower() > -most)) return exp(y * log(x));
  const auto to_power = [&](double e) {
    return x.with(std::nullopt, pow(x.h_, rational(e)), double_interval(0.0, 1.0));
  };
  if ((x.one_ / x.h_).real_range().upper() <= 1) {
    return to_power(std::ceil(exponents.upper() * places) / places);
  }
  if (x.h_.real_range().upper() <= 1) {
    return to_power(std::floor(exponents.lower() * places) / places);
  }
  return exp(y * log(x));
}

tail_series exp(const tail_series& x) {
  if (x.is_blocked()) return x;
  if (!x.is_plain()) {
    // e^(g + w) = e^g (1 + w e^xi), xi between 0 and w: w is what decays, g the rest.
    const std::optional<tail_series> v = x.phi_ ? std::nullopt : x.excess();
    const tail_series w = x.phi_ ? x : v ? x.base() * *v : x.blocked("exp");
    const double_interval small = w.is_blocked() ? double_interval::undefined() : w.range();
    if (!small.is_undefined()) {
      tail_series factor = x.with(std::nullopt, x.one_, exp(small))
                               .with_excess(w.times(exp(hull(double_interval(0), small))));
      if (x.phi_) return factor;
      tail_series result = exp(x.base()) * factor;
      if (!result.is_blocked()) return result;
    }
    const double_interval range = x.range();
    if (range.is_undefined()) return x.exp_of_growing();
    return x.with(std::nullopt, x.one_, exp(range));
  }
  const end_series h = x.h_.simplified();
  if (h.log_degree() == 0 && h.exponent() < 0) return x.with(h, x.one_, double_interval(1));
  if (h.log_degree() > 0 && h.exponent() < 0) {
    if (const auto bound = x.bound_without_logarithms(h)) {
      return x.with(*bound, x.one_, double_interval(0.0, 1.0));
    }
  }
  return x.with(std::nullopt, exp(h), double_interval(1));
}

// With L = log t <= l < 0, L^k - l^k is negative for odd k, and positive for even k. Of the other
// sign is a lower term with k = 1: the tangent of log at 64 lies above it, and log 64 = 6 log 2 is
// less than 6 * 0.6932 < 4.16, so that log y <= y/64 - 1 + log 64 < y/64 + 79/25 for y = 1/t.
std::optional<end_series> tail_series::bound_without_logarithms(const end_series& h) const {
  const ball logarithm = log(ball::exactly(r_, 64));
  if (!certainly_negative(logarithm)) return std::nullopt;
  const rational l = upper_rational(logarithm);
  end_series bound = h.coefficient(0);
  rational power = 1;
  for (int k = 1; k <= h.log_degree(); ++k) {
    power *= l;
    const end_series c = h.coefficient(k);
    if (c.is_zero()) continue;
    if (c.sign() == (k % 2 != 0 ? 1 : -1)) {
      bound = bound + c * power;
    } else if (k == 1 && c.sign() == -1) {
      const end_series y =
          end_series::argument(known_number(rational(0)), known_number(rational(1)), -1, r_);
      bound = bound - c * (y * rational(1, 64) + rational(79, 25));
    } else {
      return std::nullopt;
    }
  }
  bound = bound.simplified();
  if (bound.is_blocked() || bound.log_degree() != 0 || bound.exponent() >= 0) return std::nullopt;
  return bound;
}

tail_series tail_series::exp_of_growing() const {
  const int sign = h_.sign();
  if (sign == 0) return blocked("exp");
  const double greatest = sign > 0 ? u_.upper() : -u_.lower();
  end_series bound = (sign > 0 ? h_ : -h_) * rational(greatest);
  if (phi_) {
    if (phi_->sign() <= 0 || greatest >= 0) return blocked("exp");
    const rational e_below(2718281828, 1000000000);
    const ball start = 1 / ball::exactly(r_, 64);
    const ball least = exactly(phi_->infimum()) * pow(start, ball(rational(-phi_->exponent()), 64));
    const bool is_far = certainly_less(ball(rational(3, 2), 64), least);  // 4/e = 1.47...
    bound = bound * *phi_ * e_below;
    if (is_far) bound = bound * *phi_ * (e_below / 4);
  }
  bound = bound.simplified();
  if (bound.is_blocked() || bound.log_degree() != 0) return blocked("exp");
  return with(std::move(bound), one_, double_interval(0.0, 1.0));
}

tail_series log(const tail_series& x) {
  if (x.is_blocked()) return x;
  const end_series sum = x.phi_ ? *x.phi_ + log(x.h_) : log(x.h_);
  tail_series plain = x.with(std::nullopt, sum, double_interval(1));
  if (x.has_no_factor()) return plain;
  // log(1 + w) = w/(1 + xi), xi between 0 and w.
  const double_interval between = hull(double_interval(1), x.u_);
  if (x.excess_ && certainly_positive(between)) return plain + x.excess_->times(1 / between);
  return plain + x.with(std::nullopt, x.one_, log(x.u_));
}

template <class F>
tail_series tail_series::regular(std::string_view name, F&& f) const {
  if (is_blocked()) return *this;
  if (!is_plain()) return blocked(name);
  return with(std::nullopt, f(h_), double_interval(1));
}
template <class F>
tail_series tail_series::bounded(F&& f, double_interval range) const {
  if (is_blocked()) return *this;
  if (is_plain()) {
    const end_series value = f(h_);
    if (!value.is_blocked()) return with(std::nullopt, value, double_interval(1));
  }
  return with(std::nullopt, one_, range);
}

#define POLHODE_REGULAR(f)                                    \
  tail_series f(const tail_series& x) {                       \
    return x.regular(#f, [](const auto& h) { return f(h); }); \
  }
POLHODE_REGULAR(acos)
#undef POLHODE_REGULAR

/// Of x that grows, but not exponentially, x less or more a number from 0 to 1. Of e^x there are
/// more steps than could be followed.
template <class F>
tail_series tail_series::stepping(std::string_view name, F&& f, const ball& beside) const {
  tail_series result = regular(name, f);
  if (!result.is_blocked() || !grows() || grows_exponentially()) return result;
  return *this + bounded_like(name, beside);
}
tail_series floor(const tail_series& x) {
  return x.stepping(
      "floor", [](const auto& h) { return floor(h); }, hull(ball(-1, 64), ball(0, 64)));
}
tail_series ceil(const tail_series& x) {
  return x.stepping(
      "ceil", [](const auto& h) { return ceil(h); }, hull(ball(0, 64), ball(1, 64)));
}

/// For x, y > 0. With q = y/x, or x/y, that decays: agm(1, q) log(2/q) lies between 5/6 and pi/2
/// for 0 < q <= 1/2, for (2/pi) log(4/q) <= 1/agm(1, q) <= (6/5) log(2/q). The first is log(4/q) <=
/// ellipticK(1 - q^2) (B. C. Carlson, J. L. Gustafson, 1985; DLMF 19.9.1), of which 1/agm(1, q) is
/// 2/pi times; the second is proved at growth_bound's agm. Else sqrt(x y) <= agm(x, y): only from
/// below, as ellipticK needs it.
tail_series agm(const tail_series& x, const tail_series& y) {
  if (x.is_blocked()) return x;
  if (y.is_blocked()) return y;
  if (x.sign() <= 0 || y.sign() <= 0) return x.blocked("agm");
  for (const auto& [greater, less] : {std::pair(&x, &y), std::pair(&y, &x)}) {
    const tail_series q = *less / *greater;
    if (!q.is_small()) continue;
    const tail_series logarithm = log(q.constant_like(2) / q);
    if (!logarithm.is_blocked() && logarithm.sign() > 0) {
      return *greater * (x.one() / logarithm).times(double_interval(0.83, 1.58));
    }
  }
  tail_series mean = sqrt(x * y);
  if (mean.is_blocked()) return mean;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return mean.with(mean.phi_, mean.h_, mean.u_ * double_interval(1.0, infinity));
}

tail_series abs(const tail_series& x) {
  if (x.is_blocked()) return x;
  const int sign = x.h_.sign();
  if (sign == 0) {
    const double most = x.u_.magnitude();
    return x.with(x.phi_, x.h_, double_interval(-most, most));
  }
  return x.with(x.phi_, sign > 0 ? x.h_ : -x.h_, abs(x.u_));
}
tail_series min(const tail_series& x, const tail_series& y) {
  if (x.is_blocked()) return x;
  if (y.is_blocked()) return y;
  if (!x.is_plain() || !y.is_plain()) return x.blocked("min");
  return x.with(std::nullopt, min(x.h_, y.h_), double_interval(1));
}
tail_series max(const tail_series& x, const tail_series& y) { return -min(-x, -y); }

bool tail_series::is_small() const {
  if (is_blocked() || !phi_) return false;
  const double_interval size = range();
  return !size.is_undefined() && size.magnitude() <= 0.5;
}

template <class F>
std::optional<tail_series> tail_series::shifted(F&& f, double_interval slope) const {
  if (is_blocked() || phi_ || !excess_) return std::nullopt;
  tail_series result = f(base()) + (base() * *excess_).times(slope);
  if (result.is_blocked()) return std::nullopt;
  return result;
}

/// x times something in `range`, where it is small; f(x) else.
template <class F>
tail_series tail_series::nearly_itself(double_interval range, F&& f) const {
  return is_small() ? with(phi_, h_, u_ * range) : f(*this);
}
// For |v| <= 1/2 and an odd f that is convex or concave for v > 0, f(v)/v lies between its values
// at 0 and 1/2: sin(1/2) = 0.4794..., tan 0.5463..., asin 0.5235..., atan 0.4636..., sinh
// 0.5210..., tanh 0.4621..., asinh 0.4812..., atanh 0.5493..., and with 2/sqrt(pi) = 1.1283...,
// erf(1/2) = 0.5204....
#define POLHODE_ODD(f, low, high)                                              \
  tail_series f(const tail_series& x) {                                        \
    return x.nearly_itself(double_interval((low), (high)), [](const auto& v) { \
      return v.regular(#f, [](const auto& h) { return f(h); });                \
    });                                                                        \
  }
POLHODE_ODD(tan, 1.0, 1.0927)
POLHODE_ODD(asin, 1.0, 1.0472)
POLHODE_ODD(atanh, 1.0, 1.0987)
#undef POLHODE_ODD

tail_series sin(const tail_series& x) {
  const auto by_slope = x.shifted([](const auto& y) { return sin(y); }, double_interval(-1.0, 1.0));
  if (by_slope) return *by_slope;
  return x.nearly_itself(double_interval(0.9588, 1.0), [](const auto& v) {
    return v.bounded([](const auto& h) { return sin(h); }, double_interval(-1.0, 1.0));
  });
}
tail_series cos(const tail_series& x) {
  const auto by_slope = x.shifted([](const auto& y) { return cos(y); }, double_interval(-1.0, 1.0));
  if (by_slope) return *by_slope;
  // (1 - cos v)/v^2 falls from 1/2 to 0.4896... over 0 < |v| <= 1/2.
  if (x.is_small()) return x.one() - (x * x).times({0.4896, 0.5});
  return x.bounded([](const auto& h) { return cos(h); }, double_interval(-1.0, 1.0));
}

/// Of x that grows exponentially +-pi/2 - atan(1/x), with the sign of x.
tail_series atan(const tail_series& x) {
  if (const auto by_slope = x.shifted([](const auto& y) { return atan(y); }, {0.0, 1.0})) {
    return *by_slope;
  }
  if (const int sign = x.grows_exponentially() ? x.sign() : 0; sign != 0) {
    const known_number right_angle(pi_combination{0, rational(sign, 2)});
    const tail_series limit =
        x.with(std::nullopt, x.one_.constant_like(right_angle), double_interval(1));
    tail_series result = limit - atan(x.one() / x);
    if (!result.is_blocked()) return result;
  }
  return x.nearly_itself(double_interval(0.9272, 1.0), [](const auto& v) {
    return v.bounded([](const auto& h) { return atan(h); }, double_interval(-1.6, 1.6));
  });
}

/// Of x that grows, with the sign s: s (1 - 2 e^(-2|x|)/(1 + e^(-2|x|))).
tail_series tanh(const tail_series& x) {
  if (const auto by_slope = x.shifted([](const auto& y) { return tanh(y); }, {0.0, 1.0})) {
    return *by_slope;
  }
  if (const int sign = x.grows() ? x.sign() : 0; sign != 0) {
    const tail_series decay = exp(x * rational(-2 * sign));
    if (!decay.is_blocked() && decay.phi_) {
      tail_series result = (x.one() - (decay + decay).times({0.5, 1.0})) * rational(sign);
      if (!result.is_blocked()) return result;
    }
  }
  return x.nearly_itself(double_interval(0.9242, 1.0), [](const auto& v) {
    return v.bounded([](const auto& h) { return tanh(h); }, double_interval(-1.0, 1.0));
  });
}

/// Of x that grows exponentially +-log(|x| + sqrt(x^2 + 1)), with the sign of x.
tail_series asinh(const tail_series& x) {
  if (const auto by_slope = x.shifted([](const auto& y) { return asinh(y); }, {0.0, 1.0})) {
    return *by_slope;
  }
  if (const int sign = x.grows_exponentially() ? x.sign() : 0; sign != 0) {
    const tail_series size = x * rational(sign);
    return log(size + sqrt(x * x + 1)) * rational(sign);
  }
  return x.nearly_itself(double_interval(0.9624, 1.0), [](const auto& v) {
    return v.regular("asinh", [](const auto& h) { return asinh(h); });
  });
}
/// Of x that grows exponentially log(x + sqrt(x^2 - 1)).
tail_series acosh(const tail_series& x) {
  if (x.grows_exponentially() && x.sign() > 0) return log(x + sqrt(x * x - 1));
  return x.regular("acosh", [](const auto& h) { return acosh(h); });
}
tail_series sinh(const tail_series& x) {
  return x.nearly_itself(double_interval(1.0, 1.0422),
                         [](const auto& v) { return (exp(v) - exp(-v)) / 2; });
}
tail_series cosh(const tail_series& x) { return (exp(x) + exp(-x)) / 2; }

tail_series expm1(const tail_series& x) {
  return x.nearly_itself(double_interval(0.78, 1.3), [](const auto& v) { return exp(v) - 1; });
}
tail_series log1p(const tail_series& x) {
  return x.nearly_itself(double_interval(0.81, 1.39), [](const auto& v) { return log(v + 1); });
}

/// s (1 - erfc|x|) with the sign s of x.
tail_series erf(const tail_series& x) {
  if (x.is_blocked()) return x;
  if (const auto by_slope = x.shifted([](const auto& y) { return erf(y); }, {0.0, 1.1284})) {
    return *by_slope;
  }
  if (x.is_small()) return x.with(x.phi_, x.h_, x.u_ * double_interval(1.0409, 1.1284));
  if (x.is_plain() && !x.grows()) {
    const end_series value = erf(x.h_);
    if (!value.is_blocked()) return x.with(std::nullopt, value, double_interval(1));
  }
  const int sign = x.sign();
  if (sign != 0) {
    const tail_series decay = erfc(x * rational(sign));
    if (decay.phi_) {
      tail_series result = (x.one() - decay) * rational(sign);
      if (!result.is_blocked()) return result;
    }
  }
  return x.with(std::nullopt, x.one_, double_interval(sign > 0 ? 0.0 : -1.0, sign < 0 ? 0.0 : 1.0));
}
tail_series erfc(const tail_series& x) {
  if (x.is_blocked()) return x;
  const int sign = x.sign();
  if (sign > 0) {
    const tail_series bell = exp(-(x * x)) / x;
    const double_interval inverse_root_of_pi(0.0, 0.5642);  // 1/sqrt(pi) = 0.56418...
    if (!bell.is_blocked()) return bell.with(bell.phi_, bell.h_, bell.u_ * inverse_root_of_pi);
  }
  if (sign < 0) {
    const tail_series decay = erfc(-x);
    if (decay.phi_) {
      tail_series result = 2 - decay;
      if (!result.is_blocked()) return result;
    }
  }
  return x.with(std::nullopt, x.one_, double_interval(sign < 0 ? 1.0 : 0.0, sign > 0 ? 1.0 : 2.0));
}

magnitude tail_series::integral(const ball& y, long power) const {
  if (is_blocked()) return magnitude::infinity();
  if (h_.is_zero()) return {};
  if (!phi_ || phi_->sign() >= 0) return magnitude::infinity();
  if (!certainly_less_equal(1 / ball::exactly(r_, 64), y)) return magnitude::infinity();
  const rational exponent = -phi_->exponent();
  const ball mu(exponent, 64);
  const ball c = exactly(phi_->infimum());
  const ball v = pow(y, mu);
  magnitude sum;
  for (int k = 0; k <= h_.log_degree(); ++k) {
    const rational q = (k + power - h_.exponent() + 1) / exponent - 1;
    const ball slope = q > 0 ? c - ball(q, 64) / v : c;
    if (!certainly_positive(slope)) return magnitude::infinity();
    const ball term = exactly(h_.supremum(k)) * pow(v, ball(q, 64)) * exp(-c * v) / (mu * slope);
    sum = add_up(sum, term.magnitude_upper());
  }
  const ball u = to_ball(double_interval(u_.magnitude()), 64);
  return multiply_up(sum, u.magnitude_upper());
}

}  // namespace polhode
