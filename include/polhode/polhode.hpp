#pragma once

// All that a program needs most: numbers and their text, integrals, roots, elliptic functions,
// rigid bodies, formulas and second opinions. Each part has a header of its own, which compiles
// sooner. Certificates and scenes are not among these.

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "polhode/elliptic/complete.hpp"
#include "polhode/elliptic/jacobi.hpp"
#include "polhode/elliptic/legendre.hpp"
#include "polhode/elliptic/theta.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/integrate_box.hpp"
#include "polhode/rigid_body/body.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "polhode/rigid_body/rotor.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "polhode/roots/isolate.hpp"
#include "polhode/roots/newton.hpp"
#include "polhode/roots/systems.hpp"
#include "polhode/verify/second_integral.hpp"
#include "polhode/verify/second_roots.hpp"
#include "polhode/verify/second_value.hpp"
#include "polhode/version.hpp"
