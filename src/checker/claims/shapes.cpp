#include "shapes.hpp"

#include "answers.hpp"
#include "checker/elliptic.hpp"
#include "checker/functions.hpp"
#include "statements/shared.hpp"

namespace polhode::checker {
namespace {

/// The root of `square` less `less`: as a fact where it is rational, else as a number.
void check_constant(examination& e, const std::string& name, const real& square, long less,
                    const std::function<interval(precision bits)>& f) {
  rational root;
  if (square.is_rational() && exact_root(square.exact(), root)) {
    e.fact(statements::fill(statements::exact_constant, {name, rational(root - less).str()}), true);
  } else {
    e.number(name, f);
  }
}

}  // namespace

body check_body_and_steps(examination& e) {
  e.read_body();
  e.steps();
  return body_of(e);
}

void check_steps_only(examination& e) {
  e.read_no_inputs();
  e.steps();
}

void check_I(examination& e) {
  const body rigid = body_of(e);
  check_constant(e, "I", rigid.squared_I(), 0, [&](precision bits) { return rigid.I(bits); });
}

void check_J(examination& e) {
  const body rigid = body_of(e);
  check_constant(e, "J", rigid.squared_J_plus_1(), 1,
                 [&](precision bits) { return rigid.J(bits); });
}

tri phase_obeys_its_bounds(const interval& limit,
                           const std::function<bounded_phase(int quarter)>& at) {
  std::optional<interval> before;
  tri result = true;
  for (const int quarter : {1, 2, 3}) {
    const auto [value, least, most] = at(quarter);
    result = all_of({result, below(limit, value), below(least, value), below(value, most),
                     before ? below(value, *before) : tri(true)});
    before = value;
  }
  return result;
}

tri half_phase_obeys_its_bounds(const body& rigid, precision bits) {
  const real& a = rigid.a;
  const real& b = rigid.b;
  const interval limit = pi(bits) * rigid.I(bits);
  return phase_obeys_its_bounds(limit, [&](int quarter) -> bounded_phase {
    const rational u(quarter, 4);
    const interval ratio =
        exactly((1 - b * u) / (1 - b), bits) * sqrt(exactly((a + b) / (u * (a + b * u)), bits));
    return {half_phase(a, b, u, bits),
            (rigid.I(bits) * asinh(pi(bits) / sqrt(exactly(rational(4 * u), bits)))).scaled(1),
            limit * ratio};
  });
}

}  // namespace polhode::checker
