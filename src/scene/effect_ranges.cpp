// Of a body whose moments have uncertainties: what holds for all bodies within them, and the ranges
// of numbers. A number falls or grows with a, b and c (body_box.hpp), of which a and b have I_y in
// common, and c, where the state is given by omega or J, all three moments: the ranges of the
// moments are divided into cells, and the cells' ranges joined.

#include <algorithm>
#include <functional>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/body_box.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "scene/effect_context.hpp"

namespace polhode::detail {
namespace {

using moment_ranges = std::array<rational_range, 3>;

/// How many parts each uncertain moment's range is divided into, where 0, 1, 2 or 3 are uncertain.
using fineness = std::array<long, 4>;
constexpr fineness fine{1, 64, 30, 10};
constexpr fineness coarse{1, 30, 12, 6};  // for numbers that take milliseconds each

rational_range part_of(const rational_range& whole, long k, long parts) {
  const rational width = (whole.high - whole.low) / parts;
  return {whole.low + width * k,
          k + 1 == parts ? whole.high : rational(whole.low + width * (k + 1))};
}

/// Cells that cover the ranges; divided along these axes.
std::vector<moment_ranges> cells_of(const moment_ranges& whole, const std::array<bool, 3>& divided,
                                    const fineness& how) {
  std::size_t uncertain = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (divided[i] && whole[i].low != whole[i].high) ++uncertain;
  }
  const long parts = how[uncertain];
  std::vector<moment_ranges> cells{whole};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!divided[i] || whole[i].low == whole[i].high) continue;
    std::vector<moment_ranges> finer;
    finer.reserve(cells.size() * static_cast<std::size_t>(parts));
    for (const moment_ranges& cell : cells) {
      for (long k = 0; k < parts; ++k) {
        finer.push_back(cell);
        finer.back()[i] = part_of(whole[i], k, parts);
      }
    }
    cells = std::move(finer);
  }
  return cells;
}

/// c = 2 I_y H/J^2 - 1 of all motions of a cell that have this J: I_y (sum of J_i^2/I_i)/J^2 - 1
/// grows with I_y, of which J_y^2/J^2 is the part without it, and falls as I_x and I_z grow.
rational_range c_by_momentum(const moment_ranges& cell, const std::array<rational, 3>& squares) {
  const auto at = [&](const rational& x, const rational& y, const rational& z) {
    const rational size = squares[0] + squares[1] + squares[2];
    return rational((squares[0] * (y / x - 1) + squares[2] * (y / z - 1)) / size);
  };
  const auto& [x, y, z] = cell;
  return {at(x.high, y.low, z.high), at(x.low, y.high, z.low)};
}

rational_range product(const rational_range& x, const rational_range& y) {
  const auto [least, greatest] = std::minmax({rational(x.low * y.low), rational(x.low * y.high),
                                              rational(x.high * y.low), rational(x.high * y.high)});
  return {least, greatest};
}

/// The same of those with this omega, whose components have these squares w_i: c + 1 is I_y S/Q
/// with S = sum of w_i I_i, Q = sum of w_i I_i^2, and its derivative with respect to I_i is
/// I_y w_i (Q - 2 I_i S)/Q^2, for I_y + S/Q more. Along an axis on which that has one sign c is
/// greatest at an end; else it is at most its greatest size times half the width from the value in
/// the middle (mean value theorem).
rational_range c_by_velocity(const moment_ranges& cell, const std::array<rational, 3>& squares) {
  const auto sums = [&](const std::array<rational, 3>& at) {
    std::array<rational, 2> result;  // S, Q
    for (std::size_t i = 0; i < 3; ++i) {
      result[0] += squares[i] * at[i];
      result[1] += squares[i] * at[i] * at[i];
    }
    return result;
  };
  const auto [s_low, q_low] = sums({cell[0].low, cell[1].low, cell[2].low});
  const auto [s_high, q_high] = sums({cell[0].high, cell[1].high, cell[2].high});
  std::array<rational, 3> least;
  std::array<rational, 3> greatest;
  rational margin = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const rational_range difference{q_low - 2 * cell[i].high * s_high,
                                    q_high - 2 * cell[i].low * s_low};
    rational_range slope = product(
        {cell[1].low * squares[i] / (q_high * q_high), cell[1].high * squares[i] / (q_low * q_low)},
        difference);
    if (i == 1) {
      slope.low += s_low / q_high;
      slope.high += s_high / q_low;
    }
    if (slope.low >= 0 || slope.high <= 0) {
      least[i] = slope.low >= 0 ? cell[i].low : cell[i].high;
      greatest[i] = slope.low >= 0 ? cell[i].high : cell[i].low;
    } else {
      least[i] = greatest[i] = (cell[i].low + cell[i].high) / 2;
      margin += std::max(slope.high, rational(-slope.low)) * (cell[i].high - cell[i].low) / 2;
    }
  }
  const auto value = [&](const std::array<rational, 3>& at) {
    const auto [sum, square] = sums(at);
    return rational(at[1] * sum / square - 1);
  };
  return {value(least) - margin, value(greatest) + margin};
}

/// The squares of the components along x, y, z of what the state is given by, J or omega.
std::array<rational, 3> given_squares(const effect_context& x) {
  const scene_body& of = x.what.body;
  const triple<int> order = of.axes->along_given_axes()->order;
  const scene_state& state = *x.what.state;
  const triple<exact_real>& given = state.by_omega ? *state.omega : *state.momentum;
  std::array<rational, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const rational& one = given[static_cast<std::size_t>(order[i])].exact();
    result[i] = one * one;
  }
  return result;
}

rational_range c_of(const effect_context& x, const moment_ranges& cell) {
  if (!x.what.state->momentum) return {x.c().exact(), x.c().exact()};
  return x.what.state->by_omega ? c_by_velocity(cell, given_squares(x))
                                : c_by_momentum(cell, given_squares(x));
}

ball in_range(const rational_range& range, precision p) {
  return hull(ball(range.low, p), ball(range.high, p));
}

/// Of positive numbers.
rational_range ratio(const rational_range& x, const rational_range& y) {
  return {x.low / y.high, x.high / y.low};
}

/// I_y/|J| in the scene's unit of time.
ball unit_of_time(const effect_context& x, const moment_ranges& cell, precision p) {
  if (x.what.time_kind == scene::time_scale::natural) return ball(1, p);
  const std::array<rational, 3> squares = given_squares(x);
  rational_range square{0, 0};  // (J/I_y)^2
  const rational_range& y = cell[1];
  for (std::size_t i = 0; i < 3; ++i) {
    rational_range part{1 / y.high, 1 / y.low};
    if (x.what.state->by_omega) part = i == 1 ? rational_range{1, 1} : ratio(cell[i], y);
    square.low += squares[i] * part.low * part.low;
    square.high += squares[i] * part.high * part.high;
  }
  const pi_scale unit = x.what.body.size / x.what.state->momentum_size / x.what.time_unit.size;
  return unit.at(p) / sqrt(in_range(square, p));
}

// ---------------------------------------------------------------------------------------------

class ranges_of_effect {
 public:
  ranges_of_effect(const effect_context& x, effect_result& to)
      : x_(x), to_(to), whole_(*x.what.body.ranges->ordered()) {}

  void full_turn() {
    decide("exists", has_full_turn(least_j()), has_full_turn(greatest_j()));
    if (has_full_turn(greatest_j())) {
      add("c", of_bodies([&](const body_box& box) { return box.full_turn(x_.digits()); }));
    }
  }

  void signature() {
    decide_physical("physical");
    decide_physical("phase_of_oscillations_above_2_pi");
    decide_physical("epsilon_injective");
    decide("perfect_twist", has_perfect_twist(least_j()), has_perfect_twist(greatest_j()));
    decide("full_turn", has_full_turn(least_j()), has_full_turn(greatest_j()));
    count("intersections", intersection_count);
    // It says what follows for the middle.
    if (x_.what.body.ranges->kind() == body_kind::undecided) to_.remarks.clear();
  }

  void intersections() {
    count("count", intersection_count);
    count("crossings", crossing_count);
  }

  void tennis_racket() {
    decide_physical("injective");
    decide("perfect_twist", has_perfect_twist(least_j()), has_perfect_twist(greatest_j()));
    add("epsilon0",
        of_bodies([&](const body_box& box) { return box.separatrix_defect(x_.digits()); }), "rad");
    if (has_perfect_twist(greatest_j())) {
      add("c0", of_bodies([&](const body_box& box) { return box.perfect_twist(x_.digits()); }));
    }
    if (!has_motions()) return;
    const ball epsilon =
        of_motions(coarse, [&](const motions& m) { return m.box.twist(m.c, x_.digits()); });
    if (epsilon.is_bounded()) {
      add("epsilon", epsilon, "rad");
    } else {
      to_.remarks.emplace_back(
          "the range of epsilon is not enclosed: it is where all motions rotate, or oscillate with "
          "a phase above 4 pi");
    }
  }

  void regime() {
    if (!has_motions() || !x_.what.state->momentum) return;
    const ball all = of_motions(fine, [&](const motions& m) { return in_range(m.c, bits()); });
    add("c", all);
    if (!certainly_positive(all) && !certainly_negative(all)) {
      set_word("regime", "undecided");
      not_certified(to_, "undecided: the separatrix may lie within the uncertainties");
    }
  }

  void period() {
    if (!has_motions() || is_given_separatrix()) return;
    if (x_.what.time_kind != scene::time_scale::natural)
      add_of_motions("period", x_.what.time_unit.name, [](const motions& m) { return m.time(); });
    add_of_motions("natural_period", "I_y/J", [](const motions& m) { return m.period(); });
  }

  void montgomery_phase() {
    if (!has_motions() || is_given_separatrix()) return;
    add_of_motions("phase", "rad", [](const motions& m) { return m.phase(); });
  }

  /// The axis that J goes around where the motion oscillates, and the two others where it rotates,
  /// turn once more a period than the body (effect_phase.cpp).
  void mean_precession() {
    if (!has_motions() || is_given_separatrix()) return;
    const bool oscillates = x_.regime() == polhode::regime::oscillating;
    const ball body_rate = of_motions(fine, [](const motions& m) { return m.mean_rate(); });
    const ball turn = 2 * pi(bits());
    const ball more =
        of_motions(fine, [&](const motions& m) { return m.mean_rate() + turn / m.time(); });
    const ball& wobble = oscillates ? more : body_rate;
    const std::string& unit = x_.what.time_unit.name;
    const std::string per_time =
        x_.what.time_kind == scene::time_scale::natural ? "J/I_y" : "rad per " + unit;
    add("wobble", wobble, per_time);
    add("wobble_period", turn / wobble, unit);
    add("greatest_axis", more, per_time);
    add("middle_axis", oscillates ? body_rate : more, per_time);
    add("least_axis", body_rate, per_time);
  }

  /// Flips are half a period apart: in a time D there are floor(D/spacing) or one more.
  void flips() {
    if (!has_motions()) return;
    const ball spacing = of_motions(fine, [](const motions& m) { return scale(m.time(), -1); });
    if (!spacing.is_bounded()) {
      return not_certified(to_,
                           "the range of spacing was not enclosed: the separatrix may lie "
                           "within the uncertainties");
    }
    add("spacing", spacing, x_.what.time_unit.name);
    if (!x_.what.time) return;
    const ball times = ball(rational(x_.what.time->to - x_.what.time->from), bits()) / spacing;
    if (!times.is_bounded()) return;
    const rational least(floor_of(lower_rational(times)));
    const rational most(floor_of(upper_rational(times)) + 1);
    add("count", in_range({std::max(least, rational(0)), most}, bits()));
  }

  /// I_y/(|J| sqrt(a b)) of every body. The derivatives have no range.
  void sensitivity() {
    const ball time = of_motions(fine, [&](const motions& m) {
      const ball growth2 = in_range(m.box.a(), bits()) * in_range(m.box.b(), bits());
      return unit_of_time(x_, m.cell, bits()) / sqrt(growth2);
    });
    add("e_folding_time_at_middle_axis", time, x_.what.time_unit.name);
  }

 private:
  [[nodiscard]] precision bits() const { return bits_for_digits(x_.digits()) + 64; }

  /// The body at a corner.
  [[nodiscard]] body at(bool x_up, bool y_up, bool z_up) const {
    const auto& [x, y, z] = whole_;
    return body::from_moments(
        {x_up ? x.high : x.low, y_up ? y.high : y.low, z_up ? z.high : z.low});
  }
  /// J falls as I_x and I_y grow, and grows with I_z (uncertain_body).
  [[nodiscard]] body least_j() const { return at(true, true, false); }
  [[nodiscard]] body greatest_j() const { return at(false, false, true); }

  /// A count that grows as I falls. I grows with I_y and I_z and falls as I_x grows.
  void count(const std::string& name, integer (*of)(const body&)) {
    const integer least = of(at(false, true, true));
    const integer most = of(at(true, false, false));
    if (least == most) return;  // all have the middle's
    add(name, hull(ball(rational(least), bits()), ball(rational(most), bits())));
  }

  void set_word(const std::string& key, const std::string& word) {
    for (auto& [name, value] : to_.words) {
      if (name == key) value = word;
    }
  }
  /// Whether all have it, where those of one corner have it if any, and those of another if all.
  void decide(const std::string& key, bool any, bool all) {
    set_word(key, all ? "yes" : any ? "undecided" : "no");
    if (any && !all) undecided(key);
  }
  void decide_physical(const std::string& key) {
    const body_kind kind = x_.what.body.ranges->kind();
    set_word(key, kind == body_kind::undecided      ? "undecided"
                  : kind == body_kind::non_physical ? "no"
                                                    : "yes");
    if (kind == body_kind::undecided) undecided(key);
  }
  void undecided(const std::string& key) {
    not_certified(to_,
                  key + " is undecided: within the uncertainties there are bodies of both kinds");
  }

  void add(const std::string& name, const ball& range, const std::string& unit = "") {
    if (range.is_bounded()) {
      to_.numbers.push_back({name + "_range", range, {}, unit, true});
    } else {
      not_certified(to_, name + "_range was not enclosed");
    }
  }

  [[nodiscard]] ball of_bodies(const std::function<ball(const body_box&)>& range) const {
    ball result;
    bool first = true;
    for (const moment_ranges& cell : cells_of(whole_, {false, true, false}, fine)) {
      const ball part = range(body_box::of_moments(cell));
      result = first ? part : hull(result, part);
      first = false;
    }
    return result;
  }

  /// Whether this is a motion that is periodic or the separatrix; all members' is then none of the
  /// equilibria either, where J is along an axis. Where c is given it must be a motion of all.
  [[nodiscard]] bool has_motions() {
    if (!x_.has_motion() || is_equilibrium(x_.regime())) return false;
    if (x_.what.state->start && x_.start().regime() == polhode::regime::equilibrium_y) return false;
    if (x_.what.state->momentum) return true;
    const body_box all = body_box::of_moments(whole_);
    const rational& c = x_.c().exact();
    if (c > -all.b().low && c < all.a().low) return true;
    not_certified(to_, "c is no motion of some bodies within the uncertainties");
    return false;
  }

  /// The motions of a cell.
  struct motions {
    const ranges_of_effect& of;
    const moment_ranges& cell;
    body_box box;
    rational_range c;

    [[nodiscard]] ball period() const { return box.period(c, of.bits()); }
    [[nodiscard]] ball time() const { return period() * unit_of_time(of.x_, cell, of.bits()); }
    [[nodiscard]] ball phase() const { return box.montgomery_phase(c, of.bits()); }
    [[nodiscard]] ball mean_rate() const {
      return box.mean_rate(c, of.bits()) / unit_of_time(of.x_, cell, of.bits());
    }
  };

  /// c = 0 was given: nothing is periodic, for any body.
  [[nodiscard]] bool is_given_separatrix() const {
    return !x_.what.state->momentum && x_.regime() == polhode::regime::separatrix;
  }

  template <class Range>
  [[nodiscard]] ball of_motions(const fineness& how, const Range& range) const {
    const bool has_j = x_.what.state->momentum.has_value();
    ball result;
    bool first = true;
    for (const moment_ranges& cell : cells_of(whole_, {has_j, true, has_j}, how)) {
      const body_box box = body_box::of_moments(cell);
      const ball part = range(motions{*this, cell, box, c_of(x_, cell)});
      result = first ? part : hull(result, part);
      first = false;
    }
    return result;
  }

  template <class Number>
  void add_of_motions(const std::string& name, const std::string& unit, const Number& number) {
    const ball range = of_motions(fine, number);
    if (range.is_bounded()) return add(name, range, unit);
    not_certified(to_, "the range of " + name +
                           " was not enclosed: the separatrix may lie within the uncertainties");
  }

  const effect_context& x_;
  effect_result& to_;
  const moment_ranges& whole_;
};

}  // namespace

void add_ranges(effect_result& to, const effect_context& x) {
  if (!x.what.body.ranges || !x.what.body.axes->rigid()) return;
  using range_function = void (ranges_of_effect::*)();
  static const std::map<std::string, range_function> functions{
      {"full_turn", &ranges_of_effect::full_turn},
      {"signature", &ranges_of_effect::signature},
      {"intersections", &ranges_of_effect::intersections},
      {"tennis_racket", &ranges_of_effect::tennis_racket},
      {"regime", &ranges_of_effect::regime},
      {"period", &ranges_of_effect::period},
      {"montgomery_phase", &ranges_of_effect::montgomery_phase},
      {"mean_precession", &ranges_of_effect::mean_precession},
      {"flips", &ranges_of_effect::flips},
      {"sensitivity", &ranges_of_effect::sensitivity},
  };
  const auto found = functions.find(to.name);
  if (found == functions.end()) return;
  if (!x.what.body.ranges->is_ordered()) {
    return not_certified(
        to, "the order of the axes is undecided within the uncertainties, and so are the ranges");
  }
  ranges_of_effect ranges(x, to);
  (ranges.*found->second)();
}

}  // namespace polhode::detail
