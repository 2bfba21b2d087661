// Integrals, certified, by polhode::integrate and by Arb's acb_calc_integrate; and G(1/4) by the
// periodic trapezoidal rule too. For a = 12.65, b = 0.0629, G(u) is half the Montgomery phase of
// oscillating motion and F(c, u) the incomplete integral behind it:
//
//   F(c, u) = integral over (u, 1) of (1 - b x) / sqrt(x (1 - x) (a + b x) (b x + c)) dx,  G(u) =
//   F(-b u, u).
//
// "cold" is the first call in a process, which is what a command-line user pays: constants, tables
// and nodes are not yet made, and we have no directory of nodes; "on disk" is the same with the
// nodes in a directory. "warm" is a later call. Every figure is taken in a child process, so that
// this one stays cold; the clock starts at the call, and is the processor's time for this process,
// of which other programs on the machine take nothing. A child of Arb's answers only if the two
// results overlap and both are as accurate as was asked.
//
// Arb has every integrand in the form that serves it best of those tried, says by its flag where it
// is analytic, and does not raise its precision: it is given the guard bits that it turned out to
// need. Infinite ranges are cut off for it, with a bound of the rest.
//
// "sqrt(z), a path" is the integral along straight lines from 1 over 1 + i to -1 + i, which do not
// meet the cut. It is compared by the sum of its real and its imaginary part.

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "support/measure.hpp"
#include "tests/support/scratch_directory.hpp"

#ifdef POLHODE_HAVE_ARB
#include <acb_calc.h>

#include "support/arb_number.hpp"
#endif

namespace {

using namespace polhode;
using namespace polhode::bench;

const rational a_of_body(1265, 100);
const rational b_of_body(629, 10000);

ball certified(const integral& i) {
  if (i.verdict == status::certified) return i.enclosure;
  throw std::logic_error("our integral is not certified: " + i.obstacle);
}

template <class F>
std::function<ball(long digits)> ours(F f, end_point from, end_point to) {
  return [=](long digits) {
    integrate_options options;
    options.digits = digits;
    return certified(integrate(f, from, to, options));
  };
}

/// The sum of both parts of the integral along the path.
ball root_along_a_path(long digits) {
  const path corner = path::polygon({1, path_point(1, 1), path_point(-1, 1)});
  const contour_integral i =
      integrate_along([](const auto& z) { return sqrt(z); }, corner, {.digits = digits});
  if (i.verdict == status::certified) return i.enclosure.re + i.enclosure.im;
  throw std::logic_error("our integral along a path is not certified: " + i.obstacle);
}

/// f(x, c), where c are constants.
template <class Formula, std::size_t n>
class with_constants {
 public:
  with_constants(Formula f, std::array<rational, n> c) : f_(f), exact_(c) {}
  template <class T>
  [[nodiscard]] T operator()(const T& x) const {
    return f_(x, exact_);
  }

 private:
  Formula f_;
  std::array<rational, n> exact_;
};

constexpr auto sech_of = [](const auto& w) { return 1 / cosh(w); };

#ifdef POLHODE_HAVE_ARB

/// acb_calc_integrate from x = from to x = to, to a relative accuracy of `bits` bits, with so many
/// guard bits.
void integrate_with_arb(arb_ptr result, acb_calc_func_t f, void* data, acb_number& from,
                        acb_number& to, long bits, long guard) {
  acb_number value;
  mag_t tolerance;
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, -bits);
  acb_calc_integrate(value.get(), f, data, from.get(), to.get(), bits, tolerance, nullptr,
                     bits + guard);
  mag_clear(tolerance);
  arb_set(result, acb_realref(value.get()));
}

using arb_integral = std::function<void(arb_ptr result, long bits)>;

arb_integral theirs(acb_calc_func_t f, long from, long to, long guard, long factor = 1) {
  return [=](arb_ptr result, long bits) {
    acb_number a;
    acb_number b;
    acb_set_si(a.get(), from);
    acb_set_si(b.get(), to);
    integrate_with_arb(result, f, nullptr, a, b, bits, guard);
    arb_mul_si(result, result, factor, bits + guard);
  };
}

void set(arb_number& x, const rational& q, precision p) {
  fmpq_t exact;
  fmpq_init(exact);
  fmpq_set_str(exact, to_text(q).c_str(), 10);
  arb_set_fmpq(x.get(), exact, p);
  fmpq_clear(exact);
}

/// (1 - b x) / sqrt(...) at x = u + (1 - u) sin^2 t; the parameters at a precision.
struct phase_parameters {
  phase_parameters(const rational& u_exact, const rational& c_exact, precision p) {
    set(a, a_of_body, p);
    set(b, b_of_body, p);
    set(c, c_exact, p);
    set(u, u_exact, p);
    set(one_minus_u, rational(1 - u_exact), p);
  }
  arb_number a, b, c, u, one_minus_u;
};

/// G: (1 - b x) / sqrt(b x (a + b x)): of the forms tried, with one square root or two, its
/// reciprocal, cos^2 t + u sin^2 t, the one that serves acb_calc_integrate best. With order != 0
/// the answer must be that of an analytic function, and is indeterminate elsewhere.
int phase_on_curve(acb_ptr result, const acb_t t, void* data, slong order, slong p) {
  auto& given = *static_cast<phase_parameters*>(data);
  acb_number bx;
  acb_number product;
  acb_sin(bx.get(), t, p);
  acb_mul(bx.get(), bx.get(), bx.get(), p);
  acb_mul_arb(bx.get(), bx.get(), given.one_minus_u.get(), p);
  acb_add_arb(bx.get(), bx.get(), given.u.get(), p);
  acb_mul_arb(bx.get(), bx.get(), given.b.get(), p);
  acb_add_arb(product.get(), bx.get(), given.a.get(), p);
  acb_mul(product.get(), product.get(), bx.get(), p);
  acb_sqrt_analytic(product.get(), product.get(), order != 0 ? 1 : 0, p);
  acb_neg(bx.get(), bx.get());
  acb_add_ui(bx.get(), bx.get(), 1, p);
  acb_div(result, bx.get(), product.get(), p);
  return 0;
}

/// F: with x = u + (1 - u) sin^2 t, dx = 2 sqrt(1 - x) sqrt(x - u) dt, so that
/// (1 - b x) sqrt(x - u) / sqrt(x (a + b x)(b x + c)) remains, and sqrt(x - u) = sqrt(1 - u) sin t.
int incomplete_phase(acb_ptr result, const acb_t t, void* data, slong order, slong p) {
  auto& given = *static_cast<phase_parameters*>(data);
  acb_number sine;
  acb_number x;
  acb_number bx;
  acb_number product;
  acb_sin(sine.get(), t, p);
  acb_mul(x.get(), sine.get(), sine.get(), p);
  acb_mul_arb(x.get(), x.get(), given.one_minus_u.get(), p);
  acb_add_arb(x.get(), x.get(), given.u.get(), p);
  acb_mul_arb(bx.get(), x.get(), given.b.get(), p);
  acb_add_arb(product.get(), bx.get(), given.a.get(), p);
  acb_mul(product.get(), product.get(), x.get(), p);
  acb_add_arb(x.get(), bx.get(), given.c.get(), p);
  acb_mul(product.get(), product.get(), x.get(), p);
  acb_sqrt_analytic(product.get(), product.get(), order != 0 ? 1 : 0, p);
  acb_neg(bx.get(), bx.get());
  acb_add_ui(bx.get(), bx.get(), 1, p);
  acb_mul(bx.get(), bx.get(), sine.get(), p);
  acb_div(result, bx.get(), product.get(), p);
  return 0;
}

/// Twice the integral over [0, pi/2], times sqrt(1 - u) for F.
arb_integral phase_with_arb(const rational& u, const std::optional<rational>& c) {
  return [=](arb_ptr result, long bits) {
    constexpr long guard = 16;
    const precision p = bits + guard;
    phase_parameters parameters(u, c.value_or(0), p);
    acb_number from;
    acb_number to;
    arb_const_pi(acb_realref(to.get()), p);
    acb_mul_2exp_si(to.get(), to.get(), -1);
    integrate_with_arb(result, c ? incomplete_phase : phase_on_curve, &parameters, from, to, bits,
                       guard);
    arb_mul_2exp_si(result, result, 1);
    if (c) {
      arb_number root;
      arb_sqrt(root.get(), parameters.one_minus_u.get(), p);
      arb_mul(result, result, root.get(), p);
    }
  };
}

int reciprocal_of_1_plus_square(acb_ptr result, const acb_t x, void*, slong, slong p) {
  acb_number y;
  acb_mul(y.get(), x, x, p);
  acb_add_ui(y.get(), y.get(), 1, p);
  acb_inv(result, y.get(), p);
  return 0;
}

int circle(acb_ptr result, const acb_t x, void*, slong order, slong p) {
  acb_number y;
  acb_mul(y.get(), x, x, p);
  acb_sub_ui(y.get(), y.get(), 1, p);
  acb_neg(y.get(), y.get());
  acb_real_sqrtpos(result, y.get(), order != 0 ? 1 : 0, p);
  return 0;
}

int square_root(acb_ptr result, const acb_t z, void*, slong order, slong p) {
  acb_sqrt_analytic(result, z, order != 0 ? 1 : 0, p);
  return 0;
}

void root_along_a_path_with_arb(arb_ptr result, long bits) {
  constexpr long guard = 16;
  mag_t tolerance;
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, -bits);
  std::array<acb_number, 3> points;
  acb_set_si_si(points[0].get(), 1, 0);
  acb_set_si_si(points[1].get(), 1, 1);
  acb_set_si_si(points[2].get(), -1, 1);
  acb_number sum;
  for (std::size_t k = 1; k < points.size(); ++k) {
    acb_number part;
    acb_calc_integrate(part.get(), square_root, nullptr, points[k - 1].get(), points[k].get(), bits,
                       tolerance, nullptr, bits + guard);
    acb_add(sum.get(), sum.get(), part.get(), bits + guard);
  }
  mag_clear(tolerance);
  arb_add(result, acb_realref(sum.get()), acb_imagref(sum.get()), bits + guard);
}

int sine_of_exponential(acb_ptr result, const acb_t x, void*, slong, slong p) {
  acb_number y;
  acb_exp(y.get(), x, p);
  acb_add(y.get(), y.get(), x, p);
  acb_sin(result, y.get(), p);
  return 0;
}

int gaussian(acb_ptr result, const acb_t x, void*, slong, slong p) {
  acb_number y;
  acb_mul(y.get(), x, x, p);
  acb_neg(y.get(), y.get());
  acb_exp(result, y.get(), p);
  return 0;
}

int hyperbolic_secant(acb_ptr result, const acb_t x, void*, slong, slong p) {
  acb_sech(result, x, p);
  return 0;
}

int spikes(acb_ptr result, const acb_t x, void*, slong, slong p) {
  acb_number sum;
  acb_number y;
  for (long k = 1; k <= 3; ++k) {
    const long width = k == 1 ? 10 : (k == 2 ? 100 : 1000);
    acb_mul_si(y.get(), x, width, p);
    arb_sub_si(acb_realref(y.get()), acb_realref(y.get()), 2 * k * width / 10, p);
    acb_sech(y.get(), y.get(), p);
    acb_pow_ui(y.get(), y.get(), static_cast<ulong>(2 * k), p);
    acb_add(sum.get(), sum.get(), y.get(), p);
  }
  acb_set(result, sum.get());
  return 0;
}

int quartic(acb_ptr result, const acb_t x, void*, slong order, slong p) {
  acb_number y;
  acb_number e;
  acb_add_ui(y.get(), x, 10, p);
  for (const long coefficient : {19L, -6L, -6L}) {
    acb_mul(y.get(), y.get(), x, p);
    arb_add_si(acb_realref(y.get()), acb_realref(y.get()), coefficient, p);
  }
  acb_real_abs(y.get(), y.get(), order != 0 ? 1 : 0, p);
  acb_exp(e.get(), x, p);
  acb_mul(result, y.get(), e.get(), p);
  return 0;
}

int greater_of_sine_and_cosine(acb_ptr result, const acb_t x, void*, slong order, slong p) {
  acb_number sine;
  acb_number cosine;
  acb_sin_cos(sine.get(), cosine.get(), x, p);
  acb_real_max(result, sine.get(), cosine.get(), order != 0 ? 1 : 0, p);
  return 0;
}

/// x^1000 e^(-x) as exp(1000 log x - x), over x >= 1: up to 1.5 times faster than with a power.
int thousandth_power(acb_ptr result, const acb_t x, void*, slong order, slong p) {
  acb_number y;
  acb_log_analytic(y.get(), x, order != 0 ? 1 : 0, p);
  acb_mul_ui(y.get(), y.get(), 1000, p);
  acb_sub(y.get(), y.get(), x, p);
  acb_exp(result, y.get(), p);
  return 0;
}

void enlarge(arb_ptr result, arb_number& radius) {
  mag_t bound;
  mag_init(bound);
  arb_get_mag(bound, radius.get());
  arb_add_error_mag(result, bound);
  mag_clear(bound);
}

/// Over [-X, X]; beyond, 2 e^(-X^2)/(2 X) at most.
void gaussian_with_arb(arb_ptr result, long bits) {
  const auto x = static_cast<long>(std::ceil(std::sqrt(static_cast<double>(bits + 4) * 0.6932)));
  theirs(gaussian, -x, x, 16)(result, bits);
  arb_number rest;
  arb_set_si(rest.get(), -x * x);
  arb_exp(rest.get(), rest.get(), 64);
  enlarge(result, rest);
}

/// Over [0, X]; beyond, 2 e^(-X) at most.
void secant_with_arb(arb_ptr result, long bits) {
  const auto x = static_cast<long>(std::ceil(static_cast<double>(bits + 4) * 0.6932));
  theirs(hyperbolic_secant, 0, x, 16)(result, bits);
  arb_number rest;
  arb_set_si(rest.get(), -x);
  arb_exp(rest.get(), rest.get(), 64);
  arb_mul_2exp_si(rest.get(), rest.get(), 1);
  enlarge(result, rest);
}

/// Over [1, X], X > 1000. Before, at most 1/1001. Beyond, the logarithm of the integrand has a
/// slope of at most 1000/X - 1, so that the rest is at most X^1001 e^(-X) / (X - 1000).
void power_with_arb(arb_ptr result, long bits) {
  const double goal = std::lgamma(1001.0) - static_cast<double>(bits + 8) * 0.6932;
  long x = 1050;
  const auto log_of_rest = [](long y) {
    const auto z = static_cast<double>(y);
    return 1001 * std::log(z) - z - std::log(z - 1000);
  };
  while (log_of_rest(x) > goal) x += 25;
  theirs(thousandth_power, 1, x, 48)(result, bits);
  arb_number rest;
  arb_number factor;
  arb_set_si(rest.get(), -x);
  arb_exp(rest.get(), rest.get(), 64);
  arb_set_si(factor.get(), x);
  arb_pow_ui(factor.get(), factor.get(), 1001, 64);
  arb_mul(rest.get(), rest.get(), factor.get(), 64);
  arb_div_si(rest.get(), rest.get(), x - 1000, 64);
  arb_add_ui(rest.get(), rest.get(), 1, 64);
  enlarge(result, rest);
}

#else
using arb_integral = int;
#endif

/// An integral by both.
struct peer {
  std::string name;
  std::function<ball(long digits)> with_polhode;
  arb_integral with_arb;
  double least_cold = 0.67;  // limits at 1,000 digits of how many times faster we are
  double least_warm = 0.67;
  bool in_mean = true;
  bool slow = false;  // at 1,000 digits
};

const auto phase_formula = [](const auto& x, const auto& c) {
  const auto bx = c[1] * x;
  return (1 - bx) / sqrt(x * (1 - x) * (c[0] + bx) * (bx + c[2]));
};
const auto phase_on_curve_formula = [](const auto& t, const auto& c) {
  const auto sine = sin(t);
  const auto bx = c[1] * (c[2] + c[3] * square(sine));
  return 2 * (1 - bx) / sqrt(bx * (c[0] + bx));
};

std::function<ball(long digits)> incomplete_phase_of(const rational& c, const rational& u) {
  return ours(with_constants(phase_formula, std::array{a_of_body, b_of_body, c}), u, 1);
}
std::function<ball(long digits)> phase_on_curve_of(const rational& u) {
  return ours(
      with_constants(phase_on_curve_formula, std::array{a_of_body, b_of_body, u, rational(1 - u)}),
      0, end_point::pi(rational(1, 2)));
}

ball phase_by_periodic_rule(long digits) {
  const oscillating_motion motion{a_of_body, b_of_body, rational(1, 4)};
  const periodic_integral result =
      integrate_periodic(half_phase_integrand(motion), bits_for_digits(digits));
  if (result.verdict != status::certified) throw std::logic_error("the integral is not certified");
  return result.enclosure;
}

std::vector<peer> peers() {
#ifdef POLHODE_HAVE_ARB
#define WITH_ARB(...) __VA_ARGS__
#else
#define WITH_ARB(...) 0
#endif
  const rational quarter(1, 4);
  const rational tiny = parse_rational("1e-12");
  const auto polynomial = [](const auto& x) { return (((x + 10) * x + 19) * x - 6) * x - 6; };
  return {
      {"G(1/4), periodic rule", phase_by_periodic_rule,
       WITH_ARB(phase_with_arb(quarter, std::nullopt)), 30, 5, false},
      {"G(1/4)", phase_on_curve_of(quarter), WITH_ARB(phase_with_arb(quarter, std::nullopt)), 50,
       10},
      {"G(1e-12)", phase_on_curve_of(tiny), WITH_ARB(phase_with_arb(tiny, std::nullopt)), 50, 10},
      {"F(0.01, 0.1)", incomplete_phase_of(rational(1, 100), rational(1, 10)),
       WITH_ARB(phase_with_arb(rational(1, 10), rational(1, 100))), 50, 10},
      {"4/(1+x^2)", ours([](const auto& x) { return 4 / (1 + square(x)); }, 0, 1),
       WITH_ARB(theirs(reciprocal_of_1_plus_square, 0, 1, 16, 4))},
      {"4 sqrt(1-x^2)", ours([](const auto& x) { return 4 * sqrt(1 - square(x)); }, 0, 1),
       WITH_ARB(theirs(circle, 0, 1, 16, 4))},
      {"sin(x+e^x)", ours([](const auto& x) { return sin(x + exp(x)); }, 0, 8),
       WITH_ARB(theirs(sine_of_exponential, 0, 8, 32))},
      {"e^(-x^2)",
       ours([](const auto& x) { return exp(-square(x)); }, -end_point::infinity(),
            end_point::infinity()),
       WITH_ARB(gaussian_with_arb)},
      {"sech x", ours([](const auto& x) { return sech_of(x); }, 0, end_point::infinity()),
       WITH_ARB(secant_with_arb)},
      {"spikes",
       ours(
           [](const auto& x) {
             return pow(sech_of(10 * x - 2), 2) + pow(sech_of(100 * x - 40), 4) +
                    pow(sech_of(1000 * x - 600), 6);
           },
           0, 1),
       WITH_ARB(theirs(spikes, 0, 1, 16))},
      {"|quartic| e^x", ours([=](const auto& x) { return abs(polynomial(x)) * exp(x); }, 0, 1),
       WITH_ARB(theirs(quartic, 0, 1, 32)), 100, 100, true, true},
      {"max(sin, cos)", ours([](const auto& x) { return max(sin(x), cos(x)); }, 0, 6),
       WITH_ARB(theirs(greater_of_sine_and_cosine, 0, 6, 32)), 100, 100, true, true},
      {"x^1000 e^(-x)",
       ours([](const auto& x) { return pow(x, 1000) * exp(-x); }, 0, end_point::infinity()),
       WITH_ARB(power_with_arb)},
      {"sqrt(z), a path", root_along_a_path, WITH_ARB(root_along_a_path_with_arb)},
  };
#undef WITH_ARB
}

/// What a child reports.
struct figures {
  double cold = 0;
  double warm = 0;
  double mebibytes = 0;
};

/// The first call in this process, and later ones: as many as take a hundredth of a second.
template <class F>
figures measure_calls(F f, bool warm_too) {
  figures result;
  result.cold = processor_seconds_of(f, 1);
  rusage used;
  getrusage(RUSAGE_SELF, &used);
  result.mebibytes = static_cast<double>(used.ru_maxrss) / 1024;
  if (!warm_too) return result;
  constexpr double enough = 0.01;
  result.warm = processor_seconds_of(f, 1);
  const auto more = static_cast<long>(enough / std::max(result.warm, 1e-7));
  if (more > 1) result.warm = processor_seconds_of(f, more) / static_cast<double>(more);
  return result;
}

/// Ours, in a child whose node cache is there; "off" for none.
figures measure_ours(const peer& of, long digits, const std::string& cache) {
  return in_child([&] {
    setenv("POLHODE_CACHE", cache.c_str(), 1);
    const bool warm_too = cache == "off";
    return measure_calls([&] { benchmark::DoNotOptimize(of.with_polhode(digits)); }, warm_too);
  });
}

/// The ratios of a table, for its last line.
struct ratios_so_far {
  std::vector<double> cold;
  std::vector<double> warm;
};

/// Minutes.
bool is_slow(const peer& p, long digits) { return p.slow && digits == 1000; }

class comparison {
 public:
  comparison(peer of, long digits, ratios_so_far& all)
      : of_(std::move(of)), digits_(digits), all_(all) {}

  [[nodiscard]] outcome operator()() const {
#ifdef POLHODE_HAVE_ARB
    if (is_slow(of_, digits_)) return first_calls();
#endif
    const support::scratch_directory directory;
    (void)measure_ours(of_, digits_, directory.path());
    std::array<std::vector<double>, columns> seconds;
    figures largest;
    double total = 0;
    for (int round = 0; round < most_rounds && total < enough_seconds; ++round) {
      const figures off = measure_ours(of_, digits_, "off");
      const figures on_disk = measure_ours(of_, digits_, directory.path());
      std::array<double, columns> now{off.cold, on_disk.cold, off.warm};
      if (off.mebibytes > largest.mebibytes) largest = off;
#ifdef POLHODE_HAVE_ARB
      const figures arb = measure_arb();
      now[3] = arb.cold;
      now[4] = arb.warm;
#endif
      for (std::size_t i = 0; i < columns; ++i) {
        seconds[i].push_back(now[i]);
        total += now[i];
      }
    }
    outcome result;
    for (const auto& column : seconds)
      result.seconds.push_back(polhode::bench::detail::median(column));
#ifdef POLHODE_HAVE_ARB
    const bool limited = digits_ == 1000;
    result.ratios = {median_ratio(seconds[3], seconds[0]), median_ratio(seconds[4], seconds[2])};
    result.bounds = {limited ? std::optional(at_least(of_.least_cold)) : std::nullopt,
                     limited ? std::optional(at_least(of_.least_warm)) : std::nullopt};
    if (of_.in_mean) {
      all_.cold.push_back(result.ratios[0]);
      all_.warm.push_back(result.ratios[1]);
    }
#endif
    result.remark = memory_text(largest);
    return result;
  }

 private:
#ifdef POLHODE_HAVE_ARB
  static constexpr std::size_t columns = 5;
  /// Once, and cold, both in one child: neither uses what the other makes. Nodes are next to
  /// nothing of such an integral's time, so that its ratio stands for later calls too.
  [[nodiscard]] outcome first_calls() const {
    struct both {
      figures ours;
      figures theirs;
    };
    const both once = in_child([&] {
      setenv("POLHODE_CACHE", "off", 1);
      const long bits = bits_for_digits(digits_);
      arb_number theirs;
      ball value;
      both result;
      result.ours = measure_calls([&] { value = of_.with_polhode(digits_); }, false);
      result.theirs = measure_calls([&] { of_.with_arb(theirs.get(), bits); }, false);
      require_agreement(value, theirs.get(), bits - 8);
      return result;
    });
    const double ratio = once.theirs.cold / once.ours.cold;
    all_.cold.push_back(ratio);
    all_.warm.push_back(ratio);
    return {{once.ours.cold, 0, 0, once.theirs.cold, 0},
            {ratio, ratio},
            {at_least(of_.least_cold), at_least(of_.least_warm)},
            memory_text(once.ours)};
  }
  [[nodiscard]] figures measure_arb() const {
    return in_child([&] {
      const long bits = bits_for_digits(digits_);
      arb_number theirs;
      const figures result = measure_calls([&] { of_.with_arb(theirs.get(), bits); }, true);
      require_agreement(of_.with_polhode(digits_), theirs.get(), bits - 8);
      return result;
    });
  }
#else
  static constexpr std::size_t columns = 3;
#endif
  static std::string memory_text(const figures& of) {
    return "  " + std::to_string(std::lround(of.mebibytes)) + " MiB";
  }
  static double median_ratio(std::vector<double> numerators,
                             const std::vector<double>& denominators) {
    for (std::size_t i = 0; i < numerators.size(); ++i) numerators[i] /= denominators[i];
    return polhode::bench::detail::median(numerators);
  }
  static constexpr double enough_seconds = 0.7;
  static constexpr int most_rounds = 15;

  peer of_;
  long digits_;
  [[maybe_unused]] ratios_so_far& all_;
};

#ifdef POLHODE_HAVE_ARB
outcome geometric_mean(const ratios_so_far& all, bool limited) {
  outcome result;
  if (all.cold.empty()) return result;
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double x : values) sum += std::log(x);
    return std::exp(sum / static_cast<double>(values.size()));
  };
  result.ratios = {mean(all.cold), mean(all.warm)};
  result.bounds = {limited ? std::optional(at_least(3)) : std::nullopt,
                   limited ? std::optional(at_least(2)) : std::nullopt};
  result.remark = "  of " + std::to_string(all.cold.size());
  return result;
}

outcome worst(const ratios_so_far& all) {
  if (all.cold.empty()) return {};
  return {{},
          {*std::min_element(all.cold.begin(), all.cold.end()),
           *std::min_element(all.warm.begin(), all.warm.end())},
          {std::nullopt, std::nullopt}};
}
#endif

}  // namespace

int main(int argc, char** argv) {
  suite benchmarks;
  std::map<long, ratios_so_far> ratios;
  const auto table_of = [](const std::string& name, long digits) {
    table t{name,
            "Integrals, certified, to " + std::to_string(digits) +
                " digits: integrate() and acb_calc_integrate\n"
                "(x cold, x warm: so many times faster than Arb; last, our peak memory)",
            {"cold", "on disk", "warm"},
            {},
            22};
#ifdef POLHODE_HAVE_ARB
    t.contestants.insert(t.contestants.end(), {"Arb cold", "Arb warm"});
    t.ratios = {"x cold", "x warm"};
#endif
    return t;
  };
  for (const long digits : {30L, 100L, 300L, 1000L}) {
    for (const bool slow_ones : {false, true}) {
      const bool slow_table = slow_ones && digits == 1000;
      const std::string name = std::to_string(digits) + " digits";
      const table t = table_of(slow_table ? suite::slow + ", " + name : name, digits);
      [[maybe_unused]] bool any = false;
      for (const peer& p : peers()) {
        if (is_slow(p, digits) == slow_ones) {
          benchmarks.add_measured(t, p.name, comparison(p, digits, ratios[digits]));
          any = true;
        }
      }
#ifdef POLHODE_HAVE_ARB
      if (any) {
        benchmarks.add_measured(t, "geometric mean", [&all = ratios[digits], digits] {
          return geometric_mean(all, digits == 1000);
        });
        benchmarks.add_measured(t, "worst", [&all = ratios[digits]] { return worst(all); });
      }
#endif
    }
  }
  return benchmarks.main(argc, argv);
}
