#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "polhode/expression/library_functions.hpp"

#ifdef POLHODE_WITH_ARB
#include "definition.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/expression/expression.hpp"
#endif

namespace polhode {

#ifdef POLHODE_WITH_ARB
namespace arb_functions_impl {

// ---------------------------------------------------------------------------------------------
// Values

complex_ball value_of(const definition& f, const call& x, precision p) {
  if (x.order != nullptr && !x.order->is_exact() && f.over_order != nullptr) {
    const magnitude slope = f.over_order(x);
    if (!slope.is_infinite()) {
      const ball middle = x.order->middle();
      complex_ball result =
          value_of(f, {&middle, x.z}, p).enlarged(multiply_up(x.order->radius(), slope));
      if (x.is_real()) result.im = ball(0, p);
      return result;
    }
  }
  const arb_number z(x.z);
  std::optional<arb_number> order;
  if (x.order != nullptr) order.emplace(complex_ball(*x.order));
  arb_number r;
  const precision most = 16 * p + 4096;
  constexpr long gain = 4;  // in bits: less is none
  long before = -ARF_PREC_EXACT;
  for (precision working = p + 32; working <= most; working *= 2) {
    f.value(r.get(), order ? order->get() : nullptr, z.get(), working);
    const long known = r.accuracy();
    const bool may_gain = x.z.is_exact() && (order ? known <= 0 : true);
    if (known >= p || (!may_gain && known <= before + gain)) break;
    before = known;
  }
  complex_ball result = r.to_complex_ball(p);
  if (x.is_real()) result.im = ball(0, p);
  return result;
}

namespace {
/// f on the rectangle z, on which it is analytic.
complex_ball value_over(const definition& f, const call& x, precision p) {
  if (f.over == nullptr || x.z.is_exact()) return value_of(f, x, p);
  const bounds b = f.over(x);
  if (b.slope.is_infinite() && b.size.is_infinite()) {
    // Over sets far out Arb may take hours.
    constexpr int far = 40;
    const bool is_far = magnitude::power_of_two(far) <= x.z.magnitude_upper();
    return is_far ? complex_ball::undefined(p) : value_of(f, x, p);
  }
  const complex_ball middle = value_of(f, {x.order, x.z.middle()}, p);
  const magnitude error = multiply_up(add_up(x.z.re.radius(), x.z.im.radius()), b.slope);
  const bool is_far = b.size <= error || !middle.is_bounded();
  complex_ball result = is_far ? complex_ball(0, p).enlarged(b.size) : middle.enlarged(error);
  if (x.is_real()) result.im = ball(0, p);
  return result.re.is_bounded() ? result : complex_ball::undefined(p);
}
}  // namespace

complex_ball value_or_undefined(const definition& f, const call& x, precision p) {
  if (!x.z.is_bounded() || f.in_the_way(x) != obstacle::none) return complex_ball::undefined(p);
  return value_over(f, x, p);
}

// ---------------------------------------------------------------------------------------------
// What is said of them

obstacle left_half(const call& x) {
  if (certainly_positive(x.z.re)) return obstacle::none;
  return certainly_negative(x.z.re) ? obstacle::unknown : obstacle::branch_cut;
}
obstacle poles_of_gamma(const call& x) {
  if (certainly_positive(x.z.re) || !contains_zero(x.z.im)) return obstacle::none;
  return holds_no_integer(x.z.re) ? obstacle::none : obstacle::pole;
}
bool is_whole(const ball& order) {
  return order.is_exact() && denominator(lower_rational(order)) == 1;
}
leading leading_term(std::string main, std::string rest) {
  return further_function::leading_formula{std::move(main), std::move(rest)};
}
leading oscillating_beside(std::string main, std::string rest) {
  return further_function::leading_formula{std::move(main), std::move(rest), true};
}
leading not_defined() { return leading_term("log(x)", "1"); }
majorant steady(std::string text) { return further_function::majorant_formula{std::move(text)}; }
majorant oscillating(std::string text) {
  return further_function::majorant_formula{std::move(text), true};
}

ball upper_of(const magnitude& x) { return ball(0, few_bits).enlarged(x); }
ball greatest_size(const ball& t) {
  return {upper_rational(upper_of(t.magnitude_upper())), few_bits};
}
ball least_of(const ball& t) {
  detail::mpfr_cell lower(few_bits);
  t.lower(lower.get());
  return ball(lower.get());
}

bool is_number(const std::optional<pi_combination>& x) { return x && x->is_rational(); }
bool is_exactly(const std::optional<pi_combination>& x, long n) {
  return is_number(x) && x->q == n;
}
bool last_is_positive(known_arguments x) { return !is_number(x.back()) || x.back()->q > 0; }

namespace {
const std::vector<definition>& all() {
  static const std::vector<definition> functions = [] {
    std::vector<definition> made;
    for (auto* make : {bessel_functions, airy_functions, exponential_integrals, error_functions,
                       other_functions}) {
      std::vector<definition> some = make();
      made.insert(made.end(), std::make_move_iterator(some.begin()),
                  std::make_move_iterator(some.end()));
    }
    return made;
  }();
  return functions;
}
}  // namespace

const definition& named(std::string_view name) {
  return *std::find_if(all().begin(), all().end(),
                       [&](const definition& f) { return f.what.name == name; });
}

// ---------------------------------------------------------------------------------------------
// As functions of formulas

namespace {

template <class T>
call call_of(const definition& f, std::span<const T> x, std::vector<ball>& order) {
  const auto set = [](const T& t) {
    if constexpr (std::same_as<T, region>) {
      return t.to_complex_ball();
    } else {
      return complex_ball(t);
    }
  };
  const complex_ball z = set(x.back());
  if (!f.has_order) return {nullptr, z};
  const complex_ball first = set(x.front());
  // Of a real order only.
  order.push_back(sign_of(first.im) == certain_sign::zero ? first.re
                                                          : ball::undefined(z.precision()));
  return {&order.back(), z};
}

region over_region(const definition& f, std::span<const region> x) {
  std::vector<ball> order;
  const call at = call_of(f, x, order);
  const region& z = x.back();
  if (at.order != nullptr && !at.order->is_bounded()) {
    return region::blocked(obstacle::unknown, f.what.name);
  }
  if (!at.z.is_bounded()) return region::blocked(obstacle::undefined, f.what.name);
  const obstacle why = f.in_the_way(at);
  if (why != obstacle::none) return region::blocked(why, f.what.name);
  const precision p = z.is_in_hardware() ? few_bits : z.precision();
  const complex_ball value = value_over(f, at, p);
  if (!value.is_bounded()) return region::blocked(obstacle::undefined, f.what.name);
  return z.is_in_hardware() ? region(value) : region::in_balls(value);
}

/// The gradient by the formula of the derivative, which is read once; there is none in the order.
class gradient_by_formula {
 public:
  explicit gradient_by_formula(const definition& f) : f_(f), slope_(std::make_shared<once>()) {}

  std::vector<ball> operator()(std::span<const ball> x) const {
    precision p = few_bits;
    for (const ball& t : x) p = std::max(p, t.precision());
    std::vector<ball> gradient(x.size(), ball::undefined(p));
    if (f_.slope_over != nullptr) {
      gradient.back() = f_.slope_over(f_.has_order ? &x[0] : nullptr, x.back());
      return gradient;
    }
    std::call_once(slope_->flag, [this] {
      slope_->formula.emplace(f_.slope,
                              expression_names{argument_names(f_.what), {}, library_functions()});
    });
    gradient.back() = slope_->formula->evaluator<ball>(p)(std::vector<ball>(x.begin(), x.end()));
    return gradient;
  }

 private:
  struct once {
    std::once_flag flag;
    std::optional<expression> formula;
  };
  const definition& f_;
  std::shared_ptr<once> slope_;
};

/// Bounded, and not as narrow as sets are for which the mean value theorem serves as well.
bool is_wide(const ball& x) {
  constexpr int narrow = 16;  // in bits
  return x.is_bounded() && x.magnitude_upper() <= scale(x.radius(), narrow);
}

further_function function_of(const definition& f) {
  further_function result;
  result.what = f.what;
  result.arity = f.has_order ? 2 : 1;
  const auto at_sets = [&f](auto x, auto&& then) {
    std::vector<ball> order;
    const call at = call_of(f, x, order);
    precision p = at.z.precision();
    for (const auto& t : x) p = std::max(p, t.precision());
    if (at.order != nullptr && !at.order->is_bounded()) return complex_ball::undefined(p);
    return then(at, p);
  };
  result.value = [&f, at_sets](std::span<const ball> x) {
    const ball* order = f.has_order ? &x[0] : nullptr;
    const ball& z = x.back();
    const precision bits = z.precision();
    if (f.is_monotonic != nullptr && is_wide(z) && f.is_monotonic(order, z)) {
      return at_ends(
          [&](const ball& t) {
            return value_or_undefined(f, {order, complex_ball(t)}, bits).re;
          },
          z, bits);
    }
    if (f.over_reals != nullptr) return f.over_reals(order, z, bits);
    return at_sets(x, [&](const call& at, precision p) { return value_or_undefined(f, at, p); }).re;
  };
  result.over_complex = [&f, at_sets](std::span<const complex_ball> x) {
    return at_sets(x, [&](const call& at, precision p) { return value_or_undefined(f, at, p); });
  };
  result.slope = f.slope;
  result.gradient = gradient_by_formula(f);
  result.over_regions = [&f](std::span<const region> x) { return over_region(f, x); };
  result.may_be_defined = f.may_be_defined;
  if (f.is_nowhere_defined != nullptr) {
    result.natural_range = [&f, value = result.value](std::span<const ball> x) {
      const ball* order = f.has_order ? x.data() : nullptr;
      if (f.is_nowhere_defined(order, x.back())) return std::optional<ball>();
      ball range = value(x);
      const bool is_partial = !range.is_bounded() && f.where_defined != nullptr;
      if (is_partial && x.back().is_bounded()) range = f.where_defined(order, x.back());
      return std::optional(std::move(range));
    };
  }
  result.simpler = f.simpler;
  // A formula that depends on the order and on the sign of x.
  const auto set = [&f](auto& formulas, auto* known) {
    if (known == nullptr) return;
    formulas = [&f, known](std::span<const ball> orders, int sign) {
      using result_type = decltype(known(nullptr, sign));
      if (!f.has_order) return known(nullptr, sign);
      return orders[0].is_bounded() ? known(&orders[0], sign) : result_type();
    };
  };
  set(result.near_zero, f.near_zero);
  set(result.near_infinity, f.near_infinity);
  set(result.majorant, f.bound);
  if (f.at_pole != nullptr) {
    result.at_pole = [&f](std::span<const ball> orders, long k) {
      return f.at_pole(f.has_order ? orders.data() : nullptr, k);
    };
  }
  if (f.numerator != nullptr) {
    result.numerator = f.numerator;
    result.divisor = f.divisor;
  }
  return result;
}

}  // namespace
}  // namespace arb_functions_impl
#endif

std::shared_ptr<const further_functions> arb_functions() {
  static const auto functions = [] {
    auto made = std::make_shared<further_functions>();
#ifdef POLHODE_WITH_ARB
    for (const auto& f : arb_functions_impl::all()) {
      made->push_back(arb_functions_impl::function_of(f));
    }
    made->push_back(arb_functions_impl::digamma_function());
#endif
    return std::shared_ptr<const further_functions>(std::move(made));
  }();
  return functions;
}

std::shared_ptr<const further_functions> library_functions() {
  static const auto functions = [] {
    auto made = std::make_shared<further_functions>(*elliptic_functions());
    made->insert(made->end(), arb_functions()->begin(), arb_functions()->end());
    return std::shared_ptr<const further_functions>(std::move(made));
  }();
  return functions;
}

}  // namespace polhode
