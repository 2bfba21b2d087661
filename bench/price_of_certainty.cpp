// What certainty costs: the periodic trapezoidal rule for G(1/4) (a = 12.65, b = 0.0629) with the
// same nodes at the same precision,
//   certified  integrate_periodic: the search for a strip, its proof, the rule in balls, the bound;
//   ball       the rule alone, in balls;
//   float      the rule alone, in uncertified mpfr_float, from the same template;
//   by hand    the rule alone, uncertified, in calls of MPFR on storage that is used again.

#include <cmath>
#include <string>

#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "support/measure.hpp"

namespace {

using namespace polhode;
using namespace polhode::bench;

const oscillating_motion motion{rational(1265, 100), rational(629, 10000), rational(1, 4)};

/// periodic_trapezoid_sum<mpfr_float> of half_phase_integrand as one would write it in C: the same
/// nodes from the same tables, rounding to nearest, no certainty. Even n only.
class sum_by_hand {
 public:
  sum_by_hand(long n, precision p) : n_(n), p_(p) {
    for (cell* c : {&x_, &bx_, &root_, &node_, &sum_, &step_, &a_, &b_, &mean_, &half_, &root_b_}) {
      c->reset(p);
    }
    set(a_, motion.a.exact());
    set(b_, motion.b.exact());
    set(mean_, rational((1 + motion.u) / 2));
    set(half_, rational((1 - motion.u) / 2));
  }

  void operator()() {
    mpfr_sqrt(root_b_.get(), b_.get(), MPFR_RNDN);
    mpfr_const_pi(step_.get(), MPFR_RNDN);
    mpfr_div_si(step_.get(), step_.get(), 2 * n_, MPFR_RNDN);
    const long pairs = n_ / 2;
    const auto block = static_cast<long>(std::ceil(std::sqrt(static_cast<double>(pairs))));
    cell c(p_);
    cell s(p_);
    mpfr_sin_cos(s.get(), c.get(), step_.get(), MPFR_RNDN);
    const circle fine(c, s, 2 * block + 1, *this);
    const circle coarse(fine.cosines.back(), fine.sines.back(), (pairs + block - 1) / block, *this);
    mpfr_set_zero(sum_.get(), 1);
    for (long k = 0; k < pairs; ++k) {
      const auto i = static_cast<std::size_t>(k / block);
      const auto j = static_cast<std::size_t>(2 * (k % block) + 1);
      mpfr_mul(node_.get(), coarse.cosines[i].get(), fine.cosines[j].get(), MPFR_RNDN);
      mpfr_mul(x_.get(), coarse.sines[i].get(), fine.sines[j].get(), MPFR_RNDN);
      mpfr_sub(node_.get(), node_.get(), x_.get(), MPFR_RNDN);
      add_integrand();
      mpfr_neg(node_.get(), node_.get(), MPFR_RNDN);
      add_integrand();
    }
    mpfr_mul_2si(step_.get(), step_.get(), 1, MPFR_RNDN);
    mpfr_mul(sum_.get(), sum_.get(), step_.get(), MPFR_RNDN);
  }

  [[nodiscard]] mpfr_srcptr value() const { return sum_.get(); }

 private:
  using cell = polhode::detail::mpfr_cell;

  static void set(cell& x, const rational& q) {
    mpfr_set_q(x.get(), q.backend().data(), MPFR_RNDN);
  }

  /// Powers of a point on the unit circle, as in detail::circle_powers.
  struct circle {
    std::vector<cell> cosines, sines;
    circle(const cell& c, const cell& s, long count, sum_by_hand& of) {
      cosines.assign(static_cast<std::size_t>(count), cell(of.p_));
      sines = cosines;
      mpfr_set_si(cosines[0].get(), 1, MPFR_RNDN);
      for (std::size_t j = 1; j < cosines.size(); ++j) {
        const std::size_t low = j / 2;
        const std::size_t high = j - low;
        if (j == 1) {
          cosines[j] = c;
          sines[j] = s;
          continue;
        }
        mpfr_mul(cosines[j].get(), cosines[low].get(), cosines[high].get(), MPFR_RNDN);
        mpfr_mul(of.x_.get(), sines[low].get(), sines[high].get(), MPFR_RNDN);
        mpfr_sub(cosines[j].get(), cosines[j].get(), of.x_.get(), MPFR_RNDN);
        mpfr_mul(sines[j].get(), sines[low].get(), cosines[high].get(), MPFR_RNDN);
        mpfr_mul(of.x_.get(), cosines[low].get(), sines[high].get(), MPFR_RNDN);
        mpfr_add(sines[j].get(), sines[j].get(), of.x_.get(), MPFR_RNDN);
      }
    }
  };

  /// sum += (1 - b x) / (sqrt(b) sqrt(x (a + b x))) at x = mean + half * node.
  void add_integrand() {
    mpfr_mul(x_.get(), half_.get(), node_.get(), MPFR_RNDN);
    mpfr_add(x_.get(), x_.get(), mean_.get(), MPFR_RNDN);
    mpfr_mul(bx_.get(), b_.get(), x_.get(), MPFR_RNDN);
    mpfr_add(root_.get(), a_.get(), bx_.get(), MPFR_RNDN);
    mpfr_mul(root_.get(), root_.get(), x_.get(), MPFR_RNDN);
    mpfr_sqrt(root_.get(), root_.get(), MPFR_RNDN);
    mpfr_mul(root_.get(), root_.get(), root_b_.get(), MPFR_RNDN);
    mpfr_si_sub(bx_.get(), 1, bx_.get(), MPFR_RNDN);
    mpfr_div(bx_.get(), bx_.get(), root_.get(), MPFR_RNDN);
    mpfr_add(sum_.get(), sum_.get(), bx_.get(), MPFR_RNDN);
  }

  long n_;
  precision p_;
  cell x_, bx_, root_, node_, sum_, step_, a_, b_, mean_, half_, root_b_;
};

row comparison(long digits) {
  const half_phase_integrand integrand(motion);
  const precision bits = bits_for_digits(digits);
  const periodic_integral certified = integrate_periodic(integrand, bits);
  const long n = certified.plan.nodes;
  const precision p = certified.precision;
  if (certified.verdict != status::certified || certified.evaluations != n) {
    throw std::logic_error("the integral took more than one precision, or is not certified");
  }
  const auto in_floats = [=] { return periodic_trapezoid_sum<mpfr_float>(integrand, n, p); };
  if (!overlaps(ball(in_floats()).enlarged(magnitude::power_of_two(16 - p)), certified.enclosure)) {
    throw std::logic_error("mpfr_float's value is not that of the certified rule");
  }
  const long even = n + n % 2;
  sum_by_hand by_hand(even, p);
  by_hand();
  if (!overlaps(ball(by_hand.value()).enlarged(magnitude::power_of_two(16 - p)),
                certified.enclosure)) {
    throw std::logic_error("the value by hand is not that of the certified rule");
  }
  row r;
  r.contestants = {
      warm([=] { benchmark::DoNotOptimize(integrate_periodic(integrand, bits)); }),
      warm([=] { benchmark::DoNotOptimize(periodic_trapezoid_sum<ball>(integrand, n, p)); }),
      warm([=] { benchmark::DoNotOptimize(in_floats()); }),
      warm([by_hand]() mutable { by_hand(); }),
  };
  std::optional<ratio_limit> bound;
  if (digits == 100) bound = at_most(1.3);
  if (digits >= 1000) bound = at_most(1.1);
  r.ratios = {{0, 2, bound}, {0, 3}};
  return r;
}

}  // namespace

int main(int argc, char** argv) {
  suite benchmarks;
  const table t{"certainty",
                "G(1/4) to so many digits by one rule: certified, and as plain floating point",
                {"certified", "ball", "float", "by hand"},
                {"/float", "/hand"}};
  for (const long digits : {30L, 100L, 300L, 1000L, 3000L}) {
    benchmarks.add(t, std::to_string(digits), [digits] { return comparison(digits); });
  }
  return benchmarks.main(argc, argv);
}
