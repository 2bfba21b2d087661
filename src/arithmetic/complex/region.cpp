#include "polhode/arithmetic/region.hpp"

#include <algorithm>
#include <cmath>

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
/// What is made of it ends at 0 as a rule: x^2 of [-4, 4] does.
bool touches_zero(const rectangle<double_interval>& z) {
  return ends_at_zero(z) || contains_zero(z);
}

/// Every end is 0 or a normal double.
bool is_regular(double_interval x) {
  const auto is_kept = [](double end) {
    const double size = std::abs(end);
    return (size >= detail::least_normal_double && size < detail::infinity) || end == 0;
  };
  return is_kept(x.lower()) && is_kept(x.upper());
}
bool is_regular(const rectangle<double_interval>& z) {
  return is_regular(z.re) && is_regular(z.im);
}

// Products and quotients of rectangles, of which one often is real or touches the real axis: what 0 adds to a product is
// 0 exactly, and need not be computed.

using hardware_rectangle = rectangle<double_interval>;

bool is_real(const hardware_rectangle& z) { return z.im.lower() == 0 && z.im.upper() == 0; }

/// x * y. Where every end is 0 or far from a double's limits, a product of two of them is 0 only if a factor is.
double_interval times(double_interval x, double_interval y) {
  const auto is_plain = [](double end) {
    const double size = std::abs(end);
    return end == 0 || (size >= 0x1p-500 && size <= 0x1p500);
  };
  const double x1 = x.lower();
  const double x2 = x.upper();
  const double y1 = y.lower();
  const double y2 = y.upper();
  if (!is_plain(x1) || !is_plain(x2) || !is_plain(y1) || !is_plain(y2)) return x * y;
  const double low = std::min(std::min(x1 * y1, x1 * y2), std::min(x2 * y1, x2 * y2));
  const double high = std::max(std::max(x1 * y1, x1 * y2), std::max(x2 * y1, x2 * y2));
  return {detail::unchecked{}, low == 0 ? 0 : detail::next_down(low),
          high == 0 ? 0 : detail::next_up(high)};
}

hardware_rectangle product(const hardware_rectangle& z, const hardware_rectangle& w) {
  const double_interval re = times(z.re, w.re);
  if (is_real(z)) return {re, is_real(w) ? w.im : times(z.re, w.im)};
  if (is_real(w)) return {re, times(z.im, w.re)};
  return {re - times(z.im, w.im), times(z.re, w.im) + times(z.im, w.re)};
}

/// Whether z^n is sure to be beyond the range of doubles, or below it, somewhere.
bool leaves_range(const hardware_rectangle& z, long n) {
  const double size = std::max(z.re.magnitude(), z.im.magnitude());
  if (!(size > 0 && size < detail::infinity)) return false;
  const long exponent = std::ilogb(size);  // 2^exponent <= size < 2^(exponent + 1)
  return exponent * n > 1100 || (exponent + 2) * n < -1100;
}

/// x / (x^2 + y^2), the real part of 1/(x + iy), over a rectangle without 0. It is odd in x; for x > 0 it falls
/// with |y|, and with x rises up to x = |y| and falls from there: its least value is at the greatest |y| and an
/// end of x, its greatest at the least |y| and the x nearest to that.
double_interval real_part_of_inverse(double_interval x, double_interval y) {
  const auto at = [](double s, double t) {
    const double_interval end(s);
    return 1 / (end + square(double_interval(t)) / end);
  };
  const double least = y.mignitude();
  const double greatest = y.magnitude();
  if (x.upper() < 0) return -real_part_of_inverse(-x, y);
  if (x.lower() > 0) {
    const double low = x.lower();
    const double high = x.upper();
    double_interval r =
        hull(at(greatest <= low ? high : low, greatest), at(std::clamp(least, low, high), least));
    if (greatest > low && greatest < high) r = hull(r, at(high, greatest));
    return r;
  }
  const auto most = [&](double end) {
    return end > 0 ? at(std::min(least, end), least) : double_interval(0);
  };
  return hull(-most(-x.lower()), most(x.upper()));
}

/// For w without 0.
hardware_rectangle quotient(const hardware_rectangle& z, const hardware_rectangle& w) {
  if (is_real(w)) return {z.re / w.re, z.im / w.re};
  return product(z, {real_part_of_inverse(w.re, w.im), -real_part_of_inverse(w.im, w.re)});
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

/// 2^exponent times an interval.
struct region::scaled_interval {
  double_interval m;
  long exponent = 0;

  [[nodiscard]] double_interval over(long e) const { return scale(m, exponent - e); }
};

/// 2^exponent times a rectangle: what lies beyond the range of doubles, without balls. Each form below is
/// the function's usual one, whose factors beyond the range have the exponent split off. Nothing where a
/// function has no such form.
struct region::scaled {
  rectangle<double_interval> m;
  long exponent = 0;
  std::optional<scaled_interval> modulus = std::nullopt;

  static constexpr long largest_exponent = 1L << 40;  // sums of a few do not overflow

  static scaled of(const region& z) { return {z.hardware_, z.exponent_}; }

  /// About 1 in size, but for a set that is {0} or unbounded.
  [[nodiscard]] scaled normalised() const {
    const double size = std::max(m.re.magnitude(), m.im.magnitude());
    if (!(size > 0 && size < detail::infinity)) return *this;
    const int k = std::ilogb(size);
    return {{scale(m.re, -k), scale(m.im, -k)}, exponent + k};
  }

  /// A region in the hardware; nothing where the rectangle's parts differ by more than doubles hold.
  [[nodiscard]] std::optional<region> to_region() const {
    if (is_undefined(m) || std::abs(exponent) > largest_exponent) return std::nullopt;
    scaled r = normalised();
    if (r.exponent > -900 && r.exponent < 900) {
      r = {{scale(r.m.re, r.exponent), scale(r.m.im, r.exponent)}, 0};
    }
    if (left_range(r.m)) return std::nullopt;
    region result;
    result.hardware_ = r.m;
    result.exponent_ = r.exponent;
    if (modulus) return std::move(result).with_modulus(*modulus);
    return result;
  }

  static std::optional<scaled> sum(const scaled& z, const scaled& w) {
    const scaled& large = z.exponent >= w.exponent ? z : w;
    const scaled& small = z.exponent >= w.exponent ? w : z;
    const long shift = small.exponent - large.exponent;
    return scaled{{large.m.re + scale(small.m.re, shift), large.m.im + scale(small.m.im, shift)},
                  large.exponent};
  }
  static std::optional<scaled> difference(const scaled& z, const scaled& w) {
    return sum(z, {{-w.m.re, -w.m.im}, w.exponent});
  }
  static std::optional<scaled> product(const scaled& z, const scaled& w) {
    const scaled x = z.normalised();
    const scaled y = w.normalised();
    return scaled{x.m * y.m, x.exponent + y.exponent};
  }
  static std::optional<scaled> quotient(const scaled& z, const scaled& w) {
    const scaled x = z.normalised();
    const scaled y = w.normalised();
    return scaled{x.m / y.m, x.exponent - y.exponent};
  }
  static std::optional<scaled> square(const scaled& z) {
    const scaled x = z.normalised();
    return scaled{polhode::square(x.m), 2 * x.exponent};
  }
  static std::optional<scaled> sqrt(const scaled& z) {
    scaled x = z.normalised();
    if (x.exponent % 2 != 0) x = {{scale(x.m.re, 1), scale(x.m.im, 1)}, x.exponent - 1};
    return scaled{polhode::sqrt(x.m), x.exponent / 2};
  }

  /// e^x = 2^k e^(x - k log 2), for any k. Bounded x.
  static std::optional<scaled_interval> exp(double_interval x, long k) {
    if (!(x.magnitude() < 0x1p39)) return std::nullopt;
    static const double_interval log_2 = log(double_interval(2));
    return scaled_interval{polhode::exp(x - k * log_2), k};
  }
  /// A k for which exp(x - k log 2) stays in the hardware's range.
  static long exponent_of_exp(double x) {
    return std::abs(x) < 0x1p39 ? std::lround(x / 0.6931471805599453) : 0;
  }
  /// cosh x and sinh x, with one exponent.
  static std::optional<std::pair<double_interval, double_interval>> cosh_sinh(double_interval x,
                                                                              long k) {
    const auto up = exp(x, k);
    const auto down = exp(-x, k);
    if (!up || !down) return std::nullopt;
    return std::pair{scale(up->m + down->m, -1), scale(up->m - down->m, -1)};
  }

  static std::optional<scaled> exp(const scaled& z) {
    // In a wider one the lower end would underflow.
    if (z.exponent != 0 || !(z.m.re.width() < 600)) return std::nullopt;
    const auto size = exp(z.m.re, exponent_of_exp(z.m.re.upper()));
    if (!size) return std::nullopt;
    const auto [sine, cosine] = sin_cos(z.m.im);
    return scaled{{size->m * cosine, size->m * sine}, size->exponent, size};
  }
  /// cosh z = cosh x cos y + i sinh x sin y and sinh z = sinh x cos y + i cosh x sin y. |cosh z|^2 = sinh^2 x + cos^2 y =
  /// cosh^2 x - sin^2 y and |sinh z|^2 = sinh^2 x + sin^2 y = cosh^2 x - cos^2 y: both between |sinh x| and cosh x.
  static std::optional<scaled> hyperbolic(const scaled& z, bool is_cosh) {
    if (z.exponent != 0) return std::nullopt;
    const long k = exponent_of_exp(z.m.re.magnitude());
    const auto both = cosh_sinh(z.m.re, k);
    if (!both) return std::nullopt;
    const auto& [c, s] = *both;
    const auto [sine, cosine] = sin_cos(z.m.im);
    const scaled_interval modulus{hull(abs(s), c), k};
    if (is_cosh) return scaled{{c * cosine, s * sine}, k, modulus};
    return scaled{{s * cosine, c * sine}, k, modulus};
  }
  static std::optional<scaled> cosh(const scaled& z) { return hyperbolic(z, true); }
  static std::optional<scaled> sinh(const scaled& z) { return hyperbolic(z, false); }
  /// cos z = cosh(iz), sin z = -i sinh(iz).
  static std::optional<scaled> cos(const scaled& z) {
    return hyperbolic({{-z.m.im, z.m.re}, z.exponent}, true);
  }
  static std::optional<scaled> sin(const scaled& z) {
    const std::optional<scaled> s = hyperbolic({{-z.m.im, z.m.re}, z.exponent}, false);
    if (!s) return s;
    return scaled{{s->m.im, -s->m.re}, s->exponent, s->modulus};
  }
  /// |z|^n e^(i n arg z).
  static std::optional<scaled> pow(const scaled& z, long n) {
    const scaled x = z.normalised();
    static const double_interval log_2 = log(double_interval(2));
    if (contains_zero(x.m)) {  // in a disc
      const double_interval most(hypot(x.m.re, x.m.im).upper());
      if (n < 1 || !(most.lower() > 0)) return std::nullopt;
      const double_interval l = n * (log(most) + x.exponent * log_2);
      const auto size = exp(l, exponent_of_exp(l.upper()));
      if (!size) return std::nullopt;
      const double_interval side(-size->m.upper(), size->m.upper());
      return scaled{{side, side}, size->exponent};
    }
    const rectangle<double_interval> l = log(x.m);
    const double_interval size = n * (l.re + x.exponent * log_2);
    const auto modulus = exp(size, exponent_of_exp(size.upper()));
    if (!modulus) return std::nullopt;
    const auto [sine, cosine] = sin_cos(n * l.im);
    return scaled{{modulus->m * cosine, modulus->m * sine}, modulus->exponent, modulus};
  }
};

/// The form of a function without one.
struct region::not_scaled {
  std::optional<scaled> operator()(const scaled&, const scaled&) const { return std::nullopt; }
};

complex_ball region::to_complex_ball() const {
  if (!is_analytic()) return complex_ball::undefined(ball_bits);
  if (balls_ != nullptr) return *balls_;
  return {scale(to_ball(hardware_.re, ball_bits), exponent_),
          scale(to_ball(hardware_.im, ball_bits), exponent_)};
}

namespace {
magnitude to_magnitude(double x, bool up) {
  if (std::isinf(x)) return magnitude::infinity();
  int exponent = 0;
  const auto fraction = static_cast<std::uint64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  const magnitude m =
      up ? magnitude::from_integer_up(fraction) : magnitude::from_integer_down(fraction);
  return scale(m, exponent - 53);
}
}  // namespace

magnitude region::magnitude_upper() const {
  if (!is_analytic()) return magnitude::infinity();
  if (balls_ != nullptr) return balls_->magnitude_upper();
  const scaled_interval size = modulus();
  return scale(to_magnitude(size.m.upper(), true), size.exponent);
}
magnitude region::magnitude_lower() const {
  if (!is_analytic()) return {};
  if (balls_ != nullptr) return balls_->magnitude_lower();
  const scaled_interval size = modulus();
  return scale(to_magnitude(size.m.lower(), false), size.exponent);
}

bool region::knows_modulus() const {
  return modulus_.lower() > 0 || modulus_.upper() < detail::infinity;
}

/// |z|, of a set in the hardware.
region::scaled_interval region::modulus() const {
  const double_interval of_rectangle = hypot(hardware_.re, hardware_.im);
  if (!knows_modulus()) return {of_rectangle, exponent_};
  const double_interval both = intersection(of_rectangle, modulus_);
  return {both.is_undefined() ? of_rectangle : both, exponent_};
}

region region::convex_hull() const {
  region r = *this;
  if (knows_modulus()) r.modulus_ = {0, modulus_.upper()};
  return r;
}

region region::with_modulus(const scaled_interval& m) && {
  if (!is_analytic() || !is_in_hardware() || m.m.is_undefined()) return std::move(*this);
  const double_interval own = hypot(hardware_.re, hardware_.im);
  const double_interval news = m.over(exponent_);
  const bool tells_more = news.lower() > own.lower() || news.upper() < own.upper();
  modulus_ = tells_more ? news : not_known;
  return std::move(*this);
}

double_interval region::re() const {
  return is_analytic() ? scale(hardware_.re, exponent_) : double_interval::undefined();
}
double_interval region::im() const {
  return is_analytic() ? scale(hardware_.im, exponent_) : double_interval::undefined();
}

/// f in hardware, with an exponent, or in balls where an operand is kept in them or the result leaves the hardware's
/// range: also where an end may have underflowed to 0, so that the set would seem to touch a pole or a
/// branch point. (What is made of sets that end at 0, or hold it, ends at 0 as a rule, and balls would not help; not
/// so exp of [-1000, 0]: `zero_is_news` where it may underflow.) An undefined result of operands without an obstacle is
/// retried too: it may come of infinity - infinity; if balls do no better, it is not analytic.
template <class Hardware, class Balls, class Scaled>
region region::combined(const region& z, const region& w, Hardware&& hardware, Balls&& balls,
                        const Scaled& scaled_form, bool zero_is_news) {
  if (!z.is_analytic()) return z;
  if (!w.is_analytic()) return w;
  if (z.is_in_hardware() && w.is_in_hardware()) {
    const bool zero_is_usual = touches_zero(z.hardware_) || touches_zero(w.hardware_);
    const auto suspicious = [&](const region& r, bool is_news) {
      return ends_at_zero(r.hardware_) && (is_news || !zero_is_usual);
    };
    if (z.exponent_ == 0 && w.exponent_ == 0) {
      region r;
      r.hardware_ = hardware(z.hardware_, w.hardware_);
      if (!is_undefined(r.hardware_) && !r.needs_balls() && !suspicious(r, zero_is_news)) {
        return r;
      }
    }
    if (const std::optional<scaled> s = scaled_form(scaled::of(z), scaled::of(w))) {
      std::optional<region> r = s->to_region();
      if (r && !suspicious(*r, false)) return *r;
    }
  }
  const bool keep_balls = z.precision() > ball_bits || w.precision() > ball_bits;
  return from_balls(balls(z.to_complex_ball(), w.to_complex_ball()), keep_balls);
}

/// The shapes of the functions below.
struct region::functions {
  /// f in hardware, in r, for operands and results that need nothing else: `combined` would do the same.
  template <class F>
  static bool quick(region& r, const region& z, const region& w, F&& f) {
    if (!z.is_moderate() || !w.is_moderate()) return false;
    r.hardware_ = f(z.hardware_, w.hardware_);
    return is_regular(r.hardware_) &&
           (!ends_at_zero(r.hardware_) || touches_zero(z.hardware_) || touches_zero(w.hardware_));
  }
  /// Whether the predicate holds of the set, in the form in which it is kept.
  template <class Predicate>
  static bool holds(const region& z, Predicate&& predicate) {
    if (z.is_in_hardware() && z.exponent_ == 0) return predicate(z.hardware_);
    return predicate(static_cast<const rectangle<ball>&>(z.to_complex_ball()));
  }
  /// f without singularities.
  template <class F, class Scaled>
  static region entire(const region& z, F&& f, const Scaled& scaled_form,
                       bool zero_is_news = false) {
    return combined(
        z, z, [&](const auto& x, const auto&) { return f(x); },
        [&](const complex_ball& x, const complex_ball&) { return complex_ball(f(x)); },
        [&](const scaled& x, const scaled&) { return scaled_form(x); }, zero_is_news);
  }
  /// r, a function of z and w, with what is known of its size from the sizes of z and w.
  template <class Size>
  static region sized(region r, const region& z, const region& w, Size&& size) {
    if (!z.knows_modulus() && !w.knows_modulus()) return r;
    if (!z.is_in_hardware() || !w.is_in_hardware()) return r;
    return std::move(r).with_modulus(size(z.modulus(), w.modulus()));
  }
  static scaled_interval size_of_product(const scaled_interval& x, const scaled_interval& y) {
    return {x.m * y.m, x.exponent + y.exponent};
  }
  static scaled_interval size_of_quotient(const scaled_interval& x, const scaled_interval& y) {
    return {x.m / y.m, x.exponent - y.exponent};
  }
  /// | |z| - |w| | <= |z +- w| <= |z| + |w|.
  static scaled_interval size_of_sum(const scaled_interval& x, const scaled_interval& y) {
    const long e = std::max(x.exponent, y.exponent);
    const double_interval a = x.over(e);
    const double_interval b = y.over(e);
    return {hull(abs(a - b), a + b), e};
  }
  /// By the scaled form, where the result may leave the hardware's range; nothing where that does not help.
  template <class Scaled>
  static std::optional<region> in_scale(const region& z, const Scaled& scaled_form) {
    if (!z.is_moderate()) return std::nullopt;
    const std::optional<scaled> s = scaled_form(scaled::of(z));
    std::optional<region> r = s ? s->to_region() : std::nullopt;
    if (r && ends_at_zero(r->hardware_) && !ends_at_zero(z.hardware_)) r.reset();
    return r;
  }
  static std::optional<scaled> without_scale(const scaled&) { return std::nullopt; }
  /// f where singular(z) is false, else blocked.
  template <class Singular, class F, class Scaled>
  static region away_from(const region& z, obstacle why, std::string_view name, Singular&& singular,
                          F&& f, const Scaled& scaled_form) {
    if (!z.is_analytic()) return z;
    if (holds(z, singular)) return blocked(why, name);
    return entire(z, f, scaled_form);
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
  region r = region::functions::entire(
      z, [](const auto& x) { return -x; },
      [](const region::scaled& x) -> std::optional<region::scaled> {
        return region::scaled{-x.m, x.exponent};
      });
  return region::functions::sized(std::move(r), z, z, [](const auto& x, const auto&) { return x; });
}
region operator+(const region& z, const region& w) {
  const auto f = [](const auto& x, const auto& y) { return x + y; };
  region quick;
  if (!region::functions::quick(quick, z, w, f)) {
    quick = region::combined(z, w, f, f, region::scaled::sum);
  }
  return region::functions::sized(std::move(quick), z, w, region::functions::size_of_sum);
}
region operator-(const region& z, const region& w) {
  const auto f = [](const auto& x, const auto& y) { return x - y; };
  region quick;
  if (!region::functions::quick(quick, z, w, f)) {
    quick = region::combined(z, w, f, f, region::scaled::difference);
  }
  return region::functions::sized(std::move(quick), z, w, region::functions::size_of_sum);
}
region operator*(const region& z, const region& w) {
  region quick;
  if (!region::functions::quick(quick, z, w, product)) {
    const auto f = [](const auto& x, const auto& y) { return x * y; };
    quick = region::combined(z, w, f, f, region::scaled::product);
  }
  return region::functions::sized(std::move(quick), z, w, region::functions::size_of_product);
}
region operator/(const region& z, const region& w) {
  if (!z.is_analytic()) return z;
  if (!w.is_analytic()) return w;
  if (region::functions::holds(w, [](const auto& x) { return possibly_singular::reciprocal(x); })) {
    // The rectangle holds 0, but not the set: 1/w lies in a disc.
    if (w.is_in_hardware() && w.modulus_.lower() > 0) {
      const double_interval size = 1 / w.modulus().m;
      const double_interval side(-size.upper(), size.upper());
      const std::optional<region> inverse =
          region::scaled{{side, side}, -w.exponent_, region::scaled_interval{size, -w.exponent_}}
              .to_region();
      if (inverse) return z * *inverse;
    }
    return region::blocked(obstacle::pole, "/");
  }
  region quick;
  if (!region::functions::quick(quick, z, w, quotient)) {
    const auto f = [](const auto& x, const auto& y) { return x / y; };
    quick = region::combined(z, w, f, f, region::scaled::quotient);
  }
  return region::functions::sized(std::move(quick), z, w, region::functions::size_of_quotient);
}

region square(const region& z) {
  region quick;
  if (!region::functions::quick(quick, z, z,
                                [](const auto& x, const auto&) { return square(x); })) {
    quick =
        region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(square), region::scaled::square);
  }
  return region::functions::sized(std::move(quick), z, z, region::functions::size_of_product);
}

/// size e^(i angle).
region region::rotating(double_interval size, double_interval angle) {
  const auto [sine, cosine] = sin_cos(angle);
  region r;
  r.hardware_ = {times(size, cosine), times(size, sine)};
  return std::move(r).with_modulus({size, 0});
}
region exp(const region& z) {
  // Far from overflow and underflow the hardware's operations do.
  if (z.is_moderate() && z.hardware_.re.magnitude() < region::moderate_exponent) {
    return region::rotating(exp(z.hardware_.re), z.hardware_.im);
  }
  const auto scaled_form = [](const region::scaled& x) { return region::scaled::exp(x); };
  if (auto r = region::functions::in_scale(z, scaled_form)) return *std::move(r);
  return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(exp), scaled_form,
                                   z.hardware_.re.lower() < -region::moderate_exponent);
}

region cosh(const region& z) {
  if (z.is_moderate() && z.hardware_.re.magnitude() < region::moderate_exponent) {
    return region::hyperbolic(z.hardware_.re, z.hardware_.im, true);
  }
  if (auto r = region::functions::in_scale(z, region::scaled::cosh)) return *std::move(r);
  return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(cosh), region::scaled::cosh);
}
region sinh(const region& z) {
  if (z.is_moderate() && z.hardware_.re.magnitude() < region::moderate_exponent) {
    return region::hyperbolic(z.hardware_.re, z.hardware_.im, false);
  }
  if (auto r = region::functions::in_scale(z, region::scaled::sinh)) return *std::move(r);
  return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(sinh), region::scaled::sinh);
}
// cos z = cosh(iz), sin z = -i sinh(iz).
region cos(const region& z) {
  if (z.is_moderate() && z.hardware_.im.magnitude() < region::moderate_exponent) {
    return region::hyperbolic(-z.hardware_.im, z.hardware_.re, true);
  }
  if (auto r = region::functions::in_scale(z, region::scaled::cos)) return *std::move(r);
  return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(cos), region::scaled::cos);
}
region sin(const region& z) {
  if (z.is_moderate() && z.hardware_.im.magnitude() < region::moderate_exponent) {
    region s = region::hyperbolic(-z.hardware_.im, z.hardware_.re, false);
    s.hardware_ = {s.hardware_.im, -s.hardware_.re};
    return s;
  }
  if (auto r = region::functions::in_scale(z, region::scaled::sin)) return *std::move(r);
  return region::functions::entire(z, POLHODE_RECTANGLE_FUNCTION(sin), region::scaled::sin);
}

/// cosh(x + iy) or sinh(x + iy), as in `scaled`.
region region::hyperbolic(double_interval x, double_interval y, bool is_cosh) {
  const auto [s, c] = real_set<double_interval>::sinh_cosh(x);
  const auto [sine, cosine] = sin_cos(y);
  region r;
  if (is_cosh) {
    r.hardware_ = {times(c, cosine), times(s, sine)};
  } else {
    r.hardware_ = {times(s, cosine), times(c, sine)};
  }
  if (s.mignitude() == 0) return r;  // nothing is known that is worth its keeping
  return std::move(r).with_modulus({hull(abs(s), c), 0});
}

#define POLHODE_AWAY_FROM(f, why)                                                  \
  region f(const region& z) {                                                      \
    return region::functions::away_from(z, obstacle::why, #f, POLHODE_SINGULAR(f), \
                                        POLHODE_RECTANGLE_FUNCTION(f),             \
                                        region::functions::without_scale);         \
  }
region sqrt(const region& z) {
  return region::functions::away_from(z, obstacle::branch_cut, "sqrt", POLHODE_SINGULAR(sqrt),
                                      POLHODE_RECTANGLE_FUNCTION(sqrt), region::scaled::sqrt);
}
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
  if (n < 0 && n > -(1L << 60) && z.is_in_hardware() && z.modulus_.lower() > 0) {
    return 1 / pow(z, -n);  // which is defined where the rectangle holds 0, but not the set
  }
  constexpr long most = 1L << 20;  // so that exponents do not overflow
  const auto scaled_form = [&](const region::scaled& x) { return region::scaled::pow(x, n); };
  std::optional<region> in_scale;
  if (n > 0 && n < most && z.is_moderate() && leaves_range(z.hardware_, n)) {
    in_scale = region::functions::in_scale(z, scaled_form);
  }
  region r = in_scale ? *std::move(in_scale)
                      : region::functions::away_from(
                            z, obstacle::pole, "pow",
                            [&](const auto& x) { return possibly_singular::pow(x, n); },
                            [&](const auto& x) { return pow(x, n); }, scaled_form);
  if (n < -most || n > most) return r;
  return region::functions::sized(std::move(r), z, z, [n](const auto& x, const auto&) {
    return region::scaled_interval{pow(x.m, n), x.exponent * n};
  });
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
