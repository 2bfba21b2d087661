// The integral of a formula. The range A to B is that of x(s) = A + (B - A) s, 0 <= s <= 1, cut
// into pieces; s on a piece is that of s(t) = m + h t, -1 <= t <= 1. With F(t) = f(x(s(t))) a
// piece's integral is (B - A) h times the integral of F.
//
// The rule (L. Fejer, 1933): with the n zeros t_k = cos((2k-1) pi/(2n)) of the Chebyshev polynomial
// T_n the polynomial of degree below n that takes the values F(t_k) is the sum of c_m T_m, m < n,
// with c_m = (2/n) sum_k F(t_k) T_m(t_k), halved for m = 0. The integral of T_m is 2/(1 - m^2) for
// even m and 0 for odd, so that of the polynomial is Q(F) = sum_k w_k F(t_k),
//   w_k = (2/n) (1 - 2 sum over 1 <= j, 2j < n, of cos(j (2k-1) pi/n)/(4j^2 - 1)).
//
// Its error. Let E be the ellipse with foci -1, 1 and half-axes (rho + 1/rho)/2, (rho - 1/rho)/2,
// rho > 1, F analytic in a neighbourhood of E with its inside, and |F| <= M there. F((w + 1/w)/2)
// is analytic for 1/rho <= |w| <= rho, so its Laurent series, which is that of F = a_0/2 + sum of
// a_k T_k, has |a_k| <= 2 M rho^-k (a_k/2 is the mean of F w^-k over |w| = rho). For k < n the rule
// is exact. For k = 2nj + m or 2nj - m, 0 <= m <= n, T_k(t_i) = (-1)^j T_m(t_i) at all nodes, so
// Q(T_k) is, but for the sign, the integral of T_m for m < n, and 0 for m = n: at most 2 in size,
// as is the integral of T_k. So
//   |integral of F - Q(F)| <= sum over k >= n of 4 * 2 M rho^-k = 8 M rho^(1-n)/(rho - 1).
//
// That F is analytic and |F| <= M: rectangles that cover E's upper half with its inside, on each of
// which the formula's evaluation succeeds, which shows it analytic around that rectangle
// (functions.hpp). The formula has conjugate values at conjugate points, as have x and s, so the
// lower half follows. The functions are principal values: on overlapping rectangles they agree.

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "digest.hpp"
#include "formula_claims.hpp"
#include "statements/formulas.hpp"

namespace polhode::checker {
namespace {

/// 0 < t_1 > ... as cosines: nodes and weights of the first half, k <= (n+1)/2; the others are -t_k
/// with the same weights. For odd n the last is 0.
struct fejer_rule {
  std::vector<interval> nodes;
  std::vector<interval> weights;
};

fejer_rule make_rule(long n, precision bits) {
  // cos(i pi/(2n)) for 0 <= i < 4n, from the first quarter.
  std::vector<interval> quarter;
  quarter.reserve(static_cast<std::size_t>(n) + 1);
  const interval unit = pi(bits) / (2 * n);
  for (long i = 0; i <= n; ++i) quarter.push_back(cos(unit * i));
  const auto cosine = [&](long i) {
    i %= 4 * n;
    if (i > 2 * n) i = 4 * n - i;
    return i <= n ? quarter[static_cast<std::size_t>(i)]
                  : -quarter[static_cast<std::size_t>(2 * n - i)];
  };
  fejer_rule rule;
  const long half = (n + 1) / 2;
  rule.nodes.reserve(static_cast<std::size_t>(half));
  rule.weights.reserve(static_cast<std::size_t>(half));
  for (long k = 1; k <= half; ++k) {
    interval sum(rational(0), bits);
    for (long j = 1; 2 * j < n; ++j) sum = sum + cosine(2 * j * (2 * k - 1)) / (4 * j * j - 1);
    rule.nodes.push_back(cosine(2 * k - 1));
    rule.weights.push_back((interval(rational(1), bits) - sum.scaled(1)) * 2 / n);
  }
  return rule;
}

struct piece {
  rational begin;
  rational end;
  rational rho;
  rational supremum;
  long nodes;
  place where;

  [[nodiscard]] rational middle() const { return (begin + end) / 2; }
  [[nodiscard]] rational half() const { return (end - begin) / 2; }
};

std::vector<piece> read_pieces(const place& all) {
  constexpr std::size_t most_pieces = 2000;
  constexpr long most_nodes = 10'000;
  constexpr long most_fraction_bits = 2000;
  if (all.size() == 0) all.malformed("there must be at least one piece");
  if (all.size() > most_pieces) {
    all.not_checkable("there are more than " + std::to_string(most_pieces) + " pieces");
  }
  std::vector<piece> result;
  result.reserve(all.size());
  rational begin(0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const place one = all.at(i);
    one.expect_keys({"end", "rho", "supremum", "nodes"});
    piece p{begin,
            one["end"].fraction(),
            one["rho"].fraction(),
            one["supremum"].fraction(),
            one["nodes"].whole(1, 1L << 40U),
            one};
    if (p.end <= begin) one["end"].refute("the pieces must end one after the other, after 0");
    if (p.end > 1) one["end"].refute("a piece ends beyond the range: the last must end at 1");
    if (p.rho <= 1) one["rho"].refute("it must be greater than 1");
    if (p.supremum <= 0) one["supremum"].refute("it must be positive");
    for (const char* key : {"end", "rho", "supremum"}) {
      if (bit_length(one[key].fraction()) > most_fraction_bits) {
        one[key].not_checkable("it has too many digits");
      }
    }
    if (p.nodes > most_nodes) {
      one["nodes"].not_checkable("it is more than " + std::to_string(most_nodes));
    }
    begin = p.end;
    result.push_back(std::move(p));
  }
  if (begin != 1) all.at(all.size() - 1)["end"].refute("the last piece must end at 1");
  return result;
}

class integral_check {
 public:
  integral_check(formula_inputs inputs, std::vector<piece> pieces)
      : inputs_(std::move(inputs)), pieces_(std::move(pieces)) {}

  void check_suprema() {
    for (const piece& p : pieces_) {
      for (const long bits : region_bits) {
        if (is_bounded(p, precision(bits, p.where.work()))) break;
        if (bits == region_bits.back()) {
          p.where.not_checkable("the integrand is not shown to be analytic and at most " +
                                in_quotes(p.where["supremum"].text()) + " on this piece's ellipse");
        }
      }
    }
  }

  interval value(precision bits) {
    const auto& [start, length] = limits_at(bits);
    interval total(rational(0), bits);
    for (const piece& p : pieces_) {
      const budget::at here = p.where.working();
      const fejer_rule& rule = rule_for(p, bits);
      const interval middle = start + length * interval(p.middle(), bits);
      const interval half = length * interval(p.half(), bits);
      interval sum(rational(0), bits);
      for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const interval step = half * rule.nodes[k];
        const bool in_the_middle = p.nodes % 2 != 0 && k + 1 == rule.nodes.size();
        const interval values =
            in_the_middle ? inputs_.f(middle) : inputs_.f(middle + step) + inputs_.f(middle - step);
        sum = sum + rule.weights[k] * values;
      }
      total = total + half * sum;
      const interval error = half * truncation_error(p, bits);
      total = total.widened(error.magnitude());
    }
    return total;
  }

 private:
  const std::pair<interval, interval>& limits_at(precision bits) {
    auto found = limits_.find(bits);
    if (found == limits_.end()) {
      const interval zero(rational(0), bits);
      const auto value = [&](const formula& f, const char* key) {
        const budget::at here = inputs_.where[key].working();
        return f(zero);
      };
      const interval start = value(inputs_.from, "from");
      found = limits_.emplace(bits, std::pair(start, value(inputs_.to, "to") - start)).first;
    }
    return found->second;
  }

  /// 8 M rho^(1-n)/(rho - 1).
  static interval truncation_error(const piece& p, precision bits) {
    bits.work().rationals(3, bit_length(p.rho) + bit_length(p.supremum));
    interval power(rational(1), bits);
    const interval factor(rational(1 / p.rho), bits);
    for (long i = 1; i < p.nodes; ++i) power = power * factor;
    return power * interval(rational(8 * p.supremum / (p.rho - 1)), bits);
  }

  const fejer_rule& rule_for(const piece& p, precision bits) {
    const auto key = std::pair(p.nodes, static_cast<long>(bits));
    auto found = rules_.find(key);
    if (found == rules_.end()) {
      constexpr long numbers_of_a_node = 3;  // a cosine, a node, a weight
      bits.work().hold(p.nodes * numbers_of_a_node *
                       (static_cast<long>(sizeof(interval)) + 2 * bits / 8));
      found = rules_.emplace(key, make_rule(p.nodes, bits)).first;
    }
    return found->second;
  }

  /// A part of the plane of t, Im t >= 0.
  struct tile {
    rational left, right, bottom, top;
    int depth;
  };

  /// Covers the ellipse's upper half. False where that does not come about with so many bits.
  bool is_bounded(const piece& p, precision bits) {
    constexpr int most_depth = 60;
    const budget::at here = p.where.working();
    const rational wide((p.rho + 1 / p.rho) / 2);
    const rational high((p.rho - 1 / p.rho) / 2);
    const auto& [start, length] = limits_at(bits);
    const interval most(p.supremum, bits);
    std::vector<tile> rest{{-wide, wide, 0, high, 0}};
    while (!rest.empty()) {
      const tile t = std::move(rest.back());
      rest.pop_back();
      constexpr long operations_of_a_tile = 30;
      bits.work().rationals(operations_of_a_tile,
                            t.depth + bit_length(p.rho) + bit_length(p.begin) + bit_length(p.end));
      // The point of the tile that is nearest to 0 is on no greater ellipse of these half-axes than
      // any other.
      const rational x(t.left > 0 ? t.left : t.right < 0 ? t.right : rational(0));
      const rational u(x / wide);
      const rational v(t.bottom / high);
      if (u * u + v * v > 1) continue;
      bool shown = false;
      try {
        const rational m = p.middle();
        const rational h = p.half();
        const rectangle z{start + length * interval::between(m + h * t.left, m + h * t.right, bits),
                          length * interval::between(h * t.bottom, h * t.top, bits)};
        const rectangle f = inputs_.f(z);
        if (smallest(f.re) > most.high() || smallest(f.im) > most.high()) {
          p.where["supremum"].refute("the integrand is greater near " + near(z));
        }
        shown = f.re.magnitude() + f.im.magnitude() <= most.low();
      } catch (const undecided&) {  // smaller tiles
      }
      if (shown) continue;
      if (t.depth >= most_depth) return false;
      halve(t, rest);
    }
    return true;
  }

  static void halve(const tile& t, std::vector<tile>& rest) {
    tile one = t;
    tile other = t;
    ++one.depth;
    ++other.depth;
    if (t.right - t.left > t.top - t.bottom) {
      one.right = other.left = (t.left + t.right) / 2;
    } else {
      one.top = other.bottom = (t.bottom + t.top) / 2;
    }
    rest.push_back(std::move(other));
    rest.push_back(std::move(one));
  }

  /// The least |x| of a member.
  static integer smallest(const interval& x) {
    if (x.is_positive()) return x.low();
    return x.is_negative() ? integer(-x.high()) : integer(0);
  }
  static std::string near(const rectangle& z) {
    constexpr long few = 6;
    budget& work = z.re.bits().work();
    return decimal(z.re.lower(), few, rounding::to_zero, work) + " + " +
           decimal(z.im.lower(), few, rounding::to_zero, work) + " i";
  }

  formula_inputs inputs_;
  std::vector<piece> pieces_;
  std::map<std::pair<long, long>, fejer_rule> rules_;
  std::map<long, std::pair<interval, interval>> limits_;  // A and B - A, by their bits
};

}  // namespace

void check_integral(const place& certificate, report& result) {
  certificate["statement"].expect_text(statements::integral_statement);
  certificate["method"].expect_text(statements::integral_method);
  const place inputs = certificate["inputs"];
  formula_inputs given = formula_inputs::read(inputs, "integrand");
  certificate["formula"].expect_text(statements::fill(
      statements::integral_formula,
      {inputs["from"].text(), inputs["to"].text(), inputs["integrand"].text(), given.variable}));
  if (certificate["facts"].size() != 0) certificate["facts"].at(0).malformed("there must be none");
  expect_grounds(certificate, statements::by_machine, {statements::error_of_fejers_rule});
  result.grounds = grounds_of(certificate);
  const place numbers = certificate["numbers"];
  numbers.expect_keys({"integral"});
  const place number = numbers["integral"];
  const number_ends ends = read_number(number);
  const place witness = certificate["witness"];
  witness.expect_keys({"pieces"});
  result.subject = "integral";
  result.statement = {"the integral of " + inputs["integrand"].text() + " over " + given.variable +
                          " from " + inputs["from"].text() + " to " + inputs["to"].text(),
                      in_between("", ends.exact, ends.digits, certificate.work()).substr(1)};
  std::vector<piece> pieces = read_pieces(witness["pieces"]);
  const std::size_t count = pieces.size();
  integral_check check(std::move(given), std::move(pieces));
  check.check_suprema();
  expect_inside(number["dyadic"], ends.exact, ends.bits + 32,
                [&](precision bits) { return check.value(bits); });
  result.checks.push_back("the integrand is analytic around the range: ellipses around " +
                          std::to_string(count) + (count == 1 ? " piece" : " pieces"));
  result.checks.push_back("integral = " +
                          decimal_for_reading(ends.exact.lower, 20, certificate.work()));
  certificate["digest"].expect_text(digest_of(certificate));
}

}  // namespace polhode::checker
