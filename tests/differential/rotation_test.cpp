// Free rotation by different routes: phases and periods by quadrature, momenta by Jacobi's
// functions, what is conserved.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "integrals.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/body_box.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "polhode/rigid_body/principal_axes.hpp"
#include "polhode/rigid_body/rotor.hpp"

namespace polhode::differential {
namespace rotation_test {

const term x = "x";

/// A body with short numbers a and b.
struct drawn_body {
  term a = 0;
  term b = 0;
  body rigid;
};
rational exact(const term& t) { return *read(t).exact_value(); }

drawn_body draw_body(maker& m) {
  const term a = m.rational_near(m.scattered(0.02, 5));
  term b = m.rational_near(m.within(0.02, 0.95));
  if (!(exact(b) < 1) || !(exact(b) > 0)) b = "1/3";
  return {a, b, body(exact(a), exact(b))};
}

/// A motion c in (-b, a), rarely very near an end or the separatrix.
term draw_motion(maker& m, const drawn_body& d, bool oscillating) {
  const term fraction =
      m.one_in(4) ? m.decimal(m.scattered(1e-15, 0.1)) : m.quotient(m.within(0.05, 0.95));
  term part = m.one_in(2) ? fraction : 1 - fraction;
  if (!(exact(part) > 0) || !(exact(part) < 1)) part = "1/2";  // a quotient near 0.95 may be 1
  return oscillating ? -(d.b * part) : d.a * part;
}

void compare(const ball& v, const ball& w, const std::string& first, const std::string& second,
             counts& c) {
  if (!v.is_bounded() || !w.is_bounded()) return;
  ++c.checks;
  if (overlaps(v, w)) return;
  ++c.wrong;
  ADD_FAILURE() << "the enclosures are disjoint\n  " << first << "\n    " << to_decimal(v, 30)
                << "\n  " << second << "\n    " << to_decimal(w, 30);
}

/// The phase is twice the integral of (1 - b x)/sqrt(x (1-x) (a + b x) (c + b x)) from 0 or -c/b to
/// 1.
TEST(rotation, montgomery_phase_by_quadrature) {
  run_cases("rotation", "phases", 120, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const drawn_body d = draw_body(m);
    const bool oscillating = m.one_in(2);
    const term motion = draw_motion(m, d, oscillating);
    if (exact(motion) == 0) return;  // on the separatrix, by rounding
    const std::string command = fmt::format("polhode phase --ab \"{},{}\" --c \"{}\"", d.a.text(),
                                            d.b.text(), motion.text());
    under_way(command);
    ++c.cases;
    ++c.computed;
    const precision p = m.between(30, 200);
    const ball phase = montgomery_phase(d.rigid, exact(motion), p);
    ++(phase.is_bounded() ? c.certified : c.refused);
    compare(phase, montgomery_phase(d.rigid, exact(motion), p + 100), command, "more bits", c);
    const term radicand = x * (1 - x) * (d.a + d.b * x) * (motion + d.b * x);
    const piece by_quadrature{(1 - d.b * x) / call("sqrt", radicand),
                              oscillating ? -motion / d.b : term(0), 1, m.between(5, 20)};
    ++c.computed;
    compare(phase, 2 * computed(by_quadrature).enclosure, command,
            "twice " + command_of(by_quadrature), c);
    const ball period = rotation_period(d.rigid, exact(motion), p);
    const piece as_period{1 / call("sqrt", radicand), by_quadrature.from, 1, 12};
    ++c.computed;
    compare(period, 2 * computed(as_period).enclosure, "the period of " + command,
            "twice " + command_of(as_period), c);
    compare(phase,
            dynamic_phase(d.rigid, exact(motion), p) + geometric_phase(d.rigid, exact(motion), p),
            command, "its two parts", c);
    const rotor<ball> r(initial_state::at_middle_of_twist(d.rigid, exact(motion)), p);
    if (r.period()) compare(*r.period(), period, "the rotor's period", "the period", c);
    if (r.phase_per_period()) {
      compare(*r.phase_per_period(), phase, "the rotor's phase", "the phase", c);
    }
  });
}

/// The ranges over a box of bodies and motions hold the numbers of a member, by quadrature; and
/// F(0, sin^2 epsilon0) = 2 pi, in closed form, and F(c0, 0) = 2 pi for a number in the range.
TEST(rotation, ranges_over_boxes) {
  run_cases("rotation", "boxes", 120, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const drawn_body d = draw_body(m);
    const term motion = draw_motion(m, d, m.one_in(2));
    const rational a = exact(d.a);
    const rational b = exact(d.b);
    const rational at = exact(motion);
    if (at == 0) return;
    // Each end is the member's own number or beyond it.
    const auto beside = [&] {
      return m.one_in(3) ? rational(0) : rational(m.between(1, 300), m.one_in(2) ? 1000 : 1000000);
    };
    const auto around = [&](const rational& x) {
      const rational below = abs(x) * beside();
      return rational_range{x - below, x + abs(x) * beside()};
    };
    rational_range in_b = around(b);
    in_b.high = std::min(in_b.high, rational((1 + b) / 2));
    const body_box box(around(a), in_b);
    const rational_range motions = around(at);
    const std::string command =
        fmt::format("the ranges over a = {}..{}, b = {}..{}, c = {}..{}", to_text(box.a().low),
                    to_text(box.a().high), to_text(box.b().low), to_text(box.b().high),
                    to_text(motions.low), to_text(motions.high));
    under_way(command);
    ++c.cases;
    const precision p = m.between(60, 200);
    const term radicand = x * (1 - x) * (d.a + d.b * x) * (motion + d.b * x);
    const term from = at < 0 ? -motion / d.b : term(0);
    const piece phase{(1 - d.b * x) / call("sqrt", radicand), from, 1, m.between(5, 20)};
    const piece period{1 / call("sqrt", radicand), from, 1, m.between(5, 20)};
    c.computed += 2;
    const ball of_phase = computed(phase).enclosure;
    const ball of_period = computed(period).enclosure;
    compare(box.montgomery_phase(motions, p), 2 * of_phase, command, command_of(phase), c);
    compare(box.period(motions, p), 2 * of_period, command, command_of(period), c);
    compare(box.mean_rate(motions, p), of_phase / of_period, command, "their quotient", c);
    const ball epsilon0 = box.separatrix_defect(20);
    ++(epsilon0.is_bounded() ? c.certified : c.refused);
    const ball u = square(sin(epsilon0));
    const ball w = sqrt((1 - u) / (a + b * u));
    const ball root = sqrt(ball(a, p));
    compare(2 / sqrt(ball(rational(a * b), p)) * atanh(root * w) - 2 * atan(sqrt(ball(b, p)) * w),
            2 * pi(p), command, "2 pi, as F at the range of epsilon0", c);
    const ball c0 = box.perfect_twist(20);
    if (!c0.is_bounded()) return;
    // F falls with c: it is 2 pi or more at the lower end of the range, and no more at the upper.
    const auto half_phase = [&](const rational& end) {
      const term e("(" + to_text(end) + ")");
      ++c.computed;
      return computed({(1 - d.b * x) / call("sqrt", x * (1 - x) * (d.a + d.b * x) * (e + d.b * x)),
                       term(0), 1, 10})
          .enclosure;
    };
    const ball most = half_phase(lower_rational(c0));
    const ball least = half_phase(upper_rational(c0));
    if (most.is_bounded() && least.is_bounded()) {
      compare(hull(least, most), 2 * pi(p), command, "2 pi, as F at the range of c0", c);
    }
  });
}

/// The ranges over cells of the limit a -> infinity, b -> 0 hold a member whose defect is pi/2 -
/// psi for a psi that was drawn: chi is the square of xi/pi, with xi by quadrature from 0 to psi,
/// or to the turning point, where sin^2 = 1 + beta, and back.
TEST(rotation, ranges_over_limits) {
  run_cases("rotation", "cells of the limit", 120, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const term beta = m.one_in(2) ? m.decimal(m.within(-0.98, -0.01)) : m.decimal(m.within(0, 2));
    const bool turns = exact(beta) < 0;
    const double most = turns ? std::asin(std::sqrt(1 + static_cast<double>(exact(beta)))) : 1.7;
    const term psi = m.decimal(m.within(0.02, 0.98) * most);
    // A decimal near the turning point may be beyond it.
    const rational beta_here = exact(beta);
    if (turns &&
        !certainly_less(sin(ball(exact(psi), 64)), sqrt(ball(rational(1 + beta_here), 64)))) {
      return;
    }
    const bool beyond = turns && m.one_in(2);
    const piece before{1 / call("sqrt", beta + power(call("cos", x), 2)), 0, psi, 20};
    ball xi = computed(before).enclosure;
    ++c.computed;
    if (beyond) {
      const piece quarter{1 / call("sqrt", 1 - (1 + beta) * power(call("sin", x), 2)), 0,
                          term("pi") / 2, 20};
      xi = 2 * computed(quarter).enclosure - xi;
      ++c.computed;
    }
    if (!xi.is_bounded()) return;
    const ball chi = square(xi / pi(128));
    const auto beside = [&] {
      return m.one_in(3) ? rational(0) : rational(m.between(1, 300), m.one_in(2) ? 1000 : 1000000);
    };
    const rational_range in_chi{lower_rational(chi) * (1 - beside()),
                                upper_rational(chi) * (1 + beside())};
    const rational_range in_beta{std::max(rational(beta_here - beside()), rational(-999, 1000)),
                                 beta_here + beside()};
    const std::string command =
        fmt::format("the limit over chi = {}..{}, beta = {}..{}", to_decimal(chi, 10),
                    to_text(rational(in_chi.high)), to_text(in_beta.low), to_text(in_beta.high));
    under_way(command);
    ++c.cases;
    const ball range = limit_defect_range(in_chi, in_beta, 20);
    ++(range.is_bounded() ? c.certified : c.refused);
    compare(range, scale(pi(128), -1) - exact(psi), command, command_of(before), c);
  });
}

/// The moments of a tensor that is a number beside a block [[p, r], [r, q]]: the number, and (p + q
/// -+ sqrt((p - q)^2 + 4 r^2))/2. So a and b are formulas, and each number of the body has one.
TEST(rotation, bodies_with_irrational_moments) {
  run_cases("rotation", "irrational bodies", 120, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const auto entry = [&] { return m.rational_near(m.within(0.5, 4)); };
    const term own = entry();
    const term p = entry();
    const term q = entry();
    const term r = m.rational_near(m.one_in(3) ? m.scattered(1e-12, 0.1) : m.within(0.05, 0.9));
    const std::string tensor =
        fmt::format("{},{},{},0,0,{}", own.text(), p.text(), q.text(), r.text());
    const body rigid = [&]() -> body {
      try {
        return body::from_inertia_tensor({exact(own), exact(p), exact(q), 0, 0, exact(r)});
      } catch (const input_error&) {  // not positive definite, or a symmetric top
        return {1, rational(1, 2)};
      }
    }();
    if (!rigid.irrational_tensor()) return;
    const term root = call("sqrt", (p - q) * (p - q) + 4 * r * r);
    const term above = (p + q + root) / 2;
    const term below = (p + q - root) / 2;
    const precision bits = m.between(30, 200);
    std::vector<term> moments{own, above, below};
    std::sort(moments.begin(), moments.end(), [](const term& left, const term& right) {
      return certainly_less(read(right).value(400), read(left).value(400));
    });
    const term a = moments[1] / moments[2] - 1;
    const term b = 1 - moments[1] / moments[0];
    const std::string command = fmt::format("polhode phase --tensor \"{}\"", tensor);
    under_way(command);
    ++c.cases;
    const auto meets = [&](const ball& v, const term& formula, const char* what) {
      ++c.computed;
      compare(v, read(formula).value(bits + 100), fmt::format("{} of {}", what, command),
              formula.text(), c);
    };
    meets(rigid.a().at(bits), a, "a");
    meets(rigid.b().at(bits), b, "b");
    meets(rigid.geometric_constant(bits), (1 - b) / call("sqrt", b * (a + b)), "I");
    meets(rigid.second_geometric_constant(bits), (a + 1) / call("sqrt", a * (a + b)) - 1, "J");
    if (const auto square = rigid.square_of_geometric_constant().as_rational()) {
      meets(ball(*square, bits), (1 - b) * (1 - b) / (b * (a + b)), "the rational I^2");
    }
    if (const auto square = rigid.square_of_second_constant().as_rational()) {
      meets(ball(*square, bits), (a + 1) * (a + 1) / (a * (a + b)), "the rational (J + 1)^2");
    }
    // The phase and the period by quadrature of what they are in a, b and c.
    const bool oscillating = m.one_in(2);
    const rational share(m.between(1, 99), 100);
    const rational motion(oscillating ? rational(-rational_below(rigid.b(), 12) * share)
                                      : rational(rational_below(rigid.a(), 12) * share));
    const term at("(" + to_text(motion) + ")");
    const term radicand = x * (1 - x) * (a + b * x) * (at + b * x);
    const piece by_quadrature{(1 - b * x) / call("sqrt", radicand), oscillating ? -at / b : term(0),
                              1, m.between(5, 20)};
    ++c.computed;
    const ball phase = montgomery_phase(rigid, motion, bits);
    ++(phase.is_bounded() ? c.certified : c.refused);
    compare(phase, 2 * computed(by_quadrature).enclosure, command + " --c " + to_text(motion),
            "twice " + command_of(by_quadrature), c);
    compare(phase, montgomery_phase(rigid, motion, bits + 100), command, "more bits", c);
    compare(phase, dynamic_phase(rigid, motion, bits) + geometric_phase(rigid, motion, bits),
            command, "its two parts", c);
  });
}

using vector = std::array<rational, 3>;

/// Of the entries xx, yy, zz, xy, xz, yz.
constexpr std::array<std::pair<int, int>, 6> places{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

rational power_of_ten(long n) {
  const integer power = pow(integer(10), static_cast<unsigned>(std::abs(n)));
  return n < 0 ? rational(1, power) : rational(power);
}

/// A rotation by a quaternion of short whole numbers: its columns are rational.
std::array<vector, 3> draw_rotation(maker& m) {
  for (;;) {
    const rational w(m.between(-9, 9));
    const rational i(m.between(-9, 9));
    const rational j(m.between(-9, 9));
    const rational k(m.one_in(3) ? 0 : m.between(-9, 9));
    const rational n = w * w + i * i + j * j + k * k;
    if (n == 0) continue;
    return {vector{(w * w + i * i - j * j - k * k) / n, 2 * (i * j + w * k) / n,
                   2 * (i * k - w * j) / n},
            vector{2 * (i * j - w * k) / n, (w * w - i * i + j * j - k * k) / n,
                   2 * (j * k + w * i) / n},
            vector{2 * (i * k + w * j) / n, 2 * (j * k - w * i) / n,
                   (w * w - i * i - j * j + k * k) / n}};
  }
}
/// The sum of the moments times the projectors onto the columns: xx, yy, zz, xy, xz, yz.
std::array<rational, 6> turned_tensor(const vector& moments, const std::array<vector, 3>& axes) {
  std::array<rational, 6> t;
  for (std::size_t e = 0; e < 6; ++e) {
    for (std::size_t i = 0; i < 3; ++i) {
      t.at(e) +=
          moments.at(i) * axes.at(i).at(places.at(e).first) * axes.at(i).at(places.at(e).second);
    }
  }
  return t;
}

/// Tensors R D R^T with rational R and D of which the moments, the axes, the kind and the nearest
/// physical tensor are known: moments far apart, very near each other, equal, planar and
/// non-physical ones.
TEST(rotation, tensors_in_turned_frames) {
  run_cases("rotation", "tensors in turned frames", 300, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const rational scale = m.one_in(3) ? power_of_ten(m.between(-300, 300)) : rational(1);
    const auto positive = [&] { return exact(m.rational_near(m.scattered(0.01, 10))); };
    vector d{positive(), positive(), positive()};
    if (m.one_in(3)) d[1] = d[0] + m.between(-1, 1) * power_of_ten(-m.between(3, 60));
    if (m.one_in(5)) d[2] = rational(d[0] + d[1]);  // planar
    for (rational& moment : d) moment = rational(abs(moment) * scale);
    const auto rotation = draw_rotation(m);
    const auto tensor = turned_tensor(d, rotation);
    std::string command = "polhode body --tensor \"";
    for (const rational& entry : tensor) command += to_text(entry) + ",";
    command.back() = '"';
    under_way(command);
    ++c.cases;
    std::array<std::size_t, 3> order{0, 1, 2};
    std::ranges::sort(order, [&](std::size_t x, std::size_t y) { return d.at(x) > d.at(y); });
    const auto expect = [&](bool holds, const std::string& what) {
      ++c.checks;
      if (holds) return;
      ++c.wrong;
      ADD_FAILURE() << what << " of " << command;
    };
    const principal_axes found(tensor);
    ++c.computed;
    ++c.certified;
    const bool differ = d[0] != d[1] && d[1] != d[2] && d[0] != d[2];
    const rational margin = d.at(order[1]) + d.at(order[2]) - d.at(order[0]);
    expect(found.kind() == (margin > 0    ? body_kind::physical
                            : margin == 0 ? body_kind::planar
                                          : body_kind::non_physical),
           "the kind");
    expect(found.margin().as_rational() == margin, "the margin");
    expect(found.rigid().has_value() == differ, "the body");
    const precision p = m.between(40, 300);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t own = order.at(i);
      expect(found.moments().at(i).as_rational() == d.at(own), fmt::format("moment {}", i));
      const auto axis = found.axis(i, p);
      const auto projector = found.projector(i);
      if (!differ) continue;
      const vector& column = rotation.at(own);
      const int sign = contains(axis[0], column[0]) && contains(axis[1], column[1]) &&
                               contains(axis[2], column[2])
                           ? 1
                           : -1;
      for (std::size_t k = 0; k < 3; ++k) {
        expect(contains(axis.at(k), rational(sign * column.at(k))), fmt::format("axis {}", i));
        expect(projector.at(k).as_rational() == column.at(k) * column.at(k), "a projector");
      }
    }
    const auto nearest = nearest_physical(found);
    expect(nearest.has_value() == (margin < 0), "whether there is a nearest physical tensor");
    if (!nearest || !differ) return;
    vector moved = d;
    moved.at(order[0]) += margin / 3;
    moved.at(order[1]) -= margin / 3;
    moved.at(order[2]) -= margin / 3;
    const auto expected = turned_tensor(moved, rotation);
    for (std::size_t e = 0; e < 6; ++e) {
      expect(nearest->tensor.at(e).as_rational() == expected.at(e), "the nearest physical tensor");
    }
    expect(overlaps(nearest->distance(p), ball(rational(-margin), p) / sqrt(ball(3, p))),
           "the distance");
  });
}

/// Any symmetric tensors, whose moments and axes are irrational as a rule: T v = I v, v_i v_j is 0
/// or 1, the determinant is 1, and the moments are those of the same tensor in a turned frame.
TEST(rotation, axes_of_any_tensors) {
  run_cases("rotation", "axes of any tensors", 300, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    std::array<rational, 6> t;
    for (std::size_t e = 0; e < 6; ++e) {
      t.at(e) = exact(e < 3 ? m.rational_near(m.within(1, 6)) : m.rational_near(m.within(-1, 1)));
      if (e >= 3 && m.one_in(3))
        t.at(e) = m.one_in(2) ? rational(0) : rational(t.at(e) / 1000000007);
    }
    std::string command = "polhode body --tensor \"";
    for (const rational& entry : t) command += to_text(entry) + ",";
    command.back() = '"';
    under_way(command);
    ++c.cases;
    try {
      const principal_axes found(t);
      ++c.computed;
      ++c.certified;
      const precision p = m.between(60, 300);
      const std::array<std::array<rational, 3>, 3> rows{
          {{t[0], t[3], t[4]}, {t[3], t[1], t[5]}, {t[4], t[5], t[2]}}};
      std::array<std::array<ball, 3>, 3> v{found.axis(0, p), found.axis(1, p), found.axis(2, p)};
      const auto dot = [&](const auto& x, const auto& y) {
        return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
      };
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          compare(dot(v.at(i), rows.at(k)), found.moments().at(i).at(p) * v.at(i).at(k),
                  "T v of " + command, "I v", c);
          compare(dot(v.at(i), v.at(k)), ball(i == k ? 1 : 0, p), "v v of " + command, "0 or 1", c);
        }
      }
      const std::array<ball, 3> across{v[1][1] * v[2][2] - v[1][2] * v[2][1],
                                       v[1][2] * v[2][0] - v[1][0] * v[2][2],
                                       v[1][0] * v[2][1] - v[1][1] * v[2][0]};
      compare(dot(v[0], across), ball(1, p), "the determinant of " + command, "1", c);
      // In another frame: R T R^T by its columns.
      const auto rotation = draw_rotation(m);
      std::array<rational, 6> turned;
      for (std::size_t e = 0; e < 6; ++e) {
        const auto& [a, b] = places.at(e);
        for (std::size_t i = 0; i < 3; ++i) {
          turned.at(e) += rotation.at(a).at(i) * dot(rotation.at(b), rows.at(i));
        }
      }
      const principal_axes other(turned);
      ++c.computed;
      for (std::size_t i = 0; i < 3; ++i) {
        compare(found.moments().at(i).at(p), other.moments().at(i).at(p),
                fmt::format("moment {} of {}", i, command), "in a turned frame", c);
      }
      ++c.checks;
      if (found.kind() != other.kind()) {
        ++c.wrong;
        ADD_FAILURE() << "the kind of " << command << " changes in a turned frame";
      }
    } catch (const input_error&) {  // not positive definite
      ++c.refused;
    }
  });
}

/// From the middle of the twist, with I_y = 1 and |J| = 1 (rotor.hpp).
TEST(rotation, momentum_by_jacobis_functions) {
  run_cases("rotation", "momenta", 120, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const drawn_body d = draw_body(m);
    const bool oscillating = m.one_in(2);
    const term motion = draw_motion(m, d, oscillating);
    const term t =
        m.one_in(4) ? m.decimal(m.scattered(10, 1e12)) : m.rational_near(m.within(-20, 20));
    const std::string command = fmt::format("the body {}, {} with c = {} at {}", d.a.text(),
                                            d.b.text(), motion.text(), t.text());
    under_way(command);
    ++c.cases;
    const precision p = m.between(30, 200);
    const rotor<ball> r(initial_state::at_middle_of_twist(d.rigid, exact(motion)), p);
    const rotor_sample<ball> sample = r.sample(exact(t));
    ++c.computed;
    ++(sample.momentum[0].is_bounded() ? c.certified : c.refused);
    const term a = d.a;
    const term b = d.b;
    const term lambda = call("sqrt", oscillating ? b * (a - motion) : a * (b + motion));
    const term one_minus_m = oscillating ? -motion * (a + b) / (b * (a - motion))
                                         : motion * (a + b) / (a * (b + motion));
    const term k = 1 - one_minus_m;
    const auto jacobi = [&](const char* name) { return call(name, lambda * t, k); };
    const term big_a = call("sqrt", (a - motion) / (a + b));
    const term big_b = call("sqrt", oscillating ? (b + motion) / b : (a - motion) / a);
    const term big_c = call("sqrt", (b + motion) / (a + b));
    const std::array<term, 3> expected{-(big_a * jacobi(oscillating ? "jacobiDN" : "jacobiCN")),
                                       big_b * jacobi("jacobiSN"),
                                       big_c * jacobi(oscillating ? "jacobiCN" : "jacobiDN")};
    for (std::size_t j = 0; j < 3; ++j) {
      compare(sample.momentum[j], read(expected[j]).value(p + 100),
              fmt::format("component {} of the momentum of {}", j, command), expected[j].text(), c);
    }
    // |J|, 2 H, and R J, which is along the third axis of space where the attitude says so at the
    // start.
    ball size(0, p);
    ball energy(0, p);
    for (std::size_t j = 0; j < 3; ++j) {
      size = size + square(sample.momentum[j]);
      energy = energy + sample.momentum[j] * sample.angular_velocity[j];
    }
    compare(size, r.state().squared_momentum().at(p), "J^2 of " + command, "J^2 at the start", c);
    compare(energy, r.state().twice_energy().at(p), "2 H of " + command, "2 H at the start", c);
    const auto in_space = [&](const rational& at) {
      const rotor_sample<ball> s = r.sample(at);
      const rotor_attitude<ball> attitude = r.attitude(at);
      std::vector<ball> result;
      for (const auto& row : attitude.matrix) {
        result.push_back(row[0] * s.momentum[0] + row[1] * s.momentum[1] + row[2] * s.momentum[2]);
      }
      return result;
    };
    const std::vector<ball> now = in_space(exact(t));
    const std::vector<ball> before = in_space(0);
    for (std::size_t j = 0; j < 3; ++j) {
      compare(now[j], before[j], fmt::format("component {} of R J of {}", j, command), "at time 0",
              c);
    }
    const matrix3<ball> rows = r.attitude(exact(t)).matrix;
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t l = 0; l <= j; ++l) {
        const ball product =
            rows[j][0] * rows[l][0] + rows[j][1] * rows[l][1] + rows[j][2] * rows[l][2];
        compare(product, ball(j == l ? 1 : 0, p), "R R^T of " + command, "the unit matrix", c);
      }
    }
  });
}

}  // namespace rotation_test
}  // namespace polhode::differential
