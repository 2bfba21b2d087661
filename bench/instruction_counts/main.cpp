// Operations whose instructions scripts/instruction-counts has valgrind count.
//
//   instruction_counts --list          their names
//   instruction_counts --environment   what a count depends on, beside this tree's source, as JSON
//   instruction_counts NAME            makes that operation twice; what runs inside
//                                      measured_operation is the second time, so that constants and
//                                      nodes are known, and functions bound
//
// All of them run on this thread alone.

#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmp.h>
#include <gnu/libc-version.h>
#include <mpfr.h>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>
#if defined(__x86_64__)
#include <cpuid.h>
#endif

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/checker/check.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "polhode/rigid_body/rotor.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"
#include "polhode/roots/isolate.hpp"
#include "proofs/claim.hpp"

/// Its name is what callgrind looks for (--toggle-collect).
extern "C" __attribute__((noinline)) void measured_operation(const std::function<void()>& f) {
  f();
}

namespace {

using namespace polhode;

struct operation {
  std::string name;
  /// Prepares, and returns what is counted.
  std::function<std::function<void()>()> make;
};

void require(bool certified, const char* what) {
  if (!certified) throw std::runtime_error(fmt::format("{} was not certified", what));
}

const body& the_body() {
  static const body rigid(rational(1265, 100), rational(629, 10000));
  return rigid;
}
const rational the_c(1, 100);

operation of_constant(const std::string& name, long digits) {
  return {fmt::format("{} to {} digits", name, digits), [=] {
            return [=, c = proofs::find_constant(name)] {
              require(proofs::enclose_to_digits(*c, digits).is_bounded(), "the constant");
            };
          }};
}

operation of_phase(const std::string& name, const rational& c, long digits) {
  return {fmt::format("{} to {} digits", name, digits), [=] {
            return [=] {
              const certain_number x = montgomery_phase_to_digits(the_body(), c, digits);
              require(x.verdict == status::certified, "the phase");
            };
          }};
}

template <class F>
operation of_integral(const std::string& name, const F& f, const end_point& from,
                      const end_point& to, long digits) {
  return {fmt::format("{} to {} digits", name, digits), [=] {
            return [=] {
              integrate_options options;
              options.digits = digits;
              options.threads = 1;
              require(integrate(f, from, to, options).verdict == status::certified, "the integral");
            };
          }};
}

initial_state oscillating_state() {
  return initial_state::from_momentum({3, 2, 1}, {3, 1, rational(1, 2)});
}

template <class T>
operation of_rotor(const std::string& name, long samples, bool attitude) {
  return {name, [=] {
            return [=, r = rotor<T>(oscillating_state(), bits_for_digits(50) + 4)] {
              for (long n = 1; n <= samples; ++n) {
                if constexpr (std::same_as<T, double>) {
                  const double t = 0.01 * static_cast<double>(n);
                  const double x = attitude ? r.attitude(t).matrix[0][0] : r.sample(t).momentum[0];
                  require(x < 4, "the sample");
                } else {
                  const rational t(n, 100);
                  const T x = attitude ? r.attitude(t).matrix[0][0] : r.sample(t).momentum[0];
                  require(certainly_less(x, ball(4, 64)), "the sample");
                }
              }
            };
          }};
}

std::string text_of_file(const std::string& path) {
  std::ifstream in(path);
  std::string result{std::istreambuf_iterator<char>(in), {}};
  if (result.empty()) throw std::runtime_error("cannot read " + path);
  return result;
}

std::vector<operation> operations() {
  return {of_constant("beta", 1000),
          of_constant("epsilon0_min", 1000),
          of_phase("half_phase", rational(-the_body().b().exact() / 4), 50),
          of_phase("half_phase", rational(-the_body().b().exact() / 4), 1000),
          of_phase("montgomery_phase", the_c, 50),
          {"phase_integral to 100 digits",
           [] {
             return [] {
               require(phase_integral(the_body(), the_c, rational(1, 10), bits_for_digits(100) + 16)
                           .is_bounded(),
                       "F(c, u)");
             };
           }},
          {"epsilon to 100 digits",
           [] {
             return [] {
               require(twist_to_digits(the_body(), the_c, 100, with_slope::no).verdict ==
                           status::certified,
                       "epsilon(c)");
             };
           }},
          of_integral(
              "integral of 4/(1 + x^2)", [](const auto& x) { return 4 / (1 + x * x); }, 0, 1, 50),
          of_integral(
              "integral of sin(x + e^x)", [](const auto& x) { return sin(x + exp(x)); }, 0, 8, 50),
          {"root of cos x = x to 100 digits",
           [] {
             return [] {
               const root_set found =
                   isolate_roots([](const auto& x) { return cos(x) - x; }, 0, 1, isolate_options{});
               require(found.regions.size() == 1 &&
                           refine(found.regions, 100, 1).front().verdict == status::certified,
                       "the root");
             };
           }},
          of_rotor<double>("1000 momenta in double", 1000, false),
          of_rotor<double>("1000 attitudes in double", 1000, true),
          of_rotor<ball>("an attitude to 50 digits", 1, true),
          {"check of the certificate of beta", [] {
             return [text = text_of_file(POLHODE_CERTIFICATES_DIR "/beta.json")] {
               require(checker::check(text).result == checker::outcome::verified, "beta");
             };
           }}};
}

/// What the libraries choose their code by. Under valgrind it is valgrind's processor, which is
/// made after this one.
std::string processor() {
#if defined(__x86_64__)
  unsigned a = 0, b = 0, c = 0, d = 0;
  __cpuid(1, a, b, c, d);
  std::string result = fmt::format("x86-64 {:08x} {:08x} {:08x}", a, c, d);
  if (__get_cpuid_count(7, 0, &a, &b, &c, &d) != 0) result += fmt::format(" {:08x}", b);
  return result;
#else
  return "not x86-64";
#endif
}

nlohmann::json environment() {
  return {{"compiler", __VERSION__},        {"GMP", gmp_version},
          {"MPFR", mpfr_get_version()},     {"Boost", BOOST_LIB_VERSION},
          {"libc", gnu_get_libc_version()}, {"processor", processor()}};
}

void run(const std::string& name) {
  for (const operation& o : operations()) {
    if (o.name != name) continue;
    const std::function<void()> f = o.make();
    f();
    measured_operation(f);
    return;
  }
  throw std::invalid_argument("there is no operation \"" + name + "\"");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string what = argc == 2 ? argv[1] : "";
    if (what == "--list") {
      for (const operation& o : operations()) std::cout << o.name << '\n';
    } else if (what == "--environment") {
      std::cout << environment().dump() << '\n';
    } else if (argc == 2) {
      run(what);
    } else {
      throw std::invalid_argument("usage: instruction_counts --list | --environment | NAME");
    }
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "instruction_counts: " << error.what() << '\n';
    return 2;
  }
}
