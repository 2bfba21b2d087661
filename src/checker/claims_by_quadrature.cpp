// The claims whose witness is more than numbers: beta, by its bracket of rounded steps, its Newton box and two integrals; and the sign of dF/du, by
// an integral, an identity and a sweep.

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "claims.hpp"
#include "elliptic.hpp"
#include "polynomial.hpp"

namespace polhode::checker {
namespace {

using tri = std::optional<bool>;

interval exactly(const rational& q, precision bits) { return {q, bits}; }

// ---------------------------------------------------------------------------------------------
// Rounded steps of the arithmetic-geometric mean

/// One chain of whole numbers over the scale S, from (sqrt(1+x), sqrt(x)), x = n/S. Where `upward` every pair is at or above what the mean's step
/// makes of the pair before, so that the mean of all the numbers is at least agm(sqrt(1+x), sqrt(x)): it increases in both its arguments and is
/// not changed by a step. At the end both numbers are below S/2: agm < 1/2, and as it increases in x, x < beta. Else the reverse.
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

// ---------------------------------------------------------------------------------------------
// Integrals by the trapezoidal rule

struct periodic_integrand {
  std::function<interval(const interval& cosine)> value;
  /// A bound of its modulus on the strip; throws undecided where it proves none.
  std::function<interval(const rational& half_width, precision bits)> supremum;
};

/// Repeats the integral that a witness describes by "nodes", "half_width", "supremum" and "truncation_error", with `extra` bits for
/// what inputs of so many bits cancel.
interval check_integral(const place& where, const periodic_integrand& f, long extra) {
  constexpr long most_nodes = 200'000;
  const budget::at here = where.working();
  constexpr long most_work =
      30'000'000;  // nodes times bits: what is far beyond a proof's need is refused at once
  where["rule"].expect_text("periodic trapezoid, 2n nodes (2k+1) pi/(2n)");
  const long n = where["nodes"].whole(1, most_nodes);
  const rational half_width = where["half_width"].fraction();
  if (half_width <= 0 || half_width > 100 || bit_length(half_width) > 4096) {
    where["half_width"].malformed("it must be a positive rational up to 100, of at most 4096 bits");
  }
  // e^(2 n H) is 2^(2.885... n H).
  const rational exponent(half_width * n * 3);
  const precision bits(
      96 + extra + static_cast<long>(floor_quotient(numerator(exponent), denominator(exponent))),
      where.work());
  if (bits > most_work / n) where["nodes"].not_checkable("it would take too many operations");
  try {
    const interval least = f.supremum(half_width, bits);
    const place given_supremum = where["supremum"];
    if (given_supremum.decimal_value() < least.upper()) {
      given_supremum.refute("the supremum on the strip is not shown to be below it");
    }
    const periodic_integral own = periodic_trapezoid(f.value, n, half_width, least.upper(), bits);
    const place error = where["truncation_error"];
    if (error.decimal_value() < own.truncation_bound.upper()) {
      error.refute("the truncation error is not shown to be below it");
    }
    // They are rounded outward, not bounds of any size.
    const rational slack(1'000'001, 1'000'000);
    if (given_supremum.decimal_value() > least.upper() * slack) {
      given_supremum.refute("it is not the supremum's bound, rounded up");
    }
    if (error.decimal_value() > own.truncation_bound.upper() * rational(11, 10)) {
      error.refute("it is not the truncation error's bound, rounded up");
    }
    return own.value;
  } catch (const undecided& problem) {
    where["half_width"].not_checkable(std::string("no bound is proved on this strip: ") +
                                      problem.what());
  }
}

/// 1/sqrt(x + cos^2(t/2)); on the strip Re(x + (1 + cos t)/2) >= x + (1 - cosh H)/2.
periodic_integrand inverse_root(const rational& x) {
  return {[x](const interval& cosine) {
            const precision bits = cosine.bits();
            return exactly(1, bits) /
                   sqrt(exactly(rational(x + rational(1, 2)), bits) + cosine / 2);
          },
          [x](const rational& half_width, precision bits) {
            const interval growth = exp(exactly(half_width, bits));
            const interval cosh = (growth + exactly(1, bits) / growth) / 2;
            return exactly(1, bits) / sqrt(exactly(x, bits) + (exactly(1, bits) - cosh) / 2);
          }};
}

/// -(1/4) b^(-1/2) (1 + cos t)(a + (a+2) b X)/(X (a + b X))^(3/2), X = ((1+u) - (1-u) cos t)/2: dG/du is its integral. On the strip |X| <= above,
/// Re X >= below, |1 + cos t| <= 1 + cosh H, and |X (a + b X)| >= below (a + b below).
periodic_integrand slope_integrand(const rational& a, const rational& b, const rational& u) {
  const rational slope((a + 2) * b);
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
            const interval growth = exp(exactly(half_width, bits));
            const interval cosh = (growth + exactly(1, bits) / growth) / 2;
            const interval product = x.below * (exactly(a, bits) + exactly(b, bits) * x.below);
            const interval numerator =
                (exactly(1, bits) + cosh) * (exactly(a, bits) + exactly(slope, bits) * x.above);
            return numerator / (sqrt(exactly(b, bits)) * product * sqrt(product) * 4);
          }};
}

// ---------------------------------------------------------------------------------------------
// The sweep

constexpr long cells = 64;
constexpr long sweep_bits = 96;
/// Units of a comparison of two boxes.
constexpr long units_of_two_boxes = 300;

struct box {
  range p;
  range r;
  range u;
};

bool have_common_inside(const range& x, const range& y) {
  return x.lower < y.upper && y.lower < x.upper;
}

/// cos^2 at k pi/(2 cells), k = 0 ... cells.
std::vector<interval> squared_cosines(precision bits) {
  std::vector<interval> values;
  values.reserve(cells + 1);
  for (long k = 0; k <= cells; ++k) {
    values.push_back(square(sin_cos(pi(bits) * k / (2 * cells)).cosine));
  }
  return values;
}

/// cos^2 t (sigma^(-1/2) + r u sigma^(-3/2)).
interval sweep_integrand(const interval& cos_squared, const interval& sigma, const interval& r_u) {
  return cos_squared / sqrt(sigma) * (exactly(1, sigma.bits()) + r_u / sigma);
}

/// A lower bound of W = integral over (0, pi/2) of cos^2 t (sigma^(-1/2) + r u sigma^(-3/2)) dt, sigma = u + p (1-u) cos^2 t, on a box: on every cell the
/// least cos^2 outside, the greatest sigma, which increases in u, in p and in cos^2, and the least r u.
interval lower_bound(const box& b, const std::vector<interval>& cosines) {
  const precision& bits = cosines.front().bits();
  const interval r_u = exactly(rational(b.r.lower * b.u.lower), bits);
  interval sum = exactly(0, bits);
  for (std::size_t k = 0; k < cells; ++k) {
    const interval sigma = exactly(b.u.upper, bits) +
                           exactly(rational(b.p.upper * (1 - b.u.upper)), bits) * cosines[k];
    sum = sum + sweep_integrand(cosines[k + 1], sigma, r_u);
  }
  return sum * pi(bits) / (2 * cells);
}

/// An enclosure of W at a point with u > 0: on every cell cos^2 and sigma lie between their values at its ends.
interval enclosure_at(const rational& p, const rational& r, const rational& u, precision bits) {
  const std::vector<interval> cosines = squared_cosines(bits);
  interval sum = exactly(0, bits);
  for (std::size_t k = 0; k < cells; ++k) {
    const interval c = hull(cosines[k], cosines[k + 1]);
    const interval sigma = exactly(u, bits) + exactly(rational(p * (1 - u)), bits) * c;
    sum = sum + sweep_integrand(c, sigma, exactly(rational(r * u), bits));
  }
  return sum * pi(bits) / (2 * cells);
}

box read_box(const place& where) {
  if (where.size() != 3) where.malformed("it must be three pairs of ends");
  std::array<range, 3> sides;
  for (std::size_t i = 0; i < 3; ++i) {
    const place side = where.at(i);
    if (side.size() != 2) side.malformed("it must be a pair of ends");
    sides[i] = {side.at(0).fraction(), side.at(1).fraction()};
    if (bit_length(sides[i].lower) + bit_length(sides[i].upper) > 256) {
      side.malformed("its ends have more than 256 bits");
    }
    if (sides[i].lower < 0) side.at(0).refute("it is below 0");
    if (sides[i].upper > 1) side.at(1).refute("it is above 1");
    if (sides[i].lower >= sides[i].upper) side.refute("its ends are not in order");
  }
  return {sides[0], sides[1], sides[2]};
}

/// That W > 3/4 on every box, and that the boxes cover [0,1]^3: no two have an inner point in common, and their volumes add up to 1.
std::size_t check_sweep(const place& sweep) {
  constexpr std::size_t most_boxes = 4096;
  sweep.expect_keys({"bound", "boxes"});
  sweep["bound"].expect_text("3/4");
  const place list = sweep["boxes"];
  if (list.size() > most_boxes) list.not_checkable("it has more than 4096 boxes");
  const precision bits(sweep_bits, sweep.work());
  const std::vector<interval> cosines = squared_cosines(bits);
  std::vector<box> boxes;
  boxes.reserve(list.size());
  rational volume(0);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const box b = read_box(list.at(i));
    const budget::at here = list.at(i).working();
    sweep.work().spend(units_of_two_boxes * static_cast<long>(1 + boxes.size()));
    for (std::size_t j = 0; j < boxes.size(); ++j) {
      if (have_common_inside(b.p, boxes[j].p) && have_common_inside(b.r, boxes[j].r) &&
          have_common_inside(b.u, boxes[j].u)) {
        list.at(i).refute("it overlaps box " + std::to_string(j));
      }
    }
    try {
      if (!(lower_bound(b, cosines) - exactly(rational(3, 4), bits)).is_positive()) {
        list.at(i).refute("the bound is not shown on it");
      }
    } catch (const undecided&) {
      list.at(i).refute("the bound is not shown on it");
    }
    volume += (b.p.upper - b.p.lower) * (b.r.upper - b.r.lower) * (b.u.upper - b.u.lower);
    boxes.push_back(b);
  }
  if (volume != 1) list.refute("the boxes do not cover [0,1]^3");
  return boxes.size();
}

/// d(h^2)/du, expanded: with X = u + (1-u) k, k = y^2, N = a (1 - bX)^2 and D = (1-k) X (a + bX), (N' D - N D')/D^2 is
/// -a (1 - bX)(a + (a+2) b X)/(X (a + bX))^2.
bool identity_holds() {
  const polynomial x = polynomial::read("u+(1-u)*k");
  const auto in_x = [&](const char* text) { return polynomial::read(text).with('x', x); };
  const polynomial n = in_x("a*(1-b*x)^2");
  const polynomial d = in_x("(1-k)*x*(a+b*x)");
  return n.derivative('u') * d - n * d.derivative('u') == in_x("-a*(1-b*x)*(a+(a+2)*b*x)*(1-k)^2");
}

}  // namespace

// ---------------------------------------------------------------------------------------------
// beta

void check_beta(examination& e) {
  e.read_no_inputs();
  const range steps = check_agm_bracket(e);
  const auto equation = [](const rational& x, precision bits) {
    return agm_with_sum(sqrt(exactly(rational(1 + x), bits)), sqrt(exactly(x, bits)))
               .mean.scaled(1) -
           exactly(1, bits);
  };
  const range beta = e.root_number("beta", false, equation);
  if (steps.lower < beta.lower || beta.upper < steps.upper) {
    e.witness("scale").refute("the bracket of the steps is wider than the number's enclosure");
  }

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
  // f' = M (x + 1/2 - S)/(2 x (1+x)), S the sum of 2^(n-1) c_n^2 over n >= 1: of f = agm - 1/2. In parts of the box, as intervals that occur
  // several times in a formula make it wide.
  const auto derivative = [&](precision bits) {
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
  };
  const range slope = examination::decimals(newton["derivative"], derivative);
  e.fact(
      "interval Newton maps its box into itself with a derivative that is not 0: exactly one root "
      "in the "
      "box",
      [&](precision bits) -> tri {
        const precision more = bits + bit_length(image.lower) + bit_length(image.upper);
        const interval at_lower = equation(image.lower, more);
        const interval at_upper = equation(image.upper, more);
        if (slope.lower <= 0 || at_lower.is_positive() || at_upper.is_negative()) return false;
        if (!at_lower.is_negative() || !at_upper.is_positive()) return std::nullopt;
        // The step from the box's middle, for f = agm - 1/2, which is half of the equation's function.
        const precision w = more + bit_length(box.lower) + bit_length(box.upper);
        const rational middle((box.lower + box.upper) / 2);
        const interval step =
            exactly(middle, w) -
            equation(middle, w) / 2 / interval::between(slope.lower, slope.upper, w);
        if (!overlaps(step, box.lower, box.upper)) return false;
        return is_inside(step, box.lower, box.upper) ? tri(true) : std::nullopt;
      });

  const place quadrature = e.witness("quadrature");
  constexpr long most_quadrature_digits = 100;
  const long digits = std::min(e.digits(), most_quadrature_digits);
  quadrature.expect_keys({"below", "above"});
  const place statement = e.fact(
      "by certified quadrature, which uses no AGM: the integral over (0, pi/2) of (x + cos^2 "
      "t)^(-1/2) "
      "exceeds pi at the first " +
          std::to_string(digits) +
          " digits of beta and is below pi one unit of the last place higher",
      enclosed);
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
    interval integral = check_integral(side, inverse_root(x), 0);
    examination::decimals(side["integral"], [&](long) { return integral; });
    const interval difference = integral - pi(integral.bits()).scaled(1);
    if (is_below ? !difference.is_positive() : !difference.is_negative()) {
      statement.refute(std::string("the integral ") + (is_below ? "below" : "above") +
                       " does not show it");
    }
  }
}

// ---------------------------------------------------------------------------------------------
// The sign of dF/du

void check_sign_dF_du(examination& e) {
  e.read_motion();
  const rational& a = e.a();
  const rational& b = e.b();
  const rational& u = e.u();
  const range value =
      e.number("dF_du", [&](precision bits) { return half_phase_slope(a, b, u, bits); });
  e.fact("at the given a, b, u: dF(-bu,u)/du < 0 (elliptic integrals by AGM)", value.upper < 0,
         enclosed);

  const place quadrature = e.witness("quadrature");
  if (quadrature.has("note")) {
    quadrature.expect_keys({"verdict", "rule", "note"});
    quadrature["verdict"].expect_text("not certified");
    quadrature["rule"].expect_text("periodic trapezoid, 2n nodes (2k+1) pi/(2n)");
    quadrature["note"].expect_text(
        "u is so near 0 that the rule would need more than 200000 nodes: this route is left out, "
        "and the "
        "AGM stands alone");
    // The strip's half-width is below artanh sqrt u < 2 sqrt u: for u above q^2 the rule has the digits with fewer nodes.
    const rational q(4 * std::min(e.digits(), 1000L) + 200 + e.input_bits(), 250'000);
    if (u > q * q) quadrature["note"].refute("u is not so near 0");
  } else {
    quadrature.expect_keys(
        {"verdict", "rule", "nodes", "half_width", "supremum", "truncation_error", "value"});
    quadrature["verdict"].expect_text("certified");
    interval integral = check_integral(quadrature, slope_integrand(a, b, u), e.input_bits());
    const range given = examination::decimals(quadrature["value"], [&](long) { return integral; });
    constexpr long most_quadrature_digits = 1000;
    quadrature["value"]["digits"].expect_whole(std::min(e.digits(), most_quadrature_digits));
    e.fact("the paper's eq. (44) by certified quadrature, to " +
               std::to_string(std::min(e.digits(), most_quadrature_digits)) +
               " digits, overlaps the value by AGM and is negative",
           overlaps(integral, value.lower, value.upper) && given.upper < 0, enclosed);
  }

  const place identity = e.witness("identity");
  identity.expect_keys({"points", "degrees"});
  identity["points"].expect_whole(528);
  identity["degrees"].expect_text(
      "cleared of denominators both sides are polynomials of degree at most 2 in a, 3 in b, 3 in u "
      "and 10 "
      "in y; they agree on a grid of 3 x 4 x 4 x 11 points, hence everywhere");
  const bool holds = identity_holds();
  e.fact(
      "the u-derivative of the integrand of eq. (43) is the integrand of eq. (44): d(h^2)/du = -a "
      "(1 - "
      "bX)(a + (a+2) b X)/(X (a + bX))^2, equal in exact rationals at 528 points",
      holds);
  e.fact(
      "for all a > 0, 0 < b < 1, 0 < u <= 1: on 0 < y < 1 every factor of the integrand of eq. "
      "(44) is "
      "positive (X = u + (1-u) y^2 lies in (0, 1], 1 - y^2 > 0), and its sign is minus",
      holds &&
          letter_ranges("a > 0, b > 0, x > 0").show_sign(polynomial::read("a+(a+2)*b*x"), true));

  const std::size_t boxes = check_sweep(e.witness("sweep"));
  e.fact(
      "interval sweep: -u sqrt(b(a+b)) dF/du > 3/4 on all of [0,1]^3 in the variables a/(a+b), "
      "b(1+a)/(a+b), u (" +
          std::to_string(boxes) + " boxes)",
      true, enclosed);
  const interval integral = enclosure_at(rational(a / (a + b)), rational(b * (1 + a) / (a + b)), u,
                                         precision(sweep_bits + e.input_bits(), e.work()));
  e.fact("the sweep's integral at the given a, b, u holds the value above",
         [&](precision bits) -> tri {
           const interval factor = -exactly(u, bits) * sqrt(exactly(rational(b * (a + b)), bits));
           const interval W = factor * interval::between(value.lower, value.upper, bits);
           if (is_inside(W, integral.lower(), integral.upper())) return true;
           if (!overlaps(W, integral.lower(), integral.upper())) return false;
           return std::nullopt;
         });
}

}  // namespace polhode::checker
