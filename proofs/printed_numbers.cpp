#include "proofs/printed_numbers.hpp"

#include <array>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "proofs/claims.hpp"
#include "proofs/half_phase.hpp"
#include "proofs/rotating_phase.hpp"

namespace polhode::proofs {
namespace {

body with_ab(const std::string& a, const std::string& b) {
  return {parse_rational(a), parse_rational(b)};
}

/// Rotational constants are inversely proportional to the moments of inertia.
body with_rotational_constants(const std::array<const char*, 3>& constants) {
  std::array<rational, 3> moments;
  for (std::size_t i = 0; i < moments.size(); ++i) moments[i] = 1 / parse_rational(constants[i]);
  return body::from_moments(moments);
}

body water_at_equilibrium() { return with_rotational_constants({"9.5077", "14.5924", "27.2660"}); }
body water_in_ground_state() { return with_rotational_constants({"9.28", "14.52", "27.88"}); }

int places_of(const std::string& printed) {
  const auto point = printed.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(printed.size() - point - 1);
}

printed_number geometric_constant_of(const std::string& where, const std::string& a,
                                     const std::string& b, const std::string& printed) {
  return {where, "I for a = " + a + ", b = " + b, printed, places_of(printed),
          [rigid = with_ab(a, b)](precision p) { return rigid.geometric_constant(p); }};
}

printed_number geometric_constant_of(const std::string& what, const body& rigid,
                                     const std::string& printed) {
  return {"section 8", "I for water, " + what, printed, places_of(printed),
          [rigid](precision p) { return rigid.geometric_constant(p); }};
}

printed_number paper_constant(const std::string& where, const std::string& name,
                              const std::string& printed) {
  return {where, name, printed, places_of(printed), find_constant(name)->enclose};
}

/// Where a number has so many digits, at most a few times as many bits decide how it rounds.
ball enclosed(const printed_number& n, long digits) {
  return enclose_to_digits(n.value, digits, 15 * bits_for_digits(digits) + 1024);
}

void add_all(certificate& c, const std::vector<printed_number>& numbers, rounding expected,
             long digits) {
  constexpr long shown_digits = 10;
  for (const printed_number& n : numbers) {
    c.numbers.push_back({n.where + ": " + n.what, enclosed(n, digits), digits});
    const ball value = enclosed(n, shown_digits);
    c.facts.push_back(
        {n.where + " prints " + n.printed + " for " + n.what + ", which is " +
             to_decimal(value, shown_digits) +
             (expected == rounding::right ? ": right to the last digit printed" : ": wrong"),
         check_rounding(n.printed, n.places, value) == expected});
  }
}

certificate prove_printed_numbers(const request& wanted) {
  certificate c;
  c.formula = "|printed - value| <= half a unit of the last place printed";
  c.method =
      "Each number is enclosed from its formula in ball arithmetic (beta by interval Newton), and "
      "compared with the printed decimal as an exact rational. Those that are wrong are in the "
      "claim "
      "errata.";
  add_all(c, right_numbers(), rounding::right, wanted.digits);
  c.conclude();
  return c;
}

// ---------------------------------------------------------------------------------------------
// Errata in words

bool phase_increases_in_c(const body& rigid) {
  return is_decided([&](precision p) {
    return certainly_less(montgomery_phase(rigid, rational(-rigid.b() * 3 / 4), p),
                          montgomery_phase(rigid, rational(-rigid.b() / 4), p));
  });
}

void add_words(certificate& c) {
  const rational water_a = water_at_equilibrium().a();
  c.facts.push_back(
      {"section 2 says \"by definition, a > 1\": a > 0 is right; the water molecule of "
       "section 8 has a = " +
           to_decimal(ball(water_a, 64), 8) + " and I > 1",
       water_a > 0 && water_a < 1 && water_at_equilibrium().kind() == body_kind::physical});
  c.facts.push_back(
      {"section 1 says that the phase of oscillating motion is a decreasing function of c: it "
       "increases, for a = 12.65, b = 0.0629 from c = -3b/4 to -b/4 (for all bodies: the claim "
       "montgomery_oscillating)",
       phase_increases_in_c(with_ab("12.65", "0.0629"))});
  const body rigid = with_ab("12.65", "0.0629");
  const auto c0 = bracket_rotating_phase_root(rigid, 2);
  c.facts.push_back(
      {"proposition 3 seeks c0 in (-b, a): it lies in (0, a), for a = 12.65, b = 0.0629 "
       "at c0/a between " +
           (c0 ? in_decimals(*c0) : std::string("?")),
       c0 && c0->lower > 0 && passes_rotating_phase(rigid, 2, *c0)});
  const body planar = with_ab("1", "1/3");
  c.facts.push_back(
      {"section 8 says \"if and only if I > 1\": theorem 3 has I >= 1; the planar body a "
       "= 1, b = 1/3 has I = 1, is physical, and epsilon(c) never crosses pi/2",
       planar.exact_geometric_constant() == rational(1) && planar.kind() == body_kind::planar &&
           count_crossings(planar) == 0});
  const body once = with_ab("18.27", "0.0629");
  c.facts.push_back(
      {"section 6.2 says that for non-physical bodies C and S intersect several times: "
       "for 2/3 <= I < 1 exactly once, as for a = 18.27, b = 0.0629",
       once.kind() == body_kind::non_physical && count_intersections(once) == 1});
  const body twice = with_ab("39.95", "0.0629");
  c.facts.push_back(
      {"theorem 4 says at least n for I < 2/(2n+1): there are at least n + 1; for a = "
       "39.95, b = 0.0629, where n = 1, there are 2",
       exceeds_geometric_constant(rational(2, 3), twice) &&
           !exceeds_geometric_constant(rational(2, 5), twice) && count_intersections(twice) == 2});
  const body at_two = with_ab("77/40", "1/10");
  c.facts.push_back(
      {"lemma 2 says that C and S intersect if and only if I <= 2: at I = 2 the point u "
       "= 1 is only a limit, as for a = 77/40, b = 1/10, where there is no intersection",
       at_two.exact_geometric_constant() == rational(2) && count_intersections(at_two) == 0});
}

certificate prove_errata(const request& wanted) {
  certificate c;
  c.formula = "|printed - value| > half a unit of the last place printed";
  c.method =
      "The numbers as in the claim printed_numbers; statements by an exact counterexample in "
      "rationals, or by enclosures of the phase. The numbers of figure 7, but for 1.045, are those "
      "of b = 0.0629 in place of 0.06, and 0.872 is cut off where 0.873 would be rounded.";
  add_all(c, wrong_numbers(), rounding::wrong, wanted.digits);
  // What figure 7 meant.
  const std::array<std::array<const char*, 3>, 4> meant{{{"12.65", "1.045", "wrong"},
                                                         {"13.89", "1", "right"},
                                                         {"15.38", "0.951", "right"},
                                                         {"18.27", "0.872", "wrong"}}};
  for (const auto& [a, printed, verdict] : meant) {
    const ball value = with_ab(a, "0.0629").geometric_constant(64);
    const bool right = std::string(verdict) == "right";
    c.facts.push_back(
        {std::string("figure 7 with b = 0.0629 in place of 0.06: ") + printed + " for a = " + a +
             " would be " + verdict + ", I = " + to_decimal(value, 8),
         check_rounding(printed, 3, value) == (right ? rounding::right : rounding::wrong)});
  }
  add_words(c);
  c.conclude();
  return c;
}

}  // namespace

const std::vector<printed_number>& right_numbers() {
  static const std::vector<printed_number> numbers{
      geometric_constant_of("figure 6", "39.95", "0.0629", "0.59"),
      geometric_constant_of("figure 6", "18.27", "0.0629", "0.87"),
      geometric_constant_of("figure 6", "12.65", "0.0629", "1.05"),
      geometric_constant_of("figure 6", "3.1", "0.0629", "2.1"),
      paper_constant("eq. (39)", "epsilon0_min", "0.086374"),
      paper_constant("eq. (40)", "beta", "0.028973"),
      paper_constant("section 7", "delta_psi_max", "2.96884"),
      geometric_constant_of("equilibrium", water_at_equilibrium(), "1.001"),
  };
  return numbers;
}

const std::vector<printed_number>& wrong_numbers() {
  static const std::vector<printed_number> numbers = [] {
    std::vector<printed_number> list{
        geometric_constant_of("figure 7", "12.65", "0.06", "1.045"),
        geometric_constant_of("figure 7", "13.89", "0.06", "1"),
        geometric_constant_of("figure 7", "15.38", "0.06", "0.951"),
        geometric_constant_of("figure 7", "18.27", "0.06", "0.872"),
        geometric_constant_of("ground state", water_in_ground_state(), "0.946"),
    };
    list[1].places = 3;  // "1" beside numbers of three decimals
    return list;
  }();
  return numbers;
}

rounding check_rounding(const std::string& printed, int places, const ball& value) {
  const rational decimal = parse_rational(printed);
  const rational half_unit = parse_rational("0.5e-" + std::to_string(places));
  const ball distance = abs(value - decimal);
  const ball limit(half_unit, std::max<precision>(value.precision(), 64));
  if (certainly_less_equal(distance, limit)) return rounding::right;
  if (certainly_less(limit, distance)) return rounding::wrong;
  return rounding::undecided;
}

claim printed_numbers_claim() {
  return {"printed_numbers",
          "figs. 6, 7, eqs. (39), (40), section 8",
          "The numbers in the captions, in section 7 and in the conclusion are those of their "
          "formulas, to the last digit printed, but for those in errata.",
          "enclosures against the printed decimals",
          claim_subject::none,
          prove_printed_numbers};
}

claim errata_claim() {
  return {
      "errata",
      "sections 1 to 8, figure 7",
      "Each printed number that is wrong, beside the certified one, and statements that are not "
      "right as printed.",
      "enclosures against the printed decimals; exact counterexamples",
      claim_subject::none,
      prove_errata};
}

}  // namespace polhode::proofs
