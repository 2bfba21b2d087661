#include "taylor_shift.hpp"

#include <algorithm>

namespace polhode::detail {

std::vector<integer> shifted_by_one(const std::vector<integer>& p) {
  // Horner's scheme: n passes of additions c[k] += c[k + 1]. A coefficient of the result is a sum
  // of binomial(j, k) p[j], below 2^(n + 1) max |p[j]|, and so is every number on the way. So all
  // of them are kept in two's complement with the same number of limbs, and no addition overflows.
  const std::size_t count = p.size();
  if (count < 2) return p;
  std::size_t bits = 0;
  for (const integer& c : p) bits = std::max(bits, mpz_sizeinbase(c.backend().data(), 2));
  const std::size_t limb_bits = GMP_NUMB_BITS;
  const std::size_t limbs = (bits + count + 2) / limb_bits + 1;
  std::vector<mp_limb_t> row(count * limbs, 0);
  const auto length = static_cast<mp_size_t>(limbs);
  for (std::size_t k = 0; k < count; ++k) {
    const mpz_srcptr c = p[k].backend().data();
    mp_limb_t* const place = row.data() + k * limbs;
    mpn_copyi(place, mpz_limbs_read(c), static_cast<mp_size_t>(mpz_size(c)));
    if (mpz_sgn(c) < 0) mpn_neg(place, place, length);
  }
  for (std::size_t pass = 0; pass + 1 < count; ++pass) {
    for (std::size_t k = count - 1; k-- > pass;) {
      mp_limb_t* const place = row.data() + k * limbs;
      mpn_add_n(place, place, place + limbs, length);
    }
  }
  std::vector<integer> result(count);
  for (std::size_t k = 0; k < count; ++k) {
    mp_limb_t* const place = row.data() + k * limbs;
    const bool negative = (place[limbs - 1] >> (limb_bits - 1)) != 0;
    if (negative) mpn_neg(place, place, length);
    const mpz_ptr c = result[k].backend().data();
    mpn_copyi(mpz_limbs_write(c, length), place, length);
    mpz_limbs_finish(c, negative ? -length : length);
  }
  return result;
}

long sign_changes(const std::vector<integer>& p) {
  long changes = 0;
  int last = 0;
  for (const integer& c : p) {
    const int s = c.sign();
    if (s != 0 && last != 0 && s != last) ++changes;
    if (s != 0) last = s;
  }
  return changes;
}

}  // namespace polhode::detail
