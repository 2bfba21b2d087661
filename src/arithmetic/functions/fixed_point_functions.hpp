#pragma once

// exp, sinh, cosh, log, sin, cos and atan by algorithms of our own, where MPFR's functions take
// several times as long as they need.

#include <mpfr.h>

#include "polhode/arithmetic/magnitude.hpp"

namespace polhode::detail {

/// Each sets r to a number near f(x) and returns true; `error` is then a bound of |r - f(x)|, which
/// is at most (1/2 + 2^-10) units in r's last place. Each returns false, and leaves r unspecified,
/// for the arguments and precisions that it leaves to MPFR. Hypothesis: r is not x.
using near_function = bool (*)(mpfr_ptr r, mpfr_srcptr x, magnitude& error);
bool near_exp(mpfr_ptr r, mpfr_srcptr x, magnitude& error);
bool near_sinh(mpfr_ptr r, mpfr_srcptr x, magnitude& error);
bool near_cosh(mpfr_ptr r, mpfr_srcptr x, magnitude& error);
bool near_log(mpfr_ptr r, mpfr_srcptr x, magnitude& error);
bool near_atan(mpfr_ptr r, mpfr_srcptr x, magnitude& error);
bool near_sin(mpfr_ptr r, mpfr_srcptr x, magnitude& error);
bool near_cos(mpfr_ptr r, mpfr_srcptr x, magnitude& error);

/// Which of two values were found.
struct near_pair {
  bool sine;
  bool cosine;
};
/// near_sin and near_cos together, the same bit for bit, for results of one precision. Either
/// pointer may be null.
near_pair near_sin_cos(mpfr_ptr sine, mpfr_ptr cosine, mpfr_srcptr x, magnitude& sine_error,
                       magnitude& cosine_error);

}  // namespace polhode::detail
