// Integrals of oscillations up to infinity over rays on which they decay.
//
// Let f = Re h exp(i phi) for x >= p, with a real polynomial phi of degree n >= 1 and leading
// coefficient d_n > 0, and h analytic on {z: Re z >= p} with |h(z)| <= C |z|^m |log z|^k for great
// |z| there, m < n - 1, or m = n - 1 and k < 0.
// Let phi(p + w) = the sum of d_j w^j and theta = pi/(2n). Then
//
//   the integral of f from p to infinity = Re of the integral of
//       exp(i theta) h(p + s e^(i theta)) exp(i phi(p + s e^(i theta))) ds from 0 to infinity.
//
// Proof: the sector 0 <= arg w <= theta lies in Re z >= p. Between the two rays Cauchy's theorem
// leaves the arc w = R e^(i alpha), 0 <= alpha <= theta, on which sin(n alpha) >= 2 n alpha/pi and
// |sin(j alpha)| <= j alpha, so that Im phi >= alpha (2 n d_n R^n/pi - the sum of j |d_j| R^j over
// 1 <= j < n) >= alpha d_n R^n/2 for great R. So the arc contributes at most the integral of C'
// R^(m+1) log(R)^k exp(-alpha d_n R^n/2) over alpha, at most 2 C' R^(m+1-n) log(R)^k/d_n, which
// tends to 0. On
// the ray |exp(i phi)| = exp(-V), V = the sum of d_j sin(j theta) s^j with leading term d_n s^n:
// the integral over it converges absolutely. So the one over the real axis converges to the same
// number.
//
// Between two numbers p < q the same rays from p and from q have the difference
//
//   the integral of f from p to q = (that over the ray from p) - (that over the ray from q),
//
// for every m: the path from p + R e^(i theta) to q + R e^(i theta), on which Im phi >= d_n R^n/2
// for great R, contributes at most C R^m exp(-d_n R^n/2), which tends to 0.
//
// A factor exp(rho) with a real polynomial rho, the sum of r_j w^j around p, of degree at most n:
// between two numbers nothing changes, as r_n cos(n theta) = 0 leaves |exp(rho)| at most
// exp(C R^(n-1)) on the far path, and d_n R^n/2 is more. Up to infinity r_j <= 0 is needed for
// j >= 1, around p. Then |exp(rho)| <= exp(r_0) in the sector, as cos(j alpha) >= 0 there. Where
// some r_j with 1 <= j <= n is less than 0, every m is allowed: on the arc |exp(rho)| is at most
// exp(r_0 - |r_j| R^j cos(j alpha)), which for j alpha <= pi/4 is at most
// exp(r_0 - |r_j| R^j/sqrt(2)); and for greater alpha, where alpha >= pi/(4n),
// exp(-alpha d_n R^n/2) <= exp(-pi d_n R^n/(8n)). So the arc contributes nothing in the limit,
// whatever power of R is beside these.
//
// A sum Q(z) log z in phi, with a real polynomial Q of degree l <= n, the sum of q_j w^j around p,
// where p > 0. For w = R e^(i alpha) in the sector, |z| >= R, 0 <= arg z <= alpha, and
//   Im(Q log z) = Im Q log |z| + Re Q arg z,
// with |Im Q| <= alpha times the sum of j |q_j| R^j, and |Re Q| at most the sum of |q_j| R^j.
//   l < n, with d_n > 0: this is at least -alpha O(R^l log R), and changes nothing above.
//   l = n, with q_n > 0 and any polynomial of degree n or less beside it: Im Q is at least
//     alpha (2 n q_n R^n/pi - O(R^(n-1))), Re Q at least -O(R^(n-1)), as cos(n alpha) >= 0, and
//     the polynomial at least -alpha O(R^n). So Im phi >= alpha q_n R^n log(R)/2 for great R, and
//     the arc contributes at most 2 C' R^(m+1-n) log(R)^(k-1)/q_n: m = n - 1 and k < 1 is enough.
// z^(i q_0), whose size is exp(-q_0 arg z), is the case l = 0.
//
// h is made of the variable by sums, products, quotients, powers and logarithms. Its m and k come
// from these: log w of a polynomial w of degree d >= 1 has the size of d log |z| for great |z|, m =
// 0 and k = 1; as a divisor it must have no zero, so that w - 1 has none. Of a power with an
// irrational exponent the bounds are those of rational numbers beside it. A divisor that is a
// polynomial with the
// coefficients c_j, d_j those around p, has no zero in the sector, and is at least C |z|^d there, C
// > 0, in two cases:
//   p > 0 and |c_d| > the sum of |c_j| p^(j-d) over j < d, for |z| >= p there;
//   d_0 > 0, d_1 > 0, d_j >= 0 (or all of the other sign), d <= 2n: for w = r e^(i alpha), j alpha
//   lies in [0, pi], so that the imaginary part is at least d_1 r sin alpha > 0 unless alpha = 0,
//   where the real part is at least d_0; and its limit inferior beside |z|^d is positive.
// Between two rays there is a third: d = 1 and the root, which is real, is not in [p, q], the only
// real points between the rays; at infinity as before. In the second case, with positive signs, the
// polynomial w is never a number <= 0, so that the principal branches of w^e and log w are
// analytic; for d <= 2 arg w is the sum of those of z - r over the roots r, which have Re r < p
// (d_1 > 0 where they are not real), each in (-pi/2, pi/2). At p = 0, where x^e is not analytic,
// only e > 0 is allowed, and not in a divisor: then the contour's part around 0 vanishes with its
// radius.

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "exact_value.hpp"
#include "exponential_sum.hpp"
#include "polhode/arithmetic/ball.hpp"
#include "polhode/expression/symbol.hpp"

namespace polhode {
namespace turned_rays_impl {
namespace {

using detail::complex_node;
using detail::complex_nodes;
using detail::node;
using detail::node_id;
using detail::operation;

constexpr std::size_t most_nodes = 300;  // of the formula
constexpr precision bits = 192;
constexpr std::size_t most_expanded = 8;  // coefficients of a polynomial that is taken as one

/// |z|^power |log z|^logarithms; of two the greater one is greater for great |z|.
struct order {
  rational power = 0;
  rational logarithms = 0;

  friend order operator+(const order& x, const order& y) {
    return {x.power + y.power, x.logarithms + y.logarithms};
  }
  friend order operator-(const order& x, const order& y) {
    return {x.power - y.power, x.logarithms - y.logarithms};
  }
  friend order operator*(const order& x, long n) { return {x.power * n, x.logarithms * n}; }
  friend bool operator<(const order& x, const order& y) {
    return x.power < y.power || (x.power == y.power && x.logarithms < y.logarithms);
  }
};
/// |h(z)| is at most C' times the size `most` for great z in the sector. Where `least` is known, h
/// has no zero in the sector, ends included, and is at least C times that size for great z, C > 0.
struct growth {
  order most;
  std::optional<order> least;
};
/// An exponent without the variable, and bounds of it.
struct exponent_node {
  node_id value;
  rational least;
  rational most;
};

class turned_rays {
 public:
  explicit turned_rays(detail::graph f)
      : g_(std::move(f)), nodes_(g_), x_(g_.variable(0)), s_(x_) {}

  /// Whether it is such a sum.
  bool prepare() {
    const node_id zero = g_.number(0);
    auto terms = detail::exponential_terms_of(g_, true);
    if (!terms) return false;
    for (auto& [e, h] : *terms) {
      oscillation part{{}, {}, {}, h};
      for (const complex_node& c : e.powers) {
        part.phase.push_back(c.im);
        part.size.push_back(c.re);
      }
      for (const complex_node& c : e.logarithmic) {
        if (c.re != zero) return false;
        part.logarithmic.push_back(c.im);
      }
      for (auto* c : {&part.phase, &part.size}) {
        while (!c->empty() && c->back() == zero) c->pop_back();
      }
      if (!part.is_steady()) {
        if (part.degree() == 0 || part.size.size() > part.degree() ||
            !make_leading_positive(part)) {
          return false;
        }
      }
      parts_.push_back(std::move(part));
    }
    return !parts_.empty() && !std::ranges::all_of(parts_, &oscillation::is_steady);
  }

  /// Whether the rays may start at p >= 0, for an integral up to `end`, or up to infinity. With
  /// `only_rising`, whether the phases' derivatives are not negative there either.
  bool may_start_at(const rational& p, const std::optional<rational>& end, bool only_rising) {
    start_ = p;
    end_ = end;
    return std::ranges::all_of(parts_, [&](const oscillation& part) {
      growths_.clear();
      n_ = static_cast<long>(part.degree());
      if (part.is_steady()) return true;
      if (!part.logarithmic.empty() && p == 0) return false;
      for (const node_id h : {part.amplitude.re, part.amplitude.im}) {
        if (h == g_.number(0)) continue;
        const auto of = growth_of(h);
        if (!of) return false;
        const bool converges = of->most < order{n_ - 1, part.is_led_by_logarithm() ? 1 : 0};
        if (!end && !converges && !decays(part)) return false;
      }
      if (!end && !never_grows(part)) return false;
      // Where the phase falls for long the rays' integrands are as great as e to a power of that
      // length; beside a logarithm it may be longer than numbers reach.
      if (!only_rising && part.logarithmic.empty()) return true;
      const std::vector<node_id> d = shifted(with_constant_0(part.phase));
      const std::vector<node_id> q = shifted(part.logarithmic);
      const ball logarithm = p > 0 ? log(ball(p, bits)) : ball(0, bits);
      for (std::size_t j = 1; j < std::max(d.size(), q.size()); ++j) {
        ball rate = j < d.size() ? value_of(d[j]) : ball(0, bits);
        if (j < q.size()) rate += value_of(q[j]) * logarithm;
        if (certainly_positive(-rate)) return false;
      }
      return true;
    });
  }

  /// About how often the fastest part turns between two numbers.
  double turns_between(const rational& p, const rational& q) {
    ball most(0, bits);
    for (const oscillation& part : parts_) {
      ball turn(0, bits);
      for (std::size_t j = part.phase.size(); j-- > 0;) {
        // (q^(j+1) - p^(j+1)) times the coefficient.
        const auto n = static_cast<long>(j + 1);
        turn += value_of(part.phase[j]) * (pow(ball(q, bits), n) - pow(ball(p, bits), n));
      }
      for (std::size_t j = part.logarithmic.size(); j-- > 0 && p > 0;) {
        const auto at = [&](const rational& x) {
          return pow(ball(x, bits), static_cast<long>(j)) * log(ball(x, bits));
        };
        turn += value_of(part.logarithmic[j]) * (at(q) - at(p));
      }
      if (certainly_less(most, abs(turn))) most = abs(turn);
    }
    return most.is_bounded() ? static_cast<double>(upper_rational(most)) / 6.3 : 0;
  }

  /// The sum of the parts that do not oscillate, as a node of graph(), where there are any.
  std::optional<node_id> steady_part() {
    std::optional<node_id> sum;
    for (const oscillation& part : parts_) {
      if (!part.is_steady()) continue;
      node_id f = part.amplitude.re;
      if (!part.size.empty()) {
        node_id exponent = g_.number(0);
        for (std::size_t j = part.size.size(); j-- > 0;) {
          exponent = nodes_.product(x_, nodes_.sum(part.size[j], exponent));
        }
        f = nodes_.product(f, nodes_.call("exp", exponent));
      }
      sum = sum ? nodes_.sum(*sum, f) : f;
    }
    return sum;
  }

  /// The formulas in s of the parts that oscillate, on the rays from p, as nodes of graph().
  std::vector<node_id> on_rays_from(const rational& p) {
    start_ = p;
    std::vector<node_id> result;
    for (const oscillation& part : parts_) {
      if (part.is_steady()) continue;
      for (const node_id root : on_ray(part)) result.push_back(root);
    }
    return result;
  }
  [[nodiscard]] const detail::graph& graph() const { return g_; }

 private:
  /// Re amplitude exp(size + i (phase + logarithmic log x)).
  struct oscillation {
    std::vector<node_id> phase;        // the coefficients of x, x^2, ...
    std::vector<node_id> size;         // likewise
    std::vector<node_id> logarithmic;  // of 1, x, x^2, ...
    complex_node amplitude;

    [[nodiscard]] bool is_steady() const { return phase.empty() && logarithmic.empty(); }
    /// The greater degree of the two polynomials in the phase.
    [[nodiscard]] std::size_t degree() const {
      return std::max(phase.size(), logarithmic.size() - (logarithmic.empty() ? 0 : 1));
    }
    [[nodiscard]] bool is_led_by_logarithm() const { return logarithmic.size() > degree(); }
  };
  [[nodiscard]] std::vector<node_id> with_constant_0(const std::vector<node_id>& c) {
    std::vector<node_id> result{g_.number(0)};
    result.insert(result.end(), c.begin(), c.end());
    return result;
  }

  /// r_j <= 0 for all j >= 1.
  bool never_grows(const oscillation& part) {
    const std::vector<node_id> r = shifted(with_constant_0(part.size));
    return std::all_of(r.begin() + 1, r.end(), [&](node_id c) {
      return c == g_.number(0) || certainly_positive(-value_of(c));
    });
  }
  /// r_j < 0 for a j with 1 <= j <= n.
  bool decays(const oscillation& part) {
    const std::vector<node_id> r = shifted(with_constant_0(part.size));
    return std::any_of(r.begin() + 1, r.end(),
                       [&](node_id c) { return certainly_positive(-value_of(c)); });
  }

  ball value_of(node_id c) {
    const auto known = values_.find(c);
    if (known != values_.end()) return known->second;
    return values_.emplace(c, detail::value_at(g_, c, bits)).first->second;
  }

  /// Re h exp(i phi) = Re conj(h) exp(-i phi).
  bool make_leading_positive(oscillation& part) {
    const ball leading =
        value_of(part.is_led_by_logarithm() ? part.logarithmic.back() : part.phase.back());
    if (certainly_positive(leading)) return true;
    if (!certainly_positive(-leading)) return false;
    for (auto* polynomial : {&part.phase, &part.logarithmic}) {
      for (node_id& c : *polynomial) c = nodes_.minus(c);
    }
    part.amplitude = nodes_.conjugate(part.amplitude);
    return true;
  }

  // -------------------------------------------------------------------------------------------
  // Growth in the sector

  std::optional<growth> growth_of(node_id i) {
    const auto known = growths_.find(i);
    if (known != growths_.end()) return known->second;
    std::optional<growth> found = growth_made(i);
    growths_.emplace(i, found);
    return found;
  }
  std::optional<growth> growth_made(node_id i) {
    if (const auto c = detail::polynomial_in_variable(g_, i)) {
      auto found = of_polynomial(*c);
      if (!found || found->least || c->size() <= 2) return found;
    }
    const node n = g_[i];
    const auto left = [&] { return growth_of(n.left); };
    switch (n.what) {
      case operation::negate:
        return left();
      case operation::add:
      case operation::subtract: {
        const auto x = left();
        const auto y = growth_of(n.right);
        if (!x || !y) return std::nullopt;
        return growth{std::max(x->most, y->most), std::nullopt};
      }
      case operation::multiply: {
        const auto x = left();
        const auto y = growth_of(n.right);
        if (!x || !y) return std::nullopt;
        growth result{x->most + y->most, std::nullopt};
        if (x->least && y->least) result.least = *x->least + *y->least;
        return result;
      }
      case operation::divide: {
        const auto x = left();
        const auto y = growth_of(n.right);
        if (!x || !y || !y->least) return std::nullopt;
        growth result{x->most - *y->least, std::nullopt};
        if (x->least) result.least = *x->least - y->most;
        return result;
      }
      case operation::power_integer: {
        const auto x = left();
        if (!x || (n.number < 0 && !x->least)) return std::nullopt;
        if (n.number >= 0) {
          growth result{x->most * n.number, std::nullopt};
          if (x->least) result.least = *x->least * n.number;
          return result;
        }
        return growth{*x->least * n.number, x->most * n.number};
      }
      default:
        return growth_of_branch(i);
    }
  }
  /// Of a power or a logarithm.
  std::optional<growth> growth_of_branch(node_id i) {
    const node n = g_[i];
    const std::optional<exponent_node> e = exponent_at(i);
    if (!e && n.what != operation::log) return std::nullopt;
    const auto c = detail::polynomial_in_variable(g_, n.left);
    if (!c || c->size() < 2) return std::nullopt;
    if (start_ == 0 && c->size() == 2 && c->front() == g_.number(0)) {
      if (e && e->least > 0 && certainly_positive(value_of(c->back()))) {
        return growth{{e->most}, std::nullopt};
      }
      return std::nullopt;
    }
    if (c->size() > 3 || !lies_in_half_plane(*c, true)) return std::nullopt;
    if (c->size() == 3 && !quadratic_of(*c).is_decided) return std::nullopt;
    const auto degree = static_cast<long>(c->size() - 1);
    if (e) return growth{order{e->most} * degree, order{e->least} * degree};
    growth result{{0, 1}, std::nullopt};
    std::vector<node_id> less_one = *c;
    less_one[0] = nodes_.difference(less_one[0], g_.number(1));
    if (const auto of = of_polynomial(less_one); of && of->least) result.least = result.most;
    return result;
  }
  /// The exponent of a root, or of a power with an exponent that is no whole number.
  std::optional<exponent_node> exponent_at(node_id i) {
    if (const auto e = detail::fractional_exponent_at(g_, i)) {
      return exponent_node{g_.number(*e), *e, *e};
    }
    const node n = g_[i];
    if (n.what != operation::power || is_varying(n.right)) return std::nullopt;
    const ball e = value_of(n.right);
    if (!e.is_bounded()) return std::nullopt;
    return exponent_node{n.right, lower_rational(e), upper_rational(e)};
  }
  bool is_varying(node_id i) {
    const auto c = detail::polynomial_in_variable(g_, i);
    return !c || c->size() > 1;
  }
  std::optional<growth> of_polynomial(const std::vector<node_id>& c) {
    if (c.empty()) return growth{{}, std::nullopt};
    for (const node_id k : c) {
      if (!value_of(k).is_bounded()) return std::nullopt;
    }
    const auto degree = static_cast<long>(c.size()) - 1;
    growth result{{degree}, std::nullopt};
    if (leading_term_is_greatest(c) || lies_in_half_plane(c, false) || has_root_elsewhere(c)) {
      result.least = result.most;
    }
    return result;
  }
  /// |c_d| > the sum of |c_j| p^(j-d) over j < d.
  bool leading_term_is_greatest(const std::vector<node_id>& c) {
    if (start_ == 0 && c.size() > 1) return false;
    ball rest(0, bits);
    for (std::size_t j = 0; j + 1 < c.size(); ++j) {
      rest = (rest + abs(value_of(c[j]))) / ball(start_, bits);
    }
    return certainly_less(rest, abs(value_of(c.back())));
  }
  /// The third case above: a linear form whose root is not in [start_, end_].
  bool has_root_elsewhere(const std::vector<node_id>& c) {
    if (c.size() != 2 || !end_) return false;
    const ball at_start = value_of(c[0]) + value_of(c[1]) * ball(start_, bits);
    const ball at_end = value_of(c[0]) + value_of(c[1]) * ball(*end_, bits);
    return (certainly_positive(at_start) && certainly_positive(at_end)) ||
           (certainly_positive(-at_start) && certainly_positive(-at_end));
  }
  /// The second case above; with `positive`, with those signs.
  bool lies_in_half_plane(const std::vector<node_id>& c, bool positive) {
    if (static_cast<long>(c.size()) - 1 > 2 * n_) return false;
    std::vector<ball> d;
    d.reserve(c.size());
    for (const node_id k : c) d.push_back(value_of(k));
    const ball p(start_, bits);
    for (std::size_t k = 0; k + 1 < d.size(); ++k) {
      for (std::size_t j = d.size() - 1; j-- > k;) d[j] += p * d[j + 1];
    }
    const bool is_negative = !positive && certainly_positive(-d[0]);
    for (std::size_t j = 0; j < d.size(); ++j) {
      const ball own = is_negative ? -d[j] : d[j];
      const bool may_be_0 =
          j > 1 && j + 1 < d.size() && own.radius().is_zero() && contains_zero(own);
      if (!may_be_0 && !certainly_positive(own)) return false;
    }
    return true;
  }
  // -------------------------------------------------------------------------------------------
  // Formulas in s

  /// The coefficients around start_ of the polynomial with these coefficients.
  std::vector<node_id> shifted(std::vector<node_id> c) {
    for (std::size_t k = 0; k + 1 < c.size(); ++k) {
      for (std::size_t j = c.size() - 1; j-- > k;) {
        c[j] = nodes_.sum(c[j], nodes_.product(g_.number(start_), c[j + 1]));
      }
    }
    return c;
  }
  /// exp(i pi j/(2n)).
  complex_node turn(long j, long n) {
    const node_id zero = g_.number(0);
    const node_id one = g_.number(1);
    if (j % n == 0) {
      switch (j / n % 4) {
        case 0:
          return {one, zero};
        case 1:
          return {zero, one};
        case 2:
          return {g_.number(-1), zero};
        default:
          return {zero, g_.number(-1)};
      }
    }
    const node_id angle = nodes_.product(g_.number(rational(j, 2 * n)), g_.make(operation::pi));
    return {nodes_.call("cos", angle), nodes_.call("sin", angle)};
  }
  /// The polynomial with these coefficients at z_, turned by so many angles theta more.
  complex_node polynomial_at_z(const std::vector<node_id>& c, long more) {
    const std::vector<node_id> d = shifted(c);
    complex_node sum = nodes_.number(0);
    for (std::size_t j = 0; j < d.size(); ++j) {
      const auto n = static_cast<long>(j);
      const node_id term = nodes_.product(d[j], detail::power(g_, s_, g_.number(n)));
      sum = nodes_.add(sum, nodes_.multiply(turn(n + more, n_), nodes_.real(term)));
    }
    return sum;
  }
  /// h exp(i theta) at z_.
  complex_node turned_amplitude(node_id h) {
    const auto c = detail::polynomial_in_variable(g_, h);
    if (c && c->size() <= most_expanded) return polynomial_at_z(*c, 1);
    return nodes_.multiply(at_z(h), turn(1, n_));
  }
  /// The part's formula, in two summands where it has logarithms: their growth is known one by one.
  std::vector<node_id> on_ray(const oscillation& part) {
    n_ = static_cast<long>(part.degree());
    z_ = nodes_.add(nodes_.number(start_), nodes_.multiply(turn(1, n_), nodes_.real(s_)));
    at_z_.clear();
    has_logarithm_ = false;
    const complex_node unit{g_.number(0), g_.number(1)};
    complex_node h = turned_amplitude(part.amplitude.re);
    if (part.amplitude.im != g_.number(0)) {
      h = nodes_.add(h, nodes_.multiply(unit, turned_amplitude(part.amplitude.im)));
    }
    complex_node phase = polynomial_at_z(with_constant_0(part.phase), 0);
    if (!part.logarithmic.empty()) {
      const node_id size = nodes_.call("log", square_of_size(z_));
      const complex_node logarithm{nodes_.product(g_.number(rational(1, 2)), size),
                                   nodes_.call("atan", detail::divide(g_, z_.im, z_.re))};
      phase = nodes_.add(phase, nodes_.multiply(polynomial_at_z(part.logarithmic, 0), logarithm));
    }
    const complex_node size = polynomial_at_z(with_constant_0(part.size), 0);
    const node_id angle = nodes_.sum(phase.re, size.im);
    const complex_node wave{nodes_.call("cos", angle), nodes_.call("sin", angle)};
    const node_id decay = nodes_.call("exp", nodes_.difference(size.re, phase.im));
    const node_id first = nodes_.product(decay, nodes_.product(h.re, wave.re));
    const node_id second = nodes_.minus(nodes_.product(decay, nodes_.product(h.im, wave.im)));
    if (has_logarithm_ && second != g_.number(0)) return {first, second};
    return {nodes_.product(decay, nodes_.multiply(h, wave).re)};
  }
  /// The function that a node of the variable is, at z_.
  complex_node at_z(node_id i) {
    const auto known = at_z_.find(i);
    if (known != at_z_.end()) return known->second;
    const complex_node found = made_at_z(i);
    at_z_.emplace(i, found);
    return found;
  }
  complex_node made_at_z(node_id i) {
    const auto c = detail::polynomial_in_variable(g_, i);
    if (c && c->size() <= 1) return nodes_.real(i);
    if (c && c->size() <= most_expanded) return polynomial_at_z(*c, 0);
    const node n = g_[i];
    switch (n.what) {
      case operation::negate:
        return nodes_.negate(at_z(n.left));
      case operation::add:
        return nodes_.add(at_z(n.left), at_z(n.right));
      case operation::subtract:
        return nodes_.add(at_z(n.left), nodes_.negate(at_z(n.right)));
      case operation::multiply:
        return nodes_.multiply(at_z(n.left), at_z(n.right));
      case operation::divide:
        if (const auto e = varying_exponent_at(n.right)) {
          return nodes_.multiply(at_z(n.left), branch_at_z(g_[n.right].left, nodes_.minus(*e)));
        }
        return nodes_.divide(at_z(n.left), at_z(n.right));
      case operation::power_integer:
        if (const auto e = varying_exponent_at(n.left)) {
          return branch_at_z(g_[n.left].left, nodes_.product(g_.number(n.number), *e));
        }
        return nodes_.power(at_z(n.left), n.number);
      default:
        break;
    }
    if (const auto e = exponent_at(i)) return branch_at_z(n.left, e->value);
    if (n.what != operation::log) {
      throw std::logic_error("turned rays: internal error: a function without a bound");
    }
    has_logarithm_ = true;
    const node_id size = nodes_.call("log", square_of_size(at_z(n.left)));
    return {nodes_.product(g_.number(rational(1, 2)), size), argument_of(n.left)};
  }
  /// w^e = |w|^e exp(i e arg w) for the polynomial w that a node is.
  complex_node branch_at_z(node_id of, node_id e) {
    const node_id half = nodes_.product(g_.number(rational(1, 2)), e);
    const node_id power = detail::power(g_, square_of_size(at_z(of)), half);
    const node_id turned = nodes_.product(e, argument_of(of));
    return {nodes_.product(power, nodes_.call("cos", turned)),
            nodes_.product(power, nodes_.call("sin", turned))};
  }
  /// The exponent of a root or power of what varies.
  std::optional<node_id> varying_exponent_at(node_id i) {
    const auto e = detail::polynomial_in_variable(g_, i) ? std::nullopt : exponent_at(i);
    return e ? std::optional(e->value) : std::nullopt;
  }
  node_id square_of_size(const complex_node& w) {
    return nodes_.sum(nodes_.product(w.re, w.re), nodes_.product(w.im, w.im));
  }
  node_id argument_of(node_id i) { return argument_at_z(*detail::polynomial_in_variable(g_, i)); }
  /// The sum of the arguments of z - r over the roots r of the polynomial, all with Re r < Re z.
  node_id argument_at_z(const std::vector<node_id>& c) {
    const auto of = [&](node_id re, node_id im) {
      return nodes_.call(
          "atan", detail::divide(g_, nodes_.difference(z_.im, im), nodes_.difference(z_.re, re)));
    };
    const node_id zero = g_.number(0);
    if (start_ == 0 && c.size() == 2 && c[0] == zero) {  // z = s exp(i theta)
      return nodes_.product(g_.number(rational(1, 2 * n_)), g_.make(operation::pi));
    }
    if (c.size() == 2) return of(nodes_.minus(detail::divide(g_, c[0], c[1])), zero);
    const quadratic q = quadratic_of(c);
    const node_id root = nodes_.call("sqrt", q.has_real_roots ? q.square : nodes_.minus(q.square));
    const node_id less = nodes_.difference(q.centre, root);
    const node_id more = nodes_.sum(q.centre, root);
    if (q.has_real_roots) return nodes_.sum(of(less, zero), of(more, zero));
    return nodes_.sum(of(q.centre, root), of(q.centre, nodes_.minus(root)));
  }
  /// c_2 ((x - centre)^2 - square).
  struct quadratic {
    node_id centre;
    node_id square;
    bool is_decided;
    bool has_real_roots;
  };
  quadratic quadratic_of(const std::vector<node_id>& c) {
    const node_id twice = nodes_.product(g_.number(2), c[2]);
    const node_id centre = nodes_.minus(detail::divide(g_, c[1], twice));
    const node_id square =
        nodes_.difference(nodes_.product(centre, centre), detail::divide(g_, c[0], c[2]));
    const bool is_positive = certainly_positive(value_of(square));
    return {centre, square, is_positive || certainly_positive(-value_of(square)), is_positive};
  }

  detail::graph g_;
  complex_nodes nodes_;
  node_id x_;
  node_id s_;
  rational start_;
  std::optional<rational> end_;
  long n_ = 0;  // the degree n of the part's phase, or l
  std::vector<oscillation> parts_;
  std::map<node_id, ball> values_;
  std::map<node_id, std::optional<growth>> growths_;
  complex_node z_{};
  bool has_logarithm_ = false;  // the part at z_
  std::map<node_id, complex_node> at_z_;
};

/// The least whole number above it.
rational next_integer(const rational& q) { return rational(integer(floor_of(q) + 1)); }

}  // namespace
}  // namespace turned_rays_impl

std::optional<expression::rays> expression::on_turned_rays(const rational& from) const {
  using turned_rays_impl::turned_rays;
  if (variables_.size() != 1 || graph_->size() > turned_rays_impl::most_nodes ||
      !detail::has_circular_functions(*graph_)) {
    return std::nullopt;
  }
  try {
    turned_rays turned(*graph_);
    if (!turned.prepare()) return std::nullopt;
    constexpr int most_doublings = 24;
    const rational first = std::max(from, rational(0));
    std::optional<rational> start;
    for (const bool only_rising : {true, false}) {
      rational p = first;
      for (int k = 0; k < most_doublings && !start; ++k) {
        if (turned.may_start_at(p, std::nullopt, only_rising)) start = p;
        p = turned_rays_impl::next_integer(p * 2 - first);
      }
    }
    if (!start) return std::nullopt;
    rays result{*start, {}};
    for (const detail::node_id root : turned.on_rays_from(*start)) {
      result.parts.push_back(with_root(turned.graph(), root));
      result.parts.back().variables_ = {"s"};
    }
    if (const auto root = turned.steady_part()) {
      const expression steady = with_root(turned.graph(), *root);
      expression_names own = names();
      own.variables = {"s"};
      result.parts.emplace_back(steady(symbol(*start) + symbol::variable(0)), own);
    }
    return result;
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

std::optional<expression::two_rays> expression::between_turned_rays(const rational& a,
                                                                    const rational& b) const {
  using turned_rays_impl::turned_rays;
  if (variables_.size() != 1 || graph_->size() > turned_rays_impl::most_nodes ||
      !detail::has_circular_functions(*graph_) || a < 0) {
    return std::nullopt;
  }
  try {
    turned_rays turned(*graph_);
    if (!turned.prepare()) return std::nullopt;
    // The sector from the start holds that from b.
    two_rays result;
    bool found = turned.may_start_at(a, b, false);
    result.start = a;
    for (int k = 20; k > 0 && !found; --k) {
      result.start = a + (b - a) / rational(integer(1) << k);
      found = turned.may_start_at(result.start, b, false);
    }
    if (!found) return std::nullopt;
    result.turns = turned.turns_between(result.start, b);
    const auto add_from = [&](const rational& p, std::vector<expression>& parts) {
      for (const detail::node_id root : turned.on_rays_from(p)) {
        parts.push_back(with_root(turned.graph(), root));
        parts.back().variables_ = {"s"};
      }
    };
    add_from(result.start, result.from_start);
    add_from(b, result.from_end);
    if (const auto steady = turned.steady_part()) {
      result.steady.push_back(with_root(turned.graph(), *steady));
    }
    return result;
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

}  // namespace polhode
