// The program with a fault in the first route of each command, put in by the linker (--wrap): its
// second route must find it.

#include <utility>

#include "polhode/expression/expression.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/roots/isolate.hpp"
#include "proofs/claim.hpp"

namespace polhode {
namespace {

/// Off by a part in 10^15 of itself, and as narrow as before.
ball shifted(const ball& x) { return x * (1 + rational(1, 1'000'000'000'000'000)); }

}  // namespace

// The names are those that --wrap gives to the functions of tests/CMakeLists.txt.

integral
right_integral(const detail::integrand& f, const end_point& a, const end_point& b, const integrate_options& options) __asm__(
    "__real__ZN7polhode6detail18integrate_functionERKNS0_9integrandERKNS_"
    "9end_pointES6_RKNS_17integrate_optionsE");
integral
wrong_integral(const detail::integrand& f, const end_point& a, const end_point& b, const integrate_options& options) __asm__(
    "__wrap__ZN7polhode6detail18integrate_functionERKNS0_9integrandERKNS_"
    "9end_pointES6_RKNS_17integrate_optionsE");
integral wrong_integral(const detail::integrand& f, const end_point& a, const end_point& b,
                        const integrate_options& options) {
  integral result = right_integral(f, a, b, options);
  if (options.rule == quadrature_rule::automatic) result.enclosure = shifted(result.enclosure);
  return result;
}

root_set
right_roots(const real_function& f, const end_point& lower, const end_point& upper, const isolate_options& options) __asm__(
    "__real__ZN7polhode13isolate_rootsERKNS_13real_functionERKNS_9end_"
    "pointES5_RKNS_15isolate_optionsE");
root_set
wrong_roots(const real_function& f, const end_point& lower, const end_point& upper, const isolate_options& options) __asm__(
    "__wrap__ZN7polhode13isolate_rootsERKNS_13real_functionERKNS_9end_"
    "pointES5_RKNS_15isolate_optionsE");
/// Loses the last root when it is called first.
root_set wrong_roots(const real_function& f, const end_point& lower, const end_point& upper,
                     const isolate_options& options) {
  static int calls = 0;
  root_set result = right_roots(f, lower, upper, options);
  if (calls++ == 0 && !result.regions.empty()) result.regions.pop_back();
  return result;
}

ball right_value(const expression* f,
                 precision p) __asm__("__real__ZNK7polhode10expression5valueEl");
ball wrong_value(const expression* f,
                 precision p) __asm__("__wrap__ZNK7polhode10expression5valueEl");
ball wrong_value(const expression* f, precision p) { return shifted(right_value(f, p)); }

ball right_constant(const proofs::constant& c, long digits) __asm__(
    "__real__ZN7polhode6proofs17enclose_to_digitsERKNS0_8constantEl");
ball wrong_constant(const proofs::constant& c, long digits) __asm__(
    "__wrap__ZN7polhode6proofs17enclose_to_digitsERKNS0_8constantEl");
ball wrong_constant(const proofs::constant& c, long digits) {
  return shifted(right_constant(c, digits));
}

}  // namespace polhode
