// The logarithm in fixed point, by tables with few limbs and by a correction with more.

#include <algorithm>
#include <bit>
#include <cstdint>

#include "arithmetic/functions/fixed_point/correction.hpp"
#include "arithmetic/functions/fixed_point/exponential.hpp"
#include "arithmetic/functions/fixed_point_functions.hpp"
#include "polhode/arithmetic/mpfr_cell.hpp"

namespace polhode::detail {

using namespace fixed_point;

namespace {

/// l = log x for 1 < x < 2, about, in its upper limbs: a choice.
bool set_first_logarithm(fraction& l, mpfr_srcptr x, long few, long w) {
  constexpr mpfr_prec_t guard = 32;
  mpfr_cell argument(64 * few + guard);
  mpfr_cell logarithm(64 * few);
  mpfr_set(argument.get(), x, MPFR_RNDZ);
  mpfr_set_exp(argument.get(), 1);
  magnitude error;
  if (!near_log(logarithm.get(), argument.get(), error)) return false;
  number value(few);
  load(value, logarithm.get(), mpfr_get_exp(logarithm.get()), few);
  // Not above log 2, so that e^l < 2.
  const log_2 log2(few);
  if (value[few] != 0 || mpn_cmp(value.data(), log2.data(), few) > 0) return false;
  mpn_copyi(l.data() + (w - few), value.data(), few);
  return true;
}

}  // namespace

bool near_log(mpfr_ptr r, mpfr_srcptr x, magnitude& error) {
  constexpr mpfr_exp_t most_exponent = mpfr_exp_t{1} << 20;
  if (mpfr_regular_p(x) == 0 || mpfr_sgn(x) < 0 || mpfr_get_exp(x) > most_exponent ||
      mpfr_get_exp(x) < -most_exponent || !may_be_own()) {
    return false;
  }
  // x = (1 + f) 2^e, exactly. Near 1 the logarithm begins as many bits behind the point as x and 1
  // have in common.
  const mpfr_exp_t e = mpfr_get_exp(x) - 1;
  const auto* significand = static_cast<const limb*>(mpfr_custom_get_significand(x));
  const limb top = significand[(mpfr_get_prec(x) - 1) / 64];
  const long in_common = e == 0 ? std::countl_zero(top << 1) : (e == -1 ? std::countl_one(top) : 0);
  const long w = limbs_for(std::max(mpfr_get_prec(r), mpfr_get_prec(x)), in_common);
  if (w > most_limbs || in_common > 32) return false;
  number f(w);
  load(f, x, 1, w);
  f[w] = 0;
  const auto turns = static_cast<limb>(e < 0 ? -e : e);
  // value = log(1 + f), and e log 2 is added.
  const auto finish = [&](number& value, std::uint64_t units) {
    const log_2 log2(w);
    if (e < 0) {
      value[w] -= mpn_submul_1(value.data(), log2.data(), w, turns);
    } else {
      value[w] += mpn_addmul_1(value.data(), log2.data(), w, turns);
    }
    const bool negative = is_negative(value, w);
    if (negative) mpn_neg(value.data(), value.data(), w + 1);
    return store(r, value, w, negative ? -1 : 1, 0, units + turns, error);
  };
  if (is_tabulated(w)) {
    number value(w);
    const auto units = tabulated_log1p(value.data(), f.data(), w);
    return units && finish(value, *units);
  }
  // log(1 + f) = l + 2 atanh((1 + f - e^l) / (1 + f + e^l)).
  fraction l(w);
  mpn_zero(l.data(), w);
  if (const long few = limbs_of_first_value(w); few == 1) {
    l[w - 1] = first_logarithm(f[w - 1]);
  } else if (!set_first_logarithm(l, x, few, w)) {
    return false;
  }
  fraction m(w);
  const std::uint64_t units = expm1_of_fraction(m.data(), l.data(), w);
  fraction num(w);
  const bool below = difference(num, f.data(), m.data(), w);
  number den(w);
  den[w] = 2 + mpn_add_n(den.data(), f.data(), m.data(), w);
  number correction(w);
  if (!arctangent_of_quotient(correction, num.data(), den, w, true)) return false;
  // The error of m, through d/dE of (F - E) / (F + E), which is below 2 F / (F + E)^2 <= 1 for E, F
  // >= 1, twice; and that of log 2, |e| units.
  number value(w);
  mpn_copyi(value.data(), l.data(), w);
  value[w] = 0;
  for (int i = 0; i < 2; ++i) {
    if (below) {
      mpn_sub_n(value.data(), value.data(), correction.data(), w + 1);
    } else {
      mpn_add_n(value.data(), value.data(), correction.data(), w + 1);
    }
  }
  return finish(value, 2 * units + 6);
}

}  // namespace polhode::detail
