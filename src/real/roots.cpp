#include "polhode/real/roots.hpp"

namespace polhode::detail {

root_enclosure proved_near(const expression& formula, const ball& x, const ball& interval,
                           precision p) {
  root_enclosure result;
  result.root = interval;
  result.box = interval;
  if (!x.is_bounded() || !interval.is_bounded()) return result;
  const real_function f(formula);
  const auto value = [&](const ball& at) { return f.at(at.precision())->value(at); };
  const auto slope = [&](const ball& at) { return f.at(at.precision())->derivative(at); };
  const magnitude width = interval.radius();
  const magnitude size = x.magnitude_upper().is_zero() ? width : x.magnitude_upper();
  // A few units in the last place of x first, where an iteration that ended well is; then wider, to
  // the whole interval.
  constexpr long first_bits_off = 6;
  for (long bits = static_cast<long>(x.precision()) - first_bits_off;; bits /= 2) {
    const magnitude radius = bits > 0 ? scale(size, -bits) : width;
    const ball around = x.enlarged(radius < width ? radius : width);
    const ball box = bits > 0 ? intersection(around, interval) : interval;
    if (box.is_undefined()) return result;
    root_enclosure proof = refine_root(value, slope, box, p);
    if (proof.verdict == root_verdict::unique) return proof;
    if (bits <= 0) return result;
  }
}

}  // namespace polhode::detail
