#pragma once

// Vectors and matrices of balls: boxes, and the linear algebra of their systems.

#include <vector>

#include "polhode/arithmetic/ball.hpp"

namespace polhode::boxes {

using vector = std::vector<ball>;
using matrix = std::vector<vector>;

/// In any component.
[[nodiscard]] bool is_undefined(const vector& x);
[[nodiscard]] bool is_bounded(const vector& x);
[[nodiscard]] bool all_overlap(const vector& x, const vector& y);
/// Every member of y is one of x; of its interior.
[[nodiscard]] bool holds(const vector& x, const vector& y);
[[nodiscard]] bool holds_inside(const vector& x, const vector& y);
[[nodiscard]] bool holds_zero(const vector& x);
[[nodiscard]] vector middle_of(const vector& x);
[[nodiscard]] vector with_precision(const vector& x, precision p);
/// Undefined in a component where there is no common part.
[[nodiscard]] vector common(const vector& x, const vector& y);
/// The least box that holds both.
[[nodiscard]] vector joined(const vector& x, const vector& y);
/// The greatest radius.
[[nodiscard]] magnitude widest(const vector& x);
/// Points near the inverse of the middles of a, by elimination with the largest pivot; empty where
/// a pivot is 0. Nothing rests on how near they are.
[[nodiscard]] matrix approximate_inverse(const matrix& a, precision p);
[[nodiscard]] vector product(const matrix& a, const vector& x);
[[nodiscard]] matrix product(const matrix& a, const matrix& b);
[[nodiscard]] vector difference_of(const vector& x, const vector& y);

}  // namespace polhode::boxes
