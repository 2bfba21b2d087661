// Inertia from the files of robot simulators.

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <string_view>

#include <pugixml.hpp>

#include "base/quoted.hpp"
#include "polhode/rigid_body/exact_rotation.hpp"
#include "polhode/scene/link_inertias.hpp"
#include "scene/inertia.hpp"

namespace polhode::detail {
namespace {

struct found_inertia {
  std::string name;
  long line = 0;
  tensor_entries tensor;
  exact_rotation turn;  // of imported_inertia
  std::string problem;  // with its line
};

/// R T R^T.
tensor_entries turned(const tensor_entries& t, const matrix3<rational>& rotation) {
  const auto& [xx, yy, zz, xy, xz, yz] = t;
  const matrix3<rational> rows{{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
  const auto entry = [&](std::size_t i, std::size_t k) {
    rational sum = 0;
    for (std::size_t m = 0; m < 3; ++m) {
      for (std::size_t n = 0; n < 3; ++n) sum += rotation[i][m] * rows[m][n] * rotation[k][n];
    }
    return sum;
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

/// How a MuJoCo file writes angles.
struct angle_format {
  angle_unit unit = angle_unit::degrees;
  std::string sequence = "xyz";
};

// NOLINTNEXTLINE(bugprone-exception-escape): its destructor is the library's
class reader : public pugi::xml_tree_walker {
 public:
  /// For one body the frame is read, too; the invariants of all do not depend on it. A link that is
  /// refused is kept with its problem.
  enum class purpose { one_body, all_invariants };
  reader(const std::string& text, purpose what, angle_format angles)
      : text_(&text), purpose_(what), angles_(std::move(angles)) {}

  bool for_each(pugi::xml_node& node) override {
    if (std::string_view(node.name()) != "inertial") return true;
    try {
      read(node);
    } catch (const input_error& error) {
      turn_ = {};
      add(node, {}, error.what());
    }
    return true;
  }

  std::vector<found_inertia> found;

 private:
  void read(const pugi::xml_node& node) {
    turn_ = purpose_ == purpose::one_body ? turn_of(node) : exact_rotation();
    if (node.attribute("diaginertia") || node.attribute("fullinertia")) {
      add(node, from_mujoco(node));
    } else if (const pugi::xml_node inertia = node.child("inertia")) {
      if (inertia.next_sibling("inertia")) refuse(node, "it has two <inertia>; give one");
      add(node, from_entries(inertia));
    } else if (purpose_ == purpose::all_invariants) {
      refuse(node, "it has no inertia");
    }
  }
  /// Counted from 1. Nodes come in the order of the text, so that it is read once.
  long line_of(const pugi::xml_node& node) const {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    const std::size_t to = std::min(offset, text_->size());
    if (to < counted_to_) {
      counted_to_ = 0;
      counted_ = 1;
    }
    counted_ += std::count(text_->begin() + static_cast<std::ptrdiff_t>(counted_to_),
                           text_->begin() + static_cast<std::ptrdiff_t>(to), '\n');
    counted_to_ = to;
    return counted_;
  }
  [[noreturn]] void refuse(const pugi::xml_node& node, const std::string& what) const {
    throw input_error("line " + std::to_string(line_of(node)) + ": <" + node.name() + ">: " + what);
  }
  rational number(const pugi::xml_node& node, const std::string& text) const {
    try {
      return parse_rational(text);
    } catch (const input_error& error) {
      refuse(node, error.what());
    }
  }
  /// From the axes of the inertia's frame to the link's. The frame's place, the centre of mass, is
  /// of no matter.
  exact_rotation turn_of(const pugi::xml_node& node) const {
    if (const pugi::xml_node origin = node.child("origin")) {  // URDF
      const pugi::xml_attribute rpy = origin.attribute("rpy");
      const pugi::xml_attribute quaternion = origin.attribute("quat_xyzw");
      if (rpy && quaternion) refuse(origin, "it is turned twice; give one of rpy, quat_xyzw");
      if (quaternion) return of_quaternion_xyzw(origin, numbers(origin, quaternion.value(), 4), 0);
      if (!rpy) return {};
      return of_roll_pitch_yaw(numbers(origin, rpy.value(), 3), 0, angle_unit::radians);
    }
    if (const pugi::xml_node pose = node.child("pose")) return of_pose(pose);
    exact_rotation result;
    int given = 0;
    const auto read = [&](const char* key, std::size_t count, const auto& make) {
      const pugi::xml_attribute attribute = node.attribute(key);
      if (!attribute) return;
      if (++given > 1)
        refuse(node,
               "its frame is turned twice; give one of quat, euler, axisangle, xyaxes, zaxis");
      const std::vector<rational> x = numbers(node, attribute.value(), count);
      try {
        result = make(x);
      } catch (const input_error& error) {
        refuse(node, std::string(key) + ": " + error.what());
      }
    };
    read("quat", 4, [](const auto& x) {
      return exact_rotation::of_quaternion({x[0], x[1], x[2], x[3]});
    });
    read("euler", 3, [&](const auto& x) { return of_sequence(x); });
    read("axisangle", 4, [&](const auto& x) {
      return exact_rotation::about({x[0], x[1], x[2]}, x[3], angles_.unit);
    });
    read("xyaxes", 6, [](const auto& x) {
      return exact_rotation::with_axes({x[0], x[1], x[2]}, {x[3], x[4], x[5]});
    });
    read("zaxis", 3, [](const auto& x) {
      return exact_rotation::with_third_axis({x[0], x[1], x[2]});
    });
    if (given > 0 && node.attribute("fullinertia"))
      refuse(node, "fullinertia goes with no turned frame; give diaginertia, or no frame");
    return result;
  }
  /// Of SDF: three numbers of the place, then the rotation.
  exact_rotation of_pose(const pugi::xml_node& pose) const {
    constexpr std::size_t places = 3;
    if (*pose.attribute("relative_to").value() != 0) {
      refuse(pose, "relative_to: it must be given against the link's own frame");
    }
    const std::string_view format = pose.attribute("rotation_format").value();
    if (format == "quat_xyzw") {
      return of_quaternion_xyzw(pose, numbers(pose, pose.text().get(), places + 4), places);
    }
    if (!format.empty() && format != "euler_rpy")
      refuse(pose, R"(rotation_format: it must be "euler_rpy" or "quat_xyzw")");
    const std::string_view degrees = pose.attribute("degrees").value();
    return of_roll_pitch_yaw(
        numbers(pose, pose.text().get(), places + 3), places,
        degrees == "true" || degrees == "1" ? angle_unit::degrees : angle_unit::radians);
  }
  exact_rotation of_quaternion_xyzw(const pugi::xml_node& at, const std::vector<rational>& x,
                                    std::size_t first) const {
    try {
      return exact_rotation::of_quaternion({x[first + 3], x[first], x[first + 1], x[first + 2]});
    } catch (const input_error& error) {
      refuse(at, error.what());
    }
  }
  /// About the fixed axes x, y, z, in this order.
  static exact_rotation of_roll_pitch_yaw(const std::vector<rational>& angles, std::size_t first,
                                          angle_unit unit) {
    return exact_rotation::about(2, angles[first + 2], unit) *
           exact_rotation::about(1, angles[first + 1], unit) *
           exact_rotation::about(0, angles[first], unit);
  }
  /// Each letter is an axis: a small one of the frame, which turns, a capital one of the link.
  exact_rotation of_sequence(const std::vector<rational>& angles) const {
    exact_rotation result;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const std::size_t own = std::string_view("xyz").find(angles_.sequence[i]);
      const std::size_t fixed = std::string_view("XYZ").find(angles_.sequence[i]);
      const auto one = exact_rotation::about(std::min(own, fixed), angles[i], angles_.unit);
      result = own < 3 ? result * one : one * result;
    }
    return result;
  }
  std::vector<rational> numbers(const pugi::xml_node& at, const std::string& text,
                                std::size_t count) const {
    std::vector<rational> result;
    std::istringstream words(text);
    for (std::string word; words >> word;) result.push_back(number(at, word));
    if (result.size() != count) {
      refuse(at, "its frame has " + std::to_string(result.size()) + " numbers, and must have " +
                     std::to_string(count));
    }
    return result;
  }
  void add(const pugi::xml_node& node, tensor_entries tensor, std::string problem = "") {
    const std::string name = node.parent().attribute("name").value();
    exact_rotation turn = turn_;
    if (const auto rotation = turn.rational_matrix()) {
      if (!turn.is_identity()) tensor = turned(tensor, *rotation);
      turn = {};
    }
    found.push_back({name, line_of(node), std::move(tensor), std::move(turn), std::move(problem)});
  }
  /// URDF has attributes, SDF elements.
  tensor_entries from_entries(const pugi::xml_node& node) const {
    const std::array<const char*, 6> keys{"ixx", "iyy", "izz", "ixy", "ixz", "iyz"};
    tensor_entries result;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      std::string text = node.attribute(keys[i]).value();
      if (text.empty()) text = node.child(keys[i]).text().get();
      std::istringstream words(text);
      std::string word;
      if (!(words >> word)) {
        if (i < 3) refuse(node, std::string(keys[i]) + " is missing");
        word = "0";
      }
      if (words >> word) refuse(node, std::string(keys[i]) + ": it must be one number");
      result[i] = number(node, word);
    }
    return result;
  }
  tensor_entries from_mujoco(const pugi::xml_node& node) const {
    const pugi::xml_attribute full = node.attribute("fullinertia");
    const pugi::xml_attribute diagonal = node.attribute("diaginertia");
    if (full && diagonal) refuse(node, "it has diaginertia and fullinertia; there may be one");
    tensor_entries result{0, 0, 0, 0, 0, 0};
    std::istringstream words(full ? full.value() : diagonal.value());
    std::string word;
    std::size_t count = 0;
    for (; words >> word; ++count) {
      if (count < result.size()) result[count] = number(node, word);
    }
    const std::size_t right = full ? 6 : 3;
    if (count != right) {
      refuse(node, std::string(full ? "fullinertia" : "diaginertia") + " must be " +
                       std::to_string(right) + " numbers");
    }
    return result;
  }

  const std::string* text_;
  purpose purpose_;
  angle_format angles_;
  exact_rotation turn_;
  mutable std::size_t counted_to_ = 0;
  mutable long counted_ = 1;
};

// NOLINTNEXTLINE(bugprone-exception-escape): its destructor is the library's
class without_inertia : public pugi::xml_tree_walker {
 public:
  bool for_each(pugi::xml_node& node) override {
    const std::string_view name = node.name();
    if ((name == "link" || name == "body") && node.attribute("name") && !node.child("inertial")) {
      names.emplace_back(node.attribute("name").value());
    }
    return true;
  }
  std::vector<std::string> names;
};

/// Throws input_error where the text is no XML.
void load(pugi::xml_document& document, const std::string& text) {
  const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
  if (!parsed) {
    const auto end = static_cast<std::ptrdiff_t>(std::min(
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0)), text.size()));
    throw input_error("line " +
                      std::to_string(1 + std::count(text.begin(), text.begin() + end, '\n')) +
                      ": no XML: " + parsed.description());
  }
}

/// Of several <compiler> the last that says it.
// NOLINTNEXTLINE(bugprone-exception-escape): its destructor is the library's
class angle_format_reader : public pugi::xml_tree_walker {
 public:
  bool for_each(pugi::xml_node& node) override {
    if (std::string_view(node.name()) != "compiler") return true;
    const std::string_view unit = node.attribute("angle").value();
    if (unit == "radian") found.unit = angle_unit::radians;
    if (unit == "degree") found.unit = angle_unit::degrees;
    if (node.attribute("eulerseq")) found.sequence = node.attribute("eulerseq").value();
    const bool is_right = found.sequence.size() == 3 &&
                          found.sequence.find_first_not_of("xyzXYZ") == std::string::npos;
    if (!is_right) {
      throw input_error("<compiler>: eulerseq " + detail::quoted(found.sequence) +
                        ": it must be three letters of \"xyz\", or capital ones");
    }
    return true;
  }
  angle_format found;
};

/// Throws input_error where there is none.
std::vector<found_inertia> inertias_in(const std::string& text, reader::purpose what) {
  pugi::xml_document document;
  load(document, text);
  angle_format_reader angles;
  if (what == reader::purpose::one_body) document.traverse(angles);
  reader inertias(text, what, angles.found);
  document.traverse(inertias);
  if (inertias.found.empty()) {
    throw input_error(
        "there is no inertia in it: neither <inertial> with <inertia> (URDF, SDF) nor <inertial> "
        "with diaginertia or "
        "fullinertia (MuJoCo)");
  }
  return std::move(inertias.found);
}

void settle(link_inertia& link, const tensor_entries& given) {
  const principal_axes axes(given);
  link.moments = axes.moments();
  link.kind = axes.kind();
  link.margin = axes.margin();
  link.rigid = axes.rigid();
}

/// The one of this name, or the only one.
template <class Link>
Link& chosen(std::vector<Link>& found, const std::optional<std::string>& link) {
  Link* result = nullptr;
  std::size_t count = 0;
  std::string names;
  for (Link& one : found) {
    constexpr std::size_t most_shown = 200;
    if (names.size() < most_shown) names += (names.empty() ? "" : ", ") + detail::quoted(one.name);
    if (link && one.name != *link) continue;
    result = &one;
    ++count;
  }
  if (count == 0)
    throw input_error("there is no inertia of " + detail::quoted(*link) + "; there are those of " +
                      names);
  if (count > 1) {
    throw input_error("there are " + std::to_string(count) + " inertias" +
                      (link ? " of " + detail::quoted(*link) : "; choose the link: " + names));
  }
  return *result;
}

}  // namespace

imported_inertia import_inertia(const std::string& text, const std::optional<std::string>& link) {
  std::vector<found_inertia> found = inertias_in(text, reader::purpose::one_body);
  found_inertia& one = chosen(found, link);
  if (!one.problem.empty()) throw input_error(one.problem);
  return {one.name, one.tensor, one.turn};
}

}  // namespace polhode::detail

namespace polhode {

std::vector<link_inertia> read_link_inertias(const std::string& text) {
  std::vector<link_inertia> result;
  for (detail::found_inertia& one :
       detail::inertias_in(text, detail::reader::purpose::all_invariants)) {
    link_inertia link;
    link.name = one.name;
    link.line = one.line;
    link.problem = one.problem;
    if (link.problem.empty()) {
      link.tensor = one.tensor;
      try {
        detail::settle(link, one.tensor);
      } catch (const input_error& error) {
        link.problem = "line " + std::to_string(one.line) + ": " + error.what();
      }
    }
    result.push_back(std::move(link));
  }
  return result;
}

std::vector<std::string> links_without_inertia(const std::string& text) {
  pugi::xml_document document;
  detail::load(document, text);
  detail::without_inertia links;
  document.traverse(links);
  return std::move(links.names);
}

bool is_robot_file(const std::string& path) {
  constexpr std::array extensions{".urdf", ".sdf", ".xml", ".mjcf"};
  const std::string own = std::filesystem::path(path).extension().string();
  return std::any_of(extensions.begin(), extensions.end(),
                     [&own](const char* one) { return own == one; });
}

body read_link_body(const std::string& text, const std::optional<std::string>& link) {
  std::vector<link_inertia> links = read_link_inertias(text);
  const link_inertia& one = detail::chosen(links, link);
  if (!one.problem.empty()) throw input_error(one.problem);
  if (one.rigid) return *one.rigid;
  throw input_error("line " + std::to_string(one.line) + ": " + detail::quoted(one.name) +
                    ": two principal moments are equal, a symmetric top, which has no intermediate "
                    "axis");
}

}  // namespace polhode
