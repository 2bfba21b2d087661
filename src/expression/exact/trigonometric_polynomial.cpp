// Cosines and sines of angles that are no multiples of pi, as generators of exact_field: cos(x) and
// sin(x) for a sum x.
//
// Products of them are made into sums, by
//   cos a cos b = (cos(a - b) + cos(a + b))/2,   sin a sin b = (cos(a - b) - cos(a + b))/2,
//   sin a cos b = (sin(a + b) + sin(a - b))/2,
// so that every polynomial in them is a linear combination of cosines and sines of different
// angles: a polynomial in the e^(i x_k) in its one form, without a complex number. By the theorem
// of Lindemann and Weierstrass (A. Baker, Transcendental Number Theory, 1975, theorem 1.4) the e^(i
// x) of different algebraic x are linearly independent over the algebraic numbers, so that with
// algebraic angles two equal numbers have the same form, up to relations among the coefficients.
// Nothing rests on that: here, as in all of exact_field, a sum whose terms cancel is 0, which needs
// the identities above alone.

#include <algorithm>
#include <vector>

#include "expression/exact_number.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {
namespace {

constexpr long most_factors = 32;  // of a product that is made into a sum

bool is_positive_integer(const rational& q) { return denominator(q) == 1 && q > 0; }

/// m without one factor g.
monomial without_one(monomial m, generator_id g) {
  const auto part =
      std::find_if(m.begin(), m.end(), [g](const auto& one) { return one.first == g; });
  part->second -= 1;
  if (part->second == 0) m.erase(part);
  return m;
}

}  // namespace

/// {cos x, sin x} of a sum x that has no multiples of pi, with cos(-x) = cos x and sin(-x) = -sin
/// x.
std::pair<exact_sum, exact_sum> exact_field::generated_cos_and_sin(const exact_sum& x) {
  if (!further_) throw not_decided();
  const int s = x.begin()->second.sign();
  const exact_sum angle = scaled(x, s);
  const ball around = enclosure(angle);
  // Of a greater angle an enclosure of `bits` bits tells too little, and functions of it take long.
  const ball greatest(rational(integer(1) << (bits / 2)), bits);
  if (!certainly_positive(greatest - around) || !certainly_positive(greatest + around)) {
    throw not_decided();
  }
  const generator_id cosine = make(kind::angle_cosine, angle, polhode::cos(around));
  const generator_id sine = make(kind::angle_sine, angle, polhode::sin(around));
  return {generated(cosine), scaled(generated(sine), s)};
}

std::pair<long, long> exact_field::waves_in(const monomial& m) const {
  std::pair<long, long> result(0, 0);
  for (const auto& [g, exponent] : m) {
    const kind what = generators_[g].what;
    if (!is_positive_integer(exponent)) continue;
    const long factors =
        exponent > most_factors ? most_factors + 1 : numerator(exponent).convert_to<long>();
    if (what == kind::cosine) result.first += factors;
    if (what == kind::angle_cosine || what == kind::angle_sine) result.second += factors;
  }
  return result;
}

bool exact_field::has_waves_to_reduce(const monomial& m) const {
  if (!further_) return false;
  const auto [of_pi, others] = waves_in(m);
  return (of_pi > 1 || others > 1) && of_pi <= most_factors && others <= most_factors;
}

/// The product of two of the same sort. The angle of the sum and the difference may have a closed
/// form: x + x for x = atan(1/2)/2 has.
exact_sum exact_field::product_of_waves(generator_id v, generator_id w) {
  const rational half(1, 2);
  const generator a = generators_[v];
  const generator b = generators_[w];
  if (a.what == kind::cosine) {
    const rational p = a.of.begin()->second;
    const rational q = b.of.begin()->second;
    return scaled(sum(cospi(p - q), cospi(p + q)), half);
  }
  const auto [cos_sum, sin_sum] = cos_and_sin(sum(a.of, b.of));
  const auto [cos_difference, sin_difference] = cos_and_sin(difference(a.of, b.of));
  const bool first_is_sine = a.what == kind::angle_sine;
  const bool second_is_sine = b.what == kind::angle_sine;
  if (first_is_sine && second_is_sine) return scaled(difference(cos_difference, cos_sum), half);
  if (first_is_sine) return scaled(sum(sin_sum, sin_difference), half);
  if (second_is_sine) return scaled(difference(sin_sum, sin_difference), half);
  return scaled(sum(cos_difference, cos_sum), half);
}

/// One pair after the other. Longer products factor by factor, so that equal terms come together at
/// every step.
exact_sum exact_field::with_waves_reduced(const monomial& m) {
  const auto [of_pi, others] = waves_in(m);
  std::vector<generator_id> of_sort;  // the factors of a sort with two or more, or else all
  monomial rest = m;
  const bool is_long = of_pi > 2 || others > 2;
  for (const auto& [g, exponent] : m) {
    const bool is_of_pi = generators_[g].what == kind::cosine;
    const bool is_other =
        generators_[g].what == kind::angle_cosine || generators_[g].what == kind::angle_sine;
    const bool is_meant = is_long ? is_of_pi || is_other : (others == 2 ? is_other : is_of_pi);
    if (!is_meant || !is_positive_integer(exponent)) continue;
    for (long k = numerator(exponent).convert_to<long>(); k > 0; --k) {
      of_sort.push_back(g);
      rest = without_one(rest, g);
    }
  }
  exact_sum result = expanded(rest);
  if (!is_long) return product(result, product_of_waves(of_sort[0], of_sort[1]));
  for (const generator_id g : of_sort) result = product(result, generated(g));
  return result;
}

}  // namespace polhode::detail
