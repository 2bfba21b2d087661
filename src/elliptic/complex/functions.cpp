// The functions of complex.hpp, over regions and over complex balls.

#include "polhode/elliptic/complex.hpp"

#include <concepts>
#include <stdexcept>
#include <string>

#include "jacobi.hpp"

namespace polhode {

// The templates beside this file.
using namespace detail::in_plane;  // NOLINT(google-build-using-namespace)

namespace {

/// f(x...), with its name on an obstacle. Over regions, where f is not available there but is at
/// the middle, the set is too wide, it or an enclosure made of it reaching a cut; smaller ones are
/// of use.
template <class F>
complex_ball answered(const char*, const F& f, const std::same_as<complex_ball> auto&... x) {
  return f(x...);
}
template <class F>
region answered(const char* name, const F& f, const std::same_as<region> auto&... x) {
  region value = f(x...);
  if (value.is_analytic()) return value;
  for (const region* argument : {&x...}) {
    if (!argument->is_analytic()) return *argument;
  }
  const auto middle = [](const region& z) {
    return region(double_interval(z.re().midpoint()), double_interval(z.im().midpoint()));
  };
  const bool is_point = (... && (x.re().is_exact() && x.im().is_exact()));
  // A pole that sets of less than a double's last place do not get past is one of f's.
  const bool at_pole = value.why() == obstacle::pole && (... && !x.is_in_hardware());
  if (value.why() != obstacle::unknown && !at_pole) return region::blocked(value.why(), name);
  const bool smaller_would_do = !is_point && f(middle(x)...).is_analytic();
  return region::blocked(smaller_would_do ? obstacle::branch_cut : obstacle::unknown, name);
}

}  // namespace

#define POLHODE_COMPLEX_ELLIPTIC(Z)                                                              \
  Z carlson_rf(const Z& x, const Z& y, const Z& z) {                                             \
    return answered(                                                                             \
        "carlsonRF", [&](const Z& x_, const Z& y_, const Z& z_) -> Z { return rf(x_, y_, z_); }, \
        x, y, z);                                                                                \
  }                                                                                              \
  Z carlson_rc(const Z& x, const Z& y) {                                                         \
    return answered(                                                                             \
        "carlsonRC", [&](const Z& x_, const Z& y_) -> Z { return rf(x_, y_, y_); }, x, y);       \
  }                                                                                              \
  Z carlson_rj(const Z& x, const Z& y, const Z& z, const Z& p) {                                 \
    return answered(                                                                             \
        "carlsonRJ",                                                                             \
        [&](const Z& x_, const Z& y_, const Z& z_, const Z& p_) -> Z {                           \
          return rj<Z>({x_, y_, z_}, p_);                                                        \
        },                                                                                       \
        x, y, z, p);                                                                             \
  }                                                                                              \
  Z carlson_rd(const Z& x, const Z& y, const Z& z) {                                             \
    return answered(                                                                             \
        "carlsonRD",                                                                             \
        [&](const Z& x_, const Z& y_, const Z& z_) -> Z {                                        \
          return rj<Z>({x_, y_, z_}, z_);                                                        \
        },                                                                                       \
        x, y, z);                                                                                \
  }                                                                                              \
  Z carlson_rg(const Z& x, const Z& y, const Z& z) {                                             \
    return answered(                                                                             \
        "carlsonRG", [&](const Z& x_, const Z& y_, const Z& z_) -> Z { return rg(x_, y_, z_); }, \
        x, y, z);                                                                                \
  }                                                                                              \
  Z elliptic_k(const Z& m) {                                                                     \
    return answered(                                                                             \
        "ellipticK", [&](const Z& m_) -> Z { return complete(m_).k; }, m);                       \
  }                                                                                              \
  Z elliptic_d(const Z& m) {                                                                     \
    return answered(                                                                             \
        "ellipticD", [&](const Z& m_) -> Z { return complete(m_).d; }, m);                       \
  }                                                                                              \
  Z elliptic_e(const Z& m) {                                                                     \
    return answered(                                                                             \
        "ellipticE",                                                                             \
        [&](const Z& m_) -> Z {                                                                  \
          const kinds<Z> w = complete(m_);                                                       \
          return w.k - m_ * w.d;                                                                 \
        },                                                                                       \
        m);                                                                                      \
  }                                                                                              \
  Z elliptic_pi(const Z& n, const Z& m) {                                                        \
    return answered(                                                                             \
        "ellipticPi", [&](const Z& n_, const Z& m_) -> Z { return complete_third(n_, m_); }, n,  \
        m);                                                                                      \
  }                                                                                              \
  Z elliptic_f(const Z& phi, const Z& m) {                                                       \
    return answered(                                                                             \
        "ellipticF",                                                                             \
        [&](const Z& phi_, const Z& m_) -> Z {                                                   \
          return incomplete<Z>(integral::f, nullptr, phi_, m_);                                  \
        },                                                                                       \
        phi, m);                                                                                 \
  }                                                                                              \
  Z elliptic_e(const Z& phi, const Z& m) {                                                       \
    return answered(                                                                             \
        "ellipticE",                                                                             \
        [&](const Z& phi_, const Z& m_) -> Z {                                                   \
          return incomplete<Z>(integral::e, nullptr, phi_, m_);                                  \
        },                                                                                       \
        phi, m);                                                                                 \
  }                                                                                              \
  Z elliptic_d(const Z& phi, const Z& m) {                                                       \
    return answered(                                                                             \
        "ellipticD",                                                                             \
        [&](const Z& phi_, const Z& m_) -> Z {                                                   \
          return incomplete<Z>(integral::d, nullptr, phi_, m_);                                  \
        },                                                                                       \
        phi, m);                                                                                 \
  }                                                                                              \
  Z elliptic_pi(const Z& n, const Z& phi, const Z& m) {                                          \
    return answered(                                                                             \
        "ellipticPi",                                                                            \
        [&](const Z& n_, const Z& phi_, const Z& m_) -> Z {                                      \
          return incomplete<Z>(integral::pi, &n_, phi_, m_);                                     \
        },                                                                                       \
        n, phi, m);                                                                              \
  }                                                                                              \
  Z elliptic_nome(const Z& m) {                                                                  \
    return answered(                                                                             \
        "ellipticNome", [&](const Z& m_) -> Z { return period_of(m_).q; }, m);                   \
  }                                                                                              \
  Z theta_value(int j, const Z& z, const Z& q) {                                                 \
    return answered(                                                                             \
        "jacobiTheta",                                                                           \
        [&](const Z& z_, const Z& q_) -> Z { return theta_series(j, false, z_, q_); }, z, q);    \
  }                                                                                              \
  Z theta_derivative(int j, const Z& z, const Z& q) {                                            \
    return answered(                                                                             \
        "jacobiThetaPrime",                                                                      \
        [&](const Z& z_, const Z& q_) -> Z { return theta_series(j, true, z_, q_); }, z, q);     \
  }                                                                                              \
  Z jacobi_am(const Z& u, const Z& m) {                                                          \
    return answered(                                                                             \
        "jacobiAM", [&](const Z& u_, const Z& m_) -> Z { return amplitude(u_, m_); }, u, m);     \
  }                                                                                              \
  Z jacobi_quotient(char p, char q, const Z& u, const Z& m) {                                    \
    return answered(                                                                             \
        names_of_jacobi[place_of(p, q)],                                                         \
        [&](const Z& u_, const Z& m_) -> Z {                                                     \
          const jacobi_parts<Z> parts(u_, m_);                                                   \
          return parts(p) / parts(q);                                                            \
        },                                                                                       \
        u, m);                                                                                   \
  }                                                                                              \
  Z jacobi_inverse(char p, char q, const Z& x, const Z& m) {                                     \
    return answered(                                                                             \
        names_of_inverse[place_of(p, q)],                                                        \
        [&](const Z& x_, const Z& m_) -> Z { return inverse_function<Z>(p, q, x_, m_); }, x, m); \
  }
POLHODE_COMPLEX_ELLIPTIC(complex_ball)
POLHODE_COMPLEX_ELLIPTIC(region)
#undef POLHODE_COMPLEX_ELLIPTIC

}  // namespace polhode
