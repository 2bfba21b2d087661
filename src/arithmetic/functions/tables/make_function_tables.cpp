// Writes the tables of tabulated_functions.cpp, as a header, to the file that is named: run at
// build time.
//
// Each entry is a number in [0, 1) to 512 bits, cut off: MPFR rounds the function of an exact
// argument correctly, towards zero.

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <functional>

#include <mpfr.h>

namespace {

constexpr mpfr_prec_t bits = 512;

using setter = std::function<void(mpfr_ptr value, unsigned long i)>;

/// The table of f(0), ..., f(size - 1), least significant limb first.
void write(std::FILE* file, const char* name, unsigned long size, const setter& f) {
  mpfr_t value;
  mpfr_init2(value, bits);
  std::fprintf(file, "inline constexpr table<%lu> %s = {{\n", size, name);
  for (unsigned long i = 0; i < size; ++i) {
    f(value, i);
    mpz_t whole;
    mpz_init(whole);
    mpfr_mul_2si(value, value, bits, MPFR_RNDZ);  // exact
    mpfr_get_z(whole, value, MPFR_RNDZ);
    std::fprintf(file, "  {{");
    for (int k = 0; k < bits / 64; ++k) {
      std::fprintf(file, "%s0x%016" PRIx64, k == 0 ? "" : ", ",
                   static_cast<std::uint64_t>(mpz_getlimbn(whole, k)));
    }
    std::fprintf(file, "}},\n");
    mpz_clear(whole);
  }
  std::fprintf(file, "}};\n");
  mpfr_clear(value);
}

using mpfr_function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

/// f(numerator(i)/denominator(i)), f increasing or decreasing, for arguments that a double holds
/// exactly.
setter of_quotients(mpfr_function f, double denominator, double sign = 1) {
  return [=](mpfr_ptr value, unsigned long i) {
    mpfr_t x;
    mpfr_init2(x, 53);
    mpfr_set_d(x, sign * static_cast<double>(i) / denominator, MPFR_RNDZ);  // a power of 2 divides
    f(value, x, MPFR_RNDZ);
    mpfr_abs(value, value, MPFR_RNDZ);
    mpfr_clear(x);
  };
}

}  // namespace

int main(int argc, char** argv) {
  std::FILE* const file = argc == 2 ? std::fopen(argv[1], "w") : nullptr;
  if (file == nullptr) {
    std::fprintf(stderr, "make_function_tables: give the name of a file that can be written\n");
    return 1;
  }
  std::fprintf(file,
               "// Made by make_function_tables.cpp: entries of 512 bits, cut off, the least "
               "significant limb "
               "first.\n\n");
  write(file, "coarse_expm1", 89, of_quotients(mpfr_expm1, 128));
  write(file, "fine_expm1", 128, of_quotients(mpfr_expm1, 16384));
  write(file, "sines", 101, of_quotients(mpfr_sin, 128));
  // cos 0 = 1 is no fraction; it is not used.
  write(file, "cosines", 101, [](mpfr_ptr value, unsigned long i) {
    of_quotients(mpfr_cos, 128)(value, i);
    if (i == 0) mpfr_set_zero(value, 1);
  });
  // log(256/(256 - i)) = -log(1 - i/256).
  write(file, "coarse_logarithms", 129, of_quotients(mpfr_log1p, 256, -1));
  write(file, "logarithms_below", 129, of_quotients(mpfr_log1p, 16384, -1));
  write(file, "logarithms_above", 129, of_quotients(mpfr_log1p, 16384));
  write(file, "coarse_arctangents", 129, of_quotients(mpfr_atan, 128));
  write(file, "fine_arctangents", 65, of_quotients(mpfr_atan, 16384));

  // 1/2!, 1/3!, ...; 1/2!, 1/4!, ...; 1/3!, 1/5!, ...; 1/2, 1/3, ...; 1/3, 1/5, ...
  constexpr unsigned long coefficients = 44;
  const auto inverse_factorials = [](unsigned long first, unsigned long stride) -> setter {
    return [=](mpfr_ptr value, unsigned long i) {
      mpz_t factorial;
      mpz_init(factorial);
      mpz_fac_ui(factorial, first + i * stride);
      mpfr_t exact;
      mpfr_init2(exact, static_cast<mpfr_prec_t>(mpz_sizeinbase(factorial, 2)));
      mpfr_set_z(exact, factorial, MPFR_RNDZ);
      mpfr_ui_div(value, 1, exact, MPFR_RNDZ);
      mpfr_clear(exact);
      mpz_clear(factorial);
    };
  };
  const auto inverses = [](unsigned long first, unsigned long stride) -> setter {
    return [=](mpfr_ptr value, unsigned long i) {
      mpfr_set_ui(value, 1, MPFR_RNDZ);
      mpfr_div_ui(value, value, first + i * stride, MPFR_RNDZ);
    };
  };
  write(file, "inverse_factorials", coefficients, inverse_factorials(2, 1));
  write(file, "inverse_even_factorials", coefficients, inverse_factorials(2, 2));
  write(file, "inverse_odd_factorials", coefficients, inverse_factorials(3, 2));
  write(file, "inverse_numbers", coefficients, inverses(2, 1));
  write(file, "inverse_odd_numbers", coefficients, inverses(3, 2));
  const bool written = std::ferror(file) == 0;
  return std::fclose(file) == 0 && written ? 0 : 1;
}
