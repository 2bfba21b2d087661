#include "roots/zero_intervals.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/symbol.hpp"

namespace polhode::detail {
namespace zero_intervals_impl {
namespace {

constexpr precision bits = 128;

/// A formula that takes the place of f between two points.
struct piece {
  end_point lower;
  end_point upper;
  expression formula;
  bool is_zero = false;
};

enum class value_at { zero, not_zero, unknown };

value_at value_of(const expression& f, const rational& x) {
  const ball value = f.evaluator<ball>(bits)(ball(x, bits));
  if (!value.is_undefined() && !contains_zero(value)) return value_at::not_zero;
  try {
    expression_names names = f.names();
    names.variables.clear();
    const auto exact = expression(f(symbol(x)), names).rational_value();
    if (exact) return *exact == 0 ? value_at::zero : value_at::not_zero;
  } catch (const input_error&) {
    return value_at::not_zero;  // f has no value there
  }
  return value_at::unknown;
}

/// For an end that is not rational a number beyond it.
std::optional<rational> beyond(const end_point& x, bool is_lower) {
  if (x.is_infinite() || x.exact()) return x.exact();
  return is_lower ? lower_rational(x.at(bits)) : upper_rational(x.at(bits));
}

/// f is 0 between rational numbers, or beyond one.
bool is_zero_piece(const expression::piece& p) {
  const rational inside = p.lower && p.upper ? rational((*p.lower + *p.upper) / 2)
                          : p.lower          ? rational(*p.lower + 1)
                          : p.upper          ? rational(*p.upper - 1)
                                             : rational(0);
  const ball value = p.formula.evaluator<ball>(bits)(ball(inside, bits));
  if (!value.is_undefined() && !contains_zero(value)) return false;
  return p.formula.exact_value() == rational(0) || p.formula.is_zero_almost_everywhere();
}

/// The pieces of f where one of them is 0, and nothing else; nothing, too, where a piece may end
/// between an irrational end and the number beyond it.
std::vector<piece> pieces_with_zeros(const expression& f, const end_point& lower,
                                     const end_point& upper) {
  constexpr std::size_t most_pieces = 1000;
  if (f.variables().size() != 1) return {};
  const auto found = f.pieces(beyond(lower, true), beyond(upper, false), most_pieces);
  if (!found) return {};
  std::vector<piece> result;
  for (const expression::piece& p : *found) {
    result.push_back({p.lower ? end_point(*p.lower) : lower, p.upper ? end_point(*p.upper) : upper,
                      p.formula, is_zero_piece(p)});
  }
  if (std::ranges::none_of(result, &piece::is_zero)) return {};
  result.front().lower = lower;
  result.back().upper = upper;
  const auto is_proper = [](const piece& p) {
    if (p.lower.is_infinite() || p.upper.is_infinite()) return true;
    if (p.lower.exact() && p.upper.exact()) return *p.lower.exact() < *p.upper.exact();
    return certainly_less(p.lower.at(bits), p.upper.at(bits));
  };
  if (!std::ranges::all_of(result, is_proper)) return {};
  return result;
}

/// Adds the roots that a piece has between its ends.
void add_roots(const piece& p, const isolate_options& options, root_set& result) {
  root_search s(p.formula, p.lower, p.upper);
  s.run(options);
  root_set found = s.result();
  result.complete = result.complete && found.complete;
  result.account.evaluations += found.account.evaluations;
  result.account.boxes += found.account.boxes;
  result.account.most_bits = std::max(result.account.most_bits, found.account.most_bits);
  for (root_region& r : found.regions) {
    bool is_end = false;
    for (const end_point* end : {&p.lower, &p.upper}) {
      if (!end->exact()) continue;
      is_end = is_end || (r.exact == end->exact() && is_one_root(r.verdict));
      // A root that may be the end: what f has there is seen at the end itself.
      if (!r.exact && overlaps(r.enclosure, ball(*end->exact(), bits))) r.may_lie_outside = true;
    }
    if (!is_end) result.regions.push_back(std::move(r));
  }
  std::ranges::move(found.singular, std::back_inserter(result.singular));
}

/// Adds what f has at an end of a piece that is a rational number.
void add_point(const real_function& f, const rational& x, value_at value, root_set& result) {
  root_region r;
  r.box = r.enclosure = ball(x, std::max(bits, static_cast<precision>(size_in_bits(x))));
  r.function = r.simple = std::make_shared<real_function>(f);
  if (value == value_at::zero) {
    r.verdict = root_verdict::isolated;
    r.exact = x;
  } else {
    r.remark = "the value at this point is not decided";
  }
  result.regions.push_back(std::move(r));
}

}  // namespace
}  // namespace zero_intervals_impl

std::optional<root_set> roots_beside_zeros(const real_function& f, const end_point& lower,
                                           const end_point& upper, const isolate_options& options) {
  using namespace zero_intervals_impl;
  if (f.formula() == nullptr) return std::nullopt;
  const std::vector<piece> pieces = pieces_with_zeros(*f.formula(), lower, upper);
  if (pieces.empty()) return std::nullopt;
  root_set result;
  // At a point between pieces, which is rational, or at an end of the range. If that is not, it is
  // inside its piece.
  const auto value = [&](const end_point& x, const piece& p) {
    if (x.exact()) return value_of(*f.formula(), *x.exact());
    return p.is_zero && !x.is_infinite() ? value_at::zero : value_at::not_zero;
  };
  value_at at_lower = value(pieces.front().lower, pieces.front());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const piece& p = pieces[k];
    const bool follows_zero = k > 0 && pieces[k - 1].is_zero;
    const bool is_shown = at_lower == value_at::unknown ||
                          (at_lower == value_at::zero && !follows_zero && !p.is_zero);
    if (is_shown) add_point(f, *p.lower.exact(), at_lower, result);
    const value_at at_upper = value(p.upper, p);
    if (!p.is_zero) {
      add_roots(p, options, result);
    } else if (follows_zero && at_lower == value_at::zero) {
      result.zero_intervals.back().upper = p.upper;
      result.zero_intervals.back().has_upper = at_upper == value_at::zero;
    } else {
      result.zero_intervals.push_back(
          {p.lower, p.upper, at_lower == value_at::zero, at_upper == value_at::zero});
    }
    at_lower = at_upper;
  }
  const bool ends_shown =
      at_lower == value_at::unknown || (at_lower == value_at::zero && !pieces.back().is_zero);
  if (ends_shown) add_point(f, *pieces.back().upper.exact(), at_lower, result);
  return result;
}

}  // namespace polhode::detail
