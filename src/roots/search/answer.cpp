#include "answer.hpp"

#include <algorithm>
#include <utility>

#include "clusters.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "range.hpp"

namespace polhode::detail {

namespace {

/// From left to right by the lower ends of what place(x) is. Each end is computed once, and what is
/// sorted is moved once.
template <class T, class Place>
std::vector<T> sorted(std::vector<T> given, const Place& place) {
  std::vector<std::pair<mpfr_float, std::size_t>> order;
  order.reserve(given.size());
  for (const T& x : given) order.emplace_back(lower(place(x)), order.size());
  std::ranges::stable_sort(order, {}, &std::pair<mpfr_float, std::size_t>::first);
  std::vector<T> result;
  result.reserve(given.size());
  for (const auto& [end, i] : order) result.push_back(std::move(given[i]));
  return result;
}

void in_order(std::vector<root_region>& regions) {
  regions = sorted(std::move(regions), [](const root_region& r) { return r.enclosure; });
}

/// Roots of different factors, neither in the other's enclosure, may have enclosures that overlap:
/// they are made narrower.
void keep_apart(std::vector<root_region>& regions) {
  constexpr long most_digits = 1L << 14;
  for (std::size_t i = 1; i < regions.size(); ++i) {
    root_region& x = regions[i - 1];
    root_region& y = regions[i];
    if (!is_one_root(x.verdict) || !is_one_root(y.verdict)) continue;
    for (long digits = 15; overlaps(x.enclosure, y.enclosure) && digits < most_digits;
         digits *= 2) {
      x.enclosure = refine(x, digits).enclosure;
      y.enclosure = refine(y, digits).enclosure;
    }
  }
  in_order(regions);
}

/// The boxes of the regions of a factor may hold roots of others: they are made narrower.
void keep_out_other_roots(root_region& r, std::size_t problem,
                          const std::vector<root_problem>& problems) {
  if (problems.size() < 2 || r.multiplicity == 0) return;
  constexpr long most_digits = 1L << 20;
  for (long digits = 15; digits <= most_digits; digits *= 2) {
    bool apart = true;
    for (std::size_t i = 0; i < problems.size(); ++i) {
      if (i == problem) continue;
      const ball value = problems[i].g->at(r.enclosure.precision())->value(r.enclosure);
      apart = apart && !value.is_undefined() && !contains_zero(value);
    }
    if (apart) {
      r.box = r.enclosure;
      return;
    }
    const ball finer = intersection(refine(r, digits).enclosure, r.enclosure);
    if (!finer.is_undefined()) r.enclosure = finer;
  }
  r.box = r.enclosure;
  r.verdict = root_verdict::at_least_one;
  r.multiplicity = 0;
  r.remark = "not told from a root of another multiplicity";
}

/// The roots and poles that do not lie outside of the range.
void add_found(const root_search::state& s, root_set& result) {
  for (const found_root& known : s.found) {
    root_region r = known.region;
    const root_problem& problem = s.problems[known.problem];
    const side at_lower = side_of(r, s.lower, true, *problem.g, r);
    const side at_upper = side_of(r, s.upper, false, *problem.g, r);
    if (at_lower == side::outside || at_upper == side::outside) continue;
    r.may_lie_outside = (at_lower == side::undecided || at_upper == side::undecided) &&
                        r.verdict != root_verdict::unresolved;
    keep_out_other_roots(r, known.problem, s.problems);
    if (problem.pole_order) {
      if (is_one_root(r.verdict)) {
        result.singular.push_back({r.box, *problem.pole_order});
        continue;
      }
      r.verdict = root_verdict::unresolved;
      r.remark = "a place where the function is not defined, not told from a root";
    }
    r.function = s.f;
    result.regions.push_back(std::move(r));
  }
}

/// What is not settled, in clusters.
void add_open(const root_search::state& s, std::vector<root_region>& regions) {
  std::vector<work_box> open = s.pending;
  open.insert(open.end(), s.stuck.begin(), s.stuck.end());
  const std::vector<work_box> clusters = joined(open, s.found);
  (void)parts_of(clusters, open);
  for (const work_box& b : clusters) {
    root_region r;
    r.box = r.enclosure = b.x.to_ball(b.bits);
    r.remark = s.limit.empty() ? "not examined yet" : s.limit + " was reached";
    r.function = s.f;
    r.simple = s.problems[b.problem].g;
    regions.push_back(std::move(r));
  }
}

/// From left to right; neighbouring places where f is not defined are one.
std::vector<singular_place> in_order(std::vector<singular_place> given) {
  given = sorted(std::move(given), [](const singular_place& x) { return x.place; });
  std::vector<singular_place> places;
  for (singular_place& place : given) {
    const bool joins = !places.empty() && places.back().pole_order == 0 && place.pole_order == 0 &&
                       overlaps(places.back().place, place.place);
    const bool again = !places.empty() && places.back().pole_order > 0 &&
                       overlaps(places.back().place, place.place);
    if (joins) {
      places.back().place = hull(places.back().place, place.place);
    } else if (!again) {
      places.push_back(std::move(place));
    }
  }
  return places;
}

}  // namespace

root_set answer_of(const root_search::state& s) {
  root_set result;
  result.identically_zero = s.identically_zero;
  result.complete = s.pending.empty() && !s.has_open_end;
  result.account = s.account;
  result.singular = s.singular;
  add_found(s, result);
  result.singular = in_order(std::move(result.singular));
  add_open(s, result.regions);
  in_order(result.regions);
  keep_apart(result.regions);
  return result;
}

}  // namespace polhode::detail
