#pragma once

#include "examination.hpp"

namespace polhode::checker {

void check_beta(examination& e);
void check_sign_dF_du(examination& e);

}  // namespace polhode::checker
