#pragma once

// What a double or an mpfr_float does beside a ball: it does not compile, with one sentence that
// says what to write.
//
// 0.1 is a decimal only by accident, and an mpfr_float carries an error that no one knows: a result
// would enclose something else than what was meant, in silence. Without these operators the
// compiler says so in thousands of lines, one for each scalar that an integrand is called with; and
// pow(x, 0.5) would be pow(x, 0).

#include <concepts>

#include "polhode/arithmetic/ball.hpp"

namespace polhode {

namespace detail {

/// Of Boost's floating-point numbers, and of expressions of them (whose kind is a category of
/// Boost's).
template <class N>
concept boost_float = mpfr_like<N> || requires {
  typename N::proto_tag;
};

template <class N>
concept inexact_number = std::floating_point<N> ||
    (boost_float<N> && !integer_like<N> && !rational_like<N>);

template <class>
inline constexpr bool never = false;

/// Made into a type once for each N, however many scalars meet it: one error.
template <class N>
struct exact_number_needed {
  static_assert(never<N>,
                "Polhode: a double, float or mpfr_float in a formula is not an exact number. Write "
                "x / 2 for 0.5 * x, "
                "polhode::rational(1, 10) for 0.1, polhode::parse_rational(\"0.1\") for a text, or "
                "polhode::rational(c) "
                "for a c that is meant as the exact number it is");
  static constexpr bool reported = true;
};

/// Of the types that a generic function of this library is called with: they say so by a member.
template <class X, class N>
concept exact_beside_inexact = X::takes_exact_numbers && inexact_number<N>;

}  // namespace detail

#define POLHODE_REFUSE_INEXACT(name)                                         \
  template <class X, class N>                                                \
  requires detail::exact_beside_inexact<X, N> X name(const X& x, const N&) { \
    static_assert(detail::exact_number_needed<N>::reported);                 \
    return x;                                                                \
  }                                                                          \
  template <class X, class N>                                                \
  requires detail::exact_beside_inexact<X, N> X name(const N&, const X& x) { \
    static_assert(detail::exact_number_needed<N>::reported);                 \
    return x;                                                                \
  }
POLHODE_REFUSE_INEXACT(operator+)
POLHODE_REFUSE_INEXACT(operator-)
POLHODE_REFUSE_INEXACT(operator*)
POLHODE_REFUSE_INEXACT(operator/)
POLHODE_REFUSE_INEXACT(pow)
#undef POLHODE_REFUSE_INEXACT

}  // namespace polhode
