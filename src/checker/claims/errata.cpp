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
        statements::fill(
            statements::meant_by_figure_7,
            {m.as_read, m.a, m.right ? "right" : "wrong", std::string(m.in_short) + "..."}),
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
      statements::fill(statements::a_above_1, {"0.86850689..."}),
      water.a > number_in("0.86850689") && water.a < number_in("0.86850690") && water.kind() > 0);
  const body usual = with_ab("12.65", "0.0629");
  e.fact(statements::phase_is_said_to_decrease, [&](precision bits) {
    return below(half_phase(usual.a, usual.b, rational(3, 4), bits),
                 half_phase(usual.a, usual.b, rational(1, 4), bits));
  });
  const range c0{number_in("0.0002473696968432"), number_in("0.0002473696968435")};
  e.fact(statements::fill(statements::range_of_c0, {in_decimals(c0, e.work())}),
         [&](precision bits) { return passes_rotating_phase(usual, 2, c0, bits); });
  const body planar{1, rational(1, 3)};
  e.fact(statements::planar_body,
         planar.squared_I() == 1 && planar.kind() == 0 && planar.crossings() == 0);
  const body once = with_ab("18.27", "0.0629");
  e.fact(statements::one_meeting, once.kind() < 0 && once.intersections() == 1);
  const body twice = with_ab("39.95", "0.0629");
  e.fact(statements::exactly_n_plus_1, twice.is_above_I(rational(2, 3)) &&
                                           !twice.is_above_I(rational(2, 5)) &&
                                           twice.intersections() == 2);
  const body at_two{rational(77, 40), rational(1, 10)};
  e.fact(statements::no_meeting_at_2, at_two.squared_I() == 4 && at_two.intersections() == 0);
  const range u{number_in("0.053943792"), number_in("0.053943793")};
  e.fact(statements::many_epsilon_for_one_c, [&](precision bits) {
    const sine_and_cosine at = sin_cos(exactly(rational(2, 5), bits));
    return all_of(
        {passes_half_phase(usual, 2, u, bits), below(exactly(u.upper, bits), square(at.sine))});
  });
  e.fact(statements::period_is_said_to_decrease, [&](precision bits) {
    return below(half_phase(usual.a, usual.b, rational(1, 2), bits),
                 half_phase(usual.a, usual.b, rational(1, 8), bits));
  });
  const body first{2, rational(1, 4)};
  const body second{4, rational(1, 100)};
  e.fact(statements::epsilon0_across_b, [&](precision bits) -> tri {
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
