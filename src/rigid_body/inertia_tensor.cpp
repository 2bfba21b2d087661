#include "polhode/rigid_body/inertia_tensor.hpp"

#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/roots/newton.hpp"

namespace polhode {
namespace {

/// How many roots of the cubic are at most x, if all are real: 3 less the changes of sign in the
/// Taylor coefficients there, zeros left out. Proof. Let q(t) = p(x + t) have m roots 0. By
/// Descartes' rule the positive roots are at most V(q(t)), the negative ones at most V(q(-t)), and
/// V(q(t)) + V(q(-t)) <= 3 - m; since all roots are real these are 3 - m together, so that equality
/// holds.
long roots_up_to(const rational_polynomial& p, const rational& x) {
  const rational_polynomial slope = p.derivative();
  long above = 0;
  int last = p.leading().sign();
  for (const int sign : {slope.derivative()(x).sign(), slope(x).sign(), p(x).sign()}) {
    if (sign * last < 0) ++above;
    if (sign != 0) last = sign;
  }
  return 3 - above;
}

/// The least integer x in (low, high] with at least k roots up to x/unit. Hypothesis: fewer are up
/// to low/unit, and so many up to high/unit.
integer least_with(const rational_polynomial& p, long k, integer low, integer high,
                   const integer& unit) {
  while (high - low > 1) {
    const integer middle = (low + high) / 2;
    (roots_up_to(p, rational(middle, unit)) >= k ? high : low) = middle;
  }
  return high;
}

/// T, M, D of the characteristic polynomial x^3 - T x^2 + M x - D.
std::array<rational, 3> invariants_of(const std::array<rational, 6>& tensor) {
  const auto& [xx, yy, zz, xy, xz, yz] = tensor;
  return {rational(xx + yy + zz),
          rational(xx * yy + yy * zz + zz * xx - xy * xy - xz * xz - yz * yz),
          rational(xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz))};
}

/// The k-th root from below, which is in (above - 1, above], to about q bits. The box around it is
/// found by exact signs and holds it; Newton's method takes what it can from there.
ball enclosed_root(const rational_polynomial& p, long k, const integer& above, precision q) {
  const rational_polynomial slope = p.derivative();
  const auto f = [&p](const ball& x) { return p(x); };
  const auto derivative = [&slope](const ball& x) { return slope(x); };
  const auto is_narrow = [q](const ball& x) {
    constexpr precision lost = 8;
    return x.is_bounded() && x.radius() <= scale(x.magnitude_lower(), lost - q);
  };
  for (long bits = 0;; bits = 2 * bits + 16) {
    const integer unit = integer(1) << static_cast<unsigned>(bits);
    const integer high = least_with(p, k, (above - 1) * unit, above * unit, unit);
    const precision enough =
        static_cast<precision>(mpz_sizeinbase(high.backend().data(), 2)) + bits + 64;
    ball box = hull(ball(rational(high - 1, unit), enough), ball(rational(high, unit), enough));
    // Where roots are near each other the value near one of them cancels: with twice the box's bits
    // it is resolved.
    const root_enclosure found = refine_root(f, derivative, box, std::max(q, 2 * enough));
    if (found.verdict == root_verdict::unique && is_narrow(found.root)) return found.root;
    if (is_narrow(box)) return box;
  }
}

}  // namespace

/// The moments with the most bits so far.
struct inertia_tensor::known_moments {
  std::mutex guard;
  precision bits = 0;
  std::array<ball, 3> values;
};

inertia_tensor::inertia_tensor(const std::array<rational, 6>& given)
    : entries_(given), common_(1), known_(std::make_shared<known_moments>()) {
  for (const rational& entry : given) common_ = lcm(common_, denominator(entry));
  constexpr std::size_t most_bits = 4096;
  for (const rational& one : given) {
    const rational scaled(one * common_);
    if (mpz_sizeinbase(numerator(scaled).backend().data(), 2) <= most_bits) continue;
    throw input_error("inertia tensor: with a common denominator an entry has more than " +
                      std::to_string(most_bits) + " bits; give shorter numbers, or the moments");
  }
  std::array<rational, 6> entry;
  std::string text;
  for (std::size_t i = 0; i < given.size(); ++i) {
    entry[i] = given[i] * common_;
    text += (i == 0 ? "" : ", ") + to_text(given[i]);
  }
  const auto& [trace, minors, determinant] = invariants_of(entry);
  trace_ = trace;
  // All roots of the characteristic polynomial are real: they are positive exactly where its signs
  // alternate.
  if (trace_ <= 0 || minors <= 0 || determinant <= 0) {
    throw input_error("inertia tensor " + text +
                      ": a principal moment is not positive; all three must be");
  }
  polynomial_ = rational_polynomial(std::vector<rational>{-determinant, minors, -trace_, 1});
  if (count_real_roots(polynomial_, 0, trace_) < 3) {
    throw input_error(
        "inertia tensor " + text +
        ": two principal moments are equal, a symmetric top, which has no intermediate "
        "axis; three different moments are needed");
  }
  // Rational roots of a polynomial with integer coefficients that leads with 1 are integers. The
  // roots are different: the integer above the k-th one, if it is a root, is the k-th where k roots
  // are up to it, and a greater one where more are.
  for (std::size_t i = 0; i < exact_.size(); ++i) {
    const long k = 3 - static_cast<long>(i);
    above_[i] = least_with(polynomial_, k, 0, numerator(trace_), 1);
    const rational above(above_[i]);
    if (polynomial_(above) == 0 && roots_up_to(polynomial_, above) == k) {
      exact_[i] = rational(above / common_);
    }
  }
}

body_kind inertia_tensor::kind() const {
  const rational value = polynomial_(rational(trace_ / 2));
  if (value == 0) return body_kind::planar;
  return value > 0 ? body_kind::physical : body_kind::non_physical;
}

std::optional<inertia_tensor::conjugate_pair> inertia_tensor::beside(std::size_t i) const {
  if (is_rational() || !exact_[i]) return std::nullopt;
  const rational& moment = *exact_[i];
  const rational unit(common_);
  // chi(0) = -xyz of the multiple.
  const rational product(-polynomial_(rational(0)) / (unit * unit * unit));
  return conjugate_pair{moment, rational(trace_ / unit - moment), rational(product / moment)};
}

std::optional<rational> inertia_tensor::square_with_rational_y() const {
  const auto y = beside(1);
  if (!y || y->sum * y->sum - 2 * y->product != y->moment * y->sum) return std::nullopt;
  const rational between(y->moment * y->sum - y->moment * y->moment - y->product);
  return rational(y->moment * (y->sum - y->moment) / (2 * between));
}

std::optional<rational> inertia_tensor::exact_square_of_geometric_constant() const {
  if (const auto x = beside(0)) {
    return rational(x->product / (x->moment * x->moment - x->moment * x->sum + x->product));
  }
  return square_with_rational_y();
}

std::optional<rational> inertia_tensor::exact_square_of_second_constant() const {
  if (const auto z = beside(2)) {
    return rational(z->product / (z->product - z->moment * z->sum + z->moment * z->moment));
  }
  return square_with_rational_y();
}

precision inertia_tensor::lost_bits() const { return 3 * size_in_bits(trace_); }

std::array<ball, 3> inertia_tensor::moments(precision p) const {
  const std::lock_guard lock(known_->guard);
  if (known_->bits >= p) return known_->values;
  std::array<ball, 3> result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (exact_[i]) {
      result[i] = ball(*exact_[i], p);
      continue;
    }
    result[i] = enclosed_root(polynomial_, 3 - static_cast<long>(i), above_[i], p) / common_;
  }
  if (std::all_of(result.begin(), result.end(), [](const ball& x) { return x.is_bounded(); })) {
    known_->bits = p;
    known_->values = result;
  }
  return result;
}

ball inertia_tensor::a(precision p) const {
  const auto [x, y, z] = moments(p + lost_bits());
  return (y - z) / z;
}

ball inertia_tensor::b(precision p) const {
  const auto [x, y, z] = moments(p + lost_bits());
  return (x - y) / x;
}

ball inertia_tensor::geometric_constant(precision p) const {
  if (kind() == body_kind::planar) return ball(1, p);
  const auto [x, y, z] = moments(p + lost_bits());
  return sqrt(y * z / ((x - y) * (x - z)));
}

ball inertia_tensor::second_geometric_constant(precision p) const {
  const auto [x, y, z] = moments(p + lost_bits());
  const ball below = (y - z) * (x - z);
  return z * (x + y - z) / below / (sqrt(x * y / below) + 1);
}

std::optional<std::array<rational, 3>> equal_principal_moments(
    const std::array<rational, 6>& tensor) {
  const auto& [t, m, d] = invariants_of(tensor);
  const rational discriminant(18 * t * m * d - 4 * t * t * t * d + t * t * m * m - 4 * m * m * m -
                              27 * d * d);
  if (discriminant != 0) return std::nullopt;
  const rational difference(t * t - 3 * m);
  const rational twice(difference == 0 ? rational(t / 3)
                                       : rational((t * m - 9 * d) / (2 * difference)));
  const rational once(t - 2 * twice);
  if (once > twice) return std::array<rational, 3>{once, twice, twice};
  return std::array<rational, 3>{twice, twice, once};
}

}  // namespace polhode
