// [body]

#include <algorithm>

#include "base/quoted.hpp"
#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/scene/body_file.hpp"
#include "polhode/scene/link_inertias.hpp"
#include "scene/inertia.hpp"

namespace polhode::detail {
namespace {

/// What builds the body, its input_error with the line of the key.
template <class F>
scene_body at_key(const section& from, const std::string& key, const F& make) {
  try {
    return make();
  } catch (const input_error& error) {
    from.refuse(key, error.what());
  }
}

/// The range of 1/x for x in value +- sigma.
uncertain_moment inverse_range(const rational& value, const rational& sigma) {
  const rational low(1 / (value + sigma));
  const rational high(1 / (value - sigma));
  return {(low + high) / 2, (high - low) / 2};
}

scene_body of_measured(const std::vector<measured_number>& given,
                       const std::optional<std::vector<rational>>& sigma, bool inverse) {
  std::array<uncertain_moment, 3> ranges;
  bool uncertain = sigma.has_value();
  for (std::size_t i = 0; i < 3; ++i) {
    const rational& value = given[i].value;
    if (given[i].sigma && sigma)
      throw input_error("it has uncertainties, and there is a \"sigma\"; give one of them");
    const rational width = given[i].sigma ? *given[i].sigma : (sigma ? (*sigma)[i] : rational(0));
    uncertain = uncertain || given[i].sigma;
    if (width < 0) throw input_error("a sigma must not be negative");
    if (inverse && value - width <= 0) {
      throw input_error(to_text(value) + (width == 0 ? "" : " less its sigma") +
                        " is not positive; a rotational constant must be");
    }
    ranges[i] = inverse ? inverse_range(value, width) : uncertain_moment{value, width};
  }
  if (uncertain && inverse) {
    // Of the values given, and not of the middles of the moments' ranges.
    const auto moment = [&](std::size_t i) { return rational(1 / given[i].value); };
    scene_body result = body_of_moments({moment(0), moment(1), moment(2)});
    set_ranges(result, ranges);
    return result;
  }
  if (uncertain) {
    scene_body result = body_of_moments({ranges[0].value, ranges[1].value, ranges[2].value});
    set_ranges(result, ranges);
    return result;
  }
  return body_of_moments({ranges[0].value, ranges[1].value, ranges[2].value});
}

scene_body of_ab(const std::array<rational, 2>& ab) {
  const auto& [a, b] = ab;
  (void)body(a, b);  // refuses what is none
  return body_of_moments({1 / (1 - b), 1, 1 / (1 + a)});
}

std::array<rational, 6> tensor_of(const std::vector<std::vector<rational>>& rows) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (rows[i][k] != rows[k][i]) throw input_error("the tensor must be symmetric");
    }
  }
  return {rows[0][0], rows[1][1], rows[2][2], rows[0][1], rows[0][2], rows[1][2]};
}

template <std::size_t Count>
std::vector<measured_number> measured(const std::array<rational, Count>& values) {
  std::vector<measured_number> result;
  result.reserve(Count);
  for (const rational& value : values) result.push_back({value, {}});
  return result;
}

scene_body of_json(const std::string& text) {
  const body_file file = parse_body_file(text);
  if (file.ab) return of_ab(*file.ab);
  if (file.tensor) return body_of_tensor(*file.tensor);
  std::optional<std::vector<rational>> sigma;
  if (file.sigma) sigma.emplace(file.sigma->begin(), file.sigma->end());
  return file.moments ? of_measured(measured(*file.moments), sigma, false)
                      : of_measured(measured(*file.rotational), sigma, true);
}

scene_body of_file(section& from, const std::filesystem::path& directory, text_files& files) {
  const std::filesystem::path given = from.text("file");
  const std::string path = (given.is_absolute() ? given : directory / given).string();
  const std::optional<std::string> link = from.optional_text("link");
  if (given.extension() == ".json") {
    if (link) from.refuse("link", "a JSON body has no links");
    scene_body result = of_json(files[path]);
    result.file = path;
    return result;
  }
  if (!is_robot_file(path)) {
    throw input_error(detail::quoted(given.string()) +
                      ": it must be a .json, .urdf, .sdf, .xml or .mjcf file");
  }
  const imported_inertia imported = import_inertia(files[path], link);
  scene_body result = body_of_tensor(imported.tensor);
  result.turn = imported.turn;
  result.name = imported.name;
  result.has_unit = true;  // all three formats are in kg m^2
  result.file = path;
  return result;
}

std::string violation(const scene_body& of) {
  const auto& m = of.moments();
  return "the triangle inequality is violated: the greatest moment " + shown(m[0]) +
         " is above the sum of the others " + shown(m[1] + m[2]) + " by " +
         shown(-of.axes->margin());
}

}  // namespace

std::string shown(const exact_real& x) {
  constexpr precision longest = 200;
  if (x.is_rational() && size_in_bits(x) <= longest) return to_text(x);
  return "about " + to_decimal(x.at(64).middle(), 6);
}

std::optional<unit> read_unit(section& from, const std::string& key,
                              const std::vector<unit>& units) {
  const auto name = from.optional_text(key);
  if (!name) return std::nullopt;
  std::vector<std::string> names;
  names.reserve(units.size());
  for (const unit& one : units) {
    if (one.name == *name) return one;
    names.push_back(one.name);
  }
  refuse_unless_known(from.at(key), from.path_of(key), *name, names, "the unit");
  return std::nullopt;
}

scene_body read_body(section body, const std::filesystem::path& directory, text_files& files,
                     std::vector<std::string>& remarks) {
  static const std::vector<std::string> ways{"moments",    "ab",    "tensor",
                                             "rotational", "solid", "file"};
  const std::optional<std::string> name = body.optional_text("name");
  const std::optional<std::string> source = body.optional_text("source");
  std::vector<std::string> given;
  for (const std::string& way : ways) {
    if (body.find(way)) given.push_back(way);
  }
  // Keys that belong to one of the ways: read in any case, so that a misplaced one is said to be
  // misplaced.
  const bool has_unit = body.find("unit") != nullptr;
  const bool has_sigma = body.find("sigma") != nullptr;
  const bool has_link = body.find("link") != nullptr;
  bool has_solid_units = false;
  for (const char* key : {"length_unit", "mass_unit", "density_unit"}) {
    has_solid_units = body.find(key) != nullptr || has_solid_units;
  }
  // An unknown key is more often the reason than a missing one.
  body.finish();
  if (given.empty()) {
    body.refuse("there is no body; give one of moments, ab, tensor, rotational, solid, file");
  }
  if (given.size() > 1)
    body.refuse(given[1], "the body is given twice, by \"" + given[0] + "\" and by \"" + given[1] +
                              "\"; give one");
  const std::string& way = given.front();
  if (has_unit && (way == "ab" || way == "solid" || way == "file"))
    body.refuse("unit", "a unit goes with moments, tensor or rotational");
  if (has_sigma && way != "moments" && way != "rotational")
    body.refuse("sigma", "a sigma goes with moments or rotational");
  if (has_link && way != "file") body.refuse("link", "a link goes with a file");
  if (has_solid_units && way != "solid")
    body.refuse("length_unit, mass_unit and density_unit go with [[body.solid]]");

  scene_body result;
  if (way == "moments" || way == "rotational") {
    const bool inverse = way == "rotational";
    const auto values = body.measured_numbers(way, 3);
    std::optional<std::vector<rational>> sigma;
    if (has_sigma) sigma = body.numbers("sigma", 3);
    const auto size = read_unit(body, "unit", inverse ? rotational_units() : inertia_units());
    result = at_key(body, way, [&] { return of_measured(values, sigma, inverse); });
    if (size) {
      result.size = inverse ? inertia_times_rotational_constant() / size->size : size->size;
      result.has_unit = true;
    }
  } else if (way == "ab") {
    const auto values = body.numbers("ab", 2);
    result = at_key(body, way, [&] { return of_ab({values[0], values[1]}); });
  } else if (way == "tensor") {
    const auto rows = body.matrix("tensor", 3);
    const auto size = read_unit(body, "unit", inertia_units());
    result = at_key(body, way, [&] { return body_of_tensor(tensor_of(rows)); });
    if (size) {
      result.size = size->size;
      result.has_unit = true;
    }
  } else if (way == "solid") {
    const composed whole = read_solids(body);
    result = at_key(body, way, [&] { return body_of_tensor(whole.tensor); });
    result.size = whole.size;
    result.solids = whole.solids;
    result.has_unit = true;
  } else {
    result = at_key(body, way, [&] { return of_file(body, directory, files); });
  }
  if (name) result.name = *name;
  if (source) result.source = *source;
  if (result.kind == body_kind::non_physical)
    remarks.push_back("no mass distribution has these moments: " + violation(result));
  if (result.ranges) {
    remarks.emplace_back(
        "moments with uncertainties: kinds, yes or no, and each NAME_range are of all bodies "
        "within "
        "them; the other numbers, series and curves are of the middle values");
  }
  return result;
}

}  // namespace polhode::detail
