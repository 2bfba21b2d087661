#pragma once

// The ends of ranges: of an integral, of a search for roots, of a piece of either.

#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "polhode/arithmetic/pi_combination.hpp"

namespace polhode {

/// A number that can be enclosed to any precision, exactly where it is known so, or an infinity:
///
///   end_point(1)   end_point(rational(1, 3))   end_point::pi(rational(1, 2))   -end_point::infinity()
///   end_point([](precision p) { return sqrt(ball(2, p)); })
class end_point {
 public:
  template <machine_integer N>
  end_point(N n)  // NOLINT(google-explicit-constructor): exact
      : end_point(rational(n)) {}
  end_point(const rational& q)  // NOLINT(google-explicit-constructor): exact
      : end_point(pi_combination{q, 0}) {}
  /// The set x, whose width the result cannot fall below.
  end_point(const ball& x)  // NOLINT(google-explicit-constructor): the same set
      : end_point([x](precision) { return x; }) {}
  /// q + r pi, known as such. An integrand that is even about it, or of such a period, is integrated by fewer evaluations;
  /// a root that is exactly there, as sin(x) has at pi, is found to be inside.
  explicit end_point(const pi_combination& x)
      : at_(shared([x](precision p) { return x.at(p); })), form_(x) {
    if (x.is_rational()) exact_ = x.q;
  }
  /// r pi.
  [[nodiscard]] static end_point pi(const rational& r = 1) {
    return end_point(pi_combination{0, r});
  }
  /// A number that at(p) encloses with p bits.
  explicit end_point(std::function<ball(precision)> at) : at_(shared(std::move(at))) {}
  /// A double is a decimal only by accident: see ball.
  template <std::floating_point N>
  end_point(N) = delete;

  [[nodiscard]] static end_point infinity() { return {1, infinite{}}; }
  friend end_point operator-(const end_point& x) {
    if (x.infinite_ != 0) return {-x.infinite_, infinite{}};
    if (x.form_) return end_point(-*x.form_);
    return end_point([at = x.at_](precision p) { return -(*at)(p); });
  }

  /// 1 for infinity, -1 for -infinity, else 0.
  [[nodiscard]] int infinite_sign() const { return infinite_; }
  [[nodiscard]] bool is_infinite() const { return infinite_ != 0; }
  /// The rational number that it is known to be.
  [[nodiscard]] const std::optional<rational>& exact() const { return exact_; }
  /// The number q + r pi that it is known to be.
  [[nodiscard]] const std::optional<pi_combination>& form() const { return form_; }
  /// An enclosure with p bits; undefined for an infinity.
  [[nodiscard]] ball at(precision p) const {
    return infinite_ == 0 ? (*at_)(p) : ball::undefined(p);
  }
  /// They are the same point for certain: equal exact numbers, the same infinity, or copies of one end point.
  [[nodiscard]] bool is_same_as(const end_point& other) const {
    if (infinite_ != other.infinite_) return false;
    if (infinite_ != 0) return true;
    if (form_ && other.form_) return *form_ == *other.form_;
    return at_ == other.at_;
  }

 private:
  using function = std::function<ball(precision)>;
  struct infinite {};
  end_point(int sign, infinite /*unused*/) : infinite_(sign) {}
  static std::shared_ptr<const function> shared(function at) {
    return std::make_shared<const function>(std::move(at));
  }

  std::shared_ptr<const function> at_;
  std::optional<rational> exact_;
  std::optional<pi_combination> form_;
  int infinite_ = 0;
};

// What they were called in version 0.1.
using limit [[deprecated("it is called end_point")]] = end_point;
using range_end [[deprecated("it is called end_point")]] = end_point;

}  // namespace polhode
