#include "other_variables.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/expression/symbol.hpp"
#include "polhode/quadrature/zero_free_ends.hpp"

namespace polhode::detail {

namespace {

bool is_zero(const end_point& x) { return x.exact() && *x.exact() == 0; }

/// x is on this side of 0 for certain.
bool is_beyond_zero(const end_point& x, int side) {
  if (x.is_infinite()) return x.infinite_sign() == side;
  return side > 0 ? certainly_positive(x.at(64)) : certainly_negative(x.at(64));
}

/// A rational number c > 0 with c <= |x|, where that is found.
rational size_below(const end_point& x) {
  if (x.is_infinite()) return 1;
  return x.exact() ? abs(*x.exact()) : lower_rational(abs(x.at(64)));
}

/// The integral between 0 and an end on this side of it; false where it is not in u.
bool add_side(std::vector<part>& parts, const expression& f, const end_point& end, int side) {
  const symbol x = symbol::variable(0);
  const auto in_u = (side > 0 ? f : expression(f(-x), f.names())).by_reciprocal();
  const rational c = size_below(end);
  if (!in_u || !(c > 0)) {
    const end_point zero(0);
    parts.push_back(side > 0 ? part{integrand_of(f), zero, end} : part{integrand_of(f), end, zero});
    return false;
  }
  // x between 0 and side c, and what is left up to the end.
  parts.push_back({integrand_of(*in_u), end_point(rational(1 / c)), end_point::infinity()});
  if (!end.exact()) {
    const end_point cut(rational(side * c));
    parts.push_back(side > 0 ? part{integrand_of(f), cut, end} : part{integrand_of(f), end, cut});
  }
  return true;
}

}  // namespace

std::vector<part> parts_in_reciprocal(const expression& f, const end_point& a, const end_point& b) {
  if (!f.by_reciprocal()) return {};
  const bool has_left = !is_zero(a);
  const bool has_right = !is_zero(b);
  if ((has_left && !is_beyond_zero(a, -1)) || (has_right && !is_beyond_zero(b, 1))) return {};
  std::vector<part> parts;
  bool found = false;
  if (has_left) found = add_side(parts, f, a, -1) || found;
  if (has_right) found = add_side(parts, f, b, 1) || found;
  return found ? parts : std::vector<part>();
}

namespace {

/// The integer k with |x - k pi| < pi/2 for certain; for x = (k + 1/2) pi exactly k + 1 on its
/// upper side, k on its lower one.
std::optional<integer> branch_of(const end_point& x, int side) {
  if (x.form() && x.form()->q == 0 && denominator(x.form()->r) == 2) {
    const integer below = floor_of(x.form()->r);
    return side > 0 ? integer(below + 1) : below;
  }
  constexpr precision p = 128;
  const ball turns = x.at(p) / pi(p) + rational(1, 2);
  if (!turns.is_bounded()) return std::nullopt;
  const integer k = floor_of(lower_rational(turns));
  const bool is_inside = certainly_less(ball(rational(k), p), turns) &&
                         certainly_less(turns, ball(rational(k + 1), p));
  return is_inside ? std::optional(k) : std::nullopt;
}

/// tan(x); at an odd multiple of pi/2 the infinity of sign `side`.
std::optional<end_point> tangent_of(const end_point& x, int side) {
  if (x.form() && x.form()->q == 0 && denominator(x.form()->r) == 2) {
    return side > 0 ? end_point::infinity() : -end_point::infinity();
  }
  const std::optional<expression> e = formula_of(x);
  if (!e) return std::nullopt;
  return end_point_of(expression(tan(e->evaluate(std::span<const symbol>())), {}));
}

}  // namespace

std::vector<part> parts_in_tangent(const expression& f, const end_point& a, const end_point& b) {
  if (a.is_infinite() || b.is_infinite() || !f.by_tangent(0)) return {};
  const auto first = branch_of(a, 1);
  const auto last = branch_of(b, -1);
  const auto lower = tangent_of(a, -1);
  const auto upper = tangent_of(b, 1);
  constexpr long most_branches = 16;
  if (!first || !last || !lower || !upper || *last - *first >= most_branches) return {};
  const bool reaches_a_pole = *first != *last || lower->is_infinite() || upper->is_infinite();
  if (!reaches_a_pole) return {};
  std::vector<part> parts;
  for (integer k = *first; k <= *last; ++k) {
    const auto in_u = f.by_tangent(k);
    if (!in_u) return {};
    parts.push_back({integrand_of(*in_u), k == *first ? *lower : -end_point::infinity(),
                     k == *last ? *upper : end_point::infinity()});
  }
  return parts;
}

namespace {

/// The functions whose sum f is for all x >= from, where there are any.
struct far_out {
  std::vector<expression> terms;
  rational from = 0;
};
using terms_far_out = far_out (*)(const expression& f);

/// f without its kinks beyond some x, where each decider has one sign.
far_out beyond_kinks(const expression& f) {
  constexpr unsigned first = 4;
  constexpr unsigned last = 20;
  for (unsigned e = first; e <= last; e += 2) {
    const rational from = rational(integer(1) << e);
    const auto smooth = f.without_kinks([&](const expression& d) -> std::optional<bool> {
      if (const auto known = d.exact_value()) return *known >= 0;
      const int sign = zero_free_ends(d).sign_beyond(from);
      return sign != 0 ? std::optional(sign > 0) : std::nullopt;
    });
    if (smooth) return {{*smooth}, from};
  }
  return {};
}
far_out limits_of(const expression& f) {
  if (const auto apart = f.by_steady_factor()) return {{apart->limit, apart->rest}};
  if (const auto same = f.with_decaying_exponentials()) return {{*same}};
  return beyond_kinks(f);
}
far_out scaled(const expression& f) {
  const auto same = f.with_scaled_functions();
  return same ? far_out{{*same}} : far_out{};
}

/// From a point to infinity on this side; false where there are no such terms.
bool add_beyond(std::vector<part>& parts, const expression& f, const end_point& from, int side,
                terms_far_out terms) {
  const symbol x = symbol::variable(0);
  const far_out beyond = terms(side > 0 ? f : expression(f(-x), f.names()));
  const ball distance = side > 0 ? from.at(64) : -from.at(64);
  if (beyond.terms.empty() || !distance.is_bounded()) return false;
  const rational c = floor_of(std::max<rational>({upper_rational(distance), beyond.from, 0})) + 1;
  const end_point cut(rational(side * c));
  parts.push_back(side > 0 ? part{integrand_of(f), from, cut} : part{integrand_of(f), cut, from});
  for (const expression& one : beyond.terms) {
    parts.push_back({integrand_of(one), end_point(c), end_point::infinity()});
  }
  return true;
}

std::vector<part> parts_beyond(const expression& f, const end_point& a, const end_point& b,
                               terms_far_out terms) {
  std::vector<part> parts;
  if (f.variables().size() != 1) return parts;
  const bool both = a.is_infinite() && b.is_infinite();
  const bool has_left = a.is_infinite() && add_beyond(parts, f, both ? end_point(0) : b, -1, terms);
  const bool has_right = b.is_infinite() && add_beyond(parts, f, both ? end_point(0) : a, 1, terms);
  if (both && has_left && !has_right) parts.push_back({integrand_of(f), end_point(0), b});
  if (both && has_right && !has_left) parts.push_back({integrand_of(f), a, end_point(0)});
  return parts;
}
}  // namespace

std::vector<part> parts_with_limits(const expression& f, const end_point& a, const end_point& b) {
  return parts_beyond(f, a, b, limits_of);
}

std::vector<part> parts_with_scaled_functions(const expression& f, const end_point& a,
                                              const end_point& b) {
  return parts_beyond(f, a, b, scaled);
}

}  // namespace polhode::detail
