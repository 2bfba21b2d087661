#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* kind_of_body =
    "at the given a, b, exactly: I_y + I_z - I_x = {} for I_y = 1, and I^2 - 1 = {}, of the "
    "same sign: {}";

[[nodiscard]] inline claim_text physical() {
  return {
      .name = "physical",
      .reference = "proposition 1",
      .statement =
          "A rigid body with moments of inertia I_z < I_y < I_x is physical, I_y + I_z >= I_x, if "
          "and only if its geometric constant is I >= 1; it is planar if and only if I = 1.",
      .technique = "identities of polynomials over all moments; exact signs for a body",
      .formula = "I_y + I_z >= I_x  <=>  I = (1-b)/sqrt(b(a+b)) >= 1  <=>  ab + 2b <= 1",
      .method =
          "For all bodies: with x = I_x, y = I_y, z = I_z the square of I is yz/((x-y)(x-z)), and "
          "yz - (x-y)(x-z) = x(y+z-x); every a > 0, 0 < b < 1 is that of some moments. All steps "
          "are identities of polynomials, decided by expansion. For the given body: exact "
          "signs.",
      .steps =
          {identity(
               "(y-z)*x + (x-y)*z", "y*(x-z)",
               "a + b = y(x-z)/(xz) with a = (y-z)/z, b = (x-y)/x, so that I^2 = yz/((x-y)(x-z))"),
           identity("y*z - (x-y)*(x-z)", "x*(y+z-x)", "I^2 - 1 has the sign of I_y + I_z - I_x"),
           identity("(1-b)^2 - b*(a+b)", "1 - 2*b - a*b", "and that of 1 - 2b - ab"),
           positive("x+z-y", "z + p", "z > 0, p = x-y > 0", "I_x + I_z > I_y always"),
           positive("x+y-z", "x + p", "x > 0, p = y-z > 0", "I_x + I_y > I_z always"),
           identity("(u^2+w^2)+(u^2+v^2)-(v^2+w^2)", "2*u^2",
                    "a body of masses at (u, v, w) has I_x, I_y, I_z = the integrals of v^2 + w^2, "
                    "u^2 + w^2, u^2 + v^2 over its masses: I_y + I_z - I_x is twice that of u^2, "
                    "which is not negative, and 0 exactly where all masses are in the plane u = "
                    "0")},
      .tier = by_kernel,
      .argument = {in_coq("Prop1.proposition_1"), in_coq("Prop1.planar")}};
}

}  // namespace polhode::statements
