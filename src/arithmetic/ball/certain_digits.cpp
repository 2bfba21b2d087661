#include "polhode/arithmetic/certain_digits.hpp"

#include "polhode/arithmetic/text.hpp"

namespace polhode {

precision ample_guard(long digits) { return 15 * bits_for_digits(digits) + 1024; }

ball enclose_to_digits(const enclosing_function& f, long digits, precision most_guard) {
  const precision needed = bits_for_digits(digits);
  for (precision guard = 32; guard <= most_guard; guard *= 2) {
    ball x = f(needed + guard);
    if (shows_digits(x, digits)) return x;
  }
  return ball::undefined(needed);
}

precision size_in_bits(const rational& q) {
  return static_cast<precision>(mpz_sizeinbase(numerator(q).backend().data(), 2) +
                                mpz_sizeinbase(denominator(q).backend().data(), 2));
}

}  // namespace polhode
