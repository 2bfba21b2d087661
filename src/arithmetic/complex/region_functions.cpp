// Elementary functions of regions.

#include <optional>
#include <utility>

#include "arithmetic/complex/region_shapes.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode {

using namespace detail::regions;

#define POLHODE_RECTANGLE_FUNCTION(f) [](const auto& x) { return f(x); }
#define POLHODE_SINGULAR(f) [](const auto& x) { return possibly_singular::f(x); }

/// size e^(i angle).
region region::rotating(double_interval size, double_interval angle) {
  const auto [sine, cosine] = sin_cos(angle);
  region r;
  r.hardware_ = {times(size, cosine), times(size, sine)};
  // The rectangle does not say more: a product of the size and both functions, each rounded.
  if (r.is_analytic() && r.is_in_hardware() && !size.is_undefined()) r.modulus_ = size;
  return r;
}
region exp(const region& z) {
  // Far from overflow and underflow the hardware's operations do.
  if (z.is_moderate() && z.hardware_.re.magnitude() < region::moderate_exponent) {
    return region::rotating(exp(z.hardware_.re), z.hardware_.im);
  }
  const auto scaled_form = [](const region::scaled& x) { return region::scaled::exp(x); };
  if (auto r = region::functions::in_scale(z, scaled_form)) return *std::move(r);
  return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(exp), scaled_form,
                                   z.hardware_.re.lower() < -region::moderate_exponent);
}

region cosh(const region& z) {
  if (z.is_moderate() && z.hardware_.re.magnitude() < region::moderate_exponent) {
    return region::hyperbolic(z.hardware_.re, z.hardware_.im, true);
  }
  if (auto r = region::functions::in_scale(z, region::scaled::cosh)) return *std::move(r);
  return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(cosh), region::scaled::cosh);
}
region sinh(const region& z) {
  if (z.is_moderate() && z.hardware_.re.magnitude() < region::moderate_exponent) {
    return region::hyperbolic(z.hardware_.re, z.hardware_.im, false);
  }
  if (auto r = region::functions::in_scale(z, region::scaled::sinh)) return *std::move(r);
  return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(sinh), region::scaled::sinh);
}
// cos z = cosh(iz), sin z = -i sinh(iz).
region cos(const region& z) {
  if (z.is_moderate() && z.hardware_.im.magnitude() < region::moderate_exponent) {
    return region::hyperbolic(-z.hardware_.im, z.hardware_.re, true);
  }
  if (auto r = region::functions::in_scale(z, region::scaled::cos)) return *std::move(r);
  return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(cos), region::scaled::cos);
}
region sin(const region& z) {
  if (z.is_moderate() && z.hardware_.im.magnitude() < region::moderate_exponent) {
    region s = region::hyperbolic(-z.hardware_.im, z.hardware_.re, false);
    s.hardware_ = {s.hardware_.im, -s.hardware_.re};
    return s;
  }
  if (auto r = region::functions::in_scale(z, region::scaled::sin)) return *std::move(r);
  return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(sin), region::scaled::sin);
}

/// cosh(x + iy) or sinh(x + iy), as in `scaled`.
region region::hyperbolic(double_interval x, double_interval y, bool is_cosh) {
  const auto [s, c] = real_set<double_interval>::sinh_cosh(x);
  const auto [sine, cosine] = sin_cos(y);
  region r;
  if (is_cosh) {
    r.hardware_ = {times(c, cosine), times(s, sine)};
  } else {
    r.hardware_ = {times(s, cosine), times(c, sine)};
  }
  if (s.mignitude() == 0) return r;  // nothing is known that is worth its keeping
  return std::move(r).with_modulus({hull(abs(s), c), 0});
}

#define POLHODE_AWAY_FROM(f, why)                                                  \
  region f(const region& z) {                                                      \
    return region::functions::away_from(z, obstacle::why, #f, POLHODE_SINGULAR(f), \
                                        POLHODE_RECTANGLE_FUNCTION(f),             \
                                        region::functions::without_scale);         \
  }
region sqrt(const region& z) {
  return region::functions::away_from(z, obstacle::branch_cut, "sqrt", POLHODE_SINGULAR(sqrt),
                                      POLHODE_RECTANGLE_FUNCTION(sqrt), region::scaled::sqrt);
}
POLHODE_AWAY_FROM(log, branch_cut)
POLHODE_AWAY_FROM(tan, pole)
POLHODE_AWAY_FROM(tanh, pole)
POLHODE_AWAY_FROM(asin, branch_cut)
POLHODE_AWAY_FROM(acos, branch_cut)
POLHODE_AWAY_FROM(atan, branch_cut)
POLHODE_AWAY_FROM(asinh, branch_cut)
POLHODE_AWAY_FROM(acosh, branch_cut)
POLHODE_AWAY_FROM(atanh, branch_cut)
#undef POLHODE_AWAY_FROM
#undef POLHODE_SINGULAR
#undef POLHODE_RECTANGLE_FUNCTION

}  // namespace polhode
