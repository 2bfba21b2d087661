#include "arithmetic/functions/fixed_point/fraction.hpp"

#include "arithmetic/functions/fixed_point/prime_numbers.hpp"

namespace polhode::detail::fixed_point {

void load(number& x, mpfr_srcptr a, mpfr_exp_t exponent, long w) {
  const auto* significand = static_cast<const limb*>(mpfr_custom_get_significand(a));
  const long n = (mpfr_get_prec(a) + 63) / 64;
  mpn_zero(x.data(), w + 1);
  // |a| = {significand, n} * 2^(exponent - 64 n): shifted to the left by that many bits.
  const long shift = static_cast<long>(exponent) + 64 * (w - n);
  const long whole_limbs = shift >= 0 ? shift / 64 : -((63 - shift) / 64);
  const auto bits = static_cast<unsigned>(shift - 64 * whole_limbs);
  for (long i = 0; i < n; ++i) {
    const long to = i + whole_limbs;
    if (to >= 0 && to <= w) x[to] |= significand[i] << bits;
    if (bits != 0 && to + 1 >= 0 && to + 1 <= w) x[to + 1] |= significand[i] >> (64 - bits);
  }
}

bool store(mpfr_ptr r, number& x, long w, int sign, mpfr_exp_t exponent, std::uint64_t units,
           magnitude& error) {
  long n = w + 1;
  while (n > 0 && x[n - 1] == 0) --n;
  if (n == 0) return false;
  const auto zeros = static_cast<unsigned>(std::countl_zero(x[n - 1]));
  if (zeros != 0) mpn_lshift(x.data(), x.data(), n, zeros);
  const mpfr_exp_t e = exponent + 64 * (n - w) - static_cast<mpfr_exp_t>(zeros);
  mpfr_t whole;
  mpfr_custom_init_set(whole, sign < 0 ? -MPFR_REGULAR_KIND : MPFR_REGULAR_KIND, e, 64 * n,
                       x.data());
  const bool inexact = mpfr_set(r, whole, MPFR_RNDN) != 0;
  const std::int64_t unit = std::int64_t{exponent} - 64 * w;
  // 2^(e - p) is the unit in the last place of `whole` at p bits; r's is not less.
  const std::int64_t half_ulp = std::int64_t{e} - mpfr_get_prec(r) - 1;
  if (static_cast<std::int64_t>(std::bit_width(units)) + unit > half_ulp - 9) return false;
  error = magnitude::from_bits_up(units, unit);
  if (inexact) error = add_up(error, magnitude::power_of_two(half_ulp));
  return true;
}

namespace {

/// MPFR's constant in [1/2, 1), cut off.
void set_by(int (*f)(mpfr_ptr, mpfr_rnd_t), limb* to, long w) {
  mpfr_t as_mpfr;
  mpfr_custom_init_set(as_mpfr, MPFR_ZERO_KIND, 0, 64 * w, to);
  f(as_mpfr, MPFR_RNDD);
}

}  // namespace

log_2::log_2(long w) : constant(is_tabulated(w) ? tabulated_log_2(w) : nullptr, w) {
  if (is_tabulated(w)) return;
  if (is_by_primes(w)) {
    mpn_copyi(own(), logarithms_of_primes(w)->number(0, w), w);
  } else {
    set_by(mpfr_const_log2, own(), w);
  }
}

quarter_pi::quarter_pi(long w) : constant(is_tabulated(w) ? tabulated_quarter_pi(w) : nullptr, w) {
  if (is_tabulated(w)) return;
  if (is_by_primes(w)) {
    // 2 arg(1 + i) = pi/2, with a limb before the point.
    number half(w);
    mpn_rshift(half.data(), angles_of_primes(w)->number(0, w), w + 1, 1);
    mpn_copyi(own(), half.data(), w);
  } else {
    set_by(mpfr_const_pi, own(), w);
  }
}

std::uint64_t reduce(number& x, const constant& c, long w) {
  const uint128 top = (uint128{x[w]} << 64) | x[w - 1];
  auto n = static_cast<std::uint64_t>(top / c[w - 1]);  // or one more or less
  x[w] -= mpn_submul_1(x.data(), c.data(), w, n);
  while (is_negative(x, w)) {
    --n;
    x[w] += mpn_add_n(x.data(), x.data(), c.data(), w);
  }
  while (x[w] != 0 || mpn_cmp(x.data(), c.data(), w) >= 0) {
    ++n;
    x[w] -= mpn_sub_n(x.data(), x.data(), c.data(), w);
  }
  return n;
}

}  // namespace polhode::detail::fixed_point

namespace polhode::detail {

namespace only_mpfr_impl {
namespace {
thread_local long wanted_times = 0;
}  // namespace
}  // namespace only_mpfr_impl

only_mpfr_functions::only_mpfr_functions() noexcept { ++only_mpfr_impl::wanted_times; }
only_mpfr_functions::~only_mpfr_functions() { --only_mpfr_impl::wanted_times; }
bool only_mpfr_functions::are_wanted() noexcept { return only_mpfr_impl::wanted_times > 0; }

}  // namespace polhode::detail
