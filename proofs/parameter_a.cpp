#include "proofs/parameter_a.hpp"

namespace polhode::proofs {

std::vector<polynomial_step> decrease_in_a_steps() {
  return {slope('a', "(1-b*x)^2", "(a+b*x)*(c+b*x)", "-(1-b*x)^2*(c+b*x)",
                "the derivative in a of the square of the integrand, negative"),
          positive("1-b*x", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
                   "1 - bX > 0 for 0 <= X <= 1: the integrand is positive")};
}

body with_double_a(const body& rigid) {
  return {rational(2 * rigid.a().exact()), rigid.b().exact()};
}

}  // namespace polhode::proofs
