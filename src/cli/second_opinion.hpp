#pragma once

// --verify: a result is found again by a route that shares as little with the first as there is, and the two are compared.
//
// Each route proves that the true value lies in a set. Two such sets without a common number are a contradiction: one of the
// proofs is wrong, and nothing is printed as a result. Where they have one, and the second is as narrow as the digits
// that were asked for, the result is confirmed. A route that proves less confirms nothing.

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli_app.hpp"
#include "errors.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/verdict.hpp"
#include "polhode/certificate/certificate.hpp"

namespace polhode::cli {

/// --verify
struct verify_option {
  bool given = false;

  void declare(CLI::App& app);
  /// Throws usage_error, with --verify, where the format has no place for a second opinion: csv and cpp.
  void expect_format(const std::string& format) const;
};

/// What a route proved: that the number lies in the set.
template <class Set>
struct finding {
  std::string route;
  Set enclosure;
};

/// Throws contradiction_error where the two sets have no number in common; `what` is the number: "the integral". A set that is undefined or
/// unbounded holds everything.
void expect_overlap(std::string_view what, const finding<ball>& first, const finding<ball>& second);
void expect_overlap(std::string_view what, const finding<complex_ball>& first,
                    const finding<complex_ball>& second);

/// Throws contradiction_error: the first route proved one thing, and the second another that excludes it.
[[noreturn]] void contradict(std::string_view what, const finding<std::string>& first,
                             const finding<std::string>& second);

/// How wide an enclosure may be to confirm `first` to so many digits: the greater of first's radius and 10^-digits of its size.
[[nodiscard]] magnitude confirming_radius(const ball& first, long digits);
[[nodiscard]] magnitude confirming_radius(const complex_ball& first, long digits);

/// What came of one further route.
// NOLINTNEXTLINE(bugprone-exception-escape): its destructor is the library's
struct route_report {
  std::string route;     // "Gauss-Legendre, the range cut at 0.3704"
  std::string obstacle;  // why it confirms nothing; empty where it confirms the result
  json enclosure;        // as the command prints numbers; null where there is none
  std::string work;      // "76 evaluations with 233 bits"; may be empty
  double seconds = 0;

  [[nodiscard]] bool agrees() const { return obstacle.empty(); }
};

/// The routes tried, in their order.
class second_opinion {
 public:
  void add(route_report r) { tried_.push_back(std::move(r)); }
  /// A route confirms the result.
  [[nodiscard]] bool agrees() const;
  /// One line for each route that confirms the result; where there is none, one line with the reasons.
  [[nodiscard]] std::string as_text() const;
  /// {"agrees", "route", "enclosure", "cost", "further"} of the first route that confirms the result and those after it; where there is none,
  /// {"agrees": false, "tried"} with the reasons.
  [[nodiscard]] json as_json() const;
  /// What a certified result exits with.
  [[nodiscard]] exit_status status() const {
    return agrees() ? exit_status::all_certified : exit_status::not_certified;
  }

 private:
  std::vector<route_report> tried_;
};

/// Has the independent checker (`polhode check`) show the certificate again. What it refutes is a contradiction; `what` is the number, and
/// `first` the route that the certificate's number comes from.
[[nodiscard]] route_report checked_again(std::string_view what, const std::string& first,
                                         const json& certificate);

/// Seconds since it was made.
class stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace polhode::cli
