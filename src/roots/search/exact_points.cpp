#include "exact_points.hpp"

#include "roots/polynomial/root_bracket.hpp"

namespace polhode::detail {
namespace exact_points_impl {
namespace {

std::optional<rational> if_simple(rational q) {
  constexpr std::size_t most_bits = 200;  // of the longer part
  if (rational_polynomial({q}).height() > most_bits) return std::nullopt;
  return q;
}

}  // namespace
}  // namespace exact_points_impl

std::optional<rational> simple_number_in(const exact_box& b) {
  return exact_points_impl::if_simple(simplest_between(*b.lower, *b.upper));
}

std::optional<rational> simple_multiple_of_pi_in(const exact_box& b, precision bits) {
  const auto turns = simplest_multiple_of_pi(*b.lower, *b.upper, bits + 64);
  return turns ? exact_points_impl::if_simple(*turns) : std::nullopt;
}

}  // namespace polhode::detail
