#include "polhode/rigid_body/phase_integrands.hpp"

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/elliptic/complete.hpp"

namespace polhode {

void check(const oscillating_motion& motion) {
  const auto out_of_range = [](const char* name, const exact_real& given, const char* range) {
    throw input_error(std::string(name) + " = " + to_text(given) + ": it must be " + range);
  };
  if (motion.a <= 0) out_of_range("a", motion.a, "positive");
  if (motion.b <= 0 || motion.b >= 1) out_of_range("b", motion.b, "between 0 and 1, ends excluded");
  if (motion.u <= 0 || motion.u > 1) out_of_range("u", motion.u, "above 0 and at most 1");
}

detail::strip_range detail::range_on_strip(const ball& u, const ball& half_width) {
  const ball spread = (1 - u) * square(sinh(scale(half_width, -1)));
  return {1 + spread, u - spread};
}

namespace {
/// |x (a + b x)| >= below (a + b below) on the strip; nothing where below > 0 is not proved.
struct bounded_product {
  ball least;
  ball above;
};
std::optional<bounded_product> product_on_strip(const oscillating_motion& motion,
                                                const ball& half_width) {
  const precision p = half_width.precision();
  const detail::strip_range x = detail::range_on_strip(ball(motion.u, p), half_width);
  if (!certainly_positive(half_width) || !certainly_positive(x.below)) return std::nullopt;
  return bounded_product{x.below * (motion.a + motion.b * x.below), x.above};
}
}  // namespace

std::optional<strip_bound> half_phase_integrand::bound_on_strip(const ball& half_width) const {
  const auto product = product_on_strip(motion_, half_width);
  if (!product) return std::nullopt;
  return strip_bound{half_width,
                     (1 + motion_.b * product->above) / sqrt(motion_.b * product->least)};
}

std::optional<strip_bound> half_phase_slope_integrand::bound_on_strip(
    const ball& half_width) const {
  const auto product = product_on_strip(motion_, half_width);
  if (!product) return std::nullopt;
  const exact_real slope = (motion_.a + 2) * motion_.b;
  const ball numerator = (1 + cosh(half_width)) * (motion_.a + slope * product->above);
  const ball root_b = sqrt(motion_.b.at(half_width.precision()));
  return strip_bound{half_width, numerator / (4 * root_b * product->least * sqrt(product->least))};
}

ball half_phase_slope(const oscillating_motion& motion, precision p) {
  check(motion);
  const exact_real& a = motion.a;
  const exact_real& b = motion.b;
  const exact_real u(motion.u);
  const exact_real v = (a + b * u) / (a + b);
  const exact_real ratio = u / v;
  const exact_real r = b * (1 + a) / (a + b);
  const exact_real m = a * (1 - u) / (a + b * u);
  const complete_integrals integrals = complete_legendre(m.at(p), ratio.at(p));
  const ball sum = integrals.b + r * ratio * integrals.d;
  return -sum / (motion.u * sqrt((b * (a + b) * v).at(p)));
}

}  // namespace polhode
