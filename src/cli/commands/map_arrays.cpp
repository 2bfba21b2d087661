#include "map_arrays.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/modules/hdf5_file.hpp"
#include "cli/modules/module.hpp"
#include "cli/output/errors.hpp"
#include "map_rows.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/version.hpp"

namespace polhode::cli {
namespace map_arrays_impl {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A double that is at most x, and next to it.
double rounded_down(const rational& x) {
  auto result = static_cast<double>(x);
  if (result == infinity) return std::numeric_limits<double>::max();
  while (result != -infinity && rational(result) > x) result = std::nextafter(result, -infinity);
  return result;
}
double rounded_up(const rational& x) { return -rounded_down(-x); }

/// An end of a cell or of a range, rounded outwards: of "undecided" and the empty column behind it
/// -infinity and infinity, of "none" NaN. `before` is the number of the column before.
double end_as_double(const std::string& text, double before, bool up) {
  if (text == "none") return nan;
  if (text == "undecided") return -infinity;
  if (text.empty()) return before == -infinity ? infinity : nan;
  const rational exact = parse_rational(text);
  return up ? rounded_up(exact) : rounded_down(exact);
}

/// The middle of value ± radius as a double, and a double that is at least the distance of every
/// number in it from that: infinity where the number is undecided, NaN where there is none.
std::pair<double, double> as_doubles(std::string_view value, std::string_view radius) {
  if (value == "inf") return {infinity, 0};
  if (value == "none") return {nan, nan};
  if (value == "undecided") return {nan, infinity};
  const rational exact = parse_rational(std::string(value));
  const auto middle = static_cast<double>(exact);
  if (!std::isfinite(middle)) return {middle, infinity};
  const rational distance = abs(exact - rational(middle)) + parse_rational(std::string(radius));
  return {middle, rounded_up(distance)};
}

/// The text between the commas of each row.
template <class Each>
void for_each_row(const std::string& rows, const Each& each) {
  std::vector<std::string_view> texts;
  for (std::size_t at = 0; at < rows.size();) {
    const std::size_t end = rows.find('\n', at);
    texts.clear();
    for (std::size_t from = at; from <= end;) {
      const std::size_t to = std::min(rows.find(',', from), end);
      texts.push_back(std::string_view(rows).substr(from, to - from));
      from = to + 1;
    }
    each(texts);
    at = end + 1;
  }
}

/// A column of a map of cells.
struct map_column {
  std::string name;
  std::string unit;
  std::vector<double> numbers;
};

std::vector<map_column> columns_of_cells(const map_grid& g, const std::string& rows) {
  std::vector<map_column> result;
  std::vector<std::size_t> places;  // in a row, where each end has an exact column too
  std::vector<bool> up;
  const auto add = [&](const std::string& name, const std::string& unit, std::size_t place,
                       bool rounds_up) {
    result.push_back({name, unit, {}});
    places.push_back(place);
    up.push_back(rounds_up);
  };
  std::size_t place = 0;
  for (const std::string& axis : {g.first.name, g.second.name, std::string("c")}) {
    if (axis == "c" && !g.c) continue;
    // The exact one of two columns, rounded into the cell.
    add(fmt::format("{}_low", axis), "1", place + 1, true);
    add(fmt::format("{}_high", axis), "1", place + 3, false);
    place += 4;
  }
  for (const quantity* q : g.chosen) {
    add(q->name + "_lower", q->unit, place++, false);
    add(q->name + "_upper", q->unit, place++, true);
  }
  for_each_row(rows, [&](const std::vector<std::string_view>& texts) {
    for (std::size_t k = 0; k < result.size(); ++k) {
      const std::string text(texts.at(places[k]));
      result[k].numbers.push_back(
          end_as_double(text, k > 0 ? result[k - 1].numbers.back() : nan, up[k]));
    }
  });
  return result;
}

/// The bytes of NumPy's format 1.0.
std::string npy_of(const std::string& shape, const std::vector<double>& numbers) {
  static_assert(std::endian::native == std::endian::little);
  std::string head =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}), }}", shape);
  constexpr std::size_t magic = 10;  // bytes before it, of which two are its length
  while ((magic + head.size() + 1) % 64 != 0) head += ' ';
  head += '\n';
  std::string result("\x93NUMPY\x01\x00", 8);
  result += static_cast<char>(head.size() % 256);
  result += static_cast<char>(head.size() / 256);
  result += head;
  const std::size_t text = result.size();
  result.resize(text + numbers.size() * sizeof(double));
  std::memcpy(result.data() + text, numbers.data(), numbers.size() * sizeof(double));
  return result;
}

hdf5_file file_of_points(const map_grid& g, const std::string& rows) {
  hdf5_file file;
  std::vector<std::size_t> shape;
  const auto add_axis = [&](const std::string& name, const std::vector<rational>& values) {
    hdf5_dataset near{name, {values.size()}, {}, {}, {{"unit", "1"}}};
    hdf5_dataset exact{name + "_exact", {values.size()}, {}, {}, {{"unit", "1"}}};
    for (const rational& x : values) {
      near.numbers.push_back(static_cast<double>(x));
      exact.texts.push_back(to_text(x));
    }
    file.datasets.push_back(std::move(near));
    file.datasets.push_back(std::move(exact));
    shape.push_back(values.size());
  };
  add_axis(g.first.name, g.first.values);
  add_axis(g.second.name, g.second.values);
  if (g.c) add_axis("c", g.c_values);
  const std::vector<double> numbers = map_numbers(g, rows);
  const auto points = static_cast<std::ptrdiff_t>(g.points());
  auto next = numbers.begin();
  for (const quantity* q : g.chosen) {
    const std::string axes = fmt::format("{}, {}{}", g.first.name, g.second.name, g.c ? ", c" : "");
    for (const char* of : {"", "_radius"}) {
      const std::string what = *of == '\0' ? "" : "greatest distance from the value of the ";
      file.datasets.push_back(
          {q->name + of,
           shape,
           {next, next + points},
           {},
           {{"unit", q->unit}, {"description", what + q->description}, {"axes", axes}}});
      next += points;
    }
  }
  return file;
}

}  // namespace
}  // namespace map_arrays_impl

std::vector<double> map_numbers(const map_grid& g, const std::string& rows) {
  const std::size_t columns = 2 * g.chosen.size();
  const std::size_t before = g.c ? 6 : 4;
  const std::size_t points = g.points();
  std::vector<double> numbers(columns * points);
  std::size_t point = 0;
  map_arrays_impl::for_each_row(rows, [&](const std::vector<std::string_view>& texts) {
    for (std::size_t k = 0; k < columns; k += 2) {
      const auto [value, radius] =
          map_arrays_impl::as_doubles(texts.at(before + k), texts.at(before + k + 1));
      numbers[k * points + point] = value;
      numbers[(k + 1) * points + point] = radius;
    }
    ++point;
  });
  return numbers;
}

std::string map_npy(const map_grid& g, const std::string& rows) {
  if (!g.cells) {
    std::string shape = fmt::format("{}, 2, {}, {}", g.chosen.size(), g.first.values.size(),
                                    g.second.values.size());
    if (g.c) shape += fmt::format(", {}", g.c_values.size());
    return map_arrays_impl::npy_of(shape, map_numbers(g, rows));
  }
  const std::vector<map_arrays_impl::map_column> columns =
      map_arrays_impl::columns_of_cells(g, rows);
  const std::size_t cells = columns.front().numbers.size();
  std::vector<double> numbers;
  numbers.reserve(cells * columns.size());
  for (std::size_t i = 0; i < cells; ++i) {
    for (const map_arrays_impl::map_column& one : columns) numbers.push_back(one.numbers[i]);
  }
  return map_arrays_impl::npy_of(fmt::format("{}, {}", cells, columns.size()), numbers);
}

std::string map_hdf5(const map_grid& g, const std::string& rows) {
  using maker = void (*)(const hdf5_file&, std::string&);
  const auto make = reinterpret_cast<maker>(function_of_module("hdf5", "polhode_hdf5_bytes"));
  if (make == nullptr) {
    throw usage_error(
        "--format hdf5: polhode was built without HDF5; install libhdf5-dev and build it again, or "
        "give --format npy");
  }
  hdf5_file file;
  if (g.cells) {
    for (map_arrays_impl::map_column& one : map_arrays_impl::columns_of_cells(g, rows)) {
      file.datasets.push_back(
          {one.name, {one.numbers.size()}, std::move(one.numbers), {}, {{"unit", one.unit}}});
    }
  } else {
    file = map_arrays_impl::file_of_points(g, rows);
  }
  file.attributes = {{"polhode", POLHODE_VERSION}, {"map", head_of(g)}};
  std::string bytes;
  make(file, bytes);
  return bytes;
}

}  // namespace polhode::cli
