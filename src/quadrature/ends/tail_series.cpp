#include "quadrature/ends/tail_series.hpp"

#include <algorithm>
#include <cmath>

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

tail_series tail_series::argument(const known_number& s, double r, int orders) {
  const double most = std::min(r, 1.0);
  const end_series x = end_series::argument(known_number(), s, -1, most, orders);
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

tail_series operator-(const tail_series& x) { return x.with(x.phi_, -x.h_, x.u_); }

tail_series operator*(const tail_series& x, const tail_series& y) {
  if (x.is_blocked()) return x;
  if (y.is_blocked()) return y;
  std::optional<end_series> phi = x.phi_;
  if (y.phi_) phi = phi ? *phi + *y.phi_ : *y.phi_;
  const bool both = x.has_no_factor() && y.has_no_factor();
  return x.with(std::move(phi), x.h_ * y.h_, both ? double_interval(1) : x.u_ * y.u_);
}

tail_series operator/(const tail_series& x, const tail_series& y) {
  if (y.is_blocked()) return y;
  const bool exact = y.has_no_factor();
  std::optional<end_series> phi;
  if (y.phi_) phi = -*y.phi_;
  return x * y.with(std::move(phi), 1 / y.h_, exact ? double_interval(1) : 1 / y.u_);
}

/// With the greater exponential in front: e^phi h (U + (g/h) V e^delta), where delta = -c y^mu
/// times at least 1 and |g/h| <= B y^P as for integral_beyond, and y^P e^(-c y^mu) decreases for y
/// >= 1/r.
tail_series operator+(const tail_series& x, const tail_series& y) {
  tail_series sum = tail_series::sum(x, y);
  if (sum.is_blocked()) return sum;
  if (x.is_one() && y.phi_) sum.beyond_1_ = std::make_shared<const tail_series>(y);
  if (y.is_one() && x.phi_) sum.beyond_1_ = std::make_shared<const tail_series>(x);
  return sum;
}

tail_series tail_series::sum(const tail_series& x, const tail_series& y) {
  if (x.is_blocked()) return x;
  if (y.is_blocked()) return y;
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
    if (x.h_.is_zero()) return y;
    if (h.is_zero()) return x;
    const double_interval ratio = (h / x.h_).real_range();
    if (!ratio.is_undefined()) return x.with(x.phi_, x.h_, x.u_ + ratio * y.u_);
    const double_interval other = (x.h_ / h).real_range();
    return x.with(x.phi_, h, y.u_ + other * x.u_);
  }
  const int sign = delta->sign();
  if (sign == 0) return x.blocked("+ (of exponentials)");
  if (sign > 0) return sum(y, x);
  if (y.h_.is_zero()) return x;
  const end_series quotient = y.h_ / x.h_;
  if (quotient.is_blocked()) return x.blocked("+");
  const ball mu(rational(-delta->exponent()), 64);
  const ball start = 1 / ball::exactly(x.r_, 64);
  const ball v = pow(start, mu);
  const ball slope = exactly(delta->infimum()) * v;
  magnitude bound;
  for (int k = 0; k <= quotient.log_degree(); ++k) {
    const ball p(rational(k - quotient.exponent()), 64);
    if (!certainly_less(p, mu * slope)) return x.blocked("+ (of exponentials)");
    const ball size = exactly(quotient.supremum(k)) * pow(start, p) * exp(-slope);
    bound = add_up(bound, size.magnitude_upper());
  }
  const double_interval error = outward(ball(0, 64).enlarged(bound));
  return x.with(x.phi_, x.h_, x.u_ + error * y.u_);
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
  return x.with(std::move(phi), pow(x.h_, e), u);
}

tail_series pow(const tail_series& x, long n) { return pow(x, rational(n)); }

/// Where x >= 1 and y <= e: x^y = x^e U with U = x^(y - e) in (0, 1]; where 0 < x <= 1, so for y >=
/// e. Else e^(y log x).
tail_series pow(const tail_series& x, const tail_series& y) {
  if (x.is_blocked() || y.is_blocked()) return exp(y * log(x));
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
    // Of a bounded argument.
    double_interval range = x.h_.real_range() * x.u_;
    if (x.phi_) {
      const bool decays = x.phi_->sign() < 0;
      range = decays ? range * double_interval(0.0, 1.0) : double_interval::undefined();
    }
    if (range.is_undefined()) return x.exp_of_growing();
    return x.with(std::nullopt, x.one_, exp(range));
  }
  const end_series h = x.h_.simplified();
  if (h.log_degree() == 0 && h.exponent() < 0) return x.with(h, x.one_, double_interval(1));
  return x.with(std::nullopt, exp(h), double_interval(1));
}

tail_series tail_series::exp_of_growing() const {
  const int sign = h_.sign();
  if (sign == 0) return blocked("exp");
  const double greatest = sign > 0 ? u_.upper() : -u_.lower();
  end_series bound = (sign > 0 ? h_ : -h_) * rational(greatest);
  if (phi_) {
    if (phi_->sign() <= 0 || greatest >= 0) return blocked("exp");
    const rational e_below(2718281828, 1000000000);
    bound = bound * *phi_ * e_below;
  }
  bound = bound.simplified();
  if (bound.is_blocked() || bound.log_degree() != 0) return blocked("exp");
  return with(std::move(bound), one_, double_interval(0.0, 1.0));
}

tail_series log(const tail_series& x) {
  if (x.is_blocked()) return x;
  if (x.beyond_1_ && x.beyond_1_->is_small()) return log1p(*x.beyond_1_);
  const end_series sum = x.phi_ ? *x.phi_ + log(x.h_) : log(x.h_);
  if (x.has_no_factor()) return x.with(std::nullopt, sum, double_interval(1));
  return x.with(std::nullopt, sum, double_interval(1)) + x.with(std::nullopt, x.one_, log(x.u_));
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
POLHODE_REGULAR(acosh)
POLHODE_REGULAR(floor)
POLHODE_REGULAR(ceil)
#undef POLHODE_REGULAR

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

bool tail_series::is_one() const { return !is_blocked() && is_plain() && (h_ - one_).is_zero(); }

bool tail_series::is_small() const {
  if (is_blocked() || !phi_) return false;
  if (phi_->sign() >= 0) return false;
  // phi <= -c y^mu <= -c r^-mu.
  const ball most =
      exp(-exactly(phi_->infimum()) * pow(ball::exactly(r_, 64), ball(phi_->exponent(), 64)));
  const double_interval size = h_.real_range() * u_ * outward(most);
  return size.magnitude() <= 0.5;
}

/// The range of an odd, increasing f with |f| <= limit over this series: where it is plain and |h|
/// >= m > 0 of one sign, f is at least f(m) in size.
template <class F>
double_interval tail_series::beyond(F&& f, double limit) const {
  const int sign = is_plain() ? h_.sign() : 0;
  const double_interval inverse =
      sign != 0 ? (one_ / h_).real_range() : double_interval::undefined();
  if (inverse.is_undefined()) return {-limit, limit};
  const ball least = f(1 / abs(to_ball(double_interval(inverse.magnitude()), 64)));
  const double_interval size(double_interval::from_ball(least).lower(), limit);
  if (!(size.lower() > 0)) return {-limit, limit};
  return sign > 0 ? size : -size;
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
POLHODE_ODD(asinh, 0.9624, 1.0)
POLHODE_ODD(atanh, 1.0, 1.0987)
#undef POLHODE_ODD
// And where only their range is known, that.
#define POLHODE_ODD_BOUNDED(f, low, high, range)                               \
  tail_series f(const tail_series& x) {                                        \
    return x.nearly_itself(double_interval((low), (high)), [](const auto& v) { \
      return v.bounded([](const auto& h) { return f(h); }, range);             \
    });                                                                        \
  }
POLHODE_ODD_BOUNDED(sin, 0.9588, 1.0, double_interval(-1.0, 1.0))
POLHODE_ODD_BOUNDED(atan, 0.9272, 1.0, (v.beyond([](const ball& y) { return atan(y); }, 1.6)))
POLHODE_ODD_BOUNDED(tanh, 0.9242, 1.0, (v.beyond([](const ball& y) { return tanh(y); }, 1.0)))
#undef POLHODE_ODD_BOUNDED
tail_series cos(const tail_series& x) {
  return x.bounded([](const auto& h) { return cos(h); }, double_interval(-1.0, 1.0));
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

tail_series erf(const tail_series& x) {
  if (x.is_blocked()) return x;
  if (x.is_small()) return x.with(x.phi_, x.h_, x.u_ * double_interval(1.0409, 1.1284));
  const int sign = x.sign();
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
