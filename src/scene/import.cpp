// Inertia from the files of robot simulators.

#include <algorithm>
#include <sstream>
#include <string_view>

#include <pugixml.hpp>

#include "base/quoted.hpp"
#include "polhode/rigid_body/inertia_tensor.hpp"
#include "polhode/scene/link_inertias.hpp"
#include "scene/inertia.hpp"

namespace polhode::detail {
namespace {

struct found_inertia {
  std::string name;
  long line = 0;
  tensor_entries tensor;
  bool is_turned = false;
  std::string problem;  // with its line
};

// NOLINTNEXTLINE(bugprone-exception-escape): its destructor is the library's
class reader : public pugi::xml_tree_walker {
 public:
  /// For one body a turned frame is refused, and so is what is no number. Of the invariants of all
  /// a frame is of no matter, and a link that is refused is found with its problem.
  enum class purpose { one_body, all_invariants };
  reader(const std::string& text, purpose what) : text_(&text), purpose_(what) {}

  bool for_each(pugi::xml_node& node) override {
    if (std::string_view(node.name()) != "inertial") return true;
    try {
      read(node);
    } catch (const input_error& error) {
      if (purpose_ == purpose::one_body) throw;
      add(node, {}, error.what());
    }
    return true;
  }

  std::vector<found_inertia> found;

 private:
  void read(const pugi::xml_node& node) {
    is_turned_ = purpose_ == purpose::one_body && refuse_turned_frame(node);
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
  /// The entries are about the axes of a frame of their own: only where these are the link's are
  /// they taken, or where they are turned by no more than `least_turn`, which is remembered. Its
  /// place, the centre of mass, is of no matter. Returns whether the frame is turned at all.
  bool refuse_turned_frame(const pugi::xml_node& node) const {
    bool is_turned = false;
    const auto numbers = [&](const pugi::xml_node& at, const std::string& text) {
      std::vector<rational> result;
      std::istringstream words(text);
      for (std::string word; words >> word;) result.push_back(number(at, word));
      return result;
    };
    // Angles, in radians or degrees.
    const auto check_angles = [&](const pugi::xml_node& at, const std::vector<rational>& all,
                                  std::size_t from) {
      for (std::size_t i = from; i < all.size(); ++i) {
        if (all[i] == 0) continue;
        if (abs(all[i]) > least_turn()) refuse(at, turned);
        is_turned = true;
      }
    };
    // A quaternion from numbers[from] on, with the real part at `real`: the angle is at most 2
    // |v|/|w|.
    const auto check_quaternion = [&](const pugi::xml_node& at, const std::vector<rational>& all,
                                      std::size_t from, std::size_t real) {
      constexpr std::size_t places = 4;
      if (all.size() != from + places) refuse(at, "a quaternion must be 4 numbers");
      const rational size(abs(all[real]) * least_turn() / 4);
      if (size == 0) refuse(at, turned);
      for (std::size_t i = from; i < all.size(); ++i) {
        if (i == real || all[i] == 0) continue;
        if (abs(all[i]) * 2 > size) refuse(at, turned);
        is_turned = true;
      }
    };
    if (const pugi::xml_node origin = node.child("origin")) {  // URDF
      check_angles(origin, numbers(origin, origin.attribute("rpy").value()), 0);
    }
    if (const pugi::xml_node pose =
            node.child("pose")) {  // SDF: x y z, and roll pitch yaw or a quaternion
      constexpr std::size_t places = 3;
      const std::vector<rational> all = numbers(pose, pose.text().get());
      if (std::string_view(pose.attribute("rotation_format").value()) == "quat_xyzw") {
        check_quaternion(pose, all, places, all.size() - 1);
      } else {
        check_angles(pose, all, places);
      }
    }
    if (const pugi::xml_attribute quaternion = node.attribute("quat")) {  // MuJoCo: w x y z
      check_quaternion(node, numbers(node, quaternion.value()), 0, 0);
    }
    for (const char* key : {"euler", "axisangle", "xyaxes", "zaxis"}) {  // MuJoCo
      if (node.attribute(key)) refuse(node, turned);
    }
    return is_turned;
  }
  /// What a program for drawing leaves of an angle of 0, and far below what is measured.
  static rational least_turn() { return {1, 1'000'000'000'000}; }
  static constexpr const char* turned =
      "its frame is turned against the link's; give the inertia about the link's own axes";
  void add(const pugi::xml_node& node, tensor_entries tensor, std::string problem = "") {
    const std::string name = node.parent().attribute("name").value();
    found.push_back({name, line_of(node), std::move(tensor), is_turned_, std::move(problem)});
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
  bool is_turned_ = false;
  mutable std::size_t counted_to_ = 0;
  mutable long counted_ = 1;
};

/// Throws input_error where there is none.
std::vector<found_inertia> inertias_in(const std::string& text, reader::purpose what) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
  if (!parsed) {
    const auto end = static_cast<std::ptrdiff_t>(std::min(
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0)), text.size()));
    throw input_error("line " +
                      std::to_string(1 + std::count(text.begin(), text.begin() + end, '\n')) +
                      ": no XML: " + parsed.description());
  }
  reader inertias(text, what);
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

}  // namespace

imported_inertia import_inertia(const std::string& text, const std::optional<std::string>& link) {
  std::vector<found_inertia> found = inertias_in(text, reader::purpose::one_body);
  std::vector<found_inertia> chosen;
  std::string names;
  for (found_inertia& one : found) {
    constexpr std::size_t most_shown = 200;
    if (names.size() < most_shown) names += (names.empty() ? "" : ", ") + detail::quoted(one.name);
    if (!link || one.name == *link) chosen.push_back(std::move(one));
  }
  if (chosen.empty())
    throw input_error("there is no inertia of " + detail::quoted(*link) + "; there are those of " +
                      names);
  if (chosen.size() > 1) {
    throw input_error(
        "there are " + std::to_string(chosen.size()) + " inertias" +
        (link ? " of " + detail::quoted(*link) : "; choose one by \"link\": " + names));
  }
  return {chosen.front().name, chosen.front().tensor, chosen.front().is_turned};
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

}  // namespace polhode
