#include "polhode/quadrature/error_bounds.hpp"

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode {
namespace {

/// n beyond which products of 2n would leave the range of long, with room.
constexpr long most_chebyshev_points = 1'000'000'000;

magnitude times(const ball& factor, const magnitude& bound) {
  if (!factor.is_bounded()) return magnitude::infinity();
  return multiply_up(factor.magnitude_upper(), bound);
}

/// The sum of error(k) rho^-k over k = first, first + 2, ... < 2n.
template <class Error>
ball sum_below_alias(long n, long first, const ball& rho, const Error& error) {
  const ball ratio = 1 / square(rho);
  ball power = 1 / pow(rho, first);
  ball sum(0, rho.precision());
  for (long k = first; k < 2 * n; k += 2) {
    sum += error(k) * power;
    power *= ratio;
  }
  return sum;
}

}  // namespace

ball periodic_trapezoid_error(const strip_bound& bound, long nodes) {
  const precision p = bound.half_width.precision();
  if (nodes < 1 || !certainly_positive(bound.half_width)) return ball::undefined(p);
  return 4 * pi(p) * bound.supremum / (exp(bound.half_width * nodes) - 1);
}

magnitude mean_trapezoid_error(const strip_bound& bound, long nodes) {
  if (nodes < 1 || nodes > most_chebyshev_points) return magnitude::infinity();
  const ball on_circle = periodic_trapezoid_error(bound, 2 * nodes);
  if (!on_circle.is_bounded()) return magnitude::infinity();
  return (on_circle / (2 * pi(bound.half_width.precision()))).magnitude_upper();
}

magnitude gauss_legendre_error(long n, const ball& rho, const magnitude& bound) {
  if (n < 1 || !certainly_greater(rho, 1)) return magnitude::infinity();
  // 64 / (15 (rho^2 - 1) rho^(2n - 2)), decreasing in rho: its greatest value over the ball is at
  // the least rho, and is inside the enclosure.
  const ball factor = 64 / (15 * (square(rho) - 1) * pow(square(rho), n - 1));
  return times(factor, bound);
}

magnitude gauss_chebyshev_error(long n, const ball& rho, const magnitude& bound) {
  if (n < 1 || !certainly_greater(rho, 1)) return magnitude::infinity();
  const ball factor = 2 * pi(rho.precision()) / (pow(square(rho), n) - 1);
  return times(factor, bound);
}

magnitude gauss_chebyshev_second_error(long n, const ball& rho, const magnitude& bound) {
  if (n < 1 || !certainly_greater(rho, 1)) return magnitude::infinity();
  const ball power = pow(square(rho), n + 1);
  return times(pi(rho.precision()) * square(rho + 1 / rho) / (2 * (power - 1)), bound);
}

magnitude clenshaw_curtis_error(long n, const ball& rho, const magnitude& bound) {
  if (n < 1 || n > most_chebyshev_points || !certainly_greater(rho, 1)) {
    return magnitude::infinity();
  }
  const auto error = [n](long k) {
    const long m = 2 * n - k;
    return rational(2, m * m - 1) - rational(2, k * k - 1);
  };
  const ball power = pow(square(rho), n);
  const rational extra = n == 1 ? rational(2) : rational(22, 15);
  const ball factor = sum_below_alias(n, n + 1 + (n + 1) % 2, rho, error) +
                      rational(2, 3) / (power * (1 - 1 / square(rho))) + extra / (power - 1);
  return times(2 * factor, bound);
}

magnitude fejer_error(long n, const ball& rho, const magnitude& bound) {
  if (n < 1 || n > most_chebyshev_points || !certainly_greater(rho, 1)) {
    return magnitude::infinity();
  }
  const auto error = [n](long k) {
    const long m = 2 * n - k;
    const rational of_rule = k == n ? rational(0) : rational(2, m * m - 1);
    return rational(of_rule + rational(2, k * k - 1));
  };
  const ball power = pow(square(rho), n);
  const rational beyond = rational(2, 3) + rational(2, 4 * n * n - 1);
  const ball factor = sum_below_alias(n, n + n % 2, rho, error) +
                      beyond / (power * (1 - 1 / square(rho))) + rational(4, 3) / (power - 1);
  return times(2 * factor, bound);
}

magnitude trapezoid_error(const ball& h, const rectangle_bound& bound) {
  const precision p = 64;
  const ball d = ball::exactly(bound.half_height, p);
  if (!certainly_positive(h) || !certainly_positive(d)) return magnitude::infinity();
  const ball step = h.with_precision(p);
  const ball ends = exp(2 * pi(p) * d / step) - 1;
  magnitude error = times(1 / ends, bound.horizontal);
  for (const std::vector<side_piece>* side : {&bound.left, &bound.right}) {
    double reached = 0;
    for (const side_piece& piece : *side) {
      if (piece.from != reached || !(piece.to >= piece.from)) return magnitude::infinity();
      reached = piece.to;
      const auto logarithm = [&](double y) {
        return log1p(exp(-2 * pi(p) * ball::exactly(y, p) / step));
      };
      const ball weight = (logarithm(piece.from) - logarithm(piece.to)) * step / pi(p);
      error = add_up(error, times(weight, piece.supremum));
    }
    if (reached != bound.half_height) return magnitude::infinity();
  }
  return error;
}

}  // namespace polhode
