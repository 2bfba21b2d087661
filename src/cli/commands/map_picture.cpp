#include "map_picture.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cli/output/gnuplot.hpp"

namespace polhode::cli {
namespace map_picture_impl {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

std::string number_of(double x) { return std::isfinite(x) ? fmt::format("{:.9g}", x) : "NaN"; }

/// A curve by its points; pairs of NaN where it is not on the map.
struct curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

/// So many numbers from one end to the other, on the scale of the axis.
std::vector<double> along(double low, double high, bool log) {
  constexpr int steps = 500;
  std::vector<double> result;
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    result.push_back(log ? std::exp((1 - t) * std::log(low) + t * std::log(high))
                         : (1 - t) * low + t * high);
  }
  return result;
}

bool is_between(double x, const std::vector<double>& axis) {
  return x >= axis.front() && x <= axis.back();
}

/// The powers of ten on an axis, on a short one 2 and 5 times them too, as gnuplot's list of tics.
std::string tics_on(const std::vector<double>& axis) {
  std::string result;
  const int first = static_cast<int>(std::floor(std::log10(axis.front())));
  const int last = static_cast<int>(std::ceil(std::log10(axis.back())));
  constexpr int most_decades = 4;
  for (int k = first; k <= last; ++k) {
    for (const int digit : {1, 2, 5}) {
      if (digit > 1 && last - first > most_decades) break;
      const double x = digit * std::pow(10.0, k);
      if (!is_between(x, axis)) continue;
      const std::string label =
          std::abs(k) > 3 ? fmt::format("{}e{}", digit, k) : fmt::format("{:g}", x);
      result += fmt::format("{}'{}' {}", result.empty() ? "" : ", ", label, number_of(x));
    }
  }
  return result;
}

/// I = q is (q^2 - 1) b^2 + (q^2 a + 2) b = 1, and J = q with p = (q + 1)^2 is (p - 1) a^2 + (p b -
/// 2) a = 1: each has one positive root.
std::vector<curve> curves_over(const map_values& map) {
  std::vector<curve> result;
  const auto add = [&](std::string name, const std::vector<std::pair<double, double>>& points) {
    curve one{std::move(name), {}};
    bool is_seen = false;
    for (const auto& [a, b] : points) {
      const bool is_on_map = is_between(a, map.x) && is_between(b, map.y);
      is_seen = is_seen || is_on_map;
      one.points.emplace_back(is_on_map ? a : no_number, is_on_map ? b : no_number);
    }
    if (is_seen) result.push_back(std::move(one));
  };
  if (map.plane == map_plane::limit) return result;
  if (map.plane == map_plane::moments) {
    const double third = map.third_moment;
    std::vector<std::pair<double, double>> planar;
    // One moment is the sum of the others.
    for (const double slope : {-1.0, 1.0}) {
      for (const double sum : {-third, third}) {
        if (slope < 0 && sum < 0) continue;
        for (const double x : along(map.x.front(), map.x.back(), map.log))
          planar.emplace_back(x, slope * x + sum);
        planar.emplace_back(no_number, no_number);
      }
    }
    add("planar", planar);
    return result;
  }
  // Of x^2 square + x linear = 1.
  const auto positive_root = [](double square, double linear) {
    return 2 / (linear + std::sqrt(linear * linear + 4 * square));
  };
  const auto defect = [&](const std::string& name, double q) {
    std::vector<std::pair<double, double>> points;
    for (const double a : along(map.x.front(), map.x.back(), map.log))
      points.emplace_back(a, positive_root(q * q - 1, q * q * a + 2));
    add("I = " + name, points);
  };
  defect("2", 2);
  defect("1", 1);
  constexpr int most = 6;
  for (int n = 1; n < most; ++n) defect(fmt::format("2/{}", 2 * n + 1), 2.0 / (2 * n + 1));
  for (const double q : {1.0, 2.0}) {
    std::vector<std::pair<double, double>> points;
    const double p = (q + 1) * (q + 1);
    for (const double b : along(map.y.front(), map.y.back(), map.log))
      points.emplace_back(positive_root(p - 1, p * b - 2), b);
    add(fmt::format("J = {}", q), points);
  }
  return result;
}

/// The values at points, as a block of gnuplot's data.
std::string data_of_points(const map_values& map) {
  std::string result = "$map << EOD\n";
  for (std::size_t i = 0; i < map.x.size(); ++i) {
    for (std::size_t k = 0; k < map.y.size(); ++k) {
      result += fmt::format("{} {} {}\n", number_of(map.x[i]), number_of(map.y[k]),
                            number_of(map.values[i * map.y.size() + k]));
    }
    result += '\n';
  }
  return result + "EOD\n";
}

/// Counts of more than this many are drawn by the logarithm of 1 + N.
constexpr double most_in_equal_steps = 20;

/// The tiles that have a value as $map, the undecided ones as $undecided.
std::string data_of_tiles(const map_values& map, bool by_logarithm) {
  std::string known = "$map << EOD\n";
  std::string undecided = "$undecided << EOD\n";
  for (const map_tile& t : map.tiles) {
    const std::string box =
        fmt::format("{0} {2} {0} {1} {2} {3}", number_of(t.x_low), number_of(t.x_high),
                    number_of(t.y_low), number_of(t.y_high));
    if (t.is_undecided) {
      undecided += box + '\n';
    } else if (t.value) {
      known +=
          fmt::format("{} {}\n", box, number_of(by_logarithm ? std::log1p(*t.value) : *t.value));
    }
  }
  return known + "EOD\n" + undecided + "EOD\n";
}

/// 0 and 1, 2, 5 times the powers of ten, at log(1 + N).
std::string tics_of_counts(double most) {
  std::string result = "'0' 0";
  for (double power = 1; power <= most; power *= 10) {
    for (const int digit : {1, 2, 5}) {
      const double n = digit * power;
      if (n <= most) result += fmt::format(", '{:g}' {}", n, number_of(std::log1p(n)));
    }
  }
  return result;
}

/// The colours, axes, legend and margins.
std::string frame_of(const map_values& map) {
  const bool has_unit = map.quantity.starts_with("epsilon");
  return fmt::format(
      "set xlabel '{7}'\nset ylabel '{8}'\n"
      "set cblabel '{0}{1}'\nset title '{0} {9}'\n"
      "set xrange [{2}:{3}]\nset yrange [{4}:{5}]\nset tics out nomirror\n"
      "set lmargin at screen 0.12\nset rmargin at screen 0.82\nset bmargin at screen 0.24\n"
      "set tmargin at screen 0.92\n"
      "set key at screen 0.5, 0.06 center horizontal maxrows 2\n{6}"
      "set palette defined (0 '#fff7ec', 1 '#fdbb84', 2 '#d7301f', 3 '#67001f')\n",
      map.quantity, has_unit ? " [rad]" : "", number_of(map.x.front()), number_of(map.x.back()),
      number_of(map.y.front()), number_of(map.y.back()),
      map.log ? fmt::format("set logscale xy\nset xtics ({})\nset ytics ({})\n", tics_on(map.x),
                            tics_on(map.y))
              : "",
      map.x_title, map.y_title,
      map.plane == map_plane::moments
          ? fmt::format("over two moments, the third is {:g}", map.third_moment)
      : map.plane == map_plane::limit ? "in the limit of slender bodies"
                                      : "over the plane of bodies");
}

/// Whether they are integers, and the greatest of them; of those that are finite.
struct drawn_values {
  bool are_counts = true;
  double most = 0;
};
drawn_values drawn_values_of(const map_values& map) {
  drawn_values result;
  const auto add = [&](double x) {
    if (!std::isfinite(x)) return;
    result.are_counts = result.are_counts && x == std::floor(x);
    result.most = std::max(result.most, x);
  };
  std::ranges::for_each(map.values, add);
  for (const map_tile& t : map.tiles) add(t.value.value_or(no_number));
  return result;
}

/// The points or tiles, as the first things that gnuplot plots.
std::string layers_of(const map_values& map, bool are_counts) {
  if (map.tiles.empty()) {
    return fmt::format(
        "set view map\nset pm3d map corners2color {}\nsplot $map using 1:2:3 with pm3d notitle",
        are_counts ? "c1" : "mean");
  }
  std::string result = "plot NaN notitle";  // gnuplot does not draw an empty block
  if (std::ranges::any_of(map.tiles, [](const map_tile& t) { return t.value.has_value(); })) {
    result += ", $map using 1:2:3:4:5:6:7 with boxxyerror lc palette fs solid noborder notitle";
  }
  if (std::ranges::any_of(map.tiles, &map_tile::is_undecided)) {
    result +=
        ", $undecided using 1:2:3:4:5:6 with boxxyerror lc rgb '#b8c4d0' fs solid noborder "
        "title 'undecided'";
  }
  return result;
}

}  // namespace
}  // namespace map_picture_impl

std::string map_picture(const map_values& map, const std::string& format) {
  using namespace map_picture_impl;
  const std::vector<curve> curves = curves_over(map);
  const bool has_tiles = !map.tiles.empty();
  const drawn_values values = drawn_values_of(map);
  const bool by_logarithm = has_tiles && values.are_counts && values.most > most_in_equal_steps;
  std::string program =
      format == "svg" ? "set terminal svg size 900,700 font 'Helvetica,15' background 'white'\n"
                      : "set terminal pngcairo size 1350,1050 font 'Sans,16' linewidth 1.5\n";
  program += has_tiles ? data_of_tiles(map, by_logarithm) : data_of_points(map);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    program += fmt::format("$curve{} << EOD\n", i);
    for (const auto& [a, b] : curves[i].points)
      program += std::isnan(a) ? "\n" : fmt::format("{} {} 0\n", number_of(a), number_of(b));
    program += "EOD\n";
  }
  program += frame_of(map);
  if (by_logarithm) {
    program += fmt::format("set cbrange [0:{}]\nset cbtics ({})\n",
                           number_of(std::log1p(values.most)), tics_of_counts(values.most));
  }
  program += layers_of(map, values.are_counts);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const bool is_rotating = curves[i].name.front() == 'J';
    const std::string colour = is_rotating ? "rgb 'black'" : fmt::format("{}", i + 1);
    program += fmt::format(", $curve{} using {} with lines lw 2 lc {} dt {} title '{}'", i,
                           has_tiles ? "1:2" : "1:2:3", colour, i % 4 + 1, curves[i].name);
  }
  return run_gnuplot(program + '\n', "give --format csv");
}

}  // namespace polhode::cli
