#include "end_plan.hpp"

#include <array>
#include <cmath>

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail::ends {

end_point sum_of(const end_point& a, const end_point& b, const rational& factor) {
  if (a.form() && b.form()) return end_point(*a.form() + *b.form() * factor);
  return end_point([=](precision p) { return a.at(p) + b.at(p) * factor; });
}
end_point difference(const end_point& a, const end_point& b) { return sum_of(a, -b, 1); }

known_number exactly(const end_point& x) {
  if (x.form()) return known_number(*x.form());
  const auto f = formula_of(x);
  return f ? f->known_value(192) : known_number(x.at(192));
}

namespace {

/// |q| t^(q-1) f(p + s t^q): the exponent and the bounds from the series of f.
end_plan plan_from_series(const end_series& series, long q, double r) {
  const end_series h = series.simplified();
  end_plan plan;
  plan.q = q;
  plan.r = r;
  plan.exponent = h.exponent() + (q - 1);
  const auto factor = magnitude::from_integer_up(static_cast<std::uint64_t>(std::abs(q)));
  for (int k = 0; k <= h.log_degree(); ++k) {
    plan.bounds.push_back(multiply_up(h.supremum(k), factor));
  }
  const bool integrable = plan.exponent > -1;
  const bool is_power = h.log_degree() == 0 && denominator(plan.exponent) == 1;
  if (!integrable) {
    plan.how = h.leads_surely() ? manner::divergent : manner::unknown;
    plan.obstacle = "a coefficient that may be 0";
  } else {
    plan.how = is_power ? manner::power : manner::exponential;
  }
  return plan;
}

using series_function = std::function<end_series(const end_series& x)>;

/// f near an end, with the substitution x = p + s t^q, over the largest of some squares on which
/// its series is known; with few orders first, which cost less and mostly suffice.
end_series series_at_end(const series_function& f, const end_of_range& end, long q, double& r) {
  constexpr std::array<double, 6> sizes{0.5, 0.25, 0x1p-4, 0x1p-8, 0x1p-16, 0x1p-32};
  using remedy = end_series::remedy;
  const known_number p = exactly(end.at);
  const known_number s = exactly(end.distance);
  end_series first;
  double found_r = 0;
  std::optional<end_series> found;  // on a larger square, with a poor bound
  int orders = 2;
  for (std::size_t k = 0; k < sizes.size();) {
    r = sizes.at(k);
    end_series h = f(end_series::argument(p, s, q, r, orders));
    const bool few_orders = orders < end_series::most_orders;
    const remedy help = h.what_may_help();
    if (h.is_blocked()) {
      if (found) break;
      if (k == 0) first = h;
      if (help == remedy::none || help == remedy::other_root) return h;
      if (help == remedy::smaller_square || !few_orders) ++k;
    } else if (!few_orders || h.simplified().leads_surely()) {
      // On a small square the bound is not far from the value at its centre.
      constexpr long poor = 10;
      const end_series g = h.simplified();
      if (found && multiply_up(g.supremum(g.log_degree()), magnitude::power_of_two(poor)) >
                       found->simplified().supremum(g.log_degree())) {
        break;
      }
      found = h;
      found_r = r;
      if (g.supremum(g.log_degree()) <= multiply_up(g.size_at_0(), magnitude::power_of_two(poor)))
        break;
      ++k;
      continue;
    }
    if (help != remedy::smaller_square) orders = end_series::most_orders;
  }
  if (!found) return first;
  r = found_r;
  return *found;
}

/// The plan by the growth of f alone; a divergent one where that proves it.
std::optional<end_plan> plan_from_growth(const integrand& f, const end_of_range& end) {
  if (!f.growth) return std::nullopt;
  const long q = end.infinite ? -1 : 1;
  // The plan whose bound of the part up to t, C t^(M+1)/(M+1), is small from the greatest t on.
  std::optional<end_plan> best;
  double farthest = 0;
  for (const double r : {0x1p-2, 0x1p-3, 0x1p-4, 0x1p-5, 0x1p-6, 0x1p-8, 0x1p-16, 0x1p-32}) {
    if (best && r <= farthest) break;
    const growth_bound g =
        f.growth(growth_bound::argument(exactly(end.at), exactly(end.distance), q, r));
    if (g.is_blocked() || g.factor().is_infinite()) continue;
    end_plan plan;
    plan.exponent = g.exponent() + (q - 1);
    const bool diverges =
        g.least_exponent() + (q - 1) <= -1 && g.sign() != 0 && !g.least_factor().is_zero();
    if (plan.exponent <= -1 && !diverges) continue;
    plan.how = diverges ? manner::divergent : manner::exponential;
    plan.q = q;
    plan.r = r;
    plan.bounds = {g.factor()};
    plan.has_growth_only = true;
    plan.has_growing_parts = g.has_growing_parts();
    plan.oscillates = g.oscillates();
    if (diverges) return plan;
    constexpr double wanted_bits = 128;
    const double factor = g.factor().is_zero() ? 0 : static_cast<double>(g.factor().log2_floor());
    const double small_from =
        std::min(r, std::exp2(-(wanted_bits + factor) / static_cast<double>(plan.exponent + 1)));
    // Panels can follow few oscillations.
    constexpr double oscillations_from = 0x1p-8;
    if ((best && small_from <= farthest) || (g.oscillates() && small_from < oscillations_from)) {
      continue;
    }
    farthest = small_from;
    best = plan;
  }
  return best;
}

/// The plan for x = p + s tau^(q d) from one for x = p + s t^q without logarithms, where d (M + 1)
/// is a whole number. With t = tau^d, F_qd(tau) = d tau^(d-1) F_q(tau^d) = d tau^(d (M+1) - 1)
/// G(tau^d): the bound of |G| holds for |tau| < r^(1/d), where |t| < r and G is analytic.
end_plan with_root(end_plan plan, long d) {
  const double whole = plan.r;
  plan.r = std::pow(whole, 1.0 / static_cast<double>(d));
  while (!(pow(double_interval(plan.r), d).upper() <= whole)) plan.r = std::nextafter(plan.r, 0.0);
  plan.q *= d;
  plan.exponent = d * (plan.exponent + 1) - 1;
  for (magnitude& bound : plan.bounds) {
    bound = multiply_up(bound, magnitude::from_integer_up(static_cast<std::uint64_t>(d)));
  }
  plan.how = manner::power;
  return plan;
}

/// Tries substitutions x = p + s t^q for small q.
end_plan plan_from_series_of(const series_function& f, const end_of_range& end) {
  using remedy = end_series::remedy;
  constexpr long most_root = 6;
  end_plan best;
  for (long root = 1; root <= most_root;) {
    const long q = end.infinite ? -root : root;
    double r = 0;
    const end_series h = series_at_end(f, end, q, r);
    if (h.is_blocked()) {
      if (best.obstacle.empty()) best.obstacle = std::string(h.where());
      const remedy help = h.what_may_help();
      if (help == remedy::none || help == remedy::smaller_square) break;
      ++root;
      continue;
    }
    end_plan plan = plan_from_series(h, q, r);
    if (plan.how == manner::power) return plan;
    if (best.how == manner::unknown) best = plan;
    // Where there is no logarithm, the exponent times this root is whole.
    const integer whole = denominator(plan.exponent) * root;
    const bool helps = plan.how == manner::exponential && plan.bounds.size() == 1;
    if (!helps || whole <= root || whole > most_root) break;
    return with_root(plan, static_cast<long>(whole) / root);
  }
  return best;
}

}  // namespace

end_plan look_at_end(const integrand& f, const end_of_range& end) {
  end_plan best = plan_from_series_of(f.near_end, end);
  if (best.how == manner::unknown) {
    // Beside another point regions of 1 - x, say, are found by halving alone, in many panels.
    const bool is_at_0 = end.at.exact() && *end.at.exact() == 0;
    if (end.infinite || is_at_0) {
      const auto plan = plan_from_growth(f, end);
      if (plan && !plan->has_growing_parts && !plan->oscillates) return *plan;
      best.growth_is_known = true;
      if (plan) best.last_resort = std::make_shared<const end_plan>(*plan);
    }
  }
  return best;
}

std::optional<end_plan> last_resort(const integrand& f, const end_of_range& end,
                                    const end_plan& seen) {
  if (!seen.growth_is_known) return plan_from_growth(f, end);
  return seen.last_resort ? std::optional(*seen.last_resort) : std::nullopt;
}

bool is_regular(const integrand& f, const end_of_range& end) {
  constexpr precision wide = 192;
  const double_interval in_doubles(-0x1p-10, 0x1p-10);
  const region around =
      region(end.at.at(wide)) + region(end.distance.at(wide)) * region(in_doubles, in_doubles);
  if (f.over(around).is_analytic()) return true;
  // Beside a pole or a cut as near as panels come to an end.
  for (const long size : {10L, 20L, 40L, 80L, 160L, 320L}) {
    const precision p = wide + size;
    const ball side = scale(hull(ball(-1, p), ball(1, p)), -size);
    const region x = end.at.at(p) + end.distance.at(p) * region::in_balls({side, side});
    if (f.over(x).is_analytic()) return true;
  }
  return false;
}

}  // namespace polhode::detail::ends
