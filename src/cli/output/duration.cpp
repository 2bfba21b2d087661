#include "duration.hpp"

#include <cmath>

#include <fmt/format.h>

namespace polhode::cli {

std::string duration_text(double seconds) {
  constexpr double minute = 60;
  constexpr double hour = 60 * minute;
  constexpr double day = 24 * hour;
  constexpr double year = 365.25 * day;
  // A unit is used from two of it on.
  const auto in = [seconds](double unit, const char* name) {
    const double count = seconds / unit;
    return fmt::format(
        "{} {}", count < 9.95 ? fmt::format("{:.2g}", count) : fmt::format("{:.0f}", count), name);
  };
  if (seconds < 2 * minute) return in(1, "s");
  if (seconds < 2 * hour) return in(minute, "min");
  if (seconds < 2 * day) return in(hour, "h");
  if (seconds < 2 * year) return in(day, "days");
  constexpr double many = 1e6;
  if (seconds < many * year) return in(year, "years");
  return fmt::format("10^{:.0f} years", std::log10(seconds / year));
}

}  // namespace polhode::cli
