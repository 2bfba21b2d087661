#include "polhode/certificate/certificate_of.hpp"

#include <vector>

#include "polhode/arithmetic/exact.hpp"

namespace polhode {

json certificate_of(const formula_over_range& what, const integral& found, long digits) {
  if (found.verdict != status::certified) {
    throw input_error("no certificate: the integral is not certified");
  }
  return integral_certificate(what, found.enclosure, digits);
}

void expect_checkable(const root_set& found) {
  if (found.identically_zero) throw input_error("the formula is 0 everywhere");
  if (!found.zero_intervals.empty()) throw input_error("the formula is 0 on an interval");
  if (found.of_period) throw input_error("the roots are those of one period, not of the range");
  if (!found.singular.empty()) {
    throw input_error(
        "the formula is not defined everywhere in the range; give one in which it is");
  }
  for (const root_region& r : found.regions) {
    if (r.multiplicity > 1) throw input_error("there is a multiple root; it must be simple");
    if (r.verdict == root_verdict::isolated) {
      throw input_error("there is a root at a kink or branch point; it must be simple");
    }
    if (r.verdict == root_verdict::infinitely_many) {
      throw input_error("there are infinitely many roots; give a range with a last one");
    }
  }
  if (!found.is_resolved() || !found.complete) {
    throw input_error("not every place is proved to hold one root; a certificate has no open ones");
  }
}

json certificate_of(const formula_over_range& what, const root_set& found, long digits) {
  // The certificate's numbers are wider than the enclosures.
  constexpr long more_digits = 8;
  expect_checkable(found);
  std::vector<ball> enclosures;
  enclosures.reserve(found.regions.size());
  for (const root_region& r : found.regions) {
    enclosures.push_back(refine(r, digits + more_digits).enclosure);
  }
  return roots_certificate(what, enclosures, digits);
}

}  // namespace polhode
