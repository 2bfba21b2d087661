// polhode figures: the figures of the paper, drawn from certified values.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/figures/figure.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/options.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/gnuplot.hpp"
#include "cli/output/layout.hpp"
#include "cli/output/output_directory.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"

namespace polhode::cli {
namespace figures_impl {
namespace {

struct figures_options {
  std::vector<std::string> names;
  bool list = false;
  bool data_only = false;
  std::string directory = "figures";
  digits_option digits{"15"};
  memory_limit_option memory_limit;
  time_limit_option time_limit;
};

/// The paper's numbers, such as 3, stand for all figures of that number.
std::vector<std::string> with_numbers_named(const std::vector<std::string>& given) {
  std::vector<std::string> result;
  for (const std::string& text : given) {
    bool is_number = false;
    for (const figure& f : all_figures()) {
      const std::string number = "figure " + text;
      if (f.place != number && f.place.rfind(number + " (", 0) != 0) continue;
      is_number = true;
      result.push_back(f.name);
    }
    if (!is_number) result.push_back(text);
  }
  return result;
}

std::vector<const figure*> selected_figures(const figures_options& options) {
  const std::vector<std::string> all = names_of(all_figures());
  const std::vector<std::string> names =
      known_names(with_numbers_named(options.names), all, "figure", "polhode figures --list");
  std::vector<const figure*> result;
  for (const figure& f : all_figures()) {
    const bool named = std::find(names.begin(), names.end(), f.name) != names.end();
    if (names.empty() || named) result.push_back(&f);
  }
  return result;
}

std::string list_of(const std::vector<const figure*>& figures) {
  constexpr std::size_t place_width = 14;
  constexpr std::size_t between = 2;
  std::size_t name_width = 0;
  for (const figure* f : figures) name_width = std::max(name_width, f->name.size());
  std::vector<std::vector<std::string>> rows;
  rows.reserve(figures.size());
  for (const figure* f : figures) {
    rows.push_back({f->name, f->place, f->shows + (f->note.empty() ? "" : "; " + f->note)});
  }
  return table({{"FIGURE", name_width},
                {"IN THE PAPER", place_width},
                {"WHAT IT SHOWS", terminal_columns - name_width - place_width - 2 * between}},
               rows);
}

exit_status run(const figures_options& options) {
  const std::vector<const figure*> figures = selected_figures(options);
  const long digits = options.digits.value();
  if (options.list) {
    print(list_of(figures));
    return exit_status::all_certified;
  }
  constexpr double points = 2000;  // of a figure, at most about
  constexpr double bytes_per_digit = 20;
  options.memory_limit.check({fmt::format("{} figures with {} digits", figures.size(), digits),
                              points * bytes_per_digit * static_cast<double>(figures.size()) *
                                  static_cast<double>(digits)});
  (void)options.time_limit.limit();
  if (!options.data_only) require_gnuplot("give --data-only");

  std::vector<std::string> names;
  for (const figure* f : figures) {
    names.push_back(f->name + ".csv");
    if (options.data_only) continue;
    names.push_back(f->name + ".svg");
    names.push_back(f->name + ".png");
  }
  output_directory directory(options.directory, names);
  std::string report;
  {
    const progress line;
    line.show("estimating");
    std::vector<time_limit_option::work> works;
    works.reserve(figures.size());
    for (const figure* f : figures) {
      works.emplace_back([f](long fewer) { (void)f->compute(fewer); });
    }
    line.expect(
        options.time_limit.check(fmt::format("{} digits of every point of {} figure{}", digits,
                                             figures.size(), figures.size() == 1 ? "" : "s"),
                                 digits, works));
    const time_watch watch(options.time_limit.limit(static_cast<double>(figures.size())));
    std::size_t done = 0;
    for (const figure* f : figures) {
      line.show(fmt::format("computing {}, {} ({}/{})", f->name, f->place, ++done, figures.size()));
      const figure_content content = f->compute(digits);
      const std::string width = greatest_width(content, digits);
      directory.write(f->name + ".csv", csv_of(*f, content, digits));
      if (!options.data_only) {
        line.show(fmt::format("drawing {} ({}/{})", f->name, done, figures.size()));
        directory.write(f->name + ".svg", draw(*f, content, width, picture_format::svg));
        directory.write(f->name + ".png", draw(*f, content, width, picture_format::png));
      }
      report += fmt::format("{}{}: {}; every coordinate certified to within {}\n", f->name,
                            options.data_only ? ".csv" : ".svg, .png, .csv", f->place, width);
    }
    directory.publish();
  }
  print(report);
  return exit_status::all_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<figures_options>();
  add_option(app, "NAME", options->names,
             "Figures to draw, by name or by the paper's number; without any, all")
      .type_name("");
  add_flag(app, "--list", options->list, "Show the figures instead of drawing them");
  add_option(app, "--out", options->directory,
             "Where NAME.svg, NAME.png and NAME.csv go; DIR is created where\n"
             "it is missing; all files appear, or none [figures]")
      .type_name("DIR");
  add_flag(app, "--data-only", options->data_only,
           "Write the CSV files alone, which needs no gnuplot; without this\n"
           "option nothing is written where gnuplot is missing");
  options->digits.declare(app);
  options->memory_limit.declare(app);
  options->time_limit.declare(app, "figure");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace figures_impl

command figures_command() {
  return {"figures", "Draw the figures of the paper from certified values",
          "  polhode figures\n"
          "  polhode figures --list\n"
          "  polhode figures injectivity varying_a --out pictures\n"
          "  polhode figures 3\n"
          "  polhode figures limit --data-only --digits 30\n\n"
          "gnuplot draws them. Each title says how wide the widest enclosure of its "
          "points is; the\n"
          "CSV file has them all: the certain digits of each coordinate, and its ends rounded "
          "outward.\n",
          figures_impl::declare};
}

}  // namespace polhode::cli
