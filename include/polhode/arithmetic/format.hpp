#pragma once

// fmt::format("{:.20}", x) for balls: to_decimal(x, 20). Without a number of digits, 6 as iostreams
// do.

#include <fmt/format.h>

#include "polhode/arithmetic/text.hpp"

template <>
struct fmt::formatter<polhode::ball> {
  constexpr auto parse(fmt::format_parse_context& context) {
    auto it = context.begin();
    if (it != context.end() && *it == '.') {
      ++it;
      long digits = 0;
      while (it != context.end() && *it >= '0' && *it <= '9' && digits < 100'000'000) {
        digits = 10 * digits + (*it++ - '0');
      }
      if (digits < 1) throw fmt::format_error("a ball's format is {} or {:.DIGITS}");
      digits_ = digits;
    }
    if (it != context.end() && *it != '}') {
      throw fmt::format_error("a ball's format is {} or {:.DIGITS}");
    }
    return it;
  }

  auto format(const polhode::ball& x, fmt::format_context& context) const {
    return fmt::format_to(context.out(), "{}", polhode::to_decimal(x, digits_));
  }

 private:
  long digits_ = 6;
};
