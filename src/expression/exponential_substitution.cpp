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
//   ellipticK(m) = pi/(2 agm(1, sqrt(1 - m))) (C. F. Gauss; DLMF 19.8.5) and ellipticE(m) =
//     2 carlsonRG(0, 1 - m, 1) (DLMF 19.25.1) where 1 - m is exp(a) p: of a rational function 1 - m
//     a power of the distance from a rational end, or of 1/|x|, is divided out of its polynomials
//     in that; where m is known as 1 + w (below), 1 - m is -w,
//   carlsonRF(0, x, y) = pi/(2 agm(sqrt x, sqrt y)) (the same, by DLMF 19.25.1),
//   sin(k pi + w) = (-1)^k sin w,  sin(k pi + pi/2 + w) = (-1)^k cos w, and so for cos,
//   tan(k pi + w) = tan w,  tan(k pi + pi/2 + w) = -1/tan w.
// What decays with s and is a difference of two numbers near a constant c is written without that
// difference, so that regions of it keep its relative size. For that an operation that tends to c
// is known as c + w, too:
//   cos(c + w) - cos c = -2 sin(c + w/2) sin(w/2),  sin(c + w) - sin c = 2 cos(c + w/2) sin(w/2),
//   cosh(c + w) - cosh c = 2 sinh(c + w/2) sinh(w/2),  and so for sinh, with cosh(c + w/2),
//   exp(c + w) - exp c = 2 exp(c + w/2) sinh(w/2),
//   sqrt(c + w) - sqrt c = w/(sqrt(c + w) + sqrt c),  log(c + w) - log c = 2 atanh(w/(2c + w)),
//   (c + w)^y - c^y = 2 c^y exp(h) sinh(h),  h = y atanh(w/(2c + w)),  for c > 0,
//   (c + w)^2 - c^2 = w (2c + w),  (c + w)(d + v) - cd = cv + dw + wv,
//   (c + w)/(d + v) - c/d = (dw - cv)/(d (d + v)).

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "exact_value.hpp"
#include "graph.hpp"
#include "polhode/arithmetic/polynomial.hpp"
#include "polhode/expression/library_functions.hpp"

namespace polhode {
namespace exponential_substitution_impl {
namespace {

using detail::node;
using detail::node_id;
using detail::operation;

constexpr node_id most_nodes = 500;

/// exp(kappa s + v) rest.
struct part {
  node_id kappa;
  node_id v;
  node_id rest;
};
/// c + w with a constant c and a w that decays with s; no w where w.rest is 0.
struct near_number {
  node_id c;
  part w;
};
/// A part; where it is linear in x, alpha + beta exp(+-s) too; and where it tends to a constant, as
/// near_number.
struct value : part {
  struct linear {
    node_id alpha;
    node_id beta;
  };
  std::optional<linear> in_x;
  std::optional<near_number> beside = std::nullopt;
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

  [[nodiscard]] part plain_part(node_id rest) const { return {zero_, zero_, rest}; }
  [[nodiscard]] value as_it_is(node_id rest) const { return {plain_part(rest), std::nullopt}; }
  [[nodiscard]] value constant(node_id c) const { return {plain_part(c), value::linear{c, zero_}}; }
  /// alpha + beta exp(+-s), with the exponential taken out where alpha is shown to be 0.
  value linear(node_id alpha, node_id beta) {
    if (beta == zero_) return constant(alpha);
    if (!is_zero(alpha)) {
      const node_id moving = multiply(g_, beta, exp_of(multiply(g_, growth_, s_)));
      return {plain_part(add(g_, alpha, moving)), value::linear{alpha, beta}};
    }
    return {{growth_, zero_, beta}, value::linear{zero_, beta}};
  }
  node_id call(const char* function, const std::vector<node_id>& x) {
    return detail::find_function(function)->build(g_, x);
  }
  node_id exp_of(node_id x) { return x == zero_ ? one_ : call("exp", {x}); }
  node_id exponent(const part& x) {
    return x.kappa == zero_ ? x.v : add(g_, multiply(g_, x.kappa, s_), x.v);
  }
  node_id plain(const part& x) {
    return x.rest == zero_ ? zero_ : multiply(g_, exp_of(exponent(x)), x.rest);
  }

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
    if (x == zero_ || y == zero_) return zero_;
    const node product = g_[y];
    const rational* const p = g_.value(x);
    const rational* const q =
        product.what == operation::multiply ? g_.value(product.left) : nullptr;
    if (p == nullptr || q == nullptr) return multiply(g_, x, y);
    return multiply(g_, g_.number(*p * *q), product.right);
  }
  node_id plus(node_id x, node_id y, bool minus) {
    if (y == zero_) return x;
    if (x == zero_) return minus ? negate(g_, y) : y;
    return minus ? subtract(g_, x, y) : add(g_, x, y);
  }
  part plus(const part& x, const part& y, bool minus) {
    if (y.rest == zero_) return x;
    if (x.rest == zero_) return minus ? times(g_.number(-1), y) : y;
    if (x.kappa == y.kappa && x.v == y.v) return {x.kappa, x.v, plus(x.rest, y.rest, minus)};
    return plain_part(plus(plain(x), plain(y), minus));
  }
  part times(const part& x, const part& y) {
    if (x.rest == zero_) return x;
    if (y.rest == zero_) return y;
    return {add(g_, x.kappa, y.kappa), add(g_, x.v, y.v), multiply(g_, x.rest, y.rest)};
  }
  part times(node_id c, const part& x) { return {x.kappa, x.v, times(c, x.rest)}; }
  part over(const part& x, node_id divisor) {
    return {x.kappa, x.v, x.rest == zero_ ? zero_ : divide(g_, x.rest, divisor)};
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
        if (x.beside) {
          const node_id minus = g_.number(-1);
          x.beside = near_number{times(minus, x.beside->c), times(minus, x.beside->w)};
        }
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
        if (const auto b = beside_of(x); b && is_positive(b->c)) {
          const node_id c = call("sqrt", {b->c});
          result.beside = near_number{c, over(b->w, add(g_, plain(result), c))};
        }
        return result;
      }
      case operation::root: {
        const value& x = *values_[n.left];
        const node_id y = g_.number(rational(1, n.number));
        value result = scaled(x, y, call("root", {x.rest, g_.number(n.number)}));
        result.beside = power_beside(x, y);
        return result;
      }
      case operation::exp: {
        const value& x = *values_[n.left];
        const auto [kappa, v] = split(plain(x));
        value result{{kappa, v, one_}, std::nullopt};
        if (const auto b = beside_of(x)) {
          const node_id half = half_of(b->w);
          const node_id middle = call("exp", {plus(b->c, half, false)});
          result.beside = near_number{exp_of(b->c), twice(middle, call("sinh", {half}))};
        }
        return result;
      }
      case operation::cosh:
        return by_half_angle(n, "cosh", "sinh", "sinh", 1);
      case operation::sinh:
        return by_half_angle(n, "sinh", "cosh", "sinh", 1);
      case operation::expm1: {
        const value& x = *values_[n.left];
        const auto b = beside_of(x);
        if (!b || b->c != zero_) break;
        const node_id half = half_of(b->w);
        return decaying(twice(call("exp", {half}), call("sinh", {half})));
      }
      case operation::log1p: {
        const value& x = *values_[n.left];
        const auto b = beside_of(x);
        if (!b || b->c != zero_) break;
        return decaying(logarithm_of_ratio({one_, b->w}));
      }
      case operation::log: {
        const value& x = *values_[n.left];
        const auto b = beside_of(x);
        if (b && is_rational(b->c, 1)) return decaying(logarithm_of_ratio(*b));
        value result =
            as_it_is(add(g_, exponent(x), x.rest == one_ ? zero_ : call("log", {x.rest})));
        if (b && is_positive(b->c)) {
          result.beside = near_number{call("log", {b->c}), logarithm_of_ratio(*b)};
        }
        return result;
      }
      case operation::abs: {
        const value& x = *values_[n.left];
        return {{x.kappa, x.v, call("abs", {x.rest})}, std::nullopt};
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
        return {{negate(g_, x.kappa), negate(g_, x.v), divide(g_, further, x.rest)}, std::nullopt};
      }
      case operation::further:
        if (auto complete = complete_integral(i)) return *complete;
        break;
      case operation::sin:
      case operation::cos:
      case operation::tan:
        if (auto moved = by_quarter_turns(n)) return *moved;
        if (n.what == operation::sin) return by_half_angle(n, "sin", "cos", "sin", 1);
        if (n.what == operation::cos) return by_half_angle(n, "cos", "sin", "sin", -1);
        return odd(i);
      case operation::asin:
      case operation::atan:
      case operation::tanh:
      case operation::asinh:
      case operation::atanh:
        return odd(i);
      default:
        break;
    }
    return of_plain_operands(i);
  }
  value of_plain_operands(node_id i) {
    return as_it_is(
        detail::with_operands(g_, f_, i, [&](node_id k) { return plain(*values_[k]); }));
  }
  /// It tends to 0 for s -> infinity, if its last factor is bounded.
  [[nodiscard]] bool decays(const part& x) {
    return x.v == zero_ && x.kappa != zero_ && is_constant(x.kappa) &&
           certainly_negative(detail::value_at(g_, x.kappa, 64));
  }
  [[nodiscard]] bool is_positive(node_id c) {
    return c != zero_ && certainly_positive(detail::value_at(g_, c, 64));
  }

  // -------------------------------------------------------------------------------------------
  // Values near a constant. None of the identities asks that w is small.

  static const part& part_of(const value& x) { return x; }
  /// Where x tends to a constant.
  std::optional<near_number> beside_of(const value& x) {
    if (x.beside) return x.beside;
    if (x.in_x && x.in_x->beta == zero_) return near_number{x.in_x->alpha, plain_part(zero_)};
    if (x.in_x && !is_infinite_) {
      return near_number{x.in_x->alpha, {growth_, zero_, x.in_x->beta}};
    }
    if (decays(x)) return near_number{zero_, part_of(x)};
    return std::nullopt;
  }
  /// What tends to 0.
  value decaying(const part& w) { return {w, std::nullopt, near_number{zero_, w}}; }
  node_id half_of(const part& w) {
    return w.rest == zero_ ? zero_ : divide(g_, plain(w), g_.number(2));
  }
  part twice(node_id x, node_id y) {
    return plain_part(multiply(g_, g_.number(2), multiply(g_, x, y)));
  }
  /// log(c + w) - log(c) for c > 0.
  part logarithm_of_ratio(const near_number& x) {
    const node_id two = g_.number(2);
    const node_id w = plain(x.w);
    const node_id quotient = divide(g_, w, plus(multiply(g_, two, x.c), w, false));
    return plain_part(multiply(g_, two, call("atanh", {quotient})));
  }
  /// f(c + w) with f(c + w) - f(c) = 2 sign g(c + w/2) h(w/2).
  value by_half_angle(const node& n, const char* f, const char* g, const char* h, int sign) {
    const value& x = *values_[n.left];
    value result = as_it_is(call(f, {plain(x)}));
    const auto b = beside_of(x);
    if (!b) return result;
    const node_id half = half_of(b->w);
    const node_id rate = call(g, {plus(b->c, half, false)});
    const node_id swing = call(h, {half});
    const part w = rate == swing
                       ? plain_part(multiply(g_, g_.number(2), power(g_, rate, g_.number(2))))
                       : twice(rate, swing);
    const node_id at = b->c == zero_ ? (f[0] == 'c' ? one_ : zero_) : call(f, {b->c});
    result.beside = at == zero_ ? near_number{zero_, part_of(result)}
                                : near_number{at, sign < 0 ? times(g_.number(-1), w) : w};
    return result;
  }
  /// A function that is 0 at 0.
  value odd(node_id i) {
    const auto b = beside_of(*values_[f_[i].left]);
    value result = of_plain_operands(i);
    return b && b->c == zero_ ? decaying(result) : result;
  }
  [[nodiscard]] bool is_number_zero(node_id c) {
    if (const rational* const q = g_.value(c)) return *q == 0;
    return contains_zero(detail::value_at(g_, c, 64)) && is_zero(c);
  }
  value sum(const value& x, const value& y, bool minus) {
    value result = sum_as_it_is(x, y, minus);
    if (result.in_x) return result;
    const auto b = beside_of(x);
    const auto d = beside_of(y);
    if (!b || !d) return result;
    const node_id c = plus(b->c, d->c, minus);
    const part w = plus(b->w, d->w, minus);
    if (b->c != zero_ && d->c != zero_ && is_number_zero(c)) return decaying(w);
    result.beside = near_number{c, c == zero_ ? part_of(result) : w};
    return result;
  }
  std::optional<near_number> product_beside(const value& x, const value& y, const part& product) {
    const auto b = beside_of(x);
    const auto d = beside_of(y);
    if (!b || !d) return std::nullopt;
    if (b->c == zero_ || d->c == zero_) return near_number{zero_, product};
    return times(*b, *d);
  }
  near_number times(const near_number& x, const near_number& y) {
    const part linear = plus(times(x.c, y.w), times(y.c, x.w), false);
    return {multiply(g_, x.c, y.c), plus(linear, times(x.w, y.w), false)};
  }
  /// The square as (c + w)^2 - c^2 = w (2 c + w).
  near_number power_of(const near_number& x, long n) {
    if (n == 1) return x;
    if (n % 2 != 0) return times(power_of(x, n - 1), x);
    const near_number root = power_of(x, n / 2);
    const node_id sum = plus(multiply(g_, g_.number(2), root.c), plain(root.w), false);
    return {multiply(g_, root.c, root.c), times(root.w, plain_part(sum))};
  }
  std::optional<near_number> quotient_beside(const value& x, const value& y, const part& quotient) {
    const auto b = beside_of(x);
    const auto d = beside_of(y);
    if (!b || !d || d->c == zero_) return std::nullopt;
    if (b->c == zero_) return near_number{zero_, quotient};
    const part w = plus(times(d->c, b->w), times(b->c, d->w), true);
    return near_number{divide(g_, b->c, d->c), over(over(w, d->c), plain(y))};
  }
  /// x^y for a constant y.
  std::optional<near_number> power_beside(const value& x, node_id y) {
    constexpr long most_factors = 16;
    const auto b = beside_of(x);
    if (!b || b->c == zero_) return std::nullopt;
    const rational* const q = g_.value(y);
    if (q != nullptr && denominator(*q) == 1 && *q > 0 && *q <= most_factors) {
      return power_of(*b, static_cast<long>(numerator(*q)));
    }
    if (!is_positive(b->c)) return std::nullopt;
    const node_id h = multiply(g_, y, half_of(logarithm_of_ratio(*b)));
    const node_id c = power(g_, b->c, y);
    return near_number{c, times(c, twice(exp_of(h), call("sinh", {h})))};
  }
  value sum_as_it_is(const value& x, const value& y, bool minus) {
    const auto of = [&](node_id p, node_id q) {
      return minus ? subtract(g_, p, q) : add(g_, p, q);
    };
    if (x.in_x && y.in_x) {
      return linear(of(x.in_x->alpha, y.in_x->alpha), of(x.in_x->beta, y.in_x->beta));
    }
    if (x.kappa == y.kappa && x.v == y.v) {
      return {{x.kappa, x.v, of(x.rest, y.rest)}, std::nullopt};
    }
    return as_it_is(of(plain(x), plain(y)));
  }
  value product(const value& x, const value& y) {
    const auto is_constant_in_x = [&](const value& z) { return z.in_x && z.in_x->beta == zero_; };
    if (x.in_x && is_constant_in_x(y)) {
      return linear(multiply(g_, x.in_x->alpha, y.rest), times(x.in_x->beta, y.rest));
    }
    if (y.in_x && is_constant_in_x(x)) return product(y, x);
    const part result{add(g_, x.kappa, y.kappa), add(g_, x.v, y.v), multiply(g_, x.rest, y.rest)};
    return {result, std::nullopt, product_beside(x, y, result)};
  }
  value quotient(const value& x, const value& y) {
    if (x.in_x && y.in_x && y.in_x->beta == zero_) {
      return linear(divide(g_, x.in_x->alpha, y.rest),
                    x.in_x->beta == zero_ ? zero_ : divide(g_, x.in_x->beta, y.rest));
    }
    const part result{subtract(g_, x.kappa, y.kappa), subtract(g_, x.v, y.v),
                      divide(g_, x.rest, y.rest)};
    return {result, std::nullopt, quotient_beside(x, y, result)};
  }
  /// (exp(kappa s + v) rest)^y.
  value to_power(const value& x, node_id y) {
    const bool has_no_exponential = x.kappa == zero_ && x.v == zero_;
    // 1^y is left out where y is in the exponent.
    const node_id rest = x.rest == one_ && !has_no_exponential ? one_ : power(g_, x.rest, y);
    if (is_constant(y)) {
      value result = has_no_exponential ? as_it_is(rest) : scaled(x, y, rest);
      result.beside = power_beside(x, y);
      return result;
    }
    if (has_no_exponential) return as_it_is(rest);
    const auto [kappa, v] = split(multiply(g_, exponent(x), y));
    return {{kappa, v, rest}, std::nullopt};
  }
  /// The exponential that is taken out of it falls with s; at an infinite end there is none.
  [[nodiscard]] bool tends_to_0(const value& x) const {
    return growth_ != one_ && x.kappa == growth_;
  }
  /// 1 - m where m tends to 1.
  std::optional<value> complement(node_id i) {
    const auto m = beside_of(*values_[i]);
    if (!m || m->w.rest == zero_ || !is_rational(m->c, 1)) return std::nullopt;
    return decaying(times(g_.number(-1), m->w));
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
    return value{{g_.number(-power), zero_, rest}, std::nullopt};
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
  /// The complete ellipticK, ellipticE and carlsonRF towards their logarithmic ends.
  std::optional<value> complete_integral(node_id i) {
    const detail::further_call& f = f_.call_at(i);
    // A function of this name in another list may be anything.
    const further_functions& own = *library_functions();
    const auto is_called = [&](const further_function& one) { return &one == f.function; };
    if (std::ranges::none_of(own, is_called)) return std::nullopt;
    const std::string& name = f.function->what.name;
    if (name == "carlsonRF") return symmetric_integral(f.operands);
    if (f.operands.size() != 1 || (name != "ellipticK" && name != "ellipticE")) return std::nullopt;
    std::optional<value> left = rational_complement(f.operands.front());
    if (!left) left = complement(f.operands.front());
    if (!left) return std::nullopt;
    if (name == "ellipticK") return by_mean(constant(one_), *left);
    const node_id half = further("carlsonRG", {zero_, plain(*left), one_});
    return as_it_is(multiply(g_, g_.number(2), half));
  }
  /// carlsonRF(0, x, y), in any order.
  std::optional<value> symmetric_integral(const std::vector<node_id>& operands) {
    std::vector<const value*> others;
    for (const node_id k : operands) {
      if (values_[k]->rest != zero_) others.push_back(&*values_[k]);
    }
    if (others.size() != 2) return std::nullopt;
    return by_mean(*others[0], *others[1]);
  }
  /// pi/(2 agm(sqrt x, sqrt y)).
  value by_mean(const value& x, const value& y) {
    const auto root = [&](const value& z) {
      // Of a negative number an undefined value, and not none: the formula may have others.
      const bool is_negative =
          is_constant(z.rest) && certainly_negative(detail::value_at(g_, z.rest, 64));
      if (is_negative) return call("sqrt", {plain(z)});
      return plain(scaled(z, g_.number(rational(1, 2)), call("sqrt", {z.rest})));
    };
    // 1/agm as it stands: growth bounds know it better than agm.
    const node_id inverse = divide(g_, one_, call("agm", {root(x), root(y)}));
    const node_id half = g_.number(rational(1, 2));
    return as_it_is(multiply(g_, multiply(g_, half, g_.make(operation::pi)), inverse));
  }
  node_id further(std::string_view name, std::vector<node_id> x) {
    const further_functions& own = *library_functions();
    const auto f = std::ranges::find_if(own, [&](const further_function& one) {
      return one.what.name == name && one.arity == x.size();
    });
    return g_.call({&*f, std::move(x)});
  }
  value scaled(const value& x, node_id y, node_id rest) {
    return {{times(x.kappa, y), times(x.v, y), rest}, std::nullopt};
  }
  /// sin, cos and tan of alpha + w where alpha is shown to be a whole number of quarter turns.
  std::optional<value> by_quarter_turns(const node& n) {
    const auto x = beside_of(*values_[n.left]);
    if (!x || x->c == zero_) return std::nullopt;
    const node_id quarters = divide(g_, multiply(g_, g_.number(2), x->c), g_.make(operation::pi));
    const auto found = detail::rational_value_at(g_, quarters);
    if (!found || denominator(*found) != 1) return std::nullopt;
    const integer k = numerator(*found);
    const long turns = static_cast<long>(mpz_fdiv_ui(k.backend().data(), 4));
    const node_id w = plain(x->w);
    if (n.what == operation::tan) {
      const node_id tangent = call("tan", {w});
      if (turns % 2 == 0) return decaying(plain_part(tangent));
      return as_it_is(negate(g_, divide(g_, one_, tangent)));
    }
    // The quarter turns that take sin w there: cos w = sin(w + pi/2).
    const long quarter = (turns + (n.what == operation::cos ? 1 : 0)) % 4;
    const node_id function = call(quarter % 2 == 0 ? "sin" : "cos", {w});
    value result = as_it_is(quarter >= 2 ? negate(g_, function) : function);
    if (quarter % 2 == 0) return decaying(result);
    const node_id sine = power(g_, call("sin", {half_of(x->w)}), g_.number(2));
    const int sign = quarter >= 2 ? -1 : 1;
    result.beside = near_number{g_.number(sign), plain_part(times(g_.number(-2 * sign), sine))};
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
