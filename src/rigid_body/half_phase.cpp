#include "polhode/rigid_body/half_phase.hpp"

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/elliptic/carlson.hpp"

namespace polhode {

ball rotating_half_phase(const body& rigid, const ball& c) {
  const precision p = c.precision();
  const ball end = c + rigid.b();
  const carlson_pair w = carlson_rf_rj(
      ball(0, p), ball(rational(rigid.a() / (rigid.a() + rigid.b())), p), c / end, ball(1, p));
  const ball sum = rational(1 - rigid.b()) * w.rf + rational(rigid.b() / 3) * w.rj;
  return 2 * sum / sqrt(rational(rigid.a() + rigid.b()) * end);
}

ball rotating_half_phase_slope(const body& rigid, const ball& c) {
  const precision p = c.precision();
  const ball end = c + rigid.b();
  const ball y(rational(rigid.a() / (rigid.a() + rigid.b())), p);
  const ball z = c / end;
  const ball zero(0, p);
  const ball sum = rational(1 - rigid.b()) * carlson_rf(zero, y, z) +
                   rational(rigid.b() / 3) * (1 + c) / end * carlson_rd(zero, y, z);
  return -sum / (end * sqrt(rational(rigid.a() + rigid.b()) * end));
}

ball oscillating_half_phase(const body& rigid, const turning_point& at) {
  const precision p = at.u.precision();
  const rational total(rigid.a() + rigid.b());
  const ball v = (rigid.a() + rigid.b() * at.u) / total;
  const carlson_pair w = carlson_rf_rj(ball(0, p), at.u, v, ball(1, p));
  const ball sum = rational(1 - rigid.b()) * w.rf + rational(rigid.b() / 3) * at.left * w.rj;
  return 2 * sum / sqrt(ball(rational(rigid.b() * total), p));
}

ball oscillating_half_phase_slope(const body& rigid, const turning_point& at) {
  const precision p = at.u.precision();
  const rational total(rigid.a() + rigid.b());
  const ball v = (rigid.a() + rigid.b() * at.u) / total;
  const ball zero(0, p);
  const ball sum = carlson_rd(zero, v, at.u) +
                   rational(rigid.b() * (1 + rigid.a()) / total) * carlson_rd(zero, at.u, v);
  return -sum / (3 * sqrt(ball(rational(rigid.b() * total), p)));
}

}  // namespace polhode
