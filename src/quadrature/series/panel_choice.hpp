#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "taylor_panel.hpp"

namespace polhode::detail {

/// A root of one of the factors, to search with.
struct approximate_root {
  std::complex<double> at;
  double exponent = 0;
};

/// The panels that cover a range, chosen in doubles.
class panel_choice {
 public:
  panel_choice(const smooth_range& range, double bits)
      : range_(range), bits_(bits), ratio_(bits < 600 ? 0.58 : 0.5) {}

  /// The roots; false where they are not found.
  bool prepare();
  /// Nothing where the range is not understood.
  std::optional<std::vector<taylor_panel>> panels();

  /// About log2 of the greatest contribution of a panel.
  [[nodiscard]] double log2_of_size(const std::vector<taylor_panel>& panels) const;
  /// About log2 |P h|.
  [[nodiscard]] double log2_at(double y) const;

 private:
  struct end {
    rational at;
    bool is_singular = false;
  };

  [[nodiscard]] bool is_singular_at(const rational& y) const;
  /// The range is singular at y, and integrable there.
  [[nodiscard]] bool is_integrable_at(const rational& y) const;
  /// Where panels begin: at the range's end or, if that is not exact, a little before it, or at the
  /// singular point before it that a series begins at and reaches it from.
  [[nodiscard]] end lower_end(double low, double length) const;
  [[nodiscard]] end upper_end(double high, double length) const;

  /// From y to the next root, but for those at the given place.
  [[nodiscard]] double distance(double y,
                                const std::optional<rational>& except = std::nullopt) const;
  /// The root is taken for the exact number.
  [[nodiscard]] static bool is_at(const approximate_root& root, const rational& y);

  /// log of |h| up to a constant, at a complex y, without the roots at a place.
  [[nodiscard]] double log_size(std::complex<double> y,
                                const std::optional<rational>& except) const;
  /// log2 of how much |g| varies on a panel's circle and on the panel.
  [[nodiscard]] double spread(double c, double r, const std::optional<rational>& except) const;
  [[nodiscard]] double most_spread() const { return std::max(20.0, bits_ / 4); }

  /// Of a panel that begins at a singular end.
  [[nodiscard]] double length_at(const rational& y, int direction, const rational& all) const;

  /// A number of few bits near r.
  [[nodiscard]] static rational rounded(double r);

  /// Panels from one point to the other, neither of which is singular.
  bool cover(rational from, const rational& to, std::vector<taylor_panel>& panels) const;

  const smooth_range& range_;
  double bits_;
  double ratio_;
  std::vector<approximate_root> roots_;
  std::vector<double> exponent_;
  std::vector<double> phase_;
  std::vector<double> numerator_;
  double log_of_constant_ = 0;
};
}  // namespace polhode::detail
