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
constexpr int most_meetings = 3;  // that are enclosed
/// Coq has the number of meetings as a unary number.
constexpr int most_counted = 100;

/// An open interval with ends of so many significant digits that has the number inside.
struct bracket {
  integer lower;
  integer upper;
  long scale = 0;  // of 10: the ends are lower/10^scale and upper/10^scale

  [[nodiscard]] integer unit() const { return pow(integer(10), static_cast<unsigned>(scale)); }
};

/// With 0 < lower and upper < limit, which is above the number; then perhaps of more digits.
bracket bracket_of(const certain_number& found, long digits, const rational& limit,
                   const char* name) {
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
  const rational lower = lower_rational(found.enclosure);
  const rational upper = upper_rational(found.enclosure);
  if (lower <= 0 || upper >= limit) {
    throw not_certified_error(
        fmt::format("--coq: {} is so near the end of its range that {} digits do not tell them "
                    "apart; give more --digits",
                    name, digits));
  }
  for (;; ++result.scale) {
    const rational unit(result.unit());
    result.lower = ceil_of(rational(lower * unit)) - 1;
    result.upper = floor_of(rational(upper * unit)) + 1;
    if (result.lower > 0 && rational(result.upper) < limit * unit) return result;
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

// ---------------------------------------------------------------------------------------------
// The tests of proofs/coq/ThirdKindBounds.v in the same integers. What they answer here only says
// which scale and how many steps Coq needs to answer the same.

enum class side { above, below };

/// T(x/S, y/S; A, B, C, D) of proofs/coq/ThirdKind.v.
struct third_kind_integral {
  integer x, y;
  integer a, b, c, d;
};

integer floor_quotient(const integer& n, const integer& d) { return n / d; }  // of positive ones
integer ceiling_quotient(const integer& n, const integer& d) { return (n + d - 1) / d; }
integer floor_root(const integer& n) { return sqrt(n); }
integer ceiling_root(const integer& n) {
  const integer root = sqrt(n);
  return root * root == n ? root : integer(root + 1);
}

/// A step of the mean, rounded so that the integral decreases (above) or increases (below).
third_kind_integral next(const third_kind_integral& t, side which) {
  const bool up = which == side::above;
  const auto greater = up ? ceiling_quotient : floor_quotient;  // of x, y, c, d
  const auto lesser = up ? floor_quotient : ceiling_quotient;   // of a, b
  const integer sum = t.x + t.y;
  const integer denominator = t.c * t.y + t.d * t.x;
  const integer product = t.x * t.y;
  return {greater(sum, 2),
          up ? ceiling_root(product) : floor_root(product),
          lesser((t.a * t.d + t.b * t.c) * sum, 2 * denominator),
          lesser(t.a * t.y + t.b * t.x, sum),
          greater(t.c * t.d * sum, denominator),
          greater(denominator, sum)};
}

/// Whether so many steps show that the integral is above, or below, pi/m.
bool is_shown(third_kind_integral t, const integer& scale, const integer& m, int steps,
              side which) {
  for (;; --steps) {
    if (t.x <= 0 || t.y <= 0 || t.c <= 0 || t.d <= 0) return false;
    if (steps == 0) break;
    t = next(t, which);
  }
  const integer z = which == side::above ? std::max(t.x, t.y) : std::min(t.x, t.y);
  const auto is_on_side = [&](const integer& value, const integer& weight) {
    const integer left = m * scale * value;
    const integer right = 2 * z * weight;
    return which == side::above ? left > right : left < right;
  };
  return is_on_side(t.a, t.c) && is_on_side(t.b, t.d);
}

/// The integral whose x and y are the roots of two rationals z/N^2 and w/N^2 that the tests of
/// proofs/coq/paper/BracketTests.v start with.
struct test_start {
  integer n, z, w;
  integer a, b, c, d;
};

/// rotating_phase a b c = 2 T, with na/N for a, and so on.
test_start start_of_twist(const integer& n, const integer& a, const integer& b, const integer& c) {
  return {n, c * (a + b), a * (c + b), (n - b) * c, n * (c + b), n * c, n * (c + b)};
}
/// G a b u = 2 T.
test_start start_of_meeting(const integer& n, const integer& a, const integer& b,
                            const integer& u) {
  const integer at_u = n * a + b * u;
  return {n * n,          n * (b * ((a + b) * u)), n * (b * at_u), (n * n - b * u) * (a + b),
          (n - b) * at_u, n * n * (a + b),         n * at_u};
}

/// The power of 2 and the number of steps with which Coq's test answers that T is above, or below,
/// pi/m.
struct test_effort {
  long bits = 0;
  int steps = 0;
};

test_effort effort_for(const test_start& start, const integer& m, side which, long first_bits) {
  constexpr int most_doublings = 8;
  const bool up = which == side::above;
  const auto greater = up ? ceiling_quotient : floor_quotient;
  const auto lesser = up ? floor_quotient : ceiling_quotient;
  for (int doublings = 0; doublings <= most_doublings; ++doublings) {
    const long bits = first_bits << doublings;
    const integer s = integer(1) << static_cast<unsigned>(bits);
    const auto root = [&](const integer& q) {
      const integer square = greater(s * s * q, start.n * start.n);
      return up ? ceiling_root(square) : floor_root(square);
    };
    const third_kind_integral first{root(start.z),
                                    root(start.w),
                                    lesser(s * start.a, start.c),
                                    lesser(s * start.b, start.c),
                                    s,
                                    greater(s * start.d, start.c)};
    if (first.x == 0 || first.y == 0) continue;
    // Quadratic, once x and y are of one size; half the difference of their logarithms a step.
    const long distance =
        std::labs(static_cast<long>(msb(first.x)) - static_cast<long>(msb(first.y)));
    const int steps = 5 + static_cast<int>(std::log2(static_cast<double>(bits + distance)));
    if (is_shown(first, s, m, steps, which)) return {bits, steps};
  }
  throw not_certified_error(
      "--coq: the digits could not be shown by integers; give fewer --digits");
}

/// a, b and a third number with a common denominator.
class common_denominator {
 public:
  common_denominator(const rational& a, const rational& b, const integer& unit)
      : n_(lcm(lcm(denominator(a), denominator(b)), unit)), a_(over(a)), b_(over(b)), unit_(unit) {}

  [[nodiscard]] const integer& n() const { return n_; }
  [[nodiscard]] const integer& a() const { return a_; }
  [[nodiscard]] const integer& b() const { return b_; }
  /// k/unit.
  [[nodiscard]] integer over_unit(const integer& k) const { return k * (n_ / unit_); }

 private:
  [[nodiscard]] integer over(const rational& q) const {
    return numerator(q) * (n_ / denominator(q));
  }

  integer n_, a_, b_, unit_;
};

/// Coq's proof that T is above pi/m at the lower end and below at the upper, by the theorems
/// <kind>_is_above and <kind>_is_below of BracketTests.v. Their last argument is m, where they have
/// it.
template <class Start>
std::string by_integers(const std::string& kind, const rational& a, const rational& b,
                        const bracket& inside, const integer& m, const std::string& last_argument,
                        const Start& start) {
  const common_denominator ab(a, b, inside.unit());
  const long first_bits = 64 + static_cast<long>(msb(inside.unit()));
  const auto at_end = [&](const integer& end, side which) {
    const integer at = ab.over_unit(end);
    const test_effort effort = effort_for(start(ab.n(), ab.a(), ab.b(), at), m, which, first_bits);
    return fmt::format(
        "- apply ({}_is_{} {} (2^{}) {} {} {} {}{});\n"
        "    [unfold a; lra | unfold b; lra | lra | vm_compute; reflexivity].\n",
        kind, which == side::above ? "above" : "below", effort.steps, effort.bits, ab.n().str(),
        ab.a().str(), ab.b().str(), at.str(), last_argument);
  };
  return at_end(inside.lower, side::above) + at_end(inside.upper, side::below);
}

/// How often C meets S, and where first.
void add_meetings(coq_theory& theory, const body& rigid, const rational& a, const rational& b,
                  long digits) {
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
    const bracket inside = bracket_of(u, digits, 1, name.c_str());
    theory.text +=
        between(name.c_str(), fmt::format("meeting_at a b {}", k).c_str(), inside,
                fmt::format("apply (meeting_between a b {0} {1}); try (unfold a, b; lra).\n"
                            "- auto with arith.\n"
                            "- rewrite INR_IZR_INZ; simpl; lra.\n{2}",
                            k, 2 * k - 1,
                            by_integers("meeting", a, b, inside, 2 * k - 1,
                                        fmt::format(" {}", 2 * k - 1), start_of_meeting)));
  }
  theory.meeting_digits = digits;
}

}  // namespace

coq_theory coq_theory_of(const body& rigid, long digits) {
  const rational a = *rigid.a().as_rational();
  const rational b = *rigid.b().as_rational();
  coq_theory result;
  result.text = fmt::format(
      "(** The body with these parameters: a = I_y/I_z - 1, b = 1 - I_y/I_x. Made by\n"
      "      polhode certify --coq --ab {},{} --digits {}\n"
      "    and proved by the theories of proofs/coq: scripts/check-coq --theory FILE *)\n"
      "Require Import Reals Lra.\n"
      "From Coquelicot Require Import Coquelicot.\n"
      "From Interval Require Import Tactic.\n"
      "From Polhode Require HalfPhase.\n"
      "From Polhode Require Import Infima Curve Brackets BracketTests.\n"
      "Open Scope R_scope.\n\n"
      "Definition a : R := {}.\nDefinition b : R := {}.\n\n",
      to_text(a), to_text(b), digits, real(a), real(b));
  if (rigid.moments()) {
    const auto& [x, y, z] = *rigid.moments();
    result.text += fmt::format(
        "Definition Ix : R := {}.\nDefinition Iy : R := {}.\nDefinition Iz : R := {}.\n\n"
        "Theorem parameters_of_the_moments : a = Iy / Iz - 1 /\\ b = 1 - Iy / Ix.\n"
        "Proof. unfold a, b, Ix, Iy, Iz. lra. Qed.\n\n",
        real(x), real(y), real(z));
  }
  const bool is_physical = 2 * b + a * b <= 1;
  result.text += fmt::format(
      "Theorem body_is_{0} : {1}physical_parameters a b.\n"
      "Proof. apply is_{0}; unfold a, b; lra. Qed.\n\n",
      is_physical ? "physical" : "not_physical", is_physical ? "" : "~ ");

  // 1 - sqrt(a) y is of the size of sin(e)^2.
  const rational below_half_pi(integer(157079632679489661), integer("100000000000000000"));
  const bracket defect =
      bracket_of(separatrix_defect_to_digits(rigid, digits + 3), digits, below_half_pi, "epsilon0");
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
    result.twist_digits = digits;
    const bracket twist = bracket_of(perfect_twist_to_digits(rigid, digits + 3), digits, a, "c0");
    result.text += "(** The perfect twist, proposition 3. *)\n";
    result.text += between("c0", "perfect_twist a b", twist,
                           "apply twist_between; try (unfold a, b; lra).\n" +
                               by_integers("twist", a, b, twist, 1, "", start_of_twist));
  }
  add_meetings(result, rigid, a, b, digits);
  return result;
}

}  // namespace polhode::cli
