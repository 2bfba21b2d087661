#include "coq_theory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cli/output/errors.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"

namespace polhode::cli {

namespace {

constexpr double log2_of_10 = 3.3219280948873623;
constexpr long most_quadrature_digits = 12;  // by coq-interval's quadrature
constexpr int most_meetings = 3;             // that are enclosed, each in ten seconds
/// Coq has the number of meetings as a unary number.
constexpr int most_counted = 100;

/// An open interval with ends of so many significant digits that has the number inside.
struct bracket {
  integer lower;
  integer upper;
  long scale = 0;  // of 10: the ends are lower/10^scale and upper/10^scale
};

bracket bracket_of(const certain_number& found, long digits, const char* name) {
  if (found.verdict != status::certified) {
    throw not_certified_error(fmt::format("--coq: {} is not certified to {} digits", name, digits));
  }
  constexpr double least_size = -10000;
  const double size = estimated_log2(found.enclosure.magnitude_upper()) / log2_of_10;
  if (size < least_size) {
    throw usage_error(fmt::format("--coq: {} is below 10^{:.0f}, which is too small for a theory",
                                  name, least_size));
  }
  bracket result;
  result.scale = std::max(0L, digits - 1 - static_cast<long>(std::floor(size)));
  for (;; ++result.scale) {
    const rational unit(integer(pow(integer(10), static_cast<unsigned>(result.scale))));
    result.lower = ceil_of(rational(lower_rational(found.enclosure) * unit)) - 1;
    result.upper = floor_of(rational(upper_rational(found.enclosure) * unit)) + 1;
    if (result.lower > 0) return result;
  }
}

std::string real(const rational& q) {
  return fmt::format("({} / {})", numerator(q).str(), denominator(q).str());
}
std::string real(const integer& n, long scale) {
  return fmt::format("({} / 10^{})", n.str(), scale);
}

/// exists x, P /\ lower < x < upper, and no other.
std::string between(const char* name, const char* predicate, const bracket& x,
                    const std::string& proof) {
  return fmt::format(
      "Theorem {0} : exists x, {1} x /\\\n"
      "  {2} <\n  x <\n  {3} /\\\n"
      "  forall y, {1} y -> y = x.\n"
      "Proof.\n{4}Qed.\n\n",
      name, predicate, real(x.lower, x.scale), real(x.upper, x.scale), proof);
}

constexpr const char* by_quadrature =
    "integral with (i_prec 90, i_degree 20, i_fuel 20000, i_width (-52))";

/// How often C meets S, and where first.
void add_meetings(coq_theory& theory, const body& rigid, long digits) {
  const integer count = intersection_count(rigid);
  theory.text += "(** Where C meets S, theorem 4: c = -b u. *)\n";
  if (count == 0) {
    theory.text +=
        "Theorem no_meeting_with_S : forall c, ~ meeting a b c.\n"
        "Proof. apply never_meets; unfold a, b; lra. Qed.\n";
    return;
  }
  theory.are_meetings_counted = count <= most_counted;
  if (theory.are_meetings_counted) {
    theory.text += fmt::format(
        "Theorem meetings_with_S : has_exactly {0} (meeting a b).\n"
        "Proof.\napply (meets_exactly a b {1} {2}); try (unfold a, b; lra).\n"
        "rewrite INR_IZR_INZ; simpl; lra.\nQed.\n\n",
        count.str(), integer(count - 1).str(), integer(2 * count - 1).str());
  }
  for (int k = 1; k <= most_meetings && k <= count; ++k) {
    const meeting at = meeting_to_digits(rigid, integer(2 * k - 1), digits + 3);
    certain_number u;
    u.verdict = at.verdict;
    u.enclosure = at.u;
    const std::string name = fmt::format("u{}", k);
    const bracket inside = bracket_of(u, digits, name.c_str());
    theory.text += between(
        name.c_str(), fmt::format("meeting_at a b {}", k).c_str(), inside,
        fmt::format("apply (meeting_between a b {0} {1}); try (unfold a, b; lra).\n"
                    "- auto with arith.\n"
                    "- rewrite INR_IZR_INZ; simpl; lra.\n"
                    "- unfold HalfPhase.G, HalfPhase.h, HalfPhase.X, HalfPhase.Q, a, b; {2}.\n"
                    "- unfold HalfPhase.G, HalfPhase.h, HalfPhase.X, HalfPhase.Q, a, b; {2}.\n",
                    k, 2 * k - 1, by_quadrature));
  }
  theory.meeting_digits = digits;
}

}  // namespace

coq_theory coq_theory_of(const rational& a, const rational& b, long digits) {
  const body rigid(a, b);
  coq_theory result;
  result.text = fmt::format(
      "(** The body with these parameters: a = I_y/I_z - 1, b = 1 - I_y/I_x. Made by\n"
      "      polhode certify --coq --ab {},{} --digits {}\n"
      "    and proved by the theories of proofs/coq: scripts/check-coq --theory FILE *)\n"
      "Require Import Reals Lra.\n"
      "From Coquelicot Require Import Coquelicot.\n"
      "From Interval Require Import Tactic.\n"
      "From Polhode Require HalfPhase.\n"
      "From Polhode Require Import Infima Curve Brackets.\n"
      "Open Scope R_scope.\n\n"
      "Definition a : R := {}.\nDefinition b : R := {}.\n\n",
      to_text(a), to_text(b), digits, real(a), real(b));
  const bool is_physical = 2 * b + a * b <= 1;
  result.text += fmt::format(
      "Theorem body_is_{0} : {1}physical_parameters a b.\n"
      "Proof. apply is_{0}; unfold a, b; lra. Qed.\n\n",
      is_physical ? "physical" : "not_physical", is_physical ? "" : "~ ");

  // 1 - sqrt(a) y is of the size of sin(e)^2.
  const bracket defect =
      bracket_of(separatrix_defect_to_digits(rigid, digits + 3), digits, "epsilon0");
  const auto bits =
      static_cast<long>(log2_of_10 *
                        static_cast<double>(digits + 2 * std::max(0L, defect.scale - digits))) +
      80;
  result.defect_digits = digits;
  result.text += "(** The defect on the separatrix, equation (25) of the paper. *)\n";
  result.text += between(
      "epsilon0", "defect_on_separatrix a b", defect,
      fmt::format(
          "apply defect_between; unfold separatrix_phase, a, b; cbv zeta;\n"
          "  [lra | lra | split; interval with (i_prec 90) | split; interval with (i_prec 90) |\n"
          "   interval with (i_prec {0}) | interval with (i_prec {0})].\n",
          bits));

  if (!has_perfect_twist(rigid)) {
    result.text +=
        "(** There is no perfect twist. *)\n"
        "Theorem no_c0 : forall c, ~ perfect_twist a b c.\n"
        "Proof. apply no_twist; unfold a, b; lra. Qed.\n\n";
  } else {
    result.twist_digits = std::min(digits, most_quadrature_digits);
    const bracket twist = bracket_of(perfect_twist_to_digits(rigid, result.twist_digits + 3),
                                     result.twist_digits, "c0");
    result.text += "(** The perfect twist, proposition 3. *)\n";
    result.text += between("c0", "perfect_twist a b", twist,
                           fmt::format("apply twist_between; unfold rotating_phase, a, b;\n"
                                       "  [lra | lra | lra | lra |\n   {0} |\n   {0}].\n",
                                       by_quadrature));
  }
  add_meetings(result, rigid, std::min(digits, most_quadrature_digits));
  return result;
}

}  // namespace polhode::cli
