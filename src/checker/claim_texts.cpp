#include "claim_texts.hpp"

#include <algorithm>

namespace polhode::checker {
namespace {

const std::vector<claim_text>& all_texts() {
  static const std::vector<claim_text> texts{
      {"physical",
       "proposition 1",
       "A rigid body with moments of inertia I_z < I_y < I_x is physical, I_y + I_z >= I_x, if and "
       "only if its geometric constant is I >= 1; it is planar if and only if I = 1.",
       "I_y + I_z >= I_x  <=>  I = (1-b)/sqrt(b(a+b)) >= 1  <=>  ab + 2b <= 1",
       "For all bodies: with x = I_x, y = I_y, z = I_z the square of I is yz/((x-y)(x-z)), and yz "
       "- (x-y)(x-z) = x(y+z-x); every a > 0, 0 < b < 1 is that of some moments. All steps are "
       "identities of polynomials, decided by expansion. For the given body: signs of rational "
       "numbers.",
       {{step_kind::identity, "(y-z)*x + (x-y)*z", "", "", "y*(x-z)", "",
         "a + b = y(x-z)/(xz) with a = (y-z)/z, b = (x-y)/x, so that I^2 = yz/((x-y)(x-z))"},
        {step_kind::identity, "y*z - (x-y)*(x-z)", "", "", "x*(y+z-x)", "",
         "I^2 - 1 has the sign of I_y + I_z - I_x"},
        {step_kind::identity, "(1-b)^2 - b*(a+b)", "", "", "1 - 2*b - a*b", "",
         "and that of 1 - 2b - ab"},
        {step_kind::positive, "x+z-y", "", "", "z + p", "z > 0, p = x-y > 0",
         "I_x + I_z > I_y always"},
        {step_kind::positive, "x+y-z", "", "", "x + p", "x > 0, p = y-z > 0",
         "I_x + I_y > I_z always"}},
       with_words,
       {{"argued in words",
         "With I_z < I_y < I_x all denominators are positive, and I > 0: I >= 1 exactly where I^2 "
         "- 1 >= 0, where I_y + I_z - I_x >= 0."}}},
      {"montgomery_oscillating",
       "theorem 1",
       "The Montgomery phase of oscillating motion increases in c, and its greatest lower bound is "
       "2 pi I; this is at least 2 pi if and only if the body is physical.",
       "dphi(c) = 2 G(u), u = -c/b: decreasing in u, inf = lim (u -> 1) = 2 pi I; inf >= 2 pi <=> "
       "I >= 1",
       "For all a > 0, 0 < b < 1: G(u) = b^(-1/2) times the integral of g(x) over 0 < t < pi with "
       "x = u + (1-u) cos^2(t/2); g decreases strictly in x and x increases in u, so G decreases "
       "strictly in u (the phase increases in c); u <= x <= 1 gives pi I <= G(u) <= pi I "
       "g(u)/g(1), so that pi I is the limit for u -> 1 and the greatest lower bound, which is not "
       "attained. By the claim physical it is at least pi exactly for physical bodies. Computed: "
       "the polynomial steps; the rest is monotonicity of the integral.",
       {{step_kind::identity, "(1-(u+(1-u)*k)) * ((u+(1-u)*k)-u)", "", "", "(1-u)^2*k*(1-k)", "",
         "x = u + (1-u) k with k = cos^2(t/2) turns F(-bu,u) into b^(-1/2) times the integral over "
         "(0, pi) of g(x) dt, g(x) = (1-bx)/sqrt(x(a+bx))"},
        {step_kind::slope, "(1-b*x)^2", "x*(a+b*x)", "x", "-(1-b*x)*(a+(a+2)*b*x)", "",
         "the derivative of g^2"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bx > 0 for 0 < x <= 1"},
        {step_kind::positive, "a+(a+2)*b*x", "", "", "a + a*b*x + 2*b*x", "a > 0, b > 0, x > 0",
         "so g decreases strictly on 0 < x <= 1"},
        {step_kind::identity, "(v+(1-v)*k) - (u+(1-u)*k)", "", "", "(v-u)*(1-k)", "",
         "x is greater for v > u where 0 < t < pi, so G decreases"},
        {step_kind::not_negative, "(a+b)-(a+b*x)", "", "", "b*y", "b > 0, y = 1-x >= 0",
         "a + bx <= a + b: g(x) >= (1-b)/sqrt((a+b) x)"},
        {step_kind::not_negative, "(u+k)-(u+(1-u)*k)", "", "", "u*k", "u > 0, k >= 0",
         "x <= u + k: G(u) >= 2 I arsinh(pi/(2 sqrt(u)))"}},
       with_words,
       {{"argued in words",
         "G decreases in u, as its integrand does at every t; by its two bounds G takes on (0, 1) "
         "every value above pi I, once, and no other."},
        {"argued in words",
         "As u tends to 1 both bounds tend to pi I, so that this is the greatest lower bound, and "
         "it is not attained."}}},
      {"montgomery_rotating",
       "theorem 2, eq. (17)",
       "The Montgomery phase of rotating motion decreases in c, and its greatest lower bound is 2 "
       "pi J.",
       "dphi(c) = 2 F(c,0): decreasing in c, inf = lim (c -> a) = 2 pi J",
       "For all a > 0, 0 < b < 1: the integrand decreases strictly in c; (a+bX)/(c+bX) lies "
       "between 1 and a/c, so that P < F(c,0) <= P sqrt(a/c) with P the integral at c = a, which "
       "is pi J by an antiderivative. So pi J is the limit for c -> a and the greatest lower "
       "bound, which is not attained for c < a. Computed: the polynomial steps; the rest is "
       "monotonicity of the integral.",
       {{step_kind::slope, "(1-b*x)^2", "(a+b*x)*(c+b*x)", "c", "-(1-b*x)^2*(a+b*x)", "",
         "the derivative in c of the square of the integrand"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bX > 0 for 0 <= X <= 1: the integrand is positive and decreases in c"},
        {step_kind::positive, "(a+b*x)-(c+b*x)", "", "", "d", "d = a-c > 0",
         "(a+bX)/(c+bX) > 1 for c < a"},
        {step_kind::not_negative, "a*(c+b*x)-c*(a+b*x)", "", "", "b*x*d",
         "b > 0, x >= 0, d = a-c > 0", "(a+bX)/(c+bX) <= a/c for c < a"},
        {step_kind::identity, "1-b*x", "", "", "(1+a)-(a+b*x)", "",
         "(1-bX)/(a+bX) = (1+a)/(a+bX) - 1"},
        {step_kind::identity, "a*(1+t^2)+b", "", "", "(a+b)+a*t^2", "",
         "with T = tan psi, X = 1/(1+T^2), k^2 = a/(a+b): the derivative of "
         "arctan(kT)/sqrt(a(a+b)), (1+T^2)/((a+b)(1+k^2 T^2)), is 1/(a+bX), so the limit is pi J"},
        {step_kind::not_negative, "(a+b)-(a+b*x)", "", "", "b*y", "b > 0, y = 1-x >= 0",
         "a + bX <= a + b: F(c,0) >= 2 I arsinh((pi/2) sqrt(b/c)), unbounded as c -> 0"}},
       with_words,
       {{"argued in words",
         "An integral over a fixed range decreases in a quantity where its integrand does at every "
         "point of the range."},
        {"argued in words",
         "As c tends to a both bounds tend to P, which is pi J by the antiderivative: this is the "
         "greatest lower bound, and it is not attained."}}},
      {"first_equation",
       "proposition 2, eqs. (21)-(24)",
       "The twist defect given by the first implicit equation decreases strictly in c, and so is "
       "injective there.",
       "integral over (0, pi/2 - epsilon) of (1-bX)/sqrt((a+bX)(c+bX)) dpsi = pi, X = cos^2 psi: "
       "epsilon decreases in c",
       "For all a > 0, 0 < b < 1: the integrand is positive and decreases strictly in c, so the "
       "integral increases strictly in its upper end and decreases strictly in c; where it is pi "
       "for c and for c' > c, the upper end for c' is the greater one. Computed: the polynomial "
       "steps.",
       {{step_kind::slope, "(1-b*x)^2", "(a+b*x)*(c+b*x)", "c", "-(1-b*x)^2*(a+b*x)", "",
         "the derivative in c of the square of the integrand, negative"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bX > 0 for 0 <= X <= 1: the integrand is positive"}},
       with_words,
       {{"argued in words",
         "The integral increases in its upper end, as its integrand is positive, and decreases in "
         "c, as its integrand does: where c is greater the upper end at which it is pi is "
         "greater."},
        {"argued in words",
         "Eq. (24): h_c = -(1-bX)/(2 sqrt(a+bX) (c+bX)^(3/2)) for the integrand h, by the "
         "derivative of h^2; differentiation under the integral, which has no singularity before "
         "the turning point, and the implicit function theorem give d epsilon/dc = -(integral of "
         "|h_c|)/h(pi/2 - epsilon) < 0."}}},
      {"separatrix_twist",
       "proposition 3, part 1, eq. (25)",
       "The tennis racket effect always occurs on the separatrix: F(0,u) = 2 pi has exactly one "
       "solution u = sin^2 epsilon0 in (0, 1), for every body.",
       "F(0, sin^2 epsilon0) = 2 pi has exactly one solution, 0 < epsilon0 < pi/2",
       "For all a > 0, 0 < b < 1: F(0,u) decreases strictly in u, its integrand being positive; it "
       "is at least I log(1/u), and by its closed form, whose derivative is an identity of "
       "polynomials, it tends to 0 as u tends to 1. So it is 2 pi exactly once. The number: "
       "interval Newton on y/sqrt(ab) - arctan(sqrt(b/a) tanh y) = pi, tan epsilon0 = "
       "sqrt(a/(a+b))/sinh y.",
       {{step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bx > 0: the integrand is positive, F(0,u) decreases in u"},
        {step_kind::not_negative, "(a+b)-(a+b*x)", "", "", "b*y", "b > 0, y = 1-x >= 0",
         "a + bx <= a + b: the integrand is at least I/x, F(0,u) >= I log(1/u)"},
        {step_kind::slope, "1-x", "a+b*x", "x", "-(a+b)", "",
         "the derivative of w^2 = (1-x)/(a+bx)"},
        {step_kind::identity, "(a+b*x) - a*(1-x)", "", "", "(a+b)*x", "",
         "1 - a w^2 = (a+b)x/(a+bx)"},
        {step_kind::identity, "(a+b*x) + b*(1-x)", "", "", "a+b", "",
         "1 + b w^2 = (a+b)/(a+bx), so that F(0,u) = 2 artanh(sqrt(a) w)/sqrt(ab) - 2 "
         "arctan(sqrt(b) w), which tends to 0 as u -> 1"}},
       with_words,
       {{"argued in words",
         "F(0,u) decreases in u, as its integrand is positive and its range shrinks; it has no "
         "bound as u tends to 0 and tends to 0 as u tends to 1, by its bound and its closed form."},
        {"cited", "The intermediate value theorem."}}},
      {"perfect_twist",
       "proposition 3, part 2",
       "A perfect twist, epsilon = 0, occurs if and only if J < 2, at exactly one c0, which lies "
       "in (0, a).",
       "F(c0,0) = 2 pi for some c0  <=>  J < 2; then c0 is in (0, a) and the only one",
       "For all a > 0, 0 < b < 1, by the proof of montgomery_rotating: F(c,0) maps 0 < c < a one "
       "to one onto the values above pi J, and F(c,u) is defined at u = 0 for c > 0 only. So 2 pi "
       "is a value exactly where J < 2 (and the phase 2 F(c,0) has the value 2 pi, a full turn, "
       "exactly where J < 1). For a given body J < 2 is decided in rationals.",
       {{step_kind::slope, "(1-b*x)^2", "(a+b*x)*(c+b*x)", "c", "-(1-b*x)^2*(a+b*x)", "",
         "the derivative in c of the square of the integrand"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bX > 0 for 0 <= X <= 1: the integrand is positive and decreases in c"},
        {step_kind::positive, "(a+b*x)-(c+b*x)", "", "", "d", "d = a-c > 0",
         "(a+bX)/(c+bX) > 1 for c < a"},
        {step_kind::not_negative, "a*(c+b*x)-c*(a+b*x)", "", "", "b*x*d",
         "b > 0, x >= 0, d = a-c > 0", "(a+bX)/(c+bX) <= a/c for c < a"},
        {step_kind::identity, "1-b*x", "", "", "(1+a)-(a+b*x)", "",
         "(1-bX)/(a+bX) = (1+a)/(a+bX) - 1"},
        {step_kind::identity, "a*(1+t^2)+b", "", "", "(a+b)+a*t^2", "",
         "with T = tan psi, X = 1/(1+T^2), k^2 = a/(a+b): the derivative of "
         "arctan(kT)/sqrt(a(a+b)), (1+T^2)/((a+b)(1+k^2 T^2)), is 1/(a+bX), so the limit is pi J"},
        {step_kind::not_negative, "(a+b)-(a+b*x)", "", "", "b*y", "b > 0, y = 1-x >= 0",
         "a + bX <= a + b: F(c,0) >= 2 I arsinh((pi/2) sqrt(b/c)), unbounded as c -> 0"},
        {step_kind::identity, "9*a*(a+b) - (a+1)^2", "", "", "8*a^2 + 9*a*b - 2*a - 1", "",
         "J < 2 exactly where this is positive, as (J+1)^2 = (a+1)^2/(a(a+b))"},
        {step_kind::identity, "4*a*(a+b) - (a+1)^2", "", "", "3*a^2 + 4*a*b - 2*a - 1", "",
         "J < 1 exactly where this is positive"}},
       with_words,
       {{"argued in words",
         "An integral over a fixed range decreases in a quantity where its integrand does at every "
         "point of the range."},
        {"argued in words",
         "By its two bounds F(c,0) takes on (0, a) every value above pi J, and no other."},
        {"cited", "The intermediate value theorem."}}},
      {"intersection",
       "lemma 2 and its remark",
       "The part of C given by the first implicit equation meets S in exactly one point with u in "
       "(0, 1) if I < 2 and in none otherwise; at I = 2 the point is the limit u = 1.",
       "F(-bu,u) = 2 pi for some u in (0, 1)  <=>  I < 2; then u is the only one (u = 1 <=> I = 2)",
       "For all a > 0, 0 < b < 1: G(u) = F(-bu,u) maps (0, 1) one to one onto the values above pi "
       "I, decreasing, and tends to pi I at u = 1 (the steps are those of montgomery_oscillating). "
       "With u = 1 allowed, where F(-b,1) means this limit, the condition is the paper's I <= 2; u "
       "= 1 is the equilibrium c = -b, no motion. For a given body I < 2 is decided in rationals.",
       {{step_kind::identity, "(1-(u+(1-u)*k)) * ((u+(1-u)*k)-u)", "", "", "(1-u)^2*k*(1-k)", "",
         "x = u + (1-u) k with k = cos^2(t/2) turns F(-bu,u) into b^(-1/2) times the integral over "
         "(0, pi) of g(x) dt, g(x) = (1-bx)/sqrt(x(a+bx))"},
        {step_kind::slope, "(1-b*x)^2", "x*(a+b*x)", "x", "-(1-b*x)*(a+(a+2)*b*x)", "",
         "the derivative of g^2"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bx > 0 for 0 < x <= 1"},
        {step_kind::positive, "a+(a+2)*b*x", "", "", "a + a*b*x + 2*b*x", "a > 0, b > 0, x > 0",
         "so g decreases strictly on 0 < x <= 1"},
        {step_kind::identity, "(v+(1-v)*k) - (u+(1-u)*k)", "", "", "(v-u)*(1-k)", "",
         "x is greater for v > u where 0 < t < pi, so G decreases"},
        {step_kind::not_negative, "(a+b)-(a+b*x)", "", "", "b*y", "b > 0, y = 1-x >= 0",
         "a + bx <= a + b: g(x) >= (1-b)/sqrt((a+b) x)"},
        {step_kind::not_negative, "(u+k)-(u+(1-u)*k)", "", "", "u*k", "u > 0, k >= 0",
         "x <= u + k: G(u) >= 2 I arsinh(pi/(2 sqrt(u)))"},
        {step_kind::identity, "4*b*(a+b) - (1-b)^2", "", "", "4*a*b + 3*b^2 + 2*b - 1", "",
         "I < 2 exactly where this is positive"}},
       with_words,
       {{"argued in words",
         "G decreases in u, as its integrand does at every t; by its two bounds G takes on (0, 1) "
         "every value above pi I, once, and no other."},
        {"argued in words",
         "On the part of C of the first implicit equation C meets S where pi is the time from psi "
         "= 0 to the turning point, G = 2 pi."},
        {"cited", "The intermediate value theorem."}}},
      {"crossing",
       "lemma 3",
       "epsilon(c) takes the value pi/2 in (-b, 0) if and only if I < 1, that is, if the body is "
       "not physical: exactly ceil(1/I) - 1 times.",
       "epsilon(c*) = pi/2 for some c* in (-b, 0)  <=>  I < 1; it has ceil(1/I) - 1 such solutions",
       "For all a > 0, 0 < b < 1: by the symmetries of the reduced system psi_c(phi + G) = "
       "-psi_c(phi), and psi_c(pi) = 0 exactly where pi = k G(u) for a whole k >= 1; G maps (0, 1) "
       "one to one onto the values above pi I, so that there is one solution for every k < 1/I. "
       "The first, G = pi, lies beyond the first intersection, G = 2 pi. Computed: the polynomial "
       "steps for G, and the count in rationals. Cited: uniqueness of solutions (Picard and "
       "Lindeloef).",
       {{step_kind::identity, "(1-(u+(1-u)*k)) * ((u+(1-u)*k)-u)", "", "", "(1-u)^2*k*(1-k)", "",
         "x = u + (1-u) k with k = cos^2(t/2) turns F(-bu,u) into b^(-1/2) times the integral over "
         "(0, pi) of g(x) dt, g(x) = (1-bx)/sqrt(x(a+bx))"},
        {step_kind::slope, "(1-b*x)^2", "x*(a+b*x)", "x", "-(1-b*x)*(a+(a+2)*b*x)", "",
         "the derivative of g^2"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bx > 0 for 0 < x <= 1"},
        {step_kind::positive, "a+(a+2)*b*x", "", "", "a + a*b*x + 2*b*x", "a > 0, b > 0, x > 0",
         "so g decreases strictly on 0 < x <= 1"},
        {step_kind::identity, "(v+(1-v)*k) - (u+(1-u)*k)", "", "", "(v-u)*(1-k)", "",
         "x is greater for v > u where 0 < t < pi, so G decreases"},
        {step_kind::not_negative, "(a+b)-(a+b*x)", "", "", "b*y", "b > 0, y = 1-x >= 0",
         "a + bx <= a + b: g(x) >= (1-b)/sqrt((a+b) x)"},
        {step_kind::not_negative, "(u+k)-(u+(1-u)*k)", "", "", "u*k", "u > 0, k >= 0",
         "x <= u + k: G(u) >= 2 I arsinh(pi/(2 sqrt(u)))"}},
       with_words,
       {{"argued in words",
         "G decreases in u, as its integrand does at every t; by its two bounds G takes on (0, 1) "
         "every value above pi I, once, and no other."},
        {"argued in words",
         "The reduced system is the same under (psi, phi) -> (-psi, -phi) and under (cos theta, "
         "phi) -> (-cos theta, -phi); so psi_c is odd and psi_c(phi + G) = -psi_c(phi)."},
        {"argued in words", "psi_c(pi) = 0 exactly where pi = k G for a whole k >= 1."},
        {"cited", "The intermediate value theorem."},
        {"cited",
         "Solutions of ordinary differential equations exist, are unique (Picard and Lindeloef) "
         "and depend continuously on their data."}}},
      {"injectivity",
       "theorem 3, proposition 4",
       "The twist defect epsilon(c) is an injective function of c if and only if I >= 1, that is, "
       "if and only if the body is physical.",
       "c -> epsilon(c) is injective on (-b, a)  <=>  I >= 1  <=>  the body is physical",
       "For all a > 0, 0 < b < 1. I >= 1: G > pi, so that pi is reached before the first turning "
       "point, where epsilon decreases by first_equation, or between it and the return to psi = 0, "
       "where T(c, psi_c(pi)) = G - pi; as c decreases G decreases and T increases for every psi, "
       "so psi_c(pi) decreases: epsilon decreases strictly throughout. I < 1: epsilon is pi/2 at "
       "c* by the claim crossing and tends to pi/2 as c -> -b; a continuous injective function "
       "would have different limits. Computed: the polynomial steps, I against 1 in rationals, and "
       "enclosures for the given body. Cited: existence, uniqueness and continuous dependence of "
       "solutions of ordinary differential equations (Picard and Lindeloef); the intermediate "
       "value theorem.",
       {{step_kind::identity, "(1-(u+(1-u)*k)) * ((u+(1-u)*k)-u)", "", "", "(1-u)^2*k*(1-k)", "",
         "x = u + (1-u) k with k = cos^2(t/2) turns F(-bu,u) into b^(-1/2) times the integral over "
         "(0, pi) of g(x) dt, g(x) = (1-bx)/sqrt(x(a+bx))"},
        {step_kind::slope, "(1-b*x)^2", "x*(a+b*x)", "x", "-(1-b*x)*(a+(a+2)*b*x)", "",
         "the derivative of g^2"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bx > 0 for 0 < x <= 1"},
        {step_kind::positive, "a+(a+2)*b*x", "", "", "a + a*b*x + 2*b*x", "a > 0, b > 0, x > 0",
         "so g decreases strictly on 0 < x <= 1"},
        {step_kind::identity, "(v+(1-v)*k) - (u+(1-u)*k)", "", "", "(v-u)*(1-k)", "",
         "x is greater for v > u where 0 < t < pi, so G decreases"},
        {step_kind::not_negative, "(a+b)-(a+b*x)", "", "", "b*y", "b > 0, y = 1-x >= 0",
         "a + bx <= a + b: g(x) >= (1-b)/sqrt((a+b) x)"},
        {step_kind::not_negative, "(u+k)-(u+(1-u)*k)", "", "", "u*k", "u > 0, k >= 0",
         "x <= u + k: G(u) >= 2 I arsinh(pi/(2 sqrt(u)))"},
        {step_kind::slope, "(1-b*x)^2", "(a+b*x)*(c+b*x)", "c", "-(1-b*x)^2*(a+b*x)", "",
         "the derivative in c of the square of T's integrand, negative"}},
       with_words,
       {{"argued in words",
         "G decreases in u, as its integrand does at every t; by its two bounds G takes on (0, 1) "
         "every value above pi I, once, and no other."},
        {"argued in words",
         "The reduced system is the same under (psi, phi) -> (-psi, -phi) and under (cos theta, "
         "phi) -> (-cos theta, -phi); so psi_c is odd and psi_c(phi + G) = -psi_c(phi)."},
        {"argued in words",
         "Where I >= 1, pi is at most G, and as c decreases G decreases and the time T to every "
         "psi increases: psi_c(pi) decreases, before the turning point and after it."},
        {"argued in words",
         "Where I < 1, epsilon is pi/2 at some c and tends to pi/2 as c tends to -b: a continuous "
         "injective function would have different limits."},
        {"cited", "The intermediate value theorem."},
        {"cited",
         "Solutions of ordinary differential equations exist, are unique (Picard and Lindeloef) "
         "and depend continuously on their data."}}},
      {"count",
       "theorem 4",
       "C and S meet exactly N = ceil(1/I + 1/2) - 1 times: n + 1 times for 2/(2n+3) <= I < "
       "2/(2n+1), where the paper says at least.",
       "C meets S in exactly N = ceil(1/I + 1/2) - 1 points with -b < c < 0, G(u_k) = 2 pi/(2k-1)",
       "For all a > 0, 0 < b < 1: by the symmetries of the reduced system psi_c(pi) is a turning "
       "point, which is where C meets S, exactly where pi = (k - 1/2) G(u) for a whole k >= 1; G "
       "maps (0, 1) one to one onto the values above pi I, so that there is one for every k < 1/I "
       "+ 1/2. I < 2/(2n+1) is n + 1 < 1/I + 1/2: N >= n + 1, the paper's theorem. Computed: the "
       "polynomial steps for G, and the count in rationals. Cited: uniqueness of solutions (Picard "
       "and Lindeloef).",
       {{step_kind::identity, "(1-(u+(1-u)*k)) * ((u+(1-u)*k)-u)", "", "", "(1-u)^2*k*(1-k)", "",
         "x = u + (1-u) k with k = cos^2(t/2) turns F(-bu,u) into b^(-1/2) times the integral over "
         "(0, pi) of g(x) dt, g(x) = (1-bx)/sqrt(x(a+bx))"},
        {step_kind::slope, "(1-b*x)^2", "x*(a+b*x)", "x", "-(1-b*x)*(a+(a+2)*b*x)", "",
         "the derivative of g^2"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bx > 0 for 0 < x <= 1"},
        {step_kind::positive, "a+(a+2)*b*x", "", "", "a + a*b*x + 2*b*x", "a > 0, b > 0, x > 0",
         "so g decreases strictly on 0 < x <= 1"},
        {step_kind::identity, "(v+(1-v)*k) - (u+(1-u)*k)", "", "", "(v-u)*(1-k)", "",
         "x is greater for v > u where 0 < t < pi, so G decreases"},
        {step_kind::not_negative, "(a+b)-(a+b*x)", "", "", "b*y", "b > 0, y = 1-x >= 0",
         "a + bx <= a + b: g(x) >= (1-b)/sqrt((a+b) x)"},
        {step_kind::not_negative, "(u+k)-(u+(1-u)*k)", "", "", "u*k", "u > 0, k >= 0",
         "x <= u + k: G(u) >= 2 I arsinh(pi/(2 sqrt(u)))"},
        {step_kind::identity, "2*k - (2*k-1)", "", "", "1", "",
         "2 pi/(2k-1) > pi/k: the k-th crossing of pi/2 comes after the k-th intersection"},
        {step_kind::identity, "(2*k+1) - 2*k", "", "", "1", "",
         "pi/k > 2 pi/(2k+1): and before the next"}},
       with_words,
       {{"argued in words",
         "G decreases in u, as its integrand does at every t; by its two bounds G takes on (0, 1) "
         "every value above pi I, once, and no other."},
        {"argued in words",
         "The reduced system is the same under (psi, phi) -> (-psi, -phi) and under (cos theta, "
         "phi) -> (-cos theta, -phi); so psi_c is odd and psi_c(phi + G) = -psi_c(phi)."},
        {"argued in words",
         "psi_c(pi) is a turning point exactly where pi = (k - 1/2) G for a whole k >= 1."},
        {"cited", "The intermediate value theorem."},
        {"cited",
         "Solutions of ordinary differential equations exist, are unique (Picard and Lindeloef) "
         "and depend continuously on their data."}}},
      {"c0_decreases",
       "lemma 4",
       "The perfect twist c0(a, b) decreases as a increases.",
       "a < a'  =>  c0(a', b) < c0(a, b), where c0(a, b) exists",
       "For all a > 0, 0 < b < 1 with J < 2: the integrand of F(c,0) decreases strictly in a and "
       "in c. At c0(a) the integral for a' > a is below 2 pi, so its root c0(a') is smaller; it "
       "exists, as J decreases in a. Computed: the polynomial steps.",
       {{step_kind::slope, "(1-b*x)^2", "(a+b*x)*(c+b*x)", "a", "-(1-b*x)^2*(c+b*x)", "",
         "the derivative in a of the square of the integrand, negative"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bX > 0 for 0 <= X <= 1: the integrand is positive"},
        {step_kind::slope, "(1-b*x)^2", "(a+b*x)*(c+b*x)", "c", "-(1-b*x)^2*(a+b*x)", "",
         "the derivative in c of the square of the integrand, negative"},
        {step_kind::slope, "(a+1)^2", "a*(a+b)", "a", "-(a+1)*(a*(2-b)+b)", "",
         "the derivative in a of (J+1)^2"},
        {step_kind::positive, "a*(2-b)+b", "", "", "a + a*q + b", "a > 0, b > 0, q = 1-b > 0",
         "so J decreases in a"}},
       with_words,
       {{"argued in words",
         "An integral over a fixed range decreases in a quantity where its integrand does at every "
         "point of the range."},
        {"argued in words",
         "So at c0(a) the integral for a' > a is below 2 pi, and its root is smaller."}}},
      {"epsilon0_decreases",
       "lemma 5",
       "The twist defect on the separatrix, epsilon0(a, b), decreases as a increases.",
       "a < a'  =>  epsilon0(a', b) < epsilon0(a, b)",
       "For all a > 0, 0 < b < 1: the integrand of F(0,u) decreases strictly in a, and F(0,u) "
       "decreases in u. At epsilon0(a) the integral for a' > a is below 2 pi, so its root is "
       "smaller. Computed: the polynomial steps.",
       {{step_kind::slope, "(1-b*x)^2", "(a+b*x)*(c+b*x)", "a", "-(1-b*x)^2*(c+b*x)", "",
         "the derivative in a of the square of the integrand, negative"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bX > 0 for 0 <= X <= 1: the integrand is positive"}},
       with_words,
       {{"argued in words",
         "An integral over a fixed range decreases in a quantity where its integrand does at every "
         "point of the range."},
        {"argued in words",
         "So at epsilon0(a) the integral for a' > a is below 2 pi, and its root is smaller."}}},
      {"large_a",
       "section 7: after lemma 5, remark 2",
       "As a -> infinity for one b, epsilon0 -> 0, c0 -> 0 and the first point where C meets S "
       "tends to c = epsilon = 0; for no body is epsilon0 = 0: a perfect twist on the separatrix "
       "there is in this limit only.",
       "0 < epsilon0 < 2 arctan(e^(-pi sqrt(ab))), c0 < 1/(4a) where there is a c0, u1 < 1/(4ab) "
       "and -c1 < 1/(4a) where C meets S first",
       "For all a > 0, 0 < b < 1: 1 - bX < 1 and a + bX > a for X > 0, so that F(0,u) < 2 "
       "artanh(sqrt(1-u))/sqrt(ab), F(c,0) < pi/sqrt(ac) and G(u) < pi/sqrt(abu); each is 2 pi at "
       "epsilon0, c0 and u1. epsilon0 > 0 by the claim separatrix_twist. Computed: the polynomial "
       "steps.",
       {{step_kind::positive, "1 - (1-b*x)", "", "", "b*x", "b > 0, x > 0", "1 - bX < 1"},
        {step_kind::positive, "(a+b*x) - a", "", "", "b*x", "b > 0, x > 0", "a + bX > a"},
        {step_kind::positive, "(c+b*x) - c", "", "", "b*x", "b > 0, x > 0",
         "c + bX > c, for c > 0"},
        {step_kind::not_negative, "(u+(1-u)*k) - u", "", "", "k*v", "k >= 0, v = 1-u >= 0",
         "x = u + (1-u) k >= u in the integral G(u): g(x) < 1/sqrt(a u)"}},
       with_words,
       {{"argued in words",
         "An integral is below that of a greater integrand: that of 1/(sqrt(ab) x sqrt(1-x)) from "
         "u to 1 is 2 artanh(sqrt(1-u))/sqrt(ab), and artanh(cos epsilon) = log cot(epsilon/2)."},
        {"argued in words",
         "F(c,0) is twice the integral over 0 < psi < pi/2, and G is b^(-1/2) times that of g over "
         "0 < t < pi: bounds of their integrands give those of the integrals."},
        {"argued in words",
         "F(0,u) is 2 pi at one u in (0, 1), never at u = 0 (claim separatrix_twist): epsilon0 > "
         "0."}}},
      {"limit_formula",
       "eqs. (33)-(38)",
       "As a -> infinity, b -> 0 with ab -> chi > 0 and c/b = beta > -1, epsilon tends to pi/2 - "
       "am(pi sqrt(chi(1+beta)) | 1/(1+beta)), where for beta < 0 the amplitude is the psi with "
       "sin psi = sqrt(1+beta) sn(pi sqrt(chi) | 1+beta), |psi| < pi/2, before the first turning "
       "point and beyond it.",
       "sin psi_c(pi) = sqrt(1+beta) sn(xi | 1+beta) for -1 < beta < 0, psi_c(pi) = "
       "am(sqrt(1+beta) xi | 1/(1+beta)) for beta >= 0, with pi sqrt(ab) <= xi <= pi sqrt(ab) "
       "sqrt((a+b)/a)/(1-b), c = b beta; epsilon = pi/2 - psi_c(pi)",
       "For all a > 0, 0 < b < 1, beta > -1: sqrt(ab) times the integrand is v (beta + cos^2 "
       "psi)^(-1/2) with (1-b) sqrt(a/(a+b)) <= v <= 1, so that xi, which grows by (beta + cos^2 "
       "psi)^(-1/2) |dpsi| along the motion, lies at phi = pi between the bounds; they have the "
       "limit pi sqrt(chi). In xi the motion is that of the limit: an elliptic function of xi. "
       "Computed: the polynomial steps.",
       {{step_kind::not_negative, "(a+b*x) - a*(1-b*x)^2", "", "", "b*x + a*b*x*(1+q+b*y)",
         "a > 0, b > 0, x >= 0, q = 1-b > 0, y = 1-x >= 0", "v^2 = a(1-bX)^2/(a+bX) <= 1"},
        {step_kind::not_negative, "(1-b*x) - (1-b)", "", "", "b*y", "b > 0, y = 1-x >= 0",
         "1 - bX >= 1 - b"},
        {step_kind::not_negative, "(a+b) - (a+b*x)", "", "", "b*y", "b > 0, y = 1-x >= 0",
         "a + bX <= a + b, so that v^2 >= a(1-b)^2/(a+b)"},
        {step_kind::identity, "d + (1-s)", "", "", "(1+d) - s", "",
         "beta + cos^2 = (1+beta)(1 - sin^2/(1+beta)): the limit form is F(psi | "
         "1/(1+beta))/sqrt(1+beta)"},
        {step_kind::identity, "d + (1-(1+d)*s^2)", "", "", "(1+d)*(1-s^2)", "",
         "with sin psi = sqrt(1+beta) s: beta + cos^2 = (1+beta)(1-s^2), so that (ds/dxi)^2 = "
         "(1-s^2)(1-(1+beta)s^2), the equation of sn(xi | 1+beta)"}},
       by_argument,
       {{"argued in words",
         "Along the motion sqrt(ab) dphi = v dxi at every psi between the turning points, which "
         "are passed in finite time, so that the bounds of v are those of xi(pi) against pi "
         "sqrt(ab)."},
        {"argued in words",
         "For beta < 0: sin psi = sqrt(1+beta) sn(xi | 1+beta) up to the first turning point, xi = "
         "K(1+beta), by the equation of sn; beyond it, as psi_c(phi + G) = -psi_c(phi) and psi_c "
         "is odd, xi grows by 2K in every G, and sn is odd with sn(xi + 2K) = -sn xi. For beta >= "
         "0 psi increases, and xi = F(psi | 1/(1+beta))/sqrt(1+beta) defines am."},
        {"argued in words",
         "sn and am are continuous in xi, so that psi_c(pi) tends to its value at pi sqrt(chi)."},
        {"argued in words",
         "The reduced system is the same under (psi, phi) -> (-psi, -phi) and under (cos theta, "
         "phi) -> (-cos theta, -phi); so psi_c is odd and psi_c(phi + G) = -psi_c(phi)."},
        {"cited", "sn(x + 2K | m) = -sn(x | m) (DLMF 22.4(iii))."},
        {"cited",
         "Solutions of ordinary differential equations exist, are unique (Picard and Lindeloef) "
         "and depend continuously on their data."}}},
      {"limit_minimum",
       "section 7, eqs. (39), (40)",
       "Over all physical bodies the greatest lower bound of epsilon0 is epsilon0_min; over all "
       "physical bodies that have a c0 (J < 2) that of c0/b is beta; neither is attained. For beta "
       "< 0, chi <= 1 the limit's epsilon is above epsilon0_min, and tends to it as chi -> 1, beta "
       "-> 0.",
       "ab + 2b <= 1  =>  epsilon0 > epsilon0_min = 2 arctan(e^-pi) and, where J < 2, c0/b > beta; "
       "both are greatest lower bounds",
       "For all physical bodies: (1-bX)^2 > b(a+bX) for 0 <= X < 1, so that the integrand of the "
       "implicit equation exceeds (beta + cos^2 psi)^(-1/2), that of the limit for chi = 1, at "
       "every c = b beta; so epsilon0 and, where there is a c0, c0/b exceed their limits. Planar "
       "bodies a = 1/b - 2 approach them for b -> 0 by the limit formula. Computed: the polynomial "
       "step and both numbers.",
       {{step_kind::positive, "(1-b*x)^2 - b*(a+b*x)", "", "", "p + b*y*(1+q+b*y)",
         "b > 0, p = 1-a*b-2*b >= 0, q = 1-b > 0, y = 1-x > 0",
         "p >= 0 for physical bodies: the integrand exceeds the limit's where X < 1"},
        {step_kind::identity, "(1-2*b) + 2*b", "", "", "1", "",
         "a = 1/b - 2 is planar: ab + 2b = 1"}},
       by_argument,
       {{"argued in words",
         "The integrand exceeds the limit's at every psi > 0, so that the integral does, and "
         "epsilon0 and c0/b exceed their limits."},
        {"argued in words", "Planar bodies approach both limits, by the claim limit_formula."},
        {"argued in words",
         "Before the first turning point the limit's integral is greater for beta < 0 than for "
         "beta = 0 at every psi, and its value pi sqrt(chi) is at most pi: psi is below that of "
         "beta = 0, chi = 1."}}},
      {"epsilon0_min",
       "eq. (39)",
       "epsilon0_min = pi/2 - am(pi | 1) = pi - 2 arctan(e^pi). What it says of bodies, that it is "
       "the greatest lower bound of the twist defect on the separatrix over all physical ones, is "
       "the claim limit_minimum. The paper prints 0.086374.",
       "epsilon0_min = pi - 2 arctan(e^pi) = 2 arctan(e^-pi)",
       "On the separatrix of the limit the amplitude is the Gudermannian, am(pi|1) = 2 "
       "arctan(e^pi) - pi/2, so that pi/2 - am(pi|1) is the formula above; it is evaluated in ball "
       "arithmetic. The second route encloses the one root of log(tan(x/2)) + pi in [0.086, 0.087] "
       "by interval Newton.",
       {},
       by_machine,
       {{"cited", "am(x | 1) is the Gudermannian, 2 arctan(e^x) - pi/2 (DLMF 22.16(i))."}}},
      {"delta_psi_max",
       "section 7, after eq. (40)",
       "delta_psi_max = pi - 2 epsilon0_min. What it says of bodies, that it is the least upper "
       "bound of the twist on the separatrix over all physical ones, follows by the claim "
       "limit_minimum. The paper prints 2.96884.",
       "delta_psi_max = pi - 2 epsilon0_min = 4 arctan(e^pi) - pi",
       "The formula in ball arithmetic; the second route takes epsilon0_min from interval Newton "
       "on log(tan(x/2)) + pi.",
       {},
       by_machine,
       {{"cited", "am(x | 1) is the Gudermannian, 2 arctan(e^x) - pi/2 (DLMF 22.16(i))."}}},
      {"beta",
       "eq. (40)",
       "beta is the one positive root of K(1/(1+beta)) = pi sqrt(1+beta). What it says of bodies, "
       "that it is the greatest lower bound of c0/b over all physical ones, is the claim "
       "limit_minimum. The paper prints 0.028973.",
       "agm(sqrt(1+beta), sqrt(beta)) = 1/2, equivalent to K(1/(1+beta)) = pi sqrt(1+beta)",
       "K(1/(1+x)) = sqrt(1+x) I(x) with I(x) the integral over (0, pi/2) of (x + cos^2 t)^(-1/2), "
       "and I(x) = pi/(2 agm(sqrt(1+x), sqrt(x))) by Gauss: pi cancels. The mean increases "
       "strictly in x > 0 from 0 without bound, so there is exactly one root; interval Newton with "
       "f' from the same AGM steps proves it in its box and encloses it.",
       {},
       by_machine,
       {{"cited",
         "K(m) = pi/(2 agm(1, sqrt(1-m))) (Gauss; DLMF 19.8(i)); the mean is continuous, increases "
         "in both its arguments and is homogeneous."}}},
      {"sign_dF_du",
       "appendix A, lemma 6, eq. (44)",
       "F(-bu,u), half the Montgomery phase of oscillating motion, decreases in u: its derivative "
       "is negative at the given a, b, u, and for all a > 0, 0 < b < 1, 0 < u <= 1.",
       "dF(-bu,u)/du = -(b/(ab)^(3/2)) integral over (0,1) of sqrt(1-y^2) (a + (a+2) b X)/(X (1 + "
       "bX/a))^(3/2) dy < 0, X = u + (1-u) y^2",
       "At the given a, b, u the value is enclosed by two routes that share no formula. For all a, "
       "b, u: after y = sin s the integrand of eq. (43) and its u-derivative are continuous in (s, "
       "u) on [0, pi/2] x [u_0, 1] for every u_0 > 0, so differentiation under the integral is "
       "allowed; the derivative of the integrand is the paper's, an exact identity of rational "
       "functions; its sign is read off its factors. The sweep bounds the same quantity over the "
       "whole compactified box of parameters in interval arithmetic.",
       {},
       with_words,
       {{"argued in words",
         "Differentiation under the integral: the integrand and its derivative in u are continuous "
         "on [0, pi/2] x [u_0, 1] for every u_0 > 0. An integral of what is negative is "
         "negative."}}},
      {"half_phase_limits",
       "appendix A, lemma 7, eqs. (45)-(46)",
       "F(-bu,u) tends to pi I as u tends to 1, and to infinity as u tends to 0.",
       "F(-bu,u) -> pi (1-b)/sqrt(b(a+b)) as u -> 1, F(-bu,u) -> infinity as u -> 0",
       "For all a > 0, 0 < b < 1, by the bounds pi I <= F(-bu,u) <= pi I g(u)/g(1) and F(-bu,u) >= "
       "2 I arsinh(pi/(2 sqrt(u))), g(x) = (1-bx)/sqrt(x(a+bx)): their steps are questions about "
       "polynomials, decided by expansion.",
       {{step_kind::identity, "(1-(u+(1-u)*k)) * ((u+(1-u)*k)-u)", "", "", "(1-u)^2*k*(1-k)", "",
         "x = u + (1-u) k with k = cos^2(t/2) turns F(-bu,u) into b^(-1/2) times the integral over "
         "(0, pi) of g(x) dt, g(x) = (1-bx)/sqrt(x(a+bx))"},
        {step_kind::slope, "(1-b*x)^2", "x*(a+b*x)", "x", "-(1-b*x)*(a+(a+2)*b*x)", "",
         "the derivative of g^2"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "1 - bx > 0 for 0 < x <= 1"},
        {step_kind::positive, "a+(a+2)*b*x", "", "", "a + a*b*x + 2*b*x", "a > 0, b > 0, x > 0",
         "so g decreases strictly on 0 < x <= 1"},
        {step_kind::identity, "(v+(1-v)*k) - (u+(1-u)*k)", "", "", "(v-u)*(1-k)", "",
         "x is greater for v > u where 0 < t < pi, so G decreases"},
        {step_kind::not_negative, "(a+b)-(a+b*x)", "", "", "b*y", "b > 0, y = 1-x >= 0",
         "a + bx <= a + b: g(x) >= (1-b)/sqrt((a+b) x)"},
        {step_kind::not_negative, "(u+k)-(u+(1-u)*k)", "", "", "u*k", "u > 0, k >= 0",
         "x <= u + k: G(u) >= 2 I arsinh(pi/(2 sqrt(u)))"}},
       with_words,
       {{"argued in words",
         "As u tends to 1 both bounds tend to pi I; as u tends to 0 the lower one grows without "
         "bound."}}},
      {"implicit_equations",
       "appendix B, eqs. (48)-(53)",
       "After n intersections of C and S the curve C is given by one of four implicit equations, "
       "by the parity of n and the side of pi/2 on which epsilon is.",
       "2n G - F(c,u') = 2 pi (n odd, epsilon < pi/2; n even, epsilon > pi/2), 2n G + F(c,u') = 2 "
       "pi (n odd, epsilon >= pi/2; n even, epsilon <= pi/2), G = F(c,-c/b), u' = sin^2 epsilon",
       "For all a > 0, 0 < b < 1, -b < c < 0: by the symmetries of the reduced system psi_c(phi + "
       "G) = -psi_c(phi) and psi_c is odd; with pi = nG + r, |r| <= G/2, psi_c(pi) = (-1)^n "
       "psi_c(r) and |r| = F(c,u')/2, and the four cases are those of the signs of (-1)^n and r. "
       "The integral forms consist of 2n-1 whole sweeps G and two end pieces (G +- F)/2. Computed: "
       "the sums below. Cited: uniqueness of solutions (Picard and Lindeloef).",
       {{step_kind::identity, "2*(n*g+r)", "", "", "2*n*g + 2*r", "",
         "2 pi = 2nG + 2r, with 2r = F or 2r = -F"},
        {step_kind::identity, "2*(2*n-1)*g + 2*(g-f)", "", "", "2*(2*n*g - f)", "",
         "eq. (48), epsilon < pi/2, gives eq. (50); eq. (49), epsilon > pi/2, gives eq. (52) "
         "(twice both sides)"},
        {step_kind::identity, "2*(2*n-1)*g + 2*(g+f)", "", "", "2*(2*n*g + f)", "",
         "eq. (48), epsilon >= pi/2, gives eq. (51); eq. (49), epsilon <= pi/2, gives eq. (53)"},
        {step_kind::identity, "2*(2*1-1)*g + 2*(g-f)", "", "", "2*(2*g - f)", "",
         "n = 1: the second equation, eq. (28)"},
        {step_kind::identity, "2*(2*1-1)*g + 2*(g+f)", "", "", "2*(2*g + f)", "",
         "n = 1: eq. (29)"}},
       by_argument,
       {{"argued in words",
         "The reduced system is the same under (psi, phi) -> (-psi, -phi) and under (cos theta, "
         "phi) -> (-cos theta, -phi); so psi_c is odd and psi_c(phi + G) = -psi_c(phi)."},
        {"argued in words",
         "With pi = nG + r, |r| <= G/2: psi_c(pi) = (-1)^n psi_c(r), |r| = F(c,u')/2, and the four "
         "cases are those of the signs of (-1)^n and r."},
        {"cited",
         "Solutions of ordinary differential equations exist, are unique (Picard and Lindeloef) "
         "and depend continuously on their data."}}},
      {"printed_numbers",
       "figs. 6, 7, eqs. (39), (40), section 8",
       "The numbers in the captions, in section 7 and in the conclusion are those of their "
       "formulas, to the last digit printed, but for those in errata.",
       "|printed - value| <= half a unit of the last place printed",
       "Each number is enclosed from its formula in ball arithmetic (beta by interval Newton), and "
       "compared with the printed decimal as an exact rational. Those that are wrong are in the "
       "claim errata.",
       {},
       by_machine,
       {}},
      {"errata",
       "sections 1 to 8, figure 7",
       "Each printed number that is wrong, beside the certified one, and statements that are not "
       "right as printed.",
       "|printed - value| > half a unit of the last place printed",
       "The numbers as in the claim printed_numbers; statements by an exact counterexample in "
       "rationals, by enclosures, or by polynomial steps. The numbers of figure 7, but for 1.045, "
       "are "
       "those of b = 0.0629 in place of 0.06, and 0.872 is cut off where 0.873 would be rounded.",
       {{step_kind::identity, "2*f + 2*(g-f)", "", "", "2*g", "",
         "lemma 1, where C meets S, at G = 2 pi: from -pi/2 + epsilon to pi/2 - epsilon it takes "
         "F, from there to the turning point and back (G - F)/2 twice, G in all for every epsilon"},
        {step_kind::identity, "0 - (2*e-p)", "", "", "2*(p-e) - p", "",
         "lemma 1, at every c: the mirror motion, psi -> -psi and cos theta -> -cos theta, goes in "
         "the same time from -psi_i = -pi/2 + (pi - epsilon) to -psi_f, so that pi - epsilon "
         "belongs to c as well (here epsilon is that of the motion with cos theta > 0 at psi = 0 "
         "and half of the time)"},
        {step_kind::positive, "1-b*x", "", "", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
         "proposition 2 says that d epsilon/dc <= 0 with a discrete set of zeros: the integrand of "
         "its numerator has the sign of 1 - bX, is positive, and the range 0 < psi < pi/2 - "
         "epsilon is not empty, as the integral over it is pi: d epsilon/dc < 0 throughout"}},
       with_words,
       {{"argued in words",
         "A statement that is not right in general is refuted by one body; what the facts say of "
         "all bodies is that of the claims that they name."}}},
  };
  return texts;
}

}  // namespace

const claim_text* find_claim_text(std::string_view name) {
  const auto& texts = all_texts();
  const auto found =
      std::find_if(texts.begin(), texts.end(), [&](const claim_text& t) { return t.name == name; });
  return found == texts.end() ? nullptr : &*found;
}

}  // namespace polhode::checker
