#pragma once

// Bodies, and motions of them, whose parameters a, b, c lie in ranges: what holds for all of them,
// and the range of each number. Nothing is subdivided: each range comes from two corners.
//
// The half phase, with x = cos^2 psi, is an integral over psi of 2 k, where
//
//   k(x; a, b, c) = (1 - b x)/sqrt((a + b x)(c + b x)),    0 < x < 1,
//
// decreases in a, in b and in c wherever c + b x > 0: the numerator falls (b < 1), the factors of
// the denominator grow. From it follow, each strictly:
//
//   number                        decreases in  because
//   F(c,0), c >= 0                a, b, c       it is the integral of 2 k over a fixed range
//   F(0,u)                        a, b, u       the range shrinks with u
//   epsilon0: F(0, sin^2) = 2 pi  a, b          F decreases in u, too
//   c0: F(c0,0) = 2 pi            a, b          F decreases in c, too; so of the full turn
//   |c_m|, u_m: G(u_m) = 2 pi/m   a, b          G(u) = F(c,-c/b), c = -b u, decreases in |c|, and
//                                               at one u in b, as |c| grows with b
//   F(c,-c/b), c < 0              a, b, |c|     with y = -c (1-s) + b s it is the integral of
//                                               (1-y)/sqrt(y (a+y) s (1-s)) over 0 < s < 1
//   I = (1-b)/sqrt(b (a+b))       a, b
//   J = (a+1)/sqrt(a (a+b)) - 1   a, b          d ln(J+1)/da has the sign of ab - 2a - b < 0
//   T, c > 0                      a, b, c       2 pi/agm(sqrt(a (b+c)), sqrt(c (a+b)))
//   T, c < 0                      a, b, |c|     2 pi/agm(sqrt(b (a-c)), sqrt(-c (a+b)))
//   P/T, P the phase              a, b, |c|     it is 1 less the mean of y over a period of time
//   epsilon(c) where c >= 0       a, b, c       psi' = 1/k along the motion from psi = 0: one with
//   or n = 0                                    greater a, b or c is ahead at phi = pi
//
// The substitution is b x = y, of F's integrand (1-y)/sqrt(y (b-y) (a+y) (c+y)) in y from -c to b.
// n is the branch of twist_curve.hpp, 0 where half the phase is above 2 pi: then no member that
// oscillates has turned back at phi = pi. An arithmetic-geometric mean increases in both of its
// arguments.
//
// The mean of y: with y = b s (c > 0) or y = -c (1-s) + b s, and the weight w/sqrt(s (1-s)) over
// 0 < s < 1, w = 1/sqrt((a+y)(c+y)) or 1/sqrt(y (a+y)), P is the integral of 1 - y and T that of 1.
// By t, one of a, b, |c|, the mean E[y] has the derivative E[y'] + Cov(y, (ln w)'), ' = d/dt.
// For t = a, and for t = c > 0, y' = 0 and (ln w)' = -1/(2 (t + y)) grows with y: Cov >= 0
// (Chebyshev). Else y' = s or 1 - s is >= 0, and (ln w)' = -y' (1/(a+y) + 1/(d+y))/2, d = 0 or c;
// there Cov(y, y'/(d+y)) <= E[y y'/(d+y)] <= E[y'], and the same with a: the derivative is >= 0.
//
// Counts and kinds follow from I and J, and from ab + 2b (body::kind), in rationals.

#include <array>
#include <optional>

#include "polhode/rigid_body/montgomery_phase.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"

namespace polhode {

class body_box {
 public:
  /// All bodies with a and b in these ranges. Throws input_error unless 0 < a.low <= a.high and
  /// 0 < b.low <= b.high < 1.
  body_box(const rational_range& a, const rational_range& b);
  /// Bodies among which are all with principal moments I_x, I_y, I_z in these ranges, which are
  /// positive and disjoint in this order: a = I_y/I_z - 1 and b = 1 - I_y/I_x, each in its range.
  [[nodiscard]] static body_box of_moments(const std::array<rational_range, 3>& moments);

  /// The body of the box with the least a and b, at which every number below is greatest, and that
  /// with the greatest a and b.
  [[nodiscard]] const body& least() const { return least_; }
  [[nodiscard]] const body& greatest() const { return greatest_; }

  [[nodiscard]] rational_range a() const { return {least_.a().exact(), greatest_.a().exact()}; }
  [[nodiscard]] rational_range b() const { return {least_.b().exact(), greatest_.b().exact()}; }

  // What holds for every body of the box; nothing, or undecided, where it does not hold for all.

  /// physical: of every body, planar ones included; planar of a single body.
  [[nodiscard]] body_kind kind() const;
  [[nodiscard]] std::optional<integer> meeting_count() const;
  [[nodiscard]] std::optional<integer> intersection_count() const;
  [[nodiscard]] std::optional<bool> is_injective() const;
  [[nodiscard]] std::optional<bool> has_perfect_twist() const;
  [[nodiscard]] std::optional<bool> has_full_turn() const;

  // Ranges: each encloses the numbers of all bodies of the box, and both ends are nearly attained,
  // to about p bits or `digits` digits. Undefined where some body does not have the number, or
  // where an end was not certified.

  [[nodiscard]] ball geometric_constant(precision p) const;
  [[nodiscard]] ball second_geometric_constant(precision p) const;
  [[nodiscard]] ball separatrix_defect(long digits) const;
  [[nodiscard]] ball perfect_twist(long digits) const;
  [[nodiscard]] ball full_turn(long digits) const;
  /// c and epsilon of the m-th meeting, as meeting_to_digits has them; epsilon is undefined where m
  /// is even. Throws input_error for m < 1.
  struct meeting_range {
    ball c, epsilon;
  };
  [[nodiscard]] meeting_range meeting(const integer& m, long digits) const;

  // Of all motions with c in a range too. Numbers c outside -b .. a are no motions, and are passed
  // over; undefined where the range has 0 in it, or no motion.

  /// In units of I_y/J.
  [[nodiscard]] ball period(const rational_range& c, precision p) const;
  [[nodiscard]] ball montgomery_phase(const rational_range& c, precision p) const;
  /// P/T, the mean rate at which the body turns about J, in J/I_y.
  [[nodiscard]] ball mean_rate(const rational_range& c, precision p) const;
  /// epsilon(c); for c = 0 too. Undefined also where c < 0 and n > 0 for some motion.
  [[nodiscard]] ball twist(const rational_range& c, long digits) const;

 private:
  /// The range of a number that decreases in a, in b and in |c|. value(body, c) is also asked for
  /// c below -b.low, where the number's formula goes on.
  template <class Value>
  [[nodiscard]] ball of_motions(const rational_range& c, const Value& value) const;

  body least_;
  body greatest_;
};

/// The defect in the limit (`limit_defect`, twist_curve.hpp) for all chi and all beta in these
/// ranges, to `digits` digits. Undefined where some member has xi = pi sqrt(chi) that is not shown
/// to be below 2 K(1 + beta), that is, where its motion has come back to psi = 0; that never
/// happens for chi <= 1, as 2 K > pi. Throws input_error for chi <= 0, beta <= -1, empty ranges.
///
/// epsilon = pi/2 - psi, where psi(xi; beta) grows by dpsi/dxi = sqrt(beta + cos^2 psi) from 0 up
/// to the turning point xi = K(1 + beta), sin^2 psi = 1 + beta, where there is one (beta < 0), and
/// returns as it came: xi = T before it and 2 K - T beyond, T(beta, psi) the integral of (beta +
/// cos^2)^(-1/2). T decreases in beta, and K increases: at one xi < 2 K psi increases in beta on
/// both branches, and on the whole by continuity. So over a cell psi is least for the least beta,
/// at an end of the range of xi, as it rises and then falls; and greatest for the greatest beta, at
/// the turning point where that is in the range of xi, and else at the end next to it.
[[nodiscard]] ball limit_defect_range(const rational_range& chi, const rational_range& beta,
                                      long digits);

}  // namespace polhode
