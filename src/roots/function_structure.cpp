#include "polhode/roots/function_structure.hpp"

#include <algorithm>
#include <utility>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {

std::optional<ball> detail::natural_power(const ball& x, const ball& y) {
  const precision p = std::min(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  // Of numbers that are not positive, the whole powers are defined too: few of them are taken one
  // by one. (0^0 is none of natural_domain's, so 0 is among these.)
  std::optional<ball> range = natural_domain::pow(x, y);
  const bool is_whole_range = lower(x) > 0 || (lower(x) >= 0 && lower(y) > 0);
  if (is_whole_range) return range;
  constexpr long most_powers = 8;
  if (!y.is_bounded()) return pow(x, y);
  const integer last = floor_of(upper_rational(y));
  const integer first = ceil_of(lower_rational(y));
  if (first <= last &&
      (last - first >= most_powers || abs(first) > most_powers || abs(last) > most_powers)) {
    return pow(x, y);
  }
  for (auto n = static_cast<long>(first); n <= static_cast<long>(last); ++n) {
    const std::optional<ball> power = natural_domain::pow(x, n);
    if (!power) continue;
    range = range ? hull(*range, *power) : *power;
  }
  return range;
}

function_structure::exact_series detail::exact_power(const function_structure::exact_series& x,
                                                     const function_structure::exact_series& y) {
  // 0^y is 0 for y > 0, without a derivative as far as is known.
  if (x[0].is_exactly(0) && y[0].exact() && *y[0].exact() > 0) {
    return function_structure::value_alone(x, x[0].like(0));
  }
  return exp(y * log(x));
}

namespace {

using structure_product = function_structure::product;
using structure_factor = function_structure::factor;

void multiply_factors(std::vector<structure_factor>& factors,
                      const std::vector<structure_factor>& more) {
  for (const structure_factor& g : more) {
    const auto same = std::find_if(factors.begin(), factors.end(),
                                   [&](const structure_factor& h) { return h.id == g.id; });
    if (same == factors.end()) {
      factors.push_back(g);
    } else {
      same->power += g.power;
      same->is_branch = same->is_branch || g.is_branch;
    }
  }
}

structure_product multiplied(const structure_product& x, const structure_product& y, long id) {
  structure_product r{id, x.factors, x.over * y.over, x.at_point * y.at_point};
  multiply_factors(r.factors, y.factors);
  r.is_defined_at_zeros = x.is_defined_at_zeros && y.is_defined_at_zeros;
  return r;
}

}  // namespace

function_structure function_structure::variable(const ball& box, const ball& point) {
  function_structure x;
  x.ids_ = std::make_shared<long>(1);
  x.numerator_.id = 1;
  x.numerator_.over = jet<ball, 1>::variable(box);
  x.numerator_.at_point = point;
  x.numerator_.factors = {{1, 1, x.numerator_.over, point}};
  x.numerator_.is_defined_at_zeros = true;
  x.natural_ = box;
  return x;
}

function_structure function_structure::variable_at(const known_number& c, int order) {
  function_structure x = variable(c.enclosure(), c.enclosure());
  x.series_ = exact_series::variable(c, order);
  return x;
}

jet<ball, 1> function_structure::over() const {
  return denominator_ ? numerator_.over / denominator_->over : numerator_.over;
}
ball function_structure::at_point() const {
  return denominator_ ? numerator_.at_point / denominator_->at_point : numerator_.at_point;
}

function_structure function_structure::fresh(jet<ball, 1> over, ball at_point,
                                             bool never_zero) const {
  function_structure r;
  r.ids_ = ids_;
  r.divisors_ = divisors_;
  r.numerator_.id = ++*ids_;
  if (!never_zero) r.numerator_.factors = {{r.numerator_.id, 1, over, at_point}};
  r.numerator_.is_defined_at_zeros = !over[0].is_undefined();
  r.numerator_.over = std::move(over);
  r.numerator_.at_point = std::move(at_point);
  return r;
}

// Proof of is_defined_at_zeros. A product with one vanishing factor g is made of parts that are
// defined all over the box, and of parts such as sqrt(u) where u has a vanishing factor: that is g,
// and at its zeros u is 0, where the part is defined, if its denominator is not 0 there. A u
// without a vanishing factor may be negative there.
function_structure function_structure::with_zeros_of(const function_structure& u) && {
  const auto may_vanish = [](const ball& t) { return t.is_undefined() || contains_zero(t); };
  numerator_.factors = u.numerator_.factors;
  for (factor& g : numerator_.factors) g.is_branch = true;
  if (std::any_of(numerator_.factors.begin(), numerator_.factors.end(),
                  [&](const factor& g) { return may_vanish(g.over[0]); })) {
    numerator_.is_defined_at_zeros = u.numerator_.is_defined_at_zeros &&
                                     !(u.denominator_ && may_vanish(u.denominator_->over[0]));
  }
  return std::move(*this);
}

function_structure function_structure::constant(const ball& c) const {
  function_structure r = fresh(jet<ball, 1>::constant(c), c, !contains_zero(c));
  r.natural_ = c;
  return r;
}
function_structure function_structure::constant_like(const known_number& c) const {
  function_structure r = constant(c.enclosure());
  if (series_) r.series_ = exact_series::constant(c, series_->order());
  return r;
}

function_structure::exact_series function_structure::value_alone(const exact_series& like,
                                                                 const known_number& value) {
  exact_series r = exact_series::constant(value, like.order());
  for (int k = 1; k <= r.order(); ++k) {
    r[k] = known_number(ball::undefined(value.enclosure().precision()));
  }
  return r;
}

function_structure operator-(const function_structure& x) {
  function_structure r = x;  // the same factors
  r.numerator_.id = ++*x.ids_;
  r.numerator_.over = -x.numerator_.over;
  r.numerator_.at_point = -x.numerator_.at_point;
  if (x.natural_) r.natural_ = -*x.natural_;
  if (x.series_) r.series_ = -*x.series_;
  return r;
}

function_structure operator+(const function_structure& x, const function_structure& y) {
  // n/d + m/d = (n + m)/d, n/d + m/e = (ne + md)/(de).
  jet<ball, 1> over = x.numerator_.over;
  ball at_point = x.numerator_.at_point;
  std::optional<structure_product> denominator = x.denominator_;
  if (x.denominator_ && y.denominator_ && x.denominator_->id == y.denominator_->id) {
    over += y.numerator_.over;
    at_point += y.numerator_.at_point;
  } else {
    if (y.denominator_) {
      over *= y.denominator_->over;
      at_point *= y.denominator_->at_point;
    }
    if (x.denominator_) {
      over += y.numerator_.over * x.denominator_->over;
      at_point += y.numerator_.at_point * x.denominator_->at_point;
    } else {
      over += y.numerator_.over;
      at_point += y.numerator_.at_point;
    }
    if (y.denominator_) {
      denominator = x.denominator_ ? multiplied(*x.denominator_, *y.denominator_, ++*x.ids_)
                                   : *y.denominator_;
    }
  }
  function_structure r = x.fresh(std::move(over), std::move(at_point), false);
  r.add_divisors(y.divisors_);
  r.denominator_ = std::move(denominator);
  if (x.natural_ && y.natural_) r.natural_ = *x.natural_ + *y.natural_;
  if (x.series_ && y.series_) r.series_ = *x.series_ + *y.series_;
  return r;
}
function_structure operator-(const function_structure& x, const function_structure& y) {
  return x + (-y);
}

namespace {

/// The series with 0 for its first coefficients where they are exactly that: before they are
/// multiplied by others, as the formula of a product is longer.
function_structure::exact_series with_zeros(function_structure::exact_series s) {
  for (int k = 0; k <= s.order(); ++k) {
    known_number exactly = settled(s[k]);
    if (!exactly.is_zero()) break;
    s[k] = std::move(exactly);
  }
  return s;
}

}  // namespace

function_structure operator*(const function_structure& x, const function_structure& y) {
  function_structure r;
  r.ids_ = x.ids_;
  r.divisors_ = x.divisors_;
  r.add_divisors(y.divisors_);
  r.numerator_ = multiplied(x.numerator_, y.numerator_, ++*x.ids_);
  if (x.denominator_ && y.denominator_) {
    r.denominator_ = multiplied(*x.denominator_, *y.denominator_, ++*x.ids_);
  } else {
    r.denominator_ = x.denominator_ ? x.denominator_ : y.denominator_;
  }
  if (x.natural_ && y.natural_) {
    const bool same = x.numerator_.id == y.numerator_.id &&
                      x.denominator_.has_value() == y.denominator_.has_value() &&
                      (!x.denominator_ || x.denominator_->id == y.denominator_->id);
    r.natural_ = same ? square(*x.natural_) : *x.natural_ * *y.natural_;
  }
  if (x.series_ && y.series_) r.series_ = with_zeros(*x.series_) * with_zeros(*y.series_);
  return r;
}

function_structure operator/(const function_structure& x, const function_structure& y) {
  function_structure r;
  r.ids_ = x.ids_;
  r.divisors_ = x.divisors_;
  r.add_divisors(y.divisors_);
  const structure_product& divisor = y.numerator_;
  for (const structure_factor& g : divisor.factors) r.divisors_.insert(g.id);
  // (n/d) / (m/e) = (n e) / (d m). The e is one more condition: y is not defined where it vanishes.
  r.numerator_ =
      y.denominator_ ? multiplied(x.numerator_, *y.denominator_, ++*x.ids_) : x.numerator_;
  if (x.denominator_) {
    r.denominator_ = multiplied(*x.denominator_, divisor, ++*x.ids_);
  } else {
    r.denominator_ = divisor;
  }
  if (x.natural_ && y.natural_) r.natural_ = natural_domain::divide(*x.natural_, *y.natural_);
  if (x.series_ && y.series_) r.series_ = with_zeros(*x.series_) / *y.series_;
  // At the point of the series, the only one of the box that is meant.
  if (y.series_ && settled((*y.series_)[0]).is_zero()) r.natural_.reset();
  return r;
}

function_structure pow(const function_structure& x, long n) {
  if (n == 0) {
    function_structure one = x.constant_like(rational(1));
    if (!x.natural_ || x.over()[0].is_undefined()) one.natural_ = x.natural_;
    if (x.over()[0].is_undefined()) {  // 1 where x is defined, but nothing is known where not
      one.numerator_.over[0] = ball::undefined(x.numerator_.at_point.precision());
      one.numerator_.is_defined_at_zeros = false;
    }
    return one;
  }
  constexpr long most_power = 1L << 40;
  const auto bits = static_cast<unsigned long>(n);
  const auto m = static_cast<long>(
      std::min(n < 0 ? 0UL - bits : bits, static_cast<unsigned long>(most_power) + 1));
  const auto raised = [&](const structure_product& g) {
    structure_product r{++*x.ids_, g.factors, pow(g.over, m), pow(g.at_point, m)};
    r.over[0] = pow(g.over[0], m);
    r.is_defined_at_zeros = g.is_defined_at_zeros;
    for (structure_factor& h : r.factors) h.power *= m;
    return r;
  };
  const auto too_high = [&](const std::vector<structure_factor>& factors) {
    return m > most_power ||
           std::any_of(factors.begin(), factors.end(),
                       [](const structure_factor& h) { return h.power > (1L << 20); });
  };
  function_structure r;
  if (too_high(x.numerator_.factors) ||
      (x.denominator_ && too_high(x.denominator_->factors))) {  // powers would overflow
    r = x.fresh(pow(x.over(), n), pow(x.at_point(), n), false);
  } else {
    r.ids_ = x.ids_;
    r.divisors_ = x.divisors_;
    r.numerator_ = raised(x.numerator_);
    if (x.denominator_) r.denominator_ = raised(*x.denominator_);
    if (n < 0) {
      for (const structure_factor& g : x.numerator_.factors) r.divisors_.insert(g.id);
      const structure_product top =
          r.denominator_ ? *r.denominator_ : x.constant_like(rational(1)).numerator_;
      r.denominator_ = r.numerator_;
      r.numerator_ = top;
    }
  }
  if (x.natural_) r.natural_ = natural_domain::pow(*x.natural_, n);
  if (x.series_) r.series_ = pow(*x.series_, n);
  return r;
}

function_structure square(const function_structure& x) { return pow(x, 2); }

// Those that are defined everywhere.
#define POLHODE_ENTIRE(f, never_zero)                                                          \
  function_structure f(const function_structure& x) {                                          \
    const auto apply = [](const auto& t) { return f(t); };                                     \
    return function_structure::applied(                                                        \
        x, apply, [](const ball& t) { return std::optional<ball>(f(t)); }, apply, never_zero); \
  }
POLHODE_ENTIRE(exp, true)
POLHODE_ENTIRE(sin, false)
POLHODE_ENTIRE(cos, false)
POLHODE_ENTIRE(atan, false)
POLHODE_ENTIRE(sinh, false)
POLHODE_ENTIRE(cosh, true)
POLHODE_ENTIRE(tanh, false)
POLHODE_ENTIRE(asinh, false)
#undef POLHODE_ENTIRE
#define POLHODE_PARTIAL(f)                                                    \
  function_structure f(const function_structure& x) {                         \
    const auto apply = [](const auto& t) { return f(t); };                    \
    return function_structure::applied(                                       \
        x, apply, [](const ball& t) { return natural_domain::f(t); }, apply); \
  }
POLHODE_PARTIAL(log)
POLHODE_PARTIAL(asin)
POLHODE_PARTIAL(acos)
POLHODE_PARTIAL(acosh)
POLHODE_PARTIAL(atanh)
#undef POLHODE_PARTIAL

function_structure sqrt(const function_structure& x) {
  const auto apply = [](const auto& t) { return sqrt(t); };
  const auto natural = [](const ball& t) { return natural_domain::sqrt(t); };
  return function_structure::applied(x, apply, natural, apply).with_zeros_of(x);
}

#define POLHODE_WITHOUT_SERIES(f, never_zero)                                          \
  function_structure f(const function_structure& x) {                                  \
    return function_structure::applied(                                                \
        x, [](const auto& t) { return f(t); },                                         \
        [](const ball& t) { return std::optional<ball>(f(t)); }, nullptr, never_zero); \
  }
POLHODE_WITHOUT_SERIES(erf, false)
POLHODE_WITHOUT_SERIES(erfc, true)
#undef POLHODE_WITHOUT_SERIES

namespace {

using exact_series = function_structure::exact_series;

/// Whether the function is known to be continuous at the point.
bool is_continuous(const exact_series& s) {
  return s.order() > 0 && !s[1].enclosure().is_undefined();
}

/// floor or ceil, whose value at t is `value`: a constant near a t between two integers.
exact_series step_of(const exact_series& s, const known_number& value) {
  const ball& t = s[0].enclosure();
  const ball below = floor(t);
  const bool is_between =
      below.is_exact() && certainly_less(below, t) && certainly_less(t, below + 1);
  return is_between && is_continuous(s) ? exact_series::constant(value, s.order())
                                        : function_structure::value_alone(s, value);
}

/// The one of the two that is less, or the greater one, in a neighbourhood of the point.
exact_series one_of(const exact_series& s, const exact_series& t, bool lesser) {
  if (is_continuous(s) && is_continuous(t)) {
    if (certainly_less(s[0].enclosure(), t[0].enclosure())) return lesser ? s : t;
    if (certainly_less(t[0].enclosure(), s[0].enclosure())) return lesser ? t : s;
  }
  const auto& a = s[0].exact();
  const auto& b = t[0].exact();
  const known_number value = a && b   ? s[0].like(lesser ? std::min(*a, *b) : std::max(*a, *b))
                             : lesser ? known_number(min(s[0].enclosure(), t[0].enclosure()))
                                      : known_number(max(s[0].enclosure(), t[0].enclosure()));
  return function_structure::value_alone(s, value);
}

/// floor or ceil, of a ball or jet and of an exact number.
template <class OfSet, class OfNumber>
function_structure step(const function_structure& x, const OfSet& of_set,
                        const OfNumber& of_number) {
  return function_structure::applied(
      x, of_set, [&](const ball& t) { return std::optional<ball>(of_set(t)); },
      [&](const exact_series& s) {
        const auto& exact = s[0].exact();
        return step_of(s, exact ? s[0].like(rational(of_number(*exact)))
                                : known_number(of_set(s[0].enclosure())));
      });
}

}  // namespace

function_structure floor(const function_structure& x) {
  return step(
      x, [](const auto& t) { return floor(t); }, [](const rational& t) { return floor_of(t); });
}
function_structure ceil(const function_structure& x) {
  return step(
      x, [](const auto& t) { return ceil(t); }, [](const rational& t) { return ceil_of(t); });
}

function_structure tan(const function_structure& x) { return sin(x) / cos(x); }

function_structure abs(const function_structure& x) {
  return function_structure::applied(
             x, [](const auto& t) { return abs(t); },
             [](const ball& t) { return std::optional<ball>(abs(t)); },
             [](const function_structure::exact_series& s) {
               const auto value = s[0].exact() ? s[0].like(abs(*s[0].exact()))
                                               : known_number(abs(s[0].enclosure()));
               return function_structure::value_alone(s, value);
             })
      .with_zeros_of(x);
}
function_structure min(const function_structure& x, const function_structure& y) {
  return function_structure::applied_to_two(
      x, y, [](const auto& s, const auto& t) { return min(s, t); },
      [](const ball& s, const ball& t) { return std::optional<ball>(min(s, t)); },
      [](const exact_series& s, const exact_series& t) { return one_of(s, t, true); });
}
function_structure max(const function_structure& x, const function_structure& y) {
  return function_structure::applied_to_two(
      x, y, [](const auto& s, const auto& t) { return max(s, t); },
      [](const ball& s, const ball& t) { return std::optional<ball>(max(s, t)); },
      [](const exact_series& s, const exact_series& t) { return one_of(s, t, false); });
}
function_structure pow(const function_structure& x, const function_structure& y) {
  return detail::power_of(x, y, [](const auto& s, const auto& t) { return pow(s, t); });
}

}  // namespace polhode
