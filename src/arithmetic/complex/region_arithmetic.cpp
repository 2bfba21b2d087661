// Sums, products, quotients and powers of regions.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "arithmetic/complex/region_shapes.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode {

using namespace detail::regions;

namespace {

// Products and quotients of rectangles, of which one often is real or touches the real axis: what 0
// adds to a product is 0 exactly, and need not be computed.

bool is_real(const hardware_rectangle& z) { return z.im.lower() == 0 && z.im.upper() == 0; }

hardware_rectangle rectangle_product(const hardware_rectangle& z, const hardware_rectangle& w) {
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

/// x / (x^2 + y^2), the real part of 1/(x + iy), over a rectangle without 0. It is odd in x; for x
/// > 0 it falls with |y|, and with x rises up to x = |y| and falls from there: its least value is
/// at the greatest |y| and an end of x, its greatest at the least |y| and the x nearest to that.
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
  return rectangle_product(z,
                           {real_part_of_inverse(w.re, w.im), -real_part_of_inverse(w.im, w.re)});
}

}  // namespace

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
  if (!region::functions::quick(quick, z, w, rectangle_product)) {
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
    quick = region::functions::entire(
        z, [](const auto& x) { return square(x); }, region::scaled::square);
  }
  return region::functions::sized(std::move(quick), z, z, region::functions::size_of_product);
}

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

}  // namespace polhode
