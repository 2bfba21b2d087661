#include "body_links.hpp"

#include <algorithm>
#include <array>
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
                           ample_guard(digits));
}

struct counts {
  std::size_t physical = 0;
  std::size_t planar = 0;
  std::size_t non_physical = 0;
  std::size_t refused = 0;
};

std::optional<nearest_physical_tensor> nearest_of(const link_inertia& link, bool wanted) {
  if (!wanted || is_refused(link) || link.kind != body_kind::non_physical) return std::nullopt;
  return nearest_physical(principal_axes(link.tensor));
}

ball distance_of(const nearest_physical_tensor& x, long digits) {
  return x.distance(bits_for_digits(digits) + 32);
}

constexpr const char* unit_of_inertia = "kg m^2";

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

using names = std::vector<std::string>;

std::string as_text(const std::vector<link_inertia>& links, const names& without, bool nearest) {
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
  for (const link_inertia& link : links) {
    if (const auto x = nearest_of(link, nearest))
      result += link.name + ": " + nearest_text(*x, shown, unit_of_inertia);
  }
  if (!without.empty()) {
    const std::string text = fmt::format("without <inertial>: {}", fmt::join(without, ", "));
    for (const std::string& line : wrapped(text, terminal_columns)) result += line + '\n';
  }
  const counts n = counts_of(links);
  result +=
      fmt::format("{} link{}: {} physical, {} planar, {} non-physical, {} refused\n", links.size(),
                  links.size() == 1 ? "" : "s", n.physical, n.planar, n.non_physical, n.refused);
  return result + "moments and margin, I_y + I_z - I_x, in kg m^2; digits cut off\n";
}

std::string as_csv(const std::vector<link_inertia>& links, const names& without, long digits,
                   bool nearest) {
  const auto quoted = [](const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
  };
  const auto cell = [&](const std::optional<ball>& x) {
    return x ? to_decimal_enclosure(*x, digits).value : "";
  };
  std::string result = "link,line,kind,margin,I_x,I_y,I_z,I,J,remark";
  if (nearest) {
    result += ",distance";
    for (const char* entry : tensor_entry_names) result += fmt::format(",nearest_{}", entry);
  }
  result += '\n';
  for (const link_inertia& link : links) {
    result += fmt::format("{},{},", quoted(link.name), link.line);
    if (is_refused(link)) {
      result += "refused,,,,,,," + quoted(link.problem) + (nearest ? ",,,,,,,\n" : "\n");
      continue;
    }
    result += fmt::format("{},{}", to_text(link.kind), decimal_of(link.margin, digits));
    for (const exact_real& moment : link.moments) result += ',' + decimal_of(moment, digits);
    result += fmt::format(",{},{},", cell(constant_of(link, digits, &body::geometric_constant)),
                          cell(constant_of(link, digits, &body::second_geometric_constant)));
    if (const auto x = nearest_of(link, nearest)) {
      result += ',' + cell(distance_of(*x, digits));
      for (const exact_real& entry : x->tensor) result += ',' + decimal_of(entry, digits);
    } else if (nearest) {
      result += ",,,,,,,";
    }
    result += '\n';
  }
  for (const std::string& name : without) {
    result += quoted(name) + ",,without inertial,,,,,,," + (nearest ? ",,,,,,,\n" : "\n");
  }
  return result;
}

json measured(json number, const std::string& unit) {
  if (!unit.empty()) number["unit"] = unit;
  return number;
}

std::string as_json(const std::vector<link_inertia>& links, const names& without, long digits,
                    bool nearest) {
  const auto in_unit = [&](const exact_real& x) {
    return measured(exact_json(x, digits), unit_of_inertia);
  };
  json result{{"verdict",
               to_text(counts_of(links).refused == 0 ? status::certified : status::not_certified)},
              {"links", json::array()},
              {"without_inertial", without}};
  for (const link_inertia& link : links) {
    json one{{"name", link.name}, {"line", link.line}};
    if (is_refused(link)) {
      one["kind"] = "refused";
      one["remark"] = link.problem;
    } else {
      one["kind"] = to_text(link.kind);
      one["margin"] = in_unit(link.margin);
      constexpr std::array names{"x", "y", "z"};
      for (std::size_t i = 0; i < 3; ++i) one["moments"][names[i]] = in_unit(link.moments[i]);
      if (const auto x = constant_of(link, digits, &body::geometric_constant)) {
        one["geometric_constant"] = to_json(*x, digits);
        one["second_geometric_constant"] =
            to_json(*constant_of(link, digits, &body::second_geometric_constant), digits);
      } else {
        one["remark"] = "two moments are equal, a symmetric top: there is no intermediate axis";
      }
      if (const auto x = nearest_of(link, nearest))
        one["nearest"] = nearest_json(*x, digits, unit_of_inertia);
    }
    result["links"].push_back(std::move(one));
  }
  return json_document_text("links", result);
}

}  // namespace
}  // namespace body_links_impl

json nearest_json(const nearest_physical_tensor& x, long digits, const std::string& unit) {
  using namespace body_links_impl;
  json result{{"distance", measured(to_json(distance_of(x, digits), digits), unit)}};
  for (std::size_t i = 0; i < x.tensor.size(); ++i)
    result["tensor"][tensor_entry_names[i]] = measured(exact_json(x.tensor[i], digits), unit);
  constexpr std::array names{"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i)
    result["moments"][names[i]] = measured(exact_json(x.moments[i], digits), unit);
  return result;
}

std::string nearest_text(const nearest_physical_tensor& x, long digits, const std::string& unit) {
  std::string result = fmt::format("nearest physical tensor, at the distance {}{}:\n",
                                   to_decimal(body_links_impl::distance_of(x, digits), digits),
                                   unit.empty() ? "" : ' ' + unit);
  for (std::size_t i = 0; i < x.tensor.size(); ++i) {
    const exact_real& entry = x.tensor[i];
    result += fmt::format(
        "  {} = {}\n", tensor_entry_names[i],
        !entry.is_rational() ? to_decimal(entry.at(bits_for_digits(digits) + 32), digits)
        : is_short(entry.exact(), digits) ? to_text(entry) + " exactly"
                                          : with_dots(leading_digits_of(entry.exact(), digits)));
  }
  return result;
}

exit_status print_links(const std::string& path, const links_wanted& wanted) {
  const auto [links, without] = [&] {
    try {
      const std::string text = read_text_file(path);
      return std::pair(read_link_inertias(text), links_without_inertia(text));
    } catch (const input_error& error) {
      throw usage_error(fmt::format("{}: {}", in_quotes(path), error.what()));
    }
  }();
  using namespace body_links_impl;
  print(wanted.format == "json"  ? as_json(links, without, wanted.digits, wanted.nearest)
        : wanted.format == "csv" ? as_csv(links, without, wanted.digits, wanted.nearest)
                                 : as_text(links, without, wanted.nearest));
  const counts n = counts_of(links);
  const bool is_right = n.refused == 0 && (n.non_physical == 0 || wanted.allow_non_physical);
  return is_right ? exit_status::all_certified : exit_status::not_certified;
}

}  // namespace polhode::cli
