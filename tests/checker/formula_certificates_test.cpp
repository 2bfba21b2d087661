// Certificates of integrals and roots of formulas: what is true is shown again; what is false is
// not, however it is dressed; and what has the wrong shape, or would take long, is refused.

#include <gtest/gtest.h>

#include "formulas.hpp"
#include "polhode/checker/check.hpp"

namespace polhode::checker {
namespace formula_certificates_test {

using test::integral_json;
using test::make_digest_right;
using test::roots_json;

report checked(json certificate) {
  make_digest_right(certificate);
  return check(certificate.dump());
}

void expect_verified(const json& certificate, const std::string& what) {
  const report r = check(certificate.dump());
  EXPECT_EQ(r.result, outcome::verified) << what << ": at " << r.place << ": " << r.message;
}

/// It is refused at that place, or deeper.
void expect_refused(const json& certificate, const std::string& place, const std::string& why) {
  const report r = checked(certificate);
  EXPECT_NE(r.result, outcome::verified) << why;
  EXPECT_EQ(r.place.rfind(place, 0), 0U) << why << ": at " << r.place << ": " << r.message;
  EXPECT_FALSE(r.message.empty()) << why;
}

const json& some_integral() {
  static const json certificate = integral_json("4/(1+x^2)", "0", "1", "pi");
  return certificate;
}
const json& some_roots() {
  static const json certificate =
      roots_json("(x^2-2)*(x-1/2)", "-2", "2", {"-sqrt(2)", "1/2", "sqrt(2)"});
  return certificate;
}

TEST(FormulaCertificates, TrueIntegralsAreShownAgain) {
  struct known {
    const char *f, *from, *to, *value;
  };
  for (const auto& [f, from, to, value] : {
           known{"4/(1+x^2)", "0", "1", "pi"},
           known{"exp(-x^2)", "0", "1", "erf(1)*sqrt(pi)/2"},
           known{"sin(x)", "0", "pi", "2"},
           known{"sin(x)", "-1", "1", "0"},
           known{"x^2", "2", "-1", "-3"},
           known{"5", "1", "3", "10"},
           known{"sqrt(x)", "1/100", "4", "16/3 - 2/3000"},
           known{"1/x", "1", "exp(3)", "3"},
           known{"log(x)", "1", "2", "2*log(2) - 1"},
           known{"1/(1+10000*x^2)", "-1", "1", "atan(100)/50"},
           known{"x^(1/2)*cosh(x)^0", "1", "4", "14/3"},
           known{"tan(x)", "0", "1", "-log(cos(1))"},
           known{"1/sqrt(1-x^2)", "0", "1/2", "pi/6"},
           known{"10^-40*exp(x)", "0", "1", "10^-40*(exp(1)-1)"},
       }) {
    for (const long digits : {8L, 50L}) {
      expect_verified(integral_json(f, from, to, value, digits), f);
    }
  }
}

TEST(FormulaCertificates, TrueRootsAreShownAgain) {
  struct known {
    const char *f, *from, *to;
    std::vector<std::string> roots;
  };
  for (const auto& [f, from, to, roots] : std::vector<known>{
           {"x^2-2", "0", "2", {"sqrt(2)"}},
           {"(x-1)*(x+2)", "-3", "pi", {"-2", "1"}},
           {"sin(x)", "-1", "10", {"0", "pi", "2*pi", "3*pi"}},
           {"exp(x)", "-10", "10", {}},
           {"sqrt(x) - 1", "1/10", "4", {"1"}},
           {"(x-1)*(x-1-10^-9)", "0", "2", {"1", "1+10^-9"}},
           {"log(x)", "1/4", "pi", {"1"}},
           {"atan(x) - pi/4", "-pi^2", "4", {"1"}},
       }) {
    for (const long digits : {12L, 50L}) {
      expect_verified(roots_json(f, from, to, roots, digits), f);
    }
  }
}

TEST(FormulaCertificates, WhatNoCheckerKnowsIsRefusedByTheWriter) {
  for (const char* f : {"abs(x)", "erf(x)", "root(x, 3)", "max(x, 0)", "x*euler_gamma"}) {
    EXPECT_THROW(static_cast<void>(integral_json(f, "1", "2", "1")), input_error) << f;
  }
  // Not analytic at an end, or between the ends.
  EXPECT_THROW(static_cast<void>(integral_json("sqrt(x)", "0", "1", "2/3")), input_error);
  EXPECT_THROW(static_cast<void>(integral_json("1/x", "-1", "1", "0")), input_error);
  // A root at an end, and a multiple one.
  EXPECT_THROW(static_cast<void>(roots_json("sin(x)", "0", "4", {"0", "pi"})), input_error);
  EXPECT_THROW(static_cast<void>(roots_json("(x-1)^2", "0", "4", {"1"})), input_error);
}

// ---------------------------------------------------------------------------------------------
// False theorems. The digest is made right, and all that can be is made to agree.

json with_pieces(const std::string& f, const std::string& from, const std::string& to,
                 const json& pieces) {
  json c = some_integral();
  c["inputs"]["integrand"] = f;
  c["inputs"]["from"] = from;
  c["inputs"]["to"] = to;
  c["formula"] = "integral from " + from + " to " + to + " of (" + f + ") dx";
  c["witness"]["pieces"] = pieces;
  return c;
}

TEST(FormulaCertificates, AnotherIntegralIsRefuted) {
  expect_refused(integral_json("4/(1+x^2)", "0", "1", "pi + 10^-19"), "/numbers/integral/dyadic",
                 "another value");
  expect_refused(integral_json("4/(1+x^2)", "1", "0", "pi"), "/numbers/integral/dyadic",
                 "the other direction");
  json c = some_integral();
  c["inputs"]["integrand"] = "4/(1 + x^2) + 10^-19";
  expect_refused(c, "/formula", "an integrand that is not the formula's");
  c["formula"] = "integral from 0 to 1 of (4/(1 + x^2) + 10^-19) dx";
  expect_refused(c, "/numbers/integral/dyadic", "another integrand");
}

TEST(FormulaCertificates, EllipsesMustHoldNoSingularity) {
  const auto piece = [](const char* rho, const char* supremum) {
    return json::array({{{"end", "1"}, {"rho", rho}, {"supremum", supremum}, {"nodes", 400}}});
  };
  // 4/(1+x^2) over [0, 1] has its poles where rho = 4.61...
  EXPECT_EQ(checked(with_pieces("4/(1 + x^2)", "0", "1", piece("9/2", "1000"))).result,
            outcome::verified);
  const char* great = "1000000000000000000000";
  for (const char* rho : {"47/10", "5", "100"}) {
    expect_refused(with_pieces("4/(1 + x^2)", "0", "1", piece(rho, great)), "/witness/pieces/0",
                   "a pole inside");
  }
  // A pole between the ends, on the axis, off the middle.
  expect_refused(with_pieces("1/(x - 1/3)", "0", "1", piece("101/100", great)), "/witness/pieces/0",
                 "a pole on the axis");
  // A removable one is one all the same.
  expect_refused(with_pieces("sin(x)/x", "-1", "1", piece("2", great)), "/witness/pieces/0", "0/0");
  // Cuts: of the root and the logarithm, by an end, across an ellipse, above the axis only in its
  // image.
  for (const char* f : {"sqrt(x)", "log(x)", "x^(1/3)", "sqrt(x)*sqrt(x)"}) {
    expect_refused(with_pieces(f, "0", "1", piece("101/100", great)), "/witness/pieces/0", f);
    expect_refused(with_pieces(f, "1/100", "1", piece("3/2", great)), "/witness/pieces/0", f);
  }
  // sqrt((1+x^2)^2) is |1+x^2| on the axis but has a cut from each of i and -i.
  expect_refused(with_pieces("sqrt((1 + x^2)^2)", "0", "1", piece("5", great)), "/witness/pieces/0",
                 "a cut from i on");
  // |x| in disguise.
  expect_refused(with_pieces("sqrt(x^2)", "-1", "1", piece("101/100", great)), "/witness/pieces/0",
                 "|x|");
  expect_refused(with_pieces("atan(1/x)", "-1", "1", piece("101/100", great)), "/witness/pieces/0",
                 "a jump");
  expect_refused(with_pieces("atan(x)", "0", "1", piece("6", great)), "/witness/pieces/0",
                 "a cut from i on");
}

TEST(FormulaCertificates, BoundsMustHold) {
  json c = some_integral();
  json& p = c["witness"]["pieces"][0];
  p["supremum"] = "3";
  expect_refused(c, "/witness/pieces/0/supremum", "below the integrand");
  // The greatest value is where x is nearest to i, off the axis: the integrand is at most 4 on it.
  c = with_pieces("4/(1 + x^2)", "0", "1",
                  json::array({{{"end", "1"}, {"rho", "4"}, {"supremum", "5"}, {"nodes", 96}}}));
  expect_refused(c, "/witness/pieces/0", "below the supremum off the axis");
  c = some_integral();
  c["witness"]["pieces"][0]["nodes"] = 8;
  expect_refused(c, "/numbers/integral/dyadic", "too few nodes");
  // The rule's sum is right to 50 digits, but on these ellipses nothing shows it.
  for (const char* rho : {"11/10", "3/2"}) {
    c = with_pieces("4/(1 + x^2)", "0", "1",
                    json::array({{{"end", "1"}, {"rho", rho}, {"supremum", "64"}, {"nodes", 96}}}));
    expect_refused(c, "/numbers/integral/dyadic", rho);
  }
}

// One node takes 2x^2 - 1 for -1, and its integral, -2/3, for -2: the bound of the error, 8 M = 32,
// is all that keeps -2 +- 5/4 from being shown.
TEST(FormulaCertificates, TheRulesErrorIsCounted) {
  const ball wrong = hull(ball(polhode::rational(-13, 4), 64), ball(polhode::rational(-3, 4), 64));
  json c = integral_certificate({test::read("2*x^2-1", "x"), test::read("-1"), test::read("1")},
                                wrong, 1);
  c["witness"]["pieces"] =
      json::array({{{"end", "1"}, {"rho", "2"}, {"supremum", "4"}, {"nodes", 1}}});
  expect_refused(c, "/numbers/integral/dyadic", "the rule's value is not the integral");
}

// Two nodes take 2 x^2/L^2 - 1 over [-L, L] for 0, and its integral is -2 L/3. On a wide ellipse
// the bound is 4 (2 M/rho^2) L, and that it has the power rho^(1-n) and the factor L is all that
// keeps 0 from being shown.
TEST(FormulaCertificates, TheRulesErrorHasItsPowerAndItsLength) {
  const ball near_zero =
      hull(ball(polhode::rational(-1, 2), 64), ball(polhode::rational(1, 2), 64));
  json c = integral_certificate({test::read("2*x^2-1", "x"), test::read("-1"), test::read("1")},
                                near_zero, 1);
  c["witness"]["pieces"] =
      json::array({{{"end", "1"}, {"rho", "10"}, {"supremum", "80"}, {"nodes", 2}}});
  expect_refused(c, "/numbers/integral/dyadic", "two powers are missing");
  c = integral_certificate({test::read("x^2/5000-1", "x"), test::read("-100"), test::read("100")},
                           near_zero * 20, 1);
  c["witness"]["pieces"] =
      json::array({{{"end", "1"}, {"rho", "1000"}, {"supremum", "800000"}, {"nodes", 2}}});
  expect_refused(c, "/numbers/integral/dyadic", "the length is missing");
}

// |f| is up to 5.25 on this ellipse, but neither part of f is above 4.72.
TEST(FormulaCertificates, BothPartsOfAValueCount) {
  const json pieces = json::array({{{"end", "1"}, {"rho", "4"}, {"supremum", "5"}, {"nodes", 96}}});
  expect_refused(with_pieces("(x+1)*exp(-x^2/4)", "-1", "1", pieces), "/witness/pieces/0",
                 "a false supremum");
}

TEST(FormulaCertificates, PiecesMustCoverTheRange) {
  const json good = some_integral();
  const auto with = [&](const char* key, const json& value) {
    json c = good;
    c["witness"]["pieces"][0][key] = value;
    return c;
  };
  const std::string place = "/witness/pieces/0/";
  for (const char* end : {"0", "-1", "1/2", "2", "2/2", "0.5", ""}) {
    expect_refused(with("end", end), place + "end", end);
  }
  for (const char* rho : {"1", "1/2", "0", "-4"}) {
    expect_refused(with("rho", rho), place + "rho", rho);
  }
  for (const char* supremum : {"0", "-64"}) {
    expect_refused(with("supremum", supremum), place + "supremum", supremum);
  }
  for (const json& nodes : {json(0), json(-1), json(1L << 50U), json(20'000), json("96")}) {
    expect_refused(with("nodes", nodes), place + "nodes", nodes.dump());
  }
  json c = good;
  c["witness"]["pieces"] = json::array();
  expect_refused(c, "/witness/pieces", "no piece");
  c = good;
  c["witness"]["pieces"].push_back(c["witness"]["pieces"][0]);
  expect_refused(c, "/witness/pieces/1/end", "a piece twice");
  c = good;
  c["witness"]["pieces"][0]["begin"] = "0";
  expect_refused(c, "/witness/pieces/0/begin", "a key too many");
}

TEST(FormulaCertificates, RootsMustBeAllAndRight) {
  // One is missing.
  const std::vector<std::string> roots{"-sqrt(2)", "1/2", "sqrt(2)"};
  for (std::size_t i = 0; i < roots.size(); ++i) {
    std::vector<std::string> fewer = roots;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    expect_refused(roots_json("(x^2-2)*(x-1/2)", "-2", "2", fewer), "/witness/boxes", roots[i]);
  }
  expect_refused(roots_json("x^2-2", "0", "2", {}), "/witness/boxes", "none");
  // A double root between the boxes changes no sign.
  expect_refused(roots_json("(x-3/2)^2*(x-1/2)", "0", "2", {"1/2"}), "/witness/boxes", "double");
  // A pole is no root, though the sign changes there.
  json c = roots_json("x-1/2", "0", "2", {"1/2"});
  c["inputs"]["formula"] = "1/(x - 1/2)";
  c["formula"] = "1/(x - 1/2) = 0 for 0 <= x <= 2";
  expect_refused(c, "/witness/boxes/0", "a pole");
  // Beside the root; one that is there twice; a box too many.
  expect_refused(roots_json("x^2-2", "0", "2", {"sqrt(2) + 10^-19"}), "/numbers/root_1/dyadic",
                 "beside it");
  c = some_roots();
  c["numbers"]["root_2"] = c["numbers"]["root_1"];
  expect_refused(c, "/witness/boxes/1", "twice");
  c["witness"]["boxes"][1] = c["witness"]["boxes"][0];
  expect_refused(c, "/witness/boxes/1/lower", "twice, with its box");
  c = some_roots();
  c["witness"]["boxes"].push_back({{"lower", "7/4"}, {"upper", "2"}});
  expect_refused(c, "/witness/boxes", "a box without a number");
  // A root outside the range.
  c = some_roots();
  c["inputs"]["to"] = "1";
  c["formula"] = c["inputs"]["formula"].get<std::string>() + " = 0 for -2 <= x <= 1";
  expect_refused(c, "/witness/boxes/2", "outside");
  // A box around two roots, or with a derivative that is 0 in it.
  c = some_roots();
  c["witness"]["boxes"][2] = {{"lower", "4/5"}, {"upper", "2"}};
  expect_refused(c, "/witness/boxes/2", "the derivative has a zero near 0.98");
  // The range the wrong way round.
  c = roots_json("exp(x)", "0", "1", {});
  c["inputs"]["to"] = "-1";
  c["formula"] = "exp(x) = 0 for 0 <= x <= -1";
  expect_refused(c, "/inputs/to", "an empty range");
  // A formula that is not defined in the range.
  c = roots_json("exp(x)", "-1", "1", {});
  c["inputs"]["formula"] = "sqrt(x) + 1";
  c["formula"] = "sqrt(x) + 1 = 0 for -1 <= x <= 1";
  expect_refused(c, "/witness/boxes", "not defined for x < 0");
  c["inputs"]["formula"] = "1/x";
  c["formula"] = "1/x = 0 for -1 <= x <= 1";
  expect_refused(c, "/witness/boxes", "not defined at 0");
  c["inputs"]["formula"] = "x - x";
  c["formula"] = "x - x = 0 for -1 <= x <= 1";
  expect_refused(c, "/witness/boxes", "0 everywhere");
}

TEST(FormulaCertificates, NumbersMustAgreeWithTheirEnds) {
  const std::string at = "/numbers/integral/";
  const auto with = [&](const char* key, const json& value) {
    json c = some_integral();
    c["numbers"]["integral"][key] = value;
    return c;
  };
  expect_refused(with("value", "3.1415926535897932385"), at + "value", "rounded, not cut off");
  expect_refused(with("value", nullptr), at + "value", "null");
  expect_refused(with("digits", 19), at + "value", "fewer");
  expect_refused(with("digits", 21), at + "digits", "more than asked for");
  expect_refused(with("radius", "0"), at + "radius", "no error");
  expect_refused(with("radius", "1"), at + "radius", "an error far too large");
  expect_refused(with("rounded", false), at + "rounded", "it is left out then");
  expect_refused(with("lower", "3.2"), at + "lower", "inward");
  expect_refused(with("lower", "3.1"), at + "lower", "far away");
  expect_refused(with("upper", "3.1"), at + "upper", "inward");
  expect_refused(with("upper", "1e100000"), at + "upper", "far away");
  json c = some_integral();
  json& lower = c["numbers"]["integral"]["dyadic"]["lower"];
  lower["mantissa"] = lower["mantissa"].get<std::string>() + "0";
  expect_refused(c, at + "dyadic/lower/mantissa", "not in lowest form");
  c = some_integral();
  std::swap(c["numbers"]["integral"]["dyadic"]["lower"],
            c["numbers"]["integral"]["dyadic"]["upper"]);
  expect_refused(c, at + "dyadic", "the ends exchanged");
}

// ---------------------------------------------------------------------------------------------
// Hostile input

TEST(FormulaCertificates, HostileInputIsRefusedSoon) {
  const auto piece = [](const json& nodes) {
    return json::array({{{"end", "1"}, {"rho", "2"}, {"supremum", "1000"}, {"nodes", nodes}}});
  };
  const std::string place = "/witness/pieces/0";
  expect_refused(with_pieces("(1 + x)^1000000", "0", "1", piece(10)), place, "a great power");
  expect_refused(with_pieces("exp(exp(exp(x)))", "0", "10", piece(10)), place, "a great value");
  expect_refused(with_pieces("exp(x)", "0", "10^100", piece(10)), place, "a great range");
  expect_refused(with_pieces("x", "0", "exp(10^6)", piece(10)), "", "an end that is too great");
  expect_refused(with_pieces("x", "0", "1/sin(0)", piece(10)), "", "an end that is none");
  expect_refused(with_pieces("x", "0", "1/0", piece(10)), "/inputs/to", "an end that is none");
  expect_refused(with_pieces("x", "0", "x", piece(10)), "/inputs/to", "an end with a variable");
  expect_refused(with_pieces(std::string(1'000'000, '1'), "0", "1", piece(10)), "/inputs/integrand",
                 "a long formula");
  expect_refused(with_pieces(std::string(10'000, '('), "0", "1", piece(10)), "/inputs/integrand",
                 "a deep formula");
  json c = some_integral();
  c["witness"]["pieces"] = json::array();
  for (int i = 0; i < 3000; ++i) c["witness"]["pieces"].push_back(piece(4)[0]);
  expect_refused(c, "/witness/pieces", "many pieces");
  c = some_integral();
  for (const char* key : {"end", "rho", "supremum"}) {
    c = some_integral();
    c["witness"]["pieces"][0][key] = "1/" + std::string(100'000, '7');
    expect_refused(c, place + "/" + key, "a long fraction");
  }
  for (const json& exponent : {json(4'000'000), json(-4'000'000)}) {
    c = some_integral();
    c["numbers"]["integral"]["dyadic"]["lower"]["exponent"] = exponent;
    expect_refused(c, "/numbers/integral/dyadic", "a great exponent");
  }
  c = some_integral();
  c["inputs"]["variable"] = "sin";
  expect_refused(c, "/inputs/variable", "a function as variable");
  c = some_integral();
  c["facts"].push_back({{"statement", "1 = 2"}, {"holds", true}});
  expect_refused(c, "/facts/0", "a fact");
  c = some_roots();
  c["reference"] = "a friend";
  expect_refused(c, "/reference", "a reference");
}

/// Any part replaced by something of another type.
TEST(FormulaCertificates, WrongShapesAreRefused) {
  for (const json& good : {some_integral(), some_roots()}) {
    const json flat = good.flatten();
    std::vector<json::json_pointer> places;
    for (const auto& [key, value] : flat.items()) {
      for (json::json_pointer at(key); !at.empty(); at = at.parent_pointer()) places.push_back(at);
    }
    for (const auto& at : places) {
      if (at.to_string().rfind("/software", 0) == 0 || at.to_string() == "/digest") continue;
      for (const json& wrong : {json(nullptr), json(true), json(-7), json("x y"), json::array(),
                                json::object(), json::array({json::array({1})})}) {
        if (good[at] == wrong) continue;
        json c = good;
        c[at] = wrong;
        const report r = checked(c);
        EXPECT_NE(r.result, outcome::verified) << at << " = " << wrong;
      }
    }
  }
}

}  // namespace formula_certificates_test
}  // namespace polhode::checker
