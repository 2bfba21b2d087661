// What each claim's certificate is checked by. The words of claims and steps are in claim_texts.cpp; here are the facts of a given body and the
// numbers.

#include <algorithm>
#include <array>
#include <map>

#include "claims.hpp"
#include "elliptic.hpp"
#include "examination.hpp"
#include "twist.hpp"

namespace polhode::checker {
namespace {

using tri = std::optional<bool>;

interval exactly(const rational& q, precision bits) { return {q, bits}; }

/// x < y: true, false, or not known.
tri below(const interval& x, const interval& y) {
  if (is_below(x, y)) return true;
  if (is_below(y, x)) return false;
  return std::nullopt;
}

tri all_of(std::initializer_list<tri> answers) {
  bool known = true;
  for (const tri& answer : answers) {
    if (answer && !*answer) return false;
    known = known && answer.has_value();
  }
  return known ? tri(true) : std::nullopt;
}

body body_of(const examination& e) { return {e.a(), e.b()}; }

// ---------------------------------------------------------------------------------------------
// Constants

interval epsilon0_min(precision bits) { return atan(exp(-pi(bits))).scaled(1); }
interval delta_psi_max(precision bits) { return pi(bits) - epsilon0_min(bits).scaled(1); }
/// 2 agm(sqrt(1+x), sqrt(x)) - 1, which increases in x > 0 and is 0 at beta.
interval mean_equation(const rational& x, precision bits) {
  const mean_and_sum s = agm_with_sum(sqrt(exactly(rational(1 + x), bits)), sqrt(exactly(x, bits)));
  return s.mean.scaled(1) - exactly(1, bits);
}

/// F(0, sin^2 epsilon) - 2 pi, which decreases in 0 < epsilon < pi/2 and is 0 at epsilon0.
std::function<interval(const rational& x, precision bits)> separatrix_equation(const body& rigid) {
  return [rigid](const rational& epsilon, precision bits) {
    // The root is below pi/2: beyond, the sign is that on its upper side.
    if (is_below(pi(bits) / 2, exactly(epsilon, bits))) return exactly(-1, bits);
    if (epsilon <= 0 || !is_below(exactly(epsilon, bits), pi(bits) / 2)) {
      throw undecided("it is not known to be between 0 and pi/2");
    }
    const sine_and_cosine at = sin_cos(exactly(epsilon, bits));
    return separatrix_phase(rigid.a, rigid.b, square(at.sine), square(at.cosine)) -
           pi(bits).scaled(1);
  };
}

void check_epsilon0(examination& e, const std::string& name, const body& rigid) {
  if (!e.is_missing("an enclosure of " + name)) {
    e.root_number(name, true, separatrix_equation(rigid));
  }
}

void check_constant(examination& e, const std::string& name, bool exists, const rational& exact,
                    const std::function<interval(precision bits)>& f) {
  if (exists) {
    e.fact("at the given a, b: " + name + " = " + exact.str() + " exactly", true);
  } else {
    e.number(name, f);
  }
}
void check_I(examination& e) {
  const body rigid = body_of(e);
  rational exact;
  const bool exists = exact_root(rigid.squared_I(), exact);
  check_constant(e, "I", exists, exact, [&](precision bits) { return rigid.I(bits); });
}
void check_J(examination& e) {
  const body rigid = body_of(e);
  rational exact;
  const bool exists = exact_root(rigid.squared_J_plus_1(), exact);
  exact -= 1;
  check_constant(e, "J", exists, exact, [&](precision bits) { return rigid.J(bits); });
}

// ---------------------------------------------------------------------------------------------
// Brackets

/// G(lower) > q pi > G(upper) for 0 < lower < upper < 1.
tri passes_half_phase(const body& rigid, const rational& q, const range& u, precision bits) {
  if (u.lower <= 0 || u.upper >= 1) return false;
  const interval target = pi(bits) * exactly(q, bits);
  return all_of({below(target, half_phase(rigid.a, rigid.b, u.lower, bits)),
                 below(half_phase(rigid.a, rigid.b, u.upper, bits), target)});
}
/// F(c,0) > q pi > F(c',0) for c = a lower, c' = a upper, 0 < lower < upper < 1.
tri passes_rotating_phase(const body& rigid, const rational& q, const range& s, precision bits) {
  if (s.lower <= 0 || s.upper >= 1) return false;
  const interval target = pi(bits) * exactly(q, bits);
  return all_of(
      {below(target, rotating_phase(rigid.a, rigid.b, rational(rigid.a * s.lower), bits)),
       below(rotating_phase(rigid.a, rigid.b, rational(rigid.a * s.upper), bits), target)});
}
long size_of(const range& r) { return bit_length(r.lower) + bit_length(r.upper); }

std::string counted(const integer& count) {
  if (count == 0) return "no k >= 1";
  return (count == 1 ? "k = 1" : "k = 1 ... " + count.str()) + " and no other k >= 1";
}

/// Brackets of G(u) = q(k) pi for k = 1 ... count, at most six of them.
void check_brackets(examination& e, const integer& count, const std::function<rational(int k)>& q,
                    const std::string& key) {
  constexpr int most = 6;
  const body rigid = body_of(e);
  const int shown = count < most ? static_cast<int>(count) : most;
  const place all = e.witness(key);
  for (int k = 1; k <= shown; ++k) {
    const place one = all.at(static_cast<std::size_t>(k - 1));
    const std::string target = multiple_of_pi(q(k));
    if (one.value().is_null()) {
      if (!e.is_missing("a bracket of G(u) = " + target)) one.malformed("it must be a bracket");
      continue;
    }
    const range u = examination::bracket(one);
    e.fact("at the given a, b, by the AGM: G(u) passes " + target +
               " between u = " + in_decimals(u, e.work()),
           [&](precision bits) { return passes_half_phase(rigid, q(k), u, bits + size_of(u)); });
  }
  if (all.size() > static_cast<std::size_t>(shown)) {
    all.at(static_cast<std::size_t>(shown)).malformed("there are not so many roots to bracket");
  }
}

void check_absence(examination& e, const rational& q) {
  const body rigid = body_of(e);
  e.fact("at the given a, b, in rationals: I >= " + q.str() + "; by the AGM G(1/2) > " +
             multiple_of_pi(q),
         [&](precision bits) -> tri {
           if (rigid.is_above_I(q)) return false;
           return below(pi(bits) * exactly(q, bits),
                        half_phase(rigid.a, rigid.b, rational(1, 2), bits));
         });
}

// ---------------------------------------------------------------------------------------------
// The phases

/// At u = 1/4, 1/2, 3/4 G decreases and keeps within its bounds.
tri half_phase_obeys_its_bounds(const body& rigid, precision bits) {
  const rational& a = rigid.a;
  const rational& b = rigid.b;
  const interval limit = pi(bits) * rigid.I(bits);
  std::optional<interval> before;
  tri result = true;
  for (const int quarter : {1, 2, 3}) {
    const rational u(quarter, 4);
    const interval value = half_phase(a, b, u, bits);
    const interval least =
        (rigid.I(bits) * asinh(pi(bits) / sqrt(exactly(rational(4 * u), bits)))).scaled(1);
    const interval ratio = exactly(rational((1 - b * u) / (1 - b)), bits) *
                           sqrt(exactly(rational((a + b) / (u * (a + b * u))), bits));
    result = all_of({result, below(limit, value), below(least, value), below(value, limit * ratio),
                     before ? below(value, *before) : tri(true)});
    before = value;
  }
  return result;
}

/// At c = a/4, a/2, 3a/4 F(c,0) decreases and keeps within its bounds.
tri rotating_phase_obeys_its_bounds(const body& rigid, precision bits) {
  const interval limit = pi(bits) * rigid.J(bits);
  std::optional<interval> before;
  tri result = true;
  for (const int quarter : {1, 2, 3}) {
    const rational c(rigid.a * quarter / 4);
    const interval value = rotating_phase(rigid.a, rigid.b, c, bits);
    const interval least =
        (rigid.I(bits) * asinh(pi(bits) * sqrt(exactly(rational(rigid.b / (4 * c)), bits))))
            .scaled(1);
    const interval most = limit * sqrt(exactly(rational(4, quarter), bits));
    result = all_of({result, below(limit, value), below(least, value), below(value, most),
                     before ? below(value, *before) : tri(true)});
    before = value;
  }
  return result;
}

void check_physical(examination& e) {
  e.read_body();
  e.steps();
  check_I(e);
  const body rigid = body_of(e);
  const rational excess(1 + 1 / (1 + e.a()) - 1 / (1 - e.b()));
  const rational above(rigid.squared_I() - 1);
  const auto sign = [](const rational& q) { return q > 0 ? 1 : q < 0 ? -1 : 0; };
  e.fact("at the given a, b, in rationals: I_y + I_z - I_x = " + excess.str() +
             " for I_y = 1, and I^2 - 1 = " + above.str() +
             ", of the same sign: " + rigid.kind_in_words(),
         sign(excess) == sign(above) && sign(excess) == rigid.kind());
}

void check_montgomery_oscillating(examination& e) {
  e.read_body();
  e.steps();
  const body rigid = body_of(e);
  e.number("greatest_lower_bound",
           [&](precision bits) { return (pi(bits) * rigid.I(bits)).scaled(1); });
  e.fact(
      "at the given a, b the phase by the AGM at u = 1/4, 1/2, 3/4 decreases, is above 2 pi I and "
      "4 I "
      "arsinh(pi/(2 sqrt(u))), and below 2 pi I g(u)/g(1)",
      [&](precision bits) { return half_phase_obeys_its_bounds(rigid, bits); });
  const bool below_one = rigid.is_above_I(1);
  e.fact("at the given a, b, in rationals: the body is " + rigid.kind_in_words() +
             ", and the greatest lower bound is " + (below_one ? "below 2 pi" : "2 pi or more"),
         below_one == (rigid.kind() < 0));
}

void check_montgomery_rotating(examination& e) {
  e.read_body();
  e.steps();
  const body rigid = body_of(e);
  e.number("greatest_lower_bound",
           [&](precision bits) { return (pi(bits) * rigid.J(bits)).scaled(1); });
  e.fact(
      "at the given a, b the phase by the AGM at c = a/4, a/2, 3a/4 decreases, is above 2 pi J and "
      "4 I "
      "arsinh((pi/2) sqrt(b/c)), and below 2 pi J sqrt(a/c)",
      [&](precision bits) { return rotating_phase_obeys_its_bounds(rigid, bits); });
}

/// The integrals are compared by their integrands and ranges: the integrand is positive, and at every x smaller for the greater c (the
/// claim's steps), and the range u < x < 1 is smaller for the greater u. All five comparisons are of one of these two kinds.
void check_first_equation(examination& e) {
  e.read_body();
  e.steps();
  if (e.is_missing("the order of some values of F(c,u)")) return;
  e.fact(
      "at the given a, b, by Carlson's integrals: F(c,u) decreases from c = -b/8 to 0 to a/2 to a "
      "at u "
      "= 1/2, and from u = 1/4 to 1/2 to 3/4 at c = a/2",
      // They are defined: c + b u >= 0 for c = -b/8, u = 1/2.
      -e.b() / 8 + e.b() / 2 > 0 && e.a() / 2 > 0, enclosed);
}

void check_separatrix_twist(examination& e) {
  e.read_body();
  e.steps();
  check_epsilon0(e, "epsilon0", body_of(e));
}

void check_rotating_root(examination& e, const rational& q, const rational& polynomial,
                         const std::string& what, const std::string& key) {
  const body rigid = body_of(e);
  const rational& a = e.a();
  const bool exists = rigid.is_above_J(q);
  const std::string target = q == 1 ? "pi" : q.str() + " pi";
  e.fact("at the given a, b, in rationals: J " + std::string(exists ? "< " : ">= ") + q.str() +
             ", so there is " + (exists ? "a " : "no ") + what,
         exists == (polynomial > 0));
  if (!exists) {
    e.fact("at the given a, b, by the AGM: F(c,0) > " + q.str() + " pi at c = a/2 and 3a/4",
           [&](precision bits) {
             const interval value = pi(bits) * exactly(q, bits);
             return all_of({below(value, rotating_phase(a, e.b(), rational(a / 2), bits)),
                            below(value, rotating_phase(a, e.b(), rational(3 * a / 4), bits))});
           });
    return;
  }
  const place where = e.witness(key);
  if (where.value().is_null()) {
    if (!e.is_missing("a bracket of the " + what)) where.malformed("it must be a bracket");
    return;
  }
  const range s = examination::bracket(where);
  e.fact("at the given a, b, by the AGM: F(c,0) passes " + target +
             " between c/a = " + in_decimals(s, e.work()),
         [&](precision bits) { return passes_rotating_phase(rigid, q, s, bits + size_of(s)); });
}

void check_perfect_twist(examination& e) {
  e.read_body();
  e.steps();
  check_J(e);
  const rational& a = e.a();
  const rational ab(a * e.b());
  check_rotating_root(e, 2, rational(8 * a * a + 9 * ab - 2 * a - 1), "perfect twist", "c0_over_a");
  check_rotating_root(e, 1, rational(3 * a * a + 4 * ab - 2 * a - 1), "full turn",
                      "full_turn_c_over_a");
}

void check_intersection(examination& e) {
  e.read_body();
  e.steps();
  check_I(e);
  const bool meets = body_of(e).is_above_I(2);
  e.fact(std::string("at the given a, b, in rationals: I ") + (meets ? "<" : ">=") +
             " 2, and 4ab + 3b^2 + 2b - 1 is " + (meets ? "positive" : "not positive"),
         meets == (4 * e.a() * e.b() + 3 * e.b() * e.b() + 2 * e.b() > 1));
  if (meets) {
    check_brackets(
        e, 1, [](int) { return rational(2); }, "intersection");
  } else {
    check_absence(e, 2);
  }
}

void check_crossing(examination& e) {
  e.read_body();
  e.steps();
  check_I(e);
  const body rigid = body_of(e);
  const integer count = rigid.crossings();
  e.witness("crossings_count").expect_text(count.str());
  e.fact("at the given a, b, in rationals: k < 1/I for " + counted(count) + ", and the body is " +
             rigid.kind_in_words(),
         (count == 0 || rigid.is_above_I(rational(integer(1), count))) &&
             !rigid.is_above_I(rational(integer(1), count + 1)) &&
             (count > 0) == (rigid.kind() < 0));
  if (count > 0) {
    check_brackets(
        e, count, [](int k) { return rational(1, k); }, "crossings");
  } else {
    check_absence(e, 1);
  }
}

void check_count(examination& e) {
  e.read_body();
  e.steps();
  check_I(e);
  const body rigid = body_of(e);
  const integer count = rigid.intersections();
  e.witness("N").expect_text(count.str());
  const auto q = [](const integer& k) { return rational(integer(2), 2 * k - 1); };
  e.fact("at the given a, b, in rationals: I < 2/(2k-1) for " + counted(count),
         (count == 0 || rigid.is_above_I(q(count))) && !rigid.is_above_I(q(count + 1)));
  if (count > 0) {
    check_brackets(
        e, count, [&](int k) { return q(integer(k)); }, "intersections");
  } else {
    check_absence(e, 2);
  }
}

// ---------------------------------------------------------------------------------------------
// Injectivity

/// Bits for the twist defect, which has some 50 at any precision.
constexpr std::array<long, 2> twist_precisions{128, 320};
/// The series are meant for numbers of this size: their cost grows with it, and with the number of points.
constexpr long most_twist_bits = 4000;
constexpr long most_level_bits = 4000;
constexpr std::size_t most_points = 100;

void expect_side(const place& where, const body& rigid, const rational& c, const rational& level,
                 int side, const std::string& wrong) {
  const budget::at here = where.working();
  const long size = bit_length(rigid.a) + bit_length(rigid.b) + bit_length(c);
  if (size > most_twist_bits || bit_length(level) > most_level_bits) {
    where.not_checkable("it, c, a and b have too many digits together");
  }
  for (const long bits : twist_precisions) {
    try {
      const long more = 2 * size;
      if (side_of_defect(rigid, c, level, precision(bits + more, where.work())) != side)
        where.refute(wrong);
      return;
    } catch (const undecided&) {  // more bits
    }
  }
  where.not_checkable("the checker's precision does not decide on which side epsilon is");
}

void check_chain(examination& e) {
  const body rigid = body_of(e);
  const place chain = e.witness("chain");
  if (chain.value().is_null()) {
    if (!e.is_missing("a chain of points with certainly different epsilon")) {
      chain.malformed("it must be a chain of points");
    }
    return;
  }
  if (chain.size() < 3 || chain.size() > most_points) {
    chain.malformed("it must have from 3 to 100 points");
  }
  std::optional<rational> c_before;
  std::optional<rational> epsilon_before;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const place point = chain.at(i);
    point.expect_keys({"c", "lower", "upper"});
    const rational c = point["c"].fraction();
    const rational lower = point["lower"].decimal_value();
    const rational upper = point["upper"].decimal_value();
    if (c <= -rigid.b || c > rigid.a) point["c"].refute("it is not above -b and at most a");
    if (c_before && c >= *c_before) point["c"].refute("it must be below that of the point before");
    if (upper <= lower) point["upper"].refute("it is not above lower");
    if (epsilon_before && lower <= *epsilon_before) {
      point["lower"].not_checkable("it is not above the upper end of the point before");
    }
    expect_side(point["lower"], rigid, c, lower, 1, "epsilon(c) is below it");
    expect_side(point["upper"], rigid, c, upper, -1, "epsilon(c) is above it");
    c_before = c;
    epsilon_before = upper;
  }
  e.fact("at the given a, b: epsilon(c) increases as c goes down a chain of " +
             std::to_string(chain.size()) +
             " points towards -b, and is below pi/2, its limit there; as it is monotone by the "
             "proof, the "
             "boxes between neighbouring points cover the curve between them",
         [&](precision bits) { return below(exactly(*epsilon_before, bits), pi(bits) / 2); });
}

void check_two_c(examination& e) {
  const body rigid = body_of(e);
  const place two = e.witness("two_c");
  if (two.value().is_null()) {
    if (!e.is_missing("a pair of c with one epsilon")) two.malformed("it must be a pair");
    return;
  }
  two.expect_keys({"epsilon", "u_first", "u_second"});
  const rational level = two["epsilon"].fraction();
  const range first = examination::bracket(two["u_first"]);
  const range second = examination::bracket(two["u_second"]);
  if (first.lower <= 0) two["u_first"]["lower"].refute("it is not above 0");
  if (first.upper > second.lower) two["u_second"]["lower"].refute("it is below u_first");
  if (second.upper >= 1) two["u_second"]["upper"].refute("it is not below 1");
  const auto c_of = [&](const rational& u) { return rational(-rigid.b * u); };
  const auto text = [&](const rational& u) { return decimal_for_reading(c_of(u), 12, e.work()); };
  const std::string above = "epsilon is above the level there";
  const std::string under = "epsilon is below the level there";
  expect_side(two["u_first"]["lower"], rigid, c_of(first.lower), level, -1, above);
  expect_side(two["u_first"]["upper"], rigid, c_of(first.upper), level, 1, under);
  expect_side(two["u_second"]["lower"], rigid, c_of(second.lower), level, 1, under);
  // epsilon <= pi/2 + arcsin sqrt(1 - u), as |psi_c| is at most the turning point.
  const auto most_is_below = [&](precision bits) -> tri {
    const interval sine_squared = exactly(rational(1 - second.upper), bits);
    const interval most = pi(bits) / 2 + atan(sqrt(sine_squared / exactly(second.upper, bits)));
    return below(most, exactly(level, bits));
  };
  if (most_is_below(precision(256 + size_of(second), e.work())) != tri(true)) {
    expect_side(two["u_second"]["upper"], rigid, c_of(second.upper), level, -1, above);
  }
  e.fact("at the given a, b: epsilon = " + decimal_for_reading(level, 8, e.work()) +
             " (one exact number) is passed between c = " + text(first.lower) + " and " +
             text(first.upper) + ", and again between " + text(second.lower) + " and " +
             text(second.upper) + ": two c with the same epsilon",
         true, enclosed);
}

void check_injectivity(examination& e) {
  e.read_body();
  e.steps();
  check_I(e);
  const body rigid = body_of(e);
  const bool physical = !rigid.is_above_I(1);
  e.fact("at the given a, b, in rationals: I " + std::string(physical ? ">=" : "<") + " 1, " +
             rigid.kind_in_words() + ": epsilon(c) is " +
             (physical ? "injective" : "not injective"),
         physical == (rigid.kind() >= 0));
  if (physical) {
    check_chain(e);
  } else {
    check_two_c(e);
  }
}

// ---------------------------------------------------------------------------------------------
// The parameter a, and the limit

void check_c0_decreases(examination& e) {
  e.read_body();
  e.steps();
  const body rigid = body_of(e);
  const body other{2 * e.a(), e.b()};
  if (!rigid.is_above_J(2)) {
    e.add_to_method(" (At the given a, b J >= 2: there is no c0.)");
    return;
  }
  if (e.is_missing("a bracket of c0")) return;
  const range first = examination::bracket(e.witness("c0_over_a"));
  const range second = examination::bracket(e.witness("c0_over_a_for_2a"));
  e.fact("at the given b, by the AGM: c0 for 2a is below c0 for the given a, c0/a lying between " +
             in_decimals(first, e.work()),
         [&](precision bits) {
           return all_of({passes_rotating_phase(rigid, 2, first, bits + size_of(first)),
                          passes_rotating_phase(other, 2, second, bits + size_of(second)),
                          tri(other.a * second.upper < rigid.a * first.lower)});
         });
}

void check_epsilon0_decreases(examination& e) {
  e.read_body();
  e.steps();
  const body rigid = body_of(e);
  const body other{2 * e.a(), e.b()};
  std::optional<range> first;
  std::optional<range> second;
  if (!e.is_missing("an enclosure of epsilon0")) {
    first = e.root_number("epsilon0", true, separatrix_equation(rigid));
  }
  if (!e.is_missing("an enclosure of epsilon0 for 2a")) {
    second = e.root_number("epsilon0 for 2a", true, separatrix_equation(other));
  }
  if (e.is_missing("the order of epsilon0 for a and 2a")) return;
  const place where = e.fact(
      "at the given b, by interval Newton: epsilon0 for 2a is below epsilon0 for the given a",
      enclosed);
  if (!first || !second) where.not_checkable("the certificate has no enclosures of both");
  if (second->lower >= first->upper) where.refute("it is not so of the two enclosures");
  if (second->upper >= first->lower) where.not_checkable("the two enclosures overlap");
}

void check_steps_only(examination& e) {
  e.read_no_inputs();
  e.steps();
}

void check_limit_minimum(examination& e) {
  e.read_body();
  e.steps();
  const body rigid = body_of(e);
  e.number("epsilon0_min", epsilon0_min);
  const range beta = e.root_number("beta", false, mean_equation);
  e.fact(
      "agm(1, sin epsilon0_min) < 1/2 with sin epsilon0_min = 1/cosh(pi), so that K(cos^2 "
      "epsilon0_min) > pi: for beta < 0, chi <= 1 the limit's motion has either -beta > sin^2 "
      "epsilon0_min, and epsilon >= epsilon* > epsilon0_min, or is still before its first turning "
      "point",
      [&](precision bits) {
        const interval one = exactly(1, bits);
        const interval cosine = (exp(pi(bits)) + exp(-pi(bits))) / 2;
        return below(agm_with_sum(one, one / cosine).mean, exactly(rational(1, 2), bits));
      });
  if (rigid.kind() < 0) {
    e.add_to_method(" (The given body is not physical: the bounds are not for it.)");
    return;
  }
  if (!e.is_missing("the order of epsilon0 and epsilon0_min")) {
    // epsilon0 is above epsilon0_min where F(0, sin^2) - 2 pi is still positive.
    e.fact("at the given a, b, " + rigid.kind_in_words() +
               ": epsilon0, by interval Newton, is above epsilon0_min",
           [&](precision bits) {
             const sine_and_cosine at = sin_cos(epsilon0_min(bits));
             return below(pi(bits).scaled(1),
                          separatrix_phase(rigid.a, rigid.b, square(at.sine), square(at.cosine)));
           });
  }
  if (!rigid.is_above_J(2)) {
    e.add_to_method(" (At the given a, b J >= 2: there is no c0.)");
    return;
  }
  if (e.is_missing("a bracket of c0") ||
      e.is_missing("a bracket of c0 that lies on one side of b beta")) {
    return;
  }
  const range c0 = examination::bracket(e.witness("c0_over_a"));
  e.fact("at the given a, b: c0/b is above beta (c0/a between " + in_decimals(c0, e.work()) + ")",
         [&](precision bits) {
           return all_of({tri(beta.upper < rigid.a * c0.lower / rigid.b),
                          passes_rotating_phase(rigid, 2, c0, bits + size_of(c0))});
         });
}

void check_epsilon0_min(examination& e) {
  e.read_no_inputs();
  e.number("epsilon0_min", epsilon0_min);
  e.fact(
      "log(tan(x/2)) + pi has exactly one root in [0.086, 0.087] (interval Newton), and its "
      "enclosure "
      "overlaps the one by the formula",
      // log(tan(x/2)) increases on (0, pi), so that the root is where the signs differ, and tan(x/2) = e^-pi is the formula.
      [&](precision bits) {
        const auto value = [&](const rational& x) {
          const sine_and_cosine at = sin_cos(exactly(rational(x / 2), bits));
          return log(at.sine / at.cosine) + pi(bits);
        };
        const interval zero = exactly(0, bits);
        return all_of(
            {below(value(rational(86, 1000)), zero), below(zero, value(rational(87, 1000)))});
      });
  examination::decimals(e.witness("second_route"), epsilon0_min);
}

void check_delta_psi_max(examination& e) {
  e.read_no_inputs();
  e.number("delta_psi_max", delta_psi_max);
  // The second route's enclosure holds the same number, so that the two overlap.
  e.fact(
      "pi - 2 epsilon0_min with epsilon0_min from log and tan overlaps the formula in exp and "
      "arctan",
      true, enclosed);
  examination::decimals(e.witness("second_route"), delta_psi_max);
}

void check_half_phase_limits(examination& e) {
  e.read_body();
  e.steps();
  const body rigid = body_of(e);
  e.number("limit", [&](precision bits) { return pi(bits) * rigid.I(bits); });
  e.fact("at the given a, b both bounds hold at u = 1/4, 1/2, 3/4 for the value by the AGM",
         [&](precision bits) { return half_phase_obeys_its_bounds(rigid, bits); });
}

// ---------------------------------------------------------------------------------------------
// Printed numbers

struct printed_number {
  const char* where;
  const char* what;
  const char* printed;
  const char* as_read;   // with the decimals that are meant
  int places;            // of them
  const char* in_short;  // the value to ten digits
  std::function<interval(precision bits)> value;
};

rational number_in(const char* text) {
  rational q;
  if (!read_decimal(text, q)) throw std::logic_error("no decimal");
  return q;
}
body with_ab(const char* a, const char* b) { return {number_in(a), number_in(b)}; }
/// From rotational constants C < B < A: a = B^-1/A^-1 - 1, b = 1 - B^-1/C^-1.
body with_constants(const char* C, const char* B, const char* A) {
  return {number_in(A) / number_in(B) - 1, 1 - number_in(C) / number_in(B)};
}
body water_at_equilibrium() { return with_constants("9.5077", "14.5924", "27.2660"); }

std::function<interval(precision bits)> I_of(const body& rigid) {
  return [rigid](precision bits) { return rigid.I(bits); };
}

/// |value - printed| <= half a unit of the last place.
tri is_right(const interval& value, const char* printed, int places) {
  const rational half(power_of_ten(-places) / 2);
  const rational p = number_in(printed);
  return all_of({below(exactly(rational(p - half), value.bits()), value),
                 below(value, exactly(rational(p + half), value.bits()))});
}
tri is_wrong(const interval& value, const char* printed, int places) {
  const tri right = is_right(value, printed, places);
  return right ? tri(!*right) : std::nullopt;
}

void check_printed(examination& e, const std::vector<printed_number>& numbers, bool right) {
  for (const printed_number& n : numbers) {
    const std::string name = std::string(n.where) + ": " + n.what;
    if (n.value) {
      e.number(name, n.value);
    } else {
      e.root_number(name, false, mean_equation);
    }
  }
  for (const printed_number& n : numbers) {
    e.fact(std::string(n.where) + " prints " + n.as_read + " for " + n.what + ", which is " +
               n.in_short + (right ? "...: right to the last digit printed" : "...: wrong"),
           [&](precision bits) -> tri {
             const rational cut = number_in(n.in_short);
             const auto decimals = static_cast<long>(std::string(n.in_short).find('.'));
             const auto length = static_cast<long>(std::string(n.in_short).size());
             const rational unit = power_of_ten(decimals + 1 - length);
             if (!n.value) {  // beta lies where its equation changes sign
               const interval low = mean_equation(cut, bits);
               const interval high = mean_equation(rational(cut + unit), bits);
               const interval box = interval::between(cut, rational(cut + unit), bits);
               return all_of({tri(low.is_negative()), tri(high.is_positive()),
                              is_right(box, n.printed, n.places)});
             }
             const interval value = n.value(bits);
             return all_of({below(exactly(cut, bits), value),
                            below(value, exactly(rational(cut + unit), bits)),
                            right ? is_right(value, n.printed, n.places)
                                  : is_wrong(value, n.printed, n.places)});
           });
  }
}

void check_printed_numbers(examination& e) {
  e.read_no_inputs();
  const auto I = [](const char* a) { return I_of(with_ab(a, "0.0629")); };
  check_printed(
      e,
      {{"figure 6", "I for a = 39.95, b = 0.0629", "0.59", "0.59", 2, "0.5906913359", I("39.95")},
       {"figure 6", "I for a = 18.27, b = 0.0629", "0.87", "0.87", 2, "0.8726599209", I("18.27")},
       {"figure 6", "I for a = 12.65, b = 0.0629", "1.05", "1.05", 2, "1.047944541", I("12.65")},
       {"figure 6", "I for a = 3.1, b = 0.0629", "2.1", "2.1", 1, "2.100960486", I("3.1")},
       {"eq. (39)", "epsilon0_min", "0.086374", "0.086374", 6, "0.08637409704", epsilon0_min},
       {"eq. (40)", "beta", "0.028973", "0.028973", 6, "0.02897322803", nullptr},
       {"section 7", "delta_psi_max", "2.96884", "2.96884", 5, "2.968844459", delta_psi_max},
       {"section 8", "I for water, equilibrium", "1.001", "1.001", 3, "1.000557630",
        I_of(water_at_equilibrium())}},
      true);
}

void check_errata(examination& e) {
  e.read_no_inputs();
  const auto I = [](const char* a) { return I_of(with_ab(a, "0.06")); };
  check_printed(
      e,
      {{"figure 7", "I for a = 12.65, b = 0.06", "1.045", "1.045", 3, "1.076414286", I("12.65")},
       {"figure 7", "I for a = 13.89, b = 0.06", "1",
        "1 (read as 1.000, as its neighbours have 3 decimals)", 3, "1.027460476", I("13.89")},
       {"figure 7", "I for a = 15.38, b = 0.06", "0.951", "0.951", 3, "0.9766266710", I("15.38")},
       {"figure 7", "I for a = 18.27, b = 0.06", "0.872", "0.872", 3, "0.8963363227", I("18.27")},
       {"section 8", "I for water, ground state", "0.946", "0.946", 3, "0.9399956863",
        I_of(with_constants("9.28", "14.52", "27.88"))}},
      false);
  struct meant {
    const char* a;
    const char* printed;
    const char* as_read;
    bool right;
    const char* in_short;
  };
  for (const meant& m : {meant{"12.65", "1.045", "1.045", false, "1.0479445"},
                         meant{"13.89", "1", "1 (read as 1.000, as its neighbours have 3 decimals)",
                               true, "1.0002956"},
                         meant{"15.38", "0.951", "0.951", true, "0.95081535"},
                         meant{"18.27", "0.872", "0.872", false, "0.87265992"}}) {
    e.fact(
        std::string("figure 7 with b = 0.0629 in place of 0.06: ") + m.as_read + " for a = " + m.a +
            " would be " + (m.right ? "right" : "wrong") + ", I = " + m.in_short + "...",
        [&](precision bits) {
          const interval value = with_ab(m.a, "0.0629").I(bits);
          const rational cut = number_in(m.in_short);
          const auto length = static_cast<long>(std::string(m.in_short).size());
          return all_of({below(exactly(cut, bits), value),
                         below(value, exactly(rational(cut + power_of_ten(2 - length)), bits)),
                         m.right ? is_right(value, m.printed, 3) : is_wrong(value, m.printed, 3)});
        });
  }
  const body water = water_at_equilibrium();
  e.fact(
      "section 2 says \"by definition, a > 1\": a > 0 is right; the water molecule of section 8 "
      "has a = "
      "0.86850689... and I > 1",
      water.a > number_in("0.86850689") && water.a < number_in("0.86850690") && water.kind() > 0);
  const body usual = with_ab("12.65", "0.0629");
  e.fact(
      "section 1 says that the phase of oscillating motion is a decreasing function of c: it "
      "increases, "
      "for a = 12.65, b = 0.0629 from c = -3b/4 to -b/4 (for all bodies: the claim "
      "montgomery_oscillating)",
      [&](precision bits) {
        return below(half_phase(usual.a, usual.b, rational(3, 4), bits),
                     half_phase(usual.a, usual.b, rational(1, 4), bits));
      });
  const range c0{number_in("0.0002473696968432"), number_in("0.0002473696968435")};
  e.fact(
      "proposition 3 seeks c0 in (-b, a): it lies in (0, a), for a = 12.65, b = 0.0629 at c0/a "
      "between " +
          in_decimals(c0, e.work()),
      [&](precision bits) { return passes_rotating_phase(usual, 2, c0, bits); });
  const body planar{1, rational(1, 3)};
  e.fact(
      "section 8 says \"if and only if I > 1\": theorem 3 has I >= 1; the planar body a = 1, b = "
      "1/3 has "
      "I = 1, is physical, and epsilon(c) never crosses pi/2",
      planar.squared_I() == 1 && planar.kind() == 0 && planar.crossings() == 0);
  const body once = with_ab("18.27", "0.0629");
  e.fact(
      "section 6.2 says that for non-physical bodies C and S intersect several times: for 2/3 <= I "
      "< 1 "
      "exactly once, as for a = 18.27, b = 0.0629",
      once.kind() < 0 && once.intersections() == 1);
  const body twice = with_ab("39.95", "0.0629");
  e.fact(
      "theorem 4 says at least n, and one more beyond the n-th, for I < 2/(2n+1): there are "
      "exactly n + "
      "1 for 2/(2n+3) <= I < 2/(2n+1); for a = 39.95, b = 0.0629, where n = 1, there are 2",
      twice.is_above_I(rational(2, 3)) && !twice.is_above_I(rational(2, 5)) &&
          twice.intersections() == 2);
  const body at_two{rational(77, 40), rational(1, 10)};
  e.fact(
      "lemma 2 says that C and S intersect if and only if I <= 2: at I = 2 the point u = 1 is only "
      "a "
      "limit, as for a = 77/40, b = 1/10, where there is no intersection",
      at_two.squared_I() == 4 && at_two.intersections() == 0);
  const range u{number_in("0.053943792"), number_in("0.053943793")};
  e.fact(
      "lemma 1 says that there is one epsilon for each c: at a = 12.65, b = 0.0629 G(u) passes 2 "
      "pi between u = 0.053943792 and 0.053943793, at c between -0.0033930646 and -0.0033930645, "
      "where C meets S; there psi(phi + 2 pi) = -psi(phi) on the whole orbit, so that each epsilon "
      "from epsilon* to pi - epsilon* belongs to this one c, such as 0.4, 0.9 and 1.4, as sin^2 "
      "0.4 > u",
      [&](precision bits) {
        const sine_and_cosine at = sin_cos(exactly(rational(2, 5), bits));
        return all_of(
            {passes_half_phase(usual, 2, u, bits), below(exactly(u.upper, bits), square(at.sine))});
      });
  e.fact(
      "appendix B says that the period T_phi(c) is a decreasing function: by lemma 6 T_phi = 2 "
      "F(-bu,u) decreases in u = -c/b and so increases in c, for a = 12.65, b = 0.0629 from c = "
      "-b/2 to -b/8",
      [&](precision bits) {
        return below(half_phase(usual.a, usual.b, rational(1, 2), bits),
                     half_phase(usual.a, usual.b, rational(1, 8), bits));
      });
  const body first{2, rational(1, 4)};
  const body second{4, rational(1, 100)};
  e.fact(
      "section 7 says that by lemma 5, which is for one b, epsilon0 is smallest as a -> infinity: "
      "for one b bodies are physical up to a = 1/b - 2 only, and between physical bodies of "
      "different b a greater a may have a greater epsilon0: for a = 2, b = 1/4 it is below 1/2, "
      "for a = 4, b = 1/100 above (what follows is so: the claim limit_minimum)",
      [&](precision bits) -> tri {
        if (first.kind() < 0 || second.kind() < 0) return false;
        // F(0, sin^2 epsilon) - 2 pi decreases in epsilon and is 0 at epsilon0.
        const interval zero = exactly(0, bits);
        return all_of({below(separatrix_equation(first)(rational(1, 2), bits), zero),
                       below(zero, separatrix_equation(second)(rational(1, 2), bits))});
      });
  e.steps();
}

}  // namespace

void check_claim(std::string_view name, examination& e) {
  static const std::map<std::string_view, void (*)(examination&)> checks{
      {"physical", check_physical},
      {"montgomery_oscillating", check_montgomery_oscillating},
      {"montgomery_rotating", check_montgomery_rotating},
      {"first_equation", check_first_equation},
      {"separatrix_twist", check_separatrix_twist},
      {"perfect_twist", check_perfect_twist},
      {"intersection", check_intersection},
      {"crossing", check_crossing},
      {"injectivity", check_injectivity},
      {"count", check_count},
      {"c0_decreases", check_c0_decreases},
      {"epsilon0_decreases", check_epsilon0_decreases},
      {"large_a", check_steps_only},
      {"limit_formula", check_steps_only},
      {"limit_minimum", check_limit_minimum},
      {"epsilon0_min", check_epsilon0_min},
      {"delta_psi_max", check_delta_psi_max},
      {"beta", check_beta},
      {"sign_dF_du", check_sign_dF_du},
      {"half_phase_limits", check_half_phase_limits},
      {"implicit_equations", check_steps_only},
      {"printed_numbers", check_printed_numbers},
      {"errata", check_errata},
  };
  checks.at(name)(e);
  e.finish();
}

}  // namespace polhode::checker
