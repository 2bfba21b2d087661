#include "erf_series.hpp"

#include <algorithm>
#include <utility>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/special_functions.hpp"

namespace polhode::detail {

namespace erf_series_impl {
namespace {

template <class T>
T sum_of_terms(const T& w, precision bits, std::int64_t small) {
  constexpr precision least_bits = 48;
  constexpr precision at_once = 64;
  constexpr precision spare = 16;
  const magnitude size = w.magnitude_upper();
  T sum(ball(1, bits));
  T term = sum;
  T factor = w;
  std::int64_t greatest = 0;  // of the exponents of the terms
  magnitude previous = magnitude::infinity();
  for (long k = 0;; ++k) {
    term = term * factor / (2 * k + 3);
    sum += term;
    const magnitude last = term.magnitude_upper();
    // |w|/(2 (k + 1) + 3) <= 1/2: from t_(k+1) on each term is at most half the one before it.
    const bool falls =
        !(magnitude::from_bits_down(static_cast<std::uint64_t>(2 * k + 5), -1) < size);
    if (last.is_zero()) return sum;
    if (last.is_infinite()) return sum.enlarged(last);
    greatest = std::max(greatest, last.log2_floor());
    const std::int64_t below = last.log2_floor() - greatest;
    // A term at the least exponent does not become smaller.
    if (falls && (below < -small || !(last < previous))) return sum.enlarged(last);
    previous = last;
    // A term needs the bits that it has above the last place of the sum.
    const precision wanted =
        std::min<std::int64_t>(bits, std::max<std::int64_t>(least_bits, below + bits + spare));
    if (falls && wanted + at_once < term.precision()) {
      term = term.with_precision(wanted);
      factor = w.with_precision(wanted);
    }
  }
}

template <class T>
struct value_and_slope {
  T value, slope;
};
/// erf and its derivative (2/sqrt(pi)) e^(-z^2) at a point, with errors of about 2^-bits of them;
/// `lost` bits cancel in the sum.
template <class T>
value_and_slope<T> erf_at(const T& z, precision bits, precision lost) {
  const T own = z.with_precision(bits + lost);
  const T square_of_z = square(own);
  const T sum = sum_of_terms(T(scale(square_of_z, 1)), bits + lost, bits + lost);
  T slope = scale(exp(-square_of_z), 1) / sqrt(pi(bits + lost));
  return {own * slope * sum, std::move(slope)};
}

}  // namespace
}  // namespace erf_series_impl

ball sum_of_erf(const ball& w, precision bits, std::int64_t small) {
  return erf_series_impl::sum_of_terms(w, bits, small);
}
complex_ball sum_of_erf(const complex_ball& w, precision bits, std::int64_t small) {
  return erf_series_impl::sum_of_terms(w, bits, small);
}

std::optional<ball> erf_by_series(const ball& x) {
  using namespace erf_series_impl;
  constexpr precision most_bits = 1L << 13;
  constexpr precision guard = 16;
  constexpr std::int64_t narrow = 20;
  if (!x.is_bounded() || x.precision() > most_bits) return std::nullopt;
  const ball m = x.middle();
  const precision p = x.precision();
  const magnitude size = m.magnitude_upper();
  if (size.is_zero() || size.log2_floor() < -2 * p) return std::nullopt;
  // Beyond x^2 = p log(2) erf(x) is 1 to p bits, which MPFR sees at once.
  const auto most_square = static_cast<std::uint64_t>(0.7 * static_cast<double>(p));
  if (magnitude::from_integer_up(most_square) < multiply_up(size, size)) return std::nullopt;
  const bool is_exact = x.is_exact();
  if (!is_exact && !(x.radius().is_zero() || x.radius().log2_floor() < size.log2_floor() - narrow))
    return std::nullopt;
  const auto [value, slope] = erf_at(m, p + guard, 0);
  if (is_exact) return value.with_precision(p);
  // |t - m| <= r makes e^(-t^2) at most e^(2 |m| r) e^(-m^2), and e^y <= 1 + 2 y for 0 <= y <= 1;
  // here 2 |m| r <= 2^-19 m^2 <= 2^-19 0.7 p < 1.
  const magnitude r = x.radius();
  const magnitude steeper = add_up(magnitude::power_of_two(0), scale(multiply_up(size, r), 2));
  const magnitude steepest = multiply_up(slope.magnitude_upper(), steeper);
  return value.enlarged(multiply_up(r, steepest)).with_precision(p);
}

complex_ball erf_by_series(const complex_ball& z) {
  using namespace erf_series_impl;
  constexpr precision guard = 16;
  const precision p = z.precision();
  const magnitude most = magnitude::power_of_two(5);
  if (!z.is_bounded() || most < z.magnitude_upper()) return complex_ball::undefined(p);
  const complex_ball m = z.middle();
  // The terms are at most e^(|z|^2) in size, and the sum at least about e^(Re z^2)/|z|^2.
  const auto square_of_part = [](const ball& x) {
    const double y = mpfr_get_d(midpoint(x).backend().data(), MPFR_RNDN);
    return y * y;
  };
  constexpr double bits_of_e = 1.4427;
  const double lost = 2 * bits_of_e * square_of_part(m.im) + 16;
  const complex_ball value = erf_at(m, p + guard, static_cast<precision>(lost)).value;
  if (z.is_exact()) return value.with_precision(p);
  // erf(Z) - erf(m) is in (Z - m) (2/sqrt(pi)) e^(-W^2), W the convex set Z.
  const complex_ball slope = scale(exp(-square(z)) / sqrt(pi(p)), 1);
  return (value + (z - m) * slope).with_precision(p);
}

}  // namespace polhode::detail

namespace polhode {

complex_ball erf(const complex_ball& z) {
  if (sign_of(z.im) == certain_sign::zero) return complex_ball(erf(z.re));
  return detail::erf_by_series(z);
}

complex_ball erfc(const complex_ball& z) {
  if (sign_of(z.im) == certain_sign::zero) return complex_ball(erfc(z.re));
  return 1 - erf(z);
}

}  // namespace polhode
