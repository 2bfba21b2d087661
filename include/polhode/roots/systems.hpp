#pragma once

// All roots of n equations in n variables in a box, each proved to exist and to be the only one
// near it.
//
//   const auto f = [](const auto& x) { return std::vector{square(x[0]) + x[1] - 11, x[0] +
//   square(x[1]) - 7}; }; system_root_set s = solve_system(f, {{-5, 5}, {-5, 5}});
//
// f is a generic function of a std::vector. It is called once, with symbols, and becomes a formula
// for each component (formula_of.hpp).
//
// How: branch and prune. A box is discarded where a component of f, or of the mean value form f(m)
// + J(X) (X - m), does not hold 0, or where the preconditioned interval Newton method in
// Gauss-Seidel form (E. Hansen, S. Sengupta, 1981) leaves nothing of it. It has exactly one root
// where Krawczyk's operator maps it into its interior. What is left is halved. The proof is tried
// on a wider box, which is then taken out, so that a root on a face of boxes is found once. The
// result is made only where the boxes, settled and open, are proved to be the whole box, each part
// once; otherwise std::logic_error is thrown: a fault of the library.
//
// Krawczyk's operator proves no multiple roots. Those of polynomials with rational coefficients are
// proved by elimination: the coordinates of a root are roots of polynomials of one variable each,
// and whether the equations, and the determinant of their derivatives, are 0 at such a point is
// decided exactly. Where an equation is v = g for a variable v and a formula g without it, and the
// search leaves something open, g takes the place of v in the other equations
// (src/roots/by_substitution.hpp): two equations are then one in one variable.

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/verdict.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/formula_of.hpp"
#include "polhode/roots/isolate.hpp"
#include "polhode/roots/newton.hpp"

namespace polhode {

namespace detail {
class common_zeros;
}

/// The sides of a box, one for each variable: from a lower to an upper end, infinite where there is
/// none.
using system_side = std::pair<std::optional<rational>, std::optional<rational>>;
using system_box = std::vector<system_side>;

/// n functions of n variables.
class real_system {
 public:
  /// Of formulas in the same variables, one for each component. Throws input_error where there are
  /// not as many of them as variables.
  explicit real_system(const std::vector<expression>& given);
  /// Of a generic function of a std::vector, through the formulas of its components (formulas_of).
  template <class F>
  real_system(const F& f, std::size_t variables) : real_system(formulas_of(f, variables)) {}

  [[nodiscard]] std::vector<ball> operator()(const std::vector<ball>& x) const { return value_(x); }
  /// Row i, column j: an enclosure of the derivative of f_i by x_j over the box. The values of f
  /// over the box come with it.
  struct linearised {
    std::vector<ball> value;
    std::vector<std::vector<ball>> jacobian;
  };
  [[nodiscard]] linearised linearise(const std::vector<ball>& x) const;
  [[nodiscard]] const std::vector<expression>& components() const { return components_; }

 private:
  std::vector<expression> components_;
  std::function<std::vector<ball>(const std::vector<ball>&)> value_;
  std::function<std::vector<jet<ball, 1>>(const std::vector<jet<ball, 1>>&)> slope_;
};

/// One step of Krawczyk's method: K(X) = m - Y f(m) + (I - Y J(X)) (X - m), m the middle of X and Y
/// near the inverse of the middle of J(X).
///
/// Theorem (R. Krawczyk, 1969; R. E. Moore, SIAM J. Numer. Anal. 14 (1977); A. Neumaier, Interval
/// Methods for Systems of Equations, 1990, Thm 5.1.8). Let f be continuously differentiable on X
/// with its derivatives in J(X). (1) Every root of f in X lies in K(X). (2) If K(X) lies in the
/// interior of X, f has exactly one root in X, and J there is regular. Proof. For x in X, f(x) -
/// f(m) = A (x - m) with a matrix A in J(X), row by row by the mean value theorem, so that x - Y
/// f(x) = m - Y f(m) + (I - Y A)(x - m) lies in K(X): hence (1). (2) The width of K(X) is at least
/// that of (I - Y A)(X - m), which is |I - Y A| times that of X; it is less than that of X, so |I -
/// Y A| w < w for the positive vector w of widths. So the spectral radius of I - Y A is below 1,
/// and Y and every such A are regular. By Brouwer x - Y f(x) has a fixed point in X, a root since Y
/// is regular; for two roots A (x - x') = 0 with such an A, so they are equal.
struct krawczyk_step {
  std::vector<ball> image;  // undefined where f or J is, or Y was not found
  std::vector<std::vector<ball>> jacobian;
  std::vector<ball> value_at_middle;
  std::vector<std::vector<ball>> preconditioner;  // Y, of points
};
[[nodiscard]] krawczyk_step krawczyk(const real_system& f, const std::vector<ball>& x, precision p);

/// What is known of the roots in one part of the box: unique, multiple, at_least_one or unresolved.
struct system_region {
  root_verdict verdict = root_verdict::unresolved;
  std::vector<ball> box;        // what the verdict is about
  std::vector<ball> enclosure;  // holds every root in the box
  bool may_lie_outside =
      false;           // it is not decided on which side of the given box's faces the root lies
  std::string remark;  // why it is not resolved
  /// Where the root was found otherwise than by Krawczyk's method: encloses it with about p bits.
  std::function<std::vector<ball>(precision p)> enclose = {};
};

struct system_root_set {
  /// In ascending order of the first component, then the second, ...
  std::vector<system_region> regions;
  bool complete = true;  // no limit was reached, or what it left was solved by elimination
  isolation_account account;

  [[nodiscard]] bool is_resolved() const;
};

struct system_options {
  long most_boxes = 2'000'000;
  /// Boxes narrower in every direction than 2^-most_halvings of the given side, or of their own
  /// distance from 0 and of 1 where that is infinite, are left unresolved.
  int most_halvings = 60;
  /// Where more boxes than this are left unresolved, there seem to be infinitely many roots, and
  /// the search ends.
  std::size_t most_unresolved = 5'000;
  std::function<bool(const isolation_progress&)> progress = {};
};

/// A search that can be stopped and resumed, as root_search.
class system_search {
 public:
  /// Throws input_error where a side is the wrong way round, where
  /// there are none, or where f has not as many components as there are variables.
  system_search(real_system f, system_box box);

  /// Of a generic function of a std::vector.
  template <class F>
  requires(!std::same_as<F, real_system>) system_search(const F& f, const system_box& box)
      : system_search(real_system(f, box.size()), box) {}

  void run(const system_options& options = {});
  [[nodiscard]] bool is_finished() const { return pending_.empty(); }
  [[nodiscard]] system_root_set result() const;

 private:
  friend class system_searcher;
  [[nodiscard]] std::optional<std::vector<system_region>> regions_of(
      detail::common_zeros& zeros, const std::vector<ball>& box) const;
  struct waiting {
    std::vector<ball> x;
    int halvings = 0;
  };
  real_system f_;
  system_box range_;
  std::vector<waiting> pending_;
  std::vector<waiting> stuck_;
  rational settled_ = 0;  // the share of the box that is settled
  std::vector<system_region> found_;
  std::string limit_;  // that the last run met
  isolation_account account_;
};

/// The roots of f in the box, faces included.
[[nodiscard]] system_root_set solve_system(const real_system& f, const system_box& box,
                                           const system_options& options = {});

/// The same of a generic function of a std::vector.
template <class F>
[[nodiscard]] system_root_set solve_system(const F& f, const system_box& box,
                                           const system_options& options = {}) {
  return solve_system(real_system(f, box.size()), box, options);
}

struct refined_system_root {
  std::vector<ball> enclosure;
  /// Certified where each radius is at most 10^-digits of its component, or of the box where that
  /// may be 0.
  status verdict = status::not_certified;
  int evaluations_of_f = 0;
  int evaluations_of_jacobian = 0;
};

/// The root of a region with one root to `digits` digits: by its `enclose`, where it has that, or
/// by Krawczyk's method, with f(m) at the precision of each step and the Jacobian and its inverse
/// at half of it; the precision doubles from step to step.
[[nodiscard]] refined_system_root refine(const real_system& f, const system_region& region,
                                         long digits);
/// The same of a generic function of a std::vector.
template <class F>
[[nodiscard]] refined_system_root refine(const F& f, const system_region& region, long digits) {
  return refine(real_system(f, region.box.size()), region, digits);
}

}  // namespace polhode
