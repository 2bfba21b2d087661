// All roots of polynomials with rational coefficients, real and complex, to 30 digits.
//
// Arb's arb_fmpz_poly_complex_roots is the peer of the complex roots. Both begin with the
// coefficients.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "polhode/arithmetic/text.hpp"
#include "polhode/roots/complex_roots.hpp"
#include "polhode/roots/isolate.hpp"
#include "support/measure.hpp"

#ifdef POLHODE_HAVE_ARB
#include <acb.h>
#include <arb_fmpz_poly.h>
#include <flint/fmpz_poly.h>
#endif

namespace {

using namespace polhode;
using namespace polhode::bench;

constexpr long digits = 30;

rational_polynomial line(const rational& at_0, const rational& slope) {
  return rational_polynomial({at_0, slope});
}

/// Chebyshev's T_n.
rational_polynomial chebyshev(long n) {
  rational_polynomial before({rational(1)});
  rational_polynomial now = rational_polynomial::variable();
  for (long k = 1; k < n; ++k) {
    rational_polynomial next = line(0, 2) * now - before;
    before = std::exchange(now, std::move(next));
  }
  return now;
}

rational_polynomial wilkinson(long n) {
  rational_polynomial p({rational(1)});
  for (long k = 1; k <= n; ++k) p = p * line(-k, 1);
  return p;
}

/// x^n - 2 (10^10 x - 1)^2 (M. Mignotte, 1982): two roots are about 10^(-5n) apart.
rational_polynomial mignotte(long n) {
  std::vector<rational> power(static_cast<std::size_t>(n) + 1);
  power.back() = 1;
  const rational_polynomial steep = line(-1, 10'000'000'000);
  return rational_polynomial(power) - rational_polynomial({rational(2)}) * steep * steep;
}

/// Integers up to 1000 in size, by a linear congruential generator (D. E. Knuth's MMIX).
rational_polynomial random_dense(long n) {
  std::uint64_t state = 38;
  std::vector<rational> c;
  for (long k = 0; k <= n; ++k) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    c.emplace_back(static_cast<long>((state >> 33U) % 2001U) - 1000);
  }
  c.back() += 2000;
  return rational_polynomial(std::move(c));
}

contestant real_roots_of(const rational_polynomial& p) {
  return warm([f = real_function::of(p)] {
    const root_set s = isolate_roots(f, -end_point::infinity(), end_point::infinity());
    benchmark::DoNotOptimize(refine(s.regions, digits, 1));
  });
}

contestant complex_roots_of(const rational_polynomial& p) {
  return warm([p] { benchmark::DoNotOptimize(complex_roots(p, digits)); });
}

#ifdef POLHODE_HAVE_ARB

class integer_polynomial {
 public:
  explicit integer_polynomial(const rational_polynomial& p) {
    fmpz_poly_init(value_);
    const std::vector<integer> c = primitive_coefficients(p);
    for (std::size_t k = 0; k < c.size(); ++k) {
      fmpz_t one;
      fmpz_init(one);
      fmpz_set_mpz(one, c[k].backend().data());
      fmpz_poly_set_coeff_fmpz(value_, static_cast<slong>(k), one);
      fmpz_clear(one);
    }
  }
  integer_polynomial(const integer_polynomial& other) {
    fmpz_poly_init(value_);
    fmpz_poly_set(value_, other.value_);
  }
  integer_polynomial& operator=(const integer_polynomial&) = delete;
  ~integer_polynomial() { fmpz_poly_clear(value_); }

  void find_complex_roots() const {
    const slong n = fmpz_poly_degree(value_);
    const acb_ptr roots = _acb_vec_init(n);
    arb_fmpz_poly_complex_roots(roots, value_, 0, bits_for_digits(digits));
    _acb_vec_clear(roots, n);
  }

 private:
  fmpz_poly_t value_;
};

#endif

row real_row(const rational_polynomial& p) {
  row r;
  r.contestants = {real_roots_of(p)};
  return r;
}

row complex_row(const rational_polynomial& p) {
  row r;
  r.contestants = {complex_roots_of(p)};
#ifdef POLHODE_HAVE_ARB
  r.contestants.push_back(warm([q = integer_polynomial(p)] { q.find_complex_roots(); }));
  r.ratios = {{0, 1}};
#endif
  return r;
}

}  // namespace

int main(int argc, char** argv) {
  suite benchmarks;
  const table real{"real", "all real roots to 30 digits", {"Polhode"}, {}};
  table complex{"complex", "all complex roots to 30 digits", {"Polhode"}, {}};
#ifdef POLHODE_HAVE_ARB
  complex.contestants.emplace_back("Arb");
  complex.ratios.emplace_back("/Arb");
#endif
  using named = std::pair<std::string, rational_polynomial>;
  for (const auto& [name, p] :
       {named("T_100", chebyshev(100)), named("T_200", chebyshev(200)),
        named("Wilkinson 200", wilkinson(200)), named("Mignotte 100", mignotte(100)),
        named("dense 500", random_dense(500))}) {
    benchmarks.add(real, name, [p = p] { return real_row(p); });
  }
  for (const auto& [name, p] :
       {named("T_50", chebyshev(50)), named("Wilkinson 50", wilkinson(50)),
        named("Mignotte 20", mignotte(20)), named("dense 100", random_dense(100)),
        named("dense 200", random_dense(200))}) {
    benchmarks.add(complex, name, [p = p] { return complex_row(p); });
  }
  return benchmarks.main(argc, argv);
}
