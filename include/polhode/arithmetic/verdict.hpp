#pragma once

#include <string>

#include "polhode/language.hpp"

namespace polhode {

/// Whether what was asked is proved. Anything short of a proof is not_certified.
enum class status { certified, not_certified };

/// Why something is not certified.
enum class reason {
  none,              // it is certified
  precision_limit,   // the enclosure is as narrow as the allowed precision makes it, and too wide
  evaluation_limit,  // the work needed exceeds the limit that was given
  not_analytic,      // no region was found in which the integrand is proved analytic
  not_integrable,    // the integral was proved to diverge
  not_convergent,    // an iteration did not contract
  not_applicable,    // the method that was insisted on is not for this
  not_defined,       // the function is not defined on what it was asked for
  refuted            // the contrary is proved
};

[[nodiscard]] std::string to_text(status s);
[[nodiscard]] std::string to_text(reason r);

}  // namespace polhode
