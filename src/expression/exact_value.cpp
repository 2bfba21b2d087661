#include "exact_value.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "exact_number.hpp"

namespace polhode::detail {
namespace {

// Beyond these a formula is left to its enclosures.
constexpr node_id most_nodes = 2000;
constexpr long greatest_half_integer = 200;  // of which gamma is taken
constexpr long greatest_zeta = 40;

/// The coefficient B_n of n!, with t/(e^t - 1) = the sum of B_n t^n / n!, by
/// (n + 1) B_n = -(the sum over k < n of binomial(n + 1, k) B_k).
rational bernoulli(long n) {
  std::vector<rational> b{1};
  for (long m = 1; m <= n; ++m) {
    rational total = 0;
    rational binomial = 1;
    for (long k = 0; k < m; ++k) {
      total += binomial * b[static_cast<std::size_t>(k)];
      binomial = binomial * (m + 1 - k) / (k + 1);
    }
    b.push_back(-total / (m + 1));
  }
  return b.back();
}

class evaluation {
 public:
  /// By further rules, see exact_field.
  evaluation(const graph& g, const program& f, bool further)
      : g_(g), f_(f), used_(reachable(g)), field_(further) {
    values_.resize(g.size());
    places_.resize(g.size(), 0);
    std::size_t place = 0;
    for (node_id i = 0; i <= g.root; ++i) {
      if (used_[i] != 0 && g[i].what != operation::number) places_[i] = place++;
    }
  }

  /// Of a node by the rules, after all before it.
  std::optional<rational> at(node_id i) {
    for (; done_ <= i; ++done_) {
      if (used_[done_] == 0) continue;
      try {
        values_[done_] = by_rules(done_);
      } catch (const not_decided&) {
        values_[done_] = std::nullopt;
      }
    }
    const auto& result = values_[i];
    return result ? field_.as_rational(*result) : std::nullopt;
  }

 private:
  /// The value of an operand: by the rules, or as a number of which the enclosure is known.
  const exact_sum& of(node_id i) {
    if (values_[i]) return *values_[i];
    if (!enclosures_) enclosures_ = values_of_constants(f_, exact_field::bits);
    const ball& around = g_[i].what == operation::number
                             ? (numbers_[i] = ball(*g_.value(i), exact_field::bits))
                             : (*enclosures_)[places_[i]];
    if (!around.is_bounded()) throw not_decided();  // it may not be defined
    values_[i] = field_.opaque(i, around);
    return *values_[i];
  }

  exact_sum half_of(const exact_sum& x) { return field_.scaled(x, rational(1, 2)); }
  exact_sum one_and(const exact_sum& x) { return field_.sum(exactly(1), x); }
  exact_sum one_without(const exact_sum& x) { return field_.difference(exactly(1), x); }
  exact_sum square(const exact_sum& x) { return field_.product(x, x); }

  /// |x| where a square is x^2.
  std::optional<exact_sum> root_of_square(node_id i) {
    const node& n = g_[i];
    try {
      if (n.what == operation::power_integer && n.number % 2 == 0) {
        return field_.integer_power(field_.abs(of(n.left)), n.number / 2);
      }
      if (n.what == operation::multiply && n.left == n.right) return field_.abs(of(n.left));
    } catch (const not_decided&) {
      return std::nullopt;
    }
    return std::nullopt;
  }

  exact_sum angle(node_id i, bool times_pi) {
    return times_pi ? field_.product(of(i), field_.pi()) : of(i);
  }

  exact_sum power(const exact_sum& x, const exact_sum& y) {
    const int s = field_.sign(x);
    if (s < 0 || (s == 0 && field_.sign(y) != 1)) throw not_decided();
    if (s == 0) return {};
    if (const auto q = field_.as_rational(y)) return field_.power(x, *q);
    return field_.exp(field_.product(y, field_.log(x)));
  }

  /// {e^x, e^-x}
  std::pair<exact_sum, exact_sum> exponentials(node_id i) {
    const exact_sum x = of(i);
    return {field_.exp(x), field_.exp(field_.scaled(x, -1))};
  }

  exact_sum atan2(const exact_sum& y, const exact_sum& x) {
    const int s = field_.sign(x);
    const int t = field_.sign(y);
    if (s == 0 && t == 0) throw not_decided();
    if (s == 0) return field_.scaled(field_.pi(), rational(t, 2));
    exact_sum angle = field_.atan(field_.quotient(y, x));
    if (s > 0) return angle;
    return field_.sum(angle, field_.scaled(field_.pi(), t < 0 ? -1 : 1));
  }

  /// gamma(k + 1/2) from gamma(1/2) = sqrt(pi) and gamma(x + 1) = x gamma(x).
  exact_sum gamma(const exact_sum& x) {
    const auto q = field_.as_rational(x);
    if (!q || *q > greatest_half_integer || *q < -greatest_half_integer) throw not_decided();
    const bool is_whole = denominator(*q) == 1;
    if ((is_whole && *q <= 0) || denominator(*q) > 2) throw not_decided();
    const rational first = is_whole ? rational(1) : rational(1, 2);
    rational factor = 1;
    for (rational y = first; y < *q; y += 1) factor *= y;
    for (rational y = *q; y < first; y += 1) factor /= y;
    return field_.scaled(is_whole ? exactly(1) : field_.sqrt(field_.pi()), factor);
  }

  /// zeta(n) = (-1)^(n/2 + 1) B_n (2 pi)^n / (2 n!) for even n (L. Euler, 1735).
  exact_sum zeta(long n) {
    if (n % 2 != 0 || n > greatest_zeta) throw not_decided();
    rational factor = bernoulli(n) / 2;
    if (factor < 0) factor = -factor;
    for (long k = 1; k <= n; ++k) factor *= rational(2, k);
    return field_.scaled(field_.integer_power(field_.pi(), n), factor);
  }

  exact_sum by_rules(node_id i) {
    const node& n = g_[i];
    switch (n.what) {
      case operation::number:
        return field_.scaled(exactly(1), *g_.value(i));
      case operation::pi:
        return field_.pi();
      case operation::zeta:
        return zeta(n.number);
      case operation::negate:
        return field_.scaled(of(n.left), -1);
      case operation::power_integer:
        return field_.integer_power(of(n.left), n.number);
      case operation::root:
        return field_.root(of(n.left), n.number);
      case operation::sqrt:
        if (auto root = root_of_square(n.left)) return *std::move(root);
        return field_.sqrt(of(n.left));
      case operation::abs:
        return field_.abs(of(n.left));
      case operation::floor:
        return field_.floor(of(n.left));
      case operation::ceil:
        return field_.scaled(field_.floor(field_.scaled(of(n.left), -1)), -1);
      case operation::exp:
        return field_.exp(of(n.left));
      case operation::expm1:
        return field_.difference(field_.exp(of(n.left)), exactly(1));
      case operation::log:
        return field_.log(of(n.left));
      case operation::log1p:
        return field_.log(one_and(of(n.left)));
      case operation::cos:
      case operation::cospi:
        return field_.cos_and_sin(angle(n.left, n.what == operation::cospi)).first;
      case operation::sin:
      case operation::sinpi:
        return field_.cos_and_sin(angle(n.left, n.what == operation::sinpi)).second;
      case operation::tan: {
        const auto [c, s] = field_.cos_and_sin(of(n.left));
        return field_.quotient(s, c);
      }
      case operation::asin:
        return field_.asin(of(n.left));
      case operation::acos:
        return field_.acos(of(n.left));
      case operation::atan:
        return field_.atan(of(n.left));
      case operation::sinh: {
        const auto [e, r] = exponentials(n.left);
        return half_of(field_.difference(e, r));
      }
      case operation::cosh: {
        const auto [e, r] = exponentials(n.left);
        return half_of(field_.sum(e, r));
      }
      case operation::tanh: {
        const auto [e, r] = exponentials(n.left);
        return field_.quotient(field_.difference(e, r), field_.sum(e, r));
      }
      case operation::asinh: {
        const exact_sum x = of(n.left);
        return field_.log(field_.sum(x, field_.sqrt(one_and(square(x)))));
      }
      case operation::acosh: {
        const exact_sum x = of(n.left);
        if (field_.sign(field_.difference(x, exactly(1))) < 0) throw not_decided();
        return field_.log(field_.sum(x, field_.sqrt(field_.difference(square(x), exactly(1)))));
      }
      case operation::atanh: {
        const exact_sum x = of(n.left);
        if (field_.sign(one_without(x)) != 1) throw not_decided();
        return half_of(field_.log(field_.quotient(one_and(x), one_without(x))));
      }
      case operation::gamma:
        return gamma(of(n.left));
      case operation::add:
        return field_.sum(of(n.left), of(n.right));
      case operation::subtract:
        return field_.difference(of(n.left), of(n.right));
      case operation::multiply:
        return field_.product(of(n.left), of(n.right));
      case operation::divide:
        return field_.quotient(of(n.left), of(n.right));
      case operation::power:
        return power(of(n.left), of(n.right));
      case operation::min:
      case operation::max: {
        const int s = field_.sign(field_.difference(of(n.left), of(n.right)));
        return (s < 0) == (n.what == operation::min) ? of(n.left) : of(n.right);
      }
      case operation::hypot:
        return field_.sqrt(field_.sum(square(of(n.left)), square(of(n.right))));
      case operation::atan2:
        return atan2(of(n.left), of(n.right));
      case operation::agm:
        if (of(n.left) != of(n.right) || field_.sign(of(n.left)) < 0) throw not_decided();
        return of(n.left);
      default:
        throw not_decided();
    }
  }

  const graph& g_;
  const program& f_;
  std::vector<char> used_;
  exact_field field_;
  std::vector<std::optional<exact_sum>> values_;
  node_id done_ = 0;                 // the first node that is not evaluated
  std::vector<std::size_t> places_;  // among the instructions without variables
  std::map<node_id, ball> numbers_;  // those that are too long for the rules
  std::optional<std::vector<ball>> enclosures_;
};

}  // namespace

std::optional<rational> rational_value(const graph& g, const program& f) {
  if (const rational* q = g.value(g.root)) return *q;
  if (g.root >= most_nodes || varying(g)[g.root] != 0) return std::nullopt;
  // The further rules take their own budget: where they reach its end, nothing is lost that the
  // others decide.
  for (const bool further : {false, true}) {
    try {
      if (auto q = evaluation(g, f, further).at(g.root)) return q;
    } catch (const not_decided&) {
      continue;
    }
  }
  return std::nullopt;
}

std::optional<rational> rational_value_at(const graph& g, node_id i) {
  if (const rational* q = g.value(i)) return *q;
  graph alone = g;
  alone.root = i;
  return rational_value(alone, compile(alone, 0));
}

ball value_at(const graph& g, node_id i, precision p) {
  if (const rational* q = g.value(i)) return ball(*q, p);
  graph alone = g;
  alone.root = i;
  return values_of_constants(compile(alone, 0), p).back();  // the root's
}

ball value_far_out(graph& g, node_id i) {
  constexpr precision few = 64;
  ball value = ball::undefined(few);
  for (const long x : {1L << 20, 1L << 10, 1L << 5}) {
    const node_id far = g.number(rational(x));
    std::vector<node_id> at(i + 1);
    for (node_id k = 0; k <= i; ++k) {
      if (g[k].what == operation::variable) {
        at[k] = far;
      } else if (operands_at(g, k).empty()) {
        at[k] = k;
      } else {
        at[k] = with_operands(g, g, k, [&](node_id of) { return at[of]; });
      }
    }
    value = value_at(g, at[i], few);
    if (value.is_bounded()) break;
  }
  return value;
}

}  // namespace polhode::detail
