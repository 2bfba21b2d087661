// The real roots of a polynomial without multiple roots, by continued fractions (A. J. H. Vincent,
// 1836; A. G. Akritas, A. W. Strzebonski, A comparative study of two real root isolation methods,
// 2005).
//
// The positive roots are looked for as x = (a t + b)/(c t + d) with t > 0 and integers a, b, c, d
// >= 0, ad - bc = +-1 times a power of two: q(t) = (c t + d)^n p(x) has integer coefficients. Let
// v(q) be the number of sign changes in the coefficients of q.
//   Descartes' rule: q has v(q) positive roots, or fewer by an even number.
//   Budan's theorem: q has v(q) - v(q(t + 1)) roots with 0 < t <= 1, or fewer by an even number,
//     if roots are counted with multiplicities.
// So 0 proves that there is none, and 1 that there is exactly one. Otherwise the part with t > 1
// goes on as q(t + 1), and the part with t < 1 as (t + 1)^n q(1/(t + 1)); t = 1 is no root, because
// the rational roots were divided out before. By Vincent's theorem this ends, as no root is
// multiple. Where all positive roots seem to be above 2^k, t is replaced by 2^k t first: that is a
// guess for speed, as Budan's theorem proves afterwards that nothing was lost.

#include "real_roots.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "rational_roots.hpp"
#include "root_bracket.hpp"
#include "taylor_shift.hpp"

namespace polhode::detail {
namespace {

using whole_coefficients = std::vector<integer>;

/// log2 of |n|, rounded somehow; n is not 0.
double log2_abs(const integer& n) {
  long exponent = 0;
  const double fraction = mpz_get_d_2exp(&exponent, n.backend().data());
  return std::log2(std::abs(fraction)) + static_cast<double>(exponent);
}

/// About log2 of a lower bound of the positive roots: the local-max-quadratic bound of the reversed
/// polynomial (A. G. Akritas, A. W. Strzebonski, P. S. Vigklas, Quadratic complexity bounds on the
/// values of positive roots of polynomials, 2009).
double log2_below_roots(const whole_coefficients& q) {
  const std::size_t n = q.size() - 1;
  const int leading = q.front().sign();  // of the reversed polynomial
  std::vector<double> size(q.size());
  std::vector<double> uses(q.size(), 1);
  for (std::size_t k = 0; k <= n; ++k) size[k] = q[k] == 0 ? 0 : log2_abs(q[k]);
  double most = -std::numeric_limits<double>::infinity();
  // x^(n - k) in the reversed polynomial has the coefficient q[k].
  for (std::size_t k = 1; k <= n; ++k) {
    if (q[k] == 0 || q[k].sign() == leading) continue;
    double least = std::numeric_limits<double>::infinity();
    std::size_t used = 0;
    for (std::size_t j = 0; j < k; ++j) {
      if (q[j] == 0 || q[j].sign() != leading) continue;
      const double bound = (size[k] - size[j] + uses[j]) / static_cast<double>(k - j);
      if (bound < least) {
        least = bound;
        used = j;
      }
    }
    uses[used] += 1;
    most = std::max(most, least);
  }
  return -most;
}

/// Divided by the greatest common power of two.
void make_shorter(whole_coefficients& q) {
  mp_bitcnt_t common = std::numeric_limits<mp_bitcnt_t>::max();
  for (const integer& c : q) {
    if (c != 0) common = std::min(common, mpz_scan1(c.backend().data(), 0));
  }
  if (common == 0) return;
  for (integer& c : q) mpz_tdiv_q_2exp(c.backend().data(), c.backend().data(), common);
}

/// q(2^k t), k > 0.
void scale_argument(whole_coefficients& q, unsigned long k) {
  for (std::size_t i = 0; i < q.size(); ++i) q[i] <<= k * i;
  make_shorter(q);
}

/// x = (a t + b)/(c t + d).
struct moebius_map {
  integer a = 1;
  integer b = 0;
  integer c = 0;
  integer d = 1;
};

class positive_roots {
 public:
  positive_roots(const whole_coefficients& p, const std::function<bool()>& go_on)
      : go_on_(go_on), bound_(root_bound(as_polynomial(p))) {
    pending_.push_back({p, {}, sign_changes(p)});
  }

  /// The brackets in ascending order; std::nullopt where go_on returned false.
  std::optional<std::vector<exact_interval>> run() {
    while (!pending_.empty()) {
      if (!go_on_()) return std::nullopt;
      ++steps_;
      node q = std::move(pending_.back());
      pending_.pop_back();
      if (q.changes == 1) {
        add_bracket(q.map);
      } else if (q.changes > 1) {
        divide(std::move(q));
      }
    }
    std::sort(found_.begin(), found_.end(),
              [](const exact_interval& x, const exact_interval& y) { return *x.lower < *y.lower; });
    return std::move(found_);
  }
  [[nodiscard]] long steps() const { return steps_; }

 private:
  struct node {
    whole_coefficients q;
    moebius_map map;
    long changes;
  };

  static rational_polynomial as_polynomial(const whole_coefficients& p) {
    return rational_polynomial(std::vector<rational>(p.begin(), p.end()));
  }

  /// t = 0 and t = infinity are the ends; beyond the bound there is no root.
  void add_bracket(const moebius_map& m) {
    const auto value = [&](const integer& above, const integer& below) {
      return below == 0 ? bound_ : rational(above, below);
    };
    rational x = value(m.b, m.d);
    rational y = value(m.a, m.c);
    if (y < x) std::swap(x, y);
    found_.push_back({std::move(x), std::move(y)});
  }

  void divide(node n) {
    constexpr double greatest_step = 1e6;
    const double below = log2_below_roots(n.q);
    if (below >= 1) {
      const auto k = static_cast<unsigned long>(std::min(below, greatest_step));
      scale_argument(n.q, k);
      n.map.a <<= k;
      n.map.c <<= k;
    }
    moebius_map& m = n.map;
    whole_coefficients beyond = shifted_by_one(n.q);  // t > 1
    const long changes_beyond = sign_changes(beyond);
    const long changes_before = n.changes - changes_beyond;  // 0 < t <= 1
    const integer a_and_b = m.a + m.b;
    const integer c_and_d = m.c + m.d;
    const moebius_map before_map{m.b, a_and_b, m.d, c_and_d};
    if (changes_before == 1) {
      add_bracket(before_map);
    } else if (changes_before > 1) {
      std::reverse(n.q.begin(), n.q.end());
      whole_coefficients before = shifted_by_one(n.q);
      const long changes = sign_changes(before);
      make_shorter(before);
      if (changes > 0) pending_.push_back({std::move(before), before_map, changes});
    }
    if (changes_beyond > 0) {
      make_shorter(beyond);
      pending_.push_back({std::move(beyond), {m.a, a_and_b, m.c, c_and_d}, changes_beyond});
    }
  }

  const std::function<bool()>& go_on_;
  rational bound_;
  std::vector<node> pending_;
  std::vector<exact_interval> found_;
  long steps_ = 0;
};

/// p(-x).
whole_coefficients mirrored(whole_coefficients p) {
  for (std::size_t k = 1; k < p.size(); k += 2) p[k] = -p[k];
  return p;
}
exact_interval mirrored(const exact_interval& x) {
  return {rational(-*x.upper), rational(-*x.lower)};
}

rational power(const rational& x, unsigned long k) {
  const mpq_srcptr q = x.backend().data();
  rational result;
  mpz_pow_ui(mpq_numref(result.backend().data()), mpq_numref(q), k);
  mpz_pow_ui(mpq_denref(result.backend().data()), mpq_denref(q), k);
  return result;
}

/// A bracket of the positive root x with x^k in the bracket of r's root y > 0: between its k-th
/// powers r has that root alone.
exact_interval root_of_bracket(polynomial_values& r, const exact_interval& y, unsigned long k) {
  constexpr long first_bits = 16;
  for (long bits = first_bits;; bits *= 2) {
    const exact_interval sharper = narrowed(r, y, bits);
    const precision p = bits + 16;
    const ball x = root(sharper.to_ball(p), k);
    if (!x.is_bounded()) continue;
    exact_interval result{lower_rational(x), upper_rational(x)};
    if (*result.lower >= 0 && power(*result.lower, k) >= *y.lower &&
        power(*result.upper, k) <= *y.upper) {
      return result;
    }
  }
}

/// Of p without rational roots.
std::optional<std::vector<exact_interval>> brackets_of(const whole_coefficients& p,
                                                       const std::function<bool()>& go_on,
                                                       long& steps) {
  const auto k = static_cast<unsigned long>(common_exponent(p));
  whole_coefficients r;
  for (std::size_t i = 0; i < p.size(); i += k) r.push_back(p[i]);
  // By the k-th roots of r's roots, where these are irrational like those of p.
  const bool by_powers =
      k > 1 && rational_roots_of(rational_polynomial({r.begin(), r.end()})).roots.empty();
  const auto positive = [&](const whole_coefficients& q) {
    positive_roots search(q, go_on);
    auto found = search.run();
    steps += search.steps();
    if (found && by_powers) {
      polynomial_values values(q);
      for (exact_interval& y : *found) y = root_of_bracket(values, y, k);
    }
    return found;
  };
  const whole_coefficients& q = by_powers ? r : p;
  const auto above = positive(q);
  if (!above) return std::nullopt;
  const auto below = k % 2 == 0 ? above : positive(mirrored(q));
  if (!below) return std::nullopt;
  std::vector<exact_interval> result;
  std::transform(below->rbegin(), below->rend(), std::back_inserter(result),
                 [](const exact_interval& x) { return mirrored(x); });
  result.insert(result.end(), above->begin(), above->end());
  return result;
}

}  // namespace

std::optional<separated_roots> separate_real_roots(const rational_polynomial& p,
                                                   const std::function<bool()>& go_on) {
  separated_roots result;
  rational_roots known = rational_roots_of(p);
  result.exact = std::move(known.roots);
  result.rest = std::move(known.rest);
  if (result.rest.size() == 1) return result;
  auto brackets = brackets_of(result.rest, go_on, result.steps);
  if (!brackets) return std::nullopt;
  result.brackets = std::move(*brackets);
  return result;
}

}  // namespace polhode::detail
