#include "exact_value.hpp"
#include "polhode/expression/evaluation.hpp"

namespace polhode {
namespace detail {
namespace {

/// What f sets an MPFR number of p bits to, correctly rounded: within half a unit in the last place.
ball rounded_constant(precision p, int (*f)(mpfr_ptr, mpfr_rnd_t)) {
  mpfr_float value = zero_of_precision(p);
  f(value.backend().data(), MPFR_RNDN);
  return ball::from_midpoint_radius(
      value.backend().data(),
      magnitude::power_of_two(mpfr_get_exp(value.backend().data()) - p - 1));
}

ball without_operands(const instruction& i, precision p) {
  switch (i.what) {
    case operation::pi:
      return pi(p);
    case operation::euler_gamma:
      return rounded_constant(p, mpfr_const_euler);
    case operation::catalan:
      return rounded_constant(p, mpfr_const_catalan);
    case operation::zeta:
      return zeta(static_cast<unsigned long>(i.number), p);
    default:
      throw std::logic_error("not an operation without operands");
  }
}

}  // namespace

std::vector<ball> constants_of(const program& f, precision p) {
  return evaluate_constants<ball>(
      f, [p](const rational& q) { return ball(q, p); },
      [p](const instruction& i) { return without_operands(i, p); });
}

std::vector<ball> values_of_constants(const program& f, precision p) {
  std::vector<ball> result;
  result.reserve(f.constants.code.size());
  static_cast<void>(evaluate_constants<ball>(
      f, [p](const rational& q) { return ball(q, p); },
      [p](const instruction& i) { return without_operands(i, p); },
      [&result](const instruction&, const ball& x) { result.push_back(x); }));
  return result;
}

std::optional<instruction> first_undefined(const program& f, precision p) {
  std::optional<instruction> first;
  static_cast<void>(evaluate_constants<ball>(
      f, [p](const rational& q) { return ball(q, p); },
      [p](const instruction& i) { return without_operands(i, p); },
      [&first](const instruction& i, const ball& x) {
        if (!first && x.is_undefined()) first = i;
      }));
  return first;
}

std::vector<possibly_exact_constant> possibly_exact_constants_of(const program& f, precision p) {
  std::vector<possibly_exact_constant> result;
  std::size_t k = 0;
  for (ball& x : constants_of(f, p)) {
    const std::uint32_t source = f.constants.outputs[k++];
    result.push_back({std::move(x), std::nullopt});
    if (source < f.constants.inputs) result.back().exact = f.numbers[source];
  }
  return result;
}

}  // namespace detail

template class compiled_expression<ball>;

}  // namespace polhode
