// All roots of a formula f in a range. The witness gives a box around each root, one after the
// other. On a box f has a derivative that is nowhere 0, so it has at most one root there; it has
// different signs at the ends of the root's number, which lie in the box, so it has one between
// them. Between the boxes, and between them and the ends of the range, f is defined and not 0. Both
// are shown by evaluation over intervals, halved until they decide; beside the range of f there is
// the mean value form, f(m) + f'(X) (X - m).

#include <algorithm>
#include <utility>
#include <vector>

#include "digest.hpp"
#include "formula_claims.hpp"
#include "statements/formulas.hpp"
#include "statements/shared.hpp"

namespace polhode::checker {
namespace {

enum class sign { negative, unknown, positive };

sign sign_of(const interval& x) {
  if (x.is_positive()) return sign::positive;
  return x.is_negative() ? sign::negative : sign::unknown;
}

class roots_check {
 public:
  explicit roots_check(formula f) : f_(std::move(f)) {}

  /// f's sign at x, with more and more bits.
  sign sign_at(const rational& x, long bits, const place& where) {
    const budget::at here = where.working();
    for (int attempt = 0; attempt < 5; ++attempt, bits += bits / 2 + 64) {
      try {
        const sign s = sign_of(f_(interval(x, precision(bits, where.work()))));
        if (s != sign::unknown) return s;
      } catch (const undecided&) {  // more bits
      }
    }
    return sign::unknown;
  }

  /// That f' has one sign on the box.
  void expect_monotone(const range& box, const place& where) {
    sign all = sign::unknown;
    const auto shows = [&](const range& part, precision bits) {
      const sign s = sign_of(jet_over(part, bits).slope);
      if (s == sign::unknown) return false;
      if (all != sign::unknown && s != all) {
        where.refute("the derivative has both signs on it");
      }
      all = s;
      return true;
    };
    if (const auto left = first_not_shown(box, shows, where)) {
      where.not_checkable("the derivative is not shown to be different from 0 between " +
                          in_decimals(*left, where.work()));
    }
  }

  /// That f is nowhere 0 between.
  void expect_no_root(const range& gap, const place& where) {
    const auto shows = [&](const range& part, precision bits) {
      if (sign_of(f_(interval::between(part.lower, part.upper, bits))) != sign::unknown)
        return true;
      const rational middle((part.lower + part.upper) / 2);
      const interval step =
          interval::between(part.lower - middle, part.upper - middle, bits).widened(integer(1));
      return sign_of(f_(interval(middle, bits)) + jet_over(part, bits).slope * step) !=
             sign::unknown;
    };
    if (const auto left = first_not_shown(gap, shows, where)) {
      where.not_checkable("the formula is not shown to be different from 0 between " +
                          in_decimals(*left, where.work()) + ", where there is no box");
    }
  }

 private:
  jet jet_over(const range& x, precision bits) {
    return f_(jet{interval::between(x.lower, x.upper, bits), interval(rational(1), bits)});
  }

  /// Halves the range until `shows` shows every part. Returns a part where it does not.
  template <class Shows>
  std::optional<range> first_not_shown(const range& all, const Shows& shows, const place& where) {
    constexpr int most_depth = 60;
    struct part {
      range x;
      int depth;
    };
    const budget::at here = where.working();
    std::optional<range> stuck;
    for (const long number_of_bits : region_bits) {
      const precision bits(number_of_bits, where.work());
      stuck.reset();
      std::vector<part> rest{{all, 0}};
      while (!rest.empty() && !stuck) {
        part one = std::move(rest.back());
        rest.pop_back();
        bits.work().rationals(8, bit_length(one.x.lower) + bit_length(one.x.upper));
        try {
          if (shows(one.x, bits)) continue;
        } catch (const undecided&) {  // smaller parts
        }
        if (one.depth == most_depth) {
          stuck = one.x;
          break;
        }
        const rational middle((one.x.lower + one.x.upper) / 2);
        rest.push_back({{middle, one.x.upper}, one.depth + 1});
        rest.push_back({{one.x.lower, middle}, one.depth + 1});
      }
      if (!stuck) return std::nullopt;
    }
    return stuck;
  }

  formula f_;
};

std::string name_of(std::size_t i) { return "root_" + std::to_string(i + 1); }

}  // namespace

void check_roots(const place& certificate, report& result) {
  const place numbers = certificate["numbers"];
  const std::size_t count = numbers.value().size();
  certificate["statement"].expect_text(
      statements::fill(statements::roots_statement, {std::to_string(count)}));
  certificate["method"].expect_text(statements::roots_method);
  const place inputs = certificate["inputs"];
  const formula_inputs given = formula_inputs::read(inputs, "formula");
  certificate["formula"].expect_text(statements::fill(
      statements::roots_formula,
      {inputs["formula"].text(), inputs["from"].text(), given.variable, inputs["to"].text()}));
  if (certificate["facts"].size() != 0) certificate["facts"].at(0).malformed("there must be none");
  expect_grounds(certificate, statements::by_machine, {statements::intermediate_values});
  result.grounds = grounds_of(certificate);
  result.subject = count == 1 ? "1 root" : std::to_string(count) + " roots";
  result.statement = {inputs["formula"].text() + " is 0 for exactly " + std::to_string(count) +
                      " " + given.variable + " in the range " + inputs["from"].text() +
                      " <= " + given.variable + " <= " + inputs["to"].text()};
  const place witness = certificate["witness"];
  witness.expect_keys({"boxes"});
  const place boxes = witness["boxes"];
  if (boxes.size() != count) boxes.refute("there must be a box for each number");
  const range from = end_of(given.from, inputs["from"]);
  const range to = end_of(given.to, inputs["to"]);
  if (from.upper >= to.lower) inputs["to"].refute("it must be above the range's lower end");
  std::vector<number_ends> ends;
  std::vector<range> box;
  ends.reserve(count);
  box.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!numbers.has(name_of(i))) numbers[name_of(i)].malformed("it is missing");
    const place number = numbers[name_of(i)];
    ends.push_back(read_number(number));
    const place where = boxes.at(i);
    box.push_back(examination::bracket(where));
    const range& b = box.back();
    if (ends[i].exact.lower < b.lower || b.upper < ends[i].exact.upper) {
      where.refute("the number is not inside it");
    }
    if (i == 0 && b.lower < from.upper) where["lower"].refute("it is not shown to be in the range");
    if (i > 0 && b.lower < box[i - 1].upper)
      where["lower"].refute("it begins before the last box ends");
    if (i + 1 == count && b.upper > to.lower) {
      where["upper"].refute("it is not shown to be in the range");
    }
  }
  roots_check check(given.f);
  for (std::size_t i = 0; i < count; ++i) {
    const place number = numbers[name_of(i)]["dyadic"];
    const sign below = check.sign_at(ends[i].exact.lower, ends[i].bits + 32, number["lower"]);
    const sign above = check.sign_at(ends[i].exact.upper, ends[i].bits + 32, number["upper"]);
    if (below == sign::unknown) number["lower"].not_checkable("the sign there is not decided");
    if (above == sign::unknown) number["upper"].not_checkable("the sign there is not decided");
    if (below == above) number.refute("the formula has the same sign at both ends");
    check.expect_monotone(box[i], boxes.at(i));
    result.statement.push_back(
        in_between(name_of(i), ends[i].exact, ends[i].digits, certificate.work()));
    result.checks.push_back(name_of(i) + " = " +
                            decimal_for_reading(ends[i].exact.lower, 20, certificate.work()));
  }
  for (std::size_t i = 0; i <= count; ++i) {
    const range gap{i == 0 ? from.lower : box[i - 1].upper, i == count ? to.upper : box[i].lower};
    if (gap.lower < gap.upper) check.expect_no_root(gap, boxes);
  }
  result.checks.emplace_back("there is no other root in the range");
  certificate["digest"].expect_text(digest_of(certificate));
}

}  // namespace polhode::checker
