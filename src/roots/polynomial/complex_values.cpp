// Horner's scheme in integers, in units of 2^-w. Let u be the point, which is exact, with
// |u| <= 1 + 1/(4 n), and let v_k, s_k be the exact values of
//   v_k = v_(k+1) u + c_k,   s_k = s_(k+1) u + v_(k+1)
// and V_k, S_k the computed ones, whose parts are rounded down after each product, by less than a
// unit each, so by less than 2^(1/2) together. As |u|^n <= e^(1/4) < 1.2841,
//   |V_k - v_k| <= |V_(k+1) - v_(k+1)| |u| + 2^(1/2)
// is at most 1.2841 2^(1/2) n < 2 n, and
//   |S_k - s_k| <= |S_(k+1) - s_(k+1)| |u| + 2^(1/2) + 2 n
// is at most 1.2841 (2^(1/2) + 2 n) n < 3 n (n + 1).
// A point on the unit circle may be rounded to one beyond it; that is why |u| may exceed 1.

#include "complex_values.hpp"

#include <algorithm>

#include "polhode/arithmetic/boost_bridge.hpp"

namespace polhode::detail {
namespace {

mpz_ptr raw(integer& n) { return n.backend().data(); }
mpz_srcptr raw(const integer& n) { return n.backend().data(); }

/// |n| from below and from above.
magnitude size_of(const integer& n, bool upward) {
  const std::size_t length = mpz_sizeinbase(raw(n), 2);
  const std::size_t cut = length > 62 ? length - 62 : 0;
  integer leading;
  mpz_tdiv_q_2exp(raw(leading), raw(n), cut);
  mpz_abs(raw(leading), raw(leading));
  auto bits = leading.convert_to<std::uint64_t>();
  if (upward && cut > 0) ++bits;
  return upward ? magnitude::from_bits_up(bits, static_cast<std::int64_t>(cut))
                : magnitude::from_bits_down(bits, static_cast<std::int64_t>(cut));
}

/// z u, the parts rounded down.
class product_with {
 public:
  product_with(const fixed_point& u, long bits) : u_(u), bits_(static_cast<mp_bitcnt_t>(bits)) {}
  void operator()(integer& re, integer& im) {
    mpz_mul(raw(a_), raw(re), raw(u_.re));
    mpz_submul(raw(a_), raw(im), raw(u_.im));
    mpz_mul(raw(b_), raw(re), raw(u_.im));
    mpz_addmul(raw(b_), raw(im), raw(u_.re));
    mpz_fdiv_q_2exp(raw(re), raw(a_), bits_);
    mpz_fdiv_q_2exp(raw(im), raw(b_), bits_);
  }

 private:
  const fixed_point& u_;
  mp_bitcnt_t bits_;
  integer a_;
  integer b_;
};

}  // namespace

magnitude fixed_value::abs_upper() const {
  return add_up(add_up(size_of(re, true), size_of(im, true)), error);
}

magnitude fixed_value::abs_lower() const {
  const magnitude known = max(size_of(re, false), size_of(im, false));
  return known > error ? subtract_down(known, error) : magnitude();
}

complex_values::values complex_values::at(const fixed_point& x, long bits) {
  if (shift_ != bits) {
    shift_ = bits;
    shifted_.resize(p_.size());
    for (std::size_t k = 0; k < p_.size(); ++k) {
      mpz_mul_2exp(raw(shifted_[k]), raw(p_[k]), static_cast<mp_bitcnt_t>(bits));
    }
  }
  const std::size_t n = p_.size() - 1;
  const auto coefficient = [&](std::size_t k) -> const integer& {
    return shifted_[x.is_reciprocal ? n - k : k];
  };
  values r;
  r.value.re = coefficient(n);
  product_with times_u(x, bits);
  for (std::size_t k = n; k-- > 0;) {
    times_u(r.slope.re, r.slope.im);
    r.slope.re += r.value.re;
    r.slope.im += r.value.im;
    times_u(r.value.re, r.value.im);
    r.value.re += coefficient(k);
  }
  const auto degree = static_cast<std::uint64_t>(n);
  r.value.error = magnitude::from_integer_up(2 * degree);
  r.slope.error = magnitude::from_integer_up(3 * degree * (degree + 1));
  // (1 + 1/(4 n))^2 is above 1 + 1/(2 n).
  const integer one = integer(1) << (2 * static_cast<unsigned long>(bits));
  if (x.re * x.re + x.im * x.im > one + one / (2 * degree)) {
    r.value.error = r.slope.error = magnitude::infinity();
  }
  return r;
}

magnitude complex_values::value_bound(const fixed_point& x, const values& v, long bits) const {
  const magnitude bound = scale(v.value.abs_upper(), -bits);
  if (!x.is_reciprocal) return bound;
  constexpr precision enough = 64;
  return multiply_up(bound, pow(abs(to_ball(x, bits, enough)), degree()).magnitude_upper());
}

complex_ball to_ball(const fixed_point& x, long bits, precision p) {
  const auto part = [&](const integer& n) {
    const auto length = static_cast<precision>(mpz_sizeinbase(raw(n), 2));
    return scale(ball(n, std::max(p, length)), -bits).with_precision(p);
  };
  const complex_ball u(part(x.re), part(x.im));
  return x.is_reciprocal ? reciprocal(u) : u;
}

}  // namespace polhode::detail
