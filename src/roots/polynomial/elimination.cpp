#include "elimination.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "polhode/expression/symbol.hpp"

namespace polhode::detail {
namespace {

/// Thrown where it would take too long.
struct too_many {};

/// So many products of machine words are made at most.
class budget {
 public:
  void spend(std::size_t products) {
    if (products > left_) throw too_many();
    left_ -= products;
  }
  /// For so many products with a number of the size of x.
  void spend(std::size_t products, const rational& x) {
    spend(products * (1 + mpz_size(numerator(x).backend().data())));
  }

 private:
  std::size_t left_ = 1'000'000;
};

using exponents = std::vector<long>;
/// Without coefficients that are 0.
using polynomial = std::map<exponents, rational>;

void add_term(polynomial& p, const exponents& e, const rational& c) {
  const auto [at, is_new] = p.try_emplace(e, c);
  if (!is_new) at->second += c;
  if (at->second == 0) p.erase(at);
}
polynomial sum(polynomial p, const polynomial& q, const rational& factor) {
  for (const auto& [e, c] : q) add_term(p, e, c * factor);
  return p;
}
polynomial product(const polynomial& p, const polynomial& q, budget& work) {
  work.spend(p.size() * q.size());
  polynomial result;
  for (const auto& [e, c] : p) {
    for (const auto& [f, d] : q) {
      exponents both = e;
      for (std::size_t i = 0; i < both.size(); ++i) both[i] += f[i];
      add_term(result, both, c * d);
    }
  }
  return result;
}
long degree_in(const polynomial& p, std::size_t variable) {
  long degree = 0;
  for (const auto& [e, c] : p) degree = std::max(degree, e[variable]);
  return degree;
}

std::optional<rational> constant_in(const polynomial& p) {
  if (p.empty()) return rational(0);
  const auto& [e, c] = *p.begin();
  const bool is_constant =
      p.size() == 1 && std::all_of(e.begin(), e.end(), [](long k) { return k == 0; });
  return is_constant ? std::optional(c) : std::nullopt;
}

constexpr long most_degree = 300;

/// The formula as a polynomial in so many variables; nothing where it is none.
std::optional<polynomial> polynomial_of(const symbol& f, std::size_t variables, budget& work) {
  const symbol_node& n = f.node();
  work.spend(1);
  polynomial result;
  exponents none(variables, 0);
  if (n.name.empty()) {
    if (n.enclosure || n.variable == symbol_node::imaginary_unit) return std::nullopt;
    if (n.variable == symbol_node::no_variable) {
      add_term(result, none, n.number);
      return result;
    }
    none[n.variable] = 1;
    add_term(result, none, 1);
    return result;
  }
  std::vector<polynomial> operands;
  for (const symbol& x : n.operands) {
    auto p = polynomial_of(x, variables, work);
    if (!p) return std::nullopt;
    operands.push_back(*std::move(p));
  }
  if (n.name == "-" && operands.size() == 1) return sum({}, operands[0], -1);
  if (operands.size() != 2) return std::nullopt;
  const auto& [x, y] = std::tie(operands[0], operands[1]);
  if (n.name == "+") return sum(x, y, 1);
  if (n.name == "-") return sum(x, y, -1);
  if (n.name == "*") return product(x, y, work);
  const std::optional<rational> q = constant_in(y);
  if (!q) return std::nullopt;
  if (n.name == "/") return *q == 0 ? std::nullopt : std::optional(sum({}, x, 1 / *q));
  constexpr long most = 100;
  if (n.name != "pow" || denominator(*q) != 1 || *q < 1 || *q > most) return std::nullopt;
  result = x;
  for (long k = 1; k < *q; ++k) result = product(result, x, work);
  return result;
}

/// p with a number in the place of the first variable: in the variables after it.
polynomial with_first(const polynomial& p, const rational& x) {
  polynomial result;
  for (const auto& [e, c] : p) {
    rational value = c;
    for (long k = 0; k < e[0]; ++k) value *= x;
    add_term(result, exponents(e.begin() + 1, e.end()), value);
  }
  return result;
}

/// Of one variable: the coefficients up to this degree.
std::vector<rational> coefficients_of(const polynomial& p, long degree) {
  std::vector<rational> result(static_cast<std::size_t>(degree) + 1);
  for (const auto& [e, c] : p) result[static_cast<std::size_t>(e[0])] = c;
  return result;
}

/// Of a formula in as many variables as it has.
std::optional<polynomial> polynomial_of(const expression& f, budget& work) {
  std::vector<symbol> variables;
  const std::size_t n = f.variables().size();
  for (std::size_t i = 0; i < n; ++i) variables.push_back(symbol::variable(i));
  return polynomial_of(f.evaluate(std::span<const symbol>(variables)), n, work);
}
expression formula_of(const polynomial& p, const expression_names& names) {
  symbol sum(rational(0));
  for (const auto& [e, c] : p) {
    symbol term(c);
    for (std::size_t i = 0; i < e.size(); ++i) {
      if (e[i] != 0) term = term * pow(symbol::variable(i), e[i]);
    }
    sum = sum + term;
  }
  return expression(sum, names);
}

polynomial derivative(const polynomial& p, std::size_t variable) {
  polynomial result;
  for (const auto& [e, c] : p) {
    exponents lower = e;
    if (lower[variable]-- == 0) continue;
    add_term(result, lower, c * e[variable]);
  }
  return result;
}
/// By the first row.
polynomial determinant(const std::vector<std::vector<polynomial>>& rows, budget& work) {
  if (rows.size() == 1) return rows[0][0];
  polynomial result;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    std::vector<std::vector<polynomial>> minor;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      std::vector<polynomial>& row = minor.emplace_back(rows[i]);
      row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
    }
    work.spend(1);
    result = sum(std::move(result), product(rows[0][j], determinant(minor, work), work),
                 j % 2 == 0 ? 1 : -1);
  }
  return result;
}

/// The determinant of Sylvester's matrix of two polynomials of one variable, as of degrees m and n:
/// by Euclid's algorithm. Its first column has the leading coefficients f_m and g_n; where one is 0
/// it is developed by the other. Else, with f = q g + r, rows of g times q are taken from those of
/// f.
rational resultant(std::vector<rational> f, std::vector<rational> g, budget& work) {
  rational factor = 1;
  while (true) {
    const std::size_t m = f.size() - 1;
    const std::size_t n = g.size() - 1;
    work.spend(1 + m + n, f[m]);
    const auto power = [](const rational& x, std::size_t k) {
      rational r = 1;
      for (std::size_t i = 0; i < k; ++i) r *= x;
      return r;
    };
    if (m == 0) return factor * power(f[0], n);
    if (n == 0) return factor * power(g[0], m);
    const bool falls_f = f[m] == 0;
    const bool falls_g = g[n] == 0;
    if (falls_f && falls_g) return 0;
    if (falls_f) {  // f_m = 0: (-1)^n g_n times the determinant without it
      factor *= n % 2 == 0 ? g[n] : rational(-g[n]);
      f.pop_back();
    } else if (falls_g) {
      factor *= f[m];
      g.pop_back();
    } else if (m < n) {  // m n exchanges of neighbouring rows
      if (m * n % 2 != 0) factor = -factor;
      std::swap(f, g);
    } else {
      const rational q = f[m] / g[n];
      work.spend(n, q);
      for (std::size_t k = 0; k <= n; ++k) f[m - n + k] -= q * g[k];
    }
  }
}

/// The resultant in the last variable, by its values: at whole numbers for the first variable it is
/// that of polynomials in one variable less, and its degree in the first variable is at most
/// deg_x(f) deg_y(g) + deg_x(g) deg_y(f).
polynomial resultant(const polynomial& f, const polynomial& g, std::size_t variables, long m,
                     long n, budget& work) {
  if (variables == 1) {
    polynomial result;
    add_term(result, {}, resultant(coefficients_of(f, m), coefficients_of(g, n), work));
    return result;
  }
  const long degree = degree_in(f, 0) * n + degree_in(g, 0) * m;
  // Newton's divided differences at 0, 1, 2, ....
  std::vector<polynomial> differences;
  for (long k = 0; k <= degree; ++k) {
    polynomial value = resultant(with_first(f, k), with_first(g, k), variables - 1, m, n, work);
    for (long j = 0; j < k; ++j) {
      work.spend(value.size() + 1, value.empty() ? rational(0) : value.begin()->second);
      const polynomial& before = differences[static_cast<std::size_t>(j)];
      polynomial difference;
      for (const auto& [e, c] : sum(std::move(value), before, -1)) {
        difference.emplace(e, c / (k - j));
      }
      value = std::move(difference);
    }
    differences.push_back(std::move(value));
  }
  polynomial result;  // by Horner's scheme in x - k
  for (long k = degree; k >= 0; --k) {
    polynomial next;
    for (const auto& [e, c] : result) {
      exponents higher = e;
      ++higher[0];
      add_term(next, higher, c);
      add_term(next, e, -k * c);
    }
    work.spend(result.size() + 1, result.empty() ? rational(0) : result.begin()->second);
    for (const auto& [e, c] : differences[static_cast<std::size_t>(k)]) {
      exponents at{0};
      at.insert(at.end(), e.begin(), e.end());
      add_term(next, at, c);
    }
    result = std::move(next);
  }
  return result;
}

/// A polynomial in the first variable, 0 at the first coordinates of all solutions; or just 0.
rational_polynomial eliminant(std::vector<polynomial> f, budget& work) {
  for (std::size_t variables = f.size(); variables > 1; --variables) {
    const std::size_t last = variables - 1;
    // The equation of the least degree in the last variable that has it.
    const auto rank = [&](const polynomial& p) {
      const long degree = degree_in(p, last);
      return std::pair(degree == 0, degree);
    };
    std::iter_swap(f.begin(),
                   std::min_element(f.begin(), f.end(), [&](const auto& p, const auto& q) {
                     return rank(p) < rank(q);
                   }));
    std::vector<polynomial> next;
    for (std::size_t k = 1; k < f.size(); ++k) {
      if (degree_in(f[k], last) == 0) {  // an equation without the variable is one already
        polynomial same;
        for (const auto& [e, c] : f[k]) same.emplace(exponents(e.begin(), e.end() - 1), c);
        next.push_back(std::move(same));
      } else {
        next.push_back(
            resultant(f[0], f[k], variables, degree_in(f[0], last), degree_in(f[k], last), work));
      }
    }
    f = std::move(next);
  }
  return rational_polynomial(coefficients_of(f[0], degree_in(f[0], 0)));
}

}  // namespace

std::vector<std::optional<rational_polynomial>> eliminants(std::span<const expression> components) {
  const std::size_t n = components.size();
  std::vector<std::optional<rational_polynomial>> result(n);
  std::vector<polynomial> f;
  try {
    budget work;
    for (const expression& component : components) {
      auto p = polynomial_of(component, work);
      if (!p) return result;
      for (std::size_t i = 0; i < n; ++i) {
        if (degree_in(*p, i) > most_degree) return result;
      }
      f.push_back(*std::move(p));
    }
  } catch (const too_many&) {
    return result;
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<polynomial> turned;  // with the variable i in the first place
    for (const polynomial& p : f) {
      polynomial& q = turned.emplace_back();
      for (const auto& [e, c] : p) {
        exponents moved = e;
        std::swap(moved[0], moved[i]);
        q.emplace(std::move(moved), c);
      }
    }
    try {
      budget work;
      rational_polynomial p = eliminant(std::move(turned), work);
      if (!p.is_zero()) result[i] = std::move(p);
    } catch (const too_many&) {
      continue;
    }
  }
  return result;
}

std::optional<rational_polynomial> eliminant_of_values(const expression& g,
                                                       std::span<const rational_polynomial> p) {
  try {
    budget work;
    const auto of_x = polynomial_of(g, work);
    if (!of_x) return std::nullopt;
    std::vector<polynomial> f;  // in t, x
    polynomial& first = f.emplace_back();
    for (const auto& [e, c] : *of_x) {
      exponents shifted{0};
      shifted.insert(shifted.end(), e.begin(), e.end());
      first.emplace(std::move(shifted), -c);
    }
    exponents of_t(p.size() + 1, 0);
    of_t[0] = 1;
    add_term(first, of_t, 1);
    for (std::size_t i = 0; i < p.size(); ++i) {
      polynomial& q = f.emplace_back();
      exponents e(p.size() + 1, 0);
      for (const rational& c : p[i].coefficients()) {
        add_term(q, e, c);
        ++e[i + 1];
      }
    }
    rational_polynomial result = eliminant(std::move(f), work);
    return result.is_zero() ? std::nullopt : std::optional(std::move(result));
  } catch (const too_many&) {
    return std::nullopt;
  }
}

std::optional<expression> jacobian_determinant(std::span<const expression> components) {
  try {
    budget work;
    std::vector<std::vector<polynomial>> rows;
    for (const expression& component : components) {
      const auto p = polynomial_of(component, work);
      if (!p) return std::nullopt;
      std::vector<polynomial>& row = rows.emplace_back();
      for (std::size_t j = 0; j < components.size(); ++j) row.push_back(derivative(*p, j));
    }
    return formula_of(determinant(rows, work), components.front().names());
  } catch (const too_many&) {
    return std::nullopt;
  }
}

}  // namespace polhode::detail
