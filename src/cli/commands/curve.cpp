// polhode curve: the curve C of the tennis racket effect, beside S.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/options/body_option.hpp"
#include "cli/options/count_option.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/motion_option.hpp"
#include "cli/options/options.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/gnuplot.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/curve_motions.hpp"
#include "polhode/rigid_body/motion.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"

namespace polhode::cli {
namespace curve_impl {
namespace {

struct curve_options {
  body_option which;
  count_option points{"--points", 200, 1, most_steps};
  std::optional<std::string> c;
  digits_option digits{"15"};
  format_option format{{"csv", "json", "svg"}};
  memory_limit_option memory_limit;
  time_limit_option time_limit;
};

struct point {
  rational c;
  ball epsilon;
  std::optional<ball> turning;  // epsilon of S up to pi/2, for c <= 0
};

std::optional<std::array<rational, 2>> range_of(const curve_options& options, const body& rigid) {
  if (!options.c) return std::nullopt;
  const motion_range range = read_motion_range(*options.c, rigid);
  return {{range.low, range.high}};
}

point point_at(const body& rigid, const rational& c, long digits) {
  const std::string at_c = " at c = " + to_text(c);
  point p{c, certain(defect_to_digits(rigid, c, digits), "epsilon" + at_c, digits), {}};
  if (c <= 0) {
    const exact_real u = motion(rigid, c).turning_point();
    const exact_real square = u / (1 - u);  // of the tangent
    const auto angle = [&](precision q) { return atan(sqrt(square.at(q))); };
    p.turning = certain(number_to_digits(angle, digits, ample_guard(digits)),
                        "the turning point" + at_c, digits);
  }
  return p;
}

std::vector<point> points_of(const body& rigid, const std::vector<rational>& motions, long digits,
                             const progress& line) {
  std::vector<point> result;
  result.reserve(motions.size());
  for (const rational& c : motions) {
    line.show_part("computing epsilon(c)", result.size(), motions.size());
    result.push_back(point_at(rigid, c, digits));
  }
  return result;
}

// ---------------------------------------------------------------------------------------------
// The formats

std::string as_csv(const std::vector<point>& points, long digits) {
  std::string result =
      csv_header("c") +
      ",epsilon,radius,lower,upper,digits,epsilon_of_s,epsilon_of_s_radius,remark\n";
  for (const point& p : points) {
    const decimal_enclosure d = to_decimal_enclosure(p.epsilon, digits);
    result += fmt::format("{},{},{},{},{},{},", csv_cells(p.c), d.value, d.radius, d.lower, d.upper,
                          d.digits);
    if (p.turning) {
      const decimal_enclosure s = to_decimal_enclosure(*p.turning, digits);
      result += fmt::format("{},{},\n", s.value, s.radius);
    } else {
      result += ",,no point of S at c > 0\n";
    }
  }
  return result;
}

std::string as_json(const body& rigid, const std::vector<point>& points, long digits) {
  json result{{"a", exact_json(rigid.a(), digits)},
              {"b", exact_json(rigid.b(), digits)},
              {"kind", to_text(rigid.kind())},
              {"verdict", to_text(status::certified)},
              {"points", json::array()}};
  for (const point& p : points) {
    json one{{"c", exact_json(p.c, digits)}, {"epsilon", to_json(p.epsilon, digits)}};
    if (p.turning) one["epsilon_of_s"] = to_json(*p.turning, digits);
    result["points"].push_back(std::move(one));
  }
  return json_document_text("curve", result);
}

std::string short_decimal(const exact_real& x) {
  constexpr long shown = 8;
  if (!x.is_rational()) return decimal_of(x, shown) + "...";
  return with_dots(leading_digits_of(x.exact(), shown));
}

std::string as_svg(const body& rigid, const std::vector<point>& points) {
  constexpr long drawn = 12;
  if (points.size() < 2) throw usage_error("--points 1: a picture needs at least 2");
  std::string program =
      "set terminal svg size 900,600 font 'Helvetica,15' background 'white'\n"
      "set xlabel 'c'\nset ylabel 'epsilon'\n"
      "set key outside top right\nset grid lc rgb '#dddddd'\n"
      "set xzeroaxis lt 1 lc rgb '#888888'\nset yzeroaxis lt 1 lc rgb '#888888'\n"
      "set ytics ('-pi' -pi, '-pi/2' -pi/2, '0' 0, 'pi/4' pi/4, 'pi/2' pi/2, '3pi/4' 3*pi/4, 'pi' "
      "pi)\n";
  program += fmt::format("set xrange [{}:{}]\n", leading_digits_of(points.front().c, drawn).value,
                         leading_digits_of(points.back().c, drawn).value);
  program += fmt::format("set title 'a = {}, b = {}: {}'\n", short_decimal(rigid.a()),
                         short_decimal(rigid.b()), to_text(rigid.kind()));
  const auto decimals = [](const ball& x) { return to_decimal_enclosure(x, drawn).value; };
  program += "$curve << EOD\n";
  for (const point& p : points) {
    program += fmt::format("{} {}\n", leading_digits_of(p.c, drawn).value, decimals(p.epsilon));
  }
  program += "EOD\n$turning << EOD\n";
  for (const point& p : points) {
    if (p.turning)
      program += fmt::format("{} {}\n", leading_digits_of(p.c, drawn).value, decimals(*p.turning));
  }
  program += "EOD\n";
  const bool oscillates = points.front().c <= 0;
  program += "plot $curve with lines lw 2 lc rgb '#20406a' title 'C'";
  if (oscillates)
    program +=
        ", $turning with lines lw 2 dt 2 lc rgb '#b03020' title 'S'"
        ", $turning using 1:(pi-$2) with lines lw 2 dt 2 lc rgb '#b03020' notitle";
  return run_gnuplot(program + '\n');
}

exit_status run(const curve_options& options) {
  const long digits = options.digits.value();
  const long points = options.points.value();
  const std::string& format = options.format.value();
  const body rigid = options.which.value();
  const std::vector<rational> motions = curve_motions(rigid, range_of(options, rigid), points);
  constexpr double bytes_per_digit = 60;
  constexpr double bytes_kept = 20;
  const std::string what = fmt::format("{} points of {} digits", points, digits);
  options.memory_limit.check({what, (bytes_per_digit + bytes_kept * static_cast<double>(points)) *
                                        static_cast<double>(digits)});
  const std::vector<point> curve = [&] {
    const progress line;
    line.show("estimating");
    const rational& middle = motions[motions.size() / 2];
    line.expect(options.time_limit.check(
        what, digits, {[&](long fewer) { (void)point_at(rigid, middle, fewer); }},
        static_cast<double>(points)));
    const time_watch watch(options.time_limit.limit(static_cast<double>(points)));
    return points_of(rigid, motions, digits, line);
  }();
  print(format == "csv"
            ? as_csv(curve, digits)
            : (format == "json" ? as_json(rigid, curve, digits) : as_svg(rigid, curve)));
  return exit_status::all_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<curve_options>();
  options->which.declare(app);
  options->points.declare(app, "How many points: the middles of as many equal parts of the range");
  add_option(app, "--c", options->c,
             "The range of c, within -b to a [-b to b, or to a where that is less]")
      .type_name("LO..HI");
  options->digits.declare(app);
  options->format.declare(app);
  options->memory_limit.declare(app);
  options->time_limit.declare(app);
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace curve_impl

command curve_command() {
  return {
      "curve", "Follow the curve C of the tennis racket effect, epsilon(c), beside S",
      "  polhode curve --ab 12.65,0.0629\n"
      "  polhode curve --ab 18.27,0.0629 --points 1000 --format svg > curve.svg\n"
      "  polhode curve --moments 3,2,1 --c -0.1..0.1 --format json\n\n"
      "Every epsilon is certified. S is the curve of the turning points, c = -b sin^2 epsilon,\n"
      "where c <= 0. gnuplot draws the picture.\n",
      curve_impl::declare};
}

}  // namespace polhode::cli
