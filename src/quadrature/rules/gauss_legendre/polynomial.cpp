#include "quadrature/rules/gauss_legendre/polynomial.hpp"

#include <algorithm>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail {

static_assert(GMP_NUMB_BITS == 64, "limbs of 64 bits without nails");

/// P_n(x) = 2^-n sum of (-1)^k a_k x^(n-2k), a_k = C(n, k) C(2n - 2k, n): integers with
/// a_(k+1) / a_k = (n - 2k)(n - 2k - 1) / (2 (k + 1)(2n - 2k - 1)).
legendre_coefficients::legendre_coefficients(const legendre_shape& s, precision bits)
    : fraction_bits(bits) {
  const auto n = static_cast<unsigned long>(s.n);
  std::vector<integer> all;
  all.reserve(static_cast<std::size_t>(s.degree) + 1);
  integer a;
  const mpz_ptr z = a.backend().data();
  mpz_bin_uiui(z, 2 * n, n);
  integer sum = 0;
  for (unsigned long k = 0; 2 * k <= n; ++k) {
    const auto power = static_cast<unsigned long>(s.degree) - k;
    mpz_addmul_ui(sum.backend().data(), z, std::max(power, 1UL));
    all.push_back(a);
    if (2 * k + 1 >= n) break;
    mpz_mul_ui(z, z, (n - 2 * k) * (n - 2 * k - 1));
    mpz_divexact_ui(z, z, 2 * (k + 1) * (2 * n - 2 * k - 1));
  }
  // sum / 2^n bounds both sums of coefficients; it is at least |P_n(i)| >= 1, or 2^-1 for n = 1.
  const auto bits_of_sum = static_cast<long>(mpz_sizeinbase(sum.backend().data(), 2)) - s.n;
  size = (std::max(bits_of_sum, 1L) + 3 + fraction_bits) / GMP_NUMB_BITS + 1;
  limbs.resize(all.size() * static_cast<std::size_t>(size), 0);
  const long shift = fraction_bits - s.n;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const mpz_ptr scaled = all[k].backend().data();
    if (k % 2 != 0) mpz_neg(scaled, scaled);
    if (shift >= 0) {
      mpz_mul_2exp(scaled, scaled, static_cast<mp_bitcnt_t>(shift));
    } else {
      mpz_fdiv_q_2exp(scaled, scaled, static_cast<mp_bitcnt_t>(-shift));
    }
    mp_limb_t* const target = limbs.data() + k * static_cast<std::size_t>(size);
    mpn_copyi(target, mpz_limbs_read(scaled), static_cast<mp_size_t>(mpz_size(scaled)));
    if (mpz_sgn(scaled) < 0) mpn_neg(target, target, size);
  }
}

}  // namespace polhode::detail
