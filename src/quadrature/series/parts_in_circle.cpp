#include <utility>

#include "parts_by_variable.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "quadrature/formula/formula_graph.hpp"

namespace polhode::detail {

namespace {

constexpr long greatest_multiple = 8;  // of an angle
constexpr long most_pieces = 32;

class in_circle {
 public:
  explicit in_circle(const formula_range& of) : f_(of.f), a_(of.a), b_(of.b), plain_(of.plain) {}

  /// By quarters of a period: y = sin^2 w', where w = k pi/2 + w'. By halves: y = sin^2(w'/2),
  /// where w = (k - shift/2) pi + w'. So y grows with w.
  bool add(std::size_t node, bool by_quarters, int shift,
           hyperexponential_integrals& result) const {
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
      tiling.add({from_a ? piece_end::lower_end() : piece_end(k),
                  to_b ? piece_end::upper_end() : piece_end(k + 1)},
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
                              return circular(f_.node(i).what, n, odd, both, inside);
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

 private:
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
    const formula_node& node = f_.node(i);
    if (!node.is_circular()) return std::nullopt;
    const auto w = affine_of((*plain_)[node.left]);
    if (!w || w->offset != 0) return std::nullopt;
    const bool of_pi = node.what == operation::sinpi || node.what == operation::cospi;
    return frequency{w->slope, of_pi};
  }

  struct sine_and_cosine {
    hyperexponential_sum sine;
    hyperexponential_sum cosine;
  };
  static hyperexponential_sum scaled(const hyperexponential_sum& f, long factor) {
    hyperexponential_sum result = f;
    for (hyperexponential& term : result) term.coefficient *= factor;
    return result;
  }
  /// Of w = k pi/2 + w', y = sin^2 w'.
  static sine_and_cosine quarter(long k) {
    const hyperexponential_sum inner_sine{power_of_variable(rational(1, 2))};
    const hyperexponential_sum inner_cosine{power_of_complement(rational(1, 2))};
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
    const hyperexponential_sum inner_sine{
        product(number(2),
                product(power_of_variable(rational(1, 2)), power_of_complement(rational(1, 2))))};
    const hyperexponential_sum inner_cosine{
        apart.of_polynomial(rational_polynomial({rational(1), rational(-2)}))};
    const long sign = k % 2 == 0 ? 1 : -1;
    if (shift == 0) return {scaled(inner_sine, sign), scaled(inner_cosine, sign)};
    return {scaled(inner_cosine, -sign), scaled(inner_sine, sign)};
  }
  /// The function of n w, with its sign changed where it is odd and that is asked for.
  static maybe_sum circular(operation rule, const rational& n, bool negative,
                            const sine_and_cosine& of_w, const rational& inside) {
    if (!is_integer(n) || n > greatest_multiple) return std::nullopt;
    const taking_apart apart(inside);
    // f(n w) = 2 cos w f((n - 1) w) - f((n - 2) w)
    maybe_sum sine = of_w.sine;
    maybe_sum cosine = of_w.cosine;
    maybe_sum last_sine;  // 0
    maybe_sum last_cosine = hyperexponential_sum{number(1)};
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
    if (rule == operation::cos || rule == operation::cospi) return cosine;
    if (rule == operation::sin || rule == operation::sinpi) return scaled(*sine, sign);
    const maybe_sum inverse = apart.raised(*cosine, -1);
    return inverse ? apart.multiplied(scaled(*sine, sign), *inverse) : std::nullopt;
  }

  const formula_graph& f_;
  const end_point& a_;
  const end_point& b_;
  const forms* plain_;
};

}  // namespace

bool add_in_sine_squared(const formula_range& of, std::size_t node,
                         hyperexponential_integrals& result) {
  return in_circle(of).add(node, true, 0, result);
}

bool add_in_sine_of_half(const formula_range& of, std::size_t node,
                         hyperexponential_integrals& result) {
  if (in_circle(of).add(node, false, 0, result)) return true;
  result.clear();
  return in_circle(of).add(node, false, 1, result);
}

}  // namespace polhode::detail
