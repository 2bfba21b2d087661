#include "waves.hpp"
#include "quadrature/formula/recorded.hpp"

#include <algorithm>
#include <utility>

namespace polhode::detail::oscillations {

namespace {

/// q times a constant of the recording; q alone where there is none.
struct coefficient {
  rational q = 1;
  std::optional<recorded> node;
};

/// About how long the numerator and the denominator are.
std::size_t bits_of(const rational& q) {
  return mpz_sizeinbase(numerator(q).backend().data(), 2) +
         mpz_sizeinbase(denominator(q).backend().data(), 2);
}
/// Longer numbers are not followed: nested powers would make them as long as they like.
constexpr std::size_t most_exact_bits = 4096;

/// The sum of c_e y^e, without zeros.
using power_sum = std::map<rational, coefficient>;

/// The sum of amplitudes times e^(i w y). Real for real y: the amplitudes of w and -w are
/// conjugate.
struct wave {
  std::map<frequency, amplitude> terms;
  /// Where there is no oscillation, and it is known.
  std::optional<power_sum> powers;

  /// Only the frequency without terms, which is 0.
  [[nodiscard]] bool is_steady() const {
    return terms.empty() || (terms.size() == 1 && terms.begin()->first.empty());
  }
};

std::optional<recorded> sum_of(const std::optional<recorded>& x, const std::optional<recorded>& y) {
  if (!x || !y) return x ? x : y;
  return *x + *y;
}
std::optional<recorded> negative(const std::optional<recorded>& x) {
  return x ? std::optional(-*x) : std::nullopt;
}
std::optional<recorded> product(const std::optional<recorded>& x,
                                const std::optional<recorded>& y) {
  return x && y ? std::optional(*x * *y) : std::nullopt;
}
amplitude operator+(const amplitude& x, const amplitude& y) {
  return {sum_of(x.re, y.re), sum_of(x.im, y.im)};
}
amplitude operator*(const amplitude& x, const amplitude& y) {
  return {sum_of(product(x.re, y.re), negative(product(x.im, y.im))),
          sum_of(product(x.re, y.im), product(x.im, y.re))};
}
amplitude conjugate(const amplitude& x) { return {x.re, negative(x.im)}; }

frequency sum_of(frequency x, const frequency& y) {
  for (const auto& [node, q] : y) {
    rational& sum = x[node];
    sum += q;
    if (sum == 0) x.erase(node);
  }
  return x;
}
frequency negative(frequency x) {
  for (auto& [node, q] : x) q = -q;
  return x;
}

/// The waves of f's nodes, one after the other.
class separation {
 public:
  separation(const formula& f, precision p, const end_point& at, const end_point& s,
             const rational& theta, int sign)
      : nodes_(f.at(p)), f_(f), bits_(p), y_(recorded::argument()) {
    const coefficient start = constant(at, p);
    const coefficient distance = constant(s, p);
    x_.powers = power_sum{{theta, distance}};
    if (start.q != 0) x_.powers->emplace(rational(0), start);
    x_.terms[{}].re = value(*x_.powers);
    const rational size = sign * abs(theta);
    const coefficient scale{distance.q * size, distance.node};
    factor_ = value({{rational(theta - 1), scale}});
  }

  [[nodiscard]] separated result() {
    separated result{y_, terms(), std::nullopt};
    result.growth = growth_;
    return result;
  }

 private:
  /// Nothing where f is not a sum of oscillations.
  [[nodiscard]] std::optional<std::map<frequency, amplitude>> terms() {
    std::vector<std::optional<wave>> waves(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!f_.needs(i)) continue;
      waves[i] = of_node(nodes_[i], waves);
      if (!waves[i]) return std::nullopt;
    }
    std::map<frequency, amplitude> result;
    for (const auto& [w, a] : waves[f_.result()]->terms) {
      result[w] = amplitude{factor_, std::nullopt} * a;
    }
    return result;
  }
  [[nodiscard]] coefficient constant(const end_point& x, precision p) const {
    if (x.exact()) return {*x.exact(), std::nullopt};
    return {1, y_.constant_like(x.at(p))};
  }
  [[nodiscard]] recorded value(const coefficient& c) const {
    if (!c.node) return y_.constant_like(c.q);
    return c.q == 1 ? *c.node : *c.node * c.q;
  }
  [[nodiscard]] recorded value(const power_sum& x) const {
    std::optional<recorded> sum;
    for (const auto& [e, c] : x) {
      if (e == 0) {
        sum = sum_of(sum, value(c));
        continue;
      }
      const recorded power = e == 1 ? y_ : pow(y_, e);
      sum = sum_of(sum, !c.node && c.q == 1 ? power : power * value(c));
    }
    return sum ? *sum : y_.constant_like(0);
  }
  /// Of a steady one.
  [[nodiscard]] recorded value(const wave& x) const {
    if (x.terms.empty() || !x.terms.begin()->second.re) return y_.constant_like(0);
    return *x.terms.begin()->second.re;
  }

  [[nodiscard]] wave steady(recorded value, std::optional<power_sum> powers = {}) const {
    wave result;
    if (!powers || !powers->empty()) result.terms[{}].re = std::move(value);
    result.powers = std::move(powers);
    return result;
  }
  [[nodiscard]] static bool is_constant(const wave& x) {
    return x.powers && std::all_of(x.powers->begin(), x.powers->end(),
                                   [](const auto& term) { return term.first == 0; });
  }

  static coefficient times(const coefficient& x, const coefficient& y) {
    coefficient result{x.q * y.q, x.node};
    if (y.node) result.node = x.node ? *x.node * *y.node : *y.node;
    return result;
  }
  void add(power_sum& sum, const rational& e, const coefficient& c) const {
    const auto [place, is_new] = sum.emplace(e, c);
    if (is_new) return;
    coefficient& known = place->second;
    const bool same = known.node.has_value() == c.node.has_value() &&
                      (!c.node || known.node->node() == c.node->node());
    if (same) {
      known.q += c.q;
      if (known.q == 0) sum.erase(place);
    } else {
      known = {1, value(known) + value(c)};
    }
  }
  [[nodiscard]] std::optional<power_sum> sum_of_powers(const wave& x, const wave& y) const {
    if (!x.powers || !y.powers) return std::nullopt;
    power_sum sum = *x.powers;
    for (const auto& [e, c] : *y.powers) add(sum, e, c);
    return unless_long(std::move(sum));
  }
  [[nodiscard]] std::optional<power_sum> product_of_powers(const wave& x, const wave& y) const {
    constexpr std::size_t most_terms = 16;
    if (!x.powers || !y.powers || x.powers->size() * y.powers->size() > most_terms) {
      return std::nullopt;
    }
    power_sum sum;
    for (const auto& [e, c] : *x.powers) {
      for (const auto& [g, d] : *y.powers) add(sum, e + g, times(c, d));
    }
    return unless_long(std::move(sum));
  }
  [[nodiscard]] static std::optional<power_sum> unless_long(power_sum x) {
    const bool is_long = std::any_of(x.begin(), x.end(), [](const auto& term) {
      return bits_of(term.first) + bits_of(term.second.q) > most_exact_bits;
    });
    return is_long ? std::nullopt : std::optional(std::move(x));
  }
  /// One power to the e. Of a negative number only a whole one is taken, and of a constant that is
  /// not a rational number none.
  [[nodiscard]] std::optional<power_sum> power_of_powers(const wave& x, const rational& e) const {
    if (!x.powers || x.powers->size() != 1) return std::nullopt;
    const auto& [g, c] = *x.powers->begin();
    if (16 * (bits_of(c.q) + bits_of(e) + bits_of(g)) > most_exact_bits) return std::nullopt;
    coefficient result = c;
    if (c.node) {
      if (e == -1) {
        result = {1 / c.q, 1 / *c.node};
      } else if (e != 1) {
        return std::nullopt;
      }
    } else if (c.q != 1) {
      if (denominator(e) != 1 || abs(numerator(e)) > 16) {
        if (c.q <= 0) return std::nullopt;
        result = {1, pow(y_.constant_like(c.q), e)};
      } else {
        const auto n = static_cast<long>(numerator(e));
        result.q = 1;
        for (long k = 0; k < std::abs(n); ++k) result.q *= c.q;
        if (n < 0) result.q = 1 / result.q;
      }
    }
    return power_sum{{rational(g * e), result}};
  }

  [[nodiscard]] wave negated(const wave& x) const {
    wave result;
    for (const auto& [w, a] : x.terms) result.terms[w] = {negative(a.re), negative(a.im)};
    if (x.powers) {
      result.powers = *x.powers;
      for (auto& [e, c] : *result.powers) c.q = -c.q;
    }
    return result;
  }
  [[nodiscard]] std::optional<wave> sum(const wave& x, const wave& y) const {
    if (x.is_steady() && y.is_steady()) {
      return steady(value(x) + value(y), sum_of_powers(x, y));
    }
    wave result;
    result.terms = x.terms;
    for (const auto& [w, a] : y.terms) result.terms[w] = result.terms[w] + a;
    return limited(std::move(result));
  }
  [[nodiscard]] std::optional<wave> times(const wave& x, const wave& y) const {
    if (x.is_steady() && y.is_steady()) {
      return steady(value(x) * value(y), product_of_powers(x, y));
    }
    wave result;
    for (const auto& [w, a] : x.terms) {
      for (const auto& [v, b] : y.terms) {
        amplitude& at = result.terms[sum_of(w, v)];
        at = at + a * b;
      }
    }
    return limited(std::move(result));
  }
  [[nodiscard]] static std::optional<wave> limited(wave x) {
    constexpr std::size_t most_terms = 64;
    if (x.terms.size() > most_terms) return std::nullopt;
    return x;
  }
  [[nodiscard]] std::optional<wave> quotient(const wave& x, const wave& y) const {
    if (!y.is_steady()) return std::nullopt;
    if (x.is_steady()) {
      wave inverse;
      inverse.powers = power_of_powers(y, -1);
      return steady(value(x) / value(y), product_of_powers(x, inverse));
    }
    return times(x, steady(1 / value(y)));
  }
  [[nodiscard]] std::optional<wave> power(const wave& x, const rational& e) const {
    if (x.is_steady()) return steady(pow(value(x), e), power_of_powers(x, e));
    constexpr long most = 16;
    if (denominator(e) != 1 || e < 1 || e > most) return std::nullopt;
    wave result = x;
    for (long k = 1; k < static_cast<long>(numerator(e)); ++k) {
      std::optional<wave> next = times(result, x);
      if (!next) return std::nullopt;
      result = *std::move(next);
    }
    return result;
  }

  /// sin or cos. e^(iR)/(2i) = (sin R - i cos R)/2, e^(iR)/2 = (cos R + i sin R)/2.
  [[nodiscard]] std::optional<wave> circular(const wave& x, bool sine) {
    if (!x.is_steady()) return std::nullopt;
    const auto grows = [](const auto& term) { return term.first > 0; };
    if (!x.powers || std::none_of(x.powers->begin(), x.powers->end(), grows)) {
      const recorded v = value(x);
      return steady(sine ? sin(v) : cos(v));
    }
    if (x.powers->rbegin()->first != 1) {
      growth_ = x.powers->rbegin()->first;
      return std::nullopt;
    }
    power_sum rest = *x.powers;
    const coefficient w = rest.rbegin()->second;
    rest.erase(std::prev(rest.end()));
    if (std::any_of(rest.begin(), rest.end(), grows)) return std::nullopt;
    amplitude a;
    const rational half(1, 2);
    const recorded r = value(rest);
    const recorded cosine = rest.empty() ? y_.constant_like(half) : cos(r) * half;
    const std::optional<recorded> sine_of_rest =
        rest.empty() ? std::nullopt : std::optional(sin(r) * half);
    a.re = sine ? sine_of_rest : cosine;
    a.im = sine ? -cosine : sine_of_rest;
    wave result;
    const frequency key{{w.node ? w.node->node() : 0, w.q}};
    result.terms[key] = a;
    result.terms[negative(key)] = conjugate(a);
    return result;
  }
  /// Of pi x. Its node is made once, so that frequencies are known to be the same.
  [[nodiscard]] std::optional<wave> circular_of_pi(const wave& x, bool sine) {
    if (!pi_) pi_ = y_.constant_like(pi(bits_));
    wave factor;
    factor.terms[{}].re = pi_;
    factor.powers = power_sum{{rational(0), coefficient{1, pi_}}};
    const std::optional<wave> product = times(x, factor);
    return product ? circular(*product, sine) : product;
  }

  std::optional<wave> of_node(const recorded_node& node,
                              const std::vector<std::optional<wave>>& waves) {
    using kind = recorded_node::kind;
    if (node.what == kind::argument) return x_;
    if (node.what == kind::constant) return of_constant(node);
    if (node.is_piecewise()) return std::nullopt;
    const wave& x = *waves[node.left];
    if (node.what == kind::power) return power(x, *node.exact);
    return of_function(node, x, *waves[node.right]);
  }
  [[nodiscard]] wave of_constant(const recorded_node& node) const {
    const coefficient c = node.exact ? coefficient{*node.exact, std::nullopt}
                                     : coefficient{1, y_.constant_like(node.enclosure)};
    power_sum powers;
    if (c.q != 0) powers.emplace(rational(0), c);
    return steady(value(c), powers);
  }
  [[nodiscard]] std::optional<wave> of_function(const recorded_node& node, const wave& x,
                                                const wave& y) {
    switch (node.operation.rule) {
      case recorded_rule::negative:
        return negated(x);
      case recorded_rule::sum:
        return sum(x, y);
      case recorded_rule::difference:
        return sum(x, negated(y));
      case recorded_rule::product:
        return times(x, y);
      case recorded_rule::quotient:
        return quotient(x, y);
      case recorded_rule::square:
        return power(x, 2);
      case recorded_rule::sqrt:
        if (!x.is_steady()) return std::nullopt;
        return steady(sqrt(value(x)), power_of_powers(x, rational(1, 2)));
      case recorded_rule::root:
        // Of a positive number the power. That it is positive from Y0 on is proved where the power
        // is bounded: powers of negative numbers have no series, and lie on a cut.
        if (!is_constant(x)) return power(x, rational(1, node.number));
        break;
      case recorded_rule::power: {
        const recorded_node& exponent = nodes_[node.right];
        const bool is_exact = exponent.what == recorded_node::kind::constant && exponent.exact;
        if (!is_constant(x) && is_exact) return power(x, *exponent.exact);
        break;
      }
      case recorded_rule::sin:
      case recorded_rule::cos:
        if (!is_constant(x)) return circular(x, node.operation.rule == recorded_rule::sin);
        break;
      case recorded_rule::sinpi:
      case recorded_rule::cospi:
        if (!is_constant(x)) return circular_of_pi(x, node.operation.rule == recorded_rule::sinpi);
        break;
      default:
        break;
    }
    return of_steady_function(node, x, y);
  }
  /// Of a function that leaves no oscillation as one.
  [[nodiscard]] std::optional<wave> of_steady_function(const recorded_node& node, const wave& x,
                                                       const wave& y) const {
    if (!x.is_steady() || !y.is_steady()) return std::nullopt;
    const bool is_known = is_constant(x) && is_constant(y);
    if (node.operation.on_complex == nullptr && !is_known) return std::nullopt;
    recorded v = value(x).applied(node.operation, value(y), node.number);
    if (!is_known) return steady(v);
    // A number, also where the function is one of real numbers only.
    if (node.operation.on_complex == nullptr) v = y_.constant_like(constant_value(v));
    return steady(v, power_sum{{rational(0), coefficient{1, v}}});
  }

  /// Of a node that does not depend on y.
  [[nodiscard]] ball constant_value(const recorded& x) const {
    return *program_of_parts(y_, x.node())(ball(1, bits_)).front();
  }

  const recorded_nodes& nodes_;
  const formula& f_;
  precision bits_;
  recorded y_;
  wave x_;
  std::optional<recorded> factor_;
  std::optional<recorded> pi_;
  std::optional<rational> growth_;
};

}  // namespace

separated separate(const formula& f, precision p, const end_point& at, const end_point& s,
                   const rational& theta, int sign) {
  return separation(f, p, at, s, theta, sign).result();
}

}  // namespace polhode::detail::oscillations
