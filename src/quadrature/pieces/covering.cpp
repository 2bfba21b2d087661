#include "covering.hpp"

#include <algorithm>
#include <utility>

#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/multiple_of_pi.hpp"
#include "quadrature/pieces/breaks.hpp"
#include "quadrature/pieces/end_plan.hpp"

namespace polhode::detail::breaks {

namespace {

/// An end that is no rational number, where it is known exactly.
std::optional<end_point> irrational_end(const end_point& x) {
  if (x.exact() || (!x.form() && !formula_of(x))) return std::nullopt;
  return x;
}

}  // namespace

covering::covering(const formula_graph& f, const integrand& g, const end_point& a,
                   const end_point& b, const interval& whole, long bits)
    : f_(f),
      g_(g),
      whole_(whole),
      ends_{irrational_end(a), irrational_end(b)},
      least_log2_width_(whole.log2_width() - bits),
      most_effort_(1e6 + static_cast<double>(bits) * static_cast<double>(bits) / 2) {
  cover();
}

bool covering::has_branches() const {
  return std::any_of(stretches_.begin(), stretches_.end(), [](const stretch& s) {
    return s.what == stretch::form::plain || s.what == stretch::form::broken;
  });
}

void covering::cover() {
  constexpr long most_breaks = 4000;
  std::vector<interval> open{whole_};
  while (!open.empty()) {
    const interval x = open.back();
    open.pop_back();
    if (effort_ > most_effort_ || breaks_ > most_breaks) {
      stretches_.clear();
      return;
    }
    const traced t = traced_over(x, nullptr, 0);
    if (std::optional<stretch> s = resolved(x, t)) {
      stretches_.push_back(*std::move(s));
    } else if (std::vector<stretch> sides = beside_a_rational(x); !sides.empty()) {
      for (stretch& side : sides) stretches_.push_back(std::move(side));
      ++breaks_;
    } else if (std::optional<stretch> around = around_a_multiple_of_pi(x)) {
      stretches_.push_back(*std::move(around));
    } else if (std::optional<stretch> last = up_to_an_end(x)) {
      stretches_.push_back(*std::move(last));
    } else {
      split(x, t, open);
    }
  }
}

std::optional<stretch> covering::resolved(const interval& x, const traced& t) {
  using form = stretch::form;
  if (t.decided) return stretch{x, form::plain, t.chosen, {}, std::nullopt};
  if (t.crosses) {
    traced before = traced_over(x, &*t.suspect, -1);
    traced beyond = traced_over(x, &*t.suspect, 1);
    if (before.decided && beyond.decided) {
      ++breaks_;
      return stretch{x, form::broken, std::move(before.chosen), std::move(beyond.chosen),
                     t.suspect};
    }
  }
  const bool is_short = x.log2_width() < least_log2_width_;
  const precision p = x.bits();
  const bool hopeless = x.level >= 40 && !g_.evaluator(p)(x.set(p)).is_bounded();
  if (!is_short && !hopeless) return std::nullopt;
  // Near such a point breaks may crowd.
  if (hopeless) most_effort_ = std::min(most_effort_, effort_ + 5e4);
  return stretch{x, hopeless ? form::unresolved : form::short_one, {}, {}, std::nullopt};
}

// Series take the time of many evaluations: they are not tried for ever.
constexpr long most_tries = 200;
constexpr double effort_of_series = 100;

bool covering::is_away_from_changes(const ball& m) {
  effort_ += static_cast<double>(f_.size());
  return breaks::is_away_from_changes(f_, m);
}

std::vector<stretch> covering::beside_a_rational(const interval& x) {
  ++asked_;
  if (tries_ > most_tries) return {};
  const rational m = simplest_between(x.low, x.high);
  if (is_away_from_changes(ball(m, x.bits()))) return {};
  ++tries_;
  std::vector<stretch> sides;
  for (const int side : {-1, 1}) {
    const rational reach = side < 0 ? m - x.low : x.high - m;
    if (reach == 0) continue;
    effort_ += effort_of_series * static_cast<double>(f_.size());
    std::optional<choices> chosen = branches_beside(f_, known_number(m), side, reach);
    if (!chosen) return {};
    const interval part = side < 0 ? interval{x.low, m, x.level} : interval{m, x.high, x.level};
    sides.push_back({part, stretch::form::plain, *std::move(chosen), {}, std::nullopt});
  }
  return sides;
}

std::optional<stretch> covering::around_a_multiple_of_pi(const interval& x) {
  constexpr long each = 4;  // of the intervals where a rational number was tried
  if (tries_ > most_tries || asked_ % each != 0) return std::nullopt;
  const precision p = x.bits() + 64;
  const std::optional<rational> turns = simplest_multiple_of_pi(x.low, x.high, p);
  if (!turns) return std::nullopt;
  const pi_combination m{0, *turns};
  if (is_away_from_changes(m.at(p))) return std::nullopt;
  ++tries_;
  const known_number exact(m);
  const rational above = upper_rational(ball(x.high, p) - m.at(p));
  const rational below = upper_rational(m.at(p) - ball(x.low, p));
  effort_ += effort_of_series * static_cast<double>(f_.size());
  std::optional<choices> before = branches_beside(f_, exact, -1, below);
  if (!before) return std::nullopt;
  effort_ += effort_of_series * static_cast<double>(f_.size());
  const std::optional<choices> beyond = branches_beside(f_, exact, 1, above);
  if (!beyond || *before != *beyond) return std::nullopt;
  return stretch{x, stretch::form::plain, *std::move(before), {}, std::nullopt};
}

std::optional<stretch> covering::up_to_an_end(const interval& x) {
  const precision p = x.bits() + 64;
  for (const int side : {1, -1}) {
    const std::optional<end_point>& end = ends_.at(side > 0 ? 0 : 1);
    const bool touches = side > 0 ? x.low == whole_.low : x.high == whole_.high;
    if (!touches || !end || tries_ > most_tries) continue;
    const ball at = end->at(p);
    if (is_away_from_changes(at)) continue;
    const ball length = side > 0 ? ball(x.high, p) - at : at - ball(x.low, p);
    if (!certainly_positive(length)) continue;
    ++tries_;
    effort_ += effort_of_series * static_cast<double>(f_.size());
    std::optional<choices> chosen =
        branches_beside(f_, ends::exactly(*end), side, upper_rational(length));
    if (chosen) return stretch{x, stretch::form::plain, *std::move(chosen), {}, std::nullopt};
  }
  return std::nullopt;
}

/// Into halves; or, where the decider can only be n within a short interval, into that and what is
/// beside it.
void covering::split(const interval& x, const traced& t, std::vector<interval>& open) const {
  const precision p = x.bits();
  // The middle between irrational ends, rounded, is very close to a break there.
  const bool avoids_middle = x.level == 0 && (ends_[0] || ends_[1]);
  std::vector<rational> cuts{avoids_middle ? rational(x.low + x.width() * rational(7, 16))
                                           : x.middle()};
  if (t.suspect) {
    // As in break_point::refine.
    const std::size_t d = t.suspect->decider;
    const ball middle(x.middle(), p);
    const ball value =
        evaluate(f_, p, slope_jet::variable(middle), t.chosen, d)[d][0] - t.suspect->n;
    const ball zero = intersection(middle - value / t.slope, x.set(p));
    if (zero.is_bounded()) {
      // A little wider, so that the signs at the ends can be told.
      const magnitude margin = scale(ball(x.width(), 64).magnitude_upper(), -p / 4);
      const ball grown = zero.enlarged(margin);
      const rational low = lower_rational(grown);
      const rational high = upper_rational(grown);
      if (high - low < x.width() / 8) {
        cuts.clear();
        if (low > x.low) cuts.push_back(low);
        if (high < x.high) cuts.push_back(high);
      }
    }
  }
  cuts.push_back(x.high);
  std::vector<interval> parts;
  rational start = x.low;
  for (const rational& end : cuts) {
    interval part{start, end, 0};
    part.level = x.level + std::max(1L, static_cast<long>(x.log2_width() - part.log2_width()));
    parts.push_back(part);
    start = end;
  }
  open.insert(open.end(), parts.rbegin(), parts.rend());
}

traced covering::traced_over(const interval& x, const crossing* given, int side) {
  const precision p = x.bits();
  effort_ += static_cast<double>(f_.size()) * (1 + static_cast<double>(p) / 256);
  return trace(f_, x.set(p), ball(x.low, p), ball(x.high, p), given, side);
}

}  // namespace polhode::detail::breaks
