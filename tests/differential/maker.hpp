#pragma once

// Random pieces that the families are put together from: numbers in every form in which a formula
// can have them, ranges, functions.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "support/random.hpp"
#include "term.hpp"

namespace polhode::differential {

class maker {
 public:
  explicit maker(std::uint64_t seed) : source_(seed) {}

  support::random_source& source() { return source_; }
  long between(long least, long most) { return source_.between(least, most); }
  bool one_in(long n) { return source_.one_in(n); }
  template <class T>
  T any_of(std::initializer_list<T> values) {
    return *(values.begin() + between(0, static_cast<long>(values.size()) - 1));
  }
  /// In [0, 1].
  double fraction() { return static_cast<double>(between(0, 1 << 20)) / (1 << 20); }
  double within(double low, double high) { return low + (high - low) * fraction(); }
  /// As likely of each order of magnitude.
  double scattered(double low, double high) {
    return std::exp(within(std::log(low), std::log(high)));
  }

  /// A decimal of few digits near t.
  term decimal(double t) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*g", static_cast<int>(between(1, 6)), t);
    return signed_number(text.data());
  }
  /// A quotient of small whole numbers near t.
  term quotient(double t) {
    const long below = one_in(4) ? 1L << between(0, 6) : between(1, 24);
    const double above = std::round(t * static_cast<double>(below));
    if (!(std::abs(above) < 1e15) || (above == 0 && t != 0)) return decimal(t);
    const auto n = static_cast<long>(above);
    if (n % below == 0) return term(n / below);
    return n < 0 ? -(term(-n) / term(below)) : term(n) / term(below);
  }
  /// A rational number near t, as it may be written.
  term rational_near(double t) { return one_in(2) ? decimal(t) : quotient(t); }

  /// A positive number that is not rational as a rule.
  term irrational() {
    switch (between(0, 7)) {
      case 0:
        return call("sqrt", between(2, 40));
      case 1:
        return call("sqrt", quotient(within(0.1, 4)));
      case 2:
        return call("cbrt", between(2, 40));
      case 3:
        return call("root", between(2, 20), between(4, 7));
      case 4:
        return "pi";
      case 5:
        return call("exp", quotient(within(-2, 2)));
      case 6:
        return call("log", between(2, 30));
      default:
        return one_in(2) ? term("e") : term("pi") / between(2, 12);
    }
  }
  /// A number near t, to 5 %, in any form, exact or not.
  term near(double t) {
    if (t == 0) return 0;
    for (int tries = 0; tries < 20; ++tries) {
      term result = roughly(t);
      if (std::abs(approximately(result) - t) <= 0.05 * std::abs(t)) return result;
    }
    return decimal_exactly(t);
  }

  /// Two numbers, the first the smaller one, both in [low, high]; their distance is any fraction of
  /// it.
  std::pair<term, term> range(double low, double high) {
    for (int tries = 0; tries < 20; ++tries) {
      double length = high - low;
      if (!one_in(3)) length *= scattered(1e-4, 1);
      const double start = low + (high - low - length) * fraction();
      term a = near(start);
      term b = near(start + length);
      const double x = approximately(a);
      const double y = approximately(b);
      if (x >= low && y <= high && x < y) return {std::move(a), std::move(b)};
    }
    return {decimal_exactly(low), decimal_exactly(high)};
  }
  /// From a number near low to one that is a very little greater.
  std::pair<term, term> narrow_range(double low, double high) {
    const term a = near(within(low, high));
    return {a, a + decimal(scattered(1e-30, 1e-3) * std::abs(approximately(a)))};
  }

  /// A whole exponent, of any order of magnitude.
  term exponent(long most) {
    const auto n = static_cast<long>(std::round(scattered(1, static_cast<double>(most))));
    return one_in(2) ? term(n) : term(-n);
  }
  /// The same, in halves and thirds too.
  term broken_exponent(long most) {
    if (one_in(3)) return exponent(most);
    const long below = any_of({2L, 3L, 4L, 5L});
    const auto n = static_cast<long>(
        std::round(scattered(1, static_cast<double>(most) * static_cast<double>(below))));
    return one_in(2) ? term(n) / below : -(term(n) / below);
  }
  /// Between the two, which are not far from 0.
  term exponent_between(double low, double high) {
    for (int tries = 0; tries < 20; ++tries) {
      term e = one_in(8) ? near(within(low, high)) : quotient(within(low, high));
      const double v = approximately(e);
      if (v > low && v < high) return e;
    }
    return quotient((low + high) / 2);
  }

  /// A coefficient: not 0, mostly rational.
  term coefficient() {
    const double size = (one_in(2) ? 1 : -1) * scattered(0.1, 20);
    return one_in(4) ? near(size) : rational_near(size);
  }
  term positive_coefficient() {
    const double size = scattered(0.1, 20);
    return one_in(4) ? near(size) : rational_near(size);
  }
  /// A polynomial of any sign.
  term polynomial(long degree) {
    term result = coefficient();
    for (long k = 1; k <= degree; ++k) {
      if (one_in(3) && k < degree) continue;
      result = result + coefficient() * power("x", k);
    }
    return result;
  }
  /// A polynomial that is positive for x > 0; for every x where even is asked for.
  term positive_polynomial(bool everywhere) {
    const term x = "x";
    switch (between(0, 4)) {
      case 0:
        return positive_coefficient() + power(x, 2);
      case 1:
        return power(x, 2) + x + positive_rational() + 1;
      case 2:
        return 1 + positive_rational() * power(x, 4);
      default:
        if (everywhere) return positive_rational() + positive_rational() * power(x, 2);
        return positive_rational() + positive_rational() * x;
    }
  }
  term positive_rational() { return rational_near(scattered(0.1, 20)); }

  /// A function that is analytic on the whole line and of moderate size, of t.
  term gentle(const term& t) {
    switch (between(0, 8)) {
      case 0:
        return call("sin", t);
      case 1:
        return call("cos", t);
      case 2:
        return call("exp", -power(t, 2));
      case 3:
        return call("tanh", t);
      case 4:
        return call("atan", t);
      case 5:
        return 1 / (1 + power(t, 2));
      case 6:
        return call("erf", t);
      case 7:
        return call("sqrt", 1 + power(t, 2));
      default:
        return call("log", 2 + power(t, 2));
    }
  }

 private:
  /// A number in any form, which the size of its parts may keep away from t.
  term roughly(double t) {
    switch (between(0, 6)) {
      case 0:
        return decimal(t);
      case 1:
      case 2:
        return quotient(t);
      case 3: {  // (p + sqrt(n))/q
        const term root = call("sqrt", between(2, 60));
        const long below = between(1, 4);
        const double above = t * static_cast<double>(below) - approximately(root);
        return (quotient(above) + root) / below;
      }
      case 4: {
        const term s = irrational();
        return quotient(t - approximately(s)) + s;
      }
      default: {
        const term s = irrational();
        return quotient(t / approximately(s)) * s;
      }
    }
  }

  static term signed_number(const std::string& text) {
    if (text.front() == '-') return -term(text.substr(1));
    return term(text);
  }
  static term decimal_exactly(double t) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.17g", t);
    return signed_number(text.data());
  }

  support::random_source source_;
};

}  // namespace polhode::differential
