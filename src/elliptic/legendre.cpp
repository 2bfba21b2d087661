#include "polhode/elliptic/legendre.hpp"

#include <optional>
#include <utility>

#include "elliptic/enclose.hpp"
#include "elliptic/given_modulus.hpp"
#include "elliptic/legendre_points.hpp"

namespace polhode {
namespace {

/// 1 where f increases with m, written for what is given: m or m1.
int direction_in(const detail::ball_parameter& m, int in_m) {
  return m.is_complement() ? -in_m : in_m;
}

/// f(modulus, q), monotone in m.
template <class F>
ball complete(const detail::ball_parameter& m, int in_m, const F& f) {
  const precision p = m.given().precision();
  return detail::monotone_range<1>(
      {m.given()}, {direction_in(m, in_m)}, p, [&](const std::array<ball, 1>& x) {
        return detail::to_accuracy(
            p, [&](precision q) { return f(detail::modulus_at(x[0], m, q), q); });
      });
}

/// K over a narrow ball with 0 <= m <= 63/64 by its value at the middle; std::nullopt for others.
///
/// With b = sqrt(1 - m), K = pi/(2 M(1, b)) for the arithmetic-geometric mean M, which is
/// homogeneous and increases in both arguments: its elasticities (derivatives of log M by the
/// logarithms of the arguments) are in [0, 1], and their sum is 1. M(1, b) = M((1 + b)/2, sqrt(b))
/// gives e(b) = (1 - e') b/(1 + b) + e'/2 for that in b, where e' is that in sqrt(b), the lesser
/// argument again for b <= 1. As b/(1 + b) <= 1/2, e <= 1/2; so e' <= 1/2, and e <= b/(2 (1 + b)) +
/// 1/4, which increases with b.
///
/// Let m change by s, |s| <= r, and k be e/2 <= 1/4 for the greatest b. K rises at most by the
/// factor (1 + s/(1 - m - s))^k <= 1 + k s/(1 - m - s), and falls at most by (1 + s/(1 - m))^-k >=
/// 1 - k s/(1 - m): the relative change is at most k r/(1 - m - r).
///
/// The bound of e is at most a tenth above e for 1 - m >= 1/64, and more beyond.
std::optional<ball> k_over_narrow(const detail::ball_parameter& m) {
  constexpr long narrow = 10;
  constexpr precision few_bits = 64;
  const ball& given = m.given();
  if (given.is_exact() || !given.is_bounded()) return std::nullopt;
  const magnitude r = given.radius();
  if (r > magnitude::power_of_two(-narrow - 7)) return std::nullopt;
  const ball few = given.with_precision(few_bits);
  const ball m1 = m.is_complement() ? few : 1 - few;
  if (sign_of(m1) != certain_sign::positive || m1.magnitude_lower() < magnitude::power_of_two(-6) ||
      m1.magnitude_upper() > magnitude::power_of_two(0)) {
    return std::nullopt;
  }
  const ball b = sqrt(m1);
  const ball k = scale(b / scale(1 + b, 1) + scale(ball(1, few_bits), -2), -1);
  const magnitude change = multiply_up(k.magnitude_upper(), divide_up(r, m1.magnitude_lower()));
  const precision p = given.precision();
  const ball middle = given.middle();
  const ball value = detail::to_accuracy(
      p, [&](precision q) { return detail::k_at(detail::modulus_at(middle, m, q), q); });
  return value.enlarged(multiply_up(change, value.magnitude_upper()));
}

/// The range of f(phi, others..., m), increasing in phi and odd, which for phi > 0 goes with the
/// others in the given directions, the last of which is that of what is given of m.
template <std::size_t Count, class F>
ball incomplete(const ball& phi, const std::array<ball, Count>& others,
                const std::array<int, Count>& direction, precision p, const F& f) {
  const auto value = [&](const ball& at, const std::array<ball, Count>& corner) {
    return detail::to_accuracy(
        p, [&](precision q) { return f(detail::raised_ball(at, q), corner, q); });
  };
  bool exact = phi.is_exact();
  for (const ball& x : others) exact = exact && x.is_exact();
  if (exact) return value(phi, others);
  if (!phi.is_bounded()) return ball::undefined(p);
  const auto corner = [&](int side, const ball& end) {
    std::array<ball, Count> result;
    const int sign = detail::sign_in(end) < 0 ? -side : side;
    for (std::size_t i = 0; i < Count; ++i) {
      result[i] =
          sign * direction[i] > 0 ? detail::upper_end(others[i]) : detail::lower_end(others[i]);
    }
    return value(end, result);
  };
  const ball low = corner(-1, detail::lower_end(phi));
  const ball high = corner(1, detail::upper_end(phi));
  if (low.is_undefined() || high.is_undefined()) return ball::undefined(p);
  return hull(low, high);
}

/// f(phi, modulus, q) over balls.
template <class F>
ball of_amplitude(const ball& phi, const detail::ball_parameter& m, int in_m, const F& f) {
  return incomplete<1>(phi, {m.given()}, {direction_in(m, in_m)}, detail::precision_for(phi, m),
                       [&](const ball& at, const std::array<ball, 1>& corner, precision q) {
                         return f(at, detail::modulus_at(corner[0], m, q), q);
                       });
}

/// |phi| < pi/2 for certain.
bool within_quarter(const ball& phi) {
  return certainly_less(abs(phi), scale(pi(phi.precision()), -1));
}

}  // namespace

ball elliptic_k(const detail::ball_parameter& m) {
  if (std::optional<ball> one = k_over_narrow(m)) return *std::move(one);
  return complete(m, 1, [](const auto& k, precision q) { return detail::k_at(k, q); });
}
ball elliptic_e(const detail::ball_parameter& m) {
  return complete(m, -1, [](const auto& k, precision q) { return detail::e_at(k, q); });
}
ball elliptic_d(const detail::ball_parameter& m) {
  return complete(m, 1, [](const auto& k, precision q) { return detail::d_at(k, q); });
}
ball elliptic_f(const ball& phi, const detail::ball_parameter& m) {
  return of_amplitude(
      phi, m, 1, [](const ball& at, const auto& k, precision q) { return detail::f_at(at, k, q); });
}
ball elliptic_e(const ball& phi, const detail::ball_parameter& m) {
  if (!phi.is_exact() || !m.given().is_exact()) {
    // It decreases in m: what is least and greatest is not where the domain, m sin^2 <= 1 up to
    // phi, ends first.
    const ball greatest_m =
        m.is_complement() ? detail::lower_end(m.given()) : detail::upper_end(m.given());
    const precision q = detail::precision_for(phi, m) + 64;
    for (const ball& end : {detail::lower_end(phi), detail::upper_end(phi)}) {
      const bool is_defined =
          end.is_bounded() && greatest_m.is_bounded() &&
          !detail::e_at(detail::raised_ball(end, q), detail::modulus_at(greatest_m, m, q), q)
               .is_undefined();
      if (!is_defined) return ball::undefined(detail::precision_for(phi, m));
    }
  }
  return of_amplitude(phi, m, -1, [](const ball& at, const auto& k, precision q) {
    return detail::e_at(at, k, q);
  });
}
ball elliptic_d(const ball& phi, const detail::ball_parameter& m) {
  return of_amplitude(
      phi, m, 1, [](const ball& at, const auto& k, precision q) { return detail::d_at(at, k, q); });
}

ball elliptic_pi(const ball& n, const detail::ball_parameter& m) {
  const precision p = std::max(n.precision(), m.given().precision());
  const auto of_numbers = [&](const std::array<ball, 2>& x) {
    return detail::to_accuracy(p, [&](precision q) {
      return detail::pi_at(detail::raised_ball(x[0], q), detail::modulus_at(x[1], m, q), q);
    });
  };
  if (certainly_less(n, 1)) {
    return detail::monotone_range<2>({n, m.given()}, {1, direction_in(m, 1)}, p, of_numbers);
  }
  if (!certainly_greater(n, 1)) return ball::undefined(p);
  if (n.is_exact() && m.given().is_exact()) return of_numbers({n, m.given()});
  return detail::pi_at(n, detail::modulus_at(m.given(), m, p), p);
}

ball elliptic_pi(const ball& n, const ball& phi, const detail::ball_parameter& m) {
  const precision p = std::max(n.precision(), detail::precision_for(phi, m));
  const auto of_numbers = [&](const ball& at, const std::array<ball, 2>& corner, precision q) {
    return detail::pi_at(detail::raised_ball(corner[0], q), at, detail::modulus_at(corner[1], m, q),
                         q);
  };
  const bool regular =
      certainly_less(n, 1) || (within_quarter(phi) && certainly_less(n * square(sin(phi)), 1));
  const bool exact = n.is_exact() && phi.is_exact() && m.given().is_exact();
  if (regular || exact) {
    return incomplete<2>(phi, {n, m.given()}, {1, direction_in(m, 1)}, p, of_numbers);
  }
  return of_numbers(detail::raised_ball(phi, p), {n, m.given()}, p);
}

ball bulirsch_cel(const ball& kc, const ball& p, const ball& a, const ball& b) {
  const precision bits = std::max({kc.precision(), p.precision(), a.precision(), b.precision()});
  if (contains_zero(kc)) return ball::undefined(bits);
  const auto value = [&](precision q) {
    return detail::cel_at(square(detail::raised_ball(kc, q)), detail::raised_ball(p, q),
                          detail::raised_ball(a, q), detail::raised_ball(b, q), q);
  };
  const bool exact = kc.is_exact() && p.is_exact() && a.is_exact() && b.is_exact();
  return exact ? detail::to_accuracy(bits, value) : value(bits + 16).with_precision(bits);
}

// ---------------------------------------------------------------------------------------------
// Numbers without radii.

namespace {

constexpr precision legendre_guard_bits = 48;

template <class F, class... Numbers>
mpfr_float rounded(const F& f, const elliptic_parameter<mpfr_float>& m, const Numbers&... x) {
  const precision p = std::max({precision_of(m.given()), precision_of(x)...});
  const precision q = p + legendre_guard_bits;
  return detail::raised(
      f(detail::raised(x, q)..., detail::modulus_of(m.given(), m.is_complement(), q), q), p);
}
template <class F, class... Numbers>
double rounded(const F& f, const elliptic_parameter<double>& m, Numbers... x) {
  const auto given = static_cast<long double>(m.given());
  return static_cast<double>(
      f(static_cast<long double>(x)...,
        detail::modulus_of(given, m.is_complement(), detail::long_double_bits),
        detail::long_double_bits));
}

}  // namespace

#define POLHODE_LEGENDRE_OF_NUMBERS(T)                                                            \
  T elliptic_k(const elliptic_parameter<T>& m) {                                                  \
    return rounded([](const auto& k, precision q) { return detail::k_at(k, q); }, m);             \
  }                                                                                               \
  T elliptic_e(const elliptic_parameter<T>& m) {                                                  \
    return rounded([](const auto& k, precision q) { return detail::e_at(k, q); }, m);             \
  }                                                                                               \
  T elliptic_d(const elliptic_parameter<T>& m) {                                                  \
    return rounded([](const auto& k, precision q) { return detail::d_at(k, q); }, m);             \
  }                                                                                               \
  T elliptic_pi(const T& n, const elliptic_parameter<T>& m) {                                     \
    return rounded(                                                                               \
        [](const auto& a, const auto& k, precision q) { return detail::pi_at(a, k, q); }, m, n);  \
  }                                                                                               \
  T elliptic_f(const T& phi, const elliptic_parameter<T>& m) {                                    \
    return rounded(                                                                               \
        [](const auto& a, const auto& k, precision q) { return detail::f_at(a, k, q); }, m, phi); \
  }                                                                                               \
  T elliptic_e(const T& phi, const elliptic_parameter<T>& m) {                                    \
    return rounded(                                                                               \
        [](const auto& a, const auto& k, precision q) { return detail::e_at(a, k, q); }, m, phi); \
  }                                                                                               \
  T elliptic_d(const T& phi, const elliptic_parameter<T>& m) {                                    \
    return rounded(                                                                               \
        [](const auto& a, const auto& k, precision q) { return detail::d_at(a, k, q); }, m, phi); \
  }                                                                                               \
  T elliptic_pi(const T& n, const T& phi, const elliptic_parameter<T>& m) {                       \
    return rounded([](const auto& a, const auto& b, const auto& k,                                \
                      precision q) { return detail::pi_at(a, b, k, q); },                         \
                   m, n, phi);                                                                    \
  }
POLHODE_LEGENDRE_OF_NUMBERS(mpfr_float)
POLHODE_LEGENDRE_OF_NUMBERS(double)
#undef POLHODE_LEGENDRE_OF_NUMBERS

mpfr_float bulirsch_cel(const mpfr_float& kc, const mpfr_float& p, const mpfr_float& a,
                        const mpfr_float& b) {
  const precision bits =
      std::max({precision_of(kc), precision_of(p), precision_of(a), precision_of(b)});
  const precision q = bits + legendre_guard_bits;
  return detail::raised(
      detail::cel_at(detail::square_of(detail::raised(kc, q)), detail::raised(p, q),
                     detail::raised(a, q), detail::raised(b, q), q),
      bits);
}
double bulirsch_cel(const double& kc, const double& p, const double& a, const double& b) {
  const auto root = static_cast<long double>(kc);
  return static_cast<double>(detail::cel_at(root * root, static_cast<long double>(p),
                                            static_cast<long double>(a),
                                            static_cast<long double>(b), detail::long_double_bits));
}

// ---------------------------------------------------------------------------------------------
// Derivatives.

// K' = int sin^2/(2 Delta^3) = B/(2 m1), B = int cos^2/Delta = K - D (DLMF 19.4.1).
ball elliptic_k_derivative(const detail::ball_parameter& m) {
  return (elliptic_k(m) - elliptic_d(m)) / (2 * m.m1());
}
// E' = (E - K)/(2m) = -D/2.
ball elliptic_e_derivative(const detail::ball_parameter& m) { return -elliptic_d(m) / 2; }

namespace {

struct slope_parts {
  ball s, c, delta, ss;
};
/// sin phi, cos phi and Delta(phi), for every phi.
slope_parts slope_parts_of(const ball& phi, const detail::ball_parameter& m) {
  const auto [s, c] = sin_cos(phi.with_precision(phi.precision() + 16));
  const ball ss = square(s);
  return {s, c, sqrt(square(c) + m.m1() * ss), ss};
}

}  // namespace

// In m: from F = s R_F(X, Y, 1), dY/dm = -s^2, and 2 k K; undefined over sets that hold an odd
// multiple of pi/2.
std::array<ball, 2> elliptic_f_gradient(const ball& phi, const detail::ball_parameter& m) {
  const detail::amplitude<ball> w = detail::amplitude_of(phi, phi.precision() + 16);
  const ball ss = square(w.s);
  ball in_m = w.s * ss * carlson_rd(w.X, ball(1, phi.precision()), w.X + m.m1() * ss) / 6;
  if (sign_of(w.turns) != certain_sign::zero) in_m += 2 * w.turns * elliptic_k_derivative(m);
  return {1 / slope_parts_of(phi, m).delta, in_m};
}
std::array<ball, 2> elliptic_e_gradient(const ball& phi, const detail::ball_parameter& m) {
  return {slope_parts_of(phi, m).delta, -elliptic_d(phi, m) / 2};
}
// DLMF 19.4.4 and 19.4.7 and their like in the parameter m.
std::array<ball, 2> elliptic_pi_gradient(const ball& n, const detail::ball_parameter& m) {
  const ball k = elliptic_k(m);
  const ball e = elliptic_e(m);
  const ball value = elliptic_pi(n, m);
  const ball difference = m.m() - n;
  return {(e + difference * k / n + (square(n) - m.m()) * value / n) / (2 * difference * (n - 1)),
          (e / m.m1() - value) / (2 * difference)};
}
std::array<ball, 3> elliptic_pi_gradient(const ball& n, const ball& phi,
                                         const detail::ball_parameter& m) {
  const auto [s, c, delta, ss] = slope_parts_of(phi, m);
  const ball f = elliptic_f(phi, m);
  const ball e = elliptic_e(phi, m);
  const ball value = elliptic_pi(n, phi, m);
  const ball difference = m.m() - n;
  const ball sc = s * c;
  const ball factor = square(c) + (1 - n) * ss;  // 1 - n sin^2 phi
  const ball in_n =
      (e + difference * f / n + (square(n) - m.m()) * value / n - n * delta * sc / factor) /
      (2 * difference * (n - 1));
  const ball in_m = (e / m.m1() - value - m.m() * sc / (m.m1() * delta)) / (2 * difference);
  return {in_n, 1 / (factor * delta), in_m};
}

}  // namespace polhode
