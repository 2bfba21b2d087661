#pragma once

// What a search for roots knows: the boxes that are left, the roots and the singular places that
// were found, and the pieces of the interval that are settled.

#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/roots/isolate.hpp"
#include "roots/settled_pieces.hpp"

namespace polhode {
namespace detail {

using exact_box = exact_interval;

constexpr precision first_bits = 64;

/// What counts, at most, as the halvings of a box beside one with an exact zero, or beside a root
/// that was found.
constexpr int halvings_beside_zero = 64;

struct outcome;

/// Where a box seems to have a point at which f is not defined or not bounded.
enum class singular_point : std::uint8_t { none, at_lower_end, at_upper_end, inside };

struct work_box {
  exact_box x;
  int halvings = 0;
  precision bits = first_bits;
  std::size_t problem = 0;
  std::string remark;  // why it is left unresolved
  /// It is not halved where f is not defined on the whole of it, or not bounded.
  bool is_left_whole = false;
  /// A guess, which decides on the order of the search and on where it ends.
  singular_point singular = singular_point::none;
  /// The other part of the box that it was halved from is singular.
  bool is_beside_singular = false;
  /// It is the rest of the interval on the way to an end, or a singular point, with many roots.
  bool is_open_end = false;
  /// It is proved to hold infinitely many roots.
  bool has_endless_roots = false;
  /// What its examination gives, where it was examined before its turn.
  std::shared_ptr<outcome> ahead = nullptr;
};

/// What the examination of a box gives, of pieces that make up the box. It depends on the box and
/// the options alone.
struct outcome {
  struct without_root {
    exact_box x;
    ball over;  // has no root in this set
  };
  /// All roots in `done`, which holds the box, are known: the region's, or none where there is no
  /// region.
  struct known_part {
    exact_box done;
    ball over;  // what the proof is about: the region's box
    std::optional<root_region> region;
  };
  std::vector<work_box> rest;  // left to do, in the order of a stack
  std::vector<work_box> stuck;
  std::vector<without_root> excluded;
  std::optional<known_part> known;
  std::vector<singular_place> singular;
  long evaluations = 0;
  precision most_bits = 0;
  std::exception_ptr error;  // what f threw
};

/// Proves that the outcome is about the whole box: the pieces make it up, and what was proved was
/// proved over them.
void expect_whole(const exact_box& box, const outcome& o);

/// A function whose roots are looked for: f, or a factor of the polynomial f with simple roots
/// only.
struct root_problem {
  std::shared_ptr<const real_function> g;
  long multiplicity = 1;  // of its roots, as roots of f
  bool is_factor = false;
  /// The roots of the factor are no roots of f, which is not defined there: poles of this order,
  /// or 0.
  std::optional<long> pole_order = std::nullopt;
};

struct found_root {
  root_region region;
  std::size_t problem = 0;
  double_interval about;  // holds the region's box
};

}  // namespace detail

struct root_search::state {
  std::shared_ptr<const real_function> f;
  end_point lower = 0;
  end_point upper = 0;
  std::vector<detail::root_problem> problems;
  std::vector<detail::settled_pieces> settled;  // of each problem
  std::vector<detail::work_box> pending;        // a stack, the leftmost box on top
  std::vector<detail::work_box> stuck;
  std::vector<detail::found_root> found;
  /// None of these lies beyond it.
  double end_of_found = -std::numeric_limits<double>::infinity();
  std::vector<singular_place> singular;
  bool identically_zero = false;
  bool concluded = false;
  /// A rest of the interval up to an end, or around a singular point, was left, after many roots,
  /// and is not proved to hold infinitely many.
  bool has_open_end = false;
  std::string limit;  // the one that ended the last run
  isolation_account account;
};

namespace detail {

/// Proves that the interval that was asked for, from end to end, is in the one that is searched,
/// and that every point of it is settled or open: for every problem.
void expect_whole(const root_search::state& s);

}  // namespace detail
}  // namespace polhode
