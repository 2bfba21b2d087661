#include "arithmetic/functions/fixed_point/circular.hpp"

#include <algorithm>
#include <cstdint>

#include "arithmetic/functions/fixed_point/prime_reduction.hpp"
#include "arithmetic/functions/fixed_point/series.hpp"
#include "arithmetic/functions/fixed_point_functions.hpp"

namespace polhode::detail::fixed_point {

std::uint64_t versine_of_fraction(limb* v, const limb* t, long w) {
  const long zeros = leading_zeros(t, w);
  const long r = std::max(std::min(integer_sqrt(64 * w) / 3 + 1, 18L) - zeros, 1L);
  fraction y(w);
  fraction z(w);
  mpn_rshift(y.data(), t, w, static_cast<unsigned>(r));
  square(z.data(), y.data(), w);
  number sum(w);
  const long small = std::min(2 * (r + zeros), 32 * w);
  sum_series(sum, series::circular, z.data(), w, small);
  if (is_negative(sum, w)) mpn_zero(sum.data(), w + 1);  // nearer to v >= 0
  mpn_copyi(v, sum.data(), w);
  for (long i = 0; i < r; ++i) {
    fraction v2(w);
    square(v2.data(), v, w);
    mpn_lshift(v, v, w, 2);
    mpn_submul_1(v, v2.data(), w, 2);
  }
  return std::uint64_t{37} << (2 * r);
}

std::uint64_t sine_from_versine(limb* s, const limb* v, std::uint64_t units, long zeros, long w) {
  double_fraction square_of_s(w);
  fraction v2(w);
  square(v2.data(), v, w);
  mpn_zero(square_of_s.data(), w);
  limb* const top = square_of_s.data() + w;
  mpn_lshift(top, v, w, 1);
  mpn_sub_n(top, top, v2.data(), w);
  mpn_sqrtrem(s, nullptr, square_of_s.data(), 2 * w);
  return (units + 1) << (zeros + 2);
}

circular_errors sine_and_cosine(number* s, number* c, const limb* t, long zeros, long w) {
  fraction v(w);
  if (is_by_primes(w)) {
    fraction other(w);
    const std::uint64_t units = sine_and_cosine_by_primes(
        s != nullptr ? s->data() : v.data(), c != nullptr ? c->data() : other.data(), t, w);
    if (s != nullptr) (*s)[w] = 0;
    if (c != nullptr) (*c)[w] = 0;
    return {units, units};
  }
  const std::uint64_t units = versine_of_fraction(v.data(), t, w);
  circular_errors errors{0, units};
  if (s != nullptr) {
    errors.sine = sine_from_versine(s->data(), v.data(), units, zeros, w);
    (*s)[w] = 0;
  }
  if (c != nullptr) {
    mpn_zero(c->data(), w);
    (*c)[w] = 1 - mpn_sub_n(c->data(), c->data(), v.data(), w);
  }
  return errors;
}

}  // namespace polhode::detail::fixed_point

namespace polhode::detail {

using namespace fixed_point;

namespace {

/// Limbs for values of which the greater begins with `more` zero bits at most, or by halving with
/// half as many.
long limbs_beyond_tables(mpfr_prec_t p, long more) {
  const long by_halving = limbs_for_halving(p, 2 * more);
  if (!is_by_primes(by_halving)) return by_halving;
  return std::max(limbs_for_primes(p, more), most_limbs_for_halving + 1);
}

/// near_sin_cos where neither value is below about 2^-(range_log2 + near_zero). `lost` becomes the
/// zero bits at the top of a value that is below that, and so was not found.
near_pair sin_cos_beside(long near_zero, mpfr_ptr sine, mpfr_ptr cosine, mpfr_srcptr x,
                         magnitude& sine_error, magnitude& cosine_error, long& lost) {
  near_pair found{false, false};
  const mpfr_ptr either = sine != nullptr ? sine : cosine;
  if (mpfr_regular_p(x) == 0 || mpfr_get_exp(x) > range_log2 || mpfr_get_exp(x) < -range_log2 ||
      !may_be_own()) {
    return found;
  }
  const long small = std::max<long>(-mpfr_get_exp(x), 0);
  // With more limbs the two series by tables take longer than one by halving and a square root.
  constexpr long most_limbs_by_tables = 3;
  long w = limbs_for_tables(mpfr_get_prec(either), small + bits_of_turns(x) + near_zero);
  const bool tabulated = w <= (near_zero == 0 ? most_limbs_by_tables : most_tabulated_limbs);
  if (!tabulated) {
    w = limbs_beyond_tables(mpfr_get_prec(either), small + near_zero);
    // Halving would lose twice as many bits as there are zeros.
    if (near_zero > 0 && !is_by_primes(w)) return found;
  }
  if (w > most_limbs) return found;
  // |x| = n pi/4 + t, cut off by one unit, with an error of n units.
  number t(w);
  load(t, x, mpfr_get_exp(x), w);
  const quarter_pi eighth(w);
  const std::uint64_t n = reduce(t, eighth, w);
  // |x| = quarters * pi/2 + t, or - t.
  const std::uint64_t quarters = (n + 1) / 2;
  const bool minus = n % 2 != 0;
  if (minus) mpn_sub_n(t.data(), eighth.data(), t.data(), w);
  const long zeros = leading_zeros(t.data(), w);
  const bool is_small = zeros > range_log2 + near_zero;
  number sine_of_t(w);
  number cosine_of_t(w);
  circular_errors errors{};
  if (tabulated) {
    errors.sine = tabulated_sin_cos(sine_of_t.data(), cosine_of_t.data(), t.data(), w);
    errors.cosine = errors.sine;
    sine_of_t[w] = 0;
  } else {
    // The sine of |x| is that of t for even `quarters`, the cosine for odd ones.
    const bool even = quarters % 2 == 0;
    const bool wants_sine = (even ? sine : cosine) != nullptr && !is_small;
    const bool wants_cosine = (even ? cosine : sine) != nullptr;
    if (wants_sine || wants_cosine) {
      errors = sine_and_cosine(wants_sine ? &sine_of_t : nullptr,
                               wants_cosine ? &cosine_of_t : nullptr, t.data(), zeros, w);
    }
  }
  // By the quadrant: sin, cos, -sin, -cos (of t, or of -t) for the sine of |x|, and one on for the
  // cosine.
  const auto set = [&](mpfr_ptr r, std::uint64_t quadrant, bool negated, magnitude& error) {
    bool negative = negated != (quadrant % 4 >= 2);
    const bool by_sine = quadrant % 2 == 0;
    if (by_sine) {
      if (is_small) {
        lost = zeros;
        return false;
      }
      negative = negative != minus;
    }
    return store(r, by_sine ? sine_of_t : cosine_of_t, w, negative ? -1 : 1, 0,
                 (by_sine ? errors.sine : errors.cosine) + n + 2, error);
  };
  if (sine != nullptr) found.sine = set(sine, quarters, mpfr_sgn(x) < 0, sine_error);
  if (cosine != nullptr) found.cosine = set(cosine, quarters + 1, false, cosine_error);
  return found;
}

}  // namespace

near_pair near_sin_cos(mpfr_ptr sine, mpfr_ptr cosine, mpfr_srcptr x, magnitude& sine_error,
                       magnitude& cosine_error) {
  long lost = 0;
  near_pair found = sin_cos_beside(0, sine, cosine, x, sine_error, cosine_error, lost);
  if (lost == 0) return found;
  // One of them is near 0: its bits begin below those zeros.
  const mpfr_ptr missing_sine = found.sine ? nullptr : sine;
  const mpfr_ptr missing_cosine = found.cosine ? nullptr : cosine;
  const near_pair more =
      sin_cos_beside(lost, missing_sine, missing_cosine, x, sine_error, cosine_error, lost);
  return {found.sine || more.sine, found.cosine || more.cosine};
}

bool near_sin(mpfr_ptr r, mpfr_srcptr x, magnitude& error) {
  return near_sin_cos(r, nullptr, x, error, error).sine;
}
bool near_cos(mpfr_ptr r, mpfr_srcptr x, magnitude& error) {
  return near_sin_cos(nullptr, r, x, error, error).cosine;
}

}  // namespace polhode::detail
