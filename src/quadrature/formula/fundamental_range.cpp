#include "quadrature/formula/fundamental_range.hpp"

#include "quadrature/formula/symmetry.hpp"

namespace polhode::detail {

std::optional<fundamental_range> fundamental_range_of(const integrand& f, const end_point& a,
                                                      const end_point& b) {
  if (!f.under || !a.form() || !b.form() || *a.form() == *b.form()) return std::nullopt;
  const auto is_even_about = [&](const pi_combination& x) {
    return f.under(symmetry::reflection(x)).is_invariant();
  };
  const auto has_period = [&](const pi_combination& x) {
    return f.under(symmetry::translation(x)).is_invariant();
  };
  fundamental_range range{*a.form(), *b.form(), 0};
  const bool even = is_even_about(range.a) && is_even_about(range.b);
  if (!even && !has_period(range.b - range.a)) return std::nullopt;
  // Even about the middle, or with a half of the range for a period: half of the range has half of
  // the integral, and again one of the two symmetries. For if f is even about b, or has the period
  // b - a, evenness about the middle makes it even about a too.
  constexpr long most_halvings = 10;
  while (range.log2_copies < most_halvings) {
    const pi_combination middle = (range.a + range.b) * rational(1, 2);
    if (!is_even_about(middle) && !has_period(middle - range.a)) break;
    range.b = middle;
    ++range.log2_copies;
  }
  return range;
}

}  // namespace polhode::detail
