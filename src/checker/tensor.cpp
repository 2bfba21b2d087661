#include "tensor.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace polhode::checker {
namespace {

integer times_power_of_two(const integer& n, long k) { return n << static_cast<unsigned>(k); }

}  // namespace

/// I_x > I_y > I_z of a multiple of the tensor, enclosed by the narrowest brackets so far.
struct tensor::roots {
  /// chi = X^3 - T X^2 + M X - D, with whole coefficients.
  struct cubic {
    integer trace;
    integer minors;
    integer determinant;

    /// The sign of chi(n/2^k).
    [[nodiscard]] int sign_at(const integer& n, long k, budget& work) const {
      const long size = words(n) + words(trace) + k / 64 + 1;
      work.product(3 * size, 3 * size);
      const integer value =
          ((n - times_power_of_two(trace, k)) * n + times_power_of_two(minors, 2 * k)) * n -
          times_power_of_two(determinant, 3 * k);
      return value > 0 ? 1 : value < 0 ? -1 : 0;
    }
    /// floor(2^t (m - chi(m)/chi'(m))) at m = n/2^k: Newton's step; nothing where chi'(m) = 0.
    [[nodiscard]] std::optional<integer> newton(const integer& n, long k, long t,
                                                budget& work) const {
      const integer value =
          ((n - times_power_of_two(trace, k)) * n + times_power_of_two(minors, 2 * k)) * n -
          times_power_of_two(determinant, 3 * k);
      const integer slope =
          (3 * n - times_power_of_two(2 * trace, k)) * n + times_power_of_two(minors, 2 * k);
      if (slope == 0) return std::nullopt;
      work.product(3 * words(value), 3 * words(value));
      const integer next = n * slope - value;  // 2^k slope times the step's end
      const integer scaled = times_power_of_two(slope > 0 ? next : -next, t);
      return floor_quotient(scaled, times_power_of_two(slope > 0 ? slope : -slope, k));
    }
    [[nodiscard]] integer discriminant() const {
      return 18 * trace * minors * determinant - 4 * trace * trace * trace * determinant +
             trace * trace * minors * minors - 4 * minors * minors * minors -
             27 * determinant * determinant;
    }
  };

  /// low/2^bits < root < (low + 1)/2^bits, or the root is the whole number low.
  struct bracket {
    integer low;
    long bits = 0;
    bool is_whole = false;
  };

  cubic chi;
  std::array<bracket, 3> at;
  budget* charged;

  /// chi's sign below the i-th root: chi is negative left of all, and changes at each.
  static int sign_below(std::size_t i) { return i == 1 ? 1 : -1; }

  /// Whether the i-th root is between n/2^k and (n + 1)/2^k, which are in its bracket.
  [[nodiscard]] bool is_in(std::size_t i, const integer& n, long k) const {
    return chi.sign_at(n, k, *charged) == sign_below(i) &&
           chi.sign_at(n + 1, k, *charged) == -sign_below(i);
  }

  void halve(std::size_t i) {
    bracket& b = at[i];
    const integer middle = 2 * b.low + 1;
    b.bits += 1;
    b.low = chi.sign_at(middle, b.bits, *charged) == sign_below(i) ? middle : middle - 1;
  }

  /// Newton's step from the middle, where signs show that it is right; else the half.
  void refine(std::size_t i, long bits) {
    constexpr long lost = 4;
    while (at[i].bits < bits) {
      bracket& b = at[i];
      const long t = std::min(bits, 2 * b.bits - lost);
      const std::optional<integer> n =
          t > b.bits + lost ? chi.newton(2 * b.low + 1, b.bits + 1, t, *charged) : std::nullopt;
      bool found = false;
      if (n) {
        const integer first = times_power_of_two(b.low, t - b.bits);
        const integer last = times_power_of_two(b.low + 1, t - b.bits) - 1;
        for (const int step : {0, -1, 1}) {
          const integer low = *n + step;
          if (low < first || low > last || !is_in(i, low, t)) continue;
          b = {low, t, false};
          found = true;
          break;
        }
      }
      if (!found) halve(i);
    }
  }

  [[nodiscard]] interval enclosed(std::size_t i, precision bits) {
    if (at[i].is_whole) return {rational(at[i].low), bits};
    refine(i, bits);
    const long more = at[i].bits - bits;
    return {floor_shift(at[i].low, more), ceiling_shift(at[i].low + 1, more), bits};
  }
};

// chi rises from chi(0) = -D < 0 to its greatest value at c_1 = (T - sqrt(T^2 - 3M))/3, falls to
// its least at c_2 = (T + sqrt(T^2 - 3M))/3 and rises: with three different roots it is positive
// at c_1, negative at c_2 and, as T is the roots' sum, positive at T.
tensor::tensor(const std::array<rational, 6>& entries, budget& work)
    : roots_(std::make_shared<roots>()) {
  roots& r = *roots_;
  r.charged = &work;
  integer common = 1;
  long size = 0;
  for (const rational& entry : entries) {
    common = lcm(common, denominator(entry));
    size += bit_length(entry);
  }
  work.rationals(100, 8 * size);
  std::array<integer, 6> whole;
  std::transform(entries.begin(), entries.end(), whole.begin(),
                 [&](const rational& entry) { return numerator(rational(entry * common)); });
  // Without a common factor, as only ratios matter.
  integer factor = 0;
  for (const integer& n : whole) factor = gcd(factor, n);
  if (factor > 1) {
    for (integer& n : whole) n /= factor;
  }
  const auto& [xx, yy, zz, xy, xz, yz] = whole;
  r.chi = {xx + yy + zz, xx * yy + yy * zz + zz * xx - xy * xy - xz * xz - yz * yz,
           xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz)};
  const auto& [T, M, D] = r.chi;
  // A symmetric matrix has real eigenvalues: all are positive where the signs alternate.
  if (T <= 0 || M <= 0 || D <= 0) throw std::invalid_argument("a principal moment is not positive");
  if (r.chi.discriminant() <= 0) throw std::invalid_argument("two principal moments are equal");
  for (long k = 1;; k *= 2) {
    const integer root = floor_root(times_power_of_two(T * T - 3 * M, 2 * k));
    const integer end = times_power_of_two(T, k);
    const integer first = floor_quotient(end - root, 3);
    const integer second = floor_quotient(end + root, 3);
    if (r.chi.sign_at(first, k, work) <= 0 || r.chi.sign_at(second, k, work) >= 0) continue;
    const std::array<std::pair<integer, integer>, 3> ends{
        {{second, end}, {first, second}, {0, first}}};
    for (std::size_t i = 0; i < ends.size(); ++i) {
      auto [low, high] = ends[i];
      while (high - low > 1) {
        const integer middle = floor_quotient(low + high, 2);
        const int sign = r.chi.sign_at(middle, k, work);
        // Whole roots are points of the grid: they are all met. Other roots are irrational, as chi
        // leads with 1.
        if (sign == 0) {
          r.at[i] = {floor_shift(middle, k), 0, true};
          break;
        }
        (sign == roots::sign_below(i) ? low : high) = middle;
      }
      if (!r.at[i].is_whole) r.at[i] = {low, k, false};
    }
    break;
  }
}

int tensor::kind() const { return roots_->chi.sign_at(roots_->chi.trace, 1, *roots_->charged); }

real tensor::difference(std::size_t i, std::size_t j, std::size_t unit) const {
  const std::shared_ptr<roots> r = roots_;
  const auto& at = r->at;
  if (at[i].is_whole && at[j].is_whole) {
    return rational(at[i].low - at[j].low, at[unit].low);
  }
  const auto quotient = [=](precision bits) {
    return (r->enclosed(i, bits) - r->enclosed(j, bits)) / r->enclosed(unit, bits);
  };
  // Its bits before the point, or the zeros behind it.
  for (long bits = 64;; bits *= 2) {
    try {
      const interval x = quotient({bits, *r->charged});
      if (!x.is_positive()) continue;
      return real::irrational(quotient, 2 * std::abs(bit_length(x.low()) - bits) + 16, *r->charged);
    } catch (const undecided&) {  // more bits
    }
  }
}

real tensor::a() const { return difference(1, 2, 2); }
real tensor::b() const { return difference(0, 1, 0); }

// With a root r, the product of the two others is D/r, and that of their differences from r is
// chi'(r), of either sign: I^2 is D/(x chi'(x)) of the greatest, (J+1)^2 is D/(z chi'(z)) of the
// least. As chi(r) = 0, r chi'(r) = T r^2 - 2 M r + 3 D. Where r is irrational and another root rho
// is rational, r is a root of X^2 - S X + P with S = T - rho, P = D/rho, and r chi'(r) =
// (T S - 2 M) r + 3 D - T P: rational where T S = 2 M alone. Where no root is rational it would
// give r a polynomial of degree 2, and chi is irreducible.
std::optional<rational> tensor::rational_quotient(std::size_t i) const {
  const auto& [T, M, D] = roots_->chi;
  const std::array<roots::bracket, 3>& at = roots_->at;
  if (at[i].is_whole) {
    const integer& r = at[i].low;
    return rational(D, (T * r - 2 * M) * r + 3 * D);
  }
  for (const roots::bracket& other : at) {
    if (!other.is_whole) continue;
    const integer& rho = other.low;
    if (T * (T - rho) != 2 * M) return std::nullopt;
    return rational(D) / (3 * D - rational(T * D, rho));
  }
  return std::nullopt;
}

std::optional<rational> tensor::squared_I() const { return rational_quotient(0); }
std::optional<rational> tensor::squared_J_plus_1() const { return rational_quotient(2); }

}  // namespace polhode::checker
