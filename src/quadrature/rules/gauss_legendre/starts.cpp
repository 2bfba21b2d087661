#include "quadrature/rules/gauss_legendre/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace polhode::detail::legendre {
namespace {

/// An estimate of the k-th zero of P_n from the right, k = 1 ... n/2: Halley's method, from the
/// classical guess. The recurrence is written as P_(k+1) = x P_k + k/(k+1) (x P_k - P_(k-1)).
long double estimated_node(long n, long k, const std::vector<long double>& quotients) {
  const auto degree = static_cast<long double>(n);
  const long double angle =
      std::numbers::pi_v<long double> * (static_cast<long double>(k) - 0.25L) / (degree + 0.5L);
  long double x = (1 - (degree - 1) / (8 * degree * degree * degree)) * std::cos(angle);
  for (int iteration = 0; iteration < 8; ++iteration) {
    long double before = 1;
    long double value = x;
    for (std::size_t j = 1; j < static_cast<std::size_t>(n); ++j) {
      const long double product = x * value;
      const long double next = product + quotients[j] * (product - before);
      before = value;
      value = next;
    }
    const long double complement = (1 - x) * (1 + x);
    const long double slope = degree * (before - x * value) / complement;
    const long double bend = (2 * x * slope - degree * (degree + 1) * value) / complement;
    const long double step = -2 * value * slope / (2 * slope * slope - value * bend);
    x += step;
    // The next error is about the third power of the step, in units of the distance of the zeros.
    if (std::abs(step) * degree * degree < 1e-6L) break;
  }
  return x;
}

}  // namespace

std::vector<std::uint64_t> estimated_squares(const legendre_shape& s) {
  std::vector<long double> quotients(static_cast<std::size_t>(s.n));
  for (std::size_t j = 0; j < quotients.size(); ++j) {
    quotients[j] = static_cast<long double>(j) / static_cast<long double>(j + 1);
  }
  std::vector<std::uint64_t> squares;
  squares.reserve(static_cast<std::size_t>(s.degree));
  for (long k = s.degree; k >= 1; --k) {
    const long double x = estimated_node(s.n, k, quotients);
    const long double scaled = std::ldexp(x * x, 64);
    const bool usable = scaled >= 1 && scaled < 18446744073709549568.0L;
    squares.push_back(usable ? static_cast<std::uint64_t>(scaled) : std::uint64_t{1} << 63);
  }
  return squares;
}

namespace {

/// A few zeros of P_n at once, which a processor works on side by side.
struct lanes {
  static constexpr std::size_t count = 8;
  std::array<double, count> values;
  double& operator[](std::size_t i) { return values[i]; }
};

/// Estimates of 1 - x for the k-th zeros of P_n from the right, k = first, first + 1 ...: Halley's
/// method, from the classical guess. With t = 1 - x and D_k = P_k - P_(k-1) the recurrence is
/// D_(k+1) = r D_k - (1 + r) t P_k, r = k/(k+1), which is as exact near x = 1 as elsewhere.
lanes estimated_complements(long n, long first, const std::vector<double>& ratios) {
  const auto degree = static_cast<double>(n);
  const double shrinkage = (degree - 1) / (8 * degree * degree * degree);
  lanes t{};
  for (std::size_t i = 0; i < lanes::count; ++i) {
    const long k = std::min(first + static_cast<long>(i), n / 2);
    const double angle = std::numbers::pi * (static_cast<double>(k) - 0.25) / (degree + 0.5);
    const double sine = std::sin(angle / 2);
    t[i] = 2 * sine * sine + shrinkage * (1 - 2 * sine * sine);
  }
  for (int iteration = 0; iteration < 6; ++iteration) {
    lanes value{};
    lanes difference{};
    for (std::size_t i = 0; i < lanes::count; ++i) {
      value[i] = 1 - t[i];
      difference[i] = -t[i];
    }
    for (std::size_t j = 1; j < static_cast<std::size_t>(n); ++j) {
      const double r = ratios[j];
      for (std::size_t i = 0; i < lanes::count; ++i) {
        difference[i] = r * difference[i] - (1 + r) * (t[i] * value[i]);
        value[i] += difference[i];
      }
    }
    double largest = 0;
    for (std::size_t i = 0; i < lanes::count; ++i) {
      const double square = t[i] * (2 - t[i]);  // 1 - x^2
      const double slope = degree * (t[i] * value[i] - difference[i]) / square;
      const double bend = (2 * (1 - t[i]) * slope - degree * (degree + 1) * value[i]) / square;
      const double step = 2 * value[i] * slope / (2 * slope * slope - value[i] * bend);
      t[i] += step;
      largest = std::max(largest, std::abs(step) / t[i]);
    }
    // The next error is about the third power of the step, in units of the distance of the zeros.
    if (largest * degree < 1e-5) break;
  }
  return t;
}

}  // namespace

std::vector<std::uint64_t> roughly_estimated_squares(const legendre_shape& s) {
  std::vector<double> ratios(static_cast<std::size_t>(s.n));
  for (std::size_t j = 0; j < ratios.size(); ++j) {
    ratios[j] = static_cast<double>(j) / static_cast<double>(j + 1);
  }
  std::vector<std::uint64_t> squares(static_cast<std::size_t>(s.degree));
  for (long first = 1; first <= s.degree; first += static_cast<long>(lanes::count)) {
    lanes t = estimated_complements(s.n, first, ratios);
    for (std::size_t i = 0; i < lanes::count; ++i) {
      const long k = first + static_cast<long>(i);
      if (k > s.degree) break;
      // y or 1 - y, whichever is the smaller one, to as many bits as t has.
      const bool near_1 = t[i] < 0.5;
      const double part = near_1 ? t[i] * (2 - t[i]) : (1 - t[i]) * (1 - t[i]);
      const bool usable = part > 0x1p-60 && part < 0.9;
      const auto units =
          usable ? static_cast<std::uint64_t>(std::ldexp(part, 64)) : std::uint64_t{1} << 63;
      squares[static_cast<std::size_t>(s.degree - k)] = near_1 ? 0 - units : units;
    }
  }
  return squares;
}

}  // namespace polhode::detail::legendre
