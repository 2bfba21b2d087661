#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

[[nodiscard]] inline claim_text separatrix_twist() {
  return {.name = "separatrix_twist",
          .reference = "proposition 3, part 1, eq. (25)",
          .statement =
              "The tennis racket effect always occurs on the separatrix: F(0,u) = 2 pi has exactly "
              "one solution u = sin^2 epsilon0 in (0, 1), for every body.",
          .technique = "exact signs and limits; interval Newton for the number",
          .formula = "F(0, sin^2 epsilon0) = 2 pi has exactly one solution, 0 < epsilon0 < pi/2",
          .method =
              "For all a > 0, 0 < b < 1: F(0,u) decreases strictly in u, its integrand being "
              "positive; it is at least I log(1/u), and by its closed form, whose derivative is an "
              "identity of polynomials, it tends to 0 as u tends to 1. So it is 2 pi exactly once. "
              "The number: interval Newton on y/sqrt(ab) - arctan(sqrt(b/a) tanh y) = pi, tan "
              "epsilon0 = sqrt(a/(a+b))/sinh y.",
          .steps = {positive("1-b*x", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
                             "1 - bx > 0: the integrand is positive, F(0,u) decreases in u"),
                    not_negative(
                        "(a+b)-(a+b*x)", "b*y", "b > 0, y = 1-x >= 0",
                        "a + bx <= a + b: the integrand is at least I/x, F(0,u) >= I log(1/u)"),
                    slope("1-x", "a+b*x", "x", "-(a+b)", "the derivative of w^2 = (1-x)/(a+bx)"),
                    identity("(a+b*x) - a*(1-x)", "(a+b)*x", "1 - a w^2 = (a+b)x/(a+bx)"),
                    identity("(a+b*x) + b*(1-x)", "a+b",
                             "1 + b w^2 = (a+b)/(a+bx), so that F(0,u) = 2 artanh(sqrt(a) "
                             "w)/sqrt(ab) - 2 arctan(sqrt(b) w), which tends to 0 as u -> 1")},
          .tier = by_kernel,
          .argument = {in_coq("Separatrix.proposition_3_1")}};
}

}  // namespace polhode::statements
