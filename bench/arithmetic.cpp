// One operation of the ball against the same of plain MPFR and of Arb, of the complex ball against
// Arb's, of intervals and regions in hardware doubles by themselves, and how often a ball goes to
// the heap.
//
// Operands are balls with a radius of one unit in the last place about numbers like sqrt(2), and
// for MPFR their midpoints; the result's storage is used again from call to call. Only the
// operator, "x*y", makes a new number each time, in all three: the price of that is its time over
// that of "mul". The complex ball's operations are operators, where Arb's write into an old number.
// The fused multiply-add is compared with mpfr_fma and arb_fma, which have the same three operands.
// The limits are those that Polhode sets itself; a ratio below 1 means that the ball is faster.
// "MPFR/Arb" tells what the functions would cost if they were MPFR's.

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/double_interval.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/region.hpp"
#include "support/measure.hpp"

#ifdef POLHODE_HAVE_ARB
#include "support/arb_number.hpp"
#endif

// --------------------------------------------------------------------------------------------- The
// heap, counted: with the GNU C library a program's own malloc serves every library of the process.

#ifdef __GLIBC__
namespace {
long heap_calls = 0;
}
extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier)
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier)
void* malloc(std::size_t size) noexcept {
  ++heap_calls;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  ++heap_calls;
  return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) noexcept {
  ++heap_calls;
  return __libc_realloc(block, size);
}
}
#endif

namespace {

using namespace polhode;
using namespace polhode::bench;

/// sqrt(n), rounded, with a radius of one unit in the last place.
ball operand(long n, precision p) {
  const ball root = sqrt(ball(n, p)).middle();
  const auto exponent = root.magnitude_upper().log2_floor();
  return root.enlarged(magnitude::power_of_two(exponent + 1 - std::int64_t{p}));
}

/// The operands of one measurement in the three libraries, and room for a result.
struct operands {
  explicit operands(precision p) : bits(p), x(operand(2, p)), y(operand(3, p)), z(operand(5, p)) {
    mx.reset(p);
    my.reset(p);
    mz.reset(p);
    mr.reset(p);
    x.midpoint(mx.get());
    y.midpoint(my.get());
    z.midpoint(mz.get());
#ifdef POLHODE_HAVE_ARB
    const auto convert = [](arb_ptr to, mpfr_srcptr midpoint, const magnitude& radius) {
      arf_set_mpfr(arb_midref(to), midpoint);
      mag_set_ui_2exp_si(arb_radref(to), radius.fraction(), static_cast<slong>(radius.exponent()));
    };
    convert(ax.get(), mx.get(), x.radius());
    convert(ay.get(), my.get(), y.radius());
    convert(az.get(), mz.get(), z.radius());
#endif
  }

  precision bits;
  ball x, y, z, r;
  polhode::detail::mpfr_cell mx, my, mz, mr;
#ifdef POLHODE_HAVE_ARB
  arb_number ax, ay, az, ar;
#endif
};

/// An operation in the three libraries. Each maker returns the loop over its calls, the loop's body
/// being seen by the compiler.
struct operation {
  std::string name;
  std::function<contestant(operands&)> ours, with_mpfr, with_arb;
  bool field = false;       // limits of multiplication, division, square root
  bool elementary = false;  // limits of exp, log, sin, cos, atan
  bool limited_by_arb = false;
};

#ifdef POLHODE_HAVE_ARB
#define POLHODE_WITH_ARB(expression) [](operands& o) { return warm([&o] { expression; }); }
#else
#define POLHODE_WITH_ARB(expression) nullptr
#endif
#define POLHODE_CALL(expression) [](operands& o) { return warm([&o] { expression; }); }

#define POLHODE_BINARY(name, ball_function, library_function)                                 \
  operation {                                                                                 \
    name, POLHODE_CALL(ball_function(o.r, o.x, o.y)),                                         \
        POLHODE_CALL(mpfr_##library_function(o.mr.get(), o.mx.get(), o.my.get(), MPFR_RNDN)), \
        POLHODE_WITH_ARB(arb_##library_function(o.ar.get(), o.ax.get(), o.ay.get(), o.bits))  \
  }
#define POLHODE_UNARY(name, ball_function, mpfr_function, arb_function) \
  operation {                                                           \
    name, POLHODE_CALL(ball_function(o.r, o.x)),                        \
        POLHODE_CALL(mpfr_function(o.mr.get(), o.mx.get(), MPFR_RNDN)), \
        POLHODE_WITH_ARB(arb_function(o.ar.get(), o.ax.get(), o.bits))  \
  }

std::vector<operation> all_operations() {
  std::vector<operation> result{
      POLHODE_BINARY("add", add, add),
      POLHODE_BINARY("sub", subtract, sub),
      POLHODE_BINARY("mul", multiply, mul),
      POLHODE_BINARY("x*y", multiply, mul),
      POLHODE_UNARY("sqr", square, mpfr_sqr, arb_sqr),
      operation{"fma", POLHODE_CALL(fma(o.r, o.x, o.y, o.z)),
                POLHODE_CALL(mpfr_fma(o.mr.get(), o.mx.get(), o.my.get(), o.mz.get(), MPFR_RNDN)),
                POLHODE_WITH_ARB(arb_fma(o.ar.get(), o.ax.get(), o.ay.get(), o.az.get(), o.bits))},
      POLHODE_BINARY("div", divide, div),
      POLHODE_UNARY("sqrt", sqrt, mpfr_sqrt, arb_sqrt),
      POLHODE_BINARY("agm", agm, agm),
      POLHODE_UNARY("exp", exp, mpfr_exp, arb_exp),
      POLHODE_UNARY("log", log, mpfr_log, arb_log),
      POLHODE_UNARY("sin", sin, mpfr_sin, arb_sin),
      POLHODE_UNARY("cos", cos, mpfr_cos, arb_cos),
      POLHODE_UNARY("atan", atan, mpfr_atan, arb_atan),
  };
  for (operation& op : result) {
    if (op.name == "x*y") {
      op.ours = POLHODE_CALL(const ball r = o.x * o.y);
      op.with_mpfr = POLHODE_CALL(mpfr_t r; mpfr_init2(r, o.bits);
                                  mpfr_mul(r, o.mx.get(), o.my.get(), MPFR_RNDN); mpfr_clear(r));
      op.with_arb = POLHODE_WITH_ARB(arb_t r; arb_init(r);
                                     arb_mul(r, o.ax.get(), o.ay.get(), o.bits); arb_clear(r));
    }
    op.field = op.name == "mul" || op.name == "div" || op.name == "sqrt";
    op.elementary = op.name == "exp" || op.name == "log" || op.name == "sin" || op.name == "cos" ||
                    op.name == "atan";
    op.limited_by_arb = op.field || op.name == "add" || op.name == "fma" || op.name == "agm";
  }
  return result;
}
#undef POLHODE_UNARY
#undef POLHODE_BINARY
#undef POLHODE_CALL
#undef POLHODE_WITH_ARB

// ---------------------------------------------------------------------------------------------
// The complex ball, at sqrt(2) + sqrt(3) i and sqrt(5) + sqrt(7) i.

struct complex_operands {
  explicit complex_operands(precision p)
      : bits(p), z(operand(2, p), operand(3, p)), w(operand(5, p), operand(7, p)) {
#ifdef POLHODE_HAVE_ARB
    const auto convert = [p](acb_ptr to, const complex_ball& from) {
      const auto set = [p](arb_ptr part, const ball& x) {
        polhode::detail::mpfr_cell m(p);
        x.midpoint(m.get());
        arf_set_mpfr(arb_midref(part), m.get());
        mag_set_ui_2exp_si(arb_radref(part), x.radius().fraction(),
                           static_cast<slong>(x.radius().exponent()));
      };
      set(acb_realref(to), from.re);
      set(acb_imagref(to), from.im);
    };
    convert(az.get(), z);
    convert(aw.get(), w);
#endif
  }

  precision bits;
  complex_ball z, w;
#ifdef POLHODE_HAVE_ARB
  acb_number az, aw, ar;
#endif
};

struct complex_operation {
  std::string name;
  std::function<contestant(complex_operands&)> ours, with_arb;
};

#ifdef POLHODE_HAVE_ARB
#define POLHODE_WITH_ARB(expression) [](complex_operands& o) { return warm([&o] { expression; }); }
#else
#define POLHODE_WITH_ARB(expression) nullptr
#endif
#define POLHODE_COMPLEX(name, expression, arb_expression)                                \
  complex_operation {                                                                    \
    name, [](complex_operands& o) { return warm([&o] { const auto r = expression; }); }, \
        POLHODE_WITH_ARB(arb_expression)                                                 \
  }

std::vector<complex_operation> complex_operations() {
  return {
      POLHODE_COMPLEX("mul", o.z * o.w, acb_mul(o.ar.get(), o.az.get(), o.aw.get(), o.bits)),
      POLHODE_COMPLEX("sqr", square(o.z), acb_mul(o.ar.get(), o.az.get(), o.az.get(), o.bits)),
      POLHODE_COMPLEX("div", o.z / o.w, acb_div(o.ar.get(), o.az.get(), o.aw.get(), o.bits)),
      POLHODE_COMPLEX("sqrt", sqrt(o.z), acb_sqrt(o.ar.get(), o.az.get(), o.bits)),
      POLHODE_COMPLEX("exp", exp(o.z), acb_exp(o.ar.get(), o.az.get(), o.bits)),
      POLHODE_COMPLEX("log", log(o.z), acb_log(o.ar.get(), o.az.get(), o.bits)),
  };
}
#undef POLHODE_COMPLEX
#undef POLHODE_WITH_ARB

row comparison(const complex_operation& op, complex_operands& o) {
  row r;
  r.contestants = {op.ours(o)};
  if (op.with_arb) {
    r.contestants.push_back(op.with_arb(o));
    r.ratios = {{0, 1}};
  }
  return r;
}

// ---------------------------------------------------------------------------------------------
// Hardware doubles: an interval, and the region made of two.

struct hardware_operands {
  double_interval x{1.40625, 1.4375};
  double_interval y{1.71875, 1.75};
  region z{x, double_interval(0.25, 0.28125)};
  region w{y, double_interval(0.5, 0.53125)};
  double_interval interval_result;
  region region_result{x};
};

struct hardware_operation {
  std::string name;
  std::function<contestant(hardware_operands&)> of_interval, of_region;
};

std::vector<hardware_operation> hardware_operations() {
#define POLHODE_HARDWARE(name, interval_expression, region_expression)                           \
  hardware_operation {                                                                           \
    name,                                                                                        \
        [](hardware_operands& o) {                                                               \
          return warm([&o] { o.interval_result = interval_expression; });                        \
        },                                                                                       \
        [](hardware_operands& o) { return warm([&o] { o.region_result = region_expression; }); } \
  }
  return {
      POLHODE_HARDWARE("add", o.x + o.y, o.z + o.w),
      POLHODE_HARDWARE("mul", o.x * o.y, o.z * o.w),
      POLHODE_HARDWARE("div", o.x / o.y, o.z / o.w),
      POLHODE_HARDWARE("sqrt", sqrt(o.x), sqrt(o.z)),
      POLHODE_HARDWARE("exp", exp(o.x), exp(o.z)),
      POLHODE_HARDWARE("log", log(o.x), log(o.z)),
      POLHODE_HARDWARE("sin", sin(o.x), sin(o.z)),
      POLHODE_HARDWARE("cos", cos(o.x), cos(o.z)),
      POLHODE_HARDWARE("atan", atan(o.x), atan(o.z)),
  };
#undef POLHODE_HARDWARE
}

std::optional<ratio_limit> limit_against_mpfr(const operation& op, precision bits) {
  if (op.elementary) return at_most(1.15);
  if (!op.field || bits < 128) return std::nullopt;
  return at_most(bits < 333 ? 1.7 : (bits < 1024 ? 1.35 : 1.1));
}

std::optional<ratio_limit> limit_against_arb(const operation& op) {
  return op.limited_by_arb ? std::optional(at_most(1.2)) : std::nullopt;
}

row comparison(const operation& op, operands& o) {
  row r;
  r.contestants = {op.ours(o), op.with_mpfr(o)};
  r.ratios = {{0, 1, limit_against_mpfr(op, o.bits)}};
  if (op.with_arb) {
    r.contestants.push_back(op.with_arb(o));
    r.ratios.push_back({0, 2, limit_against_arb(op)});
    r.ratios.push_back({1, 2});
  }
  return r;
}

#ifdef __GLIBC__
double heap_calls_of(const std::function<contestant(operands&)>& make, operands& o) {
  if (!make) return 0;
  constexpr long calls = 64;
  const contestant c = make(o);
  const long before = heap_calls;
  (void)c.batch(calls);
  return static_cast<double>(heap_calls - before) / static_cast<double>(calls);
}

void print_heap_calls(const std::vector<operation>& operations) {
  const std::vector<precision> precisions{64, 128, 192, 256};
  std::cout << "\nCalls of malloc, calloc and realloc in one operation: Polhode | MPFR"
#ifdef POLHODE_HAVE_ARB
               " | Arb"
#endif
               " (limit for Polhode: 0)\n\n"
            << std::setw(13) << "";
  for (const precision p : precisions) std::cout << std::setw(16) << (std::to_string(p) + " bits");
  std::cout << '\n' << std::fixed << std::setprecision(0);
  for (const operation& op : operations) {
    std::cout << std::left << std::setw(13) << op.name << std::right;
    for (const precision p : precisions) {
      operands o(p);
      std::ostringstream cell;
      cell << heap_calls_of(op.ours, o) << " | " << heap_calls_of(op.with_mpfr, o);
      if (op.with_arb) cell << " | " << heap_calls_of(op.with_arb, o);
      std::cout << std::setw(16) << cell.str();
    }
    std::cout << '\n';
  }
}
#endif

}  // namespace

int main(int argc, char** argv) {
  const std::vector<operation> operations = all_operations();
  std::vector<std::unique_ptr<operands>> in_use;
  suite benchmarks;
  table t{"arithmetic",
          "One operation, at so many bits: the ball against MPFR's number and Arb's ball",
          {"Polhode", "MPFR"},
          {"/MPFR"}};
  if (operations.front().with_arb) {
    t.contestants.emplace_back("Arb");
    t.ratios.emplace_back("/Arb");
    t.ratios.emplace_back("MPFR/Arb");
  }
  for (const operation& op : operations) {
    for (const precision bits : {64, 128, 333, 1024, 3333, 10000, 33333}) {
      benchmarks.add(t, op.name + '/' + std::to_string(bits), [&op, &in_use, bits] {
        in_use.push_back(std::make_unique<operands>(bits));
        return comparison(op, *in_use.back());
      });
    }
  }
  const std::vector<complex_operation> of_complex = complex_operations();
  std::vector<std::unique_ptr<complex_operands>> complex_in_use;
  table u{
      "complex", "One operation, at so many bits: the complex ball against Arb's", {"Polhode"}, {}};
  if (of_complex.front().with_arb) {
    u.contestants.emplace_back("Arb");
    u.ratios.emplace_back("/Arb");
  }
  for (const complex_operation& op : of_complex) {
    for (const precision bits : {64, 128, 333, 1024, 3333}) {
      benchmarks.add(u, op.name + '/' + std::to_string(bits), [&op, &complex_in_use, bits] {
        complex_in_use.push_back(std::make_unique<complex_operands>(bits));
        return comparison(op, *complex_in_use.back());
      });
    }
  }
  const table v{"hardware",
                "One operation in hardware doubles: of intervals, and of complex regions",
                {"interval", "region"},
                {}};
  hardware_operands in_hardware;
  for (const hardware_operation& op : hardware_operations()) {
    benchmarks.add(v, op.name, [op, &in_hardware] {
      row r;
      r.contestants = {op.of_interval(in_hardware), op.of_region(in_hardware)};
      return r;
    });
  }
  const int status = benchmarks.main(argc, argv);
#ifdef __GLIBC__
  if (status == 0) print_heap_calls(operations);
#endif
  return status;
}
