// polhode table: a quantity of the rotation for many bodies and motions.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/worker_threads.hpp"
#include "cli/commands.hpp"
#include "cli/options/body_option.hpp"
#include "cli/options/count_option.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/motion_option.hpp"
#include "cli/options/options.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/version.hpp"
#include "quantities.hpp"

namespace polhode::cli {
namespace table_impl {
namespace {

struct row {
  std::shared_ptr<const body> rigid;
  std::optional<rational> c;
  ball value;
  bool is_infinite = false;  // and there is no other value
};

struct table_options {
  std::vector<std::string> quantity;
  bodies_option bodies;
  std::optional<std::string> c;
  count_option threads{"--threads", 0, 0, most_threads};
  digits_option digits;
  format_option format{{"csv", "json", "cpp"}};
  memory_limit_option memory_limit;
  time_limit_option time_limit;
};

// ---------------------------------------------------------------------------------------------
// The formats

std::string as_csv(const quantity& q, const std::vector<row>& rows, long digits) {
  std::string result = csv_header("a") + ',' + csv_header("b") + ',';
  if (q.of_motion) result += csv_header("c") + ',';
  result += q.name + ",radius,lower,upper,digits\n";
  for (const row& r : rows) {
    result += csv_cells(r.rigid->a()) + ',' + csv_cells(r.rigid->b()) + ',';
    if (r.c) result += csv_cells(*r.c) + ',';
    if (r.is_infinite) {
      result += "inf,0,inf,inf,0\n";
      continue;
    }
    const decimal_enclosure d = to_decimal_enclosure(r.value, digits);
    result += fmt::format("{},{},{},{},{}\n", d.value, d.radius, d.lower, d.upper, d.digits);
  }
  return result;
}

/// Row by row: as one value, a million of them would take gigabytes.
std::string as_json(const quantity& q, const std::vector<row>& rows, long digits) {
  const auto indented = [](std::string text, const std::string& by) {
    for (auto at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
      text.insert(at + 1, by);
    }
    return by + text;
  };
  const json head{{"quantity", q.name},
                  {"description", q.description},
                  {"verdict", to_text(status::certified)},
                  {"rows", json::array()}};
  std::string result = json_document("table", head).dump(2);
  constexpr std::string_view end = "]\n}";  // of the array and the object
  result.resize(result.size() - end.size());
  const json infinity{
      {"value", "inf"}, {"radius", "0"}, {"lower", "inf"}, {"upper", "inf"}, {"digits", 0}};
  const char* before = "\n";
  for (const row& r : rows) {
    json one{{"a", exact_json(r.rigid->a(), digits)}, {"b", exact_json(r.rigid->b(), digits)}};
    if (r.c) one["c"] = exact_json(*r.c, digits);
    one[q.name] = r.is_infinite ? infinity : to_json(r.value, digits);
    result += before + indented(one.dump(2), "    ");
    before = ",\n";
  }
  result += "\n  ]\n}\n";
  return result;
}

constexpr long digits_of_literals = 50;

/// Decimals as a floating point literal.
std::string literal(const std::string& decimals) {
  return decimals.find_first_of(".e") == std::string::npos ? decimals + ".0" : decimals;
}
std::string literal(const exact_real& x) { return literal(decimal_of(x, digits_of_literals)); }

/// A double has no room for what is neither 0 nor a normal number of its own.
void refuse_unless_double(const std::string& name, bool is_zero, double x,
                          const std::string& text) {
  if (is_zero || std::isnormal(x)) return;
  throw usage_error(fmt::format(
      "--format cpp: {} = {} is outside the range of a double; csv and json have it", name, text));
}
void refuse_unless_doubles(const row& r) {
  const auto refuse = [](const std::string& name, const exact_real& x) {
    refuse_unless_double(
        name, x == 0, midpoint(x.at(64)).convert_to<double>(),
        x.is_rational() ? with_dots(leading_digits_of(x.exact(), 10)) : to_text(x));
  };
  refuse("a", r.rigid->a());
  refuse("b", r.rigid->b());
  if (r.c) refuse("c", *r.c);
}

std::string as_cpp(const quantity& q, const std::vector<row>& rows, long digits) {
  std::string result = fmt::format(
      "// Written by polhode {}: the {}. The decimals are the first {} significant\n"
      "// digits of the true values, cut off, not rounded (where more than that are zeros or "
      "nines, the "
      "number\n// that they come to, off by less than a unit of the last); the floating point "
      "numbers are rounded "
      "by the "
      "compiler\n"
      "// from {} digits.\n"
      "#pragma once\n\n#include <array>\n#include <limits>\n#include <string_view>\n\nnamespace "
      "polhode_tables {{\n\n",
      POLHODE_VERSION, q.description, digits, digits_of_literals);
  result += fmt::format(
      "struct {}_row {{\n  double a;\n  double b;\n{}  double {};\n  std::string_view "
      "decimal;\n}};\n\n",
      q.name, q.of_motion ? "  double c;\n" : "", q.name);
  result += fmt::format("inline constexpr std::array<{0}_row, {1}> {0}{{{{\n", q.name, rows.size());
  for (const row& r : rows) {
    const auto place = [&](const std::string& cells) {
      std::string found = "    {" + literal(r.rigid->a()) + ", " + literal(r.rigid->b()) + ", ";
      if (r.c) found += literal(*r.c) + ", ";
      return found + cells;
    };
    if (r.is_infinite) {
      result += place("std::numeric_limits<double>::infinity(), \"inf\"},\n");
      continue;
    }
    refuse_unless_double(q.name, r.value.is_exact() && contains_zero(r.value),
                         midpoint(r.value).convert_to<double>(),
                         to_decimal_enclosure(r.value, 10).value);
    result += place(fmt::format("{}, \"{}\"}},\n",
                                literal(to_decimal_enclosure(r.value, digits_of_literals).value),
                                to_decimal_enclosure(r.value, digits).value));
  }
  return result + "}};\n\n}  // namespace polhode_tables\n";
}

// ---------------------------------------------------------------------------------------------
// The command

const quantity& selected(const table_options& options) {
  const std::vector<std::string> all = names_of(all_quantities());
  const std::vector<std::string> names =
      known_names(options.quantity, all, "quantity", "polhode table --help");
  if (names.size() != 1) {
    throw usage_error(
        fmt::format("{}; give one of {}",
                    names.empty() ? "there is no quantity" : "there are several quantities",
                    fmt::join(all, ", ")));
  }
  return *std::find_if(all_quantities().begin(), all_quantities().end(),
                       [&](const quantity& q) { return q.name == names.front(); });
}

/// The rows without their values, each of which is known to exist.
std::vector<row> rows_of(const table_options& options, const quantity& q) {
  const std::vector<body> bodies = options.bodies.value();
  if (q.of_motion != options.c.has_value()) {
    throw usage_error(
        q.of_motion ? fmt::format("{} is that of a motion; give --c LO..HI/N, or --c C", q.name)
                    : fmt::format("--c: {} is that of a body and of no motion", q.name));
  }
  std::vector<rational> motions;
  if (q.of_motion) {
    const motion_range range = read_motions(*options.c);
    if (!range.steps && range.low != range.high) {
      throw usage_error(
          fmt::format("--c {}: the number of steps is missing; give LO..HI/N, such as {}/10",
                      in_quotes(*options.c), *options.c));
    }
    motions = range.values();
  }
  std::vector<row> result;
  result.reserve(bodies.size() * std::max<std::size_t>(motions.size(), 1));
  for (const body& one : bodies) {
    const auto shared = std::make_shared<const body>(one);
    const body& rigid = *shared;
    if (!q.of_motion) {
      q.check(rigid, 0);
      result.push_back({shared, {}, {}});
    }
    for (const rational& c : motions) {
      try {
        (void)regime_of(rigid, c);
      } catch (const input_error& error) {
        throw usage_error(fmt::format("--c {}: {}", in_quotes(*options.c), error.what()));
      }
      q.check(rigid, c);
      result.push_back({shared, c, {}, c == 0 && q.infinite_at_0});
    }
  }
  return result;
}

certain_number value_of(const row& r, const quantity& q, long digits) {
  if (r.is_infinite) return {};
  return q.compute(*r.rigid, r.c ? *r.c : rational(0), digits);
}

/// All values. Throws not_certified_error for the first of the rows whose value is not certified, whatever the threads.
void compute(std::vector<row>& rows, const quantity& q, long digits, const std::string& what,
             const table_options& options) {
  const progress line;
  line.show("estimating");
  detail::worker_threads threads(static_cast<int>(options.threads.value()));
  const auto some = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2),
                                 rows.end(), [](const row& r) { return !r.is_infinite; });
  const row& middle = some == rows.end() ? rows.front() : *some;
  line.expect(options.time_limit.check(what, digits,
                                       {[&](long fewer) { (void)value_of(middle, q, fewer); }},
                                       static_cast<double>(rows.size()) / threads.count()));
  const time_watch watch(options.time_limit.limit(static_cast<double>(rows.size())));
  constexpr std::size_t rows_of_thread = 16;
  const std::size_t at_a_time = rows_of_thread * static_cast<std::size_t>(threads.count());
  std::vector<certain_number> values(std::min(at_a_time, rows.size()));
  for (std::size_t first = 0; first < rows.size(); first += at_a_time) {
    line.show_part("computing " + q.name, first, rows.size());
    const std::size_t count = std::min(at_a_time, rows.size() - first);
    threads.for_each(static_cast<long>(count), [&](long i) {
      const auto k = static_cast<std::size_t>(i);
      if (!rows[first + k].is_infinite) values[k] = value_of(rows[first + k], q, digits);
    });
    for (std::size_t k = 0; k < count; ++k) {
      row& r = rows[first + k];
      if (r.is_infinite) continue;
      const std::string where =
          fmt::format("{} at a = {}, b = {}{}", q.name, to_text(r.rigid->a()),
                      to_text(r.rigid->b()), r.c ? ", c = " + to_text(*r.c) : "");
      r.value = certain(values[k], where, digits);
    }
  }
}

exit_status run(const table_options& options) {
  const quantity& q = selected(options);
  const long digits = options.digits.value();
  const std::string& format = options.format.value();
  const long computed = format == "cpp" ? std::max(digits, digits_of_literals) : digits;
  std::vector<row> rows = rows_of(options, q);
  if (format == "cpp") std::for_each(rows.begin(), rows.end(), refuse_unless_doubles);
  constexpr double bytes_per_digit = 60;
  constexpr double bytes_kept = 12;
  // Measured: a row's names, punctuation, numbers a, b, c and the like.
  const double bytes_beside = format == "json" ? 2500 : 700;
  const auto count = static_cast<double>(rows.size());
  const std::string what = fmt::format("{} numbers of {} digits", rows.size(), digits);
  options.memory_limit.check(
      {what, (bytes_per_digit *
                  detail::worker_threads(static_cast<int>(options.threads.value())).count() +
              bytes_kept * count) *
                     static_cast<double>(computed) +
                 bytes_beside * count});
  compute(rows, q, computed, what, options);
  print(format == "csv" ? as_csv(q, rows, digits)
                        : (format == "json" ? as_json(q, rows, digits) : as_cpp(q, rows, digits)));
  return exit_status::all_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<table_options>();
  add_option(app, "QUANTITY", options->quantity,
             fmt::format("What to tabulate: {}", fmt::join(names_of(all_quantities()), ", ")))
      .type_name("");
  options->bodies.declare(app);
  add_option(app, "--c", options->c,
             "The motions, for phase and epsilon: N equal steps from LO to HI,\n"
             "both included; or one")
      .type_name("LO..HI/N");
  options->threads.declare(
      app, "Compute on so many threads; 0 for all processors. The digits are\nthe same");
  options->digits.declare(app);
  options->format.declare(app);
  options->memory_limit.declare(app);
  options->time_limit.declare(app);
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace table_impl

command table_command() {
  return {
      "table", "Tabulate a quantity of free rotations, every number certified",
      "  polhode table phase --ab 12.65,0.0629 --c -0.06..-0.01/5\n"
      "  polhode table epsilon --ab 12.65,0.0629 --ab 18.27,0.0629 --c -0.06..0.06/24 --digits 20\n"
      "  polhode table c0 --moments 3,2,1 --moments 5,4,2 --format json\n\n"
      "phase is the Montgomery phase, epsilon the defect of the tennis racket effect at c, "
      "epsilon0 that on\n"
      "the separatrix, c0 the motion of the perfect twist. The numbers of --c are formed exactly. "
      "Either\n"
      "every number is certified, or nothing is printed.\n",
      table_impl::declare};
}

}  // namespace polhode::cli
