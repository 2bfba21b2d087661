// The figures of the paper: the list.

#include "paper_figures.hpp"

namespace polhode::cli {
namespace paper {
namespace {

constexpr const char* schematic_note =
    "schematic in print; here for the physical body with moments 4, 3, 2: a = 1/2, b = 1/4";

/// Figure 1.
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

}  // namespace
}  // namespace paper

const std::vector<figure>& all_figures() {
  using namespace paper;
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
