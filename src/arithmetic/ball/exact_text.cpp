// Balls as text without loss.

#include <charconv>
#include <optional>
#include <string>

#include "ball_access.hpp"
#include "base/quoted.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode {

using detail::mpfr_cell;
using form = ball_access::form;

namespace {

constexpr precision greatest_text_precision = precision{1} << 26;

std::string power_text(long exponent) {
  return (exponent < 0 ? "p" : "p+") + std::to_string(exponent);
}

/// An integer without trailing zero bits times a power of two; "0", "inf", "-inf".
std::string number_text(mpfr_srcptr x) {
  if (mpfr_inf_p(x) != 0) return mpfr_sgn(x) < 0 ? "-inf" : "inf";
  if (mpfr_zero_p(x) != 0) return "0";
  integer mantissa;
  long exponent = mpfr_get_z_2exp(mantissa.backend().data(), x);
  const auto zeros = mpz_scan1(mantissa.backend().data(), 0);
  mantissa >>= zeros;
  exponent += static_cast<long>(zeros);
  const bool negative = mantissa < 0;
  if (negative) mantissa = -mantissa;
  return (negative ? "-0x" : "0x") + mantissa.str(0, std::ios_base::hex) + power_text(exponent);
}

std::string radius_text(const magnitude& r) {
  if (r.is_zero()) return "0";
  const int zeros = std::countr_zero(r.fraction());
  integer fraction = r.fraction() >> zeros;
  return "0x" + fraction.str(0, std::ios_base::hex) + power_text(r.exponent() + zeros);
}

/// Reads the text piece by piece; every failure is one error with the whole of it.
class reader {
 public:
  explicit reader(std::string_view text) : whole_(text), rest_(text) {}

  [[noreturn]] void fail(const std::string& why) const {
    throw input_error(detail::quoted(whole_) + ": " + why +
                      "; accepted are PRECISION:MIDPOINT+-RADIUS, PRECISION:[LOWER, UPPER] and "
                      "PRECISION:undefined with numbers like -0x5a8279p-22");
  }
  bool skip(std::string_view token) {
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  long decimal(const char* what) {
    skip("+");
    long n = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), n);
    if (error != std::errc{}) fail(std::string("no ") + what);
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return n;
  }

  struct dyadic {
    integer mantissa;
    long exponent = 0;
  };
  /// [-]0xHEXp[+-]N or 0, with a mantissa of at most `most_bits` bits.
  dyadic number(precision most_bits, const char* what) {
    dyadic r;
    const bool negative = skip("-");
    if (!skip("0x")) {
      if (negative || !skip("0")) fail(std::string("no ") + what);
      return r;
    }
    const auto digits = rest_.find_first_not_of("0123456789abcdef");
    const std::string_view hex = rest_.substr(0, digits);
    if (hex.empty()) fail(std::string("no digits in the ") + what);
    if (static_cast<precision>(hex.size()) > most_bits / 4 + 2) too_long(what, most_bits);
    mpz_set_str(r.mantissa.backend().data(), std::string(hex).c_str(), 16);
    if (static_cast<precision>(mpz_sizeinbase(r.mantissa.backend().data(), 2)) > most_bits) {
      too_long(what, most_bits);
    }
    rest_.remove_prefix(hex.size());
    if (!skip("p")) fail(std::string("no exponent p... in the ") + what);
    r.exponent = decimal("exponent");
    constexpr long most_exponent = 1L << 60;
    if (r.exponent > most_exponent || r.exponent < -most_exponent) {
      fail(std::string("the exponent of the ") + what + " is beyond +-2^60");
    }
    if (negative) r.mantissa = -r.mantissa;
    return r;
  }
  /// The same, or inf, -inf, as an MPFR number of p bits.
  mpfr_cell mpfr_number(precision p, const char* what) {
    mpfr_cell r(p);
    if (skip("-inf")) {
      mpfr_set_inf(r.get(), -1);
    } else if (skip("inf")) {
      mpfr_set_inf(r.get(), 1);
    } else {
      const dyadic d = number(p, what);
      mpfr_set_z_2exp(r.get(), d.mantissa.backend().data(), d.exponent, MPFR_RNDN);
      if (d.mantissa != 0 && mpfr_regular_p(r.get()) == 0) {
        fail(std::string("the exponent of the ") + what + " is beyond MPFR's range");
      }
    }
    return r;
  }

 private:
  [[noreturn]] void too_long(const char* what, precision most_bits) const {
    fail(std::string("the ") + what + " has more than " + std::to_string(most_bits) + " bits");
  }

  std::string_view whole_;
  std::string_view rest_;
};

ball read_ends(reader& in, precision p) {
  mpfr_cell lower = in.mpfr_number(p, "lower end");
  if (!in.skip(", ")) in.fail("no comma after the lower end");
  mpfr_cell upper = in.mpfr_number(p, "upper end");
  if (!in.skip("]")) in.fail("no bracket after the upper end");
  const bool wrong_infinity = (mpfr_inf_p(lower.get()) != 0 && mpfr_sgn(lower.get()) > 0) ||
                              (mpfr_inf_p(upper.get()) != 0 && mpfr_sgn(upper.get()) < 0);
  if (wrong_infinity || mpfr_greater_p(lower.get(), upper.get()) != 0) {
    in.fail("the lower end exceeds the upper end");
  }
  ball r;
  ball_access::set_exact_ends(r, lower, upper);
  return r;
}

ball read_midpoint_radius(reader& in, precision p) {
  mpfr_cell midpoint = in.mpfr_number(p, "midpoint");
  if (mpfr_number_p(midpoint.get()) == 0) in.fail("an infinite midpoint");
  if (!in.skip("+-")) in.fail("no +- after the midpoint");
  const auto radius = in.number(31, "radius");
  if (radius.mantissa < 0) in.fail("a negative radius");
  return ball::from_midpoint_radius(
      midpoint.get(),
      magnitude::from_bits_up(static_cast<std::uint64_t>(radius.mantissa), radius.exponent));
}

}  // namespace

std::string to_exact_text(const ball& x) {
  const std::string head = std::to_string(x.precision()) + ":";
  switch (ball_access::form_of(x)) {
    case form::midpoint_radius:
      return head + number_text(ball_access::first(x)) + "+-" + radius_text(ball_access::radius(x));
    case form::end_points:
      return head + '[' + number_text(ball_access::first(x)) + ", " +
             number_text(ball_access::second(x)) + ']';
    case form::undefined:
      break;
  }
  return head + "undefined";
}

ball parse_exact_text(std::string_view text) {
  reader in(text);
  const long p = in.decimal("precision");
  if (p < least_precision || p > greatest_text_precision) {
    in.fail("a precision of " + std::to_string(p) + " bits is outside " +
            std::to_string(least_precision) + " ... " + std::to_string(greatest_text_precision));
  }
  if (!in.skip(":")) in.fail("no colon after the precision");
  ball r = ball::undefined(p);
  if (in.skip("[")) {
    r = read_ends(in, p);
  } else if (!in.skip("undefined")) {
    r = read_midpoint_radius(in, p);
  }
  if (!in.at_end()) in.fail("something follows the ball");
  return r;
}

}  // namespace polhode
