#include "proofs/parameter_a.hpp"

namespace polhode::proofs {

body with_double_a(const body& rigid) { return {2 * rigid.a(), rigid.b()}; }

}  // namespace polhode::proofs
