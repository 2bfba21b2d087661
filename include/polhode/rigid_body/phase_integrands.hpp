#pragma once

// The Montgomery phase of oscillating motion as periodic quadrature.
//
// For a > 0, 0 < b < 1, 0 < u <= 1 (mathematics of the paper's section 4 and appendix A): with
// x(t) = ((1 + u) + (1 - u) cos t) / 2, which runs from 1 to u as t runs from 0 to pi,
//
//   G(u) = F(-b u, u) = b^(-1/2) integral from 0 to pi of (1 - b x) / sqrt(x (a + b x)) dt,
//   dG/du = -(1/2) b^(-1/2) integral from 0 to pi of
//               ((1 + cos t)/2) (a + (a + 2) b X) / (X (a + b X))^(3/2) dt,   X = x(pi - t).
//
// The first is the paper's eq. (14) under its substitution x = cos^2 + u sin^2; the second its eq.
// (44) with y = sin(t/2), where X = u + (1 - u) y^2. Half the Montgomery phase is G.

#include <optional>

#include "polhode/arithmetic/exact_real.hpp"
#include "polhode/arithmetic/scalar.hpp"
#include "polhode/quadrature/error_bounds.hpp"

namespace polhode {

/// What G is a function of: a body and a point of the curve S, exact, as a person gives them and
/// before anything is checked. The parameters of a claim about one motion (proofs/claim.hpp) and of
/// the integrands below.
///
/// It stands beside the class motion, whose c is -b u, as the other does not hold what this one is
/// for: u = 1 has a value of G here, the limit pi I, where motion is an equilibrium without period
/// and phase; a = 0 is refused here, where motion takes equal moments; and what is out of range is
/// refused in terms of u, which the person typed, when it is used: a claim about the body alone
/// takes any u.
struct oscillating_motion {
  exact_real a;  // I_y/I_z - 1 > 0
  exact_real b;  // 1 - I_y/I_x, in (0, 1)
  rational u;    // -c/b, in (0, 1]
};

/// Throws input_error, which names the parameter, where one is out of its range.
void check(const oscillating_motion& motion);

namespace detail {
/// Bounds of x(t) for |Im t| <= H: |x| <= above = ((1 + u) + (1 - u) cosh H) / 2 and
/// Re x >= below = ((1 + u) - (1 - u) cosh H) / 2.
/// Proof: |cos t| <= cosh H and Re cos t >= -cosh H there, and 1 - u >= 0. Both are formed with
/// cosh H = 1 + 2 sinh^2(H/2), which loses no digits where u and H are small.
struct strip_range {
  ball above;
  ball below;
};
[[nodiscard]] strip_range range_on_strip(const ball& u, const ball& half_width);
}  // namespace detail

/// The integrand of G(u), for integrate_periodic. The constructor calls check: the bound on the
/// strip is false for u > 1.
class half_phase_integrand {
 public:
  explicit half_phase_integrand(oscillating_motion motion) : motion_(std::move(motion)) {
    check(motion_);
  }

  template <scalar T>
  [[nodiscard]] auto evaluator(precision p) const {
    const T a = scalar_from<T>(motion_.a, p);
    const T b = scalar_from<T>(motion_.b, p);
    const T mean = scalar_from<T>(rational((1 + motion_.u) / 2), p);
    const T half = scalar_from<T>(rational((1 - motion_.u) / 2), p);
    const T root_b = sqrt(b);
    return [=](const T& cosine) -> T {
      const T x = mean + half * cosine;
      const T bx = b * x;
      return (1 - bx) / (root_b * sqrt(T(x * (a + bx))));
    };
  }

  /// |integrand| <= (1 + b above) / sqrt(b below (a + b below)), where below > 0 is checked: then x
  /// and a + b x have positive real parts, so that sqrt(x) sqrt(a + b x) is analytic, equals sqrt(x
  /// (a + b x)) on the real line, and |x| >= Re x >= below, |a + b x| >= a + b below.
  [[nodiscard]] std::optional<strip_bound> bound_on_strip(const ball& half_width) const;

 private:
  oscillating_motion motion_;
};

/// The integrand of dG/du. The constructor calls check.
class half_phase_slope_integrand {
 public:
  explicit half_phase_slope_integrand(oscillating_motion motion) : motion_(std::move(motion)) {
    check(motion_);
  }

  template <scalar T>
  [[nodiscard]] auto evaluator(precision p) const {
    const T a = scalar_from<T>(motion_.a, p);
    const T b = scalar_from<T>(motion_.b, p);
    const T mean = scalar_from<T>(rational((1 + motion_.u) / 2), p);
    const T half = scalar_from<T>(rational((1 - motion_.u) / 2), p);
    const T slope = scalar_from<T>((motion_.a + 2) * motion_.b, p);
    const T minus_four_root_b = -4 * sqrt(b);
    return [=](const T& cosine) -> T {
      const T x = mean - half * cosine;
      const T product = x * (a + b * x);
      return (1 + cosine) * (a + slope * x) / T(minus_four_root_b * T(product * sqrt(product)));
    };
  }

  /// |integrand| <= (1 + cosh H) (a + (a + 2) b above) / (4 sqrt(b) (below (a + b below))^(3/2)),
  /// under the condition and by the argument of half_phase_integrand.
  [[nodiscard]] std::optional<strip_bound> bound_on_strip(const ball& half_width) const;

 private:
  oscillating_motion motion_;
};

/// dG/du by complete elliptic integrals (AGM), to about p bits; calls check. With v = (a + b u)/(a
/// + b), m = 1 - u/v and r = b (1 + a)/(a + b),
///   dG/du = -(B(m) + r (u/v) D(m)) / (u sqrt(b (a + b) v)).
/// Here 1 - u/v = a (1 - u)/(a + b u) and u/v are formed exactly, and both terms are positive. (It
/// equals Carlson's -[(a + b) R_D(0, v, u) + b (1 + a) R_D(0, u, v)] / (3 sqrt(b) (a + b)^(3/2)).)
///
/// Proof. In eq. (44) put y = sin s, tan s = sqrt(u) tan t, and q = cos^2 t + u sin^2 t, so that
/// cos^2 s = cos^2 t / q, X = u/q, ds = sqrt(u)/q dt. Then a q + b u = (a + b) sigma with sigma = v
/// cos^2 t + u sin^2 t = v (1 - m sin^2 t), and -u sqrt(b (a + b)) dG/du is the integral over (0,
/// pi/2) of cos^2 t (sigma^(-1/2) + r u sigma^(-3/2)). The first term gives v^(-1/2) B(m). For the
/// second, with Delta^2 = 1 - m sin^2 t, the integral of cos^2 t / Delta^3 is D(m), that of sin^2 t
/// / Delta, because d/dt (sin t cos t / Delta) = cos^2 t / Delta^3 - sin^2 t / Delta.
[[nodiscard]] ball half_phase_slope(const oscillating_motion& motion, precision p);

}  // namespace polhode
