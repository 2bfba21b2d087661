#pragma once

// The integral of P h over one panel, and what it is off by.

#include <optional>
#include <vector>

#include "local_polynomial.hpp"
#include "polhode/arithmetic/double_interval.hpp"
#include "taylor_panel.hpp"
#include "taylor_terms.hpp"

namespace polhode::detail {

/// The integral over a panel, or over the part of it that is in the range, and which part that was.
struct panel_value {
  ball value;
  piece_done done;
};

/// The integral of P h over one panel.
class panel_integral {
 public:
  panel_integral(const smooth_range& range, const taylor_panel& panel)
      : range_(range), panel_(panel) {}

  /// To about 2^log2_goal. Returns nullopt where the theorem's hypotheses are not proved, or where
  /// it takes more bits or terms than allowed.
  std::optional<panel_value> to(double log2_goal, precision most_bits, long most_terms);
  /// The same in units of 2^-f, with a result of p bits.
  std::optional<panel_value> in_units(long f, precision p, long most_terms);

  [[nodiscard]] long terms() const { return terms_; }
  [[nodiscard]] long bits() const { return bits_; }

 private:
  struct local_factor {
    local_polynomial p;
    rational exponent;
  };

  bool prepare();
  /// p(c + r z), where p has rational coefficients; the content is positive.
  [[nodiscard]] local_polynomial local(const rational_polynomial& p) const;
  /// Bounds of log g, and of log(Q/q_0) from below.
  bool prepare_bounds();
  /// Q and S, with integer coefficients without a common factor.
  void prepare_recurrence();
  /// Adds p' to the quotient of S's part by Q.
  void add_derivative(const local_polynomial& p, integers& part);
  /// |r| times the factors at z = 0, that of P among them, with p bits.
  [[nodiscard]] ball constant(precision p) const;
  /// The integral of |z|^p over the panel.
  [[nodiscard]] ball length_factor() const;
  /// z of the range's end.
  [[nodiscard]] ball coordinate(const end_point& end, precision p) const;
  /// Where the panel is cut off, in z.
  struct cut_ends {
    std::optional<ball> low;
    std::optional<ball> high;
    [[nodiscard]] bool is_cut() const { return low || high; }
  };
  [[nodiscard]] cut_ends cut_ends_in_z(precision bits) const;
  /// The sums at these ends, in units of 2^-f; false where an end is not proved to be in the panel.
  [[nodiscard]] bool add_cut_ends(const cut_ends& cut, long f, series_part& own) const;
  /// What the a_n are off by makes the integral of g so much wrong, in size: that of A for g,
  /// integrated, with N, or sqrt(2) N < 3/2 N, of the theorem.
  [[nodiscard]] magnitude error_of_coefficients(long count_of_divisions, std::size_t parts,
                                                long f) const;
  /// The integral of one part of the series, but for what the a_n are off by.
  [[nodiscard]] ball integral_of(const series_part& own, const cut_ends& ends, long f,
                                 precision p) const;
  std::optional<ball> sum(long f, precision p, long most_terms);

  const smooth_range& range_;
  const taylor_panel& panel_;
  bool is_prepared_ = false;
  std::vector<local_factor> factors_;
  local_polynomial numerator_;
  local_polynomial exponent_;
  local_polynomial phase_;
  rational power_ = 0;  // p
  ball maximum_;        // of |P|, an upper bound
  double_interval log_least_;
  double_interval log_greatest_;
  double_interval log_least_q_;
  integers q_;
  integers s_;
  integers t_;  // the imaginary part of S
  long terms_ = 0;
  long bits_ = 0;
};

}  // namespace polhode::detail
