#include "polhode/arithmetic/exact.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>

#include "arithmetic/ball/ball_access.hpp"
#include "base/quoted.hpp"
#include "polhode/arithmetic/pi_combination.hpp"

namespace polhode {

using detail::quoted;

namespace {

[[noreturn]] void not_a_number(std::string_view text) {
  throw input_error(quoted(text) +
                    " is not a number: give a decimal such as 0.0629 or 1e-12, or a quotient such "
                    "as 1/4");
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

rational ten_to_the(unsigned long n) {
  integer power;
  mpz_ui_pow_ui(power.backend().data(), 10, n);
  return rational(power);
}

rational parse_decimal(std::string_view text, std::string_view whole) {
  std::size_t i = 0;
  const bool negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) ++i;
  std::string digits;
  long decimals = 0;
  while (i < text.size() && is_digit(text[i])) digits += text[i++];
  if (i < text.size() && text[i] == '.') {
    ++i;
    while (i < text.size() && is_digit(text[i])) {
      digits += text[i++];
      ++decimals;
    }
  }
  if (digits.empty()) not_a_number(whole);
  long exponent = 0;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && text[i] == '+') ++i;
    const bool sign_twice = i < text.size() && text[i] == '-' && text[i - 1] == '+';
    const auto [end, error] = std::from_chars(text.data() + i, text.data() + text.size(), exponent);
    if (error == std::errc::invalid_argument || sign_twice) not_a_number(whole);
    i = static_cast<std::size_t>(end - text.data());
    if (error == std::errc::result_out_of_range || exponent > greatest_decimal_exponent ||
        exponent < -greatest_decimal_exponent) {
      throw input_error("the exponent in " + quoted(whole) + " is beyond +-" +
                        std::to_string(greatest_decimal_exponent));
    }
  }
  if (i != text.size()) not_a_number(whole);
  integer mantissa;
  mpz_set_str(mantissa.backend().data(), digits.c_str(), 10);
  if (negative) mantissa = -mantissa;
  const long shift = exponent - decimals;
  return shift >= 0 ? rational(mantissa) * ten_to_the(static_cast<unsigned long>(shift))
                    : rational(mantissa) / ten_to_the(static_cast<unsigned long>(-shift));
}

rational dyadic_end(const ball& x, bool upwards) {
  if (!x.is_bounded()) throw std::domain_error("the end points of an unbounded ball");
  rational result;
  if (ball_access::form_of(x) == ball_access::form::end_points) {
    mpfr_get_q(result.backend().data(), upwards ? ball_access::second(x) : ball_access::first(x));
    return result;
  }
  mpfr_get_q(result.backend().data(), ball_access::first(x));
  if (x.is_exact()) return result;
  // In rationals, where no exponent overflows. A radius below 2^-64 of the midpoint's last place
  // counts as so much: a short ball does not give a rational of gigabytes.
  const magnitude radius =
      max(ball_access::radius(x),
          magnitude::power_of_two(mpfr_get_exp(ball_access::first(x)) - x.precision() - 64));
  rational offset(radius.fraction());
  mpq_ptr q = offset.backend().data();
  if (radius.exponent() >= 0) {
    mpq_mul_2exp(q, q, static_cast<mp_bitcnt_t>(radius.exponent()));
  } else {
    mpq_div_2exp(q, q, static_cast<mp_bitcnt_t>(-radius.exponent()));
  }
  return upwards ? result + offset : result - offset;
}

}  // namespace

rational parse_rational(std::string_view text) {
  if (text.size() > longest_number_text) {
    throw input_error("a number of " + std::to_string(text.size()) + " characters: at most " +
                      std::to_string(longest_number_text) + " are read");
  }
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return parse_decimal(text, text);
  const rational numerator = parse_decimal(text.substr(0, slash), text);
  const rational denominator = parse_decimal(text.substr(slash + 1), text);
  if (denominator == 0) throw input_error(quoted(text) + " divides by zero");
  return numerator / denominator;
}

ball parse_ball(std::string_view text, precision p) { return {parse_rational(text), p}; }

std::string to_text(const rational& q) { return q.str(); }

ball pi_combination::at(precision p) const {
  if (is_rational()) return {q, p};
  const ball multiple = pi(p) * r;
  return q == 0 ? multiple : multiple + q;
}

std::optional<pi_combination> common_period(const pi_combination& x, const pi_combination& y) {
  if ((x.q != 0 && x.r != 0) || (y.q != 0 && y.r != 0) || x.is_rational() != y.is_rational()) {
    return std::nullopt;
  }
  // The least common multiple of m/n and k/l is lcm(m l, k n)/(n l).
  const auto least = [](const rational& u, const rational& v) {
    const integer first = numerator(u) * denominator(v);
    const integer second = numerator(v) * denominator(u);
    integer multiple;
    mpz_lcm(multiple.backend().data(), first.backend().data(), second.backend().data());
    return rational(multiple, integer(denominator(u) * denominator(v)));
  };
  return x.is_rational() ? pi_combination{least(x.q, y.q), 0} : pi_combination{0, least(x.r, y.r)};
}

std::string to_text(const pi_combination& x) {
  if (x.is_rational()) return to_text(x.q);
  const rational size = abs(x.r);
  const std::string multiple = size == 1 ? "pi" : to_text(size) + "*pi";
  if (x.q == 0) return (x.r < 0 ? "-" : "") + multiple;
  return to_text(x.q) + (x.r < 0 ? " - " : " + ") + multiple;
}

integer floor_of(const rational& q) {
  integer n;
  mpz_fdiv_q(n.backend().data(), mpq_numref(q.backend().data()), mpq_denref(q.backend().data()));
  return n;
}
integer ceil_of(const rational& q) {
  integer n;
  mpz_cdiv_q(n.backend().data(), mpq_numref(q.backend().data()), mpq_denref(q.backend().data()));
  return n;
}

rational simplest_between(const rational& lower, const rational& upper) {
  return *simplest_between(lower, upper, std::numeric_limits<int>::max());
}

std::optional<rational> simplest_between(const rational& lower, const rational& upper,
                                         int most_terms) {
  if (most_terms < 1) return std::nullopt;
  if (lower <= 0 && upper >= 0) return rational(0);
  if (upper < 0) {
    const auto positive = simplest_between(-upper, -lower, most_terms);
    if (!positive) return std::nullopt;
    return rational(-*positive);
  }
  // The continued fractions of a/b = lower and c/d = upper begin with the same terms; where they
  // part, the least whole number between them is the last one. In place, as this is asked often.
  integer a = numerator(lower);
  integer b = denominator(lower);
  integer c = numerator(upper);
  integer d = denominator(upper);
  // The convergent before the last, and the last.
  integer above_before = 0;
  integer below_before = 1;
  integer above = 1;
  integer below = 0;
  integer term;
  integer multiple;
  const auto append = [&] {  // h = term h + h before it
    mpz_addmul(above_before.backend().data(), term.backend().data(), above.backend().data());
    mpz_addmul(below_before.backend().data(), term.backend().data(), below.backend().data());
    std::swap(above_before, above);
    std::swap(below_before, below);
  };
  for (int terms = 0; terms < most_terms; ++terms) {
    mpz_cdiv_q(term.backend().data(), a.backend().data(), b.backend().data());
    mpz_mul(multiple.backend().data(), term.backend().data(), d.backend().data());
    if (multiple <= c) {  // term <= upper
      append();
      rational result;
      mpz_swap(mpq_numref(result.backend().data()), above.backend().data());
      mpz_swap(mpq_denref(result.backend().data()), below.backend().data());
      return result;  // convergents are in lowest terms
    }
    // Both lie strictly between term - 1 and term: 1/(q - (term - 1)) of them, in the other order.
    --term;
    append();
    mpz_submul(a.backend().data(), term.backend().data(), b.backend().data());
    mpz_submul(c.backend().data(), term.backend().data(), d.backend().data());
    std::swap(a, d);
    std::swap(b, c);
  }
  return std::nullopt;
}

std::optional<rational> exact_root(const rational& q, unsigned long n) {
  integer above = numerator(q);
  integer below = denominator(q);
  if (q < 0 && n % 2 == 0) return std::nullopt;
  if (mpz_root(above.backend().data(), above.backend().data(), n) == 0) return std::nullopt;
  if (mpz_root(below.backend().data(), below.backend().data(), n) == 0) return std::nullopt;
  return rational(above) / rational(below);
}

rational lower_rational(const ball& x) { return dyadic_end(x, false); }
rational upper_rational(const ball& x) { return dyadic_end(x, true); }

}  // namespace polhode
