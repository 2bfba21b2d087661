#include "polhode/rigid_body/half_phase.hpp"

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/elliptic/carlson.hpp"

namespace polhode {

ball rotating_half_phase(const body& rigid, const ball& c) {
  const precision p = c.precision();
  const exact_real& b = rigid.b();
  const exact_real total = rigid.a() + b;
  const ball end = c + b;
  const carlson_pair w = carlson_rf_rj(ball(0, p), (rigid.a() / total).at(p), c / end, ball(1, p));
  const ball sum = (1 - b) * w.rf + b / 3 * w.rj;
  return 2 * sum / sqrt(total * end);
}

ball rotating_half_phase_slope(const body& rigid, const ball& c) {
  const precision p = c.precision();
  const exact_real& b = rigid.b();
  const exact_real total = rigid.a() + b;
  const ball end = c + b;
  const ball y = (rigid.a() / total).at(p);
  const ball z = c / end;
  const ball zero(0, p);
  const ball sum =
      (1 - b) * carlson_rf(zero, y, z) + b / 3 * (1 + c) / end * carlson_rd(zero, y, z);
  return -sum / (end * sqrt(total * end));
}

ball oscillating_half_phase(const body& rigid, const turning_point& at) {
  const precision p = at.u.precision();
  const exact_real& b = rigid.b();
  const exact_real total = rigid.a() + b;
  const ball v = (rigid.a() + b * at.u) / total;
  const carlson_pair w = carlson_rf_rj(ball(0, p), at.u, v, ball(1, p));
  const ball sum = (1 - b) * w.rf + b / 3 * at.left * w.rj;
  return 2 * sum / sqrt((b * total).at(p));
}

ball oscillating_half_phase_slope(const body& rigid, const turning_point& at) {
  const precision p = at.u.precision();
  const exact_real& b = rigid.b();
  const exact_real total = rigid.a() + b;
  const ball v = (rigid.a() + b * at.u) / total;
  const ball zero(0, p);
  const ball sum =
      carlson_rd(zero, v, at.u) + b * (1 + rigid.a()) / total * carlson_rd(zero, at.u, v);
  return -sum / (3 * sqrt((b * total).at(p)));
}

}  // namespace polhode
