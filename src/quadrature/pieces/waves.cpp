#include "waves.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "polhode/expression/library_functions.hpp"
#include "quadrature/formula/arithmetics.hpp"

namespace polhode::detail::oscillations {

namespace {

/// A number by its name: the same name stands for the same number.
struct constant {
  symbol value;
  std::string name;
};

/// q times a constant; q alone where there is none.
struct coefficient {
  rational q = 1;
  std::optional<constant> factor = std::nullopt;
};

constant operator*(const constant& x, const constant& y) {
  const auto& [first, second] = std::minmax(x.name, y.name);
  return {x.value * y.value, fmt::format("({} * {})", first, second)};
}

/// About how long the numerator and the denominator are.
std::size_t bits_of(const rational& q) {
  return mpz_sizeinbase(numerator(q).backend().data(), 2) +
         mpz_sizeinbase(denominator(q).backend().data(), 2);
}
/// Longer numbers and names are not followed: nested powers would make them as long as they like.
constexpr std::size_t most_exact_bits = 4096;
constexpr std::size_t longest_name = 1024;

/// The sum of c_e y^e, without zeros.
using power_sum = std::map<rational, coefficient>;

/// The sum of amplitudes times e^(i w y). Real for real y: the amplitudes of w and -w are
/// conjugate.
struct wave {
  std::map<frequency, amplitude> terms;
  /// The part that does not oscillate, where it is known.
  std::optional<power_sum> powers;

  /// Only the frequency without terms, which is 0.
  [[nodiscard]] bool is_steady() const {
    return terms.empty() || (terms.size() == 1 && terms.begin()->first.empty());
  }
};

std::optional<symbol> sum_of(const std::optional<symbol>& x, const std::optional<symbol>& y) {
  if (!x || !y) return x ? x : y;
  return *x + *y;
}
std::optional<symbol> negative(const std::optional<symbol>& x) {
  return x ? std::optional(-*x) : std::nullopt;
}
std::optional<symbol> product(const std::optional<symbol>& x, const std::optional<symbol>& y) {
  return x && y ? std::optional(*x * *y) : std::nullopt;
}
amplitude operator+(const amplitude& x, const amplitude& y) {
  return {sum_of(x.re, y.re), sum_of(x.im, y.im)};
}
amplitude operator*(const amplitude& x, const amplitude& y) {
  return {sum_of(product(x.re, y.re), negative(product(x.im, y.im))),
          sum_of(product(x.re, y.im), product(x.im, y.re))};
}
amplitude conjugate(const amplitude& x) { return {x.re, negative(x.im)}; }

/// A function of the table, or a power.
symbol applied(const formula_node& node, const symbol& x, const symbol& y) {
  const char* name = node.what == operation::power ? "pow" : name_of(node.what);
  return operands_of(node.what) == 2 ? symbol::call(name, {x, y}) : symbol::call(name, {x});
}

frequency sum_of(frequency x, const frequency& y) {
  for (const auto& [name, q] : y) {
    rational& sum = x[name];
    sum += q;
    if (sum == 0) x.erase(name);
  }
  return x;
}
frequency negative(frequency x) {
  for (auto& [name, q] : x) q = -q;
  return x;
}

/// The waves of f's nodes, one after the other.
class separation {
 public:
  separation(std::shared_ptr<const formula_graph> f, const end_point& at, const end_point& s,
             const rational& theta, int sign)
      : f_(std::move(f)) {
    const coefficient start = number(at, "p");
    const coefficient distance = number(s, "s");
    x_.powers = power_sum{{theta, distance}};
    if (start.q != 0) x_.powers->emplace(rational(0), start);
    x_.terms[{}].re = value(*x_.powers);
    const rational size = sign * abs(theta);
    const coefficient scale{distance.q * size, distance.factor};
    factor_ = value({{rational(theta - 1), scale}});
  }

  [[nodiscard]] separated result() {
    separated result;
    result.terms = terms();
    result.growth = growth_;
    result.constants = std::move(constants_);
    result.numbers = std::move(numbers_);
    result.amplitudes = std::move(amplitudes_);
    result.positive = std::move(positive_);
    return result;
  }

 private:
  /// Nothing where f is not a sum of oscillations.
  [[nodiscard]] std::optional<std::map<frequency, amplitude>> terms() {
    std::vector<std::optional<wave>> waves(f_->size());
    for (std::size_t i = 0; i < f_->size(); ++i) {
      waves[i] = of_node(f_->node(i), waves);
      if (!waves[i]) return std::nullopt;
    }
    std::map<frequency, amplitude> result;
    for (const auto& [w, a] : waves[f_->result()]->terms) {
      result[w] = amplitude{factor_, std::nullopt} * a;
    }
    return result;
  }
  /// A new variable for a number.
  [[nodiscard]] constant numbered(std::string name,
                                  std::function<possibly_exact_constant(precision)> at) {
    numbers_.push_back(std::move(at));
    return {symbol::variable(first_number + numbers_.size() - 1), std::move(name)};
  }
  [[nodiscard]] coefficient number(const end_point& x, const char* name) {
    if (x.exact()) return {*x.exact()};
    return {1, numbered(name, [x](precision p) { return known_number(x.at(p)); })};
  }
  [[nodiscard]] static symbol value(const coefficient& c) {
    if (!c.factor) return c.q;
    return c.q == 1 ? c.factor->value : c.factor->value * c.q;
  }
  [[nodiscard]] symbol value(const power_sum& x) const {
    std::optional<symbol> sum;
    for (const auto& [e, c] : x) {
      if (e == 0) {
        sum = sum_of(sum, value(c));
        continue;
      }
      const symbol power = e == 1 ? y_ : pow(y_, symbol(e));
      sum = sum_of(sum, !c.factor && c.q == 1 ? power : power * value(c));
    }
    return sum ? *sum : symbol(0);
  }
  /// Of a steady one.
  [[nodiscard]] static symbol value(const wave& x) {
    if (x.terms.empty() || !x.terms.begin()->second.re) return 0;
    return *x.terms.begin()->second.re;
  }

  [[nodiscard]] static wave steady(symbol value, std::optional<power_sum> powers = {}) {
    wave result;
    if (!powers || !powers->empty()) result.terms[{}].re = std::move(value);
    result.powers = std::move(powers);
    return result;
  }
  [[nodiscard]] static bool is_constant(const wave& x) {
    return x.is_steady() && x.powers &&
           std::all_of(x.powers->begin(), x.powers->end(),
                       [](const auto& term) { return term.first == 0; });
  }

  static coefficient times(const coefficient& x, const coefficient& y) {
    coefficient result{x.q * y.q, x.factor};
    if (y.factor) result.factor = x.factor ? *x.factor * *y.factor : *y.factor;
    return result;
  }
  static std::string name_of(const coefficient& c) {
    return c.factor ? fmt::format("{} {}", c.q.str(), c.factor->name) : c.q.str();
  }
  static void add(power_sum& sum, const rational& e, const coefficient& c) {
    const auto [place, is_new] = sum.emplace(e, c);
    if (is_new) return;
    coefficient& known = place->second;
    const bool same = known.factor.has_value() == c.factor.has_value() &&
                      (!c.factor || known.factor->name == c.factor->name);
    if (same) {
      known.q += c.q;
      if (known.q == 0) sum.erase(place);
    } else {
      known = {1, constant{value(known) + value(c),
                           fmt::format("({} + {})", name_of(known), name_of(c))}};
    }
  }
  [[nodiscard]] std::optional<power_sum> sum_of_powers(const wave& x, const wave& y) const {
    if (!x.powers || !y.powers) return std::nullopt;
    power_sum sum = *x.powers;
    for (const auto& [e, c] : *y.powers) add(sum, e, c);
    return unless_long(std::move(sum));
  }
  [[nodiscard]] std::optional<power_sum> product_of_powers(const wave& x, const wave& y) const {
    constexpr std::size_t most_terms = 16;
    if (!x.powers || !y.powers || x.powers->size() * y.powers->size() > most_terms) {
      return std::nullopt;
    }
    power_sum sum;
    for (const auto& [e, c] : *x.powers) {
      for (const auto& [g, d] : *y.powers) add(sum, e + g, times(c, d));
    }
    return unless_long(std::move(sum));
  }
  [[nodiscard]] static std::optional<power_sum> unless_long(power_sum x) {
    const bool is_long = std::any_of(x.begin(), x.end(), [](const auto& term) {
      const auto& [e, c] = term;
      return bits_of(e) + bits_of(c.q) > most_exact_bits ||
             (c.factor && c.factor->name.size() > longest_name);
    });
    return is_long ? std::nullopt : std::optional(std::move(x));
  }
  /// One power to the e. Of a negative number only a whole one is taken, and of a constant that is
  /// not a rational number none.
  [[nodiscard]] std::optional<power_sum> power_of_powers(const wave& x, const rational& e) const {
    if (!x.powers || x.powers->size() != 1) return std::nullopt;
    const auto& [g, c] = *x.powers->begin();
    if (16 * (bits_of(c.q) + bits_of(e) + bits_of(g)) > most_exact_bits) return std::nullopt;
    coefficient result = c;
    if (c.factor) {
      if (e == -1) {
        result = {1 / c.q, constant{1 / c.factor->value, fmt::format("1/{}", c.factor->name)}};
      } else if (e != 1) {
        return std::nullopt;
      }
    } else if (c.q != 1) {
      if (denominator(e) != 1 || abs(numerator(e)) > 16) {
        if (c.q <= 0) return std::nullopt;
        result = {
            1, constant{pow(symbol(c.q), symbol(e)), fmt::format("({} ^ {})", c.q.str(), e.str())}};
      } else {
        const auto n = static_cast<long>(numerator(e));
        result.q = 1;
        for (long k = 0; k < std::abs(n); ++k) result.q *= c.q;
        if (n < 0) result.q = 1 / result.q;
      }
    }
    return power_sum{{rational(g * e), result}};
  }

  [[nodiscard]] wave negated(const wave& x) const {
    wave result;
    for (const auto& [w, a] : x.terms) result.terms[w] = {negative(a.re), negative(a.im)};
    if (x.powers) {
      result.powers = *x.powers;
      for (auto& [e, c] : *result.powers) c.q = -c.q;
    }
    return result;
  }
  [[nodiscard]] std::optional<wave> sum(const wave& x, const wave& y) const {
    if (x.is_steady() && y.is_steady()) {
      return steady(value(x) + value(y), sum_of_powers(x, y));
    }
    wave result;
    result.terms = x.terms;
    for (const auto& [w, a] : y.terms) result.terms[w] = result.terms[w] + a;
    result.powers = sum_of_powers(x, y);
    if (result.powers) {
      // A part that cancels is 0, not a difference of numbers.
      result.terms.erase(frequency{});
      if (!result.powers->empty()) result.terms[{}].re = value(*result.powers);
    }
    return limited(std::move(result));
  }
  [[nodiscard]] std::optional<wave> times(const wave& x, const wave& y) const {
    if (x.is_steady() && y.is_steady()) {
      return steady(value(x) * value(y), product_of_powers(x, y));
    }
    wave result;
    for (const auto& [w, a] : x.terms) {
      for (const auto& [v, b] : y.terms) {
        amplitude& at = result.terms[sum_of(w, v)];
        at = at + a * b;
      }
    }
    if (!result.terms.contains(frequency{})) result.powers.emplace();
    return limited(std::move(result));
  }
  [[nodiscard]] static std::optional<wave> limited(wave x) {
    constexpr std::size_t most_terms = 64;
    if (x.terms.size() > most_terms) return std::nullopt;
    return x;
  }
  [[nodiscard]] std::optional<wave> quotient(const wave& x, const wave& y) const {
    if (!y.is_steady()) return std::nullopt;
    if (x.is_steady()) {
      wave inverse;
      inverse.powers = power_of_powers(y, -1);
      return steady(value(x) / value(y), product_of_powers(x, inverse));
    }
    return times(x, steady(1 / value(y)));
  }
  [[nodiscard]] std::optional<wave> power(const wave& x, const rational& e) const {
    if (x.is_steady()) return steady(pow(value(x), symbol(e)), power_of_powers(x, e));
    constexpr long most = 16;
    if (denominator(e) != 1 || e < 1 || e > most) return std::nullopt;
    wave result = x;
    for (long k = 1; k < static_cast<long>(numerator(e)); ++k) {
      std::optional<wave> next = times(result, x);
      if (!next) return std::nullopt;
      result = *std::move(next);
    }
    return result;
  }

  /// sin or cos. e^(iR)/(2i) = (sin R - i cos R)/2, e^(iR)/2 = (cos R + i sin R)/2.
  [[nodiscard]] std::optional<wave> circular(const wave& x, bool sine) {
    if (!x.is_steady()) return std::nullopt;
    const auto grows = [](const auto& term) { return term.first > 0; };
    if (!x.powers || std::none_of(x.powers->begin(), x.powers->end(), grows)) {
      const symbol v = value(x);
      return steady(sine ? sin(v) : cos(v));
    }
    if (x.powers->rbegin()->first != 1) {
      growth_ = x.powers->rbegin()->first;
      return std::nullopt;
    }
    power_sum rest = *x.powers;
    const coefficient w = rest.rbegin()->second;
    rest.erase(std::prev(rest.end()));
    if (std::any_of(rest.begin(), rest.end(), grows)) return std::nullopt;
    amplitude a;
    const rational half(1, 2);
    const symbol r = value(rest);
    const symbol cosine = rest.empty() ? symbol(half) : cos(r) * half;
    const std::optional<symbol> sine_of_rest =
        rest.empty() ? std::nullopt : std::optional(sin(r) * half);
    a.re = sine ? sine_of_rest : cosine;
    a.im = sine ? -cosine : sine_of_rest;
    wave result;
    const frequency key{{w.factor ? w.factor->name : "", w.q}};
    if (w.factor) constants_.emplace(w.factor->name, w.factor->value);
    result.terms[key] = a;
    result.terms[negative(key)] = conjugate(a);
    result.powers.emplace();
    return result;
  }
  /// Of pi x.
  [[nodiscard]] std::optional<wave> circular_of_pi(const wave& x, bool sine) {
    const std::optional<wave> product =
        times(x, steady(pi().value, power_sum{{rational(0), coefficient{1, pi()}}}));
    return product ? circular(*product, sine) : product;
  }

  std::optional<wave> of_node(const formula_node& node,
                              const std::vector<std::optional<wave>>& waves) {
    if (node.is_argument()) return x_;
    if (node.is_constant()) return of_constant(node);
    if (node.is_call()) return of_call(f_->call_at(node), waves);
    if (node.is_piecewise()) return std::nullopt;
    return of_function(node, *waves[node.left], *waves[node.right]);
  }
  /// Bessel's J and Y of a rational order, sine, cosine and Fresnel's integrals, and Airy functions
  /// towards minus infinity.
  [[nodiscard]] std::optional<wave> of_call(const formula_graph::call& call,
                                            const std::vector<std::optional<wave>>& waves) {
    // A function of this name in another list may be anything.
    const further_functions& own = *library_functions();
    const bool is_own =
        std::ranges::any_of(own, [&](const auto& f) { return &f == call.function; });
    const wave& x = *waves[call.operands.back()];
    if (!is_own || !x.is_steady() || !x.powers || x.powers->empty()) return std::nullopt;
    const std::string& name = call.function->what.name;
    if (name == "besselJ" || name == "besselY") {
      const std::optional<rational>& order = f_->node(call.operands[0]).exact;
      return order ? bessel(*order, x, name == "besselJ") : std::nullopt;
    }
    if (name == "Ci") return oscillating({integrals, 0}, x, false);
    if (name == "Si" || name == "fresnelS" || name == "fresnelC") return odd_integral(name, x);
    return airy(name, x);
  }
  static constexpr auto integrals = wave_function::family::integral_of_power;

  /// P cos + Q sin, or P sin - Q cos, of w y + c; not where w < 0 or c < 0 is known.
  [[nodiscard]] std::optional<wave> oscillating(const wave_function& f, const wave& x,
                                                bool first_kind) {
    const auto& [e, slope] = *x.powers->rbegin();
    if (e > 0 && e != 1) growth_ = e;
    if (e != 1 || !may_be_positive(slope)) return std::nullopt;
    power_sum shift = *x.powers;
    shift.erase(std::prev(shift.end()));
    const bool is_shifted = !shift.empty();
    if (is_shifted && (shift.size() != 1 || shift.begin()->first != 0 ||
                       !may_be_positive(shift.begin()->second))) {
      return std::nullopt;
    }
    const std::size_t variable = first_number + numbers_.size();
    numbers_.insert(numbers_.end(), 2, nullptr);
    amplitudes_.push_back({variable, f, value(slope), value(shift)});
    const wave p = steady(symbol::variable(variable));
    const wave q = steady(symbol::variable(variable + 1));
    const std::optional<wave> sine = circular(x, true);
    const std::optional<wave> cosine = circular(x, false);
    if (!sine || !cosine) return std::nullopt;
    const std::optional<wave> with_p = times(p, first_kind ? *cosine : *sine);
    const std::optional<wave> with_q = times(q, first_kind ? *sine : negated(*cosine));
    return with_p && with_q ? sum(*with_p, *with_q) : std::nullopt;
  }
  /// A minus sign leads it. What the sign of its number is the decomposition asks.
  [[nodiscard]] static bool has_minus(const wave& x) { return x.powers->rbegin()->second.q < 0; }
  [[nodiscard]] std::optional<wave> bessel(const rational& order, const wave& x, bool first_kind) {
    // J(-x) = (-1)^order J(x) for a whole order.
    const bool is_mirrored = first_kind && has_minus(x) && denominator(order) == 1;
    const std::optional<wave> result = oscillating({wave_function::family::bessel, order},
                                                   is_mirrored ? negated(x) : x, first_kind);
    const bool changes_sign = is_mirrored && numerator(order) % 2 != 0;
    return result && changes_sign ? negated(*result) : result;
  }
  /// pi/2 - Si(x), 1/2 - S(x) and C(x) - 1/2 are P cos + Q sin and P sin - Q cos, for x > 0 (DLMF
  /// 6.2.10, 6.2.11, 7.2.7 to 7.2.9): of Fresnel's integrals by that of t^(-1/2) e^(i t) from
  /// t = pi x^2/2 on, over sqrt(2 pi).
  [[nodiscard]] std::optional<wave> odd_integral(const std::string& name, wave x) {
    const bool is_negative = has_minus(x);
    if (is_negative) x = negated(x);
    const bool is_fresnel = name != "Si";
    std::optional<power_sum> limit = power_sum{{rational(0), coefficient{rational(1, 2)}}};
    if (!is_fresnel) limit->begin()->second.factor = pi();
    std::optional<wave> tail;
    if (is_fresnel) {
      const auto& [e, slope] = *x.powers->rbegin();
      if (e <= 0 || x.powers->size() != 1) return std::nullopt;
      positive_.push_back(value(slope));
      const power_sum phase{
          {rational(2 * e), times(coefficient{rational(1, 2), pi()}, times(slope, slope))}};
      tail =
          oscillating({integrals, rational(1, 2)}, steady(value(phase), phase), name == "fresnelS");
      if (tail) tail = times(*tail, steady(1 / sqrt(2 * pi().value)));
    } else {
      tail = oscillating({integrals, 0}, x, true);
    }
    if (!tail) return std::nullopt;
    if (name != "fresnelC") tail = negated(*tail);
    const std::optional<wave> result = sum(steady(value(*limit), limit), *tail);
    return result && is_negative ? negated(*result) : result;
  }
  /// With t = (2/3) z^(3/2), z > 0 (DLMF 9.6.6 to 9.6.9):
  ///   Ai(-z) = sqrt(z)/3 (J_(1/3) + J_(-1/3))(t),    Bi(-z) = sqrt(z/3) (J_(-1/3) - J_(1/3))(t),
  ///   Ai'(-z) = z/3 (J_(2/3) - J_(-2/3))(t),         Bi'(-z) = z/sqrt(3) (J_(-2/3) + J_(2/3))(t).
  /// Of z = w y^e, w > 0 rational.
  [[nodiscard]] std::optional<wave> airy(const std::string& name, const wave& x) {
    const bool is_prime = name.ends_with("Prime");
    const bool is_first = name.starts_with("airyAi");
    if (!is_first && !name.starts_with("airyBi")) return std::nullopt;
    const coefficient& w = x.powers->rbegin()->second;
    if (x.powers->size() != 1 || x.powers->rbegin()->first <= 0 || w.factor || w.q >= 0) {
      return std::nullopt;
    }
    const wave z = negated(x);
    std::optional<power_sum> t = power_of_powers(z, rational(3, 2));
    if (!t) return std::nullopt;
    for (auto& [e, c] : *t) c.q *= rational(2, 3);
    const wave phase = steady(value(*t), t);
    const rational order(is_prime ? 2 : 1, 3);
    const std::optional<wave> plus = bessel(order, phase, true);
    const std::optional<wave> minus = bessel(-order, phase, true);
    if (!plus || !minus) return std::nullopt;
    const bool is_difference = is_prime == is_first;
    const std::optional<wave> both = is_first ? sum(*plus, is_difference ? negated(*minus) : *minus)
                                              : sum(*minus, is_difference ? negated(*plus) : *plus);
    const symbol size = value(*z.powers);
    const symbol root = sqrt(symbol(3));
    const symbol factor = is_prime ? size / (is_first ? symbol(3) : root)
                                   : sqrt(size) / (is_first ? symbol(3) : root);
    return both ? times(*both, steady(factor)) : std::nullopt;
  }
  /// Of other numbers the decomposition asks.
  [[nodiscard]] static bool may_be_positive(const coefficient& c) { return c.factor || c.q > 0; }
  [[nodiscard]] wave of_constant(const formula_node& node) {
    const coefficient c = node.exact ? coefficient{*node.exact} : number(node);
    power_sum powers;
    if (c.q != 0) powers.emplace(rational(0), c);
    return steady(value(c), powers);
  }
  /// A constant of f that is not known to be rational.
  [[nodiscard]] coefficient number(const formula_node& node) {
    const auto k = static_cast<std::size_t>(node.number);
    const auto at = [f = f_, k](precision p) { return (*f->constants_at(p))[k]; };
    const auto form = std::get<known_number>(at(64)).form();
    if (form && form->q == 0) return {form->r, pi()};
    return {1, numbered(fmt::format("c{}", k), at)};
  }
  static constant pi() { return {symbol::constant("pi"), "pi"}; }
  [[nodiscard]] std::optional<wave> of_function(const formula_node& node, const wave& x,
                                                const wave& y) {
    switch (node.what) {
      case operation::negate:
        return negated(x);
      case operation::add:
        return sum(x, y);
      case operation::subtract:
        return sum(x, negated(y));
      case operation::multiply:
        return times(x, y);
      case operation::divide:
        return quotient(x, y);
      case operation::power_integer:
        return power(x, node.number);
      case operation::sqrt:
        if (!x.is_steady()) return std::nullopt;
        return steady(sqrt(value(x)), power_of_powers(x, rational(1, 2)));
      case operation::root:
        // Of a positive number the power. That it is positive from Y0 on is proved where the power
        // is bounded: powers of negative numbers have no series, and lie on a cut.
        if (!is_constant(x)) return power(x, rational(1, node.number));
        break;
      case operation::power: {
        const std::optional<rational>& exponent = f_->node(node.right).exact;
        if (!is_constant(x) && exponent) return power(x, *exponent);
        break;
      }
      case operation::sin:
      case operation::cos:
        if (!is_constant(x)) return circular(x, node.what == operation::sin);
        break;
      case operation::sinpi:
      case operation::cospi:
        if (!is_constant(x)) return circular_of_pi(x, node.what == operation::sinpi);
        break;
      default:
        break;
    }
    return of_steady_function(node, x, y);
  }
  /// Of a function that leaves no oscillation as one.
  [[nodiscard]] static std::optional<wave> of_steady_function(const formula_node& node,
                                                              const wave& x, const wave& y) {
    if (!x.is_steady() || !y.is_steady() || !is_known_over_analytic_balls(node.what)) {
      return std::nullopt;
    }
    const symbol v = applied(node, value(x), value(y));
    if (!is_constant(x) || !is_constant(y)) return steady(v);
    const constant c{
        v, fmt::format("{}({}, {})", static_cast<int>(node.what), name_of(x), name_of(y))};
    return steady(v, power_sum{{rational(0), coefficient{1, c}}});
  }
  static std::string name_of(const wave& constant) {
    const power_sum& powers = *constant.powers;
    return powers.empty() ? "0" : name_of(powers.begin()->second);
  }

  std::shared_ptr<const formula_graph> f_;
  symbol y_ = symbol::variable(variable_y);
  wave x_;
  std::optional<symbol> factor_;
  std::optional<rational> growth_;
  std::map<std::string, symbol> constants_;
  std::vector<std::function<possibly_exact_constant(precision)>> numbers_;
  std::vector<function_amplitudes> amplitudes_;
  std::vector<symbol> positive_;
};

}  // namespace

separated separate(const std::shared_ptr<const formula_graph>& f, const end_point& at,
                   const end_point& s, const rational& theta, int sign) {
  return separation(f, at, s, theta, sign).result();
}

}  // namespace polhode::detail::oscillations
