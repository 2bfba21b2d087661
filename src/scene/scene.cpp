#include "polhode/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "base/nearest_name.hpp"
#include "base/quoted.hpp"
#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/scene/effects.hpp"
#include "scene/exact_quaternion.hpp"
#include "scene/inertia.hpp"

namespace polhode {

triple<ball> scene_body::principal_axis(std::size_t i, precision p) const {
  const matrix3<ball> turned = turn.matrix(p);
  const triple<ball> own = axes->axis(i, p);
  triple<ball> result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = turned[k][0] * own[0] + turned[k][1] * own[1] + turned[k][2] * own[2];
  }
  return result;
}

namespace detail {
namespace {

std::string time_of(const std::string& angular_velocity) {
  if (angular_velocity == "rpm") return "min";
  if (angular_velocity == "Hz") return "s";
  return angular_velocity.substr(angular_velocity.find('/') + 1);
}

unit unit_named(const std::vector<unit>& units, const std::string& name) {
  return *std::find_if(units.begin(), units.end(),
                       [&](const unit& one) { return one.name == name; });
}

std::array<rational, 4> nonzero_quaternion(section& from, const char* key,
                                           const std::array<std::size_t, 4>& wxyz) {
  const auto q = from.numbers(key, 4);
  if (std::all_of(q.begin(), q.end(), [](const rational& x) { return x == 0; }))
    from.refuse(key, "it must not be 0");
  return {q[wxyz[0]], q[wxyz[1]], q[wxyz[2]], q[wxyz[3]]};
}

void read_matrix(section& from, scene_state& result, std::vector<std::string>& remarks) {
  const auto entries = from.matrix("matrix", 3);
  matrix3<rational> rows;
  for (std::size_t i = 0; i < 3; ++i) rows[i] = {entries[i][0], entries[i][1], entries[i][2]};
  const bool project = from.flag("project", false);
  try {
    if (!project) {
      refuse_unless_rotation(rows);
      result.matrix = rows;
      return;
    }
    const projected_rotation nearest = nearest_rotation(rows);
    const ball distance = sqrt(ball(nearest.squared_distance, 64));
    if (nearest.squared_distance > rational(1, 100)) {
      throw input_error("the nearest rotation is at the distance " +
                        to_decimal_enclosure(distance, 3).value +
                        ": too far for a rounded rotation, at most 0.1");
    }
    result.quaternion = nearest.quaternion;
    remarks.push_back("matrix: projected to the nearest rotation, at the distance " +
                      to_decimal_enclosure(distance, 3).value + " in the Frobenius norm");
  } catch (const input_error& error) {
    from.refuse("matrix", error.what());
  }
}

/// "zxz", "321": three axes, none after itself.
triple<int> read_axes(section& from) {
  const std::string name = from.text("euler_sequence");
  triple<int> result{};
  bool right = name.size() == result.size();
  for (std::size_t i = 0; i < result.size() && right; ++i) {
    const std::size_t letter = std::string_view("xyz").find(name[i]);
    const std::size_t digit = std::string_view("123").find(name[i]);
    right = letter < 3 || digit < 3;
    result[i] = static_cast<int>(std::min(letter, digit));
    right = right && (i == 0 || result[i] != result[i - 1]);
  }
  if (!right) {
    from.refuse("euler_sequence",
                detail::quoted(name) +
                    ": it must be three axes, none after itself, such as \"zxz\" or "
                    "\"321\"");
  }
  return result;
}

void read_attitude(section& from, scene_state& result, std::vector<std::string>& remarks) {
  int given = 0;
  for (const char* key : {"quaternion", "quaternion_xyzw", "mrp", "matrix", "euler"})
    given += int{from.has(key)};
  if (given > 1) {
    from.refuse(
        "the attitude is given twice; give one of quaternion, quaternion_xyzw, mrp, matrix, euler");
  }
  if (from.find("quaternion"))
    result.quaternion = nonzero_quaternion(from, "quaternion", {0, 1, 2, 3});
  if (from.find("quaternion_xyzw"))
    result.quaternion = nonzero_quaternion(from, "quaternion_xyzw", {3, 0, 1, 2});
  if (from.find("mrp")) {
    // tan(angle/4) times the axis: q = (1 - m^2, 2 m)/(1 + m^2).
    const auto m = from.numbers("mrp", 3);
    result.quaternion = {rational(1 - m[0] * m[0] - m[1] * m[1] - m[2] * m[2]), rational(2 * m[0]),
                         rational(2 * m[1]), rational(2 * m[2])};
  }
  if (from.find("matrix")) {
    read_matrix(from, result, remarks);
  } else if (from.find("project")) {
    from.refuse("project", "it goes with matrix");
  }
  if (!from.find("euler")) {
    for (const char* key : {"euler_unit", "euler_sequence"})
      if (from.find(key)) from.refuse(key, "it goes with euler");
    return;
  }
  const auto angles = from.numbers("euler", 3);
  result.euler = {angles[0], angles[1], angles[2]};
  const std::string unit_name = from.text("euler_unit");
  refuse_unless_known(from.at("euler_unit"), from.path_of("euler_unit"), unit_name, {"rad", "deg"},
                      "the unit");
  result.euler_unit = unit_name == "deg" ? angle_unit::degrees : angle_unit::radians;
  if (from.find("euler_sequence")) result.euler_axes = read_axes(from);
}

rational_vector nonzero(section& from, const std::string& key, const char* what) {
  const auto v = from.numbers(key, 3);
  if (v[0] == 0 && v[1] == 0 && v[2] == 0)
    from.refuse(key, std::string(what) + " is 0: the body does not turn");
  return {v[0], v[1], v[2]};
}

}  // namespace

scene_state read_state(section from, const scene_body& of, scene& whole) {
  scene_state result;
  result.line = from.value().line;
  const bool by_omega = from.find("omega") != nullptr;
  const bool by_momentum = from.find("momentum") != nullptr;
  const bool by_c = from.find("c") != nullptr;
  const bool has_unit = from.find("unit") != nullptr;
  read_attitude(from, result, whole.remarks);
  from.finish();
  if (int{by_omega} + int{by_momentum} + int{by_c} != 1) {
    from.refuse(by_omega || by_momentum || by_c
                    ? "the state is given twice; give one of omega, momentum, c"
                    : "there is no state; give one of omega, momentum, c");
  }
  if (by_c) {
    if (has_unit) from.refuse("unit", "c has no unit: contradictory");
    if (result.quaternion || result.matrix || result.euler)
      from.refuse("an attitude goes with omega or momentum, which tell where the body starts");
    if (!of.axes->rigid()) from.refuse("c", "c needs a body with three different moments");
    const rational c = from.number("c");
    try {
      result.motion.emplace(*of.axes->rigid(), c);
    } catch (const input_error& error) {
      from.refuse("c", error.what());
    }
    return result;
  }
  const std::string key = by_omega ? "omega" : "momentum";
  const rational_vector given =
      nonzero(from, key, by_omega ? "the angular velocity" : "the angular momentum");
  const auto size = read_unit(from, "unit", by_omega ? angular_velocity_units() : momentum_units());
  if (by_momentum && size.has_value() != of.has_unit) {
    from.refuse(key, size ? "contradictory units: the momentum has a unit and the moments of "
                            "inertia have none; give [body] a unit"
                          : "contradictory units: the moments of inertia have a unit and the "
                            "momentum has none; give [state] a unit");
  }
  result.by_omega = by_omega;
  const triple<exact_real> exact{given[0], given[1], given[2]};
  const triple<exact_real> inner = of.turn.inverse().of(exact);
  result.momentum = by_omega ? of.turn.of(of.axes->times(inner)) : exact;
  result.omega = by_omega ? exact : of.turn.of(of.axes->solved(inner));
  try {
    result.start = by_omega ? initial_state::from_tensor_and_velocity(of.axes, given, of.turn)
                            : initial_state::from_tensor(of.axes, given, of.turn);
  } catch (const input_error& error) {
    from.refuse(key, error.what());
  }
  if (result.quaternion) result.start->set_quaternion(*result.quaternion);
  if (result.matrix) result.start->set_matrix(*result.matrix);
  if (result.euler)
    result.start->set_euler_angles(*result.euler, result.euler_unit, result.euler_axes);
  if (of.axes->rigid()) result.motion = result.start->motion();
  if (size) {
    result.momentum_size = by_omega ? of.size * size->size : size->size;
    whole.time_kind = scene::time_scale::si;
    whole.time_unit = unit_named(time_units(), by_omega ? time_of(size->name) : "s");
  } else {
    result.momentum_size = of.size;  // so that I_y/J is in the units given
    whole.time_kind = scene::time_scale::as_given;
    whole.time_unit = {by_omega ? "1/omega" : "I/J", {1, 0}};
  }
  return result;
}

}  // namespace detail

namespace {

using detail::read_body;
using detail::read_state;

constexpr long most_samples = 1'000'000;
constexpr long most_scene_digits = 100'000;

scene_time read_time(section from, scene& whole) {
  scene_time result;
  const auto from_value = from.optional_number("from");
  (void)from.find("to");
  (void)from.find("samples");
  (void)from.find("unit");
  (void)from.find("epoch");
  from.finish();
  if (from_value) result.from = *from_value;
  result.to = from.number("to");
  // Then `from` and `to` are Julian dates, too.
  const std::optional<rational> epoch = from.optional_number("epoch");
  if (epoch) {
    result.from = from_value ? rational(*from_value - *epoch) : rational(0);
    result.to -= *epoch;
    whole.remarks.push_back("time 0 is the Julian date " + from.at("epoch").text +
                            "; times are in days from then");
  }
  result.samples = from.count("samples", 101, 1, most_samples);
  if (result.to < result.from)
    from.refuse("to", "the end must not be before the beginning, from = " + to_text(result.from));
  if (result.samples == 1 && result.to != result.from) {
    from.refuse("samples", "one sample is of one time; give from = to, or at least 2 samples");
  }
  auto size = detail::read_unit(from, "unit", time_units());
  if (epoch && size && size->name != "day") {
    from.refuse("unit",
                "with an epoch the times are Julian dates; it must be \"day\", or left out");
  }
  if (epoch) size = detail::unit_named(time_units(), "day");
  if (!size) return result;
  if (whole.time_kind != scene::time_scale::si) {
    from.refuse(epoch ? "epoch" : "unit",
                "contradictory units: the state has no unit of time (such as unit = \"rad/s\"), "
                "and [time] has one");
  }
  whole.time_unit = *size;
  return result;
}

std::vector<rational> read_sweep_values(section& sweep, const std::string& key) {
  const document_value& value = sweep.at(key);
  constexpr std::size_t most = 100'000;
  if (value.type == document_value::kind::array) {
    if (value.items.empty() || value.items.size() > most)
      sweep.refuse(key, "it must be an array of at least one number");
    return sweep.numbers(key, value.items.size());
  }
  section range = sweep.table(key);
  const rational low = range.number("from");
  const rational high = range.number("to");
  const long steps = range.count("steps", 10, 1, static_cast<long>(most) - 1);
  range.finish();
  std::vector<rational> result;
  result.reserve(static_cast<std::size_t>(steps) + 1);
  for (long k = 0; k <= steps; ++k) result.emplace_back(low + (high - low) * k / steps);
  return result;
}

void read_sweep(section sweep, scene& result, const replacements& replaced) {
  std::size_t points = 1;
  const std::vector<std::string> known(replaced.seen.begin(), replaced.seen.end());
  const std::set<std::string> seen(known.begin(), known.end());  // before the sweep's own numbers
  for (const auto& [key, value] : sweep.value().members) {
    if (!seen.contains(key)) {
      const std::optional<std::string> near = near_name(key, known);
      const std::string right = near ? "; the nearest is \"" + *near + '"' : "";
      refuse_value(value, detail::quoted(key), "there is no such number in this scene" + right);
    }
    result.sweep.push_back({key, read_sweep_values(sweep, key)});
    points *= result.sweep.back().values.size();
    constexpr std::size_t most = 1'000'000;
    if (points > most) refuse_value(value, "sweep", "it has more than 1000000 points");
  }
  if (result.sweep.empty())
    sweep.refuse(
        "it is empty; give a key of a number, \"state.omega[0]\" = { from = 1, to = 2, steps = 10 "
        "}");
}

/// What an effect lacks in this scene; empty where it has everything.
std::string missing_for(const effect_needs& needs, const scene& what) {
  if (needs.distinct && !what.body.axes->rigid()) {
    return "three different moments, and this body is a symmetric top, which has no intermediate "
           "axis";
  }
  if ((needs.motion || needs.start) && !what.state)
    return "a state: give [state] omega, momentum or c";
  if (needs.start && !what.state->momentum) {
    return "the direction of the angular momentum in the body: give [state] omega or momentum in "
           "place of c";
  }
  if (needs.time && !what.time) return "a time: give [time] to";
  return "";
}

void read_effects(section from, scene& result) {
  std::vector<std::string> names;
  names.reserve(all_effects().size());
  for (const effect_description& one : all_effects()) names.push_back(one.name);
  (void)from.find("want");
  result.points = from.count("points", result.points, 2, 100'000);
  result.listed = from.count("listed", result.listed, 0, 100'000);
  if (from.find("c")) {
    const auto ends = from.numbers("c", 2);
    result.c_range = {ends[0], ends[1]};
  }
  from.finish();
  const std::vector<std::string> want = from.texts("want");
  if (want.empty())
    from.refuse("want", "it is empty; give at least one of the effects, such as \"period\"");
  for (const std::string& name : want) {
    refuse_unless_known(from.at("want"), "effects.want", name, names, "the effect");
    if (std::find(result.want.begin(), result.want.end(), name) == result.want.end())
      result.want.push_back(name);
  }
  if (result.c_range && result.body.axes->rigid()) {
    const auto& [low, high] = *result.c_range;
    if (low >= high) from.refuse("c", "the lower end must be below the upper one");
    for (const rational& end : {low, high}) {
      try {
        (void)regime_of(*result.body.axes->rigid(), end);
      } catch (const input_error& error) {
        from.refuse("c", error.what());
      }
    }
  }
  for (const std::string& name : result.want) {
    for (const std::string& needed : closure_of({name})) {
      const std::string what = missing_for(find_effect(needed)->needs, result);
      if (!what.empty())
        from.refuse("want", fmt::format(R"(the effect "{}" needs {})", name, what));
    }
  }
}

scene read_sections(const document_value& document, const std::filesystem::path& directory,
                    replacements& replaced, text_files& files) {
  section root(document, "", replaced);
  scene result;
  for (const char* key :
       {"title", "source", "digits", "precision", "body", "state", "time", "effects", "sweep"})
    (void)root.find(key);
  root.finish();
  result.title = root.optional_text("title").value_or("");
  result.source = root.optional_text("source").value_or("");
  if (root.has("precision")) {
    if (root.text("precision") != "double")
      root.refuse("precision", "it must be \"double\"; for more, give digits = 50");
    if (root.has("digits"))
      root.refuse("precision", "contradictory: there are digits, too; give one");
    result.in_double = true;
    result.digits = 15;
  }
  result.digits = root.count("digits", result.digits, 1, most_scene_digits);
  if (!root.has("body")) root.refuse("there is no [body]");
  if (!root.has("effects")) root.refuse("there are no [effects]; give want = [\"period\"]");
  result.body = read_body(root.table("body"), directory, files, result.remarks);
  if (result.in_double) {
    for (const exact_real& moment : result.body.moments()) {
      if (std::isnormal(midpoint(moment.at(64)).convert_to<double>())) continue;
      root.refuse("precision", "in double " + detail::shown(moment) +
                                   " has no room; give moments in another unit, or digits = 15");
    }
  }
  if (root.has("state")) result.state = read_state(root.table("state"), result.body, result);
  if (root.has("time")) result.time = read_time(root.table("time"), result);
  read_effects(root.table("effects"), result);
  // At one point of a sweep its values have been read already, once for all points.
  if (root.has("sweep") && replaced.numbers.empty())
    read_sweep(root.table("sweep"), result, replaced);
  return result;
}

}  // namespace

scene read_scene(const std::string& text, const std::filesystem::path& directory,
                 const std::map<std::string, rational>& replaced) {
  text_files files;
  return read_scene(text, directory, replaced, files);
}

scene read_scene(const std::string& text, const std::filesystem::path& directory,
                 const std::map<std::string, rational>& replaced, text_files& files,
                 const std::vector<std::string>& settings) {
  replacements in_place{replaced, {}};
  const document_value document = with_settings(parse_document(text), settings);
  return read_sections(document, directory, in_place, files);
}

}  // namespace polhode
