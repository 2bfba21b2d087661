#include "breaks.hpp"

#include <memory>
#include <utility>

#include "break_point.hpp"
#include "covering.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "quadrature/formula/formula_graph.hpp"

namespace polhode::detail {

using breaks::break_point;
using breaks::covering;
using breaks::crossing;
using breaks::interval;
using breaks::stretch;

namespace {

/// A bound of |g| and of f with these branches over x; infinite where one is not bounded.
magnitude bound_over(const formula_graph& f, const integrand& g, const ball& x,
                     std::initializer_list<const choices*> branches) {
  const precision p = x.precision();
  magnitude bound = g.evaluator(p)(x).magnitude_upper();
  for (const choices* c : branches) {
    if (c->empty()) continue;
    const slope_jet value = evaluate(f, p, slope_jet::variable(x), *c, f.result())[f.result()];
    bound = max(bound, value[0].magnitude_upper());
  }
  return bound;
}

/// The point between two pieces.
struct cut {
  end_point at;
  std::optional<crossing> crosses;
};

/// g, with f's branches in place of what it is made of; and what is known at an end of the piece.
integrand with_branches(const std::shared_ptr<const formula_graph>& f, const integrand& g,
                        const std::shared_ptr<const choices>& chosen,
                        const std::optional<crossing>& at_end) {
  integrand result = g;
  result.graph = nullptr;
  if (chosen->empty()) return result;
  // f's symmetries are not those of one of its pieces, continued: |sin| is even about 0.
  result.under = nullptr;
  result.pieces = nullptr;
  result.with_limits = nullptr;
  result.scaled = nullptr;

  result.in_exponential = nullptr;
  result.antiderivative = nullptr;
  result.on_turned_rays = nullptr;
  result.folded_at_infinity = nullptr;
  result.between_turned_rays = nullptr;
  result.by_exponential = nullptr;
  result.angle_evaluator = nullptr;
  result.over = [f, chosen](const region& x) {
    return evaluate(*f, x.precision(), x, *chosen, f->result())[f->result()];
  };
  // A step function may have another value at points where its operand touches an integer.
  bool steps = false;
  for (std::size_t i = 0; i < f->size(); ++i) {
    const operation what = f->node(i).what;
    steps = steps || what == operation::floor || what == operation::ceil;
  }
  if (steps) {
    result.evaluator = [f, chosen](precision p) -> std::function<ball(const ball&)> {
      evaluation<ball> constants(*f, p, ball(0, p));
      for (std::size_t i = 0; i < f->size(); ++i) {
        if (f->node(i).is_constant()) constants.step(i, std::nullopt);
      }
      return [f, chosen, constants](const ball& x) {
        evaluation<ball> values = constants;
        values.set_argument(x);
        for (std::size_t i = 0; i <= f->result(); ++i) {
          if (!f->node(i).is_constant()) values.step(i, (*chosen)[i]);
        }
        return values[f->result()];
      };
    };
  }
  result.near_end = [f, chosen, at_end](const end_series& x) {
    evaluation<end_series> values(*f, 192, x);
    for (std::size_t i = 0; i <= f->result(); ++i) {
      values.step(i, (*chosen)[i]);
      if (at_end && at_end->decider == i) values[i] = values[i].with_value_at_0(at_end->n);
    }
    return values[f->result()];
  };
  return result;
}

/// The pieces of f's range, from the covering: each cut lies between two of them, and each has one
/// set of branches.
class assembly {
 public:
  /// f is g's graph; the range from a to b, with `fine` bits.
  assembly(std::shared_ptr<const formula_graph> f, const integrand& g, const end_point& a,
           const end_point& b, precision fine)
      : f_(std::move(f)), g_(g), a_(a), b_(b), fine_(fine), start_(a.at(fine)), end_(b.at(fine)) {}

  /// False where f or what stands for it is not bounded on something that is left out.
  [[nodiscard]] bool add(const std::vector<stretch>& stretches) {
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const stretch& s = stretches[i];
      if (s.what == stretch::form::short_one) {
        interval gap = s.x;
        while (i + 1 < stretches.size() && stretches[i + 1].what == stretch::form::short_one) {
          gap.high = stretches[++i].x.high;
        }
        if (!add_gap(gap, i + 1 < stretches.size() ? &stretches[i + 1] : nullptr)) return false;
        continue;
      }
      add_continued(s);  // of an unresolved one, without branches
      if (s.what == stretch::form::broken) add_break(s);
    }
    return !branches_.empty();
  }
  /// Drops the cuts that may be at or beyond an end of the range. False as in `add`.
  [[nodiscard]] bool drop_outer_cuts() {
    while (!cuts_.empty() && !certainly_less(cuts_.back().at.at(fine_), end_)) {
      const ball last = cuts_.back().at.at(fine_);
      const std::size_t n = branches_.size();
      if (!certainly_less(end_, last) &&
          !leave_out(hull(last, end_), branches_[n - 2], branches_[n - 1])) {
        return false;
      }
      cuts_.pop_back();
      branches_.pop_back();
    }
    while (!cuts_.empty() && !certainly_less(start_, cuts_.front().at.at(fine_))) {
      const ball first = cuts_.front().at.at(fine_);
      if (!certainly_less(first, start_) &&
          !leave_out(hull(start_, first), branches_[0], branches_[1])) {
        return false;
      }
      cuts_.erase(cuts_.begin());
      branches_.erase(branches_.begin());
    }
    return true;
  }
  [[nodiscard]] pieces_of_range result() {
    for (std::size_t i = 0; i < branches_.size(); ++i) {
      const auto chosen = std::make_shared<const choices>(std::move(branches_[i]));
      const bool has_left = i > 0;
      const bool has_right = i < cuts_.size();
      const std::optional<crossing> left = has_left ? cuts_[i - 1].crosses : std::nullopt;
      const std::optional<crossing> right = has_right ? cuts_[i].crosses : std::nullopt;
      result_.pieces.push_back({has_left ? cuts_[i - 1].at : a_, has_right ? cuts_[i].at : b_,
                                with_branches(f_, g_, chosen, std::nullopt),
                                with_branches(f_, g_, chosen, left),
                                with_branches(f_, g_, chosen, right)});
    }
    return std::move(result_);
  }

 private:
  void add_continued(const stretch& s) {
    if (!branches_.empty() && branches_.back() == s.before) return;
    if (!branches_.empty()) cuts_.push_back({end_point(s.x.low), std::nullopt});
    branches_.push_back(s.before);
  }
  void add_break(const stretch& s) {
    const auto point = std::make_shared<break_point>(f_, *s.crosses, s.before, s.x);
    const std::optional<rational> q = point->as_rational();
    cuts_.push_back(
        {q ? end_point(*q) : end_point([point](precision p) { return point->at(p); }), s.crosses});
    branches_.push_back(s.beyond);
  }
  /// What is too short, before the next stretch, if there is one.
  [[nodiscard]] bool add_gap(const interval& gap, const stretch* next) {
    const choices none;
    const choices before = branches_.empty() ? none : branches_.back();
    const choices beyond = next == nullptr ? none : next->before;
    if (!leave_out(gap.set(fine_), before, beyond)) return false;
    if (next == nullptr || branches_.empty() || before == beyond) return true;
    cuts_.push_back({end_point(gap.middle()), std::nullopt});
    branches_.push_back(beyond);
    return true;
  }
  /// False where f or what stands for it is not bounded there.
  [[nodiscard]] bool leave_out(const ball& x, const choices& before, const choices& beyond) {
    const magnitude bound = bound_over(*f_, g_, x, {&before, &beyond});
    if (bound.is_infinite()) return false;
    const ball width(rational(upper_rational(x) - lower_rational(x)), 64);
    result_.remainder =
        result_.remainder.enlarged(multiply_up(width.magnitude_upper(), scale(bound, 1)));
    result_.has_remainder = true;
    return true;
  }

  std::shared_ptr<const formula_graph> f_;
  const integrand& g_;
  const end_point& a_;
  const end_point& b_;
  precision fine_;
  ball start_;
  ball end_;
  std::vector<cut> cuts_;
  std::vector<choices> branches_;
  pieces_of_range result_;
};

}  // namespace

unsigned long exponent_beyond_breaks(const integrand& g, unsigned long e, int sign) {
  if (!g.graph) return e;
  const std::shared_ptr<const formula_graph> f = g.graph();
  if (!f->has_breaks()) return e;
  constexpr unsigned long most = 16;
  constexpr precision p = 96;
  mpfr_float unbounded = zero_of_precision(p);
  mpfr_set_inf(unbounded.backend().data(), 1);
  for (unsigned long n = e; n <= e + most; ++n) {
    const ball start = scale(ball(1, p), static_cast<long>(n));
    const ball x = from_end_points(midpoint(start), unbounded, p);
    const ball undefined = ball::undefined(p);
    const bool decided = (sign > 0 ? breaks::trace(*f, x, start, undefined, nullptr, 0)
                                   : breaks::trace(*f, -x, undefined, -start, nullptr, 0))
                             .decided;
    if (decided) return n;
  }
  return e;
}

pieces_of_range analytic_pieces(const integrand& g, const end_point& a, const end_point& b,
                                long bits) {
  const auto as_it_is = [&] {
    pieces_of_range result;
    result.pieces.push_back({a, b, g, g, g});
    return result;
  };
  if (!g.graph) return as_it_is();
  const std::shared_ptr<const formula_graph> f = g.graph();
  if (!f->has_breaks()) return as_it_is();
  const precision fine = bits + bits / 16 + 64;
  const ball start = a.at(fine);
  const ball end = b.at(fine);
  if (!certainly_less(start, end)) return as_it_is();
  interval whole{lower_rational(start), upper_rational(end)};
  if (a.exact()) whole.low = *a.exact();
  if (b.exact()) whole.high = *b.exact();
  if (g.over(region(ball(whole.middle(), 64))).why() == obstacle::unknown) return as_it_is();

  const covering cover(*f, g, a, b, whole, fine);
  if (!cover.has_branches()) return as_it_is();
  assembly parts(f, g, a, b, fine);
  if (!parts.add(cover.stretches()) || !parts.drop_outer_cuts()) return as_it_is();
  return parts.result();
}

}  // namespace polhode::detail
