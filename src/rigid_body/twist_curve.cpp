#include "polhode/rigid_body/twist_curve.hpp"

#include <optional>
#include <utility>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "polhode/elliptic/jacobi.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "polhode/roots/newton.hpp"
#include "rigid_body/half_phase.hpp"
#include "rigid_body/raised_precision.hpp"

namespace polhode {
namespace {

/// The motion on its first quarters, by S = sinh w = tan am(lambda t), t the time from the middle of the twist in I_y/J:
///
///                oscillating               rotating, separatrix
///   kappa^2      (a+b)/(a-c)               (a+b)/a
///   m1 = 1 - m   -c (a+b)/(b (a-c))        c (a+b)/(a (b+c))
///   lambda^2     b (a-c)                   a (b+c)
///   eta          (b+c)/b                   1
///   tan psi      sqrt(eta) T/sqrt(1+m1 S^2)   T              with T = kappa S
///
/// and in both, with x = cos^2 psi,
///   1 - x = eta T^2/(1+T^2),   a + b x = (a+b)(1+S^2)/(1+T^2),                                               (1)
///   {x, (c + b x)/(b+c)} = {(1+m1 S^2)/(1+T^2), 1/(1+T^2)} when oscillating, the other way round when rotating.  (2)
/// Proof of (1), (2): eta = 1 + c/b is 1 - u for the turning point u = -c/b; put 1 - x = eta sin^2 alpha, T = tan alpha (alpha
/// = psi when rotating). Then c + b x = (b+c) cos^2 alpha when oscillating; the rest is multiplying out, with
/// m1 = kappa^2 (-c/b), kappa^2 c/(b+c).
///
/// The phase from psi = 0 on is F(c,x)/2 = (montgomery_phase.hpp) sqrt((1-x)/((a+b)(b+c))) [(1-b) R_F + (b (1-x)/3) R_J] at
/// the arguments x, (a+bx)/(a+b), (c+bx)/(b+c). R_F and R_J are symmetric in them and homogeneous, of the degrees -1/2 and -3/2;
/// multiplied by 1 + T^2 they are 1, 1+S^2, 1+m1 S^2, and so
///   phi = (S/lambda) [ (1-b) R_F(1, 1+S^2, 1+m1 S^2) + (b eta T^2/3) R_J(1, 1+S^2, 1+m1 S^2, 1+T^2) ],      (3)
/// odd in S, with nothing that cancels; lambda t = S R_F(1, 1+S^2, 1+m1 S^2), which is F(am | m).
/// Since dphi/dt = sin^2 psi + (I_y/I_x) cos^2 psi = 1 - b x and dw/d(lambda t) = dn/cn with dn/cn = sqrt(1+m1 S^2),
///   dphi/dw = (1 - b x)/(lambda sqrt(1+m1 S^2)).                                                              (4)
/// Counted from the end of the quarter, with w' in the place of w, lambda t becomes K - lambda t and S becomes
/// S = 1/(sqrt(m1) sinh w') (DLMF 22.4.3), and by dn/cn = 1/sn there
///   dphi/dw' = -(1 - b x)/(lambda sqrt(1+m1 sinh^2 w')).                                                      (5)
/// So phi is nearly linear in w up to S = m1^(-1/4), the middle in time, and in w' beyond, however near c is to 0.
class quarter {
 public:
  quarter(const body& rigid, const rational& c, regime motion, precision p)
      : b_(rigid.b(), p), rest_(rational(1 - rigid.b()), p) {
    const rational& a = rigid.a();
    const rational& b = rigid.b();
    const rational total(a + b);
    const bool oscillating = motion == regime::oscillating;
    const rational first(oscillating ? a - c : a);
    const rational second(oscillating ? b : b + c);
    kappa2_ = ball(rational(total / first), p);
    m1_ = ball(rational(abs(c) * total / (first * second)), p);
    lambda_ = sqrt(ball(rational(first * second), p));
    eta_ = ball(oscillating ? rational((b + c) / b) : rational(1), p);
  }

  [[nodiscard]] const ball& m1() const { return m1_; }
  [[nodiscard]] const ball& lambda() const { return lambda_; }
  [[nodiscard]] const ball& eta() const { return eta_; }
  [[nodiscard]] ball tangent(const ball& s) const { return sqrt(kappa2_) * s; }

  /// (3)
  [[nodiscard]] ball phase(const ball& s) const {
    const ball s2 = square(s);
    const ball t2 = kappa2_ * s2;
    const carlson_pair w = carlson_rf_rj(ball(1, s.precision()), 1 + s2, 1 + m1_ * s2, 1 + t2);
    return s / lambda_ * (rest_ * w.rf + b_ * eta_ * t2 / 3 * w.rj);
  }
  /// 1 - b x
  [[nodiscard]] ball rate(const ball& s) const {
    const ball t2 = kappa2_ * square(s);
    return rest_ + b_ * eta_ * t2 / (1 + t2);
  }
  /// The sizes of (4) and (5), the second by sinh w'.
  [[nodiscard]] ball rate_in_w(const ball& s, const ball& sinh_w) const {
    return rate(s) / (lambda_ * sqrt(1 + m1_ * square(sinh_w)));
  }

 private:
  ball b_, rest_, kappa2_, m1_, lambda_, eta_;
};

// ---------------------------------------------------------------------------------------------
// The branch

/// 2^exponent covers the sizes that a ball may have.
long log2_of(const ball& x) { return static_cast<long>(x.magnitude_upper().log2_floor()) + 1; }

struct branch {
  integer n;
  bool late = false;   // r is in the second half, in time, of its quarter: solve from its end
  precision lost = 0;  // bits that r, or its distance from the end, has lost
};

ball half_phase(const body& rigid, const rational& c, precision p) {
  return scale(montgomery_phase(rigid, c, p), -1);
}

/// r = pi - n Q.
ball rest_of(const body& rigid, const rational& c, const integer& n, precision p) {
  return n == 0 ? pi(p) : pi(p) - n * half_phase(rigid, c, p);
}

/// Nothing where n is not decided.
std::optional<branch> branch_of(const body& rigid, const rational& c, regime motion) {
  if (motion == regime::separatrix) return branch{};
  const precision most =
      2048 + 8 * (size_in_bits(rigid.a()) + size_in_bits(rigid.b()) + size_in_bits(c));
  constexpr precision least = 64;
  for (precision p = least; p <= most; p *= 2) {
    const ball q = half_phase(rigid, c, p);
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
    const quarter way(rigid, c, motion, p);
    result.late = certainly_positive(abs(r) - way.phase(1 / sqrt(sqrt(way.m1()))));
    result.lost = std::max(0L, log2_of(result.n * q) - (result.late ? log2_of(left) : 0)) + 8;
    return result;
  }
  return std::nullopt;
}

// ---------------------------------------------------------------------------------------------
// The root

/// f(w) = 0 with f increasing, at any precision.
struct increasing_equation {
  std::function<ball(const ball& w)> f;
  std::function<ball(const ball& w)> slope;
};

/// A number near the root between the two, found by Newton's method within halves. It proves nothing.
ball approximate_root(const increasing_equation& equation, ball low, ball high) {
  ball w = low;
  constexpr int most_steps = 200;
  constexpr int enough = 24;
  for (int i = 0; i < most_steps; ++i) {
    const ball value = equation.f(w);
    if (value.is_undefined() || contains_zero(value)) break;
    (certainly_positive(value) ? high : low) = w;
    const ball step = (value / equation.slope(w)).middle();
    ball next = (w - step).middle();
    const bool near = step.magnitude_upper() <= scale(w.magnitude_lower(), -enough);
    if (!certainly_less(low, next) || !certainly_less(next, high)) next = sqrt(low * high).middle();
    w = next;
    if (near) break;
  }
  return w;
}

/// The root proved, to a relative radius of about 2^-p, or undefined. start is near it, up to `uncertainty`.
ball proved_root(const increasing_equation& equation, const ball& start,
                 const magnitude& uncertainty, precision p) {
  for (const int bits : {20, 12, 6}) {
    const ball box = start.enlarged(std::max(scale(start.magnitude_upper(), -bits), uncertainty));
    const root_enclosure found = refine_root(equation.f, equation.slope, box, p);
    if (found.verdict == root_verdict::unique) return found.root;
  }
  return ball::undefined(p);
}

/// S at phi = r, or undefined; its relative error is about 2^-p, or its absolute one where S is near 0.
ball find_s(const body& rigid, const rational& c, regime motion, const branch& at, precision p) {
  const auto way = [&](const ball& x) { return quarter(rigid, c, motion, x.precision()); };
  const auto rest = [&](const ball& x) { return rest_of(rigid, c, at.n, x.precision()); };
  const precision coarse = 64 + at.lost;
  const ball r = rest_of(rigid, c, at.n, coarse);
  const bool backwards = certainly_negative(r);
  const quarter q(rigid, c, motion, coarse);
  const ball most_rate_inverse = 1 / ball(rational(1 - rigid.b()), coarse);

  increasing_equation equation;
  ball low;
  if (!at.late) {
    equation.f = [=](const ball& w) {
      const ball target = backwards ? -rest(w) : rest(w);
      if (motion != regime::separatrix) return way(w).phase(sinh(w)) - target;
      // In closed form: t - arctan(sqrt(b/a) tanh w), w = lambda t = sqrt(ab) t.
      const ball root = sqrt(ball(rational(rigid.b() / rigid.a()), w.precision()));
      return w / way(w).lambda() - atan(root * tanh(w)) - target;
    };
    equation.slope = [=](const ball& w) {
      const ball s = sinh(w);
      return way(w).rate_in_w(s, s);
    };
    low = abs(r) * q.lambda();
  } else {
    equation.f = [=](const ball& w) {
      const quarter here = way(w);
      return (backwards ? -rest(w) : rest(w)) - here.phase(1 / (sqrt(here.m1()) * sinh(w)));
    };
    equation.slope = [=](const ball& w) {
      const quarter here = way(w);
      const ball from_end = sinh(w);
      return here.rate_in_w(1 / (sqrt(here.m1()) * from_end), from_end);
    };
    low = (scale(half_phase(rigid, c, coarse), -1) - abs(r)) * q.lambda();
  }
  // From (4) and (5), with m1 S^2 <= 1: the slope is from (1-b)/(lambda sqrt 2) to 1/lambda.
  const ball high = 2 * low * most_rate_inverse;
  if (!high.is_bounded()) return ball::undefined(p);
  const bool through_zero = contains_zero(r);
  const precision bits = coarse + std::max(0L, log2_of(high));
  const ball start = through_zero ? ball(0, bits)
                                  : approximate_root(equation, low.with_precision(bits).middle(),
                                                     high.with_precision(bits).middle());
  const magnitude uncertainty = through_zero ? high.magnitude_upper() : high.radius();
  const ball w =
      proved_root(equation, start, uncertainty, p + at.lost + std::max(0L, log2_of(start)));
  if (w.is_undefined()) return w;
  const ball s = at.late ? 1 / (sqrt(way(w).m1()) * sinh(w)) : sinh(w);
  return backwards ? -s : s;
}

// ---------------------------------------------------------------------------------------------
// What S says

bool is_odd(const integer& n) { return n % 2 != 0; }

/// epsilon, by an angle between 0 and pi whose smallness is not lost.
ball epsilon_at(const quarter& way, const ball& s, regime motion, const integer& n) {
  const precision p = s.precision();
  ball tangent = way.tangent(s);
  if (motion == regime::oscillating) {
    tangent = sqrt(way.eta()) * tangent / sqrt(1 + way.m1() * square(s));
    return atan2(ball(1, p), is_odd(n) ? -tangent : tangent);
  }
  // pi/2 - arctan T - n pi, and arctan T = -arctan(-T).
  if (certainly_negative(s)) return -atan2(ball(1, p), -tangent) - (n - 1) * pi(p);
  return atan2(ball(1, p), tangent) - n * pi(p);
}

/// d epsilon/dc. On its branch psi_1(c) solves n Q(c) + Phi(c, psi_1) = pi, Phi(c,psi) = F(c, cos^2 psi)/2 with the sign of psi, whose
/// derivative in psi is h = (1 - b x)/sqrt((a + b x)(c + b x)). So
///   d epsilon/dc = -(+-1) dpsi_1/dc = +-(n Q' + dPhi/dc)/h,
/// the minus sign where the body oscillates and n is odd. With the letters of (1), (2), and z = 1 when oscillating, 1 + m1 S^2
/// when rotating (the one that stands for c + b x),
///   dPhi/dc = -(1/2) sqrt(eta/(a+b)) (b+c)^(-3/2) T [ (1-b) R_F + (b (1+c) eta T^2/(3 (b+c))) R_D(.,.,z) ],
/// where R_F and R_D have the arguments 1, 1+S^2, 1+m1 S^2, z the last of R_D.
/// Proof. By t + 1 = (1-u)/(1-x) (montgomery_phase.hpp) F is sqrt((1-u)/((a+b)(b+c))) times the integral over t > 0 of
/// (1 - b x)/sqrt((t+X)(t+Y)(t+Z)), with c + b x = (b+c)(t+Z)/(t+1). Differentiating F's integrand in c multiplies it by
/// -1/(2 (c + b x)) = -(t+1)/(2 (b+c)(t+Z)), and (1 - b x)(t+1) = (1-b)(t+1) + b (1-u) = (1-b)(t+Z) + b (1-u)(1+c)/(b+c), since
/// 1 - Z = b (1-u)/(b+c). The integral of 1/sqrt(...) is 2 R_F, that of 1/((t+Z) sqrt(...)) is (2/3) R_D(X,Y,Z); then homogeneity,
/// as for (3), with R_D of the degree -3/2.
ball slope_at(const body& rigid, const rational& c, regime motion, const quarter& way,
              const ball& s, const integer& n) {
  const precision p = s.precision();
  const bool oscillating = motion == regime::oscillating;
  const rational& b = rigid.b();
  const rational total(rigid.a() + b);
  const rational end(b + c);
  const ball one(1, p);
  const ball s2 = square(s);
  const ball other = 1 + way.m1() * s2;
  const ball& z = oscillating ? one : other;
  const ball tangent = way.tangent(s);
  const ball t2 = square(tangent);
  const ball rf = carlson_rf(one, 1 + s2, other);
  const ball rd = carlson_rd(oscillating ? other : one, 1 + s2, z);
  const ball sum = rational(1 - b) * rf + rational(b * (1 + c) / (3 * end)) * way.eta() * t2 * rd;
  ball change =
      -scale(sqrt(way.eta() / ball(rational(total * end * end * end), p)) * tangent * sum, -1);
  if (n != 0) {
    const ball whole = oscillating
                           ? -half_phase_slope({rigid.a(), b, rational(-c / b)}, p) / ball(b, p)
                           : detail::rotating_half_phase_slope(rigid, ball(c, p));
    change += n * whole;
  }
  const ball inverse_h = sqrt(rational(total * end) * ((1 + s2) * z)) / (way.rate(s) * (1 + t2));
  const ball result = change * inverse_h;
  return oscillating && is_odd(n) ? -result : result;
}

/// As montgomery_phase refuses, but for the separatrix.
regime moving_regime(const body& rigid, const rational& c) {
  const regime motion = regime_of(rigid, c);
  if (motion != regime::equilibrium_x && motion != regime::equilibrium_z) return motion;
  throw input_error(
      "c = " + to_text(c) + ": " + to_text(motion) +
      ", where the angular momentum does not move in the body; give c between -b and a, "
      "ends excluded");
}

twist twist_on(const body& rigid, const rational& c, regime motion, const branch& at, precision p,
               with_slope slope) {
  constexpr precision guard = 32;
  twist result;
  result.motion = motion;
  result.branch = at.n;
  result.epsilon = result.slope = ball::undefined(p);
  const ball s = find_s(rigid, c, motion, at, p + guard);
  if (!s.is_bounded()) return result;
  const quarter way(rigid, c, motion, s.precision());
  result.epsilon = epsilon_at(way, s, motion, at.n).with_precision(p + guard);
  if (slope == with_slope::yes) {
    result.slope = slope_at(rigid, c, motion, way, s, at.n).with_precision(p + guard);
  }
  if (!result.epsilon.is_bounded()) return result;
  result.verdict = status::certified;
  result.why = reason::none;
  return result;
}

}  // namespace

twist twist_at(const body& rigid, const rational& c, precision p, with_slope slope) {
  const regime motion = moving_regime(rigid, c);
  const auto at = branch_of(rigid, c, motion);
  if (at) return twist_on(rigid, c, motion, *at, p, slope);
  twist undecided;
  undecided.motion = motion;
  undecided.epsilon = undecided.slope = ball::undefined(p);
  return undecided;
}

twist twist_to_digits(const body& rigid, const rational& c, long digits, with_slope slope) {
  const regime motion = moving_regime(rigid, c);
  twist result;
  result.motion = motion;
  const auto at = branch_of(rigid, c, motion);
  if (at) {
    const precision most = detail::guard_for(digits) + 4 * (at->lost + size_in_bits(c));
    const precision needed = bits_for_digits(digits);
    for (precision guard = 0; guard <= most; guard = 2 * guard + 32) {
      result = twist_on(rigid, c, motion, *at, needed + guard, slope);
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
  return detail::number_to_digits([&](precision p) { return limit_defect(chi, beta, p); }, digits,
                                  detail::guard_for(digits) + 2 * lost + 4 * size_in_bits(beta));
}

}  // namespace polhode
