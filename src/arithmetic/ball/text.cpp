#include "polhode/arithmetic/text.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <ostream>
#include <stdexcept>

#include "ball_access.hpp"
#include "polhode/arithmetic/certain_digits.hpp"

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

/// digits + n as a decimal numeral; false where it would need one digit more.
bool add_to_numeral(std::string& digits, unsigned long n) {
  for (std::size_t i = digits.size(); n != 0; n /= 10) {
    if (i == 0) return false;
    unsigned long sum = static_cast<unsigned long>(digits[--i] - '0') + n % 10;
    if (sum > 9) {
      sum -= 10;
      n += 10;
    }
    digits[i] = static_cast<char>('0' + sum);
  }
  return true;
}

/// x, with two digits, away from 0.
decimal two_digits_up(decimal x) {
  drop_trailing_zeros(x);
  if (x.digits.size() <= 2) return x;
  x.digits.resize(2);
  if (!add_to_numeral(x.digits, 1)) {
    x.digits = "1";
    ++x.exponent;
  }
  drop_trailing_zeros(x);
  return x;
}

/// The digits of x's size at the places 10^(first - 1), 10^(first - 2), ...: `count` of them.
std::string at_places(const decimal& x, long first, std::size_t count) {
  std::string result(static_cast<std::size_t>(first - x.exponent), '0');
  result += x.digits;
  result.resize(count, '0');
  return result;
}

/// The exponents of two decimals, if they lie further apart than this, differ by so much that a
/// difference of the sizes is at most the larger, and no less than all but 10^-39 of it.
constexpr long far_apart = 40;

/// A decimal of two digits, at least |x - y|.
decimal distance_up(const decimal& x, const decimal& y) {
  if (x.digits.empty()) return two_digits_up({false, y.digits, y.exponent});
  if (y.digits.empty()) return two_digits_up({false, x.digits, x.exponent});
  const bool x_first = x.exponent >= y.exponent;
  const decimal& greater = x_first ? x : y;
  const decimal& smaller = x_first ? y : x;
  if (greater.exponent - smaller.exponent > far_apart) {
    // At most |greater| + |smaller|, and |smaller| is less than a unit of the digit after next of
    // the greater.
    decimal sum = two_digits_up({false, greater.digits, greater.exponent});
    if (sum.digits.size() < 2) sum.digits += '0';
    if (!add_to_numeral(sum.digits, 1)) {
      sum.digits = "1";
      ++sum.exponent;
    }
    return sum;
  }
  // Aligned, with one place to the left for a carry.
  const long first = greater.exponent + 1;
  const auto places = [&](const decimal& z) {
    return static_cast<std::size_t>(first - z.exponent) + z.digits.size();
  };
  const std::size_t count = std::max(places(x), places(y));
  std::string a = at_places(x, first, count);
  std::string b = at_places(y, first, count);
  if (x.negative == y.negative) {
    if (a < b) std::swap(a, b);
    for (std::size_t i = count, borrow = 0; i-- > 0;) {
      const int digit = a[i] - b[i] - static_cast<int>(borrow);
      borrow = digit < 0 ? 1 : 0;
      a[i] = static_cast<char>('0' + digit + (borrow != 0 ? 10 : 0));
    }
  } else {
    for (std::size_t i = count, carry = 0; i-- > 0;) {
      const int digit = (a[i] - '0') + (b[i] - '0') + static_cast<int>(carry);
      carry = digit > 9 ? 1 : 0;
      a[i] = static_cast<char>('0' + digit - (carry != 0 ? 10 : 0));
    }
  }
  const auto start = a.find_first_not_of('0');
  if (start == std::string::npos) return {};
  return two_digits_up({false, a.substr(start), first - static_cast<long>(start)});
}

/// Whether |x| <= |y|.
bool is_at_most(const decimal& x, const decimal& y) {
  if (x.digits.empty() || y.digits.empty()) return x.digits.empty();
  if (x.exponent != y.exponent) return x.exponent < y.exponent;
  // Numerals without trailing zeros compare as texts.
  decimal a = x;
  decimal b = y;
  drop_trailing_zeros(a);
  drop_trailing_zeros(b);
  return a.digits <= b.digits;
}

/// The greatest n <= most for which the radius is at most one unit of the n-th significant digit of
/// the value; or 0.
long digits_within(const decimal& value, const decimal& radius, long most) {
  if (value.digits.empty()) return 0;
  if (radius.digits.empty()) return most;
  // The radius is below 10^radius.exponent, and 10^(radius.exponent - 1) where its one digit is 1;
  // the unit of the n-th digit is 10^(value.exponent - n).
  const long unit = radius.digits == "1" ? radius.exponent - 1 : radius.exponent;
  return std::clamp(value.exponent - unit, 0L, most);
}

/// The two ends as they are printed, and what is printed of the value beside them, which is cut off
/// or rounded.
decimal_enclosure assembled(const decimal& value, decimal low, decimal high, long shared,
                            long most_digits) {
  const bool cut = shared >= most_digits;
  for (decimal* end : {&low, &high}) {
    drop_trailing_zeros(*end);
    fill_to_units(*end);
  }
  const decimal below = distance_up(value, low);
  const decimal above = distance_up(high, value);
  const decimal& radius = is_at_most(below, above) ? above : below;
  decimal_enclosure result;
  result.value = written(value);
  result.radius = written(radius);
  result.lower = written(low);
  result.upper = written(high);
  result.cut = cut;
  result.shared = shared;
  result.digits =
      cut ? static_cast<long>(value.digits.size()) : digits_within(value, radius, most_digits);
  return result;
}

/// ceil(width / 10^exponent), or 0 where that is beyond 10^6.
unsigned long width_in_units(mpfr_srcptr width, long exponent) {
  constexpr unsigned long most = 1'000'000;
  mpfr_cell unit(64);
  mpfr_cell quotient(64);
  mpfr_ui_pow_ui(unit.get(), 10, static_cast<unsigned long>(std::abs(exponent)),
                 exponent < 0 ? MPFR_RNDU : MPFR_RNDD);
  if (exponent < 0) {
    mpfr_mul(quotient.get(), width, unit.get(), MPFR_RNDU);
  } else {
    mpfr_div(quotient.get(), width, unit.get(), MPFR_RNDU);
  }
  if (!(mpfr_cmp_ui(quotient.get(), most) < 0)) return 0;
  return mpfr_get_ui(quotient.get(), MPFR_RNDU) + 1;
}

/// Numerals of one size below and above the sizes of all members of a narrow set of one sign, and
/// the sign.
struct numerals {
  int sign;
  decimal below;
  std::string above;
};

/// Numerals that share their first so many digits, from a single conversion to decimals, which is
/// most of the cost at many digits: of |x|'s lower end, cut off after 8 digits more than asked for.
/// Every member's size then lies between that numeral and the numeral plus the width in units of
/// its last digit plus 1.
std::optional<numerals> numerals_sharing(const end_points& e, long most_digits) {
  const int sign = mpfr_sgn(e.lower());
  if (sign == 0 || sign != mpfr_sgn(e.upper())) return std::nullopt;
  numerals result{sign, rounded(sign > 0 ? e.lower() : e.upper(), most_digits + 8, MPFR_RNDZ), {}};
  result.below.negative = sign < 0;
  mpfr_cell width(64);
  mpfr_sub(width.get(), e.upper(), e.lower(), MPFR_RNDU);
  const unsigned long units =
      width_in_units(width.get(), result.below.exponent - (most_digits + 8));
  result.above = result.below.digits;
  if (units == 0 || !add_to_numeral(result.above, units + 1)) return std::nullopt;
  // A set this narrow changes a wanted digit only by a carry through a run of nines, which may be
  // the numerals' and not the ends': the ends decide.
  const auto wanted = static_cast<std::size_t>(most_digits);
  if (result.below.digits.compare(0, wanted, result.above, 0, wanted) != 0) return std::nullopt;
  return result;
}

/// The enclosure of a narrow set of one sign.
std::optional<decimal_enclosure> narrow_enclosure(const end_points& e, long most_digits) {
  std::optional<numerals> n = numerals_sharing(e, most_digits);
  if (!n) return std::nullopt;
  decimal value = n->below;
  value.digits.resize(static_cast<std::size_t>(most_digits));
  decimal low = std::move(n->below);
  decimal high{low.negative, std::move(n->above), low.exponent};
  low.digits.resize(value.digits.size() + 3);
  high.digits.resize(value.digits.size() + 3);
  if (!add_to_numeral(high.digits, 1)) return std::nullopt;
  if (n->sign < 0) std::swap(low, high);
  return assembled(value, std::move(low), std::move(high), most_digits, most_digits);
}

/// The middle of the ends, to nearest, with the digits that its distance from them gives a meaning;
/// at most so many.
decimal rounded_middle(const end_points& e, long most_digits, precision p) {
  mpfr_cell middle(p);
  mpfr_cell half(64);
  mpfr_cell half_of_lower(p);
  mpfr_div_2ui(half_of_lower.get(), e.lower(), 1, MPFR_RNDN);
  mpfr_div_2ui(middle.get(), e.upper(), 1, MPFR_RNDN);
  mpfr_sub(half.get(), middle.get(), half_of_lower.get(), MPFR_RNDU);
  mpfr_add(middle.get(), middle.get(), half_of_lower.get(), MPFR_RNDN);
  if (mpfr_zero_p(middle.get()) != 0) return {};
  const long first = rounded(middle.get(), 2, MPFR_RNDZ).exponent;
  const long last = mpfr_zero_p(half.get()) != 0 ? first - most_digits
                                                 : rounded(half.get(), 2, MPFR_RNDU).exponent - 2;
  if (first <= last) return {};
  // mpfr_get_str takes 1 digit and more.
  decimal result = rounded(middle.get(), std::min(first - last, most_digits), MPFR_RNDN);
  drop_trailing_zeros(result);
  fill_to_units(result);
  return result;
}

/// How many digits to look at for that many wanted: no more than there can be. An exact number of p
/// bits and exponent e has at most p + |e| digits, fewer than its bits before and after the point;
/// the ends of other balls are computed to p + 32 bits and share no more digits than that.
long useful_digits(const ball& x, long most_digits) {
  if (most_digits < 1) {
    throw std::invalid_argument(std::to_string(most_digits) + " digits: it must be at least 1");
  }
  long most = x.precision() + 64;
  const mpfr_srcptr first = ball_access::first(x);
  if (x.is_exact() && mpfr_regular_p(first) != 0) most += std::abs(mpfr_get_exp(first));
  return std::min(most_digits, most);
}

}  // namespace

decimal_enclosure to_decimal_enclosure(const ball& x, long most_digits) {
  most_digits = useful_digits(x, most_digits);
  if (!x.is_bounded()) throw std::domain_error("an unbounded ball has no decimals");
  const end_points e(x, x.precision() + 32);
  if (mpfr_number_p(e.lower()) == 0 || mpfr_number_p(e.upper()) == 0) {
    throw std::domain_error("a ball beyond the greatest exponent has no decimals");
  }
  if (!x.is_exact()) {
    if (auto narrow = narrow_enclosure(e, most_digits)) return *std::move(narrow);
  }

  decimal low = rounded(e.lower(), most_digits, MPFR_RNDZ);
  decimal high = rounded(e.upper(), most_digits, MPFR_RNDZ);
  decimal shared;
  if (low.negative == high.negative && low.exponent == high.exponent) {
    const auto difference =
        std::mismatch(low.digits.begin(), low.digits.end(), high.digits.begin(), high.digits.end());
    shared = low;
    shared.digits.assign(low.digits.begin(), difference.first);
  }
  const long shared_digits = static_cast<long>(shared.digits.size());
  if (x.is_exact()) {
    // Read the digits back: the number is all there when they give it again.
    mpfr_cell again(x.precision());
    const std::string text = written(shared);
    const bool converted_exactly =
        mpfr_strtofr(again.get(), text.c_str(), nullptr, 10, MPFR_RNDN) == 0;
    if (converted_exactly && mpfr_equal_p(again.get(), e.lower()) != 0) {
      drop_trailing_zeros(shared);
      fill_to_units(shared);
      decimal_enclosure result = assembled(shared, shared, shared, most_digits, most_digits);
      result.shared = result.digits;
      result.exact = true;
      return result;
    }
  }

  // As many digits as the ball's width gives a meaning, though the two ends may share fewer: 2 may
  // lie between 1.9999 and 2.0001.
  long meaningful = 1;
  const magnitude width = x.radius();
  const magnitude size = x.magnitude_upper();
  if (!width.is_zero() && !width.is_infinite() && !size.is_zero()) {
    const auto bits = static_cast<double>(size.log2_floor() - width.log2_floor());
    meaningful =
        static_cast<long>(std::clamp(bits * 0.30103, 1.0, static_cast<double>(most_digits)));
  }
  const long more = std::max(shared_digits, meaningful) + 3;
  low = rounded(e.lower(), more, MPFR_RNDD);
  high = rounded(e.upper(), more, MPFR_RNDU);
  const bool cut = shared_digits >= most_digits;
  const decimal value = cut ? shared : rounded_middle(e, most_digits, x.precision() + 64);
  return assembled(value, std::move(low), std::move(high), shared_digits, most_digits);
}

bool shows_digits(const ball& x, long digits) {
  if (!x.is_bounded()) return false;
  // Without the texts of an enclosure, where that is enough.
  if (!x.is_exact() && useful_digits(x, digits) == digits) {
    const end_points e(x, x.precision() + 32);
    if (mpfr_number_p(e.lower()) != 0 && mpfr_number_p(e.upper()) != 0 &&
        numerals_sharing(e, digits)) {
      return true;
    }
  }
  if (to_decimal_enclosure(x, digits).has_cut(digits)) return true;
  constexpr long spare = 30;
  return to_decimal_enclosure(x, digits + spare).has(digits + spare);
}

std::string to_text(const decimal_enclosure& d) {
  if (d.exact) return d.value;
  if (!d.cut) return d.value + " ± " + d.radius;
  const auto e = d.value.find('e');
  if (e == std::string::npos) return d.value + "...";
  return d.value.substr(0, e) + "..." + d.value.substr(e);
}

std::string to_decimal(const ball& x, long most_digits) {
  most_digits = useful_digits(x, most_digits);
  if (x.is_undefined()) return "undefined";
  const end_points ends(x, x.precision() + 32);
  if (mpfr_inf_p(ends.lower()) != 0 || mpfr_inf_p(ends.upper()) != 0) {
    // At least one end is infinite; the other is printed outward.
    const auto end = [&](mpfr_srcptr value, mpfr_rnd_t rounding) -> std::string {
      if (mpfr_inf_p(value) != 0) return mpfr_sgn(value) < 0 ? "-inf" : "inf";
      return written(rounded(value, most_digits, rounding));
    };
    return '[' + end(ends.lower(), MPFR_RNDD) + ", " + end(ends.upper(), MPFR_RNDU) + ']';
  }
  const decimal_enclosure d = to_decimal_enclosure(x, most_digits);
  constexpr long few = 3;
  if (d.cut || d.exact || d.digits >= std::min(few, most_digits)) return to_text(d);
  return '[' + d.lower + ", " + d.upper + ']';
}

std::ostream& operator<<(std::ostream& out, const ball& x) {
  const long width = std::max<long>(out.precision(), 1);
  return out << to_decimal(x, width);
}

}  // namespace polhode
