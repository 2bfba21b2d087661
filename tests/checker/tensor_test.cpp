// The checker's bodies with irrational moments: its tensors against the prover's, with which it
// shares nothing, and certificates of such bodies.

#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "checker/body.hpp"
#include "formulas.hpp"
#include "generous.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/certificate/certificate.hpp"
#include "polhode/checker/check.hpp"
#include "polhode/rigid_body/inertia_tensor.hpp"
#include "proofs/claim.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode::checker {
namespace tensor_test {

using polhode::support::random_source;
using polhode::support::repeat;
using entries = std::array<polhode::rational, 6>;

polhode::rational as_provers(const rational& q) { return polhode::rational(q.str()); }

body body_of(const entries& given) {
  std::array<rational, 6> own;
  for (std::size_t i = 0; i < own.size(); ++i) own[i] = rational(given[i].str());
  const auto whole = std::make_shared<const tensor>(own, generous());
  return {whole->a(), whole->b(), whole};
}

std::string in_words(const entries& given) {
  std::string text;
  for (const polhode::rational& one : given) text += polhode::to_text(one) + ", ";
  return text;
}

int as_sign(body_kind kind) {
  return kind == body_kind::physical ? 1 : kind == body_kind::planar ? 0 : -1;
}

void expect_overlap(const interval& x, const ball& y, const std::string& what) {
  EXPECT_LE(as_provers(x.lower()), upper_rational(y)) << what;
  EXPECT_LE(lower_rational(y), as_provers(x.upper())) << what;
  EXPECT_LE(x.high() - x.low(), 8) << what;
}

/// Whether both agree that the square of I is q, and of J + 1.
void expect_same_square(const real& own, const exact_real& known, const std::string& what) {
  ASSERT_EQ(own.is_rational(), known.is_rational()) << what;
  if (!own.is_rational()) return;
  EXPECT_EQ(as_provers(own.exact()), known.exact()) << what;
}

void expect_same(const entries& given) {
  const polhode::body rigid = polhode::body::from_inertia_tensor(given);
  const body own = body_of(given);
  const std::string what = in_words(given);
  EXPECT_EQ(own.kind(), as_sign(rigid.kind())) << what;
  ASSERT_EQ(own.a.is_rational(), rigid.a().is_rational()) << what;
  for (const long bits : {20L, 200L, 1000L}) {
    expect_overlap(own.a.at(at_bits(bits)), rigid.a().at(bits + 64), what);
    expect_overlap(own.b.at(at_bits(bits)), rigid.b().at(bits + 64), what);
  }
  expect_same_square(own.squared_I(), rigid.square_of_geometric_constant(), what);
  expect_same_square(own.squared_J_plus_1(), rigid.square_of_second_constant(), what);
}

/// Of any shape; nearly a sphere; planar, about z; with a rational moment there; and with one that
/// is far smaller than the others.
entries drawn(random_source& random) {
  const auto hundredths = [&](long least, long most) {
    return polhode::rational(random.between(least, most), 100);
  };
  switch (random.between(0, 4)) {
    case 0:
      return {hundredths(50, 400), hundredths(50, 400), hundredths(50, 4000),
              hundredths(-40, 40), hundredths(-40, 40), hundredths(-40, 40)};
    case 1: {
      const polhode::rational e(polhode::support::power_of_ten(-random.between(1, 40)));
      return {1,
              1 + e * random.between(0, 3),
              1 + e * random.between(0, 9),
              e * random.between(1, 5) / 7,
              e * random.between(0, 5) / 11,
              e * e};
    }
    case 2: {
      const polhode::rational x = hundredths(100, 500);
      const polhode::rational y = hundredths(100, 500);
      return {x, y, x + y, hundredths(1, 90), 0, 0};
    }
    case 3: {
      const long k = random.between(10, 1'000'000);
      return {k * k + 1, 1, random.between(2, 9), k, 0, 0};
    }
    default:
      return {random.between(2, 9), random.between(2, 9), random.between(1, 9), 1, 0, 0};
  }
}

TEST(Tensor, HasTheMomentsAndKindsOfTheProvers) {
  random_source random(61);
  for (repeat trial(100); trial.again();) {
    entries given = drawn(random);
    const polhode::rational unit(polhode::support::power_of_ten(random.between(-300, 300)));
    for (polhode::rational& one : given) one *= unit;
    try {
      (void)polhode::inertia_tensor(given);
    } catch (const input_error&) {
      std::array<rational, 6> own;
      for (std::size_t i = 0; i < own.size(); ++i) own[i] = rational(given[i].str());
      EXPECT_THROW((void)tensor(own, generous()), std::invalid_argument) << in_words(given);
      continue;
    }
    expect_same(given);
  }
}

/// I^2 or (J+1)^2 is rational of these, with irrational a and b: by a rational greatest, middle,
/// least moment. The thresholds of the claims are met exactly.
TEST(Tensor, KnowsRationalSquares) {
  const polhode::rational half(1, 2);
  const entries two{2, 3 * half, 3, 1, 0, 0};  // I = 2
  const entries middle{3, 1, 3, 1, 0, 0};      // I^2 = (J+1)^2 = 3/2
  const entries twist{polhode::rational(11, 4),
                      polhode::rational(5, 4),
                      1,
                      polhode::rational(1, 4),
                      0,
                      0};                // J = 2
  const entries turn{8, 2, 1, 2, 0, 0};  // J = 1
  for (const entries& given : {two, middle, twist, turn}) expect_same(given);
  EXPECT_EQ(body_of(two).squared_I(), 4);
  EXPECT_FALSE(body_of(two).is_above_I(2));
  EXPECT_TRUE(body_of(two).is_above_I(rational(2'000'001, 1'000'000)));
  EXPECT_EQ(body_of(middle).squared_I(), rational(3, 2));
  EXPECT_EQ(body_of(middle).squared_J_plus_1(), rational(3, 2));
  EXPECT_EQ(body_of(twist).squared_J_plus_1(), 9);
  EXPECT_FALSE(body_of(twist).is_above_J(2));
  EXPECT_TRUE(body_of(twist).is_above_J(rational(2'000'001, 1'000'000)));
  EXPECT_EQ(body_of(turn).squared_J_plus_1(), 4);
}

// ---------------------------------------------------------------------------------------------
// Certificates

json certificate_of(std::string_view claim, const entries& given, long digits = 20) {
  const auto whole = std::make_shared<const inertia_tensor>(given);
  const polhode::body rigid = polhode::body::from_inertia_tensor(whole);
  return to_json(proofs::find_claim(claim)->prove(
      {digits, {rigid.a(), rigid.b(), polhode::rational(1, 4)}, rigid.irrational_tensor()}));
}

void expect_verified(std::string_view claim, const entries& given, long digits = 20) {
  const json c = certificate_of(claim, given, digits);
  EXPECT_TRUE(c["inputs"].contains("xx")) << claim;
  const report r = check(c.dump());
  EXPECT_EQ(r.result, outcome::verified)
      << claim << " of " << in_words(given) << "at " << r.place << ": " << r.message;
}

TEST(Tensor, HasCertificatesThatTheCheckerTakes) {
  const polhode::rational tenth(1, 10);
  const entries physical{2, 3, polhode::rational(5, 2), tenth, 2 * tenth, tenth};
  const entries planar{1, 2, 3, polhode::rational(1, 3), 0, 0};
  const entries not_physical{1, 2, 20, polhode::rational(1, 7), polhode::rational(1, 9), tenth};
  const entries two{2, polhode::rational(3, 2), 3, 1, 0, 0};
  const entries twist{
      polhode::rational(11, 4), polhode::rational(5, 4), 1, polhode::rational(1, 4), 0, 0};
  for (const entries& given : {physical, planar, not_physical, two, twist}) {
    for (const proofs::claim& c : proofs::all_claims()) {
      if (c.subject >= proofs::claim_subject::body) expect_verified(c.name, given);
    }
  }
  for (const char* claim : {"separatrix_twist", "count", "half_phase_limits"}) {
    expect_verified(claim, physical, 1000);
  }
}

TEST(Tensor, DrawnHasCertificatesThatTheCheckerNeverRefutes) {
  random_source random(62);
  for (repeat trial(4); trial.again();) {
    const entries given = drawn(random);
    try {
      if (polhode::body::from_inertia_tensor(given).a().is_rational()) continue;
    } catch (const input_error&) {
      continue;
    }
    for (const proofs::claim& c : proofs::all_claims()) {
      if (c.subject < proofs::claim_subject::body) continue;
      const report r = check(certificate_of(c.name, given).dump());
      EXPECT_TRUE(r.is_verified() || r.result == outcome::not_checkable)
          << c.name << " of " << in_words(given) << "at " << r.place << ": " << r.message;
    }
  }
}

TEST(Tensor, OfAnotherBodyIsRefused) {
  const entries given{2, 3, polhode::rational(5, 2), polhode::rational(1, 10), 0, 0};
  json c = certificate_of("separatrix_twist", given);
  const auto after = [&](const char* name, const char* text) {
    json other = c;
    other["inputs"][name] = text;
    test::make_digest_right(other);
    return check(other.dump());
  };
  // Another number; two equal moments; one that is negative; none at all.
  EXPECT_EQ(after("xy", "1/11").result, outcome::refuted);
  EXPECT_EQ(after("xy", "1/11").place, "/numbers/epsilon0/dyadic/upper");
  EXPECT_EQ(after("zz", "-1").result, outcome::malformed);
  EXPECT_EQ(after("zz", "-1").place, "/inputs");
  c["inputs"]["xy"] = "0";
  EXPECT_EQ(after("xx", "3").place, "/inputs");
  EXPECT_NE(after("xx", "3").message.find("two principal moments are equal"), std::string::npos);
  EXPECT_EQ(after("u", "1/4").place, "/inputs/u");
  EXPECT_EQ(after("yz", "a").place, "/inputs/yz");
}

}  // namespace tensor_test
}  // namespace polhode::checker
