#pragma once

// All roots of a function of one variable in an interval, each proved to exist and to be the only
// one in its box, or said not to be.
//
//   root_set s = isolate_roots([](const auto& x) { return cos(x) - x; }, 0, 1);
//   refined_root r = refine(s.regions[0], 100);       // a hundred digits
//
// Outside the regions of the answer f has no root in the interval: they cover what could not be
// excluded, without gaps. A region says what is proved of it (root_verdict, newton.hpp).
//
// A quotient of polynomials with rational coefficients is searched exactly. Its numerator is made
// free of multiple roots (Yun, 1976), the rational roots are found (Hensel lifting), and the others
// are told apart by Descartes' rule of signs and continued fractions (Vincent's theorem;
// src/roots/polynomial). Roots of divisors are poles, or places where it is not defined.
//
// For other functions the interval is cut into boxes. Over a box X with its middle m, f and f' are
// enclosed by evaluation and by Taylor's formula about m. A box whose range does not hold 0 has no
// root; one on which f' has one sign and which interval Newton maps into itself has exactly one.
// Where this fails the box is halved, with more bits where rounding is in the way. A root found is
// looked for in a box wider than its own, which is then taken out of the others, so that a root at
// a common end is found once. What halving cannot decide is asked of the function's structure
// (function_structure.hpp):
//   a factor g^m, g with one simple root in the box and the other factors without one: multiplicity
//   m; f, f', ..., f^(m-1) exactly 0 at a rational point and f^(m) not 0 over the box: that point,
//   m times, and by
//     Rolle's theorem no other;
//   f exactly 0 at a rational point c, and |f(c +- t)| >= k t^a with k > 0 on either side
//   (zero_free_ends.hpp), or f not defined there: c, and no other; c may be a kink or a branch
//   point;
//   a factor sqrt(g), |g| or g^c with c > 0, g with one simple root in the box and the rest defined
//   there: that root, without a multiplicity;
//   f certainly not 0 at a point, or not defined, and so on either side: no root;
//   no factor of the numerator vanishes: no root, but a pole where the denominator does;
//   towards infinity, |f(x)| >= k |x|^a with k > 0 from some x on (zero_free_ends.hpp): no root.
// An unbounded interval is searched outward, in parts whose lengths double, and one with an end at
// which f is not defined towards that end. Where the roots do not end, the rest is one region,
// which is proved to hold infinitely many where f changes its sign again and again (docs/roots.md).
// What an examination of a box has proved, it says of pieces, and the search proves in exact
// arithmetic that the pieces make up the box; the result is made only where all pieces, settled and
// open, are proved to make up the interval, each point once. Otherwise std::logic_error is thrown:
// a fault of the library. A multiple root that none of these proves stays unresolved, however many
// bits are spent; the number of complex roots near it, which Rouche's theorem gives, is reported
// with it.

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/roots/newton.hpp"
#include "polhode/roots/real_function.hpp"

namespace polhode {

/// What is known of the roots in one part of the interval.
struct root_region {
  root_verdict verdict = root_verdict::unresolved;
  ball box;        // what the verdict is about; unbounded towards infinity
  ball enclosure;  // holds every root of f in the box
  /// Of the root, where the verdict is unique (then 1) or multiple; else 0. An isolated root has
  /// none.
  long multiplicity = 0;
  /// The root, where it is known to be this rational number.
  std::optional<rational> exact;
  /// The complex roots of f in a disc around the box, counted with their multiplicities, where
  /// proved.
  std::optional<long> complex_roots;
  /// It is not decided on which side of an end of the interval the root lies.
  bool may_lie_outside = false;
  /// Why it is not resolved, in words: what f meets in the box, or which limit was reached.
  std::string remark;
  std::shared_ptr<const real_function> function;  // f
  /// A function with the same root, there simple: f itself, or the factor of f that vanishes.
  std::shared_ptr<const real_function> simple;
};

/// A place where f is not defined, and is proved to have no root.
struct singular_place {
  ball place;
  /// The order of the one pole in the place; 0 where f is not defined on the whole of the place.
  long pole_order = 0;
};

struct isolation_account {
  long evaluations = 0;  // of f, over boxes and at points, in all arithmetics
  long boxes = 0;
  precision most_bits = 0;
};

/// What was searched in place of an unbounded interval: one period of the roots of f, in it.
struct searched_period {
  pi_combination period;
  end_point lower;
  end_point upper;  // lower + period
};

/// f is 0 between the ends, wherever it is defined there.
struct zero_interval {
  end_point lower;
  end_point upper;
  /// f is 0 at that end, too.
  bool has_lower = false;
  bool has_upper = false;
};

struct root_set {
  /// In ascending order, with disjoint enclosures. None is in one of the intervals.
  std::vector<root_region> regions;
  /// In ascending order: of formulas that are 0 between points where abs, min, max, floor or ceil
  /// pass from one function to another, as max(x, 0).
  std::vector<zero_interval> zero_intervals;
  /// Where there is one (isolate_options::by_period), the regions and singular places are those of
  /// [lower, upper]. All others in the interval are these and a whole number of periods more: each
  /// root is one of infinitely many.
  std::optional<searched_period> of_period = std::nullopt;
  std::vector<singular_place> singular;
  /// f is 0 everywhere; there are no regions then.
  bool identically_zero = false;
  /// The whole interval was searched: no limit was reached. A part that is left where infinitely
  /// many roots are proved counts as searched.
  bool complete = true;
  isolation_account account;

  /// Every region has one root (is_one_root), or infinitely many, and none may lie outside.
  [[nodiscard]] bool is_resolved() const;
};

struct isolation_progress {
  long boxes_done = 0;
  long boxes_waiting = 0;
  long roots = 0;
  /// The fraction of the interval, as it was open when the run began, that is settled or given up;
  /// nothing where it is unbounded. To be shown.
  std::optional<double> share_done = std::nullopt;
};

struct isolate_options {
  /// Boxes that may be examined in one run.
  long most_boxes = 100'000;
  /// Boxes that may be left unresolved: more of them are a function that is 0 on an interval that
  /// is not recognised, or the like.
  long most_unresolved = 2'000;
  /// Towards an infinite end, or a point at which f is not defined, so many roots and singular
  /// places are found before the rest is left, as one region, unless f is proved to have no root
  /// from some point on. Its verdict is infinitely_many where that is proved, else unresolved.
  long most_towards_end = 100;
  /// The time that one run may take.
  std::optional<std::chrono::milliseconds> most_time = std::nullopt;
  /// How often a box may be halved before it is left unresolved; twelve times as often where f is
  /// exactly 0 at a short rational number in the box, beside which there may be roots at any scale.
  int most_halvings = 200;
  /// Bits that cancellation may raise the working precision to.
  precision most_precision = 1L << 14;
  /// On how many threads boxes are examined; 0 for as many as the machine has processors, which are
  /// the most. The result is the same bit for bit. Unless it is 1, several threads at a time call
  /// real_function::at; each calls what it made by itself.
  int threads = 1;
  /// Called every few boxes; false ends the run as a limit does.
  std::function<bool(const isolation_progress&)> progress = {};
  /// Of a periodic f over an unbounded interval, isolate_roots looks in one period, and says so by
  /// root_set::of_period. Who asks for it must look there: the regions are then not all roots.
  bool by_period = false;
};

/// A search that can be stopped and resumed: its state is a value.
///
///   root_search s(f, 0, 1);
///   s.run({.most_boxes = 1000});
///   root_set so_far = s.result();           // what was not examined is unresolved
///   if (!s.is_finished()) s.run({});
class root_search {
 public:
  /// Throws input_error where the interval is the wrong way round, or is one infinity.
  root_search(const real_function& f, const end_point& lower, const end_point& upper);

  void run(const isolate_options& options = {});
  [[nodiscard]] bool is_finished() const;
  [[nodiscard]] root_set result() const;

  struct state;

 private:
  std::shared_ptr<const state> state_;
};

/// The roots of f with lower <= x <= upper; with isolate_options::by_period, those of one period.
[[nodiscard]] root_set isolate_roots(const real_function& f, const end_point& lower,
                                     const end_point& upper, const isolate_options& options = {});

/// A root to many digits.
struct refined_root {
  ball enclosure;
  std::optional<rational> exact;
  /// Certified where the radius is at most 10^-digits of the root, or of the box where the root is
  /// 0.
  status verdict = status::not_certified;
  int evaluations_of_f = 0;
  int evaluations_of_derivative = 0;
};

/// The root of a region that is unique or multiple, to a radius of 10^-digits of its size (of the
/// box's where the root is so near 0 that it cannot be told from it), by interval Newton with
/// precision doubling: refine_root of newton.hpp. f is evaluated once with the full precision, and
/// f' once with half of it, and once more with the bits that cancellation costs where it does; a
/// multiple root is refined as the simple root of a factor of f. Of another region, the enclosure
/// as it is. Throws std::invalid_argument for digits < 1.
[[nodiscard]] refined_root refine(const root_region& region, long digits);
/// The same for each region, on several threads (isolate_options::threads).
[[nodiscard]] std::vector<refined_root> refine(const std::vector<root_region>& regions, long digits,
                                               int threads);

/// A point x in the box at which derivative(x) is certainly not f'(x); std::nullopt where none was
/// found at `points` equally spaced points. f' comes from jets; derivative is a function object
/// ball -> ball.
[[nodiscard]] std::optional<rational> refute_derivative(
    const real_function& f, const std::function<ball(const ball&)>& derivative,
    const rational& lower, const rational& upper, int points = 16);

}  // namespace polhode
