#include "proofs/derivative_identity.hpp"

#include <bit>

#include "polhode/arithmetic/exact.hpp"
#include "statements/sign_dF_du.hpp"

namespace polhode::proofs {
namespace {

/// value + derivative * e with e^2 = 0: exact differentiation of rational functions.
struct dual {
  rational value;
  rational derivative;

  friend dual operator+(const dual& x, const dual& y) {
    return {x.value + y.value, x.derivative + y.derivative};
  }
  friend dual operator-(const dual& x, const dual& y) {
    return {x.value - y.value, x.derivative - y.derivative};
  }
  friend dual operator*(const dual& x, const dual& y) {
    return {x.value * y.value, x.derivative * y.value + x.value * y.derivative};
  }
  friend dual operator/(const dual& x, const dual& y) {
    return {x.value / y.value,
            (x.derivative * y.value - x.value * y.derivative) / (y.value * y.value)};
  }
};

dual constant(const rational& q) { return {q, 0}; }

/// X = u + (1 - u) y^2, with u the variable.
dual x_of(const dual& u, const rational& y) { return u + (constant(1) - u) * constant(y * y); }

/// h^2 from its definition.
dual squared_integrand(const rational& a, const rational& b, const dual& u, const rational& y) {
  const dual x = x_of(u, y);
  const dual one_minus_bx = constant(1) - constant(b) * x;
  return constant(a) * one_minus_bx * one_minus_bx /
         (constant(1 - y * y) * x * (constant(a) + constant(b) * x));
}

/// The right side: twice h times the paper's derivative.
rational paper_side(const numerator_polynomial& numerator, const rational& a, const rational& b,
                    const rational& u, const rational& y) {
  const rational x = u + (1 - u) * y * y;
  const rational product = x * (a + b * x);
  return -a * (1 - b * x) * numerator(a, b, x) / (product * product);
}

}  // namespace

rational derivative_numerator(const rational& a, const rational& b, const rational& x) {
  return a + (a + 2) * b * x;
}

identity_check check_derivative_identity(const numerator_polynomial& numerator) {
  constexpr long a_points = 3;
  constexpr long b_points = 4;
  constexpr long u_points = 4;
  constexpr long y_points = 11;
  identity_check result;
  result.statement = statements::fill(statements::derivative_identity,
                                      {std::to_string(a_points * b_points * u_points * y_points)});
  result.degrees = statements::degrees_of_identity;
  result.holds = true;
  for (long i = 1; i <= a_points; ++i) {
    for (long j = 1; j <= b_points; ++j) {
      for (long k = 1; k <= u_points; ++k) {
        for (long l = 0; l < y_points; ++l) {
          // Points inside the domain, where no denominator is 0: 0 <= y < 1, X > 0.
          const rational a(i);
          const rational b(j, b_points + 1);
          const rational u(k, u_points);
          const rational y(l, y_points);
          const rational derivative = squared_integrand(a, b, {u, 1}, y).derivative;
          result.holds = result.holds && derivative == paper_side(numerator, a, b, u, y);
          ++result.points;
        }
      }
    }
  }
  return result;
}

bool numerator_is_positive(const numerator_polynomial& numerator) {
  bool some_positive = false;
  for (unsigned monomial = 0; monomial < 8; ++monomial) {  // bits: a, b, X
    rational coefficient = 0;
    for (unsigned point = 0; point < 8; ++point) {
      if ((point & ~monomial) != 0) continue;  // the corners below this monomial
      const bool odd = std::popcount(monomial ^ point) % 2 != 0;
      const rational value = numerator(point & 1U, point >> 1 & 1U, point >> 2 & 1U);
      coefficient += odd ? rational(-value) : value;
    }
    if (coefficient < 0) return false;
    some_positive = some_positive || coefficient > 0;
  }
  return some_positive;
}

}  // namespace polhode::proofs
