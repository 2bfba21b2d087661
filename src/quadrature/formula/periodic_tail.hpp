#pragma once

// Tails of functions that have a period but for a decaying factor, over one period.

#include <cstddef>
#include <optional>
#include <vector>

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode::detail {

/// The integral of f from `start` to infinity is that of `folded` from -half to half, but for a
/// number of at most `rest` in size.
struct periodic_tail {
  end_point start;
  expression folded;
  pi_combination half;
  magnitude rest;
};

/// The tail of a sum of products of a function of one period that is integrable with others: these
/// rational functions and powers of x and of polynomials with coefficients of the period, which
/// decay faster than 1/x, or decay where the periodic ones are shown to have the mean 0
/// (expression::as_periodic_sum); or any that decay exponentially, about. start >= from, and the
/// rest is about 2^-p beside the size of the terms. None for other formulas.
[[nodiscard]] std::optional<periodic_tail> periodic_tail_of(const expression& f,
                                                            const rational& from, precision p);

/// Z(s), Z(s+1), ..., Z(s+count-1), Z(c) = the sum of (x + n period)^-c over n >= 0: the first
/// `shifts` terms, and for the others the formula of Euler and Maclaurin to this order, with p
/// bits. Hypotheses: s > 1, x > 0, period > 0.
[[nodiscard]] std::vector<ball> sums_of_powers(const rational& s, const rational& x,
                                               const ball& period, std::size_t count, long shifts,
                                               long order, precision p);

}  // namespace polhode::detail
