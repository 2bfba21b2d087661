#pragma once

// Integrals whose values are known otherwise, and how a certified one is held against them.

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode::support {

/// x^e, x > 0.
inline ball real_power(const ball& x, const rational& e) { return pow(x, ball(e, x.precision())); }
inline symbol real_power(const symbol& x, const rational& e) { return pow(x, e); }

struct known_integral {
  std::string name;
  /// Where the value comes from: DLMF or Gradshteyn and Ryzhik (GR, 7th ed.) by number, or how it
  /// is derived.
  std::string source;
  std::function<integral(const integrate_options&)> run;
  /// The same of the text of its formula.
  std::function<integral(const integrate_options&)> run_text;
  std::function<ball(precision)> value;
  /// Of the integral of |f|, where the value is 0.
  std::function<ball(precision)> size;
};

template <class F>
[[nodiscard]] known_integral known(std::string name, std::string source, F f, end_point a,
                                   end_point b, std::function<ball(precision)> value) {
  return {std::move(name),
          std::move(source),
          [f, a, b](const integrate_options& options) { return integrate(f, a, b, options); },
          [f, a, b](const integrate_options& options) {
            return integrate(parse(formula_of(f).to_text()), a, b, options);
          },
          std::move(value),
          nullptr};
}
template <class F>
[[nodiscard]] known_integral known_zero(std::string name, std::string source, F f, end_point a,
                                        end_point b, std::function<ball(precision)> size) {
  known_integral k = known(std::move(name), std::move(source), f, std::move(a), std::move(b),
                           [](precision p) { return ball(0, p); });
  k.size = std::move(size);
  return k;
}

/// The enclosure holds the value, which is given so narrowly that it must lie inside as a whole
/// (where the enclosure is one number: meet it).
[[nodiscard]] inline ::testing::AssertionResult holds(const integral& i, const ball& value) {
  const bool held =
      i.enclosure.is_exact() ? overlaps(i.enclosure, value) : contains(i.enclosure, value);
  if (!i.enclosure.is_undefined() && held) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << described(i.enclosure) << " for " << described(value);
}

/// Certified, right, and with a radius of at most 10^-digits of the value; or of 10^-digits of the
/// size of |f| where the value is 0. By Taylor series it must be so by panels too.
[[nodiscard]] inline ::testing::AssertionResult right(
    const known_integral& k, long digits, quadrature_rule rule = quadrature_rule::automatic) {
  const integral i = k.run({.digits = digits, .rule = rule});
  const auto failure = [&] {
    return ::testing::AssertionFailure()
           << k.name << " to " << digits << " digits, " << to_text(rule) << ": ";
  };
  if (i.verdict != status::certified || i.why != reason::none || !i.obstacle.empty()) {
    return failure() << to_text(i.verdict) << ", " << to_text(i.why) << ": " << i.obstacle;
  }
  const precision p = bits_for_digits(2 * digits) + 300;
  if (const auto held = holds(i, k.value(p)); !held) return failure() << held.message();
  const bool is_zero = k.size != nullptr;
  const ball size = is_zero ? k.size(p) * power_of_ten(-digits) : abs(k.value(p));
  const ball radius(rational(to_rational(i.enclosure.radius()) * power_of_ten(digits)), 64);
  if (!i.enclosure.is_exact() && !certainly_less_equal(radius, size)) {
    return failure() << "too wide: " << described(i.enclosure);
  }
  const std::vector<quadrature_rule>& used = i.account.rules;
  const bool is_series =
      std::find(used.begin(), used.end(), quadrature_rule::taylor_series) != used.end();
  return is_series && rule == quadrature_rule::automatic
             ? right(k, digits, quadrature_rule::gauss_legendre)
             : ::testing::AssertionSuccess();
}

/// Sum of term(n), n >= 0, for terms of which each is at most half of the one before in size from n
/// = 4 on.
template <class Term>
[[nodiscard]] ball sum_of_series(precision p, Term&& term) {
  ball sum(0, p);
  for (long n = 0;; ++n) {
    const ball next = term(n);
    sum += next;
    // What follows is less than the last term.
    if (n > 4 && next.magnitude_upper() <= magnitude::power_of_two(-p)) {
      return sum.enlarged(next.magnitude_upper());
    }
  }
}

}  // namespace polhode::support
