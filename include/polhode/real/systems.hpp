#pragma once

// Systems of equations of a person's own, over a type Real: all solutions in a box, each proved.
//
//   const auto f = [](const auto& x) { return std::vector{x[0] * x[0] + x[1] - 11, x[0] + x[1] *
//   x[1] - 7}; }; const auto s = polhode::solve_system<Real>(f, {{-5, 5}, {-5, 5}});
//
// f is called once with a vector of symbols (expression/symbol.hpp), and answers with as many
// symbols.

#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "polhode/expression/formula_of.hpp"
#include "polhode/real/number.hpp"
#include "polhode/real/roots.hpp"
#include "polhode/roots/systems.hpp"

namespace polhode {

/// A solution with the box that is proved to hold it.
template <class Real>
struct certified_solution {
  std::vector<Real> value;
  std::vector<Real> lower;
  std::vector<Real> upper;
  /// unique, or unresolved.
  root_verdict verdict = root_verdict::unresolved;
  /// Each component to the digits asked for.
  bool reached = false;
  std::string remark;
};

template <class Real>
struct certified_solutions {
  std::vector<certified_solution<Real>> solutions;
  /// The whole box was searched, every solution is unique, and there is no other.
  bool resolved = false;
  isolation_account account;
};

struct real_system_options {
  /// By default all that Real has; 15 for a ball.
  std::optional<long> digits = std::nullopt;
  system_options search = {};
};

/// The solutions of f(x) = 0 in a box, faces included. Real: a floating_real, or ball. Throws
/// input_error for a box that is none.
template <class Real, class F>
requires real_or_ball<Real>
[[nodiscard]] certified_solutions<Real> solve_system(
    const F& f, const std::vector<std::pair<range_limit<Real>, range_limit<Real>>>& box,
    const real_system_options& options = {}) {
  system_box sides;
  precision p = 0;
  for (const auto& [lower, upper] : box) {
    if (!lower.point().exact() || !upper.point().exact()) {
      throw input_error("a side of the box has an end that is no finite rational number");
    }
    sides.emplace_back(lower.point().exact(), upper.point().exact());
    p = std::max(p, detail::bits_between<Real>(lower, upper, options.digits));
  }
  real_root_options digits_of;
  digits_of.digits = options.digits;
  const long digits = detail::root_digits<Real, answer_by_verdict>(digits_of, p);
  const real_system system(formulas_of<detail::symbol_of_real<Real>>(f, box.size()));
  const system_root_set found = solve_system(system, sides, options.search);
  certified_solutions<Real> result;
  result.resolved = found.complete && found.is_resolved();
  result.account = found.account;
  for (const system_region& region : found.regions) {
    certified_solution<Real> one;
    one.verdict = region.verdict;
    one.remark = region.remark;
    std::vector<ball> enclosure = region.enclosure;
    if (region.verdict == root_verdict::unique) {
      const refined_system_root refined = refine(system, region, digits);
      enclosure = refined.enclosure;
      one.reached = refined.verdict == status::certified;
    }
    for (const ball& x : enclosure) {
      one.value.push_back(detail::end_as<Real>(x, p, MPFR_RNDN));
      one.lower.push_back(detail::end_as<Real>(x, p, MPFR_RNDD));
      one.upper.push_back(detail::end_as<Real>(x, p, MPFR_RNDU));
    }
    result.solutions.push_back(std::move(one));
  }
  return result;
}

/// Refuses any other Real.
template <class Real, class F, class... Rest>
requires(!real_or_ball<Real> && std::is_class_v<F>) void solve_system(const F& /*f*/,
                                                                      const Rest&... /*rest*/) {
  static_assert(detail::real_needed<Real>::reported);
}

}  // namespace polhode
