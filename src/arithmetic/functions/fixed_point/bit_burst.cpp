#include "arithmetic/functions/fixed_point/bit_burst.hpp"

#include <bit>

#include "arithmetic/functions/fixed_point/powers_by_length.hpp"

namespace polhode::detail::fixed_point {

namespace bit_burst_impl {
namespace {

/// The sum over k in (first, last] of p^(k - first)/(2^(scale (k - first)) f(first + 1) ... f(k))
/// is t/(2^(scale (last - first)) q), q = f(first + 1) ... f(last).
struct partial_sum {
  integer t;
  integer q;
};

/// By halves: t = t_1 q_2 2^(scale (last - middle)) + p^(middle - first) t_2.
template <class Factor>
partial_sum sum_of_terms(long first, long last, const powers_by_length& powers, long scale,
                         Factor factor) {
  if (last - first == 1) return {powers.of(1), integer(factor(last))};
  const long middle = first + (last - first) / 2;
  partial_sum left = sum_of_terms(first, middle, powers, scale, factor);
  partial_sum right = sum_of_terms(middle, last, powers, scale, factor);
  left.t *= right.q;
  left.t <<= static_cast<unsigned long>(scale * (last - middle));
  right.t *= powers.of(middle - first);
  left.t += right.t;
  left.q *= right.q;
  return left;
}

/// The sum of x^k/(f(1) ... f(k)) for k >= 1, x = p/2^scale, |x| <= 2^-small <= 1/2, in units of
/// 2^-bits, within 2: the first term left out is below half a unit and each one less than half of
/// the one before; cutting off loses less than one.
template <class Factor>
integer series_at(const integer& p, long scale, long small, long bits, Factor factor) {
  long terms = 0;
  long known = 0;
  while (known < bits + 2) {
    ++terms;
    known += small + static_cast<long>(std::bit_width(factor(terms))) - 1;
  }
  powers_by_length powers(p);
  (void)powers.make(terms);
  partial_sum sum = sum_of_terms(0, terms, powers, scale, factor);
  const long shift = bits - scale * terms;
  if (shift >= 0) {
    sum.t <<= static_cast<unsigned long>(shift);
  } else {
    sum.t >>= static_cast<unsigned long>(-shift);
  }
  integer quotient;
  mpz_fdiv_q(quotient.backend().data(), sum.t.backend().data(), sum.q.backend().data());
  return quotient;
}

}  // namespace
}  // namespace bit_burst_impl

integer expm1_of_short(const integer& a, long scale, long small, long bits) {
  return bit_burst_impl::series_at(a, scale, small, bits,
                                   [](long k) { return static_cast<unsigned long>(k); });
}

// sin x = x + x g(-x^2), g = the sum of z^k/((2 3)(4 5)...(2k (2k+1))). |x| <= 1/2 makes less than
// 1 of the error of g, and cutting off loses less than 1.
integer sine_of_short(const integer& a, long scale, long small, long bits) {
  const integer g =
      bit_burst_impl::series_at(integer(-(a * a)), 2 * scale, 2 * small, bits, [](long k) {
        return static_cast<unsigned long>(2 * k) * static_cast<unsigned long>(2 * k + 1);
      });
  integer sum = (integer(1) << static_cast<unsigned long>(bits)) + g;
  sum *= a;
  sum >>= static_cast<unsigned long>(scale);
  return sum;
}

}  // namespace polhode::detail::fixed_point
