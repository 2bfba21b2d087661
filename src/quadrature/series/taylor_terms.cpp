#include "taylor_terms.hpp"

#include <algorithm>

#include "polhode/arithmetic/mpfr_cell.hpp"

namespace polhode::detail {

fixed_point_number in_fixed_point(const ball& z, long f) {
  fixed_point_number result;
  ball units;
  scale(units, z.with_precision(f + 64), f);
  mpfr_cell middle(f + 64);
  units.midpoint(middle.get());
  mpfr_get_z(result.value.backend().data(), middle.get(), MPFR_RNDN);
  result.error = scale((units - ball(result.value, f + 64)).magnitude_upper(), -f);
  return result;
}

std::optional<computed_terms> add_terms(const taylor_recurrence& of, const wanted_terms& wanted,
                                        std::vector<series_part>& part) {
  const auto& [q, s, t, of_p, power] = of;
  const long f = wanted.f;
  long most_terms = wanted.most_terms;
  const std::size_t parts = part.size();
  // p = above/below
  constexpr long greatest = 1L << 31;
  if (denominator(power) > greatest || abs(numerator(power)) > greatest) {
    return std::nullopt;
  }
  const auto above = static_cast<long>(numerator(power));
  const auto below = static_cast<unsigned long>(denominator(power));
  // a_n and e_n = sum of P_k a_(n-k), until all that are looked back at are 0.
  const std::size_t depth = std::max({q.size() - 1, s.size(), t.size()});
  const std::size_t looked_at = std::max(depth, of_p.size());
  const std::size_t ring = looked_at + 1;
  for (series_part& own : part) own.a.resize(ring);
  mpz_setbit(part[0].a[0].backend().data(), static_cast<mp_bitcnt_t>(f));
  // The real part of s_k - (n - k) q_(k+1), for the n of the step.
  std::vector<integer> c(depth);
  for (std::size_t k = 0; k < depth; ++k) {
    if (k < s.size()) c[k] = s[k];
    if (k + 1 < q.size()) c[k] += q[k + 1] * static_cast<long>(k);
  }
  std::vector<integer> step(depth);  // of c from one n to the next
  for (std::size_t k = 0; k < depth && k + 1 < q.size(); ++k) step[k] = q[k + 1];
  std::vector<integer> next(parts);
  integer e;
  integer b;
  integer divisor;
  std::size_t zeros = 0;
  std::size_t newest = 0;
  // A series that converges takes no such terms, or less than so many.
  const auto most_limbs = static_cast<std::size_t>(2 * f / GMP_NUMB_BITS + 32);
  most_terms = std::min(most_terms, 8 * f + 500);
  computed_terms result;
  long n = 0;
  for (;; ++n) {
    const auto before = [&](const series_part& own, std::size_t back) -> mpz_srcptr {
      return own.a[newest >= back ? newest - back : newest + ring - back].backend().data();
    };
    const std::size_t known = std::min(static_cast<std::size_t>(n) + 1, looked_at);
    mpz_ptr const sum = e.backend().data();
    if (!wanted.only_even || n % 2 == 0) {
      // b_n = e_n / (n + p + 1)
      const auto by = static_cast<unsigned long>(above + static_cast<long>(below) * (n + 1));
      for (series_part& own : part) {
        mpz_set_ui(sum, 0);
        for (std::size_t k = 0; k < std::min(of_p.size(), known); ++k) {
          mpz_addmul(sum, before(own, k), of_p[k].backend().data());
        }
        mpz_mul_ui(b.backend().data(), sum, below);
        mpz_tdiv_q_ui(b.backend().data(), b.backend().data(), by);
        own.add(b, e, n, wanted.is_cut);
      }
    }
    if (zeros >= looked_at) break;
    if (n >= most_terms) return std::nullopt;
    // a_(n+1)
    mpz_mul_ui(divisor.backend().data(), q[0].backend().data(), static_cast<unsigned long>(n) + 1);
    bool is_zero = true;
    bool is_divided = false;
    for (std::size_t i = 0; i < parts; ++i) {
      mpz_set_ui(sum, 0);
      for (std::size_t k = 0; k < std::min(depth, known); ++k) {
        mpz_addmul(sum, before(part[i], k), c[k].backend().data());
      }
      for (std::size_t k = 0; k < std::min(t.size(), known); ++k) {
        // i t_k times the other part
        (i == 0 ? mpz_submul : mpz_addmul)(sum, before(part[1 - i], k), t[k].backend().data());
      }
      is_divided = is_divided || mpz_sgn(sum) != 0;
      mpz_tdiv_q(next[i].backend().data(), sum, divisor.backend().data());
      if (mpz_size(next[i].backend().data()) > most_limbs) return std::nullopt;
      is_zero = is_zero && mpz_sgn(next[i].backend().data()) == 0;
    }
    zeros = is_zero ? zeros + 1 : 0;
    if (is_divided) ++result.divisions;
    for (std::size_t k = 0; k < depth; ++k) {
      mpz_sub(c[k].backend().data(), c[k].backend().data(), step[k].backend().data());
    }
    newest = newest + 1 == ring ? 0 : newest + 1;
    for (std::size_t i = 0; i < parts; ++i) {
      mpz_swap(part[i].a[newest].backend().data(), next[i].backend().data());
    }
  }
  result.count = n + 1;
  return result;
}

}  // namespace polhode::detail
