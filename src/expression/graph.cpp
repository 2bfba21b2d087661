#include "graph.hpp"

#include <algorithm>
#include <optional>

#include "exact/rationals.hpp"

namespace polhode::detail {
namespace {

bool commutes(operation what) {
  switch (what) {
    case operation::add:
    case operation::multiply:
#define POLHODE_COMMUTES(f, ...) case operation::f:
      POLHODE_FUNCTION_TABLE(POLHODE_NO_ROW, POLHODE_NO_ROW, POLHODE_COMMUTES, POLHODE_NO_ROW)
#undef POLHODE_COMMUTES
      return true;
    default:
      return false;
  }
}

long length_of(const integer& n) {
  return n == 0 ? 0 : static_cast<long>(mpz_sizeinbase(n.backend().data(), 2));
}
long length_of(const rational& q) {
  return std::max(length_of(numerator(q)), length_of(denominator(q)));
}
bool is_short(const rational& q) { return length_of(q) <= most_folded_bits; }

/// Where its negative is a machine number, too.
std::optional<long> as_long(const rational& q) {
  const integer n = numerator(q);
  if (!exact_parts::is_integer(q) || mpz_fits_slong_p(n.backend().data()) == 0) return std::nullopt;
  const long value = mpz_get_si(n.backend().data());
  return value == std::numeric_limits<long>::min() ? std::nullopt : std::optional(value);
}

/// f(x, y) for two numbers where it is short, else nothing.
template <class F>
std::optional<node_id> folded(graph& g, node_id x, node_id y, F&& f) {
  const rational* a = g.value(x);
  const rational* b = g.value(y);
  if (a == nullptr || b == nullptr || !is_short(*a) || !is_short(*b)) return std::nullopt;
  const rational result = f(*a, *b);
  if (!is_short(result)) return std::nullopt;
  return g.number(result);
}

bool is_number(const graph& g, node_id x, long n) {
  const rational* q = g.value(x);
  return q != nullptr && *q == n;
}

/// The node is e.
bool is_e(const graph& g, node_id x) {
  return g[x].what == operation::exp && is_number(g, g[x].left, 1);
}

rational integer_power(const rational& q, unsigned long n) {
  integer above = numerator(q);
  integer below = denominator(q);
  mpz_pow_ui(above.backend().data(), above.backend().data(), n);
  mpz_pow_ui(below.backend().data(), below.backend().data(), n);
  return rational(above) / rational(below);
}

[[noreturn]] void refuse_power(const rational& x, const rational& y, const char* why) {
  throw undefined_operation(brief(x) + " to the power " + brief(y) + " is not defined: " + why);
}

node_id power_to_long(graph& g, node_id x, long n) {
  if (n == 1) return x;
  if (is_e(g, x)) return n == 0 ? g.number(1) : g.make(operation::exp, g.number(n));
  const rational* q = g.value(x);
  if (q == nullptr) {
    // (q^m)^n = q^(m n) for a number q, which is not 0 here: powers of 0 are numbers.
    const node& inner = g[x];
    long product = 0;
    if (inner.what == operation::power_integer && g.value(inner.left) != nullptr && n != 0 &&
        !__builtin_mul_overflow(inner.number, n, &product) &&
        product != std::numeric_limits<long>::min()) {
      return g.make(operation::power_integer, inner.left, 0, product);
    }
    return g.make(operation::power_integer, x, 0, n);
  }
  if (*q == 0 && n < 0) refuse_power(*q, n, "0 has no negative powers");
  const bool odd = n % 2 != 0;
  if (n == 0 || *q == 1) return g.number(1);
  if (*q == 0) return g.number(0);
  if (*q == -1) return g.number(odd ? -1 : 1);
  const unsigned long size =
      n < 0 ? 0UL - static_cast<unsigned long>(n) : static_cast<unsigned long>(n);
  if (size > static_cast<unsigned long>(most_folded_bits / length_of(*q))) {
    return g.make(operation::power_integer, x, 0, n);
  }
  const rational result = integer_power(*q, size);
  return g.number(n < 0 ? rational(1 / result) : result);
}

/// An integer that is too great for a machine: only 0, 1 and -1 have such powers that can be
/// written.
std::optional<node_id> power_to_great_integer(graph& g, const rational& x, const rational& n) {
  if (x == 0 && n < 0) refuse_power(x, n, "0 has no negative powers");
  if (x == 0 || x == 1) return g.number(x);
  if (x == -1) return g.number(mpz_even_p(numerator(n).backend().data()) != 0 ? 1 : -1);
  return std::nullopt;
}

/// x^y for a fraction y, where that is a rational number.
std::optional<node_id> power_to_fraction(graph& g, const rational& x, const rational& y) {
  if (x < 0) {
    refuse_power(x, y,
                 "the base of a fractional power must not be negative; root(x, n) is the real root "
                 "of odd order");
  }
  if (x == 0 && y < 0) refuse_power(x, y, "0 has no negative powers");
  if (x == 0 || x == 1) return g.number(x);
  const std::optional<long> n = as_long(rational(denominator(y)));
  const std::optional<long> m = as_long(rational(numerator(y)));
  if (!n || !m) return std::nullopt;
  const std::optional<rational> root = exact_root(x, static_cast<unsigned long>(*n));
  if (!root) return std::nullopt;
  return power_to_long(g, g.number(*root), *m);
}

}  // namespace

std::string brief(const rational& q) {
  constexpr std::size_t most = 40;
  if (length_of(q) > 8 * static_cast<long>(most)) return "a number of many digits";
  std::string text = polhode::to_text(q);
  if (text.size() > most) return text.substr(0, most) + "...";
  return text;
}

// NOLINTBEGIN(bugprone-branch-clone): a case each function, by the table
int operands_of(operation what) {
  switch (what) {
    case operation::negate:
    case operation::power_integer:
    case operation::root:
      return 1;
    case operation::add:
    case operation::subtract:
    case operation::multiply:
    case operation::divide:
    case operation::power:
      return 2;
#define POLHODE_ONE(f, ...) \
  case operation::f:        \
    return 1;
#define POLHODE_TWO(f, ...) \
  case operation::f:        \
    return 2;
      POLHODE_FUNCTION_TABLE(POLHODE_ONE, POLHODE_TWO, POLHODE_TWO, POLHODE_NO_ROW)
#undef POLHODE_ONE
#undef POLHODE_TWO
    default:
      return 0;
  }
}
// NOLINTEND(bugprone-branch-clone)

bool is_piecewise(operation what) {
  return what == operation::abs || what == operation::min || what == operation::max ||
         what == operation::floor || what == operation::ceil;
}

std::vector<node_id> operands_at(const graph& g, node_id i) {
  const node& n = g[i];
  if (n.what == operation::further) {
    std::vector<node_id> result = g.call_at(i).operands;
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
  switch (operands_of(n.what)) {
    case 0:
      return {};
    case 1:
      return {n.left};
    default:
      if (n.left == n.right) return {n.left};
      return {n.left, n.right};
  }
}

node_id graph::call(const further_call& c) {
  if (const auto known = known_calls_.find(c); known != known_calls_.end()) return known->second;
  calls_.push_back(c);
  nodes_.push_back({operation::further, 0, 0, static_cast<long>(calls_.size()) - 1});
  return known_calls_[c] = size() - 1;
}

node_id graph::plain(const node& n) {
  if (const auto known = known_.find(n); known != known_.end()) return known->second;
  if (commutes(n.what)) {
    const auto turned = known_.find({n.what, n.right, n.left, n.number});
    if (turned != known_.end()) return turned->second;
  }
  nodes_.push_back(n);
  return known_[n] = size() - 1;
}

node_id graph::number(const rational& q) {
  if (const auto known = known_numbers_.find(q); known != known_numbers_.end()) {
    return known->second;
  }
  numbers_.push_back(q);
  nodes_.push_back({operation::number, 0, 0, static_cast<long>(numbers_.size()) - 1});
  return known_numbers_[q] = size() - 1;
}

namespace {

/// Whether a variable is in it.
bool varies(const graph& g, node_id x) {
  std::vector<char> seen(x + 1, 0);
  seen[x] = 1;
  for (node_id i = x + 1; i-- > 0;) {
    if (seen[i] == 0) continue;
    if (g[i].what == operation::variable) return true;
    for (const node_id operand : operands_at(g, i)) seen[operand] = 1;
  }
  return false;
}

/// number - f: 1 - erf(x) = erfc(x), 1 - erfc(x) = erf(x), 2 - erfc(x) = erfc(-x), which lose no
/// digits where the difference does. A constant is left to the exact rules, which know f as it is.
std::optional<node_id> complement_of(graph& g, node_id f, node_id number) {
  const operation what = g[f].what;
  const bool is_one = is_number(g, number, 1);
  const bool is_two = is_number(g, number, 2) && what == operation::erfc;
  if ((what != operation::erf && what != operation::erfc) || (!is_one && !is_two)) {
    return std::nullopt;
  }
  const node_id x = g[f].left;
  if (!varies(g, x)) return std::nullopt;
  if (is_two) return g.make(operation::erfc, negate(g, x));
  return g.make(what == operation::erf ? operation::erfc : operation::erf, x);
}

/// 1 + erf(x) = erfc(-x), likewise.
std::optional<node_id> sum_with_erf(graph& g, node_id f, node_id number) {
  const node_id x = g[f].left;
  if (g[f].what != operation::erf || !is_number(g, number, 1) || !varies(g, x)) {
    return std::nullopt;
  }
  return g.make(operation::erfc, negate(g, x));
}

}  // namespace

node_id add(graph& g, node_id x, node_id y) {
  if (is_number(g, x, 0)) return y;
  if (is_number(g, y, 0)) return x;
  if (const auto other = sum_with_erf(g, x, y)) return *other;
  if (const auto other = sum_with_erf(g, y, x)) return *other;
  const auto exact =
      folded(g, x, y, [](const rational& a, const rational& b) { return rational(a + b); });
  return exact ? *exact : g.make(operation::add, x, y);
}

node_id subtract(graph& g, node_id x, node_id y) {
  if (is_number(g, y, 0)) return x;
  if (const auto other = complement_of(g, y, x)) return *other;
  if (const auto other = complement_of(g, x, y)) return negate(g, *other);
  const auto exact =
      folded(g, x, y, [](const rational& a, const rational& b) { return rational(a - b); });
  return exact ? *exact : g.make(operation::subtract, x, y);
}

node_id multiply(graph& g, node_id x, node_id y) {
  if (is_number(g, x, 1)) return y;
  if (is_number(g, y, 1)) return x;
  const auto exact =
      folded(g, x, y, [](const rational& a, const rational& b) { return rational(a * b); });
  return exact ? *exact : g.make(operation::multiply, x, y);
}

node_id divide(graph& g, node_id x, node_id y) {
  if (is_number(g, y, 0)) throw undefined_operation("a division by zero");
  if (is_number(g, y, 1)) return x;
  const auto exact =
      folded(g, x, y, [](const rational& a, const rational& b) { return rational(a / b); });
  return exact ? *exact : g.make(operation::divide, x, y);
}

node_id negate(graph& g, node_id x) {
  if (const rational* q = g.value(x)) return g.number(-*q);
  if (g[x].what == operation::negate) return g[x].left;
  return g.make(operation::negate, x);
}

namespace {

/// (-1)^n = 1 - 2 n + 4 floor(n/2) of n = floor(u), where floor(n/2) = floor(u/2); ceil(u) is
/// -floor(-u). Nothing for other exponents.
std::optional<node_id> power_of_minus_one(graph& g, node_id exponent) {
  const operation what = g[exponent].what;
  if (what != operation::floor && what != operation::ceil) return std::nullopt;
  const node_id operand = g[exponent].left;
  const node_id u = what == operation::floor ? operand : negate(g, operand);
  const auto floor_of = [&](node_id v) { return g.make(operation::floor, v); };
  const node_id twice = multiply(g, g.number(2), floor_of(u));
  const node_id half = floor_of(divide(g, u, g.number(2)));
  return add(g, subtract(g, g.number(1), twice), multiply(g, g.number(4), half));
}

}  // namespace

node_id power(graph& g, node_id x, node_id y) {
  const rational* exponent = g.value(y);
  if (exponent == nullptr) {
    if (is_number(g, x, -1)) {
      if (const auto sign = power_of_minus_one(g, y)) return *sign;
    }
    return is_e(g, x) ? g.make(operation::exp, y) : g.make(operation::power, x, y);
  }
  if (const std::optional<long> n = as_long(*exponent)) return power_to_long(g, x, *n);
  if (is_e(g, x)) return g.make(operation::exp, y);
  if (const rational* base = g.value(x)) {
    const auto exact = exact_parts::is_integer(*exponent)
                           ? power_to_great_integer(g, *base, *exponent)
                           : power_to_fraction(g, *base, *exponent);
    if (exact) return *exact;
  }
  const std::optional<long> twice = as_long(rational(*exponent * 2));
  if (twice) return power_to_long(g, g.make(operation::sqrt, x), *twice);
  return g.make(operation::power, x, y);
}

node_id factorial(graph& g, node_id x) {
  const rational* q = g.value(x);
  if (q == nullptr || !exact_parts::is_integer(*q) || *q < 0) {
    throw undefined_operation(
        "the factorial is of whole numbers from 0; gamma(x + 1) is of others");
  }
  constexpr long most = 5000;  // of 54,233 bits
  const std::optional<long> n = as_long(*q);
  if (!n || *n > most) return g.make(operation::gamma, add(g, x, g.number(1)));
  integer product;
  mpz_fac_ui(product.backend().data(), static_cast<unsigned long>(*n));
  return g.number(rational(product));
}

node_id double_factorial(graph& g, node_id x) {
  const rational* q = g.value(x);
  if (q == nullptr || !exact_parts::is_integer(*q) || *q < 0) {
    throw undefined_operation("the double factorial, n!!, is of whole numbers from 0");
  }
  constexpr long most = 10'000;  // of 59,335 bits
  const std::optional<long> n = as_long(*q);
  if (n && *n <= most) {
    integer product;
    mpz_2fac_ui(product.backend().data(), static_cast<unsigned long>(*n));
    return g.number(rational(product));
  }
  // (2k)!! = 2^k k!, and (2k-1)!! = (2k)!/(2k)!!.
  const integer whole = numerator(*q);
  const bool is_even = mpz_even_p(whole.backend().data()) != 0;
  const rational k(is_even ? integer(whole / 2) : integer((whole + 1) / 2));
  const node_id evens = multiply(g, power(g, g.number(2), g.number(k)), factorial(g, g.number(k)));
  return is_even ? evens : divide(g, factorial(g, g.number(rational(2 * k))), evens);
}

namespace {

/// Calls each with the operands of a node, some of them perhaps twice.
template <class Each>
void for_each_operand(const graph& g, node_id i, const Each& each) {
  const node& n = g[i];
  if (n.what == operation::further) {
    for (const node_id x : g.call_at(i).operands) each(x);
    return;
  }
  const int count = operands_of(n.what);
  if (count > 0) each(n.left);
  if (count > 1) each(n.right);
}

}  // namespace

std::vector<char> reachable(const graph& g) {
  std::vector<char> marks(g.size(), 0);
  marks[g.root] = 1;
  for (node_id i = g.root + 1; i-- > 0;) {
    if (marks[i] != 0) for_each_operand(g, i, [&](node_id x) { marks[x] = 1; });
  }
  return marks;
}

std::optional<rational> fractional_exponent_at(const graph& g, node_id i) {
  const node& n = g[i];
  switch (n.what) {
    case operation::sqrt:
      return rational(1, 2);
    case operation::root:
      return rational(1, n.number);
    case operation::power:
      if (const rational* e = g.value(n.right)) return *e;
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

std::vector<char> varying(const graph& g) {
  const std::vector<char> used = reachable(g);
  std::vector<char> marks(g.size(), 0);
  for (node_id i = 0; i <= g.root; ++i) {
    if (used[i] == 0) continue;
    bool varies = g[i].what == operation::variable;
    for_each_operand(g, i, [&](node_id x) { varies = varies || marks[x] != 0; });
    marks[i] = varies ? 1 : 0;
  }
  return marks;
}

namespace {

/// As known_value; looks at no more nodes than `rest` says, as sums of sums could be long.
std::optional<pi_combination> known_value(const graph& g, node_id i, int& rest) {
  if (--rest < 0) return std::nullopt;
  if (const rational* q = g.value(i)) return pi_combination{*q, 0};
  const node& n = g[i];
  const auto part = [&](node_id x) { return known_value(g, x, rest); };
  switch (n.what) {
    case operation::pi:
      return pi_combination{0, 1};
    case operation::negate:
      if (const auto x = part(n.left)) return -*x;
      return std::nullopt;
    case operation::add:
      if (const auto x = part(n.left), y = part(n.right); x && y) return *x + *y;
      return std::nullopt;
    case operation::subtract:
      if (const auto x = part(n.left), y = part(n.right); x && y) return *x - *y;
      return std::nullopt;
    case operation::multiply:
    case operation::divide: {
      const rational* left = g.value(n.left);
      const rational* right = g.value(n.right);
      const bool quotient = n.what == operation::divide;
      if (right != nullptr) {
        const auto x = part(n.left);
        if (x) return *x * (quotient ? rational(1 / *right) : *right);
      } else if (left != nullptr && !quotient) {
        const auto x = part(n.right);
        if (x) return *x * *left;
      }
      return std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<pi_combination> known_value(const graph& g, node_id i) {
  int most_nodes = 32;
  return known_value(g, i, most_nodes);
}

namespace {

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

/// Makes a tape of the nodes in `code`, given where the inputs lie (operand numbers by node).
tape assemble(const graph& g, const std::vector<node_id>& code, const std::vector<node_id>& outputs,
              std::vector<std::uint32_t> place, std::uint32_t inputs) {
  tape result;
  result.inputs = inputs;
  std::vector<std::size_t> last_use(g.size(), 0);
  for (std::size_t i = 0; i < code.size(); ++i) {
    for (const node_id x : operands_at(g, code[i])) last_use[x] = i;
  }
  for (const node_id o : outputs) last_use[o] = code.size();
  std::vector<std::uint32_t> free;
  const auto release = [&](node_id operand, std::size_t now) {
    if (last_use[operand] == now && place[operand] >= inputs) free.push_back(place[operand]);
  };
  for (std::size_t i = 0; i < code.size(); ++i) {
    const node& n = g[code[i]];
    const int operands = operands_of(n.what);
    const std::uint32_t left = operands >= 1 ? place[n.left] : 0;
    const std::uint32_t right = operands == 2 ? place[n.right] : left;
    long number = n.number;
    if (n.what == operation::further) {
      const further_call& call = g.call_at(code[i]);
      number = static_cast<long>(result.calls.size());
      result.calls.push_back({call.function, {}});
      for (const node_id x : call.operands) result.calls.back().operands.push_back(place[x]);
    }
    for (const node_id x : operands_at(g, code[i])) release(x, i);
    if (free.empty()) free.push_back(inputs + result.slots++);
    place[code[i]] = free.back();
    free.pop_back();
    result.code.push_back({n.what, place[code[i]] - inputs, left, right, number});
  }
  for (const node_id o : outputs) result.outputs.push_back(place[o]);
  return result;
}

}  // namespace

bool is_of_ring(operation what) {
  return what == operation::variable || what == operation::negate || what == operation::add ||
         what == operation::subtract || what == operation::multiply;
}

node_id with_operands(graph& to, const graph& from, node_id i,
                      const std::function<node_id(node_id)>& operand) {
  const node n = from[i];
  if (n.what == operation::further) {
    further_call call = from.call_at(i);
    for (node_id& x : call.operands) x = operand(x);
    return to.call(call);
  }
  const int operands = operands_of(n.what);
  const node_id left = operands > 0 ? operand(n.left) : 0;
  const node_id right = operands > 1 ? operand(n.right) : 0;
  return to.make(n.what, left, right, n.number);
}

std::vector<node_id> copied_into(graph& to, const graph& from) {
  const std::vector<char> used = reachable(from);
  std::vector<node_id> places(from.size(), 0);
  for (node_id i = 0; i <= from.root; ++i) {
    if (used[i] == 0) continue;
    const node& n = from[i];
    if (n.what == operation::number) {
      places[i] = to.number(from.number_at(n.number));
    } else if (n.what == operation::variable) {
      throw std::invalid_argument("a number with a variable in it");
    } else {
      places[i] = with_operands(to, from, i, [&](node_id k) { return places[k]; });
    }
  }
  return places;
}

program compile(const graph& g, std::size_t variables) {
  program result;
  result.further = g.further();
  result.variables = static_cast<std::uint32_t>(variables);
  const std::vector<char> used = reachable(g);
  const std::vector<char> varies = varying(g);
  std::vector<node_id> constant_code;
  std::vector<node_id> body_code;
  std::vector<char> wanted(g.size(), 0);  // constants that the body reads
  std::vector<std::uint32_t> constant_place(g.size(), nowhere);
  std::vector<std::uint32_t> body_place(g.size(), nowhere);
  for (node_id i = 0; i <= g.root; ++i) {
    if (used[i] == 0) continue;
    if (g[i].what == operation::number) {
      constant_place[i] = static_cast<std::uint32_t>(result.numbers.size());
      result.numbers.push_back(g.number_at(g[i].number));
    } else if (g[i].what == operation::variable) {
      body_place[i] = static_cast<std::uint32_t>(g[i].number);
    } else if (varies[i] == 0) {
      constant_code.push_back(i);
    } else {
      body_code.push_back(i);
      for (const node_id x : operands_at(g, i)) wanted[x] = 1;
    }
  }
  wanted[g.root] = 1;
  std::vector<node_id> constants;
  for (node_id i = 0; i <= g.root; ++i) {
    if (used[i] == 0 || wanted[i] == 0 || varies[i] != 0) continue;
    body_place[i] = result.variables + static_cast<std::uint32_t>(constants.size());
    constants.push_back(i);
  }
  const auto numbers = static_cast<std::uint32_t>(result.numbers.size());
  const auto inputs = result.variables + static_cast<std::uint32_t>(constants.size());
  result.constants = assemble(g, constant_code, constants, std::move(constant_place), numbers);
  result.body = assemble(g, body_code, {g.root}, std::move(body_place), inputs);
  return result;
}

}  // namespace polhode::detail
