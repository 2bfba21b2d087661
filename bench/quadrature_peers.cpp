// The same integral, certified, by the periodic trapezoidal rule and by Arb's acb_calc_integrate:
// G(1/4) for a = 12.65, b = 0.0629, half the Montgomery phase of the paper's eq. (mon5).
//
// "cold" is the first call in a process, which is what a command-line user pays: constants, tables
// and nodes are not yet made. "warm" is a later one. Every figure is taken in a child process, so
// that this one stays cold; the clock starts at the call.

#include <string>

#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "support/measure.hpp"

#ifdef POLHODE_HAVE_ARB
#include <acb_calc.h>

#include "support/arb_number.hpp"
#endif

namespace {

using namespace polhode;
using namespace polhode::bench;

const oscillating_motion motion{rational(1265, 100), rational(629, 10000), rational(1, 4)};

ball with_polhode(long digits) {
  const periodic_integral result =
      integrate_periodic(half_phase_integrand(motion), bits_for_digits(digits));
  if (result.verdict != status::certified) throw std::logic_error("the integral is not certified");
  return result.enclosure;
}

#ifdef POLHODE_HAVE_ARB
/// The parameters at a precision.
struct parameters {
  explicit parameters(precision p) {
    set(a, motion.a, p);
    set(b, motion.b, p);
    set(u, motion.u, p);
    set(one_minus_u, 1 - motion.u, p);
  }
  arb_number a, b, u, one_minus_u;

 private:
  static void set(arb_number& x, const rational& q, precision p) {
    arb_set_si(x.get(), static_cast<slong>(numerator(q)));
    arb_div_si(x.get(), x.get(), static_cast<slong>(denominator(q)), p);
  }
};

class acb_number {
 public:
  acb_number() { acb_init(value_); }
  acb_number(const acb_number&) = delete;
  acb_number& operator=(const acb_number&) = delete;
  ~acb_number() { acb_clear(value_); }
  [[nodiscard]] acb_ptr get() { return value_; }

 private:
  acb_t value_;
};

/// (1 - b x) / sqrt(b x (a + b x)) at x = u + (1 - u) sin^2 t: of the forms tried, with one square
/// root or two, its reciprocal, cos^2 t + u sin^2 t, the one that serves acb_calc_integrate best.
/// With order != 0 the answer must be that of an analytic function, and is indeterminate elsewhere.
int integrand(acb_ptr result, const acb_t t, void* data, slong order, slong p) {
  auto& [a, b, u, one_minus_u] = *static_cast<parameters*>(data);
  acb_number bx;
  acb_number product;
  acb_sin(bx.get(), t, p);
  acb_mul(bx.get(), bx.get(), bx.get(), p);
  acb_mul_arb(bx.get(), bx.get(), one_minus_u.get(), p);
  acb_add_arb(bx.get(), bx.get(), u.get(), p);
  acb_mul_arb(bx.get(), bx.get(), b.get(), p);
  acb_add_arb(product.get(), bx.get(), a.get(), p);
  acb_mul(product.get(), product.get(), bx.get(), p);
  acb_sqrt_analytic(product.get(), product.get(), order != 0 ? 1 : 0, p);
  acb_neg(bx.get(), bx.get());
  acb_add_ui(bx.get(), bx.get(), 1, p);
  acb_div(result, bx.get(), product.get(), p);
  return 0;
}

/// Twice the integral over [0, pi/2]: our rule uses that symmetry too.
void with_arb(arb_ptr result, long digits) {
  const precision bits = bits_for_digits(digits);
  const precision p = bits + 16;
  parameters of_integrand(p);
  acb_number zero;
  acb_number end;
  acb_number value;
  arb_const_pi(acb_realref(end.get()), p);
  acb_mul_2exp_si(end.get(), end.get(), -1);
  mag_t tolerance;
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, -bits);
  acb_calc_integrate(value.get(), integrand, &of_integrand, zero.get(), end.get(), bits, tolerance,
                     nullptr, p);
  mag_clear(tolerance);
  arb_mul_2exp_si(result, acb_realref(value.get()), 1);
}
#endif

row comparison(long digits) {
  const auto ours = [digits] { benchmark::DoNotOptimize(with_polhode(digits)); };
  row r;
  r.contestants = {cold(ours), warm_in_child(ours)};
  r.ratios = {{0, 1}};
#ifdef POLHODE_HAVE_ARB
  (void)in_child([digits] {
    arb_number theirs;
    with_arb(theirs.get(), digits);
    require_agreement(with_polhode(digits), theirs.get(), bits_for_digits(digits) - 8);
    return 0.0;
  });
  const auto theirs = [digits, result = arb_number()]() mutable { with_arb(result.get(), digits); };
  r.contestants.push_back(cold(theirs));
  r.contestants.push_back(warm_in_child(theirs));
  const bool limited = digits == 1000;
  r.ratios.push_back({2, 0, limited ? std::optional(at_least(30)) : std::nullopt});
  r.ratios.push_back({3, 1, limited ? std::optional(at_least(5)) : std::nullopt});
#endif
  return r;
}

}  // namespace

int main(int argc, char** argv) {
  suite benchmarks;
  table t{
      "G(1/4)",
      "G(1/4), certified, to so many digits: the periodic trapezoidal rule and acb_calc_integrate\n"
      "(/warm: our cold time over our warm one; x cold, x warm: so many times faster than Arb)",
      {"ours cold", "ours warm"},
      {"/warm"}};
#ifdef POLHODE_HAVE_ARB
  t.contestants.insert(t.contestants.end(), {"Arb cold", "Arb warm"});
  t.ratios.insert(t.ratios.end(), {"x cold", "x warm"});
#endif
  for (const long digits : {30L, 100L, 300L, 1000L}) {
    benchmarks.add(t, std::to_string(digits), [digits] { return comparison(digits); });
  }
  return benchmarks.main(argc, argv);
}
