// The paper's curves over c: the Montgomery phase, figure 3, and the defect epsilon, figures 5 to
// 8.

#include <utility>

#include <fmt/format.h>

#include "cli/options/motion_option.hpp"
#include "paper_figures.hpp"
#include "proofs/claim.hpp"
#include "proofs/printed_values.hpp"

namespace polhode::cli::paper {
namespace {

using proofs::with_ab;

struct coloured {
  std::string value;  // of a, or of chi
  const char* colour;
};

}  // namespace

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
    const rational& end = rigid.a().exact();
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

/// The c of a meeting of C with S.
ball motion_of(const meeting& found, long digits) {
  certain_number c;
  c.enclosure = found.c;
  c.verdict = found.verdict;
  c.why = found.why;
  return certain(c, "a meeting with S", digits);
}

figure_content first_equation(long digits) {
  const body rigid = schematic_body();
  const rational& a = rigid.a().exact();
  const rational& b = rigid.b().exact();
  const meeting first = meeting_to_digits(rigid, 1, digits);
  const ball c1 = motion_of(first, digits);
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
      meetings.parts.front().push_back({motion_of(at, digits), at.epsilon});
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

namespace {

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

}  // namespace

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

}  // namespace polhode::cli::paper
