#include "integrate_on_panels.hpp"

#include <algorithm>
#include <utility>

#include "integrator.hpp"
#include "polhode/arithmetic/text.hpp"
#include "quadrature/formula/poles.hpp"
#include "quadrature/pieces/end_plan.hpp"

namespace polhode::detail {

namespace {

/// Whether f is analytic at x, as far as its values show: then a cut there does not help.
bool is_regular_at(const integrand& f, const end_point& x) {
  const end_point beyond = ends::sum_of(x, end_point(1), 1);
  return ends::is_regular(f, ends::end_of_range::finite(x, beyond));
}

/// Adds x in its place, where it certainly is in the range and none of the cuts, and f is not
/// regular there and understood on both of its sides.
void add_cut(std::vector<end_point>& cuts, const integrand& f, const end_point& x,
             const end_point& a, const end_point& b) {
  constexpr precision p = 192;
  const ball at = x.at(p);
  const auto is_apart = [&](const end_point& c) {
    return certainly_less(c.at(p), at) || certainly_less(at, c.at(p));
  };
  if (!is_inside(x, a, b) || !std::all_of(cuts.begin(), cuts.end(), is_apart) ||
      is_regular_at(f, x) || !can_cut_at(f, x)) {
    return;
  }
  const auto place = std::find_if(cuts.begin(), cuts.end(),
                                  [&](const end_point& c) { return certainly_less(at, c.at(p)); });
  cuts.insert(place, x);
}

}  // namespace

integral integrate_on_panels(const integrand& f, const end_point& a, const end_point& b,
                             const integrate_options& options) {
  integral result;
  long bits = bits_for_digits(options.digits);
  std::vector<end_point> cuts;  // where the range is cut, in order
  range_knowledge known;        // as points: these, the limits, and where cutting does not help
  for (const end_point& end : {a, b}) {
    if (end.exact()) known.points.push_back(*end.exact());
  }
  // In the set, or, for a pole at the set's end, in a larger one; but in the range.
  const auto is_in_range = [&](const ball& x) {
    return is_inside(lower_rational(x), a, b) && is_inside(upper_rational(x), a, b);
  };
  known.pole_in = [&](const ball& x) -> std::optional<ball> {
    if (!x.is_bounded()) return std::nullopt;
    const ball more = x.enlarged(scale(x.radius(), 3));
    if (is_in_range(more)) return pole_in(f, more);
    return is_in_range(x) ? pole_in(f, x) : std::nullopt;
  };
  constexpr std::size_t most_points = 2000;
  constexpr int most_points_without_cut = 4;
  int points_without_cut = 0;  // of interest, as panels seemed to say
  bool counts_as_zero = false;
  long spent = 0;  // evaluations, by all attempts
  if (f.candidates) {
    for (const end_point& x : f.candidates(a, b)) {
      if (!is_inside(x, a, b)) continue;
      if (x.exact()) known.points.push_back(*x.exact());
      add_cut(cuts, f, x, a, b);
    }
  }
  for (int attempts = 0; attempts < 3;) {
    const preparation prepared = prepare(f, a, b, cuts, bits);
    if (prepared.why != reason::none) {
      result.why = prepared.why;
      result.obstacle = prepared.obstacle;
      return result;
    }
    known.is_long = points_without_cut >= most_points_without_cut;
    integrator work(prepared, options, known);
    const contour_integral found = work.run();
    result = real_part(found);
    counts_as_zero = work.counts_as_zero();
    spent += result.account.evaluations + result.account.region_evaluations;
    std::vector<rational>& points = known.points;
    if (points.size() < most_points && spent < options.most_evaluations) {
      const std::size_t before = points.size();
      for (const rational& q : work.points_of_interest()) {
        if (std::find(points.begin(), points.end(), q) != points.end()) continue;
        points.push_back(q);
        const std::size_t cuts_before = cuts.size();
        add_cut(cuts, f, end_point(q), a, b);
        if (cuts.size() == cuts_before) ++points_without_cut;
      }
      if (points.size() > before) continue;
    }
    const bool tail_too_large = prepared.has_tail && result.why == reason::precision_limit;
    if (result.verdict == status::certified || !tail_too_large) break;
    bits *= 2;
    ++attempts;
  }
  if (counts_as_zero) settle_as_zero(result);
  return result;
}

}  // namespace polhode::detail
