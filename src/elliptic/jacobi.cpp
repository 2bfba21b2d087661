#include "polhode/elliptic/jacobi.hpp"

#include "elliptic/enclose.hpp"
#include "elliptic/given_modulus.hpp"
#include "elliptic/jacobi_points.hpp"
#include "polhode/elliptic/legendre.hpp"

namespace polhode {
namespace {

/// f of sn, cn, dn: at numbers to full accuracy, else from the range of am.
template <class F>
ball of_triple(const ball& u, const detail::ball_parameter& m, const F& f) {
  const precision p = detail::precision_for(u, m);
  if (u.is_exact() && m.given().is_exact()) {
    return detail::to_accuracy(p, [&](precision q) {
      const jacobi_values<ball> w =
          detail::jacobi_at(detail::raised_ball(u, q), detail::modulus_at(m.given(), m, q), q);
      return f(w.sn, w.cn, w.dn);
    });
  }
  const jacobi_values<ball> w = jacobi_elliptic(u, m);
  return f(w.sn, w.cn, w.dn);
}

}  // namespace

ball jacobi_am(const ball& u, const detail::ball_parameter& m) {
  const precision p = detail::precision_for(u, m);
  const auto value = [&](const ball& at, const ball& given) {
    return detail::to_accuracy(p, [&](precision q) {
      return detail::am_at(detail::raised_ball(at, q), detail::modulus_at(given, m, q), q);
    });
  };
  if (u.is_exact() && m.given().is_exact()) return value(u, m.given());
  if (!u.is_bounded() || !m.given().is_bounded()) return ball::undefined(p);
  // Monotone for m <= 1, which all members must be.
  if (!detail::not_negative(m.m1())) return ball::undefined(p);
  // With m where u < 0, against it where u > 0; for m1 the other way round.
  const auto corner = [&](int side, const ball& end) {
    const int with_m = detail::sign_in(end) < 0 ? side : -side;
    const bool upper = (with_m > 0) != m.is_complement();
    return value(end, upper ? detail::upper_end(m.given()) : detail::lower_end(m.given()));
  };
  const ball low = corner(-1, detail::lower_end(u));
  const ball high = corner(1, detail::upper_end(u));
  if (low.is_undefined() || high.is_undefined()) return ball::undefined(p);
  return hull(low, high);
}

jacobi_values<ball> jacobi_elliptic(const ball& u, const detail::ball_parameter& m) {
  const precision p = detail::precision_for(u, m);
  if (u.is_exact() && m.given().is_exact()) {
    return {jacobi_sn(u, m), jacobi_cn(u, m), jacobi_dn(u, m)};
  }
  if (certainly_negative(m.m1())) {  // as in jacobi_at
    const ball root = sqrt(m.m());
    const jacobi_values<ball> w =
        jacobi_elliptic(root * u, detail::ball_parameter::with_complement(-m.m1() / m.m()));
    return {w.sn / root, w.dn, w.cn};
  }
  const ball phi = jacobi_am(u, m);
  if (phi.is_undefined()) return detail::undefined_values<ball>(p);
  const auto [s, c] = sin_cos(phi);
  return {s, c, sqrt(square(c) + m.m1() * square(s))};
}

#define POLHODE_JACOBI_QUOTIENT(name, value)                                                      \
  ball name(const ball& u, const detail::ball_parameter& m) {                                     \
    return of_triple(u, m, [](const auto& sn, const auto& cn, const auto& dn) {                   \
      static_cast<void>(sn), static_cast<void>(cn), static_cast<void>(dn);                        \
      return ball(value);                                                                         \
    });                                                                                           \
  }                                                                                               \
  mpfr_float name(const mpfr_float& u, const elliptic_parameter<mpfr_float>& m) {                 \
    const auto [sn, cn, dn] = with_guard_bits(u, m);                                              \
    static_cast<void>(sn), static_cast<void>(cn), static_cast<void>(dn);                          \
    return detail::raised(mpfr_float(value), std::max(precision_of(u), precision_of(m.given()))); \
  }                                                                                               \
  double name(const double& u, const elliptic_parameter<double>& m) {                             \
    const auto [sn, cn, dn] = in_long_double(u, m);                                               \
    static_cast<void>(sn), static_cast<void>(cn), static_cast<void>(dn);                          \
    return static_cast<double>(value);                                                            \
  }

namespace {

constexpr precision jacobi_guard_bits = 64;

jacobi_values<mpfr_float> with_guard_bits(const mpfr_float& u,
                                          const elliptic_parameter<mpfr_float>& m) {
  const precision q = std::max(precision_of(u), precision_of(m.given())) + jacobi_guard_bits;
  return detail::jacobi_at(detail::raised(u, q),
                           detail::modulus_of(m.given(), m.is_complement(), q), q);
}
jacobi_values<long double> in_long_double(double u, const elliptic_parameter<double>& m) {
  const auto given = static_cast<long double>(m.given());
  constexpr double moderate = 16;
  if (std::abs(u) > moderate || std::abs(given) > moderate || !std::isfinite(u)) {
    // A long double has too few bits to reduce such an argument.
    if (!std::isfinite(u) || !std::isfinite(m.given())) {
      return detail::undefined_values<long double>(detail::long_double_bits);
    }
    const jacobi_values<ball> w = jacobi_elliptic(
        ball::exactly(u, 80),
        m.is_complement() ? detail::ball_parameter::with_complement(ball::exactly(m.given(), 80))
                          : detail::ball_parameter(ball::exactly(m.given(), 80)));
    const auto number = [](const ball& x) {
      return mpfr_get_ld(midpoint(x).backend().data(), MPFR_RNDN);
    };
    return {number(w.sn), number(w.cn), number(w.dn)};
  }
  return detail::jacobi_at(static_cast<long double>(u),
                           detail::modulus_of(given, m.is_complement(), detail::long_double_bits),
                           detail::long_double_bits);
}

}  // namespace

POLHODE_JACOBI_QUOTIENT(jacobi_sn, sn)
POLHODE_JACOBI_QUOTIENT(jacobi_cn, cn)
POLHODE_JACOBI_QUOTIENT(jacobi_dn, dn)
POLHODE_JACOBI_QUOTIENT(jacobi_ns, 1 / sn)
POLHODE_JACOBI_QUOTIENT(jacobi_nc, 1 / cn)
POLHODE_JACOBI_QUOTIENT(jacobi_nd, 1 / dn)
POLHODE_JACOBI_QUOTIENT(jacobi_sc, sn / cn)
POLHODE_JACOBI_QUOTIENT(jacobi_sd, sn / dn)
POLHODE_JACOBI_QUOTIENT(jacobi_cs, cn / sn)
POLHODE_JACOBI_QUOTIENT(jacobi_cd, cn / dn)
POLHODE_JACOBI_QUOTIENT(jacobi_ds, dn / sn)
POLHODE_JACOBI_QUOTIENT(jacobi_dc, dn / cn)
#undef POLHODE_JACOBI_QUOTIENT

jacobi_values<mpfr_float> jacobi_elliptic(const mpfr_float& u,
                                          const elliptic_parameter<mpfr_float>& m) {
  const precision p = std::max(precision_of(u), precision_of(m.given()));
  const auto w = with_guard_bits(u, m);
  return {detail::raised(w.sn, p), detail::raised(w.cn, p), detail::raised(w.dn, p)};
}
jacobi_values<double> jacobi_elliptic(const double& u, const elliptic_parameter<double>& m) {
  const auto w = in_long_double(u, m);
  return {static_cast<double>(w.sn), static_cast<double>(w.cn), static_cast<double>(w.dn)};
}
mpfr_float jacobi_am(const mpfr_float& u, const elliptic_parameter<mpfr_float>& m) {
  const precision p = std::max(precision_of(u), precision_of(m.given()));
  const precision q = p + jacobi_guard_bits;
  return detail::raised(
      detail::am_at(detail::raised(u, q), detail::modulus_of(m.given(), m.is_complement(), q), q),
      p);
}
double jacobi_am(const double& u, const elliptic_parameter<double>& m) {
  const auto given = static_cast<long double>(m.given());
  return static_cast<double>(
      detail::am_at(static_cast<long double>(u),
                    detail::modulus_of(given, m.is_complement(), detail::long_double_bits),
                    detail::long_double_bits));
}

// ---------------------------------------------------------------------------------------------
// Inverse functions: from u = R_F(cs^2, ds^2, ns^2), cs^2 + m1 = ds^2, cs^2 + 1 = ns^2, times the
// square root of a common factor of the three.

namespace {

/// f(x, m, m1) at numbers to full accuracy, over other balls as it stands. The part of u in [0, K]
/// for x >= 0; `reflected`: 2K minus that of -x for x < 0; odd functions need nothing.
template <class F>
ball inverse(const ball& x, const detail::ball_parameter& m, bool reflected, const F& f) {
  const precision p = detail::precision_for(x, m);
  if (!detail::not_negative(m.m()) || !detail::not_negative(m.m1())) return ball::undefined(p);
  const auto value = [&](precision q) {
    const auto [k, k1] = detail::modulus_at(m.given(), m, q);
    const ball at = detail::raised_ball(x, q);
    if (!reflected || !certainly_negative(at)) return ball(f(at, k, k1));
    return 2 * elliptic_k(m.is_complement() ? detail::ball_parameter::with_complement(k1)
                                            : detail::ball_parameter(k)) -
           f(-at, k, k1);
  };
  if (reflected && sign_of(x) == certain_sign::unknown) return ball::undefined(p);
  const bool exact = x.is_exact() && m.given().is_exact();
  return exact ? detail::to_accuracy(p, value) : value(p + 16).with_precision(p);
}
ball one_of(const ball& x) { return {1, x.precision()}; }

}  // namespace

ball jacobi_arcsn(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, false, [](const ball& t, const ball&, const ball& m1) {
    const ball rest = (1 - t) * (1 + t);
    return t * carlson_rf(rest, rest + m1 * square(t), one_of(t));
  });
}
ball jacobi_arccn(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, true, [](const ball& t, const ball&, const ball& m1) {
    const ball rest = (1 - t) * (1 + t);
    return sqrt(rest) * carlson_rf(square(t), square(t) + m1 * rest, one_of(t));
  });
}
ball jacobi_arcdn(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, false, [](const ball& t, const ball& k, const ball& m1) {
    if (!certainly_positive(t)) return ball::undefined(t.precision());
    return sqrt((1 - t) * (1 + t)) * carlson_rf(square(t) - m1, k * square(t), k);
  });
}
ball jacobi_arcns(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, false, [](const ball& t, const ball&, const ball& m1) {
    const ball rest = (t - 1) * (t + 1);
    if (!certainly_positive(t)) return ball::undefined(t.precision());
    return carlson_rf(rest, rest + m1, square(t));
  });
}
ball jacobi_arcnc(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, false, [](const ball& t, const ball&, const ball& m1) {
    const ball rest = (t - 1) * (t + 1);
    if (!certainly_positive(t)) return ball::undefined(t.precision());
    return sqrt(rest) * carlson_rf(one_of(t), 1 + m1 * rest, square(t));
  });
}
ball jacobi_arcnd(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, false, [](const ball& t, const ball& k, const ball& m1) {
    if (!certainly_positive(t)) return ball::undefined(t.precision());
    return sqrt((t - 1) * (t + 1)) * carlson_rf(1 - m1 * square(t), k, k * square(t));
  });
}
ball jacobi_arcsc(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, false, [](const ball& t, const ball&, const ball& m1) {
    return t * carlson_rf(one_of(t), 1 + m1 * square(t), 1 + square(t));
  });
}
ball jacobi_arcsd(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, false, [](const ball& t, const ball& k, const ball& m1) {
    return t * carlson_rf(1 - m1 * square(t), one_of(t), 1 + k * square(t));
  });
}
ball jacobi_arccs(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, true, [](const ball& t, const ball&, const ball& m1) {
    return carlson_rf(square(t), square(t) + m1, square(t) + 1);
  });
}
ball jacobi_arccd(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, true, [](const ball& t, const ball&, const ball& m1) {
    const ball rest = (1 - t) * (1 + t);
    return sqrt(rest) * carlson_rf(m1 * square(t), m1, rest + m1 * square(t));
  });
}
ball jacobi_arcds(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, false, [](const ball& t, const ball& k, const ball& m1) {
    if (!certainly_positive(t)) return ball::undefined(t.precision());
    return carlson_rf(square(t) - m1, square(t), square(t) + k);
  });
}
ball jacobi_arcdc(const ball& x, const detail::ball_parameter& m) {
  return inverse(x, m, false, [](const ball& t, const ball&, const ball& m1) {
    const ball rest = (t - 1) * (t + 1);
    if (!certainly_positive(t)) return ball::undefined(t.precision());
    return sqrt(rest) * carlson_rf(m1, m1 * square(t), rest + m1);
  });
}

// K(1-m)/K(m) = M(1, sqrt m1)/M(1, sqrt m).
ball elliptic_nome(const detail::ball_parameter& m) {
  const precision p = m.given().precision();
  return detail::monotone_range<1>({m.given()}, {m.is_complement() ? -1 : 1}, p,
                                   [&](const std::array<ball, 1>& x) {
                                     return detail::to_accuracy(p, [&](precision q) {
                                       const auto [k, m1] = detail::modulus_at(x[0], m, q);
                                       ball one(1, q);
                                       if (certainly_negative(k) || certainly_negative(m1))
                                         return ball::undefined(q);
                                       if (sign_of(k) == certain_sign::zero) return ball(0, q);
                                       if (sign_of(m1) == certain_sign::zero) return one;
                                       return exp(-pi(q) * agm(one, sqrt(m1)) / agm(one, sqrt(k)));
                                     });
                                   });
}

jacobi_gradient_values jacobi_gradient(const ball& u, const detail::ball_parameter& m) {
  const ball phi = jacobi_am(u, m);
  const auto [sn, cn, dn] = jacobi_elliptic(u, m);
  const ball am_in_m = -dn * elliptic_f_gradient(phi, m)[1];
  const ball sn_in_m = cn * am_in_m;
  return {{dn, am_in_m},
          {cn * dn, sn_in_m},
          {-sn * dn, -sn * am_in_m},
          {-m.m() * sn * cn, -(square(sn) + 2 * m.m() * sn * sn_in_m) / (2 * dn)}};
}

}  // namespace polhode
