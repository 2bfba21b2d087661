// PARI, whose results have no error bound, and MPFI's intervals, beside the certified ones.
//
// PARI is called through its library. Behind each of its rows stands the error that its result has,
// measured against the certified value; its intnum is given the ends, with exponential decay where
// they are infinite, and nothing else, as one does who does not know better. Without PARI its
// columns are empty; without MPFI there is no table of it.

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/legendre.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/measure.hpp"

#ifdef POLHODE_HAVE_MPFI
#include <mpfi.h>
#endif
#ifdef POLHODE_HAVE_PARI
// Its macros take many a name: it is the last.
#include "support/pari.hpp"
#endif

namespace {

using polhode::ball;
using namespace polhode::bench;
using bench_row = polhode::bench::row;  // PARI has another

#ifdef POLHODE_HAVE_PARI
using pari_function = GEN (*)(void*, GEN);
#endif

#ifdef POLHODE_HAVE_PARI
using pari_call = std::function<GEN(long prec)>;
#define WITH_PARI(...) __VA_ARGS__
#else
struct pari_call {};
#define WITH_PARI(...) \
  {}
#endif

/// Ours beside PARI's to so many digits, and the error of what that gives against the value.
outcome beside_pari(const std::function<void()>& ours, [[maybe_unused]] const pari_call& theirs,
                    [[maybe_unused]] const std::function<ball()>& value,
                    [[maybe_unused]] long digits) {
  bench_row race;
  race.contestants = {warm(ours)};
#ifdef POLHODE_HAVE_PARI
  const long prec = ndec2prec(digits);
  race.contestants.push_back(
      warm([&] { with_stack([&] { benchmark::DoNotOptimize(theirs(prec)); }); }));
  race.ratios = {{0, 1}};
  outcome result = polhode::bench::detail::measure(race);
  with_stack(
      [&] { result.remark = "   PARI's error: " + error_text(theirs(prec), value(), digits); });
  return result;
#else
  return polhode::bench::detail::measure(race);
#endif
}

struct integral_case {
  std::string name;
  std::function<polhode::integral(const polhode::integrate_options&)> ours;
  pari_call theirs;
};

std::vector<integral_case> integrals() {
  using polhode::end_point;
  using polhode::integrate;
  using polhode::integrate_options;
  return {
      {"4/(1+x^2)",
       [](const integrate_options& o) {
         return integrate([](const auto& x) { return 4 / (1 + square(x)); }, 0, 1, o);
       },
       WITH_PARI([](long prec) {
         const pari_function f = [](void*, GEN x) { return gdivsg(4, gaddgs(gsqr(x), 1)); };
         return intnum(nullptr, f, gen_0, gen_1, nullptr, prec);
       })},
      {"4 sqrt(1-x^2)",
       [](const integrate_options& o) {
         return integrate([](const auto& x) { return 4 * sqrt(1 - square(x)); }, 0, 1, o);
       },
       WITH_PARI([](long prec) {
         const pari_function f = [](void*, GEN x) {
           return gmulsg(4, gsqrt(gsubsg(1, gsqr(x)), realprec(x)));
         };
         return intnum(nullptr, f, gen_0, gen_1, nullptr, prec);
       })},
      {"sin(x+e^x)",
       [](const integrate_options& o) {
         return integrate([](const auto& x) { return sin(x + exp(x)); }, 0, 8, o);
       },
       WITH_PARI([](long prec) {
         const pari_function f = [](void*, GEN x) {
           return gsin(gadd(x, gexp(x, realprec(x))), realprec(x));
         };
         return intnum(nullptr, f, gen_0, stoi(8), nullptr, prec);
       })},
      {"e^(-x^2)",
       [](const integrate_options& o) {
         return integrate([](const auto& x) { return exp(-square(x)); }, -end_point::infinity(),
                          end_point::infinity(), o);
       },
       WITH_PARI([](long prec) {
         const pari_function f = [](void*, GEN x) { return gexp(gneg(gsqr(x)), realprec(x)); };
         return intnum(nullptr, f, mkvec2(mkmoo(), gen_1), mkvec2(mkoo(), gen_1), nullptr, prec);
       })},
      {"|quartic| e^x",
       [](const integrate_options& o) {
         return integrate(
             [](const auto& x) { return abs((((x + 10) * x + 19) * x - 6) * x - 6) * exp(x); }, 0,
             1, o);
       },
       WITH_PARI([](long prec) {
         const pari_function f = [](void*, GEN x) {
           const GEN cubic = gsubgs(gmul(gaddgs(gmul(gaddgs(x, 10), x), 19), x), 6);
           const GEN quartic = gsubgs(gmul(cubic, x), 6);
           return gmul(gabs(quartic, realprec(x)), gexp(x, realprec(x)));
         };
         return intnum(nullptr, f, gen_0, gen_1, nullptr, prec);
       })},
  };
}

outcome of_integral(const integral_case& c, long digits) {
  const auto to_digits = [&c](long n) {
    polhode::integrate_options options;
    options.digits = n;
    return c.ours(options);
  };
  return beside_pari([=] { benchmark::DoNotOptimize(to_digits(digits)); }, c.theirs,
                     [=] { return to_digits(digits + 20).enclosure; }, digits);
}

outcome of_elliptic(long digits) {
  const auto k = [](polhode::precision p) {
    return polhode::elliptic_k(ball(polhode::rational(1, 4), p));
  };
  // PARI's is of the modulus, k = 1/2.
  return beside_pari([=] { benchmark::DoNotOptimize(k(polhode::bits_for_digits(digits) + 8)); },
                     WITH_PARI([](long prec) { return ellK(real2n(-1, prec), prec); }),
                     [=] { return k(polhode::bits_for_digits(2 * digits)); }, digits);
}

#ifdef POLHODE_HAVE_MPFI
class mpfi_number {
 public:
  mpfi_number(unsigned long n, polhode::precision p) {
    mpfi_init2(x_, p);
    mpfi_set_ui(x_, n);
    mpfi_sqrt(x_, x_);
  }
  ~mpfi_number() { mpfi_clear(x_); }
  mpfi_number(const mpfi_number&) = delete;
  mpfi_number& operator=(const mpfi_number&) = delete;
  mpfi_number(mpfi_number&&) = delete;
  mpfi_number& operator=(mpfi_number&&) = delete;
  [[nodiscard]] mpfi_ptr get() { return x_; }

 private:
  mpfi_t x_;
};

using ball_operation = void (*)(ball&, const ball&, const ball&);
using mpfi_operation = int (*)(mpfi_ptr, mpfi_srcptr, mpfi_srcptr);

bench_row of_intervals(ball_operation ours, mpfi_operation theirs, polhode::precision p) {
  const auto x = sqrt(ball(2, p));
  const auto y = sqrt(ball(3, p));
  const auto a = std::make_shared<mpfi_number>(2, p);
  const auto b = std::make_shared<mpfi_number>(3, p);
  const auto c = std::make_shared<mpfi_number>(1, p);
  bench_row race;
  race.contestants = {
      warm([=, z = ball(0, p)]() mutable {
        ours(z, x, y);
        benchmark::DoNotOptimize(z);
      }),
      warm([=] { benchmark::DoNotOptimize(theirs(c->get(), a->get(), b->get())); })};
  race.ratios = {{0, 1}};
  return race;
}
#endif

}  // namespace

int main(int argc, char** argv) {
#ifdef POLHODE_HAVE_PARI
  start_pari();
#endif
  suite benchmarks;
  constexpr int label_width = 20;
  const table of_integrals{"integrals",
                           "certified integrals, and PARI's intnum, which is not",
                           {"Polhode", "PARI"},
                           {"/PARI"},
                           label_width};
  for (const long digits : {50L, 100L}) {
    for (const integral_case& c : integrals()) {
      benchmarks.add_measured(of_integrals, c.name + ", " + std::to_string(digits),
                              [c, digits] { return of_integral(c, digits); });
    }
  }
  const table of_k{"K",
                   "K(m = 1/4), certified, and PARI's ellK, which is not",
                   {"Polhode", "PARI"},
                   {"/PARI"},
                   label_width};
  for (const long digits : {50L, 1000L, 10'000L}) {
    benchmarks.add_measured(of_k, std::to_string(digits), [digits] { return of_elliptic(digits); });
  }
#ifdef POLHODE_HAVE_MPFI
  const table of_mpfi{"MPFI",
                      "operations on balls, and on MPFI's intervals, which keep two ends",
                      {"Polhode", "MPFI"},
                      {"/MPFI"},
                      label_width};
  for (const polhode::precision p : {64L, 333L, 3333L}) {
    const auto add_row = [&](const std::string& name, ball_operation ours, mpfi_operation theirs) {
      benchmarks.add(of_mpfi, name + '/' + std::to_string(p),
                     [=] { return of_intervals(ours, theirs, p); });
    };
    add_row(
        "add", [](ball& z, const ball& x, const ball& y) { add(z, x, y); }, mpfi_add);
    add_row(
        "mul", [](ball& z, const ball& x, const ball& y) { multiply(z, x, y); }, mpfi_mul);
    add_row(
        "div", [](ball& z, const ball& x, const ball& y) { divide(z, x, y); }, mpfi_div);
  }
#endif
  return benchmarks.main(argc, argv);
}
