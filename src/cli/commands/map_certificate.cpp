#include "map_certificate.hpp"

#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/output/errors.hpp"
#include "map_rows.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "statements/map.hpp"

namespace polhode::cli {
namespace map_certificate_impl {
namespace {

constexpr std::size_t most_cells = 250'000;

/// The length of ranges of an axis: the difference, or that of the logarithms.
class axis_length {
 public:
  explicit axis_length(bool log) : log_(log) {}
  [[nodiscard]] ball operator()(const rational_range& range) {
    return at(range.high) - at(range.low);
  }

 private:
  ball at(const rational& x) {
    constexpr precision p = 128;
    if (!log_) return {x, p};
    const auto [place, is_new] = known_.try_emplace(x);
    if (is_new) place->second = log(ball(x, p));
    return place->second;
  }

  bool log_;
  std::map<rational, ball> known_;
};

/// What is counted of one quantity.
struct undecided_cells {
  std::size_t count = 0;
  ball area{0, 128};
};

/// A share in percent with two decimals, rounded up; and up a little more, so that a checker's
/// enclosure is below it where the share has two decimals itself.
std::string percent(const undecided_cells& part, const ball& all) {
  if (part.count == 0) return "0.00";
  const rational share = upper_rational(part.area / all * 10'000) + rational(1, 1'000'000);
  const integer hundredths = -floor_of(rational(-share));
  return fmt::format("{}.{:02}", integer(hundredths / 100).str(),
                     static_cast<int>(integer(hundredths % 100)));
}

void expect_cells(std::size_t count) {
  if (count <= most_cells) return;
  throw usage_error(
      fmt::format("--certificate: the map has more than {} cells; give fewer steps, or a smaller "
                  "--refine",
                  most_cells));
}

/// Of the two columns of an integer its value, where they are equal.
std::string value_of(const std::string& columns) {
  const std::size_t comma = columns.find(',');
  const std::string low = columns.substr(0, comma);
  return low == columns.substr(comma + 1) ? low : std::string(statements::undecided_on_cell);
}

}  // namespace
}  // namespace map_certificate_impl

void expect_certifiable(const map_grid& g) {
  std::vector<std::string_view> known;
  known.reserve(statements::mapped_quantities.size());
  for (const statements::mapped_quantity& q : statements::mapped_quantities)
    known.push_back(q.name);
  const auto refuse = [](const std::string& why) {
    return usage_error("--certificate: " + why + "; it is of cells of --a and --b");
  };
  for (const std::string& name : g.quantities) {
    if (statements::find_mapped(name) == nullptr) {
      throw refuse(
          fmt::format("{} is not among {}, which rationals decide", name, fmt::join(known, ", ")));
    }
  }
  if (!g.cells) throw refuse("--cells is missing");
  if (!g.a) throw refuse("the axes are others");
  if (g.first.values.size() < 2 || g.second.values.size() < 2) {
    throw refuse("one of them is a single number");
  }
  map_certificate_impl::expect_cells(g.points());
}

json map_certificate(const map_grid& g) {
  using namespace map_certificate_impl;
  std::vector<const statements::mapped_quantity*> chosen;
  for (const std::string& name : g.quantities) chosen.push_back(statements::find_mapped(name));
  axis_length along_a(g.log);
  axis_length along_b(g.log);
  std::vector<undecided_cells> undecided(chosen.size());
  std::size_t count = 0;
  json cells = json::array();
  for (std::size_t index = 0; index < g.points(); ++index) {
    json parts = json::array();
    walk_cell(
        g, cell_of(g, index),
        [&](const map_cell& cell, const std::vector<std::string>& columns) {
          expect_cells(++count);
          std::vector<std::string> values;
          for (std::size_t k = 0; k < columns.size(); ++k) {
            values.push_back(value_of(columns[k]));
            if (values.back() != statements::undecided_on_cell) continue;
            ++undecided[k].count;
            undecided[k].area = undecided[k].area + along_a(cell.x) * along_b(cell.y);
          }
          parts.push_back(fmt::format("{}", fmt::join(values, " ")));
        },
        [&](bool in_a, const rational& at) {
          parts.push_back(fmt::format("{} {}", in_a ? "a" : "b", to_text(at)));
        });
    cells.push_back(std::move(parts));
  }
  const rational_range a{g.first.values.front(), g.first.values.back()};
  const rational_range b{g.second.values.front(), g.second.values.back()};
  const std::vector<std::pair<std::string, std::string>> inputs{
      {"quantities", fmt::format("{}", fmt::join(g.quantities, " "))},
      {"a_from", to_text(a.low)},
      {"a_to", to_text(a.high)},
      {"b_from", to_text(b.low)},
      {"b_to", to_text(b.high)},
      {"scale", std::string(g.log ? statements::logarithmic_scale : statements::linear_scale)}};
  certificate c;
  c.claim = statements::map_claim;
  c.statement = statements::fill(statements::map_statement, {to_text(a.low), to_text(a.high),
                                                             to_text(b.low), to_text(b.high)});
  c.formula = statements::map_formula(chosen);
  c.method = statements::map_method;
  c.tier = proof_tier::with_words;
  for (const statements::stated_text& s : statements::map_grounds(chosen)) {
    c.argument.push_back(
        {s.kind == statements::proved_in_coq ? step_kind::kernel : step_kind::argued,
         std::string(s.statement)});
  }
  const ball whole = along_a(a) * along_b(b);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const undecided_cells& u = undecided[k];
    c.facts.push_back(
        {statements::fill(statements::map_fact,
                          {g.quantities[k], std::to_string(u.count), std::to_string(count),
                           percent(u, whole), std::string(g.log ? statements::in_logarithms : "")}),
         true, step_kind::enclosed});
  }
  const auto values_of = [](const std::vector<rational>& values) {
    json result = json::array();
    for (const rational& x : values) result.push_back(to_text(x));
    return result;
  };
  c.witness = json{{"a", values_of(g.first.values)},
                   {"b", values_of(g.second.values)},
                   {"cells", std::move(cells)}};
  c.conclude();
  return to_json(c, inputs);
}

}  // namespace polhode::cli
