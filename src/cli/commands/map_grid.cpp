#include "map_grid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

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

void set_a_and_b(map_grid& g) {
  g.first = {"a", "a = I_y/I_z - 1", axis("--a", *g.a, g.log)};
  g.second = {"b", "b = 1 - I_y/I_x", axis("--b", *g.b, g.log)};
  for (const rational& a : {g.first.values.front(), g.first.values.back()}) {
    if (!(a > 0)) throw usage_error(fmt::format("--a {}: a must be above 0", in_quotes(*g.a)));
  }
  for (const rational& b : {g.second.values.front(), g.second.values.back()}) {
    if (!(b > 0 && b < 1)) {
      throw usage_error(fmt::format("--b {}: b must be between 0 and 1", in_quotes(*g.b)));
    }
  }
}

void set_moments(map_grid& g) {
  std::vector<std::string> given;
  std::istringstream texts(*g.moments + ',');
  for (std::string text; std::getline(texts, text, ',');) given.push_back(text);
  const auto wrong = [&](const std::string& why) {
    return usage_error(fmt::format(
        "--moments {}: {}; give two ranges and one number, such as 3,1..2/10,0.5..1.5/10",
        in_quotes(*g.moments), why));
  };
  if (given.size() != 3) throw wrong(fmt::format("{} in place of three moments", given.size()));
  map_axis* next = &g.first;
  for (std::size_t i = 0; i < given.size(); ++i) {
    std::vector<rational> values = axis("--moments", given[i], g.log);
    for (const rational& moment : {values.front(), values.back()}) {
      if (!(moment > 0)) throw wrong("moments are above 0");
    }
    if (given[i].find("..") == std::string::npos) {
      g.fixed = values.front();
      g.place_of_fixed = i;
      continue;
    }
    if (next == nullptr) throw wrong("three ranges");
    *next = {fmt::format("moment_{}", i + 1), fmt::format("moment {}", i + 1), std::move(values)};
    next = next == &g.first ? &g.second : nullptr;
  }
  if (next != nullptr) throw wrong("fewer ranges than two");
}

void set_limit(map_grid& g) {
  g.first = {"chi", "chi = a b", axis("--chi", *g.chi, g.log)};
  g.second = {"beta", "beta = c/b", axis("--beta", *g.beta, g.log)};
  if (!(g.first.values.front() > 0)) {
    throw usage_error(fmt::format("--chi {}: chi must be above 0", in_quotes(*g.chi)));
  }
  if (!(g.second.values.front() > -1)) {
    throw usage_error(fmt::format("--beta {}: beta must be above -1", in_quotes(*g.beta)));
  }
  if (g.quantities != std::vector<std::string>{"epsilon"} || g.c) {
    throw usage_error("--chi, --beta: of the limit there is epsilon alone, without --c");
  }
}

/// Which of the three pairs of axes is given.
void set_axes(map_grid& g) {
  const bool by_a = g.a || g.b;
  const bool by_chi = g.chi || g.beta;
  const bool is_one = (by_a ? 1 : 0) + (g.moments ? 1 : 0) + (by_chi ? 1 : 0) == 1;
  if (!is_one || g.a.has_value() != g.b.has_value() || g.chi.has_value() != g.beta.has_value()) {
    throw usage_error("the axes: give --a and --b, or --moments, or --chi and --beta");
  }
  if (by_a) set_a_and_b(g);
  if (g.moments) set_moments(g);
  if (by_chi) set_limit(g);
}

/// The moments at a point of a map over moments, or of a cell, in the order that was given.
template <class Number>
std::array<Number, 3> moments_at(const map_grid& g, const Number& x, const Number& y,
                                 const Number& fixed) {
  std::vector<Number> result{x, y};
  const auto place = result.begin() + static_cast<std::ptrdiff_t>(g.place_of_fixed);
  result.insert(place, fixed);
  return {result[0], result[1], result[2]};
}

/// The options that are the texts of axes, by name.
template <class Grid>
auto axes_in(Grid& g) {
  return std::array{
      std::pair{"a", &g.a},     std::pair{"b", &g.b},       std::pair{"moments", &g.moments},
      std::pair{"chi", &g.chi}, std::pair{"beta", &g.beta}, std::pair{"c", &g.c}};
}

json as_json(const map_grid& g) {
  json result{{"quantities", g.quantities}};
  for (const auto& [name, value] : axes_in(g)) {
    if (*value) result[name] = **value;
  }
  result["log"] = g.log;
  result["digits"] = g.digits;
  result["points"] = g.points();
  result["points_of_block"] = g.points_of_block;
  if (g.c) result["c"] = *g.c;
  if (g.cells) {
    result["cells"] = true;
    result["refine"] = g.refine;
    if (g.width) result["width"] = to_text(*g.width);
  }
  return result;
}

/// With n ranks rank 0 needs m seconds for a block and keeps up with them while a block takes n m
/// or more; and the last blocks leave ranks idle for less than a quarter of the time while there
/// are 4 n blocks or more. For P points of t seconds both hold up to the same n where a block takes
/// sqrt(P t m)/2. That follows from the map alone: shards and ranks have the same blocks.
std::size_t chosen_block(const map_grid& g) {
  constexpr double m = 1200;  // microseconds: a file is on the disk before the next block
  double t = 0;
  for (const quantity* q : g.chosen) t += q->microseconds;
  t *= 1 + static_cast<double>(g.digits) / 100;
  // Of a cell two corners are computed, and of its halves again; most cells are not halved as often
  // as they may be.
  if (g.cells) t *= 2 * std::exp2(static_cast<double>(g.refine) / 2);
  const auto points = std::sqrt(static_cast<double>(g.points()) * m / (4 * t));
  return static_cast<std::size_t>(
      std::clamp(points, 1.0, static_cast<double>(map_grid::most_points_of_block)));
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
    if (found->of_motion && !g.c && !g.chi) {
      throw usage_error(fmt::format("{} is that of a motion; give --c LO..HI/N, or --c C", name));
    }
  }
  if (g.c && !of_motion) {
    throw usage_error(fmt::format("--c: {} {} of a body and of no motion",
                                  fmt::join(g.quantities, ", "),
                                  g.quantities.size() == 1 ? "is that" : "are those"));
  }
  map_grid_impl::set_axes(g);
  if (g.c) g.c_values = map_grid_impl::axis("--c", *g.c, false);
  if (g.points() > map_grid_impl::most_points) {
    throw usage_error(fmt::format("a map of {} points: at most {} are possible", g.points(),
                                  map_grid_impl::most_points));
  }
  if (g.points_of_block == 0) g.points_of_block = map_grid_impl::chosen_block(g);
  return g;
}

std::optional<body> body_at(const map_grid& g, const rational& x, const rational& y) {
  if (!g.moments) return body(x, y);
  const std::array<rational, 3> moments = map_grid_impl::moments_at<rational>(g, x, y, g.fixed);
  if (moments[0] == moments[1] || moments[1] == moments[2] || moments[0] == moments[2]) {
    return std::nullopt;
  }
  return body::from_moments(moments);
}

std::optional<body_box> bodies_of_cell(const map_grid& g, const rational_range& x,
                                       const rational_range& y) {
  if (!g.moments) return body_box(x, y);
  std::array<rational_range, 3> moments =
      map_grid_impl::moments_at<rational_range>(g, x, y, {g.fixed, g.fixed});
  std::ranges::sort(moments, std::ranges::greater(), &rational_range::low);
  if (!(moments[0].low > moments[1].high && moments[1].low > moments[2].high)) return std::nullopt;
  return body_box::of_moments(moments);
}

std::string head_of(const map_grid& g) {
  return json_document_text("map", map_grid_impl::as_json(g));
}

std::optional<map_grid> read_head(const std::string& text) {
  try {
    const json head = json::parse(text);
    map_grid g;
    head.at("quantities").get_to(g.quantities);
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
    for (const auto& [name, value] : map_grid_impl::axes_in(g)) {
      if (head.contains(name)) *value = head.at(name).get<std::string>();
    }
    map_grid done = completed(g);
    if (head_of(done) == text) return done;
  } catch (const json::exception&) {
  } catch (const usage_error&) {
  } catch (const input_error&) {
  }
  return std::nullopt;
}

}  // namespace polhode::cli
