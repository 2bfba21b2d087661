#pragma once

// Time, accuracy and memory of a method, measured; and a model of the time at digits that were not.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "quantity.hpp"

namespace polhode::cost {

struct measurement {
  long digits = 0;                     // asked for
  double seconds = 0;                  // of a later call in this process: the median
  std::optional<double> cold_seconds;  // of the first call in a process, with no nodes on disk
  /// log10 of the relative error: certified, of the radius; else of the distance from the certified
  /// value, which is known to `digits` and some more. Nothing where the method gave no number.
  std::optional<double> log10_error;
  std::optional<double> log10_claimed;  // as the method said
  long evaluations = 0;
  double bytes = 0;  // the most that its multiple-precision numbers took at a time

  /// The error is at most 10^-digits.
  [[nodiscard]] bool has_digits() const;
  /// It says that its error is less than a tenth of what it is, and it has not the digits asked
  /// for.
  [[nodiscard]] bool claims_too_much() const;
};

/// First calls, each in a process that has computed nothing: make it before anything is computed in
/// this one. Where there are no such processes, nothing is measured.
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

/// The time at `digits` by the last two of some measurements, a power of the digits through both;
/// nothing where there is none.
[[nodiscard]] std::optional<double> extrapolated_seconds(const std::vector<measurement>& known,
                                                         long digits);

/// The exponent of the digits that time grows by, by least squares over the measurements of 300
/// digits and more, or over the last 3 where those are fewer, of measurements by growing digits;
/// nothing where there are fewer than 3.
[[nodiscard]] std::optional<double> growth_exponent(const std::vector<measurement>& known);

/// What f takes where no other program is in the way. The shortest of three calls or more, for a
/// hundredth of a second; of a call that takes so long that others may have been in the way of all
/// of them, the processor's time, where that is less than the clock's (on several threads it is
/// more).
[[nodiscard]] double undisturbed_seconds(const std::function<void()>& f);

/// Seconds of a multiplication of two numbers of so many digits, M(n).
[[nodiscard]] double multiplication_seconds(long digits);

/// Estimates of a time from times t at growing numbers of digits: between two of them, a power of
/// the digits through both. Beyond the last one, N, t(n) = t(N) (M(n)/M(N)) (n/N)^e: the
/// multiplications that are done, t/M, grow by the power e, the greater of those between the last
/// time and each of the two before it, which is at least -1/2 (calls cost more than multiplications
/// while digits are few) and at most 2. Beyond 4N, e is at least 1/10: no count of multiplications
/// falls for long. Where only one time is known, e = 0.
class cost_model {
 public:
  /// Throws std::invalid_argument without a time.
  explicit cost_model(std::vector<std::pair<long, double>> known,
                      std::function<double(long digits)> multiplication = multiplication_seconds);
  [[nodiscard]] double seconds(long digits) const;

 private:
  std::vector<std::pair<long, double>> known_;  // digits and seconds
  std::function<double(long digits)> multiplication_;
  double exponent_ = 0;
};

/// Seconds at `digits`, by the cost_model of timed(n) for n = 30, 60, 120, ... up to `most_timed`.
/// A time is taken as long as it is itself estimated to be at most 0.03 s, or at most a tenth of
/// what is estimated for `digits`, and in any case at most `longest_call`; the first is always
/// taken. So the more there is to be done, the nearer to it the last time is. Nothing where
/// `most_timed` is below 30.
[[nodiscard]] std::optional<double> estimated_seconds(
    const std::function<double(long digits)>& timed, long digits, long most_timed,
    double longest_call,
    const std::function<double(long digits)>& multiplication = multiplication_seconds);

/// Seconds of a later call of the first method of the quantity of that name, undisturbed, by
/// estimated_seconds with calls of up to a second. Throws std::invalid_argument for an unknown
/// name.
[[nodiscard]] double estimate_cost(const std::string& name, long digits);

/// Whether work(digits) takes at most so many seconds, if its time grows no faster than the cube of
/// the digits: judged by one call each of work(30), work(240), work(1920), ..., as long as these
/// take little. Much cheaper than an estimate. False where a call throws.
[[nodiscard]] bool is_short_work(const std::function<void(long digits)>& work, long digits,
                                 double seconds);

/// Seconds that work(digits) would take: by estimated_seconds with calls of up to a second and half
/// of the digits. Nothing where a call throws, or the digits are fewer than 60.
[[nodiscard]] std::optional<double> estimated_seconds_of_work(
    const std::function<void(long digits)>& work, long digits);

}  // namespace polhode::cost
