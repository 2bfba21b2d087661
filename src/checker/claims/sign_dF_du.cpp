// The sign of dF/du, by an integral, an identity and a sweep.

#include <algorithm>
#include <optional>
#include <string>

#include "answers.hpp"
#include "checker/elliptic.hpp"
#include "checker/functions.hpp"
#include "checker/polynomial.hpp"
#include "list.hpp"
#include "statements/sign_dF_du.hpp"
#include "sweep.hpp"
#include "trapezoid.hpp"

namespace polhode::checker {
namespace {

/// -(1/4) b^(-1/2) (1 + cos t)(a + (a+2) b X)/(X (a + b X))^(3/2), X = ((1+u) - (1-u) cos t)/2:
/// dG/du is its integral. On the strip |X| <= above, Re X >= below, |1 + cos t| <= 1 + cosh H, and
/// |X (a + b X)| >= below (a + b below).
periodic_integrand slope_integrand(const real& a, const real& b, const rational& u) {
  const real slope = (a + 2) * b;
  return {[=](const interval& cosine) {
            const precision bits = cosine.bits();
            const interval x = exactly(rational((1 + u) / 2), bits) -
                               exactly(rational((1 - u) / 2), bits) * cosine;
            const interval product = x * (exactly(a, bits) + exactly(b, bits) * x);
            const interval numerator =
                (exactly(1, bits) + cosine) * (exactly(a, bits) + exactly(slope, bits) * x);
            return -numerator / (sqrt(exactly(b, bits)) * product * sqrt(product) * 4);
          },
          [=](const rational& half_width, precision bits) {
            const strip_range x = range_on_strip(u, half_width, bits);
            if (!x.below.is_positive()) throw undecided("x may be 0 on it");
            const interval cosh = cosh_of(half_width, bits);
            const interval product = x.below * (exactly(a, bits) + exactly(b, bits) * x.below);
            const interval numerator =
                (exactly(1, bits) + cosh) * (exactly(a, bits) + exactly(slope, bits) * x.above);
            return numerator / (sqrt(exactly(b, bits)) * product * sqrt(product) * 4);
          }};
}

/// d(h^2)/du, expanded: with X = u + (1-u) k, k = y^2, N = a (1 - bX)^2 and D = (1-k) X (a + bX),
/// (N' D - N D')/D^2 is -a (1 - bX)(a + (a+2) b X)/(X (a + bX))^2.
bool identity_holds() {
  const polynomial x = polynomial::read("u+(1-u)*k");
  const auto in_x = [&](const char* text) { return polynomial::read(text).with('x', x); };
  const polynomial n = in_x("a*(1-b*x)^2");
  const polynomial d = in_x("(1-k)*x*(a+b*x)");
  return n.derivative('u') * d - n * d.derivative('u') == in_x("-a*(1-b*x)*(a+(a+2)*b*x)*(1-k)^2");
}

/// The second route: the integral of eq. (44), or the note that u is too near 0 for it.
void check_integral_route(examination& e, const range& value) {
  const real& a = e.rigid().a;
  const real& b = e.rigid().b;
  const rational& u = e.u();
  const place quadrature = e.witness("quadrature");
  if (quadrature.has("note")) {
    quadrature.expect_keys({"verdict", "rule", "note"});
    quadrature["verdict"].expect_text("not certified");
    quadrature["rule"].expect_text(statements::periodic_rule);
    quadrature["note"].expect_text(statements::fill(statements::too_near_0, {"200000"}));
    // The strip's half-width is below artanh sqrt u < 2 sqrt u: for u above q^2 the rule has the
    // digits with fewer nodes.
    const rational q(4 * std::min(e.digits(), 1000L) + 200 + e.input_bits(), 250'000);
    if (u > q * q) quadrature["note"].refute("u is not so near 0");
  } else {
    quadrature.expect_keys(
        {"verdict", "rule", "nodes", "half_width", "supremum", "truncation_error", "value"});
    quadrature["verdict"].expect_text("certified");
    interval integral = check_quadrature(quadrature, slope_integrand(a, b, u), e.input_bits());
    const range given = examination::decimals(quadrature["value"], [&](long) { return integral; });
    constexpr long most_quadrature_digits = 1000;
    quadrature["value"]["digits"].expect_whole(std::min(e.digits(), most_quadrature_digits));
    e.fact(statements::fill(statements::slope_by_quadrature,
                            {std::to_string(std::min(e.digits(), most_quadrature_digits))}),
           overlaps(integral, value.lower, value.upper) && given.upper < 0, enclosed);
  }
}

/// The paper's derivative of the integrand, and its sign.
void check_identity(examination& e) {
  const place identity = e.witness("identity");
  identity.expect_keys({"points", "degrees"});
  identity["points"].expect_whole(528);
  identity["degrees"].expect_text(statements::degrees_of_identity);
  const bool holds = identity_holds();
  e.fact(statements::fill(statements::derivative_identity, {"528"}), holds);
  e.fact(statements::factors_are_positive,
         holds &&
             letter_ranges("a > 0, b > 0, x > 0").show_sign(polynomial::read("a+(a+2)*b*x"), true));
}

void check_boxes(examination& e, const range& value) {
  const real& a = e.rigid().a;
  const real& b = e.rigid().b;
  const rational& u = e.u();
  const std::size_t boxes = check_sweep(e.witness("sweep"));
  e.fact(statements::fill(statements::sweep_of_all_parameters, {std::to_string(boxes)}), true,
         enclosed);
  const interval integral = enclosure_at(a / (a + b), b * (1 + a) / (a + b), u,
                                         precision(sweep_bits + e.input_bits(), e.work()));
  e.fact(statements::sweep_holds_value, [&](precision bits) -> tri {
    const interval factor = -exactly(u, bits) * sqrt(exactly(b * (a + b), bits));
    const interval W = factor * interval::between(value.lower, value.upper, bits);
    if (is_inside(W, integral.lower(), integral.upper())) return true;
    if (!overlaps(W, integral.lower(), integral.upper())) return false;
    return std::nullopt;
  });
}

void check_sign_dF_du(examination& e) {
  e.read_motion();
  const real& a = e.rigid().a;
  const real& b = e.rigid().b;
  const rational& u = e.u();
  const range value =
      e.number("dF_du", [&](precision bits) { return half_phase_slope(a, b, u, bits); });
  e.fact(statements::slope_is_negative, value.upper < 0, enclosed);
  check_integral_route(e, value);
  check_identity(e);
  check_boxes(e, value);
}

}  // namespace

claim sign_dF_du_claim() { return {statements::sign_dF_du(), check_sign_dF_du}; }

}  // namespace polhode::checker
