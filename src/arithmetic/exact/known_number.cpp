#include "polhode/arithmetic/known_number.hpp"

#include <array>
#include <cstdlib>

namespace polhode {

namespace {

bool is_short(const rational& q) {
  const mpq_srcptr parts = q.backend().data();
  return mpz_sizeinbase(mpq_numref(parts), 2) <= known_number::longest &&
         mpz_sizeinbase(mpq_denref(parts), 2) <= known_number::longest;
}

/// Not 2^(2^30), which would fill the memory as a rational number.
bool is_short(const ball& x) {
  constexpr long most = static_cast<long>(known_number::longest);
  const magnitude size = x.magnitude_upper();
  return size.is_zero() ||
         (x.precision() < most && std::labs(size.exponent()) < most - x.precision());
}

}  // namespace

known_number::known_number(const pi_combination& x, precision p) : enclosure_(x.at(p)) {
  if (!is_short(x.q) || !is_short(x.r)) return;
  if (x.is_rational()) {
    exact_ = x.q;
  } else {
    with_pi_ = x;
  }
}

known_number::known_number(ball x) : enclosure_(std::move(x)) {
  if (enclosure_.is_bounded() && enclosure_.is_exact() && is_short(enclosure_)) {
    exact_ = lower_rational(enclosure_);
  }
}

known_number operator-(const known_number& x) {
  if (const auto s = x.form()) return x.like(-*s);
  return known_number::made("-", -x.enclosure_, x);
}

known_number operator+(const known_number& x, const known_number& y) {
  if (y.is_zero()) return x;
  if (x.exact_ && y.exact_) return x.like(rational(*x.exact_ + *y.exact_));
  if (const auto s = x.form(), t = y.form(); s && t) return x.like(*s + *t);
  return known_number::made("+", x.enclosure_ + y.enclosure_, x, y);
}

known_number operator*(const known_number& x, const known_number& y) {
  if (x.is_zero() && !y.enclosure_.is_undefined()) return x;
  if (y.is_zero() && !x.enclosure_.is_undefined()) return x.like(0);
  if (x.exact_ && y.exact_) return x.like(rational(*x.exact_ * *y.exact_));
  if (x.with_pi_ && y.exact_) return x.like(*x.with_pi_ * *y.exact_);
  if (x.exact_ && y.with_pi_) return x.like(*y.with_pi_ * *x.exact_);
  return known_number::made("*", x.enclosure_ * y.enclosure_, x, y);
}

known_number operator/(const known_number& x, const known_number& y) {
  if (x.exact_ && y.exact_ && *y.exact_ != 0) return x.like(rational(*x.exact_ / *y.exact_));
  if (x.with_pi_ && y.exact_ && *y.exact_ != 0) {
    return x.like(*x.with_pi_ * rational(1 / *y.exact_));
  }
  if (x.is_zero() && !y.enclosure_.is_undefined() && !contains_zero(y.enclosure_)) return x;
  return known_number::made("/", x.enclosure_ / y.enclosure_, x, y);
}

known_number sqrt(const known_number& x) {
  if (x.exact() && *x.exact() >= 0) {
    const mpq_srcptr q = x.exact()->backend().data();
    if (mpz_perfect_square_p(mpq_numref(q)) != 0 && mpz_perfect_square_p(mpq_denref(q)) != 0) {
      rational root;
      mpz_sqrt(mpq_numref(root.backend().data()), mpq_numref(q));
      mpz_sqrt(mpq_denref(root.backend().data()), mpq_denref(q));
      return x.like(root);
    }
  }
  return known_number::made("sqrt", sqrt(x.enclosure()), x);
}

// f(at) = value.
#define POLHODE_KNOWN_AT(f, at, value)                  \
  known_number f(const known_number& x) {               \
    if (x.is_exactly(at)) return x.like(value);         \
    return known_number::made(#f, f(x.enclosure()), x); \
  }
POLHODE_KNOWN_AT(exp, 0, 1)
POLHODE_KNOWN_AT(log, 1, 0)
POLHODE_KNOWN_AT(asin, 0, 0)
POLHODE_KNOWN_AT(acos, 1, 0)
POLHODE_KNOWN_AT(atan, 0, 0)
POLHODE_KNOWN_AT(sinh, 0, 0)
POLHODE_KNOWN_AT(cosh, 0, 1)
POLHODE_KNOWN_AT(tanh, 0, 0)
POLHODE_KNOWN_AT(asinh, 0, 0)
POLHODE_KNOWN_AT(acosh, 1, 0)
POLHODE_KNOWN_AT(atanh, 0, 0)
#undef POLHODE_KNOWN_AT

namespace {

/// k where x is k pi/2, counted modulo 4.
std::optional<int> quarters_in(const known_number& x) {
  const auto form = x.form();
  if (!form || form->q != 0) return std::nullopt;
  const rational twice = 2 * form->r;
  if (denominator(twice) != 1) return std::nullopt;
  return static_cast<int>(mpz_fdiv_ui(mpq_numref(twice.backend().data()), 4));
}

}  // namespace

known_number sin(const known_number& x) {
  constexpr std::array<long, 4> values = {0, 1, 0, -1};
  if (const auto k = quarters_in(x)) return x.like(values.at(static_cast<std::size_t>(*k)));
  return known_number::made("sin", sin(x.enclosure()), x);
}
known_number cos(const known_number& x) {
  constexpr std::array<long, 4> values = {1, 0, -1, 0};
  if (const auto k = quarters_in(x)) return x.like(values.at(static_cast<std::size_t>(*k)));
  return known_number::made("cos", cos(x.enclosure()), x);
}
known_number tan(const known_number& x) {
  const auto k = quarters_in(x);
  if (k && *k % 2 == 0) return x.like(0);
  return known_number::made("tan", tan(x.enclosure()), x);
}

}  // namespace polhode
