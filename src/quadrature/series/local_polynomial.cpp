#include "local_polynomial.hpp"

#include <algorithm>

namespace polhode::detail {

local_polynomial at_panel(const rational_polynomial& p, const rational& c, const rational& r) {
  // c = C/T, r = R/T: T^n p(c + r z) = sum p_j T^(n-j) (C + R z)^j by Horner's rule.
  const integer t = lcm(denominator(c), denominator(r));
  const integer shift = numerator(c) * (t / denominator(c));
  const integer scale = numerator(r) * (t / denominator(r));
  const auto n = static_cast<std::size_t>(p.degree());
  integers v{numerator(p.coefficients()[n])};
  integer power = 1;
  for (std::size_t j = n; j-- > 0;) {
    power *= t;
    v.emplace_back(0);
    for (std::size_t k = v.size(); k-- > 0;) {
      v[k] *= shift;
      if (k > 0) v[k] += v[k - 1] * scale;
    }
    v[0] += numerator(p.coefficients()[j]) * power;
  }
  integer common = 0;
  for (const integer& x : v) common = gcd(common, x);
  if (common > 1) {
    for (integer& x : v) x /= common;
  }
  return {std::move(v), rational(common, power)};
}

integers product(const integers& p, const integers& q) {
  if (p.empty() || q.empty()) return {};
  integers result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) result[i + j] += p[i] * q[j];
  }
  return result;
}
integers derivative(const integers& p) {
  integers result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(p[k] * static_cast<long>(k));
  return result;
}
void multiply_by(integers& p, const integer& factor) {
  for (integer& x : p) x *= factor;
}
void add_to(integers& p, const integers& q) {
  if (p.size() < q.size()) p.resize(q.size());
  for (std::size_t k = 0; k < q.size(); ++k) p[k] += q[k];
}
long without_zeros(integers& p) {
  const auto first = std::find_if(p.begin(), p.end(), [](const integer& x) { return x != 0; });
  const long zeros = first - p.begin();
  p.erase(p.begin(), first);
  return zeros;
}

double_interval quotient(const integer& x, const integer& y) {
  if (x == 0) return double_interval(0);
  // |x| = m 2^e with 1/2 <= m < 1, cut off after 53 bits.
  const auto parts_of = [](const integer& n) {
    long e = 0;
    const double m = mpz_get_d_2exp(&e, n.backend().data());
    constexpr double unit = 0x1p-52;
    return std::pair(m < 0 ? double_interval(m - unit, m) : double_interval(m, m + unit), e);
  };
  const auto [above, above_exponent] = parts_of(x);
  const auto [below, below_exponent] = parts_of(y);
  return scale(above / below, above_exponent - below_exponent);
}

}  // namespace polhode::detail
