// A formula in s in place of x = e + sigma exp(-s), or x = sigma exp(s), with the factor |dx/ds|.
//
// Every operation of f is written as exp(kappa s + v) rest, kappa a constant, so that powers, roots
// and logarithms of it take the exponent out: what decays or grows as a power of the distance, or
// of x, becomes an exponential of s. Each step is an identity of real numbers wherever the
// operation of f is defined:
//   exp(a) p * exp(b) q = exp(a + b) p q,
//   (exp(a) p)^y = exp(a y) p^y for p > 0, and for all p where y is a whole number,
//   (exp(a) p)^(1/n) = exp(a/n) p^(1/n),  log(exp(a) p) = a + log p,  |exp(a) p| = exp(a) |p|,
//   alpha + beta exp(w) = beta exp(w) where the exact rules show that alpha = 0,
//   log_gamma(w) = log_gamma(1 + w) - log |w|, gamma(w) = gamma(1 + w)/w,
//   ellipticK(m) = pi/(2 agm(1, sqrt(1 - m))) where 1 - m is exp(a) p (C. F. Gauss; DLMF 19.8.5);
//     of a rational function 1 - m a power of the distance from a rational end, or of 1/|x|, is
//     divided out of its polynomials in that; where m is one of the numbers near 1 below, or the
//     square of one, 1 - m is written as there,
//   sin(k pi + w) = (-1)^k sin w,  sin(k pi + pi/2 + w) = (-1)^k cos w, and so for cos,
//   tan(k pi + w) = tan w,  tan(k pi + pi/2 + w) = -1/tan w.
// What decays with s and is a difference of two numbers near 1 is written without that difference,
// so that regions of it keep its relative size:
//   cos w - 1 = -2 sin(w/2)^2,  cosh w - 1 = 2 sinh(w/2)^2,  exp w - 1 = 2 exp(w/2) sinh(w/2),
//   sqrt(1 + w) - 1 = w/(sqrt(1 + w) + 1),  log(1 + w) = 2 atanh(w/(2 + w)).

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "exact_value.hpp"
#include "graph.hpp"
#include "polhode/arithmetic/polynomial.hpp"
#include "polhode/expression/elliptic_functions.hpp"

namespace polhode {
namespace exponential_substitution_impl {
namespace {

using detail::node;
using detail::node_id;
using detail::operation;

constexpr node_id most_nodes = 500;

/// exp(kappa s + v) rest; and where it is linear in x, alpha + beta exp(+-s).
struct value {
  node_id kappa;
  node_id v;
  node_id rest;
  struct linear {
    node_id alpha;
    node_id beta;
  };
  std::optional<linear> in_x;
  /// It is sign F(w), where F is cos, cosh, exp, 1 + w (add) or sqrt(1 + w) of a w that decays with
  /// s.
  struct near_one {
    operation function;
    node_id w;
    int sign = 1;
  };
  std::optional<near_one> beside_one = std::nullopt;
  /// 1 + w.
  [[nodiscard]] bool is_one_and_more() const {
    return beside_one && beside_one->function == operation::add && beside_one->sign > 0;
  }
};

/// p(a + b x).
rational_polynomial composed(const rational_polynomial& p, const rational& a, const rational& b) {
  const rational_polynomial x({a, b});
  rational_polynomial result;
  for (std::size_t i = p.coefficients().size(); i-- > 0;) {
    result = result * x + rational_polynomial({p.coefficients()[i]});
  }
  return result;
}
/// The polynomial with its coefficients in the other order: x^n p(1/x), of degree n.
rational_polynomial reversed(const rational_polynomial& p) {
  return rational_polynomial({p.coefficients().rbegin(), p.coefficients().rend()});
}
/// p without its factor x^k, and k.
std::pair<rational_polynomial, long> without_power(const rational_polynomial& p) {
  const auto& c = p.coefficients();
  const auto first = std::ranges::find_if(c, [](const rational& q) { return q != 0; });
  return {rational_polynomial({first, c.end()}), static_cast<long>(first - c.begin())};
}

class substitution {
 public:
  /// The node of f as a rational function, where it is one.
  using quotient_of = std::function<std::optional<rational_quotient>(node_id)>;

  /// end: that of the finite e, none for an infinity; `at` its value, where it is rational.
  substitution(const detail::graph& f, const detail::graph* end, std::optional<rational> at,
               int side, quotient_of quotient)
      : f_(f),
        g_(f.further()),
        s_(g_.variable(0)),
        zero_(g_.number(0)),
        one_(g_.number(1)),
        is_infinite_(end == nullptr),
        at_(std::move(at)),
        side_(side),
        quotient_(std::move(quotient)) {
    const node_id sigma = g_.number(side);
    growth_ = g_.number(end == nullptr ? 1 : -1);
    x_ = linear(end == nullptr ? zero_ : copied(*end), sigma);
  }

  detail::graph result() {
    const std::vector<char> used = detail::reachable(f_);
    varies_ = detail::varying(f_);
    values_.resize(f_.size());
    for (node_id i = 0; i <= f_.root; ++i) {
      if (used[i] != 0) values_[i] = made(i);
    }
    value f = *values_[f_.root];
    f.kappa = add(g_, f.kappa, growth_);
    g_.root = plain(f);
    return std::move(g_);
  }

 private:
  // -------------------------------------------------------------------------------------------
  // Values

  [[nodiscard]] value as_it_is(node_id rest) const { return {zero_, zero_, rest, std::nullopt}; }
  [[nodiscard]] value constant(node_id c) const {
    return {zero_, zero_, c, value::linear{c, zero_}};
  }
  /// alpha + beta exp(+-s), with the exponential taken out where alpha is shown to be 0.
  value linear(node_id alpha, node_id beta) {
    if (beta == zero_) return constant(alpha);
    if (!is_zero(alpha)) {
      const node_id moving = multiply(g_, beta, exp_of(multiply(g_, growth_, s_)));
      return {zero_, zero_, add(g_, alpha, moving), value::linear{alpha, beta}};
    }
    return {growth_, zero_, beta, value::linear{zero_, beta}};
  }
  node_id call(const char* function, const std::vector<node_id>& x) {
    return detail::find_function(function)->build(g_, x);
  }
  node_id exp_of(node_id x) { return x == zero_ ? one_ : call("exp", {x}); }
  node_id exponent(const value& x) {
    return x.kappa == zero_ ? x.v : add(g_, multiply(g_, x.kappa, s_), x.v);
  }
  node_id plain(const value& x) { return multiply(g_, exp_of(exponent(x)), x.rest); }

  /// Whether the rules show that a node without variables is 0.
  [[nodiscard]] bool is_zero(node_id c) { return is_rational(c, 0); }
  [[nodiscard]] bool is_rational(node_id c, const rational& q) {
    const auto found = detail::rational_value_at(g_, c);
    return found && *found == q;
  }
  /// w = kappa s + v, as far as it is a sum of multiples of s and others.
  std::pair<node_id, node_id> split(node_id w) {
    if (w == s_) return {one_, zero_};
    const node n = g_[w];
    switch (n.what) {
      case operation::negate: {
        const auto [kappa, v] = split(n.left);
        return {negate(g_, kappa), negate(g_, v)};
      }
      case operation::add:
      case operation::subtract: {
        const auto [kappa, v] = split(n.left);
        const auto [more, rest] = split(n.right);
        if (n.what == operation::add) return {add(g_, kappa, more), add(g_, v, rest)};
        return {subtract(g_, kappa, more), subtract(g_, v, rest)};
      }
      case operation::multiply: {
        if (is_constant(n.left)) {
          const auto [kappa, v] = split(n.right);
          return {multiply(g_, n.left, kappa), times(n.left, v)};
        }
        if (is_constant(n.right)) {
          const auto [kappa, v] = split(n.left);
          return {multiply(g_, kappa, n.right), times(v, n.right)};
        }
        return {zero_, w};
      }
      case operation::divide: {
        if (!is_constant(n.right)) return {zero_, w};
        const auto [kappa, v] = split(n.left);
        return {divide(g_, kappa, n.right), v == zero_ ? v : divide(g_, v, n.right)};
      }
      default:
        return {zero_, w};
    }
  }
  node_id times(node_id x, node_id y) {
    return x == zero_ || y == zero_ ? zero_ : multiply(g_, x, y);
  }
  /// Of g_: it does not depend on s.
  [[nodiscard]] bool is_constant(node_id i) {
    if (i == s_) return false;
    while (constant_.size() < g_.size()) {
      const auto k = static_cast<node_id>(constant_.size());
      bool all = k != s_;
      for (const node_id x : detail::operands_at(g_, k)) all = all && constant_[x] != 0;
      constant_.push_back(static_cast<char>(all));
    }
    return constant_[i] != 0;
  }

  // -------------------------------------------------------------------------------------------
  // Operations

  value made(node_id i) {
    const node n = f_[i];
    if (n.what == operation::variable) return x_;
    if (varies_[i] == 0) {
      if (n.what == operation::number) return constant(g_.number(f_.number_at(n.number)));
      return constant(
          detail::with_operands(g_, f_, i, [&](node_id k) { return values_[k]->rest; }));
    }
    switch (n.what) {
      case operation::negate: {
        value x = *values_[n.left];
        if (x.in_x) return linear(negate(g_, x.in_x->alpha), negate(g_, x.in_x->beta));
        x.rest = negate(g_, x.rest);
        if (x.beside_one) x.beside_one->sign = -x.beside_one->sign;
        return x;
      }
      case operation::add:
      case operation::subtract:
        return sum(*values_[n.left], *values_[n.right], n.what == operation::subtract);
      case operation::multiply:
        return product(*values_[n.left], *values_[n.right]);
      case operation::divide:
        return quotient(*values_[n.left], *values_[n.right]);
      case operation::power_integer:
        return to_power(*values_[n.left], g_.number(n.number));
      case operation::power:
        return to_power(*values_[n.left], plain(*values_[n.right]));
      case operation::sqrt: {
        const value& x = *values_[n.left];
        const node_id half = g_.number(rational(1, 2));
        value result = scaled(x, half, call("sqrt", {x.rest}));
        if (x.is_one_and_more()) {
          result.beside_one = value::near_one{operation::sqrt, x.beside_one->w};
        }
        return result;
      }
      case operation::root: {
        const value& x = *values_[n.left];
        const node_id part = g_.number(rational(1, n.number));
        return scaled(x, part, call("root", {x.rest, g_.number(n.number)}));
      }
      case operation::exp: {
        const auto [kappa, v] = split(plain(*values_[n.left]));
        return beside_one({kappa, v, one_, std::nullopt}, n);
      }
      case operation::cosh:
        return beside_one(as_it_is(call("cosh", {plain(*values_[n.left])})), n);
      case operation::expm1: {
        const value& x = *values_[n.left];
        if (!decays(x)) break;
        return less_one({operation::exp, plain(x)});
      }
      case operation::log1p: {
        const value& x = *values_[n.left];
        if (!decays(x)) break;
        return logarithm_beside_one(plain(x));
      }
      case operation::log: {
        const value& x = *values_[n.left];
        if (x.is_one_and_more()) return logarithm_beside_one(x.beside_one->w);
        return as_it_is(add(g_, exponent(x), x.rest == one_ ? zero_ : call("log", {x.rest})));
      }
      case operation::abs: {
        const value& x = *values_[n.left];
        return {x.kappa, x.v, call("abs", {x.rest}), std::nullopt};
      }
      case operation::log_gamma: {
        const value& x = *values_[n.left];
        if (!tends_to_0(x)) break;
        const node_id rest = x.rest == one_ ? zero_ : call("log", {call("abs", {x.rest})});
        const node_id further = call("log_gamma", {add(g_, one_, plain(x))});
        return as_it_is(subtract(g_, further, add(g_, exponent(x), rest)));
      }
      case operation::gamma: {
        const value& x = *values_[n.left];
        if (!tends_to_0(x)) break;
        const node_id further = call("gamma", {add(g_, one_, plain(x))});
        return {negate(g_, x.kappa), negate(g_, x.v), divide(g_, further, x.rest), std::nullopt};
      }
      case operation::further:
        if (auto complete = complete_integral(i)) return *complete;
        break;
      case operation::sin:
      case operation::cos:
      case operation::tan:
        if (auto moved = by_quarter_turns(n)) return *moved;
        if (n.what != operation::cos) break;
        return beside_one(as_it_is(call("cos", {plain(*values_[n.left])})), n);
      default:
        break;
    }
    return as_it_is(
        detail::with_operands(g_, f_, i, [&](node_id k) { return plain(*values_[k]); }));
  }
  /// It tends to 0 for s -> infinity, if its last factor is bounded.
  [[nodiscard]] bool decays(const value& x) {
    return x.v == zero_ && x.kappa != zero_ && is_constant(x.kappa) &&
           certainly_negative(detail::value_at(g_, x.kappa, 64));
  }
  /// The function of node n, which is 1 at 0.
  value beside_one(value result, const node& n) {
    const value& x = *values_[n.left];
    if (decays(x)) result.beside_one = value::near_one{n.what, plain(x)};
    return result;
  }
  /// F(w) - 1.
  value less_one(const value::near_one& f) {
    const node_id two = g_.number(2);
    const node_id half = divide(g_, f.w, two);
    const auto twice_squared = [&](const char* function) {
      return multiply(g_, two, power(g_, call(function, {half}), two));
    };
    switch (f.function) {
      case operation::cos:
        return as_it_is(negate(g_, twice_squared("sin")));
      case operation::cosh:
        return as_it_is(twice_squared("sinh"));
      case operation::exp:
        return as_it_is(multiply(g_, multiply(g_, two, call("exp", {half})), call("sinh", {half})));
      default: {  // sqrt(1 + w)
        const node_id root = call("sqrt", {add(g_, one_, f.w)});
        return as_it_is(divide(g_, f.w, add(g_, root, one_)));
      }
    }
  }
  value logarithm_beside_one(node_id w) {
    const node_id two = g_.number(2);
    return as_it_is(multiply(g_, two, call("atanh", {divide(g_, w, add(g_, two, w))})));
  }
  /// x + sign y without a difference of numbers near 1, where y is 1 or -1.
  std::optional<value> without_one(const value& x, const value& y, int sign) {
    if (!x.beside_one || x.beside_one->function == operation::add) return std::nullopt;
    const rational* const c = g_.value(y.rest);
    if (c == nullptr || !y.in_x || y.in_x->beta != zero_) return std::nullopt;
    if (*c * sign + x.beside_one->sign != 0) return std::nullopt;
    value result = less_one(*x.beside_one);
    if (x.beside_one->sign < 0) result.rest = negate(g_, result.rest);
    return result;
  }
  value sum(const value& x, const value& y, bool minus) {
    const int sign = minus ? -1 : 1;
    if (auto difference = without_one(x, y, sign)) return *difference;
    if (auto difference = without_one(y, x, sign)) {
      if (minus) difference->rest = negate(g_, difference->rest);
      return *difference;
    }
    value result = sum_as_it_is(x, y, minus);
    if (x.rest == one_ && x.in_x && x.in_x->beta == zero_ && decays(y)) {
      const node_id w = plain(y);
      result.beside_one = value::near_one{operation::add, minus ? negate(g_, w) : w};
    } else if (!minus && y.rest == one_ && y.in_x && y.in_x->beta == zero_ && decays(x)) {
      result.beside_one = value::near_one{operation::add, plain(x)};
    }
    return result;
  }
  value sum_as_it_is(const value& x, const value& y, bool minus) {
    const auto of = [&](node_id p, node_id q) {
      return minus ? subtract(g_, p, q) : add(g_, p, q);
    };
    if (x.in_x && y.in_x) {
      return linear(of(x.in_x->alpha, y.in_x->alpha), of(x.in_x->beta, y.in_x->beta));
    }
    if (x.kappa == y.kappa && x.v == y.v) {
      return {x.kappa, x.v, of(x.rest, y.rest), std::nullopt};
    }
    return as_it_is(of(plain(x), plain(y)));
  }
  value product(const value& x, const value& y) {
    const auto is_constant_in_x = [&](const value& z) { return z.in_x && z.in_x->beta == zero_; };
    if (x.in_x && is_constant_in_x(y)) {
      return linear(multiply(g_, x.in_x->alpha, y.rest), times(x.in_x->beta, y.rest));
    }
    if (y.in_x && is_constant_in_x(x)) return product(y, x);
    return {add(g_, x.kappa, y.kappa), add(g_, x.v, y.v), multiply(g_, x.rest, y.rest),
            std::nullopt};
  }
  value quotient(const value& x, const value& y) {
    if (x.in_x && y.in_x && y.in_x->beta == zero_) {
      return linear(divide(g_, x.in_x->alpha, y.rest),
                    x.in_x->beta == zero_ ? zero_ : divide(g_, x.in_x->beta, y.rest));
    }
    return {subtract(g_, x.kappa, y.kappa), subtract(g_, x.v, y.v), divide(g_, x.rest, y.rest),
            std::nullopt};
  }
  /// (exp(kappa s + v) rest)^y.
  value to_power(const value& x, node_id y) {
    if (x.kappa == zero_ && x.v == zero_) return as_it_is(power(g_, x.rest, y));
    const node_id rest = x.rest == one_ ? one_ : power(g_, x.rest, y);  // y is in the exponent
    if (is_constant(y)) return scaled(x, y, rest);
    const auto [kappa, v] = split(multiply(g_, exponent(x), y));
    return {kappa, v, rest, std::nullopt};
  }
  /// The exponential that is taken out of it falls with s; at an infinite end there is none.
  [[nodiscard]] bool tends_to_0(const value& x) const {
    return growth_ != one_ && x.kappa == growth_;
  }
  /// 1 - y without a difference of numbers near 1, where y tends to 1.
  std::optional<value> less_than_one(const value& y) {
    if (y.is_one_and_more()) return as_it_is(negate(g_, y.beside_one->w));
    std::optional<value> more = without_one(y, constant(one_), -1);
    if (more) more->rest = negate(g_, more->rest);
    return more;
  }
  /// 1 - m where it tends to 0, of a square m = k^2 as (1 - k)(1 + k).
  std::optional<value> complement(node_id i) {
    const node n = f_[i];
    const value one = constant(one_);
    if (n.what != operation::power_integer || n.number != 2) {
      if (auto less = less_than_one(*values_[i])) return less;
      const value difference = sum(one, *values_[i], true);
      return tends_to_0(difference) ? std::optional(difference) : std::nullopt;
    }
    const value& k = *values_[n.left];
    if (const auto less = less_than_one(k)) return product(*less, sum(one, k, false));
    if (const auto more = without_one(k, one, 1)) return product(sum(one, k, true), *more);
    const value both = product(sum(one, k, true), sum(one, k, false));
    return tends_to_0(both) ? std::optional(both) : std::nullopt;
  }
  /// 1 - m of a rational function m, where it is t^k r(t) for a k > 0 and a rational r without zero
  /// or pole at 0: t = exp(-s) is the distance from a rational end, or 1/|x|.
  std::optional<value> rational_complement(node_id i) {
    if (!is_infinite_ && !at_) return std::nullopt;
    const auto m = quotient_(i);
    if (!m) return std::nullopt;
    rational_polynomial below = denominator_of(*m);
    rational_polynomial above = below - m->numerator;
    constexpr long most_degree = 64;
    if (std::max(above.degree(), below.degree()) > most_degree) return std::nullopt;
    long power = 0;
    if (is_infinite_) {
      power = below.degree() - above.degree();
      // p(side/t) = (side/t)^n (reversed p)(side t).
      above = composed(reversed(above), 0, side_);
      below = composed(reversed(below), 0, side_);
      if (power % 2 != 0 && side_ < 0) below = below * rational_polynomial({rational(-1)});
    } else {
      above = composed(above, *at_, side_);
      below = composed(below, *at_, side_);
    }
    if (above.is_zero() || below.is_zero()) return std::nullopt;
    const auto [numerator, zeros] = without_power(above);
    const auto [denominator, poles] = without_power(below);
    power += zeros - poles;
    if (power <= 0) return std::nullopt;
    const node_id rest = divide(g_, in_distance(numerator), in_distance(denominator));
    return value{g_.number(-power), zero_, rest, std::nullopt};
  }
  /// p(exp(-s)).
  node_id in_distance(const rational_polynomial& p) {
    const node_id t = exp_of(negate(g_, s_));
    node_id result = zero_;
    for (std::size_t i = p.coefficients().size(); i-- > 0;) {
      const node_id c = g_.number(p.coefficients()[i]);
      result = result == zero_ ? c : add(g_, multiply(g_, result, t), c);
    }
    return result;
  }
  /// ellipticK towards its logarithmic end.
  std::optional<value> complete_integral(node_id i) {
    const detail::further_call& f = f_.call_at(i);
    // A function of this name in another list may be anything.
    const further_functions& own = *elliptic_functions();
    const auto is_called = [&](const further_function& one) { return &one == f.function; };
    if (f.function->what.name != "ellipticK" || std::ranges::none_of(own, is_called))
      return std::nullopt;
    std::optional<value> found = rational_complement(f.operands.front());
    if (!found) found = complement(f.operands.front());
    if (!found) return std::nullopt;
    const value& left = *found;
    const node_id half = g_.number(rational(1, 2));
    const node_id modulus = plain(scaled(left, half, call("sqrt", {left.rest})));
    const node_id inverse = divide(g_, one_, call("agm", {one_, modulus}));
    return as_it_is(multiply(g_, multiply(g_, half, g_.make(operation::pi)), inverse));
  }
  value scaled(const value& x, node_id y, node_id rest) {
    return {times(x.kappa, y), times(x.v, y), rest, std::nullopt};
  }
  /// sin, cos and tan of alpha + w where alpha is shown to be a whole number of quarter turns.
  std::optional<value> by_quarter_turns(const node& n) {
    const value& x = *values_[n.left];
    if (!x.in_x || x.in_x->alpha == zero_) return std::nullopt;
    const node_id quarters =
        divide(g_, multiply(g_, g_.number(2), x.in_x->alpha), g_.make(operation::pi));
    const auto found = detail::rational_value_at(g_, quarters);
    if (!found || denominator(*found) != 1) return std::nullopt;
    const integer k = numerator(*found);
    const long turns = static_cast<long>(mpz_fdiv_ui(k.backend().data(), 4));
    const node_id w = plain(linear(zero_, x.in_x->beta));
    if (n.what == operation::tan) {
      const node_id tangent = call("tan", {w});
      return as_it_is(turns % 2 == 0 ? tangent : negate(g_, divide(g_, one_, tangent)));
    }
    // The quarter turns that take sin w there: cos w = sin(w + pi/2).
    const long quarter = (turns + (n.what == operation::cos ? 1 : 0)) % 4;
    const node_id function = call(quarter % 2 == 0 ? "sin" : "cos", {w});
    value result = as_it_is(quarter >= 2 ? negate(g_, function) : function);
    if (quarter % 2 != 0 && decays(linear(zero_, x.in_x->beta))) {
      result.beside_one = value::near_one{operation::cos, w, quarter >= 2 ? -1 : 1};
    }
    return result;
  }

  node_id copied(const detail::graph& number) {
    if (number.further() != nullptr && number.further() != g_.further()) {
      throw detail::undefined_operation("functions of another list");  // which g_ would not keep
    }
    return detail::copied_into(g_, number)[number.root];
  }

  const detail::graph& f_;
  detail::graph g_;
  node_id s_;
  node_id zero_;
  node_id one_;
  node_id growth_ = 0;  // 1 or -1
  bool is_infinite_;
  std::optional<rational> at_;
  int side_;
  quotient_of quotient_;
  value x_{};
  std::vector<char> varies_;
  std::vector<std::optional<value>> values_;
  std::vector<char> constant_;
};

}  // namespace
}  // namespace exponential_substitution_impl

std::optional<expression> expression::in_exponential(const expression* end, int side) const {
  namespace impl = exponential_substitution_impl;
  if (variables_.size() != 1 || graph_->root >= impl::most_nodes ||
      (end != nullptr && !end->used_variables().empty())) {
    return std::nullopt;
  }
  try {
    const auto quotient_of = [&](detail::node_id i) { return with_root(*graph_, i).quotient(); };
    impl::substitution s(*graph_, end == nullptr ? nullptr : end->graph_.get(),
                         end == nullptr ? std::nullopt : end->rational_value(), side, quotient_of);
    detail::graph g = s.result();
    const detail::node_id root = g.root;
    expression result = with_root(std::move(g), root);
    result.variables_ = {"s"};
    return result;
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

}  // namespace polhode
