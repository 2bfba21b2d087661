// Bodies composed of solids.

#include <array>

#include "polhode/arithmetic/text.hpp"
#include "scene/inertia.hpp"

namespace polhode::detail {
namespace {

/// A homogeneous solid about its own centre: with mass m, principal moments m square[i] about the
/// axes of the body.
struct solid {
  pi_scale mass;
  rational_vector square;
  rational_vector position;
  body_solid drawn;
  const document_value* at = nullptr;
  std::string path;
};

struct solid_units {
  rational length = 1;
  pi_scale mass;
  pi_scale density;
};

rational positive(section& from, const std::string& key) {
  rational value = from.number(key);
  if (value <= 0)
    from.refuse(key, to_text(value) + " must be positive: a solid has a size and a mass");
  return value;
}

rational_vector positive_vector(section& from, const std::string& key) {
  const std::vector<rational> values = from.numbers(key, 3);
  for (const rational& value : values) {
    if (value <= 0)
      from.refuse(key, to_text(value) + " must be positive: a solid of no size has no inertia");
  }
  return {values[0], values[1], values[2]};
}

std::size_t read_axis(section& from) {
  const std::string axis = from.optional_text("axis").value_or("z");
  if (axis != "x" && axis != "y" && axis != "z")
    from.refuse("axis", R"(it must be "x", "y" or "z")");
  return static_cast<std::size_t>(axis[0] - 'x');
}

solid read_solid(section from, const solid_units& units) {
  static const std::vector<std::string> shapes{"box", "cylinder", "ellipsoid"};
  const std::string shape = from.text("shape");
  refuse_unless_known(from.at("shape"), from.path_of("shape"), shape, shapes, "the shape");
  solid result;
  result.drawn.shape = shape;
  pi_scale volume;
  // The mean squares of the coordinates, x^2: the moment about x is m (y^2 + z^2).
  rational_vector mean;
  if (shape == "box") {  // side^2/12
    const rational_vector sides = positive_vector(from, "size");
    for (std::size_t i = 0; i < 3; ++i) mean[i] = sides[i] * sides[i] / 12;
    for (std::size_t i = 0; i < 3; ++i) result.drawn.half[i] = sides[i] / 2;
    volume.factor = sides[0] * sides[1] * sides[2];
  } else if (shape == "cylinder") {  // r^2/4 across, h^2/12 along
    const std::size_t axis = read_axis(from);
    const rational radius = positive(from, "radius");
    const rational height = positive(from, "height");
    for (std::size_t i = 0; i < 3; ++i)
      mean[i] = i == axis ? rational(height * height / 12) : rational(radius * radius / 4);
    volume = {radius * radius * height, 1};
    result.drawn.axis = axis;
    for (std::size_t i = 0; i < 3; ++i)
      result.drawn.half[i] = i == axis ? rational(height / 2) : radius;
  } else {  // a^2/5
    const rational_vector axes = positive_vector(from, "semi_axes");
    for (std::size_t i = 0; i < 3; ++i) mean[i] = axes[i] * axes[i] / 5;
    volume = {axes[0] * axes[1] * axes[2] * 4 / 3, 1};
    result.drawn.half = axes;
  }
  const rational area = units.length * units.length;
  for (std::size_t i = 0; i < 3; ++i)
    result.square[i] = (mean[(i + 1) % 3] + mean[(i + 2) % 3]) * area;
  for (rational& one : result.drawn.half) one *= units.length;
  volume.factor *= area * units.length;
  if (from.has("mass") == from.has("density")) {
    from.refuse(from.has("mass") ? "it has a mass and a density; give one"
                                 : R"(it has neither "mass" nor "density"; give one)");
  }
  if (from.find("mass")) {
    result.mass = pi_scale{positive(from, "mass"), 0} * units.mass;
  } else {
    (void)from.find("density");
    result.mass = pi_scale{positive(from, "density"), 0} * units.density * volume;
  }
  result.position = {0, 0, 0};
  if (from.find("position")) {
    const std::vector<rational> place = from.numbers("position", 3);
    for (std::size_t i = 0; i < 3; ++i) result.position[i] = place[i] * units.length;
  }
  result.at = &from.value();
  result.path = from.path_of("");
  from.finish();
  return result;
}

}  // namespace

/// Steiner's theorem about the common centre of mass. The masses must be rational multiples of each
/// other, for otherwise the moments are not, pi being transcendental: all by density with a pi in
/// each volume, or none with one.
composed read_solids(section& body) {
  solid_units units;
  const auto length = read_unit(body, "length_unit", length_units());
  const auto mass = read_unit(body, "mass_unit", mass_units());
  const auto density = read_unit(body, "density_unit", density_units());
  if (length) units.length = length->size.factor;
  if (mass) units.mass = mass->size;
  if (density) units.density = density->size;
  const std::vector<section> tables = body.tables("solid");
  std::vector<solid> solids;
  solids.reserve(tables.size());
  for (const section& one : tables) solids.push_back(read_solid(one, units));

  const int power = solids.front().mass.power;
  rational total = 0;
  rational_vector centre{0, 0, 0};
  for (const solid& s : solids) {
    if (s.mass.power != power) {
      refuse_value(*s.at, "body.solid",
                   "the mass of one solid is a multiple of pi and that of another is not, so that "
                   "the ratio of their moments is "
                   "irrational, and a body is exact; give the masses in place of the densities");
    }
    total += s.mass.factor;
    for (std::size_t i = 0; i < 3; ++i) centre[i] += s.mass.factor * s.position[i];
  }
  for (rational& coordinate : centre) coordinate /= total;
  composed result;
  result.size.power = power;
  result.tensor = {0, 0, 0, 0, 0, 0};
  result.solids.reserve(solids.size());
  for (const solid& s : solids) {
    rational_vector r;
    for (std::size_t i = 0; i < 3; ++i) r[i] = s.position[i] - centre[i];
    const rational square(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    const rational& m = s.mass.factor;
    for (std::size_t i = 0; i < 3; ++i)
      result.tensor[i] += m * (s.square[i] + square - r[i] * r[i]);
    result.tensor[3] -= m * r[0] * r[1];
    result.tensor[4] -= m * r[0] * r[2];
    result.tensor[5] -= m * r[1] * r[2];
    result.solids.push_back(s.drawn);
    result.solids.back().position = r;
  }
  return result;
}

}  // namespace polhode::detail
