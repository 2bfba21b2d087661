// Values of elliptic integrals and functions: the identities of DLMF 19-22, and the
// arithmetic-geometric mean.

#include "values.hpp"

namespace polhode::differential {
namespace {

term parameter(maker& m) {
  if (m.one_in(8)) return m.decimal(m.scattered(1e-20, 0.5));
  if (m.one_in(8)) return 1 - m.decimal(m.scattered(1e-20, 0.5));
  return m.exponent_between(0.01, 0.99);
}
/// Below 1, negative ones too.
term any_parameter(maker& m) { return m.one_in(2) ? parameter(m) : m.exponent_between(-20, 0.99); }
term positive(maker& m) {
  return m.one_in(6) ? m.decimal(m.scattered(1e-12, 1e12)) : m.positive_coefficient();
}

value_case complete(maker& m) {
  const term k = any_parameter(m);
  const auto of = [](const char* name, const term& t) { return call(name, t); };
  const term big_k = of("ellipticK", k);
  switch (m.between(0, 6)) {
    case 0:
      return {big_k, term("pi") / 2 / call("agm", 1, call("sqrt", 1 - k))};
    case 1: {  // Legendre's relation, DLMF 19.7.1
      const term p = parameter(m);
      const term q = 1 - p;
      return {of("ellipticE", p) * of("ellipticK", q) + of("ellipticE", q) * of("ellipticK", p) -
                  of("ellipticK", p) * of("ellipticK", q),
              term("pi") / 2};
    }
    case 2:
      return {of("ellipticD", k) * k, big_k - of("ellipticE", k)};
    case 3:
      return {big_k, term("carlsonRF", {0, 1 - k, 1})};
    case 4:
      return {of("ellipticE", k), 2 * term("carlsonRG", {0, 1 - k, 1})};
    case 5:  // DLMF 19.7.2: K(-m) = K(m/(1+m))/sqrt(1+m)
    {
      const term p = parameter(m);
      return {of("ellipticK", -p), of("ellipticK", p / (1 + p)) / call("sqrt", 1 + p)};
    }
    default: {
      const term n = m.exponent_between(-5, 0.95);
      return {call("ellipticPi", n, k), big_k + n / 3 * term("carlsonRJ", {0, 1 - k, 1, 1 - n})};
    }
  }
}

value_case incomplete(maker& m) {
  const term k = any_parameter(m);
  const term phi = m.near(m.within(-1.4, 1.4));
  const term s = call("sin", phi);
  const term c2 = power(call("cos", phi), 2);
  const term d2 = 1 - k * power(s, 2);
  switch (m.between(0, 6)) {
    case 0:
      return {call("ellipticF", phi, k), s * term("carlsonRF", {c2, d2, 1})};
    case 1:
      return {call("ellipticD", phi, k), power(s, 3) / 3 * term("carlsonRD", {c2, d2, 1})};
    case 2:
      return {call("ellipticE", phi, k), call("ellipticF", phi, k) - k * call("ellipticD", phi, k)};
    case 3: {
      const long n = m.between(1, 20);
      return {call("ellipticF", phi + term("pi") * n, k),
              call("ellipticF", phi, k) + 2 * n * call("ellipticK", k)};
    }
    case 4:
      return {call("ellipticF", -phi, k), -call("ellipticF", phi, k)};
    case 5: {
      const term n = m.exponent_between(-5, 0.95);
      return {term("ellipticPi", {n, phi, k}),
              call("ellipticF", phi, k) +
                  n / 3 * power(s, 3) * term("carlsonRJ", {c2, d2, 1, 1 - n * power(s, 2)})};
    }
    default: {
      const long n = m.between(1, 20);
      return {call("ellipticE", phi + term("pi") * n, k),
              call("ellipticE", phi, k) + 2 * n * call("ellipticE", k)};
    }
  }
}

value_case carlson(maker& m) {
  const term a = positive(m);
  const term b = positive(m);
  const term c = positive(m);
  const term p = positive(m);
  const term t = m.positive_rational();
  const auto rf = [](const term& u, const term& v, const term& w) {
    return term("carlsonRF", {u, v, w});
  };
  const auto rj = [](const term& u, const term& v, const term& w, const term& z) {
    return term("carlsonRJ", {u, v, w, z});
  };
  switch (m.between(0, 8)) {
    case 0:
      return {rf(a, b, c), rf(c, a, b)};
    case 1:
      return {rf(t * a, t * b, t * c), rf(a, b, c) / call("sqrt", t)};
    case 2:
      return {rj(a, b, c, p), rj(c, b, a, p)};
    case 3:
      return {term("carlsonRD", {a, b, c}), rj(a, b, c, c)};
    case 4:
      return {call("carlsonRC", a, b), rf(a, b, b)};
    case 5: {  // duplication, DLMF 19.26.18
      const term l = call("sqrt", a * b) + call("sqrt", b * c) + call("sqrt", c * a);
      return {rf(a, b, c), 2 * rf(a + l, b + l, c + l)};
    }
    case 6:  // DLMF 19.21.9: x R_D(y,z,x) + y R_D(z,x,y) + z R_D(x,y,z) = 3 R_F
      return {a * term("carlsonRD", {b, c, a}) + b * term("carlsonRD", {c, a, b}) +
                  c * term("carlsonRD", {a, b, c}),
              3 * rf(a, b, c)};
    case 7:
      return {rj(t * a, t * b, t * c, t * p), rj(a, b, c, p) / power(t, "3/2")};
    default:  // DLMF 19.21.10: 2 R_G = z R_F - (x-z)(y-z) R_D/3 + sqrt(xy/z)
      return {2 * term("carlsonRG", {a, b, c}),
              c * rf(a, b, c) - (a - c) * (b - c) * term("carlsonRD", {a, b, c}) / 3 +
                  call("sqrt", a * b / c)};
  }
}

value_case jacobi(maker& m) {
  const term k = m.one_in(3) ? any_parameter(m) : parameter(m);
  const term u =
      m.one_in(8) ? m.near(m.within(-1, 1)) * power(10, m.between(1, 20)) : m.near(m.within(-5, 5));
  const term v = m.near(m.within(-3, 3));
  const auto sn = [&](const term& t) { return call("jacobiSN", t, k); };
  const auto cn = [&](const term& t) { return call("jacobiCN", t, k); };
  const auto dn = [&](const term& t) { return call("jacobiDN", t, k); };
  switch (m.between(0, 9)) {
    case 0:
      return {power(sn(u), 2) + power(cn(u), 2), 1};
    case 1:
      return {power(dn(u), 2) + k * power(sn(u), 2), 1};
    case 2:
      return {sn(u + v), (sn(u) * cn(v) * dn(v) + sn(v) * cn(u) * dn(u)) /
                             (1 - k * power(sn(u), 2) * power(sn(v), 2))};
    case 3:
      return {dn(u + v), (dn(u) * dn(v) - k * sn(u) * sn(v) * cn(u) * cn(v)) /
                             (1 - k * power(sn(u), 2) * power(sn(v), 2))};
    case 4:
      return {call("ellipticF", call("jacobiAM", v, k), k), v};
    case 5:
      return {sn(u), call("sin", call("jacobiAM", u, k))};
    case 6:
      return {sn(u + 4 * call("ellipticK", k)), sn(u)};
    case 7:
      return {call("jacobiSC", u, k) * call("jacobiCD", u, k), call("jacobiSD", u, k)};
    case 8: {
      const term s = m.quotient(m.within(-0.95, 0.95));
      const term p = parameter(m);
      return {call("jacobiSN", call("jacobiArcSN", s, p), p), s};
    }
    default: {  // Landen, DLMF 22.7.2, with k1 = (1 - sqrt(1-m))/(1 + sqrt(1-m))
      const term p = parameter(m);
      const term root = call("sqrt", 1 - p);
      const term k1 = (1 - root) / (1 + root);
      const term w = v / (1 + k1);
      const term s = call("jacobiSN", w, power(k1, 2));
      return {call("jacobiSN", v, p), (1 + k1) * s / (1 + k1 * power(s, 2))};
    }
  }
}

value_case theta(maker& m) {
  const term q = m.decimal(m.scattered(1e-6, 0.8));
  const term z = m.near(m.within(-4, 4));
  const auto t = [&](long j, const term& at) {
    return call("jacobiTheta" + std::to_string(j), at, q);
  };
  switch (m.between(0, 4)) {
    case 0:  // DLMF 20.7.5
      return {power(t(3, 0), 4), power(t(2, 0), 4) + power(t(4, 0), 4)};
    case 1:  // Jacobi's derivative formula, DLMF 20.4.6
      return {call("jacobiTheta1Prime", 0, q), t(2, 0) * t(3, 0) * t(4, 0)};
    case 2:
      return {t(1, z + term("pi") / 2), t(2, z)};
    case 3:
      return {t(4, z), t(3, z + term("pi") / 2)};
    default: {  // K = pi/2 theta_3^2, DLMF 20.9.2
      const term k = parameter(m);
      return {call("ellipticK", k),
              term("pi") / 2 * power(call("jacobiTheta3", 0, call("ellipticNome", k)), 2)};
    }
  }
}

}  // namespace

std::vector<value_family> elliptic_families() {
  return {{"complete elliptic integrals", 400, complete},
          {"incomplete elliptic integrals", 400, incomplete},
          {"Carlson's functions", 400, carlson},
          {"Jacobi's functions", 400, jacobi},
          {"theta functions", 300, theta}};
}

}  // namespace polhode::differential
