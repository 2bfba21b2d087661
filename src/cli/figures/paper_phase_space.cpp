// The paper's phase spaces: figures 2 and 4.

#include <functional>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cli/output/exact_decimals.hpp"
#include "paper_figures.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/motion.hpp"

namespace polhode::cli::paper {
namespace {

/// What is drawn over psi for x = cos^2 psi, where c + b x = level, a number that does not cancel.
using height =
    std::function<ball(const body&, const rational& c, const ball& x, const ball& level)>;

/// dpsi/dphi
ball rate_of_psi(const body& rigid, const rational&, const ball& x, const ball& level) {
  const ball bx = rigid.b().exact() * x;
  return sqrt((rigid.a().exact() + bx) * level) / (1 - bx);
}

/// pi/2 - theta, from cos^2 theta = (c + b x)/(a + b x) and sin^2 theta = (a - c)/(a + b x)
ball height_of_theta(const body& rigid, const rational& c, const ball&, const ball& level) {
  return atan(sqrt(level / rational(rigid.a().exact() - c)));
}

/// The quarter of an oscillating motion in which psi and the height are positive, from psi near 0
/// to the turning point: sin psi = sqrt(1-u) sin t, so that cos^2 psi = 1 - (1-u) sin^2 t and c + b
/// cos^2 psi = b (1-u) cos^2 t.
std::vector<figure_point> oscillating_quarter(const body& rigid, const rational& c, const height& f,
                                              long digits) {
  constexpr long steps = 40;
  const rational rest(1 - motion(rigid, c).turning_point().exact());  // 1 - u
  const auto psi = [&](const rational& turn, precision p) {
    return asin(sqrt(ball(rest, p)) * sin(turn * pi(p)));
  };
  const auto y = [&](const rational& turn, precision p) {
    const ball t = turn * pi(p);
    return f(rigid, c, 1 - rest * square(sin(t)),
             rational(rigid.b().exact() * rest) * square(cos(t)));
  };
  std::vector<figure_point> result;
  result.reserve(steps + 1);
  for (long k = 0; k < steps; ++k) {
    const rational turn(2 * k + 1, 4 * steps);
    result.push_back({enclosed([&](precision p) { return psi(turn, p); }, "psi", digits),
                      enclosed([&](precision p) { return y(turn, p); }, "the height", digits)});
  }
  const auto turning = [&](precision p) { return asin(sqrt(ball(rest, p))); };
  result.push_back({enclosed(turning, "the turning point", digits), rational(0)});
  return result;
}

/// The same for c >= 0, from psi near 0 to pi/2. None of its points but the last has a rational
/// cos^2 psi, where the height may be rational.
std::vector<figure_point> rotating_quarter(const body& rigid, const rational& c, const height& f,
                                           const coordinate& last, long digits) {
  constexpr long steps = 40;
  const auto y = [&](const rational& turn, precision p) {
    const ball x = square(cos(turn * pi(p)));
    return f(rigid, c, x, c + rigid.b().exact() * x);
  };
  std::vector<figure_point> result;
  result.reserve(steps + 1);
  for (long k = 0; k < steps; ++k) {
    const rational turn(2 * k + 1, 4 * steps);
    result.push_back({multiple_of_pi(turn, digits),
                      enclosed([&](precision p) { return y(turn, p); }, "the height", digits)});
  }
  result.push_back({multiple_of_pi(rational(1, 2), digits), last});
  return result;
}

/// The quarter and its mirror image in psi: from -psi to psi.
std::vector<figure_point> half_from(const std::vector<figure_point>& quarter) {
  std::vector<figure_point> result(quarter.rbegin(), quarter.rend());
  for (figure_point& p : result) p.x = negated(p.x);
  result.insert(result.end(), quarter.begin(), quarter.end());
  return result;
}

std::vector<figure_point> upside_down(std::vector<figure_point> points) {
  for (figure_point& p : points) p.y = negated(p.y);
  return points;
}

/// The orbit at c, symmetric in psi and in the height.
figure_curve orbit(const body& rigid, const rational& c, const height& f,
                   const figure_curve::drawing& drawn, long digits) {
  const std::string name = "c = " + exact_text(c, digits_of_names);
  if (c < 0) {
    std::vector<figure_point> around = half_from(oscillating_quarter(rigid, c, f, digits));
    const std::vector<figure_point> lower = upside_down(around);
    around.insert(around.end(), lower.rbegin() + 1, lower.rend());
    return {name, {drawn}, {around}};
  }
  coordinate last = rational(0);
  if (c > 0) {
    const auto height_at_end = [&](precision p) { return f(rigid, c, ball(0, p), ball(c, p)); };
    last = enclosed(height_at_end, "the height", digits);
  }
  const std::vector<figure_point> upper = half_from(rotating_quarter(rigid, c, f, last, digits));
  return {name, {drawn}, {upper, upside_down(upper)}};
}

std::vector<figure_curve> orbits(const body& rigid, const height& f, long digits) {
  struct family {
    const char* title;
    const char* colour;
    std::vector<const char*> motions;
  };
  std::vector<figure_curve> result;
  for (const auto& [title, colour, motions] : std::vector<family>{
           {"oscillating: c = −0.2, −0.12, −0.06, −0.01", red, {"-0.2", "-0.12", "-0.06", "-0.01"}},
           {"separatrix: c = 0", black, {"0"}},
           {"rotating: c = 0.05, 0.15, 0.3", blue, {"0.05", "0.15", "0.3"}}}) {
    for (const char* c : motions) {
      const bool first = c == motions.front();
      result.push_back(orbit(rigid, number(c), f, {solid(colour), first ? title : ""}, digits));
    }
  }
  return result;
}

}  // namespace

figure_content reduced_phase_space(long digits) {
  const body rigid = schematic_body();
  figure_content result{
      "set xlabel \"ψ (radians)\"\nset ylabel \"dψ/dφ\"\n"
      "set xrange [-pi/2:pi/2]\nset yrange [-1.2:1.2]\n"
      "set xtics ('−π/2' -pi/2, '−π/4' -pi/4, '0' 0, 'π/4' pi/4, 'π/2' pi/2)\n",
      orbits(rigid, rate_of_psi, digits)};
  const std::vector<figure_point> quarter =
      rotating_quarter(rigid, rigid.a().exact(), rate_of_psi, rigid.a().exact(), digits);
  const std::vector<figure_point> upper = half_from(quarter);
  result.curves.push_back({"c = " + exact_text(rigid.a().exact(), digits_of_names),
                           {{solid(green), "turning about z: c = a"}},
                           {upper, upside_down(upper)}});
  result.curves.push_back({"c = " + exact_text(-rigid.b().exact(), digits_of_names),
                           {{discs(grey), "turning about x: c = −b"}},
                           {{{rational(0), rational(0)}}}});
  return result;
}

figure_content phase_space(long digits) {
  const body rigid = schematic_body();
  figure_content result{
      "set xlabel \"ψ (radians)\"\nset ylabel \"θ (radians)\"\n"
      "set xrange [-pi/2:3*pi/2]\nset yrange [0:pi]\n"
      "set xtics ('−π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi, '3π/2' 3*pi/2)\n"
      "set ytics ('0' 0, 'π/4' pi/4, 'π/2' pi/2, '3π/4' 3*pi/4, 'π' pi)\n",
      orbits(rigid, height_of_theta, digits)};
  // theta = pi/2 - height; and everything once more for psi + pi.
  const auto theta = [&](const coordinate& y) -> coordinate {
    if (std::holds_alternative<rational>(y)) return multiple_of_pi(rational(1, 2), digits);
    return enclosed([&](precision p) { return scale(pi(p), -1) - std::get<ball>(y); }, "theta",
                    digits);
  };
  for (figure_curve& curve : result.curves) {
    std::vector<std::vector<figure_point>> shifted;
    for (auto& part : curve.parts) {
      std::vector<figure_point> other;
      for (figure_point& p : part) {
        p.y = theta(p.y);
        other.push_back({shifted_by_pi(p.x, digits), p.y});
      }
      shifted.push_back(std::move(other));
    }
    curve.parts.insert(curve.parts.end(), shifted.begin(), shifted.end());
  }
  const coordinate left = multiple_of_pi(rational(-1, 2), digits);
  const coordinate right = multiple_of_pi(rational(3, 2), digits);
  const coordinate one = multiple_of_pi(1, digits);
  const coordinate half = multiple_of_pi(rational(1, 2), digits);
  result.curves.push_back(
      {"c = " + exact_text(rigid.a().exact(), digits_of_names),
       {{fmt::format("lines lw 4 lc rgb '{}'", green), "turning about z: c = a"}},
       {{{left, rational(0)}, {right, rational(0)}}, {{left, one}, {right, one}}}});
  result.curves.push_back({"c = " + exact_text(-rigid.b().exact(), digits_of_names),
                           {{discs(grey), "turning about x: c = −b"}},
                           {{{rational(0), half}, {one, half}}}});
  return result;
}

}  // namespace polhode::cli::paper
