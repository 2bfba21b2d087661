#include "taylor_series.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "panel_choice.hpp"
#include "panel_integral.hpp"
#include "quadrature/base/approximate.hpp"
#include "quadrature/formula/formula_graph.hpp"
#include "quadrature/formula/periods.hpp"
#include "taylor_ranges.hpp"
#include "tiling/tiling.hpp"

namespace polhode::detail {

namespace {

using clock = std::chrono::steady_clock;

/// One attempt at the sum of all parts.
class taylor_sum {
 public:
  taylor_sum(const formula_graph& f, const std::vector<hyperexponential_integral>& parts,
             const integrate_options& options)
      : f_(f), parts_(parts), options_(options) {}

  /// To about 2^-bits of the greatest part, or to the absolute goal. Returns nullopt where it is
  /// not found, or where the pieces are not proved to tile their ranges.
  std::optional<ball> to(double bits) {
    struct covered_range {
      const smooth_range* range;
      std::vector<taylor_panel> panels;
    };
    std::vector<finite_ranges> prepared;
    std::vector<std::vector<covered_range>> covered;
    std::vector<double> log2_constants;
    double size = -infinite;
    for (const hyperexponential_integral& part : parts_) {
      const hyperexponential& h = part.function;
      if (h.coefficient == 0) return std::nullopt;
      const double constant = estimated_log2(h.constant(f_, 64).magnitude_upper());
      if (!std::isfinite(constant)) return std::nullopt;
      log2_constants.push_back(constant);
      auto one = ranges_of(part, bits);
      if (!one) return std::nullopt;
      prepared.push_back(std::move(*one));
    }
    long count = 0;
    for (std::size_t i = 0; i < prepared.size(); ++i) {
      covered.emplace_back();
      for (const smooth_range& range : prepared[i].ranges) {
        panel_choice choice(range, bits);
        auto panels = choice.panels();
        if (!panels) return std::nullopt;
        size = std::max(size, log2_constants[i] + choice.log2_of_size(*panels));
        count += static_cast<long>(panels->size());
        covered.back().push_back({&range, std::move(*panels)});
      }
    }
    if (!(std::abs(size) < 1e15)) return std::nullopt;
    double goal = size - bits;
    if (options_.absolute_exponent) {
      goal = std::max(goal, static_cast<double>(*options_.absolute_exponent) - 2);
    }
    goal -= std::log2(static_cast<double>(count)) + 1;
    const auto result_bits = static_cast<precision>(std::max(size - goal, 0.0)) + 64;
    const precision most_bits =
        options_.most_precision.value_or(static_cast<precision>(64 * (bits + 64)));
    ball total(0, result_bits);
    for (std::size_t i = 0; i < prepared.size(); ++i) {
      const double own_goal = goal - log2_constants[i];
      tiled_sum<ball> of_part(parts_[i].lower, parts_[i].upper, ball(0, result_bits));
      for (const bounded_part& rest : prepared[i].rests) {
        of_part.add(rest.done, rest.within, rest.value.with_precision(result_bits));
      }
      for (const covered_range& own : covered[i]) {
        const smooth_range& range = *own.range;
        tiled_sum<ball> of_range(range.lower, range.upper, ball(0, result_bits));
        for (const taylor_panel& panel : own.panels) {
          if (!add_panel(of_range, range, panel, own_goal, most_bits, 0)) return std::nullopt;
        }
        const std::optional<ball> value = of_range.total();
        if (!value) return std::nullopt;
        of_part.add_tiled(range.piece(), *value);
      }
      const std::optional<ball> value = of_part.total();
      if (!value) return std::nullopt;
      total += *value * parts_[i].function.constant(f_, result_bits);
    }
    if (!total.is_bounded()) return std::nullopt;
    return total;
  }
  [[nodiscard]] const integral_account& account() const { return account_; }

 private:
  /// Adds the integral over a panel, by its halves where that is needed. Returns false where it is
  /// not found.
  bool add_panel(tiled_sum<ball>& sum, const smooth_range& range, const taylor_panel& panel,
                 double goal, precision most_bits, int depth) {
    panel_integral own(range, panel);
    const long left = options_.most_evaluations - account_.terms;
    if (const std::optional<panel_value> found = own.to(goal, most_bits, left)) {
      sum.add(found->done, panel.interval(), found->value);
      ++account_.panels;
      account_.terms += own.terms();
      account_.most_nodes = std::max(account_.most_nodes, own.terms());
      account_.precision = std::max<precision>(account_.precision, own.bits());
      return true;
    }
    constexpr int deepest = 8;
    if (depth >= deepest || left <= 0) return false;
    const auto halves = cut_to(range, halves_of(panel));
    return halves && std::all_of(halves->begin(), halves->end(), [&](const taylor_panel& half) {
             return add_panel(sum, range, half, goal - 1, most_bits, depth + 1);
           });
  }

  const formula_graph& f_;
  const std::vector<hyperexponential_integral>& parts_;
  const integrate_options& options_;
  integral_account account_;
};

}  // namespace

std::optional<integral> integrate_by_taylor_series(const integrand& f, const end_point& a,
                                                   const end_point& b,
                                                   const integrate_options& options) {
  if (!f.graph) return std::nullopt;
  const auto start = clock::now();
  const std::shared_ptr<const formula_graph> graph = f.graph();
  // Of many periods one is enough, and panels know that.
  if (options.rule.is_automatic() && whole_periods_of(f, a, b)) return std::nullopt;
  const auto parts = hyperexponential_parts(*graph, a, b);
  if (!parts || parts->empty()) return std::nullopt;
  const double digits = static_cast<double>(options.digits) * std::log2(10.0);
  double bits = digits + 6;
  for (int attempts = 0; attempts < 4; ++attempts) {
    taylor_sum sum(*graph, *parts, options);
    const std::optional<ball> value = sum.to(bits);
    if (!value) return std::nullopt;
    const magnitude radius = value->radius();
    if (options.goal().is_met_by(*value)) {
      integral result;
      result.enclosure = *value;
      result.verdict = status::certified;
      result.account = sum.account();
      result.account.rules = {quadrature_rule::taylor_series};
      result.account.seconds_for_sums = std::chrono::duration<double>(clock::now() - start).count();
      return result;
    }
    // The value is smaller than its parts, or their bounds are larger than was expected.
    const double missing =
        estimated_log2(radius) + digits - estimated_log2(value->magnitude_upper());
    if (!(missing < digits + 64)) return std::nullopt;
    bits += std::max(missing, 0.0) + 8;
  }
  return std::nullopt;
}

}  // namespace polhode::detail
