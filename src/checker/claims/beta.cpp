// beta, by its bracket of rounded steps, its Newton box and two integrals.

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "answers.hpp"
#include "checker/elliptic.hpp"
#include "checker/examination.hpp"
#include "checker/functions.hpp"
#include "constants.hpp"
#include "list.hpp"
#include "statements/beta.hpp"
#include "trapezoid.hpp"

namespace polhode::checker {
namespace {

/// One chain of whole numbers over the scale S, from (sqrt(1+x), sqrt(x)), x = n/S. Where `upward`
/// every pair is at or above what the mean's step makes of the pair before, so that the mean of all
/// the numbers is at least agm(sqrt(1+x), sqrt(x)): it increases in both its arguments and is not
/// changed by a step. At the end both numbers are below S/2: agm < 1/2, and as it increases in x, x
/// < beta. Else the reverse.
void check_chain_of_steps(const place& chain, const integer& S, const integer& n, bool upward) {
  constexpr std::size_t most_steps = 200;
  chain.expect_keys({"argument", "start", "steps"});
  const auto is_rounded = [upward](const integer& given, const integer& exact) {
    return upward ? given >= exact : given <= exact;
  };
  const auto read_pair = [](const place& where) {
    if (where.size() != 2) where.malformed("it must be a pair of whole numbers");
    std::array<integer, 2> pair{where.at(0).big(), where.at(1).big()};
    for (std::size_t i = 0; i < 2; ++i) {
      if (pair[i] <= 0) where.at(i).refute("it is not positive");
    }
    return pair;
  };
  const std::string way = upward ? "at least " : "at most ";
  budget& work = chain.work();
  // Products of two numbers of the chain, and of one with the scale.
  const auto charge = [&](const integer& x, const integer& y) {
    work.spend(4 * budget::of_product(words(x) + words(S), words(y) + words(S)));
  };
  const place start = chain["start"];
  const budget::at here = start.working();
  auto [A, B] = read_pair(start);
  charge(A, B);
  if (!is_rounded(A * A, (S + n) * S)) start.at(0).refute("it must be " + way + "sqrt(1+x) S");
  if (!is_rounded(B * B, n * S)) start.at(1).refute("it must be " + way + "sqrt(x) S");
  const place steps = chain["steps"];
  if (steps.size() > most_steps) steps.malformed("it has more than 200 steps");
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const place step = steps.at(i);
    const auto [A_next, B_next] = read_pair(step);
    const budget::at at_step = step.working();
    charge(A, B);
    charge(B_next, B_next);
    if (!is_rounded(2 * A_next, A + B)) {
      step.at(0).refute("it must be " + way + "the mean of the pair before");
    }
    if (!is_rounded(B_next * B_next, A * B)) {
      step.at(1).refute("it must be " + way + "the root of the product of the pair before");
    }
    A = A_next;
    B = B_next;
  }
  const bool ends = upward ? 2 * A < S && 2 * B < S : 2 * A > S && 2 * B > S;
  if (!ends) {
    steps.refute(std::string("the last pair does not lie ") + (upward ? "below" : "above") +
                 " half of the scale");
  }
}

/// The bracket's ends.
range check_agm_bracket(examination& e) {
  e.witness("kind").expect_text("agm_bracket");
  const place scale = e.witness("scale");
  const place below = e.witness("below");
  const place above = e.witness("above");
  const integer S = scale.big();
  if (S <= 0) scale.refute("it is not positive");
  const integer from = below["argument"].big();
  const integer to = above["argument"].big();
  if (from <= 0) below["argument"].refute("it is not positive");
  if (to <= from) above["argument"].refute("it is not above the other argument");
  check_chain_of_steps(below, S, from, true);
  check_chain_of_steps(above, S, to, false);
  return {rational(from, S), rational(to, S)};
}

/// f' = M (x + 1/2 - S)/(2 x (1+x)) over the box, S the sum of 2^(n-1) c_n^2 over n >= 1: of f =
/// agm - 1/2. In parts of the box, as intervals that occur several times in a formula make it wide.
interval derivative_over(const range& box, precision bits) {
  constexpr int parts = 32;
  const precision w = bits + 64;
  const interval one = exactly(1, w);
  const rational step((box.upper - box.lower) / parts);
  std::optional<interval> all;
  for (int i = 0; i < parts; ++i) {
    const rational from(box.lower + i * step);
    const interval x = interval::between(from, rational(from + step), w);
    const mean_and_sum s = agm_with_sum(sqrt(one + x), sqrt(x));
    const interval part = s.mean * (x + one / 2 - s.sum) / (x * (one + x)).scaled(1);
    all = all ? hull(*all, part) : part;
  }
  return *all;
}

/// The Newton step maps its box into itself, with a derivative that is positive.
void check_newton(examination& e) {
  const place newton = e.witness("newton");
  newton.expect_keys({"box", "derivative", "image"});
  const range box = examination::dyadic_range(newton["box"]);
  const range image = examination::dyadic_range(newton["image"]);
  if (box.lower <= 0) newton["box"]["lower"].refute("it is not positive");
  if (box.upper > 1) newton["box"]["upper"].refute("it is above 1");
  for (const char* key : {"box", "image"}) {
    const range& r = key == std::string("box") ? box : image;
    if (bit_length(r.lower) + bit_length(r.upper) > 20'000) {
      newton[key].not_checkable("its ends have too many digits");
    }
  }
  if (image.lower < box.lower) newton["image"]["lower"].refute("the image leaves the box");
  if (image.upper > box.upper) newton["image"]["upper"].refute("the image leaves the box");
  const range slope = examination::decimals(
      newton["derivative"], [&](precision bits) { return derivative_over(box, bits); });
  e.fact(statements::one_root_in_box, [&](precision bits) -> tri {
    const precision more = bits + bit_length(image.lower) + bit_length(image.upper);
    const interval at_lower = mean_equation(image.lower, more);
    const interval at_upper = mean_equation(image.upper, more);
    if (slope.lower <= 0 || at_lower.is_positive() || at_upper.is_negative()) return false;
    if (!at_lower.is_negative() || !at_upper.is_positive()) return std::nullopt;
    // The step from the box's middle, for f = agm - 1/2, which is half of the equation's
    // function.
    const precision w = more + bit_length(box.lower) + bit_length(box.upper);
    const rational middle((box.lower + box.upper) / 2);
    const interval step = exactly(middle, w) - mean_equation(middle, w) / 2 /
                                                   interval::between(slope.lower, slope.upper, w);
    if (!overlaps(step, box.lower, box.upper)) return false;
    return is_inside(step, box.lower, box.upper) ? tri(true) : std::nullopt;
  });
}

/// 1/sqrt(x + cos^2(t/2)); on the strip Re(x + (1 + cos t)/2) >= x + (1 - cosh H)/2.
periodic_integrand inverse_root(const rational& x) {
  return {[x](const interval& cosine) {
            const precision bits = cosine.bits();
            return exactly(1, bits) /
                   sqrt(exactly(rational(x + rational(1, 2)), bits) + cosine / 2);
          },
          [x](const rational& half_width, precision bits) {
            const interval cosh = cosh_of(half_width, bits);
            return exactly(1, bits) / sqrt(exactly(x, bits) + (exactly(1, bits) - cosh) / 2);
          }};
}

/// The integral exceeds pi at the first digits of beta, and is below pi one unit of the last place
/// higher.
void check_integrals(examination& e, const range& beta) {
  const place quadrature = e.witness("quadrature");
  constexpr long most_quadrature_digits = 100;
  const long digits = std::min(e.digits(), most_quadrature_digits);
  quadrature.expect_keys({"below", "above"});
  const place statement =
      e.fact(statements::fill(statements::signs_by_quadrature, {std::to_string(digits)}), enclosed);
  const std::string first = decimal(beta.lower, digits, rounding::to_zero, e.work());
  rational below;
  static_cast<void>(read_decimal(first, below));
  const rational above(below + power_of_ten(static_cast<long>(first.find('.')) + 1 -
                                            static_cast<long>(first.size())));
  for (const bool is_below : {true, false}) {
    const place side = quadrature[is_below ? "below" : "above"];
    side.expect_keys(
        {"x", "rule", "nodes", "half_width", "supremum", "truncation_error", "integral"});
    const rational& x = is_below ? below : above;
    side["x"].expect_text(x.str());
    interval integral = check_quadrature(side, inverse_root(x), 0);
    examination::decimals(side["integral"], [&](long) { return integral; });
    const interval difference = integral - pi(integral.bits()).scaled(1);
    if (is_below ? !difference.is_positive() : !difference.is_negative()) {
      statement.refute(std::string("the integral ") + (is_below ? "below" : "above") +
                       " does not show it");
    }
  }
}

void check_beta(examination& e) {
  e.read_no_inputs();
  const range steps = check_agm_bracket(e);
  const range beta = e.root_number("beta", false, mean_equation);
  if (steps.lower < beta.lower || beta.upper < steps.upper) {
    e.witness("scale").refute("the bracket of the steps is wider than the number's enclosure");
  }
  check_newton(e);
  check_integrals(e, beta);
}

}  // namespace

claim beta_claim() { return {statements::beta(), check_beta}; }

}  // namespace polhode::checker
