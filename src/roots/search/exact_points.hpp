#pragma once

// Points of a box at which a function may be known exactly.

#include <memory>
#include <optional>
#include <vector>

#include "polhode/arithmetic/known_number.hpp"
#include "polhode/arithmetic/multiple_of_pi.hpp"
#include "polhode/expression/expression.hpp"
#include "state.hpp"

namespace polhode::detail {

[[nodiscard]] inline exact_box exact_ends(const ball& x) {
  return {lower_rational(x), upper_rational(x)};
}

/// False where x is undefined.
[[nodiscard]] inline bool is_certainly_not_zero(const ball& x) {
  return !x.is_undefined() && !contains_zero(x);
}

/// The simplest rational number in the bounded box; nothing where its parts are long.
[[nodiscard]] std::optional<rational> simple_number_in(const exact_box& b);
/// The simplest rational r for which r pi is in the bounded box; nothing where its parts are long.
[[nodiscard]] std::optional<rational> simple_multiple_of_pi_in(const exact_box& b, precision bits);

/// A number that is known exactly: by its form, or by a formula without variables.
class exact_point {
 public:
  exact_point(const pi_combination& form) : form_(form) {}  // NOLINT(google-explicit-constructor)
  explicit exact_point(const expression& formula)
      : formula_(std::make_shared<const expression>(formula)) {}

  /// Nothing where a formula is all that is known.
  [[nodiscard]] const std::optional<pi_combination>& form() const { return form_; }
  [[nodiscard]] std::optional<rational> as_rational() const {
    return form_ && form_->is_rational() ? std::optional(form_->q) : std::nullopt;
  }
  [[nodiscard]] ball at(precision p) const { return form_ ? form_->at(p) : formula_->value(p); }
  [[nodiscard]] known_number known(precision p) const {
    return form_ ? known_number(*form_, p) : formula_->known_value(p);
  }
  /// The number as a formula.
  [[nodiscard]] std::string to_text() const;

 private:
  std::optional<pi_combination> form_;
  std::shared_ptr<const expression> formula_;
};

/// Numbers in the bounded box at which f may be 0: the simplest rational multiples of its
/// constants, and roots, logarithms and exponentials of rational numbers. Each lies in the box;
/// that f is 0 there is a guess.
[[nodiscard]] std::vector<exact_point> guessed_points(const expression& f, const exact_box& b,
                                                      precision bits);

/// The first answer, which is an optional, that f gives for one of these two points.
template <class F>
[[nodiscard]] auto first_of_simple_points(const exact_box& b, precision bits, const F& f)
    -> decltype(f(pi_combination{})) {
  if (const auto q = simple_number_in(b)) {
    if (auto r = f(pi_combination{*q, 0})) return r;
  }
  const auto turns = simple_multiple_of_pi_in(b, bits);
  return turns ? f(pi_combination{0, *turns}) : std::nullopt;
}

}  // namespace polhode::detail
