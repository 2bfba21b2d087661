// All roots of systems of equations in a box, beside kv (M. Kashiwagi, github.com/mskashi/kv) where
// its headers are given: cmake --preset release -DPOLHODE_KV=DIR.
//
// Both get the same generic functions and boxes, search for all roots and prove each, to the digits
// of hardware doubles. The problems are those that interval solvers are compared by.

#ifdef POLHODE_HAVE_KV
#include <kv/allsol.hpp>  // the first, as system headers have a macro by one of its names
#endif

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "polhode/roots/systems.hpp"
#include "support/measure.hpp"

namespace {

using namespace polhode;
using namespace polhode::bench;

/// A function of vectors of any kind, with the side that all variables have.
template <class F>
struct problem {
  std::string name;
  std::size_t variables;
  long lower;
  long upper;
  std::size_t roots;
  F f;
};

const auto broyden = [](const auto& x, std::size_t n) {
  auto r = x;
  for (std::size_t k = 0; k < n; ++k) {
    r[k] = (3 - 2 * x[k]) * x[k] + 1;
    if (k > 0) r[k] = r[k] - x[k - 1];
    if (k + 1 < n) r[k] = r[k] - 2 * x[k + 1];
  }
  return r;
};
const auto yamamura = [](const auto& x, std::size_t n) {
  auto r = x;
  auto sum = x[0] * x[0] * x[0];
  for (std::size_t k = 1; k < n; ++k) sum = sum + x[k] * x[k] * x[k];
  for (std::size_t k = 0; k < n; ++k) {
    r[k] = 2 * static_cast<int>(n) * x[k] - sum - static_cast<int>(k + 1);
  }
  return r;
};
const auto cyclic = [](const auto& x, std::size_t n) {
  auto r = x;
  for (std::size_t k = 1; k <= n; ++k) {
    auto sum = x[0] * 0;
    for (std::size_t i = 0; i < (k < n ? n : 1); ++i) {
      auto product = x[i];
      for (std::size_t j = 1; j < k; ++j) product = product * x[(i + j) % n];
      sum = sum + product;
    }
    r[k - 1] = k < n ? sum : sum - 1;
  }
  return r;
};
const auto katsura = [](const auto& u, std::size_t n) {
  auto r = u;
  const auto last = static_cast<long>(n) - 1;
  const auto at = [&](long i) { return u[static_cast<std::size_t>(std::abs(i))]; };
  auto all = u[0] - 1;
  for (long m = 0; m < last; ++m) {
    auto sum = -u[static_cast<std::size_t>(m)];
    for (long l = m - last; l <= last; ++l) sum = sum + at(l) * at(m - l);
    r[static_cast<std::size_t>(m)] = sum;
    all = all + 2 * at(m + 1);
  }
  r[n - 1] = all;
  return r;
};
/// u'' + e^u = 0 on n points.
const auto bratu = [](const auto& x, std::size_t n) {
  auto r = x;
  const int scale = static_cast<int>((n + 1) * (n + 1));
  for (std::size_t k = 0; k < n; ++k) {
    auto sum = -2 * x[k];
    if (k > 0) sum = sum + x[k - 1];
    if (k + 1 < n) sum = sum + x[k + 1];
    r[k] = scale * sum + exp(x[k]);
  }
  return r;
};
const auto economics = [](const auto& x, std::size_t n) {
  auto r = x;
  auto all = x[0] + 1;
  for (std::size_t k = 1; k < n; ++k) {
    auto sum = x[k - 1];
    for (std::size_t i = 0; i + 1 + k < n; ++i) sum = sum + x[i] * x[i + k];
    r[k - 1] = sum * x[n - 1] - static_cast<int>(k);
    if (k + 1 < n) all = all + x[k];
  }
  r[n - 1] = all;
  return r;
};
const auto shinohara = [](const auto& x, std::size_t) {
  auto r = x;
  r[0] = 2 * x[0] * x[0] - 2 * x[1] - 2;
  r[1] = x[0] * x[1] - x[2];
  r[2] = 2 * x[2] * x[2] - 2 * x[0] - 1;
  return r;
};

void expect_count(const std::string& name, std::size_t found, std::size_t known) {
  if (found != known) {
    throw std::logic_error(name + ": " + std::to_string(found) + " roots, not " +
                           std::to_string(known));
  }
}

template <class F>
row all_roots(const problem<F>& p) {
  row r;
  r.contestants = {warm([p] {
    const auto f = [&](const auto& x) { return p.f(x, p.variables); };
    const system_root_set s = solve_system(f, system_box(p.variables, {p.lower, p.upper}));
    if (!s.is_resolved()) throw std::logic_error(p.name + ": not all roots are proved");
    expect_count(p.name, s.regions.size(), p.roots);
  })};
#ifdef POLHODE_HAVE_KV
  r.contestants.push_back(warm([p] {
    namespace ublas = boost::numeric::ublas;
    const auto f = [&](const auto& x) { return p.f(x, p.variables); };
    ublas::vector<kv::interval<double>> box(p.variables);
    for (auto& side : box) {
      side = kv::interval<double>(static_cast<double>(p.lower), static_cast<double>(p.upper));
    }
    expect_count(p.name + " by kv", kv::allsol(f, box, 0).size(), p.roots);
  }));
  r.ratios = {{1, 0, at_least(1)}};
#endif
  return r;
}

}  // namespace

int main(int argc, char** argv) {
  suite benchmarks;
  table systems{"systems", "all roots of a system in a box, each proved", {"Polhode"}, {}};
#ifdef POLHODE_HAVE_KV
  systems.contestants.emplace_back("kv");
  systems.ratios.emplace_back("kv/Polhode");
#endif
  const auto add = [&](const auto& p) {
    benchmarks.add(systems, p.name, [p] { return all_roots(p); });
  };
  // The sides of Katsura's box go beyond the roots, one of which is (1, 0, ..., 0).
  add(problem{"broyden-10", 10, -2, 2, 2, broyden});
  add(problem{"yamamura-7", 7, -3, 3, 3, yamamura});
  add(problem{"cyclic-5", 5, -10, 10, 10, cyclic});
  add(problem{"katsura-4", 5, -2, 2, 12, katsura});
  add(problem{"bratu-10", 10, 0, 20, 2, bratu});
  add(problem{"economics-4", 4, -100, 100, 2, economics});
  add(problem{"shinohara", 3, -10, 10, 2, shinohara});
  return benchmarks.main(argc, argv);
}
