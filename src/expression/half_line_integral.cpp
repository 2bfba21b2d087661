// The integral from 0 to infinity of
//
//     f(x) = Re of the sum over j of c_j x^k_j exp(-s_j x),  integers k_j,
//
// where (1) the coefficient of x^-m in its Laurent series at 0 is 0 for each m >= 1, and (2) for
// each j either Re s_j > 0; or Re s_j = 0, s_j != 0 and k_j < 0; or s_j = 0 and k_j < -1.
//
// Theorem. The integral is the real part of the sum of the c_j V(k_j, s_j) with
//
//     V(k, s) = k!/s^(k+1)  for k >= 0,
//     V(-n, s) = (-s)^(n-1)/(n-1)! (1 + 1/2 + ... + 1/(n-1) - log s)  for n >= 1 and s != 0,
//     V(-n, 0) = 0.
//
// Proof. Let I(z) be the integral of x^(z+k) exp(-s x) from 0 to 1, for large Re z, and J(z) that
// from 1 to infinity, for small Re z. I is the sum over i of (-s)^i/(i! (z + k + i + 1)), so that
// it is meromorphic; J is entire for s != 0, by integrations by parts if Re s = 0, and -1/(z+k+1)
// for s = 0. I + J is Gamma(z+k+1) s^-(z+k+1), which it is for z where both integrals converge if
// Re s > 0, and beyond by continuation, also in s; it is 0 for s = 0. By (2) J(0) is the integral
// of x^k exp(-s x) from 1 to infinity. By (1) f is bounded at 0, so that the real part of the sum
// of the c_j I_j(z), the integral of x^z f(x) from 0 to 1, tends to that of f for real z -> 0+. So
// the integral of f is the limit of the real part of the sum of the c_j Gamma(z+k_j+1)
// s_j^-(z+k_j+1). For k = -n and z -> 0
//
//     Gamma(z-n+1) = Gamma(z+1)/(z (z-1) ... (z-n+1))
//                  = (-1)^(n-1)/(n-1)! (1/z + 1 + 1/2 + ... + 1/(n-1) - gamma + O(z)),
//     s^(n-1-z) = s^(n-1) (1 - z log s + O(z^2)),
//
// and the sum of the c_j (-s_j)^(n_j-1)/(n_j-1)! has the real part 0, by (1) with m = 1: with it go
// the poles and Euler's constant.
//
// And of a sum of terms c x^mu J_nu(k x): for k > 0 and mu + nu > -1 and mu < 1/2 (H. Weber,
// 1868; G. N. Watson, A treatise on the theory of Bessel functions, 13.24 (1); DLMF 10.22.43)
//
//     the integral of x^mu J_nu(x) is 2^mu Gamma((1 + nu + mu)/2)/Gamma((1 + nu - mu)/2).

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "exact_value.hpp"
#include "exponential_sum.hpp"
#include "graph.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/library_functions.hpp"

namespace polhode {
namespace half_line_impl {
namespace {

using detail::complex_node;
using detail::complex_nodes;
using detail::node_id;
using detail::operation;

constexpr std::size_t most_nodes = 300;   // of the formula
constexpr std::size_t most_powers = 512;  // in all terms
constexpr precision few = 64;

/// c_k x^k exp(l x), l = -s.
struct term {
  complex_node c;
  long k;
  complex_node l;
};

class integral_over_half_line {
 public:
  explicit integral_over_half_line(detail::graph& g) : g_(g), nodes_(g), zero_(g.number(0)) {}

  std::optional<node_id> root() {
    if (!find_terms() || !is_regular_at_zero()) return std::nullopt;
    node_id sum = zero_;
    for (const term& t : terms_) {
      const auto value = value_of(t);
      if (!value) return std::nullopt;
      sum = nodes_.sum(sum, nodes_.multiply(t.c, *value).re);
    }
    return sum;
  }

 private:
  bool find_terms() {
    const auto sum = detail::exponential_terms_of(g_);
    if (!sum) return false;
    for (const auto& [e, amplitude] : *sum) {
      if (e.powers.size() > 1) return false;
      const complex_node l = e.powers.empty() ? nodes_.number(0) : e.powers.front();
      const auto re = detail::laurent_polynomial_in_variable(g_, amplitude.re);
      const auto im = detail::laurent_polynomial_in_variable(g_, amplitude.im);
      if (!re || !im) return false;
      for (const auto* part : {&*re, &*im}) {
        for (const node_id d : part->divisors) {
          if (!is_certainly_nonzero(d)) return false;
        }
        for (std::size_t i = 0; i < part->coefficients.size(); ++i) {
          const node_id c = part->coefficients[i];
          const bool is_real_part = part == &*re;
          // An imaginary number times a real exponential has no real part.
          if (c == zero_ || (!is_real_part && nodes_.is_real(l))) continue;
          terms_.push_back({is_real_part ? nodes_.real(c) : complex_node{zero_, c},
                            part->lowest + static_cast<long>(i), l});
        }
        if (terms_.size() > most_powers) return false;
      }
    }
    return true;
  }
  bool is_certainly_nonzero(node_id i) {
    const ball value = detail::value_at(g_, i, few);
    return value.is_bounded() && !contains_zero(value);
  }
  bool is_zero(node_id i) {
    if (i == zero_) return true;
    const auto exact = detail::rational_value_at(g_, i);
    return exact && *exact == 0;
  }

  /// Condition (1): the coefficient of x^-m is the real part of the sum over the terms with k <= -m
  /// of c l^i/i!, i = -m - k.
  bool is_regular_at_zero() {
    long most = 0;
    for (const term& t : terms_) most = std::max(most, -t.k);
    for (long m = 1; m <= most; ++m) {
      node_id sum = zero_;
      for (const term& t : terms_) {
        if (t.k > -m) continue;
        sum = nodes_.sum(sum, nodes_.multiply(t.c, power_over_factorial(t.l, -m - t.k)).re);
      }
      if (!is_zero(sum)) return false;
    }
    return true;
  }
  /// l^n/n!.
  complex_node power_over_factorial(const complex_node& l, long n) {
    if (n == 0) return nodes_.number(1);
    rational factorial = 1;
    for (long i = 2; i <= n; ++i) factorial *= i;
    return nodes_.multiply(nodes_.power(l, n), nodes_.number(1 / factorial));
  }

  /// V(k, -l); nothing where condition (2) is not known to hold.
  std::optional<complex_node> value_of(const term& t) {
    const ball a = detail::value_at(g_, t.l.re, few);
    const bool decays = certainly_negative(a);
    if (!decays && !is_zero(t.l.re)) return std::nullopt;
    const complex_node s = decays ? nodes_.negate(t.l) : complex_node{zero_, nodes_.minus(t.l.im)};
    if (t.k >= 0) {
      if (!decays) return std::nullopt;
      rational factorial = 1;
      for (long i = 2; i <= t.k; ++i) factorial *= i;
      return nodes_.divide(nodes_.number(factorial), nodes_.power(s, t.k + 1));
    }
    if (!decays && !is_certainly_nonzero(t.l.im)) {
      if (t.k < -1 && is_zero(t.l.im)) return nodes_.number(0);
      return std::nullopt;
    }
    rational harmonic = 0;
    for (long i = 1; i < -t.k; ++i) harmonic += rational(1, i);
    const complex_node rest =
        nodes_.add(nodes_.number(harmonic), nodes_.negate(logarithm(s, decays)));
    const complex_node minus_s = nodes_.negate(s);
    return nodes_.multiply(power_over_factorial(minus_s, -t.k - 1), rest);
  }
  /// log s for Re s > 0, or for a pure imaginary s != 0.
  complex_node logarithm(const complex_node& s, bool is_right) {
    if (!is_right) {
      const bool positive = certainly_positive(detail::value_at(g_, s.im, few));
      const node_id size = positive ? s.im : nodes_.minus(s.im);
      return {nodes_.call("log", size), nodes_.product(g_.number(rational(positive ? 1 : -1, 2)),
                                                       g_.make(detail::operation::pi))};
    }
    if (nodes_.is_real(s)) return nodes_.real(nodes_.call("log", s.re));
    const node_id norm = nodes_.sum(nodes_.product(s.re, s.re), nodes_.product(s.im, s.im));
    return {nodes_.product(g_.number(rational(1, 2)), nodes_.call("log", norm)),
            nodes_.call("atan", detail::divide(g_, s.im, s.re))};
  }

  detail::graph& g_;
  complex_nodes nodes_;
  node_id zero_;
  std::vector<term> terms_;
};

class bessel_over_half_line {
 public:
  explicit bessel_over_half_line(detail::graph& g) : g_(g), varies_(detail::varying(g)) {}

  std::optional<node_id> root() { return integral(g_.root, product{{}, {}, 0, std::nullopt}); }

 private:
  /// Some factors of a term: constants that multiply and divide it, a power of x, and the call.
  struct product {
    std::vector<node_id> above;
    std::vector<node_id> below;
    rational mu;
    std::optional<node_id> bessel;
  };

  /// Of the node times the product.
  std::optional<node_id> integral(node_id i, const product& others) {
    const detail::node n = g_[i];
    if (varies(i) && (n.what == operation::add || n.what == operation::subtract)) {
      const auto left = integral(n.left, others);
      const auto right = left ? integral(n.right, others) : std::nullopt;
      if (!right) return std::nullopt;
      return n.what == operation::add ? add(g_, *left, *right) : subtract(g_, *left, *right);
    }
    if (varies(i) && n.what == operation::negate) {
      const auto positive = integral(n.left, others);
      return positive ? std::optional(negate(g_, *positive)) : std::nullopt;
    }
    if (varies(i) && (n.what == operation::multiply || n.what == operation::divide)) {
      // The factor that is no monomial goes last.
      product more = others;
      const bool divides = n.what == operation::divide;
      if (multiply_by(n.right, divides ? -1 : 1, more)) return integral(n.left, more);
      if (!divides && multiply_by(n.left, 1, more = others)) return integral(n.right, more);
      return std::nullopt;
    }
    product all = others;
    if (!multiply_by(i, 1, all) || !all.bessel) return std::nullopt;
    return value_of(all);
  }
  [[nodiscard]] bool varies(node_id i) const { return i < varies_.size() && varies_[i] != 0; }

  /// Multiplies by node^e, e = 1 or -1, where that is a constant, a power of x, or the one J.
  bool multiply_by(node_id i, int e, product& p) {
    if (!varies(i)) {
      (e > 0 ? p.above : p.below).push_back(i);
      return true;
    }
    const detail::node n = g_[i];
    const auto is_variable = [&](node_id k) { return g_[k].what == operation::variable; };
    if (n.what == operation::variable) {
      p.mu += e;
    } else if (n.what == operation::power_integer && is_variable(n.left)) {
      p.mu += rational(e) * n.number;
    } else if (n.what == operation::sqrt && is_variable(n.left)) {
      p.mu += rational(e, 2);
    } else if (const auto exponent = detail::fractional_exponent_at(g_, i);
               exponent && is_variable(n.left)) {
      p.mu += e * *exponent;
    } else if (n.what == operation::negate) {
      p.above.push_back(g_.number(-1));
      return multiply_by(n.left, e, p);
    } else if (n.what == operation::multiply) {
      return multiply_by(n.left, e, p) && multiply_by(n.right, e, p);
    } else if (n.what == operation::divide) {
      return multiply_by(n.left, e, p) && multiply_by(n.right, -e, p);
    } else if (n.what == operation::further && e > 0 && !p.bessel && is_bessel(i)) {
      p.bessel = i;
    } else {
      return false;
    }
    return true;
  }
  [[nodiscard]] bool is_bessel(node_id i) const {
    const further_functions& own = *library_functions();
    const further_function* f = g_.call_at(i).function;
    // A function of this name in another list may be anything.
    return f->what.name == "besselJ" &&
           std::any_of(own.begin(), own.end(),
                       [&](const further_function& one) { return &one == f; });
  }

  std::optional<node_id> value_of(const product& p) {
    const std::vector<node_id> operands = g_.call_at(*p.bessel).operands;
    const rational* nu = g_.value(operands[0]);
    const auto k = factor_of_variable(operands[1]);
    if (nu == nullptr || !k) return std::nullopt;
    const ball size = detail::value_at(g_, *k, few);
    // J_n(-x) = (-1)^n J_n(x) for whole n.
    const bool is_reflected = certainly_negative(size) && denominator(*nu) == 1;
    if (!certainly_positive(size) && !is_reflected) return std::nullopt;
    if (p.mu + *nu <= -1 || p.mu >= rational(1, 2)) return std::nullopt;
    const node_id frequency = is_reflected ? negate(g_, *k) : *k;
    const auto gamma = [&](const rational& x) {
      return detail::find_function("gamma")->build(g_, {g_.number(x / 2)});
    };
    const rational above(1 + *nu + p.mu);
    const rational below(1 + *nu - p.mu);
    // x = t/k.
    const node_id scale = power(g_, divide(g_, g_.number(2), frequency), g_.number(p.mu));
    node_id result =
        divide(g_, multiply(g_, scale, gamma(above)), multiply(g_, gamma(below), frequency));
    for (const node_id c : p.above) result = multiply(g_, result, c);
    for (const node_id c : p.below) result = divide(g_, result, c);
    return is_reflected && numerator(*nu) % 2 != 0 ? negate(g_, result) : result;
  }
  /// k of k x.
  std::optional<node_id> factor_of_variable(node_id i) {
    product p{{}, {}, 0, std::nullopt};
    if (!multiply_by(i, 1, p) || p.mu != 1 || p.bessel) return std::nullopt;
    node_id k = g_.number(1);
    for (const node_id c : p.above) k = multiply(g_, k, c);
    for (const node_id c : p.below) k = divide(g_, k, c);
    return k;
  }

  detail::graph& g_;
  std::vector<char> varies_;
};

}  // namespace
}  // namespace half_line_impl

std::optional<expression> expression::integral_over_half_line() const {
  if (variables_.size() != 1 || graph_->size() > half_line_impl::most_nodes) return std::nullopt;
  try {
    detail::graph g = *graph_;
    auto root = half_line_impl::integral_over_half_line(g).root();
    if (!root) {
      g = *graph_;
      root = half_line_impl::bessel_over_half_line(g).root();
    }
    if (!root) return std::nullopt;
    return with_root(std::move(g), *root);
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

}  // namespace polhode
