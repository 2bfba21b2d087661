#pragma once

// Integrals with their values, all as texts.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"

namespace polhode::support {

inline end_point number(const std::string& text) {
  if (text == "inf") return end_point::infinity();
  if (text == "-inf") return -end_point::infinity();
  return end_point_of(parse(text, {}));
}

inline integral integral_of(const std::string& f, const std::string& a, const std::string& b,
                            long digits = 30) {
  return integrate(parse(f), number(a), number(b), {.digits = digits});
}

struct integral_as_text {
  std::string f;
  std::string from;
  std::string to;
  std::string value;
};

/// They are certified, and hold the values.
inline void expect_values(const std::vector<integral_as_text>& all) {
  for (const integral_as_text& k : all) {
    const integral i = integral_of(k.f, k.from, k.to);
    EXPECT_EQ(i.verdict, status::certified) << k.f << ": " << i.obstacle;
    EXPECT_TRUE(overlaps(i.enclosure, parse(k.value, {}).value(300))) << k.f;
  }
}

}  // namespace polhode::support
