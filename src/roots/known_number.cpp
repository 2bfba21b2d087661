#include "polhode/roots/known_number.hpp"

namespace polhode::detail {

known_number sqrt(const known_number& x) {
  if (x.exact() && *x.exact() >= 0) {
    const mpq_srcptr q = x.exact()->backend().data();
    if (mpz_perfect_square_p(mpq_numref(q)) != 0 && mpz_perfect_square_p(mpq_denref(q)) != 0) {
      rational root;
      mpz_sqrt(mpq_numref(root.backend().data()), mpq_numref(q));
      mpz_sqrt(mpq_denref(root.backend().data()), mpq_denref(q));
      return x.like(root);
    }
  }
  return known_number(sqrt(x.enclosure()));
}

// f(at) = value.
#define POLHODE_KNOWN_AT(f, at, value)          \
  known_number f(const known_number& x) {       \
    if (x.is_exactly(at)) return x.like(value); \
    return known_number(f(x.enclosure()));      \
  }
POLHODE_KNOWN_AT(exp, 0, 1)
POLHODE_KNOWN_AT(log, 1, 0)
POLHODE_KNOWN_AT(sin, 0, 0)
POLHODE_KNOWN_AT(cos, 0, 1)
POLHODE_KNOWN_AT(tan, 0, 0)
POLHODE_KNOWN_AT(asin, 0, 0)
POLHODE_KNOWN_AT(acos, 1, 0)
POLHODE_KNOWN_AT(atan, 0, 0)
POLHODE_KNOWN_AT(sinh, 0, 0)
POLHODE_KNOWN_AT(cosh, 0, 1)
POLHODE_KNOWN_AT(tanh, 0, 0)
POLHODE_KNOWN_AT(asinh, 0, 0)
POLHODE_KNOWN_AT(acosh, 1, 0)
POLHODE_KNOWN_AT(atanh, 0, 0)
#undef POLHODE_KNOWN_AT

}  // namespace polhode::detail
