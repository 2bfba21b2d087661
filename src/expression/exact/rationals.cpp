#include "expression/exact/rationals.hpp"

#include <algorithm>

#include "expression/exact_number.hpp"

namespace polhode::detail::exact_parts {

std::size_t bits_of(const rational& q) {
  return std::max(mpz_sizeinbase(mpq_numref(q.backend().data()), 2),
                  mpz_sizeinbase(mpq_denref(q.backend().data()), 2));
}
bool is_integer(const rational& q) { return denominator(q) == 1; }

long as_long(const integer& n) {
  if (mpz_fits_slong_p(n.backend().data()) == 0) throw not_decided();
  return mpz_get_si(n.backend().data());
}

rational integer_power_of(const rational& c, const integer& n) {
  if (c == 1 || n == 0) return 1;
  if (c == -1) return mpz_even_p(n.backend().data()) != 0 ? 1 : -1;
  const long exponent = as_long(n);
  const unsigned long size = exponent < 0 ? 0UL - static_cast<unsigned long>(exponent)
                                          : static_cast<unsigned long>(exponent);
  if (size > most_bits / bits_of(c)) throw not_decided();
  integer above = numerator(c);
  integer below = denominator(c);
  mpz_pow_ui(above.backend().data(), above.backend().data(), size);
  mpz_pow_ui(below.backend().data(), below.backend().data(), size);
  return exponent < 0 ? rational(rational(below) / rational(above))
                      : rational(rational(above) / rational(below));
}

}  // namespace polhode::detail::exact_parts
