// The claims for given bodies, and what they are made of, against routes that share nothing with
// them.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/complete.hpp"
#include "polhode/elliptic/jacobi.hpp"
#include "polhode/elliptic/parameter.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "polhode/rigid_body/twist_curve.hpp"
#include "proofs/body_facts.hpp"
#include "proofs/claim.hpp"
#include "proofs/half_phase.hpp"
#include "proofs/printed_values.hpp"
#include "proofs/rotating_phase.hpp"
#include "proofs/separatrix.hpp"
#include "proofs/twist.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode::proofs {
namespace bodies_test {

certificate prove(std::string_view name, const body& rigid, long digits = 15) {
  request wanted;
  wanted.digits = digits;
  wanted.motion.a = rigid.a().exact();
  wanted.motion.b = rigid.b().exact();
  return find_claim(name)->prove(wanted);
}

bool mentions(const certificate& c, const std::string& words) {
  for (const checked_fact& f : c.facts) {
    if (f.statement.find(words) != std::string::npos) return true;
  }
  return false;
}

/// a and b of very different sizes, b up to within 10^-12 of 1; physical, planar and not.
body any_body(support::random_source& random) {
  const auto power = [&](long low, long high) {
    return rational(rational(random.between(1, 99), 10) *
                    support::power_of_ten(random.between(low, high)));
  };
  switch (random.between(0, 3)) {
    case 0: {
      const rational b(random.between(1, 49), 100);
      return {rational(1 / b - 2), b};  // planar
    }
    case 1:
      return {power(-6, 3), rational(1 - power(-12, -2))};
    case 2:
      return {power(-6, 2), power(-9, -2)};
    default:
      return {power(-2, 1), rational(random.between(1, 99), 100)};
  }
}

TEST(BodyClaims, AreCertifiedForEveryBody) {
  support::random_source random(41);
  for (support::repeat trial(8); trial.again();) {
    const body rigid = any_body(random);
    for (const claim& c : all_claims()) {
      if (c.subject != claim_subject::body) continue;
      const certificate result = prove(c.name, rigid);
      EXPECT_EQ(result.verdict, status::certified) << to_text(result);
    }
  }
}

TEST(BodyClaims, AreCertifiedFarOut) {
  for (const auto& [a, b] :
       std::vector<std::pair<const char*, const char*>>{{"1e-40", "1/2"},
                                                        {"1e-20", "0.4"},
                                                        {"1e40", "1e-41"},
                                                        {"1e6", "0.9"},
                                                        {"1e-30", "1e-30"},
                                                        {"1", "0.999999999999999999"}}) {
    for (const claim& c : all_claims()) {
      if (c.subject != claim_subject::body) continue;
      const certificate result = prove(c.name, with_ab(a, b));
      EXPECT_EQ(result.verdict, status::certified) << to_text(result);
    }
  }
}

TEST(BodyClaims, DoNotNeedTheirWitnesses) {
  struct row {
    const char* claim;
    const char* a;
    const char* b;
    const char* missing;
  };
  for (const row& r :
       {row{"first_equation", "1e-2600", "0.4", "the order of some values of F(c,u)"},
        row{"epsilon0_decreases", "1e-2600", "0.4", "the order of epsilon0 for a and 2a"},
        row{"epsilon0_decreases", "1e300", "0.5", "an enclosure of epsilon0 for 2a"},
        row{"separatrix_twist", "1e300", "0.5", "an enclosure of epsilon0"},
        row{"limit_minimum", "1e40", "planar", "a bracket of c0 that lies on one side"}}) {
    const body rigid = std::string(r.b) == "planar"
                           ? body(parse_rational(r.a), rational(1 / (parse_rational(r.a) + 2)))
                           : with_ab(r.a, r.b);
    const certificate c = prove(r.claim, rigid);
    EXPECT_EQ(c.verdict, status::certified) << to_text(c);
    EXPECT_NE(c.method.find(r.missing), std::string::npos) << c.method;
    EXPECT_NE(c.method.find("The proof does not need it."), std::string::npos) << c.method;
  }
  EXPECT_NE(prove("limit_minimum", with_ab("0.1", "0.1")).method.find("there is no c0"),
            std::string::npos);
}

TEST(Comparisons, HoldOrDoNotOrAreNoted) {
  const auto added = [](const ball& less, const ball& greater) {
    certificate c;
    add_comparisons(c, "order", "the order", [&](precision) {
      return std::vector<comparison>{{ball(0, 64), ball(1, 64)}, {less, greater}};
    });
    return c;
  };
  const ball one(1, 64);
  const ball two(2, 64);
  ASSERT_EQ(added(one, two).facts.size(), 1U);
  EXPECT_TRUE(added(one, two).facts[0].holds);
  ASSERT_EQ(added(two, one).facts.size(), 1U);
  EXPECT_FALSE(added(two, one).facts[0].holds);
  EXPECT_FALSE(added(one, one).facts[0].holds);
  for (const ball& wide : {hull(one, two), ball::undefined(64)}) {
    const certificate c = added(one, wide);
    EXPECT_TRUE(c.facts.empty());
    EXPECT_NE(c.method.find("the order was not found"), std::string::npos);
  }
}

TEST(BodyClaims, DecideOnTheBoundary) {
  const body planar = with_ab("1", "1/3");
  EXPECT_TRUE(mentions(prove("physical", planar), "I = 1 exactly"));
  EXPECT_TRUE(mentions(prove("injectivity", planar), "planar: epsilon(c) is injective"));
  EXPECT_TRUE(mentions(prove("crossing", planar), "for no k"));
  const rational little = parse_rational("1e-30");
  EXPECT_TRUE(mentions(prove("injectivity", body(1 - little, rational(1, 3))), "is injective"));
  EXPECT_TRUE(mentions(prove("injectivity", body(1 + little, rational(1, 3))), "not injective"));
  // I = 2, and J = 2: (a+1)^2 = 9 a (a+b) at a = 1/5, b = 3/5; J = 1: (a+1)^2 = 4 a (a+b) at a =
  // 1/2, b = 5/8.
  EXPECT_TRUE(mentions(prove("intersection", with_ab("77/40", "1/10")), "I >= 2"));
  EXPECT_TRUE(
      mentions(prove("perfect_twist", with_ab("1/5", "3/5")), "so there is no perfect twist"));
  EXPECT_TRUE(
      mentions(prove("perfect_twist", with_ab("1/2", "5/8")), "so there is a perfect twist"));
  EXPECT_TRUE(mentions(prove("perfect_twist", with_ab("1/2", "5/8")), "so there is no full turn"));
  EXPECT_TRUE(mentions(prove("perfect_twist", body(rational(1, 2) + little, rational(5, 8))),
                       "so there is a full turn"));
}

TEST(Counts, AreTheCeilingFormulas) {
  support::random_source random(42);
  for (support::repeat trial(300); trial.again();) {
    const body rigid = any_body(random);
    const integer crossings = count_crossings(rigid);
    const integer intersections = count_intersections(rigid);
    if (rigid.exact_geometric_constant()) {
      const rational inverse(1 / *rigid.exact_geometric_constant());
      const auto ceiling = [](const rational& q) {
        return integer((numerator(q) + denominator(q) - 1) / denominator(q));
      };
      EXPECT_EQ(crossings, ceiling(inverse) - 1);
      EXPECT_EQ(intersections, ceiling(inverse + rational(1, 2)) - 1);
      continue;
    }
    const ball inverse = 1 / rigid.geometric_constant(400);
    EXPECT_TRUE(contains(ceil(inverse) - 1, rational(crossings)))
        << rigid.a().exact() << " " << rigid.b().exact();
    EXPECT_TRUE(contains(ceil(inverse + rational(1, 2)) - 1, rational(intersections)));
    EXPECT_TRUE(ceil(inverse).is_exact());
  }
  EXPECT_EQ(count_intersections(with_ab("77/40", "1/10")), 0) << "I = 2";
  EXPECT_EQ(count_intersections(with_ab("12.65", "0.0629")), 1);
  EXPECT_EQ(count_intersections(with_ab("39.95", "0.0629")), 2);
  EXPECT_EQ(count_crossings(with_ab("1", "1/3")), 0) << "I = 1";
}

/// The number after the last of these words, up to a space.
rational number_after(const std::string& text, const std::string& words) {
  const std::size_t from = text.rfind(words) + words.size();
  return parse_rational(text.substr(from, text.find(' ', from) - from));
}

TEST(Counts, TheSlopeWhereCMeetsSIsThatOfTheCurve) {
  const body rigid = with_ab("900", "0.0629");
  const certificate c = prove("count", rigid, 30);
  long points = 0;
  for (const checked_fact& f : c.facts) {
    if (f.statement.find("the same slope") == std::string::npos) continue;
    const long k = ++points;
    const meeting at = meeting_to_digits(rigid, 2 * k - 1, 60);
    const ball slope =
        twist_to_digits(rigid, lower_rational(at.c) - support::power_of_ten(-45), 40).slope;
    const bool falls = f.statement.find("= -2 b sqrt") != std::string::npos;
    const rational size = number_after(f.statement, "between ");
    const rational more = number_after(f.statement, " and ");
    EXPECT_TRUE(size < more && more < size * parse_rational("1.00000001")) << f.statement;
    const rational given = falls ? -size : size;
    EXPECT_EQ(falls, k % 2 == 1) << f.statement;
    EXPECT_TRUE(certainly_less(abs(slope * given - 1), ball(support::power_of_ten(-8), 200)))
        << f.statement << ' ' << slope;
  }
  EXPECT_EQ(points, 6);
}

TEST(Brackets, HoldTheRootAndNothingElsePasses) {
  support::random_source random(43);
  for (support::repeat trial(40); trial.again();) {
    const body rigid = any_body(random);
    const rational q(random.between(1, 40), 10);
    const auto bracket = bracket_half_phase_root(rigid, q);
    EXPECT_EQ(exceeds_geometric_constant(q, rigid),
              certainly_less(rigid.geometric_constant(300), ball(q, 300)));
    if (!exceeds_geometric_constant(q, rigid)) {
      EXPECT_FALSE(bracket);
    }
    if (!bracket) continue;
    EXPECT_LT(bracket->lower, bracket->upper);
    EXPECT_TRUE(passes_half_phase(rigid, q, *bracket));
    EXPECT_FALSE(passes_half_phase(rigid, q, {bracket->upper, bracket->lower}));
    EXPECT_FALSE(passes_half_phase(rigid, rational(q * 101 / 100), *bracket));
    EXPECT_FALSE(passes_half_phase(rigid, rational(q * 99 / 100), *bracket));
    // As periodic quadrature has it.
    EXPECT_TRUE(certainly_less(half_phase(rigid, bracket->upper, 400), pi(400) * q));
  }
  // The root is at 1 - u of the order of 10^-60: 128 bits don't tell the sides apart.
  const body nearly_planar(1 + parse_rational("1e-60"), rational(1, 3));
  const auto near_end = bracket_half_phase_root(nearly_planar, 1);
  ASSERT_TRUE(near_end);
  EXPECT_TRUE(passes_half_phase(nearly_planar, 1, *near_end));
  const body rigid = with_ab("12.65", "0.0629");
  const auto c0 = bracket_rotating_phase_root(rigid, 2);
  ASSERT_TRUE(c0);
  EXPECT_TRUE(passes_rotating_phase(rigid, 2, *c0));
  EXPECT_FALSE(passes_rotating_phase(rigid, 1, *c0));
  EXPECT_FALSE(passes_rotating_phase(rigid, 2, {c0->upper, c0->lower}));
  EXPECT_FALSE(bracket_rotating_phase_root(with_ab("0.001", "0.5"), 2));
}

/// psi_c(pi) by the classical Runge-Kutta method on the paper's eqs. (18) and (19), in hardware
/// arithmetic.
double integrated_defect(double a, double b, double c) {
  constexpr int steps = 40'000;
  const double pi_double = std::acos(-1.0);
  const double h = pi_double / steps;
  struct state {
    double psi;
    double theta;
  };
  const auto slope = [&](const state& s) -> state {
    const double x = std::cos(s.psi) * std::cos(s.psi);
    return {(a + b * x) * std::cos(s.theta) / (1 - b * x),
            b * std::sin(s.theta) * std::sin(s.psi) * std::cos(s.psi) / (1 - b * x)};
  };
  const auto moved = [](const state& s, const state& d, double t) -> state {
    return {s.psi + t * d.psi, s.theta + t * d.theta};
  };
  state s{0, std::acos(std::sqrt((c + b) / (a + b)))};
  for (int i = 0; i < steps; ++i) {
    const state k1 = slope(s);
    const state k2 = slope(moved(s, k1, h / 2));
    const state k3 = slope(moved(s, k2, h / 2));
    const state k4 = slope(moved(s, k3, h));
    s = {s.psi + h / 6 * (k1.psi + 2 * k2.psi + 2 * k3.psi + k4.psi),
         s.theta + h / 6 * (k1.theta + 2 * k2.theta + 2 * k3.theta + k4.theta)};
  }
  return pi_double / 2 - s.psi;
}

TEST(TwistDefect, IsTheSolutionOfTheReducedSystem) {
  struct row {
    const char* a;
    const char* b;
    const char* c;
  };
  // Before and after each intersection of the curves, on either side of pi/2, on the separatrix,
  // rotating, over and over.
  for (const row& r : {row{"12.65", "0.0629", "-0.06"},  row{"12.65", "0.0629", "-0.01"},
                       row{"12.65", "0.0629", "-0.001"}, row{"12.65", "0.0629", "0"},
                       row{"12.65", "0.0629", "0.01"},   row{"12.65", "0.0629", "3"},
                       row{"12.65", "0.0629", "12.65"},  row{"18.27", "0.0629", "-0.05"},
                       row{"18.27", "0.0629", "-0.03"},  row{"39.95", "0.0629", "-0.06"},
                       row{"39.95", "0.0629", "-0.05"},  row{"39.95", "0.0629", "-0.02"},
                       row{"39.95", "0.0629", "-0.004"}, row{"5", "0.8", "-0.79"},
                       row{"5", "0.8", "-0.6"},          row{"5", "0.8", "-0.4"},
                       row{"5", "0.8", "-0.2"},          row{"5", "0.8", "-0.05"},
                       row{"1", "1/3", "0.3"},           row{"0.1", "0.9", "-0.5"}}) {
    const body rigid = with_ab(r.a, r.b);
    const rational c = parse_rational(r.c);
    const ball epsilon = twist_defect(rigid, c, 128);
    ASSERT_TRUE(epsilon.is_bounded());
    const double expected =
        integrated_defect(rigid.a().exact().convert_to<double>(),
                          rigid.b().exact().convert_to<double>(), c.convert_to<double>());
    const ball error = abs(epsilon - ball::exactly(expected));
    EXPECT_TRUE(certainly_less(error, ball(parse_rational("1e-8"), 64)))
        << r.a << " " << r.b << " " << r.c << ": " << epsilon << " " << expected;
    EXPECT_TRUE(epsilon.radius() <= magnitude::power_of_two(-30));
  }
}

TEST(TwistDefect, OnTheSeparatrixIsTheOtherRoute) {
  support::random_source random(44);
  for (support::repeat trial(20); trial.again();) {
    const body rigid(rational(random.between(1, 400), 10), rational(random.between(1, 99), 100));
    const ball one = separatrix_defect(rigid, 128);
    const ball other = twist_defect(rigid, 0, 128);
    EXPECT_TRUE(overlaps(one, other)) << one << " " << other;
    EXPECT_TRUE(one.radius() <= magnitude::power_of_two(-100));
    // F(0, sin^2 epsilon0) = 2 pi by Carlson's integrals: signs at both sides of the root.
    const ball u = square(sin(one));
    const rational below(lower_rational(u) * (1 - parse_rational("1e-20")));
    const rational above(upper_rational(u) * (1 + parse_rational("1e-20")));
    EXPECT_TRUE(certainly_less(2 * pi(256), phase_integral(rigid, 0, below, 256)));
    EXPECT_TRUE(certainly_less(phase_integral(rigid, 0, above, 256), 2 * pi(256)));
  }
}

TEST(Injectivity, HasTwoWitnessesForEveryBodyThatIsNotPhysical) {
  for (const auto& [a, b] : std::vector<std::pair<const char*, const char*>>{{"18.27", "0.0629"},
                                                                             {"39.95", "0.0629"},
                                                                             {"5", "0.8"},
                                                                             {"0.1", "0.9"},
                                                                             {"1.000000001", "1/3"},
                                                                             {"100", "0.3"}}) {
    const body rigid = with_ab(a, b);
    const certificate c = prove("injectivity", rigid);
    EXPECT_EQ(c.verdict, status::certified);
    const json& two = c.witness.at("two_c");
    ASSERT_FALSE(two.is_null()) << a;
    const ball level(parse_rational(two.at("epsilon").get<std::string>()), 1024);
    const auto at = [&](const char* which, const char* end) {
      const rational u = parse_rational(two.at(which).at(end).get<std::string>());
      return twist_defect(rigid, rational(-rigid.b().exact() * u), 512);
    };
    EXPECT_TRUE(certainly_less(at("u_first", "lower"), level));
    EXPECT_TRUE(certainly_less(level, at("u_first", "upper")));
    EXPECT_TRUE(certainly_less(level, at("u_second", "lower")));
    EXPECT_TRUE(certainly_less(at("u_second", "upper"), level));
    EXPECT_LE(parse_rational(two.at("u_first").at("upper").get<std::string>()),
              parse_rational(two.at("u_second").at("lower").get<std::string>()));
  }
}

TEST(Injectivity, HasADecreasingChainForPhysicalBodies) {
  for (const auto& [a, b] : std::vector<std::pair<const char*, const char*>>{
           {"12.65", "0.0629"}, {"3.1", "0.0629"}, {"1", "1/3"}, {"0.01", "0.4"}}) {
    const certificate c = prove("injectivity", with_ab(a, b));
    const json& chain = c.witness.at("chain");
    ASSERT_GE(chain.size(), 25U);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const auto number = [&](std::size_t k, const char* end) {
        return parse_rational(chain[k].at(end).get<std::string>());
      };
      EXPECT_LT(number(i - 1, "upper"), number(i, "lower"));
      EXPECT_GT(parse_rational(chain[i - 1].at("c").get<std::string>()),
                parse_rational(chain[i].at("c").get<std::string>()));
    }
  }
}

TEST(PrintedNumbers, AreRoundedRightOrWrong) {
  const auto at = [](const char* printed, int places, const char* value) {
    return check_rounding(printed, places, parse_ball(value, 100));
  };
  EXPECT_EQ(at("0.59", 2, "0.5949999"), rounding::right);
  EXPECT_EQ(at("0.59", 2, "0.5950001"), rounding::wrong);
  EXPECT_EQ(at("0.59", 2, "0.5850001"), rounding::right);
  EXPECT_EQ(at("0.59", 2, "0.5849999"), rounding::wrong);
  EXPECT_EQ(at("1", 0, "1.027"), rounding::right);
  EXPECT_EQ(at("1", 3, "1.027"), rounding::wrong);
  EXPECT_EQ(as_read("1", 3), "1 (read as 1.000, as its neighbours have 3 decimals)");
  EXPECT_EQ(as_read("0.59", 2), "0.59");
  EXPECT_EQ(check_rounding("0.5", 1, hull(ball(0, 64), ball(1, 64))), rounding::undecided);
  EXPECT_EQ(check_rounding("0.5", 1, ball::undefined(64)), rounding::undecided);
  for (const printed_number& n : right_numbers()) {
    EXPECT_EQ(check_rounding(n.printed, n.places, n.value(100)), rounding::right) << n.what;
  }
  EXPECT_EQ(right_numbers().size(), 8U);
  EXPECT_EQ(wrong_numbers().size(), 5U);
  for (const printed_number& n : wrong_numbers()) {
    EXPECT_EQ(check_rounding(n.printed, n.places, n.value(100)), rounding::wrong) << n.what;
  }
  EXPECT_TRUE(contains(hull(parse_ball("0.93999568", 64), parse_ball("0.93999569", 64)),
                       wrong_numbers().back().value(100)));
}

/// The claim limit_formula's formula, for bodies: beyond turning points too.
TEST(LimitFormula, EnclosesTheTwistOfEveryBody) {
  struct given {
    const char* a;
    const char* b;
    const char* beta;
    int branch;  // n: pi = nG + r
  };
  constexpr precision p = 200;
  for (const given& g :
       {given{"4000000", "0.000001", "-0.9", 2}, given{"900000", "0.00001", "-0.99", 3},
        given{"1000000", "0.000001", "-0.2", 1}, given{"1000000", "0.000001", "-0.005", 0},
        given{"99000", "0.0001", "-0.5", 3}, given{"1000000", "0.000001", "-0.96", 1}}) {
    const rational a = parse_rational(g.a);
    const rational b = parse_rational(g.b);
    const rational beta = parse_rational(g.beta);
    const twist at = twist_to_digits(body(a, b), rational(b * beta), 30, with_slope::no);
    ASSERT_EQ(at.verdict, status::certified);
    EXPECT_EQ(at.branch, g.branch) << g.a << ' ' << g.beta;
    const ball least = pi(p) * sqrt(ball(rational(a * b), p));
    const ball most = least * sqrt(ball(rational((a + b) / a), p)) / ball(rational(1 - b), p);
    const ball xi = hull(least, most);
    const auto limit =
        jacobi_elliptic(xi, elliptic_parameter<ball>::with_complement(ball(rational(-beta), p)));
    const ball enclosed = sqrt(ball(rational(1 + beta), p)) * limit.sn;
    const ball sine = cos(at.epsilon);  // epsilon = pi/2 - psi
    EXPECT_TRUE(overlaps(sine, enclosed)) << g.a << ' ' << g.beta;
    // It is the sign and the size of this sn, and no other.
    EXPECT_TRUE(certainly_less(abs(sine - enclosed), ball(rational(1, 100), p)));
    EXPECT_FALSE(overlaps(-sine, enclosed));
  }
}

/// The greatest difference from the limit that the claim limit_formula allows.
ball rate_of(const rational& a, const rational& b, const rational& beta, const rational& chi) {
  constexpr precision p = 200;
  const ball root = sqrt(ball(chi, p));
  const ball least = sqrt(ball(rational(a * b), p));
  const ball most = least * sqrt(ball(rational((a + b) / a), p)) / ball(rational(1 - b), p);
  return pi(p) * sqrt(ball(rational(1 + beta), p)) * max(abs(least - root), abs(most - root));
}

TEST(LimitFormula, HasTheRateOfTheClaim) {
  support::random_source random(35);
  for (support::repeat trial(60); trial.again();) {
    const rational b(random.between(1, 900), random.one_in(2) ? 1000 : 1000000);
    const rational a(random.between(1, 900), random.one_in(3) ? 1000 : 10);
    const rational beta(random.between(-990, 1500), 1000);
    const rational chi = a * b * rational(random.between(500, 1500), 1000);
    const rational c = b * beta;
    if (c >= a) continue;
    const twist at = twist_to_digits(body(a, b), c, 30, with_slope::no);
    if (at.verdict != status::certified) continue;
    const ball limit = limit_defect_to_digits(chi, beta, 30).enclosure;
    EXPECT_FALSE(certainly_less(rate_of(a, b, beta, chi), abs(at.epsilon - limit)))
        << to_text(a) << ' ' << to_text(b) << ' ' << to_text(beta) << ' ' << to_text(chi);
  }
}

TEST(LimitFormula, AttainsTheRateNearly) {
  // While psi is near 0, where cos^2 = 1, the motion has the greatest xi, and psi the greatest
  // slope.
  for (const char* beta : {"-0.5", "0", "0.5"}) {
    const rational a = parse_rational("1e-6");
    const rational b = parse_rational("1e-6");
    const rational ratio = parse_rational(beta);
    const rational chi = a * b;
    const ball difference =
        abs(twist_to_digits(body(a, b), rational(b * ratio), 30, with_slope::no).epsilon -
            limit_defect_to_digits(chi, ratio, 30).enclosure);
    const ball bound = rate_of(a, b, ratio, chi);
    EXPECT_TRUE(certainly_less(difference, bound)) << beta;
    EXPECT_TRUE(certainly_less(bound * rational(999, 1000), difference)) << beta;
  }
}

TEST(LimitFormula, ExceedsTheMinimumByAtMostTheBoundOfTheClaim) {
  constexpr precision p = 200;
  const ball least = 2 * atan(exp(-pi(p)));
  support::random_source random(36);
  for (support::repeat trial(60); trial.again();) {
    const long scale = random.one_in(2) ? 1000 : 1000000;
    const rational beta(random.between(-999, -1), scale);
    const rational chi(random.between(1, 1000), 1000);
    const ball above = limit_defect_to_digits(chi, beta, 30).enclosure - least;
    const ball bound = pi(p) * (1 - sqrt(ball(chi, p))) +
                       pi(p) * cosh(pi(p)) * sqrt(ball(rational(-beta * chi), p));
    EXPECT_TRUE(certainly_less(ball(0, p), above)) << to_text(beta) << ' ' << to_text(chi);
    EXPECT_TRUE(certainly_less(above, bound)) << to_text(beta) << ' ' << to_text(chi);
  }
}

/// Planar bodies lie between the bounds of limit_minimum, which meet as b -> 0.
TEST(LimitMinimum, PlanarBodiesAreBelowTheUpperBound) {
  constexpr precision p = 200;
  const ball least = 2 * atan(exp(-pi(p)));
  for (const char* text : {"0.3", "0.1", "0.01", "1e-4", "1e-8"}) {
    const rational b = parse_rational(text);
    const rational a = 1 / b - 2;
    const body planar(a, b);
    ASSERT_EQ(planar.kind(), body_kind::planar);
    const ball root = sqrt(ball(rational(1 - 2 * b), p));
    const ball most = 2 * atan(exp(-pi(p) * root));
    const ball epsilon0 = separatrix_defect_to_digits(planar, 30).enclosure;
    EXPECT_TRUE(certainly_less(least, epsilon0) && certainly_less(epsilon0, most)) << text;
    EXPECT_TRUE(certainly_less(most - least, ball(b, p))) << text;  // they meet
    if (!has_perfect_twist(planar)) continue;
    const ball t = perfect_twist_to_digits(planar, 30).enclosure / b;
    EXPECT_TRUE(certainly_less(agm(sqrt(1 + t), sqrt(t)) * 2 * root, ball(1, p))) << text;
    EXPECT_TRUE(certainly_less(ball(1, p), agm(sqrt(1 + t), sqrt(t)) * 2)) << text;
  }
}

}  // namespace bodies_test
}  // namespace polhode::proofs
