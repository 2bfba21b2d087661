#pragma once

// The range of a function with breaks, covered by intervals on which its branches are known.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "quadrature/formula/integrand.hpp"
#include "quadrature/pieces/branches.hpp"

namespace polhode::detail::breaks {

/// A part of the range: with one set of branches; or with a break in it, and the branches before
/// and beyond it; or so short that it is left out; or unresolved.
struct stretch {
  enum class form : std::uint8_t { plain, broken, short_one, unresolved };
  interval x;
  form what = form::plain;
  choices before;
  choices beyond;
  std::optional<crossing> crosses;
};

/// f is g's graph, and `whole` holds the range from a to b.
class covering {
 public:
  covering(const formula_graph& f, const integrand& g, const end_point& a, const end_point& b,
           const interval& whole, long bits);

  /// In order; none where that took too much effort.
  [[nodiscard]] const std::vector<stretch>& stretches() const { return stretches_; }
  [[nodiscard]] bool has_branches() const;

 private:
  void cover();
  /// The interval with its branches, with a break and what is beside it, or left as it is; nothing
  /// where it is to be cut first.
  [[nodiscard]] std::optional<stretch> resolved(const interval& x, const traced& t);
  /// No branch changes at m: series beside it would tell no more than narrower intervals do.
  [[nodiscard]] bool is_away_from_changes(const ball& m);
  /// At a simple rational number in x, at which a decider may be 0 without a simple crossing: what
  /// is on its two sides, by series; none where they do not tell.
  [[nodiscard]] std::vector<stretch> beside_a_rational(const interval& x);
  /// The same at a multiple of pi, where the branches are one set on both of its sides.
  [[nodiscard]] std::optional<stretch> around_a_multiple_of_pi(const interval& x);
  /// x touches an irrational end of the range, at which a decider may be 0: what is between that
  /// end and x's other one. The part of x beyond the end is outside the range.
  [[nodiscard]] std::optional<stretch> up_to_an_end(const interval& x);
  void split(const interval& x, const traced& t, std::vector<interval>& open) const;
  traced traced_over(const interval& x, const crossing* given, int side);

  const formula_graph& f_;
  const integrand& g_;
  interval whole_;
  std::array<std::optional<end_point>, 2> ends_;  // where irrational and known exactly
  std::int64_t least_log2_width_;
  double effort_ = 0;  // in evaluations of a node with few bits
  double most_effort_;
  long breaks_ = 0;
  long asked_ = 0;  // for what is beside a rational number
  long tries_ = 0;  // with series
  std::vector<stretch> stretches_;
};

}  // namespace polhode::detail::breaks
