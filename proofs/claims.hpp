#pragma once

// The functions that make the claims: name_claim(), each in a file of its own.

#include "proofs/claim.hpp"
#include "statements/list.hpp"

namespace polhode::proofs {

#define POLHODE_DECLARATION(name, subject) [[nodiscard]] claim name##_claim();
POLHODE_CLAIMS(POLHODE_DECLARATION)
#undef POLHODE_DECLARATION

}  // namespace polhode::proofs
