#pragma once

// The rules of quadrature: what one is, and the list of all.
//
// A rule is an object. What every rule can do is to attempt an integral (quadrature_strategy). Most
// rules serve on panels: around a panel f is proved analytic in an ellipse and bounded there, and
// such a rule says how many nodes it takes, where they are, and what it leaves out (panel_rule);
// the planner and the sums are common to all of them.
//
// A new rule on panels is one class with a file of its own in src/quadrature/rules, and one line in
// list.cpp there; the names on the command line, its help, reports and second opinions follow from
// the list. A rule of a program's own needs no line:
//
//   const my_rule rule;
//   integrate(f, 0, 1, {.rule = rule});

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "polhode/arithmetic/ball.hpp"

namespace polhode {

class end_point;
struct integral;
struct integrate_options;
struct symmetric_nodes;
namespace detail {
struct integrand;
}  // namespace detail

/// A way to an integral, with its proof.
class quadrature_strategy {
 public:
  virtual ~quadrature_strategy() = default;
  quadrature_strategy() = default;
  quadrature_strategy(const quadrature_strategy&) = delete;
  quadrature_strategy& operator=(const quadrature_strategy&) = delete;

  /// As reports have it: "Gauss-Legendre". Lower case with hyphens for spaces it is its name on the
  /// command line.
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// What it is for, as `--help` says it.
  [[nodiscard]] virtual std::string_view purpose() const = 0;
  /// `integrate` tries it without being asked to.
  [[nodiscard]] virtual bool is_automatic() const { return false; }
  /// The integral over [a, b], a < b; -infinity and +infinity are limits too. Returns nullopt where
  /// the rule is not for this f. Whatever the verdict, the enclosure must hold the integral.
  [[nodiscard]] virtual std::optional<integral> attempt(const detail::integrand& f,
                                                        const end_point& a, const end_point& b,
                                                        const integrate_options& options) const = 0;
  /// What f would have to be, said where the rule was insisted on and is not for f.
  [[nodiscard]] virtual std::string_view need() const { return {}; }
};

/// A rule on panels. Nothing but truncation_error and nodes is believed; each must hold for every
/// argument.
class panel_rule : public quadrature_strategy {
 public:
  /// How many nodes make truncation_error about 2^log2_goal times 2, for an F with |F| <=
  /// 2^log2_supremum inside the Bernstein ellipse with foci -1 and 1 and parameter rho > 1. An
  /// estimate, to search with.
  [[nodiscard]] virtual long nodes_for(double rho, double log2_supremum,
                                       double log2_goal) const = 0;
  /// A bound of |sum of w_k F(x_k) - the integral of F over [-1, 1]| for every F that is analytic
  /// inside the ellipse and at most the supremum there.
  [[nodiscard]] virtual magnitude truncation_error(long n, const ball& rho,
                                                   const magnitude& supremum) const = 0;
  /// The rule with n nodes, with at least p bits.
  [[nodiscard]] virtual std::shared_ptr<const symmetric_nodes> nodes(long n, precision p) const = 0;
  /// The ends of a panel are nodes.
  [[nodiscard]] virtual bool has_ends_as_nodes() const { return false; }

  /// On panels (integrate.hpp says how).
  [[nodiscard]] std::optional<integral> attempt(const detail::integrand& f, const end_point& a,
                                                const end_point& b,
                                                const integrate_options& options) const final;
};

/// A rule to choose, by name or by its object; `automatic` leaves the choice to `integrate`.
class quadrature_rule {
 public:
  /// An antiderivative or a series where there is one, otherwise Gauss-Legendre or trapezoid on
  /// panels.
  static const quadrature_rule automatic;
  /// Of sums of products of powers of x, exponentials, sines and cosines of linear forms.
  static const quadrature_rule antiderivative;
  /// Of sines and cosines of polynomials times rational functions and powers of x.
  static const quadrature_rule turned_rays;
  static const quadrature_rule gauss_legendre;   // on panels
  static const quadrature_rule clenshaw_curtis;  // on panels
  static const quadrature_rule
      trapezoid;  // of functions that are periodic, or even about both limits
  static const quadrature_rule double_exponential;  // over a finite range with rational limits
  /// Of sums of functions whose logarithmic derivative is rational, or is so in e^(k x) or sin^2 (k
  /// x).
  static const quadrature_rule taylor_series;

  /// The rule must live as long as what it is given to.
  quadrature_rule(
      const quadrature_strategy& s)  // NOLINT(google-explicit-constructor): the same rule
      : own_(&s) {}

  /// All but `automatic`, in the order in which `integrate` tries those that are.
  [[nodiscard]] static std::span<const quadrature_rule> all();
  /// That of all, or automatic, whose word it is.
  [[nodiscard]] static std::optional<quadrature_rule> named(std::string_view word);

  [[nodiscard]] bool is_automatic() const { return strategy() == nullptr; }
  /// None for `automatic`.
  [[nodiscard]] const quadrature_strategy* strategy() const {
    return listed_ != nullptr ? &listed_() : own_;
  }
  /// "Gauss-Legendre".
  [[nodiscard]] std::string name() const;
  /// "gauss-legendre".
  [[nodiscard]] std::string word() const;

  friend bool operator==(const quadrature_rule& x, const quadrature_rule& y) {
    return x.strategy() == y.strategy();
  }

 private:
  using maker = const quadrature_strategy& (*)();
  constexpr explicit quadrature_rule(maker listed) : listed_(listed) {}

  maker listed_ = nullptr;
  const quadrature_strategy* own_ = nullptr;
};

/// Its name.
[[nodiscard]] std::string to_text(const quadrature_rule& rule);

}  // namespace polhode
