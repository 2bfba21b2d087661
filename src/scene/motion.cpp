// The series in time: momentum and attitude.

#include "scene/motion.hpp"

#include <algorithm>
#include <stdexcept>

#include <tbb/parallel_for.h>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/rotor.hpp"
#include "scene/exact_quaternion.hpp"
#include "scene/scene_motion.hpp"

namespace polhode::detail {
namespace {

template <class T>
T number_of(const ball& x) {
  if constexpr (std::same_as<T, ball>) {
    return x;
  } else {
    return midpoint(x).convert_to<T>();
  }
}
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

/// q and -q are one attitude: each row's quaternion gets the sign that is nearer to the row before.
/// Where two attitudes are half a turn apart, so that neither is, it stays.
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

/// The columns of momentum_table at time 0, and at all times where the motion is steady: from the
/// momentum at the start, where it is rational, so that integers and dyadic numbers among them are
/// exact.
class momentum_at_0 {
 public:
  momentum_at_0(const scene& what, const scene_motion& path, precision p) {
    steady_ = is_equilibrium(path.state().regime());
    const exact_real& square = path.state().squared_momentum();
    const auto size = square.is_rational() ? exact_root(square.exact(), 2) : std::nullopt;
    const auto add_rational = [&](const rational& one) {
      row_.emplace_back(ball(one, p));
      exact_.emplace_back(one);
    };
    const auto add_ball = [&](const ball& one) {
      row_.emplace_back(one);
      exact_.emplace_back();
    };
    const auto add_unknown = [&] {
      row_.emplace_back();
      exact_.emplace_back();
    };
    for (const exact_real& component : *what.state->momentum) {
      if (!component.is_rational()) {
        add_unknown();
        continue;
      }
      const rational& one = component.exact();
      if (size || one == 0) {
        add_rational(size ? rational(one / *size) : one);
      } else {
        add_ball(ball(one, p) / sqrt(square.at(p)));
      }
    }
    const pi_scale& unit = path.unit();
    for (const exact_real& component : *what.state->omega) {
      if (!component.is_rational()) {
        add_unknown();
        continue;
      }
      const rational& one = component.exact();
      if (unit.power == 0 || one == 0) {
        add_rational(one * unit.factor);
      } else {
        add_ball(unit.at(p) * one);
      }
    }
  }
  [[nodiscard]] bool holds_at(const rational& t) const { return steady_ || t == 0; }
  /// Puts what is known into a row of a time at which it holds.
  void put_into(std::vector<ball>& row) const {
    for (std::size_t k = 0; k < row_.size(); ++k) {
      if (row_[k]) row[k] = *row_[k];
    }
  }
  [[nodiscard]] bool is_whole() const {
    return std::all_of(row_.begin(), row_.end(), [](const auto& one) { return one.has_value(); });
  }
  [[nodiscard]] std::vector<ball> row() const {
    std::vector<ball> result(row_.size());
    put_into(result);
    return result;
  }
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
  std::vector<std::optional<ball>> row_;        // none where the momentum is irrational
  std::vector<std::optional<rational>> exact_;  // those of them that are rational
};

/// J/|J| and omega in the given frame, omega in rad per unit of the scene's time.
template <class T>
effect_table momentum_table(const effect_context& x, precision p, work_count& work) {
  const scene_motion path(x.what, p);
  const rotor<T> turning(path.state(), p);
  work += turning.work();
  const T unit = number_of<T>(path.unit().at(p));
  const T size = number_of<T>(sqrt(path.state().squared_momentum().at(p)));
  const momentum_at_0 known(x.what, path, p);
  const std::string& time = x.what.time_unit.name;
  const std::string rate = x.what.time_kind == scene::time_scale::natural ? "J/I_y" : "rad/" + time;
  effect_table table = table_of(x, {"t", "j_1", "j_2", "j_3", "omega_1", "omega_2", "omega_3"},
                                {time, "", "", "", rate, rate, rate}, [&](const rational& t) {
                                  const bool is_known = std::same_as<T, ball> && known.holds_at(t);
                                  if (is_known && known.is_whole()) return known.row();
                                  const rotor_time at = path.at(t);
                                  const rotor_sample<T> sample = turning.sample(at.t);
                                  std::vector<ball> row;
                                  row.reserve(6);
                                  for (const T& one : sample.momentum)
                                    row.push_back(in_ball(T(path.momentum(one, at) / size)));
                                  for (const T& one : sample.angular_velocity)
                                    row.push_back(in_ball(T(path.velocity(one, at) * unit)));
                                  if (is_known) known.put_into(row);
                                  return row;
                                });
  if (table.certified) known.note_exact(table);
  return table;
}

/// Notes the rational components of the quaternion in row i, of the sign that the row has. Throws
/// std::logic_error where they are not in their enclosures.
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
  const scene_motion path(x.what, p);
  const rotor<T> turning(path.state(), p);
  work += turning.work();
  effect_table table =
      table_of(x, {"t", "q_w", "q_x", "q_y", "q_z", "phi"},
               {x.what.time_unit.name, "", "", "", "", "rad"}, [&](const rational& t) {
                 const rotor_time at = path.at(t);
                 rotor_attitude<T> attitude = turning.attitude(at.t);
                 const T phi = path.attitude(attitude.angles().phi, at);
                 for (auto& row : attitude.matrix) {
                   for (T& entry : row) entry = path.attitude(entry, at);
                 }
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

effect_result momentum(const effect_context& x) {
  effect_result result;
  result.table = x.what.in_double ? momentum_table<double>(x, 53, result.work)
                                  : momentum_table<ball>(x, bits_of(x), result.work);
  if (x.what.in_double) not_certified(result, by_double);
  add_exact(result, "samples", rational(x.what.time->samples));
  // |omega| <= |J|/I_z.
  const scene_motion path(x.what, 64);
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

}  // namespace polhode::detail
