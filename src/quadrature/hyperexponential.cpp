#include "hyperexponential.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {

namespace {

using sum = std::vector<hyperexponential>;
using maybe_sum = std::optional<sum>;

// Beyond these a formula is left to other rules.
constexpr std::size_t most_terms = 16;
constexpr std::size_t most_factors = 32;
constexpr long greatest_degree = 32;
constexpr long greatest_multiple = 8;  // of an angle
constexpr long most_pieces = 32;

bool is_integer(const rational& q) { return denominator(q) == 1; }

/// gcd of the numerators over the least common denominator, so that p over it has coprime integer coefficients.
rational content(const rational_polynomial& p) {
  integer above = 0;
  integer below = 1;
  for (const rational& c : p.coefficients()) {
    above = gcd(above, numerator(c));
    below = lcm(below, denominator(c));
  }
  return {above, below};
}

hyperexponential number(const rational& q) {
  hyperexponential result;
  result.coefficient = q;
  return result;
}

/// |x|^e joins the constants of f.
void multiply_by(hyperexponential& f, const constant_power& c) {
  for (auto i = f.constants.begin(); i != f.constants.end(); ++i) {
    if (i->what != c.what || i->node != c.node || i->value != c.value) continue;
    i->exponent += c.exponent;
    if (i->exponent == 0) f.constants.erase(i);
    return;
  }
  f.constants.push_back(c);
}

void multiply_by(hyperexponential& f, const polynomial_power& p) {
  if (p.exponent == 0 && !p.must_be_positive) return;
  for (auto i = f.powers.begin(); i != f.powers.end(); ++i) {
    if (i->base != p.base) continue;
    i->exponent += p.exponent;
    i->must_be_positive = i->must_be_positive || p.must_be_positive;
    if (i->exponent == 0 && !i->must_be_positive) f.powers.erase(i);
    return;
  }
  f.powers.push_back(p);
}

hyperexponential product(const hyperexponential& f, const hyperexponential& g) {
  hyperexponential result = f;
  result.coefficient *= g.coefficient;
  for (const constant_power& c : g.constants) multiply_by(result, c);
  for (const polynomial_power& p : g.powers) multiply_by(result, p);
  if (!g.exponent.is_zero()) result.exponent = result.exponent + g.exponent;
  if (!g.phase.is_zero()) {  // f has none
    result.phase = g.phase;
    result.is_sine = g.is_sine;
  }
  return result;
}

/// f times the cosine or sine of t, where f has none of its own.
hyperexponential with_phase(hyperexponential f, const rational_polynomial& t, bool is_sine) {
  const bool is_negative = !t.is_zero() && t.leading() < 0;
  f.phase = is_negative ? t * rational_polynomial({rational(-1)}) : t;
  f.is_sine = is_sine && !t.is_zero();
  if (is_sine && t.is_zero()) f.coefficient = 0;
  if (is_sine && is_negative) f.coefficient = -f.coefficient;
  return f;
}

/// f g, a sum where both have a phase.
sum products(const hyperexponential& f, const hyperexponential& g) {
  if (f.phase.is_zero() || g.phase.is_zero()) return {product(f, g)};
  hyperexponential x = f;
  hyperexponential y = g;
  x.phase = y.phase = {};
  x.is_sine = y.is_sine = false;
  hyperexponential both = product(x, y);
  both.coefficient /= 2;
  hyperexponential negative = both;
  negative.coefficient = -negative.coefficient;
  const rational_polynomial difference = f.phase - g.phase;
  const rational_polynomial total = f.phase + g.phase;
  // 2 cos a cos b = cos(a-b) + cos(a+b), 2 sin a sin b = cos(a-b) - cos(a+b),
  // 2 sin a cos b = sin(a-b) + sin(a+b), 2 cos a sin b = -sin(a-b) + sin(a+b).
  const bool is_sine = f.is_sine != g.is_sine;
  return {with_phase(is_sine && g.is_sine ? negative : both, difference, is_sine),
          with_phase(f.is_sine && g.is_sine ? negative : both, total, is_sine)};
}

/// The exponent of a base; 0 where f does not have it.
rational exponent_of(const hyperexponential& f, const rational_polynomial& base) {
  for (const polynomial_power& p : f.powers) {
    if (p.base == base) return p.exponent;
  }
  return 0;
}

bool have_same_constants(const hyperexponential& f, const hyperexponential& g) {
  return f.constants.size() == g.constants.size() &&
         std::all_of(f.constants.begin(), f.constants.end(), [&](const constant_power& c) {
           return std::find(g.constants.begin(), g.constants.end(), c) != g.constants.end();
         });
}

/// Formulas as sums of hyperexponential functions of a variable y.
class taking_apart {
 public:
  /// `inside` is a point of the range, at which polynomials are made positive.
  explicit taking_apart(rational inside) : inside_(std::move(inside)) {}

  [[nodiscard]] hyperexponential of_polynomial(const rational_polynomial& p) const {
    if (p.degree() < 1) return number(p.is_zero() ? rational(0) : p.leading());
    hyperexponential result;
    result.coefficient = content(p);
    if (p(inside_) < 0) result.coefficient = -result.coefficient;
    std::vector<rational> c = p.coefficients();
    if (result.coefficient != 1) {
      for (rational& x : c) x /= result.coefficient;
    }
    result.powers.push_back({rational_polynomial(std::move(c)), rational(1), false});
    return result;
  }

  /// f + g as one of its kind, where it is one.
  [[nodiscard]] maybe_sum added(const sum& f, const sum& g) const {
    sum result = f;
    for (const hyperexponential& term : g) {
      if (!add(result, term)) return std::nullopt;
    }
    if (result.empty() || result.size() > most_terms) return std::nullopt;
    return result;
  }
  [[nodiscard]] maybe_sum multiplied(const sum& f, const sum& g) const {
    if (f.size() * g.size() > most_terms) return std::nullopt;
    sum result;
    for (const hyperexponential& x : f) {
      for (const hyperexponential& y : g) {
        for (const hyperexponential& term : products(x, y)) {
          if (term.powers.size() > most_factors || !add(result, term)) return std::nullopt;
        }
      }
    }
    if (result.empty() || result.size() > most_terms) return std::nullopt;
    return result;
  }
  [[nodiscard]] maybe_sum raised(const sum& f, const rational& e) const {
    if (f.size() > 1 || !f.front().phase.is_zero()) {
      if (!is_integer(e) || e < 1 || e > 8) return std::nullopt;
      maybe_sum result = f;
      for (long k = 1; result && k < e; ++k) result = multiplied(*result, f);
      return result;
    }
    hyperexponential result = f.front();
    if (result.coefficient == 0) return std::nullopt;
    for (constant_power& c : result.constants) c.exponent *= e;
    for (polynomial_power& p : result.powers) p.exponent *= e;
    const auto is_long = [](const auto& power) {
      constexpr long greatest = 1L << 20;
      return abs(numerator(power.exponent)) > greatest || denominator(power.exponent) > greatest;
    };
    if (std::any_of(result.constants.begin(), result.constants.end(), is_long) ||
        std::any_of(result.powers.begin(), result.powers.end(), is_long)) {
      return std::nullopt;
    }
    result.exponent = result.exponent * rational_polynomial({e});
    if (is_integer(e)) {
      constexpr long greatest_exponent = 1L << 20;
      constexpr double most_bits = 10'000;
      if (abs(numerator(e)) > greatest_exponent) return std::nullopt;
      const auto n = static_cast<long>(numerator(e));
      const auto bits = static_cast<double>(rational_polynomial({result.coefficient}).height());
      const bool is_unit = abs(result.coefficient) == 1;
      if (!is_unit && bits * static_cast<double>(std::abs(n)) > most_bits) return std::nullopt;
      const rational base = n < 0 ? rational(1 / result.coefficient) : result.coefficient;
      rational power = 1;
      for (long k = 0; k < (is_unit ? std::abs(n) % 2 : std::abs(n)); ++k) power *= base;
      result.coefficient = power;
      std::erase_if(result.powers, [](const polynomial_power& p) {
        return p.exponent == 0 && !p.must_be_positive;
      });
      return sum{result};
    }
    // Positive where its polynomials are.
    if (result.coefficient < 0) return std::nullopt;
    const rational coefficient = result.coefficient;
    result.coefficient = 1;
    if (coefficient != 1) {
      constant_power c;
      c.value = coefficient;
      c.exponent = e;
      multiply_by(result, c);
    }
    for (polynomial_power& p : result.powers) p.must_be_positive = true;
    return sum{result};
  }

  /// f as a polynomial with rational coefficients, without conditions.
  [[nodiscard]] static std::optional<rational_polynomial> as_polynomial(const sum& f) {
    if (f.size() != 1) return std::nullopt;
    const hyperexponential& x = f.front();
    const bool has_conditions =
        std::any_of(x.powers.begin(), x.powers.end(),
                    [](const polynomial_power& p) { return p.must_be_positive; });
    if (has_conditions || !x.constants.empty() || !x.exponent.is_zero() || !x.phase.is_zero()) {
      return std::nullopt;
    }
    return polynomial_of(x.coefficient, x.powers);
  }

 private:
  /// Nothing where the exponents are not small natural numbers.
  [[nodiscard]] static std::optional<rational_polynomial> polynomial_of(
      const rational& coefficient, const std::vector<polynomial_power>& powers) {
    rational_polynomial result({coefficient});
    for (const polynomial_power& p : powers) {
      if (!is_integer(p.exponent) || p.exponent < 0 ||
          p.exponent * p.base.degree() + result.degree() > greatest_degree) {
        return std::nullopt;
      }
      for (long k = 0; k < p.exponent; ++k) result = result * p.base;
    }
    return result;
  }

  /// Adds g to f; false where nothing can be said.
  [[nodiscard]] bool add(sum& f, const hyperexponential& g) const {
    if (g.coefficient == 0 && f.empty()) {
      f.push_back(g);
      return true;
    }
    for (auto i = f.begin(); i != f.end(); ++i) {
      const bool is_alike = i->exponent == g.exponent && i->phase == g.phase &&
                            i->is_sine == g.is_sine && have_same_constants(*i, g);
      if (!is_alike) continue;
      hyperexponential common;
      common.constants = i->constants;
      common.exponent = i->exponent;
      common.phase = i->phase;
      common.is_sine = i->is_sine;
      std::vector<polynomial_power> left;
      std::vector<polynomial_power> right;
      bool is_possible = true;
      bool must_be_positive = false;
      const auto share = [&](const polynomial_power& p) {
        const rational mine = exponent_of(*i, p.base);
        const rational other = exponent_of(g, p.base);
        if (!is_integer(mine - other)) {
          is_possible = false;
          return;
        }
        const rational least = std::min(mine, other);
        must_be_positive = must_be_positive || p.must_be_positive;
        multiply_by(common, polynomial_power{p.base, least, p.must_be_positive});
        if (mine != least) left.push_back({p.base, rational(mine - least), false});
        if (other != least) right.push_back({p.base, rational(other - least), false});
      };
      for (const polynomial_power& p : i->powers) share(p);
      for (const polynomial_power& p : g.powers) {
        const auto has = [&](const polynomial_power& q) { return q.base == p.base; };
        const auto mine = std::find_if(i->powers.begin(), i->powers.end(), has);
        if (mine == i->powers.end()) {
          share(p);
        } else if (p.must_be_positive) {
          must_be_positive = true;
          multiply_by(common, polynomial_power{p.base, 0, true});
        }
      }
      if (!is_possible) continue;
      const auto x = polynomial_of(i->coefficient, left);
      const auto y = polynomial_of(g.coefficient, right);
      if (!x || !y) continue;
      const rational_polynomial both = *x + *y;
      if (both.is_zero()) {
        if (must_be_positive) return false;
        f.erase(i);
        return true;
      }
      *i = product(common, of_polynomial(both));
      return true;
    }
    f.push_back(g);
    return true;
  }

  rational inside_;
};

/// What the functions of x that a variable stands for are in it. Nothing for the others.
struct substitution {
  rational inside;
  /// Of node i, whose operand is an affine function of x, the form in y.
  std::function<maybe_sum(std::size_t i)> leaf;
};

/// Which nodes a node is made of, itself among them.
std::vector<bool> parts_of_node(const formula& f, std::size_t node) {
  std::vector<bool> is_part(node + 1);
  is_part[node] = true;
  for (std::size_t k = node + 1; k-- > 0;) {
    const recorded_node& n = f.node(k);
    const bool is_leaf =
        n.what == recorded_node::kind::constant || n.what == recorded_node::kind::argument;
    if (is_part[k] && !is_leaf) is_part[n.left] = is_part[n.right] = true;
  }
  return is_part;
}

/// The forms of nodes, each where it has one.
class forms {
 public:
  /// Of what the node `last` is made of.
  forms(const formula& f, std::size_t last, const substitution& by) : f_(f), apart_(by.inside) {
    found_.resize(f.size());
    is_constant_.resize(f.size());
    const std::vector<bool> is_part = parts_of_node(f, last);
    for (std::size_t i = 0; i <= last; ++i) {
      if (!is_part[i]) continue;
      const recorded_node& node = f.node(i);
      const bool is_argument = node.what == recorded_node::kind::argument;
      const bool is_leaf = is_argument || node.what == recorded_node::kind::constant;
      is_constant_[i] =
          !is_argument && (is_leaf || (is_constant_[node.left] && is_constant_[node.right]));
      found_[i] = form_of(i, by);
      if (!found_[i] && is_constant_[i]) found_[i] = constant(i);
    }
  }
  [[nodiscard]] const maybe_sum& operator[](std::size_t i) const { return found_[i]; }

 private:
  /// Node i, a number that is not known to be rational.
  [[nodiscard]] maybe_sum constant(std::size_t i) const {
    constexpr precision p = 192;
    const choices none(f_.size());
    const ball value = evaluate(f_, p, ball(0, p), none, i)[i];
    if (!value.is_bounded() || contains_zero(value)) return std::nullopt;
    hyperexponential result = number(certainly_positive(value) ? 1 : -1);
    constant_power c;
    c.what = constant_power::kind::node;
    c.node = i;
    result.constants.push_back(c);
    return sum{result};
  }

  [[nodiscard]] maybe_sum form_of(std::size_t i, const substitution& by) const {
    const recorded_node& node = f_.node(i);
    if (node.what == recorded_node::kind::constant) {
      if (!node.exact) return std::nullopt;
      return sum{number(*node.exact)};
    }
    if (node.is_piecewise()) return std::nullopt;
    if (!is_constant_[i]) {
      if (maybe_sum found = by.leaf(i)) return found;
    }
    if (node.what == recorded_node::kind::argument) return std::nullopt;
    const maybe_sum& x = found_[node.left];
    if (!x) return std::nullopt;
    if (node.what == recorded_node::kind::power) return raised(i, *x, *node.exact);
    const maybe_sum& y = found_[node.right];
    switch (node.operation.rule) {
      case recorded_rule::negative:
        return apart_.multiplied(*x, {number(-1)});
      case recorded_rule::sum:
        return y ? apart_.added(*x, *y) : std::nullopt;
      case recorded_rule::difference: {
        if (!y) return std::nullopt;
        const maybe_sum negative = apart_.multiplied(*y, {number(-1)});
        return negative ? apart_.added(*x, *negative) : std::nullopt;
      }
      case recorded_rule::product:
        return y ? apart_.multiplied(*x, *y) : std::nullopt;
      case recorded_rule::quotient: {
        if (!y) return std::nullopt;
        const maybe_sum inverse = apart_.raised(*y, -1);
        return inverse ? apart_.multiplied(*x, *inverse) : std::nullopt;
      }
      case recorded_rule::square:
        return raised(i, *x, 2);
      case recorded_rule::sqrt:
        return raised(i, *x, rational(1, 2));
      case recorded_rule::root:
        return raised(i, *x, rational(1, node.number));
      case recorded_rule::power: {
        if (!y || !is_constant_[node.right]) return std::nullopt;
        const auto e = taking_apart::as_polynomial(*y);
        return e ? raised(i, *x, e->is_zero() ? rational(0) : e->leading()) : std::nullopt;
      }
      default:
        return std::nullopt;
    }
  }
  /// A root of a number is a number of its own, but where it is rational for other reasons.
  [[nodiscard]] maybe_sum raised(std::size_t i, const sum& x, const rational& e) const {
    if (is_constant_[i] && !is_integer(e)) return std::nullopt;
    return apart_.raised(x, e);
  }

  const formula& f_;
  taking_apart apart_;
  std::vector<maybe_sum> found_;
  std::vector<bool> is_constant_;
};

/// slope x + offset, of pi where the function has it.
struct affine {
  rational slope;
  rational offset;
};

std::optional<affine> affine_of(const maybe_sum& form) {
  if (!form) return std::nullopt;
  const auto p = taking_apart::as_polynomial(*form);
  if (!p || p->degree() != 1) return std::nullopt;
  return affine{p->coefficients()[1], p->coefficients()[0]};
}

/// A rational number between x < y, as far as is known; nothing where it would be a long one.
std::optional<rational> between(const ball& x, const ball& y) {
  if (certainly_less(x, 1) && certainly_greater(y, 1)) return rational(1);
  const ball next = x + abs(x) + 1;  // near x, where y is far
  const ball middle = (certainly_less(next, y) ? next : (x + y) / 2).middle();
  constexpr long most = 100'000;
  const magnitude size = middle.magnitude_upper();
  if (size.is_infinite() || (!size.is_zero() && std::abs(size.log2_floor()) > most)) {
    return std::nullopt;
  }
  return lower_rational(middle);
}
/// The same for a range without an end.
std::optional<rational> beyond(const ball& x) {
  return certainly_less(x, 1) ? std::optional<rational>(1) : between(x, x * 3 + 1);
}

/// p(-y).
rational_polynomial reflected(const rational_polynomial& p) {
  std::vector<rational> c = p.coefficients();
  for (std::size_t k = 1; k < c.size(); k += 2) c[k] = -c[k];
  return rational_polynomial(std::move(c));
}

/// x = sign y, sign = 1 or -1. `plain` are the forms in x of what exponential and circular functions are taken of.
substitution argument_itself(const formula& f, int sign, const rational& inside,
                             const forms* plain) {
  const taking_apart apart(inside);
  const auto leaf = [&f, sign, apart, plain](std::size_t i) -> maybe_sum {
    const recorded_node& node = f.node(i);
    if (node.what == recorded_node::kind::argument) {
      return sum{apart.of_polynomial(rational_polynomial({rational(0), rational(sign)}))};
    }
    if (plain == nullptr || node.what != recorded_node::kind::function) return std::nullopt;
    const auto rule = node.operation.rule;
    const bool is_exponential = rule == recorded_rule::exp;
    const bool is_circular = rule == recorded_rule::sin || rule == recorded_rule::cos;
    if (!is_exponential && !is_circular && rule != recorded_rule::sinh &&
        rule != recorded_rule::cosh) {
      return std::nullopt;
    }
    const maybe_sum& form = (*plain)[node.left];
    auto p = form ? taking_apart::as_polynomial(*form) : std::nullopt;
    if (!p) return std::nullopt;
    if (sign < 0) p = reflected(*p);
    if (is_circular) return sum{with_phase(number(1), *p, rule == recorded_rule::sin)};
    hyperexponential up;
    up.exponent = *p;
    if (is_exponential) return sum{up};
    hyperexponential down;
    down.exponent = *p * rational_polynomial({rational(-1)});
    up.coefficient = rational(1, 2);
    down.coefficient = rational(rule == recorded_rule::cosh ? 1 : -1, 2);
    return sum{up, down};
  };
  return {inside, leaf};
}

hyperexponential power_of_variable(const rational& e) {
  hyperexponential result;
  if (e != 0) result.powers.push_back({rational_polynomial::variable(), e, false});
  return result;
}
/// (1 - y)^e.
hyperexponential power_of_complement(const rational& e) {
  hyperexponential result;
  result.powers.push_back({rational_polynomial({rational(1), rational(-1)}), e, false});
  return result;
}

class parts_of {
 public:
  parts_of(const formula& f, const end_point& a, const end_point& b) : f_(f), a_(a), b_(b) {
    for (std::size_t i = 0; i < f.size() && !plain_; ++i) {
      const recorded_node& node = f.node(i);
      const bool is_transcendental = f.needs(i) && node.what == recorded_node::kind::function &&
                                     node.operation.rule >= recorded_rule::exp;
      if (is_transcendental) {
        plain_ = std::make_unique<forms>(f, f.result(), argument_itself(f, 1, 0, nullptr));
      }
    }
  }

  [[nodiscard]] std::optional<std::vector<hyperexponential_integral>> of(std::size_t node) {
    std::vector<hyperexponential_integral> result;
    if (!plain_) {
      if (!in_argument(node, result)) return in_sum(node);
      return result;
    }
    for (const auto substituted : {&parts_of::in_argument, &parts_of::in_exponential,
                                   &parts_of::in_sine_squared, &parts_of::in_sine_of_half}) {
      result.clear();
      if ((this->*substituted)(node, result)) return result;
    }
    return in_sum(node);
  }

 private:
  using parts = std::vector<hyperexponential_integral>;

  [[nodiscard]] bool is_sum(std::size_t node) const {
    const recorded_node& n = f_.node(node);
    return n.what == recorded_node::kind::function &&
           (n.operation.rule == recorded_rule::sum ||
            n.operation.rule == recorded_rule::difference);
  }
  /// Of the sum that a node is; no more than a few over the most.
  [[nodiscard]] std::size_t terms_of(std::size_t node) const {
    std::vector<std::size_t> open{node};
    std::size_t terms = 0;
    while (!open.empty() && terms <= most_terms && open.size() <= most_terms) {
      const std::size_t next = open.back();
      open.pop_back();
      if (is_sum(next)) {
        open.push_back(f_.node(next).left);
        open.push_back(f_.node(next).right);
      } else {
        ++terms;
      }
    }
    return terms + open.size();
  }
  /// A sum term by term.
  [[nodiscard]] std::optional<parts> in_sum(std::size_t node) {
    const recorded_node& sum_node = f_.node(node);
    const auto rule = sum_node.operation.rule;
    if (!is_sum(node) || terms_of(node) > most_terms) return std::nullopt;
    auto left = of(sum_node.left);
    if (!left) return std::nullopt;
    auto right = of(sum_node.right);
    if (!right || left->size() + right->size() > most_terms) return std::nullopt;
    for (hyperexponential_integral& part : *right) {
      if (rule == recorded_rule::difference) {
        part.function.coefficient = -part.function.coefficient;
      }
      left->push_back(std::move(part));
    }
    return left;
  }

  static void append(parts& all, const sum& form, const hyperexponential& factor,
                     const hyperexponential_integral& range) {
    for (const hyperexponential& term : form) {
      hyperexponential_integral part = range;
      part.function = product(term, factor);
      const std::vector<polynomial_power>& powers = part.function.powers;
      const bool has_conditions =
          std::any_of(powers.begin(), powers.end(),
                      [](const polynomial_power& p) { return p.must_be_positive; });
      if (part.function.coefficient == 0 && !has_conditions) continue;
      const auto same = [&](const hyperexponential_integral& other) {
        return other.lower.is_same_as(part.lower) && other.upper.is_same_as(part.upper) &&
               other.function == part.function;
      };
      const auto found = std::find_if(all.begin(), all.end(), same);
      if (found == all.end()) {
        all.push_back(std::move(part));
      } else {
        found->function.coefficient *= 2;  // one more of the same
      }
    }
  }

  bool in_argument(std::size_t node, parts& result) const {
    const bool from_infinity = a_.infinite_sign() != 0;
    const bool to_infinity = b_.infinite_sign() != 0;
    const auto piece = [&](const end_point& from, const end_point& to, int sign) {
      const bool is_long = to.infinite_sign() != 0;
      const ball start = from.at(128);
      const std::optional<rational> inside = is_long ? beyond(start) : between(start, to.at(128));
      if (!inside) return false;
      const substitution by = argument_itself(f_, sign, *inside, plain_.get());
      const forms found(f_, node, by);
      if (!found[node]) return false;
      hyperexponential_integral range;
      range.lower = from;
      range.upper = to;
      append(result, *found[node], number(1), range);
      return true;
    };
    if (from_infinity && to_infinity) return piece(0, b_, 1) && piece(0, b_, -1);
    if (from_infinity) return piece(-b_, -a_, -1);
    return piece(a_, b_, 1);
  }

  /// y = e^(slope x + offset), of which the functions in the formula have integer powers.
  bool in_exponential(std::size_t node, parts& result) const {
    std::optional<affine> base;
    const std::vector<bool> is_part = parts_of_node(f_, node);
    for (std::size_t i = 0; i <= node; ++i) {
      if (!is_part[i] || !is_exponential(i)) continue;
      const auto w = affine_of((*plain_)[f_.node(i).left]);
      if (!w) continue;
      if (!base) {
        base = w;
        continue;
      }
      const rational ratio = w->slope / base->slope;
      if (w->offset != ratio * base->offset) return false;
      // The greatest number of which 1 and the ratio are multiples.
      const rational unit(integer(1), denominator(ratio));
      base = affine{base->slope * unit, base->offset * unit};
    }
    if (!base) return false;
    if (base->slope < 0) base = affine{-base->slope, -base->offset};
    const auto end = [&](const end_point& x) -> end_point {
      if (x.is_infinite()) return x.infinite_sign() > 0 ? x : 0;
      if (x.exact() && base->slope * *x.exact() + base->offset == 0) return 1;
      return end_point([x, w = *base](precision p) { return exp(x.at(p) * w.slope + w.offset); });
    };
    hyperexponential_integral range;
    range.lower = end(a_);
    range.upper = end(b_);
    range.begins_at_0 = true;
    const ball low = range.lower.at(128);
    const std::optional<rational> found_inside =
        range.upper.is_infinite() ? beyond(low) : between(low, range.upper.at(128));
    if (!found_inside) return false;
    const rational& inside = *found_inside;
    const substitution by{inside, [&](std::size_t i) -> maybe_sum {
                            if (!is_exponential(i)) return std::nullopt;
                            const auto w = affine_of((*plain_)[f_.node(i).left]);
                            if (!w) return std::nullopt;
                            return exponential(f_.node(i).operation.rule, w->slope / base->slope,
                                               inside);
                          }};
    const forms found(f_, node, by);
    if (!found[node]) return false;
    // dx = dy / (slope y)
    append(result, *found[node], product(number(rational(1) / base->slope), power_of_variable(-1)),
           range);
    return true;
  }
  [[nodiscard]] bool is_exponential(std::size_t i) const {
    if (!f_.needs(i) || f_.node(i).what != recorded_node::kind::function) return false;
    const auto rule = f_.node(i).operation.rule;
    return rule == recorded_rule::exp || rule == recorded_rule::sinh ||
           rule == recorded_rule::cosh || rule == recorded_rule::tanh;
  }
  /// exp, sinh, cosh or tanh of n times log y.
  [[nodiscard]] static maybe_sum exponential(recorded_rule rule, const rational& n,
                                             const rational& inside) {
    constexpr long greatest = 1000;
    if (!is_integer(n) || abs(n) > greatest) return std::nullopt;
    const hyperexponential up = power_of_variable(n);
    if (rule == recorded_rule::exp) return sum{up};
    // (y^|n| +- y^-|n|)/2 = (y^(2 |n|) +- 1)/2 * y^-|n|
    const auto size = static_cast<std::size_t>(abs(numerator(n)));
    if (2 * size > static_cast<std::size_t>(greatest_degree)) return std::nullopt;
    const taking_apart apart(inside);
    const auto half_of = [&](long sign) {
      std::vector<rational> c(2 * size + 1);
      c[2 * size] = 1;
      c[0] = sign;
      hyperexponential result = product(apart.of_polynomial(rational_polynomial(std::move(c))),
                                        power_of_variable(rational(-static_cast<long>(size))));
      result.coefficient /= sign < 0 && n < 0 ? -2 : 2;
      return result;
    };
    maybe_sum cosine = sum{half_of(1)};
    maybe_sum sine = sum{half_of(-1)};
    if (rule == recorded_rule::cosh) return cosine;
    if (rule == recorded_rule::sinh) return sine;
    const maybe_sum inverse = apart.raised(*cosine, -1);
    return inverse ? apart.multiplied(*sine, *inverse) : std::nullopt;
  }

  // With w = frequency x, and w' from 0 to a quarter or to half of a period.
  bool in_sine_squared(std::size_t node, parts& result) const {
    return in_circular(node, true, 0, result);
  }
  bool in_sine_of_half(std::size_t node, parts& result) const {
    if (in_circular(node, false, 0, result)) return true;
    result.clear();
    return in_circular(node, false, 1, result);
  }

  struct frequency {
    rational of_x;  // positive
    bool of_pi = false;
  };
  [[nodiscard]] std::optional<frequency> common_frequency(std::size_t node) const {
    std::optional<frequency> common;
    const std::vector<bool> is_part = parts_of_node(f_, node);
    for (std::size_t i = 0; i <= node; ++i) {
      if (!is_part[i]) continue;
      const auto own = frequency_of(i);
      if (!own) continue;
      if (!common) {
        common = frequency{abs(own->of_x), own->of_pi};
        continue;
      }
      if (own->of_pi != common->of_pi) return std::nullopt;
      const rational ratio = abs(own->of_x) / common->of_x;
      common->of_x /= rational(denominator(ratio));
    }
    return common;
  }
  /// With its sign, where node i is a circular function of a multiple of x.
  [[nodiscard]] std::optional<frequency> frequency_of(std::size_t i) const {
    if (!f_.needs(i) || f_.node(i).what != recorded_node::kind::function) return std::nullopt;
    const auto rule = f_.node(i).operation.rule;
    const bool of_pi = rule == recorded_rule::sinpi || rule == recorded_rule::cospi;
    if (!of_pi && rule != recorded_rule::sin && rule != recorded_rule::cos &&
        rule != recorded_rule::tan) {
      return std::nullopt;
    }
    const auto w = affine_of((*plain_)[f_.node(i).left]);
    if (!w || w->offset != 0) return std::nullopt;
    return frequency{w->slope, of_pi};
  }

  /// By quarters of a period: y = sin^2 w', where w = k pi/2 + w'. By halves: y = sin^2(w'/2), where
  /// w = (k - shift/2) pi + w'. So y grows with w.
  bool in_circular(std::size_t node, bool by_quarters, int shift, parts& result) const {
    const auto own = common_frequency(node);
    if (!own || a_.infinite_sign() != 0 || b_.infinite_sign() != 0) return false;
    // w' as a number of pieces: one is that from k to k + 1.
    const rational pieces_of_turn = by_quarters ? 2 : 1;
    const rational start = by_quarters ? rational(0) : rational(shift, 2);
    const auto in_pieces = [&](const end_point& x) {
      const bool is_rational = own->of_pi ? x.exact().has_value() : x.form() && x.form()->q == 0;
      if (is_rational) {
        const rational turns = own->of_x * (own->of_pi ? *x.exact() : x.form()->r);
        return end_point(rational(turns * pieces_of_turn + start));
      }
      return end_point([=, w = *own](precision p) {
        const ball turns = w.of_pi ? x.at(p) * w.of_x : x.at(p) * w.of_x / pi(p);
        return turns * pieces_of_turn + start;
      });
    };
    const end_point lower = in_pieces(a_);
    const end_point upper = in_pieces(b_);
    // The piece in which an end lies, and whether it is surely where the piece begins.
    const auto place_of = [](const end_point& end) -> std::optional<std::pair<integer, bool>> {
      if (end.exact()) return std::pair(floor_of(*end.exact()), is_integer(*end.exact()));
      const ball value = end.at(128);
      if (!value.is_bounded()) return std::nullopt;
      const integer low = floor_of(lower_rational(value));
      if (low != floor_of(upper_rational(value))) return std::nullopt;
      return std::pair(low, false);
    };
    const auto first = place_of(lower);
    const auto last = place_of(upper);
    if (!first || !last || last->first - first->first > most_pieces) return false;
    if (abs(first->first) > 1L << 40) return false;
    const auto low = static_cast<long>(first->first);
    const auto high = static_cast<long>(last->first) - (last->second ? 1 : 0);
    range_tiling tiling(lower, upper);
    for (long k = low; k <= high; ++k) {
      const bool from_a = k == low && !first->second;
      const bool to_b = k == high && !last->second;
      tiling.add({from_a ? place::lower_end() : place(k), to_b ? place::upper_end() : place(k + 1)},
                 {rational(k), rational(k + 1)});
      const auto end = [&](const end_point& x) {
        return end_point([x, k, shift, by_quarters, w = *own](precision p) {
          const ball turns = w.of_pi ? x.at(p) * w.of_x : x.at(p) * w.of_x / pi(p);
          const ball inner =
              by_quarters ? turns - rational(k, 2) : (turns - rational(2 * k - shift, 2)) / 2;
          return square(sin(pi(p) * inner));
        });
      };
      hyperexponential_integral range;
      range.begins_at_0 = true;
      range.greatest = 1;
      range.lower = from_a ? end(a_) : end_point(0);
      range.upper = to_b ? end(b_) : end_point(1);
      const std::optional<rational> found_inside =
          between(range.lower.at(128), range.upper.at(128));
      if (!found_inside) return false;
      const rational& inside = *found_inside;
      const auto both = by_quarters ? quarter(k) : half(k, shift, inside);
      const substitution by{inside, [&](std::size_t i) -> maybe_sum {
                              const auto mine = frequency_of(i);
                              if (!mine) return std::nullopt;
                              const rational n = abs(mine->of_x) / own->of_x;
                              const bool odd = mine->of_x < 0;
                              return circular(f_.node(i).operation.rule, n, odd, both, inside);
                            }};
      const forms found(f_, node, by);
      if (!found[node]) return false;
      // dw = dy / (2 sqrt(y (1 - y))), twice that where y is of w'/2.
      hyperexponential factor = number(rational(by_quarters ? 1 : 2, 2) / own->of_x);
      factor = product(factor, product(power_of_variable(rational(-1, 2)),
                                       power_of_complement(rational(-1, 2))));
      if (own->of_pi) {
        constant_power c;
        c.what = constant_power::kind::pi;
        c.exponent = -1;
        factor.constants.push_back(c);
      }
      append(result, *found[node], factor, range);
    }
    return tiling.is_complete();
  }
  static integer floor_of(const rational& q) {
    integer result;
    mpz_fdiv_q(result.backend().data(), mpq_numref(q.backend().data()),
               mpq_denref(q.backend().data()));
    return result;
  }

  struct sine_and_cosine {
    sum sine;
    sum cosine;
  };
  static sum scaled(const sum& f, long factor) {
    sum result = f;
    for (hyperexponential& term : result) term.coefficient *= factor;
    return result;
  }
  /// Of w = k pi/2 + w', y = sin^2 w'.
  static sine_and_cosine quarter(long k) {
    const sum inner_sine{power_of_variable(rational(1, 2))};
    const sum inner_cosine{power_of_complement(rational(1, 2))};
    switch (((k % 4) + 4) % 4) {
      case 0:
        return {inner_sine, inner_cosine};
      case 1:
        return {inner_cosine, scaled(inner_sine, -1)};
      case 2:
        return {scaled(inner_sine, -1), scaled(inner_cosine, -1)};
      default:
        return {scaled(inner_cosine, -1), inner_sine};
    }
  }
  /// Of w = (k - shift/2) pi + w', y = sin^2(w'/2): sin w' = 2 sqrt(y (1 - y)), cos w' = 1 - 2 y.
  static sine_and_cosine half(long k, int shift, const rational& inside) {
    const taking_apart apart(inside);
    const sum inner_sine{product(number(2), product(power_of_variable(rational(1, 2)),
                                                    power_of_complement(rational(1, 2))))};
    const sum inner_cosine{apart.of_polynomial(rational_polynomial({rational(1), rational(-2)}))};
    const long sign = k % 2 == 0 ? 1 : -1;
    if (shift == 0) return {scaled(inner_sine, sign), scaled(inner_cosine, sign)};
    return {scaled(inner_cosine, -sign), scaled(inner_sine, sign)};
  }
  /// The function of n w, with its sign changed where it is odd and that is asked for.
  static maybe_sum circular(recorded_rule rule, const rational& n, bool negative,
                            const sine_and_cosine& of_w, const rational& inside) {
    if (!is_integer(n) || n > greatest_multiple) return std::nullopt;
    const taking_apart apart(inside);
    // f(n w) = 2 cos w f((n - 1) w) - f((n - 2) w)
    maybe_sum sine = of_w.sine;
    maybe_sum cosine = of_w.cosine;
    maybe_sum last_sine;  // 0
    maybe_sum last_cosine = sum{number(1)};
    const auto next = [&](maybe_sum& now, maybe_sum& last) {
      maybe_sum following = apart.multiplied(scaled(of_w.cosine, 2), *now);
      if (following && last) following = apart.added(*following, scaled(*last, -1));
      last = now;
      now = following;
    };
    for (long k = 1; k < n; ++k) {
      if (!sine || !cosine) return std::nullopt;
      next(sine, last_sine);
      next(cosine, last_cosine);
    }
    if (!sine || !cosine) return std::nullopt;
    const long sign = negative ? -1 : 1;
    if (rule == recorded_rule::cos || rule == recorded_rule::cospi) return cosine;
    if (rule == recorded_rule::sin || rule == recorded_rule::sinpi) return scaled(*sine, sign);
    const maybe_sum inverse = apart.raised(*cosine, -1);
    return inverse ? apart.multiplied(scaled(*sine, sign), *inverse) : std::nullopt;
  }

  const formula& f_;
  const end_point& a_;
  const end_point& b_;
  /// What nodes are in x, where the formula has exponential or circular functions of them.
  std::unique_ptr<forms> plain_;
};

}  // namespace

ball hyperexponential::constant(const formula& f, precision p) const {
  ball result(coefficient, p);
  for (const constant_power& c : constants) {
    ball base;
    switch (c.what) {
      case constant_power::kind::rational:
        base = ball(c.value, p);
        break;
      case constant_power::kind::pi:
        base = pi(p);
        break;
      case constant_power::kind::node: {
        const choices none(f.size());
        base = abs(evaluate(f, p, ball(0, p), none, c.node)[c.node]);
        break;
      }
    }
    result = result * power_of_positive(base, c.exponent);
  }
  return result;
}

ball power_of_positive(const ball& x, const rational& e) {
  constexpr long greatest = 1L << 30;
  const bool is_short = abs(numerator(e)) < greatest;
  if (is_short && denominator(e) == 1) return pow(x, static_cast<long>(numerator(e)));
  if (is_short && denominator(e) == 2) return pow(sqrt(x), static_cast<long>(numerator(e)));
  return pow(x, e);
}

std::optional<std::vector<hyperexponential_integral>> hyperexponential_parts(const formula& f,
                                                                             const end_point& a,
                                                                             const end_point& b) {
  if (f.has_breaks()) return std::nullopt;
  return parts_of(f, a, b).of(f.result());
}

}  // namespace polhode::detail
