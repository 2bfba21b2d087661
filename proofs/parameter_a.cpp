#include "proofs/parameter_a.hpp"

namespace polhode::proofs {

body with_double_a(const body& rigid) {
  return {rational(2 * rigid.a().exact()), rigid.b().exact()};
}

}  // namespace polhode::proofs
