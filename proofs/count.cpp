// How often C and S meet: the paper's theorem 4, sharpened. The argument:
// proofs/arguments/count.md.

#include <algorithm>
#include <string>

#include "proofs/claims.hpp"
#include "proofs/turning_points.hpp"
#include "statements/count.hpp"

namespace polhode::proofs {
namespace {

/// Dyadic numbers around the square roots of 0 < least <= greatest, as close as these numbers are
/// long: with s = floor(sqrt(floor(4^m q))), s/2^m <= sqrt(q) < (s + 1)/2^m.
root_bracket around_roots(const rational& least, const rational& greatest) {
  const auto length = [](const integer& n) {
    return static_cast<long>(mpz_sizeinbase(n.backend().data(), 2));
  };
  const long m = length(numerator(least)) + length(denominator(least));
  const integer scale = integer(1) << static_cast<unsigned>(m);
  const auto root = [&](const rational& q) {
    return integer(sqrt(integer(numerator(q) * scale * scale / denominator(q))));
  };
  return {rational(root(least), scale), rational(root(greatest) + 1, scale)};
}

/// The number, or where it is irrational the whole n with 64 bits and n/2^k < x < (n + 1)/2^k.
rational_range around(const exact_real& x) {
  if (x.is_rational()) return {x.exact(), x.exact()};
  constexpr precision bits = 64;
  const integer least = integer(1) << 63U;
  rational unit = 1;
  while (x < rational(least * unit)) unit /= 2;
  integer n = floor_of(rational(lower_rational(x.at(2 * bits)) / unit));
  while (rational((n + 1) * unit) < x) ++n;
  return {rational(n * unit), rational((n + 1) * unit)};
}

/// The slope of S, c = -b u with u = sin(epsilon)^2, and of C, which is tangent to it:
/// -b sin(2 epsilon), with epsilon = arcsin sqrt(u) for k odd, pi less that for k even. The ends of
/// its range are dyadic: their decimals are rounded in one way only.
void add_slopes(certificate& c, const rational_range& b, int k, const root_bracket& u) {
  const auto product = [](const rational& at) { return rational(at * (1 - at)); };
  const auto [least, greatest] = std::minmax({product(u.lower), product(u.upper)});
  const rational half(1, 2);
  const bool has_middle = u.lower < half && half < u.upper;
  c.facts.push_back(
      {statements::fill(statements::slopes_at_meeting,
                        {std::to_string(k), k % 2 == 0 ? "" : "-",
                         in_decimals(around_roots(
                             4 * b.low * b.low * least,
                             4 * b.high * b.high * (has_middle ? product(half) : greatest)))}),
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
        [&](int k, const root_bracket& u) { add_slopes(c, around(rigid.b()), k, u); });
  } else {
    add_absence(c, rigid, 2);
  }
  c.conclude();
  return c;
}

}  // namespace

claim count_claim() { return {statements::count(), prove_count}; }

}  // namespace polhode::proofs
