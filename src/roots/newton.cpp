#include "polhode/roots/newton.hpp"

#include "polhode/arithmetic/boost_bridge.hpp"

namespace polhode {

std::string to_text(root_verdict v) {
  switch (v) {
    case root_verdict::unique:
      return "unique";
    case root_verdict::multiple:
      return "multiple";
    case root_verdict::isolated:
      return "isolated";
    case root_verdict::at_least_one:
      return "at least one";
    case root_verdict::infinitely_many:
      return "infinitely many";
    case root_verdict::none:
      return "none";
    case root_verdict::unresolved:
      return "unresolved";
  }
  return "unresolved";
}

namespace {

/// The sign of f at a point, at the first precision that decides it.
class sign_at {
 public:
  sign_at(const std::function<ball(const ball&, precision)>& f, precision most_precision)
      : f_(f), most_precision_(most_precision) {}

  certain_sign operator()(const ball& x) {
    for (precision p = 64; p <= most_precision_; p *= 2) {
      ++evaluations;
      const certain_sign s = sign_of(f_(x, p));
      if (s != certain_sign::unknown) return s;
    }
    return certain_sign::unknown;
  }

  int evaluations = 0;

 private:
  const std::function<ball(const ball&, precision)>& f_;
  precision most_precision_;
};

bool opposite(certain_sign s, certain_sign t) {
  return (s == certain_sign::negative && t == certain_sign::positive) ||
         (s == certain_sign::positive && t == certain_sign::negative);
}

}  // namespace

sign_bracket bracket_by_sign(const std::function<ball(const ball& x, precision p)>& f,
                             const ball& interval, long bits, precision most_precision) {
  sign_bracket result;
  result.interval = interval;
  if (!interval.is_bounded()) {
    result.why = reason::not_defined;
    return result;
  }
  sign_at f_sign(f, most_precision);
  // Bisection needs a bit of the end points for each halving.
  const precision p = interval.precision() + bits + 2;
  ball low(interval.is_exact() ? midpoint(interval) : lower(interval));
  ball high(interval.is_exact() ? midpoint(interval) : upper(interval));
  low = low.with_precision(p);
  high = high.with_precision(p);
  const certain_sign low_sign = f_sign(low);
  const certain_sign high_sign = f_sign(high);
  result.evaluations = f_sign.evaluations;
  if (low_sign == certain_sign::zero || high_sign == certain_sign::zero) {
    result.verdict = status::certified;
    result.interval = low_sign == certain_sign::zero ? low : high;
    return result;
  }
  if (!opposite(low_sign, high_sign)) {
    result.why = low_sign == certain_sign::unknown || high_sign == certain_sign::unknown
                     ? reason::not_defined
                     : reason::refuted;
    return result;
  }
  result.verdict = status::certified;
  for (long i = 0; i < bits; ++i) {
    const ball middle = hull(low, high).middle();
    const certain_sign s = f_sign(middle);
    if (s == certain_sign::zero) {
      low = high = middle;
      break;
    }
    if (s == certain_sign::unknown) break;
    (s == low_sign ? low : high) = middle;
  }
  result.evaluations = f_sign.evaluations;
  result.interval = hull(low, high);
  return result;
}

}  // namespace polhode
