#include "path_option.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/output/errors.hpp"

namespace polhode::cli {
namespace {

path_point read_point(const std::string& text, const let_option& let) {
  const expression f = read_formula(text, {imaginary_unit}, let);
  if (f.exact_value()) return path_point(*f.exact_value());
  return path_point([f](precision p) { return f.evaluator<complex_ball>(p)(complex_ball::i(p)); });
}

}  // namespace

path read_polygon(const std::string& text, const let_option& let) {
  std::vector<path_point> points;
  std::map<std::string, path_point> known;  // the same text is the same point
  for (const std::string& part : parts_between_commas(text)) {
    const std::string key = without_margins(part);
    const auto found = known.find(key);
    points.push_back(found != known.end() ? found->second : read_point(part, let));
    known.emplace(key, points.back());
  }
  if (points.size() < 2) {
    throw usage_error(fmt::format(
        "--along {}: it must be two points or more, such as \"0, 1, 1+i\"", in_quotes(text)));
  }
  return path::polygon(points);
}

path read_circle(const std::string& text, const let_option& let) {
  const std::vector<std::string> parts = parts_between_commas(text);
  if (parts.size() != 2) {
    throw usage_error(fmt::format("--circle {}: it must be CENTRE, RADIUS, such as \"1+i, 1/2\"",
                                  in_quotes(text)));
  }
  const expression radius = read_formula(parts[1], {}, let);
  if (certainly_negative(radius.value(64))) {
    throw usage_error(fmt::format("--circle {}: the radius must not be negative", in_quotes(text)));
  }
  const end_point r = radius.exact_value()
                          ? end_point(*radius.exact_value())
                          : end_point([radius](precision p) { return radius.value(p); });
  return path::circle(read_point(parts[0], let), r);
}

}  // namespace polhode::cli
