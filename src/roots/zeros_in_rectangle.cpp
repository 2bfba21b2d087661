#include "polhode/roots/zeros_in_rectangle.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/natural_domain.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/evaluation.hpp"
#include "polhode/expression/symbol.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/roots/function_structure.hpp"
#include "polhode/roots/real_function.hpp"

namespace polhode {
namespace zeros_impl {
namespace {

/// The set of all numbers between two, with p bits.
ball between(const rational& low, const rational& high, precision p) {
  return hull(ball(low, p), ball(high, p));
}

struct point {
  rational re;
  rational im;
};

/// |Re z - re| <= half and |Im z - im| <= half.
struct square_around {
  rational re;
  rational im;
  rational half;

  [[nodiscard]] complex_rectangle as_rectangle() const {
    return {re - half, re + half, im - half, im + half};
  }
};

bool lies_in(const complex_rectangle& inner, const complex_rectangle& outer) {
  return outer.left <= inner.left && inner.right <= outer.right && outer.bottom <= inner.bottom &&
         inner.top <= outer.top;
}
bool meets(const complex_rectangle& x, const complex_rectangle& y) {
  return x.left <= y.right && y.left <= x.right && x.bottom <= y.top && y.bottom <= x.top;
}

/// z1 to z2, which have one part in common.
struct edge {
  rational re1, im1, re2, im2;

  [[nodiscard]] complex_ball set(precision p) const {
    return {between(std::min(re1, re2), std::max(re1, re2), p),
            between(std::min(im1, im2), std::max(im1, im2), p)};
  }
  [[nodiscard]] std::array<edge, 2> halves() const {
    const rational re = (re1 + re2) / 2;
    const rational im = (im1 + im2) / 2;
    return {edge{re1, im1, re, im}, edge{re, im, re2, im2}};
  }
};

/// arg z for Re z > 0, or Im z != 0; undefined where z may be on the other side.
std::optional<ball> argument(const complex_ball& z) {
  if (!z.is_bounded()) return std::nullopt;
  const precision p = z.precision();
  if (certainly_positive(z.re)) return atan(z.im / z.re);
  if (certainly_positive(z.im)) return pi(p) / 2 - atan(z.re / z.im);
  if (certainly_negative(z.im)) return -pi(p) / 2 - atan(z.re / z.im);
  return std::nullopt;
}

/// The values of f, a formula of one variable, over z by principal values, wherever it has one;
/// undefined where nothing is known. log of a set that holds 0 has the real part's limit -inf.
complex_ball natural_value(const expression& f, const complex_ball& z) {
  const detail::program& code = f.instructions();
  const precision p = z.precision();
  std::vector<complex_ball> inputs;
  if (code.variables > 0) inputs.push_back(z);
  if (code.variables > 1) inputs.push_back(complex_ball::i(p));
  for (const ball& c : detail::constants_of(code, p)) inputs.emplace_back(c);
  if (inputs.size() != code.body.inputs) return complex_ball::undefined(p);
  std::vector<complex_ball> slots(code.body.slots);
  const auto operand = [&](std::uint32_t i) -> const complex_ball& {
    return i < inputs.size() ? inputs[i] : slots[i - inputs.size()];
  };
  for (const detail::instruction& i : code.body.code) {
    if (i.what == detail::operation::further) return complex_ball::undefined(p);
    const complex_ball& x = operand(i.left);
    complex_ball value(0, p);
    if (i.what == detail::operation::log && contains_zero(x.re) && contains_zero(x.im)) {
      const std::optional<ball> size = natural_domain::log(hypot(x.re, x.im));
      if (!size) return complex_ball::undefined(p);
      value = {*size, hull(-pi(p), pi(p))};
    } else {
      detail::execute<complex_ball>(i, value, x, operand(i.right));
    }
    if (value.is_undefined()) return value;
    slots[i.result] = std::move(value);
  }
  return operand(code.body.outputs.front());
}

/// Whether f, a formula of a real variable, has the conjugate of its value at every conjugate
/// number with an imaginary part other than 0: where the functions that have branch cuts have them
/// on the real line, and their arguments are a z + b with a != 0, which are real for real z alone.
bool has_cuts_on_the_real_line_alone(const expression& f) {
  if (f.variables().size() != 1) return false;
  const detail::program& code = f.instructions();
  const std::vector<ball> constants = detail::constants_of(code, 64);
  const auto is_constant = [&](std::uint32_t i) { return i >= 1 && i < code.body.inputs; };
  // a, of what is known to be a z + b.
  std::vector<std::optional<ball>> slots(code.body.slots);
  const auto slope = [&](std::uint32_t i) -> std::optional<ball> {
    if (i >= code.body.inputs) return slots[i - code.body.inputs];
    return ball(is_constant(i) ? 0 : 1, 64);
  };
  const auto is_real_for_real_alone = [&](std::uint32_t i) {
    const std::optional<ball> a = slope(i);
    return a && !contains_zero(*a);
  };
  using detail::operation;
  for (const detail::instruction& i : code.body.code) {
    std::optional<ball> result;
    const std::optional<ball> left = slope(i.left);
    const std::optional<ball> right = slope(i.right);
    switch (i.what) {
      case operation::negate:
        if (left) result = -*left;
        break;
      case operation::add:
        if (left && right) result = *left + *right;
        break;
      case operation::subtract:
        if (left && right) result = *left - *right;
        break;
      case operation::multiply:
        if (is_constant(i.left) && right) result = constants[i.left - 1] * *right;
        if (is_constant(i.right) && left) result = *left * constants[i.right - 1];
        break;
      case operation::divide:
        if (is_constant(i.right) && left) result = *left / constants[i.right - 1];
        break;
      case operation::power:
        if (!is_constant(i.right) || !is_real_for_real_alone(i.left)) return false;
        break;
      case operation::sqrt:
      case operation::root:
      case operation::log:
      case operation::log1p:
      case operation::asin:
      case operation::acos:
      case operation::acosh:
      case operation::atanh:
        if (!is_real_for_real_alone(i.left)) return false;
        break;
      case operation::power_integer:
      case operation::exp:
      case operation::expm1:
      case operation::sin:
      case operation::cos:
      case operation::tan:
      case operation::sinh:
      case operation::cosh:
      case operation::tanh:
        break;
      default:
        return false;
    }
    slots[i.result] = std::move(result);
  }
  return true;
}

/// f over one denominator; a quotient of polynomials without their common factors, at whose zeros f
/// has no value.
expression::fraction fraction_of(const expression& f) {
  const auto q = f.variables().size() == 1 ? f.quotient() : std::nullopt;
  if (q && !q->numerator.is_zero()) {
    rational_polynomial numerator = q->numerator;
    for (const repeated_factor& d : q->divisors) {
      for (rational_polynomial common = gcd(numerator, d.factor); common.degree() > 0;
           common = gcd(numerator, d.factor)) {
        numerator = divide(numerator, common).first;
      }
    }
    if (numerator.degree() < q->numerator.degree()) {
      const symbol z = symbol::variable(0);
      symbol value = 0;
      for (long k = numerator.degree(); k >= 0; --k)
        value = value * z + numerator.coefficients()[static_cast<std::size_t>(k)];
      return {expression(value, f.names()), {}};
    }
  }
  return f.as_fraction().value_or(expression::fraction{f, {}});
}

class zero_search {
 public:
  zero_search(const expression& f, complex_rectangle where, const zeros_options& options)
      : zero_search(fraction_of(f), std::move(where), options) {}

  zeros_answer answer() {
    constexpr int deepest_beside_cuts = 24;  // poles and branch cuts stay undecided
    struct part {
      complex_rectangle box;
      int depth;
    };
    std::vector<part> open{{whole_, 0}};
    long looked_at = 0;
    bool ended = false;
    while (!open.empty()) {
      const part next = open.back();
      open.pop_back();
      if (is_done(next.box)) continue;
      ended = ended || ++looked_at > options_.most_parts ||
              (options_.go_on && looked_at % 64 == 0 && !options_.go_on(result_.zeros.size()));
      if (ended) {
        result_.undecided.push_back({next.box, ""});
        continue;
      }
      const region value = over(next.box, next.depth);
      const std::optional<std::string> pole = pole_of_divisor(next.box, next.depth);
      if (!value.is_analytic() && !pole && has_no_value_0(next.box, next.depth)) continue;
      if (value.is_analytic()) {
        const bool may_be_0 = value.magnitude_lower().is_zero();
        if (!may_be_0 && !pole) continue;
        if (!may_be_0 && next.depth >= deepest_beside_cuts) {
          result_.undecided.push_back({next.box, *pole});
          continue;
        }
        constexpr int first_depth = 2;
        // Beside zeros that were not told apart it seldom helps.
        const bool is_hard = next.depth % 8 != 0 && is_in_cluster(next.box);
        if (may_be_0 && next.depth >= first_depth && !is_hard) look_near(next.box);
        if (is_done(next.box)) continue;
        // So small that zeros which are still together may stay so.
        constexpr int depth_of_clusters = 30;
        if (next.depth >= depth_of_clusters && take_cluster(next.box)) continue;
      }
      if (next.depth >= 2 * options_.most_depth ||
          (!value.is_analytic() && next.depth >= deepest_beside_cuts)) {
        result_.undecided.push_back(
            {next.box, value.is_analytic() ? std::string() : in_words(value)});
        continue;
      }
      const bool is_across_cut = !value.is_analytic() && next.box.bottom < 0 && next.box.top > 0;
      for (const complex_rectangle& half :
           is_across_cut ? halves_at_real_axis(next.box) : halves(next.box)) {
        open.push_back({half, next.depth + 1});
      }
    }
    sort_zeros();
    return std::move(result_);
  }

 private:
  zero_search(const expression::fraction& f, complex_rectangle where, const zeros_options& options)
      : numerator_(f.numerator),
        divisors_(f.divisors),
        f_(complex_integrand_of(f.numerator)),
        is_real_(f.numerator.variables().size() < 2),
        is_mirrored_(has_cuts_on_the_real_line_alone(f.numerator)),
        whole_(std::move(where)),
        options_(options),
        bits_(bits_for_digits(options.digits) + 64) {
    for (const expression& d : divisors_) {
      over_divisors_.push_back(complex_integrand_of(d));
      // With log_gamma, which has a branch cut there, some are named in vain.
      const bool may_have_poles = d.to_text().find("gamma(") != std::string::npos;
      if (may_have_poles) over_divisors_with_poles_.push_back(over_divisors_.back());
    }
  }

  /// By the real parts, to the digits asked for, then by the imaginary ones.
  void sort_zeros() {
    integer ten_to_digits;
    mpz_ui_pow_ui(ten_to_digits.backend().data(), 10, static_cast<unsigned long>(options_.digits));
    const auto place = [&](const complex_zero& z) {
      const rational re = lower_rational(z.enclosure.re.middle());
      return std::pair(floor_of(rational(re * ten_to_digits + rational(1, 2))),
                       lower_rational(z.enclosure.im.middle()));
    };
    std::ranges::sort(result_.zeros, [&](const complex_zero& x, const complex_zero& y) {
      return place(x) < place(y);
    });
  }

  /// Squares with the same number of zeros, the small one wider than was asked for.
  struct cluster {
    complex_rectangle large;
    complex_rectangle small;
    long count;
  };

  static std::string in_words(const region& value) {
    const std::string name(value.where());
    switch (value.why()) {
      case obstacle::pole:
        return "the pole of " + name;
      case obstacle::unknown:
        return name + " of complex arguments is not available";
      default:
        return "the branch cut of " + name;
    }
  }

  /// Along the longer side.
  static std::array<complex_rectangle, 2> halves(const complex_rectangle& box) {
    // Not in the middle, where zeros often are.
    const rational share(17, 32);
    complex_rectangle first = box;
    complex_rectangle second = box;
    if (box.right - box.left >= box.top - box.bottom) {
      first.right = second.left = box.left + (box.right - box.left) * share;
    } else {
      first.top = second.bottom = box.bottom + (box.top - box.bottom) * share;
    }
    return {first, second};
  }

  /// The upper one has the values of the real axis.
  static std::array<complex_rectangle, 2> halves_at_real_axis(const complex_rectangle& box) {
    complex_rectangle above = box;
    complex_rectangle below = box;
    above.bottom = below.top = 0;
    return {below, above};
  }

  [[nodiscard]] bool is_done(const complex_rectangle& box) const {
    return std::ranges::any_of(done_, [&](const complex_rectangle& d) { return lies_in(box, d); });
  }

  [[nodiscard]] region over(const complex_rectangle& box, int depth) const {
    constexpr int depth_of_doubles = 60;
    const complex_ball set(between(box.left, box.right, 64 + depth),
                           between(box.bottom, box.top, 64 + depth));
    return f_.over(depth < depth_of_doubles ? region(set) : region::in_balls(set));
  }

  /// What of a divisor may have a pole in the part, as gamma has: f tends to 0 there, but has no
  /// value. None where no divisor has one: the poles of quotients and tangents are worked out, so
  /// that gamma alone brings some.
  [[nodiscard]] std::optional<std::string> pole_of_divisor(const complex_rectangle& box,
                                                           int depth) const {
    if (over_divisors_with_poles_.empty()) return std::nullopt;
    const region set(complex_ball(between(box.left, box.right, 64 + depth),
                                  between(box.bottom, box.top, 64 + depth)));
    for (const detail::complex_integrand& d : over_divisors_with_poles_) {
      const region value = d.over(set);
      if (!value.is_analytic()) return in_words(value);
    }
    return std::nullopt;
  }

  /// Whether no value over the part, by principal values, is 0, be it beside a branch cut or on it.
  /// Where f has conjugate values, a part below the real axis is taken for its mirror image: on a
  /// cut the values are those from above.
  [[nodiscard]] bool has_no_value_0(const complex_rectangle& box, int depth) const {
    const precision p = 64 + depth;
    const bool is_below = is_mirrored_ && box.top <= 0;
    const complex_ball set(between(box.left, box.right, p), is_below
                                                                ? between(-box.top, -box.bottom, p)
                                                                : between(box.bottom, box.top, p));
    const complex_ball value = natural_value(numerator_, set);
    return !value.is_undefined() && !value.magnitude_lower().is_zero();
  }

  /// The zeros near a part: squares around what the secant method finds.
  void look_near(const complex_rectangle& box) {
    const rational size = std::max(rational(box.right - box.left), rational(box.top - box.bottom));
    constexpr precision few_bits = 64;
    constexpr long few_steps = 24;
    const std::optional<point> rough = approximate(
        {(box.left + box.right) / 2, (box.bottom + box.top) / 2}, size, few_bits, few_steps);
    if (!rough || is_known(*rough)) return;
    const auto centre = approximate(*rough, size / 1000, bits_, few_steps);
    if (!centre) return;
    // The largest square with as few zeros as any has.
    std::optional<square_around> large;
    long least = 0;
    for (rational half = size; half > size / 1000 && least != 1; half /= 4) {
      const square_around square{centre->re, centre->im, half};
      constexpr int few_pieces = 100;
      const std::optional<long> count = zeros_in(square, 96, few_pieces);
      if (!count || *count == 0 || (large && *count >= least)) continue;
      large = square;
      least = *count;
    }
    if (!large) return;
    if (const auto exact = exact_zero(*centre, large->half, least)) {
      if (!meets_a_zero(*exact)) take(large->as_rectangle(), *exact, least, true);
      return;
    }
    point of_zeros = *centre;
    if (least > 1) {  // there the steps converge slowly, and the values lose digits
      const precision p = bits_ * least;
      if (const auto closer = approximate(*centre, large->half / 1000, p, few_steps + 2 * p)) {
        of_zeros = *closer;
      }
    }
    add(*large, of_zeros, least);
  }

  /// Whether it is in a square that has been examined.
  [[nodiscard]] bool is_known(const point& z) const { return is_done({z.re, z.re, z.im, z.im}); }

  /// Adds the zeros of the large square, where a small one around z has as many. Where the small
  /// one has not the digits asked for, the two are kept for take_cluster.
  void add(const square_around& large, const point& z, long count) {
    const rational size = std::max(rational(abs(z.re)), rational(abs(z.im)));
    integer ten_to_digits;
    mpz_ui_pow_ui(ten_to_digits.backend().data(), 10, static_cast<unsigned long>(options_.digits));
    const rational tiny = rational(1) / rational(integer(ten_to_digits * ten_to_digits));
    const rational goal = std::max(rational(size / rational(ten_to_digits) / 2), tiny);
    const precision p = bits_ * count + 64;
    constexpr int many_pieces = 400;
    const auto has_all = [&](const rational& half) {
      const square_around small{z.re, z.im, half};
      return lies_in(small.as_rectangle(), large.as_rectangle()) &&
             zeros_in(small, p, many_pieces) == count;
    };
    const auto around = [&](const rational& half) {
      return square_around{z.re, z.im, half}.as_rectangle();
    };
    for (const rational& half : {rational(goal / 16), goal}) {
      if (meets_a_zero(around(half))) return;
      if (!has_all(half)) continue;
      const auto exact = count == 1 ? exact_unique(around(half)) : std::nullopt;
      take(large.as_rectangle(), exact.value_or(around(half)), count);
      return;
    }
    rational half = large.half / 2;
    if (meets_a_zero(around(half)) || !has_all(half)) return;
    while (half > goal && has_all(half / 4)) half /= 4;
    clusters_.push_back({large.as_rectangle(), around(half), count});
  }
  /// A rectangle between the two, with the same zeros of the numerator, in which no divisor has a
  /// pole; the small one where none is found.
  [[nodiscard]] complex_rectangle without_pole(const complex_rectangle& large,
                                               const complex_rectangle& small) const {
    constexpr int most_steps = 40;
    constexpr int depth = 64;
    complex_rectangle part = large;
    for (int i = 0; i < most_steps; ++i) {
      if (!pole_of_divisor(part, depth)) return part;
      part = {(part.left + small.left) / 2, (part.right + small.right) / 2,
              (part.bottom + small.bottom) / 2, (part.top + small.top) / 2};
    }
    return small;
  }
  /// The large square is done; the small one has all its zeros.
  void take(const complex_rectangle& large, const complex_rectangle& small, long count,
            bool is_one = false) {
    done_.push_back(without_pole(large, small));
    if (!meets(small, whole_)) return;  // they are beyond the rectangle
    if (const auto obstacle = obstacle_to_value(small)) {
      small_.push_back(small);
      if (!are_at_a_point_without_value(small, count)) {
        result_.undecided.push_back({small, *obstacle});
      }
      return;
    }
    complex_ball enclosure(between(small.left, small.right, bits_ + 64),
                           between(small.bottom, small.top, bits_ + 64));
    // The conjugate of a zero is one, and there is no other in the large square.
    const complex_rectangle conjugate{small.left, small.right, -small.top, -small.bottom};
    const bool is_real = is_real_ && (count == 1 || is_one) && lies_in(conjugate, large);
    if (is_real) enclosure.im = ball(0, bits_);
    const bool is_inside =
        is_real ? lies_in({small.left, small.right, 0, 0}, whole_) : lies_in(small, whole_);
    result_.zeros.push_back({std::move(enclosure), count, is_inside, count == 1 || is_one});
    small_.push_back(small);
  }
  /// Why f may have no value in the small square: a divisor may be 0, or has a branch cut. None
  /// where it has values.
  [[nodiscard]] std::optional<std::string> obstacle_to_value(const complex_rectangle& small) const {
    const precision p = bits_ + 64;
    const region set = region::in_balls(
        {between(small.left, small.right, p), between(small.bottom, small.top, p)});
    for (const detail::complex_integrand& d : over_divisors_) {
      const region value = d.over(set);
      if (!value.is_analytic()) return in_words(value);
      if (value.magnitude_lower().is_zero()) return "0/0";
    }
    return std::nullopt;
  }
  /// Whether the zeros of the numerator in the small square are one zero of that multiplicity at a
  /// real number at which f has no value: as that of sin(z) at 0 for sin(z)/z.
  [[nodiscard]] bool are_at_a_point_without_value(const complex_rectangle& small,
                                                  long count) const {
    if (!is_real_ || small.bottom > 0 || small.top < 0) return false;
    const ball real = between(small.left, small.right, bits_ + 64);
    return std::ranges::any_of(
        simple_numbers(small.left, small.right), [&](const pi_combination& at) {
          if (!contains(real, at.at(2 * bits_ + 128))) return false;
          return vanishes(numerator_, at, count) &&
                 std::ranges::any_of(divisors_,
                                     [&](const expression& d) { return vanishes(d, at, 1); });
        });
  }
  /// The simplest rational number, and the simplest multiple of pi, between two.
  [[nodiscard]] std::array<pi_combination, 2> simple_numbers(const rational& low,
                                                             const rational& high) const {
    const precision p = bits_ + 64;
    const ball turns = between(low, high, p) / pi(p);
    return {pi_combination{simplest_between(low, high), 0},
            pi_combination{0, simplest_between(lower_rational(turns), upper_rational(turns))}};
  }
  /// A narrow rectangle around the zeros of a square around z, of half that width, where they are
  /// one zero of that multiplicity, at a simple real number: the numerator has so many zeros in the
  /// square, and vanishes to that order there.
  [[nodiscard]] std::optional<complex_rectangle> exact_zero(const point& z, const rational& half,
                                                            long count) const {
    if (!is_real_ || count < 2 || abs(z.im) >= half) return std::nullopt;
    constexpr int narrowest = 1 << 20;
    for (int share = 8; share <= narrowest; share *= 16) {
      for (const pi_combination& at : simple_numbers(z.re - half / share, z.re + half / share)) {
        if (!vanishes(numerator_, at, count)) continue;
        const ball place = at.at(bits_ + 64);
        const rational low = lower_rational(place);
        const rational high = upper_rational(place);
        if (z.re - half < low && high < z.re + half) return complex_rectangle{low, high, 0, 0};
      }
    }
    return std::nullopt;
  }
  /// The point of the only zero in a narrow square, where that is a short rational number.
  [[nodiscard]] std::optional<complex_rectangle> exact_unique(const complex_rectangle& r) const {
    if (!is_real_ || r.bottom > 0 || r.top < 0) return std::nullopt;
    const integer longest = integer(1) << 24U;
    const rational q = simplest_between(r.left, r.right);
    if (denominator(q) > longest || !vanishes(numerator_, {q, 0}, 1)) return std::nullopt;
    return complex_rectangle{q, q, 0, 0};
  }
  /// Whether the first so many Taylor coefficients of f at a real number are exactly 0.
  [[nodiscard]] bool vanishes(const expression& f, const pi_combination& at, long order) const {
    if (order == 1) {
      const symbol number = symbol(at.q) + symbol(at.r) * symbol::constant("pi");
      try {
        const expression value(f(number), f.names());
        if (value.rational_value() == rational(0)) return true;
      } catch (const input_error&) {  // f has no real value there
        return false;
      }
    }
    const std::optional<function_structure> value = real_function(f).structure(
        function_structure::variable_at(at, static_cast<int>(order), bits_));
    if (!value || !value->series()) return false;
    for (int k = 0; k < order; ++k) {
      if (!(*value->series())[k].is_exactly(0)) return false;
    }
    return true;
  }
  [[nodiscard]] bool is_in_cluster(const complex_rectangle& box) const {
    return std::ranges::any_of(clusters_, [&](const cluster& c) { return lies_in(box, c.large); });
  }
  /// Takes zeros that were not told apart, whose large square holds the part; false where there are
  /// none.
  bool take_cluster(const complex_rectangle& box) {
    for (const cluster& c : clusters_) {
      if (!lies_in(box, c.large) || meets_a_zero(c.small)) continue;
      take(c.large, c.small, c.count);
      return true;
    }
    return false;
  }
  [[nodiscard]] bool meets_a_zero(const complex_rectangle& r) const {
    return std::ranges::any_of(small_, [&](const complex_rectangle& s) { return meets(s, r); });
  }

  /// A number near which f seems to have a zero; by the secant method from two numbers so far
  /// apart, in so many steps at most, and not much further away.
  [[nodiscard]] std::optional<point> approximate(const point& from, const rational& apart,
                                                 precision p, long steps) const {
    const auto f = f_.evaluator(p);
    const complex_ball start = complex_ball(ball(from.re, p), ball(from.im, p)).middle();
    const magnitude most = scale(ball(apart, p).magnitude_upper(), 3);
    complex_ball z0 = start;
    complex_ball z1 =
        (start + complex_ball(ball(rational(apart / 16), p), ball(rational(apart / 24), p)))
            .middle();
    complex_ball f0 = f(z0).middle();
    for (long step = 0; step < steps; ++step) {
      const complex_ball f1 = f(z1).middle();
      if (!f1.is_bounded()) return std::nullopt;
      const complex_ball slope = f1 - f0;
      if (f1.magnitude_upper().is_zero() || slope.magnitude_lower().is_zero()) break;
      const complex_ball z2 = (z1 - f1 * (z1 - z0) / slope).middle();
      if (!z2.is_bounded() || !((z2 - start).magnitude_upper() < most)) return std::nullopt;
      z0 = std::exchange(z1, z2);
      f0 = f1;
    }
    return point{lower_rational(z1.re), lower_rational(z1.im)};
  }

  /// The number of zeros inside the square, by the argument principle; nothing where it is not
  /// proved.
  [[nodiscard]] std::optional<long> zeros_in(const square_around& s, precision p,
                                             int most_pieces) const {
    const complex_rectangle r = s.as_rectangle();
    if (!is_analytic_on(r, p, 0)) return std::nullopt;
    const auto f = f_.evaluator(p);
    ball sum(0, p);
    int pieces = most_pieces;
    for (const edge& side :
         {edge{r.left, r.bottom, r.right, r.bottom}, edge{r.right, r.bottom, r.right, r.top},
          edge{r.right, r.top, r.left, r.top}, edge{r.left, r.top, r.left, r.bottom}}) {
      if (!add_turns(side, f, p, pieces, sum)) return std::nullopt;
    }
    const ball turns = sum / (2 * pi(p));
    const integer n = ceil_of(lower_rational(turns));
    if (n != floor_of(upper_rational(turns)) || n < 0 || n > 1000) return std::nullopt;
    return static_cast<long>(n);
  }
  [[nodiscard]] bool is_analytic_on(const complex_rectangle& r, precision p, int depth) const {
    constexpr int deepest = 6;
    const complex_ball set(between(r.left, r.right, p), between(r.bottom, r.top, p));
    if (f_.over(region::in_balls(set)).is_analytic()) return true;
    if (depth >= deepest) return false;
    const auto both = halves(r);
    return is_analytic_on(both[0], p, depth + 1) && is_analytic_on(both[1], p, depth + 1);
  }
  /// Adds the change of arg f along the edge, in so many pieces at most.
  bool add_turns(const edge& along, const std::function<complex_ball(const complex_ball&)>& f,
                 precision p, int& pieces, ball& sum) const {
    if (--pieces < 0) return false;
    const region value = f_.over(region::in_balls(along.set(p)));
    if (value.is_analytic() && !value.magnitude_lower().is_zero()) {
      const complex_ball first = f({ball(along.re1, p), ball(along.im1, p)});
      const complex_ball last = f({ball(along.re2, p), ball(along.im2, p)});
      if (const auto change = argument(last / first)) {
        sum += *change;
        return true;
      }
    }
    const auto both = along.halves();
    return add_turns(both[0], f, p, pieces, sum) && add_turns(both[1], f, p, pieces, sum);
  }

  // f is 0 where the numerator is 0 and no divisor is.
  expression numerator_;
  std::vector<expression> divisors_;
  std::vector<detail::complex_integrand> over_divisors_;
  std::vector<detail::complex_integrand> over_divisors_with_poles_;
  detail::complex_integrand f_;  // the numerator
  bool is_real_;                 // for real arguments
  bool is_mirrored_;             // has_cuts_on_the_real_line_alone
  complex_rectangle whole_;
  const zeros_options& options_;
  precision bits_;
  zeros_answer result_;
  std::vector<complex_rectangle> done_;   // the large squares
  std::vector<complex_rectangle> small_;  // those around the zeros
  std::vector<cluster> clusters_;
};

}  // namespace
}  // namespace zeros_impl

zeros_answer zeros_in_rectangle(const expression& f, const complex_rectangle& where,
                                const zeros_options& options) {
  if (options.digits < 1) {
    throw std::invalid_argument("zeros_in_rectangle: digits must be at least 1");
  }
  if (!(where.left < where.right && where.bottom < where.top)) {
    throw input_error(
        "a rectangle from one corner to the same line; give the lower left and the "
        "upper right corner, such as -5-10i and 5+10i");
  }
  if (f.is_formally_zero())
    throw input_error("the formula is 0 everywhere; every number is a zero");
  if (const auto name = f.function_not_analytic()) {
    throw input_error(fmt::format("{} is not analytic in the complex plane", *name));
  }
  return zeros_impl::zero_search(f, where, options).answer();
}

}  // namespace polhode
