#include "polhode/real/ball_traits.hpp"

#include "polhode/arithmetic/boost_bridge.hpp"

std::size_t std::hash<polhode::ball>::operator()(const polhode::ball& x) const noexcept {
  if (x.is_undefined()) return 1;
  constexpr polhode::precision bits = 53;
  const auto of_end = [](mpfr_srcptr end) {
    if (mpfr_number_p(end) == 0) return static_cast<std::size_t>(mpfr_sgn(end) > 0 ? 2 : 3);
    long exponent = 0;
    const double mantissa = mpfr_get_d_2exp(&exponent, end, MPFR_RNDN);
    return std::hash<double>{}(mantissa)*31 + std::hash<long>{}(exponent);
  };
  mpfr_t end;
  mpfr_init2(end, bits);
  x.lower(end);
  const std::size_t of_lower = of_end(end);
  x.upper(end);
  const std::size_t of_upper = of_end(end);
  mpfr_clear(end);
  return of_lower * 1000003 + of_upper;
}
