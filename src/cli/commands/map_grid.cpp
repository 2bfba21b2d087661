#include "map_grid.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options/motion_option.hpp"
#include "cli/options/options.hpp"
#include "cli/output/errors.hpp"
#include "cli/output/json_document.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode::cli {
namespace map_grid_impl {
namespace {

constexpr std::size_t most_points = 100'000'000;

/// N + 1 numbers, each the product of the one before and the same factor, to six digits; the ends
/// as they are.
std::vector<rational> in_equal_ratios(const std::string& option, const std::string& text,
                                      const motion_range& range) {
  const auto low = static_cast<double>(range.low);
  const auto high = static_cast<double>(range.high);
  if (!(range.low > 0) || !std::isnormal(low) || !std::isnormal(high)) {
    throw usage_error(
        fmt::format("{} {}: with --log both ends must be above 0, from 1e-300 to 1e300", option,
                    in_quotes(text)));
  }
  std::vector<rational> result;
  const auto steps = static_cast<double>(*range.steps);
  for (long k = 0; k <= *range.steps; ++k) {
    if (k == 0 || k == *range.steps) {
      result.push_back(k == 0 ? range.low : range.high);
      continue;
    }
    const double t = static_cast<double>(k) / steps;
    result.push_back(parse_rational(
        fmt::format("{:.5e}", std::exp((1 - t) * std::log(low) + t * std::log(high)))));
  }
  return result;
}

std::vector<rational> axis(const std::string& option, const std::string& text, bool log) {
  const motion_range range = read_motions(text, option);
  if (!range.steps && range.low != range.high) {
    throw usage_error(
        fmt::format("{} {}: the number of steps is missing; give LO..HI/N, such as {}/10", option,
                    in_quotes(text), text));
  }
  return log && range.steps ? in_equal_ratios(option, text, range) : range.values();
}

json as_json(const map_grid& g) {
  json result{{"quantities", g.quantities},
              {"a", g.a},
              {"b", g.b},
              {"log", g.log},
              {"digits", g.digits},
              {"points", g.points()},
              {"points_of_block", g.points_of_block}};
  if (g.c) result["c"] = *g.c;
  if (g.cells) {
    result["cells"] = true;
    result["refine"] = g.refine;
    if (g.width) result["width"] = to_text(*g.width);
  }
  return result;
}

}  // namespace
}  // namespace map_grid_impl

map_grid completed(map_grid g) {
  const std::vector<std::string> all = names_of(all_quantities());
  g.quantities = known_names(g.quantities, all, "quantity", "polhode map --help");
  if (g.quantities.empty()) {
    throw usage_error(fmt::format("there is no quantity; give some of {}", fmt::join(all, ", ")));
  }
  bool of_motion = false;
  for (const std::string& name : g.quantities) {
    const auto found = std::ranges::find(all_quantities(), name, &quantity::name);
    g.chosen.push_back(&*found);
    of_motion = of_motion || found->of_motion;
    if (found->of_motion && !g.c) {
      throw usage_error(fmt::format("{} is that of a motion; give --c LO..HI/N, or --c C", name));
    }
  }
  if (g.c && !of_motion) {
    throw usage_error(fmt::format("--c: {} {} of a body and of no motion",
                                  fmt::join(g.quantities, ", "),
                                  g.quantities.size() == 1 ? "is that" : "are those"));
  }
  g.a_values = map_grid_impl::axis("--a", g.a, g.log);
  g.b_values = map_grid_impl::axis("--b", g.b, g.log);
  if (g.c) g.c_values = map_grid_impl::axis("--c", *g.c, false);
  for (const rational& a : {g.a_values.front(), g.a_values.back()}) {
    if (!(a > 0)) throw usage_error(fmt::format("--a {}: a must be above 0", in_quotes(g.a)));
  }
  for (const rational& b : {g.b_values.front(), g.b_values.back()}) {
    if (!(b > 0 && b < 1)) {
      throw usage_error(fmt::format("--b {}: b must be between 0 and 1", in_quotes(g.b)));
    }
  }
  if (g.points() > map_grid_impl::most_points) {
    throw usage_error(fmt::format("a map of {} points: at most {} are possible", g.points(),
                                  map_grid_impl::most_points));
  }
  return g;
}

std::string head_of(const map_grid& g) {
  return json_document_text("map", map_grid_impl::as_json(g));
}

std::optional<map_grid> read_head(const std::string& text) {
  try {
    const json head = json::parse(text);
    map_grid g;
    head.at("quantities").get_to(g.quantities);
    head.at("a").get_to(g.a);
    head.at("b").get_to(g.b);
    head.at("log").get_to(g.log);
    head.at("digits").get_to(g.digits);
    head.at("points_of_block").get_to(g.points_of_block);
    if (g.points_of_block < 1 || g.points_of_block > map_grid::most_points_of_block) {
      return std::nullopt;
    }
    if (head.contains("cells")) {
      g.cells = true;
      head.at("refine").get_to(g.refine);
      if (head.contains("width")) g.width = parse_rational(head.at("width").get<std::string>());
    }
    if (head.contains("c")) g.c = head.at("c").get<std::string>();
    map_grid done = completed(g);
    if (head_of(done) == text) return done;
  } catch (const json::exception&) {
  } catch (const usage_error&) {
  } catch (const input_error&) {
  }
  return std::nullopt;
}

}  // namespace polhode::cli
