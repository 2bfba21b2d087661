#include "folded.hpp"

#include <utility>
#include <vector>

#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/text.hpp"
#include "quadrature/parts/sum_of_parts.hpp"

namespace polhode::detail {

std::optional<integral> integrate_over_periods(const integrand& f, const end_point& a,
                                               const end_point& b,
                                               const integrate_options& options) {
  if (!f.folded_at_infinity) return std::nullopt;
  // The rest is of the size of the tail, which may be greater than the integral: once more.
  const precision first = bits_for_digits(options.digits) + 32;
  for (const precision p : {first, 2 * first + 64}) {
    const auto tail = [&](const rational& from, int side) -> std::optional<known_tail> {
      auto one = f.folded_at_infinity(from, side, p);
      if (!one) return std::nullopt;
      return known_tail{one->start, {{std::move(one->folded), one->lower, one->upper}}, one->rest};
    };
    if (auto found = integrate_with_tails(f, a, b, tail, options)) return found;
  }
  return std::nullopt;
}

std::optional<integral> integrate_by_reciprocal(const integrand& f, const end_point& a,
                                                const end_point& b,
                                                const integrate_options& options) {
  if (!f.in_reciprocal) return std::nullopt;
  std::vector<part> parts;
  // The integral between 0 and an end on one side of it.
  const auto add_side = [&](const end_point& end, int side) {
    const auto in_u = f.in_reciprocal(side);
    const end_point from = side > 0 ? end_point(0) : end;
    const end_point to = side > 0 ? end : end_point(0);
    if (!in_u) {
      parts.push_back({f, from, to});
      return false;
    }
    // x between 0 and side c, and what is left up to the end.
    rational c = 1;
    if (end.exact()) {
      c = abs(*end.exact());
    } else if (!end.is_infinite()) {
      c = lower_rational(abs(end.at(64)));
    }
    if (c <= 0) return false;
    parts.push_back({*in_u, end_point(rational(1 / c)), end_point::infinity()});
    if (!end.exact()) {
      const end_point cut(rational(side * c));
      parts.push_back(side > 0 ? part{f, cut, end} : part{f, end, cut});
    }
    return true;
  };
  const auto is_zero = [](const end_point& x) { return x.exact() && *x.exact() == 0; };
  const bool has_left = !is_zero(a);
  const bool has_right = !is_zero(b);
  const auto is_beyond_zero = [](const end_point& x, int side) {
    if (x.is_infinite()) return x.infinite_sign() == side;
    return side > 0 ? certainly_positive(x.at(64)) : certainly_negative(x.at(64));
  };
  if ((has_left && !is_beyond_zero(a, -1)) || (has_right && !is_beyond_zero(b, 1))) {
    return std::nullopt;
  }
  bool found = false;
  if (has_left) found = add_side(a, -1) || found;
  if (has_right) found = add_side(b, 1) || found;
  return found ? sum_to_goal(parts, options) : std::nullopt;
}

}  // namespace polhode::detail
