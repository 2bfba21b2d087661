#pragma once

// The measuring core of bench/: contestants that do the same work are run in turns, batch by batch,
// and compared by medians, so that a drift of the machine falls on all of them alike.
//
// A program declares tables of rows. Each row is registered with Google Benchmark (whose
// --benchmark_filter, --benchmark_list_tests and --benchmark_out serve as usual; --json FILE is
// short for the last; --quick measures three rounds at most, for a look), and printed as one line:
// the median time of a call for each contestant, then the ratios of two contestants that the table
// is about, "/Arb" for the first one's time over Arb's. A ratio is the median of the rounds'
// ratios; where it misses the limit printed beside it, it is marked with an exclamation mark.

#include <algorithm>
#include <functional>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "environment.hpp"
#include "stopwatch.hpp"

namespace polhode::bench {

/// Something that is timed: `batch(calls)` makes that many calls and returns the seconds they took.
struct contestant {
  std::function<double(long calls)> batch;
  bool repeatable = true;  // false where a batch is to be one call: the first one of a process
};

/// Calls of f in this process, after a first one that is not counted.
template <class F>
[[nodiscard]] contestant warm(F f) {
  f();
  return {[f](long calls) mutable { return seconds_of(f, calls); }};
}

/// The first call of f in a process that has called nothing before: a child of its own each time.
/// What is in this process when its children are made is theirs too, so no row of such a program
/// may compute outside its children.
template <class F>
[[nodiscard]] contestant cold(F f) {
  return {[f](long) { return in_child([f]() mutable { return seconds_of(f, 1); }); }, false};
}

/// Later calls of f in a child process, which makes one call first.
template <class F>
[[nodiscard]] contestant warm_in_child(F f) {
  return {[f](long calls) {
    return in_child([f, calls]() mutable {
      f();
      return seconds_of(f, calls);
    });
  }};
}

struct ratio_limit {
  enum class kind { at_most, at_least } direction;
  double value;
};
[[nodiscard]] inline ratio_limit at_most(double x) { return {ratio_limit::kind::at_most, x}; }
[[nodiscard]] inline ratio_limit at_least(double x) { return {ratio_limit::kind::at_least, x}; }

/// The quotient of two contestants' times.
struct ratio {
  std::size_t numerator;
  std::size_t denominator;
  std::optional<ratio_limit> bound = std::nullopt;
};

struct table {
  std::string name;   // the first part of its rows' names
  std::string about;  // printed above it
  std::vector<std::string> contestants;
  std::vector<std::string> ratios;
  int label_width = 11;
};

/// What a row measures, made when its turn comes.
struct row {
  std::vector<contestant> contestants;
  std::vector<ratio> ratios;
};

/// What came out of a row. A line that has no times, such as a mean of other rows, leaves `seconds`
/// empty.
struct outcome {
  // The median of a call of each contestant; of the first ones, where the others do not take part.
  std::vector<double> seconds;
  std::vector<double> ratios;
  std::vector<std::optional<ratio_limit>> bounds;
  std::string remark = {};  // printed after the ratios
};

namespace detail {

inline constexpr double least_batch_seconds = 1e-3;
/// How long a row is measured, and in how many rounds at least, or in how many there is time for
/// where they are long.
struct effort {
  double row_seconds = 0.4;
  int least_rounds = 7;
  double most_row_seconds = 30;
};
/// --quick lessens it, for the whole program.
[[nodiscard]] inline effort& effort_of_program() {
  static effort chosen;
  return chosen;
}
inline constexpr int most_rounds = 151;
inline constexpr int limit_width = 6;

[[nodiscard]] inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Calls in a batch, and the seconds the batch takes.
struct batch_size {
  long calls = 1;
  double seconds = 0;
};
[[nodiscard]] inline batch_size calibrate(const contestant& c) {
  batch_size size;
  while (true) {
    size.seconds = c.batch(size.calls);
    if (!c.repeatable || size.seconds >= least_batch_seconds) return size;
    const double growth = 1.2 * least_batch_seconds / std::max(size.seconds, 1e-9);
    size.calls = static_cast<long>(static_cast<double>(size.calls) * std::min(growth, 100.0)) + 1;
  }
}

[[nodiscard]] inline outcome measure(const row& r) {
  std::vector<batch_size> sizes;
  double round_seconds = 0;
  for (const contestant& c : r.contestants) {
    sizes.push_back(calibrate(c));
    round_seconds += sizes.back().seconds;
  }
  const effort& wanted = effort_of_program();
  const int affordable = std::max(1, static_cast<int>(wanted.most_row_seconds / round_seconds));
  const int rounds = std::clamp(static_cast<int>(wanted.row_seconds / round_seconds),
                                std::min(wanted.least_rounds, affordable), most_rounds);
  std::vector<std::vector<double>> seconds(r.contestants.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < r.contestants.size(); ++i) {
      const double total = r.contestants[i].batch(sizes[i].calls);
      seconds[i].push_back(total / static_cast<double>(sizes[i].calls));
    }
  }
  outcome result;
  for (const auto& of_one : seconds) result.seconds.push_back(median(of_one));
  for (const ratio& q : r.ratios) {
    std::vector<double> of_rounds;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rounds); ++i) {
      of_rounds.push_back(seconds[q.numerator][i] / seconds[q.denominator][i]);
    }
    result.ratios.push_back(median(of_rounds));
    result.bounds.push_back(q.bound);
  }
  return result;
}

/// "-" for 0: not measured.
[[nodiscard]] inline std::string time_text(double seconds) {
  if (seconds == 0) return "-";
  const char* unit = "s ";
  if (seconds < 1e-6) {
    unit = "ns";
    seconds *= 1e9;
  } else if (seconds < 1e-3) {
    unit = "us";
    seconds *= 1e6;
  } else if (seconds < 1) {
    unit = "ms";
    seconds *= 1e3;
  }
  std::ostringstream out;
  out << std::fixed << std::setprecision(seconds < 10 ? 2 : (seconds < 100 ? 1 : 0)) << seconds
      << ' ' << unit;
  return out.str();
}

[[nodiscard]] inline std::string ratio_text(double value, const std::optional<ratio_limit>& bound) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(value < 100 ? 2 : 0) << value;
  if (!bound) return out.str() + std::string(2 + limit_width, ' ');
  const bool at_most = bound->direction == ratio_limit::kind::at_most;
  const bool missed = at_most ? value > bound->value : value < bound->value;
  std::ostringstream wanted;
  wanted << (at_most ? "<=" : ">=") << std::defaultfloat << bound->value;
  std::string text = wanted.str();
  text.resize(limit_width, ' ');
  return out.str() + (missed ? "! " : "  ") + text;
}

}  // namespace detail

/// The tables of a program, in the order in which their first rows are added.
class suite {
 public:
  /// `make` is called when the row is measured.
  void add(const table& of, const std::string& label, std::function<row()> make) {
    add_measured(of, label, [make = std::move(make)] { return detail::measure(make()); });
  }

  /// A row that measures itself.
  void add_measured(const table& of, const std::string& label, std::function<outcome()> measure) {
    const std::string name = of.name + '/' + label;
    benchmark::RegisterBenchmark(name.c_str(),
                                 [this, of, label, measure = std::move(measure)](
                                     benchmark::State& state) { run(of, label, measure(), state); })
        ->Iterations(1)
        ->UseManualTime();
  }

  /// Tables whose names begin so take minutes, and are measured only where a filter asks for them.
  static inline const std::string slow = "slow";

  /// Runs the rows that --benchmark_filter asks for. Returns the exit status.
  int main(int argc, char** argv) {
    std::vector<std::string> texts = with_json_as_output(argc, argv);
    std::vector<char*> arguments;
    for (std::string& text : texts) arguments.push_back(text.data());
    int count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    for (const auto& [name, value] : environment()) benchmark::AddCustomContext(name, value);
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
    silent_reporter silent;
    benchmark::RunSpecifiedBenchmarks(&silent);
    benchmark::Shutdown();
    return 0;
  }

 private:
  class silent_reporter : public benchmark::BenchmarkReporter {
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>&) override {}
  };

  static std::vector<std::string> with_json_as_output(int argc, char** argv) {
    std::vector<std::string> result{argv[0], "--benchmark_filter=-^" + slow};
    for (int i = 1; i < argc; ++i) {
      if (std::string(argv[i]) == "--json" && i + 1 < argc) {
        result.push_back(std::string("--benchmark_out=") + argv[++i]);
        result.emplace_back("--benchmark_out_format=json");
      } else if (std::string(argv[i]) == "--quick") {
        detail::effort_of_program() = {0.03, 3, 3};
      } else {
        result.emplace_back(argv[i]);
      }
    }
    return result;
  }

  void run(const table& of, const std::string& label, const outcome& result,
           benchmark::State& state) {
    const double first = result.seconds.empty() ? 0 : result.seconds.front();
    for ([[maybe_unused]] auto _ : state) state.SetIterationTime(first);
    for (std::size_t i = 0; i < result.seconds.size(); ++i) {
      state.counters["seconds, " + of.contestants[i]] = result.seconds[i];
    }
    for (std::size_t i = 0; i < result.ratios.size(); ++i) {
      state.counters["ratio, " + of.ratios[i]] = result.ratios[i];
    }
    if (open_table_ != of.name) print_head(of, open_table_.empty());
    open_table_ = of.name;
    std::ostringstream line;
    line << std::left << std::setw(of.label_width) << label << std::right;
    for (std::size_t i = 0; i < of.contestants.size(); ++i) {
      const std::string none = result.seconds.empty() ? "" : "-";
      line << std::setw(time_width(of.contestants[i]))
           << (i < result.seconds.size() ? detail::time_text(result.seconds[i]) : none);
    }
    for (std::size_t i = 0; i < result.ratios.size(); ++i) {
      line << std::setw(ratio_width(of.ratios[i]) + after_ratio)
           << detail::ratio_text(result.ratios[i], result.bounds[i]);
    }
    print(line.str() + result.remark);
  }

  static void print_head(const table& of, bool first) {
    std::cout << '\n' << of.about << '\n';
    if (first) {
      for (const auto& [name, value] : environment()) std::cout << name << ": " << value << '\n';
    }
    std::cout << '\n';
    std::ostringstream line;
    line << std::setw(of.label_width) << "";
    for (const std::string& name : of.contestants) line << std::setw(time_width(name)) << name;
    for (const std::string& name : of.ratios) {
      line << std::setw(ratio_width(name)) << name << "  limit" << std::setw(after_ratio - 7) << "";
    }
    print(line.str());
  }

  /// Without the spaces at its end.
  static void print(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    std::cout << line << std::endl;
  }

  // 100 columns hold four contestants and three ratios, all with short names.
  static int time_width(const std::string& name) {
    return std::max(10, static_cast<int>(name.size()) + 2);
  }
  static int ratio_width(const std::string& name) {
    return std::max(8, static_cast<int>(name.size()) + 2);
  }
  static constexpr int after_ratio = 2 + detail::limit_width;

  std::string open_table_;
};

}  // namespace polhode::bench
