#pragma once

// PARI beside certified values. Only where POLHODE_HAVE_PARI is defined. Its macros take many a
// name: it is included last.

#include <cmath>
#include <string>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"

#include <pari/pari.h>

namespace polhode::bench {

inline void start_pari() {
  constexpr std::size_t stack = std::size_t{1} << 28U;
  pari_init(stack, 2);
  GP_DATA->fmt->sigd = -1;  // all digits that there are
}

/// Leaves PARI's stack as it was.
template <class F>
void with_stack(const F& f) {
  const pari_sp before = avma;
  f();
  set_avma(before);
}

/// The size of x's relative error: "1e-58", at most that power of ten.
inline std::string error_text(GEN x, const ball& value, long digits) {
  char* const text = GENtostr(x);
  std::string decimals(text);
  pari_free(text);
  for (const char* exponent : {" E", "E"}) {
    const auto at = decimals.find(exponent);
    if (at != std::string::npos) {
      decimals.replace(at, std::string(exponent).size(), "e");
      break;
    }
  }
  const precision p = bits_for_digits(2 * digits);
  const ball found(parse_rational(decimals), p);
  const ball error = abs(found / value - 1);
  if (!error.is_bounded()) return "unknown";
  if (contains_zero(error)) return "none";
  const double exponent = mpfr_get_d(upper(log10(error)).backend().data(), MPFR_RNDU);
  return "1e" + std::to_string(std::lround(std::ceil(exponent)));
}

}  // namespace polhode::bench
