// What the paper prints that is not right.

#include "statements/errata.hpp"
#include "brackets.hpp"
#include "checker/elliptic.hpp"
#include "checker/functions.hpp"
#include "constants.hpp"
#include "list.hpp"
#include "printed.hpp"

namespace polhode::checker {
namespace {

void check_errata(examination& e) {
  e.read_no_inputs();
  const auto I = [](const char* a) { return I_of(with_ab(a, "0.06")); };
  check_printed(
      e,
      {{"figure 7", "I for a = 12.65, b = 0.06", "1.045", "1.045", 3, "1.076414286", I("12.65")},
       {"figure 7", "I for a = 13.89, b = 0.06", "1",
        "1 (read as 1.000, as its neighbours have 3 decimals)", 3, "1.027460476", I("13.89")},
       {"figure 7", "I for a = 15.38, b = 0.06", "0.951", "0.951", 3, "0.9766266710", I("15.38")},
       {"figure 7", "I for a = 18.27, b = 0.06", "0.872", "0.872", 3, "0.8963363227", I("18.27")},
       {"section 8", "I for water, ground state", "0.946", "0.946", 3, "0.9399956863",
        I_of(with_constants("9.28", "14.52", "27.88"))}},
      false);
  struct meant {
    const char* a;
    const char* printed;
    const char* as_read;
    bool right;
    const char* in_short;
  };
  for (const meant& m : {meant{"12.65", "1.045", "1.045", false, "1.0479445"},
                         meant{"13.89", "1", "1 (read as 1.000, as its neighbours have 3 decimals)",
                               true, "1.0002956"},
                         meant{"15.38", "0.951", "0.951", true, "0.95081535"},
                         meant{"18.27", "0.872", "0.872", false, "0.87265992"}}) {
    e.fact(
        std::string("figure 7 with b = 0.0629 in place of 0.06: ") + m.as_read + " for a = " + m.a +
            " would be " + (m.right ? "right" : "wrong") + ", I = " + m.in_short + "...",
        [&](precision bits) {
          const interval value = with_ab(m.a, "0.0629").I(bits);
          const rational cut = number_in(m.in_short);
          const auto length = static_cast<long>(std::string(m.in_short).size());
          return all_of({below(exactly(cut, bits), value),
                         below(value, exactly(rational(cut + power_of_ten(2 - length)), bits)),
                         m.right ? is_right(value, m.printed, 3) : is_wrong(value, m.printed, 3)});
        });
  }
  const body water = water_at_equilibrium();
  e.fact(
      "section 2 says \"by definition, a > 1\": a > 0 is right; the water molecule of section 8 "
      "has a = 0.86850689... and I > 1",
      water.a > number_in("0.86850689") && water.a < number_in("0.86850690") && water.kind() > 0);
  const body usual = with_ab("12.65", "0.0629");
  e.fact(
      "section 1 says that the phase of oscillating motion is a decreasing function of c: it "
      "increases, for a = 12.65, b = 0.0629 from c = -3b/4 to -b/4 (for all bodies: the claim "
      "montgomery_oscillating)",
      [&](precision bits) {
        return below(half_phase(usual.a, usual.b, rational(3, 4), bits),
                     half_phase(usual.a, usual.b, rational(1, 4), bits));
      });
  const range c0{number_in("0.0002473696968432"), number_in("0.0002473696968435")};
  e.fact(
      "proposition 3 seeks c0 in (-b, a): it lies in (0, a), for a = 12.65, b = 0.0629 at c0/a "
      "between " +
          in_decimals(c0, e.work()),
      [&](precision bits) { return passes_rotating_phase(usual, 2, c0, bits); });
  const body planar{1, rational(1, 3)};
  e.fact(
      "section 8 says \"if and only if I > 1\": theorem 3 has I >= 1; the planar body a = 1, b = "
      "1/3 has I = 1, is physical, and epsilon(c) never crosses pi/2",
      planar.squared_I() == 1 && planar.kind() == 0 && planar.crossings() == 0);
  const body once = with_ab("18.27", "0.0629");
  e.fact(
      "section 6.2 says that for non-physical bodies C and S intersect several times: for 2/3 <= I "
      "< 1 exactly once, as for a = 18.27, b = 0.0629",
      once.kind() < 0 && once.intersections() == 1);
  const body twice = with_ab("39.95", "0.0629");
  e.fact(
      "theorem 4 says at least n, and one more beyond the n-th, for I < 2/(2n+1): there are "
      "exactly n + 1 for 2/(2n+3) <= I < 2/(2n+1); for a = 39.95, b = 0.0629, where n = 1, there "
      "are 2",
      twice.is_above_I(rational(2, 3)) && !twice.is_above_I(rational(2, 5)) &&
          twice.intersections() == 2);
  const body at_two{rational(77, 40), rational(1, 10)};
  e.fact(
      "lemma 2 says that C and S intersect if and only if I <= 2: at I = 2 the point u = 1 is only "
      "a limit, as for a = 77/40, b = 1/10, where there is no intersection",
      at_two.squared_I() == 4 && at_two.intersections() == 0);
  const range u{number_in("0.053943792"), number_in("0.053943793")};
  e.fact(
      "lemma 1 says that there is one epsilon for each c: at a = 12.65, b = 0.0629 G(u) passes 2 "
      "pi between u = 0.053943792 and 0.053943793, at c between -0.0033930646 and -0.0033930645, "
      "where C meets S; there psi(phi + 2 pi) = -psi(phi) on the whole orbit, so that each epsilon "
      "from epsilon* to pi - epsilon* belongs to this one c, such as 0.4, 0.9 and 1.4, as sin^2 "
      "0.4 > u",
      [&](precision bits) {
        const sine_and_cosine at = sin_cos(exactly(rational(2, 5), bits));
        return all_of(
            {passes_half_phase(usual, 2, u, bits), below(exactly(u.upper, bits), square(at.sine))});
      });
  e.fact(
      "appendix B says that the period T_phi(c) is a decreasing function: by lemma 6 T_phi = 2 "
      "F(-bu,u) decreases in u = -c/b and so increases in c, for a = 12.65, b = 0.0629 from c = "
      "-b/2 to -b/8",
      [&](precision bits) {
        return below(half_phase(usual.a, usual.b, rational(1, 2), bits),
                     half_phase(usual.a, usual.b, rational(1, 8), bits));
      });
  const body first{2, rational(1, 4)};
  const body second{4, rational(1, 100)};
  e.fact(
      "section 7 says that by lemma 5, which is for one b, epsilon0 is smallest as a -> infinity: "
      "for one b bodies are physical up to a = 1/b - 2 only, and between physical bodies of "
      "different b a greater a may have a greater epsilon0: for a = 2, b = 1/4 it is below 1/2, "
      "for a = 4, b = 1/100 above (what follows is so: the claim limit_minimum)",
      [&](precision bits) -> tri {
        if (first.kind() < 0 || second.kind() < 0) return false;
        // F(0, sin^2 epsilon) - 2 pi decreases in epsilon and is 0 at epsilon0.
        const interval zero = exactly(0, bits);
        return all_of({below(separatrix_equation(first)(rational(1, 2), bits), zero),
                       below(zero, separatrix_equation(second)(rational(1, 2), bits))});
      });
  e.steps();
}

}  // namespace

claim errata_claim() { return {statements::errata(), check_errata}; }

}  // namespace polhode::checker
