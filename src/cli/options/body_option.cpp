#include "body_option.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/output/errors.hpp"
#include "formula.hpp"
#include "polhode/scene/body_file.hpp"
#include "polhode/scene/document.hpp"
#include "polhode/scene/link_inertias.hpp"

namespace polhode::cli {
namespace {

/// Runs the reader; what it refuses becomes a usage error that begins with the option.
template <class F>
auto reading(const std::string& option, const std::string& text, const F& read) {
  try {
    return read();
  } catch (const input_error& error) {
    throw usage_error(fmt::format("{} {}: {}", option, in_quotes(text), error.what()));
  }
}

std::string without_spaces_around(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

template <std::size_t Count>
std::array<rational, Count> read_numbers(const std::string& option, const std::string& text,
                                         const char* right) {
  const std::vector<std::string> parts = parts_between_commas(text);
  if (parts.size() != Count) {
    throw usage_error(fmt::format("{} {}: it must be {} numbers between commas, such as {}", option,
                                  in_quotes(text), Count, right));
  }
  std::array<rational, Count> result;
  for (std::size_t i = 0; i < Count; ++i) {
    result[i] =
        reading(option, text, [&] { return parse_rational(without_spaces_around(parts[i])); });
  }
  return result;
}

/// The moments, each with its uncertainty where it has one: 2.6±0.1,2,1.
std::array<measured_number, 3> read_measured(const std::string& text) {
  const std::vector<std::string> parts = parts_between_commas(text);
  std::array<measured_number, 3> result;
  if (parts.size() != result.size()) {
    throw usage_error(fmt::format(
        "--moments {}: it must be 3 numbers between commas, such as 3,2,1", in_quotes(text)));
  }
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = reading("--moments", text, [&] { return parse_measured(parts[i]); });
  return result;
}
bool are_uncertain(const std::array<measured_number, 3>& moments) {
  return std::any_of(moments.begin(), moments.end(),
                     [](const measured_number& one) { return one.sigma.has_value(); });
}
/// Of one body.
std::array<rational, 3> read_moments(const std::string& text) {
  const auto moments = read_measured(text);
  if (are_uncertain(moments)) {
    throw usage_error(
        fmt::format("--moments {}: it has uncertainties, and this needs one body; ranges are for "
                    "body, phase, racket and scenes",
                    in_quotes(text)));
  }
  return {moments[0].value, moments[1].value, moments[2].value};
}

std::array<rational, 3> read_triple(const std::string& option, const std::string& text) {
  return read_numbers<3>(option, text, "3,2,1");
}

body body_by_ab(const std::string& text) {
  const auto [a, b] = read_numbers<2>("--ab", text, "12.65,0.0629");
  return reading("--ab", text, [&a = a, &b = b] { return body(a, b); });
}
body body_by_moments(const std::string& text) {
  const auto moments = read_moments(text);
  return reading("--moments", text, [&] { return body::from_moments(moments); });
}
body body_by_rotational_constants(const std::string& text) {
  const auto constants = read_numbers<3>("--rotational", text, "27.88,14.52,9.28");
  return reading("--rotational", text, [&] { return body::from_rotational_constants(constants); });
}
body body_by_tensor(const std::string& text) {
  const auto entries = read_numbers<6>("--tensor", text, "2,3,4,0.1,0,-0.2");
  return reading("--tensor", text, [&] { return body::from_inertia_tensor(entries); });
}

body body_in(const body_file& file) {
  if (file.sigma) {
    throw input_error(
        "it has a sigma, and this needs one body; ranges are for body, phase, racket and scenes");
  }
  if (file.ab) return {(*file.ab)[0], (*file.ab)[1]};
  if (file.moments) return body::from_moments(*file.moments);
  if (file.rotational) return body::from_rotational_constants(*file.rotational);
  return body::from_inertia_tensor(*file.tensor);
}
/// robot.urdf#link: the file, and the link where one is chosen.
std::pair<std::string, std::optional<std::string>> without_link(const std::string& path) {
  const std::size_t mark = path.rfind('#');
  if (mark == std::string::npos || !is_robot_file(path.substr(0, mark))) return {path, {}};
  return {path.substr(0, mark), path.substr(mark + 1)};
}
body body_by_file(const std::string& given) {
  return reading("--body", given, [&] {
    const auto [path, link] = without_link(given);
    return is_robot_file(path) ? read_link_body(read_text_file(path), link)
                               : body_in(read_body_file(path));
  });
}

using uncertain_moments = std::array<uncertain_moment, 3>;

uncertain_moments with_ranges(const std::array<rational, 3>& moments,
                              const std::array<rational, 3>& sigma) {
  uncertain_moments result{
      {{moments[0], sigma[0]}, {moments[1], sigma[1]}, {moments[2], sigma[2]}}};
  (void)uncertain_body(result);  // throws where it is none
  return result;
}

struct body_option_text {
  const char* name;
  const char* description;
  const char* type;
};
constexpr std::array<body_option_text, 5> body_options{
    {{"--ab", "The body by a = I_y/I_z - 1 > 0 and b = 1 - I_y/I_x in (0, 1)", "A,B"},
     {"--moments", "The body by its principal moments of inertia, in any order and unit",
      "IX,IY,IZ"},
     {"--rotational",
      "The body by its rotational constants, in any order and unit:\nmoments as 1/A, 1/B, 1/C",
      "A,B,C"},
     {"--tensor", "The body by its inertia tensor, in any axes and unit", "XX,YY,ZZ,XY,XZ,YZ"},
     {"--body",
      "The body in a JSON file: ab, moments (and sigma), rotational or tensor;\nor a link of a "
      "robot: "
      "FILE.urdf, .sdf, .xml or .mjcf, and #LINK",
      "FILE"}}};

constexpr const char* no_body =
    "there is no body; give --ab 12.65,0.0629 or --moments 3,2,1 or --rotational 27.88,14.52,9.28 "
    "or --tensor 2,3,4,0.1,0,-0.2 or --body FILE";

template <class Texts>
void declare_all(CLI::App& app, const std::array<Texts*, 5>& texts,
                 const std::optional<std::string>& ab_description = std::nullopt) {
  for (std::size_t i = 0; i < body_options.size(); ++i) {
    declared_option option = add_option(
        app, body_options[i].name, *texts[i],
        i == 0 && ab_description ? *ab_description : std::string(body_options[i].description));
    option.type_name(body_options[i].type);
    if constexpr (std::is_same_v<Texts, std::vector<std::string>>) option.one_value_each_time();
  }
}

}  // namespace

void body_option::declare(CLI::App& app, const std::optional<std::string>& ab_description) {
  declare_all<std::optional<std::string>>(app, {&ab, &moments, &rotational, &tensor, &file},
                                          ab_description);
}

const char* body_option::name() const {
  if (ab) return "--ab";
  if (moments) return "--moments";
  if (rotational) return "--rotational";
  return tensor ? "--tensor" : "--body";
}

body body_option::value() const {
  const int given = int{ab.has_value()} + int{moments.has_value()} + int{rotational.has_value()} +
                    int{tensor.has_value()} + int{file.has_value()};
  if (!is_given()) throw usage_error(no_body);
  if (given > 1) {
    throw usage_error("--ab, --moments, --rotational, --tensor, --body: give one of them");
  }
  if (ab) return body_by_ab(*ab);
  if (moments) return body_by_moments(*moments);
  if (rotational) return body_by_rotational_constants(*rotational);
  if (tensor) return body_by_tensor(*tensor);
  return body_by_file(*file);
}

std::optional<std::array<rational, 6>> body_option::tensor_entries() const {
  const auto diagonal = [](const std::array<rational, 3>& m) {
    return std::array<rational, 6>{m[0], m[1], m[2], 0, 0, 0};
  };
  if (moments) return diagonal(read_moments(*moments));
  if (tensor) return read_numbers<6>("--tensor", *tensor, "2,3,4,0.1,0,-0.2");
  if (!file || is_robot_file(without_link(*file).first)) return std::nullopt;
  return reading("--body", *file, [&]() -> std::optional<std::array<rational, 6>> {
    const body_file read = read_body_file(*file);
    if (read.moments) return diagonal(*read.moments);
    return read.tensor;
  });
}

std::optional<uncertain_moments> body_option::uncertain(
    const std::optional<std::string>& sigma) const {
  if (sigma) {
    if (!moments || ab || rotational || tensor || file)
      throw usage_error("--sigma is for --moments");
    const auto values = read_moments(*moments);
    const auto widths = read_triple("--sigma", *sigma);
    try {
      return with_ranges(values, widths);
    } catch (const input_error& error) {
      throw usage_error(fmt::format("--moments {} --sigma {}: {}", in_quotes(*moments),
                                    in_quotes(*sigma), error.what()));
    }
  }
  if (moments && !ab && !rotational && !tensor && !file) {
    const auto values = read_measured(*moments);
    if (!are_uncertain(values)) return std::nullopt;
    std::array<rational, 3> widths;
    for (std::size_t i = 0; i < 3; ++i) widths[i] = values[i].sigma.value_or(rational(0));
    return reading("--moments", *moments, [&] {
      return std::optional(
          with_ranges({values[0].value, values[1].value, values[2].value}, widths));
    });
  }
  if (!file || ab || moments || rotational || tensor) return std::nullopt;
  if (is_robot_file(without_link(*file).first)) return std::nullopt;
  return reading("--body", *file, [&]() -> std::optional<uncertain_moments> {
    const body_file read = read_body_file(*file);
    if (!read.sigma) return std::nullopt;
    return with_ranges(*read.moments, *read.sigma);
  });
}

void bodies_option::declare(CLI::App& app) {
  declare_all<std::vector<std::string>>(app, {&ab, &moments, &rotational, &tensors, &files});
}

std::vector<body> bodies_option::value() const {
  std::vector<body> result;
  result.reserve(ab.size() + moments.size() + rotational.size() + tensors.size() + files.size());
  for (const std::string& text : ab) result.push_back(body_by_ab(text));
  for (const std::string& text : moments) result.push_back(body_by_moments(text));
  for (const std::string& text : rotational) result.push_back(body_by_rotational_constants(text));
  for (const std::string& text : tensors) result.push_back(body_by_tensor(text));
  for (const std::string& path : files) result.push_back(body_by_file(path));
  if (result.empty()) throw usage_error(no_body);
  return result;
}

rational read_number(const std::string& option, const std::string& text) {
  return reading(option, text, [&] { return parse_rational(text); });
}

std::string described(body_kind kind) {
  switch (kind) {
    case body_kind::physical:
      return "physical (ab + 2b < 1)";
    case body_kind::planar:
      return "planar (ab + 2b = 1): physical, with all mass in a plane";
    case body_kind::non_physical:
      return "non-physical (ab + 2b > 1): no mass distribution has these moments";
    case body_kind::undecided:
      break;
  }
  return "undecided: within the ranges given there are physical bodies and others";
}

}  // namespace polhode::cli
