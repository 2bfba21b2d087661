#include "exact_interval.hpp"

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/interval.hpp"

namespace polhode::detail {

ball exact_interval::to_ball(precision p) const {
  mpfr_float low = zero_of_precision(p);
  mpfr_float high = zero_of_precision(p);
  if (lower) {
    mpfr_set_q(low.backend().data(), lower->backend().data(), MPFR_RNDD);
  } else {
    mpfr_set_inf(low.backend().data(), -1);
  }
  if (upper) {
    mpfr_set_q(high.backend().data(), upper->backend().data(), MPFR_RNDU);
  } else {
    mpfr_set_inf(high.backend().data(), 1);
  }
  return ball::from_end_points(low.backend().data(), high.backend().data(), p);
}

bool precedes(const exact_interval& x, const exact_interval& y) {
  if (!x.lower || !y.lower) return !x.lower && y.lower;
  return *x.lower < *y.lower;
}

bool ends_before(const exact_interval& x, const exact_interval& y) {
  if (!x.upper || !y.upper) return x.upper && !y.upper;
  return *x.upper < *y.upper;
}

bool holds(const exact_interval& x, const exact_interval& y) {
  return !precedes(y, x) && !ends_before(x, y);
}

bool holds(const ball& x, const exact_interval& y) {
  if (x.is_undefined()) return false;
  const auto is_infinite = [](const mpfr_float& end) {
    return mpfr_inf_p(end.backend().data()) != 0;
  };
  return (y.lower ? contains(x, *y.lower) : is_infinite(lower(x))) &&
         (y.upper ? contains(x, *y.upper) : is_infinite(upper(x)));
}

}  // namespace polhode::detail
