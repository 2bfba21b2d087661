// Elliptic integrals against Debian's Arb, in one run: the complete third kind and K, the
// incomplete third kind, and in hardware doubles against Boost.Math.
//
// The integrals are those of the Montgomery phase, for a = 12.65, b = 0.0629:
//   complete:   G(u),    R_F(0, u, v) and R_J(0, u, v, 1), v = (a + bu)/(a + b), u = 1/4;
//   incomplete: F(c, u), R_F(X, Y, Z) and R_J(X, Y, Z, 1), c = 1/100, u = 1/10.
// Peers: acb_elliptic_rf and acb_elliptic_rj; an AGM with Bartky's sum as one who knows Arb well
// would write it; arb_agm for K. With --growth the program prints how the time of each grows
// between 1,000 and 100,000 digits, beside a product.

#include <cmath>
#include <cstring>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "polhode/elliptic/jacobi.hpp"
#include "polhode/elliptic/legendre.hpp"
#include "support/measure.hpp"

#ifdef POLHODE_HAVE_ARB
#include <acb_elliptic.h>

#include "support/arb_number.hpp"
#endif

namespace {

using namespace polhode;
using namespace polhode::bench;

precision bits_of(long digits) {
  return static_cast<precision>(std::ceil(3.3219280948873626 * static_cast<double>(digits))) + 8;
}

struct arguments {
  rational x, y, z;
};
arguments complete_arguments() {
  const rational a = parse_rational("12.65");
  const rational b = parse_rational("0.0629");
  const rational u(1, 4);
  return {0, u, rational((a + b * u) / (a + b))};
}
arguments incomplete_arguments() {
  const rational a = parse_rational("12.65");
  const rational b = parse_rational("0.0629");
  const rational c = parse_rational("0.01");
  const rational u = parse_rational("0.1");
  return {u, rational((a + b * u) / (a + b)), rational((c + b * u) / (c + b))};
}

carlson_pair ours(const arguments& at, precision p) {
  return carlson_rf_rj(ball(at.x, p), ball(at.y, p), ball(at.z, p), ball(1, p));
}

#ifdef POLHODE_HAVE_ARB

void set(arb_ptr r, const rational& q, precision p) {
  fmpq_t exact;
  fmpq_init(exact);
  fmpq_set_mpq(exact, q.backend().data());
  arb_set_fmpq(r, exact, p);
  fmpq_clear(exact);
}

/// acb_elliptic_rf and acb_elliptic_rj.
class carlson_with_arb {
 public:
  carlson_with_arb(const arguments& at, precision p) : p_(p) {
    set(acb_realref(x_.get()), at.x, p);
    set(acb_realref(y_.get()), at.y, p);
    set(acb_realref(z_.get()), at.z, p);
    acb_one(one_.get());
  }
  void operator()() {
    acb_elliptic_rf(rf_.get(), x_.get(), y_.get(), z_.get(), 0, p_);
    acb_elliptic_rj(rj_.get(), x_.get(), y_.get(), z_.get(), one_.get(), 0, p_);
  }
  /// acb_elliptic_rj alone.
  void third() { acb_elliptic_rj(rj_.get(), x_.get(), y_.get(), z_.get(), one_.get(), 0, p_); }
  arb_srcptr rj() { return acb_realref(rj_.get()); }

 private:
  precision p_;
  acb_number x_, y_, z_, one_, rf_, rj_;
};

/// R_F(0, y, z) and R_J(0, y, z, 1) by the AGM of sqrt z and sqrt y and Bartky's sum: with p = 1, Q
/// = 1, p' = (p^2 + A g)/(2p), Q' = Q/2 (p^2 - A g)/(p^2 + A g). What is left out is at most 2|Q|;
/// M lies in [g, A].
class bartky_with_arb {
 public:
  bartky_with_arb(const arguments& at, precision p) : p_(p) {
    set(y_.get(), at.y, p);
    set(z_.get(), at.z, p);
  }
  void operator()() {
    arb_sqrt(a_.get(), z_.get(), p_);
    arb_sqrt(g_.get(), y_.get(), p_);
    arb_one(s_.get());
    arb_one(q_.get());
    arb_one(sum_.get());
    while (true) {
      arb_mul(ag_.get(), a_.get(), g_.get(), p_);
      arb_sqr(ss_.get(), s_.get(), p_);
      arb_add(t_.get(), ss_.get(), ag_.get(), p_);
      arb_sub(ss_.get(), ss_.get(), ag_.get(), p_);
      arb_mul_2exp_si(s_.get(), s_.get(), 1);
      arb_div(s_.get(), t_.get(), s_.get(), p_);
      arb_div(ss_.get(), ss_.get(), t_.get(), p_);
      arb_mul(q_.get(), q_.get(), ss_.get(), p_);
      arb_mul_2exp_si(q_.get(), q_.get(), -1);
      arb_add(sum_.get(), sum_.get(), q_.get(), p_);
      arb_sub(t_.get(), a_.get(), g_.get(), p_);
      arb_add(a_.get(), a_.get(), g_.get(), p_);
      arb_mul_2exp_si(a_.get(), a_.get(), -1);
      const bool done = arf_cmpabs_2exp_si(arb_midref(t_.get()), -p_ / 2 - 8) < 0 &&
                        arf_cmpabs_2exp_si(arb_midref(q_.get()), -p_) < 0;
      if (done) break;
      arb_sqrt(g_.get(), ag_.get(), p_);
    }
    arb_sqr(t_.get(), t_.get(), 64);  // 0 <= A - M <= (A_(n-1) - g_(n-1))^2 / (8 M), and M > 1/4
    arb_add_error(a_.get(), t_.get());
    arb_mul_2exp_si(q_.get(), q_.get(), 1);
    arb_add_error(sum_.get(), q_.get());
    arb_const_pi(rf_.get(), p_);
    arb_div(rf_.get(), rf_.get(), a_.get(), p_);
    arb_mul_2exp_si(rf_.get(), rf_.get(), -1);
    arb_mul(rj_.get(), rf_.get(), sum_.get(), p_);
    arb_mul_ui(rj_.get(), rj_.get(), 3, p_);
    arb_mul_2exp_si(rj_.get(), rj_.get(), -1);
  }
  arb_srcptr rj() { return rj_.get(); }

 private:
  precision p_;
  arb_number y_, z_, a_, g_, s_, q_, sum_, ag_, ss_, t_, rf_, rj_;
};
#endif

row complete_third_kind(long digits, double least, bool with_rj) {
  const precision p = bits_of(digits);
  const arguments at = complete_arguments();
  row r;
  r.contestants = {warm([at, p] { benchmark::DoNotOptimize(ours(at, p)); })};
#ifdef POLHODE_HAVE_ARB
  bartky_with_arb by_hand(at, p);
  by_hand();
  require_agreement(ours(at, p).rj, by_hand.rj(), p - 24);
  r.contestants.push_back(warm([by_hand]() mutable { by_hand(); }));
  r.ratios = {{0, 1, at_most(1.3)}};
  if (with_rj) {
    carlson_with_arb rj(at, p);
    rj.third();
    require_agreement(ours(at, p).rj, rj.rj(), p - 24);
    r.contestants.push_back(warm([rj]() mutable { rj.third(); }));
    r.ratios.push_back({2, 0, at_least(least)});
  }
#else
  static_cast<void>(least), static_cast<void>(with_rj);
#endif
  return r;
}

row incomplete_third_kind(long digits, std::optional<ratio_limit> limit) {
  const precision p = bits_of(digits);
  const arguments at = incomplete_arguments();
  row r;
  r.contestants = {warm([at, p] { benchmark::DoNotOptimize(ours(at, p)); })};
#ifdef POLHODE_HAVE_ARB
  carlson_with_arb both(at, p);
  both();
  require_agreement(ours(at, p).rj, both.rj(), p - 24);
  r.contestants.push_back(warm([both]() mutable { both(); }));
  r.ratios = {{1, 0, limit}};
#else
  static_cast<void>(limit);
#endif
  return r;
}

row first_kind(long digits) {
  const precision p = bits_of(digits);
  row r;
  r.contestants = {warm([p] { benchmark::DoNotOptimize(elliptic_k(ball(rational(1, 4), p))); })};
#ifdef POLHODE_HAVE_ARB
  acb_number m;
  acb_number k;
  set(acb_realref(m.get()), rational(1, 4), p);
  r.contestants.push_back(warm([m, k, p]() mutable { acb_elliptic_k(k.get(), m.get(), p); }));
  arb_number x;
  arb_number y;
  // pi / (2 agm(1, sqrt(1 - m))), with the real AGM.
  r.contestants.push_back(warm([m, x, y, p]() mutable {
    arb_sub_ui(x.get(), acb_realref(m.get()), 1, p);
    arb_neg(x.get(), x.get());
    arb_sqrt(x.get(), x.get(), p);
    arb_one(y.get());
    arb_agm(x.get(), x.get(), y.get(), p);
    arb_const_pi(y.get(), p);
    arb_div(x.get(), y.get(), x.get(), p);
    arb_mul_2exp_si(x.get(), x.get(), -1);
  }));
  r.ratios = {{0, 1, at_most(1.2)}, {0, 2, at_most(1.2)}};
#endif
  return r;
}

/// Calls of f and g in turns over many arguments, so that no branch is learnt by heart.
template <class F, class G>
row in_double(F f, G g) {
  const auto over = [](auto h) {
    return [h, i = 0]() mutable {
      i = (i + 1) % 1024;
      benchmark::DoNotOptimize(h((i + 0.5) / 1024));
    };
  };
  row r;
  r.contestants = {warm(over(f)), warm(over(g))};
  r.ratios = {{0, 1, at_most(2)}};
  return r;
}

double seconds_once(const std::function<void()>& f) {
  f();
  double best = 1e9;
  for (int i = 0; i < 3; ++i) best = std::min(best, seconds_of(f, 1));
  return best;
}

/// The exponents e of time ~ digits^e between 1,000 and 100,000 digits.
int print_growth() {
  const auto line = [](const char* name, const std::function<void(precision)>& f) {
    const precision low = bits_of(1000);
    const precision high = bits_of(100'000);
    const double first = seconds_once([&] {
                           for (int i = 0; i < 20; ++i) f(low);
                         }) /
                         20;
    const double last = seconds_once([&] { f(high); });
    std::cout << std::left << std::setw(40) << name << std::right << std::setw(12)
              << polhode::bench::detail::time_text(first) << std::setw(12)
              << polhode::bench::detail::time_text(last) << std::fixed << std::setprecision(2)
              << std::setw(8) << std::log10(last / first) / 2 << '\n';
  };
  const auto number = [](const rational& q, precision p) { return ball(q, p); };
  std::cout << std::left << std::setw(40) << ""
            << "  1,000 digits  100,000  exponent\n";
  line("product (mpfr_mul)", [&](precision p) {
    const ball x = number(rational(1, 3), p);
    const ball y = number(rational(2, 7), p);
    benchmark::DoNotOptimize(ball(x * y));
  });
  line("K(1/4)",
       [&](precision p) { benchmark::DoNotOptimize(elliptic_k(number(rational(1, 4), p))); });
  line("E(1/4)", [&](precision p) {
    benchmark::DoNotOptimize(elliptic_e(elliptic_parameter<ball>(number(rational(1, 4), p))));
  });
  line("D(1/4)", [&](precision p) {
    benchmark::DoNotOptimize(elliptic_d(elliptic_parameter<ball>(number(rational(1, 4), p))));
  });
  line("R_F, R_J of G(1/4)",
       [&](precision p) { benchmark::DoNotOptimize(ours(complete_arguments(), p)); });
  line("R_F, R_J of F(0.01, 0.1)",
       [&](precision p) { benchmark::DoNotOptimize(ours(incomplete_arguments(), p)); });
  line("sn(1/2 | 1/4)", [&](precision p) {
    benchmark::DoNotOptimize(jacobi_sn(ball(rational(1, 2), p), ball(rational(1, 4), p)));
  });
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--growth") == 0) return print_growth();
  suite benchmarks;
  table complete{"complete",
                 "G(1/4): R_F(0,u,v) and R_J(0,u,v,1); rj: acb_elliptic_rj alone",
                 {"Polhode"},
                 {}};
  table incomplete{"incomplete", "F(0.01, 0.1): R_F(X,Y,Z) and R_J(X,Y,Z,1)", {"Polhode"}, {}};
  table first{"K", "K(1/4)", {"Polhode"}, {}};
#ifdef POLHODE_HAVE_ARB
  complete.contestants = {"Polhode", "by hand", "rj"};
  complete.ratios = {"/by hand", "rj/"};
  incomplete.contestants = {"Polhode", "Arb"};
  incomplete.ratios = {"Arb/"};
  first.contestants = {"Polhode", "acb", "arb_agm"};
  first.ratios = {"/acb", "/arb_agm"};
#endif
  const std::pair<long, double> sizes[] = {{100, 5}, {1000, 20}, {10'000, 80}, {100'000, 1}};
  for (const auto& [digits, least] : sizes) {
    const long n = digits;
    const double limit = least;
    benchmarks.add(complete, std::to_string(n),
                   [n, limit] { return complete_third_kind(n, limit, n <= 10'000); });
  }
  for (const long n : {50L, 100L, 1000L, 10'000L}) {
    std::optional<ratio_limit> limit;
    if (n == 1000) limit = at_least(4);
    if (n == 10'000) limit = at_least(15);
    benchmarks.add(incomplete, std::to_string(n),
                   [n, limit] { return incomplete_third_kind(n, limit); });
  }
  for (const long n : {50L, 1000L, 10'000L, 100'000L}) {
    benchmarks.add(first, std::to_string(n), [n] { return first_kind(n); });
  }
  const table doubles{
      "double", "in hardware doubles, over 1024 arguments", {"Polhode", "Boost"}, {"/Boost"}, 20};
  benchmarks.add(doubles, "K", [] {
    return in_double([](double x) { return elliptic_k(x); },
                     [](double x) { return boost::math::ellint_1(std::sqrt(x)); });
  });
  benchmarks.add(doubles, "E", [] {
    return in_double([](double x) { return elliptic_e(x); },
                     [](double x) { return boost::math::ellint_2(std::sqrt(x)); });
  });
  benchmarks.add(doubles, "Pi(n|m)", [] {
    return in_double([](double x) { return elliptic_pi(0.9 * x, x); },
                     [](double x) { return boost::math::ellint_3(std::sqrt(x), 0.9 * x); });
  });
  benchmarks.add(doubles, "F(phi|m)", [] {
    return in_double([](double x) { return elliptic_f(1.4 * x, x); },
                     [](double x) { return boost::math::ellint_1(std::sqrt(x), 1.4 * x); });
  });
  benchmarks.add(doubles, "E(phi|m)", [] {
    return in_double([](double x) { return elliptic_e(1.4 * x, x); },
                     [](double x) { return boost::math::ellint_2(std::sqrt(x), 1.4 * x); });
  });
  benchmarks.add(doubles, "Pi(n;phi|m)", [] {
    return in_double(
        [](double x) { return elliptic_pi(0.9 * x, 1.4 * x, x); },
        [](double x) { return boost::math::ellint_3(std::sqrt(x), 0.9 * x, 1.4 * x); });
  });
  benchmarks.add(doubles, "R_F", [] {
    return in_double([](double x) { return carlson_rf(x, 1.0, 2.0); },
                     [](double x) { return boost::math::ellint_rf(x, 1.0, 2.0); });
  });
  benchmarks.add(doubles, "R_J", [] {
    return in_double([](double x) { return carlson_rj(x, 1.0, 2.0, 3.0); },
                     [](double x) { return boost::math::ellint_rj(x, 1.0, 2.0, 3.0); });
  });
  benchmarks.add(doubles, "sn, cn, dn", [] {
    return in_double(
        [](double x) { return jacobi_elliptic(3 * x, elliptic_parameter<double>(x)).sn; },
        [](double x) {
          double cn = 0;
          double dn = 0;
          return boost::math::jacobi_elliptic(std::sqrt(x), 3 * x, &cn, &dn);
        });
  });
  return benchmarks.main(argc, argv);
}
