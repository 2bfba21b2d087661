#include "checkable.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "polhode/arithmetic/text.hpp"

namespace polhode::detail {
namespace {

constexpr std::array known_names{"pi",    "sqrt", "exp",  "log",   "sin",   "cos",   "sinh",
                                 "cosh",  "atan", "tan",  "tanh",  "expm1", "log1p", "sinpi",
                                 "cospi", "asin", "acos", "asinh", "acosh", "atanh"};
constexpr std::size_t most_characters = 20'000;
constexpr int most_parentheses = 150;

std::string known_names_in_words() {
  std::string result;
  for (const char* name : known_names) result += (result.empty() ? "" : ", ") + std::string(name);
  return result;
}

std::string text_of(const expression& f, const char* what) {
  std::string text;
  try {
    text = f.to_text();
  } catch (const std::length_error&) {
    text = std::string(most_characters + 1, ' ');
  }
  if (text.size() > most_characters) {
    throw input_error(fmt::format("{} has more than {} characters, which a certificate may not",
                                  what, most_characters));
  }
  return text;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

void expect_known(const expression& f, const char* what) {
  const std::string text = text_of(f, what);
  int open = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    open += (text[i] == '(' ? 1 : 0) - (text[i] == ')' ? 1 : 0);
    if (open > most_parentheses) {
      throw input_error(
          fmt::format("{} has more than {} parentheses inside each other, which a "
                      "certificate may not",
                      what, most_parentheses));
    }
    if (!is_letter(text[i])) continue;
    std::size_t end = i;
    while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
    const std::string name = text.substr(i, end - i);
    const auto is_name = [&](const auto& known) { return name == known; };
    if (!std::any_of(f.variables().begin(), f.variables().end(), is_name) &&
        !std::any_of(known_names.begin(), known_names.end(), is_name)) {
      throw input_error(
          fmt::format("{} has {} in it, which no checker of certificates knows; it may have {}",
                      what, name, known_names_in_words()));
    }
    i = end - 1;
  }
}

rational power_of_two(long k) {
  const integer power = integer(1) << static_cast<unsigned>(std::abs(k));
  return k < 0 ? rational(integer(1), power) : rational(power);
}

std::optional<double> log2_of(const ball& x) {
  const magnitude m = x.magnitude_upper();
  if (m.is_zero() || m.is_infinite()) return std::nullopt;
  return static_cast<double>(m.log2_floor()) + 1;
}

long widening(const ball& x, double size, long digits) {
  if (!contains_zero(x)) size = *log2_of(x);
  auto k = static_cast<long>(std::floor(size)) - bits_for_digits(digits + 2);
  if (!x.radius().is_zero()) k = std::max(k, static_cast<long>(x.radius().log2_floor()) + 1);
  return k;
}

ball widened(const ball& x, long k, long digits) {
  const rational more = power_of_two(k);
  const precision p = bits_for_digits(digits) + 64;
  return hull(ball(lower_rational(x) - more, p), ball(upper_rational(x) + more, p));
}

void expect_at_most(long most, long digits, const char* what) {
  if (digits > most) {
    throw input_error(fmt::format("no certificate: {} digits are asked for; of {} it may have {}",
                                  digits, what, most));
  }
}

void expect_plain_variable(const std::string& name) {
  std::string small = name;
  for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  constexpr std::array others{"e", "i", "inf", "infinity", "nan", "euler_gamma", "catalan"};
  if (std::find(known_names.begin(), known_names.end(), small) != known_names.end() ||
      std::find(others.begin(), others.end(), small) != others.end() ||
      name.find_first_not_of("lIOo_0123456789") == std::string::npos) {
    throw input_error(fmt::format(
        "no certificate: the variable {} looks like something else in it; name it x", name));
  }
}

rational short_between(const rational& lower, const rational& upper) {
  rational unit(1);
  while (unit > upper - lower) unit /= 2;
  unit /= 4;
  const rational steps((lower + upper) / (2 * unit));
  return rational(integer(numerator(steps) / denominator(steps))) * unit;
}

}  // namespace polhode::detail
