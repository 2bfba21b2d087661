#pragma once

// A function near an end as a sum of oscillations, with its constants to as many bits as are asked
// for: what oscillation.hpp needs of waves.hpp.

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "quadrature/ends/waves.hpp"
#include "quadrature/formula/recorded.hpp"
#include "quadrature/integrand.hpp"

namespace polhode::detail::oscillations {

/// One frequency, or none, with the constants to some precision.
struct oscillation {
  ball frequency;
  program_of_parts amplitude;
};

/// f taken apart; safe to be used by several threads.
class decomposition {
 public:
  /// f between x = p + s and p, or an infinity. The power theta of y is found: x = p + s y^theta.
  decomposition(const integrand& f, const end_point& p, const end_point& s, bool infinite,
                int sign);

  /// It is a sum of oscillations, with frequencies that are certainly not 0.
  [[nodiscard]] bool is_found() const { return found_; }
  [[nodiscard]] const rational& theta() const { return theta_; }
  [[nodiscard]] bool has_steady_part() const { return steady_; }
  /// Of positive frequencies.
  [[nodiscard]] std::size_t count() const { return frequencies_.size(); }
  /// Number k; or, for k = count(), the steady part.
  [[nodiscard]] std::shared_ptr<const oscillation> at(std::size_t k, precision p) const;

 private:
  void choose(const std::map<frequency, amplitude>& terms, const recorded& y);
  [[nodiscard]] std::vector<std::shared_ptr<const oscillation>> make(precision p) const;

  formula f_;
  end_point p_;
  end_point s_;
  int sign_;
  rational theta_;
  bool found_ = false;
  bool steady_ = false;
  std::vector<frequency> frequencies_;
  mutable std::mutex mutex_;
  mutable std::map<precision, std::vector<std::shared_ptr<const oscillation>>> made_;
};

}  // namespace polhode::detail::oscillations
