#include "exponential_sum.hpp"

#include <algorithm>

#include "exact_value.hpp"

namespace polhode::detail {

// ---------------------------------------------------------------------------------------------
// Complex numbers as pairs of nodes

node_id complex_nodes::sum(node_id x, node_id y) { return detail::add(g_, x, y); }
node_id complex_nodes::difference(node_id x, node_id y) {
  if (x == y) return zero_;
  return x == zero_ ? minus(y) : subtract(g_, x, y);
}
node_id complex_nodes::product(node_id x, node_id y) {
  return x == zero_ || y == zero_ ? zero_ : detail::multiply(g_, x, y);
}
node_id complex_nodes::minus(node_id x) { return detail::negate(g_, x); }
node_id complex_nodes::call(const char* function, node_id x) {
  return find_function(function)->build(g_, {x});
}

complex_node complex_nodes::add(const complex_node& x, const complex_node& y) {
  return {sum(x.re, y.re), sum(x.im, y.im)};
}
complex_node complex_nodes::negate(const complex_node& x) { return {minus(x.re), minus(x.im)}; }
complex_node complex_nodes::conjugate(const complex_node& x) { return {x.re, minus(x.im)}; }
complex_node complex_nodes::multiply(const complex_node& x, const complex_node& y) {
  return {difference(product(x.re, y.re), product(x.im, y.im)),
          sum(product(x.re, y.im), product(x.im, y.re))};
}
complex_node complex_nodes::divide(const complex_node& x, const complex_node& y) {
  const auto over = [&](const complex_node& z, node_id d) -> complex_node {
    return {z.re == zero_ ? zero_ : detail::divide(g_, z.re, d),
            z.im == zero_ ? zero_ : detail::divide(g_, z.im, d)};
  };
  if (is_real(y)) return over(x, y.re);
  return over(multiply(x, conjugate(y)), sum(product(y.re, y.re), product(y.im, y.im)));
}
complex_node complex_nodes::power(const complex_node& x, long n) {
  if (n < 0) return divide(number(1), power(x, -n));
  if (is_real(x)) return real(detail::power(g_, x.re, g_.number(n)));
  complex_node result = number(1);
  for (complex_node square = x; n > 0; n /= 2) {
    if (n % 2 == 1) result = multiply(result, square);
    if (n > 1) square = multiply(square, square);
  }
  return result;
}

// ---------------------------------------------------------------------------------------------
// Polynomials

namespace exponential_sum_impl {
namespace {

constexpr long greatest_degree = 64;
constexpr std::size_t most_terms = 256;

/// x^lowest (c_0 + c_1 x + ...).
struct polynomial {
  long lowest = 0;
  std::vector<node_id> c;
};
using maybe_polynomial = std::optional<polynomial>;

/// Polynomials in the variable whose coefficients are nodes without it, in 1/x, too, if wanted.
class polynomial_nodes {
 public:
  explicit polynomial_nodes(graph& g, bool with_inverses = false)
      : g_(g), zero_(g.number(0)), with_inverses_(with_inverses) {}

  maybe_polynomial of(node_id i) {
    const auto known = known_.find(i);
    if (known != known_.end()) return known->second;
    maybe_polynomial found = made(i);
    known_.emplace(i, found);
    return found;
  }
  /// The coefficients of 1, x, x^2, ... of one without 1/x.
  std::optional<std::vector<node_id>> coefficients_of(node_id i) {
    const maybe_polynomial found = of(i);
    if (!found) return std::nullopt;
    std::vector<node_id> result(static_cast<std::size_t>(found->lowest), zero_);
    result.insert(result.end(), found->c.begin(), found->c.end());
    return result;
  }
  /// What coefficients were divided by.
  [[nodiscard]] const std::vector<node_id>& divisors() const { return divisors_; }
  [[nodiscard]] bool is_constant(node_id i) {
    while (varies_.size() < g_.size()) {
      const auto k = static_cast<node_id>(varies_.size());
      bool any = g_[k].what == operation::variable;
      for (const node_id x : operands_at(g_, k)) any = any || varies_[x] != 0;
      varies_.push_back(static_cast<char>(any));
    }
    return varies_[i] == 0;
  }

 private:
  maybe_polynomial made(node_id i) {
    if (is_constant(i)) return trimmed(0, {i});
    const node n = g_[i];
    const auto of_two = [&](const auto& f) -> maybe_polynomial {
      const maybe_polynomial x = of(n.left);
      const maybe_polynomial y = x ? of(n.right) : std::nullopt;
      return y ? f(*x, *y) : std::nullopt;
    };
    switch (n.what) {
      case operation::variable:
        return polynomial{1, {g_.number(1)}};
      case operation::negate: {
        maybe_polynomial x = of(n.left);
        if (x) std::ranges::for_each(x->c, [&](node_id& c) { c = negate(g_, c); });
        return x;
      }
      case operation::add:
        return of_two([&](const auto& x, const auto& y) { return sum(x, y, false); });
      case operation::subtract:
        return of_two([&](const auto& x, const auto& y) { return sum(x, y, true); });
      case operation::multiply:
        return of_two([&](const auto& x, const auto& y) { return product(x, y); });
      case operation::divide:
        if (is_constant(n.right)) {
          const maybe_polynomial x = of(n.left);
          return x ? over(*x, n.right, 0) : x;
        }
        return of_two([&](const auto& x, const auto& y) { return quotient(x, y); });
      case operation::power_integer: {
        const maybe_polynomial x = of(n.left);
        const long size = std::abs(n.number);
        if (!x || size > greatest_degree || (n.number < 1 && !with_inverses_)) return std::nullopt;
        maybe_polynomial result = polynomial{0, {g_.number(1)}};
        for (long k = 0; k < size && result; ++k) {
          result = n.number > 0 ? product(*result, *x) : quotient(*result, *x);
        }
        return result;
      }
      default:
        return std::nullopt;
    }
  }
  maybe_polynomial sum(const polynomial& x, const polynomial& y, bool minus) {
    if (y.c.empty()) return x;
    const long lowest = x.c.empty() ? y.lowest : std::min(x.lowest, y.lowest);
    const auto end_of = [](const polynomial& p) {
      return p.lowest + static_cast<long>(p.c.size());
    };
    const long end = x.c.empty() ? end_of(y) : std::max(end_of(x), end_of(y));
    if (end - lowest > 2 * greatest_degree + 1) return std::nullopt;
    const auto at = [&](const polynomial& p, long n) {
      return n < p.lowest || n >= end_of(p) ? zero_ : p.c[static_cast<std::size_t>(n - p.lowest)];
    };
    std::vector<node_id> result;
    complex_nodes reals(g_);
    for (long n = lowest; n < end; ++n) {
      const node_id p = at(x, n);
      const node_id q = at(y, n);
      result.push_back(minus ? reals.difference(p, q) : reals.sum(p, q));
    }
    return trimmed(lowest, std::move(result));
  }
  maybe_polynomial product(const polynomial& x, const polynomial& y) {
    if (x.c.empty() || y.c.empty()) return polynomial{};
    const long lowest = x.lowest + y.lowest;
    const auto size = static_cast<long>(x.c.size() + y.c.size() - 1);
    if (lowest < -greatest_degree || lowest + size - 1 > greatest_degree) return std::nullopt;
    std::vector<node_id> result(static_cast<std::size_t>(size), zero_);
    complex_nodes reals(g_);
    for (std::size_t j = 0; j < x.c.size(); ++j) {
      for (std::size_t k = 0; k < y.c.size(); ++k) {
        result[j + k] = reals.sum(result[j + k], reals.product(x.c[j], y.c[k]));
      }
    }
    return trimmed(lowest, std::move(result));
  }
  /// x over c x^n.
  maybe_polynomial over(polynomial x, node_id c, long n) {
    divisors_.push_back(c);
    for (node_id& above : x.c) {
      if (above != zero_) above = divide(g_, above, c);
    }
    x.lowest -= n;
    if (x.lowest < -greatest_degree) return std::nullopt;
    return x;
  }
  maybe_polynomial quotient(const polynomial& x, const polynomial& y) {
    if (!with_inverses_ || y.c.size() != 1) return std::nullopt;
    return over(x, y.c.front(), y.lowest);
  }
  polynomial trimmed(long lowest, std::vector<node_id> c) const {
    while (!c.empty() && c.back() == zero_) c.pop_back();
    const auto first = std::ranges::find_if(c, [&](node_id n) { return n != zero_; });
    lowest += first - c.begin();
    c.erase(c.begin(), first);
    if (c.empty()) lowest = 0;
    return {lowest, std::move(c)};
  }

  graph& g_;
  node_id zero_;
  bool with_inverses_;
  std::map<node_id, maybe_polynomial> known_;
  std::vector<node_id> divisors_;
  std::vector<char> varies_;
};

// ---------------------------------------------------------------------------------------------
// Exponentials

bool is_circular(operation what) {
  return what == operation::sin || what == operation::cos || what == operation::sinpi ||
         what == operation::cospi;
}
/// An exponential, or a function made of them.
bool is_wave(operation what) {
  return is_circular(what) || what == operation::exp || what == operation::expm1 ||
         what == operation::sinh || what == operation::cosh;
}

// ---------------------------------------------------------------------------------------------
// Sums of exponentials

using maybe_terms = std::optional<exponential_terms>;

class decomposition {
 public:
  decomposition(graph& g, bool allows_logarithms)
      : g_(g), nodes_(g), polynomials_(g), allows_logarithms_(allows_logarithms) {}

  maybe_terms root() {
    const std::vector<char> used = reachable(g_);
    const node_id end = g_.root + 1;  // the graph grows
    for (node_id i = 0; i < end; ++i) {
      if (used[i] == 0) continue;
      maybe_terms found = made(i);
      if (!found || found->size() > most_terms) return std::nullopt;
      known_.emplace(i, std::move(*found));
    }
    return known_.at(g_.root);
  }

 private:
  static exponential_terms steady(const complex_node& amplitude) { return {{{}, amplitude}}; }
  /// The node of a sum without exponentials.
  std::optional<node_id> steady_node(const exponential_terms& x) {
    if (x.empty()) return g_.number(0);
    if (x.size() > 1 || !x.begin()->first.is_zero()) return std::nullopt;
    return x.begin()->second.re;
  }

  maybe_terms made(node_id i) {
    const node n = g_[i];
    if (n.what == operation::variable || polynomials_.is_constant(i)) {
      return steady(nodes_.real(i));
    }
    if (n.what == operation::further) return of_steady_operands(i);
    if (!is_wave(n.what)) {
      if (maybe_terms found = of_steady_operands(i)) return found;
    }
    const exponential_terms& x = known_.at(n.left);
    switch (n.what) {
      case operation::negate:
        return scaled(x, nodes_.number(-1));
      case operation::add:
        return sum(x, known_.at(n.right));
      case operation::subtract:
        return sum(x, scaled(known_.at(n.right), nodes_.number(-1)));
      case operation::multiply:
        return product(x, known_.at(n.right));
      case operation::divide: {
        const auto divisor = steady_node(known_.at(n.right));
        if (!divisor) return std::nullopt;
        return scaled(x, nodes_.real(divide(g_, g_.number(1), *divisor)));
      }
      case operation::power_integer: {
        if (const auto base = steady_node(x)) {
          return steady(nodes_.real(power(g_, *base, g_.number(n.number))));
        }
        constexpr long most = 24;
        if (n.number < 1 || n.number > most) return std::nullopt;
        maybe_terms result = x;
        for (long k = 1; k < n.number && result; ++k) result = product(*result, x);
        return result;
      }
      case operation::exp:
        return exponential(x, 1, 0);
      case operation::expm1: {
        const maybe_terms found = exponential(x, 1, 0);
        return found ? sum(*found, steady(nodes_.number(-1))) : std::nullopt;
      }
      case operation::cosh:
        return half_sum(exponential(x, 1, 0), exponential(x, -1, 0), 1);
      case operation::sinh:
        return half_sum(exponential(x, 1, 0), exponential(x, -1, 0), -1);
      case operation::cos:
        return exponential(x, 0, 1);
      case operation::sin: {
        const maybe_terms found = exponential(x, 0, 1);
        return found ? scaled(*found, nodes_.negate(unit())) : found;
      }
      case operation::cospi:
        return exponential(x, 0, 1, g_.make(operation::pi));
      case operation::sinpi: {
        const maybe_terms found = exponential(x, 0, 1, g_.make(operation::pi));
        return found ? scaled(*found, nodes_.negate(unit())) : found;
      }
      default:
        return of_steady_operands(i);
    }
  }
  /// What is made of steady operands is steady.
  maybe_terms of_steady_operands(node_id i) {
    for (const node_id k : operands_at(g_, i)) {
      const auto operand = steady_node(known_.at(k));
      if (!operand || *operand != k) return std::nullopt;
    }
    return steady(nodes_.real(i));
  }

  [[nodiscard]] complex_node unit() { return {g_.number(0), g_.number(1)}; }

  maybe_terms sum(exponential_terms x, const exponential_terms& y) {
    for (const auto& [e, c] : y) {
      const auto [place, is_new] = x.emplace(e, c);
      if (!is_new) place->second = nodes_.add(place->second, c);
      if (nodes_.is_zero(place->second)) x.erase(place);
    }
    if (x.size() > most_terms) return std::nullopt;
    return x;
  }
  exponential_terms scaled(exponential_terms x, const complex_node& by) {
    for (auto& [e, c] : x) c = nodes_.multiply(c, by);
    return x;
  }
  maybe_terms half_sum(const maybe_terms& x, const maybe_terms& y, long sign) {
    if (!x || !y) return std::nullopt;
    return sum(scaled(*x, nodes_.number(rational(1, 2))),
               scaled(*y, nodes_.number(rational(sign, 2))));
  }
  exponent sum_of(const exponent& x, const exponent& y, bool conjugate) {
    return {sum_of(x.powers, y.powers, conjugate), sum_of(x.logarithmic, y.logarithmic, conjugate)};
  }
  std::vector<complex_node> sum_of(const std::vector<complex_node>& x,
                                   const std::vector<complex_node>& y, bool conjugate) {
    std::vector<complex_node> result(std::max(x.size(), y.size()), nodes_.number(0));
    for (std::size_t k = 0; k < x.size(); ++k) result[k] = x[k];
    for (std::size_t k = 0; k < y.size(); ++k) {
      result[k] = nodes_.add(result[k], conjugate ? nodes_.conjugate(y[k]) : y[k]);
    }
    while (!result.empty() && nodes_.is_zero(result.back())) result.pop_back();
    return result;
  }
  /// Re p Re q = Re (p q + p conj(q)) / 2; p q where one of the two is real.
  maybe_terms product(const exponential_terms& x, const exponential_terms& y) {
    maybe_terms result = exponential_terms{};
    const complex_node half = nodes_.number(rational(1, 2));
    for (const auto& [e, c] : x) {
      for (const auto& [f, d] : y) {
        if (is_real(e, c) || is_real(f, d)) {
          result = sum(std::move(*result), {{sum_of(e, f, false), nodes_.multiply(c, d)}});
        } else {
          const complex_node p = nodes_.multiply(c, half);
          result = sum(std::move(*result), {{sum_of(e, f, false), nodes_.multiply(p, d)}});
          if (!result) return result;
          const complex_node q = nodes_.multiply(p, nodes_.conjugate(d));
          result = sum(std::move(*result), {{sum_of(e, f, true), q}});
        }
        if (!result) return result;
      }
    }
    return result;
  }
  [[nodiscard]] bool is_real(const exponent& e, const complex_node& c) const {
    const auto has_real_parts_only = [&](const std::vector<complex_node>& x) {
      return std::ranges::all_of(x, [&](const complex_node& z) { return nodes_.is_real(z); });
    };
    return nodes_.is_real(c) && has_real_parts_only(e.powers) && has_real_parts_only(e.logarithmic);
  }

  /// u + v log x, for x > 0.
  struct parts_by_logarithm {
    node_id u;
    node_id v;
  };
  using maybe_parts = std::optional<parts_by_logarithm>;
  maybe_parts by_logarithm(node_id i) {
    const auto known = by_logarithm_.find(i);
    if (known != by_logarithm_.end()) return known->second;
    const maybe_parts found = made_by_logarithm(i);
    by_logarithm_.emplace(i, found);
    return found;
  }
  maybe_parts made_by_logarithm(node_id i) {
    const node_id zero = g_.number(0);
    const node n = g_[i];
    if (n.what == operation::log && !polynomials_.is_constant(i)) {
      // log(c x^k) = log c + k log x for c > 0.
      const auto p = laurent_polynomial_in_variable(g_, n.left);
      if (!p || p->coefficients.size() != 1) return std::nullopt;
      const node_id c = p->coefficients.front();
      if (!certainly_positive(value_at(g_, c, 64))) return std::nullopt;
      return parts_by_logarithm{c == g_.number(1) ? zero : nodes_.call("log", c),
                                g_.number(p->lowest)};
    }
    const auto of_two = [&](const auto& f) -> maybe_parts {
      const maybe_parts x = by_logarithm(n.left);
      const maybe_parts y = x ? by_logarithm(n.right) : std::nullopt;
      return y ? f(*x, *y) : std::nullopt;
    };
    switch (n.what) {
      case operation::negate: {
        const maybe_parts x = by_logarithm(n.left);
        if (!x) return x;
        return parts_by_logarithm{nodes_.minus(x->u), nodes_.minus(x->v)};
      }
      case operation::add:
        return of_two([&](const auto& x, const auto& y) -> maybe_parts {
          return parts_by_logarithm{nodes_.sum(x.u, y.u), nodes_.sum(x.v, y.v)};
        });
      case operation::subtract:
        return of_two([&](const auto& x, const auto& y) -> maybe_parts {
          return parts_by_logarithm{nodes_.difference(x.u, y.u), nodes_.difference(x.v, y.v)};
        });
      case operation::multiply:
        return of_two([&](const auto& x, const auto& y) -> maybe_parts {
          if (x.v != zero && y.v != zero) return std::nullopt;
          return parts_by_logarithm{nodes_.product(x.u, y.u),
                                    nodes_.sum(nodes_.product(x.u, y.v), nodes_.product(x.v, y.u))};
        });
      case operation::divide:
        return of_two([&](const auto& x, const auto& y) -> maybe_parts {
          if (y.v != zero) return std::nullopt;
          return parts_by_logarithm{x.u == zero ? zero : divide(g_, x.u, y.u),
                                    x.v == zero ? zero : divide(g_, x.v, y.u)};
        });
      default:
        for (const node_id k : operands_at(g_, i)) {
          const maybe_parts x = by_logarithm(k);
          if (!x || x->v != zero) return std::nullopt;
        }
        return parts_by_logarithm{i, zero};
    }
  }
  /// exp((a + i b) scale w) for a polynomial w, where a or b is 0.
  maybe_terms exponential(const exponential_terms& of, const rational& a, const rational& b,
                          std::optional<node_id> scale = std::nullopt) {
    std::optional<node_id> w = steady_node(of);
    if (!w) return std::nullopt;
    if (scale) w = nodes_.product(*scale, *w);
    auto c = polynomials_.coefficients_of(*w);
    std::vector<node_id> of_logarithm;
    if (!c && allows_logarithms_) {
      const maybe_parts parts = by_logarithm(*w);
      if (!parts) return std::nullopt;
      c = polynomials_.coefficients_of(parts->u);
      const auto l = polynomials_.coefficients_of(parts->v);
      if (!l) return std::nullopt;
      of_logarithm = *l;
    }
    if (!c) return std::nullopt;
    const complex_node factor{g_.number(a), g_.number(b)};
    exponent e;
    for (std::size_t k = 1; k < c->size(); ++k) {
      e.powers.push_back(nodes_.multiply(factor, nodes_.real((*c)[k])));
    }
    for (const node_id l : of_logarithm) {
      e.logarithmic.push_back(nodes_.multiply(factor, nodes_.real(l)));
    }
    complex_node amplitude = nodes_.number(1);
    if (!c->empty() && c->front() != g_.number(0)) {
      const node_id constant = c->front();
      amplitude = b == 0 ? nodes_.real(nodes_.call("exp", nodes_.product(factor.re, constant)))
                         : complex_node{nodes_.call("cos", constant),
                                        nodes_.product(factor.im, nodes_.call("sin", constant))};
    }
    return exponential_terms{{e, amplitude}};
  }

  graph& g_;
  complex_nodes nodes_;
  polynomial_nodes polynomials_;
  bool allows_logarithms_;
  std::map<node_id, exponential_terms> known_;
  std::map<node_id, maybe_parts> by_logarithm_;
};

}  // namespace
}  // namespace exponential_sum_impl

std::optional<std::vector<node_id>> polynomial_in_variable(graph& g, node_id of) {
  return exponential_sum_impl::polynomial_nodes(g).coefficients_of(of);
}

std::optional<laurent_nodes> laurent_polynomial_in_variable(graph& g, node_id of) {
  exponential_sum_impl::polynomial_nodes nodes(g, true);
  const auto found = nodes.of(of);
  if (!found) return std::nullopt;
  return laurent_nodes{found->lowest, found->c, nodes.divisors()};
}

bool has_circular_functions(const graph& g) {
  for (node_id i = 0; i <= g.root; ++i) {
    if (exponential_sum_impl::is_circular(g[i].what)) return true;
  }
  return false;
}

bool has_other_than_entire(const graph& g) {
  const std::vector<char> varies = varying(g);
  for (node_id i = 0; i <= g.root; ++i) {
    if (varies[i] == 0) continue;
    const node& n = g[i];
    const bool is_entire = is_of_ring(n.what) || exponential_sum_impl::is_wave(n.what) ||
                           (n.what == operation::divide && varies[n.right] == 0) ||
                           (n.what == operation::power_integer && n.number >= 0);
    if (!is_entire) return true;
  }
  return false;
}

std::optional<exponential_terms> exponential_terms_of(graph& g, bool allows_logarithms) {
  try {
    return exponential_sum_impl::decomposition(g, allows_logarithms).root();
  } catch (const undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

}  // namespace polhode::detail
