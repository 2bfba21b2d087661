// The map of counts and kinds over cells of the plane of bodies: `claim` "map".
//
// The cells are those between neighbouring values of a and b, each divided as its list says: "a q"
// or "b q" cuts the cell at q, after which come the parts of the lower half and then those of the
// upper one; anything else is the values on a cell that is not divided. So they cover the rectangle
// by construction. On such a cell the body with the least a and b, and the one with the greatest,
// must both have the values.

#include <map>
#include <utility>
#include <vector>

#include "body.hpp"
#include "digest.hpp"
#include "formula_claims.hpp"
#include "interval.hpp"
#include "statements/map.hpp"

namespace polhode::checker {
namespace {

constexpr std::size_t most_values_of_axis = 10'000;
constexpr std::size_t most_parts_of_map = 1'000'000;
constexpr long area_bits = 128;

struct map_cell {
  range a;
  range b;
};

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> result(1);
  for (const char c : text) {
    if (c == ' ') {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

/// What a body has of a quantity.
integer value_at(std::string_view name, const body& rigid) {
  if (name == "physical") return rigid.kind() >= 0 ? 1 : 0;
  return name == "meetings" ? rigid.intersections() + rigid.crossings() : rigid.intersections();
}

/// Lengths along an axis: differences, or those of the logarithms.
class axis_length {
 public:
  axis_length(bool log, const precision& bits) : log_(log), bits_(bits) {}
  [[nodiscard]] interval operator()(const range& r) { return at(r.upper) - at(r.lower); }

 private:
  interval at(const rational& x) {
    if (!log_) return {x, bits_};
    auto known = logarithms_.find(x);
    if (known == logarithms_.end()) {
      known = logarithms_.emplace(x, log_of(x)).first;
    }
    return known->second;
  }
  /// The logarithm of x = m 2^k, m in [1, 2], which takes no more bits where x is near 0.
  [[nodiscard]] interval log_of(const rational& x) const {
    const long k = static_cast<long>(msb(integer(numerator(x)))) -
                   static_cast<long>(msb(integer(denominator(x))));
    const integer power = integer(1) << static_cast<unsigned long>(k < 0 ? -k : k);
    const rational m = k < 0 ? rational(x * power) : rational(x / power);
    return log(interval(m, bits_)) + log(interval(rational(2), bits_)) * k;
  }

  bool log_;
  precision bits_;
  std::map<rational, interval> logarithms_;
};

class map_check {
 public:
  map_check(std::vector<const statements::mapped_quantity*> chosen, axis_length along_a,
            axis_length along_b, const precision& bits)
      : chosen_(std::move(chosen)),
        along_a_(std::move(along_a)),
        along_b_(std::move(along_b)),
        undecided_(chosen_.size(), {0, interval(rational(0), bits)}) {}

  /// A cell and the list of its parts.
  void examine(const map_cell& whole, const place& parts) {
    std::vector<map_cell> open{whole};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const place part = parts.at(i);
      if (open.empty()) part.malformed("the parts before it are the whole cell");
      const map_cell cell = open.back();
      open.pop_back();
      if (part.text().rfind("a ", 0) == 0 || part.text().rfind("b ", 0) == 0) {
        cut(cell, part, open);
      } else {
        expect_values(cell, part);
      }
    }
    if (!open.empty()) parts.refute("its parts are not the whole cell");
  }

  [[nodiscard]] std::size_t cells() const { return cells_; }
  [[nodiscard]] std::size_t undecided_cells(std::size_t k) const { return undecided_[k].first; }
  [[nodiscard]] const interval& undecided_area(std::size_t k) const { return undecided_[k].second; }

 private:
  static void cut(const map_cell& cell, const place& part, std::vector<map_cell>& open) {
    const json at = part.text().substr(2);
    const rational q = place(at, part.pointer(), part.work()).fraction();
    const bool in_a = part.text().front() == 'a';
    const range& r = in_a ? cell.a : cell.b;
    part.work().rationals(2, bit_length(q) + bit_length(r.lower) + bit_length(r.upper));
    if (q <= r.lower || q >= r.upper) part.refute("the cut is not inside the cell");
    map_cell low = cell;
    map_cell high = cell;
    (in_a ? low.a : low.b).upper = q;
    (in_a ? high.a : high.b).lower = q;
    open.push_back(high);
    open.push_back(low);
  }

  void expect_values(const map_cell& cell, const place& part) {
    const budget::at here = part.working();
    const std::vector<std::string> given = words_of(part.text());
    if (given.size() != chosen_.size()) {
      part.malformed("it must have a value, or ?, for each of " + std::to_string(chosen_.size()) +
                     " quantities, or be a cut");
    }
    ++cells_;
    constexpr long operations = 40;  // of a count, a root among them
    part.work().rationals(operations, bit_length(cell.a.lower) + bit_length(cell.a.upper) +
                                          bit_length(cell.b.lower) + bit_length(cell.b.upper));
    const body least{cell.a.lower, cell.b.lower};
    const body greatest{cell.a.upper, cell.b.upper};
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
      if (given[k] == statements::undecided_on_cell) {
        ++undecided_[k].first;
        undecided_[k].second = undecided_[k].second + along_a_(cell.a) * along_b_(cell.b);
        continue;
      }
      for (const body& rigid : {least, greatest}) {
        const std::string right = value_at(chosen_[k]->name, rigid).str();
        if (right == given[k]) continue;
        part.refute(std::string(chosen_[k]->name) + " is " + right + " for the body a = " +
                    rigid.a.exact().str() + ", b = " + rigid.b.exact().str() + " of the cell");
      }
    }
  }

  std::vector<const statements::mapped_quantity*> chosen_;
  axis_length along_a_;
  axis_length along_b_;
  std::vector<std::pair<std::size_t, interval>> undecided_;
  std::size_t cells_ = 0;
};

/// Values that increase from one end to the other.
std::vector<rational> values_along(const place& where, const rational& from, const rational& to) {
  if (where.size() < 2 || where.size() > most_values_of_axis) {
    where.malformed("it must have from 2 to " + std::to_string(most_values_of_axis) + " values");
  }
  std::vector<rational> result;
  result.reserve(where.size());
  for (std::size_t i = 0; i < where.size(); ++i) {
    result.push_back(where.at(i).fraction());
    where.work().rationals(2, bit_length(result.back()));
    if (i > 0 && result[i] <= result[i - 1]) where.at(i).refute("it is not above the one before");
  }
  if (result.front() != from) where.at(0).refute("it is not where the rectangle begins");
  if (result.back() != to) where.at(where.size() - 1).refute("it is not where the rectangle ends");
  return result;
}

/// That the fact has a share in percent with two decimals that is not below the area, nor above it
/// by more than 0.02. Returns its text.
std::string expect_percent(const place& fact, const interval& part, const interval& whole) {
  const std::string& text = fact["statement"].text();
  const std::string before = " are at most ";
  const auto start = text.find(before);
  const auto end = start == std::string::npos ? start : text.find(" %", start);
  if (end == std::string::npos) fact["statement"].malformed("it has no share of the area");
  std::string share = text.substr(start + before.size(), end - start - before.size());
  rational percent;
  const auto point = share.find('.');
  if (point == std::string::npos || share.size() - point != 3 || share.size() > 6 ||
      !read_decimal(share, percent)) {
    fact["statement"].malformed("the share must have two decimals, such as 5.97");
  }
  const precision& bits = part.bits();
  const interval given = whole * interval(rational(percent / 100), bits);
  const interval less = whole * interval(rational((percent - rational(1, 50)) / 100), bits);
  if (is_below(given, part)) fact["statement"].refute("the area is greater");
  if (is_below(part, less)) fact["statement"].refute("the area is smaller");
  const bool shown = is_below(part, given) || (percent == 0 && part.high() == 0);
  if (!shown) fact["statement"].not_checkable("the share of the area is not decided");
  return share;
}

std::vector<const statements::mapped_quantity*> quantities_of(const place& where) {
  std::vector<const statements::mapped_quantity*> chosen;
  for (const std::string& name : words_of(where.text())) {
    const statements::mapped_quantity* found = statements::find_mapped(name);
    if (found == nullptr) where.malformed("it names " + in_quotes(name) + ", which is no quantity");
    for (const statements::mapped_quantity* other : chosen) {
      if (other == found) where.malformed("it names " + name + " twice");
    }
    chosen.push_back(found);
  }
  return chosen;
}

}  // namespace

void check_map(const place& certificate, report& result) {
  const place inputs = certificate["inputs"];
  inputs.expect_keys({"quantities", "a_from", "a_to", "b_from", "b_to", "scale"});
  const std::vector<const statements::mapped_quantity*> chosen =
      quantities_of(inputs["quantities"]);
  const range a{inputs["a_from"].fraction(), inputs["a_to"].fraction()};
  const range b{inputs["b_from"].fraction(), inputs["b_to"].fraction()};
  if (a.lower <= 0) inputs["a_from"].refute("it must be above 0");
  if (b.lower <= 0) inputs["b_from"].refute("it must be above 0");
  if (b.upper >= 1) inputs["b_to"].refute("it must be below 1");
  const bool log = inputs["scale"].text() == statements::logarithmic_scale;
  if (!log) inputs["scale"].expect_text(statements::linear_scale);
  const std::string statement =
      statements::fill(statements::map_statement, {inputs["a_from"].text(), inputs["a_to"].text(),
                                                   inputs["b_from"].text(), inputs["b_to"].text()});
  certificate["statement"].expect_text(statement);
  certificate["formula"].expect_text(statements::map_formula(chosen));
  certificate["method"].expect_text(statements::map_method);
  const place numbers = certificate["numbers"];
  if (!numbers.value().empty()) numbers.malformed("there must be none");

  const place witness = certificate["witness"];
  witness.expect_keys({"a", "b", "cells"});
  const std::vector<rational> columns = values_along(witness["a"], a.lower, a.upper);
  const std::vector<rational> rows = values_along(witness["b"], b.lower, b.upper);
  const place cells = witness["cells"];
  if (cells.size() != (columns.size() - 1) * (rows.size() - 1)) {
    cells.malformed("there must be a list for each cell between the values of a and b");
  }
  const budget::at here = cells.working();
  result.statement = {statement, certificate["formula"].text()};
  const precision bits(area_bits, certificate.work());
  axis_length along_a(log, bits);
  axis_length along_b(log, bits);
  map_check check(chosen, along_a, along_b, bits);
  std::size_t parts = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t column = i / (rows.size() - 1);
    const std::size_t row = i % (rows.size() - 1);
    parts += cells.at(i).size();
    if (parts > most_parts_of_map) cells.at(i).not_checkable("the map has too many cells");
    check.examine({{columns[column], columns[column + 1]}, {rows[row], rows[row + 1]}},
                  cells.at(i));
  }

  const interval whole = along_a(a) * along_b(b);
  const place facts = certificate["facts"];
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const place fact = facts.at(k);
    fact.expect_keys({"statement", "holds", "kind"});
    fact["holds"].expect_true();
    fact["kind"].expect_text(enclosed);
    const std::string share = expect_percent(fact, check.undecided_area(k), whole);
    const std::string right =
        statements::fill(statements::map_fact,
                         {std::string(chosen[k]->name), std::to_string(check.undecided_cells(k)),
                          std::to_string(check.cells()), share,
                          std::string(log ? statements::in_logarithms : std::string_view())});
    fact["statement"].expect_text(right);
    result.statement.push_back(right);
    result.checks.push_back(right);
  }
  if (facts.size() > chosen.size()) facts.at(chosen.size()).malformed("there is no such quantity");
  expect_grounds(certificate, statements::with_words, statements::map_grounds(chosen));
  result.grounds = grounds_of(certificate);
  result.tier = statements::with_words;
  result.subject = "map of " + inputs["quantities"].text();
  certificate["digest"].expect_text(digest_of(certificate));
}

}  // namespace polhode::checker
