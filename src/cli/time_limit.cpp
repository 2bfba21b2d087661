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
  double seconds = 0;
  for (const work& one : works) {
    const auto of_one = cost::estimated_seconds_of_work(one, digits);
    if (!of_one) return std::nullopt;
    seconds += *of_one * times;
  }
  if (seconds <= most) return seconds;
  throw usage_error(
      fmt::format("{} are estimated to take {}; the limit is {} (--time-limit raises it)", what,
                  duration_text(seconds), duration_text(most)));
}

}  // namespace polhode::cli
