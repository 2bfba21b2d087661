#include "odeint.hpp"

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

namespace polhode::cost {
namespace {

using odeint_state = std::array<double, 7>;  // J, then w, x, y, z

class equations {
 public:
  explicit equations(const std::array<rational, 6>& tensor) {
    for (std::size_t i = 0; i < 3; ++i) inverse_[i] = static_cast<double>(rational(1 / tensor[i]));
  }
  void operator()(const odeint_state& x, odeint_state& slope, double) const {
    const auto& [jx, jy, jz, w, a, b, c] = x;
    const double ox = jx * inverse_[0];
    const double oy = jy * inverse_[1];
    const double oz = jz * inverse_[2];
    slope = {jy * oz - jz * oy,
             jz * ox - jx * oz,
             jx * oy - jy * ox,
             (-a * ox - b * oy - c * oz) / 2,
             (w * ox + b * oz - c * oy) / 2,
             (w * oy + c * ox - a * oz) / 2,
             (w * oz + a * oy - b * ox) / 2};
  }

 private:
  std::array<double, 3> inverse_{};
};

}  // namespace

integrated_rotation rotation_by_dopri5(const initial_state& start, double t, double tolerance) {
  const auto j = rotor<double>(start).sample(0.0).momentum;
  odeint_state x{j[0], j[1], j[2], 1, 0, 0, 0};
  namespace ode = boost::numeric::odeint;
  ode::integrate_adaptive(
      ode::make_controlled<ode::runge_kutta_dopri5<odeint_state>>(tolerance, tolerance),
      equations(start.tensor().tensor()), x, 0.0, t, 1e-3);
  return {{x[0], x[1], x[2]}, {x[3], x[4], x[5], x[6]}};
}

matrix3<double> integrated_rotation::matrix() const {
  const auto& [w, x, y, z] = quaternion;
  const double k = 2 / (w * w + x * x + y * y + z * z);
  return {{{1 - k * (y * y + z * z), k * (x * y - w * z), k * (x * z + w * y)},
           {k * (x * y + w * z), 1 - k * (x * x + z * z), k * (y * z - w * x)},
           {k * (x * z - w * y), k * (y * z + w * x), 1 - k * (x * x + y * y)}}};
}

}  // namespace polhode::cost
