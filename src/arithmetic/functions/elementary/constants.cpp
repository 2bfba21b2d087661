// pi and log 2.

#include "arithmetic/ball/ball_access.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode {

namespace {

ball constant(int (*f)(mpfr_ptr, mpfr_rnd_t), precision p) {
  ball r;
  detail::set_midpoint(r, checked_precision(p), {},
                       [&](mpfr_ptr value) { return f(value, MPFR_RNDN); });
  return r;
}

}  // namespace

ball pi(precision p) { return constant(mpfr_const_pi, p); }
ball log_2(precision p) { return constant(mpfr_const_log2, p); }

}  // namespace polhode
