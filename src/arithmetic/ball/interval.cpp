#include "polhode/arithmetic/interval.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "ball_access.hpp"
#include "base/quoted.hpp"

namespace polhode {

using detail::end_points;
using detail::mpfr_cell;
using form = ball_access::form;

namespace {

mpfr_float number_like(const ball& x) { return zero_of_precision(x.precision()); }
mpfr_ptr raw(mpfr_float& x) { return x.backend().data(); }

enum class side { lower, upper };

/// An end of a defined ball as an exact sum of two numbers: x + y.
struct exact_end {
  mpfr_cell offset;  // the radius with its sign, or 0
  mpfr_srcptr base = nullptr;

  exact_end(const ball& x, side s) : offset(32) {
    if (ball_access::form_of(x) == form::end_points) {
      base = s == side::lower ? ball_access::first(x) : ball_access::second(x);
      return;
    }
    base = ball_access::first(x);
    const magnitude& r = ball_access::radius(x);
    if (r.is_zero()) return;
    mpfr_set_ui_2exp(offset.get(), r.fraction(), static_cast<mpfr_exp_t>(r.exponent()), MPFR_RNDU);
    if (s == side::lower) mpfr_neg(offset.get(), offset.get(), MPFR_RNDN);
  }
  [[nodiscard]] bool is_infinite() const { return mpfr_inf_p(base) != 0; }
};

/// r = a - b, rounded once: mpfr_sum is correctly rounded. Hypothesis: not both are infinite.
void difference(mpfr_ptr r, const exact_end& a, const exact_end& b, mpfr_rnd_t rounding) {
  mpfr_cell minus_base(mpfr_get_prec(b.base));
  mpfr_cell minus_offset(32);
  mpfr_neg(minus_base.get(), b.base, MPFR_RNDN);
  mpfr_neg(minus_offset.get(), b.offset.get(), MPFR_RNDN);
  // mpfr_sum reads its terms; it takes pointers that could be written through.
  mpfr_cell base(mpfr_get_prec(a.base));
  mpfr_cell offset(32);
  mpfr_set(base.get(), a.base, MPFR_RNDN);
  mpfr_set(offset.get(), a.offset.get(), MPFR_RNDN);
  std::array<mpfr_ptr, 4> terms{base.get(), offset.get(), minus_base.get(), minus_offset.get()};
  mpfr_sum(r, terms.data(), terms.size(), rounding);
}

/// The sign of a - b: a number rounded once has the sign of the number. Infinite ends of one sign
/// are equal.
int compare(const exact_end& a, const exact_end& b) {
  if (a.is_infinite() || b.is_infinite()) return mpfr_cmp(a.base, b.base);
  mpfr_cell d(2);
  difference(d.get(), a, b, MPFR_RNDN);
  return mpfr_sgn(d.get());
}

bool either_undefined(const ball& x, const ball& y) { return x.is_undefined() || y.is_undefined(); }

/// a < b, or both infinite with the same sign.
bool less_or_at_infinity(const exact_end& a, const exact_end& b) {
  const int order = compare(a, b);
  return order < 0 || (order == 0 && a.is_infinite());
}

}  // namespace

ball from_end_points(const rational& lower, const rational& upper, precision p) {
  checked_precision(p);
  if (upper < lower) {  // as given: rounded outward they might be in order
    throw input_error("end points " + detail::quoted(lower.str()) + ", " +
                      detail::quoted(upper.str()) +
                      ": the lower one must not exceed the upper one");
  }
  mpfr_cell low(p);
  mpfr_cell high(p);
  mpfr_set_q(low.get(), lower.backend().data(), MPFR_RNDD);
  mpfr_set_q(high.get(), upper.backend().data(), MPFR_RNDU);
  return ball::from_end_points(low.get(), high.get(), p);
}

ball from_end_points(const mpfr_float& lower, const mpfr_float& upper, precision p) {
  return ball::from_end_points(lower.backend().data(), upper.backend().data(), p);
}

ball parse_interval(std::string_view text, precision p) {
  checked_precision(p);
  const auto refuse = [&](const std::string& why) {
    throw input_error(detail::quoted(text) + ": " + why +
                      "; an interval is [LOWER, UPPER], [NUMBER] or [entire], with numbers such as "
                      "0.0629, 1e-12, 1/4, -inf, inf");
  };
  const auto trimmed = [](std::string_view part) {
    const auto first = part.find_first_not_of(' ');
    if (first == std::string_view::npos) return std::string_view{};
    return part.substr(first, part.find_last_not_of(' ') - first + 1);
  };
  std::string_view inside = trimmed(text);
  if (inside.size() < 2 || inside.front() != '[' || inside.back() != ']') refuse("no brackets");
  inside = trimmed(inside.substr(1, inside.size() - 2));
  if (inside == "entire") return ball::entire(p);
  const auto comma = inside.find(',');
  const std::string_view first = trimmed(inside.substr(0, comma));
  const std::string_view last =
      comma == std::string_view::npos ? first : trimmed(inside.substr(comma + 1));

  // An infinite end has no rational: the other one is then the only one to read.
  const bool from_minus_infinity = first == "-inf";
  const bool to_infinity = last == "inf" || last == "+inf";
  rational lower = 0;
  rational upper = 0;
  try {
    if (!from_minus_infinity) lower = parse_rational(first);
    if (!to_infinity) upper = parse_rational(last);
  } catch (const input_error& e) {
    refuse(e.what());
  }
  if (!from_minus_infinity && !to_infinity) {
    if (upper < lower) refuse("the lower end exceeds the upper end");
    return from_end_points(lower, upper, p);
  }
  mpfr_cell low(p);
  mpfr_cell high(p);
  mpfr_set_q(low.get(), lower.backend().data(), MPFR_RNDD);
  mpfr_set_q(high.get(), upper.backend().data(), MPFR_RNDU);
  if (from_minus_infinity) mpfr_set_inf(low.get(), -1);
  if (to_infinity) mpfr_set_inf(high.get(), 1);
  return ball::from_end_points(low.get(), high.get(), p);
}

mpfr_float width(const ball& x) {
  mpfr_float r = number_like(x);
  if (x.is_undefined()) {
    mpfr_set_nan(raw(r));
  } else if (!x.is_bounded()) {
    mpfr_set_inf(raw(r), 1);
  } else {
    difference(raw(r), exact_end(x, side::upper), exact_end(x, side::lower), MPFR_RNDU);
  }
  return r;
}

mpfr_float half_width(const ball& x) {
  if (!x.is_bounded()) return width(x);
  // midpoint(x) of a ball kept by midpoint and radius is its midpoint, exactly.
  const ball middle = x.middle();
  const exact_end m(middle, side::lower);
  mpfr_float above = number_like(x);
  mpfr_float below = number_like(x);
  difference(raw(above), exact_end(x, side::upper), m, MPFR_RNDU);
  difference(raw(below), m, exact_end(x, side::lower), MPFR_RNDU);
  return mpfr_greater_p(raw(above), raw(below)) != 0 ? above : below;
}

mpfr_float magnitude_of(const ball& x) {
  mpfr_float a = lower(x);
  mpfr_float b = upper(x);
  mpfr_abs(raw(a), raw(a), MPFR_RNDN);
  mpfr_abs(raw(b), raw(b), MPFR_RNDN);
  return mpfr_greater_p(raw(a), raw(b)) != 0 ? a : b;
}

mpfr_float mignitude_of(const ball& x) {
  mpfr_float r = number_like(x);
  switch (sign_of(x)) {
    case certain_sign::positive:
      x.lower(raw(r));
      break;
    case certain_sign::negative:
      x.upper(raw(r));
      mpfr_neg(raw(r), raw(r), MPFR_RNDN);
      break;
    default:
      if (x.is_undefined()) mpfr_set_nan(raw(r));
  }
  return r;
}

std::pair<ball, ball> split(const ball& x) {
  if (x.is_undefined()) return {x, x};
  const precision p = x.precision();
  const end_points e(x, p);
  mpfr_cell cut(p);
  const bool from_minus_infinity = mpfr_inf_p(e.lower()) != 0;
  const bool to_infinity = mpfr_inf_p(e.upper()) != 0;
  if (!from_minus_infinity && !to_infinity) {
    x.midpoint(cut.get());
  } else if (!from_minus_infinity && mpfr_sgn(e.lower()) >= 0) {
    mpfr_mul_2ui(cut.get(), e.lower(), 1, MPFR_RNDN);
    mpfr_add_ui(cut.get(), cut.get(), 1, MPFR_RNDN);
  } else if (!to_infinity && mpfr_sgn(e.upper()) <= 0) {
    mpfr_mul_2ui(cut.get(), e.upper(), 1, MPFR_RNDN);
    mpfr_sub_ui(cut.get(), cut.get(), 1, MPFR_RNDN);
  }  // else the cut is 0
  // Beyond the greatest exponent there is no cut: both halves are all of x.
  if (mpfr_number_p(cut.get()) == 0) return {x, x};
  return {ball::from_end_points(e.lower(), cut.get(), p),
          ball::from_end_points(cut.get(), e.upper(), p)};
}

std::optional<ball> common_part(const ball& x, const ball& y) {
  // Two sets that do not meet: one lies wholly below the other.
  if (certainly_less(x, y) || certainly_less(y, x)) return std::nullopt;
  return intersection(x, y);
}

ball cancel_minus(const ball& x, const ball& y) {
  const precision p = std::max(x.precision(), y.precision());
  if (either_undefined(x, y)) return ball::undefined(p);
  if (!x.is_bounded() || !y.is_bounded()) return ball::entire(p);
  const exact_end a(x, side::lower);
  const exact_end b(x, side::upper);
  const exact_end c(y, side::lower);
  const exact_end d(y, side::upper);
  // z = [a - c, b - d], where y is not wider than x. Decided without rounding: (b - d) - (a - c) is
  // rounded once as a sum of eight numbers.
  std::array<mpfr_cell, 8> numbers;
  std::array<mpfr_ptr, 8> terms{};
  std::size_t n = 0;
  const auto append = [&](const exact_end& e, bool negative) {
    for (const mpfr_srcptr part : {e.base, e.offset.get()}) {
      numbers[n].reset(mpfr_get_prec(part));
      mpfr_setsign(numbers[n].get(), part, (mpfr_signbit(part) != 0) != negative, MPFR_RNDN);
      terms[n] = numbers[n].get();
      ++n;
    }
  };
  append(b, false);
  append(d, true);
  append(a, true);
  append(c, false);
  mpfr_cell excess(2);
  mpfr_sum(excess.get(), terms.data(), terms.size(), MPFR_RNDN);
  if (mpfr_sgn(excess.get()) < 0) return ball::entire(p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  difference(lower.get(), a, c, MPFR_RNDD);
  difference(upper.get(), b, d, MPFR_RNDU);
  ball r;
  ball_access::set_exact_ends(r, lower, upper);
  return r;
}

ball cancel_plus(const ball& x, const ball& y) { return cancel_minus(x, -y); }

bool is_entire(const ball& x) {
  return ball_access::form_of(x) == form::end_points && mpfr_inf_p(ball_access::first(x)) != 0 &&
         mpfr_inf_p(ball_access::second(x)) != 0;
}

bool is_equal(const ball& x, const ball& y) {
  return !either_undefined(x, y) &&
         compare(exact_end(x, side::lower), exact_end(y, side::lower)) == 0 &&
         compare(exact_end(x, side::upper), exact_end(y, side::upper)) == 0;
}

bool is_subset(const ball& x, const ball& y) {
  return !either_undefined(x, y) &&
         compare(exact_end(y, side::lower), exact_end(x, side::lower)) <= 0 &&
         compare(exact_end(x, side::upper), exact_end(y, side::upper)) <= 0;
}

bool is_interior(const ball& x, const ball& y) {
  return !either_undefined(x, y) &&
         less_or_at_infinity(exact_end(y, side::lower), exact_end(x, side::lower)) &&
         less_or_at_infinity(exact_end(x, side::upper), exact_end(y, side::upper));
}

bool ends_less_equal(const ball& x, const ball& y) {
  return !either_undefined(x, y) &&
         compare(exact_end(x, side::lower), exact_end(y, side::lower)) <= 0 &&
         compare(exact_end(x, side::upper), exact_end(y, side::upper)) <= 0;
}

bool ends_less(const ball& x, const ball& y) {
  return !either_undefined(x, y) &&
         less_or_at_infinity(exact_end(x, side::lower), exact_end(y, side::lower)) &&
         less_or_at_infinity(exact_end(x, side::upper), exact_end(y, side::upper));
}

}  // namespace polhode
