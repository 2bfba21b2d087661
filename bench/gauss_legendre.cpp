// All nodes and weights of Gauss and Legendre rules, certified: ours, at n of about 0.3 p, as
// adaptive quadrature asks for them, and Arb's, one node after another by
// arb_hypgeom_legendre_p_ui_root (its acb_calc_integrate makes them so). "read" is the same rule
// from a file, with all checks. --benchmark_filter=slow measures one more row, which takes a
// quarter of an hour.

#include <cstdlib>
#include <string>

#include <unistd.h>

#include "polhode/quadrature/gauss_legendre.hpp"
#include "support/measure.hpp"
#include "tests/support/scratch_directory.hpp"

#ifdef POLHODE_HAVE_ARB
#include <arb_hypgeom.h>

#include "support/arb_number.hpp"
#endif

namespace {

using namespace polhode;
using namespace polhode::bench;

constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 30;

#ifdef POLHODE_HAVE_ARB
void with_arb(long n, precision bits) {
  arb_number x;
  arb_number w;
  for (long k = 0; k < (n + 1) / 2; ++k) {
    arb_hypgeom_legendre_p_ui_root(x.get(), w.get(), static_cast<ulong>(n), static_cast<ulong>(k),
                                   bits);
  }
}

/// One node in about thirty, against Arb's.
void require_the_same(const gauss_legendre_rule& rule) {
  arb_number x;
  arb_number w;
  const std::size_t count = rule.nodes.size();
  for (std::size_t i = rule.n % 2 != 0 ? 1 : 0; i < count; i += count / 30 + 1) {
    arb_hypgeom_legendre_p_ui_root(x.get(), w.get(), static_cast<ulong>(rule.n), count - 1 - i,
                                   rule.bits + 32);
    const long bits_of_small_nodes = 12;
    require_agreement(rule.nodes[i], x.get(), rule.bits - bits_of_small_nodes);
    require_agreement(rule.weights[i], w.get(), rule.bits - 2);
  }
}
#endif

row comparison(long n, precision p, const std::string& directory) {
  const precision bits = gauss_legendre_precision_at_least(p);
  node_cache writer(directory, most_bytes, 0);
  row r;
  (void)writer.get(n, bits);
  r.contestants = {
      warm([n, bits] { benchmark::DoNotOptimize(make_gauss_legendre(n, bits)); }),
      warm([n, bits, directory] {
        node_cache reader(directory, most_bytes, 0);
        benchmark::DoNotOptimize(reader.get(n, bits));
      }),
  };
  r.ratios = {{1, 0}};
#ifdef POLHODE_HAVE_ARB
  require_the_same(*writer.get(n, bits));
  r.contestants.push_back(warm([n, bits] { with_arb(n, bits); }));
  r.ratios.push_back({0, 2, at_most(0.7)});
#endif
  return r;
}

}  // namespace

int main(int argc, char** argv) {
  table of;
  of.name = "gauss_legendre";
  of.about = "The rule of degree n with p bits (in the first column: p,n)";
  of.contestants = {"make", "read"};
  of.ratios = {"read/make"};
#ifdef POLHODE_HAVE_ARB
  of.contestants.emplace_back("Arb");
  of.ratios.emplace_back("make/Arb");
#endif
  const support::scratch_directory scratch;
  suite all;
  struct degree_and_bits {
    long n;
    precision p;
  };
  for (const auto& [n, p] :
       {degree_and_bits{40, 126}, {120, 400}, {330, 1100}, {1000, 3390}, {3300, 11000}}) {
    table of_row = of;
    if (n == 3300) of_row.name = suite::slow + ", " + of.name;
    all.add(of_row, std::to_string(p) + ',' + std::to_string(n),
            [n = n, p = p, path = scratch.path()] { return comparison(n, p, path); });
  }
  return all.main(argc, argv);
}
