// Every certificate of a claim that the prover certifies is verified by the checker: of many
// bodies, at many lengths.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "polhode/checker/check.hpp"
#include "proofs/claim.hpp"

namespace polhode::checker {
namespace claims_test {

report checked(const char* claim, const proofs::request& wanted) {
  return check(to_json(proofs::find_claim(claim)->prove(wanted)).dump(2));
}

proofs::request with(const char* a, const char* b, const char* u = "1/4", long digits = 30) {
  proofs::request wanted;
  wanted.digits = digits;
  wanted.motion = {parse_rational(a), parse_rational(b), parse_rational(u)};
  return wanted;
}

void expect_verified(const char* claim, const proofs::request& wanted) {
  const report r = checked(claim, wanted);
  EXPECT_EQ(r.result, outcome::verified)
      << claim << " a = " << polhode::to_text(wanted.motion.a)
      << " b = " << polhode::to_text(wanted.motion.b)
      << " u = " << polhode::to_text(wanted.motion.u) << " digits = " << wanted.digits << ": at "
      << r.place << ": " << r.message;
}

TEST(EveryClaim, IsVerified) {
  for (const proofs::claim& c : proofs::all_claims()) {
    expect_verified(std::string(c.name).c_str(), {});
    const report r = checked(std::string(c.name).c_str(), {});
    EXPECT_EQ(r.claim, c.name);
    EXPECT_GE(r.checks.size(), 1U);
  }
}

/// proofs/certificates: what `scripts/certificates` makes, but for the versions of the machine that
/// it ran on.
TEST(EveryClaim, HasItsCertificateInTheTree) {
  for (const proofs::claim& c : proofs::all_claims()) {
    std::ifstream file(std::string(POLHODE_CERTIFICATES_DIR) + '/' + std::string(c.name) + ".json");
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const report r = check(text);
    EXPECT_EQ(r.result, outcome::verified) << c.name << r.place << r.message;
    if (r.result != outcome::verified) continue;
    json in_tree = json::parse(text);
    json made = to_json(c.prove({}));
    for (json* one : {&in_tree, &made}) {
      one->erase("software");
      one->erase("digest");
    }
    EXPECT_EQ(in_tree, made) << c.name << ": run scripts/certificates";
  }
}

TEST(EveryClaim, IsVerifiedAtManyLengths) {
  for (const proofs::claim& c : proofs::all_claims()) {
    for (const long digits : {1L, 120L}) {
      if (c.name == "injectivity") continue;
      proofs::request wanted;
      wanted.digits = digits;
      expect_verified(std::string(c.name).c_str(), wanted);
    }
  }
}

TEST(Constants, AreVerifiedToAThousandDigits) {
  proofs::request wanted;
  wanted.digits = 1000;
  for (const char* claim : {"beta", "epsilon0_min", "delta_psi_max", "limit_minimum"}) {
    expect_verified(claim, wanted);
  }
}

TEST(BodyClaims, AreVerifiedForAllKindsOfBodies) {
  for (const auto& [a, b] : {std::pair{"18.27", "0.0629"},
                             {"3.1", "0.0629"},
                             {"1", "1/3"},
                             {"77/40", "1/10"},
                             {"39.95", "0.0629"},
                             {"1/20", "9/10"},
                             {"1000", "1/2000"},
                             {"100", "0.3"}}) {
    for (const proofs::claim& c : proofs::all_claims()) {
      if (c.subject != proofs::claim_subject::body || c.name == "injectivity") continue;
      expect_verified(std::string(c.name).c_str(), with(a, b));
    }
  }
}

TEST(Injectivity, IsVerifiedOnBothSides) {
  expect_verified("injectivity", with("18.27", "0.0629"));
  expect_verified("injectivity", with("1", "1/3"));
}

TEST(SignOfSlope, IsVerifiedForManyMotions) {
  for (const char* u : {"1/100", "1/2", "1", "1/1000000000000000000000000000000"}) {
    expect_verified("sign_dF_du", with("12.65", "0.0629", u));
    expect_verified("sign_dF_du", with("1/1000", "99/100", u));
  }
}

TEST(NotCertified, IsNotCheckable) {
  certificate c = proofs::find_claim("beta")->prove({});
  c.facts[0].holds = false;
  c.conclude();
  const report r = check(to_json(c).dump());
  EXPECT_EQ(r.result, outcome::not_checkable);
  EXPECT_EQ(r.place, "/verdict");
}

}  // namespace claims_test
}  // namespace polhode::checker
