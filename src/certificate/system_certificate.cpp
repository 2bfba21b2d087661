// Certificates of the roots of systems: the search for boxes around the roots on which the matrix
// of derivatives is regular, as the checker shows it (src/checker/roots_of_system.cpp).

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "checkable.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/certificate_of.hpp"
#include "statements/formulas.hpp"
#include "statements/shared.hpp"

namespace polhode {
namespace system_certificate_impl {
namespace {

using rational_box = std::vector<std::pair<rational, rational>>;

std::vector<ball> balls_of(const rational_box& x, precision p) {
  std::vector<ball> result;
  result.reserve(x.size());
  for (const auto& [lower, upper] : x) result.push_back(from_end_points(lower, upper, p));
  return result;
}

/// |I - Y J| is at most half of what the checker asks for, J the derivatives over the box: its
/// intervals may be wider.
bool is_regular(const real_system& f, const rational_box& x, precision p) {
  const krawczyk_step step = krawczyk(f, balls_of(x, p), p);
  const std::size_t n = x.size();
  if (step.preconditioner.size() != n) return false;
  for (std::size_t i = 0; i < n; ++i) {
    ball sum(0, p);
    for (std::size_t j = 0; j < n; ++j) {
      ball entry(i == j ? 1 : 0, p);
      for (std::size_t k = 0; k < n; ++k) entry -= step.preconditioner[i][k] * step.jacobian[k][j];
      if (!entry.is_bounded()) return false;
      sum += abs(entry);
    }
    if (!certainly_less(sum, ball(rational(1, 2), p))) return false;
  }
  return true;
}

std::string point_of(const std::vector<ball>& x) {
  std::string result;
  for (const ball& side : x) result += (result.empty() ? "" : ", ") + to_decimal(side, 10);
  return "(" + result + ")";
}

/// The box, its ends cut to short numbers that are no nearer to the inner one.
rational_box shortened(const rational_box& x, const rational_box& inner) {
  rational_box result;
  for (std::size_t i = 0; i < x.size(); ++i) {
    result.emplace_back(detail::short_between(x[i].first, inner[i].first),
                        detail::short_between(inner[i].second, x[i].second));
  }
  return result;
}

/// A box around each of the roots' boxes, apart from the others and in the range.
class box_search {
 public:
  box_search(const real_system& f, rational_box range, std::vector<rational_box> roots, precision p)
      : f_(f), range_(std::move(range)), roots_(std::move(roots)), p_(p) {}

  /// Nothing where there is none.
  [[nodiscard]] std::optional<rational_box> around(std::size_t k) const {
    constexpr int most_halvings = 200;
    rational part = share_of(k);
    for (int halvings = 0; halvings < most_halvings; ++halvings, part /= 2) {
      const auto x = widened(k, part);
      if (!x) return std::nullopt;
      if (is_regular(f_, *x, p_)) return shortened(*x, roots_[k]);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] rational width(std::size_t i) const { return range_[i].second - range_[i].first; }
  /// Boxes that are wider than the roots' by this part of the range's width are apart: half of the
  /// greatest distance from the nearest root, along one side.
  [[nodiscard]] rational share_of(std::size_t k) const {
    rational least(1, 4);
    for (std::size_t other = 0; other < roots_.size(); ++other) {
      if (other == k) continue;
      rational most = 0;
      for (std::size_t i = 0; i < range_.size(); ++i) {
        const auto& x = roots_[k][i];
        const auto& y = roots_[other][i];
        const rational gap = std::max<rational>(y.first - x.second, x.first - y.second);
        most = std::max<rational>(most, gap / width(i));
      }
      least = std::min<rational>(least, most / 2);
    }
    return least;
  }
  /// The box of the root, wider by this part of the range's width, in the range; nothing where it
  /// does not lie inside the range.
  [[nodiscard]] std::optional<rational_box> widened(std::size_t k, const rational& part) const {
    rational_box result;
    for (std::size_t i = 0; i < range_.size(); ++i) {
      const auto& [lower, upper] = roots_[k][i];
      const rational by = part * width(i);
      const rational from = std::max<rational>(range_[i].first, lower - by);
      const rational to = std::min<rational>(range_[i].second, upper + by);
      if (from >= lower || to <= upper) return std::nullopt;
      result.emplace_back(from, to);
    }
    return result;
  }

  const real_system& f_;
  rational_box range_;
  std::vector<rational_box> roots_;
  precision p_;
};

void expect_simple(const system_root_set& found) {
  if (!found.is_resolved() || !found.complete) {
    throw input_error("no certificate: not every place is proved to hold one root");
  }
  for (const system_region& r : found.regions) {
    if (r.verdict != root_verdict::unique) {
      throw input_error(
          "no certificate: there is a multiple root; a checker knows only simple ones");
    }
  }
}

}  // namespace
}  // namespace system_certificate_impl

void expect_checkable(const system_over_box& what) {
  constexpr std::size_t most_variables = 20;
  if (what.f.size() > most_variables) {
    throw input_error(fmt::format("no certificate: there are {} variables; it may have {}",
                                  what.f.size(), most_variables));
  }
  for (const expression& f : what.f) detail::expect_known(f, "a formula");
  for (const expression& end : what.from) detail::expect_known(end, "a lower end");
  for (const expression& end : what.to) detail::expect_known(end, "an upper end");
  for (const std::string& name : what.f.front().variables()) detail::expect_plain_variable(name);
}

json certificate_of(const system_over_box& what, const system_root_set& found, long digits) {
  using namespace system_certificate_impl;
  // The certificate's numbers are wider than the enclosures.
  constexpr long more_digits = 8;
  expect_checkable(what);
  expect_simple(found);
  detail::expect_at_most(detail::most_digits_of_roots, digits, "roots");
  const std::size_t count = found.regions.size();
  if (count > detail::most_roots) {
    throw input_error(fmt::format("no certificate: there are {} roots; it may have {}", count,
                                  detail::most_roots));
  }
  const std::vector<std::string>& variables = what.f.front().variables();
  const std::size_t n = variables.size();
  const precision p = bits_for_digits(digits) + 64;
  std::vector<std::pair<std::string, std::string>> inputs;
  std::string equations;
  std::string sides;
  rational_box range;
  for (std::size_t i = 0; i < n; ++i) {
    const auto numbered = [&](const char* name) { return fmt::format("{}_{}", name, i + 1); };
    const std::string f = what.f[i].to_text();
    const std::string from = what.from[i].to_text();
    const std::string to = what.to[i].to_text();
    inputs.emplace_back(numbered("formula"), f);
    inputs.emplace_back(numbered("variable"), variables[i]);
    inputs.emplace_back(numbered("from"), from);
    inputs.emplace_back(numbered("to"), to);
    equations += (i == 0 ? "" : ", ") + statements::fill(statements::equation_of_system, {f});
    sides += (i == 0 ? "" : ", ") +
             statements::fill(statements::side_of_system, {from, variables[i], to});
    range.emplace_back(upper_rational(what.from[i].value(p)), lower_rational(what.to[i].value(p)));
  }
  certificate c;
  c.claim = statements::system_claim;
  c.statement = statements::fill(statements::system_statement, {std::to_string(count)});
  c.formula = statements::fill(statements::system_formula, {equations, sides});
  c.method = statements::system_method;
  c.argument.push_back({step_kind::cited, std::string(statements::krawczyks_theorem.statement)});
  const real_system system(what.f);
  std::vector<rational_box> roots;
  for (std::size_t k = 0; k < count; ++k) {
    const std::vector<ball> fine = refine(system, found.regions[k], digits + more_digits).enclosure;
    rational_box root;
    for (std::size_t i = 0; i < n; ++i) {
      const double size = detail::log2_of(ball(range[i].second - range[i].first, 64)).value_or(0);
      ball number = detail::widened(fine[i], detail::widening(fine[i], size, digits), digits);
      root.emplace_back(lower_rational(number), upper_rational(number));
      c.numbers.push_back(
          {fmt::format("root_{}_{}", k + 1, variables[i]), std::move(number), digits});
    }
    roots.push_back(std::move(root));
  }
  json boxes = json::array();
  const box_search search(system, range, roots, p);
  for (std::size_t k = 0; k < count; ++k) {
    const auto around = search.around(k);
    if (!around) {
      throw input_error(fmt::format(
          "no certificate: the root {} is on a face of the box, or too near another; a checker "
          "knows only roots inside it",
          point_of(found.regions[k].enclosure)));
    }
    json entry = json::array();
    for (const auto& [lower, upper] : *around) {
      entry.push_back(json{{"lower", to_text(lower)}, {"upper", to_text(upper)}});
    }
    boxes.push_back(std::move(entry));
  }
  c.witness["boxes"] = std::move(boxes);
  c.verdict = status::certified;
  return to_json(c, inputs);
}

}  // namespace polhode
