// polhode cost: what accuracy costs in time, measured on this machine.

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/clock.hpp"
#include "cli/commands.hpp"
#include "cli/options/count_option.hpp"
#include "cli/options/options.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/cost_report.hpp"
#include "cli/output/duration.hpp"
#include "cli/output/gnuplot.hpp"
#include "cli/output/layout.hpp"
#include "cli/output/output_directory.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "cost/budget.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::cli {
namespace cost_impl {
namespace {

using cost::measurement;
using cost::time_budget;

constexpr long most_digits_of_estimate = 1'000'000'000;

struct cost_options {
  std::vector<std::string> names;
  bool list = false;
  bool no_hard_cases = false;
  bool data_only = false;
  count_option most_digits{"--max-digits", 1000, 16, 10'000'000};
  std::string seconds = "60";
  count_option estimate{"--estimate", 0, 0, most_digits_of_estimate};
  std::optional<std::string> directory;
  format_option format{{"text", "csv", "json"}};
  time_limit_option time_limit;
};

double seconds_of(const cost_options& options) {
  std::optional<rational> q;
  try {
    q = parse_rational(options.seconds);
  } catch (const std::exception&) {  // said below
  }
  if (!q || *q <= 0 || *q > 100'000) {
    throw usage_error(fmt::format("--seconds {}: it must be a number above 0 and at most 100000",
                                  in_quotes(options.seconds)));
  }
  return static_cast<double>(*q);
}

std::vector<long> digits_up_to(long most) {
  std::vector<long> result{16, 30, 50};
  for (long power = 100; power <= 10'000'000; power *= 10) {
    result.push_back(power);
    result.push_back(3 * power);
  }
  result.erase(std::remove_if(result.begin(), result.end(), [=](long n) { return n > most; }),
               result.end());
  return result;
}

std::vector<const cost::quantity*> selected(const cost_options& options) {
  const auto names =
      known_names(options.names, names_of(cost::quantities()), "quantity", "polhode cost --list");
  std::vector<const cost::quantity*> result;
  for (const cost::quantity& q : cost::quantities()) {
    if (names.empty() || std::find(names.begin(), names.end(), q.name) != names.end()) {
      result.push_back(&q);
    }
  }
  return result;
}

std::string list_of(const std::vector<const cost::quantity*>& quantities) {
  std::string result = fmt::format("{:<18}{:<52}{}\n", "QUANTITY", "WHAT IT IS", "METHODS");
  for (const cost::quantity* q : quantities) {
    const std::vector<std::string> lines = wrapped(q->description, 50);
    for (std::size_t i = 0; i < std::max(lines.size(), q->methods.size()); ++i) {
      const std::string method =
          i < q->methods.size()
              ? q->methods[i].name + (q->methods[i].certified ? ", certified" : "")
              : "";
      result += fmt::format("{:<18}{:<52}{}\n", i == 0 ? q->name : "",
                            i < lines.size() ? lines[i] : "", method);
    }
  }
  return result;
}

/// The true value, to a few digits more than are measured.
class references {
 public:
  explicit references(const cost::quantity& q) : first_(&q.methods.front()) {}
  [[nodiscard]] bool has(long digits) const { return known_.contains(digits); }
  const ball& at(long digits) {
    const auto found = known_.find(digits);
    if (found != known_.end()) return found->second;
    constexpr long more = 10;
    return known_[digits] = first_->compute(digits + more).value;
  }

 private:
  const cost::method* first_;
  std::map<long, ball> known_;
};

/// The fraction of the time for all that a measurement of short calls takes at least, and the
/// seconds that it takes at most.
constexpr double share_of_time = 0.001;
constexpr double most_for_short_calls = 0.04;

double least_seconds(const cost_options& options) {
  return std::min(most_for_short_calls, share_of_time * seconds_of(options));
}

measured_quantity measured(const cost::quantity& q, const std::vector<long>& digits,
                           const time_budget& budget, double least,
                           const cost::cold_processes& cold, const progress& line) {
  const auto index = static_cast<std::size_t>(&q - cost::quantities().data());
  measured_quantity result;
  result.what = &q;
  references known(q);
  for (std::size_t i = 0; i < q.methods.size(); ++i) {
    const cost::method& m = q.methods[i];
    std::vector<long> possible = digits;
    std::erase_if(possible, [&](long n) { return n > m.most_digits; });
    // A call whose memory is counted and one by the clock; of the first method also one in a new
    // process.
    const double calls = i == 0 ? 3 : 2;
    const auto of_reference = [&](long n) {
      if (m.certified || known.has(n)) return 0.0;
      return cost::extrapolated_seconds(result.methods.front().points, n).value_or(0);
    };
    const auto measured_at = [&](long n) {
      line.show(fmt::format("{}: {}, {} digits", q.name, m.name, n));
      std::optional<double> first_call;
      if (i == 0) first_call = cold.seconds(index, i, n);
      const std::optional<ball> reference =
          m.certified ? std::nullopt : std::optional<ball>(known.at(n));
      measurement point = cost::measure(m, n, reference, least);
      point.cold_seconds = first_call;
      return point;
    };
    cost::measured_points of_method = cost::measured_within(
        budget.share(q.methods.size() - i), possible, calls, of_reference, measured_at);
    result.methods.push_back({&m, std::move(of_method.points), std::move(of_method.left_out)});
  }
  return result;
}

measured_family measured(const cost::hard_family& f, long digits, const time_budget& budget,
                         double least, const progress& line) {
  // A member's time is expected to be at most so many times that of the one before.
  constexpr double growth = 3;
  measured_family result;
  result.what = &f;
  result.digits = digits;
  std::map<std::string, double> last_seconds;
  for (const long k : f.exponents) {
    const cost::quantity q = f.member(k);
    references known(q);
    for (const cost::method& m : q.methods) {
      if (m.most_digits < digits) continue;
      auto found = std::find_if(result.methods.begin(), result.methods.end(),
                                [&](const auto& x) { return x.name == m.name; });
      if (found == result.methods.end()) {
        result.methods.push_back({m.name, m.certified, {}, {}});
        found = std::prev(result.methods.end());
      }
      const bool is_first = found->points.empty();
      if (!found->left_out.empty() ||
          (!is_first && !budget.allows(growth * last_seconds[m.name]))) {
        found->left_out.push_back(k);
        continue;
      }
      line.show(fmt::format("hard {}: {}, k = {}", f.name, m.name, k));
      const double start = budget.now();
      const std::optional<ball> reference =
          m.certified ? std::nullopt : std::optional<ball>(known.at(digits));
      found->points.emplace_back(k, cost::measure(m, digits, reference, least));
      last_seconds[m.name] = budget.now() - start;
    }
  }
  return result;
}

std::string estimates(const std::vector<const cost::quantity*>& quantities, long digits) {
  std::string result;
  const progress line;
  for (const cost::quantity* q : quantities) {
    line.show("estimating " + q->name);
    const cost::method& m = q->methods.front();
    const double seconds = cost::estimate_cost(q->name, digits);
    result += fmt::format(
        "{:<18}{} digits by {}: about {}{}\n", q->name, digits, m.name, duration_text(seconds),
        digits > m.most_digits ? fmt::format(" (it is measured to {} at most)", m.most_digits)
                               : "");
  }
  return result;
}

exit_status run(const cost_options& options) {
  const std::vector<const cost::quantity*> quantities = selected(options);
  const std::vector<long> digits = digits_up_to(options.most_digits.value());
  const double allowed = seconds_of(options);
  const double least = least_seconds(options);
  const std::string& format = options.format.value();
  const long estimated = options.estimate.value();
  (void)options.time_limit.limit();
  if ((options.list || estimated > 0) &&
      (options.directory || options.data_only || format != "text")) {
    throw usage_error(
        "--list and --estimate print text: leave out --out, --data-only and --format");
  }
  if (options.list) {
    print(list_of(quantities));
    return exit_status::all_certified;
  }
  if (estimated > 0) {
    const time_watch watch(options.time_limit.limit(static_cast<double>(quantities.size())));
    print(estimates(quantities, estimated));
    return exit_status::all_certified;
  }
  std::vector<const cost::hard_family*> families;
  if (options.names.empty() && !options.no_hard_cases) {
    for (const cost::hard_family& f : cost::hard_families()) families.push_back(&f);
  }
  if (options.data_only && !options.directory) throw usage_error("--data-only: it needs --out DIR");
  // Before there are temporary files, of which its processes are to know nothing.
  const cost::cold_processes cold;
  std::optional<output_directory> directory;
  if (options.directory) {
    std::vector<std::string> files{"cost.csv", "cost.json"};
    if (!options.data_only) {
      require_gnuplot("give --data-only");
      for (const std::string& name : picture_names(quantities, families)) {
        files.push_back(name + ".svg");
        files.push_back(name + ".png");
      }
    }
    directory.emplace(*options.directory, files);
  }

  cost_report report;
  report.digits = digits;
  {
    const progress line;
    const time_watch watch(
        options.time_limit.limit(static_cast<double>(quantities.size() + families.size())));
    const auto start = detail::clock::now();
    const time_budget budget(allowed, [start] { return detail::seconds_since(start); });
    std::size_t parts = quantities.size() + families.size();
    for (const cost::quantity* q : quantities) {
      report.quantities.push_back(measured(*q, digits, budget.share(parts--), least, cold, line));
    }
    constexpr long digits_of_hard_cases = 30;
    for (const cost::hard_family* f : families) {
      report.families.push_back(
          measured(*f, digits_of_hard_cases, budget.share(parts--), least, line));
    }
    if (directory) {
      directory->write("cost.csv", as_csv(report));
      directory->write("cost.json", as_json(report));
      if (!options.data_only) {
        for (const cost_picture& p : pictures_of(report)) {
          line.show("drawing " + p.name);
          directory->write(
              p.name + ".svg",
              run_gnuplot(
                  "set terminal svg size 1200,600 font 'Helvetica,13' background 'white'\n" +
                      p.program,
                  "give --data-only"));
          directory->write(
              p.name + ".png",
              run_gnuplot(
                  "set terminal pngcairo size 1600,800 font 'Sans,13' background 'white'\n" +
                      p.program,
                  "give --data-only"));
        }
      }
      directory->publish();
    }
  }
  print(format == "csv" ? as_csv(report) : format == "json" ? as_json(report) : as_text(report));
  return exit_status::all_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<cost_options>();
  add_option(app, "NAME", options->names,
             "Quantities to measure, by name; without any, all of them, and hard cases")
      .type_name("");
  add_flag(app, "--list", options->list, "Show the quantities and their methods");
  options->most_digits.declare(app, "Measure at 16, 30, 50, 100, 300, ... digits up to N");
  add_option(app, "--seconds", options->seconds,
             "Measure for S seconds in all, of which every quantity and hard case has its "
             "share: leave\n"
             "out, and name, what is expected to pass it; the first point of each method is\n"
             "measured in any case [60]")
      .type_name("S");
  options->estimate.declare(app, "Estimate the time for N digits from short runs; 0: off");
  add_flag(app, "--no-hard-cases", options->no_hard_cases, "Leave out the hard cases");
  add_option(app, "--out", options->directory,
             "Write cost.csv, cost.json and the pictures there, as SVG and PNG; DIR is\n"
             "created where it is missing; all files appear, or none")
      .type_name("DIR");
  add_flag(app, "--data-only", options->data_only, "Without the pictures, which need gnuplot");
  options->format.declare(app);
  options->time_limit.declare(app, "quantity and hard case");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace cost_impl

command cost_command() {
  return {"cost", "Measure what accuracy costs in time, by every method there is",
          "  polhode cost\n"
          "  polhode cost half_phase --max-digits 3000\n"
          "  polhode cost --max-digits 10000 --seconds 10 --out costs\n"
          "  polhode cost beta c0 --estimate 1000000\n\n"
          "Certified methods are measured by their radius, the others by their distance from the "
          "certified\n"
          "value. docs/cost.md says how to read it.\n",
          cost_impl::declare};
}

}  // namespace polhode::cli
