#pragma once

// Integrands g with known integrals of g(cos t) over (0, pi).

#include <optional>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"

namespace polhode::support {

/// Poisson's kernel g(c) = (1 - q^2)/(1 - 2 q c + q^2), 0 < q < 1. As g(cos t) = sum of q^|k| e^(i
/// k t), its integral is pi, and the rule with N = 2n nodes on the circle, shifted by half a step,
/// gives pi (1 + 2 sum over j >= 1 of (-1)^j q^(N j)) = pi (1 - q^N)/(1 + q^N) in place of it.
class poisson_kernel {
 public:
  explicit poisson_kernel(rational q) : q_(std::move(q)) {}

  template <scalar T>
  [[nodiscard]] auto evaluator(precision p) const {
    const T above = scalar_from<T>(rational(1 - q_ * q_), p);
    const T constant = scalar_from<T>(rational(1 + q_ * q_), p);
    const T slope = scalar_from<T>(rational(2 * q_), p);
    return [=](const T& cosine) -> T { return above / T(constant - slope * cosine); };
  }

  /// |1 - 2 q cos t + q^2| = |1 - q e^(it)| |1 - q e^(-it)| >= (1 - q e^H)(1 - q e^(-H)) for |Im t|
  /// <= H: attained at t = i H.
  [[nodiscard]] std::optional<strip_bound> bound_on_strip(const ball& half_width) const {
    const ball least = (1 + q_ * q_) - (2 * q_) * cosh(half_width);
    const ball up = 1 - q_ * exp(half_width);
    if (!certainly_positive(half_width) || !certainly_positive(up) || !certainly_positive(least)) {
      return std::nullopt;
    }
    return strip_bound{half_width, rational(1 - q_ * q_) / least};
  }

  /// (1 - q^N)/(1 + q^N), N = 2n: the rule's value over pi.
  [[nodiscard]] rational rule_over_pi(long n) const {
    rational power = 1;
    for (long i = 0; i < 2 * n; ++i) power *= q_;
    return (1 - power) / (1 + power);
  }

 private:
  rational q_;
};

/// g(c) = c^k: the integral is pi binomial(k, k/2) / 2^k for even k, else 0; entire, |c| <= cosh H.
class power_of_cosine {
 public:
  explicit power_of_cosine(long k) : k_(k) {}

  template <scalar T>
  [[nodiscard]] auto evaluator(precision p) const {
    const T one = scalar_from<T>(1, p);
    return [one, k = k_](const T& cosine) -> T {
      T power = one;
      for (long i = 0; i < k; ++i) power = T(power * cosine);
      return power;
    };
  }

  [[nodiscard]] std::optional<strip_bound> bound_on_strip(const ball& half_width) const {
    return strip_bound{half_width, pow(cosh(half_width), k_)};
  }

  [[nodiscard]] rational integral_over_pi() const {
    if (k_ % 2 != 0) return 0;
    rational value = 1;  // the product of (2j - 1)/(2j)
    for (long j = 1; j <= k_ / 2; ++j) value = value * (2 * j - 1) / (2 * j);
    return value;
  }

 private:
  long k_;
};

/// g = value, a constant.
class constant_integrand {
 public:
  explicit constant_integrand(rational value) : value_(std::move(value)) {}

  template <scalar T>
  [[nodiscard]] auto evaluator(precision p) const {
    const T value = scalar_from<T>(value_, p);
    return [=](const T&) -> T { return value; };
  }
  [[nodiscard]] std::optional<strip_bound> bound_on_strip(const ball& half_width) const {
    return strip_bound{half_width, abs(ball(value_, half_width.precision()))};
  }

 private:
  rational value_;
};

}  // namespace polhode::support
