// polhode map and merge: quantities over a grid of bodies, in blocks that may be computed anywhere.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/sha256.hpp"
#include "base/worker_threads.hpp"
#include "cli/commands.hpp"
#include "cli/options/certificate_option.hpp"
#include "cli/options/count_option.hpp"
#include "cli/options/options.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/directory_lock.hpp"
#include "cli/output/output_directory.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "cli/ranks/ranks.hpp"
#include "map_arrays.hpp"
#include "map_certificate.hpp"
#include "map_grid.hpp"
#include "map_picture.hpp"
#include "map_rows.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode::cli {
namespace map_impl {
namespace {

const std::string head_name = "map.json";

/// The rows of a block, whatever the threads.
std::string rows_of_block(const map_grid& g, std::size_t block, detail::worker_threads& threads) {
  const std::size_t first = block * g.points_of_block;
  const std::size_t count = std::min(g.points_of_block, g.points() - first);
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

  /// Removes what runs that were killed have left of these blocks.
  void sweep(const std::vector<std::size_t>& blocks) const {
    std::vector<std::string> names{head_name};
    for (const std::size_t block : blocks) names.push_back(name_of(block));
    sweep_temporary_files(path_, names);
  }
  /// The map that the blocks in it are of; throws usage_error where there is none.
  [[nodiscard]] map_grid head() const {
    const auto text = read(head_name);
    const std::string give = ": give a directory that polhode map --blocks has made";
    if (!text) throw usage_error(fmt::format("{} has no {}{}", in_quotes(path_), head_name, give));
    if (auto known = read_head(*text)) return std::move(*known);
    throw usage_error(fmt::format("{} in {} is not as this version of polhode writes it{}",
                                  head_name, in_quotes(path_), give));
  }
  /// Makes it the directory of this map; throws usage_error where it is that of another one.
  void begin(const map_grid& g) {
    writer_.emplace(path_, std::vector{head_name}, "--blocks");
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
  /// What the file of a block with these rows has in it.
  [[nodiscard]] static std::string sealed(std::size_t block, const std::string& rows) {
    return rows + "sha256," + digest_of(block, rows) + '\n';
  }
  /// After begin.
  void write_block(std::size_t block, const std::string& sealed_rows) {
    write(name_of(block), sealed_rows);
  }
  /// Its rows, where it is there and whole.
  [[nodiscard]] std::optional<std::string> rows_of(std::size_t block) const {
    std::optional<std::string> text = read(name_of(block));
    if (!text) return std::nullopt;
    const std::size_t at = text->rfind("sha256,");
    if (at == std::string::npos) return std::nullopt;
    const std::string rows = text->substr(0, at);
    return *text == sealed(block, rows) ? std::optional(rows) : std::nullopt;
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
  void write(const std::string& name, const std::string& text) {
    writer_->write(name, text);
    writer_->publish();
  }

  std::string path_;
  std::optional<output_directory> writer_;
};

// ---------------------------------------------------------------------------------------------
// The whole map

bool is_picture(const std::string& format) { return format == "svg" || format == "png"; }

/// Throws usage_error where the map has no such format.
void check_format(const map_grid& g, const std::string& format) {
  if (format == "areas") {
    const bool has_integer = std::ranges::any_of(g.chosen, &quantity::is_whole);
    if (g.cells && has_integer) return;
    throw usage_error(
        "--format areas: give --cells, and a quantity that is an integer, such as intersections");
  }
  if (!is_picture(format)) return;
  constexpr std::size_t most = 1'000'000;
  if (g.quantities.size() != 1 || g.c || g.first.values.size() < 2 || g.second.values.size() < 2 ||
      g.points() > most) {
    throw usage_error(
        "a picture is of one quantity over steps of both axes, without --c, and of at most 1000000 "
        "points; give --format csv or npy");
  }
}

std::string as_picture(const map_grid& g, const std::string& rows, const std::string& format) {
  map_values map;
  map.quantity = g.quantities.front();
  map.log = g.log;
  map.plane = g.moments ? map_plane::moments : g.chi ? map_plane::limit : map_plane::bodies;
  if (g.moments) map.third_moment = static_cast<double>(g.fixed);
  map.x_title = g.first.title;
  map.y_title = g.second.title;
  if (g.cells) {
    map.tiles = map_tiles(g, rows);
  } else {
    map.values = map_numbers(g, rows);
    map.values.resize(g.points());  // without the radii
  }
  for (const rational& x : g.first.values) map.x.push_back(static_cast<double>(x));
  for (const rational& y : g.second.values) map.y.push_back(static_cast<double>(y));
  return map_picture(map, format);
}

exit_status print_map(const map_grid& g, const std::string& rows, const std::string& format) {
  print(format == "areas"    ? map_areas(g, rows)
        : is_picture(format) ? as_picture(g, rows, format)
        : format == "npy"    ? map_npy(g, rows)
        : format == "hdf5"   ? map_hdf5(g, rows)
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
collected collect(const map_grid& g, const block_directory& directory) {
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
  std::optional<std::string> a, b, moments, chi, beta, c;
  bool log = false;
  bool cells = false;
  count_option refine{"--refine", 0, 0, 20};
  std::optional<std::string> width;
  std::optional<std::string> blocks;
  std::optional<std::string> shard;
  count_option block_size{"--block-size", 0, 0, map_grid::most_points_of_block};
  digits_option digits{"15"};
  count_option threads{"--threads", 0, 0, most_threads};
  format_option format{{"csv", "npy", "hdf5", "svg", "png", "areas"}};
  certificate_option certificate;
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

map_grid grid_of(const map_options& options) {
  map_grid g;
  g.quantities = options.quantity;
  g.a = options.a;
  g.b = options.b;
  g.moments = options.moments;
  g.chi = options.chi;
  g.beta = options.beta;
  g.c = options.c;
  g.log = options.log;
  g.digits = options.digits.value();
  g.cells = options.cells;
  g.refine = options.refine.value();
  g.points_of_block = static_cast<std::size_t>(options.block_size.value());
  if (options.width) g.width = read_width(*options.width);
  if (!g.cells && (g.refine != 0 || g.width)) {
    throw usage_error("--refine and --width are of cells: give --cells, too");
  }
  return completed(std::move(g));
}

/// Throws usage_error for a map that would take too long. Returns the seconds that it is estimated
/// to take, where they are worth an estimate.
std::optional<double> checked_time(const map_grid& g, const map_options& options, int threads) {
  const std::size_t middle = g.points() / 2;
  const auto one_point = [&](long fewer) {
    map_grid rough = g;
    rough.digits = fewer;
    (void)row_of(rough, middle);
  };
  return options.time_limit.check(
      fmt::format("a map of {} points to {} digits", g.points(), g.digits), g.digits, {one_point},
      static_cast<double>(g.points()) / threads / ranks::count());
}

exit_status run(map_options& options) {
  const map_grid g = grid_of(options);
  const std::string& format = options.format.value();
  check_format(g, format);
  const shard own = read_shard(options);
  if (options.certificate.is_given()) {
    expect_certifiable(g);
    if (own.count > 1) throw usage_error("--certificate: it is of the whole map, not of a shard");
    if (!ranks::is_worker()) options.certificate.prepare();
  }
  const progress line;
  detail::worker_threads threads(ranks::threads(options.threads.value()));
  if (!ranks::is_worker()) line.expect(checked_time(g, options, threads.count()));
  const time_watch watch(options.time_limit.limit(static_cast<double>(g.points())));
  std::optional<block_directory> directory;
  std::vector<std::size_t> open;
  if (options.blocks && !ranks::is_worker()) {
    directory.emplace(*options.blocks);
    directory->begin(g);
  }
  for (std::size_t block = own.number; block < g.blocks(); block += own.count) {
    if (!directory || !directory->rows_of(block)) open.push_back(block);
  }
  if (directory) directory->sweep(open);
  const std::string what = fmt::format("computing {}", fmt::join(g.quantities, ", "));
  std::vector<std::string> in_memory(directory ? 0 : g.blocks());
  std::size_t done = 0;
  line.show_part(what, done, open.size());
  // Only rank 0 knows which are open.
  ranks::distribute(
      open,
      [&](std::size_t block) {
        const std::string rows = rows_of_block(g, block, threads);
        return options.blocks ? block_directory::sealed(block, rows) : rows;
      },
      [&](std::size_t block, std::string text) {
        if (directory) {
          directory->write_block(block, text);
        } else {
          in_memory[block] = std::move(text);
        }
        line.show_part(what, ++done, open.size());
      });
  if (options.certificate.is_given() && !ranks::is_worker()) {
    options.certificate.write(map_certificate(g));
  }
  if (!directory) {
    std::string rows;
    for (std::string& block : in_memory) rows += std::exchange(block, {});
    return print_map(g, rows, format);
  }
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
      .type_name("LO..HI/N");
  add_option(app, "--b", options->b, "Values of b = 1 - I_y/I_x in (0, 1), in the same way")
      .type_name("LO..HI/N");
  add_option(app, "--moments", options->moments,
             "In place of a and b the principal moments, in any order and\n"
             "unit: one number, and two ranges LO..HI/N")
      .type_name("I1,I2,I3");
  add_option(app, "--chi", options->chi,
             "In place of bodies their limit, a to infinity and b to 0:\n"
             "epsilon by chi = a b > 0 and beta = c/b > -1")
      .type_name("LO..HI/N");
  add_option(app, "--beta", options->beta, "Values of beta, in the same way").type_name("LO..HI/N");
  add_option(app, "--c", options->c, "The motions, for phase and epsilon, in the same way")
      .type_name("LO..HI/N");
  add_flag(app, "--log", options->log,
           "Steps of both axes with equal ratios; the values are rounded\nto six digits");
  add_flag(app, "--cells", options->cells,
           "Ranges over the cells between the values, in place of numbers\nat points");
  options->refine.declare(app,
                          "Halve a cell up to so many times, along the axes by turns, until each\n"
                          "integer is decided and each range at most --width wide");
  add_option(app, "--width", options->width, "How wide a range may be, for --refine")
      .type_name("W");
  add_option(app, "--blocks", options->blocks,
             "Keep the blocks that are done in this directory, and go on from\nthose that it has")
      .type_name("DIR");
  options->block_size.declare(app,
                              "Points, or cells, of a block; 0 for a number that follows from\n"
                              "what they cost");
  add_option(app, "--shard", options->shard,
             "Compute the I-th of N parts of the blocks alone, for merge")
      .type_name("I/N");
  options->threads.declare(
      app, "Compute on so many threads; 0 for all processors. The digits are\nthe same");
  options->digits.declare(app);
  options->format.declare(app);
  options->certificate.declare(app);
  options->time_limit.declare(app, "point");
  return [options] { return run(*options); };
}

struct merge_options {
  std::string directory;
  format_option format{{"csv", "npy", "hdf5", "svg", "png", "areas"}};
};

std::function<exit_status()> declare_merge(CLI::App& app) {
  const auto options = std::make_shared<merge_options>();
  add_option(app, "DIR", options->directory, "The directory of --blocks").type_name("").required();
  options->format.declare(app);
  return [options] {
    const block_directory directory(options->directory);
    const map_grid g = directory.head();
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
      "  polhode map epsilon0 --moments 3,1..2.9/19,0.5..2.5/20 --format png > map.png\n"
      "  polhode map epsilon0 --a 0.1..10/40 --b 0.1..0.9/40 --format hdf5 > map.h5\n"
      "  polhode map epsilon0 --a 0.1..10/40 --b 0.1..0.9/40 --log --format png > map.png\n"
      "  polhode map intersections physical --a 1e-6..1e6/48 --b 1e-6..0.999999/48 --log --cells "
      "--refine 4 --format areas\n"
      "  polhode map physical --a 1..9/8 --b 0.1..0.9/8 --cells --certificate map.json > map.csv\n"
      "  polhode map epsilon --chi 0.1..2/20 --beta -0.5..0.5/20 --format svg > limit.svg\n"
      "  polhode map epsilon0 --a 1..9/99 --b 0.1..0.9/99 --blocks map --shard 2/4\n"
      "  mpirun -n 64 polhode map epsilon0 --a 1..9/999 --b 0.1..0.9/999 --blocks map\n\n"
      "A row has a, b (or two moments), c where it is asked for, and of each quantity the value "
      "and its radius: "
      "\"none\"\n"
      "where it does not exist, \"undecided\" where it is not certified (exit status 1). npy "
      "has doubles\n"
      "[quantity][value, radius][a][b][c], whose radius holds the rounding to a double too; hdf5 "
      "the same\n"
      "by name, with units and axes. svg and png show one quantity as colours, with the curves I = "
      "1,\n"
      "I = 2/(2n+1), J = 1 and J = 2 (gnuplot).\n"
      "A row of --cells has the ends of a, b and c, and of each quantity the least and the "
      "greatest "
      "value\n"
      "that it can have for any body of the cell: all of the map is covered. areas is the share "
      "of the\n"
      "area on which an integer has which value; pictures show undecided cells in grey. "
      "--certificate is\n"
      "for the cells of intersections, meetings and physical.\n"
      "With --blocks a run that was killed goes on where it was, and shards that ran on any "
      "machines\n"
      "with that directory make one map, the same to the last byte. Under mpirun all ranks work on "
      "it, with\n"
      "one thread each unless --threads says more (docs/cluster.md).\n",
      map_impl::declare, true};
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
