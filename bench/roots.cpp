// Roots, against Newton's iteration written by hand on Arb.
//
// The peer for x = cos x is Newton's iteration as one who knows Arb well would write it: cos for f,
// sin of half the precision for f', precision doubling from a start in hardware numbers, and
// interval Newton as the last step, which makes the whole a proof at the price of that step alone.
// Polhode is timed with the search: from the interval [0, 1] to the digits. The other tables have
// no peer: times, and evaluations for each root. The table "published" has the two searches of the
// manual of IntervalRootFinding.jl, whose times are in docs/roots.md.

#include <cmath>
#include <string>
#include <vector>

#include "polhode/arithmetic/text.hpp"
#include "polhode/roots/isolate.hpp"
#include "support/measure.hpp"

#ifdef POLHODE_HAVE_ARB
#include "support/arb_number.hpp"
#endif

namespace {

using namespace polhode;
using namespace polhode::bench;

const auto cosine_minus_x = [](const auto& x) { return cos(x) - x; };

root_region dottie_region() { return isolate_roots(cosine_minus_x, 0, 1).regions.front(); }
ball dottie_number(long digits) { return refine(dottie_region(), digits).enclosure; }

#ifdef POLHODE_HAVE_ARB

class dottie_with_arb {
 public:
  arb_srcptr operator()(precision bits) {
    std::vector<precision> schedule;  // the bits that each step ends with
    for (precision p = bits; p > 48; p = p / 2 + 4) schedule.push_back(p);
    double start = 0.7;
    for (int i = 0; i < 6; ++i) start -= (std::cos(start) - start) / (-std::sin(start) - 1);
    arf_set_d(arb_midref(x_.get()), start);
    for (std::size_t i = schedule.size(); i-- > 1;) {  // not certified: midpoints only
      mag_zero(arb_radref(x_.get()));
      step(schedule[i]);
      arb_set(x_.get(), image_.get());
    }
    // Certified: if the Newton image of X lies in X, X holds exactly one root, and the image holds
    // it.
    mag_set_ui_2exp_si(arb_radref(x_.get()), 1, -(bits / 2) - 2);
    step(bits);
    if (arb_contains(x_.get(), image_.get()) == 0) throw std::logic_error("Newton on Arb failed");
    return image_.get();
  }

 private:
  /// image <- m - f(m) / f'(X) to p bits, m the middle of X.
  void step(precision p) {
    const precision full = p + 16;
    const precision half = p / 2 + 16;
    arb_sin(slope_.get(), x_.get(), half);
    arb_add_ui(slope_.get(), slope_.get(), 1, half);
    arb_get_mid_arb(middle_.get(), x_.get());
    arb_cos(value_.get(), middle_.get(), full);
    arb_sub(value_.get(), value_.get(), middle_.get(), full);
    arb_div(value_.get(), value_.get(), slope_.get(), half);
    arb_add(image_.get(), middle_.get(), value_.get(), full);
  }

  arb_number x_, image_, middle_, value_, slope_;
};

#endif

/// With the search for the root, or from the box that a search found.
row dottie(long digits, bool with_search) {
  row r;
  if (with_search) {
    r.contestants = {warm([digits] { benchmark::DoNotOptimize(dottie_number(digits)); })};
  } else {
    r.contestants = {warm(
        [digits, found = dottie_region()] { benchmark::DoNotOptimize(refine(found, digits)); })};
  }
#ifdef POLHODE_HAVE_ARB
  const precision bits = bits_for_digits(digits) + 8;
  dottie_with_arb newton;
  require_agreement(dottie_number(digits), newton(bits), bits_for_digits(digits));
  r.contestants.push_back(warm([newton, bits]() mutable { newton(bits); }));
  const bool is_limited = !with_search && digits >= 1000;
  r.ratios = {{0, 1, is_limited ? std::optional(at_most(1.3)) : std::nullopt}};
#endif
  return r;
}

/// All roots of a function, searched and refined to so many digits.
template <class F>
row all_roots(const F& f, long lower, long upper, long digits) {
  row r;
  r.contestants = {warm([f, lower, upper, digits] {
    for (const root_region& region : isolate_roots(f, lower, upper).regions) {
      benchmark::DoNotOptimize(refine(region, digits));
    }
  })};
  return r;
}

/// The search alone.
template <class F>
row search(const F& f, const end_point& lower, const end_point& upper) {
  row r;
  r.contestants = {
      warm([f, lower, upper] { benchmark::DoNotOptimize(isolate_roots(f, lower, upper)); })};
  return r;
}

rational_polynomial wilkinson(long n) {
  rational_polynomial p({rational(1)});
  for (long k = 1; k <= n; ++k) p = p * rational_polynomial({rational(-k), rational(1)});
  return p;
}

template <class F>
void print_count(const std::string& name, const F& f, const end_point& lower,
                 const end_point& upper) {
  const root_set s = isolate_roots(f, lower, upper);
  std::cout << name << ": " << s.regions.size() << " roots, "
            << (s.is_resolved() ? "all proved" : "not all proved") << ", " << s.account.boxes
            << " boxes, " << s.account.evaluations << " evaluations, " << std::fixed
            << std::setprecision(1)
            << static_cast<double>(s.account.evaluations) / static_cast<double>(s.regions.size())
            << " a root\n";
}

}  // namespace

int main(int argc, char** argv) {
  suite benchmarks;
  table dotties{"dottie", "x = cos x: search and so many digits", {"Polhode"}, {}};
#ifdef POLHODE_HAVE_ARB
  dotties.contestants.emplace_back("Arb");
  dotties.ratios.emplace_back("/Arb");
#endif
  table refinements = dotties;
  refinements.name = "refinement";
  refinements.about = "x = cos x: so many digits of the root that a search found";
  table wilkinsons{"wilkinson",
                   "all 20 roots of Wilkinson's polynomial, expanded, to so many digits",
                   {"Polhode"},
                   {}};
  table oscillations{
      "sin_square", "all 1146 roots of sin(x^2) on [0, 60] to so many digits", {"Polhode"}, {}};
  for (const long digits : {50L, 1000L, 10000L}) {
    benchmarks.add(dotties, std::to_string(digits), [digits] { return dottie(digits, true); });
  }
  for (const long digits : {50L, 1000L, 10000L}) {
    benchmarks.add(refinements, std::to_string(digits), [digits] { return dottie(digits, false); });
  }
  for (const long digits : {15L, 100L}) {
    benchmarks.add(wilkinsons, std::to_string(digits),
                   [digits] { return all_roots(real_function::of(wilkinson(20)), 0, 30, digits); });
  }
  for (const long digits : {15L, 100L}) {
    benchmarks.add(oscillations, std::to_string(digits), [digits] {
      return all_roots([](const auto& x) { return sin(square(x)); }, 0, 60, digits);
    });
  }
  const table published{"published", "searches that others publish times of", {"Polhode"}, {}};
  benchmarks.add(published, "log(x) on [-2, 2]",
                 [] { return search([](const auto& x) { return log(x); }, -2, 2); });
  benchmarks.add(published, "cos(x) sin(1/x) on [1/20, 1]", [] {
    return search([](const auto& x) { return cos(x) * sin(1 / x); }, rational(1, 20), 1);
  });
  const int status = benchmarks.main(argc, argv);
  if (status == 0) {
    std::cout << '\n';
    print_count(
        "sin(x^2) on [0, 60]", [](const auto& x) { return sin(square(x)); }, 0, 60);
    print_count(
        "sin(1/x) on [1/1000, 1]", [](const auto& x) { return sin(1 / x); }, rational(1, 1000), 1);
    print_count("Wilkinson, degree 20", real_function::of(wilkinson(20)), 0, 30);
  }
  return status;
}
