#include "exact_value.hpp"
#include "graph.hpp"
#include "polhode/expression/evaluation.hpp"

namespace polhode {
namespace detail {
namespace {

/// What f sets an MPFR number of p bits to, correctly rounded: within half a unit in the last
/// place.
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

namespace {

/// x times y, where one of them is rational.
std::optional<pi_combination> product_of(const pi_combination& x, const pi_combination& y) {
  if (y.is_rational()) return x * y.q;
  return x.is_rational() ? std::optional(y * x.q) : std::nullopt;
}

/// The result of an instruction for exact numbers, where that is one of the form.
std::optional<pi_combination> exact_result(const instruction& i,
                                           const std::optional<pi_combination>& x,
                                           const std::optional<pi_combination>& y) {
  if (i.what == operation::pi) return pi_combination{0, 1};
  if (!x) return std::nullopt;
  if (i.what == operation::negate) return -*x;
  if (!y) return std::nullopt;
  switch (i.what) {
    case operation::add:
      return *x + *y;
    case operation::subtract:
      return *x - *y;
    case operation::multiply:
      return product_of(*x, *y);
    case operation::divide:
      if (!y->is_rational() || y->q == 0) return std::nullopt;
      return *x * rational(1 / y->q);
    default:
      return std::nullopt;
  }
}

/// The formula of an instruction: null where it is not of exact numbers, or of a function beyond
/// the table.
exact_formula::pointer formula_of(const instruction& i, const exact_formula::pointer& x,
                                  const exact_formula::pointer& y) {
  const auto whole = [&] { return exact_formula::of(pi_combination{rational(i.number), 0}); };
  switch (i.what) {
    case operation::further:
      return nullptr;
    case operation::zeta:
      return exact_formula::of("zeta", {whole()});
    case operation::negate:
      return exact_formula::of("-", {x});
    case operation::power_integer:
      return exact_formula::of("pow", {x, whole()});
    case operation::root:
      return exact_formula::of("root", {x, whole()});
    case operation::add:
      return exact_formula::of("+", {x, y});
    case operation::subtract:
      return exact_formula::of("-", {x, y});
    case operation::multiply:
      return exact_formula::of("*", {x, y});
    case operation::divide:
      return exact_formula::of("/", {x, y});
    case operation::power:
      return exact_formula::of("pow", {x, y});
    default:
      break;
  }
  const int count = operands_of(i.what);
  if (count == 0) return exact_formula::of(name_of(i.what));
  return count == 1 ? exact_formula::of(name_of(i.what), {x})
                    : exact_formula::of(name_of(i.what), {x, y});
}

}  // namespace

std::vector<possibly_exact_constant> possibly_exact_constants_of(const program& f, precision p) {
  const tape& t = f.constants;
  struct slot {
    std::optional<pi_combination> exact;
    exact_formula::pointer formula;  // where it is not exact
  };
  std::vector<slot> slots(t.slots);
  const auto exactly = [&](std::uint32_t i) -> std::optional<pi_combination> {
    if (i < t.inputs) return pi_combination{f.numbers[i], 0};
    return slots[i - t.inputs].exact;
  };
  const auto formula = [&](std::uint32_t i) {
    const auto exact = exactly(i);
    return exact ? exact_formula::of(*exact) : slots[i - t.inputs].formula;
  };
  for (const instruction& i : t.code) {
    const bool has_operands = i.what >= operation::negate && i.what != operation::further;
    slot result;
    result.exact = has_operands ? exact_result(i, exactly(i.left), exactly(i.right))
                                : exact_result(i, std::nullopt, std::nullopt);
    if (!result.exact) {
      result.formula = has_operands ? formula_of(i, formula(i.left), formula(i.right))
                                    : formula_of(i, nullptr, nullptr);
    }
    slots[i.result] = std::move(result);
  }
  std::vector<possibly_exact_constant> result;
  result.reserve(t.outputs.size());
  std::vector<ball> values;  // of the outputs, where one of them is not exact
  for (std::size_t k = 0; k < t.outputs.size(); ++k) {
    const std::uint32_t i = t.outputs[k];
    if (auto exact = exactly(i)) {
      if (exact->is_rational()) {
        result.emplace_back(std::move(exact->q));
      } else {
        result.emplace_back(known_number(*exact, p));
      }
      continue;
    }
    if (values.empty()) values = constants_of(f, p);
    result.emplace_back(known_number(std::move(values[k]), slots[i - t.inputs].formula));
  }
  return result;
}

}  // namespace detail

template class compiled_expression<ball>;

}  // namespace polhode
