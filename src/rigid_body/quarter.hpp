#pragma once

#include <concepts>
#include <map>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "polhode/rigid_body/motion.hpp"

namespace polhode::detail {

/// What a quarter is made of.
struct quarter_numbers {
  explicit quarter_numbers(const motion& of)
      : b(of.b()),
        rest(1 - of.b()),
        kappa2(1 + of.kappa()),
        m1(of.m1()),
        lambda2(of.lambda2()),
        eta(1 - of.turning_point()) {}
  exact_real b, rest, kappa2, m1, lambda2, eta;
};

/// The motion on its first quarters, by S = sinh w = tan am(lambda t), t the time from the middle
/// of the twist in I_y/J:
///
///                oscillating               rotating, separatrix
///   kappa^2      (a+b)/(a-c)               (a+b)/a                  1 + the kappa of motion.hpp
///   eta          (b+c)/b                   1                        1 - its turning point
///   tan psi      sqrt(eta) T/sqrt(1+m1 S^2)   T              with T = kappa S
///
/// with m1 and lambda of motion.hpp; and in both, with x = cos^2 psi,
///   1 - x = eta T^2/(1+T^2),   a + b x = (a+b)(1+S^2)/(1+T^2),                              (1)
///   {x, (c + b x)/(b+c)} = {(1+m1 S^2)/(1+T^2), 1/(1+T^2)} when oscillating, the other way
///     round when rotating.                                                                     (2)
/// Proof of (1), (2): eta = 1 + c/b is 1 - u for the turning point u = -c/b; put 1 - x = eta sin^2
/// alpha, T = tan alpha (alpha = psi when rotating). Then c + b x = (b+c) cos^2 alpha when
/// oscillating; the rest is multiplying out, with m1 = kappa^2 (-c/b), kappa^2 c/(b+c).
///
/// The phase from psi = 0 on is F(c,x)/2 = (montgomery_phase.hpp) sqrt((1-x)/((a+b)(b+c))) [(1-b)
/// R_F + (b (1-x)/3) R_J] at the arguments x, (a+bx)/(a+b), (c+bx)/(b+c). R_F and R_J are symmetric
/// in them and homogeneous, of the degrees -1/2 and -3/2; multiplied by 1 + T^2 they are 1, 1+S^2,
/// 1+m1 S^2, and so
///   phi = (S/lambda) [ (1-b) R_F(1, 1+S^2, 1+m1 S^2)
///                      + (b eta T^2/3) R_J(1, 1+S^2, 1+m1 S^2, 1+T^2) ],                       (3)
/// odd in S, with nothing that cancels; lambda t = S R_F(1, 1+S^2, 1+m1 S^2), which is F(am | m).
/// Since dphi/dt = sin^2 psi + (I_y/I_x) cos^2 psi = 1 - b x and dw/d(lambda t) = dn/cn with dn/cn
/// = sqrt(1+m1 S^2),
///   dphi/dw = (1 - b x)/(lambda sqrt(1+m1 S^2)).                                            (4)
/// Counted from the end of the quarter, with w' in the place of w, lambda t becomes K - lambda t
/// and S becomes S = 1/(sqrt(m1) sinh w') (DLMF 22.4.3), and by dn/cn = 1/sn there
///   dphi/dw' = -(1 - b x)/(lambda sqrt(1+m1 sinh^2 w')).                                    (5)
/// So phi is nearly linear in w up to S = m1^(-1/4), the middle in time, and in w' beyond, however
/// near c is to 0.
///
/// T is ball; or double, to search for a root.
template <class T>
class quarter {
 public:
  quarter(const quarter_numbers& exact, precision p) {
    using std::sqrt;
    const auto number = [=](const exact_real& x) {
      if constexpr (std::same_as<T, ball>) {
        return x.at(p);
      } else {
        return x.is_rational() ? static_cast<T>(x.exact()) : midpoint(x.at(64)).convert_to<T>();
      }
    };
    b_ = number(exact.b);
    rest_ = number(exact.rest);
    one_ = number(1);
    kappa2_ = number(exact.kappa2);
    m1_ = number(exact.m1);
    lambda_ = sqrt(number(exact.lambda2));
    eta_ = number(exact.eta);
  }
  quarter(const motion& of, precision p) : quarter(quarter_numbers(of), p) {}

  [[nodiscard]] const T& m1() const { return m1_; }
  [[nodiscard]] const T& lambda() const { return lambda_; }
  [[nodiscard]] const T& eta() const { return eta_; }
  [[nodiscard]] T tangent(const T& s) const {
    using std::sqrt;
    return sqrt(kappa2_) * s;
  }

  /// (3)
  [[nodiscard]] T phase(const T& s) const {
    const T s2 = s * s;
    const T t2 = kappa2_ * s2;
    const T y = 1 + s2;
    const T z = 1 + m1_ * s2;
    const T p = 1 + t2;
    if constexpr (std::same_as<T, ball>) {
      const carlson_pair w = carlson_rf_rj(one_, y, z, p);
      return s / lambda_ * (rest_ * w.rf + b_ * eta_ * t2 / 3 * w.rj);
    } else {
      return s / lambda_ *
             (rest_ * carlson_rf(one_, y, z) + b_ * eta_ * t2 / 3 * carlson_rj(one_, y, z, p));
    }
  }
  /// 1 - b x
  [[nodiscard]] T rate(const T& s) const {
    const T t2 = kappa2_ * s * s;
    return rest_ + b_ * eta_ * t2 / (1 + t2);
  }
  /// The sizes of (4), where `sinh` is sinh w, and (5), where it is sinh w'.
  [[nodiscard]] T rate_in_w(const T& s, const T& sinh) const {
    using std::sqrt;
    return rate(s) / (lambda_ * sqrt(T(1 + m1_ * sinh * sinh)));
  }
  /// S by w'.
  [[nodiscard]] T from_end(const T& sinh) const {
    using std::sqrt;
    return 1 / (sqrt(m1_) * sinh);
  }

 private:
  T b_, rest_, one_, kappa2_, m1_, lambda_, eta_;
};

/// A motion's quarters to any precision, each made once.
class quarters {
 public:
  explicit quarters(const motion& of) : exact_(of) {}
  [[nodiscard]] quarter<double> in_double() const { return {exact_, 53}; }
  [[nodiscard]] const quarter<ball>& at(precision p) {
    return made_.try_emplace(p, exact_, p).first->second;
  }

 private:
  quarter_numbers exact_;
  std::map<precision, quarter<ball>> made_;
};

}  // namespace polhode::detail
