#include "exact_points.hpp"

#include <stdexcept>

#include "polhode/arithmetic/text.hpp"
#include "roots/polynomial/root_bracket.hpp"

namespace polhode::detail {
namespace exact_points_impl {
namespace {

std::optional<rational> if_simple(rational q) {
  constexpr std::size_t most_bits = 200;  // of the longer part
  if (rational_polynomial({q}).height() > most_bits) return std::nullopt;
  return q;
}

/// Of a guess: others are no simpler than a number that is drawn from the box.
constexpr std::size_t most_bits_of_guess = 16;

/// The simplest rational number from the lower end of one enclosure to the upper of the other.
std::optional<rational> simplest_from(const ball& low, const ball& high) {
  if (!low.is_bounded() || !high.is_bounded()) return std::nullopt;
  const rational q = simplest_between(lower_rational(low), upper_rational(high));
  if (rational_polynomial({q}).height() > most_bits_of_guess) return std::nullopt;
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

std::string exact_point::to_text() const {
  if (formula_) return formula_->to_text();
  return polhode::to_text(form_->q) + " + (" + polhode::to_text(form_->r) + ")*pi";
}

std::vector<exact_point> guessed_points(const expression& f, const exact_box& b, precision bits) {
  using exact_points_impl::simplest_from;
  constexpr std::size_t most_constants = 8;
  const precision p = bits + 64;
  const ball low(*b.lower, p);
  const ball high(*b.upper, p);
  std::vector<exact_point> result;
  const auto add = [&](const std::string& text) {
    const expression formula(text, f.names());
    const ball value = formula.value(p);
    if (certainly_less_equal(low, value) && certainly_less_equal(value, high)) {
      result.emplace_back(formula);
    }
  };
  for (const expression& constant : f.constants(most_constants)) {
    constexpr std::size_t longest = 200;  // operations: a point is a short formula
    const ball k = constant.value(p);
    if (contains_zero(k) || !k.is_bounded() || constant.operation_count() > longest) continue;
    const bool turned = certainly_negative(k);
    if (const auto q = simplest_from((turned ? high : low) / k, (turned ? low : high) / k)) {
      if (*q == 0) continue;
      try {
        add('(' + to_text(*q) + ")*(" + constant.to_text() + ')');
      } catch (const input_error&) {        // an enclosure has no text
      } catch (const std::length_error&) {  // or one that is too long
      }
    }
  }
  const bool positive = *b.lower > 0;
  if (positive || *b.upper < 0) {
    const auto square =
        positive ? simplest_from(low * low, high * high) : simplest_from(high * high, low * low);
    if (square) add((positive ? "sqrt(" : "-sqrt(") + to_text(*square) + ')');
  }
  if (positive) {
    if (const auto q = simplest_from(log(low), log(high))) add("exp(" + to_text(*q) + ')');
  }
  constexpr long most_of_exponential = 32;
  if (*b.lower > -most_of_exponential && *b.upper < most_of_exponential) {
    const auto q = simplest_from(exp(low), exp(high));
    if (q && *q > 0) add("log(" + to_text(*q) + ')');
  }
  return result;
}

}  // namespace polhode::detail
