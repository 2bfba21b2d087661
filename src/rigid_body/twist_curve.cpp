#include "polhode/rigid_body/twist_curve.hpp"

#include <optional>
#include <utility>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "polhode/elliptic/jacobi.hpp"
#include "polhode/rigid_body/half_phase.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "polhode/roots/newton.hpp"
#include "rigid_body/has_digits.hpp"
#include "rigid_body/quarter.hpp"

namespace polhode {
namespace {

using detail::quarter;
using detail::quarters;

// ---------------------------------------------------------------------------------------------
// The branch

/// 2^exponent covers the sizes that a ball may have.
long log2_of(const ball& x) { return static_cast<long>(x.magnitude_upper().log2_floor()) + 1; }

struct branch {
  integer n;
  bool late = false;   // r is in the second half, in time, of its quarter: solve from its end
  precision lost = 0;  // bits that r, or its distance from the end, has lost
};

ball half_phase(const motion& of, precision p) { return scale(of.phase(p), -1); }

/// r = pi - n Q.
ball rest_of(const motion& of, const integer& n, precision p) {
  return n == 0 ? pi(p) : pi(p) - n * half_phase(of, p);
}

/// Nothing where n is not decided.
std::optional<branch> branch_of(const motion& of) {
  if (of.regime() == regime::separatrix) return branch{};
  const precision most =
      2048 + 8 * (size_in_bits(of.a()) + size_in_bits(of.b()) + size_in_bits(of.c()));
  constexpr precision least = 64;
  for (precision p = least; p <= most; p *= 2) {
    const ball q = half_phase(of, p);
    const ball whole = floor(pi(p) / q + rational(1, 2));
    if (!whole.is_exact()) continue;
    branch result;
    result.n = numerator(lower_rational(whole));
    const ball r = pi(p) - result.n * q;
    const ball left = scale(q, -1) - abs(r);
    // Enough of it to begin with.
    constexpr int enough = 20;
    if (!certainly_positive(left) || left.radius() > scale(left.magnitude_lower(), -enough))
      continue;
    const quarter<ball> way(of, p);
    result.late = certainly_positive(abs(r) - way.phase(1 / sqrt(sqrt(way.m1()))));
    result.lost = std::max(0L, log2_of(result.n * q) - log2_of(result.late ? left : q)) + 8;
    return result;
  }
  return std::nullopt;
}

// ---------------------------------------------------------------------------------------------
// The root

/// The phase at w, or from the end of the quarter at w', less `target`, so that it increases; and
/// its derivative.
template <class T>
T excess_at(const quarter<T>& way, const T& w, bool late, const T& target) {
  using std::sinh;
  return late ? T(target - way.phase(way.from_end(sinh(w)))) : T(way.phase(sinh(w)) - target);
}
template <class T>
T slope_in_w(const quarter<T>& way, const T& w, bool late) {
  using std::sinh;
  const T s = sinh(w);
  return way.rate_in_w(late ? way.from_end(s) : s, s);
}

int side_of(double x) { return (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0); }
int side_of(const ball& x) { return certainly_positive(x) ? 1 : (certainly_negative(x) ? -1 : 0); }
double centre(double x) { return x; }
ball centre(const ball& x) { return x.middle(); }
magnitude size_of(double x) { return ball::exactly(x).magnitude_upper(); }
magnitude size_of(const ball& x) { return x.magnitude_upper(); }

constexpr int bits_of_search = 30;
/// Newton's last step about doubles them, up to the rounding of doubles.
constexpr int bits_of_quick_root = 46;

/// A number near the root between the two, by Newton's method kept between them. It proves nothing.
template <class T, class F, class Slope>
T approximate_root(const F& f, const Slope& slope, T low, T high) {
  using std::sqrt;
  T w = low;
  constexpr int most_steps = 200;
  for (int i = 0; i < most_steps; ++i) {
    const T value = f(w);
    if (side_of(value) == 0) break;  // or a NaN
    (side_of(value) > 0 ? high : low) = w;
    const T step = centre(T(value / slope(w)));
    w = centre(T(w - step));
    if (size_of(step) <= scale(size_of(w), -bits_of_search)) break;
    if (side_of(T(w - low)) <= 0 || side_of(T(high - w)) <= 0) w = centre(T(sqrt(low * high)));
  }
  return w;
}

/// The same in double, or nothing where it has no room for the numbers; a start where few bits are
/// lost.
std::optional<ball> quick_root(const quarters& ways, bool late, const ball& target, const ball& low,
                               const ball& high) {
  const auto number = [](const ball& x) { return midpoint(x).convert_to<double>(); };
  constexpr double most = 100;
  constexpr double least = 1e-100;
  const quarter<double> way = ways.in_double();
  // On the separatrix m1 is 0.
  const bool has_room =
      number(low) > least && number(high) < most && (way.m1() > 1e-100 || (way.m1() == 0 && !late));
  if (!has_room) return std::nullopt;
  const double rest = number(target);
  const auto w = approximate_root<double>([&](double x) { return excess_at(way, x, late, rest); },
                                          [&](double x) { return slope_in_w(way, x, late); },
                                          number(low), number(high));
  if (!(w > least && w < most)) return std::nullopt;
  return ball::exactly(w);
}

/// S at phi = r, or undefined; its relative error is about 2^-p, or its absolute one where S is
/// near 0. The proof's evaluations are counted, not those of the search.
ball find_s(const motion& of, quarters& ways, const branch& at, precision p, work_count& work) {
  const auto way_at = [&](const ball& x) -> const quarter<ball>& { return ways.at(x.precision()); };
  const precision coarse = 64 + at.lost;
  const ball r = rest_of(of, at.n, coarse);
  const bool backwards = certainly_negative(r);
  const auto target = [&](precision q) {
    const ball rest = rest_of(of, at.n, q);
    return backwards ? -rest : rest;
  };
  // The unknown of the equation is w', or w and about 1/kappa: near 0 an error of kappa w is one of
  // epsilon.
  const quarter<ball>& way = ways.at(coarse);
  const exact_real b_by_a = of.b() / of.a();
  const long unit = -log2_of(way.tangent(ball(1, coarse)));
  const ball shift = at.late ? ball(0, coarse) : scale(ball(1, coarse), unit);
  const auto excess = [&](const ball& x) {
    const ball w = x.with_precision(x.precision() + at.lost) - shift;
    const quarter<ball>& here = way_at(w);
    if (of.regime() != regime::separatrix)
      return excess_at(here, w, at.late, target(w.precision()));
    // In closed form: t - arctan(sqrt(b/a) tanh w), w = lambda t = sqrt(ab) t.
    const ball root = sqrt(b_by_a.at(w.precision()));
    return w / here.lambda() - atan(root * tanh(w)) - pi(w.precision());
  };
  const auto slope = [&](const ball& x) { return slope_in_w(way_at(x), ball(x - shift), at.late); };

  const ball span = at.late ? scale(half_phase(of, coarse), -1) - abs(r) : abs(r);
  // By (4) and (5), where m1 S^2 <= 1 or m1 sinh^2 w' <= 1: the slope is from (1-b)/(lambda sqrt 2)
  // to 1/lambda.
  const ball low = span * way.lambda();
  const ball high = 2 * low / (1 - of.b()).at(coarse);
  constexpr long bits_of_exponents = 31;  // of MPFR's; S = sinh w would be beyond them
  if (!high.is_bounded() || log2_of(low) > bits_of_exponents) return ball::undefined(p);
  const precision bits = coarse + std::max(0L, log2_of(high));
  ball start(0, bits);
  magnitude uncertainty = high.magnitude_upper();
  int bits_of_start = bits_of_search;
  if (!contains_zero(r)) {
    constexpr precision most_lost = 16;
    const auto quick =
        at.lost <= most_lost ? quick_root(ways, at.late, abs(r), low, high) : std::nullopt;
    start = quick ? quick->with_precision(bits)
                  : approximate_root<ball>([&](const ball& w) { return excess(w + shift); },
                                           [&](const ball& w) { return slope(w + shift); },
                                           low.with_precision(bits).middle(),
                                           high.with_precision(bits).middle());
    uncertainty = low.radius();
    if (quick) bits_of_start = bits_of_quick_root - static_cast<int>(at.lost);
  }
  const precision goal = p + std::max(0L, at.late ? 0 : log2_of(start) - unit);
  const ball x = start + shift;
  constexpr int least_bits_of_start = 6;
  constexpr int fewer = 8;
  for (int bits_now = bits_of_start; bits_now >= least_bits_of_start; bits_now -= fewer) {
    // The step that maps the box into itself proves a root in it; there is no other, as phi
    // increases with w.
    const magnitude radius = std::max(scale(start.magnitude_upper(), -bits_now),
                                      scale(uncertainty, bits_of_start - bits_now));
    const root_enclosure found = refine_root(excess, slope, x.enlarged(radius), goal);
    work.integrals += found.evaluations_of_f;
    work.newton_steps += found.evaluations_of_derivative;
    if (found.verdict != root_verdict::unique) continue;
    const ball sine = sinh(found.root - shift);
    const ball s = at.late ? way_at(sine).from_end(sine) : sine;
    return backwards ? -s : s;
  }
  return ball::undefined(p);
}

// ---------------------------------------------------------------------------------------------
// What S says

bool is_odd(const integer& n) { return n % 2 != 0; }

/// epsilon, by an angle between 0 and pi whose smallness is not lost.
ball epsilon_at(const quarter<ball>& way, const ball& s, regime r, const integer& n) {
  const precision p = s.precision();
  ball tangent = way.tangent(s);
  if (r == regime::oscillating) {
    tangent = sqrt(way.eta()) * tangent / sqrt(1 + way.m1() * square(s));
    return atan2(ball(1, p), is_odd(n) ? -tangent : tangent);
  }
  // pi/2 - arctan T - n pi, and arctan T = -arctan(-T).
  if (certainly_negative(s)) return -atan2(ball(1, p), -tangent) - (n - 1) * pi(p);
  return atan2(ball(1, p), tangent) - n * pi(p);
}

/// d epsilon/dc. On its branch psi_1(c) solves n Q(c) + Phi(c, psi_1) = pi, Phi(c,psi) = F(c, cos^2
/// psi)/2 with the sign of psi, whose derivative in psi is h = (1 - b x)/sqrt((a + b x)(c + b x)).
/// So
///   d epsilon/dc = -(+-1) dpsi_1/dc = +-(n Q' + dPhi/dc)/h,
/// the minus sign where the body oscillates and n is odd. With the letters of (1), (2), and z = 1
/// when oscillating, 1 + m1 S^2 when rotating (the one that stands for c + b x),
///   dPhi/dc = -(1/2) sqrt(eta/(a+b)) (b+c)^(-3/2) T [ (1-b) R_F + (b (1+c) eta T^2/(3 (b+c)))
///   R_D(.,.,z) ],
/// where R_F and R_D have the arguments 1, 1+S^2, 1+m1 S^2, z the last of R_D. Proof. By t + 1 =
/// (1-u)/(1-x) (montgomery_phase.hpp) F is sqrt((1-u)/((a+b)(b+c))) times the integral over t > 0
/// of (1 - b x)/sqrt((t+X)(t+Y)(t+Z)), with c + b x = (b+c)(t+Z)/(t+1). Differentiating F's
/// integrand in c multiplies it by -1/(2 (c + b x)) = -(t+1)/(2 (b+c)(t+Z)), and (1 - b x)(t+1) =
/// (1-b)(t+1) + b (1-u) = (1-b)(t+Z) + b (1-u)(1+c)/(b+c), since 1 - Z = b (1-u)/(b+c). The
/// integral of 1/sqrt(...) is 2 R_F, that of 1/((t+Z) sqrt(...)) is (2/3) R_D(X,Y,Z); then
/// homogeneity, as for (3), with R_D of the degree -3/2.
ball slope_at(const body& rigid, const motion& of, const quarter<ball>& way, const ball& s,
              const integer& n) {
  const precision p = s.precision();
  const bool oscillating = of.regime() == regime::oscillating;
  const exact_real& b = of.b();
  const exact_real& c = of.c();
  const exact_real total = of.a() + b;
  const exact_real end = b + c;
  const ball one(1, p);
  const ball s2 = square(s);
  const ball other = 1 + way.m1() * s2;
  const ball& z = oscillating ? one : other;
  const ball tangent = way.tangent(s);
  const ball t2 = square(tangent);
  const ball rf = carlson_rf(one, 1 + s2, other);
  const ball rd = carlson_rd(oscillating ? other : one, 1 + s2, z);
  const ball sum = (1 - b).at(p) * rf + (b * (1 + c) / (3 * end)).at(p) * way.eta() * t2 * rd;
  ball change = -scale(sqrt(way.eta() / (total * end * end * end).at(p)) * tangent * sum, -1);
  if (n != 0) {
    const ball whole = oscillating ? -oscillating_half_phase_slope(
                                         rigid, {of.turning_point().at(p), (end / b).at(p)}) /
                                         b.at(p)
                                   : rotating_half_phase_slope(rigid, c.at(p));
    change += n * whole;
  }
  const ball inverse_h = sqrt((total * end).at(p) * ((1 + s2) * z)) / (way.rate(s) * (1 + t2));
  const ball result = change * inverse_h;
  return oscillating && is_odd(n) ? -result : result;
}

/// No enclosure, since the precision does not suffice.
twist undecided(const motion& of, precision p) {
  twist result;
  result.why = reason::precision_limit;
  result.motion = of.regime();
  result.epsilon = result.slope = ball::undefined(p);
  return result;
}

twist twist_on(const body& rigid, const motion& of, quarters& ways, const branch& at, precision p,
               with_slope slope) {
  constexpr precision guard = 32;
  twist result = undecided(of, p);
  result.branch = at.n;
  const ball s = find_s(of, ways, at, p + guard, result.work);
  if (!s.is_bounded()) return result;
  const quarter<ball>& way = ways.at(s.precision());
  result.epsilon = epsilon_at(way, s, of.regime(), at.n).with_precision(p + guard);
  if (slope == with_slope::yes) {
    result.slope = slope_at(rigid, of, way, s, at.n).with_precision(p + guard);
  }
  if (!result.epsilon.is_bounded()) return result;
  result.verdict = status::certified;
  result.why = reason::none;
  return result;
}

}  // namespace

twist twist_at(const body& rigid, const rational& c, precision p, with_slope slope) {
  const motion of(rigid, c);
  of.refuse_equilibrium();
  const auto at = branch_of(of);
  if (at) {
    quarters ways(of);
    return twist_on(rigid, of, ways, *at, p, slope);
  }
  return undecided(of, p);
}

twist twist_to_digits(const body& rigid, const rational& c, long digits, with_slope slope) {
  return twist_to_digits(rigid, motion(rigid, c), digits, slope);
}

twist twist_to_digits(const body& rigid, const motion& of, long digits, with_slope slope) {
  of.refuse_equilibrium();
  twist result = undecided(of, 64);
  const auto at = branch_of(of);
  if (at) {
    const precision most = ample_guard(digits) + 4 * (at->lost + size_in_bits(of.c()));
    const precision needed = bits_for_digits(digits);
    quarters ways(of);
    for (precision guard = 0; guard <= most; guard = 2 * guard + 32) {
      const work_count before = result.work;
      result = twist_on(rigid, of, ways, *at, needed + guard, slope);
      result.work += before;
      if (result.verdict != status::certified) break;
      if (detail::has_digits(result.epsilon, digits) &&
          (slope == with_slope::no || detail::has_digits(result.slope, digits))) {
        return result;
      }
    }
  }
  result.verdict = status::not_certified;
  result.why = reason::precision_limit;
  result.epsilon = result.slope = ball::undefined(64);
  return result;
}

certain_number defect_to_digits(const body& rigid, const rational& c, long digits) {
  twist found = twist_to_digits(rigid, c, digits, with_slope::no);
  certain_number result;
  static_cast<certification&>(result) = static_cast<const certification&>(found);
  result.enclosure = std::move(found.epsilon);
  result.work = found.work;
  return result;
}

// ---------------------------------------------------------------------------------------------
// The limit

ball limit_defect(const rational& chi, const rational& beta, precision p) {
  if (chi <= 0) throw input_error("chi = " + to_text(chi) + ": it must be positive (a b)");
  if (beta <= -1) throw input_error("beta = " + to_text(beta) + ": it must be above -1 (c/b)");
  using parameter = elliptic_parameter<ball>;
  if (beta >= 0) {
    const ball u = pi(p) * sqrt(ball(rational(chi * (1 + beta)), p));
    const auto m = parameter::with_complement(ball(rational(beta / (1 + beta)), p));
    return scale(pi(p), -1) - jacobi_am(u, m);
  }
  // The reciprocal parameter is 1 + beta, its complement -beta.
  const ball u = pi(p) * sqrt(ball(chi, p));
  const auto w = jacobi_elliptic(u, parameter::with_complement(ball(rational(-beta), p)));
  return atan2(w.dn, w.sn * sqrt(ball(rational(1 + beta), p)));
}

certain_number limit_defect_to_digits(const rational& chi, const rational& beta, long digits) {
  // Small as e^(-pi sqrt chi) where beta is near 0.
  const ball size = pi(64) * sqrt(ball(chi > 0 ? chi : rational(1), 64));
  const precision lost = 2 * static_cast<precision>(static_cast<long>(
                                 lower_rational(floor(min(size, ball(1L << 24, 64))))));
  return number_to_digits([&](precision p) { return limit_defect(chi, beta, p); }, digits,
                          ample_guard(digits) + 2 * lost + 4 * size_in_bits(beta));
}

}  // namespace polhode
