#pragma once

// The ends of ranges: of an integral, of a search for roots, of a piece of either.

#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "polhode/arithmetic/pi_combination.hpp"

namespace polhode {

/// How a number was given, for a room above that can read it: a formula, say, of which more can be
/// decided than of enclosures.
class number_definition {
 public:
  number_definition() = default;
  number_definition(const number_definition&) = delete;
  number_definition& operator=(const number_definition&) = delete;
  virtual ~number_definition() = default;
};

/// A number that can be enclosed to any precision, exactly where it is known so, or an infinity:
///
///   end_point(1)   end_point(rational(1, 3))   end_point::pi(rational(1, 2))
///     -end_point::infinity()
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
  /// q + r pi, known as such. An integrand that is even about it, or of such a period, is
  /// integrated by fewer evaluations; a root that is exactly there, as sin(x) has at pi, is found
  /// to be inside.
  explicit end_point(const pi_combination& x) {
    knowledge known;
    known.form = x;
    if (x.is_rational()) known.exact = x.q;
    known_ = std::make_shared<const knowledge>(std::move(known));
  }
  /// r pi.
  [[nodiscard]] static end_point pi(const rational& r = 1) {
    return end_point(pi_combination{0, r});
  }
  /// A number that at(p) encloses with p bits; with its definition, where it has one.
  explicit end_point(std::function<ball(precision)> at,
                     std::shared_ptr<const number_definition> definition = nullptr) {
    knowledge known;
    known.at = std::move(at);
    known.definition = std::move(definition);
    known_ = std::make_shared<const knowledge>(std::move(known));
  }
  // Copies only: what was moved from stays a number.
  end_point(const end_point&) = default;
  end_point& operator=(const end_point&) = default;
  ~end_point() = default;
  /// A double is a decimal only by accident: see ball.
  template <std::floating_point N>
  end_point(N) = delete;
  template <no_number_at_all N>
  end_point(N) = delete;

  [[nodiscard]] static end_point infinity() { return {1, infinite{}}; }
  friend end_point operator-(const end_point& x) {
    if (x.is_infinite()) return {-x.infinite_sign(), infinite{}};
    if (x.form()) return end_point(-*x.form());
    return end_point([x](precision p) { return -x.at(p); });
  }

  /// 1 for infinity, -1 for -infinity, else 0.
  [[nodiscard]] int infinite_sign() const { return known_->infinite_sign; }
  [[nodiscard]] bool is_infinite() const { return infinite_sign() != 0; }
  /// The rational number that it is known to be.
  [[nodiscard]] const std::optional<rational>& exact() const { return known_->exact; }
  /// The number q + r pi that it is known to be.
  [[nodiscard]] const std::optional<pi_combination>& form() const { return known_->form; }
  /// How it was given, where it was given so and has no form; else empty.
  [[nodiscard]] const std::shared_ptr<const number_definition>& definition() const {
    return known_->definition;
  }
  /// An enclosure with p bits; undefined for an infinity.
  [[nodiscard]] ball at(precision p) const {
    if (is_infinite()) return ball::undefined(p);
    return form() ? form()->at(p) : known_->at(p);
  }
  /// They are the same point for certain: equal exact numbers, the same infinity, or copies of one
  /// end point.
  [[nodiscard]] bool is_same_as(const end_point& other) const {
    if (is_infinite() || other.is_infinite()) return infinite_sign() == other.infinite_sign();
    if (form() && other.form()) return *form() == *other.form();
    return known_ == other.known_;
  }

 private:
  struct infinite {};
  end_point(int sign, infinite /*unused*/) {
    knowledge known;
    known.infinite_sign = sign;
    known_ = std::make_shared<const knowledge>(std::move(known));
  }

  struct knowledge {
    std::optional<rational> exact;
    std::optional<pi_combination> form;
    std::function<ball(precision)> at;  // where it has no form, and is finite
    std::shared_ptr<const number_definition> definition;
    int infinite_sign = 0;
  };
  std::shared_ptr<const knowledge> known_;  // shared by copies, which are made often
};

// What they were called in version 0.1.
using limit [[deprecated("it is called end_point")]] = end_point;
using range_end [[deprecated("it is called end_point")]] = end_point;

}  // namespace polhode
