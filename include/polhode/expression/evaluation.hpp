#pragma once

// How a compiled formula is evaluated over a type T: the instructions one after another, in slots
// that are used again. Needed only for a T beyond those that expression.hpp lists.
//
// What T must offer is the concept formula_arithmetic. What it does otherwise than by the names of
// the table, or in a way of its own, it says in supplement<T>: functions and operators, the answer
// to a function that is known over balls alone (further), and numbers. A named function that is in
// neither is one that is known over balls. So a row of function_table.hpp and a function over balls
// are enough for every T to have an answer, if only that the function is not available.

#include <array>
#include <concepts>
#include <functional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/elliptic/complete.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {
namespace detail {

/// What a T has under other names than those of the table, or does otherwise there. Each static
/// member obeys the inclusion principle, or answers that it is not defined, or not available, in
/// T's way (a double, or an mpfr_float, is rounded). power_integer(x, n), power(x, y) and root(x,
/// n) are x^n, x^y and the real root; add, subtract, multiply, divide and negate stand for T's
/// operators. `further(f, arguments)` is T's answer for a function that is known by f.value over
/// balls, where arguments is a range of T or of references to them; without it T answers that f is
/// blocked. number(q) and constant(i) are a rational number and a constant such as pi, of a T that
/// knows more of them than an enclosure; from(x) is the number in a ball x, else T(x); copy(x) is x
/// with its precision, where T's copies may have another.
template <class T>
struct supplement {};

/// f(x) with these balls for the arguments x.
template <class F, class Range, class BallOf>
[[nodiscard]] ball value_at_balls(const F& f, const Range& x, const BallOf& ball_of) {
  std::vector<ball> arguments;
  arguments.reserve(x.size());
  for (const auto& argument : x) arguments.push_back(ball_of(argument));
  return f.value(arguments);
}

[[nodiscard]] inline const char* name_of_function(const further_function& f) {
  return f.what.name.c_str();
}
template <class F>
[[nodiscard]] const char* name_of_function(const F&) {
  return F::name;
}

template <>
struct supplement<ball> {
  template <class F, class Range>
  static ball further(const F& f, const Range& x) {
    return value_at_balls(f, x, [](const ball& a) { return a; });
  }
};

/// Off the real line abs, min, max, floor and ceil are those of region.hpp, decided by real parts,
/// and are undefined where the real parts do not decide; root(z, n) of odd n is -root(-z, n) where
/// Re z < 0; where the imaginary part is 0, all of them are the real functions.
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
  static complex_ball root(const complex_ball& z, long n);
  template <class F, class Range>
  static complex_ball further(const F& f, const Range& x) {
    for (const complex_ball& a : x) {
      if (sign_of(a.im) == certain_sign::zero) continue;
      if constexpr (requires { f.over_complex; }) {
        if (f.over_complex) return f.over_complex(x);
      }
      return complex_ball::undefined(a.precision());
    }
    return complex_ball(value_at_balls(f, x, [](const complex_ball& a) { return a.re; }));
  }
};

/// log_gamma(z) for Re z > 0; agm(z, w) for Re z > 0 and Re w > 0. On other sides they are not
/// available (obstacle::unknown), on sets of both sides blocked by a cut.
template <>
struct supplement<region> {
  static region expm1(const region& z);
  static region log1p(const region& z);
  static region sinpi(const region& z);
  static region cospi(const region& z);
  static region hypot(const region& z, const region& w);
  /// pi/(2 R_F(0, ((z + w)/2)^2, z w)) (DLMF 19.22.1).
  static region agm(const region& z, const region& w);
  static region atan2(const region& y, const region& x);
  static region root(const region& z, long n);
  /// erf is entire: erf(z) - erf(m) is z - m times a mean of its derivative over the segment
  /// between them, and lies in (Z - m) (2/sqrt(pi)) exp(-W^2) for any convex W that holds m and Z.
  static region erf(const region& z);
  static region erfc(const region& z);
  template <class F, class Range>
  static region further(const F& f, const Range& x) {
    for (const region& a : x) {
      if (!a.is_analytic()) return a;
    }
    if constexpr (requires { f.over_regions; }) {
      if (f.over_regions) return f.over_regions(x);
    }
    return region::blocked(obstacle::unknown, name_of_function(f));
  }
};

/// By way of balls: double_interval.hpp has the angle off a cut alone.
template <>
struct supplement<double_interval> {
  static double_interval atan2(double_interval y, double_interval x);
  static double_interval from(const ball& x) { return double_interval::from_ball(x); }
  template <class F, class Range>
  static double_interval further(const F& f, const Range& x) {
    return from(value_at_balls(f, x, [](double_interval a) { return to_ball(a, 64); }));
  }
};

/// Jets of balls: those of jet.hpp, and others whose first coefficient is the ball's own function
/// of it. Not available, and undefined, are the derivatives above the first of agm, gamma and
/// log_gamma: Gamma' = Gamma digamma, log|Gamma|' = digamma, and agm_slope.
template <int Order>
struct supplement<jet<ball, Order>> {
  using series = jet<ball, Order>;

  static series expm1(const series& x) { return with_value(exp(x), polhode::expm1(x[0])); }
  static series log1p(const series& x) { return with_value(log(x + 1), polhode::log1p(x[0])); }
  static series sinpi(const series& x) {
    return with_value(sin(x * pi(x[0].precision())), polhode::sinpi(x[0]));
  }
  static series cospi(const series& x) {
    return with_value(cos(x * pi(x[0].precision())), polhode::cospi(x[0]));
  }
  static series hypot(const series& x, const series& y) {
    return with_value(sqrt(x * x + y * y), polhode::hypot(x[0], y[0]));
  }
  /// By whichever of x > 0, y > 0 and y < 0 is certain; elsewhere the value only.
  static series atan2(const series& y, const series& x) {
    const ball value = polhode::atan2(y[0], x[0]);
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
    const ball value = polhode::root(x[0], static_cast<unsigned long>(n));
    if (certainly_positive(x[0])) return with_value(exp(log(x) / n), value);
    if (certainly_negative(x[0]) && n % 2 != 0) {
      return with_value(-exp(log(-x) / n), value);
    }
    return value_only(x, value);
  }
  static series gamma(const series& x) {
    const ball value = polhode::gamma(x[0]);
    return with_slope(x, value, value * digamma(x[0]));
  }
  static series agm(const series& x, const series& y) {
    series r = value_only(x, polhode::agm(x[0], y[0]));
    if (x.order() < 1) return r;
    r[1] = ball(0, r[0].precision());
    // An argument that does not vary needs no derivative.
    if (sign_of(x[1]) != certain_sign::zero) r[1] += agm_slope(y[0], x[0]) * x[1];
    if (sign_of(y[1]) != certain_sign::zero) r[1] += agm_slope(x[0], y[0]) * y[1];
    return r;
  }
  static series log_gamma(const series& x) {
    return with_slope(x, polhode::log_gamma(x[0]), digamma(x[0]));
  }
  /// With the first derivative, where f has a gradient.
  template <class F, class Range>
  static series further(const F& f, const Range& x) {
    const series& first = x.front();
    series r = value_only(first, value_at_balls(f, x, [](const series& a) { return a[0]; }));
    if constexpr (requires { f.gradient; }) {
      if (f.gradient && r.order() >= 1) {
        std::vector<ball> arguments;
        arguments.reserve(x.size());
        for (const series& a : x) arguments.push_back(a[0]);
        const std::vector<ball> slopes = f.gradient(arguments);
        ball sum(0, r[0].precision());
        for (std::size_t i = 0; i < x.size(); ++i) {
          // What does not vary needs no derivative.
          if (sign_of(x[i][1]) != certain_sign::zero) sum += slopes[i] * x[i][1];
        }
        r[1] = sum;
      }
    }
    return r;
  }

 private:
  /// f(x) of which f and f' at the first coefficient are given.
  static series with_slope(const series& x, const ball& value, const ball& slope) {
    series r = value_only(x, value);
    if (x.order() >= 1) r[1] = slope * x[1];
    return r;
  }
  static series with_value(series x, const ball& value) {
    x[0] = value;
    return x;
  }
  static series value_only(const series& like, const ball& value) {
    return value_alone<Order>(value, like.order());
  }
};

/// f(x) by T's own way, for a function that is known by f.value over balls: a further_function, or
/// a named one that T has not. x is a range of T or of references to them.
template <class T, class F, class Range>
[[nodiscard]] T value_over(const F& f, const Range& x) {
  if constexpr (requires { supplement<T>::further(f, x); }) {
    return supplement<T>::further(f, x);
  } else {
    const T& first = x.front();
    return first.blocked(name_of_function(f));
  }
}

/// What formulas need of T: + - * / and -, by T's operators or as supplement<T> has them, and whole
/// powers. The rest of its functions may be missing.
template <class T>
concept formula_arithmetic = std::copyable<T> && requires(const T& x, const T& y, long n) {
  requires requires { supplement<T>::add(x, y); } || requires {
    T(x + y);
  };
  requires requires { supplement<T>::subtract(x, y); } || requires {
    T(x - y);
  };
  requires requires { supplement<T>::multiply(x, y); } || requires {
    T(x * y);
  };
  requires requires { supplement<T>::divide(x, y); } || requires {
    T(x / y);
  };
  requires requires { supplement<T>::negate(x); } || requires {
    T(-x);
  };
  requires requires { supplement<T>::power_integer(x, n); } || requires {
    T(pow(x, n));
  };
};

/// A function of the table, or x^n, x^y or the real root, in every arithmetic: over(x), over(x, y)
/// or over(x, n), and put(r, ...) for the same in r, which may be one of the operands. is_own<T>: T
/// has it, and does not answer by way of balls.
template <operation what>
struct named;

#define POLHODE_NAMED_OF_ONE(f, ...)                                                     \
  template <>                                                                            \
  struct named<operation::f> {                                                           \
    static constexpr const char* name = #f;                                              \
    template <class T>                                                                   \
    static constexpr bool is_otherwise = requires(const T& x) {                          \
      supplement<T>::f(x);                                                               \
    };                                                                                   \
    template <class T>                                                                   \
    static constexpr bool is_by_name = requires(const T& x) {                            \
      { f(x) } -> std::same_as<T>;                                                       \
    };                                                                                   \
    template <class T>                                                                   \
    static constexpr bool is_own = is_otherwise<T> || is_by_name<T>;                     \
    template <class T>                                                                   \
    [[nodiscard]] static T over(const T& x) {                                            \
      if constexpr (is_otherwise<T>) {                                                   \
        return supplement<T>::f(x);                                                      \
      } else if constexpr (is_by_name<T>) {                                              \
        return f(x);                                                                     \
      } else {                                                                           \
        static_assert(!std::same_as<T, ball>, "balls have every function of the table"); \
        return value_over<T>(named(), std::array{std::cref(x)});                         \
      }                                                                                  \
    }                                                                                    \
    template <class T>                                                                   \
    static void put(T& r, const T& x) {                                                  \
      if constexpr (!is_otherwise<T> && requires { f(r, x); }) {                         \
        f(r, x);                                                                         \
      } else {                                                                           \
        r = over(x);                                                                     \
      }                                                                                  \
    }                                                                                    \
    template <class T>                                                                   \
    [[nodiscard]] static T of(std::span<const T> x) {                                    \
      return over(x[0]);                                                                 \
    }                                                                                    \
    [[nodiscard]] static ball value(std::span<const ball> x) { return of(x); }           \
  };
#define POLHODE_NAMED_OF_TWO_AS(what, f)                                                 \
  template <>                                                                            \
  struct named<operation::what> {                                                        \
    static constexpr const char* name = #f;                                              \
    template <class T>                                                                   \
    static constexpr bool is_otherwise = requires(const T& x, const T& y) {              \
      supplement<T>::what(x, y);                                                         \
    };                                                                                   \
    template <class T>                                                                   \
    static constexpr bool is_by_name = requires(const T& x, const T& y) {                \
      { f(x, y) } -> std::same_as<T>;                                                    \
    };                                                                                   \
    template <class T>                                                                   \
    static constexpr bool is_own = is_otherwise<T> || is_by_name<T>;                     \
    template <class T>                                                                   \
    [[nodiscard]] static T over(const T& x, const T& y) {                                \
      if constexpr (is_otherwise<T>) {                                                   \
        return supplement<T>::what(x, y);                                                \
      } else if constexpr (is_by_name<T>) {                                              \
        return f(x, y);                                                                  \
      } else {                                                                           \
        static_assert(!std::same_as<T, ball>, "balls have every function of the table"); \
        return value_over<T>(named(), std::array{std::cref(x), std::cref(y)});           \
      }                                                                                  \
    }                                                                                    \
    template <class T>                                                                   \
    [[nodiscard]] static T of(std::span<const T> x) {                                    \
      return over(x[0], x[1]);                                                           \
    }                                                                                    \
    [[nodiscard]] static ball value(std::span<const ball> x) { return of(x); }           \
  };
#define POLHODE_NAMED_OF_TWO(f, ...) POLHODE_NAMED_OF_TWO_AS(f, f)
POLHODE_FUNCTION_TABLE(POLHODE_NAMED_OF_ONE, POLHODE_NAMED_OF_TWO, POLHODE_NAMED_OF_TWO,
                       POLHODE_NO_ROW)
POLHODE_NAMED_OF_TWO_AS(power, pow)
#undef POLHODE_NAMED_OF_ONE
#undef POLHODE_NAMED_OF_TWO
#undef POLHODE_NAMED_OF_TWO_AS

template <>
struct named<operation::power_integer> {
  template <class T>
  [[nodiscard]] static T over(const T& x, long n) {
    if constexpr (requires { supplement<T>::power_integer(x, n); }) {
      return supplement<T>::power_integer(x, n);
    } else {
      return pow(x, n);
    }
  }
};

template <>
struct named<operation::root> {
  static constexpr const char* name = "root";
  long n;

  template <class T>
  [[nodiscard]] static T over(const T& x, long n) {
    if constexpr (std::same_as<T, ball>) {
      return polhode::root(x, static_cast<unsigned long>(n));
    } else if constexpr (requires { supplement<T>::root(x, n); }) {
      return supplement<T>::root(x, n);
    } else if constexpr (requires {
                           { root(x, n) } -> std::same_as<T>;
                         }) {
      return root(x, n);
    } else {
      return value_over<T>(named{n}, std::array{std::cref(x)});
    }
  }
  [[nodiscard]] ball value(std::span<const ball> x) const { return over(x[0], n); }
};

/// The result of the instruction for the operands x and y, of which r may be one.
template <formula_arithmetic T>
void execute(const instruction& i, T& r, const T& x, const T& y) {
// As the supplement has it; or in the storage of r, where T has such a function (ball).
#define POLHODE_OPERATOR(f, sign)                         \
  case operation::f:                                      \
    if constexpr (requires { supplement<T>::f(x, y); }) { \
      r = supplement<T>::f(x, y);                         \
    } else if constexpr (requires { f(r, x, y); }) {      \
      f(r, x, y);                                         \
    } else {                                              \
      r = x sign y;                                       \
    }                                                     \
    return;
#define POLHODE_OF_ONE(f, ...)      \
  case operation::f:                \
    named<operation::f>::put(r, x); \
    return;
#define POLHODE_OF_TWO(f, ...)           \
  case operation::f:                     \
    r = named<operation::f>::over(x, y); \
    return;
  switch (i.what) {
    POLHODE_OPERATOR(add, +)
    POLHODE_OPERATOR(subtract, -)
    POLHODE_OPERATOR(multiply, *)
    POLHODE_OPERATOR(divide, /)
    POLHODE_OF_TWO(power)
    POLHODE_FUNCTION_TABLE(POLHODE_OF_ONE, POLHODE_OF_TWO, POLHODE_OF_TWO, POLHODE_NO_ROW)
    case operation::negate:
      if constexpr (requires { supplement<T>::negate(x); }) {
        r = supplement<T>::negate(x);
      } else {
        r = -x;
      }
      return;
    case operation::power_integer:
      if constexpr (std::same_as<T, ball>) {
        if (i.number == 2) return square(r, x);
      }
      r = named<operation::power_integer>::over(x, i.number);
      return;
    case operation::root:
      r = named<operation::root>::over(x, i.number);
      return;
    default:  // numbers and variables are inputs, constants are evaluated apart
      throw std::logic_error("an instruction without operands in the body of an expression");
  }
#undef POLHODE_OPERATOR
#undef POLHODE_OF_ONE
#undef POLHODE_OF_TWO
}
/// The operand's number -> the operand, in `operand`.
template <class T, class Operand>
[[nodiscard]] T value_of_call(const tape& t, const instruction& i, const Operand& operand) {
  const call_of_further& call = t.calls[static_cast<std::size_t>(i.number)];
  std::vector<T> arguments;
  arguments.reserve(call.operands.size());
  for (const std::uint32_t o : call.operands) arguments.push_back(operand(o));
  return value_over<T>(*call.function, arguments);
}

/// The real number enclosed by x, as a T.
template <class T>
[[nodiscard]] T converted(const ball& x) {
  if constexpr (requires { supplement<T>::from(x); }) {
    return supplement<T>::from(x);
  } else {
    return T(x);
  }
}

/// A copy of the same precision.
template <class T>
[[nodiscard]] T copied(const T& x) {
  if constexpr (requires { supplement<T>::copy(x); }) {
    return supplement<T>::copy(x);
  } else {
    return x;
  }
}

/// What the part of a program without variables gives: number(q) is a number of the formula, and
/// constant(i) a constant such as pi; seen(i, x) is told the result of each instruction.
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

/// A T that knows more of a constant than an enclosure.
template <class T>
concept symbolic = requires(const rational& q, const instruction& i) {
  { supplement<T>::number(q) } -> std::same_as<T>;
  { supplement<T>::constant(i) } -> std::same_as<T>;
};

/// What the part of a program without variables gives, at p bits.
[[nodiscard]] std::vector<ball> constants_of(const program& f, precision p);
/// The first instruction of that part whose value is undefined.
[[nodiscard]] std::optional<instruction> first_undefined(const program& f, precision p);
/// The values, exactly where it is a number of the formula, or q + r pi made of these by + - * /,
/// and else with a formula.
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
      if (const rational* q = std::get_if<rational>(&c)) {
        lifted.push_back(like.constant_like(*q));
        continue;
      }
      const known_number& value = std::get<known_number>(c);
      if constexpr (requires { like.constant_like(value); }) {
        lifted.push_back(like.constant_like(value));
      } else {
        lifted.push_back(like.constant_like(value.enclosure()));
      }
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
    } else {
      detail::execute<T>(i, slots[i.result], operand(i.left), operand(i.right));
    }
  }
  const std::uint32_t result = body.outputs.front();
  if (result >= body.inputs) return std::move(slots[result - body.inputs]);
  return detail::copied(operand(result));
}

}  // namespace polhode
