// The times at which the intermediate axis turns over.

#include <optional>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/jacobi_start.hpp"
#include "scene/motion.hpp"

namespace polhode::detail {
namespace {

// J_y is 0 at u = 2K n, and at u = 0 on the separatrix, in the solution of rotor.hpp: half turns
// about principal axes, which are symmetries of the motion, have turned its start there.

/// u_0/(2K) where it is a multiple of 1/2.
std::optional<rational> exact_share(const jacobi_start& at) {
  if (at.sine == 0) return at.cosine < 0 ? rational(1) : rational(0);
  if (at.cosine == 0) return rational(at.sine, 2);
  return std::nullopt;
}

/// t_0 = u_0/lambda in I_y/J, in (-T/2, T/2].
ball initial_time(const effect_context& x, const jacobi_start& at, const ball& period) {
  const precision p = period.precision();
  const ball first = at.distance(p) / sqrt(x.motion().lambda2().at(p));
  const ball size = at.cosine < 0 ? scale(period, -1) - first : first;
  return at.sine < 0 ? -size : size;
}

/// The whole number that a rounded ball is.
std::optional<integer> whole(const ball& x) {
  if (!x.is_bounded() || !x.is_exact()) return std::nullopt;
  return numerator(lower_rational(x));
}

/// An end of the scene's time over I_y/J.
ball natural(const effect_context& x, const rational& time, precision p) {
  return ball(time, p) / natural_time(x.what, p);
}

void separatrix_flip(const effect_context& x, effect_result& result) {
  const triple<exact_real>& squares = x.start().direction_squares();
  const int side = jacobi_start_of(x.start()).sine;
  result.remarks.emplace_back("on the separatrix: it turns over once in all time");
  // artanh y = log((1 + y)/sqrt(1 - y^2)), and 1 - y^2 is the sum of the other squares.
  const exact_real rest = squares[0] + squares[2];
  const auto time = [&](precision p) {
    const ball distance = log((1 + sqrt(squares[1].at(p))) / sqrt(rest.at(p))) /
                          sqrt((x.rigid().a() * x.rigid().b()).at(p)) * natural_time(x.what, p);
    return side > 0 ? -distance : distance;
  };
  const rational from = x.what.time ? x.what.time->from : rational(0);
  std::optional<bool> inside;
  if (side == 0) inside = from <= 0 && (!x.what.time || 0 <= x.what.time->to);
  const precision most = 4096 + 8 * size_in_bits(from);
  for (precision p = 128; !inside && p <= most; p *= 2) {
    const ball t = time(p);
    const ball begin(from, p);
    const bool before = certainly_less(t, begin);
    const bool after = x.what.time && certainly_less(ball(x.what.time->to, p), t);
    if (before || after) inside = false;
    const bool not_after = !x.what.time || certainly_less(t, ball(x.what.time->to, p));
    if (certainly_less(begin, t) && not_after) inside = true;
  }
  if (!inside) {
    return not_certified(result, "whether it turns over within the range of time was not decided");
  }
  add_exact(result, "count", rational(*inside ? 1 : 0));
  if (!*inside) {
    result.remarks.emplace_back(x.what.time ? "that is outside the range of time"
                                            : "that was before time 0");
    return;
  }
  if (side == 0) return add_exact(result, "flip_1", 0);
  add(result, "flip_1", enclose_to_digits(time, x.digits(), ample_guard(x.digits())),
      x.what.time_unit.name);
}

}  // namespace

effect_result flips(const effect_context& x) {
  effect_result result;
  const std::string unit = x.what.time_unit.name;
  if (x.start().regime() == regime::separatrix) {
    separatrix_flip(x, result);
    return result;
  }
  if (!is_periodic(x.regime())) {
    result.words = {{"flips", "never"}};
    result.remarks.emplace_back(
        x.regime() == regime::separatrix
            ? "exactly about the intermediate axis: an equilibrium, in which it stays"
            : to_text(x.regime()) + ", in which it stays");
    return result;
  }
  const jacobi_start at = jacobi_start_of(x.start());
  const auto exact = exact_share(at);
  const ball& shared = x.number("period", "natural_period");
  const auto period = [&](precision p) {
    return p <= shared.precision() ? shared : x.motion().period(p, &result.work);
  };
  const auto share = [&](const ball& t) {
    if (exact) return ball(*exact, t.precision());
    ++result.work.integrals;
    return 2 * initial_time(x, at, t) / t;
  };
  // Flip n is at (n - share) T/2.
  const auto number_at = [&](const rational& time, bool up) -> std::optional<integer> {
    if (time == 0 && exact) return whole(up ? ceil(ball(*exact, 64)) : floor(ball(*exact, 64)));
    const precision sizes = size_in_bits(x.rigid().a()) + size_in_bits(x.rigid().b()) +
                            size_in_bits(x.c()) + size_in_bits(time);
    const precision most = shared.precision() + 4096 + std::min(8 * sizes, greatest_guard);
    for (precision p = shared.precision(); p <= most; p *= 2) {
      const ball t = period(p);
      const ball place = 2 * natural(x, time, p) / t + share(t);
      if (auto n = whole(up ? ceil(place) : floor(place))) return n;
    }
    return std::nullopt;
  };
  const rational begin = x.what.time ? x.what.time->from : rational(0);
  const auto first = number_at(begin, true);
  if (!first) {
    not_certified(result, "whether it turns over exactly at the beginning was not decided");
    return result;
  }
  integer last = *first + x.what.listed - 1;
  if (x.what.time) {
    const auto end = number_at(x.what.time->to, false);
    if (!end) {
      not_certified(result, "whether it turns over exactly at the end was not decided");
      return result;
    }
    add_exact(result, "count", rational(*end - *first + 1));
    if (*end > last)
      result.remarks.push_back("and " + integer(*end - last).str() +
                               " more, not listed (listed = " + std::to_string(x.what.listed) +
                               ")");
    last = std::min(last, *end);
  }
  add(result, "spacing", scale(shared, -1) * natural_time(x.what, shared.precision()), unit);
  for (integer n = *first; n <= last; ++n) {
    const std::string name = "flip_" + integer(n - *first + 1).str();
    if (exact && rational(n) == *exact) {
      add_exact(result, name, 0);
      continue;
    }
    const auto time = [&](precision p) {
      const ball t = period(p);
      const ball distance = exact ? ball(rational(n - *exact), t.precision()) * t
                                  : n * t - 2 * initial_time(x, at, t);
      return scale(distance, -1) * natural_time(x.what, t.precision());
    };
    if (!exact) ++result.work.integrals;
    ball found = time(shared.precision());
    if (!to_decimal_enclosure(found, x.digits()).has(x.digits())) {  // it is near 0, and cancels
      found =
          enclose_to_digits(time, x.digits(), ample_guard(x.digits()) + 2 * size_in_bits(x.c()));
    }
    add(result, name, found, unit);
  }
  return result;
}

}  // namespace polhode::detail
