// Square roots of sums in exact_field, written without a root under a root: sqrt(3 + 2 sqrt 2) = 1
// + sqrt 2. A candidate is found by a formula and then squared: what is returned is a root whatever
// led to it.

#include <optional>

#include "expression/exact/rationals.hpp"
#include "expression/exact/terms.hpp"
#include "expression/exact_number.hpp"

namespace polhode::detail {

using namespace exact_parts;

/// The root of a term or a sum, without a root of a sum that is not one already.
std::optional<exact_sum> exact_field::plain_root(const exact_sum& x, int depth) {
  if (x.empty()) return x;
  if (x.size() > 1) return denested_root(x, depth);
  if (x.begin()->second < 0 || !is_positive(x.begin()->first)) return std::nullopt;
  return power(x, half);
}

/// x sqrt(v) as x s/sqrt(u), for a root sqrt(u) that is known and s = sqrt(u v).
std::optional<exact_sum> exact_field::times_known_root(const exact_sum& x, const exact_sum& v) {
  for (generator_id g = 0; g < generators_.size(); ++g) {
    const exact_sum u = generators_[g].of;
    if (generators_[g].what != kind::base || plain_number(u)) continue;
    try {
      const auto s = plain_root(product(u, v), deepest_root);
      if (!s) continue;
      const exact_sum root = product(product(*s, rationalised_reciprocal(u)), generated(g, half));
      return product(x, root);
    } catch (const not_decided&) {
      spend(1);
    }
  }
  return std::nullopt;
}

/// sqrt(x) of a sum x = a + b g^(1/2) > 0 as sqrt((a + r)/2) + sqrt((a - r)/2), or the difference,
/// with r = sqrt(a^2 - b^2 g). However it was found, s is the root where s^2 = x and s > 0; both
/// are checked.
std::optional<exact_sum> exact_field::denested_root(const exact_sum& x, int depth) {
  if (depth == 0 || x.size() < 2) return std::nullopt;
  for (const generator_id g : square_roots_in(x)) {
    try {
      const auto parts = split(x, g);
      if (!parts) continue;
      const auto& [a, b] = *parts;
      const exact_sum square =
          difference(product(a, a), product(product(b, b), exact_sum(generators_[g].of)));
      const auto r = plain_root(square, depth - 1);
      if (!r) continue;
      const auto first = plain_root(scaled(sum(a, *r), half), depth - 1);
      if (!first) continue;
      const auto second = plain_root(scaled(difference(a, *r), half), depth - 1);
      if (!second) continue;
      for (const int s : {1, -1}) {
        const exact_sum root = sum(*first, scaled(*second, s));
        if (product(root, root) == x) return scaled(root, sign(root));
      }
    } catch (const not_decided&) {
      spend(1);
    }
  }
  return std::nullopt;
}

}  // namespace polhode::detail
