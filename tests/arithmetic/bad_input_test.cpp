// What cannot be used is refused with one line that says what was given and what is accepted. Every
// entry point that takes text, end points, digits or a precision.

#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/double_interval.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/format.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/arithmetic/text.hpp"
#include "support/real.hpp"

namespace polhode {
namespace bad_input_test {

using support::real;

/// f throws an Error; its message is one line that holds both texts and is not long.
template <class Error, class F>
void expect_refusal(F&& f, const std::string& given, const std::string& accepted) {
  try {
    f();
    ADD_FAILURE() << "accepted: " << given;
  } catch (const Error& e) {
    const std::string message = e.what();
    EXPECT_NE(message.find(given), std::string::npos) << message;
    EXPECT_NE(message.find(accepted), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_LT(message.size(), 400U) << message;
  }
}

TEST(BadInput, Numbers) {
  const auto refused = [](const std::string& text, const std::string& accepted) {
    const std::string shown = text.substr(0, 40);
    expect_refusal<input_error>([&] { (void)parse_rational(text); }, shown, accepted);
    expect_refusal<input_error>([&] { (void)parse_ball(text, 64); }, shown, accepted);
  };
  for (const char* text : {"", "0x", "0x1", "nan", "inf", "-inf", "1e", "1.2.3", "--1", " 1", "1,5",
                           "1/", "/2", "1/2/3", "[1, 2]", "1 .. 2"}) {
    refused(text, "give a decimal such as 0.0629 or 1e-12, or a quotient such as 1/4");
  }
  refused("1/0", "divides by zero");
  expect_refusal<input_error>([] { (void)parse_rational("1\n2\t"); }, "\"1?2?\"", "give a decimal");
  expect_refusal<input_error>([] { (void)parse_exact_text("64:\n"); }, "\"64:?\"", "accepted are");
  expect_refusal<input_error>([] { (void)parse_interval("[\n]", 64); }, "\"[?]\"",
                              "an interval is");
  refused("1e200001", "beyond +-200000");
  refused("1e-99999999999999999999", "beyond +-200000");
  // The longest mantissa that is read, and one of a million digits.
  EXPECT_NO_THROW((void)parse_ball(std::string(longest_number_text, '7'), 64));
  for (const char digit : {'7', 'x', '0'}) {
    const std::string long_text(1'000'000, digit);
    expect_refusal<input_error>([&] { (void)parse_rational(long_text); }, "1000000 characters",
                                "at most 200000");
    expect_refusal<input_error>([&] { (void)parse_ball(long_text, 64); }, "1000000 characters",
                                "at most 200000");
  }
}

TEST(BadInput, ExactText) {
  const std::string accepted = "accepted are PRECISION:MIDPOINT+-RADIUS";
  for (const char* text : {"", "0x", "64", "64:", "64:0x+-0", "64:nan+-0", "0:0+-0", "-1:0+-0",
                           "9223372036854775807:0+-0", "64:[2, 1]", "64:[0x1p+1, 0x1p+0]",
                           "64:[inf, inf]", "64:[nan, inf]", "64:0x1p+0+--0x1p+0"}) {
    expect_refusal<input_error>([&] { (void)parse_exact_text(text); }, text, accepted);
  }
  expect_refusal<input_error>(
      [&] { (void)parse_exact_text("64:0x" + std::string(1'000'000, 'f') + "p+0+-0"); },
      "more than 64 bits", accepted);
}

TEST(BadInput, Intervals) {
  const std::string accepted = "an interval is [LOWER, UPPER], [NUMBER] or [entire]";
  for (const char* text :
       {"",         "1, 2",     "[1, 2",      "1, 2]",        "[",
        "[]",       "[,]",      "[1,]",       "[,2]",         "[1, 2, 3]",
        "[2, 1]",   "[0x, 1]",  "[inf, inf]", "[-inf, -inf]", "[inf]",
        "[-inf]",   "[inf, 1]", "[nan, 1]",   "[1, nan]",     "[empty]",
        "[1/0, 2]", "(1, 2)",   "[1 2]",      "[1..2]",       "[1e999999999, 2e999999999]"}) {
    expect_refusal<input_error>([&] { (void)parse_interval(text, 64); }, text, accepted);
  }
  const std::string long_number(1'000'000, '7');
  expect_refusal<input_error>([&] { (void)parse_interval("[0, " + long_number + "]", 64); },
                              "at most 200000 are read", accepted);
  // Out of order by less than the rounding.
  const rational third(1, 3);
  const rational more = third + parse_rational("1e-100");
  expect_refusal<input_error>([&] { (void)from_end_points(more, third, 64); },
                              "characters), \"1/3\"",
                              "the lower one must not exceed the upper one");
  expect_refusal<std::invalid_argument>(
      [&] { (void)from_end_points(mpfr_float(2), mpfr_float(1), 64); }, "[2, 1]",
      "the lower one must not exceed the upper one");
}

TEST(BadInput, EndPoints) {
  const auto refused = [](const real& lower, const real& upper, const char* given,
                          const char* accepted) {
    expect_refusal<std::invalid_argument>([&] { (void)ball::from_end_points(lower, upper, 64); },
                                          given, accepted);
  };
  const real one(64, 1);
  const real two(64, 2);
  const real up = real::infinity(1);
  const real down = real::infinity(-1);
  refused(two, one, "[2, 1]", "the lower one must not exceed the upper one");
  refused(up, down, "[inf, -inf]", "the lower one may be -inf and the upper one inf");
  refused(up, up, "[inf, inf]", "the lower one may be -inf and the upper one inf");
  refused(down, down, "[-inf, -inf]", "the lower one may be -inf and the upper one inf");
  refused(real::nan(), one, "[nan, 1]", "each must be a number or an infinity");
  refused(one, real::nan(), "[1, nan]", "each must be a number or an infinity");
  EXPECT_TRUE(is_entire(ball::from_end_points(down, up, 64)));
  for (const auto& [low, high] :
       {std::pair{2.0, 1.0}, std::pair{std::numeric_limits<double>::quiet_NaN(), 1.0}}) {
    EXPECT_THROW(double_interval(low, high), std::invalid_argument);
  }
}

// No number: undefined, which is an answer.
TEST(BadInput, NumbersThatAreNone) {
  EXPECT_TRUE(ball(real::nan().get()).is_undefined());
  EXPECT_TRUE(ball(real::infinity(-1).get()).is_undefined());
  EXPECT_TRUE(ball::exactly(std::numeric_limits<double>::quiet_NaN()).is_undefined());
  EXPECT_TRUE(ball::exactly(std::numeric_limits<double>::infinity()).is_undefined());
  EXPECT_TRUE(ball::from_midpoint_radius(real::nan(), {}).is_undefined());
  EXPECT_TRUE(is_entire(ball::from_midpoint_radius(real(64, 1), magnitude::infinity())));
  EXPECT_TRUE(root(ball(2, 64), 0).is_undefined());
  EXPECT_TRUE((ball(2, 64) / 0).is_undefined());
}

TEST(BadInput, Precisions) {
  const real one(64, 1);
  for (const precision bad :
       {precision{0}, precision{1}, precision{-1}, greatest_precision + 1,
        std::numeric_limits<precision>::max(), std::numeric_limits<precision>::min()}) {
    const std::string given = std::to_string(bad) + " bits";
    const auto refused = [&](auto&& f) {
      expect_refusal<std::invalid_argument>(f, given, "it must be from 2 to 17179869184");
    };
    refused([&] { (void)ball(1, bad); });
    refused([&] { (void)ball(1UL, bad); });
    refused([&] { (void)ball(integer(1), bad); });
    refused([&] { (void)ball(rational(1, 3), bad); });
    refused([&] { (void)ball::exactly(1.0, bad); });
    refused([&] { (void)ball::from_end_points(one, one, bad); });
    refused([&] { (void)ball::undefined(bad); });
    refused([&] { (void)ball::entire(bad); });
    refused([&] { (void)ball(1, 64).with_precision(bad); });
    refused([&] { (void)parse_ball("1/3", bad); });
    refused([&] { (void)parse_interval("[1, 2]", bad); });
    refused([&] { (void)from_end_points(rational(1), rational(2), bad); });
    refused([&] { (void)pi(bad); });
    refused([&] { (void)log_2(bad); });
    refused([&] { (void)zeta(3, bad); });
    refused([&] { (void)zero_of_precision(bad); });
    refused([&] { (void)complex_ball::undefined(bad); });
    refused([&] { (void)to_ball(double_interval(1), bad); });
  }
}

TEST(BadInput, Digits) {
  for (const long bad : {0L, -1L, std::numeric_limits<long>::min()}) {
    const std::string given = std::to_string(bad) + " digits";
    for (const ball& x : {pi(64), ball::entire(64), ball::undefined(64), ball(0, 64)}) {
      expect_refusal<std::invalid_argument>([&] { (void)to_decimal(x, bad); }, given, "at least 1");
      expect_refusal<std::invalid_argument>([&] { (void)to_decimal_enclosure(x, bad); }, given,
                                            "at least 1");
    }
    expect_refusal<std::invalid_argument>([&] { (void)bits_for_digits(bad); }, given,
                                          "from 1 to 5000000000");
  }
  expect_refusal<std::domain_error>([&] { (void)to_decimal_enclosure(ball::entire(64), 5); },
                                    "unbounded", "no decimals");
  expect_refusal<std::domain_error>([&] { (void)lower_rational(ball::entire(64)); }, "unbounded",
                                    "end points");
  // As many digits as there are, however many are asked for.
  constexpr long most = std::numeric_limits<long>::max();
  EXPECT_EQ(to_decimal(pi(64), most), to_decimal(pi(64), 1000));
  EXPECT_EQ(to_decimal(ball::from_end_points(real(64, 1), real(64, 2), 64), most), "[1, 2]");
  EXPECT_EQ(to_decimal(ball(rational(1, 1024), 64), most), "0.0009765625");
  EXPECT_EQ(to_decimal(ball(0, 64), most), "0");
  EXPECT_EQ(to_decimal(scale(ball(1, 64), 100), most), "1267650600228229401496703205376");
  EXPECT_EQ(to_decimal(ball::entire(64), most), "[-inf, inf]");
  EXPECT_EQ(to_decimal_enclosure(pi(64), most).value, to_decimal_enclosure(pi(64), 500).value);
  std::ostringstream out;
  out.precision(std::numeric_limits<std::streamsize>::max());
  out << pi(64);
  EXPECT_EQ(out.str(), to_decimal(pi(64), 1000));
  for (const char* bad : {"{:x}", "{:.0}", "{:.}", "{:.-1}", "{:.99999999999999999999}"}) {
    expect_refusal<fmt::format_error>([&] { (void)fmt::format(fmt::runtime(bad), pi(64)); },
                                      "a ball's format is", "{:.DIGITS}");
  }
}

}  // namespace bad_input_test
}  // namespace polhode
