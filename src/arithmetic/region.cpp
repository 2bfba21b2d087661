#include "polhode/arithmetic/region.hpp"

namespace polhode {

namespace {
constexpr precision ball_bits = 64;  // of a set that only left the hardware's range

bool left_range(const rectangle<double_interval>& z) {
  return z.re.is_out_of_range() || z.im.is_out_of_range();
}

/// One end is 0, and not the other: it is 0, or it underflowed to it.
bool ends_at_zero(double_interval x) { return (x.lower() == 0) != (x.upper() == 0); }
bool ends_at_zero(const rectangle<double_interval>& z) {
  return ends_at_zero(z.re) || ends_at_zero(z.im);
}

/// The hardware's set holds 0 and the ball does not: an end has underflowed.
bool lost_sign(double_interval in_hardware, const ball& x) {
  return contains_zero(in_hardware) && !x.is_undefined() && !contains_zero(x);
}
}  // namespace

std::string to_text(obstacle o) {
  switch (o) {
    case obstacle::none:
      return "none";
    case obstacle::branch_cut:
      return "branch cut";
    case obstacle::pole:
      return "pole";
    case obstacle::kink:
      return "kink";
    case obstacle::jump:
      return "jump";
    case obstacle::undefined:
      return "undefined";
    case obstacle::unknown:
      return "unknown";
  }
  return "undefined";
}

bool region::needs_balls() const { return left_range(hardware_); }

void region::settle() {
  if (is_undefined(hardware_)) {
    obstacle_ = obstacle::undefined;
    where_ = "argument";
  }
}

region region::blocked(obstacle why, std::string_view function) {
  region r;
  r.hardware_ = {double_interval::undefined(), double_interval::undefined()};
  r.obstacle_ = why;
  r.where_ = function;
  return r;
}

region region::from_balls(const complex_ball& z, bool keep_balls) {
  region r;
  r.hardware_ = {double_interval::from_ball(z.re), double_interval::from_ball(z.im)};
  r.settle();
  const bool lost =
      r.needs_balls() || lost_sign(r.hardware_.re, z.re) || lost_sign(r.hardware_.im, z.im);
  if (r.is_analytic() && (keep_balls || lost)) {
    const polhode::precision p = keep_balls ? std::max(z.precision(), ball_bits + 1) : ball_bits;
    r.balls_ = std::make_shared<const complex_ball>(z.with_precision(p));
  }
  return r;
}

region region::in_balls(const complex_ball& z) { return from_balls(z, true); }

complex_ball region::to_complex_ball() const {
  if (!is_analytic()) return complex_ball::undefined(ball_bits);
  if (balls_ != nullptr) return *balls_;
  return {to_ball(hardware_.re, ball_bits), to_ball(hardware_.im, ball_bits)};
}

magnitude region::magnitude_upper() const {
  if (!is_analytic()) return magnitude::infinity();
  return to_complex_ball().magnitude_upper();
}
magnitude region::magnitude_lower() const {
  if (!is_analytic()) return {};
  return to_complex_ball().magnitude_lower();
}
double_interval region::re() const {
  return is_analytic() ? hardware_.re : double_interval::undefined();
}
double_interval region::im() const {
  return is_analytic() ? hardware_.im : double_interval::undefined();
}

/// f in hardware, or in balls where an operand is kept in them or the result leaves the hardware's
/// range: also where an end may have underflowed to 0, so that the set would seem to touch a pole or a
/// branch point. (What is made of sets that end at 0 ends at 0 as a rule, and balls would not help; not
/// so exp of [-1000, 0]: `zero_is_news` there.) An undefined result of operands without an obstacle is
/// retried too: it may come of infinity - infinity; if balls do no better, it is not analytic.
template <class Hardware, class Balls>
region region::combined(const region& z, const region& w, Hardware&& hardware, Balls&& balls,
                        bool zero_is_news) {
  if (!z.is_analytic()) return z;
  if (!w.is_analytic()) return w;
  if (z.is_in_hardware() && w.is_in_hardware()) {
    region r;
    r.hardware_ = hardware(z.hardware_, w.hardware_);
    const bool suspicious =
        ends_at_zero(r.hardware_) &&
        (zero_is_news || !(ends_at_zero(z.hardware_) || ends_at_zero(w.hardware_)));
    if (!is_undefined(r.hardware_) && !r.needs_balls() && !suspicious) return r;
  }
  const bool keep_balls = z.precision() > ball_bits || w.precision() > ball_bits;
  return from_balls(balls(z.to_complex_ball(), w.to_complex_ball()), keep_balls);
}

/// The shapes of the functions below.
struct region::functions {
  /// Whether the predicate holds of the set, in the form in which it is kept.
  template <class Predicate>
  static bool holds(const region& z, Predicate&& predicate) {
    if (z.is_in_hardware()) return predicate(z.hardware_);
    return predicate(static_cast<const rectangle<ball>&>(*z.balls_));
  }
  /// f without singularities.
  template <class F>
  static region entire(const region& z, F&& f, bool zero_is_news = false) {
    return combined(
        z, z, [&](const auto& x, const auto&) { return f(x); },
        [&](const complex_ball& x, const complex_ball&) { return complex_ball(f(x)); },
        zero_is_news);
  }
  /// f where singular(z) is false, else blocked.
  template <class Singular, class F>
  static region away_from(const region& z, obstacle why, std::string_view name, Singular&& singular,
                          F&& f) {
    if (!z.is_analytic()) return z;
    if (holds(z, singular)) return blocked(why, name);
    return entire(z, f);
  }
  /// The sign of the real part, exactly: -1, 1, or 0 where it is not the same everywhere.
  static int sign_of_real_part(const region& z) {
    if (holds(z, [](const auto& x) { return certainly_positive(x.re); })) return 1;
    return holds(z, [](const auto& x) { return certainly_negative(x.re); }) ? -1 : 0;
  }
  /// The integer f(x), where it is the same for all x near the real part.
  template <class F>
  static region step(const region& z, std::string_view name, F&& f) {
    if (!z.is_analytic()) return z;
    const complex_ball w = z.to_complex_ball();
    const ball value = f(w.re);
    // Away from the jumps: the set lies between the integers on both sides, without touching them.
    const ball below = floor(w.re);
    if (!value.is_exact() || !below.is_exact() || !certainly_less(below, w.re) ||
        !certainly_less(w.re, below + 1)) {
      return blocked(obstacle::jump, name);
    }
    return region(value);
  }
};

#define POLHODE_RECTANGLE_FUNCTION(f) [](const auto& x) { return f(x); }
#define POLHODE_SINGULAR(f) [](const auto& x) { return possibly_singular::f(x); }

region operator-(const region& z) {
  return region::functions::entire(z, [](const auto& x) { return -x; });
}
region operator+(const region& z, const region& w) {
  const auto f = [](const auto& x, const auto& y) { return x + y; };
  return region::combined(z, w, f, f);
}
region operator-(const region& z, const region& w) {
  const auto f = [](const auto& x, const auto& y) { return x - y; };
  return region::combined(z, w, f, f);
}
region operator*(const region& z, const region& w) {
  const auto f = [](const auto& x, const auto& y) { return x * y; };
  return region::combined(z, w, f, f);
}
region operator/(const region& z, const region& w) {
  if (!z.is_analytic()) return z;
  if (!w.is_analytic()) return w;
  if (region::functions::holds(w, [](const auto& x) { return possibly_singular::reciprocal(x); })) {
    return region::blocked(obstacle::pole, "/");
  }
  const auto f = [](const auto& x, const auto& y) { return x / y; };
  return region::combined(z, w, f, f);
}

#define POLHODE_ENTIRE(f) \
  region f(const region& z) { return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(f)); }
POLHODE_ENTIRE(square)
POLHODE_ENTIRE(sin)
POLHODE_ENTIRE(cos)
POLHODE_ENTIRE(sinh)
POLHODE_ENTIRE(cosh)
#undef POLHODE_ENTIRE
region exp(const region& z) {
  return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(exp), true);
}

#define POLHODE_AWAY_FROM(f, why)                                                  \
  region f(const region& z) {                                                      \
    return region::functions::away_from(z, obstacle::why, #f, POLHODE_SINGULAR(f), \
                                        POLHODE_RECTANGLE_FUNCTION(f));            \
  }
POLHODE_AWAY_FROM(sqrt, branch_cut)
POLHODE_AWAY_FROM(log, branch_cut)
POLHODE_AWAY_FROM(tan, pole)
POLHODE_AWAY_FROM(tanh, pole)
POLHODE_AWAY_FROM(asin, branch_cut)
POLHODE_AWAY_FROM(acos, branch_cut)
POLHODE_AWAY_FROM(atan, branch_cut)
POLHODE_AWAY_FROM(asinh, branch_cut)
POLHODE_AWAY_FROM(acosh, branch_cut)
POLHODE_AWAY_FROM(atanh, branch_cut)
#undef POLHODE_AWAY_FROM
#undef POLHODE_SINGULAR
#undef POLHODE_RECTANGLE_FUNCTION

region pow(const region& z, long n) {
  return region::functions::away_from(
      z, obstacle::pole, "pow", [&](const auto& x) { return possibly_singular::pow(x, n); },
      [&](const auto& x) { return pow(x, n); });
}

region pow(const region& z, const region& w) {
  if (!z.is_analytic()) return z;
  if (!w.is_analytic()) return w;
  if (region::functions::holds(z, [](const auto& x) { return possibly_singular::sqrt(x); })) {
    return region::blocked(obstacle::branch_cut, "pow");
  }
  return exp(w * log(z));
}

region abs(const region& z) {
  if (!z.is_analytic()) return z;
  switch (region::functions::sign_of_real_part(z)) {
    case 1:
      return z;
    case -1:
      return -z;
    default:
      return region::blocked(obstacle::kink, "abs");
  }
}

region min(const region& z, const region& w) {
  region difference = z - w;
  if (!difference.is_analytic()) return difference;
  const int sign = region::functions::sign_of_real_part(difference);
  if (sign == 0) return region::blocked(obstacle::kink, "min");
  return sign < 0 ? z : w;
}

region max(const region& z, const region& w) {
  region difference = z - w;
  if (!difference.is_analytic()) return difference;
  const int sign = region::functions::sign_of_real_part(difference);
  if (sign == 0) return region::blocked(obstacle::kink, "max");
  return sign > 0 ? z : w;
}

region floor(const region& z) {
  return region::functions::step(z, "floor", [](const ball& x) { return floor(x); });
}
region ceil(const region& z) {
  return region::functions::step(z, "ceil", [](const ball& x) { return ceil(x); });
}

}  // namespace polhode
