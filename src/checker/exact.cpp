#include "exact.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace polhode::checker {
namespace {

mpz_srcptr raw(const integer& n) { return n.backend().data(); }
mpz_ptr raw(integer& n) { return n.backend().data(); }

bool all_digits(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Digits, leading zeros allowed.
integer from_digits(std::string_view digits) {
  integer result;
  mpz_set_str(raw(result), std::string(digits).c_str(), 10);
  return result;
}

/// The e with 10^e <= q < 10^(e+1), q > 0.
long decimal_exponent(const rational& q) {
  const auto bits = bit_length(integer(numerator(q))) - bit_length(integer(denominator(q)));
  auto e = static_cast<long>(static_cast<double>(bits) * 0.30103) - 2;
  while (power_of_ten(e + 1) <= q) ++e;
  return e;
}

}  // namespace

integer floor_quotient(const integer& n, const integer& d) {
  integer result;
  mpz_fdiv_q(raw(result), raw(n), raw(d));
  return result;
}
integer ceiling_quotient(const integer& n, const integer& d) {
  integer result;
  mpz_cdiv_q(raw(result), raw(n), raw(d));
  return result;
}
integer floor_shift(const integer& n, long k) {
  integer result;
  mpz_fdiv_q_2exp(raw(result), raw(n), static_cast<mp_bitcnt_t>(k));
  return result;
}
integer ceiling_shift(const integer& n, long k) {
  integer result;
  mpz_cdiv_q_2exp(raw(result), raw(n), static_cast<mp_bitcnt_t>(k));
  return result;
}
integer floor_root(const integer& n) {
  integer result;
  mpz_sqrt(raw(result), raw(n));
  return result;
}
long bit_length(const integer& n) {
  return n == 0 ? 0 : static_cast<long>(mpz_sizeinbase(raw(n), 2));
}
long bit_length(const rational& q) {
  return bit_length(integer(numerator(q))) + bit_length(integer(denominator(q)));
}
long words(const integer& n) { return static_cast<long>(mpz_size(raw(n))); }
rational power_of_two(long k) {
  const integer power = integer(1) << static_cast<unsigned>(std::abs(k));
  return k < 0 ? rational(integer(1), power) : rational(power);
}
rational power_of_ten(long k) {
  integer power;
  mpz_ui_pow_ui(raw(power), 10, static_cast<unsigned long>(std::abs(k)));
  return k < 0 ? rational(integer(1), power) : rational(power);
}
bool exact_root(const rational& q, rational& root) {
  if (q < 0) return false;
  const integer n = numerator(q);
  const integer d = denominator(q);
  const integer n_root = floor_root(n);
  const integer d_root = floor_root(d);
  if (n_root * n_root != n || d_root * d_root != d) return false;
  root = rational(n_root, d_root);
  return true;
}

bool read_integer(std::string_view text, integer& value) {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  if (!all_digits(text) || (text.front() == '0' && (text.size() > 1 || negative))) return false;
  value = from_digits(text);
  if (negative) value = -value;
  return true;
}

bool read_rational(std::string_view text, rational& value) {
  const auto slash = text.find('/');
  integer n;
  integer d(1);
  if (!read_integer(text.substr(0, slash), n)) return false;
  if (slash != std::string_view::npos &&
      (!read_integer(text.substr(slash + 1), d) || d < 2 || gcd(n, d) != 1)) {
    return false;
  }
  value = rational(n, d);
  return true;
}

bool read_decimal(std::string_view text, rational& value) {
  constexpr std::size_t most_exponent_digits = 6;
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  const auto e = text.find('e');
  long exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view digits = text.substr(e + 1);
    const bool small = !digits.empty() && digits.front() == '-';
    if (small) digits.remove_prefix(1);
    if (!all_digits(digits) || digits.size() > most_exponent_digits) return false;
    exponent = std::strtol(std::string(digits).c_str(), nullptr, 10);
    if (small) exponent = -exponent;
  }
  const std::string_view digits = text.substr(0, e);
  const auto point = digits.find('.');
  const std::string_view whole = digits.substr(0, point);
  if (!all_digits(whole)) return false;
  std::string all(whole);
  if (point != std::string_view::npos) {
    const std::string_view fraction = digits.substr(point + 1);
    if (!all_digits(fraction)) return false;
    all += fraction;
    exponent -= static_cast<long>(fraction.size());
  }
  value = rational(from_digits(all)) * power_of_ten(exponent);
  if (negative) value = -value;
  return true;
}

long bits_of_decimal(std::string_view text) {
  constexpr std::size_t most_exponent_digits = 6;
  long exponent = 0;
  if (const auto e = text.find('e'); e != std::string_view::npos) {
    std::string_view digits = text.substr(e + 1);
    if (!digits.empty() && digits.front() == '-') digits.remove_prefix(1);
    if (digits.size() <= most_exponent_digits) {
      exponent = std::strtol(std::string(digits).c_str(), nullptr, 10);
    }
  }
  return 4 * (static_cast<long>(text.size()) + std::abs(exponent)) + 64;
}

std::string decimal(const rational& q, long digits, rounding way, budget& work) {
  if (q == 0) return "0";
  work.rationals(4, bit_length(q) + 4 * digits + 64);
  const bool negative = q < 0;
  const rational size = negative ? rational(-q) : q;
  long e = decimal_exponent(size);
  const rational scaled(size * power_of_ten(digits - 1 - e));
  const bool away = (way == rounding::down && negative) || (way == rounding::up && !negative);
  const integer n = numerator(scaled);
  const integer d = denominator(scaled);
  std::string text = (away ? ceiling_quotient(n, d) : floor_quotient(n, d)).str();
  if (static_cast<long>(text.size()) > digits) {  // 999... rounded up
    text.pop_back();
    ++e;
  }
  if (way != rounding::to_zero) {
    while (text.size() > 1 && text.back() == '0') text.pop_back();
  }
  // Without an exponent where the digits end before the units.
  constexpr long most_filled = 25;
  if (way != rounding::to_zero && e >= 0 && e < most_filled) {
    while (static_cast<long>(text.size()) <= e) text += '0';
  }
  const std::string sign = negative ? "-" : "";
  const auto count = static_cast<long>(text.size());
  if (e + 1 > count || e + 1 < -5) {
    const std::string rest = text.substr(1);
    return sign + text.substr(0, 1) + (rest.empty() ? "" : "." + rest) + "e" + std::to_string(e);
  }
  if (e < 0) return sign + "0." + std::string(static_cast<std::size_t>(-e - 1), '0') + text;
  const auto whole = static_cast<std::size_t>(e + 1);
  return sign + text.substr(0, whole) + (count > e + 1 ? "." + text.substr(whole) : "");
}

std::string decimal_for_reading(const rational& q, long digits, budget& work) {
  std::string text = decimal(q, digits, rounding::to_zero, work);
  work.decimals(bits_of_decimal(text));
  rational again;
  if (read_decimal(text, again) && again == q) return decimal(q, digits, rounding::down, work);
  const auto e = text.find('e');
  return e == std::string::npos ? text + "..." : text.substr(0, e) + "..." + text.substr(e);
}

}  // namespace polhode::checker
