// The paper's constants, certified, against the same written by hand on Arb.
//
// beta is the root of f(x) = agm(sqrt(1+x), sqrt(x)) - 1/2. The peer is Newton's iteration as one
// who knows Arb well would write it (see beta_with_arb): arb_agm for f, one AGM of half the
// precision for f', precision doubling from a start in hardware numbers, and interval Newton as the
// last step, which makes the whole a proof at the price of that step alone.
//
// With --memory DIGITS the program does one thing: it encloses beta to so many digits and prints
// the greatest memory that the process has held.

#include <cmath>
#include <string>

#include <sys/resource.h>

#include "polhode/arithmetic/text.hpp"
#include "proofs/claim.hpp"
#include "support/measure.hpp"

#ifdef POLHODE_HAVE_ARB
#include "support/arb_number.hpp"
#endif

namespace {

using namespace polhode;
using namespace polhode::bench;

const proofs::constant& constant_named(const std::string& name) {
  const proofs::constant* c = proofs::find_constant(name);
  if (c == nullptr) throw std::logic_error("no constant is named " + name);
  return *c;
}

#ifdef POLHODE_HAVE_ARB

/// Newton's iteration on Arb's balls for f(x) = agm(sqrt(1+x), sqrt(x)) - 1/2, with a proof. The
/// storage is used again from call to call.
class beta_with_arb {
 public:
  /// The enclosure of the only root of f in the box that the last step starts from, to `bits` bits.
  arb_srcptr operator()(precision bits) {
    std::vector<precision> schedule;  // the bits that each step ends with
    for (precision p = bits; p > 48; p = p / 2 + 4) schedule.push_back(p);
    arf_set_d(arb_midref(x_.get()), approximate_root());
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
  /// image <- m - f(m) / f'(X) for m the midpoint of X = x, to p bits: f with p bits, f' with half
  /// of them.
  void step(precision p) {
    const precision full = p + 16;
    const precision half = p / 2 + 16;
    slope(half);
    arb_get_mid_arb(middle_.get(), x_.get());
    arb_add_ui(t_.get(), middle_.get(), 1, full);
    arb_sqrt(t_.get(), t_.get(), full);
    arb_sqrt(value_.get(), middle_.get(), full);
    arb_agm(value_.get(), value_.get(), t_.get(), full);
    arb_mul_2exp_si(value_.get(), value_.get(), 1);
    arb_sub_ui(value_.get(), value_.get(), 1, full);
    arb_mul_2exp_si(value_.get(), value_.get(), -1);
    arb_div(value_.get(), value_.get(), slope_.get(), half);
    arb_sub(image_.get(), middle_.get(), value_.get(), full);
  }

  /// slope <- f'(X) = M/(2x) E/K = M (x + 1/2 - sum over n >= 1 of 2^(n-1) c_n^2) / (2 x (1+x)),
  /// from one AGM a_n, b_n of sqrt(1+x), sqrt(x), with c_n = (a_{n-1} - b_{n-1})/2.
  void slope(precision p) {
    arb_add_ui(t_.get(), x_.get(), 1, p);
    arb_sqrt(a_.get(), t_.get(), p);
    arb_sqrt(b_.get(), x_.get(), p);
    arb_set_d(sum_.get(), 0.5);
    arb_add(sum_.get(), sum_.get(), x_.get(), p);
    for (slong n = 1;; ++n) {
      arb_sub(c_.get(), a_.get(), b_.get(), p);
      arb_mul_2exp_si(c_.get(), c_.get(), -1);
      const bool last = arf_cmpabs_2exp_si(arb_midref(c_.get()), -p / 2 - 8) < 0;
      arb_sqr(c_.get(), c_.get(), p);
      if (!last) arb_mul(d_.get(), a_.get(), b_.get(), p);
      arb_add(a_.get(), a_.get(), b_.get(), p);
      arb_mul_2exp_si(a_.get(), a_.get(), -1);
      if (last)
        arb_add_error(a_.get(), c_.get());  // M > 1/4: 0 < a_n - M < c_n^2 / (2 M) < 2 c_n^2
      if (last) arb_add_error(a_.get(), c_.get());
      arb_mul_2exp_si(c_.get(), c_.get(), n - 1);
      arb_sub(sum_.get(), sum_.get(), c_.get(), p);
      if (last) break;
      arb_sqrt(b_.get(), d_.get(), p);
    }
    arb_add_error(sum_.get(), c_.get());  // the rest of the sum is less than its last term
    arb_mul(sum_.get(), sum_.get(), a_.get(), p);
    arb_mul(t_.get(), t_.get(), x_.get(), p);
    arb_mul_2exp_si(t_.get(), t_.get(), 1);
    arb_div(slope_.get(), sum_.get(), t_.get(), p);
  }

  static double approximate_root() {
    double x = 0.03;
    for (int i = 0; i < 5; ++i) {
      double a = std::sqrt(1 + x);
      double b = std::sqrt(x);
      double sum = x + 0.5;
      for (double weight = 1; weight < 64; weight *= 2) {
        const double c = (a - b) / 2;
        sum -= weight * c * c;
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
      }
      x -= (a - 0.5) * 2 * x * (1 + x) / (a * sum);
    }
    return x;
  }

  arb_number x_, image_, middle_, value_, slope_, a_, b_, c_, d_, t_, sum_;
};

/// pi - 2 atan(exp(pi)).
void epsilon0_min_with_arb(arb_ptr result, precision p) {
  arb_const_pi(result, p);
  arb_exp(result, result, p);
  arb_atan(result, result, p);
  arb_mul_2exp_si(result, result, 1);
  arb_number pi_number;
  arb_const_pi(pi_number.get(), p);
  arb_sub(result, pi_number.get(), result, p);
}
#endif

row beta(long digits) {
  const proofs::constant& c = constant_named("beta");
  row r;
  r.contestants = {
      warm([&c, digits] { benchmark::DoNotOptimize(proofs::enclose_to_digits(c, digits)); })};
#ifdef POLHODE_HAVE_ARB
  const precision bits = bits_for_digits(digits) + 8;
  beta_with_arb newton;
  require_agreement(proofs::enclose_to_digits(c, digits), newton(bits), bits_for_digits(digits));
  r.contestants.push_back(warm([newton, bits]() mutable { newton(bits); }));
  r.ratios = {{0, 1, at_most(1.5)}};
#endif
  return r;
}

row epsilon0_min(long digits) {
  const proofs::constant& c = constant_named("epsilon0_min");
  row r;
  r.contestants = {
      warm([&c, digits] { benchmark::DoNotOptimize(proofs::enclose_to_digits(c, digits)); })};
#ifdef POLHODE_HAVE_ARB
  const precision bits = bits_for_digits(digits) + 16;
  arb_number x;
  epsilon0_min_with_arb(x.get(), bits);
  require_agreement(proofs::enclose_to_digits(c, digits), x.get(), bits_for_digits(digits));
  r.contestants.push_back(warm([x, bits]() mutable { epsilon0_min_with_arb(x.get(), bits); }));
  r.ratios = {{0, 1}};
#endif
  return r;
}

int print_memory_of_beta(long digits) {
  const auto start = std::chrono::steady_clock::now();
  const ball x = proofs::enclose_to_digits(constant_named("beta"), digits);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::cout << "beta to " << digits
            << " digits: " << (x.is_bounded() ? "certified" : "not certified") << ", "
            << usage.ru_maxrss / 1024 << " MiB at most (limit 1024 at 1000000 digits), "
            << std::setprecision(3) << taken.count() << " s\n";
  return x.is_bounded() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "--memory") {
    const long digits = std::strtol(argv[2], nullptr, 10);
    if (digits >= 1) return print_memory_of_beta(digits);
    std::cerr << "--memory takes a number of digits, 1 or more\n";
    return 2;
  }
  suite benchmarks;
  table betas{"beta", "beta, certified, to so many digits", {"Polhode"}, {}};
  table epsilons{"epsilon0_min", "epsilon0_min, certified, to so many digits", {"Polhode"}, {}};
#ifdef POLHODE_HAVE_ARB
  for (table* t : {&betas, &epsilons}) {
    t->contestants.emplace_back("Arb");
    t->ratios.emplace_back("/Arb");
  }
#endif
  for (const long digits : {50L, 1000L, 10000L}) {
    benchmarks.add(betas, std::to_string(digits), [digits] { return beta(digits); });
  }
  for (const long digits : {50L, 1000L, 10000L}) {
    benchmarks.add(epsilons, std::to_string(digits), [digits] { return epsilon0_min(digits); });
  }
  return benchmarks.main(argc, argv);
}
