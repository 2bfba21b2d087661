#pragma once

// What several claims rest on: each has a name here, and its sentence stands once.

#include <array>
#include <initializer_list>
#include <span>
#include <vector>

#include "statements/claim_text.hpp"

namespace polhode::statements {

// Steps about polynomials --------------------------------------------------------------------

inline constexpr polynomial_step integrand_is_positive =
    positive("1-b*x", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
             "1 - bX > 0 for 0 <= X <= 1: the integrand is positive");
inline constexpr polynomial_step integrand_decreases_in_c =
    slope("(1-b*x)^2", "(a+b*x)*(c+b*x)", "c", "-(1-b*x)^2*(a+b*x)",
          "the derivative in c of the square of the integrand, negative");
inline constexpr polynomial_step integrand_decreases_in_a =
    slope("(1-b*x)^2", "(a+b*x)*(c+b*x)", "a", "-(1-b*x)^2*(c+b*x)",
          "the derivative in a of the square of the integrand, negative");

/// G(u) = F(-bu,u) decreases in u, and lies between its bounds.
inline constexpr std::array half_phase_steps{
    identity("(1-(u+(1-u)*k)) * ((u+(1-u)*k)-u)", "(1-u)^2*k*(1-k)",
             "x = u + (1-u) k with k = cos^2(t/2) turns F(-bu,u) into b^(-1/2) times the integral "
             "over (0, pi) of g(x) dt, g(x) = (1-bx)/sqrt(x(a+bx))"),
    slope("(1-b*x)^2", "x*(a+b*x)", "x", "-(1-b*x)*(a+(a+2)*b*x)", "the derivative of g^2"),
    positive("1-b*x", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0", "1 - bx > 0 for 0 < x <= 1"),
    positive("a+(a+2)*b*x", "a + a*b*x + 2*b*x", "a > 0, b > 0, x > 0",
             "so g decreases strictly on 0 < x <= 1"),
    identity("(v+(1-v)*k) - (u+(1-u)*k)", "(v-u)*(1-k)",
             "x is greater for v > u where 0 < t < pi, so G decreases"),
    not_negative("(a+b)-(a+b*x)", "b*y", "b > 0, y = 1-x >= 0",
                 "a + bx <= a + b: g(x) >= (1-b)/sqrt((a+b) x)"),
    not_negative("(u+k)-(u+(1-u)*k)", "u*k", "u > 0, k >= 0",
                 "x <= u + k: G(u) >= 2 I arsinh(pi/(2 sqrt(u)))")};

/// F(c,0) decreases in c, and lies between its bounds.
inline constexpr std::array rotating_phase_steps{
    slope("(1-b*x)^2", "(a+b*x)*(c+b*x)", "c", "-(1-b*x)^2*(a+b*x)",
          "the derivative in c of the square of the integrand"),
    positive("1-b*x", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
             "1 - bX > 0 for 0 <= X <= 1: the integrand is positive and decreases in c"),
    positive("(a+b*x)-(c+b*x)", "d", "d = a-c > 0", "(a+bX)/(c+bX) > 1 for c < a"),
    not_negative("a*(c+b*x)-c*(a+b*x)", "b*x*d", "b > 0, x >= 0, d = a-c > 0",
                 "(a+bX)/(c+bX) <= a/c for c < a"),
    identity("1-b*x", "(1+a)-(a+b*x)", "(1-bX)/(a+bX) = (1+a)/(a+bX) - 1"),
    identity(
        "a*(1+t^2)+b", "(a+b)+a*t^2",
        "with T = tan psi, X = 1/(1+T^2), k^2 = a/(a+b): the derivative of "
        "arctan(kT)/sqrt(a(a+b)), (1+T^2)/((a+b)(1+k^2 T^2)), is 1/(a+bX), so the limit is pi J"),
    not_negative("(a+b)-(a+b*x)", "b*y", "b > 0, y = 1-x >= 0",
                 "a + bX <= a + b: F(c,0) >= 2 I arsinh((pi/2) sqrt(b/c)), unbounded as c -> 0")};

/// Shared steps, and then those of one claim.
[[nodiscard]] inline std::vector<polynomial_step> with_more(
    std::span<const polynomial_step> shared, std::initializer_list<polynomial_step> more = {}) {
  std::vector<polynomial_step> all(shared.begin(), shared.end());
  all.insert(all.end(), more);
  return all;
}

// What neither prover nor checker decides -------------------------------------------------------

inline constexpr stated_text intermediate_values = cited("The intermediate value theorem.");
inline constexpr stated_text psi_is_odd = in_coq("Symmetry.psi_odd");
inline constexpr stated_text half_phase_symmetry = in_coq("Symmetry.half_phase_symmetry");
inline constexpr stated_text bartky_transformation =
    cited("Bartky's transformation of complete elliptic integrals (DLMF 19.8(i), 19.22(i)).");
inline constexpr stated_text gauss_mean =
    cited("K and E by the arithmetic-geometric mean (Gauss; DLMF 19.8(i)).");
inline constexpr stated_text gudermannian =
    cited("am(x | 1) is the Gudermannian, 2 arctan(e^x) - pi/2 (DLMF 22.16(i)).");

// Of the given body ---------------------------------------------------------------------------
/// The inputs of a body with irrational a and b: the entries of its inertia tensor.
inline constexpr std::array<const char*, 6> entries_of_tensor{"xx", "yy", "zz", "xy", "xz", "yz"};

// Sentences of facts, with {} for what is computed: `fill`. Those of one claim are in its header.

inline constexpr const char* exact_constant = "at the given a, b: {} = {} exactly";
inline constexpr const char* half_phase_passes =
    "at the given a, b, by the AGM: G(u) passes {} between u = {}";
inline constexpr const char* half_phase_stays_above =
    "at the given a, b, exactly: I >= {}; by the AGM G(1/2) > {}";
inline constexpr const char* printed_and_right =
    "{} prints {} for {}, which is {}: right to the last digit printed";
inline constexpr const char* printed_and_wrong = "{} prints {} for {}, which is {}: wrong";
inline constexpr const char* periodic_rule = "periodic trapezoid, 2n nodes (2k+1) pi/(2n)";

/// What the method adds where a prover did not find a witness, and the witnesses.
inline constexpr const char* missing_witness =
    " (For the given body {} was not found at the precisions tried. The proof does not need it.)";
inline constexpr const char* bracket_of_c0 = "a bracket of c0";
inline constexpr const char* bracket_of_half_phase = "a bracket of G(u) = {}";
inline constexpr const char* enclosure_of = "an enclosure of {}";
/// What the method adds where J >= 2.
inline constexpr const char* there_is_no_c0 = " (At the given a, b J >= 2: there is no c0.)";

}  // namespace polhode::statements
