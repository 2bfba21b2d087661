#pragma once

// A formula given as text, evaluated in any of the arithmetics.
//
//   const expression f("exp(-x^2) / (1 + k*x)",
//                      {.variables = {"x"}, .definitions = {{"k", "1/3"}}});
//   ball y = f(x);                          // any of the types below, at the precision of x
//   const auto g = f.evaluator<ball>(333);          // for loops: the constants are converted once
//   ball z = g(x);
//
// docs/expressions.md has the grammar and the conventions; functions.hpp the table of functions. A
// formula is a function of real variables with real values. Numbers are read exactly, and
// operations on rational numbers are done exactly while the result is short (most_folded_bits). An
// operation on exact numbers that is not defined (1/0, log(-1), sqrt(-2)) is an error of the
// formula, found when it is read.
//
// The types: ball, region, complex_ball, double_interval, jet<ball, n> for n = 1, 2, 3,
// dynamic_order, and the uncertified mpfr_float and double. For others, another order of a jet say,
// include evaluation.hpp. Over each type the inclusion principle of ball.hpp holds (but for the
// uncertified ones), and what is not defined, or has no enclosure in that type, is answered in the
// type's own way: an undefined ball or coefficient, a region that is not analytic
// (obstacle::unknown where the function is not available there), a NaN. Off the real line each
// function means what region.hpp says, so a formula over regions or complex balls is
// the continuation of the real one; over complex balls, which know nothing of analyticity, with
// principal values.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/double_interval.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/known_number.hpp"
#include "polhode/arithmetic/polynomial.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/expression/functions.hpp"
#include "polhode/expression/program.hpp"

namespace polhode {

/// A text is not a formula, or the formula is not defined; what() says in which column, what was
/// found and what would be right.
class expression_error : public input_error {
 public:
  expression_error(std::size_t column, const std::string& message)
      : input_error("column " + std::to_string(column) + ": " + message), column_(column) {}
  /// An error in the text that defines a name.
  expression_error(const std::string& name, const expression_error& error)
      : input_error("in the value of " + name + ", " + error.what()), column_(error.column_) {}

  /// Counted from 1, in bytes; one more than the length where the text ends too early.
  [[nodiscard]] std::size_t column() const { return column_; }

 private:
  std::size_t column_;
};

/// The names that a formula may use beside functions and constants.
struct expression_names {
  std::vector<std::string> variables;
  /// Names with their values as texts: formulas in numbers, constants and earlier names.
  std::vector<std::pair<std::string, std::string>> definitions;
  /// Functions beside those of functions.hpp.
  std::shared_ptr<const further_functions> further = nullptr;
};

/// How the cost of an evaluation grows with the precision p: nearly as p for sums, products,
/// quotients and roots; a little faster for the elementary functions; as p^2 and more for gamma and
/// its kin. Further functions are taken to grow as the elementary ones do, from a higher price.
enum class expression_cost { algebraic, elementary, further, special };

// Limits that keep a short text from taking much time or memory.
inline constexpr std::size_t longest_expression = 100'000;  // characters
inline constexpr int deepest_expression = 200;              // parentheses inside each other
inline constexpr long most_folded_bits = 1L << 16;  // of a numerator or denominator kept exact
inline constexpr long greatest_exponent_of_ten =
    300'000'000;  // in a number, "1e300"; MPFR ends at 1e323228496

/// Whether the text may be the name of a variable: a letter or _, then letters, digits and _.
[[nodiscard]] bool is_identifier(std::string_view text);

class symbol;  // symbol.hpp

namespace detail {
class graph;

/// What a compiled expression keeps of a constant: T itself, but for a jet, whose order comes with
/// the argument, the coefficient.
template <class T>
struct constant_of {
  using type = T;
};
template <class T, int Order>
struct constant_of<jet<T, Order>> {
  using type = T;
};
/// A region's constants are as precise as it is: in hardware doubles, or in balls.
struct region_constant_pair {
  explicit region_constant_pair(const ball& x) : in_hardware(x), exact(x) {}
  region in_hardware;
  ball exact;
};
template <>
struct constant_of<region> {
  using type = region_constant_pair;
};
/// For types that know exact numbers, and make constants beside a value that they have:
/// x.constant_like(c). A rational number of any length, or another one.
using possibly_exact_constant = std::variant<rational, known_number>;
template <class T>
requires requires(const T& x, const ball& c, const rational& q) {
  x.constant_like(c);
  x.constant_like(q);
}
struct constant_of<T> {
  using type = possibly_exact_constant;
};
}  // namespace detail

/// A formula with its constants converted to T: a function object, cheap to copy, whose calls may
/// run on several threads at once.
template <class T>
class compiled_expression {
 public:
  /// The value at x, for a formula of at most one variable. Throws std::invalid_argument for
  /// others.
  [[nodiscard]] T operator()(const T& x) const {
    if (program_->variables == 0) return evaluate({}, x);
    return evaluate({&x, 1}, x);
  }
  /// The value at the values of the variables, in their order; at least one. Throws
  /// std::invalid_argument for another number of values.
  [[nodiscard]] T operator()(std::span<const T> values) const {
    if (values.empty())
      throw std::invalid_argument("an expression needs a value for each variable");
    return evaluate(values, values.front());
  }

 private:
  friend class expression;
  using constant = typename detail::constant_of<T>::type;

  compiled_expression(std::shared_ptr<const detail::program> program, precision p);
  [[nodiscard]] T evaluate(std::span<const T> values, const T& like) const;

  std::shared_ptr<const detail::program> program_;
  std::shared_ptr<const std::vector<constant>> constants_;
};

class expression {
 public:
  /// Reads a formula. Throws expression_error where it cannot be read, or is certainly undefined,
  /// and input_error for names that may not be used (functions, constants, the same name twice).
  explicit expression(std::string_view text, const expression_names& names = {});
  /// What a function of symbols returned (symbol.hpp); symbol::variable(i) is the i-th of the
  /// names' variables, and their definitions are not looked at. Throws input_error where the
  /// formula is certainly undefined, or has a variable without a name.
  explicit expression(const symbol& formula, const expression_names& names);

  /// The value at x, at the precision of x, for a formula of at most one variable. Converts the
  /// constants at every call: see evaluator.
  template <class T>
  [[nodiscard]] T operator()(const T& x) const {
    return evaluator<T>(detail_precision_of(x))(x);
  }
  /// The formula of a symbol in the place of its variable.
  [[nodiscard]] symbol operator()(const symbol& x) const;
  /// The value at the values of the variables, in their order; at the greatest of their precisions.
  template <class T>
  [[nodiscard]] T evaluate(std::span<const T> values) const {
    precision p = least_precision;
    for (const T& x : values) p = std::max(p, detail_precision_of(x));
    return evaluator<T>(p)(values);
  }
  /// The formula with symbols in the places of its variables.
  [[nodiscard]] symbol evaluate(std::span<const symbol> values) const;
  /// The value of a formula without variables, computed with p bits. Throws std::invalid_argument
  /// where there are variables in it.
  [[nodiscard]] ball value(precision p) const;
  /// The same as an exact number, or with the formula.
  [[nodiscard]] known_number known_value(precision p) const;
  /// Where the value is undefined at p bits: the function, with its domain, that is the first in it
  /// not to be defined; none where that is an operator.
  [[nodiscard]] std::optional<expression_function> undefined_function(precision p) const;
  /// Whether each part without variables is shown to have a value, by moderately many bits. A
  /// formula with a part that has none is defined nowhere, also where the part counts for nothing:
  /// "x + 0*log(cos(2))".
  [[nodiscard]] bool has_defined_constants() const;
  /// The formula with its constants converted to p bits (of their balls; a region or a double has
  /// a precision of its own).
  template <class T>
  [[nodiscard]] compiled_expression<T> evaluator(precision p) const {
    return {program_, p};
  }

  /// The declared variables, in their order; a value is needed for each.
  [[nodiscard]] const std::vector<std::string>& variables() const { return variables_; }
  /// Returns the names for formulas that are made of this one by operator() of symbols: its
  /// variables, and its functions beside those of the table.
  [[nodiscard]] expression_names names() const;
  /// Those that the formula depends on.
  [[nodiscard]] std::vector<std::string> used_variables() const;
  /// The value where the formula was found to be a rational number.
  [[nodiscard]] const std::optional<rational>& exact_value() const { return exact_; }
  /// The value of a formula without variables where it is shown to be a rational number: by
  /// exact_value(), or by exact rules for roots of rational numbers, rational multiples of pi,
  /// exponentials, logarithms and their inverses ("cos(pi/3)", "log(8)/log(2)", "sqrt(3 +
  /// 2*sqrt(2)) - sqrt(2)"). The rules are identities: what they do not show is left open, never
  /// denied. The work is bounded, but for one evaluation with 512 bits.
  [[nodiscard]] std::optional<rational> rational_value() const;
  /// The parts without a variable that are no rational numbers as they stand, each once, as
  /// formulas without variables: "sqrt(2)" and "2*sqrt(2)" of "x^2 - 2*sqrt(2)*x + 2". At most
  /// `most`.
  [[nodiscard]] std::vector<expression> constants(std::size_t most) const;
  /// The same formula with numbers in place of the parts without variables that rational_value()
  /// knows: "x*(1 + sin(3*pi/2))" is "x*(1 - 1)".
  [[nodiscard]] expression with_rational_constants() const;
  /// Numbers, as formulas without variables, at which a divisor of a formula of one variable, or
  /// what stands under a root or a logarithm, may be 0, or a tangent may have a pole: candidates,
  /// found by inverting one operation after the other ("1/(cos(x) - cos(1))": 1 and -1), at most
  /// 64. Those of sines, cosines and tangents are found for all turns of the angle that the range
  /// allows, if they are few. There may be others; a candidate may be undefined, or outside.
  [[nodiscard]] std::vector<expression> divisor_zeros(const double_interval& range) const;
  /// f(x) |dx/ds| as a formula in s, for a formula f of one variable: with x = e + side e^-s for a
  /// finite end, a formula e without variables, and with x = side e^s where `end` is nullptr; side
  /// is 1 or -1. Powers, roots and logarithms of what grows or vanishes as an exponential are
  /// worked out ("1/(x*log(x)^2)" is "1/s^2"). Wherever f(x) is defined for a real s, the formula
  /// has the same value. None where the formula is long, or has no value anywhere.
  [[nodiscard]] std::optional<expression> in_exponential(const expression* end, int side) const;
  /// F with F' = f, entire, for a formula f of one variable that is a sum of products of powers
  /// x^n, n >= 0, constants, and exponentials, sines and cosines of linear forms; so the integral
  /// of f from a to b is F(b) - F(a) wherever F has values there. None for other formulas, and long
  /// ones.
  [[nodiscard]] std::optional<expression> entire_antiderivative() const;
  /// The integral of f from 0 to infinity, for a formula f of one variable that is a sum of
  /// products of whole powers of x, constants, and exponentials, sines and cosines of multiples of
  /// x, where f is bounded at 0 and its integral converges. Theorem and proof:
  /// half_line_integral.cpp. None for other formulas, and long ones.
  [[nodiscard]] std::optional<expression> integral_over_half_line() const;
  /// For a formula of one variable x that is made of x, constants, powers, roots and logarithms of
  /// products of powers of x and positive constants by + - * / : G, a formula in s, entire, where
  /// f(e^-s) e^-s is a sum of products s^n e^(k s), so that the integral of f from a to b is
  /// G(-log a) - G(-log b) for 0 < a, b; G tends to 0 for s -> inf where each k is negative, that
  /// is at x = 0, and for s -> -inf, at x = inf, where each k is positive. None for other formulas.
  struct logarithmic_antiderivative;
  [[nodiscard]] std::optional<logarithmic_antiderivative> antiderivative_in_logarithm() const;
  /// Formulas g_j in s with: the integral of f from `start` to infinity is the sum of those of the
  /// g_j from 0 to infinity, and the g_j decay where f oscillates.
  struct rays;
  /// The rays for a formula f of one variable that is a sum of sines and cosines of
  /// P(x) + Q(x) log x with polynomials P and Q, times rational functions of the variable and of
  /// powers and logarithms of polynomials, small enough for its integral to converge; start >=
  /// from. Theorem and proof: turned_rays.cpp. None for other formulas, and long ones.
  [[nodiscard]] std::optional<rays> on_turned_rays(const rational& from) const;
  /// The integral of such an f, whatever its size, from a start in [a, b] to b as those of
  /// `from_start`, less those of `from_end`, from 0 to infinity, and that of `steady`, if there is
  /// one, from start to b. None for other formulas, for a < 0, and where f may be singular between
  /// the rays.
  struct two_rays;
  [[nodiscard]] std::optional<two_rays> between_turned_rays(const rational& a,
                                                            const rational& b) const;
  /// f for x > 0 as a sum of products of a function of one period, x^e, a rational function, and
  /// powers of polynomials in x with coefficients of the period ("abs(sin(x))/x^2",
  /// "log(2 + cos(x))/(1 + x^2)", "floor(x)/x^3", "1/(x^2 + sin(x))"); it has the same value
  /// wherever f is defined and the polynomials of broken powers are positive. None for other
  /// formulas, where no function of a period is in f or the periods have no common multiple, and
  /// for long ones.
  struct periodic_sum;
  [[nodiscard]] std::optional<periodic_sum> as_periodic_sum() const;
  /// f for x > 0 as a sum of products of a function of one period and any function without one
  /// ("log(abs(sin(x)))*exp(-x)"), likewise.
  struct periodic_products;
  [[nodiscard]] std::optional<periodic_products> as_periodic_products() const;
  /// Formulas F(x, w), periodic in w, and w(x) with f(x) = F(x, w(x)), for a formula f with sines,
  /// cosines or tangents of q w + r, numbers q and r: "x*sin(x^2) + 1" is "x*sin(w) + 1" with the
  /// angle "x^2". One for each angle, and for each of the periods in it that have no common
  /// multiple; the other functions are left in F. x may be several variables; w comes after them.
  /// None of long formulas.
  struct unwound;
  [[nodiscard]] std::vector<unwound> unwound_angles() const;
  /// A formula g of x and further variables with f(x) = g(x, theta_1(x), ...) and -1 <= theta_i <=
  /// 1, the theta_i continuous, on a set of numbers x: functions of large arguments that are waves
  /// there, as Bessel's J, are written as sines or cosines and a rest. Each is continuous where its
  /// argument is. sign_of(u) returns a sign that a formula u of the same variables has for all x in
  /// the set and all theta_i, wherever it is defined; 0 where none is known. None where there are
  /// no such functions, and of long formulas.
  [[nodiscard]] std::optional<expression> by_waves(
      const std::function<int(const expression&)>& sign_of) const;
  /// f of its first variable alone, with any numbers in these sets, in their order, for the others.
  [[nodiscard]] expression with_sets(std::span<const ball> of_others) const;
  /// Whether f is shown to be defined and continuous on a set that is an interval, where sign_of(u)
  /// returns a sign, 1 or -1, that a formula u has wherever in the set it is defined, and 0 where
  /// none is known. By the operations of f; those that are not continuous, or have another domain,
  /// are left undecided.
  [[nodiscard]] bool is_continuous(const std::function<int(const expression&)>& sign_of) const;
  /// N and d_1, d_2, ... such that, where N and the d_i have values, f has one exactly where no d_i
  /// is 0, and is then N divided by powers of the d_i: sums, products, quotients, whole powers, tan
  /// and tanh over one denominator ("tan(x) - x": sin(x) - x*cos(x); cos(x)). None where that is
  /// long.
  struct fraction;
  [[nodiscard]] std::optional<fraction> as_fraction() const;
  /// A part of a range, and what f is inside it.
  struct piece;
  /// f between a and b (none stands for an infinity), a formula of one variable in which abs, min,
  /// max, floor and ceil are of rational functions of x and of each other, in pieces: each with a
  /// formula that has none of these and the same values. None where they meet at an irrational
  /// point, where there are none of them, or more than `most` pieces.
  [[nodiscard]] std::optional<std::vector<piece>> pieces(const std::optional<rational>& a,
                                                         const std::optional<rational>& b,
                                                         std::size_t most) const;
  /// f with one operand, or the negated one, in place of each abs, min and max of what varies: by
  /// is_positive(d), true where d >= 0 on the set of interest, false where d <= 0, with d the
  /// operand of abs, the first operand less the second of the others. None where is_positive
  /// returns nothing, there are none of them, or f has no value anywhere.
  [[nodiscard]] std::optional<expression> without_kinks(
      const std::function<std::optional<bool>(const expression&)>& is_positive) const;
  /// A formula of one variable with whole numbers in place of its steps, the floors and ceilings of
  /// what varies: of the first ones, in their order. None where it then has no value anywhere.
  struct stepped;
  [[nodiscard]] std::optional<stepped> with_steps(const std::vector<integer>& values) const;
  /// T > 0 and n where f is a polynomial in x and in floor and ceil of linear forms: then for all s
  /// and t f(s + T k + t) is a polynomial in k of degree at most n, k a whole number.
  struct staircase;
  [[nodiscard]] std::optional<staircase> as_staircase() const;
  /// f(x) dx/du as a formula in u with x = (u^q - beta)/alpha, where roots and powers in f are of
  /// alpha x + beta alone, and u = (alpha x + beta)^(1/q) makes them whole powers; for alpha x +
  /// beta > 0.
  struct in_root;
  [[nodiscard]] std::optional<in_root> by_root() const;
  /// f(x) dx/du as a formula in u = exp(c x), u > 0, for a formula f of one variable with sines or
  /// cosines of exponentials, all of them of linear forms whose slopes are whole multiples of one
  /// number c ("sin(exp(x))" is "sin(u)/u").
  struct of_exponential;
  [[nodiscard]] std::optional<of_exponential> by_exponential() const;
  /// f(atan(u) + k pi)/(1 + u^2) as a formula in u = tan(x), |x - k pi| < pi/2, for a formula f of
  /// one variable with sines or cosines over tan(x) ("cos(tan(x))" is "cos(u)/(1 + u^2)"). None for
  /// others, and long ones.
  [[nodiscard]] std::optional<expression> by_tangent(const integer& k) const;
  /// f(1/u)/u^2 as a formula in u > 0, for a formula f of one variable with powers of 1/x under
  /// abs, min, max, floor or ceil, or beside a logarithm under a sine or cosine: "floor(1/x)" is
  /// "floor(u)/u^2". None for others, and long ones.
  [[nodiscard]] std::optional<expression> by_reciprocal() const;
  /// f as s A and (T - s) A for a factor T that seems to tend to s = 1 or -1 exponentially for x ->
  /// inf, and a formula with sines or cosines: T is tanh, 1/tanh, erf or 1/(1 + e^-u)
  /// ("tanh(x)*sin(x)/x" is "sin(x)/x" and "-2/(exp(2*x) + 1)*sin(x)/x"). Their sum is f wherever
  /// it is defined. None for others, and long ones.
  struct steady_factor;
  [[nodiscard]] std::optional<steady_factor> by_steady_factor() const;
  /// The same function wherever both are defined, with divisors that seem to grow exponentially for
  /// x -> inf written by exponentials that decay: "1/sinh(x)" is "2*exp(-x)/(1 - exp(-2*x))". None
  /// where there are no such divisors, and of long formulas.
  [[nodiscard]] std::optional<expression> with_decaying_exponentials() const;
  /// The same function for x > 0 wherever both are defined, with what is left for x -> inf of
  /// products in which exponentials and functions that grow or decay as exponentials undo each
  /// other: "exp(x^2)*erfc(x)" is "erfcx(x)", "exp(-3*x)*besselI(0,x)^3" is "besselIx(0,x)^3". None
  /// where no factor seems to grow that the others keep from growing, of long formulas, and where
  /// there is no Arb.
  [[nodiscard]] std::optional<expression> with_scaled_functions() const;
  /// The polynomial with rational coefficients that a formula of at most one variable is, by sums,
  /// products, whole powers and quotients by numbers. None where it is not, or its expansion is
  /// long: a degree above 10,000, a million products of coefficients.
  [[nodiscard]] std::optional<rational_polynomial> polynomial() const;
  /// The quotient of such polynomials that the formula is, with all that it divides by: "1/(1/x)"
  /// is x where x is not 0. None where it is no such quotient, where it divides by 0, or where its
  /// expansion is long.
  [[nodiscard]] std::optional<rational_quotient> quotient() const;
  /// Whether the formula is 0 wherever it is defined, because its expansion, with each function's
  /// value as an unknown of its own, has no term: "sin(x) - sin(x)", "(1+exp(x))^2 - 1 - 2*exp(x) -
  /// exp(x)^2". False where that is not shown.
  [[nodiscard]] bool is_formally_zero() const;
  /// Whether a formula of one variable is 0 so, and defined but for isolated points: "1/(x-sqrt(2))
  /// - 1/(x-sqrt(2))". It is meromorphic then.
  [[nodiscard]] bool is_zero_almost_everywhere() const;
  /// The sum of the absolute values of the formula's terms: |x| + |y| + |z| of x - y + z, and |x|
  /// of what is no sum. A value that cannot be told from 0 has no relative digits, but beside this
  /// size.
  [[nodiscard]] expression sum_of_sizes() const;
  /// The base and the exponent where the value is a power of a rational number that is too long to
  /// be worked out (1e1000000).
  [[nodiscard]] std::optional<std::pair<rational, long>> exact_power() const;
  /// A function of the variables in it that is not analytic in the complex plane: abs, min, max,
  /// floor or ceil. None where there is none.
  [[nodiscard]] std::optional<std::string_view> function_not_analytic() const;
  /// Operations that an evaluation does; a subexpression that occurs twice is computed once.
  [[nodiscard]] std::size_t operation_count() const;
  /// How many numbers an evaluation holds at once.
  [[nodiscard]] std::size_t live_numbers() const;
  [[nodiscard]] expression_cost cost() const;

  /// The formula as text without the names of definitions, numbers as quotients: read again with
  /// the same variables it gives the same operations. Throws std::length_error where it would be
  /// longer than longest_expression.
  [[nodiscard]] std::string to_text() const;
  /// The instructions that evaluate the formula, for those who walk them (program.hpp).
  [[nodiscard]] const detail::program& instructions() const { return *program_; }

 private:
  template <class T>
  [[nodiscard]] static precision detail_precision_of(const T& x);
  void take(std::shared_ptr<const detail::graph> g);
  /// The formula of the same variables whose graph is g with this root.
  [[nodiscard]] expression with_root(detail::graph g, std::uint32_t root) const;

  std::vector<std::string> variables_;
  std::optional<rational> exact_;
  std::shared_ptr<const detail::program> program_;
  std::shared_ptr<const detail::graph> graph_;
};

struct expression::logarithmic_antiderivative {
  expression of_s;
  bool vanishes_at_zero = false;      // of x
  bool vanishes_at_infinity = false;  // of x
};
struct expression::fraction {
  expression numerator;
  std::vector<expression> divisors;
};
struct expression::steady_factor {
  expression limit;
  expression rest;
};
struct expression::rays {
  rational start;
  std::vector<expression> parts;
};
struct expression::two_rays {
  rational start;
  std::vector<expression> from_start;
  std::vector<expression> from_end;
  std::vector<expression> steady;  // at most one
  double turns = 0;                // about how often the fastest part of f turns in [a, b]
};
struct expression::periodic_sum {
  pi_combination period;
  /// (c_0 + c_1 x + ... + c_n x^n)^power with c_i of the period.
  struct moving_power {
    std::vector<expression> coefficients;
    rational power;  // may be 0: f is defined only where the polynomial is not 0
  };
  struct term {
    expression factor;  // of the period
    rational exponent;
    rational_polynomial numerator;  // may be 0: f is defined only where the factors are
    rational_polynomial denominator;
    std::vector<moving_power> powers;
  };
  std::vector<term> terms;
};
struct expression::periodic_products {
  pi_combination period;
  struct term {
    expression factor;  // of the period
    expression steady;
  };
  std::vector<term> terms;
};
struct expression::unwound {
  expression angle;
  pi_combination period;  // of F in w
  expression of_angle;    // F, whose last variable is w
};
struct expression::piece {
  std::optional<rational> lower;  // none for -infinity
  std::optional<rational> upper;  // none for infinity
  expression formula;
};
struct expression::stepped {
  enum class step { none, floor, ceil };
  step next = step::none;  // the first step without a number
  expression formula;      // the whole, or, where there is a next step, its argument
};
struct expression::staircase {
  rational period;
  long degree;
};
struct expression::in_root {
  rational alpha;
  rational beta;
  long q;
  expression formula;
};

struct expression::of_exponential {
  expression slope;  // c; without variables
  expression formula;
};

template <class T>
precision expression::detail_precision_of(const T& x) {
  if constexpr (std::same_as<T, mpfr_float>) {
    return precision_of(x);
  } else if constexpr (std::same_as<T, region>) {
    return std::max<precision>(x.precision(), 64);
  } else if constexpr (requires { x.precision(); }) {
    return x.precision();
  } else if constexpr (detail::is_jet<T>::value) {
    return detail_precision_of(x[0]);
  } else {
    return 64;  // what is kept in hardware doubles
  }
}

extern template class compiled_expression<ball>;
extern template class compiled_expression<complex_ball>;
extern template class compiled_expression<region>;
extern template class compiled_expression<double_interval>;
extern template class compiled_expression<mpfr_float>;
extern template class compiled_expression<double>;
extern template class compiled_expression<jet<ball, 1>>;
extern template class compiled_expression<jet<ball, 2>>;
extern template class compiled_expression<jet<ball, 3>>;
extern template class compiled_expression<jet<ball, dynamic_order>>;

/// x, exactly 0 where its enclosure holds 0 and the rules of expression::rational_value show for
/// its formula that it is; without a formula where they do not.
[[nodiscard]] known_number settled(const known_number& x);

}  // namespace polhode
