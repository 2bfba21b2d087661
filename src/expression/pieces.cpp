// Formulas that are algebraic between rational points: pieces without abs, min, max, floor and
// ceil, polynomials in x and in floors of linear forms, and rational functions of a root.

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "graph.hpp"
#include "polhode/arithmetic/polynomial.hpp"

namespace polhode {
namespace pieces_impl {
namespace {

using detail::node;
using detail::node_id;
using detail::operation;

constexpr node_id most_nodes = 300;  // of a formula

// ---------------------------------------------------------------------------------------------
// Rational roots

/// The different roots of p inside a range, where all of them are rational. With L the leading
/// coefficient of the multiple of p in coprime integers, the denominator of a rational root divides
/// L, and two numbers with such denominators are at least 1/L^2 apart.
class rational_roots {
 public:
  explicit rational_roots(const rational_polynomial& p)
      : p_(p), leading_(abs(primitive_coefficients(p).back())) {}

  /// Appends them in order; false where one of them is irrational, or the search would be long.
  bool add_inside(const rational& lower, const rational& upper,
                  std::vector<rational>& roots) const {
    // 2 log2 L halvings, each with a chain of as many polynomials as the degree.
    constexpr std::size_t most_work = 2000;
    const std::size_t length = mpz_sizeinbase(leading_.backend().data(), 2);
    if (length * static_cast<std::size_t>(p_.degree() + 1) > most_work) return false;
    long count = count_real_roots(p_, lower, upper);
    if (p_(lower) == 0) --count;
    if (p_(upper) == 0) --count;
    if (count == 0) return true;
    if (rational(2 * (upper - lower) * leading_ * leading_) < 1) {
      const rational root = simplest_between(lower, upper);
      if (count > 1 || p_(root) != 0 || root == lower || root == upper) return false;
      roots.push_back(root);
      return true;
    }
    const rational middle = (lower + upper) / 2;
    if (!add_inside(lower, middle, roots)) return false;
    if (p_(middle) == 0) roots.push_back(middle);
    return add_inside(middle, upper, roots);
  }

 private:
  const rational_polynomial& p_;
  integer leading_;
};

/// An end of a range; none where the range is unbounded there.
using bound = std::optional<rational>;

/// The range, where it is bounded, and else a bounded one that has the same roots of p in it: they
/// lie within 1 + max |c_i/c_n| of 0 (A.-L. Cauchy, 1829).
std::pair<rational, rational> with_all_roots(const rational_polynomial& p, const bound& lower,
                                             const bound& upper) {
  rational greatest = 0;
  if (!lower || !upper) {
    for (const rational& c : p.coefficients()) greatest = std::max(greatest, rational(abs(c)));
    greatest = 1 + greatest / abs(p.leading());
  }
  return {lower ? *lower : rational(-greatest), upper ? *upper : greatest};
}

/// A number inside the range.
rational inside(const bound& lower, const bound& upper) {
  if (lower && upper) return (*lower + *upper) / 2;
  return lower ? rational(*lower + 1) : upper ? rational(*upper - 1) : rational(0);
}

/// alpha x + beta.
struct linear_form {
  rational alpha;
  rational beta;
};

std::optional<linear_form> linear_form_of(const rational_polynomial& p) {
  if (p.degree() > 1) return std::nullopt;
  const auto& c = p.coefficients();
  return linear_form{c.size() > 1 ? c[1] : rational(0), c.empty() ? rational(0) : c[0]};
}

// ---------------------------------------------------------------------------------------------
// Graphs with other operands

/// A formula with the root at another node of the graph.
using formula_at = std::function<expression(const detail::graph& g, node_id root)>;

/// A formula's graph, which grows by nodes in the places of its own.
class rewriting {
 public:
  rewriting(const detail::graph& f, formula_at at)
      : g_(f),
        varies_(detail::varying(f)),
        used_(detail::reachable(f)),
        end_(f.root + 1),
        formula_at_(std::move(at)) {}

 protected:
  /// What `made(i)` puts in the place of the root, for each node that varies, in their order.
  template <class Made>
  std::optional<node_id> root_by(const Made& made) {
    place_.assign(end_, 0);
    for (node_id i = 0; i < end_; ++i) {
      place_[i] = i;
      if (used_[i] == 0 || varies_[i] == 0) continue;
      const std::optional<node_id> found = made(i);
      if (!found) return std::nullopt;
      place_[i] = *found;
    }
    return place_[end_ - 1];
  }
  /// Of an abs, min or max: one of its operands, or the negated one. is_positive(d): whether the
  /// node d is >= 0, which decides it, or <= 0; nothing where it is not known.
  template <class IsPositive>
  std::optional<node_id> decided(node_id i, const IsPositive& is_positive) {
    const node n = g_[i];
    const node_id x = place_[n.left];
    const node_id y = n.what == operation::abs ? g_.number(0) : place_[n.right];
    const std::optional<bool> positive = is_positive(detail::subtract(g_, x, y));
    if (!positive) return std::nullopt;
    if (n.what == operation::abs) return *positive ? x : detail::negate(g_, x);
    return *positive == (n.what == operation::max) ? x : y;
  }
  /// The operation of node i, of what is in the places of its operands.
  node_id with_places(node_id i) {
    const node n = g_[i];
    switch (n.what) {
      case operation::negate:
        return detail::negate(g_, place_[n.left]);
      case operation::add:
        return detail::add(g_, place_[n.left], place_[n.right]);
      case operation::subtract:
        return detail::subtract(g_, place_[n.left], place_[n.right]);
      case operation::multiply:
        return detail::multiply(g_, place_[n.left], place_[n.right]);
      default:
        return detail::with_operands(g_, g_, i, [&](node_id k) { return place_[k]; });
    }
  }

  detail::graph g_;
  std::vector<char> varies_;
  std::vector<char> used_;
  node_id end_;
  formula_at formula_at_;
  std::vector<node_id> place_;
};

/// The pieces of a formula.
class separation : rewriting {
 public:
  using rewriting::rewriting;

  std::optional<std::vector<expression::piece>> between(const bound& a, const bound& b,
                                                        std::size_t most) {
    bool any = false;
    for (node_id i = 0; i < end_; ++i) {
      any = any || (used_[i] != 0 && varies_[i] != 0 && detail::is_piecewise(g_[i].what));
    }
    if (!any) return std::nullopt;
    std::vector<expression::piece> result;
    std::vector<std::pair<bound, bound>> open{{a, b}};  // the leftmost is the last
    while (!open.empty()) {
      const bound lower = open.back().first;
      const bound upper = open.back().second;
      open.pop_back();
      points_.clear();
      const auto root = root_by([&](node_id i) { return made(i, lower, upper, most); });
      if (!points_.empty()) {
        if (open.size() + points_.size() + result.size() >= most) return std::nullopt;
        bound end = upper;
        for (std::size_t k = points_.size(); k-- > 0;) {
          open.emplace_back(points_[k], end);
          end = points_[k];
        }
        open.emplace_back(lower, end);
        continue;
      }
      if (!root) return std::nullopt;
      result.push_back({lower, upper, formula_at_(g_, *root)});
    }
    return result;
  }

 private:
  /// Nothing where it is not known, or the range has to be cut at points_.
  std::optional<node_id> made(node_id i, const bound& lower, const bound& upper, std::size_t most) {
    const node n = g_[i];
    if (!detail::is_piecewise(n.what)) return with_places(i);
    if (n.what == operation::floor || n.what == operation::ceil) {
      return step(place_[n.left], n.what == operation::ceil, lower, upper, most);
    }
    return decided(i, [&](node_id d) { return sign(d, lower, upper); });
  }
  /// Whether the rational function is >= 0 inside the range, or <= 0.
  std::optional<bool> sign(node_id of, const bound& lower, const bound& upper) {
    const auto w = formula_at_(g_, of).quotient();
    if (!w) return std::nullopt;
    if (w->numerator.is_zero()) return true;
    std::vector<rational> roots;
    const auto add_roots_of = [&](const rational_polynomial& p) {
      const auto [from, to] = with_all_roots(p, lower, upper);
      return !(from < to) || rational_roots(p).add_inside(from, to, roots);
    };
    if (!add_roots_of(w->numerator)) return std::nullopt;
    for (const repeated_factor& d : w->divisors) {
      if (!add_roots_of(d.factor)) return std::nullopt;
    }
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    points_ = std::move(roots);
    if (!points_.empty()) return std::nullopt;
    const rational middle = inside(lower, upper);
    bool positive = w->numerator(middle) > 0;
    for (const repeated_factor& d : w->divisors) {
      if (d.multiplicity % 2 != 0 && d.factor(middle) < 0) positive = !positive;
    }
    return positive;
  }
  /// The whole number that floor or ceil of a linear form is inside the range.
  std::optional<node_id> step(node_id of, bool up, const bound& lower, const bound& upper,
                              std::size_t most) {
    const auto p = formula_at_(g_, of).polynomial();
    const auto form = p ? linear_form_of(*p) : std::nullopt;
    if (!form || ((!lower || !upper) && form->alpha != 0)) return std::nullopt;
    const rational at_lower = (*p)(lower ? *lower : rational(0));
    const rational at_upper = (*p)(upper ? *upper : rational(0));
    const rational first = std::min(at_lower, at_upper);
    const rational last = std::max(at_lower, at_upper);
    const integer from = floor_of(first) + 1;
    const integer to = ceil_of(last) - 1;  // whole numbers strictly between
    if (form->alpha != 0 && from <= to) {
      if (to - from >= most) return std::nullopt;
      for (integer k = from; k <= to; ++k)
        points_.push_back((rational(k) - form->beta) / form->alpha);
      std::sort(points_.begin(), points_.end());
      return std::nullopt;
    }
    const rational middle = (*p)(inside(lower, upper));
    return g_.number(rational(up ? ceil_of(middle) : floor_of(middle)));
  }

  std::vector<rational> points_;
};

/// A formula without abs, min and max, where their signs are known.
class with_known_signs : rewriting {
 public:
  using rewriting::rewriting;

  std::optional<expression> found(
      const std::function<std::optional<bool>(const expression&)>& is_positive) {
    bool any = false;
    const auto root = root_by([&](node_id i) -> std::optional<node_id> {
      const operation what = g_[i].what;
      if (what != operation::abs && what != operation::min && what != operation::max) {
        return with_places(i);
      }
      any = true;
      return decided(i, [&](node_id d) { return is_positive(formula_at_(g_, d)); });
    });
    return root && any ? std::optional(formula_at_(g_, *root)) : std::nullopt;
  }
};

/// A formula with numbers in place of its steps.
class numbered_steps : rewriting {
 public:
  using rewriting::rewriting;

  expression::stepped with(const std::vector<integer>& values) {
    using step = expression::stepped::step;
    step next = step::none;
    node_id argument = 0;
    std::size_t known = 0;
    const auto root = root_by([&](node_id i) -> std::optional<node_id> {
      const operation what = g_[i].what;
      if (what != operation::floor && what != operation::ceil) return with_places(i);
      if (known < values.size()) return g_.number(rational(values[known++]));
      next = what == operation::floor ? step::floor : step::ceil;
      argument = place_[g_[i].left];
      return std::nullopt;
    });
    return {next, formula_at_(g_, root ? *root : argument)};
  }
};

/// A polynomial in x and in steps.
class steps : rewriting {
 public:
  using rewriting::rewriting;

  std::optional<expression::staircase> found() {
    std::vector<long> degree(end_, 0);
    std::optional<rational> period;
    for (node_id i = 0; i < end_; ++i) {
      if (used_[i] == 0 || varies_[i] == 0) continue;
      const node n = g_[i];
      switch (n.what) {
        case operation::variable:
          degree[i] = 1;
          break;
        case operation::negate:
          degree[i] = degree[n.left];
          break;
        case operation::add:
        case operation::subtract:
          degree[i] = std::max(degree[n.left], degree[n.right]);
          break;
        case operation::multiply:
          degree[i] = degree[n.left] + degree[n.right];
          break;
        case operation::divide:
          if (varies_[n.right] != 0) return std::nullopt;
          degree[i] = degree[n.left];
          break;
        case operation::power_integer:
          if (n.number < 0 || n.number > most_degree) return std::nullopt;
          degree[i] = degree[n.left] * n.number;
          break;
        case operation::floor:
        case operation::ceil: {
          const auto p = formula_at_(g_, n.left).polynomial();
          const auto form = p ? linear_form_of(*p) : std::nullopt;
          if (!form || form->alpha == 0) return std::nullopt;
          const rational own = abs(1 / form->alpha);
          period = period ? least_common_multiple(*period, own) : own;
          degree[i] = 1;
          break;
        }
        default:
          return std::nullopt;
      }
      if (degree[i] > most_degree) return std::nullopt;
    }
    if (!period) return std::nullopt;
    return expression::staircase{*period, degree[end_ - 1]};
  }

 private:
  static constexpr long most_degree = 64;

  static rational least_common_multiple(const rational& p, const rational& q) {
    return rational(lcm(numerator(p), numerator(q))) /
           rational(gcd(denominator(p), denominator(q)));
  }
};

/// Rational functions of a root of a linear form.
class rooted : rewriting {
 public:
  using rewriting::rewriting;

  std::optional<expression::in_root> found() {
    if (!find_form()) return std::nullopt;
    const node_id u = g_.variable(0);
    const node_id x = detail::divide(
        g_, detail::subtract(g_, detail::power(g_, u, g_.number(q_)), g_.number(form_->beta)),
        g_.number(form_->alpha));
    const auto root = root_by([&](node_id i) -> std::optional<node_id> {
      if (g_[i].what == operation::variable) return x;
      if (const auto e = detail::fractional_exponent_at(g_, i))
        return detail::power(g_, u, g_.number(*e * q_));
      return with_places(i);
    });
    const node_id slope =
        detail::multiply(g_, g_.number(q_ / form_->alpha), detail::power(g_, u, g_.number(q_ - 1)));
    return expression::in_root{form_->alpha, form_->beta, q_,
                               formula_at_(g_, detail::multiply(g_, *root, slope))};
  }

 private:
  static constexpr long most_degree = 64;  // of u^q

  /// The form that all roots are of, and the common denominator of the exponents.
  bool find_form() {
    integer q = 1;
    for (node_id i = 0; i < end_; ++i) {
      if (used_[i] == 0 || varies_[i] == 0) continue;
      const auto e = detail::fractional_exponent_at(g_, i);
      if (!e) continue;
      q = lcm(q, denominator(*e));
      if (q > most_degree) return false;
      const auto p = formula_at_(g_, g_[i].left).polynomial();
      const auto form = p ? linear_form_of(*p) : std::nullopt;
      if (!form || form->alpha == 0) return false;
      if (form_ && (form->alpha != form_->alpha || form->beta != form_->beta)) return false;
      form_ = form;
    }
    q_ = static_cast<long>(q);
    return form_.has_value();
  }

  std::optional<linear_form> form_;
  long q_ = 1;
};

}  // namespace
}  // namespace pieces_impl

std::optional<std::vector<expression::piece>> expression::pieces(const std::optional<rational>& a,
                                                                 const std::optional<rational>& b,
                                                                 std::size_t most) const {
  if (variables_.size() != 1 || graph_->size() > pieces_impl::most_nodes) return std::nullopt;
  bool any = false;
  for (detail::node_id i = 0; i <= graph_->root; ++i) {
    any = any || detail::is_piecewise((*graph_)[i].what);
  }
  if (!any) return std::nullopt;
  try {
    return pieces_impl::separation(
               *graph_,
               [this](const detail::graph& g, detail::node_id root) { return with_root(g, root); })
        .between(a, b, most);
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

std::optional<expression> expression::without_kinks(
    const std::function<std::optional<bool>(const expression&)>& is_positive) const {
  if (graph_->size() > pieces_impl::most_nodes) return std::nullopt;
  try {
    return pieces_impl::with_known_signs(
               *graph_,
               [this](const detail::graph& g, detail::node_id root) { return with_root(g, root); })
        .found(is_positive);
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

std::optional<expression::stepped> expression::with_steps(
    const std::vector<integer>& values) const {
  try {
    return pieces_impl::numbered_steps(
               *graph_,
               [this](const detail::graph& g, detail::node_id root) { return with_root(g, root); })
        .with(values);
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

std::optional<expression::staircase> expression::as_staircase() const {
  if (variables_.size() != 1 || graph_->size() > pieces_impl::most_nodes) return std::nullopt;
  return pieces_impl::steps(*graph_, [this](const detail::graph& g,
                                            detail::node_id root) { return with_root(g, root); })
      .found();
}

std::optional<expression::in_root> expression::by_root() const {
  if (variables_.size() != 1 || graph_->size() > pieces_impl::most_nodes) return std::nullopt;
  try {
    return pieces_impl::rooted(*graph_, [this](const detail::graph& g,
                                               detail::node_id root) { return with_root(g, root); })
        .found();
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

}  // namespace polhode
