#include "time_limit.hpp"

#include <algorithm>
#include <array>
#include <chrono>

#include <fmt/format.h>

#include "cli/interruption.hpp"
#include "cli/output/duration.hpp"
#include "cli/output/errors.hpp"
#include "cli/output/progress.hpp"
#include "cost/measure.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::cli {
namespace {

struct unit_of_time {
  char letter;
  double seconds;
};
constexpr std::array units{unit_of_time{'s', 1}, unit_of_time{'m', 60}, unit_of_time{'h', 3600},
                           unit_of_time{'d', 86'400}};

[[noreturn]] void end_for_want_of_time(double seconds) {
  const std::string doing = current_activity();
  end_program(fmt::format("polhode: not certified: the time limit of {} was reached{} "
                          "(--time-limit raises it, as in --time-limit 2h)\n",
                          duration_text(seconds), doing.empty() ? "" : " while " + doing),
              exit_status::not_certified);
}

}  // namespace

time_watch::time_watch(double seconds)
    : thread_(without_signals([this, seconds] {
        constexpr double most = 3e9;  // some hundred years
        const auto end = std::chrono::steady_clock::now() +
                         std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                             std::chrono::duration<double>(std::min(seconds, most)));
        std::unique_lock lock(mutex_);
        if (!ended_changed_.wait_until(lock, end, [this] { return ended_; })) {
          end_for_want_of_time(seconds);
        }
      })) {}

time_watch::~time_watch() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  ended_changed_.notify_one();
  thread_.join();
}

void time_limit_option::declare(CLI::App& app, const std::string& each) {
  add_option(app, "--time-limit", text,
             "Refuse what is estimated to take longer, and end what does:\n"
             "90s, 10m, 2h, 1d [10m for each " +
                 each + "]")
      .type_name("TIME");
}

double time_limit_option::limit(double numbers) const {
  constexpr double usual_seconds = 600;
  if (!text) return usual_seconds * std::max(numbers, 1.0);
  const char letter = text->empty() ? ' ' : text->back();
  for (const unit_of_time& unit : units) {
    if (unit.letter != letter) continue;
    try {
      const rational given = parse_rational(text->substr(0, text->size() - 1));
      if (given > 0) return static_cast<double>(given) * unit.seconds;
    } catch (const input_error&) {
      // Said below, with the option's name.
    }
  }
  throw usage_error(
      fmt::format("--time-limit {}: it must be a time with its unit, such as 90s, 10m, 2h or 1d",
                  in_quotes(*text)));
}

std::optional<double> time_limit_option::check(const std::string& what, long digits,
                                               const std::vector<work>& works, double times) const {
  const double most = limit(times * static_cast<double>(works.size()));
  constexpr long few_digits = 3000;
  if (digits < few_digits) return std::nullopt;
  constexpr double enough_for_an_estimate = 60;
  const time_watch watch(std::max(most, enough_for_an_estimate));
  double seconds = 0;
  // What is soon done needs no estimate.
  constexpr double soon = 5;
  const double each = std::min(soon, most) / (times * static_cast<double>(works.size()));
  if (std::ranges::all_of(
          works, [&](const work& one) { return cost::is_short_work(one, digits, each); })) {
    return std::nullopt;
  }
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
