#pragma once

// What a formula is turned into: flat lists of instructions. Only evaluation.hpp and the compiled
// half need to know.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/function_table.hpp"
#include "polhode/expression/functions.hpp"

namespace polhode::detail {

/// What is computed of at most two operands x and y and an integer n.
enum class operation : std::uint8_t {
  // Without operands.
  number,
  variable,
  pi,
  euler_gamma,
  catalan,
  zeta,  // of n >= 2
  // Of x.
  negate,
  power_integer,  // x^n
  root,           // the real n-th root, n >= 3
  // Of x and y.
  add,
  subtract,
  multiply,
  divide,
  power,
// The functions of the table, of x, or of x and y in the order of the arguments.
#define POLHODE_ENUMERATOR(f, ...) f,
  POLHODE_FUNCTION_TABLE(POLHODE_ENUMERATOR, POLHODE_ENUMERATOR, POLHODE_ENUMERATOR, POLHODE_NO_ROW)
#undef POLHODE_ENUMERATOR
  // Of any number of operands: n is the place in a list of calls.
  further,
};

/// The name of a constant or function in a text; empty for an operator.
[[nodiscard]] const char* name_of(operation what);
/// How many there are of it, 0 for a call.
[[nodiscard]] int operands_of(operation what);
/// Operands of a tape are numbered: first its inputs, then its slots, which are used again.
struct instruction {
  operation what;
  std::uint32_t result;  // a slot, counted from 0
  std::uint32_t left;
  std::uint32_t right;
  long number;
};

/// A call of a function that is not this room's.
struct call_of_further {
  const further_function* function;
  std::vector<std::uint32_t> operands;
};

struct tape {
  std::uint32_t inputs = 0;
  std::uint32_t slots = 0;
  std::vector<instruction> code;
  std::vector<call_of_further> calls;
  std::vector<std::uint32_t> outputs;
};

/// A formula's parts without a variable are evaluated once, as balls; the rest at every call.
struct program {
  std::uint32_t variables = 0;
  std::vector<rational> numbers;  // the inputs of `constants`
  tape constants;
  tape body;  // its inputs: the variables, then the outputs of `constants`; one output
  std::shared_ptr<const further_functions> further;  // where the calls' functions are kept
};

}  // namespace polhode::detail
