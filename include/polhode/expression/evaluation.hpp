#pragma once

// How a compiled formula is evaluated over a type T: the instructions one after another, in slots that are
// used again. Needed only for a T beyond those that expression.hpp lists.
//
// T needs the operators + - * /, pow(x, n) and the functions sqrt, exp, log, sin, cos, tan, asin, acos,
// atan, sinh, cosh, tanh, asinh, acosh and atanh; what T may lack is in detail::supplement<T>.

#include <concepts>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {
namespace detail {

/// The functions that a T may lack. Each static member obeys the inclusion principle, or answers that it
/// is not defined, or not available, in T's way.
template <class T>
struct supplement;

template <>
struct supplement<ball> {
  static ball expm1(const ball& x) { return polhode::expm1(x); }
  static ball log1p(const ball& x) { return polhode::log1p(x); }
  static ball sinpi(const ball& x) { return polhode::sinpi(x); }
  static ball cospi(const ball& x) { return polhode::cospi(x); }
  static ball abs(const ball& x) { return polhode::abs(x); }
  static ball floor(const ball& x) { return polhode::floor(x); }
  static ball ceil(const ball& x) { return polhode::ceil(x); }
  static ball min(const ball& x, const ball& y) { return polhode::min(x, y); }
  static ball max(const ball& x, const ball& y) { return polhode::max(x, y); }
  static ball hypot(const ball& x, const ball& y) { return polhode::hypot(x, y); }
  static ball agm(const ball& x, const ball& y) { return polhode::agm(x, y); }
  static ball atan2(const ball& y, const ball& x) { return polhode::atan2(y, x); }
  static ball power_integer(const ball& x, long n) { return pow(x, n); }
  static ball power(const ball& x, const ball& y) { return pow(x, y); }
  static ball root(const ball& x, long n) {
    return polhode::root(x, static_cast<unsigned long>(n));
  }
  static ball gamma(const ball& x) { return polhode::gamma(x); }
  static ball log_gamma(const ball& x) { return polhode::log_gamma(x); }
  static ball erf(const ball& x) { return polhode::erf(x); }
  static ball erfc(const ball& x) { return polhode::erfc(x); }
};

/// Off the real line abs, min, max, floor and ceil are those of region.hpp, decided by real parts, and are
/// undefined where the real parts do not decide; root(z, n) of odd n is -root(-z, n) where Re z < 0; where
/// the imaginary part is 0, all of them are the real functions.
template <>
struct supplement<complex_ball> {
  static complex_ball expm1(const complex_ball& z);
  static complex_ball log1p(const complex_ball& z);
  static complex_ball sinpi(const complex_ball& z);
  static complex_ball cospi(const complex_ball& z);
  static complex_ball abs(const complex_ball& z);
  static complex_ball floor(const complex_ball& z);
  static complex_ball ceil(const complex_ball& z);
  static complex_ball min(const complex_ball& z, const complex_ball& w);
  static complex_ball max(const complex_ball& z, const complex_ball& w);
  static complex_ball hypot(const complex_ball& z, const complex_ball& w);
  static complex_ball agm(const complex_ball& z, const complex_ball& w);
  static complex_ball atan2(const complex_ball& y, const complex_ball& x);
  static complex_ball power_integer(const complex_ball& z, long n);
  static complex_ball power(const complex_ball& z, const complex_ball& w);
  static complex_ball root(const complex_ball& z, long n);
  static complex_ball gamma(const complex_ball& z);
  static complex_ball log_gamma(const complex_ball& z);
  static complex_ball erf(const complex_ball& z);
  static complex_ball erfc(const complex_ball& z);
};

/// agm is not available (obstacle::unknown); log_gamma for Re z > 0.
template <>
struct supplement<region> {
  static region expm1(const region& z);
  static region log1p(const region& z);
  static region sinpi(const region& z);
  static region cospi(const region& z);
  static region abs(const region& z);
  static region floor(const region& z);
  static region ceil(const region& z);
  static region min(const region& z, const region& w);
  static region max(const region& z, const region& w);
  static region hypot(const region& z, const region& w);
  static region agm(const region& z, const region& w);
  static region atan2(const region& y, const region& x);
  static region power_integer(const region& z, long n);
  static region power(const region& z, const region& w);
  static region root(const region& z, long n);
  static region gamma(const region& z);
  static region log_gamma(const region& z);
  /// erf is entire: with m real, erf(z) - erf(m) is z - m times a mean of its derivative over the segment
  /// between them, and lies in (Z - m) (2/sqrt(pi)) exp(-W^2) for any convex W that holds m and Z.
  static region erf(const region& z);
  static region erfc(const region& z);
};

template <>
struct supplement<double_interval> {
  static double_interval expm1(double_interval x);
  static double_interval log1p(double_interval x);
  static double_interval sinpi(double_interval x);
  static double_interval cospi(double_interval x);
  static double_interval abs(double_interval x);
  static double_interval floor(double_interval x);
  static double_interval ceil(double_interval x);
  static double_interval min(double_interval x, double_interval y);
  static double_interval max(double_interval x, double_interval y);
  static double_interval hypot(double_interval x, double_interval y);
  static double_interval agm(double_interval x, double_interval y);
  static double_interval atan2(double_interval y, double_interval x);
  static double_interval power_integer(double_interval x, long n);
  static double_interval power(double_interval x, double_interval y);
  static double_interval root(double_interval x, long n);
  static double_interval gamma(double_interval x);
  static double_interval log_gamma(double_interval x);
  static double_interval erf(double_interval x);
  static double_interval erfc(double_interval x);
};

// Found by their arguments only, under names that no member of `supplement` hides.
template <class T>
[[nodiscard]] T error_function_of(const T& x) {
  return erf(x);
}
template <class T>
[[nodiscard]] T complementary_error_function_of(const T& x) {
  return erfc(x);
}

/// Jets of balls: those of jet.hpp, and others whose first coefficient is the ball's own function of it; the
/// derivatives of gamma, log_gamma and agm are not available, and undefined.
template <int Order>
struct supplement<jet<ball, Order>> {
  using series = jet<ball, Order>;
  using on_balls = supplement<ball>;

  static series expm1(const series& x) { return with_value(exp(x), on_balls::expm1(x[0])); }
  static series log1p(const series& x) { return with_value(log(x + 1), on_balls::log1p(x[0])); }
  static series sinpi(const series& x) {
    return with_value(sin(x * pi(x[0].precision())), on_balls::sinpi(x[0]));
  }
  static series cospi(const series& x) {
    return with_value(cos(x * pi(x[0].precision())), on_balls::cospi(x[0]));
  }
  static series abs(const series& x) { return polhode::abs(x); }
  static series floor(const series& x) { return polhode::floor(x); }
  static series ceil(const series& x) { return polhode::ceil(x); }
  static series min(const series& x, const series& y) { return polhode::min(x, y); }
  static series max(const series& x, const series& y) { return polhode::max(x, y); }
  static series hypot(const series& x, const series& y) {
    return with_value(sqrt(x * x + y * y), on_balls::hypot(x[0], y[0]));
  }
  static series agm(const series& x, const series& y) {
    return value_only(x, on_balls::agm(x[0], y[0]));
  }
  /// By whichever of x > 0, y > 0 and y < 0 is certain; elsewhere the value only.
  static series atan2(const series& y, const series& x) {
    const ball value = on_balls::atan2(y[0], x[0]);
    if (certainly_positive(x[0])) return with_value(atan(y / x), value);
    if (contains_zero(y[0]) || y[0].is_undefined()) return value_only(x, value);
    return with_value(-atan(x / y), value);
  }
  static series power_integer(const series& x, long n) {
    return with_value(pow(x, n), pow(x[0], n));
  }
  static series power(const series& x, const series& y) {
    const ball value = pow(x[0], y[0]);
    if (!certainly_positive(x[0])) return value_only(x, value);
    return with_value(exp(y * log(x)), value);
  }
  static series root(const series& x, long n) {
    const ball value = on_balls::root(x[0], n);
    if (certainly_positive(x[0])) return with_value(exp(log(x) / n), value);
    if (certainly_negative(x[0]) && n % 2 != 0) {
      return with_value(-exp(log(-x) / n), value);
    }
    return value_only(x, value);
  }
  static series gamma(const series& x) { return value_only(x, on_balls::gamma(x[0])); }
  static series log_gamma(const series& x) { return value_only(x, on_balls::log_gamma(x[0])); }
  static series erf(const series& x) { return error_function_of(x); }
  static series erfc(const series& x) { return complementary_error_function_of(x); }

 private:
  static series with_value(series x, const ball& value) {
    x[0] = value;
    return x;
  }
  static series value_only(const series& like, const ball& value) {
    return value_alone<Order>(value, like.order());
  }
};

/// The result of the instruction for the operands x and y, of which r may be one.
template <class T>
void execute(const instruction& i, T& r, const T& x, const T& y) {
  using more = supplement<T>;
// In the storage of r, where T has such a function (ball).
#define POLHODE_OWN(f)                     \
  case operation::f:                       \
    if constexpr (requires { f(r, x); }) { \
      f(r, x);                             \
    } else {                               \
      r = f(x);                            \
    }                                      \
    return;
#define POLHODE_OPERATOR(f, sign)             \
  case operation::f:                          \
    if constexpr (requires { f(r, x, y); }) { \
      f(r, x, y);                             \
    } else {                                  \
      r = x sign y;                           \
    }                                         \
    return;
#define POLHODE_MORE(f) \
  case operation::f:    \
    r = more::f(x);     \
    return;
#define POLHODE_MORE_OF_TWO(f) \
  case operation::f:           \
    r = more::f(x, y);         \
    return;
  switch (i.what) {
    POLHODE_OPERATOR(add, +)
    POLHODE_OPERATOR(subtract, -)
    POLHODE_OPERATOR(multiply, *)
    POLHODE_OPERATOR(divide, /)
    POLHODE_OWN(sqrt)
    POLHODE_OWN(exp)
    POLHODE_OWN(log)
    POLHODE_OWN(sin)
    POLHODE_OWN(cos)
    POLHODE_OWN(tan)
    POLHODE_OWN(asin)
    POLHODE_OWN(acos)
    POLHODE_OWN(atan)
    POLHODE_OWN(sinh)
    POLHODE_OWN(cosh)
    POLHODE_OWN(tanh)
    POLHODE_OWN(asinh)
    POLHODE_OWN(acosh)
    POLHODE_OWN(atanh)
    POLHODE_MORE(expm1)
    POLHODE_MORE(log1p)
    POLHODE_MORE(sinpi)
    POLHODE_MORE(cospi)
    POLHODE_MORE(abs)
    POLHODE_MORE(floor)
    POLHODE_MORE(ceil)
    POLHODE_MORE(gamma)
    POLHODE_MORE(log_gamma)
    POLHODE_MORE(erf)
    POLHODE_MORE(erfc)
    POLHODE_MORE_OF_TWO(min)
    POLHODE_MORE_OF_TWO(max)
    POLHODE_MORE_OF_TWO(hypot)
    POLHODE_MORE_OF_TWO(agm)
    POLHODE_MORE_OF_TWO(atan2)
    POLHODE_MORE_OF_TWO(power)
    case operation::negate:
      r = -x;
      return;
    case operation::power_integer:
      if constexpr (std::same_as<T, ball>) {
        if (i.number == 2) return square(r, x);
      }
      r = more::power_integer(x, i.number);
      return;
    case operation::root:
      r = more::root(x, i.number);
      return;
    default:  // numbers and variables are inputs, constants are evaluated apart
      throw std::logic_error("an instruction without operands in the body of an expression");
  }
#undef POLHODE_OWN
#undef POLHODE_OPERATOR
#undef POLHODE_MORE
#undef POLHODE_MORE_OF_TWO
}
template <>
void execute(const instruction& i, mpfr_float& r, const mpfr_float& x, const mpfr_float& y);
template <>
void execute(const instruction& i, double& r, const double& x, const double& y);

/// The value of a further function over any type, from its values over balls; supplement<T>::further(f, arguments) has it
/// for a T that has a way of its own.
template <class T>
[[nodiscard]] T value_of_further(const further_function& f, const std::vector<T>& x) {
  const auto at_balls = [&](auto&& ball_of) {
    std::vector<ball> arguments;
    arguments.reserve(x.size());
    for (const T& argument : x) arguments.push_back(ball_of(argument));
    return f.value(arguments);
  };
  if constexpr (requires { supplement<T>::further(f, x); }) {
    return supplement<T>::further(f, x);
  } else if constexpr (std::same_as<T, ball>) {
    return f.value(x);
  } else if constexpr (std::same_as<T, mpfr_float>) {
    return midpoint(at_balls([](const mpfr_float& a) { return ball(a); }));
  } else if constexpr (std::same_as<T, double>) {
    const mpfr_float middle = midpoint(at_balls([](double a) { return ball::exactly(a, 64); }));
    return mpfr_get_d(middle.backend().data(), MPFR_RNDN);
  } else if constexpr (std::same_as<T, double_interval>) {
    return double_interval::from_ball(at_balls([](double_interval a) { return to_ball(a, 64); }));
  } else if constexpr (std::same_as<T, complex_ball>) {
    for (const complex_ball& a : x) {
      if (sign_of(a.im) == sign::zero) continue;
      return f.over_complex ? f.over_complex(x) : complex_ball::undefined(a.precision());
    }
    return complex_ball(at_balls([](const complex_ball& a) { return a.re; }));
  } else if constexpr (std::same_as<T, region>) {
    for (const region& a : x) {
      if (!a.is_analytic()) return a;
    }
    if (f.over_regions) return f.over_regions(x);
    return region::blocked(obstacle::unknown, f.what.name.c_str());
  } else if constexpr (is_jet<T>::value) {
    T result = x.front();
    result[0] = at_balls([](const T& a) { return a[0]; });
    const ball none = ball::undefined(result[0].precision());
    for (int k = 1; k <= result.order(); ++k) result[k] = none;
    if (f.gradient && result.order() >= 1) {
      std::vector<ball> arguments;
      arguments.reserve(x.size());
      for (const T& a : x) arguments.push_back(a[0]);
      const std::vector<ball> slopes = f.gradient(arguments);
      ball sum(0, result[0].precision());
      for (std::size_t i = 0; i < x.size(); ++i) {
        // What does not vary needs no derivative.
        if (sign_of(x[i][1]) != sign::zero) sum += slopes[i] * x[i][1];
      }
      result[1] = sum;
    }
    return result;
  } else {
    return x.front().blocked(f.what.name.c_str());
  }
}
/// The operand's number -> the operand, in `operand`.
template <class T, class Operand>
[[nodiscard]] T value_of_call(const tape& t, const instruction& i, const Operand& operand) {
  const call_of_further& call = t.calls[static_cast<std::size_t>(i.number)];
  std::vector<T> arguments;
  arguments.reserve(call.operands.size());
  for (const std::uint32_t o : call.operands) arguments.push_back(operand(o));
  return value_of_further<T>(*call.function, arguments);
}

/// The real number enclosed by x, as a T.
template <class T>
[[nodiscard]] T converted(const ball& x) {
  if constexpr (std::same_as<T, mpfr_float>) {
    return midpoint(x);
  } else if constexpr (std::same_as<T, double>) {
    const mpfr_float middle = midpoint(x);
    return mpfr_get_d(middle.backend().data(), MPFR_RNDN);
  } else if constexpr (std::same_as<T, double_interval>) {
    return double_interval::from_ball(x);
  } else {
    return T(x);
  }
}

/// A copy of the same precision.
template <class T>
[[nodiscard]] T copied(const T& x) {
  if constexpr (std::same_as<T, mpfr_float>) {
    mpfr_float r = zero_of_precision(precision_of(x));
    mpfr_set(r.backend().data(), x.backend().data(), MPFR_RNDN);
    return r;
  } else {
    return x;
  }
}

/// What the part of a program without variables gives: number(q) is a number of the formula, and constant(i) a
/// constant such as pi; seen(i, x) is told the result of each instruction.
template <class T, class Number, class Constant, class Observer>
[[nodiscard]] std::vector<T> evaluate_constants(const program& f, const Number& number,
                                                const Constant& constant, const Observer& seen) {
  const tape& t = f.constants;
  std::vector<T> numbers;
  numbers.reserve(f.numbers.size());
  for (const rational& q : f.numbers) numbers.push_back(number(q));
  std::vector<T> slots(t.slots);
  const auto operand = [&](std::uint32_t i) -> const T& {
    return i < t.inputs ? numbers[i] : slots[i - t.inputs];
  };
  for (const instruction& i : t.code) {
    T& r = slots[i.result];
    if (i.what == operation::further) {
      r = value_of_call<T>(t, i, operand);
    } else if (i.what >= operation::negate) {
      execute<T>(i, r, operand(i.left), operand(i.right));
    } else {
      r = constant(i);
    }
    seen(i, r);
  }
  std::vector<T> result;
  result.reserve(t.outputs.size());
  for (const std::uint32_t o : t.outputs) result.push_back(operand(o));
  return result;
}

template <class T, class Number, class Constant>
[[nodiscard]] std::vector<T> evaluate_constants(const program& f, const Number& number,
                                                const Constant& constant) {
  return evaluate_constants<T>(f, number, constant, [](const instruction&, const T&) {});
}

/// A T that knows more of a constant than an enclosure: supplement<T>::number(q) is the rational number,
/// supplement<T>::constant(i) a constant such as pi.
template <class T>
concept symbolic = requires(const rational& q, const instruction& i) {
  { supplement<T>::number(q) } -> std::same_as<T>;
  { supplement<T>::constant(i) } -> std::same_as<T>;
};

/// What the part of a program without variables gives, at p bits.
[[nodiscard]] std::vector<ball> constants_of(const program& f, precision p);
/// The first instruction of that part whose value is undefined.
[[nodiscard]] std::optional<instruction> first_undefined(const program& f, precision p);
/// The values, exactly where it is a number of the formula.
[[nodiscard]] std::vector<possibly_exact_constant> possibly_exact_constants_of(const program& f,
                                                                               precision p);

}  // namespace detail

template <class T>
compiled_expression<T>::compiled_expression(std::shared_ptr<const detail::program> program,
                                            precision p)
    : program_(std::move(program)) {
  std::vector<constant> constants;
  if constexpr (std::same_as<constant, detail::possibly_exact_constant>) {
    constants = detail::possibly_exact_constants_of(*program_, checked_precision(p));
  } else if constexpr (detail::symbolic<T>) {
    constants = detail::evaluate_constants<T>(*program_, detail::supplement<T>::number,
                                              detail::supplement<T>::constant);
  } else {
    for (const ball& x : detail::constants_of(*program_, checked_precision(p))) {
      constants.push_back(detail::converted<constant>(x));
    }
  }
  constants_ = std::make_shared<const std::vector<constant>>(std::move(constants));
}

template <class T>
T compiled_expression<T>::evaluate(std::span<const T> values, const T& like) const {
  const detail::tape& body = program_->body;
  if (values.size() != program_->variables) {
    throw std::invalid_argument("an expression of " + std::to_string(program_->variables) +
                                " variables was given " + std::to_string(values.size()) +
                                " values");
  }
  const std::size_t variables = values.size();
  const std::vector<T>* constants = nullptr;
  std::vector<T> lifted;  // constants of the order, or in the form, of the argument
  if constexpr (std::same_as<T, constant>) {
    constants = constants_.get();
  } else if constexpr (std::same_as<T, region>) {
    const bool hardware = like.is_in_hardware();
    for (const constant& c : *constants_) {
      lifted.push_back(hardware ? c.in_hardware : region::in_balls(complex_ball(c.exact)));
    }
    constants = &lifted;
  } else if constexpr (std::same_as<constant, detail::possibly_exact_constant>) {
    for (const constant& c : *constants_) {
      lifted.push_back(c.exact ? like.constant_like(*c.exact) : like.constant_like(c.enclosure));
    }
    constants = &lifted;
  } else {
    for (const constant& c : *constants_) lifted.push_back(T::constant(c, like.order()));
    constants = &lifted;
  }
  std::vector<T> slots(body.slots);
  const auto operand = [&](std::uint32_t i) -> const T& {
    if (i >= body.inputs) return slots[i - body.inputs];
    return i < variables ? values[i] : (*constants)[i - variables];
  };
  for (const detail::instruction& i : body.code) {
    if (i.what == detail::operation::further) {
      slots[i.result] = detail::value_of_call<T>(body, i, operand);
      continue;
    }
    detail::execute<T>(i, slots[i.result], operand(i.left), operand(i.right));
  }
  const std::uint32_t result = body.outputs.front();
  if (result >= body.inputs) return std::move(slots[result - body.inputs]);
  return detail::copied(operand(result));
}

}  // namespace polhode
