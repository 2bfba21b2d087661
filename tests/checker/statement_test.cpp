// "Verified" says what: a report names the claim with its inputs and numbers, and a certificate
// that leaves out a part is not verified.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "formulas.hpp"
#include "polhode/checker/check.hpp"
#include "polhode/checker/files.hpp"
#include "proofs/claim.hpp"

namespace polhode::checker {
namespace statement_test {

using test::integral_json;
using test::make_digest_right;
using test::roots_json;

json certificate_of(const char* claim, const char* a = nullptr, const char* b = nullptr) {
  proofs::request wanted;
  wanted.digits = 20;
  if (a != nullptr) wanted.motion = {parse_rational(a), parse_rational(b), parse_rational("1/4")};
  return to_json(proofs::find_claim(claim)->prove(wanted));
}

report checked(json certificate) {
  make_digest_right(certificate);
  return check(certificate.dump());
}

std::string said(const report& r) {
  std::string all = r.subject;
  for (const std::string& sentence : r.statement) all += '\n' + sentence;
  return all;
}

TEST(Statement, AnIntegralIsSaidWithItsIntegrandAndLimits) {
  const report of_pi = checked(integral_json("pi", "0", "1", "pi"));
  const report of_fraction = checked(integral_json("4/(1+x^2)", "0", "1", "pi"));
  ASSERT_EQ(of_pi.result, outcome::verified);
  ASSERT_EQ(of_fraction.result, outcome::verified);
  ASSERT_EQ(of_pi.statement.size(), 2U);
  EXPECT_EQ(of_pi.statement[0], "the integral of pi over x from 0 to 1");
  EXPECT_EQ(of_fraction.statement[0], "the integral of 4/(1 + x^2) over x from 0 to 1");
  EXPECT_EQ(of_fraction.statement[1].rfind("is between 3.1415926535897932384", 0), 0U)
      << of_fraction.statement[1];
}

TEST(Statement, RootsAreSaidWithTheirRangeAndEnclosures) {
  const report r = checked(roots_json("x^2-2", "0", "3", {"sqrt(2)"}));
  ASSERT_EQ(r.result, outcome::verified) << r.place << r.message;
  ASSERT_EQ(r.statement.size(), 2U);
  EXPECT_EQ(r.statement[0], "x^2 - 2 is 0 for exactly 1 x in the range 0 <= x <= 3");
  EXPECT_EQ(r.statement[1].rfind("root_1 is between 1.4142135623730950488", 0), 0U)
      << r.statement[1];
}

TEST(Statement, AClaimIsSaidWithItsBody) {
  const report physical = checked(certificate_of("physical", "12.65", "0.0629"));
  const report other = checked(certificate_of("physical", "39.95", "0.0629"));
  EXPECT_EQ(physical.subject, "claim \"physical\" for the physical body a = 253/20, b = 629/10000");
  EXPECT_EQ(other.subject,
            "claim \"physical\" for the non-physical body a = 799/20, b = 629/10000");
  EXPECT_NE(said(other).find("of the same sign: non-physical"), std::string::npos) << said(other);
  EXPECT_NE(said(other).find("I is between 0.590691335"), std::string::npos) << said(other);
  const report planar = checked(certificate_of("crossing", "1", "1/3"));
  EXPECT_NE(planar.subject.find("for the planar body a = 1, b = 1/3"), std::string::npos);
  EXPECT_NE(said(checked(certificate_of("sign_dF_du"))).find(", u = "), std::string::npos);
  EXPECT_NE(said(checked(certificate_of("beta"))).find("beta is between 0.028973228"),
            std::string::npos);
}

TEST(Statement, NothingIsSaidOfWhatIsNotVerified) {
  json c = integral_json("4/(1+x^2)", "0", "1", "pi");
  c["witness"]["pieces"][0]["nodes"] = 8;
  const report r = checked(c);
  EXPECT_FALSE(r.is_verified());
  EXPECT_EQ(said(r), "");
}

std::string note(const std::string& what) {
  return " (For the given body " + what +
         " was not found at the precisions tried. The proof does not need it.)";
}

TEST(Emptied, ACertificateIsVerifiedOnlyInPart) {
  // What is left rests on no enclosure.
  const auto without_enclosures = [](json& c) { c["rests_on"].erase(1); };
  json c = certificate_of("separatrix_twist");
  c["numbers"] = json::object();
  without_enclosures(c);
  c["method"] = c["method"].get<std::string>() + note("an enclosure of epsilon0");
  report r = checked(c);
  EXPECT_EQ(r.result, outcome::verified_in_part) << r.place << r.message;
  EXPECT_EQ(r.left_out, std::vector<std::string>{"an enclosure of epsilon0"});

  c = certificate_of("injectivity", "12.65", "0.0629");
  c["witness"]["chain"] = nullptr;
  c["facts"].erase(c["facts"].size() - 1);
  c["method"] =
      c["method"].get<std::string>() + note("a chain of points with certainly different epsilon");
  r = checked(c);
  EXPECT_EQ(r.result, outcome::verified_in_part) << r.place << r.message;

  c = certificate_of("first_equation");
  c["facts"].erase(c["facts"].size() - 1);
  c["method"] = c["method"].get<std::string>() + note("the order of some values of F(c,u)");
  without_enclosures(c);
  EXPECT_EQ(checked(c).result, outcome::verified_in_part);
}

TEST(Grounds, AreSaidAndCannotBeChanged) {
  const report beta = checked(certificate_of("beta"));
  EXPECT_EQ(beta.grounds, (std::vector<std::string>{"enclosed", "proved in Coq", "cited"}));
  EXPECT_EQ(beta.tier, "by Coq's kernel");
  const report limits = checked(certificate_of("errata"));
  EXPECT_EQ(limits.result, outcome::verified) << limits.place << limits.message;
  EXPECT_EQ(limits.tier, "by machine, joined in words");
  EXPECT_NE(std::ranges::find(limits.grounds, "argued in words"), limits.grounds.end());
  const auto refused_at = [](const char* claim, const char* pointer, const json& value) {
    json c = certificate_of(claim);
    c[json::json_pointer(pointer)] = value;
    const report r = checked(c);
    EXPECT_FALSE(r.is_verified()) << pointer;
    EXPECT_TRUE(r.grounds.empty());
    return r.place;
  };
  // What is argued cannot pass for what is decided.
  EXPECT_EQ(refused_at("errata", "/tier", "by machine"), "/tier");
  EXPECT_EQ(refused_at("errata", "/argument", json::array()), "/argument/0");
  EXPECT_EQ(refused_at("errata", "/tier", "by Coq's kernel"), "/tier");
  EXPECT_EQ(refused_at("count", "/argument/0/statement", "Curve.theorem_4"),
            "/argument/0/statement");
  EXPECT_EQ(refused_at("count", "/argument/0/kind", "cited"), "/argument/0/kind");
  EXPECT_EQ(refused_at("errata", "/rests_on", json::array({"decided exactly"})), "/rests_on/1");
  EXPECT_EQ(refused_at("beta", "/verdict", "argued"), "/verdict");
  EXPECT_EQ(refused_at("beta", "/rests_on", json::array({"decided exactly", "enclosed", "cited"})),
            "/rests_on/0");
  EXPECT_EQ(refused_at("beta", "/facts/0/kind", "decided exactly"), "/facts/0/kind");
  // A sign is what its letters' ranges give.
  EXPECT_EQ(refused_at("physical", "/witness/polynomials/3/conclusion", ">= 0"),
            "/witness/polynomials/3/conclusion");
  EXPECT_EQ(refused_at("physical", "/witness/polynomials/3/letters", "z > 0, p = x-y >= 0"),
            "/witness/polynomials/3/letters");
}

TEST(Variables, ThatLookLikeSomethingElseAreRefused) {
  for (const char* name : {"Pi", "PI", "l", "I", "O", "e", "E", "i", "Exp", "l0", "catalan"}) {
    json c = integral_json("x", "0", "1", "1/2");
    c["inputs"]["integrand"] = name;
    c["inputs"]["variable"] = name;
    c["formula"] = "integral from 0 to 1 of (" + std::string(name) + ") d" + name;
    const report r = checked(c);
    EXPECT_EQ(r.result, outcome::malformed) << name;
    EXPECT_EQ(r.place, "/inputs/variable") << name;
  }
  json c = integral_json("x", "0", "1", "1/2");
  c["inputs"]["integrand"] = "t_1";
  c["inputs"]["variable"] = "t_1";
  c["formula"] = "integral from 0 to 1 of (t_1) dt_1";
  EXPECT_EQ(checked(c).statement[0], "the integral of t_1 over t_1 from 0 to 1");
}

TEST(Paths, CannotFakeALine) {
  EXPECT_EQ(printable("out/beta.json"), "out/beta.json");
  EXPECT_EQ(printable("a.json: verified: integral"), "\"a.json: verified: integral\"");
  EXPECT_EQ(printable("a\nb"), "\"a\\x0ab\"");
  EXPECT_EQ(printable("\x1b[2K"), "\"\\x1b[2K\"");
  EXPECT_EQ(printable("\"\\"), "\"\\\"\\\\\"");
  EXPECT_EQ(printable("\xe2\x80\xae"), "\"\\xe2\\x80\\xae\"");
  EXPECT_EQ(printable(""), "\"\"");
}

}  // namespace statement_test
}  // namespace polhode::checker
