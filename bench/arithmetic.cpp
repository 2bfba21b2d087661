// One operation of the ball against the same of plain MPFR and of Arb, and how often each goes to
// the heap.
//
// Operands are balls with a radius of one unit in the last place about numbers like sqrt(2), and
// for MPFR their midpoints; the result's storage is used again from call to call. The limits are
// those that Polhode sets itself; a ratio below 1 means that the ball is faster.

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
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
  explicit operands(precision p) : bits(p), x(operand(2, p)), y(operand(3, p)) {
    mx.reset(p);
    my.reset(p);
    mr.reset(p);
    x.midpoint(mx.get());
    y.midpoint(my.get());
#ifdef POLHODE_HAVE_ARB
    const auto convert = [](arb_ptr to, mpfr_srcptr midpoint, const magnitude& radius) {
      arf_set_mpfr(arb_midref(to), midpoint);
      mag_set_ui_2exp_si(arb_radref(to), radius.fraction(), static_cast<slong>(radius.exponent()));
    };
    convert(ax.get(), mx.get(), x.radius());
    convert(ay.get(), my.get(), y.radius());
#endif
  }

  precision bits;
  ball x, y, r;
  polhode::detail::mpfr_cell mx, my, mr;
#ifdef POLHODE_HAVE_ARB
  arb_number ax, ay, ar;
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
    if (op.name == "x*y") op.ours = POLHODE_CALL(const ball r = o.x * o.y);
    op.field = op.name == "mul" || op.name == "div" || op.name == "sqrt";
    op.elementary = op.name == "exp" || op.name == "log" || op.name == "sin" || op.name == "cos" ||
                    op.name == "atan";
    op.limited_by_arb = op.field || op.name == "add" || op.name == "agm";
  }
  return result;
}
#undef POLHODE_UNARY
#undef POLHODE_BINARY
#undef POLHODE_CALL
#undef POLHODE_WITH_ARB

std::optional<limit> limit_against_mpfr(const operation& op, precision bits) {
  if (op.elementary) return at_most(1.15);
  if (!op.field || bits < 128) return std::nullopt;
  return at_most(bits < 333 ? 1.7 : (bits < 1024 ? 1.35 : 1.1));
}

std::optional<limit> limit_against_arb(const operation& op) {
  return op.limited_by_arb ? std::optional(at_most(1.2)) : std::nullopt;
}

row comparison(const operation& op, operands& o) {
  row r;
  r.contestants = {op.ours(o), op.with_mpfr(o)};
  r.ratios = {{0, 1, limit_against_mpfr(op, o.bits)}};
  if (op.with_arb) {
    r.contestants.push_back(op.with_arb(o));
    r.ratios.push_back({0, 2, limit_against_arb(op)});
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
  }
  for (const operation& op : operations) {
    for (const precision bits : {64, 128, 333, 1024, 3333, 33333}) {
      benchmarks.add(t, op.name + '/' + std::to_string(bits), [&op, &in_use, bits] {
        in_use.push_back(std::make_unique<operands>(bits));
        return comparison(op, *in_use.back());
      });
    }
  }
  const int status = benchmarks.main(argc, argv);
#ifdef __GLIBC__
  if (status == 0) print_heap_calls(operations);
#endif
  return status;
}
