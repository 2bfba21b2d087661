#include "real.hpp"

#include <optional>
#include <utility>

namespace polhode::checker {
namespace {

/// Bits beyond those asked for, tried one after another.
constexpr long first_guard = 32;
constexpr long most_guard = 1L << 16;

}  // namespace

struct real::number {
  std::function<interval(precision bits)> enclose;
  long size;
  budget* work;
};

real real::irrational(std::function<interval(precision bits)> enclose, long size, budget& work) {
  real result(0);
  result.irrational_ = std::make_shared<const number>(number{std::move(enclose), size, &work});
  return result;
}

budget& real::work() const { return *irrational_->work; }

interval real::rough(precision bits) const {
  return irrational_ ? irrational_->enclose(bits) : interval(rational_, bits);
}

interval real::at(precision bits) const {
  if (!irrational_) return {rational_, bits};
  for (long guard = first_guard; guard <= most_guard; guard *= 2) {
    try {
      const interval x = rough(bits + guard);
      if (x.high() - x.low() <= power_of_two(guard)) return x.with_bits(bits);
    } catch (const undecided&) {  // more bits
    }
  }
  throw undecided("an irrational number takes too many bits");
}

int real::sign() const {
  if (!irrational_) return rational_ > 0 ? 1 : rational_ < 0 ? -1 : 0;
  for (long bits = 2 * first_guard; bits <= most_guard; bits *= 2) {
    try {
      const interval x = rough({bits, *irrational_->work});
      if (x.is_positive()) return 1;
      if (x.is_negative()) return -1;
    } catch (const undecided&) {  // more bits
    }
  }
  throw undecided("the sign of an irrational number takes too many bits");
}

template <class Operation>
real real::combined(const real& x, const real& y, const Operation& operation) {
  if (!x.irrational_ && !y.irrational_) return {operation(x.rational_, y.rational_)};
  return irrational(
      [x, y, operation](precision bits) { return operation(x.rough(bits), y.rough(bits)); },
      bit_length(x) + bit_length(y), *(x.irrational_ ? x : y).irrational_->work);
}

real operator+(const real& x, const real& y) {
  return real::combined(x, y, [](const auto& v, const auto& w) { return v + w; });
}
real operator-(const real& x, const real& y) {
  return real::combined(x, y, [](const auto& v, const auto& w) { return v - w; });
}
real operator*(const real& x, const real& y) {
  if ((x.is_rational() && x.rational_ == 0) || (y.is_rational() && y.rational_ == 0)) return 0;
  return real::combined(x, y, [](const auto& v, const auto& w) { return v * w; });
}
real operator/(const real& x, const real& y) {
  if (x.is_rational() && x.rational_ == 0) return 0;
  return real::combined(x, y, [](const auto& v, const auto& w) { return v / w; });
}

long bit_length(const real& x) {
  return x.irrational_ ? x.irrational_->size : bit_length(x.rational_);
}

std::string decimal_for_reading(const real& x, long digits, budget& work) {
  if (x.is_rational()) return decimal_for_reading(x.rational_, digits, work);
  for (long bits = 2 * first_guard; bits <= most_guard; bits *= 2) {
    const interval at = x.at({bits, work});
    if (!at.is_positive() && !at.is_negative()) continue;
    const std::string text = decimal(at.lower(), digits, rounding::to_zero, work);
    if (text != decimal(at.upper(), digits, rounding::to_zero, work)) continue;
    const auto e = text.find('e');
    return e == std::string::npos ? text + "..." : text.substr(0, e) + "..." + text.substr(e);
  }
  throw undecided("the digits of an irrational number take too many bits");
}

integer greatest_with_square_below(const real& x) {
  if (x.is_rational()) {
    return floor_root(ceiling_quotient(numerator(x.exact()), denominator(x.exact())) - 1);
  }
  for (long bits = 2 * first_guard; bits <= most_guard; bits *= 2) {
    // The floor of the root is that of the root of the floor.
    const interval at = x.at({bits, x.work()});
    integer n = floor_root(floor_shift(at.low(), bits));
    if (n == floor_root(floor_shift(at.high(), bits))) return n;
  }
  throw undecided("the whole part of an irrational number takes too many bits");
}

rational_neighbours neighbours_of(const real& x) {
  if (x.is_rational()) return {x.exact(), x.exact()};
  constexpr long digits = 64;
  for (long bits = 2 * digits; bits <= most_guard; bits *= 2) {
    const interval at = x.at({bits, x.work()});
    const long shift = bit_length(at.low()) - digits;
    if (!at.is_positive() || shift < 0) continue;
    const integer n = floor_shift(at.low(), shift);
    if (n != floor_shift(at.high(), shift)) continue;
    const rational unit = power_of_two(shift - bits);
    return {rational(n) * unit, rational(n + 1) * unit};
  }
  throw undecided("the first digits of an irrational number take too many bits");
}

}  // namespace polhode::checker
