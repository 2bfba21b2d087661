#include "polhode/certificate/formula_certificates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "checkable.hpp"
#include "polhode/arithmetic/text.hpp"
#include "statements/formulas.hpp"
#include "statements/shared.hpp"

namespace polhode {
namespace {

using detail::expect_at_most;
using detail::expect_known;
using detail::expect_plain_variable;
using detail::log2_of;
using detail::most_digits_of_roots;
using detail::most_roots;
using detail::power_of_two;
using detail::short_between;
using detail::widened;
using detail::widening;

constexpr long most_digits_of_integrals = 1500;

using inputs = std::vector<std::pair<std::string, std::string>>;

inputs inputs_of(const formula_over_range& what, const char* name_of_formula) {
  expect_plain_variable(what.f.variables().front());
  return {{name_of_formula, what.f.to_text()},
          {"variable", what.f.variables().front()},
          {"from", what.from.to_text()},
          {"to", what.to.to_text()}};
}

// ---------------------------------------------------------------------------------------------
// Pieces of an integral's range

struct piece {
  rational begin;
  rational end;
  rational rho;
  rational supremum;
  long nodes = 0;
};

/// The search: f over ellipses around pieces of 0 <= s <= 1, x = A + (B - A) s, as in the checker.
class piece_search {
 public:
  piece_search(const formula_over_range& what, double log2_error, long digits)
      : f_(what.f.evaluator<region>(64)),
        variable_(what.f.variables().front()),
        start_(interval_of(what.from.value(64))),
        length_(interval_of(what.to.value(64) - what.from.value(64))),
        log2_error_(log2_error),
        enough_nodes_(std::max(100L, 4 * digits)) {
    log2_length_ = log2_of(what.to.value(64) - what.from.value(64)).value_or(0);
  }

  std::vector<piece> run() {
    struct part {
      rational begin, end;
      int depth;
    };
    constexpr int most_depth = 120;
    constexpr std::size_t most_pieces = 1000;
    std::vector<piece> result;
    std::vector<part> rest{{0, 1, 0}};
    while (!rest.empty()) {
      const part p = rest.back();
      rest.pop_back();
      std::optional<piece> found = best_ellipse(p.begin, p.end);
      const rational middle((p.begin + p.end) / 2);
      if (found && (found->nodes <= enough_nodes_ || p.depth == most_depth)) {
        result.push_back(*std::move(found));
      } else if (p.depth == most_depth) {
        throw input_error(
            fmt::format("no certificate: the integrand is not found to be analytic around {} = {}, "
                        "and a checker knows only integrands that are, at the limits too",
                        variable_, to_decimal(ball(double_middle(middle)), 10)));
      } else {
        rest.push_back({middle, p.end, p.depth + 1});
        rest.push_back({p.begin, middle, p.depth + 1});
      }
      if (result.size() + rest.size() > most_pieces) {
        throw input_error(fmt::format(
            "no certificate: it would have more than {} pieces of the range", most_pieces));
      }
    }
    return result;
  }

 private:
  static double_interval interval_of(const ball& x) { return region(x).re(); }
  ball double_middle(const rational& s) const {
    return ball::exactly((start_ + length_ * double_interval(s)).midpoint(), 64);
  }

  std::optional<piece> best_ellipse(const rational& begin, const rational& end) const {
    constexpr std::array tenths_of_rho{160, 120, 80, 60, 50, 40, 35, 30,
                                       26,  23,  20, 18, 16, 14, 13};
    std::optional<piece> best;
    double least_cost = 0;
    for (const int tenths : tenths_of_rho) {
      const double rho = tenths / 10.0;
      long tiles = 0;
      const std::optional<long> bound = log2_supremum(begin, end, rho, tiles);
      if (!bound) continue;
      // 16 M |B-A| rho^(1-n)/(rho-1) at most the error: a quarter of it for all pieces together.
      const double power =
          4 + static_cast<double>(*bound) + log2_length_ - std::log2(rho - 1) - log2_error_;
      const long n = std::max(2L, static_cast<long>(std::ceil(power / std::log2(rho))) + 1);
      const long rounded = (n + 7) / 8 * 8;  // so that pieces share their rules
      const double cost = 2.0 * static_cast<double>(rounded) + static_cast<double>(tiles);
      if (best && cost >= least_cost) continue;
      least_cost = cost;
      best = piece{begin, end, rational(tenths, 10), power_of_two(*bound), rounded};
    }
    return best;
  }

  /// k with |f| <= 2^(k-1) on the ellipse, by tiles of its upper half; nothing where it is not
  /// found.
  std::optional<long> log2_supremum(const rational& begin, const rational& end, double rho,
                                    long& tiles) const {
    constexpr long most_tiles = 1500;
    constexpr long greatest_log2 = 900;
    struct tile {
      double left, right, bottom, top;
    };
    const double wide = (rho + 1 / rho) / 2;
    const double high = (rho - 1 / rho) / 2;
    const double_interval middle(rational((begin + end) / 2));
    const double_interval half(rational((end - begin) / 2));
    std::vector<tile> rest{{-wide, wide, 0, high}};
    std::optional<long> most;
    while (!rest.empty()) {
      const tile t = rest.back();
      rest.pop_back();
      const double u = (t.left > 0 ? t.left : t.right < 0 ? t.right : 0) / wide;
      const double v = t.bottom / high;
      if (u * u + v * v > 1) continue;
      if (++tiles > most_tiles) return std::nullopt;
      const region z(start_ + length_ * (middle + half * double_interval(t.left, t.right)),
                     length_ * half * double_interval(t.bottom, t.top));
      const bool is_small = t.right - t.left <= wide / 4 && t.top - t.bottom <= high / 2;
      if (is_small) {
        const region value = f_(z);
        const magnitude size = value.magnitude_upper();
        if (value.is_analytic() && !size.is_infinite()) {
          const long k = size.is_zero() ? -greatest_log2 : static_cast<long>(size.log2_floor()) + 2;
          if (k > greatest_log2) return std::nullopt;
          most = std::max({k, most.value_or(k), -greatest_log2});
          continue;
        }
      }
      if ((t.right - t.left) * high > (t.top - t.bottom) * wide) {
        const double cut = (t.left + t.right) / 2;
        rest.push_back({cut, t.right, t.bottom, t.top});
        rest.push_back({t.left, cut, t.bottom, t.top});
      } else {
        const double cut = (t.bottom + t.top) / 2;
        rest.push_back({t.left, t.right, cut, t.top});
        rest.push_back({t.left, t.right, t.bottom, cut});
      }
    }
    return most;
  }

  compiled_expression<region> f_;
  std::string variable_;
  double_interval start_;
  double_interval length_;
  double log2_length_ = 0;
  double log2_error_;
  long enough_nodes_;
};

// ---------------------------------------------------------------------------------------------
// Boxes around roots

/// Whether f' is not 0 on the box, by halving it a few times.
bool is_monotone(const compiled_expression<jet<ball, 1>>& f, const rational& lower,
                 const rational& upper, precision p, int depth = 0) {
  constexpr int most_depth = 3;
  const ball x = hull(ball(lower, p), ball(upper, p));
  const ball slope = f(jet<ball, 1>::variable(x)).derivative(1);
  if (!slope.is_undefined() && !contains_zero(slope)) return true;
  if (depth == most_depth) return false;
  const rational middle((lower + upper) / 2);
  return is_monotone(f, lower, middle, p, depth + 1) && is_monotone(f, middle, upper, p, depth + 1);
}

}  // namespace

void expect_checkable(const formula_over_range& what) {
  expect_known(what.f, "the formula");
  expect_known(what.from, "the lower end");
  expect_known(what.to, "the upper end");
}

json integral_certificate(const formula_over_range& what, const ball& enclosure, long digits) {
  expect_checkable(what);
  expect_at_most(most_digits_of_integrals, digits, "an integral");
  const ball length = what.to.value(64) - what.from.value(64);
  const long k = widening(enclosure, log2_of(length).value_or(0), digits);
  const inputs given = inputs_of(what, "integrand");
  certificate c;
  c.claim = statements::integral_claim;
  c.statement = statements::integral_statement;
  c.formula = statements::fill(statements::integral_formula, {given[2].second, given[3].second,
                                                              given[0].second, given[1].second});
  c.method = statements::integral_method;
  c.argument.push_back({step_kind::cited, std::string(statements::error_of_fejers_rule.statement)});
  c.numbers.push_back({"integral", widened(enclosure, k, digits), digits});
  json pieces = json::array();
  for (const piece& p : piece_search(what, static_cast<double>(k), digits).run()) {
    pieces.push_back(json{{"end", to_text(p.end)},
                          {"rho", to_text(p.rho)},
                          {"supremum", to_text(p.supremum)},
                          {"nodes", p.nodes}});
  }
  c.witness["pieces"] = std::move(pieces);
  c.verdict = status::certified;
  return to_json(c, given);
}

json roots_certificate(const formula_over_range& what, std::span<const ball> enclosures,
                       long digits) {
  expect_checkable(what);
  expect_at_most(most_digits_of_roots, digits, "roots");
  const std::size_t count = enclosures.size();
  if (count > most_roots) {
    throw input_error(
        fmt::format("no certificate: there are {} roots; it may have {}", count, most_roots));
  }
  const inputs given = inputs_of(what, "formula");
  certificate c;
  c.claim = statements::roots_claim;
  c.statement = statements::fill(statements::roots_statement, {std::to_string(count)});
  c.formula = statements::fill(statements::roots_formula, {given[0].second, given[2].second,
                                                           given[1].second, given[3].second});
  c.method = statements::roots_method;
  c.argument.push_back({step_kind::cited, std::string(statements::intermediate_values.statement)});
  const precision p = bits_for_digits(digits) + 64;
  const ball from = what.from.value(p);
  const ball to = what.to.value(p);
  const double size = log2_of(to - from).value_or(0);
  std::vector<ball> numbers;
  numbers.reserve(count);
  for (const ball& e : enclosures) numbers.push_back(widened(e, widening(e, size, digits), digits));
  const auto f = what.f.evaluator<jet<ball, 1>>(p);
  json boxes = json::array();
  for (std::size_t i = 0; i < count; ++i) {
    // Between the neighbours: the middle of what is between their numbers, or an end of the range.
    const rational lower = lower_rational(numbers[i]);
    const rational upper = upper_rational(numbers[i]);
    const rational below = i == 0 ? upper_rational(from) : upper_rational(numbers[i - 1]);
    const rational above = i + 1 == count ? lower_rational(to) : lower_rational(numbers[i + 1]);
    if (below >= lower || above <= upper) {
      throw input_error(fmt::format(
          "no certificate: the root {} is at an end of the range, or too near another; a checker "
          "knows only roots inside a range",
          to_decimal(enclosures[i], 10)));
    }
    rational before(i == 0 ? rational(lower - below) : rational((lower - below) / 2));
    rational behind(i + 1 == count ? rational(above - upper) : rational((above - upper) / 2));
    while (!is_monotone(f, lower - before, upper + behind, p)) {
      before /= 2;
      behind /= 2;
      if (before + behind < upper - lower) {
        throw input_error(fmt::format(
            "no certificate: the formula's derivative is not found to be different from 0 around "
            "the root {}; a checker knows only simple roots",
            to_decimal(enclosures[i], 10)));
      }
    }
    boxes.push_back(json{{"lower", to_text(short_between(lower - before, lower))},
                         {"upper", to_text(short_between(upper, upper + behind))}});
    c.numbers.push_back({fmt::format("root_{}", i + 1), numbers[i], digits});
  }
  c.witness["boxes"] = std::move(boxes);
  c.verdict = status::certified;
  return to_json(c, given);
}

}  // namespace polhode
