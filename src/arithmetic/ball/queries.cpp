// What a ball says of itself: its ends, midpoint, radius and size; and the same ball at another
// precision, or larger.

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/forms.hpp"
#include "polhode/arithmetic/ball.hpp"

namespace polhode {

using detail::end_points;
using detail::mpfr_cell;
using detail::set_middle;
using detail::shifted_by_radius;
using form = ball_access::form;

bool ball::is_bounded() const {
  switch (form_) {
    case form::midpoint_radius:
      return true;
    case form::end_points:
      return mpfr_inf_p(first_.get()) == 0 && mpfr_inf_p(second_.get()) == 0;
    case form::undefined:
      return false;
  }
  return false;
}

bool ball::is_exact() const { return form_ == form::midpoint_radius && radius_.is_zero(); }

void ball::lower(mpfr_ptr r) const {
  switch (form_) {
    case form::midpoint_radius:
      shifted_by_radius(r, first_.get(), radius_, -1);
      break;
    case form::end_points:
      mpfr_set(r, first_.get(), MPFR_RNDD);
      break;
    case form::undefined:
      mpfr_set_nan(r);
      break;
  }
}

void ball::upper(mpfr_ptr r) const {
  switch (form_) {
    case form::midpoint_radius:
      shifted_by_radius(r, first_.get(), radius_, 1);
      break;
    case form::end_points:
      mpfr_set(r, second_.get(), MPFR_RNDU);
      break;
    case form::undefined:
      mpfr_set_nan(r);
      break;
  }
}

void ball::midpoint(mpfr_ptr r) const {
  switch (form_) {
    case form::midpoint_radius:
      mpfr_set(r, first_.get(), MPFR_RNDN);
      break;
    case form::end_points:
      if (!is_bounded()) {
        const bool lower_infinite = mpfr_inf_p(first_.get()) != 0;
        const bool upper_infinite = mpfr_inf_p(second_.get()) != 0;
        if (lower_infinite && upper_infinite) {
          mpfr_set_zero(r, 1);
        } else {
          mpfr_set(r, lower_infinite ? second_.get() : first_.get(), MPFR_RNDN);
        }
      } else {
        set_middle(r, first_.get(), second_.get());
      }
      break;
    case form::undefined:
      mpfr_set_nan(r);
      break;
  }
}

magnitude ball::radius() const {
  switch (form_) {
    case form::midpoint_radius:
      return radius_;
    case form::end_points: {
      if (!is_bounded()) return magnitude::infinity();
      // The midpoint is rounded: the greater of the two distances to it is the radius.
      mpfr_cell middle(precision());
      midpoint(middle.get());
      mpfr_cell distance(64);
      mpfr_sub(distance.get(), second_.get(), middle.get(), MPFR_RNDU);
      const magnitude above = magnitude::abs_up(distance.get());
      mpfr_sub(distance.get(), middle.get(), first_.get(), MPFR_RNDU);
      return max(above, magnitude::abs_up(distance.get()));
    }
    case form::undefined:
      break;
  }
  return magnitude::infinity();
}

magnitude ball::magnitude_upper() const {
  switch (form_) {
    case form::midpoint_radius:
      return add_up(magnitude::abs_up(first_.get()), radius_);
    case form::end_points:
      return max(magnitude::abs_up(first_.get()), magnitude::abs_up(second_.get()));
    case form::undefined:
      break;
  }
  return magnitude::infinity();
}

magnitude ball::magnitude_lower() const {
  switch (form_) {
    case form::midpoint_radius:
      return subtract_down(magnitude::abs_down(first_.get()), radius_);
    case form::end_points:
      if (mpfr_sgn(first_.get()) > 0) return magnitude::abs_down(first_.get());
      if (mpfr_sgn(second_.get()) < 0) return magnitude::abs_down(second_.get());
      return {};
    case form::undefined:
      break;
  }
  return {};
}

ball ball::with_precision(polhode::precision p) const {
  checked_precision(p);
  ball r;
  switch (form_) {
    case form::midpoint_radius: {
      r.first_.reset(p);
      const int ternary = mpfr_set(r.first_.get(), first_.get(), MPFR_RNDN);
      ball_access::finish(r, ternary, radius_);
      break;
    }
    case form::end_points: {
      mpfr_cell low(p);
      mpfr_cell high(p);
      mpfr_set(low.get(), first_.get(), MPFR_RNDD);
      mpfr_set(high.get(), second_.get(), MPFR_RNDU);
      ball_access::set_exact_ends(r, low, high);
      break;
    }
    case form::undefined:
      return undefined(p);
  }
  return r;
}

ball ball::middle() const {
  if (!is_bounded()) return undefined(precision());
  ball r;
  r.first_.reset(precision());
  midpoint(r.first_.get());
  return r;
}

ball ball::enlarged(const magnitude& error) const {
  ball r = *this;
  if (error.is_zero()) return r;
  if (form_ == form::midpoint_radius) {
    ball_access::finish(r, 0, add_up(radius_, error));
  } else if (form_ == form::end_points) {
    if (error.is_infinite()) return entire(precision());
    mpfr_cell low(precision());
    mpfr_cell high(precision());
    shifted_by_radius(low.get(), first_.get(), error, -1);
    shifted_by_radius(high.get(), second_.get(), error, 1);
    ball_access::set_ends(r, low, high);
  }
  return r;
}

}  // namespace polhode
