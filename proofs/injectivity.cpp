// epsilon(c) is injective exactly for physical bodies: the paper's theorem 3 and proposition 4. The
// argument: proofs/arguments/injectivity.md.

#include <algorithm>
#include <optional>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "proofs/claims.hpp"
#include "proofs/half_phase.hpp"
#include "proofs/twist.hpp"
#include "statements/injectivity.hpp"

namespace polhode::proofs {
namespace {

/// Of epsilon(c) - level, from precisions that grow until it is decided.
certain_sign side_of(const body& rigid, const exact_real& c, const ball& level) {
  certain_sign result = certain_sign::unknown;
  (void)is_decided([&](precision p) {
    result = sign_of(twist_defect(rigid, c, p) - level);
    return result == certain_sign::negative || result == certain_sign::positive;
  });
  return result;
}

std::string decimals(const exact_real& x) { return to_decimal(x.at(size_in_bits(x) + 64), 12); }

// ---------------------------------------------------------------------------------------------
// Physical: a decreasing chain

struct curve_point {
  rational c;
  ball epsilon;
};

/// From c = a down to near -b; a and b to 32 bits where they are irrational.
std::vector<rational> places_on(const body& rigid) {
  constexpr unsigned bits = 32;
  const rational a = rational_below(rigid.a(), bits);
  const rational b = rational_below(rigid.b(), bits);
  std::vector<rational> places;
  for (int k = 12; k >= 1; --k) places.emplace_back(a * k / 12);
  for (const int n : {50, 250}) places.emplace_back(a / n);
  places.emplace_back(0);
  for (const int n : {250, 50}) places.emplace_back(-b / n);
  for (int k = 1; k < 12; ++k) places.emplace_back(-b * k / 12);
  for (const int n : {50, 250}) places.emplace_back(-b * (n - 1) / n);
  return places;
}

/// The points of the curve at these c where p bits enclose them.
std::vector<curve_point> points_at(const body& rigid, const std::vector<rational>& places,
                                   precision p) {
  std::vector<curve_point> points;
  points.reserve(places.size());
  for (const rational& c : places) {
    const ball epsilon = twist_defect(rigid, c, p);
    if (epsilon.is_bounded()) points.push_back({c, epsilon});
  }
  return points;
}

/// Points along which epsilon increases certainly and stays below pi/2: all, but for those that
/// overlap the one before or pi/2. Nothing where two points, or one and pi/2, are certainly in the
/// wrong order.
std::optional<std::vector<curve_point>> increasing_part(const std::vector<curve_point>& points) {
  std::vector<curve_point> part;
  part.reserve(points.size());
  for (const curve_point& point : points) {
    const ball half_pi = scale(pi(point.epsilon.precision()), -1);
    if (certainly_less_equal(half_pi, point.epsilon) ||
        (!part.empty() && certainly_less_equal(point.epsilon, part.back().epsilon))) {
      return std::nullopt;
    }
    if (certainly_less(point.epsilon, half_pi) &&
        (part.empty() || certainly_less(part.back().epsilon, point.epsilon))) {
      part.push_back(point);
    }
  }
  return part;
}

void add_chain(certificate& c, const body& rigid) {
  const std::vector<rational> places = places_on(rigid);
  std::optional<std::vector<curve_point>> points;
  // twist_defect has some 40 bits at any precision: more would not part points that these do not.
  for (const precision p : {128, 512}) {
    points = increasing_part(points_at(rigid, places, p));
    if (!points || points->size() == places.size()) break;
  }
  if (!points) {
    c.facts.push_back(
        {"at the given a, b: epsilon(c) increases as c goes down from a and stays below pi/2",
         false, step_kind::enclosed});
    return;
  }
  // As the certificate has them: the decimals of neighbouring points, and of pi/2, must be apart,
  // too.
  json chain = json::array();
  std::optional<rational> before;
  for (const curve_point& point : *points) {
    constexpr long digits = 12;
    const decimal_enclosure epsilon = to_decimal_enclosure(point.epsilon, digits);
    const rational upper = parse_rational(epsilon.upper);
    constexpr precision enough = 128;
    const bool is_below = certainly_less(ball(upper, enough), scale(pi(enough), -1));
    if (!is_below || (before && parse_rational(epsilon.lower) <= *before)) continue;
    before = upper;
    chain.push_back(
        json{{"c", to_text(point.c)}, {"lower", epsilon.lower}, {"upper", epsilon.upper}});
  }
  if (chain.size() < 3) {
    c.witness["chain"] = nullptr;
    note_missing_witness(c, statements::chain_of_points);
    return;
  }
  c.facts.push_back({statements::fill(statements::increasing_chain, {std::to_string(chain.size())}),
                     true, step_kind::enclosed});
  c.witness["chain"] = std::move(chain);
}

// ---------------------------------------------------------------------------------------------
// Not physical: two c with the same epsilon

/// Halves the bracket of u while the side of epsilon at the middle is decided; epsilon(lower) is
/// below the level exactly where below_at_lower.
root_bracket refined(const body& rigid, root_bracket bracket, const ball& level,
                     bool below_at_lower) {
  constexpr int steps = 24;
  for (int i = 0; i < steps; ++i) {
    const rational middle((bracket.lower + bracket.upper) / 2);
    const exact_real c = -rigid.b() * middle;
    const certain_sign side = side_of(rigid, c, level);
    if (side != certain_sign::negative && side != certain_sign::positive) break;
    ((side == certain_sign::negative) == below_at_lower ? bracket.lower : bracket.upper) = middle;
  }
  return bracket;
}

/// |psi_c(pi)| <= arcsin sqrt(1 - u), with 1 - u = 2^-k: below the level for such an u.
std::optional<rational> place_near_end(const ball& level) {
  constexpr int most_halvings = 4096;
  for (int k = 1; k <= most_halvings; k *= 2) {
    const ball w = scale(ball(1, level.precision()), -k);
    const ball most = scale(pi(level.precision()), -1) + asin(sqrt(w));
    if (certainly_less(most, level)) return rational(1 - lower_rational(w));
  }
  return std::nullopt;
}

struct witnesses {
  ball level;          // epsilon of both, an exact number
  root_bracket first;  // of u = -c/b
  root_bracket second;
};

/// The curve rises above pi/2 after its first crossing, at G = pi, and comes back to it. Between
/// the crossing and a place with G = q pi, q = max(3/4, (1 + I)/2), and between that place and one
/// near u = 1, it passes a level between pi/2 and its value there.
std::optional<witnesses> find_witnesses(const body& rigid) {
  constexpr precision p = 1024;
  const rational near_I = lower_rational(rigid.geometric_constant(p));
  const rational q = std::max(rational(3, 4), rational((1 + near_I) / 2));
  if (q >= 1) return std::nullopt;
  const auto crossing = bracket_half_phase_root(rigid, 1);
  const auto place = bracket_half_phase_root(rigid, q);
  if (!crossing || !place || crossing->lower >= place->lower) return std::nullopt;
  const rational left = crossing->lower;
  const rational top = place->lower;
  const ball at_top = twist_defect(rigid, -rigid.b() * top, p);
  if (!at_top.is_bounded()) return std::nullopt;
  const ball half_pi = scale(pi(p), -1);
  const ball level = scale(half_pi + at_top, -1).middle();
  const auto right = place_near_end(level);
  if (!right || *right <= top || !certainly_less(half_pi, level) ||
      side_of(rigid, -rigid.b() * left, level) != certain_sign::negative) {
    return std::nullopt;
  }
  return witnesses{level, refined(rigid, {left, top}, level, true),
                   refined(rigid, {top, *right}, level, false)};
}

void add_witnesses(certificate& c, const body& rigid) {
  const auto found = find_witnesses(rigid);
  if (!found) {
    c.witness["two_c"] = nullptr;
    note_missing_witness(c, statements::pair_of_c);
    return;
  }
  const auto place = [&](const rational& u) { return decimals(exact_real(-rigid.b() * u)); };
  const auto c_of = [&](const rational& u) { return exact_real(-rigid.b() * u); };
  const rational& end = found->second.upper;
  const precision p = found->level.precision();
  const ball most_at_end = scale(pi(p), -1) + asin(sqrt(ball(rational(1 - end), p)));
  c.facts.push_back(
      {statements::fill(
           statements::two_c_with_one_epsilon,
           {to_decimal(found->level, 8), place(found->first.lower), place(found->first.upper),
            place(found->second.lower), place(found->second.upper)}),
       found->first.upper <= found->second.lower &&
           side_of(rigid, c_of(found->first.lower), found->level) == certain_sign::negative &&
           side_of(rigid, c_of(found->first.upper), found->level) == certain_sign::positive &&
           side_of(rigid, c_of(found->second.lower), found->level) == certain_sign::positive &&
           (certainly_less(most_at_end, found->level) ||
            side_of(rigid, c_of(end), found->level) == certain_sign::negative),
       step_kind::enclosed});
  c.witness["two_c"] = json{{"epsilon", to_text(lower_rational(found->level))},
                            {"u_first", as_json(found->first)},
                            {"u_second", as_json(found->second)}};
}

certificate prove_injectivity(const request& wanted) {
  certificate c;
  add_steps(c, statements::injectivity().steps);
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const bool physical = !exceeds_geometric_constant(1, rigid);
  c.facts.push_back({statements::fill(statements::injective_or_not,
                                      {std::string(physical ? ">=" : "<"), to_text(rigid.kind()),
                                       (physical ? "injective" : "not injective")}),
                     physical == (rigid.kind() != body_kind::non_physical), step_kind::exact});
  if (physical) {
    add_chain(c, rigid);
  } else {
    add_witnesses(c, rigid);
  }
  c.conclude();
  return c;
}

}  // namespace

claim injectivity_claim() { return {statements::injectivity(), prove_injectivity}; }

}  // namespace polhode::proofs
