#include "scene/motion.hpp"

#include <algorithm>
#include <stdexcept>

#include <tbb/parallel_for.h>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/rotor.hpp"

namespace polhode::detail {
namespace {

/// Rotations by the principal axes, of which the columns are unit vectors: from the principal frame to the given one.
matrix3<rational> frame_of(const scene_body& of) {
  matrix3<rational> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const rational& square = of.axes[k].square;
    const rational length(integer(sqrt(numerator(square))), integer(sqrt(denominator(square))));
    for (std::size_t i = 0; i < 3; ++i) result[i][k] = of.axes[k].direction[i] / length;
  }
  return result;
}

template <class T>
T number_of(const rational& q, precision p);
template <>
ball number_of<ball>(const rational& q, precision p) {
  return {q, p};
}
template <>
double number_of<double>(const rational& q, precision) {
  return static_cast<double>(q);
}
template <class T>
T number_of(const ball& x, precision) {
  if constexpr (std::same_as<T, ball>) {
    return x;
  } else {
    return midpoint(x).convert_to<T>();
  }
}
template <class T, class From>
matrix3<T> numbers_of(const matrix3<From>& x, precision p) {
  matrix3<T> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i][k] = number_of<T>(x[i][k], p);
  }
  return result;
}

template <class T>
matrix3<T> product(const matrix3<T>& x, const matrix3<T>& y) {
  matrix3<T> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      result[i][k] = x[i][0] * y[0][k] + x[i][1] * y[1][k] + x[i][2] * y[2][k];
  }
  return result;
}
template <class T>
matrix3<T> transposed(const matrix3<T>& x) {
  matrix3<T> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i][k] = x[k][i];
  }
  return result;
}
template <class T>
triple<T> product(const matrix3<T>& x, const triple<T>& v) {
  triple<T> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = x[i][0] * v[0] + x[i][1] * v[1] + x[i][2] * v[2];
  return result;
}

/// In the principal axes.
triple<rational> momentum_of(const scene& what) {
  const scene_body& of = what.body;
  triple<rational> momentum;
  for (std::size_t i = 0; i < 3; ++i) {
    const rational& square = of.axes[i].square;
    momentum[i] = (*what.state->momentum)[i] /
                  rational(integer(sqrt(numerator(square))), integer(sqrt(denominator(square))));
  }
  return momentum;
}

initial_state state_of(const scene& what) {
  return initial_state::from_momentum(*what.body.moments, momentum_of(what));
}

/// The attitude at time 0: from the given frame to space.
matrix3<ball> attitude_at_0(const scene& what, initial_state any, precision p) {
  const scene_state& state = *what.state;
  if (state.quaternion) any.set_quaternion(*state.quaternion);
  if (state.matrix) any.set_matrix(*state.matrix);
  if (state.euler) any.set_euler_angles(*state.euler, state.euler_unit);
  return any.attitude(p);
}

/// A time as the rotor has it, in moment/momentum: an exact number, and how far from it the true time may be, which has pi in it where
/// angles are in degrees.
struct rotor_time {
  rational t;
  magnitude off = magnitude::from_integer_up(0);
};

class motion {
 public:
  motion(const scene& what, precision p)
      : unit_(what.time_unit.size * what.state->momentum_size / what.body.size),
        p_(p),
        state_(state_of(what)) {
    // |omega| <= |J|/I_z, so that |dJ/dt| = |J x omega| <= |J| |omega|, and an entry of dR/dt = R [omega]x is at most |omega|.
    const ball size = sqrt(ball(state_.squared_momentum(), 64));
    const ball fastest = size / (*what.body.moments)[2];
    momentum_speed_ = (size * fastest).magnitude_upper();
    attitude_speed_ = fastest.magnitude_upper();
  }

  [[nodiscard]] const initial_state& state() const { return state_; }
  [[nodiscard]] const pi_scale& unit() const { return unit_; }
  /// A bound of |omega|, in the rotor's units.
  [[nodiscard]] const magnitude& attitude_speed() const { return attitude_speed_; }
  [[nodiscard]] rotor_time at(const rational& t) const {
    rotor_time result;
    if (unit_.power == 0) {
      result.t = t * unit_.factor;
    } else if (t != 0) {
      // The angle turned through, at most |t| |omega|, is to be known to 2^-p_.
      const magnitude angle = multiply_up(attitude_speed_, (t * unit_.at(64)).magnitude_upper());
      const auto whole = std::max<std::int64_t>(angle.log2_floor() + 1, 0);
      const ball product = t * unit_.at(p_ + 64 + static_cast<precision>(whole));
      const ball middle = product.middle();
      result.t = lower_rational(middle);
      result.off = product.radius();
    }
    return result;
  }
  [[nodiscard]] ball momentum(const ball& x, const rotor_time& at) const {
    return x.enlarged(multiply_up(momentum_speed_, at.off));
  }
  [[nodiscard]] ball attitude(const ball& x, const rotor_time& at) const {
    return x.enlarged(multiply_up(attitude_speed_, at.off));
  }
  static double momentum(double x, const rotor_time&) { return x; }
  static double attitude(double x, const rotor_time&) { return x; }

 private:
  pi_scale unit_;
  precision p_;
  initial_state state_;
  magnitude momentum_speed_;
  magnitude attitude_speed_;
};

std::vector<rational> times_of(const scene_time& time) {
  if (time.samples == 1) return {time.from};
  std::vector<rational> result;
  result.reserve(static_cast<std::size_t>(time.samples));
  for (long k = 0; k < time.samples; ++k)
    result.emplace_back(time.from + (time.to - time.from) * k / (time.samples - 1));
  return result;
}

ball in_ball(const ball& x) { return x; }
ball in_ball(double x) { return ball::exactly(x); }

/// A row for each time, in parallel: `row` may be called by many threads.
template <class Row>
effect_table table_of(const effect_context& x, std::vector<std::string> columns,
                      std::vector<std::string> units, const Row& row) {
  effect_table table;
  table.columns = std::move(columns);
  table.units = std::move(units);
  table.digits = x.digits();
  table.certified = !x.what.in_double;
  table.first = times_of(*x.what.time);
  table.rows.resize(table.first.size());
  tbb::parallel_for(std::size_t{0}, table.rows.size(),
                    [&](std::size_t i) { table.rows[i] = row(table.first[i]); });
  return table;
}

/// q and -q are one attitude: each row's quaternion gets the sign that is nearer to the row before. Where two attitudes are
/// half a turn apart, so that neither is, it stays.
void continue_signs(effect_table& table) {
  constexpr std::size_t parts = 4;
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    const std::vector<ball>& before = table.rows[i - 1];
    std::vector<ball>& here = table.rows[i];
    ball product = before[0] * here[0];
    for (std::size_t k = 1; k < parts; ++k) product += before[k] * here[k];
    if (!certainly_less(product, ball(0, 64))) continue;
    for (std::size_t k = 0; k < parts; ++k) here[k] = -here[k];
  }
}

/// sqrt(q) of q >= 0 where it is rational.
std::optional<rational> rational_root(const rational& q) {
  const rational root(integer(sqrt(numerator(q))), integer(sqrt(denominator(q))));
  if (root * root != q) return std::nullopt;
  return root;
}

/// Whether the rotation is steady: omega = I^-1 J is parallel to J, exactly, so that J x omega = 0.
bool is_steady(const triple<rational>& momentum, const triple<rational>& omega) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    if (momentum[i] * omega[k] != momentum[k] * omega[i]) return false;
  }
  return true;
}

/// The columns of momentum_table at time 0, and at all times where the motion is steady: from the rational momentum at the
/// start, so that integers and dyadic numbers among them are exact.
class momentum_at_0 {
 public:
  momentum_at_0(const scene& what, const motion& path, precision p) {
    const matrix3<rational> frame = frame_of(what.body);
    const triple<rational> momentum = momentum_of(what);
    triple<rational> omega;
    for (std::size_t i = 0; i < 3; ++i) omega[i] = momentum[i] / (*what.body.moments)[i];
    steady_ = is_steady(momentum, omega);
    const rational square = path.state().squared_momentum();
    const auto size = rational_root(square);
    const auto add_rational = [&](const rational& one) {
      row_.emplace_back(one, p);
      exact_.emplace_back(one);
    };
    const auto add_ball = [&](const ball& one) {
      row_.push_back(one);
      exact_.emplace_back();
    };
    for (const rational& one : product(frame, momentum)) {
      if (size || one == 0) {
        add_rational(size ? rational(one / *size) : one);
      } else {
        add_ball(ball(one, p) / sqrt(ball(square, p)));
      }
    }
    const pi_scale& unit = path.unit();
    for (const rational& one : product(frame, omega)) {
      if (unit.power == 0 || one == 0) {
        add_rational(one * unit.factor);
      } else {
        add_ball(unit.at(p) * one);
      }
    }
  }
  [[nodiscard]] bool holds_at(const rational& t) const { return steady_ || t == 0; }
  [[nodiscard]] const std::vector<ball>& row() const { return row_; }
  /// Notes the cells of the rows where it holds that are rational.
  void note_exact(effect_table& table) const {
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      if (!holds_at(table.first[i])) continue;
      for (std::size_t k = 0; k < exact_.size(); ++k) {
        if (exact_[k]) table.exact[{i, k}] = *exact_[k];
      }
    }
  }

 private:
  bool steady_ = false;
  std::vector<ball> row_;
  std::vector<std::optional<rational>> exact_;  // those of them that are rational
};

/// J/|J| and omega in the given frame, omega in rad per unit of the scene's time.
template <class T>
effect_table momentum_table(const effect_context& x, precision p, work_count& work) {
  const motion path(x.what, p);
  const rotor<T> turning(path.state(), p);
  work += turning.work();
  const auto frame = numbers_of<T>(frame_of(x.what.body), p);
  const T unit = number_of<T>(path.unit().at(p), p);
  const T size = number_of<T>(sqrt(ball(path.state().squared_momentum(), p)), p);
  triple<T> inverse;
  for (std::size_t i = 0; i < 3; ++i)
    inverse[i] = number_of<T>(rational(1 / (*x.what.body.moments)[i]), p);
  const momentum_at_0 known(x.what, path, p);
  const std::string& time = x.what.time_unit.name;
  const std::string rate = x.what.time_kind == scene::time_scale::natural ? "J/I_y" : "rad/" + time;
  effect_table table = table_of(x, {"t", "j_1", "j_2", "j_3", "omega_1", "omega_2", "omega_3"},
                                {time, "", "", "", rate, rate, rate}, [&](const rational& t) {
                                  if (std::same_as<T, ball> && known.holds_at(t))
                                    return known.row();
                                  const rotor_time at = path.at(t);
                                  const rotor_sample<T> sample = turning.sample(at.t);
                                  triple<T> j;
                                  triple<T> omega;
                                  for (std::size_t i = 0; i < 3; ++i) {
                                    const T here = path.momentum(sample.momentum[i], at);
                                    j[i] = here / size;
                                    omega[i] = here * inverse[i] * unit;
                                  }
                                  const triple<T> j_given = product(frame, j);
                                  const triple<T> omega_given = product(frame, omega);
                                  std::vector<ball> row;
                                  row.reserve(6);
                                  for (const T& one : j_given) row.push_back(in_ball(one));
                                  for (const T& one : omega_given) row.push_back(in_ball(one));
                                  return row;
                                });
  if (table.certified) known.note_exact(table);
  return table;
}

/// A quaternion's components w, x, y, z, those that are known to be rational; of both signs of the whole, any.
using exact_quaternion = std::array<std::optional<rational>, 4>;

/// Of a rotation with rational entries: 4 q_i^2 and 4 q_i q_k are sums of these. Where the greatest component is rational, all
/// are; where it is not, a component is 0 or not rational.
exact_quaternion quaternion_of(const matrix3<rational>& m) {
  const std::array<rational, 4> squares{
      1 + m[0][0] + m[1][1] + m[2][2], 1 + m[0][0] - m[1][1] - m[2][2],
      1 - m[0][0] + m[1][1] - m[2][2], 1 - m[0][0] - m[1][1] + m[2][2]};
  const auto g =
      static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const std::array<rational, 3> with_w{m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]};
  matrix3<rational> others;  // 4 q_i q_k of x, y, z
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) others[i][k] = m[i][k] + m[k][i];
  }
  const auto greatest = rational_root(squares[g] / 4);
  exact_quaternion result;
  for (std::size_t k = 0; k < 4; ++k) {
    if (k == g) {
      result[k] = greatest;
      continue;
    }
    const rational product =
        g == 0 ? with_w[k - 1] : (k == 0 ? with_w[g - 1] : others[g - 1][k - 1]);
    if (product == 0) {
      result[k] = rational(0);
    } else if (greatest) {
      result[k] = product / (4 * *greatest);
    }
  }
  return result;
}

matrix3<rational> rotation_of(const std::array<rational, 4>& wxyz) {
  const auto& [w, x, y, z] = wxyz;
  const rational square(w * w + x * x + y * y + z * z);
  const std::array<std::array<rational, 3>, 3> twice{
      {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
       {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
       {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
  matrix3<rational> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i][k] = twice[i][k] / square;
  }
  return result;
}

/// The cosine of an angle where it is known to be rational: at multiples of 60 and 90 degrees, and at 0 radians.
std::optional<rational> rational_cosine(rational angle, angle_unit unit) {
  if (angle < 0) angle = -angle;
  if (angle == 0) return rational(1);
  if (unit != angle_unit::degrees) return std::nullopt;
  angle -= 360 * rational(integer(numerator(angle) / (360 * denominator(angle))));
  if (angle > 180) angle = 360 - angle;
  for (const auto& [at, value] :
       {std::pair(rational(0), rational(1)), std::pair(rational(60), rational(1, 2)),
        std::pair(rational(90), rational(0)), std::pair(rational(120), rational(-1, 2)),
        std::pair(rational(180), rational(-1))}) {
    if (angle == at) return value;
  }
  return std::nullopt;
}

/// Of R_z(phi) R_x(theta) R_z(psi): cos(theta/2) and sin(theta/2) times cosines and sines of (phi + psi)/2 and (phi - psi)/2.
exact_quaternion quaternion_of(const rational_vector& phi_theta_psi, angle_unit unit) {
  const auto& [phi, theta, psi] = phi_theta_psi;
  const bool has_degrees = unit == angle_unit::degrees;
  const auto cosine = [&](const rational& angle) { return rational_cosine(angle, unit); };
  const auto sine = [&](const rational& angle) -> std::optional<rational> {
    if (angle == 0) return rational(0);
    return has_degrees ? cosine(angle - 90) : std::nullopt;
  };
  const auto product = [](const std::optional<rational>& x,
                          const std::optional<rational>& y) -> std::optional<rational> {
    if ((x && *x == 0) || (y && *y == 0)) return rational(0);
    return x && y ? std::optional(rational(*x * *y)) : std::nullopt;
  };
  const rational half = theta / 2;
  const rational sum = (phi + psi) / 2;
  const rational difference = (phi - psi) / 2;
  exact_quaternion result{product(cosine(half), cosine(sum)),
                          product(sine(half), cosine(difference)),
                          product(sine(half), sine(difference)), product(cosine(half), sine(sum))};
  if (!has_degrees) return result;
  // 2 cos x cos y = cos(x + y) + cos(x - y), where these are rational and the factors are not.
  const auto of_sum = [&](std::optional<rational>& to, const rational& x, const rational& y) {
    const auto one = cosine(x + y);
    const auto other = cosine(x - y);
    if (!to && one && other) to = (*one + *other) / 2;
  };
  of_sum(result[0], half, sum);
  of_sum(result[1], half - 90, difference);
  of_sum(result[2], half - 90, difference - 90);
  of_sum(result[3], half, sum - 90);
  return result;
}

exact_quaternion quaternion_at_0(const scene_state& state) {
  if (state.euler) return quaternion_of(*state.euler, state.euler_unit);
  if (state.matrix) return quaternion_of(*state.matrix);
  if (state.quaternion) return quaternion_of(rotation_of(*state.quaternion));
  return {rational(1), rational(0), rational(0), rational(0)};
}

/// Notes the rational components of the quaternion in row i, of the sign that the row has. Throws std::logic_error where they are
/// not in their enclosures.
void note_exact(effect_table& table, std::size_t i, exact_quaternion known) {
  std::vector<ball>& row = table.rows[i];
  int sign = 0;  // of the row's quaternion beside the known one
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (!known[k] || *known[k] == 0 || contains_zero(row[k])) continue;
    sign = certainly_positive(row[k]) == (*known[k] > 0) ? 1 : -1;
  }
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (!known[k] || (*known[k] != 0 && sign == 0)) continue;
    const rational one(*known[k] * (sign == 0 ? 1 : sign));
    if (!contains(row[k], one)) {
      throw std::logic_error(
          "scene: internal error: an attitude at time 0 is not in its enclosure");
    }
    row[k] = ball(one, row[k].precision());
    table.exact[{i, k}] = one;
  }
}

/// The quaternion that takes the given frame to space, and the unwrapped angle phi about J.
template <class T>
effect_table attitude_table(const effect_context& x, precision p, work_count& work) {
  const motion path(x.what, p);
  const rotor<T> turning(path.state(), p);
  work += turning.work();
  const auto frame = numbers_of<T>(frame_of(x.what.body), p);
  const auto start = numbers_of<T>(attitude_at_0(x.what, path.state(), p), p);
  // The rotor begins with the principal axes along those of space: R(t) = R_0 P R_rotor(t) P^T in the given frame.
  const matrix3<T> before = product(start, frame);
  const matrix3<T> after = transposed(frame);
  effect_table table =
      table_of(x, {"t", "q_w", "q_x", "q_y", "q_z", "phi"},
               {x.what.time_unit.name, "", "", "", "", "rad"}, [&](const rational& t) {
                 const rotor_time at = path.at(t);
                 rotor_attitude<T> attitude = turning.attitude(at.t);
                 const T phi = path.attitude(attitude.angles().phi, at);
                 for (auto& row : attitude.matrix) {
                   for (T& entry : row) entry = path.attitude(entry, at);
                 }
                 attitude.matrix = product(product(before, attitude.matrix), after);
                 std::vector<ball> row;
                 row.reserve(5);
                 const bool is_start = std::same_as<T, ball> && t == 0;
                 for (const T& one : attitude.quaternion()) row.push_back(in_ball(one));
                 row.push_back(is_start ? ball(0, p) : in_ball(phi));
                 return row;
               });
  continue_signs(table);
  if (!table.certified) return table;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (table.first[i] != 0) continue;
    note_exact(table, i, quaternion_at_0(*x.what.state));
    table.exact[{i, 4}] = 0;  // phi
  }
  return table;
}

constexpr const char* by_double = "in double, as the scene asks: some 15 digits, not certified";

precision bits_of(const effect_context& x) { return bits_for_digits(x.working_digits()) + 16; }

}  // namespace

void check_rows(effect_result& result, const scene_time& time,
                const std::vector<magnitude>& scales) {
  const effect_table& table = *result.table;
  const bool is_whole = table.first == times_of(time) && table.rows.size() == table.first.size() &&
                        std::all_of(table.rows.begin(), table.rows.end(),
                                    [&](const auto& row) { return row.size() == scales.size(); });
  if (!is_whole) {
    throw std::logic_error("scene: internal error: a series has not one row for each time");
  }
  if (!table.certified) return;
  const magnitude tolerance =
      magnitude::power_of_two(1 - static_cast<std::int64_t>(bits_for_digits(table.digits)));
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    for (std::size_t k = 0; k < scales.size(); ++k) {
      const ball& x = table.rows[i][k];
      if (x.is_bounded() &&
          x.radius() <= multiply_up(tolerance, std::max(scales[k], x.magnitude_upper()))) {
        continue;
      }
      return not_certified(result, table.columns[k + 1] + " at sample " + std::to_string(i + 1) +
                                       " has fewer digits than asked for");
    }
  }
}

rational_vector direction_squares(const scene& what) {
  rational_vector squares;
  rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const rational& one = (*what.state->momentum)[i];
    squares[i] = one * one / what.body.axes[i].square;
    sum += squares[i];
  }
  for (rational& one : squares) one /= sum;
  return squares;
}

std::array<int, 3> momentum_senses(const scene& what) {
  std::array<int, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = (*what.state->momentum)[i].sign();
  return result;
}

effect_result momentum(const effect_context& x) {
  effect_result result;
  result.table = x.what.in_double ? momentum_table<double>(x, 53, result.work)
                                  : momentum_table<ball>(x, bits_of(x), result.work);
  if (x.what.in_double) not_certified(result, by_double);
  add_exact(result, "samples", rational(x.what.time->samples));
  // |omega| <= |J|/I_z.
  const motion path(x.what, 64);
  const magnitude fastest =
      multiply_up(path.attitude_speed(), path.unit().at(64).magnitude_upper());
  const magnitude one = magnitude::from_integer_up(1);
  check_rows(result, *x.what.time, {one, one, one, fastest, fastest, fastest});
  result.remarks.push_back("j = J/|J| and omega in rad per " + x.what.time_unit.name +
                           ", along the axes in which the body was given");
  return result;
}

effect_result attitude(const effect_context& x) {
  effect_result result;
  result.table = x.what.in_double ? attitude_table<double>(x, 53, result.work)
                                  : attitude_table<ball>(x, bits_of(x), result.work);
  if (x.what.in_double) not_certified(result, by_double);
  add_exact(result, "samples", rational(x.what.time->samples));
  const magnitude one = magnitude::from_integer_up(1);
  check_rows(result, *x.what.time, {one, one, one, one, one});
  result.remarks.emplace_back(
      "q takes the axes in which the body was given to those of space; phi is the angle about J, "
      "unwrapped");
  return result;
}

work_count audit_motion(const effect_context& x, precision p,
                        const std::function<void(const std::string&, const ball&)>& expect_zero) {
  const initial_state start = state_of(x.what);
  const rotor<ball> turning(start, p);
  const rotor_sample<ball> begin = turning.sample(rational(0));
  const triple<ball> in_space = product(turning.attitude(rational(0)).matrix, begin.momentum);
  // The hull of the differences; or the first that does not hold 0, which no hull may hide.
  const auto note = [](std::optional<ball>& all, const ball& difference) {
    if (all && !contains_zero(*all)) return;
    all = all && contains_zero(difference) ? hull(*all, difference) : difference;
  };
  std::optional<ball> energy;
  std::optional<ball> momentum;
  std::optional<ball> direction;
  rational size = 0;  // at least |J|, and at most sqrt(3) times that
  for (const rational& one : momentum_of(x.what)) size += abs(one);
  for (const long time : {1L, 10L, 100L}) {
    const rational t(time * start.moments()[1] / size);
    const rotor_sample<ball> sample = turning.sample(t);
    ball twice_energy(0, p);
    ball square(0, p);
    for (std::size_t i = 0; i < 3; ++i) {
      twice_energy += polhode::square(sample.momentum[i]) / start.moments()[i];
      square += polhode::square(sample.momentum[i]);
    }
    note(energy, twice_energy / start.twice_energy() - 1);
    note(momentum, square / start.squared_momentum() - 1);
    const triple<ball> there = product(turning.attitude(t).matrix, sample.momentum);
    for (std::size_t i = 0; i < 3; ++i)
      note(direction, (there[i] - in_space[i]) / turning.momentum_size());
  }
  expect_zero("energy", *energy);
  expect_zero("squared_momentum", *momentum);
  expect_zero("momentum_in_space", *direction);
  return turning.work();
}

}  // namespace polhode::detail
