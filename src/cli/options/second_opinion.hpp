#pragma once

// --verify: how a second opinion (polhode/verify) is asked for and printed.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/cli_app.hpp"
#include "cli/output/errors.hpp"
#include "polhode/certificate/certificate.hpp"
#include "polhode/verify/second_opinion.hpp"

namespace polhode::cli {

/// --verify
struct verify_option {
  bool given = false;

  void declare(CLI::App& app);
  /// Throws usage_error, with --verify, where the format has no place for a second opinion: csv and
  /// cpp.
  void expect_format(const std::string& format) const;
};

/// What came of one further route, as it is printed.
// NOLINTNEXTLINE(bugprone-exception-escape): its destructor is the library's
struct printed_route {
  std::string route;     // "Gauss-Legendre, the range cut at 0.3704"
  std::string obstacle;  // why it confirms nothing; empty where it confirms the result
  json enclosure;        // as the command prints numbers; null where there is none
  std::string work;      // "76 evaluations with 233 bits"; may be empty
  double seconds = 0;

  [[nodiscard]] bool agrees() const { return obstacle.empty(); }
};

/// The routes tried, in their order, as they are printed.
class printed_opinion {
 public:
  printed_opinion() = default;
  /// Enclosures are printed to so many digits.
  printed_opinion(const second_opinion& opinion, long digits);

  void add(printed_route r) { tried_.push_back(std::move(r)); }
  /// A route confirms the result.
  [[nodiscard]] bool agrees() const;
  /// One line for each route that confirms the result; where there is none, one line with the
  /// reasons.
  [[nodiscard]] std::string as_text() const;
  /// {"agrees", "route", "enclosure", "cost", "further"} of the first route that confirms the
  /// result and those after it; where there is none, {"agrees": false, "tried"} with the reasons.
  [[nodiscard]] json as_json() const;
  /// What a certified result exits with.
  [[nodiscard]] exit_status status() const {
    return agrees() ? exit_status::all_certified : exit_status::not_certified;
  }

 private:
  std::vector<printed_route> tried_;
};

/// Has the independent checker (`polhode check`) show the certificate again. What it refutes is a
/// contradiction; `what` is the number, and `first` the route that the certificate's number comes
/// from.
[[nodiscard]] printed_route checked_again(std::string_view what, const std::string& first,
                                          const json& certificate);

}  // namespace polhode::cli
