#include "memory_limit.hpp"

#include <unistd.h>

#include <algorithm>

#include <fmt/format.h>

#include "cli/output/errors.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::cli {
namespace {

constexpr double gib = 1024.0 * 1024.0 * 1024.0;

double default_limit() {
  constexpr double most = 4 * gib;
  const auto pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  const auto page_size = static_cast<double>(sysconf(_SC_PAGE_SIZE));
  if (pages <= 0 || page_size <= 0) return most;
  return std::min(most, 0.75 * pages * page_size);
}

double limit_from(const std::string& text) {
  try {
    const rational given = parse_rational(text);
    if (given > 0) return static_cast<double>(given) * gib;
  } catch (const input_error&) {
    // Said below, with the option's name.
  }
  throw usage_error(fmt::format(
      "--memory-limit {}: it must be a positive number of GiB, such as 16", in_quotes(text)));
}

/// Two significant digits below 10, whole numbers above.
std::string in_gib(double bytes) {
  const double value = bytes / gib;
  return value < 9.95 ? fmt::format("{:.2g} GiB", value) : fmt::format("{:.0f} GiB", value);
}

}  // namespace

void memory_limit_option::declare(CLI::App& app) {
  add_option(app, "--memory-limit", text,
             "Refuse what is estimated to need more memory\n"
             "[4, or 3/4 of the memory where that is less]")
      .type_name("GIB");
}

void memory_limit_option::check(const memory_estimate& estimate) const {
  const double limit = text ? limit_from(*text) : default_limit();
  if (estimate.bytes <= limit) return;
  throw usage_error(fmt::format("{} need about {}; the limit is {} (--memory-limit raises it)",
                                estimate.what, in_gib(estimate.bytes), in_gib(limit)));
}

}  // namespace polhode::cli
