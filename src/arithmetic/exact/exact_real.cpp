#include "polhode/arithmetic/exact_real.hpp"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode {

/// The enclosure with the most bits so far is kept.
struct exact_real::irrational_number {
  std::function<ball(precision)> enclose;
  precision size = 0;
  mutable std::mutex guard;
  mutable precision known_bits = 0;
  mutable ball known;
};

exact_real exact_real::irrational(std::function<ball(precision)> enclose, precision size) {
  const auto x = std::make_shared<irrational_number>();
  x->enclose = std::move(enclose);
  x->size = size;
  return exact_real(std::shared_ptr<const irrational_number>(x));
}

const rational& exact_real::exact() const {
  if (!rational_) throw std::logic_error("exact_real: the number is irrational");
  return *rational_;
}

ball exact_real::rough(precision p) const {
  if (rational_) return ball(*rational_, p);
  const irrational_number& x = *irrational_;
  const std::lock_guard lock(x.guard);
  if (x.known_bits >= p) return x.known;
  ball found = x.enclose(p);
  if (found.is_bounded()) {
    x.known = found;
    x.known_bits = p;
  }
  return found;
}

ball exact_real::at(precision p, precision most) const {
  if (rational_) return ball(*rational_, p);
  constexpr precision few = 16;
  for (precision bits = p + few; bits <= std::max(most, 2 * p); bits += bits / 2 + 64) {
    const ball x = rough(bits);
    if (x.is_bounded() && x.radius() <= scale(x.magnitude_lower(), -p - 1)) {
      return x.with_precision(p);
    }
  }
  return ball::undefined(p);
}

int exact_real::sign(precision most) const {
  if (rational_) return rational_->sign();
  constexpr precision first = 64;
  const ball x = at(first, most);
  if (certainly_positive(x)) return 1;
  if (certainly_negative(x)) return -1;
  throw std::domain_error("exact_real: the sign of a number is not decided");
}

int exact_real::compare(const rational& q) const {
  return rational_ ? rational_->compare(q) : (*this - q).sign();
}

template <class Operation>
exact_real exact_real::combined(const exact_real& x, const exact_real& y,
                                const Operation& operation) {
  if (x.rational_ && y.rational_)
    return exact_real(rational(operation(*x.rational_, *y.rational_)));
  // The operands need no relative precision: at() raises that of the result, and so theirs.
  return irrational(
      [x, y, operation](precision p) { return ball(operation(x.rough(p), y.rough(p))); },
      size_in_bits(x) + size_in_bits(y));
}

exact_real operator+(const exact_real& x, const exact_real& y) {
  return exact_real::combined(x, y, [](const auto& v, const auto& w) { return v + w; });
}

exact_real operator-(const exact_real& x, const exact_real& y) {
  if (x.irrational_ && x.irrational_ == y.irrational_) return 0;
  return exact_real::combined(x, y, [](const auto& v, const auto& w) { return v - w; });
}

exact_real operator*(const exact_real& x, const exact_real& y) {
  if ((x.rational_ && *x.rational_ == 0) || (y.rational_ && *y.rational_ == 0)) return 0;
  return exact_real::combined(x, y, [](const auto& v, const auto& w) { return v * w; });
}

exact_real operator/(const exact_real& x, const exact_real& y) {
  if (y.rational_ && *y.rational_ == 0) throw std::domain_error("exact_real: division by 0");
  if (x.rational_ && *x.rational_ == 0) return 0;
  return exact_real::combined(x, y, [](const auto& v, const auto& w) { return v / w; });
}

bool operator==(const exact_real& x, const exact_real& y) {
  return (x <=> y) == std::strong_ordering::equal;
}

std::strong_ordering operator<=>(const exact_real& x, const exact_real& y) {
  return (y.rational_ ? x.compare(*y.rational_) : (x - y).sign()) <=> 0;
}

precision size_in_bits(const exact_real& x) {
  return x.rational_ ? size_in_bits(*x.rational_) : x.irrational_->size;
}

rational rational_below(const exact_real& x, unsigned bits) {
  if (x.is_rational()) return x.exact();
  constexpr precision enough = 64;
  const rational low = lower_rational(x.at(enough));
  // low = n 2^-shift with so many bits in n, rounded down.
  const long size = static_cast<long>(msb(integer(abs(numerator(low))))) -
                    static_cast<long>(msb(integer(denominator(low))));
  const long exponent = size - static_cast<long>(bits);
  const integer power = integer(1) << static_cast<unsigned long>(std::abs(exponent));
  const rational unit = exponent >= 0 ? rational(power) : rational(integer(1), power);
  return rational(floor_of(rational(low / unit)) * unit);
}

std::string to_text(const exact_real& x) {
  constexpr long digits = 12;
  if (x.is_rational()) return to_text(x.exact());
  ball value;
  for (precision p = bits_for_digits(digits) + 8; p <= exact_real::most_bits; p *= 2) {
    value = x.at(p);
    if (!value.is_bounded() || to_decimal_enclosure(value, digits).has_cut(digits)) break;
  }
  return to_decimal(value, digits);
}

std::ostream& operator<<(std::ostream& out, const exact_real& x) { return out << to_text(x); }

}  // namespace polhode
