#include "sum_of_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "polhode/arithmetic/text.hpp"
#include "quadrature/base/approximate.hpp"

namespace polhode::detail {

namespace {

/// The sum; its enclosure is undefined where a part's is.
integral sum_of_parts(const std::vector<part>& parts, const integrate_options& options,
                      integral_account& account) {
  integral result;
  result.enclosure = ball(0, bits_for_digits(options.digits) + 64);
  for (const part& p : parts) {
    const integral found = integrate_function(p.f, p.lower, p.upper, options);
    account += found.account;
    result.enclosure += p.sign * found.enclosure;
    if (!result.enclosure.is_bounded()) break;
  }
  return result;
}

/// A rational number that is at least side * x, as near as its bits allow.
rational bound_beyond(const end_point& x, int side) {
  if (x.exact()) return side * *x.exact();
  const ball at = x.at(64);
  return side > 0 ? upper_rational(at) : rational(-lower_rational(at));
}

}  // namespace

std::optional<integral> sum_to_goal(const std::vector<part>& parts,
                                    const integrate_options& options, const magnitude& rest) {
  integral_account account;
  integrate_options of_parts = options;
  of_parts.rule = quadrature_rule::automatic;
  of_parts.progress = nullptr;
  of_parts.absolute_exponent.reset();
  const double log2_digits = options.goal().log2_relative();
  for (long digits = std::min(options.digits, 6L);;) {
    of_parts.digits = digits;
    integral found = sum_of_parts(parts, of_parts, account);
    if (!found.enclosure.is_bounded()) return std::nullopt;
    found.enclosure = found.enclosure.enlarged(rest);
    if (options.goal().is_met_by(found.enclosure)) {
      found.verdict = status::certified;
      found.account = std::move(account);
      return found;
    }
    if (digits > 2 * options.digits + 8) return std::nullopt;
    const double size = estimated_log2(found.enclosure.magnitude_lower());
    digits = std::isfinite(size) ? std::max(options.digits + 1, digits + 3) : digits * 2;
    if (std::isfinite(size)) {
      const double goal = size - log2_digits - std::log2(static_cast<double>(parts.size())) - 2;
      of_parts.absolute_exponent = std::max(
          static_cast<long>(goal), options.absolute_exponent.value_or(static_cast<long>(goal)));
    }
  }
}

std::optional<integral> integrate_with_tails(const integrand& f, const end_point& a,
                                             const end_point& b, const tail_finder& tail,
                                             const integrate_options& options) {
  std::vector<part> parts;
  magnitude rest;
  end_point lower = a;
  end_point upper = b;
  const auto cut = [&](end_point& end, const end_point& other) {
    const int side = end.infinite_sign();
    if (side == 0) return true;
    const auto found = tail(other.is_infinite() ? rational(0) : bound_beyond(other, side), side);
    if (!found) return false;
    parts.insert(parts.end(), found->parts.begin(), found->parts.end());
    rest = add_up(rest, found->rest);
    end = found->start;
    return true;
  };
  if (!cut(upper, a) || !cut(lower, b)) return std::nullopt;
  if (!(lower.exact() && upper.exact() && *lower.exact() == *upper.exact())) {
    parts.push_back({f, lower, upper});
  }
  return sum_to_goal(parts, options, rest);
}

}  // namespace polhode::detail
