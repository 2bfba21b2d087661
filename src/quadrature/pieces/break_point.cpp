#include "break_point.hpp"

#include <algorithm>
#include <utility>

#include "polhode/arithmetic/interval.hpp"
#include "quadrature/pieces/breaks.hpp"

namespace polhode::detail::breaks {

namespace {
ball lower_end(const ball& x) { return {lower_rational(x), x.precision()}; }
ball upper_end(const ball& x) { return {upper_rational(x), x.precision()}; }
}  // namespace

break_point::break_point(std::shared_ptr<const formula_graph> f, crossing c, choices chosen,
                         const interval& x)
    : f_(std::move(f)),
      crossing_(c),
      chosen_(std::move(chosen)),
      x_(x),
      size_(x.set(64).magnitude_upper()),
      enclosure_(x.set(x.bits())) {}

ball break_point::at(precision p) {
  const std::lock_guard lock(mutex_);
  refine(p);
  return enclosure_.with_precision(p);
}

std::optional<rational> break_point::as_rational() {
  constexpr long greatest_denominator = 10'000;
  const ball r = at(128);
  if (!r.is_bounded()) return std::nullopt;
  const rational q = simplest_between(lower_rational(r), upper_rational(r));
  if (denominator(q) > greatest_denominator || q < x_.low || q > x_.high) return std::nullopt;
  for (const double reach : {0x1p-8, 0x1p-32}) {
    const end_series x = end_series::argument(known_number(q), known_number(rational(1)), 1, reach);
    const end_series t =
        evaluate(*f_, 192, x, chosen_, crossing_.decider)[crossing_.decider] - crossing_.n;
    // 0 at q, exactly: and there is one zero only in the interval.
    if (!t.is_blocked() && t.simplified().exponent() > 0) return q;
  }
  return std::nullopt;
}

/// Newton's steps N(X) = m - t(m)/t'(X), which hold every zero in X (R. E. Moore, 1966: 0 = t(r) =
/// t(m) + t'(s) (r - m) with s in X), and halvings by the sign at the middle where these do not
/// contract.
void break_point::refine(precision p) {
  int stalls = 0;
  long extra = 64;
  while (stalls < 4) {
    const magnitude radius = enclosure_.radius();
    const magnitude size = contains_zero(enclosure_) ? size_ : enclosure_.magnitude_upper();
    if (radius <= scale(size, -p - 1)) return;
    const auto bits = std::max<std::int64_t>(size.log2_floor() - radius.log2_floor(), 1);
    const precision working = std::min<precision>(2 * bits, p) + extra;
    const ball current = enclosure_.with_precision(working);
    const ball middle = current.middle();
    const ball value = decider_at(middle)[0] - crossing_.n;
    ball next = intersection(middle - value / decider_at(current)[1], current);
    if (next.is_undefined() || next.radius() > scale(radius, -1)) {
      const certain_sign s = sign_of(value);
      if (s == certain_sign::positive || s == certain_sign::negative) {
        const bool beyond = (s == certain_sign::positive) == crossing_.ascending;
        const ball half =
            beyond ? hull(lower_end(current), middle) : hull(middle, upper_end(current));
        const ball both = next.is_undefined() ? half : intersection(next, half);
        if (!both.is_undefined()) next = both;
      }
    }
    if (!next.is_undefined() && next.radius() < radius) enclosure_ = next;
    const bool contracted = enclosure_.radius() <= scale(radius, -1);
    stalls = contracted ? 0 : stalls + 1;
    extra = contracted ? 64 : 2 * extra;
  }
}

slope_jet break_point::decider_at(const ball& x) const {
  return evaluate(*f_, x.precision(), slope_jet::variable(x), chosen_,
                  crossing_.decider)[crossing_.decider];
}

}  // namespace polhode::detail::breaks
