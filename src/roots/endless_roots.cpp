// Infinitely many roots towards infinity.
//
// Let f(x) = F(x, w(x)) for x >= X, where F(x, w) has the period T in w (expression::unwound), w is
// continuous and tends to infinity or to -infinity. Let f be 0 where N(x, w(x)) is 0 and none of
// the divisors d_i(x, w(x)) is (expression::as_fraction), with f_N(x) = N(x, w(x)) continuous.
//
// Theorem. f has a zero beyond every Y >= X where, for numbers s < t <= s + T,
// (1) N(x, s) has one sign for all x >= X, and N(x, t) the opposite one, and each d_i has a sign
//     for all x >= X, or depends on w alone and has no zero for s < w < t; or
// (2) N(x, s) is 0 for all x >= X, and each d_i has a sign for all x >= X, or depends on w alone
//     and is not 0 for w = s.
// Proof. Let w tend to infinity (else look at F(x, -w), s and t in the other order). By the
// intermediate value theorem w takes the value s + nT beyond Y for all large n, so (2) gives a zero
// there. For (1) let a >= Y with w(a) = s + nT, b the first number beyond a with w(b) = t + nT, and
// c the last one in [a, b] with w(c) = s + nT. Then s + nT < w < t + nT between c and b. As N has
// the period T, f_N(c) and f_N(b) have the signs of N(c, s) and N(b, t), and f_N has a zero between
// c and b, where no d_i is 0.
//
// Towards a point p, f(p + 1/u) is such a function of u, and f(p + e^-s) of s.

#include "endless_roots.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "polhode/arithmetic/interval.hpp"
#include "polhode/expression/symbol.hpp"
#include "polhode/quadrature/zero_free_ends.hpp"

namespace polhode::detail {

namespace {

constexpr precision bits = 128;

symbol symbol_of(const pi_combination& x) {
  return symbol(x.q) + symbol(x.r) * symbol::constant("pi");
}

/// A formula of x and of an angle w, for x >= from.
class function_of_angle {
 public:
  function_of_angle(expression f, expression angle, const rational& from)
      : f_(std::move(f)), angle_(std::move(angle)), from_(from) {}

  /// The function f(x, w(x)) of x.
  [[nodiscard]] expression whole() const {
    const symbol x = symbol::variable(0);
    return at(angle_(x));
  }
  /// The function f(x, w) of x.
  [[nodiscard]] expression at(const pi_combination& w) const { return at(symbol_of(w)); }
  [[nodiscard]] bool depends_on_angle_alone() const {
    const std::vector<std::string> used = f_.used_variables();
    return used.empty() || (used.size() == 1 && used.front() == f_.variables().back());
  }
  /// f for all angles in the ball, of an f that depends on the angle alone.
  [[nodiscard]] jet<ball, 1> over(const ball& w) const {
    const std::array<jet<ball, 1>, 2> both{jet<ball, 1>::constant(w), jet<ball, 1>::variable(w)};
    return f_.evaluator<jet<ball, 1>>(bits)(both);
  }
  /// The sign of f(x, w(x)) for all x.
  [[nodiscard]] int sign() const { return zero_free_ends(whole()).sign_beyond(from_); }

 private:
  [[nodiscard]] expression at(const symbol& w) const {
    const std::array<symbol, 2> both{symbol::variable(0), w};
    return expression(f_.evaluate(std::span<const symbol>(both)),
                      {{f_.variables().front()}, {}, f_.names().further});
  }

  expression f_;
  expression angle_;
  rational from_;
};

/// f as N and the d_i, with the angle w; and what is known for x >= from.
class turning_function {
 public:
  turning_function(const expression::unwound& f, const expression::fraction& parts,
                   const rational& from)
      : angle_(f.angle), period_(f.period), from_(from), numerator_(parts.numerator, angle_, from) {
    for (const expression& d : parts.divisors) divisors_.emplace_back(d, angle_, from);
  }

  [[nodiscard]] bool has_endless_zeros() {
    const auto sign_of = [this](const expression& u) {
      return zero_free_ends(u).sign_beyond(from_);
    };
    if (!angle_.is_continuous(sign_of) ||
        zero_free_ends(angle_).infinite_limit_beyond(from_) == 0 ||
        !numerator_.whole().is_continuous(sign_of)) {
      return false;
    }
    std::erase_if(divisors_, [&](const function_of_angle& d) {
      return d.sign() != 0 && d.whole().is_continuous(sign_of);
    });
    constexpr long parts = 24;  // of a period, in which many sines are known exactly
    return changes_sign(4) || changes_sign(parts);
  }

 private:
  [[nodiscard]] bool changes_sign(long parts) const {
    int last = 0;
    pi_combination s;
    for (long k = 0; k <= parts; ++k) {
      const pi_combination t = period_ * rational(k, parts);
      const expression here = numerator_.at(t).with_rational_constants();
      if (here.is_formally_zero() && is_defined_at(t)) return true;
      const int sign = zero_free_ends(here).sign_beyond(from_);
      if (sign == 0) continue;
      if (sign * last < 0 && is_defined_between(s, t)) return true;
      last = sign;
      s = t;
    }
    return false;
  }

  [[nodiscard]] bool is_defined_at(const pi_combination& w) const {
    return std::ranges::all_of(divisors_, [&](const function_of_angle& d) {
      if (!d.depends_on_angle_alone()) return false;
      const ball value = d.over(w.at(bits))[0];
      return !value.is_undefined() && !contains_zero(value);
    });
  }
  /// Each divisor is shown to have no zero between s and t.
  [[nodiscard]] bool is_defined_between(const pi_combination& s, const pi_combination& t) const {
    const ball between = hull(s.at(bits), t.at(bits));
    return std::ranges::all_of(divisors_, [&](const function_of_angle& d) {
      if (!d.depends_on_angle_alone()) return false;
      const jet<ball, 1> v = d.over(between);
      if (!v[0].is_undefined() && !contains_zero(v[0])) return true;
      // It has one zero at most, by Rolle's theorem, and that is s or t.
      if (v[1].is_undefined() || contains_zero(v[1])) return false;
      return d.at(s).rational_value() == rational(0) || d.at(t).rational_value() == rational(0);
    });
  }

  expression angle_;
  pi_combination period_;
  rational from_;
  function_of_angle numerator_;
  std::vector<function_of_angle> divisors_;
};

bool has_endless_roots_rightward(const expression& f) {
  for (const expression::unwound& angle : f.unwound_angles()) {
    const auto parts = angle.of_angle.as_fraction();
    if (!parts) continue;
    for (const unsigned e : {8U, 24U, 64U}) {
      if (turning_function(angle, *parts, rational(integer(1) << e)).has_endless_zeros()) {
        return true;
      }
    }
  }
  return false;
}

/// Of f(x), for the x that a formula of u takes for u -> inf.
bool has_endless_roots_along(const expression& f, const symbol& x) {
  return has_endless_roots_rightward(expression(f(x), f.names()));
}
/// In (p, p + h), or in (p - h, p) for side = -1, for every h > 0.
bool has_endless_roots_beside(const expression& f, const expression& p, int side) {
  const symbol x = symbol::variable(0);
  const symbol end = p.evaluate(std::span<const symbol>());
  try {
    if (has_endless_roots_along(f, end + symbol(side) / x)) return true;
    // At x = p + side e^-s; with the factor |dx/ds| of the substitution it is f again.
    const auto in_s =
        expression(f(x) / (symbol(side) * (x - end)), f.names()).in_exponential(&p, side);
    return in_s && has_endless_roots_rightward(*in_s);
  } catch (const input_error&) {
    return false;  // it has no value anywhere
  }
}

}  // namespace

bool has_endless_roots(const expression& f, int side) {
  return side > 0 ? has_endless_roots_rightward(f)
                  : has_endless_roots_along(f, -symbol::variable(0));
}

bool has_endless_roots_in(const expression& f, const rational& lower, const rational& upper) {
  const ball range = hull(ball(lower, bits), ball(upper, bits));
  constexpr precision many_bits = 1024;  // a box is halved often
  const auto is_between = [&](const ball& x) {
    return !x.is_undefined() && certainly_less(ball(lower, many_bits), x) &&
           certainly_less(x, ball(upper, many_bits));
  };
  const auto at = [](const rational& x) { return expression(symbol(x), {}); };
  if (lower < upper &&
      (has_endless_roots_beside(f, at(lower), 1) || has_endless_roots_beside(f, at(upper), -1))) {
    return true;
  }
  const std::vector<expression> points = f.divisor_zeros(double_interval::from_ball(range));
  return std::ranges::any_of(points, [&](const expression& p) {
    return is_between(p.value(many_bits)) &&
           (has_endless_roots_beside(f, p, 1) || has_endless_roots_beside(f, p, -1));
  });
}

}  // namespace polhode::detail
