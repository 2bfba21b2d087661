// Inverse trigonometric functions in exact_field: a rational multiple of pi where a number is the
// sine or tangent of one, else a sum of arc tangents of as few as possible.

#include <optional>
#include <utility>

#include "expression/exact/factors.hpp"
#include "expression/exact/rationals.hpp"
#include "expression/exact/terms.hpp"
#include "expression/exact_number.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/polynomial.hpp"

namespace polhode::detail {
using namespace exact_parts;

namespace {

constexpr long greatest_denominator = 120;  // of an angle that is looked for

/// The fraction of few digits in an enclosure of an angle over pi: a candidate, which is no more
/// than near.
std::optional<rational> near_fraction(const ball& angle) {
  if (!angle.is_bounded()) return std::nullopt;
  const ball turns = angle / polhode::pi(angle.precision());
  if (!turns.is_bounded()) return std::nullopt;
  constexpr int most_quotients = 64;
  auto q = simplest_between(lower_rational(turns), upper_rational(turns), most_quotients);
  if (!q || denominator(*q) > greatest_denominator) return std::nullopt;
  return q;
}

/// The a and b of p = a^2 + b^2, a >= b, for a prime p of the form 4 k + 1.
std::pair<integer, integer> squares_of_sum(const integer& p) {
  integer a;
  integer b = 0;
  do {
    ++b;
    a = p - b * b;
  } while (mpz_perfect_square_p(a.backend().data()) == 0);
  mpz_sqrt(a.backend().data(), a.backend().data());
  if (a < b) std::swap(a, b);
  return {a, b};
}

/// The one integer in an enclosure.
integer integer_in(const ball& x) {
  integer k = floor_of(upper_rational(x));
  if (rational(k) < lower_rational(x) || rational(k - 1) >= lower_rational(x)) throw not_decided();
  return k;
}

}  // namespace

/// pi q for the q in [-1/2, 1/2] with sin(pi q) = x, where it is found; else atan(x/sqrt(1 - x^2)).
exact_sum exact_field::asin(const exact_sum& x) {
  for (const int s : {-1, 0, 1}) {
    if (x == exactly(s)) return scaled(pi(), rational(s, 2));
  }
  const auto q = near_fraction(polhode::asin(enclosure(x)));
  if (q && *q >= -half && *q <= half && sinpi(*q) == x) return scaled(pi(), *q);
  return atan(quotient(x, sqrt(difference(exactly(1), product(x, x)))));
}

exact_sum exact_field::acos(const exact_sum& x) { return difference(scaled(pi(), half), asin(x)); }

/// atan t of t > 0 by a generator, of t or 1/t.
exact_sum exact_field::generated_arctan(const rational& t) {
  const rational below_1 = t < 1 ? t : rational(1 / t);
  const generator_id g = make(kind::arctan, exactly(below_1), polhode::atan(ball(below_1, bits)));
  return t < 1 ? generated(g) : difference(scaled(pi(), half), generated(g));
}

/// atan t of t = n/d > 0 by the factors of d + i n in Z[i] (C. F. Gauss; J. Todd, A problem on arc
/// tangent relations, 1949): d + i n = i^k (1 + i)^f times powers of a + i b or a - i b, one of the
/// two for each prime p = a^2 + b^2 that divides d^2 + n^2, as d and n are coprime. So atan t = k
/// pi/2 + f pi/4 + the sum of their +-e atan(b/a), and an enclosure tells k.
///
/// None where the factors are not known or great.
std::optional<exact_sum> exact_field::arctan_by_gaussian_factors(const rational& t) {
  const integer n = numerator(t);
  const integer d = denominator(t);
  spend(100);
  exact_sum result;
  for (const factor& p : factors_of(integer(n * n + d * d))) {
    if (p.base == 2) {
      result = sum(result, scaled(pi(), rational(p.multiplicity, 4)));
      continue;
    }
    constexpr long greatest_prime = 1L << 32;
    if (!p.is_prime || p.base > greatest_prime) return std::nullopt;
    spend(1000);
    const auto [a, b] = squares_of_sum(p.base);
    const bool divides = (d * a + n * b) % p.base == 0 && (n * a - d * b) % p.base == 0;
    const rational slope = rational(b) / rational(a);
    const generator_id g = make(kind::arctan, exactly(slope), polhode::atan(ball(slope, bits)));
    result = sum(result, scaled(generated(g), divides ? p.multiplicity : -p.multiplicity));
  }
  const ball left = polhode::atan(ball(t, bits)) - enclosure(result);
  const integer k = integer_in(left * 2 / polhode::pi(bits));
  return sum(result, scaled(pi(), rational(k) / 2));
}

/// atan t of t > 0.
exact_sum exact_field::arctan_of_rational(const rational& t) {
  constexpr std::size_t short_bits = 64;
  if (bits_of(t) <= short_bits) {
    if (auto result = arctan_by_gaussian_factors(t)) return *result;
  }
  return generated_arctan(t);
}

/// pi q for the q in (-1/2, 1/2) with sin(pi q) = x cos(pi q), where it is found.
exact_sum exact_field::atan(const exact_sum& x) {
  const int s = sign(x);
  if (s == 0) return {};
  if (s < 0) return scaled(atan(scaled(x, -1)), -1);
  const auto q = near_fraction(polhode::atan(enclosure(x)));
  if (q && *q > 0 && *q < half && product(x, cospi(*q)) == sinpi(*q)) return scaled(pi(), *q);
  if (const auto number = plain_number(x)) return arctan_of_rational(*number);
  if (sign(difference(x, exactly(1))) > 0) {
    return difference(scaled(pi(), half), atan(reciprocal(x)));
  }
  return generated(make(kind::arctan, x, polhode::atan(enclosure(x))));
}

}  // namespace polhode::detail
