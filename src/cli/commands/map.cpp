// polhode map and merge: quantities over a grid of bodies, in blocks that may be computed anywhere.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/sha256.hpp"
#include "base/worker_threads.hpp"
#include "cli/commands.hpp"
#include "cli/options/body_option.hpp"
#include "cli/options/count_option.hpp"
#include "cli/options/motion_option.hpp"
#include "cli/options/options.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/output_directory.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "map_picture.hpp"
#include "polhode/arithmetic/text.hpp"
#include "quantities.hpp"

namespace polhode::cli {
namespace map_impl {
namespace {

// ---------------------------------------------------------------------------------------------
// The grid

constexpr std::size_t points_of_block = 1000;
constexpr std::size_t most_points = 100'000'000;
const std::string head_name = "map.json";

/// The same numbers as `polhode map` was given, and what is computed at each point.
struct grid {
  std::vector<std::string> quantities;
  std::string a, b;
  std::optional<std::string> c;
  bool log = false;
  long digits = 15;
  bool cells = false;             // ranges over the cells between the values, in place of points
  long refine = 0;                // how often a cell is halved at most
  std::optional<rational> width;  // of a range that is narrow enough
  // Made of these:
  std::vector<rational> a_values, b_values, c_values;
  std::vector<const quantity*> chosen;

  [[nodiscard]] std::size_t points() const {
    return count_along(a_values) * count_along(b_values) * motions();
  }
  [[nodiscard]] std::size_t motions() const { return c_values.empty() ? 1 : count_along(c_values); }
  /// Points, or cells, along an axis with these values; a single value is a cell.
  [[nodiscard]] std::size_t count_along(const std::vector<rational>& values) const {
    return cells ? std::max<std::size_t>(values.size() - 1, 1) : values.size();
  }
  [[nodiscard]] std::size_t blocks() const {
    return (points() + points_of_block - 1) / points_of_block;
  }
};

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

/// Reads what the command was given; throws usage_error.
grid completed(grid g) {
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
  g.a_values = axis("--a", g.a, g.log);
  g.b_values = axis("--b", g.b, g.log);
  if (g.c) g.c_values = axis("--c", *g.c, false);
  for (const rational& a : {g.a_values.front(), g.a_values.back()}) {
    if (!(a > 0)) throw usage_error(fmt::format("--a {}: a must be above 0", in_quotes(g.a)));
  }
  for (const rational& b : {g.b_values.front(), g.b_values.back()}) {
    if (!(b > 0 && b < 1)) {
      throw usage_error(fmt::format("--b {}: b must be between 0 and 1", in_quotes(g.b)));
    }
  }
  if (g.points() > most_points) {
    throw usage_error(
        fmt::format("a map of {} points: at most {} are possible", g.points(), most_points));
  }
  return g;
}

json as_json(const grid& g) {
  json result{{"quantities", g.quantities},
              {"a", g.a},
              {"b", g.b},
              {"log", g.log},
              {"digits", g.digits},
              {"points", g.points()},
              {"points_of_block", points_of_block}};
  if (g.c) result["c"] = *g.c;
  if (g.cells) {
    result["cells"] = true;
    result["refine"] = g.refine;
    if (g.width) result["width"] = to_text(*g.width);
  }
  return result;
}
std::string head_of(const grid& g) { return json_document_text("map", as_json(g)); }

// ---------------------------------------------------------------------------------------------
// Points

std::string header_of(const grid& g) {
  if (g.cells) {
    std::string result = csv_header("a_low") + ',' + csv_header("a_high") + ',' +
                         csv_header("b_low") + ',' + csv_header("b_high");
    if (g.c) result += ',' + csv_header("c_low") + ',' + csv_header("c_high");
    for (const std::string& name : g.quantities) {
      result += fmt::format(",{0}_lower,{0}_upper", name);
    }
    return result + '\n';
  }
  std::string result = csv_header("a") + ',' + csv_header("b");
  if (g.c) result += ',' + csv_header("c");
  for (const std::string& name : g.quantities) result += fmt::format(",{0},{0}_radius", name);
  return result + '\n';
}

/// A value and its radius; "none" and nothing where the quantity does not exist, "undecided" and
/// nothing where it is not certified.
std::string cells_of(const quantity& q, const body& rigid, const std::optional<rational>& c,
                     long digits) {
  const rational at = q.of_motion ? *c : rational(0);
  try {
    if (q.of_motion) (void)regime_of(rigid, at);
    q.check(rigid, at);
  } catch (const input_error&) {
    return "none,";
  } catch (const usage_error&) {
    return "none,";
  }
  if (at == 0 && q.infinite_at_0) return "inf,0";
  const certain_number found = q.compute(rigid, at, digits);
  if (found.verdict != status::certified) return "undecided,";
  const decimal_enclosure d = to_decimal_enclosure(found.enclosure, digits);
  return d.value + ',' + d.radius;
}

// Cells

rational_range cell_along(const std::vector<rational>& values, std::size_t k) {
  return {values[k], values[std::min(k + 1, values.size() - 1)]};
}

/// Between the ends; of a logarithmic axis near the geometric mean.
rational middle_of(const rational_range& range, bool log) {
  if (log) {
    const double mean =
        std::sqrt(static_cast<double>(range.low)) * std::sqrt(static_cast<double>(range.high));
    rational near = parse_rational(fmt::format("{:.9e}", mean));
    if (range.low < near && near < range.high) return near;
  }
  return (range.low + range.high) / 2;
}

struct map_cell {
  rational_range a, b, c;
};

/// The two columns of a quantity over a cell, and whether they are what was asked for.
struct range_cells {
  std::string text;
  bool is_done = true;
};
range_cells range_of(const grid& g, const quantity& q, const map_cell& cell) {
  const std::optional<ball> range = q.range({cell.a, cell.b}, cell.c, g.digits);
  if (!range) return {"none,"};
  if (!range->is_bounded()) return {"undecided,", false};
  if (q.is_whole) {
    const integer low = floor_of(lower_rational(*range));
    const integer high = floor_of(upper_rational(*range));
    return {low.str() + ',' + high.str(), low == high};
  }
  const decimal_enclosure d = to_decimal_enclosure(*range, g.digits);
  return {d.lower + ',' + d.upper,
          !g.width || parse_rational(d.upper) - parse_rational(d.lower) <= *g.width};
}

/// The rows of a cell, or of its halves where that is not decided, or a range too wide: halved in a
/// and b by turns.
std::string rows_of_cell(const grid& g, const map_cell& cell, long halvings) {
  std::string columns;
  bool is_done = true;
  for (const quantity* q : g.chosen) {
    const range_cells one = range_of(g, *q, cell);
    columns += ',' + one.text;
    is_done = is_done && one.is_done;
  }
  const bool a_is_thin = cell.a.low == cell.a.high;
  const bool b_is_thin = cell.b.low == cell.b.high;
  if (!is_done && halvings < g.refine && !(a_is_thin && b_is_thin)) {
    const bool in_a = b_is_thin || (!a_is_thin && halvings % 2 == 0);
    map_cell low = cell;
    map_cell high = cell;
    rational_range map_cell::*const halved = in_a ? &map_cell::a : &map_cell::b;
    (low.*halved).high = (high.*halved).low = middle_of(cell.*halved, g.log);
    return rows_of_cell(g, low, halvings + 1) + rows_of_cell(g, high, halvings + 1);
  }
  std::string result;
  for (const rational_range* range : {&cell.a, &cell.b, &cell.c}) {
    if (range == &cell.c && !g.c) continue;
    result += csv_cells(range->low) + ',' + csv_cells(range->high) + ',';
  }
  result.pop_back();
  return result + columns + '\n';
}

// ---------------------------------------------------------------------------------------------

/// The row of a point, or the rows of a cell.
std::string row_of(const grid& g, std::size_t index) {
  const std::size_t motions = g.motions();
  if (g.cells) {
    const std::size_t along_b = g.count_along(g.b_values);
    map_cell cell{cell_along(g.a_values, index / motions / along_b),
                  cell_along(g.b_values, index / motions % along_b),
                  {}};
    if (g.c) cell.c = cell_along(g.c_values, index % motions);
    return rows_of_cell(g, cell, 0);
  }
  const rational& a = g.a_values[index / motions / g.b_values.size()];
  const rational& b = g.b_values[index / motions % g.b_values.size()];
  std::optional<rational> c;
  if (g.c) c = g.c_values[index % motions];
  const body rigid = body(a, b);
  std::string result = csv_cells(a) + ',' + csv_cells(b);
  if (c) result += ',' + csv_cells(*c);
  for (const quantity* q : g.chosen) result += ',' + cells_of(*q, rigid, c, g.digits);
  return result + '\n';
}

/// The rows of a block, whatever the threads.
std::string rows_of_block(const grid& g, std::size_t block, detail::worker_threads& threads) {
  const std::size_t first = block * points_of_block;
  const std::size_t count = std::min(points_of_block, g.points() - first);
  std::vector<std::string> rows(count);
  threads.for_each(static_cast<long>(count), [&](long i) {
    const auto k = static_cast<std::size_t>(i);
    rows[k] = row_of(g, first + k);
  });
  std::string result;
  for (const std::string& row : rows) result += row;
  return result;
}

// ---------------------------------------------------------------------------------------------
// Blocks in a directory

/// A directory with map.json, which says of what map it is, and a file for each block that is done.
/// A file ends with its SHA-256 digest: one that was not written whole is computed again.
class block_directory {
 public:
  explicit block_directory(std::string path) : path_(std::move(path)) {}

  /// The map that the blocks in it are of; throws usage_error where there is none.
  [[nodiscard]] grid read_head() const {
    const auto text = read(head_name);
    const std::string give = ": give a directory that polhode map --blocks has made";
    if (!text) throw usage_error(fmt::format("{} has no {}{}", in_quotes(path_), head_name, give));
    try {
      const json head = json::parse(*text);
      grid g;
      head.at("quantities").get_to(g.quantities);
      head.at("a").get_to(g.a);
      head.at("b").get_to(g.b);
      head.at("log").get_to(g.log);
      head.at("digits").get_to(g.digits);
      if (head.contains("cells")) {
        g.cells = true;
        head.at("refine").get_to(g.refine);
        if (head.contains("width")) g.width = parse_rational(head.at("width").get<std::string>());
      }
      if (head.contains("c")) g.c = head.at("c").get<std::string>();
      grid done = completed(g);
      if (head_of(done) == *text) return done;
    } catch (const json::exception&) {
    } catch (const usage_error&) {
    }
    throw usage_error(fmt::format("{} in {} is not as this version of polhode writes it{}",
                                  head_name, in_quotes(path_), give));
  }
  /// Makes it the directory of this map; throws usage_error where it is that of another one.
  void begin(const grid& g) const {
    const auto known = read(head_name);
    if (!known) {
      write(head_name, head_of(g));
    } else if (*known != head_of(g)) {
      throw usage_error(
          fmt::format("--blocks {}: it has blocks of another map (its {} says which); give another "
                      "directory, or the same command",
                      in_quotes(path_), head_name));
    }
  }
  void write_block(std::size_t block, const std::string& rows) const {
    write(name_of(block), rows + "sha256," + digest_of(block, rows) + '\n');
  }
  /// Its rows, where it is there and whole.
  [[nodiscard]] std::optional<std::string> rows_of(std::size_t block) const {
    std::optional<std::string> text = read(name_of(block));
    if (!text) return std::nullopt;
    const std::size_t at = text->rfind("sha256,");
    if (at == std::string::npos) return std::nullopt;
    const std::string rows = text->substr(0, at);
    if (text->substr(at) != "sha256," + digest_of(block, rows) + '\n') return std::nullopt;
    return rows;
  }

 private:
  static std::string name_of(std::size_t block) { return fmt::format("block-{:06}.csv", block); }
  static std::string digest_of(std::size_t block, const std::string& rows) {
    const std::string all = name_of(block) + '\n' + rows;
    std::string result;
    for (const std::uint8_t byte : sha256(std::as_bytes(std::span(all)))) {
      result += fmt::format("{:02x}", byte);
    }
    return result;
  }
  [[nodiscard]] std::optional<std::string> read(const std::string& name) const {
    std::ifstream file(std::filesystem::path(path_) / name, std::ios::binary);
    if (!file) return std::nullopt;
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    return file.bad() ? std::nullopt : std::optional(std::move(text));
  }
  /// Whole or not at all, whoever else writes it.
  void write(const std::string& name, const std::string& text) const {
    output_directory directory(path_, {name}, "--blocks");
    directory.write(name, text);
    directory.publish();
  }

  std::string path_;
};

// ---------------------------------------------------------------------------------------------
// The whole map

/// The middle of value ± radius as a double, and a double that is at least the distance of every
/// number in it from that.
std::pair<double, double> as_doubles(std::string_view value, std::string_view radius) {
  if (value == "inf") return {std::numeric_limits<double>::infinity(), 0};
  if (value == "none" || value == "undecided") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  const rational exact = parse_rational(std::string(value));
  const auto middle = static_cast<double>(exact);
  if (!std::isfinite(middle)) return {middle, std::numeric_limits<double>::infinity()};
  const rational distance = abs(exact - rational(middle)) + parse_rational(std::string(radius));
  auto bound = static_cast<double>(distance);
  while (std::isfinite(bound) && rational(bound) < distance) {
    bound = std::nextafter(bound, std::numeric_limits<double>::infinity());
  }
  return {middle, bound};
}

/// The numbers of the rows: [quantity][0: value, 1: radius][point].
std::vector<double> numbers_of(const grid& g, const std::string& rows) {
  const std::size_t columns = 2 * g.chosen.size();
  const std::size_t before = g.c ? 6 : 4;
  const std::size_t points = g.points();
  std::vector<double> numbers(columns * points);
  std::size_t at = 0;
  for (std::size_t point = 0; point < points; ++point) {
    const std::size_t end = rows.find('\n', at);
    std::vector<std::string_view> cells;
    for (std::size_t from = at; from <= end;) {
      const std::size_t to = std::min(rows.find(',', from), end);
      cells.push_back(std::string_view(rows).substr(from, to - from));
      from = to + 1;
    }
    for (std::size_t k = 0; k < columns; k += 2) {
      const auto [value, radius] = as_doubles(cells.at(before + k), cells.at(before + k + 1));
      numbers[k * points + point] = value;
      numbers[(k + 1) * points + point] = radius;
    }
    at = end + 1;
  }
  return numbers;
}

/// NumPy's format 1.0: doubles [quantity][0: value, 1: radius][a][b] and, for motions, [c].
std::string as_npy(const grid& g, const std::string& rows) {
  static_assert(std::endian::native == std::endian::little);
  const std::vector<double> numbers = numbers_of(g, rows);
  std::string shape =
      fmt::format("{}, 2, {}, {}", g.chosen.size(), g.a_values.size(), g.b_values.size());
  if (g.c) shape += fmt::format(", {}", g.c_values.size());
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

bool is_picture(const std::string& format) { return format == "svg" || format == "png"; }

/// Throws usage_error where the map has no such format.
void check_format(const grid& g, const std::string& format) {
  if (g.cells && format != "csv" && format != "areas") {
    throw usage_error(fmt::format("--format {}: a map of cells is csv or areas", format));
  }
  if (format == "areas") {
    const bool has_integer = std::ranges::any_of(g.chosen, &quantity::is_whole);
    if (g.cells && has_integer) return;
    throw usage_error(
        "--format areas: give --cells, and a quantity that is an integer, such as intersections");
  }
  if (!is_picture(format)) return;
  constexpr std::size_t most = 1'000'000;
  if (g.quantities.size() != 1 || g.c || g.a_values.size() < 2 || g.b_values.size() < 2 ||
      g.points() > most) {
    throw usage_error(
        "a picture is of one quantity over steps of a and b, without --c, and of at most 1000000 "
        "points; give --format csv or npy");
  }
}

std::string as_picture(const grid& g, const std::string& rows, const std::string& format) {
  map_values map{g.quantities.front(), {}, {}, numbers_of(g, rows), g.log};
  map.values.resize(g.points());  // without the radii
  for (const rational& a : g.a_values) map.a.push_back(static_cast<double>(a));
  for (const rational& b : g.b_values) map.b.push_back(static_cast<double>(b));
  return map_picture(map, format);
}

/// Of each quantity that is an integer: on which share of the area it has which value. In doubles.
std::string as_areas(const grid& g, const std::string& rows) {
  const auto size = [&](const std::string& low, const std::string& high) {
    const auto x = static_cast<double>(parse_rational(low));
    const auto y = static_cast<double>(parse_rational(high));
    if (x == y) return 1.0;
    return g.log ? std::log(y) - std::log(x) : y - x;
  };
  const std::size_t first = g.c ? 12 : 8;  // two columns for each end
  double all = 0;
  std::vector<std::map<integer, double>> decided(g.chosen.size());
  std::istringstream lines(rows);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> columns;
    std::istringstream row(line + ',');
    for (std::string one; std::getline(row, one, ',');) columns.push_back(one);
    const double area = size(columns.at(0), columns.at(2)) * size(columns.at(4), columns.at(6));
    all += area;
    for (std::size_t k = 0; k < decided.size(); ++k) {
      const std::string& low = columns.at(first + 2 * k);
      if (g.chosen[k]->is_whole && low == columns.at(first + 2 * k + 1)) {
        decided[k][integer(low)] += area;
      }
    }
  }
  std::string result = "quantity,value,percent_of_area\n";
  for (std::size_t k = 0; k < decided.size(); ++k) {
    if (!g.chosen[k]->is_whole) continue;
    double rest = all;
    for (const auto& [value, area] : decided[k]) {
      rest -= area;
      result += fmt::format("{},{},{:.2f}\n", g.quantities[k], value.str(), 100 * area / all);
    }
    result +=
        fmt::format("{},undecided,{:.2f}\n", g.quantities[k], 100 * std::max(rest, 0.0) / all);
  }
  return result;
}

exit_status print_map(const grid& g, const std::string& rows, const std::string& format) {
  print(format == "areas"    ? as_areas(g, rows)
        : is_picture(format) ? as_picture(g, rows, format)
        : format == "npy"    ? as_npy(g, rows)
                             : header_of(g) + rows);
  return rows.find("undecided,") == std::string::npos ? exit_status::all_certified
                                                      : exit_status::not_certified;
}

/// All rows from a directory; nothing, and how many blocks are missing and which is the first,
/// else.
struct collected {
  std::string rows;
  std::size_t missing = 0;
  std::size_t first_missing = 0;
};
collected collect(const grid& g, const block_directory& directory) {
  collected result;
  for (std::size_t block = 0; block < g.blocks(); ++block) {
    const auto rows = directory.rows_of(block);
    if (!rows) {
      if (result.missing++ == 0) result.first_missing = block;
      continue;
    }
    if (result.missing == 0) result.rows += *rows;
  }
  return result;
}

// ---------------------------------------------------------------------------------------------
// The commands

struct map_options {
  std::vector<std::string> quantity;
  std::string a, b;
  std::optional<std::string> c;
  bool log = false;
  bool cells = false;
  count_option refine{"--refine", 0, 0, 20};
  std::optional<std::string> width;
  std::optional<std::string> blocks;
  std::optional<std::string> shard;
  digits_option digits{"15"};
  count_option threads{"--threads", 0, 0, most_threads};
  format_option format{{"csv", "npy", "svg", "png", "areas"}};
  time_limit_option time_limit;
};

rational read_width(const std::string& text) {
  rational width = [&] {
    try {
      return parse_rational(text);
    } catch (const std::exception&) {
      return rational(0);
    }
  }();
  if (width > 0) return width;
  throw usage_error(
      fmt::format("--width {}: it must be a number above 0, such as 1e-3", in_quotes(text)));
}

struct shard {
  std::size_t number = 0;  // from 0
  std::size_t count = 1;
};
shard read_shard(const map_options& options) {
  if (!options.shard) return {};
  if (!options.blocks) {
    throw usage_error("--shard: give --blocks DIR too, where all shards put their blocks");
  }
  const std::string& text = *options.shard;
  unsigned long number = 0;
  unsigned long count = 0;
  char rest = 0;
  const bool is_read = text.size() < 20 &&
                       text.find_first_not_of("0123456789/") == std::string::npos &&
                       std::sscanf(text.c_str(), "%lu/%lu%c", &number, &count, &rest) == 2;
  if (!is_read || number < 1 || number > count || count > 1'000'000) {
    throw usage_error(fmt::format("--shard {}: it must be I/N, the I-th of N shards, such as 1/8",
                                  in_quotes(text)));
  }
  return {number - 1, count};
}

exit_status run(const map_options& options) {
  grid g;
  g.quantities = options.quantity;
  g.a = options.a;
  g.b = options.b;
  g.c = options.c;
  g.log = options.log;
  g.digits = options.digits.value();
  g.cells = options.cells;
  g.refine = options.refine.value();
  if (options.width) g.width = read_width(*options.width);
  if (!g.cells && (g.refine != 0 || g.width)) {
    throw usage_error("--refine and --width are of cells: give --cells, too");
  }
  g = completed(std::move(g));
  const std::string& format = options.format.value();
  check_format(g, format);
  const shard own = read_shard(options);
  const progress line;
  detail::worker_threads threads(static_cast<int>(options.threads.value()));
  const std::size_t middle = g.points() / 2;
  line.expect(
      options.time_limit.check(fmt::format("a map of {} points to {} digits", g.points(), g.digits),
                               g.digits, {[&](long fewer) {
                                 grid rough = g;
                                 rough.digits = fewer;
                                 (void)row_of(rough, middle);
                               }},
                               static_cast<double>(g.points()) / threads.count()));
  const time_watch watch(options.time_limit.limit(static_cast<double>(g.points())));
  std::optional<block_directory> directory;
  if (options.blocks) {
    directory.emplace(*options.blocks);
    directory->begin(g);
  }
  std::vector<std::size_t> open;
  for (std::size_t block = own.number; block < g.blocks(); block += own.count) {
    if (!directory || !directory->rows_of(block)) open.push_back(block);
  }
  std::string rows;
  for (std::size_t k = 0; k < open.size(); ++k) {
    line.show_part("computing " + fmt::format("{}", fmt::join(g.quantities, ", ")), k, open.size());
    std::string block = rows_of_block(g, open[k], threads);
    if (directory) {
      directory->write_block(open[k], block);
    } else {
      rows += block;
    }
  }
  if (!directory) return print_map(g, rows, format);
  if (own.count > 1) {
    print(fmt::format("shard {} of {} is done; polhode merge {} prints the map when all are\n",
                      own.number + 1, own.count, *options.blocks));
    return exit_status::all_certified;
  }
  return print_map(g, collect(g, *directory).rows, format);
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<map_options>();
  add_option(app, "QUANTITY", options->quantity,
             fmt::format("What to compute: {}", fmt::join(names_of(all_quantities()), ", ")))
      .type_name("");
  add_option(app, "--a", options->a,
             "Values of a = I_y/I_z - 1 > 0: N equal steps from LO to HI,\n"
             "both included; or one")
      .type_name("LO..HI/N")
      .required();
  add_option(app, "--b", options->b, "Values of b = 1 - I_y/I_x in (0, 1), in the same way")
      .type_name("LO..HI/N")
      .required();
  add_option(app, "--c", options->c, "The motions, for phase and epsilon, in the same way")
      .type_name("LO..HI/N");
  add_flag(app, "--log", options->log,
           "Steps of a and b with equal ratios; the values are rounded\nto six digits");
  add_flag(app, "--cells", options->cells,
           "Ranges over the cells between the values, in place of numbers\nat points");
  options->refine.declare(app,
                          "Halve a cell up to so many times, in a and b by turns, until each\n"
                          "integer is decided and each range at most --width wide");
  add_option(app, "--width", options->width, "How wide a range may be, for --refine")
      .type_name("W");
  add_option(app, "--blocks", options->blocks,
             "Keep blocks of 1000 points that are done in this directory, and\n"
             "go on from those that it has")
      .type_name("DIR");
  add_option(app, "--shard", options->shard,
             "Compute the I-th of N parts of the blocks alone, for merge")
      .type_name("I/N");
  options->threads.declare(
      app, "Compute on so many threads; 0 for all processors. The digits are\nthe same");
  options->digits.declare(app);
  options->format.declare(app);
  options->time_limit.declare(app, "point");
  return [options] { return run(*options); };
}

struct merge_options {
  std::string directory;
  format_option format{{"csv", "npy", "svg", "png", "areas"}};
};

std::function<exit_status()> declare_merge(CLI::App& app) {
  const auto options = std::make_shared<merge_options>();
  add_option(app, "DIR", options->directory, "The directory of --blocks").type_name("").required();
  options->format.declare(app);
  return [options] {
    const block_directory directory(options->directory);
    const grid g = directory.read_head();
    check_format(g, options->format.value());
    const collected all = collect(g, directory);
    if (all.missing > 0) {
      throw usage_error(fmt::format(
          "{}: {} of {} blocks are missing or not whole, the first is block {}; run polhode map "
          "with the same options and --blocks again",
          in_quotes(options->directory), all.missing, g.blocks(), all.first_missing));
    }
    return print_map(g, all.rows, options->format.value());
  };
}

}  // namespace
}  // namespace map_impl

command map_command() {
  return {
      "map", "Compute quantities over a grid of bodies, every number certified",
      "  polhode map epsilon0 c0 --a 0.1..10/40 --b 0.1..0.9/40 --log > map.csv\n"
      "  polhode map phase --a 1..3/2 --b 0.2..0.8/3 --c -0.1..0.1/4 --digits 30\n"
      "  polhode map meetings --a 1..9/8 --b 0.1..0.9/8 --format npy > map.npy\n"
      "  polhode map epsilon0 --a 0.1..10/40 --b 0.1..0.9/40 --log --format png > map.png\n"
      "  polhode map intersections physical --a 1e-6..1e6/48 --b 1e-6..0.999999/48 --log --cells "
      "--refine 4 --format areas\n"
      "  polhode map epsilon0 --a 1..9/99 --b 0.1..0.9/99 --blocks map --shard 2/4\n\n"
      "A row has a, b, c where it is asked for, and of each quantity the value and its radius: "
      "\"none\"\n"
      "where it does not exist, \"undecided\" where it is not certified (exit status 1). npy "
      "has doubles\n"
      "[quantity][value, radius][a][b][c], whose radius holds the rounding to a double too. svg "
      "and\n"
      "png show one quantity as colours, with the curves I = 1, I = 2/(2n+1), J = 1 and J = 2 "
      "(gnuplot).\n"
      "A row of --cells has the ends of a, b and c, and of each quantity the least and the "
      "greatest "
      "value\n"
      "that it can have for any body of the cell: all of the map is covered. areas is the share "
      "of the\n"
      "area on which an integer has which value.\n"
      "With --blocks a run that was killed goes on where it was, and shards that ran on any "
      "machines\n"
      "with that directory make one map, the same to the last byte.\n",
      map_impl::declare};
}

command merge_command() {
  return {"merge", "Print the map whose blocks are in a directory",
          "  polhode map meetings --a 1..9/8 --b 0.1..0.9/8 --blocks meetings --shard 1/1\n"
          "  polhode merge meetings --format csv\n\n"
          "Blocks are those of polhode map --blocks. One that is missing, or was not written "
          "whole, is an\n"
          "error that says which.\n",
          map_impl::declare_merge};
}

}  // namespace polhode::cli
