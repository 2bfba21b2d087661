#include "polhode/certificate/agm_bracket.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace polhode {
namespace {

enum class direction { up, down };

integer rounded_root(const integer& n, direction way) {
  integer root(sqrt(n));
  if (way == direction::up && root * root < n) ++root;
  return root;
}

integer rounded_half(const integer& n, direction way) {
  return integer((way == direction::up ? n + 1 : n) / 2);
}

json pair_of(const integer& A, const integer& B) { return json::array({A.str(), B.str()}); }

/// The chain from n/S, or nothing where it comes to a standstill before both numbers are on their
/// side of S/2.
std::optional<json> chain(const integer& S, const integer& n, direction way) {
  constexpr int most_steps = 100;
  const auto is_over = [&](const integer& x) {
    return way == direction::up ? 2 * x < S : 2 * x > S;
  };
  integer A = rounded_root(integer((S + n) * S), way);
  integer B = rounded_root(integer(n * S), way);
  json steps = json::array();
  json result{{"argument", n.str()}, {"start", pair_of(A, B)}};
  for (int i = 0; i < most_steps; ++i) {
    if (is_over(A) && is_over(B)) {
      result["steps"] = std::move(steps);
      return result;
    }
    const integer mean = rounded_half(integer(A + B), way);
    B = rounded_root(integer(A * B), way);
    A = mean;
    if (B <= 0) return std::nullopt;
    steps.push_back(pair_of(A, B));
  }
  return std::nullopt;
}

}  // namespace

std::optional<json> agm_bracket_witness(const rational& lower, const rational& upper) {
  const auto bits = std::max(msb(integer(denominator(lower))), msb(integer(denominator(upper))));
  for (const unsigned guard : {16U, 40U, 128U}) {
    const integer S = integer(1) << (bits + guard);
    auto from_below = chain(S, integer(numerator(rational(lower * S))), direction::up);
    auto from_above = chain(S, integer(numerator(rational(upper * S))), direction::down);
    if (from_below && from_above) {
      return json{{"kind", "agm_bracket"},
                  {"scale", S.str()},
                  {"below", *std::move(from_below)},
                  {"above", *std::move(from_above)}};
    }
  }
  return std::nullopt;
}

}  // namespace polhode
