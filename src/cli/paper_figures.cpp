// The figures of the paper.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "exact_decimals.hpp"
#include "figure.hpp"
#include "motion_option.hpp"
#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "proofs/claim.hpp"
#include "proofs/printed_values.hpp"

namespace polhode::cli {
namespace {

using proofs::with_ab;

constexpr const char* black = "black";
constexpr const char* blue = "#1f4fa0";
constexpr const char* green = "#2e8b3d";
constexpr const char* grey = "#888888";
constexpr const char* magenta = "#b0209a";
constexpr const char* purple = "#7030a0";
constexpr const char* red = "#c02a1e";

std::string solid(const char* colour) { return fmt::format("lines lw 2 lc rgb '{}'", colour); }
std::string dashed(const char* colour) {
  return fmt::format("lines lw 2 dt (8,5) lc rgb '{}'", colour);
}
std::string thin(const char* colour) { return fmt::format("lines lw 1 lc rgb '{}'", colour); }
std::string discs(const char* colour) {
  return fmt::format("points pt 7 ps 0.6 lc rgb '{}'", colour);
}
std::string circles(const char* colour) {
  return fmt::format("points pt 6 ps 0.8 lw 2 lc rgb '{}'", colour);
}

// ---------------------------------------------------------------------------------------------
// Numbers

constexpr long digits_of_names = 20;

rational number(const char* text) { return parse_rational(text); }

/// Where nothing cancels: the precision is raised until the digits are certain.
ball enclosed(const enclosing_function& f, const std::string& what, long digits) {
  certain_number result;
  result.enclosure = enclose_to_digits(f, digits, 15 * bits_for_digits(digits) + 1024);
  if (!result.enclosure.is_undefined()) result.verdict = status::certified;
  return certain(result, what, digits);
}

coordinate negated(const coordinate& x) {
  return std::visit([](const auto& value) { return coordinate(-value); }, x);
}

coordinate multiple_of_pi(const rational& factor, long digits) {
  if (factor == 0) return rational(0);
  return enclosed([&](precision p) { return factor * pi(p); }, "a multiple of pi", digits);
}

coordinate shifted_by_pi(const coordinate& x, long digits) {
  return enclosed(
      [&](precision p) {
        return std::holds_alternative<rational>(x) ? ball(std::get<rational>(x), p) + pi(p)
                                                   : std::get<ball>(x) + pi(p);
      },
      "an angle", digits);
}

/// n + 1 numbers at equal distances, both ends included.
std::vector<rational> equally_spaced(const rational& low, const rational& high, long n) {
  std::vector<rational> result;
  result.reserve(static_cast<std::size_t>(n) + 1);
  for (long k = 0; k <= n; ++k) result.emplace_back(low + (high - low) * k / n);
  return result;
}

/// end (k/n)^2 for k = 1, ..., n - 1: dense near 0.
std::vector<rational> dense_near_zero(const rational& end, long n) {
  std::vector<rational> result;
  result.reserve(static_cast<std::size_t>(n) - 1);
  for (long k = 1; k < n; ++k) result.emplace_back(end * k * k / (n * n));
  return result;
}

/// start + side 10^-k {1, 2, 5}, down to 10^-smallest, where that is in the range.
std::vector<rational> approaching(const rational& start, int side, long smallest,
                                  const rational& low, const rational& high) {
  std::vector<rational> result;
  rational power(side);
  for (long k = 1; k <= smallest; ++k) {
    power /= 10;
    for (const int leading : {1, 2, 5}) {
      const rational x(start + leading * power);
      if (low <= x && x <= high) result.push_back(x);
    }
  }
  return result;
}

std::vector<rational> merged(std::vector<std::vector<rational>> sets) {
  std::vector<rational> result;
  for (std::vector<rational>& set : sets) {
    std::move(set.begin(), set.end(), std::back_inserter(result));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// ---------------------------------------------------------------------------------------------
// Curves that several figures have

figure_curve straight(const std::string& name, const std::string& style, const figure_point& from,
                      const figure_point& to, const std::string& title = "") {
  return {name, {{style, title}}, {{from, to}}};
}

/// S from epsilon = 0 to pi/2, and its mirror up to pi: c = -b sin^2 epsilon. For b = 1 it is beta over epsilon.
figure_curve turning_curve(const rational& b, bool with_mirror, const std::string& title,
                           long digits) {
  constexpr long steps =
      61;  // prime: sin^2 (k pi/122) is never rational (Niven), so that its digits can be certain
  figure_curve result{"S", {{dashed(red), title}}, {{{rational(0), rational(0)}}}};
  std::vector<figure_point>& points = result.parts.front();
  for (long k = 1; k < steps; ++k) {
    const rational turn(k, 2 * steps);
    const ball c =
        enclosed([&](precision p) { return -b * square(sin(turn * pi(p))); }, "S", digits);
    points.push_back({c, multiple_of_pi(turn, digits)});
  }
  points.push_back({rational(-b), multiple_of_pi(rational(1, 2), digits)});
  for (long k = steps - 1; with_mirror && k >= 0; --k) {
    const coordinate c = points[static_cast<std::size_t>(k)].x;
    points.push_back({c, multiple_of_pi(rational(2 * steps - k, 2 * steps), digits)});
  }
  return result;
}

std::vector<figure_point> twists(const body& rigid, const std::vector<rational>& motions,
                                 long digits) {
  std::vector<figure_point> result;
  result.reserve(motions.size());
  for (const rational& c : motions) {
    const twist t = twist_to_digits(rigid, c, digits, with_slope::no);
    result.push_back(
        {c, certain({t.verdict, t.why, t.epsilon}, "epsilon at c = " + to_text(c), digits)});
  }
  return result;
}

std::vector<figure_point> phases(const body& rigid, const std::vector<rational>& motions,
                                 long digits) {
  std::vector<figure_point> result;
  result.reserve(motions.size());
  for (const rational& c : motions) {
    result.push_back({c, certain(montgomery_phase_to_digits(rigid, c, digits),
                                 "the phase at c = " + to_text(c), digits)});
  }
  return result;
}

ball phase_limit(const body& rigid, const rational& c, long digits) {
  return certain(montgomery_phase_limit_to_digits(rigid, c, digits), "the limit of the phase",
                 digits);
}

/// "1.0479..."
std::string geometric_constant_of(const body& rigid) {
  constexpr long shown = 5;
  if (const auto exact = rigid.exact_geometric_constant()) return to_text(*exact);
  return to_decimal(enclosed([&](precision p) { return rigid.geometric_constant(p); }, "I", shown),
                    shown);
}
std::string second_geometric_constant_of(const body& rigid) {
  constexpr long shown = 5;
  if (const auto exact = rigid.exact_second_geometric_constant()) return to_text(*exact);
  return to_decimal(
      enclosed([&](precision p) { return rigid.second_geometric_constant(p); }, "J", shown), shown);
}

/// "a = 12.65 (physical): I = 1.0479..."
std::string with_constant(const std::string& a, const body& rigid) {
  return fmt::format("a = {} ({}): I = {}", a, to_text(rigid.kind()), geometric_constant_of(rigid));
}

const char* const axis_of_c = "set xlabel \"c = 2 I_y H/J^2 − 1\"\n";
const char* const axis_of_epsilon = "set ylabel \"ε (radians)\"\n";

// ---------------------------------------------------------------------------------------------
// Figure 1

figure_content physical_region(long /*digits*/) {
  // I >= 1 <=> b <= 1/(a + 2).
  figure_curve boundary{"I = 1",
                        {{"filledcurves y1=0 fc rgb '#b9d3ee'", "physical: I ≥ 1"},
                         {solid(black), "planar: I = 1, which is ab + 2b = 1"}},
                        {{}}};
  for (const rational& a : merged({equally_spaced(0, 10, 50), equally_spaced(10, 45, 70)})) {
    boundary.parts.front().push_back({a, rational(1 / (a + 2))});
  }
  figure_curve bodies{
      "bodies", {{discs(red), "the bodies of figures 3, 6 and 7 (b = 0.0629)"}}, {{}}};
  for (const char* a : {"3.1", "12.65", "13.89", "15.38", "18.27", "39.95"}) {
    bodies.parts.front().push_back({number(a), number("0.0629")});
  }
  return {
      "set xlabel \"a = I_y/I_z − 1\"\nset ylabel \"b = 1 − I_y/I_x\"\n"
      "set xrange [0:45]\nset yrange [0:0.55]\n",
      {boundary, bodies}};
}

// ---------------------------------------------------------------------------------------------
// Figures 2 and 4: schematic in print, here for the body with moments 4, 3, 2

body schematic_body() { return with_ab("0.5", "0.25"); }

constexpr const char* schematic_note =
    "schematic in print; here for the physical body with moments 4, 3, 2: a = 1/2, b = 1/4";

/// What is drawn over psi for x = cos^2 psi, where c + b x = level, a number that does not cancel.
using height =
    std::function<ball(const body&, const rational& c, const ball& x, const ball& level)>;

/// dpsi/dphi
ball rate_of_psi(const body& rigid, const rational&, const ball& x, const ball& level) {
  const ball bx = rigid.b() * x;
  return sqrt((rigid.a() + bx) * level) / (1 - bx);
}

/// pi/2 - theta, from cos^2 theta = (c + b x)/(a + b x) and sin^2 theta = (a - c)/(a + b x)
ball height_of_theta(const body& rigid, const rational& c, const ball&, const ball& level) {
  return atan(sqrt(level / rational(rigid.a() - c)));
}

/// The quarter of an oscillating motion in which psi and the height are positive, from psi near 0 to the turning point:
/// sin psi = sqrt(1-u) sin t, so that cos^2 psi = 1 - (1-u) sin^2 t and c + b cos^2 psi = b (1-u) cos^2 t.
std::vector<figure_point> oscillating_quarter(const body& rigid, const rational& c, const height& f,
                                              long digits) {
  constexpr long steps = 40;
  const rational rest(1 + c / rigid.b());  // 1 - u
  const auto psi = [&](const rational& turn, precision p) {
    return asin(sqrt(ball(rest, p)) * sin(turn * pi(p)));
  };
  const auto y = [&](const rational& turn, precision p) {
    const ball t = turn * pi(p);
    return f(rigid, c, 1 - rest * square(sin(t)), rational(rigid.b() * rest) * square(cos(t)));
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
    return f(rigid, c, x, c + rigid.b() * x);
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

figure_content reduced_phase_space(long digits) {
  const body rigid = schematic_body();
  figure_content result{
      "set xlabel \"ψ (radians)\"\nset ylabel \"dψ/dφ\"\n"
      "set xrange [-pi/2:pi/2]\nset yrange [-1.2:1.2]\n"
      "set xtics ('−π/2' -pi/2, '−π/4' -pi/4, '0' 0, 'π/4' pi/4, 'π/2' pi/2)\n",
      orbits(rigid, rate_of_psi, digits)};
  const std::vector<figure_point> quarter =
      rotating_quarter(rigid, rigid.a(), rate_of_psi, rigid.a(), digits);
  const std::vector<figure_point> upper = half_from(quarter);
  result.curves.push_back({"c = " + exact_text(rigid.a(), digits_of_names),
                           {{solid(green), "turning about z: c = a"}},
                           {upper, upside_down(upper)}});
  result.curves.push_back({"c = " + exact_text(-rigid.b(), digits_of_names),
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
      {"c = " + exact_text(rigid.a(), digits_of_names),
       {{fmt::format("lines lw 4 lc rgb '{}'", green), "turning about z: c = a"}},
       {{{left, rational(0)}, {right, rational(0)}}, {{left, one}, {right, one}}}});
  result.curves.push_back({"c = " + exact_text(-rigid.b(), digits_of_names),
                           {{discs(grey), "turning about x: c = −b"}},
                           {{{rational(0), half}, {one, half}}}});
  return result;
}

// ---------------------------------------------------------------------------------------------
// Figure 3

struct coloured {
  std::string value;  // of a, or of chi
  const char* colour;
};

figure_content montgomery_oscillating(long digits) {
  const rational b = number("0.0629");
  const std::vector<rational> motions = merged(
      {dense_near_zero(-b, 200), approaching(-b, 1, 5, -b, 0), approaching(0, -1, 6, -b, 0)});
  figure_content result{std::string(axis_of_c) +
                            "set ylabel \"Δφ (radians)\"\nset xrange [-0.0629:0]\n"
                            "set yrange [4:14]\nset ytics (4, '2π' 2*pi, 8, 10, 12, 14)\n",
                        {}};
  figure_curve limits{"limit", {{circles(grey), "limits 2πI for c → −b"}}, {{}}};
  for (const auto& [a, colour] : std::vector<coloured>{{"12.65", red}, {"18.27", black}}) {
    const body rigid = with_ab(a, "0.0629");
    result.curves.push_back(
        {"a = " + a, {{solid(colour), with_constant(a, rigid)}}, {phases(rigid, motions, digits)}});
    limits.parts.front().push_back({rational(-b), phase_limit(rigid, -b, digits)});
  }
  result.curves.push_back(std::move(limits));
  const coordinate turn = multiple_of_pi(2, digits);
  result.curves.push_back(straight("2 pi", dashed(grey), {rational(-b), turn}, {rational(0), turn},
                                   "2π, the bound for I = 1"));
  return result;
}

figure_content montgomery_rotating(long digits) {
  figure_content result{
      std::string(axis_of_c) + "set ylabel \"Δφ (radians)\"\nset xrange [0:19]\nset yrange [0:4]\n",
      {}};
  figure_curve limits{"limit", {{circles(grey), "limits 2πJ for c → a"}}, {{}}};
  for (const auto& [a, colour] : std::vector<coloured>{{"12.65", blue}, {"18.27", black}}) {
    const body rigid = with_ab(a, "0.0629");
    const rational& end = rigid.a();
    const std::vector<rational> motions =
        merged({dense_near_zero(end, 200), approaching(end, -1, 4, 0, end)});
    const std::string title = fmt::format("a = {} ({}): J = {}", a, to_text(rigid.kind()),
                                          second_geometric_constant_of(rigid));
    result.curves.push_back(
        {"a = " + a, {{solid(colour), title}}, {phases(rigid, motions, digits)}});
    limits.parts.front().push_back({end, phase_limit(rigid, end, digits)});
  }
  result.curves.push_back(std::move(limits));
  return result;
}

// ---------------------------------------------------------------------------------------------
// Figures 5, 6 and 7: epsilon(c)

figure_content first_equation(long digits) {
  const body rigid = schematic_body();
  const rational& a = rigid.a();
  const rational& b = rigid.b();
  const meeting first = meeting_to_digits(rigid, 1, digits);
  const ball c1 = certain({first.verdict, first.why, first.c}, "the meeting with S", digits);
  std::vector<rational> motions =
      merged({equally_spaced(-b, a, 150), approaching(0, 1, 4, -b, a), approaching(0, -1, 4, -b, a),
              approaching(a, -1, 4, 0, a)});
  std::erase_if(motions,
                [&](const rational& c) { return c >= a || !certainly_less(c1, ball(c, 256)); });
  figure_curve curve{"C", {{solid(magenta), "C by the first implicit equation"}}, {{}}};
  curve.parts.front() = twists(rigid, motions, digits);
  curve.parts.front().insert(curve.parts.front().begin(), {c1, first.epsilon});
  figure_content result{
      std::string(axis_of_c) + axis_of_epsilon +
          "set xrange [-0.28:0.53]\nset yrange [-0.6:pi/2]\n"
          "set ytics ('−π/8' -pi/8, '0' 0, 'π/8' pi/8, 'π/4' pi/4, '3π/8' 3*pi/8, 'π/2' pi/2)\n"
          "set xzeroaxis lt 1 lc rgb 'black'\nset yzeroaxis lt 1 lc rgb 'black'\n",
      {curve, turning_curve(b, false, "S: c = −b sin^2ε", digits)}};
  const coordinate top = multiple_of_pi(rational(1, 2), digits);
  result.curves.push_back(straight("c = -b", solid(grey), {rational(-b), rational(-3, 5)},
                                   {rational(-b), top}, "c = −b"));
  result.curves.push_back(straight("c = a", solid(green), {a, rational(-3, 5)}, {a, top}, "c = a"));
  result.curves.push_back({"C meets S", {{discs(red), "C meets S"}}, {{{c1, first.epsilon}}}});
  result.curves.push_back(
      {"epsilon0",
       {{discs(black), "ε_0, on the separatrix"}},
       {{{rational(0), certain(separatrix_defect_to_digits(rigid, digits), "epsilon0", digits)}}}});
  result.curves.push_back(
      {"c0",
       {{circles(black), "c_0, the perfect twist"}},
       {{{certain(perfect_twist_to_digits(rigid, digits), "c0", digits), rational(0)}}}});
  return result;
}

figure_content injectivity(long digits) {
  const rational b = number("0.0629");
  const rational end = number("0.0171");
  figure_content result{std::string(axis_of_c) + axis_of_epsilon +
                            "set xrange [-0.0629:0.0171]\nset yrange [-0.6:pi]\n"
                            "set ytics ('0' 0, 'π/4' pi/4, 'π/2' pi/2, '3π/4' 3*pi/4, 'π' pi)\n",
                        {}};
  const std::vector<rational> motions = merged({equally_spaced(number("-0.0627"), end, 399),
                                                approaching(-b, 1, 6, -b, end),
                                                approaching(0, 1, 5, -b, end),
                                                approaching(0, -1, 5, -b, end),
                                                {rational(0)}});
  figure_curve meetings{"C meets S", {{discs(red), "C meets S"}}, {{}}};
  for (const auto& [a, colour] : std::vector<coloured>{
           {"39.95", purple}, {"18.27", black}, {"12.65", blue}, {"3.1", green}}) {
    const body rigid = with_ab(a, "0.0629");
    result.curves.push_back(
        {"a = " + a, {{solid(colour), with_constant(a, rigid)}}, {twists(rigid, motions, digits)}});
    for (integer m = 1; m <= meeting_count(rigid); m += 2) {
      const meeting at = meeting_to_digits(rigid, m, digits);
      meetings.parts.front().push_back(
          {certain({at.verdict, at.why, at.c}, "a meeting with S", digits), at.epsilon});
    }
  }
  result.curves.push_back(turning_curve(b, true, "S: c = −b sin^2ε", digits));
  result.curves.push_back(std::move(meetings));
  const coordinate half = multiple_of_pi(rational(1, 2), digits);
  result.curves.push_back(
      straight("epsilon = pi/2", thin(black), {rational(-b), half}, {end, half}));
  result.curves.push_back(straight("c = 0", thin(black), {rational(0), rational(-3, 5)},
                                   {rational(0), multiple_of_pi(1, digits)}));
  return result;
}

/// The curves C near the separatrix, for four a and this b.
figure_content near_separatrix(const char* b, long digits) {
  const rational low = number("-0.01");
  const rational high = number("0.01");
  figure_content result{
      std::string(axis_of_c) + axis_of_epsilon + "set xrange [-0.01:0.01]\nset yrange [-0.3:0.7]\n",
      {}};
  const std::vector<rational> motions =
      merged({equally_spaced(low, high, 200), approaching(0, 1, 6, low, high),
              approaching(0, -1, 6, low, high)});
  figure_curve defects{"epsilon0", {{discs(magenta), "ε_0, on the separatrix"}}, {{}}};
  figure_curve perfect{"c0", {{circles(magenta), "c_0, the perfect twist"}}, {{}}};
  const std::string thick = fmt::format("lines lw 3.5 lc rgb '{}'", black);
  for (const auto& [a, style] :
       std::vector<std::pair<std::string, std::string>>{{"12.65", solid(blue)},
                                                        {"13.89", dashed(blue)},
                                                        {"15.38", solid(black)},
                                                        {"18.27", thick}}) {
    const body rigid = with_ab(a, b);
    result.curves.push_back(
        {"a = " + a, {{style, with_constant(a, rigid)}}, {twists(rigid, motions, digits)}});
    defects.parts.front().push_back(
        {rational(0), certain(separatrix_defect_to_digits(rigid, digits), "epsilon0", digits)});
    perfect.parts.front().push_back(
        {certain(perfect_twist_to_digits(rigid, digits), "c0", digits), rational(0)});
  }
  result.curves.push_back(turning_curve(number(b), false, "S: c = −b sin^2ε", digits));
  result.curves.push_back(std::move(defects));
  result.curves.push_back(std::move(perfect));
  result.curves.push_back(
      straight("epsilon = 0", thin(black), {low, rational(0)}, {high, rational(0)}));
  result.curves.push_back(straight("c = 0", thin(black), {rational(0), rational(-3, 10)},
                                   {rational(0), rational(7, 10)}));
  return result;
}

figure_content varying_a(long digits) { return near_separatrix("0.0629", digits); }
figure_content varying_a_as_printed(long digits) { return near_separatrix("0.06", digits); }

// ---------------------------------------------------------------------------------------------
// Figure 8

figure_content limit(long digits) {
  const rational low = number("-0.2");
  const rational high = number("0.2");
  figure_content result{"set xlabel \"β = c/b\"\n" + std::string(axis_of_epsilon) +
                            "set xrange [-0.2:0.2]\nset yrange [-0.6:1]\n",
                        {}};
  const std::vector<rational> betas =
      merged({equally_spaced(low, high, 200), approaching(0, 1, 6, low, high),
              approaching(0, -1, 6, low, high)});
  for (const auto& [chi, colour] :
       std::vector<coloured>{{"1", green}, {"0.8", black}, {"0.6", red}, {"0.4", blue}}) {
    std::vector<figure_point> points;
    points.reserve(betas.size());
    for (const rational& beta : betas) {
      points.push_back({beta, certain(limit_defect_to_digits(number(chi.c_str()), beta, digits),
                                      "epsilon at beta = " + to_text(beta), digits)});
    }
    result.curves.push_back({"chi = " + chi, {{solid(colour), "χ = " + chi}}, {points}});
  }
  const auto constant = [&](const char* name) {
    return enclosed(proofs::find_constant(name)->enclose, name, digits);
  };
  constexpr long shown = 6;
  const ball least = constant("epsilon0_min");
  const ball beta = constant("beta");
  result.curves.push_back({"epsilon0_min",
                           {{discs(black), "ε_{0,min} = " + to_decimal(least, shown)}},
                           {{{rational(0), least}}}});
  result.curves.push_back(
      {"beta",
       {{circles(black), "perfect twist for χ = 1, β = " + to_decimal(beta, shown)}},
       {{{beta, rational(0)}}}});
  result.curves.push_back(
      straight("epsilon = 0", thin(black), {low, rational(0)}, {high, rational(0)}));
  result.curves.push_back(straight("beta = 0", thin(black), {rational(0), rational(-3, 5)},
                                   {rational(0), rational(1)}));
  return result;
}

}  // namespace

const std::vector<figure>& all_figures() {
  static const std::vector<figure> figures{
      {"physical_region", "figure 1", "the physical bodies, I = (1 − b)/√(b(a + b)) ≥ 1", "", "a",
       "b", physical_region},
      {"reduced_phase_space", "figure 2", "the reduced phase space (ψ, dψ/dφ)", schematic_note,
       "psi", "dpsi_dphi", reduced_phase_space},
      {"montgomery_oscillating", "figure 3 (a)", "the Montgomery phase, oscillating, b = 0.0629",
       "it increases with c; the introduction says that it decreases", "c", "delta_phi",
       montgomery_oscillating},
      {"montgomery_rotating", "figure 3 (b)", "the Montgomery phase, rotating, b = 0.0629", "", "c",
       "delta_phi", montgomery_rotating},
      {"phase_space", "figure 4", "the phase space (ψ, θ)", schematic_note, "psi", "theta",
       phase_space},
      {"first_equation", "figure 5", "the curve C beside S", schematic_note, "c", "epsilon",
       first_equation},
      {"injectivity", "figure 6", "the defect ε(c), b = 0.0629", "", "c", "epsilon", injectivity},
      {"varying_a", "figure 7", "the defect ε(c) near the separatrix, b = 0.0629",
       "the caption prints b = 0.06, but values of I that are near those for b = 0.0629", "c",
       "epsilon", varying_a},
      {"varying_a_as_printed", "figure 7", "the defect ε(c) near the separatrix, b = 0.06",
       "with the b of the caption, whose values of I are others", "c", "epsilon",
       varying_a_as_printed},
      {"limit", "figure 8", "the defect ε(β) in the limit a → ∞, b → 0, with χ = ab", "", "beta",
       "epsilon", limit}};
  return figures;
}

}  // namespace polhode::cli
