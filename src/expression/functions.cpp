#include "polhode/expression/functions.hpp"

#include <algorithm>
#include <optional>
#include <type_traits>

#include "calls.hpp"
#include "graph.hpp"
#include "polhode/expression/function_table.hpp"
#include "polynomials.hpp"

namespace polhode {
namespace detail {
namespace {

using operands = std::vector<node_id>;

// ---------------------------------------------------------------------------------------------
// Domains, for operands that are numbers. (Elsewhere the evaluation finds out.)

bool everywhere(const rational&) { return true; }
bool not_negative(const rational& q) { return q >= 0; }
bool positive(const rational& q) { return q > 0; }
bool not_zero(const rational& q) { return q != 0; }
bool above_minus_one(const rational& q) { return q > -1; }
bool from_one(const rational& q) { return q >= 1; }
bool in_closed_unit(const rational& q) { return q >= -1 && q <= 1; }
bool in_open_unit(const rational& q) { return q > -1 && q < 1; }
bool outside_open_unit(const rational& q) { return q >= 1 || q <= -1; }
bool outside_closed_unit(const rational& q) { return q > 1 || q < -1; }
bool in_unit_but_zero(const rational& q) { return q > 0 && q <= 1; }
bool no_pole_of_gamma(const rational& q) { return q > 0 || denominator(q) != 1; }
bool no_negative_integer(const rational& q) { return q >= 0 || denominator(q) != 1; }

/// Throws undefined_operation where x is a number outside the domain of the function.
void check_domain(const graph& g, const char* name, node_id x, bool (*defined)(const rational&)) {
  const rational* q = g.value(x);
  if (q == nullptr || defined(*q)) return;
  throw undefined_operation(std::string(name) + "(" + brief(*q) + ") is not defined: it needs " +
                            find_function(name)->what.domain);
}

// ---------------------------------------------------------------------------------------------
// Values that are rational numbers.

/// The functions whose values at 0, or at 1, are 0 or 1.
std::optional<rational> value_at_unit(operation what, const rational& q) {
  switch (what) {
    case operation::expm1:
    case operation::log1p:
    case operation::sin:
    case operation::tan:
    case operation::asin:
    case operation::atan:
    case operation::sinh:
    case operation::tanh:
    case operation::asinh:
    case operation::atanh:
    case operation::erf:
      if (q == 0) return rational(0);
      return std::nullopt;
    case operation::exp:
    case operation::cos:
    case operation::cosh:
    case operation::erfc:
      if (q == 0) return rational(1);
      return std::nullopt;
    case operation::log:
    case operation::acos:
    case operation::acosh:
      if (q == 1) return rational(0);
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

/// cos(pi q) for q in halves and thirds: at other rational numbers it is not rational
/// (I. Niven, Irrational Numbers, 1956, cor. 3.12).
std::optional<rational> rational_cospi(const rational& q) {
  const integer below = denominator(q);
  if (below > 3) return std::nullopt;
  const integer turn = 2 * below;
  integer step;  // q = step / below in [0, 2)
  mpz_fdiv_r(step.backend().data(), numerator(q).backend().data(), turn.backend().data());
  const rational angle = rational(step) / rational(below);
  const rational folded = angle > 1 ? rational(2 - angle) : angle;  // in [0, 1]
  if (folded == 0) return rational(1);
  if (folded == rational(1, 3)) return rational(1, 2);
  if (folded == rational(1, 2)) return rational(0);
  if (folded == rational(2, 3)) return rational(-1, 2);
  return rational(-1);
}

std::optional<rational> rational_value(operation what, const rational& q) {
  switch (what) {
    case operation::abs:
      return q < 0 ? rational(-q) : q;
    case operation::floor:
      return rational(floor_of(q));
    case operation::ceil:
      return rational(ceil_of(q));
    case operation::sqrt:
      return exact_root(q, 2);
    case operation::cospi:
      return rational_cospi(q);
    case operation::sinpi:  // sin(pi q) = cos(pi (1/2 - q))
      return rational_cospi(rational(1, 2) - q);
    default:
      return value_at_unit(what, q);
  }
}

/// The function of x, done exactly where x is a number and the value too.
node_id function_of(graph& g, operation what, node_id x) {
  if (const rational* q = g.value(x)) {
    if (const auto exact = rational_value(what, *q)) return g.number(*exact);
  }
  return g.make(what, x);
}

// ---------------------------------------------------------------------------------------------
// The functions

/// How a call of the operation is read: by the domain that the table gives, or the function that it
/// gives.
template <operation what, auto reader>
node_id read_call(graph& g, const operands& x) {
  if constexpr (std::is_invocable_v<decltype(reader), graph&, const operands&>) {
    return reader(g, x);
  } else {
    check_domain(g, name_of(what), x[0], reader);
    return function_of(g, what, x[0]);
  }
}

/// The quotient of two functions of x; `above` may be none, for 1.
node_id quotient(graph& g, std::optional<operation> above, operation below, node_id x) {
  const node_id numerator = above ? function_of(g, *above, x) : g.number(1);
  return divide(g, numerator, function_of(g, below, x));
}
node_id secant(graph& g, const operands& x) { return quotient(g, {}, operation::cos, x[0]); }
node_id cosecant(graph& g, const operands& x) {
  check_domain(g, "csc", x[0], not_zero);
  return quotient(g, {}, operation::sin, x[0]);
}
node_id cotangent(graph& g, const operands& x) {
  check_domain(g, "cot", x[0], not_zero);
  return quotient(g, operation::cos, operation::sin, x[0]);
}
node_id hyperbolic_secant(graph& g, const operands& x) {
  return quotient(g, {}, operation::cosh, x[0]);
}
node_id hyperbolic_cosecant(graph& g, const operands& x) {
  check_domain(g, "csch", x[0], not_zero);
  return quotient(g, {}, operation::sinh, x[0]);
}
node_id hyperbolic_cotangent(graph& g, const operands& x) {
  check_domain(g, "coth", x[0], not_zero);
  return quotient(g, {}, operation::tanh, x[0]);
}

/// The function of 1/x, where x is in the domain of the function of that name: the inverse of a
/// reciprocal, as asec(x) = acos(1/x).
node_id of_reciprocal(graph& g, operation what, const char* name, node_id x,
                      bool (*defined)(const rational&)) {
  check_domain(g, name, x, defined);
  return function_of(g, what, divide(g, g.number(1), x));
}
#define POLHODE_OF_RECIPROCAL(reader, name, what, defined)          \
  node_id reader(graph& g, const operands& x) {                     \
    return of_reciprocal(g, operation::what, #name, x[0], defined); \
  }
POLHODE_OF_RECIPROCAL(inverse_secant, asec, acos, outside_open_unit)
POLHODE_OF_RECIPROCAL(inverse_cosecant, acsc, asin, outside_open_unit)
POLHODE_OF_RECIPROCAL(inverse_hyperbolic_secant, asech, acosh, in_unit_but_zero)
POLHODE_OF_RECIPROCAL(inverse_hyperbolic_cosecant, acsch, asinh, not_zero)
POLHODE_OF_RECIPROCAL(inverse_hyperbolic_cotangent, acoth, atanh, outside_closed_unit)
#undef POLHODE_OF_RECIPROCAL

/// acot(x) = pi/2 - atan(x), in (0, pi) and analytic everywhere. For a number x > 0 that is
/// atan(1/x), without cancellation.
node_id inverse_cotangent(graph& g, const operands& x) {
  const rational* q = g.value(x[0]);
  if (q != nullptr && *q > 0) return function_of(g, operation::atan, g.number(1 / *q));
  return subtract(g, divide(g, g.make(operation::pi), g.number(2)),
                  function_of(g, operation::atan, x[0]));
}

node_id root_of(graph& g, const operands& x) {
  const rational* order = g.value(x[1]);
  if (order == nullptr || denominator(*order) != 1 || *order < 1 ||
      *order > rational(std::numeric_limits<long>::max())) {
    throw undefined_operation(
        "the second argument of root must be a whole number from 1, as in root(x, 3)");
  }
  const long n = mpz_get_si(numerator(*order).backend().data());
  if (n == 1) return x[0];
  if (const rational* q = g.value(x[0])) {
    if (*q < 0 && n % 2 == 0) {
      throw undefined_operation("root(" + brief(*q) + ", " + std::to_string(n) +
                                ") is not defined: it needs " + find_function("root")->what.domain);
    }
    if (const auto exact = exact_root(*q, static_cast<unsigned long>(n))) return g.number(*exact);
  }
  return n == 2 ? g.make(operation::sqrt, x[0]) : g.make(operation::root, x[0], 0, n);
}

node_id cube_root_of(graph& g, const operands& x) { return root_of(g, {x[0], g.number(3)}); }

/// log x / log b for b = 2 or 10; exactly for powers of b.
node_id logarithm(graph& g, const char* name, node_id x, long b) {
  check_domain(g, name, x, positive);
  if (const rational* q = g.value(x)) {
    const bool large = *q > 1;
    integer rest = large ? numerator(*q) : denominator(*q);
    if ((large ? denominator(*q) : numerator(*q)) == 1) {
      const integer base = b;
      const auto n = static_cast<long>(
          mpz_remove(rest.backend().data(), rest.backend().data(), base.backend().data()));
      if (rest == 1) return g.number(large ? n : -n);
    }
  }
  return divide(g, function_of(g, operation::log, x), g.make(operation::log, g.number(b)));
}

node_id binary_logarithm(graph& g, const operands& x) { return logarithm(g, "log2", x[0], 2); }
node_id decimal_logarithm(graph& g, const operands& x) { return logarithm(g, "log10", x[0], 10); }
node_id natural_logarithm(graph& g, const operands& x) {
  return read_call<operation::log, positive>(g, x);
}

node_id power_of(graph& g, const operands& x) { return power(g, x[0], x[1]); }

node_id gamma_of(graph& g, const operands& x) {
  check_domain(g, "gamma", x[0], no_pole_of_gamma);
  const rational* q = g.value(x[0]);
  if (q != nullptr && denominator(*q) == 1) {  // the factorial of a large number is this node again
    const node_id exact = factorial(g, g.number(*q - 1));
    if (g.value(exact) != nullptr) return exact;
  }
  return g.make(operation::gamma, x[0]);
}

node_id factorial_of(graph& g, const operands& x) {
  check_domain(g, "factorial", x[0], no_negative_integer);
  return gamma_of(g, {add(g, x[0], g.number(1))});
}

node_id euler_beta_of(graph& g, const operands& x) {
  const node_id sum = add(g, x[0], x[1]);
  for (const node_id i : {x[0], x[1], sum}) check_domain(g, "euler_beta", i, no_pole_of_gamma);
  return divide(g, multiply(g, gamma_of(g, {x[0]}), gamma_of(g, {x[1]})), gamma_of(g, {sum}));
}

node_id log_gamma_of(graph& g, const operands& x) {
  check_domain(g, "log_gamma", x[0], no_pole_of_gamma);
  const rational* q = g.value(x[0]);
  if (q != nullptr && (*q == 1 || *q == 2)) return g.number(0);
  return g.make(operation::log_gamma, x[0]);
}

/// Of other numbers than whole ones a further function, where there is one of this name.
node_id zeta_of(graph& g, const operands& x) {
  const rational* q = g.value(x[0]);
  if (q == nullptr || denominator(*q) != 1 || *q < 2 ||
      *q > rational(std::numeric_limits<long>::max())) {
    if (const auto* const f = find_further(g.further().get(), "zeta", 1)) {
      return call_further(g, *f, {x[0]});
    }
    throw undefined_operation("zeta is available at whole numbers from 2");
  }
  return g.make(operation::zeta, 0, 0, mpz_get_si(numerator(*q).backend().data()));
}

node_id smaller_of(graph& g, const operands& x) {
  const rational* a = g.value(x[0]);
  const rational* b = g.value(x[1]);
  if (a != nullptr && b != nullptr) return *a < *b ? x[0] : x[1];
  return x[0] == x[1] ? x[0] : g.make(operation::min, x[0], x[1]);
}
node_id greater_of(graph& g, const operands& x) {
  const rational* a = g.value(x[0]);
  const rational* b = g.value(x[1]);
  if (a != nullptr && b != nullptr) return *a < *b ? x[1] : x[0];
  return x[0] == x[1] ? x[0] : g.make(operation::max, x[0], x[1]);
}

/// floor(c) + ceil(c) with c = max(-1/2, min(1/2, x)): for x > 0, c is in (0, 1/2] and the sum is 0
/// + 1; for x = 0 it is 0 + 0; for x < 0, c is in [-1/2, 0) and the sum is -1 + 0.
node_id sign_of(graph& g, const operands& x) {
  const node_id below = smaller_of(g, {x[0], g.number(rational(1, 2))});
  const node_id c = greater_of(g, {below, g.number(rational(-1, 2))});
  return add(g, function_of(g, operation::floor, c), function_of(g, operation::ceil, c));
}

/// floor(max(x, 0)) + ceil(min(x, 0)), of which one is 0.
node_id truncated(graph& g, const operands& x) {
  const node_id zero = g.number(0);
  return add(g, function_of(g, operation::floor, greater_of(g, {x[0], zero})),
             function_of(g, operation::ceil, smaller_of(g, {x[0], zero})));
}
node_id rounded(graph& g, const operands& x) {
  return function_of(g, operation::floor, add(g, x[0], g.number(rational(1, 2))));
}
node_id fractional_part(graph& g, const operands& x) {
  return subtract(g, x[0], function_of(g, operation::floor, x[0]));
}
node_id remainder_of(graph& g, const operands& x) {
  const node_id turns = function_of(g, operation::floor, divide(g, x[0], x[1]));
  return subtract(g, x[0], multiply(g, x[1], turns));
}
node_id unit_step(graph& g, const operands& x) {
  return divide(g, add(g, g.number(1), sign_of(g, x)), g.number(2));
}

node_id cardinal_sine(graph& g, const operands& x) {
  const rational* q = g.value(x[0]);
  if (q != nullptr && *q == 0) return g.number(1);
  return divide(g, function_of(g, operation::sin, x[0]), x[0]);
}

node_id hypot_of(graph& g, const operands& x) {
  const node_id sum = add(g, power(g, x[0], g.number(2)), power(g, x[1], g.number(2)));
  if (const rational* q = g.value(sum)) {
    if (const auto exact = exact_root(*q, 2)) return g.number(*exact);
  }
  return g.make(operation::hypot, x[0], x[1]);
}

node_id agm_of(graph& g, const operands& x) {
  check_domain(g, "agm", x[0], not_negative);
  check_domain(g, "agm", x[1], not_negative);
  return g.value(x[0]) != nullptr && x[0] == x[1] ? x[0] : g.make(operation::agm, x[0], x[1]);
}

node_id atan2_of(graph& g, const operands& x) {
  const rational* ordinate = g.value(x[0]);
  const rational* abscissa = g.value(x[1]);
  if (ordinate != nullptr && abscissa != nullptr && *ordinate == 0) {
    if (*abscissa == 0) throw undefined_operation("atan2(0, 0) is not defined");
    return *abscissa > 0 ? g.number(0) : g.make(operation::pi);
  }
  return g.make(operation::atan2, x[0], x[1]);
}

int arity_of(std::string_view arguments) {
  return 1 + static_cast<int>(std::count(arguments.begin(), arguments.end(), ','));
}

}  // namespace

const std::vector<function_row>& function_rows() {
#define POLHODE_ROW(f, arguments, description, domain, kind, reader) \
  {{#f, arguments, description, domain}, arity_of(arguments), read_call<operation::f, reader>},
#define POLHODE_MADE(f, arguments, description, domain, reader) \
  {{#f, arguments, description, domain}, arity_of(arguments), reader},
  static const std::vector<function_row> rows{
      POLHODE_FUNCTION_TABLE(POLHODE_ROW, POLHODE_ROW, POLHODE_ROW, POLHODE_MADE)};
#undef POLHODE_ROW
#undef POLHODE_MADE
  return rows;
}

const std::vector<constant_row>& constant_rows() {
  static const std::vector<constant_row> rows{
      {{"pi", "3.14159..., half the circumference of the unit circle"},
       [](graph& g) { return g.make(operation::pi); }},
      {{"e", "2.71828..., the base of the natural logarithm"},
       [](graph& g) { return g.make(operation::exp, g.number(1)); }},
      {{"euler_gamma", "0.57721..., the limit of 1 + 1/2 + ... + 1/n - log(n)"},
       [](graph& g) { return g.make(operation::euler_gamma); }},
      {{"catalan", "0.91596..., 1 - 1/9 + 1/25 - 1/49 + ..."},
       [](graph& g) { return g.make(operation::catalan); }},
  };
  return rows;
}

namespace {
template <class Row>
const Row* find_row(const std::vector<Row>& rows, std::string_view name) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [name](const Row& row) { return row.what.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

template <class What, class Row>
std::vector<What> published(const std::vector<Row>& rows) {
  std::vector<What> result;
  result.reserve(rows.size());
  for (const Row& row : rows) result.push_back(row.what);
  return result;
}
}  // namespace

bool has_further(const further_functions* further, std::string_view name) {
  return further != nullptr &&
         std::any_of(further->begin(), further->end(),
                     [name](const further_function& f) { return f.what.name == name; });
}
const further_function* find_further(const further_functions* further, std::string_view name,
                                     std::size_t arity) {
  if (further == nullptr) return nullptr;
  const auto found = std::find_if(further->begin(), further->end(), [&](const further_function& f) {
    return f.what.name == name && f.arity == arity;
  });
  return found == further->end() ? nullptr : &*found;
}

namespace {
/// The name that another one stands for, or that name itself.
std::string_view meaning_of(std::string_view name) {
  for (const expression_alias& a : expression_aliases()) {
    if (a.name == name) return a.meaning;
  }
  return name;
}
}  // namespace

const function_row* find_function(std::string_view name) {
  return find_row(function_rows(), meaning_of(name));
}
const constant_row* find_constant(std::string_view name) {
  return find_row(constant_rows(), meaning_of(name));
}

}  // namespace detail

std::vector<std::string> argument_names(const expression_function& f) {
  std::vector<std::string> names(1);
  for (const char c : f.arguments) {
    if (c == ',') names.emplace_back();
    if (c != ',' && c != ' ') names.back() += c;
  }
  return names;
}

const std::vector<expression_function>& expression_functions() {
  static const auto functions = detail::published<expression_function>(detail::function_rows());
  return functions;
}
const std::vector<expression_constant>& expression_constants() {
  static const auto constants = detail::published<expression_constant>(detail::constant_rows());
  return constants;
}

const std::vector<expression_alias>& expression_aliases() {
  static const std::vector<expression_alias> aliases{
      {"arcsin", "asin"},   {"arccos", "acos"},   {"arctan", "atan"},   {"arctan2", "atan2"},
      {"arccot", "acot"},   {"arcsec", "asec"},   {"arccsc", "acsc"},   {"arsinh", "asinh"},
      {"arcosh", "acosh"},  {"artanh", "atanh"},  {"arcsinh", "asinh"}, {"arccosh", "acosh"},
      {"arctanh", "atanh"}, {"arsech", "asech"},  {"arcsch", "acsch"},  {"arcoth", "acoth"},
      {"arcsech", "asech"}, {"arccsch", "acsch"}, {"arccoth", "acoth"}, {"sgn", "sign"},
      {"Pi", "pi"},         {"PI", "pi"}};
  return aliases;
}

bool is_infinity(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower == "inf" || lower == "infinity" || lower == "oo" || lower == "\u221E";
}

}  // namespace polhode
