#pragma once

// Balls for those who think in end points, with the names of IEEE 1788-2015 beside ours.
//
//   IEEE 1788            here
//   numsToInterval       from_end_points; ball::from_end_points of two mpfr_t
//   textToInterval       parse_interval
//   inf, sup, mid        lower, upper, midpoint (boost_bridge.hpp; as members, into an mpfr_t)
//   wid, rad             width, half_width
//   mag, mig             magnitude_of, mignitude_of
//   convexHull           hull
//   intersection         intersection, undefined where empty; common_part, std::nullopt where empty
//   cancelPlus/Minus     cancel_plus, cancel_minus
//   isEmpty              no ball is empty; functions that may have an empty result return
//                        std::optional
//   isEntire             is_entire
//   isCommonInterval     ball::is_bounded
//   isSingleton          ball::is_exact
//   isMember             contains(x, q)
//   equal                is_equal
//   subset, interior     is_subset (which is contains, the other way round), is_interior
//   less, strictLess     ends_less_equal, ends_less
//   precedes,            certainly_less_equal,
//   strictPrecedes       certainly_less
//   disjoint             !overlaps
//   the functions over their natural domains: natural_domain.hpp
//
// A ball kept by midpoint and radius has ends that need more bits than it has; the numbers below
// are rounded, in the direction that is stated, to its precision. The questions are decided
// exactly, but for a radius below MPFR's least positive number, which counts as that number. An
// undefined ball has NaN for every number and no for every question.

#include <optional>
#include <string_view>
#include <utility>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode {

/// The set [lower, upper], ends rounded outward to p bits. Throws input_error where lower > upper,
/// and the second also for what ball::from_end_points refuses.
[[nodiscard]] ball from_end_points(const rational& lower, const rational& upper, precision p);
[[nodiscard]] ball from_end_points(const mpfr_float& lower, const mpfr_float& upper, precision p);

/// Reads "[0.1, 1/3]", "[-inf, 2]", "[0.1]" or "[entire]": numbers as parse_rational reads them,
/// between spaces or none, taken exactly and then rounded outward to p bits. Throws input_error for
/// anything else.
[[nodiscard]] ball parse_interval(std::string_view text, precision p);

/// upper - lower, rounded up; infinite where x is not bounded (IEEE 1788: wid).
[[nodiscard]] mpfr_float width(const ball& x);
/// The least r, rounded up, with |t - midpoint(x)| <= r for every member t; infinite where x is not
/// bounded (IEEE 1788: rad).
[[nodiscard]] mpfr_float half_width(const ball& x);
/// The greatest |t| over the set, rounded up, and the least one, rounded down (IEEE 1788: mag,
/// mig).
[[nodiscard]] mpfr_float magnitude_of(const ball& x);
[[nodiscard]] mpfr_float mignitude_of(const ball& x);

/// Enclosures of [lower, cut] and [cut, upper], which together hold all of x: with the same cut, a
/// number of x's precision near its middle. [a, inf) is cut at 2a + 1 or, for a < 0, at 0; (-inf,
/// a] likewise; the line at 0.
[[nodiscard]] std::pair<ball, ball> split(const ball& x);

/// The common part of the two sets; std::nullopt where it is empty (IEEE 1788: intersection).
[[nodiscard]] std::optional<ball> common_part(const ball& x, const ball& y);

/// The least set z with y + z holding all of x; the entire line where x is wider than y, or one of
/// them is not bounded (IEEE 1788: cancelMinus). Undoes x = y + z.
[[nodiscard]] ball cancel_minus(const ball& x, const ball& y);
/// cancel_minus(x, -y) (IEEE 1788: cancelPlus).
[[nodiscard]] ball cancel_plus(const ball& x, const ball& y);

[[nodiscard]] bool is_entire(const ball& x);
/// The same set.
[[nodiscard]] bool is_equal(const ball& x, const ball& y);
/// Every member of x is one of y, or one of y's interior (IEEE 1788: subset, interior).
[[nodiscard]] bool is_subset(const ball& x, const ball& y);
[[nodiscard]] bool is_interior(const ball& x, const ball& y);
/// Each end of x is at most the same end of y, or less than it; equal infinite ends count as less
/// (IEEE 1788: less, strictLess).
[[nodiscard]] bool ends_less_equal(const ball& x, const ball& y);
[[nodiscard]] bool ends_less(const ball& x, const ball& y);
/// x is bounded, and has no integer in it.
[[nodiscard]] inline bool holds_no_integer(const ball& x) {
  return x.is_bounded() && rational(ceil_of(lower_rational(x))) > upper_rational(x);
}

}  // namespace polhode
