#pragma once

// Time, accuracy and memory of a method, measured; and a model of the time at digits that were not.

#include <memory>

#include "quantity.hpp"

namespace polhode::cost {

struct measurement {
  long digits = 0;                     // asked for
  double seconds = 0;                  // of a later call in this process: the median
  std::optional<double> cold_seconds;  // of the first call in a process, with no nodes on disk
  /// log10 of the relative error: certified, of the radius; else of the distance from the certified value, which is
  /// known to `digits` and some more. Nothing where the method gave no number.
  std::optional<double> log10_error;
  std::optional<double> log10_claimed;  // as the method said
  long evaluations = 0;
  double bytes = 0;  // the most that its multiple-precision numbers took at a time

  /// The error is at most 10^-digits.
  [[nodiscard]] bool has_digits() const;
  /// It says that its error is less than a tenth of what it is, and it has not the digits asked for.
  [[nodiscard]] bool claims_too_much() const;
};

/// First calls, each in a process that has computed nothing: make it before anything is computed in this one. Where
/// there are no such processes, nothing is measured.
class cold_processes {
 public:
  cold_processes();
  ~cold_processes();
  cold_processes(const cold_processes&) = delete;
  cold_processes& operator=(const cold_processes&) = delete;
  cold_processes(cold_processes&&) = delete;
  cold_processes& operator=(cold_processes&&) = delete;

  /// Seconds of the first call of quantities()[q].methods[m].compute(digits).
  [[nodiscard]] std::optional<double> seconds(std::size_t q, std::size_t m, long digits) const;

 private:
  int child_ = -1;
  int process_ = -1;
};

/// Measures it; the reference holds the true value, nothing where the method is certified.
/// For at least `least_seconds` in all, or 25 calls.
[[nodiscard]] measurement measure(const method& m, long digits,
                                  const std::optional<ball>& reference, double least_seconds);

/// The time at `digits` by the last two of some measurements, a power of the digits through both; nothing where there is none.
[[nodiscard]] std::optional<double> extrapolated_seconds(const std::vector<measurement>& known,
                                                         long digits);

/// The exponent of the digits that time grows by, by least squares over the measurements of 300 digits and more, or over all
/// where there are fewer than 3 of those; nothing where there are fewer than 3.
[[nodiscard]] std::optional<double> growth_exponent(const std::vector<measurement>& known);

/// Estimates of what a quantity costs by its first method: between sizes that were timed, a power of the digits through both;
/// beyond the last one, N, t(n) = t(N) (M(n)/M(N)) (n/N)^e with M(n) the time of a multiplication of n digits, measured, and e from
/// the last two. Calibrated by calls of up to about a tenth of a second in all.
class cost_model {
 public:
  explicit cost_model(const quantity& q);
  /// From times at growing numbers of digits, of which there is one at least.
  explicit cost_model(std::vector<std::pair<long, double>> known);
  [[nodiscard]] double seconds(long digits) const;

 private:
  std::vector<std::pair<long, double>> known_;  // digits and seconds
  double exponent_ = 0;
};

/// The quantity of that name by a model calibrated once in this process. Throws std::invalid_argument for an unknown name.
[[nodiscard]] double estimate_cost(const std::string& name, long digits);

/// Seconds that work(digits) would take: by the model of calls with 30, 120, 480, ... digits, fewer than half of those, until one takes
/// longer than `longest_call` seconds. Nothing where a call throws.
[[nodiscard]] std::optional<double> estimated_seconds(const std::function<void(long digits)>& work,
                                                      long digits, double longest_call);

/// Seconds of a multiplication of two numbers of so many digits.
[[nodiscard]] double multiplication_seconds(long digits);

}  // namespace polhode::cost
