// The Montgomery phase and the curve C. The ratios are to a full product of as many bits, since a
// time depends on the machine:
//   phase:   dphi for a = 12.65, b = 0.0629 at one c, oscillating and rotating, warm;
//   epsilon: epsilon(c) of the same body over 1,000 values of c in (-b, b), by twist_to_digits; one
//     call is all of them.

#include <string>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "support/measure.hpp"

namespace {

using namespace polhode;
using namespace polhode::bench;

body rigid() { return {parse_rational("12.65"), parse_rational("0.0629")}; }

contestant products(precision p, long count) {
  const ball x = sqrt(ball(2, p));
  const ball y = sqrt(ball(3, p));
  return warm([x, y, count] {
    for (long k = 0; k < count; ++k) benchmark::DoNotOptimize(ball(x * y));
  });
}

row phase(const char* c, long digits) {
  const precision p = bits_for_digits(digits) + 8;
  row r;
  r.contestants = {warm([c = parse_rational(c), p] {
                     benchmark::DoNotOptimize(montgomery_phase(rigid(), c, p));
                   }),
                   products(p, 1)};
  r.ratios = {{0, 1}};
  return r;
}

constexpr long values_of_c = 1000;

row curve(long digits) {
  row r;
  r.contestants = {
      warm([digits] {
        const body top = rigid();
        for (long k = 0; k < values_of_c; ++k) {
          const rational c(top.b().exact() * rational(2 * k + 1 - values_of_c, values_of_c));
          benchmark::DoNotOptimize(twist_to_digits(top, c, digits, with_slope::no).epsilon);
        }
      }),
      products(bits_for_digits(digits), values_of_c)};
  r.ratios = {{0, 1}};
  return r;
}

}  // namespace

int main(int argc, char** argv) {
  suite benchmarks;
  const table phases{"phase",
                     "the Montgomery phase at one c, by digits",
                     {"Polhode", "product"},
                     {"/product"},
                     20};
  for (const long digits : {50L, 1000L, 10'000L}) {
    const std::string n = std::to_string(digits);
    benchmarks.add(phases, "c = -0.03, " + n, [digits] { return phase("-0.03", digits); });
    benchmarks.add(phases, "c = 0.01, " + n, [digits] { return phase("0.01", digits); });
  }
  const table curves{"epsilon",
                     "epsilon(c) over 1,000 values of c, by digits, and 1,000 products",
                     {"Polhode", "product"},
                     {"/product"}};
  for (const long digits : {15L, 100L}) {
    benchmarks.add(curves, std::to_string(digits), [digits] { return curve(digits); });
  }
  return benchmarks.main(argc, argv);
}
