#include "interval.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

// The series. Each function brings its argument near 0, where the terms at least halve from one to
// the next, sums until a term is at most one unit, and adds a bound of the rest to both ends; then
// it undoes the reduction by interval operations. Guard bits keep the result's width near that of
// the argument: they decide how tight a result is, never whether it is right.

namespace polhode::checker {
namespace {

constexpr long guard_bits = 16;
constexpr long most_argument_bits = 17;
/// Units of any operation, for what does not grow with its operands.
constexpr long overhead = 150;

long words_of(long bits) { return bits / 64 + 1; }
/// Of the greater end.
long words_of(const interval& x) { return std::max(words(x.low()), words(x.high())); }
/// One that takes time in proportion to its operands' length, and `more` bits.
void charge_linear(const interval& x, long more = 0) {
  x.bits().work().spend(overhead + 2 * (words_of(x) + words_of(std::abs(more))));
}

/// The k >= 0 with |x| 2^-k <= 2^-r.
long halvings(const interval& x, long r) {
  return std::max(0L, bit_length(x.magnitude()) - x.bits() + r);
}

/// About as many reductions as terms: the cost of both is least there.
long reduction(long bits) {
  return 2 + static_cast<long>(std::sqrt(static_cast<double>(bits)) / 2);
}

void refuse_great(const interval& x) {
  if (bit_length(x.magnitude()) - x.bits() > most_argument_bits) {
    throw undecided("an argument is too great");
  }
}

bool is_small(const interval& term) { return term.magnitude() <= 1; }

/// arctan(1/q) = sum of (-1)^k / ((2k+1) q^(2k+1)); the terms alternate and decrease, so the rest
/// is at most the first one left out. q^2 divides a whole number of units each time: that quotient,
/// cut off, is below the true one by less than 2 units (q^2 >= 2), and each term so by less than 3.
interval atan_of_inverse(long q, precision bits) {
  bits.work().spend(words_of(bits));
  integer power = (integer(1) << static_cast<unsigned>(static_cast<long>(bits))) / q;
  integer sum(0);
  long k = 0;
  for (; power != 0; ++k) {
    bits.work().spend(overhead + 6 * words(power));
    const integer term = power / (2 * k + 1);
    sum += k % 2 == 0 ? term : integer(-term);
    power /= q * q;
  }
  return interval(sum, sum, bits).widened(3 * integer(k) + 3);
}

/// 2 artanh(z) = 2 sum of z^(2j+1)/(2j+1) for |z| <= 1/2: after a term t the rest is at most |t|
/// (1/4 + 1/16 + ...) < |t|.
interval twice_artanh(const interval& z) {
  const interval z_squared = square(z);
  interval power = z;
  interval sum = z;
  for (long j = 1;; ++j) {
    power = power * z_squared;
    const interval term = power / (2 * j + 1);
    sum = sum + term;
    if (is_small(power)) return (sum.widened(power.magnitude())).scaled(1);
  }
}

/// For 1/4 <= x <= 4: log x = 2^k log x^(1/2^k).
interval log_near_one(interval x, long k) {
  for (long i = 0; i < k; ++i) x = sqrt(x);
  const interval one(rational(1), x.bits());
  return twice_artanh((x - one) / (x + one)).scaled(k);
}

}  // namespace

// ---------------------------------------------------------------------------------------------
// Arithmetic

interval::interval(const rational& q, precision bits) : bits_(bits) {
  bits.work().spend(overhead);
  const long divisor_words = words_of(bit_length(integer(denominator(q))));
  const long all_words = words_of(bit_length(integer(numerator(q))) + bits);
  for (int end = 0; end < 2; ++end) bits.work().quotient(all_words, divisor_words);
  const integer n = integer(numerator(q)) << static_cast<unsigned>(static_cast<long>(bits));
  const integer d = denominator(q);
  low_ = floor_quotient(n, d);
  high_ = ceiling_quotient(n, d);
}
interval::interval(integer low, integer high, precision bits)
    : low_(std::move(low)), high_(std::move(high)), bits_(bits) {}
interval interval::between(const rational& lower, const rational& upper, precision bits) {
  return hull(interval(lower, bits), interval(upper, bits));
}
interval interval::around_zero(const integer& units, precision bits) {
  return {integer(-units), units, bits};
}
rational interval::lower() const {
  bits_.work().rationals(1, bit_length(low_) + bits_);
  return rational(low_) * power_of_two(-bits_);
}
rational interval::upper() const {
  bits_.work().rationals(1, bit_length(high_) + bits_);
  return rational(high_) * power_of_two(-bits_);
}
integer interval::magnitude() const { return std::max<integer>(abs(low_), abs(high_)); }
interval interval::with_bits(precision bits) const {
  charge_linear(*this, bits);
  if (bits >= bits_) {
    const auto k = static_cast<unsigned>(bits - bits_);
    return {integer(low_ << k), integer(high_ << k), bits};
  }
  return {floor_shift(low_, bits_ - bits), ceiling_shift(high_, bits_ - bits), bits};
}
interval interval::scaled(long k) const {
  charge_linear(*this, k);
  if (k >= 0) {
    const auto n = static_cast<unsigned>(k);
    return {integer(low_ << n), integer(high_ << n), bits_};
  }
  return {floor_shift(low_, -k), ceiling_shift(high_, -k), bits_};
}
interval interval::widened(const integer& units) const {
  charge_linear(*this);
  return {low_ - units, high_ + units, bits_};
}

interval operator-(const interval& x) {
  charge_linear(x);
  return {integer(-x.high_), integer(-x.low_), x.bits_};
}
interval operator+(const interval& x, const interval& y) {
  charge_linear(words(x.low_) < words(y.low_) ? y : x);
  return {x.low_ + y.low_, x.high_ + y.high_, x.bits_};
}
interval operator-(const interval& x, const interval& y) {
  charge_linear(words(x.low_) < words(y.low_) ? y : x);
  return {x.low_ - y.high_, x.high_ - y.low_, x.bits_};
}
interval operator*(const interval& x, const interval& y) {
  const bool simple = x.low_ >= 0 && y.low_ >= 0;
  const long x_words = words_of(x);
  const long y_words = words_of(y);
  x.bits_.work().spend(2 * overhead + 4 * (x_words + y_words) +
                       (simple ? 2 : 4) * budget::of_product(x_words, y_words));
  if (simple) {
    return {floor_shift(x.low_ * y.low_, x.bits_), ceiling_shift(x.high_ * y.high_, x.bits_),
            x.bits_};
  }
  // The product takes its extremes at corners.
  const auto [low, high] = std::minmax({integer(x.low_ * y.low_), integer(x.low_ * y.high_),
                                        integer(x.high_ * y.low_), integer(x.high_ * y.high_)});
  return {floor_shift(low, x.bits_), ceiling_shift(high, x.bits_), x.bits_};
}
interval operator/(const interval& x, const interval& y) {
  if (y.low_ <= 0 && y.high_ >= 0) throw undecided("a divisor is not known to be different from 0");
  if (y.high_ < 0) return -x / -y;
  x.bits_.work().spend(2 * overhead);
  for (int end = 0; end < 2; ++end) {
    x.bits_.work().quotient(words_of(x) + words_of(x.bits_), words_of(y));
  }
  const auto up = static_cast<unsigned>(static_cast<long>(x.bits_));
  // For y > 0 a negative end is divided by the least y to be lowest, another by the greatest; and
  // so for the high end.
  return {floor_quotient(integer(x.low_ << up), x.low_ < 0 ? y.low_ : y.high_),
          ceiling_quotient(integer(x.high_ << up), x.high_ < 0 ? y.high_ : y.low_), x.bits_};
}
interval operator*(const interval& x, long n) {
  if (n < 0) return -(x * -n);
  charge_linear(x);
  return {x.low_ * n, x.high_ * n, x.bits_};
}
interval operator/(const interval& x, long n) {
  x.bits_.work().spend(2 * overhead + 8 * words_of(x));
  return {floor_quotient(x.low_, integer(n)), ceiling_quotient(x.high_, integer(n)), x.bits_};
}

bool is_below(const interval& x, const interval& y) { return x.high() < y.low(); }
bool is_inside(const interval& x, const rational& lower, const rational& upper) {
  return lower <= x.lower() && x.upper() <= upper;
}
bool overlaps(const interval& x, const rational& lower, const rational& upper) {
  return x.lower() <= upper && lower <= x.upper();
}
interval hull(const interval& x, const interval& y) {
  return {std::min(x.low(), y.low()), std::max(x.high(), y.high()), x.bits()};
}

interval square(const interval& x) {
  if (x.is_negative()) return square(-x);
  if (x.low() >= 0) return x * x;
  x.bits().work().spend(2 * overhead);
  x.bits().work().product(words_of(x), words_of(x));
  const integer most = x.magnitude();
  return {integer(0), ceiling_shift(most * most, x.bits()), x.bits()};
}

interval sqrt(const interval& x) {
  if (x.low() < 0) throw undecided("a number is not known to have a square root");
  const long radicand = words_of(x) + words_of(x.bits());
  x.bits().work().spend(2 * overhead);
  for (int end = 0; end < 2; ++end) x.bits().work().root(radicand);
  x.bits().work().product(radicand / 2 + 1, radicand / 2 + 1);
  const auto up = static_cast<unsigned>(static_cast<long>(x.bits()));
  const integer high = x.high() << up;
  integer root = floor_root(high);
  if (root * root < high) ++root;
  return {floor_root(integer(x.low() << up)), root, x.bits()};
}

// ---------------------------------------------------------------------------------------------
// Series

interval pi(precision bits) {
  // Machin: pi = 16 arctan(1/5) - 4 arctan(1/239).
  const precision w = bits + guard_bits + 8;
  return (atan_of_inverse(5, w) * 16 - atan_of_inverse(239, w) * 4).with_bits(bits);
}

interval exp(const interval& x) {
  refuse_great(x);
  const long k = halvings(x, reduction(x.bits()));
  // e^x has at most 1.5 |x| bits before the point, and every squaring costs one bit.
  const auto whole = static_cast<long>(floor_shift(x.magnitude(), x.bits()));
  const precision w = x.bits() + 2 * k + 3 * (whole + 1) + guard_bits;
  const interval y = x.with_bits(w).scaled(-k);
  interval term(rational(1), w);
  interval sum = term;
  for (long j = 1;; ++j) {
    term = term * y / j;
    sum = sum + term;
    // |y| <= 1/4: after a term t the rest is at most |t| (1/4 + 1/16 + ...) < |t|.
    if (is_small(term)) {
      sum = sum.widened(term.magnitude());
      break;
    }
  }
  for (long i = 0; i < k; ++i) sum = square(sum);
  return sum.with_bits(x.bits());
}

interval log(const interval& x) {
  if (!x.is_positive()) throw undecided("a number is not known to be positive");
  const long k = reduction(x.bits());
  const precision w = x.bits() + 2 * k + guard_bits + 8;
  // x = m 2^e with m in [1/2, 1] at its high end; log increases, so its ends are those of x.
  const auto at = [&](const integer& end) {
    const long e = bit_length(end) - x.bits();
    w.work().rationals(1, bit_length(end));
    const rational m = rational(end) * power_of_two(-bit_length(end));
    return log_near_one(interval(m, w), k) + log_near_one(interval(rational(2), w), k) * e;
  };
  return hull(at(x.low()), at(x.high())).with_bits(x.bits());
}

interval atan(const interval& x) {
  const long r = reduction(x.bits());
  const long k = 2 + r;
  const precision w = x.bits() + 2 * k + guard_bits;
  const interval one(rational(1), w);
  interval y = x.with_bits(w);
  // tan(t/2) = tan t / (1 + sqrt(1 + tan^2 t)). After the first |y| <= 1, after two |y| < 1/2, and
  // then it halves at least.
  for (long i = 0; i < k; ++i) y = y / (one + sqrt(one + square(y)));
  const interval y_squared = square(y);
  interval power = y;
  interval sum = y;
  for (long j = 1;; ++j) {
    power = power * y_squared;
    const interval term = power / (2 * j + 1);
    sum = j % 2 == 0 ? sum + term : sum - term;
    // Terms alternate and decrease: the rest is at most the next, which is less than this power.
    if (is_small(power)) break;
  }
  return sum.widened(power.magnitude()).scaled(k).with_bits(x.bits());
}

sine_and_cosine sin_cos(const interval& x) {
  refuse_great(x);
  const long k = halvings(x, reduction(x.bits()));
  const precision w = x.bits() + 2 * k + guard_bits;
  const interval y = x.with_bits(w).scaled(-k);
  const interval y_squared = square(y);
  // Taylor with Lagrange's remainder: after the terms up to degree n the rest is at most
  // |y|^(n+1)/(n+1)!, for both series, and that is less than the last term taken, as |y| <= 1/4. v
  // = 1 - cos y = y^2/2 - y^4/24 + ...
  interval sine_term = y;
  interval sine = y;
  interval versine_term = y_squared / 2;
  interval versine = versine_term;
  for (long j = 1;; ++j) {
    sine_term = sine_term * y_squared / ((2 * j) * (2 * j + 1));
    versine_term = versine_term * y_squared / ((2 * j + 1) * (2 * j + 2));
    sine = j % 2 == 0 ? sine + sine_term : sine - sine_term;
    versine = j % 2 == 0 ? versine + versine_term : versine - versine_term;
    if (is_small(sine_term) && is_small(versine_term)) break;
  }
  sine = sine.widened(integer(1));
  versine = versine.widened(integer(1));
  const interval one(rational(1), w);
  // sin 2y = 2 sin y (1 - v), 1 - cos 2y = 2 sin^2 y.
  for (long i = 0; i < k; ++i) {
    const interval twice = (sine * (one - versine)).scaled(1);
    versine = square(sine).scaled(1);
    sine = twice;
  }
  return {sine.with_bits(x.bits()), (one - versine).with_bits(x.bits())};
}

interval asinh(const interval& x) {
  return log(x + sqrt(square(x) + interval(rational(1), x.bits())));
}

}  // namespace polhode::checker
