#include "proofs/body_facts.hpp"

#include <algorithm>
#include <array>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/inertia_tensor.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "statements/shared.hpp"

namespace polhode::proofs {
namespace {

constexpr std::array<precision, 4> precisions{128, 512, 2048, 8192};

/// Of f(s) - target: proved, or unknown.
certain_sign side_of(const std::function<ball(const rational& s, precision p)>& f,
                     const std::function<ball(precision p)>& target, const rational& s) {
  for (const precision p : precisions) {
    const ball value = f(s, p);
    const ball wanted = target(p);
    if (certainly_less(wanted, value)) return certain_sign::positive;
    if (certainly_less(value, wanted)) return certain_sign::negative;
  }
  return certain_sign::unknown;
}

rational power_of_half(long k) {
  return rational(integer(1), integer(1) << static_cast<unsigned>(k));
}

/// The k with 2^-k <= q < 2^(1-k), for 0 < q < 1.
long halvings(const rational& q) {
  const auto difference = static_cast<long>(msb(integer(denominator(q)))) -
                          static_cast<long>(msb(integer(numerator(q))));
  return q < power_of_half(difference) ? difference + 1 : difference;
}

ball enclosed(const enclosing_function& f, long digits, const body& rigid) {
  const precision guard =
      15 * bits_for_digits(digits) + 1024 + 8 * (size_in_bits(rigid.a()) + size_in_bits(rigid.b()));
  return enclose_to_digits(f, digits, guard);
}

void add_constant(certificate& c, const std::string& name, const std::optional<rational>& exact,
                  bool exact_holds, const enclosing_function& f, long digits, const body& rigid) {
  if (exact) {
    c.facts.push_back({statements::fill(statements::exact_constant, {name, to_text(*exact)}),
                       exact_holds, step_kind::exact});
  } else {
    add_number(c, name, f, digits, rigid);
  }
}

}  // namespace

body requested_body(certificate& c, const request& wanted) {
  if (!wanted.tensor) {
    c.inputs.emplace_back("a", wanted.motion.a.exact());
    c.inputs.emplace_back("b", wanted.motion.b.exact());
    return {wanted.motion.a, wanted.motion.b};
  }
  const auto& entries = wanted.tensor->entries();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    c.inputs.emplace_back(statements::entries_of_tensor[i], entries[i]);
  }
  return body::from_inertia_tensor(wanted.tensor);
}

void add_number(certificate& c, const std::string& name, const enclosing_function& f, long digits,
                const body& rigid) {
  c.numbers.push_back({name, enclosed(f, digits, rigid), digits});
}

void add_number_or_note(certificate& c, const std::string& name, const enclosing_function& f,
                        long digits, const body& rigid) {
  const ball value = enclosed(f, digits, rigid);
  if (value.is_bounded()) {
    c.numbers.push_back({name, value, digits});
  } else {
    note_missing_witness(c, statements::fill(statements::enclosure_of, {name}));
  }
}

void part_last_numbers(certificate& c, const std::string& f_name, const enclosing_function& f,
                       const std::string& g_name, const enclosing_function& g) {
  if (c.numbers.size() < 2) return;
  enclosed_number& first = c.numbers[c.numbers.size() - 2];
  enclosed_number& second = c.numbers[c.numbers.size() - 1];
  if (first.name != f_name || second.name != g_name) return;
  for (const precision p : precisions) {
    if (!overlaps(first.enclosure, second.enclosure)) return;
    const ball x = f(p);
    const ball y = g(p);
    if (!x.is_bounded() || !y.is_bounded()) continue;
    const ball narrower = intersection(x, first.enclosure);
    const ball other = intersection(y, second.enclosure);
    if (narrower.is_undefined() || other.is_undefined()) return;
    first.enclosure = narrower;
    second.enclosure = other;
  }
}

void add_geometric_constant(certificate& c, const body& rigid, long digits) {
  const auto exact = rigid.exact_geometric_constant();
  add_constant(
      c, "I", exact,
      exact && *exact > 0 && *exact * *exact == rigid.square_of_geometric_constant().exact(),
      [&](precision p) { return rigid.geometric_constant(p); }, digits, rigid);
}

void add_second_geometric_constant(certificate& c, const body& rigid, long digits) {
  const auto exact = rigid.exact_second_geometric_constant();
  add_constant(
      c, "J", exact,
      exact && *exact > 0 &&
          (*exact + 1) * (*exact + 1) == rigid.square_of_second_constant().exact(),
      [&](precision p) { return rigid.second_geometric_constant(p); }, digits, rigid);
}

bool is_decided(const std::function<bool(precision p)>& condition) {
  for (const precision p : precisions) {
    if (condition(p)) return true;
  }
  return false;
}

ball half_phase(const body& rigid, const rational& u, precision p) {
  return scale(montgomery_phase(rigid, -rigid.b() * u, p), -1);
}

rational between(const rational& lower, const rational& upper) {
  rational middle((lower + upper) / 2);
  const rational from_one(1 - lower);
  const rational nearer(1 - upper);
  if (upper > 4 * lower) {
    middle = power_of_half((halvings(lower) + halvings(upper)) / 2);
  } else if (from_one > 4 * nearer) {
    middle = 1 - power_of_half((halvings(from_one) + halvings(nearer)) / 2);
  }
  return lower < middle && middle < upper ? middle : rational((lower + upper) / 2);
}

std::optional<root_bracket> bracket_root(
    const std::function<ball(const rational& s, precision p)>& f,
    const std::function<ball(precision p)>& target, int bits) {
  constexpr long most_halvings = 1L << 14;
  std::optional<rational> lower;
  std::optional<rational> upper;
  for (long k = 1; k <= most_halvings && !(lower && upper); k *= 2) {
    const rational step = power_of_half(k);
    if (!lower && side_of(f, target, step) == certain_sign::positive) lower = step;
    if (!upper && side_of(f, target, 1 - step) == certain_sign::negative)
      upper = rational(1 - step);
  }
  if (!lower || !upper) return std::nullopt;
  root_bracket result{*lower, *upper};
  const rational tolerance = power_of_half(bits);
  while (result.upper - result.lower > tolerance * result.lower ||
         result.upper - result.lower > tolerance * (1 - result.upper)) {
    const rational middle = between(result.lower, result.upper);
    const certain_sign side = side_of(f, target, middle);
    if (side == certain_sign::unknown) break;
    (side == certain_sign::positive ? result.lower : result.upper) = middle;
  }
  return result;
}

void note_missing_witness(certificate& c, const std::string& what) {
  c.method += statements::fill(statements::missing_witness, {what});
}

void add_comparisons(certificate& c, const std::string& statement, const std::string& what,
                     const std::function<std::vector<comparison>(precision p)>& comparisons) {
  bool refuted = false;
  const bool decided = is_decided([&](precision p) {
    const std::vector<comparison> all = comparisons(p);
    refuted = std::any_of(all.begin(), all.end(), [](const comparison& x) {
      return certainly_less_equal(x.greater, x.less);
    });
    return refuted || std::all_of(all.begin(), all.end(), [](const comparison& x) {
             return certainly_less(x.less, x.greater);
           });
  });
  if (decided) {
    c.facts.push_back({statement, !refuted, step_kind::enclosed});
  } else {
    note_missing_witness(c, what);
  }
}

std::string in_decimals(const root_bracket& bracket) {
  constexpr long digits = 10;
  const auto decimal = [](const rational& q) {
    return to_decimal_enclosure(ball(q, size_in_bits(q) + 64), digits);
  };
  return decimal(bracket.lower).lower + " and " + decimal(bracket.upper).upper;
}

json as_json(const root_bracket& bracket) {
  return json{{"lower", to_text(bracket.lower)}, {"upper", to_text(bracket.upper)}};
}

}  // namespace polhode::proofs
