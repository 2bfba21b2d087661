#include "polhode/elliptic/carlson.hpp"

#include "elliptic/carlson_points.hpp"
#include "elliptic/enclose.hpp"

namespace polhode {
namespace {

template <class... Balls>
precision greatest_precision_of(const Balls&... x) {
  return std::max({precision_of(x)...});
}

/// x, y, z >= 0, and at most one of them may be 0.
bool in_domain(const ball& x, const ball& y, const ball& z) {
  const int zeros = (certainly_positive(x) ? 0 : 1) + (certainly_positive(y) ? 0 : 1) +
                    (certainly_positive(z) ? 0 : 1);
  return zeros <= 1 && detail::not_negative(x) && detail::not_negative(y) &&
         detail::not_negative(z);
}

/// The functions of numbers, as enclosures with p bits.
template <std::size_t Count, class F>
auto enclosed(precision p, const F& f) {
  return [p, &f](const std::array<ball, Count>& x) {
    return detail::to_accuracy(p, [&](precision q) {
      std::array<ball, Count> raised;
      for (std::size_t i = 0; i < Count; ++i)
        raised[i] = x[i].with_precision(std::max(q, x[i].precision()));
      return f(raised, q);
    });
  };
}

/// Principal values, over balls with p < 0: the formula of rj_at in balls.
ball principal_rj(const ball& x, const ball& y, const ball& z, const ball& p) {
  const ball s = -p;
  // Any of x, y, z can take the place of the middle one where r > 0.
  const std::array<std::array<const ball*, 3>, 3> orders{
      {{&x, &y, &z}, {&y, &x, &z}, {&x, &z, &y}}};
  ball best = ball::undefined(greatest_precision_of(x, y, z, p));
  for (const auto& order : orders) {
    const ball& a = *order[0];
    const ball& b = *order[1];
    const ball& c = *order[2];
    if (!certainly_positive(b)) continue;
    const ball above = (c - b) * (b - a) / (b + s);
    const ball r = b + above;
    if (!certainly_positive(r)) continue;
    const ball rs = r * s;
    const ball sum = a * c + rs;
    const ball value = (above * carlson_rj(a, b, c, r) - 3 * carlson_rf(a, b, c) +
                        3 * sqrt(a * b * c / sum) * carlson_rc(sum, rs)) /
                       (b + s);
    if (value.is_undefined()) continue;
    best = best.is_undefined() ? value : intersection(best, value);
  }
  return best;
}

}  // namespace

ball carlson_rf(const ball& x, const ball& y, const ball& z) {
  const precision p = greatest_precision_of(x, y, z);
  if (!in_domain(x, y, z)) return ball::undefined(p);
  return detail::homogeneous_range<3>({x, y, z}, {-1, -1, -1}, 1, p,
                                      enclosed<3>(p, [](const std::array<ball, 3>& a, precision q) {
                                        return detail::rf_at(a[0], a[1], a[2], q);
                                      }));
}

ball carlson_rc(const ball& x, const ball& y) {
  const precision p = greatest_precision_of(x, y);
  if (!detail::not_negative(x) || (!certainly_positive(y) && !certainly_negative(y))) {
    return ball::undefined(p);
  }
  if (certainly_negative(y)) {
    const ball sum = x - y;
    return sqrt(x / sum) * carlson_rc(sum, -y);
  }
  return detail::homogeneous_range<2>({x, y}, {-1, -1}, 1, p,
                                      enclosed<2>(p, [](const std::array<ball, 2>& a, precision q) {
                                        return detail::rc_at(a[0], a[1], q);
                                      }));
}

ball carlson_rj(const ball& x, const ball& y, const ball& z, const ball& p) {
  const precision bits = greatest_precision_of(x, y, z, p);
  if (!in_domain(x, y, z)) return ball::undefined(bits);
  const auto of_numbers = enclosed<4>(bits, [](const std::array<ball, 4>& a, precision q) {
    return detail::rj_at(a[0], a[1], a[2], a[3], q);
  });
  if (certainly_negative(p)) {
    if (x.is_exact() && y.is_exact() && z.is_exact() && p.is_exact())
      return of_numbers({x, y, z, p});
    return principal_rj(x, y, z, p);
  }
  if (!certainly_positive(p)) return ball::undefined(bits);
  return detail::homogeneous_range<4>({x, y, z, p}, {-1, -1, -1, -1}, 3, bits, of_numbers);
}

carlson_pair carlson_rf_rj(const ball& x, const ball& y, const ball& z, const ball& p) {
  const precision bits = greatest_precision_of(x, y, z, p);
  const std::array<ball, 4> arguments{x, y, z, p};
  const magnitude r = detail::greatest_relative_radius(arguments);
  std::optional<ball> rf;
  if (in_domain(x, y, z) && certainly_positive(p) &&
      (r.is_zero() || r <= magnitude::power_of_two(std::min<long>(10 - bits, -2)))) {
    // As homogeneous_range does for each alone.
    const ball rj = detail::to_accuracy(bits, [&](precision q) {
      const auto raised = [q](const ball& a) {
        return a.middle().with_precision(std::max(q, a.precision()));
      };
      return detail::rj_at(raised(x), raised(y), raised(z), raised(p), q, &rf);
    });
    const auto grown = [&](const ball& value, std::uint64_t steepness) {
      return value.enlarged(multiply_up(multiply_up(r, magnitude::from_integer_up(steepness)),
                                        value.magnitude_upper()));
    };
    const ball found = rf ? rf->with_precision(bits) : ball::undefined(bits);
    return {rf && scale(found.radius(), bits - 1) <= found.magnitude_lower() ? grown(found, 1)
                                                                             : carlson_rf(x, y, z),
            grown(rj, 3)};
  }
  return {carlson_rf(x, y, z), carlson_rj(x, y, z, p)};
}

ball carlson_rd(const ball& x, const ball& y, const ball& z) {
  const precision p = greatest_precision_of(x, y, z);
  if (!in_domain(x, y, z) || !certainly_positive(z)) return ball::undefined(p);
  return detail::homogeneous_range<3>({x, y, z}, {-1, -1, -1}, 3, p,
                                      enclosed<3>(p, [](const std::array<ball, 3>& a, precision q) {
                                        return detail::rd_at(a[0], a[1], a[2], q);
                                      }));
}

ball carlson_rg(const ball& x, const ball& y, const ball& z) {
  const precision p = greatest_precision_of(x, y, z);
  if (!detail::not_negative(x) || !detail::not_negative(y) || !detail::not_negative(z)) {
    return ball::undefined(p);
  }
  return detail::homogeneous_range<3>({x, y, z}, {1, 1, 1}, 1, p,
                                      enclosed<3>(p, [](const std::array<ball, 3>& a, precision q) {
                                        return detail::rg_at(a[0], a[1], a[2], q);
                                      }));
}

// ---------------------------------------------------------------------------------------------
// Numbers without radii.

namespace {

constexpr precision carlson_guard_bits = 48;

/// f at the numbers with guard bits, rounded to the greatest precision among them.
template <class F, class... Numbers>
mpfr_float rounded(const F& f, const Numbers&... x) {
  const precision p = greatest_precision_of(x...);
  return detail::raised(f(detail::raised(x, p + carlson_guard_bits)..., p + carlson_guard_bits), p);
}
template <class F, class... Numbers>
double in_long_double(const F& f, Numbers... x) {
  return static_cast<double>(f(static_cast<long double>(x)..., detail::long_double_bits));
}

constexpr auto by_rf = [](const auto& x, const auto& y, const auto& z, precision q) {
  return detail::rf_at(x, y, z, q);
};
constexpr auto by_rc = [](const auto& x, const auto& y, precision q) {
  return detail::rc_point(x, y, q);
};
constexpr auto by_rj = [](const auto& x, const auto& y, const auto& z, const auto& p, precision q) {
  return detail::rj_at(x, y, z, p, q);
};
constexpr auto by_rd = [](const auto& x, const auto& y, const auto& z, precision q) {
  return detail::rd_at(x, y, z, q);
};
constexpr auto by_rg = [](const auto& x, const auto& y, const auto& z, precision q) {
  return detail::rg_at(x, y, z, q);
};

}  // namespace

mpfr_float carlson_rf(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z) {
  return rounded(by_rf, x, y, z);
}
mpfr_float carlson_rc(const mpfr_float& x, const mpfr_float& y) { return rounded(by_rc, x, y); }
mpfr_float carlson_rj(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z,
                      const mpfr_float& p) {
  return rounded(by_rj, x, y, z, p);
}
mpfr_float carlson_rd(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z) {
  return rounded(by_rd, x, y, z);
}
mpfr_float carlson_rg(const mpfr_float& x, const mpfr_float& y, const mpfr_float& z) {
  return rounded(by_rg, x, y, z);
}

double carlson_rf(double x, double y, double z) { return in_long_double(by_rf, x, y, z); }
double carlson_rc(double x, double y) { return in_long_double(by_rc, x, y); }
double carlson_rj(double x, double y, double z, double p) {
  return in_long_double(by_rj, x, y, z, p);
}
double carlson_rd(double x, double y, double z) { return in_long_double(by_rd, x, y, z); }
double carlson_rg(double x, double y, double z) { return in_long_double(by_rg, x, y, z); }

// ---------------------------------------------------------------------------------------------
// Derivatives, by differentiating the integrals of the header.

std::array<ball, 3> carlson_rf_gradient(const ball& x, const ball& y, const ball& z) {
  return {-carlson_rd(y, z, x) / 6, -carlson_rd(z, x, y) / 6, -carlson_rd(x, y, z) / 6};
}

// In x: -R_D(y,y,x)/6. In y, from R_F(x,y,z) at z = y: -R_D(x,y,y)/3.
std::array<ball, 2> carlson_rc_gradient(const ball& x, const ball& y) {
  const precision p = greatest_precision_of(x, y);
  if (certainly_positive(y)) return {-carlson_rd(y, y, x) / 6, -carlson_rd(x, y, y) / 3};
  // C = R_C solves 2 (y-x) dC/dx = C - 1/sqrt x, by its closed forms, and is homogeneous of degree
  // -1/2.
  if (!certainly_negative(y) || !certainly_positive(x))
    return {ball::undefined(p), ball::undefined(p)};
  const ball value = carlson_rc(x, y);
  const ball in_x = (value - 1 / sqrt(x)) / (2 * (y - x));
  return {in_x, -(value / 2 + x * in_x) / y};
}

// 1/((t+x)(t+p)) = (1/(t+x) - 1/(t+p))/(p-x) under the integral; in p by homogeneity.
std::array<ball, 4> carlson_rj_gradient(const ball& x, const ball& y, const ball& z,
                                        const ball& p) {
  const ball value = carlson_rj(x, y, z, p);
  const auto in = [&](const ball& first, const ball& second, const ball& third) {
    return (value - carlson_rd(second, third, first)) / (2 * (p - first));
  };
  const ball in_x = in(x, y, z);
  const ball in_y = in(y, z, x);
  const ball in_z = in(z, x, y);
  return {in_x, in_y, in_z, -(3 * value / 2 + x * in_x + y * in_y + z * in_z) / p};
}

std::array<ball, 3> carlson_rd_gradient(const ball& x, const ball& y, const ball& z) {
  const ball value = carlson_rd(x, y, z);
  const ball in_x = (value - carlson_rd(y, z, x)) / (2 * (z - x));
  const ball in_y = (value - carlson_rd(z, x, y)) / (2 * (z - y));
  return {in_x, in_y, -(3 * value / 2 + x * in_x + y * in_y) / z};
}

// (1/8) int t/(t+x) dt/sqrt(...) = (R_F - x R_D(y,z,x)/3)/4, and 3 R_F = x R_D(y,z,x) + y
// R_D(z,x,y) + z R_D(x,y,z).
std::array<ball, 3> carlson_rg_gradient(const ball& x, const ball& y, const ball& z) {
  const ball in_x = x * carlson_rd(y, z, x);
  const ball in_y = y * carlson_rd(z, x, y);
  const ball in_z = z * carlson_rd(x, y, z);
  return {(in_y + in_z) / 12, (in_z + in_x) / 12, (in_x + in_y) / 12};
}

}  // namespace polhode
