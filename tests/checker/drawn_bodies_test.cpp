// Every claim about bodies of all sizes: what the prover certifies, the checker never refutes.

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/certificate/certificate.hpp"
#include "polhode/checker/check.hpp"
#include "proofs/claim.hpp"
#include "proofs/claims.hpp"
#include "support/random.hpp"

namespace polhode::checker {
namespace drawn_bodies_test {

using support::random_source;
using support::repeat;

/// m 10^e with 10^e log-uniform between the ends.
rational log_uniform(random_source& random, long least, long most) {
  const long e = random.between(least, most);
  return parse_rational(fmt::format("{}e{}", random.between(1000, 9999), e - 3));
}

/// From 1e-300 to 1 - 1e-30.
rational drawn_b(random_source& random) {
  if (random.between(0, 2) == 0) return 1 - log_uniform(random, -30, -1);
  return log_uniform(random, -300, -1);
}

/// Near I = 1, or on it: a = (1 - 2b)/b, and its neighbours.
rational a_near_planar(random_source& random, const rational& b) {
  const rational a((1 - 2 * b) / b);
  if (a <= 0) return 1;
  const long side = random.between(-1, 1);
  return a + side * a * log_uniform(random, -40, -10);
}

TEST(DrawnBodies, HaveCertificatesThatTheCheckerTakes) {
  random_source random(33);
  long verified = 0;
  long not_checkable = 0;
  for (repeat trial(5); trial.again();) {
    const rational b = drawn_b(random);
    const rational a =
        random.between(0, 3) == 0 ? a_near_planar(random, b) : log_uniform(random, -300, 300);
    proofs::request wanted;
    wanted.digits = random.between(5, 40);
    wanted.motion.a = a;
    wanted.motion.b = b;
    for (const proofs::claim& c : proofs::all_claims()) {
      if (c.subject < proofs::claim_subject::body) continue;
      const std::string what =
          std::string(c.name) + " of " + polhode::to_text(a) + ", " + polhode::to_text(b);
      const certificate proved = c.prove(wanted);
      if (proved.verdict != status::certified) continue;
      const report found = check(to_json(proved).dump());
      EXPECT_TRUE(found.is_verified() || found.result == outcome::not_checkable)
          << what << ": " << to_text(found.result) << " at " << found.place << ": "
          << found.message;
      ++(found.is_verified() ? verified : not_checkable);
    }
  }
  EXPECT_GT(verified, 20 * not_checkable);
}

void expect_verified(const std::string& name, const rational& a, const rational& b) {
  proofs::request wanted;
  wanted.digits = 20;
  wanted.motion.a = a;
  wanted.motion.b = b;
  const proofs::claim* c = proofs::find_claim(name);
  ASSERT_NE(c, nullptr) << name;
  const certificate proved = c->prove(wanted);
  EXPECT_EQ(proved.method.find("was not found"), std::string::npos) << proved.method;
  const report found = check(to_json(proved).dump());
  EXPECT_TRUE(found.is_verified()) << found.place << ": " << found.message;
}

TEST(DrawnBodies, HaveNumbersOfExtremeSizesThatTheCheckerTakes) {
  // c0/a is some 10^-2735 and the full turn's some 10^-1370.
  expect_verified("perfect_twist", 1'000'000, rational(9999, 10'000));
  // Some 10^90 half turns in a turn.
  expect_verified("injectivity", parse_rational("1e90"), parse_rational("1e-191"));
}

}  // namespace drawn_bodies_test
}  // namespace polhode::checker
