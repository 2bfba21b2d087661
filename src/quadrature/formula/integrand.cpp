// Formulas as what is integrated.

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/on_first_use.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/symbol.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/zero_free_ends.hpp"
#include "quadrature/formula/arithmetics.hpp"
#include "quadrature/formula/exponential_variable.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/formula/logarithmic_ends.hpp"
#include "quadrature/formula/other_variables.hpp"
#include "quadrature/formula/periodic_tail.hpp"

namespace polhode {

namespace {

/// Throws input_error unless f has at most so many variables.
void expect_variables(const expression& f, std::size_t most, const char* what) {
  const std::vector<std::string>& names = f.variables();
  if (names.size() <= most) return;
  throw input_error(
      fmt::format("the variables of the formula are {}; {}", fmt::join(names, ", "), what));
}

}  // namespace

namespace {

/// f over T, its constants made with p bits when it is first called.
template <class T>
std::function<T(const T&)> made_on_first_use(const expression& f, precision p) {
  return [f, p, g = std::make_shared<detail::on_first_use<compiled_expression<T>>>()](const T& x) {
    return g->made_by([&] { return f.evaluator<T>(p); })(x);
  };
}

std::function<std::shared_ptr<const detail::formula_graph>()> graph_on_first_use(
    const expression& f) {
  using made_graph = std::shared_ptr<const detail::formula_graph>;
  return [f, g = std::make_shared<detail::on_first_use<made_graph>>()] {
    return g->made_by([&] { return std::make_shared<const detail::formula_graph>(f); });
  };
}

/// f(-x), of one variable.
expression reflected(const expression& f) { return expression(f(-symbol::variable(0)), f.names()); }

/// The integral from 0 to infinity, from minus infinity to 0 or over the line in closed form, by
/// the precision; nothing where there is none.
std::function<ball(precision)> over_half_lines(const expression& f, const end_point& a,
                                               const end_point& b) {
  const auto is_zero = [](const end_point& x) { return x.exact() && *x.exact() == 0; };
  const bool to_left = a.infinite_sign() < 0 && (is_zero(b) || b.infinite_sign() > 0);
  const bool to_right = b.infinite_sign() > 0 && (is_zero(a) || a.infinite_sign() < 0);
  if (!to_left && !to_right) return nullptr;
  std::vector<expression> halves;
  for (const bool left : {false, true}) {
    if (!(left ? to_left : to_right)) continue;
    const auto half = (left ? reflected(f) : f).integral_over_half_line();
    if (!half) return nullptr;
    halves.push_back(*half);
  }
  return [halves](precision p) {
    ball sum(0, p);
    for (const expression& half : halves) sum = sum + half.value(p);
    return sum;
  };
}

/// F(b) - F(a) for an antiderivative F that is entire, or is so in log x, or the integral over a
/// half-line, by the precision; nothing where there is none, or it does not reach up to the ends.
std::function<ball(precision)> difference_at_ends(const expression& f, const end_point& a,
                                                  const end_point& b) {
  if (a.infinite_sign() == 0 && b.infinite_sign() == 0) {
    if (const auto found = f.entire_antiderivative()) {
      return [F = *found, a, b](precision p) {
        const auto at = F.evaluator<ball>(p);
        return at(b.at(p)) - at(a.at(p));
      };
    }
  }
  if (f.variables().size() == 1) {
    if (auto found = over_half_lines(f, a, b)) return found;
  }
  const auto found = f.antiderivative_in_logarithm();
  if (!found || !detail::is_right_of_zero(a) || !detail::is_right_of_zero(b) ||
      !detail::reaches(*found, a) || !detail::reaches(*found, b)) {
    return nullptr;
  }
  return [G = found->of_s, a, b](precision p) {
    const auto of_s = G.evaluator<ball>(p);
    const auto at = [&](const end_point& x) {
      return detail::is_limit_of_logarithm(x) ? ball(0, p) : of_s(-log(x.at(p)));
    };
    return at(a) - at(b);
  };
}

/// detail::integrand::pieces of a formula, for a < b.
std::vector<detail::part> pieces_between(const expression& f, const end_point& a,
                                         const end_point& b) {
  constexpr std::size_t most_pieces = 8;
  constexpr precision p = 64;
  if (f.variables().size() != 1) return {};
  // For an end that is not rational a number beyond it, if no piece ends between them.
  const auto beyond = [](const end_point& x, bool is_lower) -> std::optional<rational> {
    if (x.is_infinite()) return std::nullopt;
    if (x.exact()) return x.exact();
    return is_lower ? lower_rational(x.at(p)) : upper_rational(x.at(p));
  };
  const auto found = f.pieces(beyond(a, true), beyond(b, false), most_pieces);
  if (!found) return {};
  const auto& first_end = found->front().upper;
  const auto& last_start = found->back().lower;
  const bool begins =
      a.is_infinite() || a.exact() || !first_end || upper_rational(a.at(p)) < *first_end;
  const bool ends =
      b.is_infinite() || b.exact() || !last_start || *last_start < lower_rational(b.at(p));
  if (!begins || !ends) return {};
  std::vector<detail::part> parts;
  for (const expression::piece& piece : *found) {
    parts.push_back({integrand_of(piece.formula), piece.lower ? end_point(*piece.lower) : a,
                     piece.upper ? end_point(*piece.upper) : b});
  }
  parts.front().lower = a;
  parts.back().upper = b;
  return parts;
}

/// With so many changes of the variable to an exponential, one after the other, at most.
detail::integrand integrand_with_changes(const expression& f, int changes) {
  constexpr precision series_bits = 192;
  detail::integrand result;
  result.over = [f, in_hardware = f.evaluator<region>(64)](const region& x) {
    return x.is_in_hardware() ? in_hardware(x) : f.evaluator<region>(x.precision())(x);
  };
  result.evaluator = [f](precision p) -> std::function<ball(const ball&)> {
    return f.evaluator<ball>(p);
  };
  result.angle_evaluator = [f](precision p) -> std::function<ball(const angle&)> {
    return [g = f.evaluator<angle>(p)](const angle& x) { return g(x).value(); };
  };
  result.near_end = made_on_first_use<end_series>(f, series_bits);
  if (changes > 0) {
    result.in_exponential = [f, changes](const end_point& end,
                                         int side) -> std::optional<detail::integrand> {
      std::optional<expression> x;
      if (!end.is_infinite() && !(x = formula_of(end))) return std::nullopt;
      const std::optional<expression> g = f.in_exponential(x ? &*x : nullptr, side);
      if (!g) return std::nullopt;
      return integrand_with_changes(*g, changes - 1);
    };
  }
  result.pieces = [f](const end_point& a, const end_point& b) {
    for (const auto find :
         {pieces_between, detail::parts_in_reciprocal, detail::parts_in_tangent}) {
      std::vector<detail::part> parts = find(f, a, b);
      if (!parts.empty()) return parts;
    }
    return std::vector<detail::part>();
  };
  result.with_limits = [f](const end_point& a, const end_point& b) {
    return detail::parts_with_limits(f, a, b);
  };
  result.scaled = [f](const end_point& a, const end_point& b) {
    return detail::parts_with_scaled_functions(f, a, b);
  };
  result.candidates = [f](const end_point& a, const end_point& b) {
    std::vector<end_point> points;
    if (f.variables().size() != 1) return points;
    constexpr precision p = 64;
    const auto at = [](const end_point& x) {
      return x.is_infinite() ? double_interval::entire() : double_interval::from_ball(x.at(p));
    };
    for (const expression& x : f.divisor_zeros(hull(at(a), at(b)))) {
      if (x.value(series_bits).is_bounded()) points.push_back(end_point_of(x));
    }
    return points;
  };
  result.antiderivative = [f](const end_point& a, const end_point& b) {
    return difference_at_ends(f, a, b);
  };
  result.on_turned_rays = [f](const rational& from,
                              int side) -> std::optional<detail::turned_rays> {
    if (f.variables().size() != 1) return std::nullopt;
    const expression outward = side > 0 ? f : reflected(f);
    const auto rays = outward.on_turned_rays(from);
    if (!rays) return std::nullopt;
    detail::turned_rays turned{rays->start, {}};
    for (const expression& part : rays->parts) turned.parts.push_back(integrand_of(part));
    return turned;
  };
  result.between_turned_rays = [f](const rational& a, const rational& b,
                                   double least_turns) -> std::optional<detail::rays_of_range> {
    if (f.variables().size() != 1) return std::nullopt;
    const bool mirrored = a < 0;
    const expression outward = mirrored ? reflected(f) : f;
    const auto rays = mirrored ? outward.between_turned_rays(-b, -a) : f.between_turned_rays(a, b);
    if (!rays || !(rays->turns > least_turns)) return std::nullopt;
    const auto integrands = [](const std::vector<expression>& parts) {
      std::vector<detail::integrand> made;
      made.reserve(parts.size());
      for (const expression& part : parts) made.push_back(integrand_of(part));
      return made;
    };
    detail::rays_of_range found{
        rays->start, b, integrands(rays->from_start), integrands(rays->from_end), {}};
    for (const expression& part : rays->steady) {
      found.steady.push_back(integrand_of(mirrored ? reflected(part) : part));
    }
    if (mirrored) {
      found.lower = a;
      found.upper = -rays->start;
    }
    return found;
  };
  result.by_exponential = [f](const end_point& a, const end_point& b) {
    return detail::in_exponential_variable(f, a, b);
  };
  result.folded_at_infinity = [f](const rational& from, int side,
                                  precision p) -> std::optional<detail::folded_tail> {
    auto tail = detail::periodic_tail_of(side > 0 ? f : reflected(f), from, p);
    if (!tail) return std::nullopt;
    return detail::folded_tail{side > 0 ? tail->start : -tail->start, integrand_of(tail->folded),
                               end_point(-tail->half), end_point(tail->half), tail->rest};
  };
  result.near_infinity = made_on_first_use<tail_series>(f, series_bits);
  result.growth = made_on_first_use<growth_bound>(f, series_bits);
  result.diverges_beyond = [f](const rational& from) {
    return zero_free_ends(f).diverges_beyond(from);
  };
  result.under = made_on_first_use<symmetry>(f, series_bits);
  result.graph = graph_on_first_use(f);
  return result;
}

}  // namespace

detail::integrand integrand_of(const expression& f) {
  expect_variables(f, 1, "an integrand has one, its argument");
  constexpr int most_changes = 2;  // log(log(x)) is an exponential's exponent then
  return integrand_with_changes(f, most_changes);
}

namespace {
/// A number that was given by a formula.
class defined_by_formula : public number_definition {
 public:
  explicit defined_by_formula(expression f) : formula(std::move(f)) {}
  expression formula;
};
}  // namespace

end_point end_point_of(const expression& f) {
  expect_variables(f, 0, "an end of a range has none");
  if (f.exact_value()) return end_point(*f.exact_value());
  const symmetry value = f.evaluator<symmetry>(64)(symmetry());
  if (value.value()) return end_point(*value.value());
  return end_point([f](precision p) { return f.value(p); },
                   std::make_shared<const defined_by_formula>(f));
}

std::optional<expression> formula_of(const end_point& x) {
  if (const auto& form = x.form()) {
    if (form->is_rational()) return expression(symbol(form->q), {});
    const symbol turns = symbol(form->r) * symbol::constant("pi");
    return expression(form->q == 0 ? turns : symbol(form->q) + turns, {});
  }
  const auto* known = dynamic_cast<const defined_by_formula*>(x.definition().get());
  if (known == nullptr) return std::nullopt;
  return known->formula;
}

detail::complex_integrand complex_integrand_of(const expression& f) {
  expect_variables(f, 2, "an integrand along a path has its argument and the imaginary unit");
  const bool has_unit = f.variables().size() == 2;
  detail::complex_integrand result;
  result.over = [f, has_unit, in_hardware = f.evaluator<region>(64)](const region& z) {
    const auto value = [&](const auto& g, const region& unit) {
      if (!has_unit) return g(z);
      const std::array values{z, unit};
      return g(std::span<const region>(values));
    };
    if (z.is_in_hardware()) {
      return value(in_hardware, region(double_interval(0), double_interval(1)));
    }
    return value(f.evaluator<region>(z.precision()),
                 region::in_balls(complex_ball::i(z.precision())));
  };
  result.evaluator = [f,
                      has_unit](precision p) -> std::function<complex_ball(const complex_ball&)> {
    if (!has_unit) return f.evaluator<complex_ball>(p);
    return [g = f.evaluator<complex_ball>(p), i = complex_ball::i(p)](const complex_ball& z) {
      const std::array values{z, i};
      return g(std::span<const complex_ball>(values));
    };
  };
  return result;
}

// ---------------------------------------------------------------------------------------------
// The integrals

namespace {

/// An integral of f that is not certified for want of digits, because it is 0: where f is 0
/// wherever it is defined (is_formally_zero), and the enclosure, which is bounded, shows that it is
/// defined almost everywhere, the integral is 0 exactly.
integral settled_zero(const expression& f, integral found) {
  if (found.verdict == status::certified || found.why != reason::precision_limit ||
      !found.enclosure.is_bounded() || !f.is_formally_zero()) {
    return found;
  }
  found.enclosure = ball(0, found.enclosure.precision());
  found.verdict = status::certified;
  found.why = reason::none;
  found.obstacle.clear();
  return found;
}

/// Short rational numbers in the range, apart from its ends and from whole numbers, at which
/// functions have their poles; the limits may be in either order.
std::vector<rational> samples_between(const end_point& a, const end_point& b) {
  constexpr precision p = 64;
  constexpr long count = 16;
  std::vector<rational> samples;
  if (a.infinite_sign() > 0 || b.infinite_sign() < 0) return samples_between(b, a);
  if (!a.is_infinite() && !b.is_infinite()) {
    const rational one = lower_rational(a.at(p));
    const rational other = lower_rational(b.at(p));
    const rational low = std::min(one, other);
    const rational width = std::max(one, other) - low;
    if (width == 0) return samples;
    for (long k = 0; k < count; ++k) {
      const rational middle = low + width * rational(2 * k + 1, 2 * count);
      const rational margin = width / (8 * count);
      rational q = simplest_between(rational(middle + margin / 7), rational(middle + margin));
      if (denominator(q) == 1)
        q += q + rational(3, 7) < middle + margin ? rational(3, 7) : rational(-3, 7);
      samples.push_back(std::move(q));
    }
    return samples;
  }
  constexpr long nearest = -4;
  for (long k = nearest; k < nearest + count; ++k) {
    const rational distance = rational(1237, 941) * lower_rational(scale(ball(1, p), k));
    if (!a.is_infinite()) samples.push_back(lower_rational(a.at(p)) + distance);
    if (!b.is_infinite()) samples.push_back(upper_rational(b.at(p)) - distance);
    if (a.is_infinite() && b.is_infinite()) samples.push_back(k % 2 == 0 ? distance : -distance);
  }
  return samples;
}

/// Why f has no value at q, in words; none where it has one.
std::optional<std::string> why_undefined(const expression& f, const rational& q) {
  constexpr precision p = 128;
  try {
    const expression value(f(symbol(q)), f.names());
    if (!value.evaluator<ball>(p)(ball(q, p)).is_undefined()) return std::nullopt;
    const auto function = value.undefined_function(p);
    if (function) return fmt::format("{} needs {}", function->name, function->domain);
    return "the base of a broken power must not be negative; root(x, n) is the real root of odd "
           "order";
  } catch (const input_error& error) {
    const std::string_view what = error.what();
    constexpr std::string_view prefix = "in the function, ";
    return std::string(what.starts_with(prefix) ? what.substr(prefix.size()) : what);
  }
}

/// An integral that is refused for a branch cut, where f has no values in a part of the range: that
/// is said.
integral with_place_of_no_value(const expression& f, const end_point& a, const end_point& b,
                                integral found) {
  if (found.why != reason::not_analytic || f.variables().size() != 1) return found;
  std::optional<std::string> first;
  for (const rational& q : samples_between(a, b)) {
    const auto why = why_undefined(f, q);
    if (!why) continue;
    if (first) {  // at more than a point
      found.why = reason::not_defined;
      found.obstacle = *first;
      return found;
    }
    constexpr std::size_t short_text = 20;
    const bool is_short = mpz_sizeinbase(numerator(q).backend().data(), 10) +
                              mpz_sizeinbase(denominator(q).backend().data(), 10) <
                          short_text;
    first = fmt::format("no value at {} = {}: {}", f.variables().front(),
                        is_short ? to_text(q) : to_decimal(ball(q, 64), 6), *why);
  }
  return found;
}

}  // namespace

prepared_integrand::prepared_integrand(expression f, detail::integrand functions)
    : formula_(std::move(f)),
      functions_(std::make_shared<const detail::integrand>(std::move(functions))) {}

prepared_integrand::prepared_integrand(const expression& f)
    : prepared_integrand(f, integrand_of(f)) {}

prepared_integrand prepared_integrand::watched(std::function<void()> over_region,
                                               std::function<void()> at_node) const {
  detail::integrand result = *functions_;
  result.over = [own = result.over, call = std::move(over_region)](const region& x) {
    call();
    return own(x);
  };
  result.evaluator = [make = result.evaluator,
                      call = std::move(at_node)](precision p) -> std::function<ball(const ball&)> {
    return [own = make(p), call](const ball& x) {
      call();
      return own(x);
    };
  };
  return {formula_, std::move(result)};
}

prepared_integrand prepared_integrand::with_values(const std::function<ball(const ball&)>& values,
                                                   const end_point& a, const end_point& b) const {
  constexpr precision few_bits = 64;
  constexpr long beside = -6;  // a 64th of its size
  std::vector<ball> ends;
  for (const end_point* end : {&a, &b}) {
    if (end->is_infinite() || (end->exact() && *end->exact() == 0)) continue;
    ends.push_back(end->at(few_bits));
  }
  const auto is_beside = [ends](const ball& x) {
    return std::any_of(ends.begin(), ends.end(), [&](const ball& end) {
      const magnitude distance = (x - end).magnitude_lower();
      return distance < scale(end.magnitude_upper(), beside);
    });
  };
  detail::integrand result = *functions_;
  result.angle_evaluator = nullptr;
  result.evaluator = [make = result.evaluator, values, is_beside](precision p) {
    constexpr long roundings = 24;  // bits that those of a node may take of p
    return [own = make(p), values, is_beside,
            least = roundings - static_cast<long>(p)](const ball& x) {
      const bool is_node = x.radius() <= scale(x.magnitude_lower(), least);
      if (!is_node || is_beside(x)) return own(x);
      ball value = values(x);
      return value.is_undefined() ? own(x) : value;
    };
  };
  return {formula_, std::move(result)};
}

integral integrate(const expression& f, const end_point& a, const end_point& b,
                   const integrate_options& options) {
  return integrate(prepared_integrand(f), a, b, options);
}

integral integrate(const prepared_integrand& f, const end_point& a, const end_point& b,
                   const integrate_options& options) {
  // Closed forms leave out what is multiplied by 0, or subtracted from itself.
  if (!f.formula().has_defined_constants()) {
    integral refused;
    refused.why = reason::not_analytic;
    refused.obstacle = "a number in the integrand is not defined, or is not proved to be";
    return refused;
  }
  return with_place_of_no_value(
      f.formula(), a, b,
      settled_zero(f.formula(), detail::integrate_function(f.functions(), a, b, options)));
}

contour_integral integrate_along(const expression& f, const path& along,
                                 const integrate_options& options) {
  const detail::complex_integrand g = complex_integrand_of(f);
  if (const auto name = f.function_not_analytic()) {
    contour_integral refused;
    refused.why = reason::not_analytic;
    refused.obstacle = fmt::format("{} is not analytic in the complex plane", *name);
    return refused;
  }
  return detail::integrate_path(g, along, options);
}

}  // namespace polhode
