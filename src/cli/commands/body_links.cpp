#include "body_links.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "cli/output/errors.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/layout.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/scene/body_file.hpp"
#include "polhode/scene/link_inertias.hpp"

namespace polhode::cli {
namespace body_links_impl {
namespace {

bool is_refused(const link_inertia& link) { return !link.problem.empty(); }

/// I or J, to so many digits; nothing for a symmetric top.
std::optional<ball> constant_of(const link_inertia& link, long digits,
                                ball (body::*constant)(precision) const) {
  if (!link.rigid) return std::nullopt;
  return enclose_to_digits([&](precision p) { return ((*link.rigid).*constant)(p); }, digits,
                           15 * bits_for_digits(digits) + 4096);
}

struct counts {
  std::size_t physical = 0;
  std::size_t planar = 0;
  std::size_t non_physical = 0;
  std::size_t refused = 0;
};

counts counts_of(const std::vector<link_inertia>& links) {
  counts result;
  for (const link_inertia& link : links) {
    if (is_refused(link)) {
      ++result.refused;
    } else if (link.kind == body_kind::planar) {
      ++result.planar;
    } else {
      ++(link.kind == body_kind::physical ? result.physical : result.non_physical);
    }
  }
  return result;
}

/// A decimal of at most ten characters and more where the exponent has more than two digits.
std::string short_decimal(const exact_real& x) {
  constexpr long shown = 4;
  return decimal_of(x, shown);
}
std::string short_decimal(const std::optional<ball>& x) {
  constexpr long shown = 4;
  return x ? to_decimal_enclosure(*x, shown).value : "-";
}

std::string as_text(const std::vector<link_inertia>& links) {
  constexpr long shown = 4;
  const char* row = "{:<12}  {:>10}  {:>10}  {:>10}  {:>10}  {:>7}  {:>7}  {}\n";
  std::string result =
      fmt::format(fmt::runtime(row), "KIND", "MARGIN", "I_x", "I_y", "I_z", "I", "J", "LINK");
  for (const link_inertia& link : links) {
    if (is_refused(link)) continue;
    result += fmt::format(fmt::runtime(row), to_text(link.kind), short_decimal(link.margin),
                          short_decimal(link.moments[0]), short_decimal(link.moments[1]),
                          short_decimal(link.moments[2]),
                          short_decimal(constant_of(link, shown, &body::geometric_constant)),
                          short_decimal(constant_of(link, shown, &body::second_geometric_constant)),
                          link.name);
  }
  for (const link_inertia& link : links) {
    if (!is_refused(link)) continue;
    for (const std::string& line :
         wrapped(fmt::format("refused: {}: {}", link.name, link.problem), terminal_columns)) {
      result += line + '\n';
    }
  }
  const counts n = counts_of(links);
  result +=
      fmt::format("{} link{}: {} physical, {} planar, {} non-physical, {} refused\n", links.size(),
                  links.size() == 1 ? "" : "s", n.physical, n.planar, n.non_physical, n.refused);
  return result + "moments and margin, I_y + I_z - I_x, in kg m^2; digits cut off\n";
}

std::string as_csv(const std::vector<link_inertia>& links, long digits) {
  const auto quoted = [](const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
  };
  const auto cell = [&](const std::optional<ball>& x) {
    return x ? to_decimal_enclosure(*x, digits).value : "";
  };
  std::string result = "link,line,kind,margin,I_x,I_y,I_z,I,J,remark\n";
  for (const link_inertia& link : links) {
    result += fmt::format("{},{},", quoted(link.name), link.line);
    if (is_refused(link)) {
      result += "refused,,,,,,," + quoted(link.problem) + '\n';
      continue;
    }
    result += fmt::format("{},{}", to_text(link.kind), decimal_of(link.margin, digits));
    for (const exact_real& moment : link.moments) result += ',' + decimal_of(moment, digits);
    result += fmt::format(",{},{},\n", cell(constant_of(link, digits, &body::geometric_constant)),
                          cell(constant_of(link, digits, &body::second_geometric_constant)));
  }
  return result;
}

std::string as_json(const std::vector<link_inertia>& links, long digits) {
  const auto measured = [&](const exact_real& x) {
    json number = exact_json(x, digits);
    number["unit"] = "kg m^2";
    return number;
  };
  json result{{"verdict",
               to_text(counts_of(links).refused == 0 ? status::certified : status::not_certified)},
              {"links", json::array()}};
  for (const link_inertia& link : links) {
    json one{{"name", link.name}, {"line", link.line}};
    if (is_refused(link)) {
      one["kind"] = "refused";
      one["remark"] = link.problem;
    } else {
      one["kind"] = to_text(link.kind);
      one["margin"] = measured(link.margin);
      constexpr std::array names{"x", "y", "z"};
      for (std::size_t i = 0; i < 3; ++i) one["moments"][names[i]] = measured(link.moments[i]);
      if (const auto x = constant_of(link, digits, &body::geometric_constant)) {
        one["geometric_constant"] = to_json(*x, digits);
        one["second_geometric_constant"] =
            to_json(*constant_of(link, digits, &body::second_geometric_constant), digits);
      } else {
        one["remark"] = "two moments are equal, a symmetric top: there is no intermediate axis";
      }
    }
    result["links"].push_back(std::move(one));
  }
  return json_document_text("links", result);
}

}  // namespace
}  // namespace body_links_impl

bool is_robot_file(const std::string& path) {
  constexpr std::array extensions{".urdf", ".sdf", ".xml", ".mjcf"};
  const std::string own = std::filesystem::path(path).extension().string();
  return std::any_of(extensions.begin(), extensions.end(),
                     [&own](const char* one) { return own == one; });
}

exit_status print_links(const std::string& path, const std::string& format, long digits,
                        bool allow_non_physical) {
  const std::vector<link_inertia> links = [&] {
    try {
      return read_link_inertias(read_text_file(path));
    } catch (const input_error& error) {
      throw usage_error(fmt::format("{}: {}", in_quotes(path), error.what()));
    }
  }();
  using namespace body_links_impl;
  print(format == "json"  ? as_json(links, digits)
        : format == "csv" ? as_csv(links, digits)
                          : as_text(links));
  const counts n = counts_of(links);
  const bool is_right = n.refused == 0 && (n.non_physical == 0 || allow_non_physical);
  return is_right ? exit_status::all_certified : exit_status::not_certified;
}

}  // namespace polhode::cli
