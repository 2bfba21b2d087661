// Of a body whose moments have uncertainties: what holds for all bodies within them, and the ranges
// of numbers. A number falls or grows with a, b and c (body_box.hpp), of which a and b have I_y in
// common, and c, where the state is given by omega or J, all three moments: the ranges of the
// moments are divided into cells, and the cells' ranges joined.

#include <algorithm>
#include <functional>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "polhode/rigid_body/body_box.hpp"
#include "polhode/rigid_body/jacobi_start.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "scene/effect_context.hpp"
#include "scene/sensitivity.hpp"

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
    const integer of_all = meeting_count(at(false, true, true));
    const integer listed = std::min(meeting_count(x_.rigid()), integer(x_.what.listed));
    if (listed > of_all) to_.remarks.emplace_back("not all bodies have those without a range");
    for (integer m = 1; m <= std::min(listed, of_all); ++m) {
      const std::string which = meeting_name(m);
      add(which + "_c",
          of_bodies([&](const body_box& box) { return box.meeting(m, x_.digits()).c; }));
      if (m % 2 == 0) continue;
      add(which + "_epsilon",
          of_bodies([&](const body_box& box) { return box.meeting(m, x_.digits()).epsilon; }),
          "rad");
    }
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
    flip_times();
  }

  void montgomery_curve() {
    add_column([&](const body_box& box, const rational_range& c) {
      return box.montgomery_phase(c, bits());
    });
  }
  void twist_curve() {
    add_column(
        [&](const body_box& box, const rational_range& c) { return box.twist(c, x_.digits()); });
  }

  /// I_y/(|J| sqrt(a b)) of every body, and the derivatives over cells.
  void sensitivity() {
    const ball time = of_motions(fine, [&](const motions& m) {
      const ball growth2 = in_range(m.box.a(), bits()) * in_range(m.box.b(), bits());
      return unit_of_time(x_, m.cell, bits()) / sqrt(growth2);
    });
    add("e_folding_time_at_middle_axis", time, x_.what.time_unit.name);
    if (!has_motions() || is_given_separatrix()) return;
    const std::vector<effect_number> all = derivatives();
    for (const effect_number& n : all) add(n.name, n.enclosure, n.unit);
    if (all.empty()) {
      not_certified(
          to_,
          "the ranges of the derivatives were not enclosed: the separatrix may lie within "
          "the uncertainties");
    }
  }

 private:
  struct motions;

  /// Each of all motions; none where some rotate and others oscillate.
  [[nodiscard]] std::vector<effect_number> derivatives() const {
    const precision p = bits();
    const bool has_j = x_.what.state->momentum.has_value();
    std::vector<effect_number> all;
    for (const moment_ranges& cell : cells_of(whole_, {has_j, true, has_j}, fine)) {
      const body_box box = body_box::of_moments(cell);
      const rational_range range = c_of(x_, cell);
      const ball c = intersection(in_range(range, p), in_range({-box.b().high, box.a().high}, p));
      if (!certainly_positive(c) && !certainly_negative(c)) return {};
      sensitivity_point<ball> point{
          in_range(box.a(), p), in_range(box.b(), p), c, certainly_positive(c), {}};
      if (has_j) {
        const auto balls = [&](const triple<rational_range>& x) -> triple<ball> {
          return {in_range(x[0], p), in_range(x[1], p), in_range(x[2], p)};
        };
        point.vectors = {balls(cell), balls(direction_squares(cell))};
      }
      const std::vector<effect_number> part = derivatives_at(point, p);
      if (all.empty()) all = part;
      for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].enclosure = hull(all[i].enclosure, part[i].enclosure);
      }
    }
    return all;
  }

  /// Beside each row of the table the range over those bodies that have the motion c; undefined
  /// where it is not enclosed.
  template <class Range>
  void add_column(const Range& range) {
    if (!to_.table) return;
    effect_table& table = *to_.table;
    constexpr fineness few{1, 16, 16, 16};
    std::vector<body_box> boxes;
    for (const moment_ranges& cell : cells_of(whole_, {false, true, false}, few)) {
      boxes.push_back(body_box::of_moments(cell));
    }
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const rational_range c{table.first[i], table.first[i]};
      std::optional<ball> all;
      for (const body_box& box : boxes) {
        if (c.low <= -box.b().high || c.low >= box.a().high) continue;  // no motion of these
        const ball part = range(box, c);
        all = all ? hull(*all, part) : part;
      }
      table.rows[i].push_back(all.value_or(ball::undefined(bits())));
    }
    table.columns.push_back(table.columns[1] + "_range");
    table.units.push_back(table.units[1]);
  }

  /// The times of the flips that are listed, each of all bodies. Flip n is at (n T - 2 t_0)/2
  /// (flips.cpp), where t_0 is the distance of time 0 from the zero of sn, or T/2 less that
  /// distance beyond the turning point: on the same side, and the same branch, for all members, as
  /// J's components have the same signs for all.
  void flip_times() {
    const jacobi_start at = jacobi_start_of(x_.start());
    const long side = at.sine < 0 ? -1 : 1;
    // Twice the time is (n - back) T + distances * distance.
    const rational back = at.cosine == 0 ? rational(side, 2) : rational(at.cosine < 0 ? side : 0);
    const bool is_exact = at.sine == 0 || at.cosine == 0;
    const long distances = is_exact ? 0 : at.cosine < 0 ? 2 * side : -2 * side;
    struct times {
      ball period, distance, unit;
    };
    const auto twice = [&](const integer& n, const times& t) {
      return rational(n - back) * t.period + distances * t.distance;
    };
    const ball none(0, bits());
    std::vector<times> cells;
    const bool has_j = x_.what.state->momentum.has_value();
    for (const moment_ranges& cell : cells_of(whole_, {has_j, true, has_j}, fine)) {
      const motions m{*this, cell, body_box::of_moments(cell), c_of(x_, cell)};
      cells.push_back({m.period(), is_exact ? none : distance(m), unit_of_time(x_, cell, bits())});
    }
    const ball& period = x_.number("period", "natural_period");
    const times middle{
        period, is_exact ? none : at.distance(bits()) / sqrt(x_.motion().lambda2().at(bits())),
        natural_time(x_.what, bits())};
    const std::vector<effect_number> numbers = to_.numbers;
    for (const effect_number& flip : numbers) {
      if (flip.name.rfind("flip_", 0) != 0) continue;
      const ball place = (2 * flip.enclosure / middle.unit - twice(0, middle)) / period;
      const rational near = (lower_rational(place) + upper_rational(place)) / 2;
      const integer n = floor_of(near + rational(1, 2));
      // The flip's number is in the ball, which holds one whole number.
      const ball off = place - n;
      if (!contains_zero(off) || !certainly_less(abs(off), ball(rational(1, 2), bits()))) {
        not_certified(to_, flip.name + "_range was not enclosed");
        continue;
      }
      std::optional<ball> all;
      for (const times& t : cells) {
        const ball part = scale(twice(n, t) * t.unit, -1);
        all = all ? hull(*all, part) : part;
      }
      add(flip.name, *all, flip.unit);
    }
  }

  /// The distance in time, in I_y/J, of J from the zero of sn: sqrt(sn^2) R_F(cn^2, dn^2, 1)/lambda
  /// (jacobi_start), of all motions of a cell. R_F decreases in each argument.
  [[nodiscard]] ball distance(const motions& m) const {
    const precision p = bits();
    const ball a = in_range(m.box.a(), p);
    const ball b = in_range(m.box.b(), p);
    const ball c = in_range(m.c, p);
    const bool oscillates = x_.regime() == polhode::regime::oscillating;
    const ball first = oscillates ? a - c : a;  // lambda^2 is first * second
    const ball second = oscillates ? b : b + c;
    const triple<rational_range> squares = direction_squares(m.cell);
    const ball sine2 = in_range(squares[1], p) / (oscillates ? (b + c) / second : (a - c) / first);
    const ball x2 = in_range(squares[0], p) * (a + b) / (a - c);
    const ball z2 = in_range(squares[2], p) * (a + b) / (b + c);
    // sn^2 and cn^2 are in [0, 1] and add up to 1, and dn^2 is in [1 - m, 1].
    const ball m2 = (oscillates ? a * (b + c) : b * (a - c)) / (first * second);
    const ball unit = hull(ball(0, p), ball(1, p));
    const ball cosine2 = intersection(intersection(oscillates ? z2 : x2, 1 - sine2), unit);
    const ball delta2 = intersection(oscillates ? x2 : z2, hull(1 - m2, ball(1, p)));
    const auto end = [&](const ball& x, bool is_upper) {
      const ball part = intersection(x, unit);
      return part.is_undefined() ? part
                                 : ball(is_upper ? upper_rational(part) : lower_rational(part), p);
    };
    const auto value = [&](bool is_upper) {
      return sqrt(end(sine2, is_upper)) *
             carlson_rf(end(cosine2, !is_upper), end(delta2, !is_upper), ball(1, p));
    };
    return hull(value(false), value(true)) / sqrt(first * second);
  }
  /// (J_i/J)^2 of all motions of a cell.
  [[nodiscard]] triple<rational_range> direction_squares(const moment_ranges& cell) const {
    const std::array<rational, 3> given = given_squares(x_);
    std::array<rational_range, 3> parts;
    for (std::size_t i = 0; i < 3; ++i) {
      const rational_range size = x_.what.state->by_omega ? cell[i] : rational_range{1, 1};
      parts[i] = {given[i] * size.low * size.low, given[i] * size.high * size.high};
    }
    triple<rational_range> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const rational_range& j = parts[(i + 1) % 3];
      const rational_range& k = parts[(i + 2) % 3];
      if (parts[i].high == 0) continue;
      result[i] = {parts[i].low / (parts[i].low + j.high + k.high),
                   parts[i].high / (parts[i].high + j.low + k.low)};
    }
    return result;
  }

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
      {"montgomery_curve", &ranges_of_effect::montgomery_curve},
      {"twist_curve", &ranges_of_effect::twist_curve},
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
