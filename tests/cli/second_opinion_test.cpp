// What --verify prints of second opinions, and what the program does with a contradiction.

#include "cli/options/second_opinion.hpp"

#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/certificate/formula_certificates.hpp"

namespace polhode::test {
namespace second_opinion_test {

/// What the contradiction says.
template <class Contradicts>
std::string said_by(const Contradicts& contradicts) {
  try {
    contradicts();
  } catch (const contradiction_error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no contradiction";
  return "";
}

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    EXPECT_NE(text.find(word), std::string::npos) << word << " in " << text;
  }
}

TEST(SecondOpinion, AContradictionEndsTheProgramWithStatus3) {
  testing::internal::CaptureStderr();
  cli::exit_status status = cli::exit_status::all_certified;
  try {
    contradict("the integral", {"a", "1"}, {"b", "2"});
  } catch (...) {
    status = cli::report_current_exception();
  }
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_EQ(static_cast<int>(status), 3);
  EXPECT_EQ(text.rfind("polhode: INTERNAL ERROR", 0), 0U) << text;
  expect_words(text, {"There is no result", "report it with the whole command line"});
}

TEST(SecondOpinion, WithoutARouteThatAgreesNothingIsConfirmed) {
  cli::printed_opinion opinion;
  EXPECT_FALSE(opinion.agrees());
  EXPECT_EQ(opinion.status(), cli::exit_status::not_certified);
  opinion.add({"a route", "not analytic", json(), "", 0});
  EXPECT_FALSE(opinion.agrees());
  expect_words(opinion.as_text(), {"not confirmed", "a route: not analytic"});
  EXPECT_EQ(opinion.as_json().at("agrees"), false);
  opinion.add({"another", "", json(1), "3 steps", 0.5});
  EXPECT_EQ(opinion.status(), cli::exit_status::all_certified);
  EXPECT_EQ(opinion.as_text(), "second opinion: the same by another (3 steps, 0.5 s)\n");
  EXPECT_EQ(opinion.as_json().at("route"), "another");
}

TEST(SecondOpinion, EnclosuresArePrintedAsTheCommandsPrintNumbers) {
  const ball half(rational(1, 2), 64);
  const auto printed = [](const auto& enclosure) {
    second_opinion opinion;
    opinion.add({"a route", "", enclosure, "", 0});
    return cli::printed_opinion(opinion, 5).as_json().at("enclosure");
  };
  EXPECT_EQ(printed(half), to_json(half, 5));
  EXPECT_EQ(printed(complex_ball(half, -half)),
            (json{{"real", to_json(half, 5)}, {"imaginary", to_json(-half, 5)}}));
  const json roots = printed(proved_roots{true, false, {{root_verdict::multiple, 2, half, false}}});
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_EQ(roots[0].at("multiplicity"), 2);
  EXPECT_EQ(roots[0].at("value"), to_json(half, 5).at("value"));
  EXPECT_TRUE(printed(std::monostate()).is_null());
}

TEST(SecondOpinion, WhatTheCheckerRefutesIsAContradiction) {
  const formula_over_range what{expression("4/(1+x^2)", {{"x"}, {}, nullptr}), expression("0"),
                                expression("1")};
  const json right = integral_certificate(what, pi(200), 30);
  EXPECT_TRUE(cli::checked_again("the integral", "a route", right).agrees());
  const json wrong = integral_certificate(what, pi(200) + parse_rational("1e-20"), 30);
  const std::string text =
      said_by([&] { (void)cli::checked_again("the integral", "a route", wrong); });
  expect_words(text, {"a route", "the independent checker", "refuted", "/numbers/integral"});
}

}  // namespace second_opinion_test
}  // namespace polhode::test
