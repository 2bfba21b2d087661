#pragma once

// The functions that make the claims as the checker has them: name_claim(), each in a file here.

#include "checker/claim.hpp"
#include "statements/list.hpp"

namespace polhode::checker {

#define POLHODE_CHECKER_DECLARATION(name, subject) [[nodiscard]] claim name##_claim();
POLHODE_CLAIMS(POLHODE_CHECKER_DECLARATION)
#undef POLHODE_CHECKER_DECLARATION

}  // namespace polhode::checker
