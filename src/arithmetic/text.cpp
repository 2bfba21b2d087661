#include "polhode/arithmetic/text.hpp"

#include <algorithm>
#include <ostream>
#include <stdexcept>

#include "ball_access.hpp"

namespace polhode {

using detail::end_points;
using detail::mpfr_cell;

precision bits_for_digits(long digits) {
  if (digits < 1 || digits > 5'000'000'000) {
    throw std::invalid_argument("a number of " + std::to_string(digits) +
                                " digits: it must be from 1 to 5000000000");
  }
  // log2(10) = 3.32192809488... < 3.321928095. In two parts: no overflow.
  constexpr long numerator = 3'321'928'095;
  constexpr long denominator = 1'000'000'000;
  const long whole = digits / denominator * numerator;
  const long rest = digits % denominator * numerator;
  return whole + (rest + denominator - 1) / denominator;
}

namespace {

/// A finite decimal: 0.d1 d2 d3 ... * 10^exponent with a sign.
struct decimal {
  bool negative = false;
  std::string digits;  // without trailing zeros; empty for 0
  long exponent = 0;
};

decimal rounded(mpfr_srcptr x, long digits, mpfr_rnd_t rounding) {
  decimal result;
  if (mpfr_zero_p(x) != 0) return result;
  mpfr_exp_t exponent = 0;
  char* text = mpfr_get_str(nullptr, &exponent, 10, static_cast<std::size_t>(digits), x, rounding);
  if (text == nullptr) throw std::bad_alloc();
  result.negative = *text == '-';
  result.digits = text + (result.negative ? 1 : 0);
  mpfr_free_str(text);
  result.exponent = exponent;
  return result;
}

/// Positional where that is short, scientific elsewhere. Keeps trailing zeros: they are digits.
std::string written(const decimal& x) {
  if (x.digits.empty()) return "0";
  const long n = static_cast<long>(x.digits.size());
  std::string result = x.negative ? "-" : "";
  if (x.exponent > n || x.exponent < -5) {
    result += x.digits[0];
    if (n > 1) result += '.' + x.digits.substr(1);
    return result + 'e' + std::to_string(x.exponent - 1);
  }
  if (x.exponent <= 0) {
    return result + "0." + std::string(static_cast<std::size_t>(-x.exponent), '0') + x.digits;
  }
  result += x.digits.substr(0, static_cast<std::size_t>(x.exponent));
  if (x.exponent < n) result += '.' + x.digits.substr(static_cast<std::size_t>(x.exponent));
  return result;
}

void drop_trailing_zeros(decimal& x) {
  const auto last = x.digits.find_last_not_of('0');
  x.digits.resize(last == std::string::npos ? 0 : last + 1);
}

/// Writes an integer's decimals without an exponent where its digits end before its units.
void fill_to_units(decimal& x) {
  const auto units = static_cast<std::size_t>(std::max(x.exponent, 0L));
  if (x.digits.size() < units && units <= 25) x.digits.append(units - x.digits.size(), '0');
}

}  // namespace

decimal_enclosure to_decimal_enclosure(const ball& x, long most_digits) {
  if (most_digits < 1) {
    throw std::invalid_argument(std::to_string(most_digits) + " digits: it must be at least 1");
  }
  if (!x.is_bounded()) throw std::domain_error("an unbounded ball has no decimals");
  const end_points e(x, x.precision() + 32);
  decimal_enclosure result;

  decimal low = rounded(e.lower(), most_digits, MPFR_RNDZ);
  decimal high = rounded(e.upper(), most_digits, MPFR_RNDZ);
  decimal shared;
  if (low.negative == high.negative && low.exponent == high.exponent) {
    const auto difference =
        std::mismatch(low.digits.begin(), low.digits.end(), high.digits.begin(), high.digits.end());
    shared = low;
    shared.digits.assign(low.digits.begin(), difference.first);
  }
  result.digits = static_cast<long>(shared.digits.size());
  if (x.is_exact()) {
    // Read the digits back: the number is all there when they give it again.
    mpfr_cell again(x.precision());
    const std::string text = written(shared);
    const bool converted_exactly =
        mpfr_strtofr(again.get(), text.c_str(), nullptr, 10, MPFR_RNDN) == 0;
    result.exact = converted_exactly && mpfr_equal_p(again.get(), e.lower()) != 0;
    if (result.exact) {
      drop_trailing_zeros(shared);
      fill_to_units(shared);
    }
  }
  if (result.digits > 0 || result.exact) result.value = written(shared);

  const long more = std::max(result.digits, 1L) + 3;
  low = rounded(e.lower(), more, MPFR_RNDD);
  high = rounded(e.upper(), more, MPFR_RNDU);
  for (decimal* end : {&low, &high}) {
    drop_trailing_zeros(*end);
    fill_to_units(*end);
  }
  result.lower = written(low);
  result.upper = written(high);
  return result;
}

std::string to_decimal(const ball& x, long most_digits) {
  if (x.is_undefined()) return "undefined";
  if (!x.is_bounded()) {
    // At least one end is infinite; the other is printed outward.
    const end_points e(x, x.precision());
    const auto end = [&](mpfr_srcptr value, mpfr_rnd_t rounding) -> std::string {
      if (mpfr_inf_p(value) != 0) return mpfr_sgn(value) < 0 ? "-inf" : "inf";
      return written(rounded(value, most_digits, rounding));
    };
    return '[' + end(e.lower(), MPFR_RNDD) + ", " + end(e.upper(), MPFR_RNDU) + ']';
  }
  const decimal_enclosure d = to_decimal_enclosure(x, most_digits);
  if (d.exact) return d.value;
  if (d.digits == 0) return '[' + d.lower + ", " + d.upper + ']';
  const auto e = d.value.find('e');
  if (e == std::string::npos) return d.value + "...";
  return d.value.substr(0, e) + "..." + d.value.substr(e);
}

std::ostream& operator<<(std::ostream& out, const ball& x) {
  const long width = std::max<long>(out.precision(), 1);
  return out << to_decimal(x, width);
}

}  // namespace polhode
