#include "polynomial.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "polhode/arithmetic/interval.hpp"
#include "roots/polynomial/real_roots.hpp"
#include "roots/polynomial/root_bracket.hpp"

namespace polhode::detail {
namespace {

/// A part of the range with exactly one root of the factor.
struct placed_root {
  exact_box x;
  root_region region;
};

/// Whether the range holds the root in the bracket, which is cut at an end of the range inside it.
/// The root is no rational number, so the sign of p at the end decides.
bool cut_to_range(exact_box& bracket, const exact_box& range, polynomial_values& p) {
  for (const auto& end : {range.lower, range.upper}) {
    if (!end || *end <= *bracket.lower || *end >= *bracket.upper) continue;
    const bool root_is_below = p.sign_at(*end) == p.sign_at(*bracket.upper);
    (root_is_below ? bracket.upper : bracket.lower) = end;
  }
  return (!range.lower || *bracket.upper > *range.lower) &&
         (!range.upper || *bracket.lower < *range.upper);
}

/// A narrow ball between the ends of the bracket around its root, apart from the exact roots.
ball place_of(const exact_box& bracket, const std::vector<rational>& exact, polynomial_values& p,
              long enough) {
  exact_box sharper = bracket;
  for (long bits = enough;; bits *= 2) {
    sharper = narrowed(p, sharper, bits);
    ball place = sharper.to_ball(std::max<precision>(bits + 32, p.last_precision()));
    const auto next = std::lower_bound(exact.begin(), exact.end(), lower_rational(place));
    const bool is_apart = next == exact.end() || *next > upper_rational(place);
    const bool is_inside =
        *bracket.lower < lower_rational(place) && upper_rational(place) < *bracket.upper;
    if (is_apart && is_inside) return place;
  }
}

/// Gives the exact roots boxes that are apart from their neighbours. In order, from left to right.
void keep_boxes_apart(std::vector<placed_root>& placed) {
  for (std::size_t i = 0; i < placed.size(); ++i) {
    root_region& r = placed[i].region;
    if (!r.exact) continue;
    const auto is_apart = [&] {
      return (i == 0 || *placed[i - 1].x.upper < lower_rational(r.box)) &&
             (i + 1 == placed.size() || *placed[i + 1].x.lower > upper_rational(r.box));
    };
    for (precision bits = 2 * first_bits; !is_apart(); bits *= 2) {
      r.box = r.enclosure = ball(*r.exact, bits);
    }
  }
}

}  // namespace

bool settle_polynomial(root_search::state& s, std::size_t problem,
                       const std::function<bool(long)>& go_on) {
  const root_problem& given = s.problems[problem];
  settled_pieces& settled = s.settled[problem];
  const exact_box range = settled.whole();
  long steps = 0;
  const auto found = separate_real_roots(*given.g->polynomial(), [&] { return go_on(++steps); });
  if (!found) return false;
  std::vector<placed_root> placed;
  long evaluations = 0;
  const auto place_root = [&](const ball& place, std::optional<rational> exact,
                              const std::shared_ptr<const real_function>& simple) {
    root_region r;
    r.verdict = given.multiplicity == 1 ? root_verdict::unique : root_verdict::multiple;
    r.box = r.enclosure = place;
    r.multiplicity = given.multiplicity;
    r.function = s.f;
    r.simple = simple;
    exact_box x =
        exact ? exact_box{exact, exact} : exact_box{lower_rational(place), upper_rational(place)};
    r.exact = std::move(exact);
    placed.push_back({std::move(x), std::move(r)});
  };
  for (const rational& q : found->exact) {
    if ((range.lower && q < *range.lower) || (range.upper && q > *range.upper)) continue;
    place_root(ball(q, first_bits), q,
               std::make_shared<const real_function>(
                   real_function::of(rational_polynomial({rational(-q), rational(1)}))));
  }
  if (!found->brackets.empty()) {
    const auto rest = std::make_shared<const real_function>(real_function::of(
        rational_polynomial(std::vector<rational>(found->rest.begin(), found->rest.end()))));
    polynomial_values values(found->rest);
    const long bits = given.pole_order ? 64 : 32;  // a place is shown as it is found
    for (exact_box bracket : found->brackets) {
      if (!go_on(++steps)) return false;
      if (!cut_to_range(bracket, range, values)) continue;
      place_root(place_of(bracket, found->exact, values, bits), std::nullopt, rest);
    }
    evaluations = values.evaluations();
  }
  std::sort(placed.begin(), placed.end(),
            [](const placed_root& x, const placed_root& y) { return precedes(x.x, y.x); });
  keep_boxes_apart(placed);
  s.account.boxes += found->steps + static_cast<long>(placed.size());
  s.account.evaluations += evaluations;
  // Between the places there is no root.
  std::optional<rational> covered = range.lower;
  for (placed_root& root : placed) {
    if (covered != root.x.lower) settled.add_without_root({covered, root.x.lower});
    settled.add_known(root.x, s.found.size());
    covered = root.x.upper;
    const auto about = double_interval::from_ball(root.region.box);
    s.found.push_back({std::move(root.region), problem, about});
  }
  if (placed.empty() || !range.upper || covered != range.upper) {
    settled.add_without_root({covered, range.upper});
  }
  return true;
}

}  // namespace polhode::detail
