// The class of regions: how one is made, from what it knows, and what it says of its size.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "arithmetic/complex/region_scaled.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode {

using namespace detail::regions;

namespace {

/// The hardware's set holds 0 and the ball does not: an end has underflowed.
bool lost_sign(double_interval in_hardware, const ball& x) {
  return contains_zero(in_hardware) && !x.is_undefined() && !contains_zero(x);
}

}  // namespace

std::string to_text(obstacle o) {
  switch (o) {
    case obstacle::none:
      return "none";
    case obstacle::branch_cut:
      return "branch cut";
    case obstacle::pole:
      return "pole";
    case obstacle::kink:
      return "kink";
    case obstacle::jump:
      return "jump";
    case obstacle::undefined:
      return "undefined";
    case obstacle::unknown:
      return "unknown";
  }
  return "undefined";
}

bool region::needs_balls() const { return left_range(hardware_); }

void region::settle() {
  if (is_undefined(hardware_)) {
    obstacle_ = obstacle::undefined;
    where_ = "argument";
  }
}

region region::blocked(obstacle why, std::string_view function) {
  region r;
  r.hardware_ = {double_interval::undefined(), double_interval::undefined()};
  r.obstacle_ = why;
  r.where_ = function;
  return r;
}

region region::from_balls(const complex_ball& z, bool keep_balls) {
  region r;
  r.hardware_ = {double_interval::from_ball(z.re), double_interval::from_ball(z.im)};
  r.settle();
  const bool lost =
      r.needs_balls() || lost_sign(r.hardware_.re, z.re) || lost_sign(r.hardware_.im, z.im);
  if (r.is_analytic() && (keep_balls || lost)) {
    const polhode::precision p = keep_balls ? std::max(z.precision(), ball_bits + 1) : ball_bits;
    r.balls_ = std::make_shared<const complex_ball>(z.with_precision(p));
  }
  return r;
}

region region::in_balls(const complex_ball& z) { return from_balls(z, true); }

complex_ball region::to_complex_ball() const {
  if (!is_analytic()) return complex_ball::undefined(ball_bits);
  if (balls_ != nullptr) return *balls_;
  return {scale(to_ball(hardware_.re, ball_bits), exponent_),
          scale(to_ball(hardware_.im, ball_bits), exponent_)};
}

namespace {

magnitude to_magnitude(double x, bool up) {
  if (std::isinf(x)) return magnitude::infinity();
  int exponent = 0;
  const auto fraction = static_cast<std::uint64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  const magnitude m =
      up ? magnitude::from_integer_up(fraction) : magnitude::from_integer_down(fraction);
  return scale(m, exponent - 53);
}
}  // namespace

magnitude region::magnitude_upper() const {
  if (!is_analytic()) return magnitude::infinity();
  if (balls_ != nullptr) return balls_->magnitude_upper();
  const double size = knows_modulus() ? modulus().m.upper() : hypot_up(hardware_.re, hardware_.im);
  return scale(to_magnitude(size, true), exponent_);
}
magnitude region::magnitude_lower() const {
  if (!is_analytic()) return {};
  if (balls_ != nullptr) return balls_->magnitude_lower();
  const scaled_interval size = modulus();
  return scale(to_magnitude(size.m.lower(), false), size.exponent);
}

bool region::knows_modulus() const {
  return modulus_.lower() > 0 || modulus_.upper() < detail::infinity;
}

/// |z|, of a set in the hardware.
region::scaled_interval region::modulus() const {
  const double_interval of_rectangle = hypot(hardware_.re, hardware_.im);
  if (!knows_modulus()) return {of_rectangle, exponent_};
  const double_interval both = intersection(of_rectangle, modulus_);
  return {both.is_undefined() ? of_rectangle : both, exponent_};
}

region region::convex_hull() const {
  region r = *this;
  if (knows_modulus()) r.modulus_ = {0, modulus_.upper()};
  return r;
}

region region::with_modulus(const scaled_interval& m) && {
  if (!is_analytic() || !is_in_hardware() || m.m.is_undefined()) return std::move(*this);
  const double_interval own = hypot(hardware_.re, hardware_.im);
  const double_interval news = m.over(exponent_);
  const bool tells_more = news.lower() > own.lower() || news.upper() < own.upper();
  modulus_ = tells_more ? news : not_known;
  return std::move(*this);
}

double_interval region::re() const {
  return is_analytic() ? scale(hardware_.re, exponent_) : double_interval::undefined();
}
double_interval region::im() const {
  return is_analytic() ? scale(hardware_.im, exponent_) : double_interval::undefined();
}

}  // namespace polhode
