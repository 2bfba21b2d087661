#include "time_limit.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cost/measure.hpp"
#include "duration.hpp"
#include "errors.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::cli {
namespace {

constexpr double day = 86'400;

}  // namespace

void time_limit_option::declare(CLI::App& app) {
  app.add_option("--time-limit", text, "Refuse what is estimated to take more days [30]")
      ->type_name("DAYS");
}

double time_limit_option::limit() const {
  constexpr double usual_days = 30;
  if (!text) return usual_days * day;
  try {
    const rational given = parse_rational(*text);
    if (given > 0) return static_cast<double>(given) * day;
  } catch (const input_error&) {
    // Said below, with the option's name.
  }
  throw usage_error(fmt::format("--time-limit {}: it must be a positive number of days, such as 90",
                                in_quotes(*text)));
}

std::optional<double> time_limit_option::check(const std::string& what, long digits,
                                               const std::vector<work>& works, double times) const {
  const double most = limit();
  constexpr long few_digits = 3000;
  if (digits < few_digits) return std::nullopt;
  const auto estimate = [&](double longest_call) -> std::optional<double> {
    double sum = 0;
    for (const work& one : works) {
      const auto seconds = cost::estimated_seconds(one, digits, longest_call);
      if (!seconds) return std::nullopt;
      sum += *seconds * times;
    }
    return sum;
  };
  constexpr double short_call = 0.03;
  constexpr double long_call = 1;
  std::optional<double> seconds = estimate(short_call);
  // That was from far below. Where much is to be done, a second more is spent to estimate it from nearer, before anything is refused.
  constexpr double much = 20;
  if (seconds && *seconds > std::min(much, most)) seconds = estimate(long_call);
  if (!seconds || *seconds <= most) return seconds;
  throw usage_error(
      fmt::format("{} are estimated to take {}; the limit is {} (--time-limit raises it)", what,
                  duration_text(*seconds), duration_text(most)));
}

}  // namespace polhode::cli
