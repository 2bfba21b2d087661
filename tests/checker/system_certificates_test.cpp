// Certificates of all roots of a system: what is true is shown again, and what is false is not.

#include <gtest/gtest.h>

#include "formulas.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/checker/check.hpp"

namespace polhode::checker {
namespace system_certificates_test {

using test::make_digest_right;
using test::side;
using test::system_json;

const std::vector<std::string> circle_and_cubic{"x^2+y^2-1", "x-y^3"};
const std::vector<side> square{{"x", "-2", "2"}, {"y", "-2", "2"}};

const json& some_roots() {
  static const json certificate = system_json(circle_and_cubic, square);
  return certificate;
}

/// It is refused at that place, or deeper.
void expect_refused(json certificate, const std::string& place, const std::string& why) {
  make_digest_right(certificate);
  const report r = check(certificate.dump());
  EXPECT_NE(r.result, outcome::verified) << why;
  EXPECT_EQ(r.place.rfind(place, 0), 0U) << why << ": at " << r.place << ": " << r.message;
  EXPECT_FALSE(r.message.empty()) << why;
}

/// The same certificate of other formulas in another box.
json about(json c, const std::vector<std::string>& f, const std::vector<side>& sides) {
  std::string equations;
  std::string in;
  c["inputs"] = json::object();
  for (std::size_t i = 0; i < f.size(); ++i) {
    const std::string n = "_" + std::to_string(i + 1);
    c["inputs"]["formula" + n] = f[i];
    c["inputs"]["variable" + n] = sides[i].variable;
    c["inputs"]["from" + n] = sides[i].from;
    c["inputs"]["to" + n] = sides[i].to;
    equations += (i == 0 ? "" : ", ") + f[i] + " = 0";
    in += (i == 0 ? "" : ", ") + sides[i].from + " <= " + sides[i].variable + " <= " + sides[i].to;
  }
  c["formula"] = equations + " for " + in;
  return c;
}

/// Without its root k, of two, or with the roots that are listed.
json with_roots(json c, const std::vector<int>& roots) {
  const json old = c;
  c["numbers"] = json::object();
  c["witness"]["boxes"] = json::array();
  for (std::size_t k = 0; k < roots.size(); ++k) {
    for (const char* variable : {"_x", "_y"}) {
      c["numbers"]["root_" + std::to_string(k + 1) + variable] =
          old["numbers"]["root_" + std::to_string(roots[k]) + variable];
    }
    c["witness"]["boxes"].push_back(
        old["witness"]["boxes"][static_cast<std::size_t>(roots[k]) - 1]);
  }
  std::string statement = c["statement"];
  statement.replace(statement.find("exactly 2"), 9, "exactly " + std::to_string(roots.size()));
  c["statement"] = statement;
  return c;
}

TEST(SystemCertificates, TrueOnesAreShownAgain) {
  struct known {
    std::vector<std::string> f;
    std::vector<side> sides;
    std::size_t roots;
  };
  for (const auto& [f, sides, roots] : std::vector<known>{
           {circle_and_cubic, square, 2},
           {{"x-1"}, {{"x", "0", "3"}}, 1},
           {{"x+y", "x^2+y^2+1"}, square, 0},
           {{"sin(10*x)-y", "cos(10*y)-x"}, {{"x", "-1", "1"}, {"y", "-1", "1"}}, 39},
           {{"log(x)-y", "x-2+y"}, {{"x", "1/10", "5"}, {"y", "-3", "3"}}, 1},
           // Of very different sizes, and near each other.
           {{"x-10^20", "y-10^-20"}, {{"x", "0", "10^21"}, {"y", "-1", "1"}}, 1},
           {{"(x^2-2)*10^30", "(y-x)*10^-30"}, {{"x", "0", "5"}, {"y", "0", "5"}}, 1},
           {{"(x-1)*(x-1-10^-9)", "y-x"}, {{"x", "0", "2"}, {"y", "0", "2"}}, 2},
           {{"x^2+y^2+z^2-1", "x-y", "y-z^2"},
            {{"x", "-2", "2"}, {"y", "-2", "2"}, {"z", "-2", "2"}},
            2}}) {
    for (const long digits : {8L, 100L}) {
      const json c = system_json(f, sides, digits);
      EXPECT_EQ(c["witness"]["boxes"].size(), roots) << f.front();
      const report r = check(c.dump());
      EXPECT_EQ(r.result, outcome::verified)
          << f.front() << ": at " << r.place << ": " << r.message;
    }
  }
}

TEST(SystemCertificates, WhatNoCheckerKnowsIsRefusedByTheWriter) {
  const auto refused = [](const std::vector<std::string>& f, const std::vector<side>& sides) {
    EXPECT_THROW((void)system_json(f, sides), input_error) << f.front();
  };
  refused({"abs(x)-1", "y-x"}, {{"x", "-3", "2"}, {"y", "-3", "2"}});
  refused({"x^2", "y"}, square);                                  // a multiple root
  refused({"x-1", "y-2"}, {{"x", "0", "1"}, {"y", "0", "3"}});    // on a face
  refused({"Pi-1", "y-2"}, {{"Pi", "0", "3"}, {"y", "0", "3"}});  // a misleading name
}

TEST(SystemCertificates, RootsMustBeAllAndRight) {
  for (const int left : {1, 2}) {
    expect_refused(with_roots(some_roots(), {left}), "/witness/boxes", "one is missing");
  }
  expect_refused(with_roots(some_roots(), {}), "/", "all are missing");
  expect_refused(with_roots(some_roots(), {1, 1}), "/witness/boxes/1", "one is there twice");
  // Its box overlaps the other one's.
  json c = some_roots();
  c["witness"]["boxes"][1][0]["lower"] = "-2/3";
  c["witness"]["boxes"][1][1]["lower"] = "-1";
  expect_refused(c, "/witness/boxes/1", "a box that holds the other root");
  c = some_roots();
  c["witness"]["boxes"][0] = c["witness"]["boxes"][1];
  expect_refused(c, "/witness/boxes/0", "the box of another root");
  c = some_roots();
  std::swap(c["numbers"]["root_1_x"], c["numbers"]["root_1_y"]);
  expect_refused(c, "/", "x for y");
  // Other formulas, whose roots are elsewhere, or not at all, or more.
  const json other = about(some_roots(), {"x^2+y^2-1-10^-15", "x-y^3"}, square);
  expect_refused(other, "/numbers/root_1_x", "a root beside it");
  expect_refused(about(some_roots(), {"x^2+y^2-1", "y-x^3"}, square), "/", "others");
  expect_refused(about(some_roots(), {"(x^2+y^2-1)*(x-1)", "x-y^3"}, square), "/witness/boxes",
                 "one more root, (1, 1)");
  expect_refused(about(some_roots(), {"(x^2+y^2-1)*(x-1)^2", "x-y^3"}, square), "/witness/boxes",
                 "one more root, which is multiple");
  expect_refused(about(some_roots(), {"(x^2+y^2-1)*(x-y^3)", "x-y^3"}, square), "/",
                 "infinitely many");
  expect_refused(about(some_roots(), {"x-y^3", "x-y^3"}, square), "/", "the same formula twice");
  // Other boxes.
  expect_refused(about(some_roots(), circle_and_cubic, {{"x", "-2", "2"}, {"y", "-2", "0"}}),
                 "/witness/boxes/1", "a root outside the box");
  expect_refused(
      about(some_roots(), {"(x^2+y^2-1)*(x-3)", "x-y^3"}, {{"x", "-2", "4"}, {"y", "-2", "2"}}),
      "/witness/boxes", "a root in the greater box");
  expect_refused(about(some_roots(), circle_and_cubic, {{"x", "2", "-2"}, {"y", "-2", "2"}}),
                 "/inputs/to_1", "a side the wrong way round");
  // Not defined in a part of the box, where the others are 0.
  expect_refused(about(some_roots(), {"x^2+y^2-1", "(x-y^3)*(1+0*log(y))"}, square), "/",
                 "a logarithm of what is negative");
}

TEST(SystemCertificates, TheRegionOfOneRootIsProved) {
  // Two roots in one box: the derivatives are not regular on it.
  json c = system_json({"(x-1)*(x-1-10^-3)", "y-x"}, {{"x", "0", "2"}, {"y", "0", "2"}});
  c = with_roots(c, {1});
  c["witness"]["boxes"][0] = json::array(
      {json{{"lower", "1/2"}, {"upper", "3/2"}}, json{{"lower", "1/2"}, {"upper", "3/2"}}});
  expect_refused(c, "/witness/boxes/0", "two roots in a box");
  // Exactly on the border of the norm: 2x - x^2 has the derivative 0 at the side x = 1.
  c = system_json({"x*(2-x)", "y"}, {{"x", "-1", "1/2"}, {"y", "-1", "1"}});
  c = about(c, {"x*(2-x)", "y"}, {{"x", "-1", "3/2"}, {"y", "-1", "1"}});
  c["witness"]["boxes"][0][0]["upper"] = "1";
  expect_refused(c, "/witness/boxes/0", "a derivative that is 0 on a face");
}

TEST(SystemCertificates, AWideBoxOfNumbersNeedsTheDerivativesOverIt) {
  // A Newton step from the middle, -7/100, stays in [-1/10, 1/10], and the derivative, which is 1 +
  // 9/10 tanh(10 x), is not 0; but below 0 it is less than in the middle, and the root is beyond
  // -12/100.
  json c = system_json({"x"}, {{"x", "-3/25", "3/25"}});
  c = about(c, {"7/100 + x + 9/100*log(cosh(10*x))"}, {{"x", "-3/25", "3/25"}});
  certificate wide;
  wide.numbers.push_back(
      {"root_1_x", from_end_points(polhode::rational(-1, 10), polhode::rational(1, 10), 64), 1});
  c["numbers"] = json::parse(to_json(wide).dump())["numbers"];
  const json side{{"lower", "-11/100"}, {"upper", "11/100"}};
  c["witness"]["boxes"] = json::array({json::array({side})});
  expect_refused(c, "/numbers/root_1_x", "no root");
  // With more of the slope there is one, and it is shown.
  c = about(c, {"7/100 + x + 2/100*log(cosh(10*x))"}, {{"x", "-3/25", "3/25"}});
  make_digest_right(c);
  const report r = check(c.dump());
  EXPECT_EQ(r.result, outcome::verified) << "at " << r.place << ": " << r.message;
}

TEST(SystemCertificates, NumbersNearTheRootAreNotEnough) {
  // The box of numbers must hold the root in its interior: moved by its own width, it does not.
  for (const char* const end : {"lower", "upper"}) {
    for (const char* const name : {"root_1_x", "root_1_y", "root_2_x", "root_2_y"}) {
      json c = some_roots();
      const json numbers = c["numbers"][name]["dyadic"];
      json& changed = c["numbers"][name]["dyadic"][end];
      const json& other = numbers[std::string(end) == "lower" ? "upper" : "lower"];
      changed = other;
      expect_refused(c, "/numbers/", "without width");
    }
  }
}

TEST(SystemCertificates, WrongShapesAreRefused) {
  json c = some_roots();
  c["inputs"]["variable_2"] = "x";
  expect_refused(c, "/inputs/variable_2", "one name twice");
  c = some_roots();
  c["inputs"].erase("to_2");
  expect_refused(c, "/inputs", "an end is missing");
  c = some_roots();
  c["inputs"] = json::object();
  expect_refused(c, "/inputs", "nothing");
  c = some_roots();
  c["witness"]["boxes"][0].erase(0);
  expect_refused(c, "/witness/boxes/0", "a side is missing");
  c = some_roots();
  c["numbers"]["root_3_x"] = c["numbers"]["root_1_x"];
  expect_refused(c, "/witness/boxes", "a number too many");
  const json flat = some_roots().flatten();
  for (const auto& [key, value] : flat.items()) {
    if (key.rfind("/software", 0) == 0 || key == "/digest") continue;
    for (const json& wrong :
         {json(nullptr), json(-7), json("x y"), json::array(), json::object()}) {
      const json::json_pointer at(key);
      if (some_roots()[at] == wrong) continue;
      c = some_roots();
      c[at] = wrong;
      make_digest_right(c);
      EXPECT_NE(check(c.dump()).result, outcome::verified) << at << " = " << wrong;
    }
  }
}

}  // namespace system_certificates_test
}  // namespace polhode::checker
