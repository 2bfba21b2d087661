#pragma once

// Policies of Boost.Math's at the door of this library: what happens where an answer is not proved,
// and how many digits are wanted.

#include <limits>
#include <string>
#include <type_traits>

#include <boost/math/policies/error_handling.hpp>
#include <boost/math/policies/policy.hpp>

#include "polhode/real/number.hpp"

namespace polhode {

/// In place of a policy: what is not proved says so in the answer, by its verdict; input that
/// cannot be used throws input_error.
struct answer_by_verdict {};

namespace detail {

template <class Policy>
inline constexpr bool is_policy = boost::math::policies::is_policy<Policy>::value;

/// The decimal digits that the policy asks for (digits10<N>, digits2<N>), or those of R with so
/// many bits.
template <floating_real R, class Policy>
[[nodiscard]] long digits_wanted(precision p) {
  const long all = digits_in_bits(p);
  if constexpr (is_policy<Policy>) {
    using wanted = typename Policy::precision_type;
    if constexpr (wanted::value > 0) {
      return std::min(all, digits_in_bits(static_cast<precision>(wanted::value) + 3));
    }
  }
  return all;
}

/// What the policy makes of an answer that is not proved: an exception
/// (boost::math::evaluation_error), errno, or nothing more. Returns the value to answer with.
template <floating_real R, class Policy>
R not_proved(const char* function, const std::string& why, const R& value, const Policy& policy) {
  if constexpr (is_policy<Policy>) {
    // Boost formats with %1% for the value.
    std::string message;
    for (const char c : why) message += c == '%' ? std::string("%%") : std::string(1, c);
    message += " (reached: %1%)";
    return boost::math::policies::raise_evaluation_error(function, message.c_str(), value, policy);
  } else {
    static_cast<void>(policy);
    return value;
  }
}

/// The same of input that cannot be used: boost::math's domain error (std::domain_error), errno, or
/// a NaN; without a policy, input_error.
template <floating_real R, class Policy>
R bad_input(const char* function, const input_error& error, const Policy& policy) {
  if constexpr (is_policy<Policy>) {
    std::string message;
    for (const char* c = error.what(); *c != 0; ++c) {
      message += *c == '%' ? std::string("%%") : std::string(1, *c);
    }
    return boost::math::policies::raise_domain_error(function, message.c_str(),
                                                     std::numeric_limits<R>::quiet_NaN(), policy);
  } else {
    throw error;
  }
}

}  // namespace detail

}  // namespace polhode
