#include "contraction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "polhode/expression/evaluation.hpp"

namespace polhode::detail {
namespace contraction_impl {
namespace {

using set = double_interval;

set ends(double low, double high) { return {unchecked{}, low, high}; }
const set whole = ends(-infinity, infinity);
const set not_negative = ends(0, infinity);

/// What an operation that is not known to be defined everywhere on its operands answers.
set known(const set& x) { return x.is_undefined() ? whole : x; }

/// Cuts x down to what it has in common with y; false where that is nothing.
bool meet(set& x, const set& y) {
  const double low = std::max(x.lower(), y.lower());
  const double high = std::min(x.upper(), y.upper());
  if (low > high) return false;
  x = ends(low, high);
  return true;
}
/// The same for the union of two sets.
bool meet_either(set& x, const set& y, const set& z) {
  set first = x;
  set second = x;
  const bool meets_first = meet(first, y);
  const bool meets_second = meet(second, z);
  if (meets_first && meets_second) {
    x = hull(first, second);
  } else if (meets_first || meets_second) {
    x = meets_first ? first : second;
  }
  return meets_first || meets_second;
}

/// The range of an increasing function f over x, with its limits at -inf and inf; f takes points.
template <class F>
set increasing(const F& f, const set& x, double at_minus_infinity, double at_infinity) {
  const double low = x.lower() == -infinity ? at_minus_infinity : f(set(x.lower())).lower();
  const double high = x.upper() == infinity ? at_infinity : f(set(x.upper())).upper();
  return ends(low, high);
}
/// Of an increasing function on all real numbers without a bound.
template <class F>
set increasing(const F& f, const set& x) {
  return increasing(f, x, -infinity, infinity);
}

// Functions over their natural domains; nothing where that has no member in the set.

std::optional<set> common(const set& x, const set& y) {
  set r = x;
  return meet(r, y) ? std::optional(r) : std::nullopt;
}

/// log x, of which -inf is the limit at 0.
std::optional<set> natural_log(const set& x) {
  if (!(x.upper() > 0)) return std::nullopt;
  const auto f = [](const set& t) { return log(t); };
  return increasing(f, x.lower() > 0 ? x : ends(-infinity, x.upper()));
}
std::optional<set> natural_log1p(const set& x) {
  if (!(x.upper() > -1)) return std::nullopt;
  const auto f = [](const set& t) { return log1p(t); };
  return increasing(f, x.lower() > -1 ? x : ends(-infinity, x.upper()));
}
std::optional<set> natural_atanh(const set& x) {
  if (!(x.upper() > -1) || !(x.lower() < 1)) return std::nullopt;
  const auto f = [](const set& t) { return atanh(t); };
  return increasing(
      f, ends(x.lower() > -1 ? x.lower() : -infinity, x.upper() < 1 ? x.upper() : infinity));
}
std::optional<set> natural_sqrt(const set& x) {
  const std::optional<set> inside = common(x, not_negative);
  return inside ? std::optional(sqrt(*inside)) : std::nullopt;
}
std::optional<set> natural_acosh(const set& x) {
  const std::optional<set> inside = common(x, ends(1, infinity));
  if (!inside) return std::nullopt;
  return increasing([](const set& t) { return acosh(t); }, *inside);
}

/// x/y for y other than 0.
std::optional<set> natural_quotient(const set& x, const set& y) {
  if (y.lower() == 0 && y.upper() == 0) return std::nullopt;
  if (y.lower() > 0 || y.upper() < 0) return known(x / y);
  if (y.lower() < 0 && y.upper() > 0) return x.is_exact() && x.lower() == 0 ? x : whole;
  // 1/y has no bound beside 0.
  const set inverse = y.upper() > 0 ? ends(divide_down(1, y.upper()), infinity)
                                    : ends(-infinity, -divide_down(1, -y.lower()));
  return x * inverse;
}

/// Cuts from z what is in no product: z y is in x for a member y.
bool meet_quotient(set& z, const set& x, const set& y) {
  if (!contains_zero(y)) return meet(z, known(x / y));
  if (contains_zero(x)) return true;  // of z any number, with y = 0
  if (y.lower() == 0 && y.upper() == 0) return false;
  if (y.lower() == 0 || y.upper() == 0) return meet(z, *natural_quotient(x, y));
  return meet_either(z, *natural_quotient(x, ends(y.lower(), 0)),
                     *natural_quotient(x, ends(0, y.upper())));
}

/// The least double above pi/2.
const double quarter_turn = next_up(approximation::half_pi);

set natural_exp(const set& x) {
  return increasing([](const set& t) { return exp(t); }, x, 0, infinity);
}
set natural_expm1(const set& x) {
  return increasing([](const set& t) { return expm1(t); }, x, -1, infinity);
}
set natural_sinh(const set& x) {
  return increasing([](const set& t) { return sinh(t); }, x);
}
set natural_asinh(const set& x) {
  return increasing([](const set& t) { return asinh(t); }, x);
}
set natural_tanh(const set& x) {
  return increasing([](const set& t) { return tanh(t); }, x, -1, 1);
}
set natural_atan(const set& x) {
  return increasing([](const set& t) { return atan(t); }, x, -quarter_turn, quarter_turn);
}
/// For x >= 0.
set natural_cosh(const set& x) {
  return increasing([](const set& t) { return cosh(t); }, x, 1, infinity);
}

/// x^n for n >= 1.
set natural_power(const set& x, long n) {
  const auto f = [n](const set& t) { return pow(t, n); };
  if (n % 2 != 0) return increasing(f, x);
  return increasing(f, ends(x.mignitude(), x.magnitude()));
}
/// The n-th root of x >= 0.
set natural_root(const set& x, long n) {
  if (n == 1) return x;
  const auto f = [n](const set& t) {
    if (t.lower() == 0) return set(0);
    return n == 2 ? sqrt(t) : exp(log(t) / n);
  };
  return increasing(f, x);
}

set mirrored(const set& x) { return ends(-x.upper(), -x.lower()); }

/// Cuts from x what has no |x| in y.
bool meet_magnitude(set& x, const set& y) {
  const std::optional<set> size = common(y, not_negative);
  return size && meet_either(x, *size, mirrored(*size));
}

/// Cuts from x what has no x^n in y, for n >= 1.
bool meet_root(set& x, const set& y, long n) {
  if (n % 2 == 0) {
    const std::optional<set> size = common(y, not_negative);
    return size && meet_magnitude(x, natural_root(*size, n));
  }
  const std::optional<set> above = common(y, not_negative);
  const std::optional<set> below = common(mirrored(y), not_negative);
  if (!above) return meet(x, mirrored(natural_root(*below, n)));
  if (!below) return meet(x, natural_root(*above, n));
  return meet(x, hull(mirrored(natural_root(*below, n)), natural_root(*above, n)));
}

/// Cuts from x what is in none of angle + k step, for whole k, and for both signs of the angle if
/// both are asked for.
bool meet_periods(set& x, const set& angle, const set& step, bool both_signs) {
  constexpr double most_periods = 40;
  if (!x.is_bounded() || x.magnitude() > 0x1p20) return true;
  const double first = std::floor(x.lower() / step.lower()) - 1;
  const double last = std::ceil(x.upper() / step.lower()) + 1;
  if (last - first > most_periods) return true;
  std::optional<set> left;
  const auto add = [&](const set& y) {
    if (const std::optional<set> part = common(x, y)) left = left ? hull(*left, *part) : *part;
  };
  for (double k = first; k <= last; ++k) {
    add(set(k) * step + angle);
    if (both_signs) add(set(k) * step - angle);
  }
  if (!left) return false;
  x = *left;
  return true;
}

const set pi_set = ends(2 * approximation::half_pi, 2 * quarter_turn);

/// Beyond what pow(x, n) of doubles is good for.
bool is_huge(long n) { return n > (1L << 30) || n < -(1L << 30); }

/// x^n.
std::optional<set> natural_integer_power(const set& x, long n) {
  if (n == 0) return set(1);
  if (is_huge(n)) return whole;
  return n > 0 ? natural_power(x, n) : natural_quotient(set(1), natural_power(x, -n));
}

/// The real n-th root.
std::optional<set> natural_real_root(const set& x, long n) {
  const std::optional<set> above = common(x, not_negative);
  if (n % 2 == 0) return above ? std::optional(natural_root(*above, n)) : std::nullopt;
  const std::optional<set> below = common(mirrored(x), not_negative);
  if (!below) return natural_root(*above, n);
  if (!above) return mirrored(natural_root(*below, n));
  return hull(mirrored(natural_root(*below, n)), natural_root(*above, n));
}

/// Whether x^y is exp(y log x), and undefined or 0 where x is 0: it is so for x >= 0, and there is
/// no x^y for x < 0 unless y is a whole number.
bool is_by_logarithm(const set& x, const set& y) {
  return x.lower() >= 0 || std::floor(y.upper()) < y.lower();
}

std::optional<set> natural_power_of(const set& x, const set& y) {
  if (!is_by_logarithm(x, y) || x.upper() == 0) return whole;
  const std::optional<set> logarithm = natural_log(x);
  return logarithm ? std::optional(natural_exp(y * *logarithm)) : std::nullopt;
}

const set sines = ends(-1, 1);

/// As the arithmetic has it, where x and y have bounds.
set strict(const instruction& i, const set& x, const set& y) {
  if (!x.is_bounded() || !y.is_bounded()) return whole;
  set r;
  execute<set>(i, r, x, y);
  return known(r);
}

/// On (0, 1] gamma decreases to 1, without a bound at 0: it is convex for x > 0, as the integral of
/// the convex functions t^(x-1) e^-t of x, and gamma(1) = gamma(2) = 1.
set natural_gamma(const instruction& i, const set& x) {
  if (x.lower() != 0 || !(x.upper() > 0) || x.upper() > 1) return strict(i, x, x);
  const set last(x.upper());
  return ends(std::max(strict(i, last, last).lower(), 1.0), infinity);
}

/// The values of an operation of x and y where it is defined; nothing where it is nowhere.
std::optional<set> natural_value(const instruction& i, const set& x, const set& y) {
  switch (i.what) {
    case operation::negate:
      return mirrored(x);
    case operation::add:
      return x + y;
    case operation::subtract:
      return x - y;
    case operation::multiply:
      return x * y;
    case operation::divide:
      return natural_quotient(x, y);
    case operation::power_integer:
      return natural_integer_power(x, i.number);
    case operation::root:
      return natural_real_root(x, i.number);
    case operation::power:
      return natural_power_of(x, y);
    case operation::sqrt:
      return natural_sqrt(x);
    case operation::exp:
      return natural_exp(x);
    case operation::expm1:
      return natural_expm1(x);
    case operation::log:
      return natural_log(x);
    case operation::log1p:
      return natural_log1p(x);
    case operation::sin:
      return x.is_bounded() ? known(sin(x)) : sines;
    case operation::cos:
      return x.is_bounded() ? known(cos(x)) : sines;
    case operation::asin:
    case operation::acos: {
      const std::optional<set> inside = common(x, sines);
      if (!inside) return std::nullopt;
      return i.what == operation::asin ? asin(*inside) : acos(*inside);
    }
    case operation::atan:
      return natural_atan(x);
    case operation::sinh:
      return natural_sinh(x);
    case operation::cosh:
      return natural_cosh(ends(x.mignitude(), x.magnitude()));
    case operation::tanh:
      return natural_tanh(x);
    case operation::asinh:
      return natural_asinh(x);
    case operation::acosh:
      return natural_acosh(x);
    case operation::atanh:
      return natural_atanh(x);
    case operation::abs:
      return abs(x);
    case operation::min:
      return min(x, y);
    case operation::max:
      return max(x, y);
    case operation::floor:
      return ends(std::floor(x.lower()), std::floor(x.upper()));
    case operation::ceil:
      return ends(std::ceil(x.lower()), std::ceil(x.upper()));
    case operation::hypot:
      return sqrt(square(x) + square(y));
    case operation::gamma:
      return natural_gamma(i, x);
    case operation::further:
      return whole;
    default:
      return strict(i, x, y);
  }
}

/// Cuts from x and y what has no sum of squares that is the square of a member of r.
bool meet_hypot(set& x, set& y, const set& r) {
  const std::optional<set> size = common(r, not_negative);
  if (!size) return false;
  const auto meet_rest = [&](set& u, const set& v) {
    const std::optional<set> rest = common(square(*size) - square(v), not_negative);
    return rest && meet_magnitude(u, sqrt(*rest));
  };
  return meet_rest(x, y) && meet_rest(y, x);
}

/// Cuts from x and y what has no x^y in r.
bool meet_power_of(set& x, set& y, const set& r) {
  if (!is_by_logarithm(x, y) || x.upper() == 0) return true;
  const std::optional<set> of_power = natural_log(r);
  std::optional<set> of_base = natural_log(x);
  if (!of_base) return false;
  if (!of_power) return !(x.lower() > 0);  // 0^y alone is not positive
  return meet_quotient(*of_base, *of_power, y) && meet_quotient(y, *of_power, *of_base) &&
         meet(x, natural_exp(*of_base));
}

/// Cuts from x and y what is not the smaller of both for a member of r.
bool meet_smaller(set& x, set& y, const set& r) {
  const set above = ends(r.lower(), infinity);
  if (!meet(x, above) || !meet(y, above)) return false;
  if (x.lower() > r.upper()) return meet(y, r);
  if (y.lower() > r.upper()) return meet(x, r);
  return true;
}

/// Cuts from x what has no tangent in r, for the one angle of the range.
bool meet_tangent(set& x, const set& r) {
  const auto f = [](const set& t) { return tan(t); };
  const double most = approximation::half_pi;  // below pi/2
  return meet(x, increasing(f, ends(r.lower() < -most ? -infinity : r.lower(),
                                    r.upper() > most ? infinity : r.upper())));
}

/// Cuts from x what f, an inverse function, does not have on r; where f has nothing there, all.
bool meet_inverse(set& x, const std::optional<set>& inverse) {
  return inverse && meet(x, *inverse);
}

/// Cuts from x what has no sine in r.
bool meet_sine(set& x, const set& r) {
  const std::optional<set> sine = common(r, sines);
  if (!sine) return false;
  const set quarter = ends(approximation::half_pi, quarter_turn);
  set from_quarter = x - quarter;
  return meet_periods(from_quarter, acos(*sine), 2 * pi_set, true) &&
         meet(x, from_quarter + quarter);
}

/// Cuts from x and y, which may be the same set, the members with which the operation has no value
/// in r; false where nothing is left.
bool meet_operands(const instruction& i, set& x, set& y, const set& r) {
  switch (i.what) {
    case operation::negate:
      return meet(x, mirrored(r));
    case operation::add:
      return meet(x, r - y) && meet(y, r - x);
    case operation::subtract:
      return meet(x, r + y) && meet(y, x - r);
    case operation::multiply:
      return meet_quotient(x, r, y) && meet_quotient(y, r, x);
    case operation::divide:
      return meet(x, r * y) && meet_quotient(y, x, r);
    case operation::power_integer: {
      const long n = i.number;
      if (n == 0 || is_huge(n)) return true;
      if (n > 0) return meet_root(x, r, n);
      const std::optional<set> inverse = natural_quotient(set(1), r);
      return inverse && meet_root(x, *inverse, -n);
    }
    case operation::root: {
      if (i.number % 2 != 0) return meet(x, natural_power(r, i.number));
      const std::optional<set> value = common(r, not_negative);
      return value && meet(x, natural_power(*value, i.number));
    }
    case operation::power:
      return meet_power_of(x, y, r);
    case operation::sqrt: {
      const std::optional<set> value = common(r, not_negative);
      return value && meet(x, square(*value));
    }
    case operation::exp:
      return meet_inverse(x, natural_log(r));
    case operation::expm1:
      return meet_inverse(x, natural_log1p(r));
    case operation::log:
      return meet(x, natural_exp(r));
    case operation::log1p:
      return meet(x, natural_expm1(r));
    case operation::sin:
      return meet_sine(x, r);
    case operation::cos: {
      const std::optional<set> cosine = common(r, sines);
      return cosine && meet_periods(x, acos(*cosine), 2 * pi_set, true);
    }
    case operation::tan:
      return meet_periods(x, natural_atan(r), pi_set, false);
    case operation::asin: {
      const std::optional<set> angle = common(r, ends(-quarter_turn, quarter_turn));
      return angle && meet(x, sin(*angle));
    }
    case operation::acos: {
      const std::optional<set> angle = common(r, ends(0, 2 * quarter_turn));
      return angle && meet(x, cos(*angle));
    }
    case operation::atan:
      return meet_tangent(x, r);
    case operation::sinh:
      return meet(x, natural_asinh(r));
    case operation::cosh: {
      const std::optional<set> size = natural_acosh(r);
      return size && meet_magnitude(x, *size);
    }
    case operation::tanh:
      return meet_inverse(x, natural_atanh(r));
    case operation::asinh:
      return meet(x, natural_sinh(r));
    case operation::acosh: {
      const std::optional<set> value = common(r, not_negative);
      return value && meet(x, natural_cosh(*value));
    }
    case operation::atanh:
      return meet(x, natural_tanh(r));
    case operation::abs:
      return meet_magnitude(x, r);
    case operation::min:
      return meet_smaller(x, y, r);
    case operation::max: {
      set u = mirrored(x);
      set v = mirrored(y);
      return meet_smaller(u, v, mirrored(r)) && meet(x, mirrored(u)) && meet(y, mirrored(v));
    }
    case operation::floor:
    case operation::ceil: {
      const double first = std::ceil(r.lower());
      const double last = std::floor(r.upper());
      if (first > last) return false;
      return meet(x, i.what == operation::floor ? ends(first, add_up(last, 1))
                                                : ends(add_down(first, -1), last));
    }
    case operation::hypot:
      return meet_hypot(x, y, r);
    default:
      return true;
  }
}

/// The derivatives of an operation by its operands, of which there are one or two.
struct partials {
  set by_left;
  std::optional<set> by_right = std::nullopt;
};

/// Over the sets x and y, r the values of the operation; undefined where it may not be continuously
/// differentiable, or where the derivative is not known.
partials slopes(const instruction& i, const set& x, const set& y, const set& r) {
  const set none = set::undefined();
  const long n = i.number;
  switch (i.what) {
    case operation::negate:
      return {-1};
    case operation::add:
      return {1, 1};
    case operation::subtract:
      return {1, -1};
    case operation::multiply:
      return {y, x};
    case operation::divide:
      return {1 / y, -(r / y)};
    case operation::power_integer:
      return {n == 0 ? set(0) : n * pow(x, n - 1)};
    case operation::root:
      return {r / (n * x)};
    case operation::power:
      return {y * r / x, r * log(x)};
    case operation::sqrt:
      return {1 / (2 * r)};
    case operation::exp:
      return {r};
    case operation::expm1:
      return {exp(x)};
    case operation::log:
      return {1 / x};
    case operation::log1p:
      return {1 / (1 + x)};
    case operation::sin:
      return {cos(x)};
    case operation::cos:
      return {-sin(x)};
    case operation::tan:
      return {1 + square(r)};
    case operation::sinpi:
      return {pi_set * named<operation::cospi>::over(x)};
    case operation::cospi:
      return {-(pi_set * named<operation::sinpi>::over(x))};
    case operation::erf:
      return {2 / sqrt(pi_set) * exp(-square(x))};
    case operation::erfc:
      return {-(2 / sqrt(pi_set) * exp(-square(x)))};
    case operation::asin:
      return {1 / sqrt(1 - square(x))};
    case operation::acos:
      return {-(1 / sqrt(1 - square(x)))};
    case operation::atan:
      return {1 / (1 + square(x))};
    case operation::sinh:
      return {cosh(x)};
    case operation::cosh:
      return {sinh(x)};
    case operation::tanh:
      return {1 - square(r)};
    case operation::asinh:
      return {1 / sqrt(square(x) + 1)};
    case operation::acosh:
      return {1 / sqrt(square(x) - 1)};
    case operation::atanh:
      return {1 / (1 - square(x))};
    case operation::abs:
      return {contains_zero(x) ? none : set(certainly_positive(x) ? 1 : -1)};
    case operation::min:
    case operation::max: {
      if (overlaps(x, y)) return {none, none};
      const bool is_left = certainly_less(x, y) == (i.what == operation::min);
      return {is_left ? 1 : 0, set(is_left ? 0 : 1)};
    }
    case operation::hypot:
      return {x / r, y / r};
    case operation::agm:
    case operation::atan2:
      return {none, none};
    default:
      return {none};
  }
}

}  // namespace
}  // namespace contraction_impl

contraction::contraction(const expression& f) : variables_(f.instructions().variables) {
  using namespace contraction_impl;
  constexpr precision bits = 64;
  const program& all = f.instructions();
  const tape& body = all.body;
  sets_.resize(variables_);
  for (const ball& c : constants_of(all, bits)) {
    sets_.push_back(known(set::from_ball(c)));
    has_values_ = has_values_ && !c.is_undefined();
  }
  // The number of the set that a slot has at the time: slots are used again.
  std::vector<std::uint32_t> set_in(body.slots);
  const auto set_of = [&](std::uint32_t operand) {
    return operand < body.inputs ? operand : set_in[operand - body.inputs];
  };
  for (instruction i : body.code) {
    const bool is_call = i.what == operation::further;
    has_values_ = has_values_ && !is_call;
    i.left = is_call ? 0 : set_of(i.left);
    i.right = is_call ? 0 : set_of(i.right);
    if (i.what == operation::multiply && i.left == i.right) {  // a square, of which more is known
      i.what = operation::power_integer;
      i.number = 2;
    }
    i.result = set_in[i.result] = static_cast<std::uint32_t>(sets_.size());
    code_.push_back(i);
    sets_.push_back(whole);
  }
  result_ = set_of(body.outputs.front());
  constants_.assign(sets_.begin() + static_cast<std::ptrdiff_t>(variables_),
                    sets_.begin() + body.inputs);
}

void contraction::set_inputs(const std::vector<double_interval>& box) {
  std::copy(box.begin(), box.end(), sets_.begin());
  std::copy(constants_.begin(), constants_.end(),
            sets_.begin() + static_cast<std::ptrdiff_t>(variables_));
}

bool contraction::apply(std::vector<double_interval>& box) {
  using namespace contraction_impl;
  set_inputs(box);
  for (const instruction& i : code_) {
    const std::optional<set> value = natural_value(i, sets_[i.left], sets_[i.right]);
    if (!value) return false;
    sets_[i.result] = known(*value);
  }
  if (!meet(sets_[result_], set(0))) return false;
  for (std::size_t k = code_.size(); k-- > 0;) {
    const instruction& i = code_[k];
    if (!meet_operands(i, sets_[i.left], sets_[i.right], sets_[i.result])) return false;
  }
  std::copy(sets_.begin(), sets_.begin() + static_cast<std::ptrdiff_t>(variables_), box.begin());
  return true;
}

double_interval contraction::value(const std::vector<double_interval>& box) {
  using namespace contraction_impl;
  if (!has_values_) return set::undefined();
  set_inputs(box);
  for (const instruction& i : code_) {
    set& r = sets_[i.result];
    execute<set>(i, r, sets_[i.left], sets_[i.right]);
    if (r.is_undefined()) return r;
  }
  return sets_[result_];
}

std::vector<double_interval> contraction::gradient(const std::vector<double_interval>& box) {
  using namespace contraction_impl;
  if (value(box).is_undefined()) return {};
  adjoints_.assign(sets_.size(), set(0));
  adjoints_[result_] = 1;
  for (std::size_t k = code_.size(); k-- > 0;) {
    const instruction& i = code_[k];
    const set by_result = adjoints_[i.result];
    if (by_result.is_exact() && by_result.lower() == 0) continue;
    const partials d = slopes(i, sets_[i.left], sets_[i.right], sets_[i.result]);
    if (d.by_left.is_undefined() || (d.by_right && d.by_right->is_undefined())) return {};
    adjoints_[i.left] += by_result * d.by_left;
    if (d.by_right) adjoints_[i.right] += by_result * *d.by_right;
  }
  return {adjoints_.begin(), adjoints_.begin() + static_cast<std::ptrdiff_t>(variables_)};
}

contraction::value_and_slope contraction::over(double_interval x) {
  using namespace contraction_impl;
  const set result = value({x});
  if (result.is_undefined()) return {result, result};
  adjoints_.assign(sets_.size(), set(0));
  adjoints_.front() = 1;
  const auto varies = [](const set& d) { return !d.is_exact() || d.lower() != 0; };
  for (const instruction& i : code_) {
    const bool by_left = varies(adjoints_[i.left]);
    const bool by_right = varies(adjoints_[i.right]);
    if (!by_left && !by_right) continue;
    const partials d = slopes(i, sets_[i.left], sets_[i.right], sets_[i.result]);
    set sum = 0;
    if (by_left) sum += d.by_left * adjoints_[i.left];
    if (d.by_right && by_right) sum += *d.by_right * adjoints_[i.right];
    if (sum.is_undefined()) return {result, sum};
    adjoints_[i.result] = sum;
  }
  return {result, adjoints_[result_]};
}

}  // namespace polhode::detail
