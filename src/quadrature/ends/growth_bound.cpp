#include "quadrature/ends/growth_bound.hpp"

#include <algorithm>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/special_functions.hpp"

namespace polhode {

namespace {

constexpr precision bits = 64;
/// d in |log t| <= t^-d/(e d).
const rational& log_share() {
  static const rational d(1, 64);
  return d;
}

/// The ends of a ball's set, as balls without width; undefined where there is none.
ball upper_end(const ball& x) {
  return x.is_bounded() ? ball(upper(x.with_precision(bits))) : ball::undefined(bits);
}
ball lower_end(const ball& x) {
  return x.is_bounded() ? ball(lower(x.with_precision(bits))) : ball::undefined(bits);
}
ball not_negative(const ball& x) {
  const ball low = lower_end(x);
  return certainly_positive(low) ? low : ball(0, bits);
}

/// Exponents stay short: to a multiple of 2^-64 below (above) them.
rational rounded(const rational& q, int direction) {
  const rational unit(integer(1), integer(integer(1) << 64U));
  const rational scaled = q / unit;
  return rational(direction < 0 ? floor_of(scaled) : ceil_of(scaled)) * unit;
}

rational lesser(const rational& x, const rational& y) { return x < y ? x : y; }
rational greater(const rational& x, const rational& y) { return x > y ? x : y; }

/// The ends of y, for exponents.
struct exponent_range {
  rational lower;
  rational upper;
};
exponent_range range_of(const ball& y) { return {lower_rational(y), upper_rational(y)}; }

/// 1/(e d): the greatest value of t^d |log t|.
ball greatest_log() { return 1 / (exp(ball(1, bits)) * ball(log_share(), bits)); }

}  // namespace

struct growth_bound::factors {
  growth_bound f;
  growth_bound g;
};

growth_bound growth_bound::blocked(std::string_view where) {
  growth_bound result;
  result.where_ = where;
  return result;
}

growth_bound growth_bound::undefined(std::string_view where) {
  growth_bound result = blocked(where);
  result.nowhere_defined_ = true;
  return result;
}

/// A function f of a blocked bound x is blocked. It does not keep x's inverse_, which bounds 1/x
/// and says nothing of 1/f(x).
growth_bound growth_bound::passed_on() const {
  growth_bound result = blocked(where_);
  result.nowhere_defined_ = nowhere_defined_;
  return result;
}

growth_bound growth_bound::blocked_one(const growth_bound& x, const growth_bound& y) {
  if (x.nowhere_defined_) return x.passed_on();
  if (y.nowhere_defined_) return y.passed_on();
  return (x.blocked_ ? x : y).passed_on();
}

ball growth_bound::power_of_r(const rational& e) const {
  return pow(ball::exactly(r_), ball(e, bits));
}

/// C t^b and c t^a from the series h = t^m (G_0 + ... + L^K G_K): |h| <= t^m sum of sup |G_k| |L|^k
/// with |L|^k <= (1/(e d))^k t^(-k d). (On the square |Re t|, |Im t| <= r, which holds 0 < t <= r.)
void growth_bound::improve_by_series() {
  if (series_.is_blocked()) return;
  const end_series h = series_.simplified();
  if (h.is_blocked()) return;
  const int degree = h.log_degree();
  const rational b = h.exponent() - log_share() * degree;
  ball sum(0, bits);
  for (int k = 0; k <= degree; ++k) {
    const ball bound = ball(0, bits).enlarged(h.supremum(k));
    sum += upper_end(bound) * pow(greatest_log(), k) * power_of_r(log_share() * (degree - k));
  }
  const ball most = upper_end(sum);
  if (most.is_bounded() && (blocked_ || b > upper_exponent_)) {
    most_ = most;
    upper_exponent_ = b;
    blocked_ = false;
  }
  if (sign_ == 0) sign_ = h.sign();
  for (int k = degree; k >= 0 && !blocked_; --k) improve_by_term(h, k);
}

/// Of h = H_0 + ... + L^K H_K with H_j = t^(m_j) G_j: |h| >= |L^k H_k| (1 - the sum of |L^(j-k)
/// H_j/H_k|). There |H_k| >= t^(m_k) inf |G_k|, |L|^(j-k) <= |log r|^(j-k) for j < k and, as above,
/// <= (1/(e d))^(j-k) t^(-(j-k) d) for j > k, and t^e <= r^e for e >= 0.
void growth_bound::improve_by_term(const end_series& h, int k) {
  const end_series leading = h.coefficient(k);
  if (leading.is_blocked()) return;
  const ball least_log = -log(ball::exactly(r_));
  ball left = not_negative(upper_end(ball(0, bits).enlarged(leading.infimum())));
  for (int j = 0; j <= h.log_degree(); ++j) {
    if (j == k) continue;
    const end_series other = h.coefficient(j);
    const rational e = other.exponent() - leading.exponent() - log_share() * std::max(j - k, 0);
    if (other.is_blocked() || e < 0) return;
    const ball size = upper_end(ball(0, bits).enlarged(other.supremum(0)));
    left -= size * power_of_r(e) * pow(j < k ? least_log : greatest_log(), j - k);
  }
  left = lower_end(left);
  if (!certainly_positive(left)) return;
  const bool has_none = least_.magnitude_lower().is_zero();
  if (has_none || leading.exponent() < lower_exponent_) {
    least_ = not_negative(left * pow(least_log, k));
    lower_exponent_ = leading.exponent();
  }
  if (sign_ == 0) sign_ = k % 2 == 0 ? leading.sign() : -leading.sign();
}

/// Another bound of the same function.
void growth_bound::improve_by(const growth_bound& other) {
  if (least_.magnitude_lower().is_zero()) {
    least_ = other.least_;
    lower_exponent_ = std::max(other.lower_exponent_, upper_exponent_);
  }
  if (sign_ == 0) sign_ = other.sign_;
}

growth_bound growth_bound::made(std::string_view name, const ball& most, const rational& b,
                                const ball& least, const rational& a, int sign,
                                end_series series) const {
  growth_bound result;
  result.r_ = r_;
  result.one_ = one_;
  result.oscillates_ = oscillates_;
  result.has_growing_parts_ = has_growing_parts_;
  result.series_ = std::move(series);
  result.where_ = name;
  result.most_ = upper_end(most);
  result.upper_exponent_ = rounded(b, -1);
  result.blocked_ = !result.most_.is_bounded();
  result.least_ = least.is_bounded() ? not_negative(least) : ball(0, bits);
  result.lower_exponent_ = greater(rounded(a, 1), result.upper_exponent_);
  result.sign_ = sign;
  result.improve_by_series();
  if (result.lower_exponent_ < result.upper_exponent_)
    result.lower_exponent_ = result.upper_exponent_;
  return result;
}

growth_bound growth_bound::argument(const known_number& p, const known_number& s, long q,
                                    double r) {
  growth_bound like;
  like.r_ = r;
  like.one_ = end_series::argument(known_number(rational(1)), known_number(rational(0)), 1, r);
  const end_series series = end_series::argument(p, s, q, r);
  return like.made("x", ball::undefined(bits), 0, ball::undefined(bits), 0, 0, series);
}

growth_bound growth_bound::constant_of(const ball& x, end_series series) const {
  const ball size = abs(x);
  const int s = certainly_positive(x) ? 1 : (certainly_negative(x) ? -1 : 0);
  growth_bound result = made("a constant", size, 0, size, 0, s, std::move(series));
  result.constant_ = x;
  return result;
}
growth_bound growth_bound::constant_like(const rational& q) const {
  if (is_unknown()) return passed_on();
  return constant_of(ball(q, 192), one_.constant_like(q));
}
growth_bound growth_bound::constant_like(const known_number& x) const {
  if (is_unknown()) return passed_on();
  return constant_of(x.enclosure(), one_.constant_like(x));
}

growth_bound growth_bound::reciprocal_of(const growth_bound& y) {
  growth_bound result = y.constant_like(rational(1)) / y;
  if (!result.blocked_) result.inverse_ = std::make_shared<const growth_bound>(y);
  return result;
}

growth_bound::factors growth_bound::factored() const {
  factors v = factors_ ? *factors_ : factors{*this, constant_like(rational(0))};
  v.f.oscillates_ = v.f.oscillates_ || oscillates_;
  return v;
}

growth_bound growth_bound::with(const factors& v) && {
  if (!v.f.blocked_ && !v.g.blocked_) factors_ = std::make_shared<const factors>(v);
  return std::move(*this);
}

/// With e^-g <= C t^b and |f| >= c t^a: |f e^g| >= (c/C) t^(a-b).
growth_bound growth_bound::of_factors(std::string_view name, const factors& v) {
  const auto& [f, g] = v;
  if (f.blocked_ || g.blocked_) return blocked_one(f, g);
  const growth_bound e = g.exponential();
  if (!e.blocked_) return (f * e).with(v);
  growth_bound result = blocked(name);
  result.r_ = f.r_;
  result.one_ = f.one_;
  result.sign_ = f.sign_;
  const growth_bound inverse = (-g).exponential();
  if (!inverse.blocked_) {
    result.least_ = not_negative(f.least_ / inverse.most_);
    result.lower_exponent_ = rounded(f.lower_exponent_ - inverse.upper_exponent_, 1);
  }
  return std::move(result).with(v);
}

growth_bound growth_bound::with_growing_parts() && {
  has_growing_parts_ = true;
  return std::move(*this);
}

growth_bound growth_bound::of_growing(std::string_view name, const factors& v) {
  return of_factors(name, v).with_growing_parts();
}

growth_bound operator-(const growth_bound& x) {
  growth_bound result = x.is_unknown() ? x.passed_on() : x;
  if (x.inverse_) result.inverse_ = std::make_shared<const growth_bound>(-*x.inverse_);
  if (x.factors_) result = std::move(result).with({-x.factors_->f, x.factors_->g});
  result.sign_ = -x.sign_;
  result.series_ = -x.series_;
  if (x.constant_) result.constant_ = -*x.constant_;
  return result;
}

/// (f1 + f2 e^h) e^g1 with h = g2 - g1 of either one, where e^h has a bound. For f2 = -f1 it is
/// -f1 (e^h - 1), and e^h - 1 is h times the mean of e^(s h) over 0 <= s <= 1, which lies between
/// e^-m and e^m for |h| <= m.
std::optional<growth_bound::factors> growth_bound::factors_of_sum(const growth_bound& x,
                                                                  const growth_bound& y) {
  for (const auto& [great, small] : {std::pair(&x, &y), std::pair(&y, &x)}) {
    if (!great->factors_) continue;
    const auto& [f, g] = *great->factors_;
    const auto [other_f, other_g] = small->factored();
    const growth_bound h = other_g - g;
    const ball m = h.greatest_size();
    if (m.is_bounded() && (f + other_f).is_zero()) {
      return factors{-(f * h * f.bounded_like("exp", hull(exp(-m), exp(m)))), g};
    }
    growth_bound quotient = of_factors("a sum", {other_f, h});
    quotient.factors_ = nullptr;  // those of f + quotient are not needed
    if (!quotient.blocked_) return factors{f + quotient, g};
  }
  return std::nullopt;
}

/// |x + y| <= (C_x r^(b_x - b) + C_y r^(b_y - b)) t^b with the lesser b. With one sign for both,
/// the sum is at least as great as either; else as what is left of the one that is greater by its
/// bounds: c t^a - C t^b >= (c - C r^(b-a)) t^a for b >= a.
growth_bound operator+(const growth_bound& x, const growth_bound& y) {
  if (x.is_unknown() || y.is_unknown()) return growth_bound::blocked_one(x, y);
  if (y.is_zero()) return x;
  if (x.is_zero()) return y;
  if (x.blocked_ || y.blocked_) {
    const auto v = growth_bound::factors_of_sum(x, y);
    return v ? growth_bound::of_growing("a sum", *v) : growth_bound::blocked_one(x, y);
  }
  const rational b = lesser(x.upper_exponent_, y.upper_exponent_);
  const ball most =
      x.most_ * x.power_of_r(x.upper_exponent_ - b) + y.most_ * x.power_of_r(y.upper_exponent_ - b);
  ball least(0, bits);
  rational a = b;
  int sign = 0;
  const auto has_least = [](const growth_bound& v) { return certainly_positive(v.least_); };
  if (x.sign_ != 0 && x.sign_ == y.sign_) {
    sign = x.sign_;
    const bool first = has_least(x) && (!has_least(y) || x.lower_exponent_ <= y.lower_exponent_);
    const growth_bound& greater_one = first ? x : y;
    least = greater_one.least_;
    a = greater_one.lower_exponent_;
  } else {
    for (const auto& [great, small] : {std::pair(&x, &y), std::pair(&y, &x)}) {
      if (!has_least(*great) || small->upper_exponent_ < great->lower_exponent_) continue;
      const ball left = great->least_ - small->most_ * x.power_of_r(small->upper_exponent_ -
                                                                    great->lower_exponent_);
      if (!certainly_positive(left)) continue;
      least = left;
      a = great->lower_exponent_;
      sign = great->sign_;
      break;
    }
  }
  growth_bound result = x.made("a sum", most, b, least, a, sign, x.series_ + y.series_);
  result.oscillates_ = x.oscillates_ || y.oscillates_;
  result.has_growing_parts_ = x.has_growing_parts_ || y.has_growing_parts_;
  if (x.constant_ && y.constant_) result.constant_ = *x.constant_ + *y.constant_;
  const auto v = growth_bound::factors_of_sum(x, y);
  if (!v) return result;
  result.improve_by(growth_bound::of_factors("a sum", *v));
  return std::move(result).with(*v);
}

growth_bound operator*(const growth_bound& x, const growth_bound& y) {
  if (x.is_unknown() || y.is_unknown()) return growth_bound::blocked_one(x, y);
  const auto factors_of_product = [&]() -> growth_bound::factors {
    const auto v = x.factored();
    const auto w = y.factored();
    return {v.f * w.f, v.g + w.g};
  };
  if (x.blocked_ || y.blocked_) {
    return growth_bound::of_growing((x.blocked_ ? x : y).where_, factors_of_product());
  }
  growth_bound result = x.made(
      "a product", x.most_ * y.most_, x.upper_exponent_ + y.upper_exponent_, x.least_ * y.least_,
      x.lower_exponent_ + y.lower_exponent_, x.sign_ * y.sign_, x.series_ * y.series_);
  result.oscillates_ = x.oscillates_ || y.oscillates_;
  result.has_growing_parts_ = x.has_growing_parts_ || y.has_growing_parts_;
  if (x.constant_ && y.constant_) result.constant_ = *x.constant_ * *y.constant_;
  if (x.factors_ || y.factors_) result = std::move(result).with(factors_of_product());
  return result;
}

growth_bound operator/(const growth_bound& x, const growth_bound& y) {
  if (!x.is_unknown() && y.inverse_) return x * *y.inverse_;
  if (x.is_unknown() || y.is_unknown()) return growth_bound::blocked_one(x, y);
  const auto factors_of_quotient = [&]() -> growth_bound::factors {
    const auto v = x.factored();
    const auto w = y.factored();
    return {v.f / w.f, v.g - w.g};
  };
  if (x.blocked_ || y.blocked_) {
    return growth_bound::of_growing((x.blocked_ ? x : y).where_, factors_of_quotient());
  }
  growth_bound result = x.made(
      "a quotient", x.most_ / y.least_, x.upper_exponent_ - y.lower_exponent_, x.least_ / y.most_,
      x.lower_exponent_ - y.upper_exponent_, x.sign_ * y.sign_, x.series_ / y.series_);
  if (x.factors_ || y.factors_) {  // of a y that decays exponentially as well
    const auto v = factors_of_quotient();
    if (result.blocked_) return growth_bound::of_factors("a quotient", v);
    result = std::move(result).with(v);
  }
  result.oscillates_ = x.oscillates_ || y.oscillates_;
  result.has_growing_parts_ = x.has_growing_parts_ || y.has_growing_parts_;
  if (x.constant_ && y.constant_) result.constant_ = *x.constant_ / *y.constant_;
  return result;
}

/// (C t^b)^y for y >= 0, and (c t^a)^y for y < 0; the lower bounds the other way round. Of all y in
/// a ball that is not on both sides of 0.
growth_bound growth_bound::to_the(const ball& y, std::string_view name, end_series series) const {
  if (!y.is_bounded()) return blocked(name);
  const exponent_range range = range_of(y);
  const bool rises = range.lower >= 0;
  if (!rises && range.upper > 0) return blocked(name);
  const ball& above = rises ? most_ : least_;
  const rational& above_exponent = rises ? upper_exponent_ : lower_exponent_;
  const ball& below = rises ? least_ : most_;
  const rational& below_exponent = rises ? lower_exponent_ : upper_exponent_;
  const auto products = [&](const rational& e) {
    const rational first = e * range.lower;
    const rational second = e * range.upper;
    return std::pair(lesser(first, second), greater(first, second));
  };
  const auto power = [&](const ball& base) {
    // 0^y for y > 0 is 0, and for y < 0 no number.
    if (certainly_positive(base)) return pow(base, y);
    return range.lower > 0 ? ball(0, bits) : ball::undefined(bits);
  };
  return made(name, power(above), products(above_exponent).first, power(below),
              products(below_exponent).second, 1, std::move(series));
}

growth_bound pow(const growth_bound& x, long n) {
  if (x.is_unknown()) return x.passed_on();
  const auto factors_of_power = [&]() -> growth_bound::factors {
    const auto [f, g] = x.factored();
    return {pow(f, n), g * g.constant_like(rational(n))};
  };
  if (x.blocked_) return growth_bound::of_growing(x.where_, factors_of_power());
  growth_bound result = x.to_the(ball(n, 64), "a power", pow(x.series_, n));
  if (n % 2 != 0) result.sign_ = x.sign_;
  if (n % 2 == 0 && x.sign_ == 0 && !certainly_positive(x.least_)) result.sign_ = 0;
  if (n == 0) result.sign_ = 1;
  if (x.constant_) result.constant_ = pow(*x.constant_, n);
  return x.factors_ ? std::move(result).with(factors_of_power()) : result;
}

growth_bound pow(const growth_bound& x, const growth_bound& y) {
  if (x.is_unknown() || y.is_unknown()) return growth_bound::blocked_one(x, y);
  if (x.blocked_ && y.constant_) {
    const auto [f, g] = x.factored();
    return growth_bound::of_growing(x.where_, {pow(f, y), g * y});
  }
  // For x < 0 it is defined where y happens to be whole: nowhere, for 0 < |y| < 1.
  if (!y.constant_ && x.sign_ < 0) {
    const bool is_fraction =
        y.sign_ != 0 && y.upper_exponent_ >= 0 &&
        certainly_less(upper_end(y.most_ * y.power_of_r(y.upper_exponent_)), ball(1, bits));
    return is_fraction ? growth_bound::undefined("a power")
                       : growth_bound::blocked("a power of what is negative");
  }
  if (!y.constant_) return exp(y * log(x));
  // x^y is defined for x < 0 where y is whole.
  if (x.sign_ < 0 && holds_no_integer(*y.constant_)) return growth_bound::undefined("a power");
  if (x.sign_ <= 0) return growth_bound::blocked("a power of what may be negative");
  end_series none = end_series::blocked("pow");
  growth_bound result = x.to_the(*y.constant_, "a power", none);
  if (x.constant_) result.constant_ = pow(*x.constant_, *y.constant_);
  return result;
}

growth_bound sqrt(const growth_bound& x) {
  if (x.is_unknown()) return x.passed_on();
  if (x.blocked_) return root(x, 2);
  if (x.sign_ < 0) return growth_bound::undefined("sqrt");
  if (x.sign_ <= 0 && x.series_.is_blocked()) return growth_bound::blocked("sqrt");
  const end_series series = sqrt(x.series_);
  if (x.sign_ <= 0) {
    if (series.is_blocked()) return growth_bound::blocked("sqrt");
    return x.made("sqrt", ball::undefined(bits), 0, ball::undefined(bits), 0, 0, series);
  }
  growth_bound result = x.to_the(ball(rational(1, 2), 64), "sqrt", series);
  if (!x.factors_) return result;
  const auto& [f, g] = *x.factors_;
  return std::move(result).with({sqrt(f), g * g.constant_like(rational(1, 2))});
}

growth_bound root(const growth_bound& x, long n) {
  if (x.is_unknown()) return x.passed_on();
  if (x.blocked_) {
    const auto [f, g] = x.factored();
    return growth_bound::of_growing(x.where_, {root(f, n), g * g.constant_like(rational(1, n))});
  }
  if (x.sign_ < 0 && n % 2 != 0) return -root(-x, n);
  if (x.sign_ < 0) return growth_bound::undefined("root");
  if (x.sign_ <= 0) return growth_bound::blocked("root");
  return x.to_the(ball(rational(1, n), 128), "root", pow(x.series_, rational(1, n)));
}

/// Where |x| <= C t^b with b >= 0: |x| <= C r^b, so that e^x lies between e^(-C r^b) and its
/// inverse. Where x < 0: e^x <= 1. For x <= -u with u = c t^a, a < 0: let u_r = c r^a, the least u,
/// and 0 <= k <= u_r. As e^-u u^k falls for u >= k, e^x <= e^-u <= e^-u_r u_r^k u^-k = e^-u_r r^(a
/// k) t^(-a k), at most 1.
growth_bound exp(const growth_bound& x) {
  if (x.is_unknown()) return x.passed_on();
  if (!x.blocked_) return growth_bound::of_factors("exp", {x.constant_like(rational(1)), x});
  growth_bound result = x.exponential();
  if (result.blocked_ && x.sign_ > 0) {  // e^-x decays
    const growth_bound inverse = (-x).exponential();
    if (!inverse.blocked_) result.inverse_ = std::make_shared<const growth_bound>(inverse);
  }
  return std::move(result).with_growing_parts();
}

/// e^h of a series h = L H_1 + H_0 with m = 0: with c = H_1(0), and H_j = t^(m_j) G_j, it is
/// t^c e^u with u = H_0 + L (H_1 - c), of which |L| t^e <= r^(e-d)/(e d) for e >= d.
std::optional<growth_bound> growth_bound::power_by_series() const {
  const end_series h = series_.simplified();
  if (h.is_blocked() || h.log_degree() != 1 || h.exponent() != 0) return std::nullopt;
  const end_series first = h.coefficient(1);
  const auto value = first.value_at_0();
  if (!value && first.exponent() <= 0) return std::nullopt;
  const known_number c = value.value_or(known_number());
  const end_series plain = h.coefficient(0);
  const end_series rest = value ? (first - c).simplified() : first;
  const rational e = rest.exponent() - log_share();
  if (plain.is_blocked() || rest.is_blocked() || e < 0) return std::nullopt;
  const auto size = [](const end_series& g) {
    return upper_end(ball(0, bits).enlarged(g.supremum(0)));
  };
  const ball u = upper_end(size(plain) * power_of_r(plain.exponent()) +
                           size(rest) * power_of_r(e) * greatest_log());
  if (!u.is_bounded()) return std::nullopt;
  const exponent_range power = range_of(c.enclosure());
  return made("exp", exp(u), power.lower, exp(-u), power.upper, 1, end_series::blocked("exp"));
}

growth_bound growth_bound::exponential() const {
  const growth_bound& x = *this;
  const end_series series = exp(x.series_);
  if (!x.blocked_ && x.upper_exponent_ >= 0) {
    const ball size = upper_end(x.most_ * x.power_of_r(x.upper_exponent_));
    return x.made("exp", exp(size), 0, exp(-size), 0, 1, series);
  }
  if (const auto power = x.power_by_series()) return *power;
  if (x.sign_ < 0) {
    ball most(1, bits);
    rational exponent = 0;
    if (certainly_positive(x.least_) && x.lower_exponent_ < 0) {
      const ball u = not_negative(x.least_) / x.power_of_r(-x.lower_exponent_);
      constexpr long most_k = 64;  // higher powers are not needed
      const ball k = lower_end(floor(min(lower_end(u), ball(most_k, bits))));
      if (k.is_bounded()) {
        exponent = -x.lower_exponent_ * lower_rational(k);
        most = exp(-u) / x.power_of_r(exponent);
      }
    }
    return x.made("exp", most, exponent, ball(0, bits), 0, 1, series);
  }
  growth_bound result = growth_bound::blocked("exp");
  if (!series.is_blocked()) {
    result = x.made("exp", ball::undefined(bits), 0, ball::undefined(bits), 0, 1, series);
  }
  return result;
}

growth_bound growth_bound::logarithm_of_size() const {
  return sign_ == 0 ? blocked("log") : log(sign_ < 0 ? -*this : *this);
}

/// log x lies between log c + a log t and log C + b log t. Where b > 0 and C r^b < 1 it is
/// negative, and |log x| >= |log(C r^b)|; where a < 0 and c r^a > 1 it is positive, and log x >=
/// log(c r^a). And |log x| <= |log c| + |a| |log t|, or the same of C and b.
growth_bound log(const growth_bound& x) {
  if (x.is_unknown()) return x.passed_on();
  if (x.sign_ < 0) return growth_bound::undefined("log");
  if (x.factors_) {
    growth_bound logarithm = log(x.factors_->f) + x.factors_->g;
    if (x.blocked_) return std::move(logarithm).with_growing_parts();
    if (!logarithm.blocked_) return logarithm;
  }
  if (x.sign_ == 0 || !certainly_positive(x.least_)) return growth_bound::blocked("log");
  const ball log_most = log(x.most_);
  const ball log_least = log(x.least_);
  const ball a(x.lower_exponent_, bits);
  const ball b(x.upper_exponent_, bits);
  const ball log_r = log(ball::exactly(x.r_));
  // On the whole of 0 < t <= r: the greatest of log C + b log t is at r for b >= 0, the least of
  // log c + a log t for a <= 0.
  const ball at_r_above = log_most + b * log_r;
  const ball at_r_below = log_least + a * log_r;
  int sign = 0;
  ball least(0, bits);
  if (x.upper_exponent_ >= 0 && certainly_negative(at_r_above)) {
    sign = -1;
    least = -at_r_above;
  } else if (x.lower_exponent_ <= 0 && certainly_positive(at_r_below)) {
    sign = 1;
    least = at_r_below;
  }
  const rational zero(0);
  const bool is_bounded = x.lower_exponent_ == 0 && x.upper_exponent_ == 0;
  const rational d = is_bounded ? zero : log_share();
  const ball share = is_bounded ? ball(0, bits) : greatest_log();
  const auto size = [&](const ball& constant, const ball& slope) {
    return abs(constant) * x.power_of_r(d) + abs(slope) * share;
  };
  const ball most = upper_end(size(log_most, b)) + upper_end(size(log_least, a));
  const end_series series = log(x.series_);
  return x.made("log", most, -d, least, 0, sign, series);
}

ball growth_bound::greatest_size() const {
  if (blocked_ || upper_exponent_ < 0) return ball::undefined(bits);
  return upper_end(most_ * power_of_r(upper_exponent_));
}

/// f is odd, |f| is at most the bound, and f' is at most 1 and falls for 0 < v <= m. Then |f(v)| <=
/// |v|. And f(v)/v falls, as v f'(v) - f(v) is 0 at 0 and falls (its derivative is v f''(v)): so
/// |f(v)| >= |v| f(m)/m, with the sign of v. The value at m is f(m); undefined where f' does not
/// fall up to m.
growth_bound growth_bound::flattening(std::string_view name, const ball& bound, const ball& m,
                                      const ball& value_at_m, end_series series) const {
  const bool by_itself = upper_exponent_ > 0;
  const ball share = lower_end(value_at_m / m);
  const bool is_near_0 = certainly_positive(share);
  growth_bound result =
      made(name, by_itself ? most_ : bound, by_itself ? upper_exponent_ : rational(0),
           is_near_0 ? lower_end(least_) * share : ball(0, bits),
           is_near_0 ? lower_exponent_ : rational(0), is_near_0 ? sign_ : 0, std::move(series));
  if (!factors_ || !is_near_0 || result.blocked_) return result;
  const growth_bound quotient = bounded_like(name, hull(share, ball(1, bits)));  // f(v)/v
  return std::move(result).with({factors_->f * quotient, factors_->g});
}

/// sin' falls up to pi.
growth_bound growth_bound::oscillating_as(const growth_bound& x) const {
  growth_bound result = *this;
  result.oscillates_ = oscillates_ || x.oscillates_ || 4 * x.upper_exponent_ < -1;
  return result;
}
growth_bound sin(const growth_bound& x) {
  if (x.blocked_) return x.passed_on();
  const ball m = x.greatest_size();
  const ball value = certainly_less(m, pi(bits)) ? sin(m) : ball::undefined(bits);
  return x.flattening("sin", ball(1, bits), m, value, sin(x.series_)).oscillating_as(x);
}
growth_bound atan(const growth_bound& x) {
  if (x.blocked_) return x.passed_on();
  const ball m = x.greatest_size();
  return x.flattening("atan", pi(bits) / 2, m, atan(m), atan(x.series_));
}
growth_bound tanh(const growth_bound& x) {
  if (x.blocked_) return x.passed_on();
  const ball m = x.greatest_size();
  return x.flattening("tanh", ball(1, bits), m, tanh(m), tanh(x.series_));
}

/// By its range where x is bounded.
growth_bound cos(const growth_bound& x) {
  if (x.blocked_) return x.passed_on();
  const ball m = x.greatest_size();
  const ball value = m.is_bounded() ? cos(hull(-m, m)) : ball::undefined(bits);
  const bool is_positive = certainly_positive(value);
  growth_bound result =
      x.made("cos", ball(1, bits), 0, is_positive ? lower_end(value) : ball(0, bits), 0,
             is_positive ? 1 : 0, cos(x.series_));
  result.oscillates_ = result.oscillates_ || 4 * x.upper_exponent_ < -1;
  return result;
}

/// |v| <= m < pi/2: tan' grows from 1 on, and tan(v)/v with it: |v| <= |tan v| <= |v| tan(m)/m,
/// with the sign of v. Elsewhere by the series.
growth_bound tan(const growth_bound& x) {
  if (x.blocked_) return x.passed_on();
  const ball m = x.greatest_size();
  const bool is_near_0 = certainly_positive(m) && certainly_less(m, pi(bits) / 2);
  const ball most = is_near_0 ? upper_end(x.most_ * tan(m) / m) : ball::undefined(bits);
  return x.made("tan", most, is_near_0 ? x.upper_exponent_ : rational(0),
                is_near_0 ? lower_end(x.least_) : ball(0, bits),
                is_near_0 ? x.lower_exponent_ : rational(0), is_near_0 ? x.sign_ : 0,
                tan(x.series_));
}

growth_bound erf(const growth_bound& x) {
  if (x.blocked_) return x.passed_on();
  return x.made("erf", ball(1, bits), 0, ball(0, bits), 0, x.sign_, end_series::blocked("erf"));
}

ball growth_bound::greatest_value() const {
  if (blocked_ || sign_ <= 0 || upper_exponent_ < 0) return ball::undefined(bits);
  return upper_end(most_ * power_of_r(upper_exponent_));
}
ball growth_bound::least_value() const {
  if (blocked_ || sign_ <= 0 || lower_exponent_ > 0) return ball::undefined(bits);
  return lower_end(least_ / power_of_r(-lower_exponent_));
}

ball growth_bound::values() const {
  if (blocked_ || upper_exponent_ < 0) return ball::undefined(bits);
  if (sign_ < 0) return -(-*this).values();
  const ball most = upper_end(most_ * power_of_r(upper_exponent_));
  if (sign_ == 0) return hull(-most, most);
  const ball least = least_value();
  return hull(least.is_bounded() ? least : ball(0, bits), most);
}

/// Its series is that of an unknown constant: what is proved of each constant with this value is
/// true of the function at each t.
growth_bound growth_bound::bounded_like(std::string_view name, const ball& value) const {
  if (!value.is_bounded()) return blocked(name);
  const int sign = certainly_positive(value) ? 1 : certainly_negative(value) ? -1 : 0;
  return made(name, abs(value), 0, abs(value), 0, sign, one_.constant_like(known_number(value)));
}

/// For 0 < v <= 1: Gamma(v) = Gamma(1+v)/v with 1/2 < Gamma(1+v) <= 1, since log Gamma is convex, 0
/// at 1 and at 2, and above its tangent at 1, of the slope -0.577... > -log 2. Where v grows:
/// e^(log Gamma(v)).
growth_bound gamma(const growth_bound& x) {
  if (x.blocked_) return x.passed_on();
  const end_series none = end_series::blocked("gamma");
  const ball one(1, bits);
  if (certainly_less_equal(x.greatest_value(), one))
    return x.made("gamma", one, 0, ball(rational(1, 2), bits), 0, 1, none) / x;
  const ball value = gamma(x.values());
  if (certainly_positive(value)) return x.bounded_like("gamma", value);
  const growth_bound logarithm = log_gamma(x);
  if (logarithm.blocked_) return growth_bound::blocked("gamma");
  return growth_bound::of_factors("gamma", {x.constant_like(rational(1)), logarithm});
}

/// For 0 < v <= 1: -log v - 1 < log Gamma(v) <= -log v, as above. For v >= u > 0, log Gamma(v) =
/// (v - 1/2) log v - v + log(2 pi)/2 + m with 0 < m < 1/(12 v) (DLMF 5.11.1 and 5.11(ii): the error
/// is below the first term left out and has its sign).
growth_bound log_gamma(const growth_bound& x) {
  if (x.blocked_) return x.passed_on();
  const end_series none = end_series::blocked("log_gamma");
  const ball one(1, bits);
  if (certainly_less_equal(x.greatest_value(), one))
    return x.made("log_gamma", one, 0, ball(0, bits), 0, 0, none) - log(x);
  const ball value = log_gamma(x.values());
  if (value.is_bounded()) return x.bounded_like("log_gamma", value);
  const ball u = x.least_value();
  if (!certainly_positive(u)) return growth_bound::blocked("log_gamma");
  const ball rest = log(2 * pi(bits)) / 2 + hull(ball(0, bits), 1 / (12 * u));
  return (x - x.constant_like(rational(1, 2))) * log(x) - x + x.bounded_like("log_gamma", rest);
}

/// sqrt(x y) <= agm(x, y) <= (x + y)/2 for x, y >= 0. And for a constant x and y <= x/2, of which
/// the logarithm is known, (2/pi) log(2 x/y)/x <= 1/agm(x, y) <= (6/5) log(2 x/y)/x: the first by
/// log(4/q) <= ellipticK(1 - q^2) (B. C. Carlson, J. L. Gustafson, 1985; DLMF 19.9.1), of which
/// 1/agm(1, q) is 2/pi times. Proof of the second. With q = y/x and C. F. Gauss's
///   1/agm(1, q) = (2/pi) the integral over (0, pi/2) of dw/sqrt(sin^2 w + q^2 cos^2 w),
/// sin w >= 2 w/pi gives q^2 + (1 - q^2) 4 w^2/pi^2 as a lower bound of the radicand, so that it is
/// at most arsinh(sqrt(1 - q^2)/q)/sqrt(1 - q^2) = log((1 + sqrt(1 - q^2))/q)/sqrt(1 - q^2), and
/// 1/sqrt(1 - q^2) <= 2/sqrt(3) < 6/5.
growth_bound agm(const growth_bound& x, const growth_bound& y) {
  if (x.blocked_ || y.blocked_) return growth_bound::blocked_one(x, y);
  if (x.sign_ <= 0 || y.sign_ <= 0) return growth_bound::blocked("agm");
  if (y.constant_ && !x.constant_) return agm(y, x);
  const end_series none = end_series::blocked("agm");
  const growth_bound sum = x + y;
  const growth_bound product = x * y;
  growth_bound result = x.made("agm", sum.most_ / 2, sum.upper_exponent_, sqrt(product.least_),
                               product.lower_exponent_ / 2, 1, none);
  if (!x.constant_ || !y.factors_ ||
      !certainly_less_equal(y.greatest_value(), lower_end(*x.constant_ / 2))) {
    return result;
  }
  const growth_bound logarithm = y.constant_like(log(2 * *x.constant_)) - y.logarithm_of_size();
  if (logarithm.blocked_) return result;
  // It is log 4 at least, and so the size of which the lower bound is.
  const ball least = 2 * logarithm.least_ / (pi(bits) * *x.constant_);
  const ball most = 6 * logarithm.most_ / (5 * *x.constant_);
  result.inverse_ = std::make_shared<const growth_bound>(
      x.made("agm", most, logarithm.upper_exponent_, least, logarithm.lower_exponent_, 1, none));
  return result;
}

growth_bound abs(const growth_bound& x) {
  if (x.is_unknown()) return x.passed_on();
  if (x.sign_ != 0) return x.sign_ < 0 ? -x : x;
  const auto [f, g] = x.factored();
  if (x.blocked_) return growth_bound::of_growing(x.where_, {abs(f), g});
  growth_bound result = x;
  result.factors_ = nullptr;
  if (x.factors_) result = std::move(result).with({abs(f), g});
  result.inverse_ = nullptr;
  result.series_ = end_series::blocked("abs");
  result.sign_ = certainly_positive(x.least_) ? 1 : 0;
  if (x.constant_) result.constant_ = abs(*x.constant_);
  return result;
}

}  // namespace polhode
