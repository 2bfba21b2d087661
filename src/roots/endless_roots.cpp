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
// Bessel's functions and others that are waves for large arguments are such F with further
// continuous functions of x, of which it is known that they lie in [-1, 1] (expression::by_waves):
// the signs are proved for all values there.
//
// Towards a point p, f(p + 1/u) is such a function of u, and f(p + e^-s) of s.

#include "endless_roots.hpp"

#include <algorithm>
#include <optional>
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

/// What is known of formulas for all x >= from. Their first variable is x; the others stand for
/// continuous functions of x whose values lie in [-1, 1] (expression::by_waves).
class far_out {
 public:
  explicit far_out(rational from) : from_(std::move(from)) {}

  [[nodiscard]] int sign_of(const expression& f) const {
    return zero_free_ends(of_x_alone(f)).sign_beyond(from_);
  }
  [[nodiscard]] bool is_continuous(const expression& f) const {
    return f.is_continuous([this](const expression& u) { return sign_of(u); });
  }
  /// Of a continuous f.
  [[nodiscard]] bool has_infinite_limit(const expression& f) const {
    return zero_free_ends(of_x_alone(f)).infinite_limit_beyond(from_) != 0;
  }

 private:
  static expression of_x_alone(const expression& f) {
    const std::vector<ball> others(f.variables().size() - 1, hull(ball(-1, bits), ball(1, bits)));
    return others.empty() ? f : f.with_sets(others);
  }

  rational from_;
};

/// A formula of x, perhaps others, and an angle w, which is the last variable.
class function_of_angle {
 public:
  function_of_angle(expression f, const expression& angle) : f_(std::move(f)), angle_(&angle) {}

  /// The function f(x, w(x)) of x.
  [[nodiscard]] expression whole() const {
    const std::vector<symbol> x = others();
    return at(angle_->evaluate(std::span<const symbol>(x)));
  }
  /// The function f(x, w) of x.
  [[nodiscard]] expression at(const pi_combination& w) const { return at(symbol_of(w)); }
  [[nodiscard]] bool depends_on_angle_alone() const {
    const std::vector<std::string> used = f_.used_variables();
    return used.empty() || (used.size() == 1 && used.front() == f_.variables().back());
  }
  /// f and its derivative for all angles in the ball, of an f that depends on the angle alone.
  [[nodiscard]] jet<ball, 1> over(const ball& w) const {
    std::vector<jet<ball, 1>> values(f_.variables().size(), jet<ball, 1>::constant(w));
    values.back() = jet<ball, 1>::variable(w);
    return f_.evaluator<jet<ball, 1>>(bits)(values);
  }

 private:
  [[nodiscard]] std::vector<symbol> others() const {
    std::vector<symbol> result;
    for (std::size_t i = 0; i + 1 < f_.variables().size(); ++i) {
      result.push_back(symbol::variable(i));
    }
    return result;
  }
  [[nodiscard]] expression at(const symbol& w) const {
    std::vector<symbol> values = others();
    values.push_back(w);
    std::vector<std::string> names = f_.variables();
    names.pop_back();
    return expression(f_.evaluate(std::span<const symbol>(values)),
                      {std::move(names), {}, f_.names().further});
  }

  expression f_;
  const expression* angle_;
};

/// f as N and the d_i, with the angle w.
class turning_function {
 public:
  turning_function(const expression::unwound& f, const expression::fraction& parts,
                   const far_out& beyond)
      : f_(f), beyond_(beyond), numerator_(parts.numerator, f_.angle) {
    for (const expression& d : parts.divisors) divisors_.emplace_back(d, f_.angle);
  }

  [[nodiscard]] bool has_endless_zeros() {
    if (!beyond_.is_continuous(f_.angle) || !beyond_.has_infinite_limit(f_.angle) ||
        !beyond_.is_continuous(numerator_.whole())) {
      return false;
    }
    std::erase_if(divisors_, [&](const function_of_angle& d) {
      const expression whole = d.whole();
      return beyond_.sign_of(whole) != 0 && beyond_.is_continuous(whole);
    });
    constexpr long parts = 24;  // of a period, in which many sines are known exactly
    return changes_sign(4) || changes_sign(parts);
  }

 private:
  [[nodiscard]] bool changes_sign(long parts) const {
    int last = 0;
    pi_combination s;
    for (long k = 0; k <= parts; ++k) {
      const pi_combination t = f_.period * rational(k, parts);
      const std::optional<expression> here = numerator_at(t);
      if (!here) continue;
      if (here->is_formally_zero() && is_defined_at(t)) return true;
      const int sign = beyond_.sign_of(*here);
      if (sign == 0) continue;
      if (sign * last < 0 && is_defined_between(s, t)) return true;
      last = sign;
      s = t;
    }
    return false;
  }

  /// None where it has no value for this angle.
  [[nodiscard]] std::optional<expression> numerator_at(const pi_combination& w) const {
    try {
      return numerator_.at(w).with_rational_constants();
    } catch (const input_error&) {
      return std::nullopt;
    }
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

  const expression::unwound& f_;
  const far_out& beyond_;
  function_of_angle numerator_;
  std::vector<function_of_angle> divisors_;
};

bool has_endless_roots_rightward(const expression& f) {
  constexpr std::size_t most_angles = 8;  // they take time
  for (const unsigned e : {8U, 24U, 64U}) {
    const far_out beyond(rational(integer(1) << e));
    const auto by_waves = f.by_waves([&](const expression& u) { return beyond.sign_of(u); });
    const expression& g = by_waves ? *by_waves : f;
    std::vector<expression::unwound> angles = g.unwound_angles();
    if (angles.size() > most_angles) angles.erase(angles.begin() + most_angles, angles.end());
    for (const expression::unwound& turning : angles) {
      const auto parts = turning.of_angle.as_fraction();
      if (parts && turning_function(turning, *parts, beyond).has_endless_zeros()) return true;
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
  if (has_endless_roots_along(f, end + symbol(side) / x)) return true;
  // At x = p + side e^-s; with the factor |dx/ds| of the substitution it is f again.
  const auto in_s =
      expression(f(x) / (symbol(side) * (x - end)), f.names()).in_exponential(&p, side);
  return in_s && has_endless_roots_rightward(*in_s);
}

/// What `prove` returns; false where an operation that it makes has no value anywhere.
template <class Prove>
bool is_proved_by(const Prove& prove) {
  try {
    return prove();
  } catch (const input_error&) {
    return false;
  }
}

}  // namespace

bool has_endless_roots(const expression& f, int side) {
  return is_proved_by([&] {
    return side > 0 ? has_endless_roots_rightward(f)
                    : has_endless_roots_along(f, -symbol::variable(0));
  });
}

bool has_endless_roots_in(const expression& f, const rational& lower, const rational& upper) {
  const ball range = hull(ball(lower, bits), ball(upper, bits));
  constexpr precision many_bits = 1024;  // a box is halved often
  const auto is_between = [&](const ball& x) {
    return !x.is_undefined() && certainly_less(ball(lower, many_bits), x) &&
           certainly_less(x, ball(upper, many_bits));
  };
  const auto is_beside = [&](const expression& p, int side) {
    return is_proved_by([&] { return has_endless_roots_beside(f, p, side); });
  };
  const auto at = [](const rational& x) { return expression(symbol(x), {}); };
  if (lower < upper && (is_beside(at(lower), 1) || is_beside(at(upper), -1))) return true;
  const std::vector<expression> points = f.divisor_zeros(double_interval::from_ball(range));
  return std::ranges::any_of(points, [&](const expression& p) {
    return is_between(p.value(many_bits)) && (is_beside(p, 1) || is_beside(p, -1));
  });
}

}  // namespace polhode::detail
