#pragma once

// A person's generic function for the templates over Real: as a formula, for the proof; as itself,
// for the values.

#include <functional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <boost/math/policies/error_handling.hpp>

#include "polhode/expression/formula_of.hpp"
#include "polhode/real/boost_math.hpp"
#include "polhode/real/number.hpp"

namespace polhode::detail {

/// What a function for a template over Real is called with to record it. Numbers of type double or
/// long double stand beside their own symbols; those of Boost's, and exact numbers, beside all.
template <class Real>
struct recording_symbol {
  using type = symbol;
};
template <std::floating_point Real>
struct recording_symbol<Real> {
  using type = machine_symbol<Real>;
};
template <class Real>
using symbol_of_real = typename recording_symbol<Real>::type;

/// While it lives, new numbers of type mpfr_float have p bits, or a few more, on this thread; for
/// other types, nothing.
template <floating_real R>
class thread_precision {
 public:
  explicit thread_precision(precision p) {
    if constexpr (has_variable_precision<R>) {
      before_ = R::thread_default_precision();
      R::thread_default_precision(static_cast<unsigned>(digits_in_bits(p)) + 1);
    }
  }
  ~thread_precision() {
    if constexpr (has_variable_precision<R>) R::thread_default_precision(before_);
  }
  thread_precision(const thread_precision&) = delete;
  thread_precision& operator=(const thread_precision&) = delete;
  thread_precision(thread_precision&&) = delete;
  thread_precision& operator=(thread_precision&&) = delete;

 private:
  unsigned before_ = 0;
};

/// Whether f(x) at an R is a number of its own, with R's digits. An expression template refers to
/// what it was made of, which may be gone when the function has returned; and an unqualified sin(x)
/// of a long double is C's, of a double.
template <class F, floating_real R>
inline constexpr bool returns_a_number = [] {
  if constexpr (std::same_as<R, long double>) {
    return false;
  } else {
    return !boost_expression<std::remove_cvref_t<std::invoke_result_t<const F&, const R&>>>;
  }
}();

/// f over R: itself where it returns numbers, else by its formula, in MPFR's arithmetic at R's
/// precision.
template <floating_real R, class F>
[[nodiscard]] std::function<R(const R&)> values_in(const F& f, const expression& formula,
                                                   precision p) {
  if constexpr (returns_a_number<F, R>) {
    return [f, p](const R& x) {
      const thread_precision<R> scope(p);
      return R(f(x));
    };
  } else {
    return [g = formula.evaluator<mpfr_float>(p), p](const R& x) {
      mpfr_float argument = zero_of_precision(p);
      ball_of(x).midpoint(argument.backend().data());
      return rounded_to<R>(g(argument).backend().data(), p, MPFR_RNDN);
    };
  }
}

/// The same as a function of balls: of the number in the middle of the argument, rounded to R.
/// Undefined where the function throws what Boost's functions throw beyond their domain or range,
/// which a rounded argument may be.
template <floating_real R, class F>
[[nodiscard]] std::function<ball(const ball&)> values_as_balls(const F& f,
                                                               const expression& formula,
                                                               precision p) {
  if constexpr (returns_a_number<F, R> || !mpfr_like<R>) {
    return [g = values_in<R>(f, formula, p), p](const ball& x) {
      try {
        return ball_of(g(nearest_as<R>(x, p)));
      } catch (const std::domain_error&) {
        return ball::undefined(p);
      } catch (const std::overflow_error&) {
        return ball::undefined(p);
      } catch (const boost::math::evaluation_error&) {
        return ball::undefined(p);
      }
    };
  } else {
    return [g = formula.evaluator<mpfr_float>(p), p](const ball& x) {
      mpfr_float argument = zero_of_precision(p);
      x.midpoint(argument.backend().data());
      return ball(g(argument));
    };
  }
}

}  // namespace polhode::detail
