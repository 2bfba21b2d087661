#include "exact_decimals.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "layout.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode::cli {
namespace {

integer ten_to_the(long n) {
  integer power;
  mpz_ui_pow_ui(power.backend().data(), 10, static_cast<unsigned long>(n));
  return power;
}

/// floor(q 10^n) for q >= 0, and whether that is exact.
integer shifted(const rational& q, long n, bool& exact) {
  integer above = numerator(q);
  integer below = denominator(q);
  (n >= 0 ? above : below) *= ten_to_the(std::abs(n));
  integer rest;
  integer result;
  mpz_fdiv_qr(result.backend().data(), rest.backend().data(), above.backend().data(),
              below.backend().data());
  exact = rest == 0;
  return result;
}

/// With the decimal point where it is short, else with an exponent. `places` is the number of
/// digits before the point.
std::string written(const std::string& digits, long places) {
  const auto n = static_cast<long>(digits.size());
  if (places > n || places < -5) {
    const std::string rest = n > 1 ? "." + digits.substr(1) : "";
    return fmt::format("{}{}e{}", digits.front(), rest, places - 1);
  }
  if (places <= 0) return "0." + std::string(static_cast<std::size_t>(-places), '0') + digits;
  const auto point = static_cast<std::size_t>(places);
  return digits.substr(0, point) + (places < n ? "." + digits.substr(point) : "");
}

}  // namespace

leading_digits leading_digits_of(const rational& q, long most) {
  if (q == 0) return {"0", 1, true};
  const rational size = abs(q);
  // The digits before the point, negative for zeros behind it: at least so many. The length that
  // GMP gives is the number's or one more.
  const auto length = [](const integer& n) {
    return static_cast<long>(mpz_sizeinbase(n.backend().data(), 10));
  };
  const long least_places = length(numerator(size)) - length(denominator(size)) - 1;
  leading_digits result;
  std::string digits = shifted(size, most - least_places, result.all).str();
  const long places = least_places + static_cast<long>(digits.size()) - most;
  const std::string cut = digits.substr(static_cast<std::size_t>(most));
  result.all = result.all && cut.find_first_not_of('0') == std::string::npos;
  digits.resize(static_cast<std::size_t>(most));
  if (result.all) {  // no zeros behind the last digit, but for those before the point
    const auto last = static_cast<long>(digits.find_last_not_of('0')) + 1;
    digits.resize(static_cast<std::size_t>(places > most ? last : std::max(last, places)));
  }
  result.digits = static_cast<long>(digits.size());
  result.value = (q < 0 ? "-" : "") + written(digits, places);
  return result;
}

bool is_short(const rational& q, long digits) {
  const auto most = static_cast<std::size_t>(std::max<long>(digits, terminal_columns));
  return mpz_sizeinbase(numerator(q).backend().data(), 10) <= most &&
         mpz_sizeinbase(denominator(q).backend().data(), 10) <= most;
}

std::string with_dots(const leading_digits& d) {
  if (d.all) return d.value;
  const auto exponent = std::min(d.value.find('e'), d.value.size());
  return d.value.substr(0, exponent) + "..." + d.value.substr(exponent);
}

std::string exact_text(const rational& q, long digits) {
  constexpr long usual = 40;  // most numbers have no more
  for (const long most : {std::min(usual, digits), digits}) {
    const leading_digits d = leading_digits_of(q, most);
    if (d.all) return d.value;
  }
  return to_text(q);
}

std::string exact_number_text(const rational& q, long digits) {
  if (is_short(q, digits)) return to_text(q) + " exactly";
  const leading_digits d = leading_digits_of(q, digits);
  return d.all ? with_dots(d) + " exactly" : with_dots(d);
}

std::string exact_answer(const rational& q, long digits) {
  const std::string decimals = with_dots(leading_digits_of(q, digits)) + '\n';
  if (!is_short(q, digits)) {
    return decimals + (denominator(q) == 1 ? "an integer, exactly known\n"
                                           : "a rational number, exactly known\n");
  }
  std::string result = to_text(q) + " exactly\n";
  if (denominator(q) != 1) result += decimals;
  return result;
}

std::string csv_cells(const rational& q) {
  constexpr long most = 40;
  return leading_digits_of(q, most).value + ',' + to_text(q);
}

std::string csv_cells(const exact_real& x) {
  constexpr long most = 40;
  return x.is_rational() ? csv_cells(x.exact()) : decimal_of(x, most) + ',';
}

std::string csv_header(const std::string& name) { return name + ',' + name + "_exact"; }

decimal_enclosure exact_decimals(const leading_digits& d) {
  decimal_enclosure result;
  result.value = result.lower = result.upper = d.value;
  result.radius = "0";
  result.digits = result.shared = d.digits;
  result.cut = result.exact = true;
  return result;
}

json exact_json(const rational& q, long digits) {
  const leading_digits d = leading_digits_of(q, digits);
  json number = to_json(ball(q, bits_for_digits(digits) + 64), digits);
  if (d.all) {
    number["value"] = number["lower"] = number["upper"] = d.value;
    number["radius"] = "0";
    number.erase("rounded");  // as the enclosure's decimals were
    number["digits"] = d.digits;
  }
  number["exact"] = true;
  number["rational"] = to_text(q);
  return number;
}

namespace {
/// Its enclosure with bits for the digits.
ball enclosed(const exact_real& x, long digits) { return x.at(bits_for_digits(digits) + 8); }
}  // namespace

json exact_json(const exact_real& x, long digits) {
  return x.is_rational() ? exact_json(x.exact(), digits) : to_json(enclosed(x, digits), digits);
}

std::string decimal_of(const exact_real& x, long digits) {
  if (x.is_rational()) return leading_digits_of(x.exact(), digits).value;
  return to_decimal_enclosure(enclosed(x, digits), digits).value;
}

std::string text_of_parts(const complex_ball& z, long digits) {
  if (!z.is_bounded()) return "undefined\n";
  const auto part = [&](const ball& x) {
    // What cannot be told from 0 is 0 with an error.
    const bool may_be_0 = contains_zero(x) && !x.radius().is_zero();
    const ball shown = may_be_0 ? ball(0, x.precision()).enlarged(x.magnitude_upper()) : x;
    return to_text(to_decimal_enclosure(shown, digits));
  };
  return fmt::format("real part      {}\nimaginary part {}\n", part(z.re), part(z.im));
}

}  // namespace polhode::cli
