#pragma once

// One integral by many routes. Whatever route encloses it, its enclosure must meet those of all
// others.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "maker.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "tally.hpp"
#include "term.hpp"

namespace polhode::differential {

/// factor times the integral of a formula in x, as `polhode integrate` computes it.
struct piece {
  term integrand = 0;
  term from = 0;
  term to = 0;
  long digits = 15;
  quadrature_rule rule = quadrature_rule::automatic;
  term factor = 1;
  long most_evaluations = 4'000;
};

/// The command that computes a piece, without its factor.
[[nodiscard]] std::string command_of(const piece& p);
/// What the command computes, with so many evaluations at most. What cannot be read as a formula or
/// a limit is not certified, not_defined.
[[nodiscard]] integral computed(const piece& p);

/// An integral and what is known of it.
struct integral_case {
  term integrand = 0;
  term from = 0;
  term to = 0;
  long digits = 15;
  /// F with F' = integrand: the integral is F(to) - F(from).
  std::optional<term> antiderivative = std::nullopt;
  /// The integral as a formula without variables.
  std::optional<term> value = std::nullopt;
  /// Integrals whose sum it is.
  std::vector<piece> parts = {};
  /// There is no such integral: nothing may be certified.
  bool diverges = false;
  /// Each route gets few evaluations, and the other number of digits is small, too.
  bool is_cheap = false;
};

struct integral_family {
  std::string name;
  long at_effort_one;
  std::function<integral_case(maker&)> make;
};

/// The same cases, but nine of ten with few digits and evaluations: integrals that take long become
/// many that do not.
[[nodiscard]] std::function<integral_case(maker&)> mostly_cheap(
    std::function<integral_case(maker&)> make);

[[nodiscard]] std::vector<integral_family> steep_families();
[[nodiscard]] std::vector<integral_family> end_families();
[[nodiscard]] std::vector<integral_family> shape_families();
[[nodiscard]] std::vector<integral_family> known_families();
[[nodiscard]] std::vector<integral_family> oscillation_families();

/// Computes the case by the first route and some others, and holds their enclosures against each
/// other. Reports, as a failure of the running test, a contradiction: shrunk, with its commands.
void examine(const integral_case& given, std::uint64_t seed, counts& c);

/// The same by every route.
void examine_thoroughly(const integral_case& given, std::uint64_t seed, counts& c);

}  // namespace polhode::differential
