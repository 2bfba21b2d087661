// Cosines and sines in exact_field: of rational multiples of pi, of whole multiples of arc
// tangents, and of sums of both.

#include <cstdlib>
#include <optional>
#include <utility>

#include "expression/exact/rationals.hpp"
#include "expression/exact_number.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {

using namespace exact_parts;

/// cos(pi q) of 0 <= q <= 1/2 by the roots of natural numbers: cos(pi/3) = 1/2, cos(pi/4) =
/// sqrt(2)/2, cos(pi/6) = sqrt(3)/2, cos(pi/5) = (1 + sqrt 5)/4, cos(2 pi/5) = (sqrt 5 - 1)/4,
/// cos(pi/12) = (sqrt 6 + sqrt 2)/4, cos(5 pi/12) = (sqrt 6 - sqrt 2)/4.
std::optional<exact_sum> exact_field::cospi_of_few_roots(const rational& angle) {
  const auto root = [this](long n) { return number_power(n, half); };
  const auto is = [&](long above, long below) { return angle == rational(above, below); };
  if (angle == 0) return exactly(1);
  if (is(1, 2)) return exact_sum();
  if (is(1, 3)) return exactly(half);
  if (is(1, 4)) return scaled(root(2), half);
  if (is(1, 6)) return scaled(root(3), half);
  const rational quarter(1, 4);
  if (is(1, 5)) return scaled(sum(root(5), exactly(1)), quarter);
  if (is(2, 5)) return scaled(difference(root(5), exactly(1)), quarter);
  if (is(1, 12)) return scaled(sum(root(6), root(2)), quarter);
  if (is(5, 12)) return scaled(difference(root(6), root(2)), quarter);
  return std::nullopt;
}

/// cos(pi q): by its period and symmetries from 0 <= q <= 1/2, and by cos(x/2) = sqrt((1 + cos
/// x)/2) from angles of few roots where the denominator is one of theirs and some factors 2 more.
exact_sum exact_field::cospi(const rational& q) {
  if (bits_of(q) > most_bits) throw not_decided();
  spend(4);
  rational angle = q - 2 * rational(floor_of(q * half));
  if (angle > 1) angle = 2 - angle;
  if (angle > half) return scaled(cospi(1 - angle), -1);
  if (auto known = cospi_of_few_roots(angle)) return *known;
  constexpr long most_halves = 64;
  integer odd = denominator(angle);
  mpz_tdiv_q_2exp(odd.backend().data(), odd.backend().data(), mpz_scan1(odd.backend().data(), 0));
  if (denominator(angle) <= most_halves && (odd == 1 || odd == 3 || odd == 5)) {
    return sqrt(scaled(sum(exactly(1), cospi(2 * angle)), half));
  }
  return generated(make(kind::cosine, exactly(angle), polhode::cos(polhode::pi(bits) * angle)));
}

/// {cos(x + y), sin(x + y)} from {cos x, sin x} and {cos y, sin y}.
std::pair<exact_sum, exact_sum> exact_field::cos_and_sin_of_sum(
    const std::pair<exact_sum, exact_sum>& x, const std::pair<exact_sum, exact_sum>& y) {
  const auto& [cos_x, sin_x] = x;
  const auto& [cos_y, sin_y] = y;
  exact_sum cosine = difference(product(cos_x, cos_y), product(sin_x, sin_y));
  exact_sum sine = sum(product(sin_x, cos_y), product(cos_x, sin_y));
  return {std::move(cosine), std::move(sine)};
}

/// {cos(x + n y), sin(x + n y)} from {cos x, sin x}, for y = atan(tangent): cos y = 1/sqrt(1 +
/// tangent^2) and sin y = tangent cos y.
std::pair<exact_sum, exact_sum> exact_field::turned_by_arcs(std::pair<exact_sum, exact_sum> x,
                                                            const exact_sum& tangent, long n) {
  const exact_sum cosine = reciprocal(sqrt(sum(exactly(1), product(tangent, tangent))));
  const exact_sum sine = scaled(product(tangent, cosine), n < 0 ? -1 : 1);
  for (long k = 0; k < std::abs(n); ++k) x = cos_and_sin_of_sum(x, {cosine, sine});
  return x;
}

/// By the sums of angles. What is left but multiples of pi and of arc tangents is an angle of which
/// cosine and sine are generators, or nothing is known.
std::pair<exact_sum, exact_sum> exact_field::cos_and_sin(const exact_sum& x) {
  constexpr long most_arcs = 16;
  rational turns = 0;
  exact_sum left;
  std::pair<exact_sum, exact_sum> result(exactly(1), exact_sum());
  long arcs = 0;
  for (const auto& [m, c] : x) {
    const bool is_multiple = m.size() == 1 && m.front().second == 1;
    if (is_multiple && generators_[m.front().first].what == kind::pi) {
      turns = c;
      continue;
    }
    if (!is_multiple || generators_[m.front().first].what != kind::arctan) {
      add_to(left, m, c);
      continue;
    }
    const integer whole = floor_of(c);
    add_to(left, m, rational(c - rational(whole)));
    const long n = as_long(whole);
    if (n > most_arcs || n < -most_arcs || (arcs += std::abs(n)) > most_arcs) throw not_decided();
    const exact_sum tangent = generators_[m.front().first].of;
    result = turned_by_arcs(std::move(result), tangent, n);
  }
  if (!left.empty()) result = cos_and_sin_of_sum(result, generated_cos_and_sin(left));
  return cos_and_sin_of_sum(result, {cospi(turns), sinpi(turns)});
}

}  // namespace polhode::detail
