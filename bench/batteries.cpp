// The batteries of tests/support/batteries.hpp to 30 digits, certified by Polhode and by Arb's
// acb_calc_integrate, and not certified by PARI's intnum.
//
// Every program has the same formula, in the order of its operations. Arb's evaluation says where
// it is analytic; Arb is given the fewest guard bits, of 16, 64, 256, 1024 and 4096, with which its
// answer is as accurate as was asked; where the range is infinite, or f singular at an end, a part
// of the range, and a bound of the rest. A result of Arb's that is disjoint from ours ends the
// program. PARI's intnum reads the formula as a text, and is given the ends and nothing else;
// behind its time is the error of its result. Times are those of a call after a first one. A call
// of more than 20 s is not waited for.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <regex>
#include <string>

#include <unistd.h>

#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/measure.hpp"
#include "tests/support/batteries.hpp"

#ifdef POLHODE_HAVE_ARB
#include "support/arb_formula.hpp"
#endif
#ifdef POLHODE_HAVE_PARI
#include "support/pari.hpp"
#endif

namespace {

using namespace polhode;
using namespace polhode::bench;
using test::battery;
using test::battery_integral;

constexpr long least_digits = 30;

end_point end_of(const std::string& text) {
  return text == "inf" ? end_point::infinity() : end_point_of(parse(text, {}));
}

expression integrand_of(const battery_integral& i) {
  return expression(i.formula, {{"x"}, {}, library_functions()});
}

/// As `polhode integrate` has it: exactly where that is possible.
ball certified(const battery_integral& i) {
  const expression f = integrand_of(i);
  const end_point lower = end_of(i.lower);
  const end_point upper = end_of(i.upper);
  if (const auto exact = exact_integral(f, lower, upper)) {
    return ball(*exact, bits_for_digits(least_digits));
  }
  integrate_options options;
  options.digits = least_digits;
  const integral r = integrate(f, lower, upper, options);
  if (r.verdict != status::certified) {
    throw std::logic_error(i.formula + " is not certified: " + r.obstacle);
  }
  return r.enclosure;
}

/// The seconds of a later call of f, which answers whether its result is as accurate as was asked;
/// none where it is not, or takes too long. What the libraries say of it is not shown. Throws
/// std::logic_error where f does: the results contradict.
template <class F>
std::optional<double> seconds_of_later_call(const F& f) {
  constexpr unsigned most_seconds = 20;
  try {
    const double seconds = in_child([&] {
      alarm(most_seconds);
      [[maybe_unused]] const auto* const silenced = std::freopen("/dev/null", "w", stderr);
      bool is_accurate = true;
      const auto call = [&] { is_accurate = f() && is_accurate; };
      try {
        const double first = processor_seconds_of(call, 1);
        if (!is_accurate) return 0.0;
        constexpr double least = 0.02;
        const long calls = std::clamp(static_cast<long>(least / std::max(first, 1e-6)), 1L, 1000L);
        return processor_seconds_of(call, calls) / static_cast<double>(calls);
      } catch (const std::logic_error&) {
        return -1.0;
      }
    });
    if (seconds < 0) throw std::logic_error("the contestants' results are disjoint");
    if (seconds > 0) return seconds;
  } catch (const std::runtime_error&) {  // the child was ended
  }
  return std::nullopt;
}

#ifdef POLHODE_HAVE_ARB
/// Arb's integral with so many guard bits, to the accuracy that was asked of the value.
void by_arb(arb_ptr result, const battery_integral& i, const ball& value, long guard) {
  const long bits = bits_for_digits(least_digits);
  const polhode::precision p = bits + guard;
  const expression f = integrand_of(i);
  arb_formula integrand(f, p);
  const bool is_cut = !i.cut.rest.empty();
  const auto number = [&](const std::string& text) {
    const expression e = parse(text, {}, {{"p", std::to_string(bits + 10)}});
    return e.value(p);
  };
  const arb_value lower(number(is_cut ? i.cut.lower : i.lower));
  const arb_value upper(number(is_cut ? i.cut.upper : i.upper));
  constexpr long more = 14;  // for rounding, and for the errors of many parts
  acb_number sum;
  mag_t tolerance;
  mag_init(tolerance);
  arb_get_mag_lower(tolerance, acb_realref(arb_value(value).get()));
  mag_mul_2exp_si(tolerance, tolerance, -bits - more);
  acb_calc_integrate(sum.get(), arb_formula::over, &integrand, lower.get(), upper.get(),
                     bits + more, tolerance, nullptr, p);
  mag_clear(tolerance);
  arb_set(result, acb_realref(sum.get()));
  if (is_cut) {
    const arb_value rest(number(i.cut.rest));
    arb_add_error(result, acb_realref(rest.get()));
  }
}

/// The seconds of Arb's integral; none where it takes too long, or is never as accurate as asked.
std::optional<double> seconds_of_arb(const battery_integral& i, const ball& value) {
  if (i.upper == "inf" && i.cut.rest.empty()) return std::nullopt;
  for (const long guard : {16L, 64L, 256L, 1024L, 4096L}) {
    const auto seconds = seconds_of_later_call([&i, &value, guard] {
      arb_number result;
      by_arb(result.get(), i, value, guard);
      if (arb_is_finite(result.get()) == 0) return false;
      const long bits = bits_for_digits(least_digits);
      const ball theirs = from_arb(result.get(), bits + guard);
      if (!overlaps(value, theirs)) throw std::logic_error(i.formula + ": disjoint from Arb's");
      return theirs.radius() <= scale(theirs.magnitude_lower(), -bits);
    });
    if (seconds) return seconds;
  }
  return std::nullopt;
}
#endif

#ifdef POLHODE_HAVE_PARI
/// The formula, or number, in the syntax of gp.
std::string in_gp(const std::string& text) {
  const std::string with_pi = std::regex_replace(text, std::regex("\\bpi\\b"), "Pi");
  return text == "inf" ? "oo" : with_pi;
}

GEN by_pari(const battery_integral& i) {
  const std::string& f = i.in_gp.empty() ? i.formula : i.in_gp;
  const std::string call =
      "intnum(x=" + in_gp(i.lower) + ',' + in_gp(i.upper) + ',' + in_gp(f) + ')';
  return gp_read_str(call.c_str());
}
#endif

outcome of_integral(const battery_integral& i) {
  const ball value = certified(i);
  if (!i.value.empty() &&
      !overlaps(value, parse(i.value, {}).value(bits_for_digits(least_digits) + 64))) {
    throw std::logic_error(i.formula + ": disjoint from " + i.value);
  }
  outcome result;
  const auto ours = seconds_of_later_call([&] { return certified(i).is_bounded(); });
  result.seconds = {ours.value_or(0), 0, 0};
#ifdef POLHODE_HAVE_ARB
  result.seconds[1] = seconds_of_arb(i, value).value_or(0);
#endif
#ifdef POLHODE_HAVE_PARI
  const auto of_pari = seconds_of_later_call([&] {
    with_stack([&] { benchmark::DoNotOptimize(by_pari(i)); });
    return true;
  });
  if (of_pari) {
    result.seconds[2] = *of_pari;
    with_stack([&] { result.remark = "   " + error_text(by_pari(i), value, least_digits); });
  }
#endif
  return result;
}

std::string shortened(const std::string& text, std::size_t width) {
  return text.size() <= width ? text : text.substr(0, width - 2) + "..";
}

}  // namespace

int main(int argc, char** argv) {
#ifdef POLHODE_HAVE_PARI
  start_pari();
  gp_read_str(("default(realprecision," + std::to_string(least_digits + 8) + ")").c_str());
#endif
  suite benchmarks;
  constexpr int width = 58;
  for (const battery& b : {test::bailey(), test::kahaner(), test::flint()}) {
    std::string about = b.name + ", to 30 digits\n(" + b.source + ')';
    for (const std::string& name : b.missing) {
      about += (&name == &b.missing.front() ? "\n(missing: " : ", ") + name;
    }
    if (!b.missing.empty()) about += ')';
    const table of{b.name, about, {"Polhode", "Arb", "PARI"}, {}, width};
    for (const battery_integral& i : b.integrals) {
      const std::string ends = ", " + i.lower + ".." + i.upper;
      const std::string label = i.number + "  " + shortened(i.formula, width - 10 - ends.size());
      benchmarks.add_measured(of, label + ends, [i] { return of_integral(i); });
    }
  }
  return benchmarks.main(argc, argv);
}
