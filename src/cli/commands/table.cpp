// polhode table: a quantity of the rotation for many bodies and motions.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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
#include "cli/ranks/ranks.hpp"
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

/// A table as text: the head, the rows with what stands between two of them, and the end.
struct table_text {
  std::string head;
  std::function<std::string(const row&, const ball& value)> row_of;
  std::string between;
  std::string end;
};

table_text as_csv(const quantity& q, long digits) {
  table_text result;
  result.head = csv_header("a") + ',' + csv_header("b") + ',';
  if (q.of_motion) result.head += csv_header("c") + ',';
  result.head += q.name + ",radius,lower,upper,digits\n";
  result.row_of = [digits](const row& r, const ball& value) {
    std::string cells = csv_cells(r.rigid->a()) + ',' + csv_cells(r.rigid->b()) + ',';
    if (r.c) cells += csv_cells(*r.c) + ',';
    if (r.is_infinite) return cells + "inf,0,inf,inf,0\n";
    const decimal_enclosure d = to_decimal_enclosure(value, digits);
    return cells + fmt::format("{},{},{},{},{}\n", d.value, d.radius, d.lower, d.upper, d.digits);
  };
  return result;
}

/// Row by row: as one value, a million of them would take gigabytes.
table_text as_json(const quantity& q, long digits) {
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
  table_text result;
  result.head = json_document("table", head).dump(2);
  constexpr std::string_view end = "]\n}";  // of the array and the object
  result.head.resize(result.head.size() - end.size());
  result.head += '\n';
  result.row_of = [&q, digits, indented](const row& r, const ball& value) {
    json one{{"a", exact_json(r.rigid->a(), digits)}, {"b", exact_json(r.rigid->b(), digits)}};
    if (r.c) one["c"] = exact_json(*r.c, digits);
    if (r.is_infinite) {
      one[q.name] = {
          {"value", "inf"}, {"radius", "0"}, {"lower", "inf"}, {"upper", "inf"}, {"digits", 0}};
    } else {
      one[q.name] = to_json(value, digits);
    }
    return indented(one.dump(2), "    ");
  };
  result.between = ",\n";
  result.end = "\n  ]\n}\n";
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

table_text as_cpp(const quantity& q, std::size_t rows, long digits) {
  table_text result;
  result.head = fmt::format(
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
  result.head += fmt::format(
      "struct {}_row {{\n  double a;\n  double b;\n{}  double {};\n  std::string_view "
      "decimal;\n}};\n\n",
      q.name, q.of_motion ? "  double c;\n" : "", q.name);
  result.head += fmt::format("inline constexpr std::array<{0}_row, {1}> {0}{{{{\n", q.name, rows);
  result.row_of = [&q, digits](const row& r, const ball& value) {
    std::string cells = "    {" + literal(r.rigid->a()) + ", " + literal(r.rigid->b()) + ", ";
    if (r.c) cells += literal(*r.c) + ", ";
    if (r.is_infinite) return cells + "std::numeric_limits<double>::infinity(), \"inf\"},\n";
    refuse_unless_double(q.name, value.is_exact() && contains_zero(value),
                         midpoint(value).convert_to<double>(),
                         to_decimal_enclosure(value, 10).value);
    return cells + fmt::format("{}, \"{}\"}},\n",
                               literal(to_decimal_enclosure(value, digits_of_literals).value),
                               to_decimal_enclosure(value, digits).value);
  };
  result.end = "}};\n\n}  // namespace polhode_tables\n";
  return result;
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
      result.push_back({shared, {}});
    }
    for (const rational& c : motions) {
      try {
        (void)regime_of(rigid, c);
      } catch (const input_error& error) {
        throw usage_error(fmt::format("--c {}: {}", in_quotes(*options.c), error.what()));
      }
      q.check(rigid, c);
      result.push_back({shared, c, c == 0 && q.infinite_at_0});
    }
  }
  return result;
}

certain_number value_of(const row& r, const quantity& q, long digits) {
  if (r.is_infinite) return {};
  return q.compute(*r.rigid, r.c ? *r.c : rational(0), digits);
}

/// The rows as text, with what stands before each but the first of the table. Throws
/// not_certified_error for the first of them whose value is not certified, whatever the threads.
std::string text_of(std::span<const row> rows, bool starts_table, const quantity& q, long digits,
                    const table_text& table, detail::worker_threads& threads) {
  std::vector<certain_number> values(rows.size());
  threads.for_each(static_cast<long>(rows.size()), [&](long i) {
    const auto k = static_cast<std::size_t>(i);
    values[k] = value_of(rows[k], q, digits);
  });
  std::string text;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const row& r = rows[k];
    ball value;
    if (!r.is_infinite) {
      const std::string where =
          fmt::format("{} at a = {}, b = {}{}", q.name, to_text(r.rigid->a()),
                      to_text(r.rigid->b()), r.c ? ", c = " + to_text(*r.c) : "");
      value = certain(values[k], where, digits);
    }
    if (k > 0 || !starts_table) text += table.between;
    text += table.row_of(r, value);
  }
  return text;
}

/// All rows as text. Throws not_certified_error for the first of them whose value is not certified,
/// whatever the threads and ranks.
std::string compute(const std::vector<row>& rows, const quantity& q, long digits,
                    const table_text& table, const std::string& what,
                    const table_options& options) {
  const progress line;
  line.show("estimating");
  const int asked = ranks::threads(options.threads.value());
  detail::worker_threads threads(asked);
  const auto some = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2),
                                 rows.end(), [](const row& r) { return !r.is_infinite; });
  const row& middle = some == rows.end() ? rows.front() : *some;
  if (!ranks::is_worker()) {
    line.expect(options.time_limit.check(
        what, digits, {[&](long fewer) { (void)value_of(middle, q, fewer); }},
        static_cast<double>(rows.size()) / threads.count() / ranks::count()));
  }
  const time_watch watch(options.time_limit.limit(static_cast<double>(rows.size())));
  // The parts are the same on every rank: not by the processors that a machine happens to have.
  constexpr std::size_t rows_of_thread = 16;
  const int each = ranks::count() > 1 ? asked : threads.count();
  const std::size_t rows_of_part = rows_of_thread * static_cast<std::size_t>(each);
  constexpr char is_certified = '+';
  constexpr char is_not = '-';
  const auto part = [&](std::size_t index) {
    const auto from = std::span(rows).subspan(index * rows_of_part);
    const auto own = from.first(std::min(rows_of_part, from.size()));
    try {
      return is_certified + text_of(own, index == 0, q, digits, table, threads);
    } catch (const not_certified_error& error) {
      return is_not + std::string(error.what());
    }
  };
  std::vector<std::size_t> parts((rows.size() + rows_of_part - 1) / rows_of_part);
  std::iota(parts.begin(), parts.end(), std::size_t{0});
  std::vector<std::string> texts(parts.size());
  std::size_t done = 0;
  line.show_part("computing " + q.name, done, parts.size());
  const auto refuse = [](const std::string& text) { throw not_certified_error(text.substr(1)); };
  ranks::distribute(parts, part, [&](std::size_t index, std::string text) {
    // Alone, parts are done in order; on several ranks one before it may come later.
    if (text.front() == is_not && ranks::count() == 1) refuse(text);
    texts[index] = std::move(text);
    line.show_part("computing " + q.name, ++done, parts.size());
  });
  std::string result;
  for (std::string& text : texts) {
    if (text.front() == is_not) refuse(text);
    result += std::exchange(text, {}).substr(1);
  }
  return result;
}

exit_status run(const table_options& options) {
  const quantity& q = selected(options);
  const long digits = options.digits.value();
  const std::string& format = options.format.value();
  const long computed = format == "cpp" ? std::max(digits, digits_of_literals) : digits;
  const std::vector<row> rows = rows_of(options, q);
  if (format == "cpp") std::for_each(rows.begin(), rows.end(), refuse_unless_doubles);
  constexpr double bytes_per_digit = 60;
  constexpr double bytes_kept = 12;
  // Measured: a row's names, punctuation, numbers a, b, c and the like.
  const double bytes_beside = format == "json" ? 2500 : 700;
  const auto count = static_cast<double>(rows.size());
  const std::string what = fmt::format("{} numbers of {} digits", rows.size(), digits);
  options.memory_limit.check(
      {what,
       (bytes_per_digit * detail::worker_threads(ranks::threads(options.threads.value())).count() +
        bytes_kept * count) *
               static_cast<double>(computed) +
           bytes_beside * count});
  const table_text table = format == "csv"    ? as_csv(q, digits)
                           : format == "json" ? as_json(q, digits)
                                              : as_cpp(q, rows.size(), digits);
  print(table.head + compute(rows, q, computed, table, what, options) + table.end);
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
      "every number is certified, or nothing is printed. Under mpirun all ranks work on the "
      "table.\n",
      table_impl::declare, true};
}

}  // namespace polhode::cli
