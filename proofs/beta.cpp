#include "proofs/beta.hpp"

#include <cmath>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/agm_bracket.hpp"
#include "polhode/elliptic/complete.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "proofs/claims.hpp"
#include "proofs/periodic_witness.hpp"
#include "statements/beta.hpp"

namespace polhode::proofs {
namespace {

/// f(x) = M(sqrt(1+x), sqrt(x)) - 1/2.
ball mean_equation(const ball& x) { return (2 * agm(sqrt(1 + x), sqrt(x)) - 1) / 2; }

/// f'(x) = M (x + 1/2 - S) / (2 x (1 + x)), S the sum of 2^(n-1) c_n^2 over n >= 1: the proof is in
/// proofs/arguments/beta.md.
ball mean_equation_slope(const ball& x) {
  const agm_sums m = agm_with_sum(sqrt(1 + x), sqrt(x));
  return m.mean * (x + rational(1, 2) - m.sum) / (2 * x * (1 + x));
}

/// A root near enough for interval Newton to start with, by the secant method in hardware
/// arithmetic. A bad value would be noticed, not believed.
long double approximate_root() {
  const auto f = [](long double x) {
    long double a = std::sqrt(1 + x);
    long double b = std::sqrt(x);
    for (int i = 0; i < 6; ++i) {
      const long double mean = (a + b) / 2;
      b = std::sqrt(a * b);
      a = mean;
    }
    return a - 0.5L;
  };
  long double x = 0.02L;
  long double y = 0.04L;
  long double fx = f(x);
  for (int i = 0; i < 12 && x != y; ++i) {
    const long double fy = f(y);
    if (fx == fy) break;
    const long double next = y - fy * (y - x) / (fy - fx);
    x = y;
    fx = fy;
    y = next;
  }
  return y;
}

/// A box of relative radius 2^-bits around the approximate root.
ball start_box(int bits) {
  const long double root = approximate_root();
  const auto high = static_cast<double>(root);
  const auto low = static_cast<double>(root - high);
  const ball centre = ball::exactly(high, 80) + ball::exactly(low, 80);
  return centre.enlarged(scale(centre.magnitude_upper(), -bits));
}

/// 1/sqrt(x + cos^2(t/2)) at the cosine of t: the integral over (0, pi) is 2 I, so that the
/// equation K(1/(1+x)) = pi sqrt(1+x) reads: this integral is 2 pi.
class inverse_root_integrand {
 public:
  explicit inverse_root_integrand(rational x) : x_(std::move(x)) {}

  template <scalar T>
  [[nodiscard]] auto evaluator(precision p) const {
    const T shift = scalar_from<T>(rational(x_ + rational(1, 2)), p);
    return [=](const T& cosine) -> T { return 1 / sqrt(T(shift + cosine / 2)); };
  }

  /// Re(x + (1 + cos t)/2) >= x + (1 - cosh H)/2 for |Im t| <= H: where that is positive the root
  /// is analytic and |integrand| <= (x + (1 - cosh H)/2)^(-1/2).
  [[nodiscard]] std::optional<strip_bound> bound_on_strip(const ball& half_width) const {
    const ball least = x_ + scale(1 - cosh(half_width), -1);
    if (!certainly_positive(half_width) || !certainly_positive(least)) return std::nullopt;
    return strip_bound{half_width, 1 / sqrt(least)};
  }

 private:
  rational x_;
};

/// The sign of (integral - 2 pi) at x, by certified quadrature to a radius of 2^-bits.
struct sign_by_quadrature {
  certain_sign value = certain_sign::unknown;
  periodic_integral integral;
};
sign_by_quadrature sign_at(const rational& x, long bits) {
  sign_by_quadrature result;
  result.integral = integrate_periodic(inverse_root_integrand(x), bits);
  if (result.integral.verdict == status::certified) {
    result.value = sign_of(result.integral.enclosure - 2 * pi(bits + 64));
  }
  return result;
}

/// The decimals of x cut off after `digits` digits, as a rational, and one unit of their last
/// place.
struct decimal_bracket {
  rational below;
  rational above;
};
decimal_bracket bracket_of(const ball& x, long digits) {
  const std::string text = to_decimal_enclosure(x, digits).value;
  const rational below = parse_rational(text);
  const auto decimals = static_cast<long>(text.size() - text.find('.') - 1);
  return {below, below + parse_rational("1e-" + std::to_string(decimals))};
}

/// The independent route: no AGM, no derivative. The integral decreases in x (its integrand does),
/// so signs + and - at two points enclose its only root.
void add_quadrature_route(certificate& c, const ball& root, long digits) {
  const decimal_bracket bracket = bracket_of(root, digits);
  const long bits = bits_for_digits(digits) + 16;
  const sign_by_quadrature below = sign_at(bracket.below, bits);
  const sign_by_quadrature above = sign_at(bracket.above, bits);
  c.facts.push_back({statements::fill(statements::signs_by_quadrature, {std::to_string(digits)}),
                     below.value == certain_sign::positive && above.value == certain_sign::negative,
                     step_kind::enclosed});
  const auto side = [](const rational& x, const sign_by_quadrature& s) {
    json one{{"x", to_text(x)}};
    add_periodic_plan(one, s.integral.plan);
    one["integral"] = to_json(s.integral.enclosure, 20);
    return one;
  };
  c.witness["quadrature"] =
      json{{"below", side(bracket.below, below)}, {"above", side(bracket.above, above)}};
}

certificate prove_beta(const request& wanted) {
  constexpr long most_quadrature_digits = 100;
  certificate c;
  const root_enclosure root = enclose_beta(bits_for_digits(wanted.digits) + 32);
  c.numbers.push_back({"beta", root.root, wanted.digits});
  c.facts.push_back({statements::one_root_in_box,
                     root.verdict == root_verdict::unique && !contains_zero(root.derivative),
                     step_kind::enclosed});
  if (root.verdict == root_verdict::unique) {
    if (auto steps = agm_bracket_witness(lower_rational(root.root), upper_rational(root.root))) {
      c.witness = *std::move(steps);
    }
  }
  c.witness["newton"] = json{{"box", to_dyadic_json(root.box)},
                             {"derivative", to_json(root.derivative, 17)},
                             {"image", to_dyadic_json(root.image)}};
  if (root.verdict == root_verdict::unique) {
    add_quadrature_route(c, root.root, std::min(wanted.digits, most_quadrature_digits));
  }
  c.conclude();
  return c;
}

}  // namespace

root_enclosure enclose_beta(precision p) {
  root_enclosure root;
  // The first box is right where long double has 64 bits; the others are for machines where it has
  // fewer.
  for (const int bits : {54, 44, 20}) {
    root = refine_root(mean_equation, mean_equation_slope, start_box(bits), p);
    if (root.verdict == root_verdict::unique) break;
  }
  return root;
}

claim beta_claim() { return {statements::beta(), prove_beta}; }

}  // namespace polhode::proofs
