#include "motion_option.hpp"

#include <charconv>

#include <fmt/format.h>

#include "body_option.hpp"
#include "cli/output/errors.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode::cli {
namespace {

std::optional<rational> number_in(const std::string& text) {
  try {
    return parse_rational(text);
  } catch (const input_error&) {
    return std::nullopt;
  }
}

std::optional<long> steps_in(const std::string& text) {
  long result = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, result);
  if (error != std::errc() || rest != end || result < 1 || result > most_steps) return std::nullopt;
  return result;
}

/// LO..HI; a number may end or begin with a point, so every ".." is tried.
std::optional<motion_range> range_in(const std::string& text) {
  for (std::size_t at = text.find(".."); at != std::string::npos; at = text.find("..", at + 1)) {
    const auto low = number_in(text.substr(0, at));
    const auto high = number_in(text.substr(at + 2));
    if (low && high) return motion_range{*low, *high, {}};
  }
  return std::nullopt;
}

void refuse_unless_ascending(const std::string& option, const std::string& text,
                             const motion_range& range) {
  if (range.low < range.high) return;
  throw usage_error(
      fmt::format("{} {}: the lower end must be below the upper one", option, in_quotes(text)));
}

}  // namespace

motion_range read_motion_range(const std::string& text, const body& rigid) {
  const auto result = range_in(text);
  if (!result) {
    throw usage_error(
        fmt::format("--c {}: it must be LO..HI, such as -0.06..0.06", in_quotes(text)));
  }
  refuse_unless_ascending("--c", text, *result);
  for (const rational& end : {result->low, result->high}) {
    try {
      (void)regime_of(rigid, end);
    } catch (const input_error& error) {
      throw usage_error(fmt::format("--c {}: {}", in_quotes(text), error.what()));
    }
  }
  return *result;
}

rational read_motion(const std::string& text, const body& rigid) {
  rational c = read_number("--c", text);
  try {
    (void)regime_of(rigid, c);
  } catch (const input_error& error) {
    throw usage_error(fmt::format("--c {}: {}", in_quotes(text), error.what()));
  }
  return c;
}

std::vector<rational> motion_range::values() const {
  if (!steps) return {low};
  std::vector<rational> result;
  result.reserve(static_cast<std::size_t>(*steps) + 1);
  for (long k = 0; k <= *steps; ++k) result.emplace_back(low + (high - low) * k / *steps);
  return result;
}

motion_range read_motions(const std::string& text, const std::string& option) {
  if (text.find("..") == std::string::npos) {
    const rational c = read_number(option, text);
    return {c, c, {}};
  }
  // The number of steps is behind the last "/": 0..1/3 is three steps, 0..1/3/10 ten.
  const std::size_t slash = text.rfind('/');
  std::optional<motion_range> result;
  if (slash != std::string::npos && slash > text.rfind("..")) {
    const auto steps = steps_in(text.substr(slash + 1));
    result = range_in(text.substr(0, slash));
    if (result && !steps) {
      throw usage_error(
          fmt::format("{} {}: behind the last / there must be the number of steps, from 1 to {}",
                      option, in_quotes(text), most_steps));
    }
    if (result) result->steps = steps;
  } else {
    result = range_in(text);
  }
  if (!result) {
    throw usage_error(fmt::format("{} {}: it must be LO..HI/N, such as {}, or one number", option,
                                  in_quotes(text),
                                  option == "--c" ? "-0.06..0.06/12" : "0.1..0.9/8"));
  }
  refuse_unless_ascending(option, text, *result);
  return *result;
}

ball certain(const certain_number& n, const std::string& what, long digits) {
  if (n.verdict == status::certified) return n.enclosure;
  throw not_certified_error(
      fmt::format("{} was not certified to {} digits ({})", what, digits, to_text(n.why)));
}

void refuse_equilibrium(const body& rigid, const rational& c, const std::string& name) {
  const regime r = regime_of(rigid, c);
  if (!is_equilibrium(r)) return;
  throw usage_error(fmt::format(
      "c = {}: {}, where the angular momentum does not move in the body and there is no {}; "
      "give c between -b = {} and a = {}, ends excluded",
      to_text(c), to_text(r), name, to_text(-rigid.b()), to_text(rigid.a())));
}

}  // namespace polhode::cli
