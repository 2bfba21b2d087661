// All roots of n formulas in n variables in a box. The witness gives a box around each root; no two
// of them have a point in common, but on their faces.
//
// Theorem (R. Krawczyk, 1969; R. E. Moore, 1977). Let f be continuously differentiable on a box N
// with its derivatives in J(N), y in N, C a matrix, and
//   K = y - C f(y) + (I - C J(N)) (N - y).
// If K lies in the interior of N, f has exactly one root in N, and it lies in K. So the box that
// the root's numbers make up has one, in its interior.
//
// On a box B around it, |I - C A| < 1 for each matrix A of derivatives in J(B), row by row, in the
// norm of the greatest sum over a row. Then C and A are regular; and f(x) - f(x') = A (x - x') with
// such an A for x and x' in B (the mean value theorem for each row), so B has no second root.
//
// The rest of the box is halved until in each part one of the formulas is not 0, by its values over
// the part or by the mean value form f(m) + J (X - m), or one of the combinations C f is not, by
// the same form.

#include <algorithm>
#include <utility>
#include <vector>

#include "digest.hpp"
#include "formula_claims.hpp"
#include "statements/formulas.hpp"
#include "statements/shared.hpp"

namespace polhode::checker {
namespace {

using sides = std::vector<range>;  // of a box
using vector_of_intervals = std::vector<interval>;
using interval_matrix = std::vector<vector_of_intervals>;  // row i: of the formula i
using matrix = std::vector<std::vector<rational>>;

rational middle_of(const range& x) { return (x.lower + x.upper) / 2; }
rational width_of(const range& x) { return x.upper - x.lower; }
std::vector<rational> middle_of(const sides& x) {
  std::vector<rational> m;
  m.reserve(x.size());
  for (const range& side : x) m.push_back(middle_of(side));
  return m;
}
bool is_part_of(const sides& x, const sides& y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i].lower < y[i].lower || y[i].upper < x[i].upper) return false;
  }
  return true;
}
/// They have no common point, but on their faces.
bool are_apart(const sides& x, const sides& y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i].upper <= y[i].lower || y[i].upper <= x[i].lower) return true;
  }
  return false;
}

/// c x.
interval product(const rational& c, const interval& x) {
  const integer n = numerator(c);
  const integer d = denominator(c);
  x.bits().work().rationals(2, bit_length(c) + bit_length(x.low()) + bit_length(x.high()));
  const integer at_low = n * x.low();
  const integer at_high = n * x.high();
  return {floor_quotient(std::min(at_low, at_high), d),
          ceiling_quotient(std::max(at_low, at_high), d), x.bits()};
}

/// About q, with 64 bits.
rational rounded(const rational& q) {
  if (q == 0) return q;
  constexpr long few = 64;
  const long k = few + bit_length(integer(denominator(q))) - bit_length(integer(numerator(q)));
  const rational scaled(q * power_of_two(k));
  return rational(floor_quotient(numerator(scaled), denominator(scaled))) * power_of_two(-k);
}

/// About the inverse of the middle of m, which need not be near it for what is shown with it to be
/// true; nothing where none is found.
std::optional<matrix> near_inverse(const interval_matrix& m) {
  const std::size_t n = m.size();
  budget& work = m.front().front().bits().work();
  matrix a(n);
  matrix inverse(n, std::vector<rational>(n, 0));
  for (std::size_t i = 0; i < n; ++i) {
    for (const interval& x : m[i]) a[i].push_back(rounded((x.lower() + x.upper()) / 2));
    inverse[i][i] = 1;
  }
  constexpr long bits_of_entry = 256;  // numerator and denominator, a product, and more
  work.rationals(static_cast<long>(4 * n * n * n), bits_of_entry);
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (abs(a[i][k]) > abs(a[pivot][k])) pivot = i;
    }
    if (a[pivot][k] == 0) return std::nullopt;
    std::swap(a[k], a[pivot]);
    std::swap(inverse[k], inverse[pivot]);
    const rational by = a[k][k];
    for (std::size_t j = 0; j < n; ++j) {
      a[k][j] = rounded(a[k][j] / by);
      inverse[k][j] = rounded(inverse[k][j] / by);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const rational factor = a[i][k];
      if (i == k || factor == 0) continue;
      for (std::size_t j = 0; j < n; ++j) {
        a[i][j] = rounded(a[i][j] - factor * a[k][j]);
        inverse[i][j] = rounded(inverse[i][j] - factor * inverse[k][j]);
      }
    }
  }
  return inverse;
}

bool is_nonzero(const interval& x) { return x.is_positive() || x.is_negative(); }

class system_check {
 public:
  explicit system_check(std::vector<formula> f) : f_(std::move(f)) {}

  /// That there is exactly one root in the box, in its interior.
  void expect_root(const sides& x, long bits, const place& where) {
    const budget::at here = where.working();
    for (int attempt = 0; attempt < 5; ++attempt, bits += bits / 2 + 64) {
      try {
        if (shows_root(x, precision(bits, where.work()))) return;
      } catch (const undecided&) {  // more bits
      }
    }
    where.not_checkable("Krawczyk's operator does not map its numbers into themselves");
  }

  /// That there is at most one root in the box.
  void expect_regular(const sides& x, const place& where) {
    const budget::at here = where.working();
    for (const long number_of_bits : region_bits) {
      try {
        const precision bits(number_of_bits, where.work());
        const interval_matrix over = derivatives(x, bits);
        const auto c = near_inverse(over);
        if (c && is_contraction(rest_of(*c, over))) return;
      } catch (const undecided&) {  // more bits
      }
    }
    where.not_checkable("the matrix of derivatives is not shown to be regular on it");
  }

  /// That there is no root in the box outside the others, each of which is a part of it.
  void expect_no_other(const sides& all, const std::vector<sides>& others, const place& where) {
    constexpr int most_depth = 60;  // for each side
    struct part {
      sides x;
      std::vector<std::size_t> near;  // others that it may have points in common with
      int depth;
    };
    const budget::at here = where.working();
    const auto n = static_cast<int>(all.size());
    std::vector<std::size_t> every(others.size());
    for (std::size_t k = 0; k < every.size(); ++k) every[k] = k;
    std::optional<sides> stuck;
    for (const long number_of_bits : region_bits) {
      const precision bits(number_of_bits, where.work());
      stuck.reset();
      std::vector<part> rest{{all, every, 0}};
      while (!rest.empty() && !stuck) {
        part one = std::move(rest.back());
        rest.pop_back();
        const long length = bit_length(one.x.front().lower) + bit_length(one.x.front().upper);
        bits.work().rationals(8L * n + 2L * n * static_cast<long>(one.near.size()), length);
        std::erase_if(one.near, [&](std::size_t k) { return are_apart(one.x, others[k]); });
        if (std::any_of(one.near.begin(), one.near.end(),
                        [&](std::size_t k) { return is_part_of(one.x, others[k]); })) {
          continue;
        }
        const std::optional<std::size_t> side = side_to_cut(one.x, all, bits);
        if (!side) continue;
        if (one.depth == most_depth * n) {
          stuck = one.x;
          break;
        }
        ++one.depth;
        part upper = one;
        upper.x[*side].lower = middle_of(one.x[*side]);
        one.x[*side].upper = upper.x[*side].lower;
        rest.push_back(std::move(upper));
        rest.push_back(std::move(one));
      }
      if (!stuck) return;
    }
    std::string in;
    for (const range& side : *stuck) {
      in += (in.empty() ? "between " : "; ") + in_decimals(side, where.work());
    }
    where.not_checkable("the formulas are not shown to be different from 0 " + in +
                        ", where there is no box");
  }

 private:
  [[nodiscard]] vector_of_intervals intervals(const sides& x, const precision& bits) const {
    vector_of_intervals result;
    result.reserve(x.size());
    for (const range& side : x) {
      result.push_back(interval::between(side.lower, side.upper, bits));
    }
    return result;
  }
  [[nodiscard]] static sides point(const std::vector<rational>& x) {
    sides result;
    result.reserve(x.size());
    for (const rational& q : x) result.push_back({q, q});
    return result;
  }
  [[nodiscard]] vector_of_intervals values(const sides& x, const precision& bits) const {
    const vector_of_intervals at = intervals(x, bits);
    vector_of_intervals result;
    result.reserve(f_.size());
    for (const formula& f : f_) result.push_back(f(at));
    return result;
  }
  [[nodiscard]] interval_matrix derivatives(const sides& x, const precision& bits) const {
    const interval zero(rational(0), bits);
    const interval one(rational(1), bits);
    std::vector<jet> at;
    at.reserve(x.size());
    for (const interval& side : intervals(x, bits)) at.push_back({side, zero});
    interval_matrix result(f_.size());
    for (jet& variable : at) {
      variable.slope = one;
      for (std::size_t i = 0; i < f_.size(); ++i) result[i].push_back(f_[i](at).slope);
      variable.slope = zero;
    }
    return result;
  }
  /// C v.
  static vector_of_intervals combined(const matrix& c, const vector_of_intervals& v) {
    vector_of_intervals result;
    result.reserve(c.size());
    for (const std::vector<rational>& row : c) {
      interval sum = product(row.front(), v.front());
      for (std::size_t j = 1; j < v.size(); ++j) sum = sum + product(row[j], v[j]);
      result.push_back(std::move(sum));
    }
    return result;
  }
  /// C J.
  static interval_matrix combined(const matrix& c, const interval_matrix& m) {
    interval_matrix result(c.size());
    for (std::size_t j = 0; j < m.front().size(); ++j) {
      vector_of_intervals column;
      column.reserve(m.size());
      for (const vector_of_intervals& row : m) column.push_back(row[j]);
      const vector_of_intervals made = combined(c, column);
      for (std::size_t i = 0; i < c.size(); ++i) result[i].push_back(made[i]);
    }
    return result;
  }
  /// I - C J.
  static interval_matrix rest_of(const matrix& c, const interval_matrix& m) {
    interval_matrix result = combined(c, m);
    for (std::size_t i = 0; i < result.size(); ++i) {
      for (std::size_t j = 0; j < result.size(); ++j) {
        interval& x = result[i][j];
        x = interval(rational(i == j ? 1 : 0), x.bits()) - x;
      }
    }
    return result;
  }
  /// The norm of the greatest sum over a row is below 1.
  static bool is_contraction(const interval_matrix& m) {
    for (const vector_of_intervals& row : m) {
      integer sum = 0;
      for (const interval& x : row) sum += x.magnitude();
      const integer one = integer(1) << static_cast<unsigned>(long{row.front().bits()});
      if (sum >= one) return false;
    }
    return true;
  }
  /// The linear form a + sum b_j (x_j - m_j) over the box, m its middle.
  static interval linear(const interval& a, const vector_of_intervals& b, const sides& x) {
    interval sum = a;
    for (std::size_t j = 0; j < x.size(); ++j) {
      const rational half = width_of(x[j]) / 2;
      sum = sum + b[j] * interval::between(-half, half, a.bits());
    }
    return sum;
  }

  bool shows_root(const sides& x, const precision& bits) {
    const std::vector<rational> y = middle_of(x);
    const sides at = point(y);
    const auto c = near_inverse(derivatives(at, bits));
    if (!c) return false;
    const vector_of_intervals step = combined(*c, values(at, bits));
    const interval_matrix rest = rest_of(*c, derivatives(x, bits));
    for (std::size_t i = 0; i < x.size(); ++i) {
      const interval image = linear(interval(y[i], bits) - step[i], rest[i], x);
      if (image.lower() <= x[i].lower || x[i].upper <= image.upper()) return false;
    }
    return true;
  }

  /// Nothing where the box is shown to have no root; else the side that is to be halved.
  std::optional<std::size_t> side_to_cut(const sides& x, const sides& all, const precision& bits) {
    const vector_of_intervals over = intervals(x, bits);
    bool is_defined = true;
    for (const formula& f : f_) {
      try {
        if (is_nonzero(f(over))) return std::nullopt;
      } catch (const undecided&) {  // it may be another formula that is not 0
        is_defined = false;
      }
    }
    if (is_defined) {
      try {
        const interval_matrix slopes = derivatives(x, bits);
        const vector_of_intervals at_middle = values(point(middle_of(x)), bits);
        for (std::size_t i = 0; i < f_.size(); ++i) {
          if (is_nonzero(linear(at_middle[i], slopes[i], x))) return std::nullopt;
        }
        if (const auto c = near_inverse(slopes)) {
          const vector_of_intervals value = combined(*c, at_middle);
          const interval_matrix slope = combined(*c, slopes);
          for (std::size_t i = 0; i < f_.size(); ++i) {
            if (is_nonzero(linear(value[i], slope[i], x))) return std::nullopt;
          }
        }
        return steepest(slopes, x, all);
      } catch (const undecided&) {  // smaller parts
      }
    }
    std::size_t longest = 0;
    for (std::size_t j = 1; j < x.size(); ++j) {
      if (width_of(x[j]) * width_of(all[longest]) > width_of(x[longest]) * width_of(all[j])) {
        longest = j;
      }
    }
    return longest;
  }
  /// The side along which one of the formulas changes most, of its change in the box, and which is
  /// long beside that of the whole box.
  static std::size_t steepest(const interval_matrix& slopes, const sides& x, const sides& all) {
    const auto n = static_cast<long>(x.size());
    slopes.front().front().bits().work().rationals(4 * n * n * n, 1024);
    std::size_t best = 0;
    rational most = 0;
    for (std::size_t j = 0; j < x.size(); ++j) {
      rational change = 0;
      for (const vector_of_intervals& row : slopes) {
        rational total = 0;  // of the formula, along all sides
        for (std::size_t k = 0; k < x.size(); ++k) {
          total += rational(row[k].magnitude()) * width_of(x[k]);
        }
        if (total == 0) continue;
        change = std::max(change, rational(rational(row[j].magnitude()) * width_of(x[j]) / total));
      }
      change *= width_of(x[j]) / width_of(all[j]);
      if (change > most) {
        most = change;
        best = j;
      }
    }
    return best;
  }

  std::vector<formula> f_;
};

/// Formulas and sides of a box, as a certificate's inputs give them.
struct system_inputs {
  std::vector<std::string> variables;
  std::vector<formula> f;
  sides inner;  // lies in the sides that is meant
  sides outer;  // holds it
  std::string equations;
  std::string ranges;
};

constexpr std::size_t most_variables = 20;
constexpr std::size_t most_roots = 1000;

std::string numbered(const char* name, std::size_t i) {
  return name + ("_" + std::to_string(i + 1));
}

system_inputs read_inputs(const place& inputs) {
  constexpr std::size_t keys_of_each = 4;
  const std::size_t n = inputs.value().size() / keys_of_each;
  if (n == 0 || n > most_variables || n * keys_of_each != inputs.value().size()) {
    inputs.malformed("there must be formula_1, variable_1, from_1, to_1 and so on, of at most " +
                     std::to_string(most_variables) + " variables");
  }
  system_inputs given;
  for (std::size_t i = 0; i < n; ++i) {
    const place where = inputs[numbered("variable", i)];
    const std::string& name = read_variable(where);
    if (std::find(given.variables.begin(), given.variables.end(), name) != given.variables.end()) {
      where.malformed("there is another variable of that name");
    }
    given.variables.push_back(name);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const place f = inputs[numbered("formula", i)];
    const place from = inputs[numbered("from", i)];
    const place to = inputs[numbered("to", i)];
    given.f.push_back(formula::read(f, given.variables));
    const range lower = end_of(formula::read(from, {}), from);
    const range upper = end_of(formula::read(to, {}), to);
    if (lower.upper >= upper.lower) to.refute("it must be above the side's lower end");
    given.inner.push_back({lower.upper, upper.lower});
    given.outer.push_back({lower.lower, upper.upper});
    const auto add = [](std::string& list, const std::string& one) {
      list += (list.empty() ? "" : ", ") + one;
    };
    add(given.equations, statements::fill(statements::equation_of_system, {f.text()}));
    add(given.ranges,
        statements::fill(statements::side_of_system, {from.text(), given.variables[i], to.text()}));
  }
  return given;
}

}  // namespace

void check_system(const place& certificate, report& result) {
  const system_inputs given = read_inputs(certificate["inputs"]);
  const std::size_t n = given.variables.size();
  const place numbers = certificate["numbers"];
  const place witness = certificate["witness"];
  witness.expect_keys({"boxes"});
  const place boxes = witness["boxes"];
  const std::size_t count = boxes.size();
  if (count > most_roots) boxes.not_checkable("there are too many");
  if (numbers.value().size() != n * count) {
    boxes.refute("there must be a box for the numbers of each root");
  }
  certificate["statement"].expect_text(
      statements::fill(statements::system_statement, {std::to_string(count)}));
  certificate["method"].expect_text(statements::system_method);
  certificate["formula"].expect_text(
      statements::fill(statements::system_formula, {given.equations, given.ranges}));
  if (certificate["facts"].size() != 0) certificate["facts"].at(0).malformed("there must be none");
  expect_grounds(certificate, statements::by_machine, {statements::krawczyks_theorem});
  result.grounds = grounds_of(certificate);
  result.subject = count == 1 ? "1 root" : std::to_string(count) + " roots";
  result.statement = {given.equations + " for exactly " + std::to_string(count) +
                      " points of the box " + given.ranges};
  std::vector<sides> around;
  system_check check(given.f);
  certificate.work().rationals(static_cast<long>(count * count * n), 256);
  for (std::size_t k = 0; k < count; ++k) {
    const place where = boxes.at(k);
    if (where.size() != n) where.malformed("it must have a side for each variable");
    sides exact;
    sides witnessed;
    long bits = 0;
    std::string point;
    for (std::size_t i = 0; i < n; ++i) {
      const std::string name = numbered("root", k) + "_" + given.variables[i];
      if (!numbers.has(name)) numbers[name].malformed("it is missing");
      const number_ends ends = read_number(numbers[name]);
      bits = std::max(bits, ends.bits);
      exact.push_back(ends.exact);
      witnessed.push_back(examination::bracket(where.at(i)));
      result.statement.push_back(in_between(name, ends.exact, ends.digits, certificate.work()));
      point += (point.empty() ? "" : ", ") + given.variables[i] + " = " +
               decimal_for_reading(ends.exact.lower, 20, certificate.work());
    }
    if (!is_part_of(exact, witnessed)) where.refute("the numbers are not inside it");
    if (!is_part_of(witnessed, given.inner)) {
      where.refute("it is not shown to be in the box that is asked for");
    }
    for (const sides& other : around) {
      if (!are_apart(witnessed, other)) where.refute("it has points in common with another one");
    }
    check.expect_root(exact, bits + 64, numbers[numbered("root", k) + "_" + given.variables[0]]);
    check.expect_regular(witnessed, where);
    around.push_back(std::move(witnessed));
    result.checks.push_back(point);
  }
  check.expect_no_other(given.outer, around, boxes);
  result.checks.emplace_back("there is no other root in the box");
  certificate["digest"].expect_text(digest_of(certificate));
}

}  // namespace polhode::checker
