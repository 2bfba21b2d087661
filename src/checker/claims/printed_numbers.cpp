// The numbers of the paper that are right.

#include "statements/printed_numbers.hpp"
#include "constants.hpp"
#include "list.hpp"
#include "printed.hpp"

namespace polhode::checker {
namespace {

void check_printed_numbers(examination& e) {
  e.read_no_inputs();
  const auto I = [](const char* a) { return I_of(with_ab(a, "0.0629")); };
  check_printed(
      e,
      {{"figure 6", "I for a = 39.95, b = 0.0629", "0.59", "0.59", 2, "0.5906913359", I("39.95")},
       {"figure 6", "I for a = 18.27, b = 0.0629", "0.87", "0.87", 2, "0.8726599209", I("18.27")},
       {"figure 6", "I for a = 12.65, b = 0.0629", "1.05", "1.05", 2, "1.047944541", I("12.65")},
       {"figure 6", "I for a = 3.1, b = 0.0629", "2.1", "2.1", 1, "2.100960486", I("3.1")},
       {"eq. (39)", "epsilon0_min", "0.086374", "0.086374", 6, "0.08637409704", epsilon0_min},
       {"eq. (40)", "beta", "0.028973", "0.028973", 6, "0.02897322803", nullptr},
       {"section 7", "delta_psi_max", "2.96884", "2.96884", 5, "2.968844459", delta_psi_max},
       {"section 8", "I for water, equilibrium", "1.001", "1.001", 3, "1.000557630",
        I_of(water_at_equilibrium())}},
      true);
}

}  // namespace

claim printed_numbers_claim() { return {statements::printed_numbers(), check_printed_numbers}; }

}  // namespace polhode::checker
