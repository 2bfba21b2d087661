// How often C and S meet: the paper's theorem 4, sharpened. The argument:
// proofs/arguments/count.md.

#include <algorithm>
#include <string>

#include "proofs/claims.hpp"
#include "proofs/turning_points.hpp"
#include "statements/count.hpp"

namespace polhode::proofs {
namespace {

/// The slope of S, c = -b u with u = sin(epsilon)^2, and of C, which is tangent to it, by the range
/// of u (1 - u), whose ends are dyadic as u's are: their decimals are rounded in one way only.
void add_slopes(certificate& c, int k, const root_bracket& u) {
  const auto product = [](const rational& at) { return rational(at * (1 - at)); };
  const auto [least, greatest] = std::minmax({product(u.lower), product(u.upper)});
  const rational half(1, 2);
  const bool has_middle = u.lower < half && half < u.upper;
  c.facts.push_back(
      {statements::fill(
           statements::slopes_at_meeting,
           {std::to_string(k), in_decimals({least, has_middle ? product(half) : greatest})}),
       least > 0, step_kind::exact});
}

certificate prove_count(const request& wanted) {
  certificate c;
  add_steps(c, statements::count().steps);
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const integer count = count_intersections(rigid);
  c.witness["N"] = count.str();
  const auto q = [](const integer& k) { return rational(integer(2), integer(2 * k - 1)); };
  c.facts.push_back({statements::fill(statements::number_of_meetings, {counted(count)}),
                     (count == 0 || exceeds_geometric_constant(q(count), rigid)) &&
                         !exceeds_geometric_constant(q(count + 1), rigid),
                     step_kind::exact});
  if (count > 0) {
    add_brackets(
        c, rigid, count, [&](int k) { return q(k); }, "intersections",
        [&](int k, const root_bracket& u) { add_slopes(c, k, u); });
  } else {
    add_absence(c, rigid, 2);
  }
  c.conclude();
  return c;
}

}  // namespace

claim count_claim() { return {statements::count(), prove_count}; }

}  // namespace polhode::proofs
