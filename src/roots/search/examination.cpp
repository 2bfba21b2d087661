#include "examination.hpp"

#include <algorithm>
#include <array>

#include "exact_points.hpp"
#include "jumps.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "roots/count_zeros.hpp"
#include "roots/polynomial/root_bracket.hpp"
#include "taylor_bounds.hpp"

namespace polhode::detail {

namespace {

/// The box and half of its width more on either side; a point, and a little.
exact_box widened(const exact_box& b) {
  rational more = b.width() / 2;
  if (more == 0) more = (abs(*b.lower) + 1) / (1L << 40);
  return {*b.lower - more, *b.upper + more};
}

/// g(x) for the factor with that id in the numerator, or the denominator, of f's structure.
real_function factor_of(const real_function& f, long id) {
  const auto slope = [f, id](const ball& x) {
    const auto s = f.structure(function_structure::variable(x, x.middle()));
    for (const auto& g : s->numerator().factors) {
      if (g.id == id) return g.over;
    }
    if (s->denominator()) {
      for (const auto& g : s->denominator()->factors) {
        if (g.id == id) return g.over;
      }
    }
    return jet<ball, 1>::constant(ball::undefined(x.precision()));
  };
  return real_function(
      [slope](precision) {
        function_evaluator e;
        e.value = [slope](const ball& x) { return slope(x)[0]; };
        e.derivative = [slope](const ball& x) { return slope(x)[1]; };
        e.slope = slope;
        e.series = [slope](const ball& x, int n) {
          const jet<ball, 1> known = slope(x);
          series_type r(n);
          for (int k = 0; k <= n; ++k) r[k] = k <= 1 ? known[k] : ball::undefined(x.precision());
          return r;
        };
        return e;
      },
      1);
}

bool is_not_negative(const ball& x) {
  const certain_sign s = sign_of(x);
  return s == certain_sign::positive || s == certain_sign::zero;
}

/// The examination of one box.
class examination {
 public:
  examination(const root_search::state& s, const isolate_options& options, evaluators& known)
      : s_(s), options_(options), evaluators_(known) {}

  [[nodiscard]] outcome of_box(work_box b) && {
    if (b.x.is_bounded()) {
      examine(std::move(b));
    } else {
      examine_tail(std::move(b));
    }
    return std::move(result_);
  }
  /// The region that a cluster of boxes is, which are as narrow as they get.
  [[nodiscard]] outcome of_cluster(const work_box& b) && {
    conclude(b);
    return std::move(result_);
  }

 private:
  [[nodiscard]] const root_problem& problem(const work_box& b) const {
    return s_.problems[b.problem];
  }
  const function_evaluator& evaluator(std::size_t problem, precision p) {
    result_.most_bits = std::max(result_.most_bits, p);
    auto& known = evaluators_.in_balls[{problem, p}];
    if (known == nullptr) known = s_.problems[problem].g->at(p);
    return *known;
  }
  series_type series(const work_box& b, const ball& x, int n) {
    ++result_.evaluations;
    return evaluator(b.problem, b.bits).series(x, n);
  }
  std::optional<function_structure> structure(const root_problem& p, const function_structure& x) {
    ++result_.evaluations;
    return p.g->structure(x);
  }

  // -------------------------------------------------------------------------------------------
  // Bounded boxes

  void examine(work_box b) {
    const rational size = std::max({abs(*b.x.lower), abs(*b.x.upper), rational(1, 1L << 30)});
    const rational width = b.x.width();
    if (width > 0) {  // the ends must be told apart
      const rational ratio = size / width;
      const auto bits =
          static_cast<precision>(mpz_sizeinbase(mpq_numref(ratio.backend().data()), 2) -
                                 mpz_sizeinbase(mpq_denref(ratio.backend().data()), 2));
      b.bits = std::max<precision>(b.bits, bits + 40);
    }
    switch (by_hardware(b)) {
      case hardware_answer::settled:
        return;
      case hardware_answer::wide:
        // The parts cost next to nothing.
        if (b.halvings > 0 && (b.halvings < cheap_halvings || !is_turn_for_structure(b))) {
          return halve(std::move(b));
        }
        break;
      case hardware_answer::none:
        break;
    }
    const ball x = b.x.to_ball(b.bits);
    const int n = problem(b).g->best_order();
    series_type over = series(b, x, n);
    if (is_certainly_not_zero(over[0])) return exclude(b.x, x);
    if (over[0].is_undefined() || over[1].is_undefined()) {
      if (has_no_root_where_defined(b) || by_structure(b)) return;
      return b.is_left_whole ? leave(std::move(b)) : halve(std::move(b), true);
    }
    const ball middle(b.x.middle(), b.bits);
    const series_type at_middle = series(b, middle, n);
    if (over[n].is_undefined()) {  // once differentiable
      series_type shorter(1);
      shorter[0] = over[0];
      shorter[1] = over[1];
      over = shorter;
    }
    const enclosed_function f = taylor(at_middle, over, x - middle);
    if (is_certainly_not_zero(f.value)) return exclude(b.x, x);
    if (!contains_zero(f.slope) && by_newton(b, x, middle, at_middle[0], f.slope)) return;
    // Where rounding, not the width of the box, is what leaves f undecided.
    constexpr int least_gain = 8;
    const bool noisy = at_middle[0].radius() > scale(f.value.radius(), -least_gain);
    if (noisy) b.bits = std::max(b.bits, std::min(2 * b.bits, most_bits(b)));
    if (is_turn_for_structure(b) && by_structure(b)) return;
    if (b.is_left_whole && !over[0].is_bounded()) return leave(std::move(b));
    halve(b);
  }

  /// f in hardware doubles; nullptr where it is not to be had.
  contraction* hardware_of(const work_box& b) {
    const auto [known, is_new] = evaluators_.in_hardware.try_emplace(b.problem);
    if (is_new && problem(b).g->formula() != nullptr) {
      auto made = std::make_unique<contraction>(*problem(b).g->formula());
      if (made->has_values()) known->second = std::move(made);
    }
    return known->second.get();
  }

  static constexpr int cheap_halvings = 16;
  enum class hardware_answer {
    settled,  // the box has no root, or its root was found
    wide,     // f is differentiable, and the width of the box, not rounding, leaves f undecided
    none
  };
  /// The answer of hardware doubles. Of a box near their resolution they are not asked.
  hardware_answer by_hardware(const work_box& b) {
    constexpr precision most = first_bits + 8;
    if (b.bits > most || b.x.is_point()) return hardware_answer::none;
    contraction* const f = hardware_of(b);
    if (f == nullptr) return hardware_answer::none;
    const double_interval x(double_interval(*b.x.lower).lower(),
                            double_interval(*b.x.upper).upper());
    if (!x.is_bounded()) return hardware_answer::none;
    ++result_.evaluations;
    const auto [plain, slope] = f->over(x);
    const double_interval middle(x.midpoint());
    double_interval value = 0;
    double_interval over = plain;
    if (contains_zero(plain)) {  // or it is undefined
      if (slope.is_undefined()) return hardware_answer::none;
      ++result_.evaluations;
      value = f->value({middle});
      if (value.is_undefined()) return hardware_answer::none;
      over = value + slope * (x - middle);  // the mean value theorem
    }
    if (!contains_zero(over)) {
      exclude(b.x, to_ball(x, first_bits));
      return hardware_answer::settled;
    }
    if (contains_zero(slope)) {
      // Where f is not known at one point, narrower boxes will not tell more.
      return contains_zero(value) ? hardware_answer::none : hardware_answer::wide;
    }
    const double_interval image = middle - value / slope;
    if (image.is_undefined()) return hardware_answer::wide;
    if (add_by_newton(b, b.x, x, image)) return hardware_answer::settled;
    // A root near an end, or at it: in a wider box.
    const exact_box wide = widened(b.x);
    const double_interval wider(double_interval(*wide.lower).lower(),
                                double_interval(*wide.upper).upper());
    ++result_.evaluations;
    const double_interval around = f->over(wider).slope;
    // Undefined where the slope may be 0.
    const double_interval wider_image = middle - value / around;
    if (add_by_newton(b, wide, wider, wider_image)) return hardware_answer::settled;
    const exact_box part{rational(std::max(image.lower(), x.lower())),
                         rational(std::min(image.upper(), x.upper()))};
    return keeps_only(part, b, to_ball(x, first_bits)) ? hardware_answer::settled
                                                       : hardware_answer::wide;
  }

  /// Adds the root in x, of which `done` is a part, where Newton's image of x lies in x.
  bool add_by_newton(const work_box& b, const exact_box& done, const double_interval& x,
                     const double_interval& image) {
    if (image.is_undefined() || image.lower() < x.lower() || image.upper() > x.upper()) {
      return false;
    }
    add_simple_root(b, done, to_ball(x, first_bits), to_ball(image, first_bits));
    return true;
  }

  /// There is no root in x, nor in the set, which holds it.
  void exclude(const exact_box& x, const ball& over) { result_.excluded.push_back({x, over}); }

  /// What is spent on cancellation grows with the depth: a function that is 0 on an interval is not
  /// to cost the most everywhere.
  [[nodiscard]] precision most_bits(const work_box& b) const {
    return std::min<precision>(options_.most_precision, 512 + 32L * b.halvings);
  }

  /// At some depths, and near singular points, where a factor may be too small to be told from 0.
  static bool is_turn_for_structure(const work_box& b) {
    const int halvings = b.halvings;
    if (b.is_beside_singular && halvings > cheap_halvings) return true;
    constexpr std::array turns = {0, 8, 12, 16, 24, 32, 48, 64, 96, 128, 160, 192};
    constexpr int later = 16;
    return std::find(turns.begin(), turns.end(), halvings) != turns.end() ||
           (halvings > turns.back() && halvings % later == 0);
  }

  /// True where the box is settled: it has no root, its root was found, or a narrower box takes its
  /// place.
  bool by_newton(const work_box& b, const ball& x, const ball& middle, const ball& value,
                 const ball& slope) {
    const ball image = middle - value / slope;
    if (image.is_undefined()) return false;
    if (!overlaps(image, x)) {
      exclude(b.x, x);
      return true;
    }
    if (contains(x, image)) {
      add_simple_root(b, b.x, x, image);
      return true;
    }
    // A root near an end, or at it: in a wider box.
    const exact_box wide = widened(b.x);
    const ball wider = wide.to_ball(b.bits);
    ++result_.evaluations;
    const jet<ball, 1> over = evaluator(b.problem, b.bits).slope(wider);
    if (!over[0].is_undefined() && is_certainly_not_zero(over[1])) {
      const ball wider_image = middle - value / over[1];
      // The root may lie beyond x, where the first image says nothing of it.
      if (contains(wider, wider_image)) {
        add_simple_root(b, wide, wider, wider_image);
        return true;
      }
    }
    const ball left = intersection(image, x);
    if (left.is_undefined() || !left.is_bounded()) return false;
    return keeps_only(exact_ends(left), b, x);
  }

  /// The roots in the box, which lies in x, are in the part. True where the box is settled, as the
  /// part that is left is narrower, or empty.
  bool keeps_only(exact_box part, const work_box& b, const ball& x) {
    if (is_long(b.x)) return false;  // a cut in size gains more
    work_box rest = b;
    rest.x = std::move(part);
    rest.x.lower = std::max(*rest.x.lower, *b.x.lower);
    rest.x.upper = std::min(*rest.x.upper, *b.x.upper);
    if (*rest.x.upper < *rest.x.lower) {
      exclude(b.x, x);
      return true;
    }
    if (rest.x.width() > b.x.width() * rational(3, 4) || b.x.width() == 0) return false;
    if (++rest.halvings > options_.most_halvings) return false;
    if (*b.x.lower < *rest.x.lower) exclude({b.x.lower, rest.x.lower}, x);
    if (*rest.x.upper < *b.x.upper) exclude({rest.x.upper, b.x.upper}, x);
    result_.rest.push_back(std::move(rest));
    return true;
  }

  void leave(work_box b) {
    b.remark = "not resolved by " + std::to_string(b.halvings) + " halvings";
    result_.stuck.push_back(std::move(b));
  }

  /// The middle; of a box whose ends are far apart in size, about their geometric mean.
  static rational cut_of(const exact_box& x) { return is_long(x) ? inner_point(x) : x.middle(); }
  static bool is_long(const exact_box& x) {
    constexpr long far_apart = 1L << 16;
    return (*x.lower > 0 && *x.upper > far_apart * *x.lower) ||
           (*x.upper < 0 && *x.lower < far_apart * *x.upper);
  }

  /// From left to right; a part in which f is singular comes after one where it is not, and
  /// after one that does not reach to the singular point.
  void halve(work_box b, bool is_singular = false) {
    constexpr int times_around_zero = 12;
    const auto zero = b.halvings >= halvings_beside_zero ? kink_in(b) : std::nullopt;
    const bool goes_on = b.halvings < options_.most_halvings ||
                         (zero && b.halvings < times_around_zero * options_.most_halvings);
    if (!goes_on || b.x.width() == 0) return leave(std::move(b));
    ++b.halvings;
    work_box right = b;
    right.x.lower = cut_of(b.x);
    b.x.upper = right.x.lower;
    // A part beside an exact zero is at a scale of its own.
    if (zero && *zero < *right.x.lower) right.halvings = halvings_beside_zero;
    if (zero && *zero > *b.x.upper) b.halvings = halvings_beside_zero;
    mark_singular_points(b, right, is_singular);
    b.is_beside_singular = right.singular != singular_point::none;
    right.is_beside_singular = b.singular != singular_point::none;
    const bool is_right_first =
        b.singular == singular_point::at_lower_end
            ? right.singular != singular_point::at_upper_end
            : b.singular != singular_point::none && right.singular == singular_point::none;
    if (is_right_first) std::swap(b, right);
    result_.rest.push_back(std::move(right));
    result_.rest.push_back(std::move(b));
  }

  /// Of the two parts of a box.
  void mark_singular_points(work_box& left, work_box& right, bool is_singular) {
    const auto is_defined_over = [&](const work_box& b, const ball& x) {
      const series_type over = series(b, x, 1);
      return !over[0].is_undefined() && !over[1].is_undefined();
    };
    const auto is_singular_over = [&](const work_box& b) {
      return is_singular && !is_defined_over(b, b.x.to_ball(b.bits));
    };
    const exact_box& whole = s_.settled[left.problem].whole();
    const bool is_at_lower =
        left.singular == singular_point::at_lower_end || left.x.lower == whole.lower;
    const bool is_at_upper =
        left.singular == singular_point::at_upper_end || right.x.upper == whole.upper;
    const bool left_is_singular = is_singular_over(left);
    const bool right_is_singular = is_singular_over(right);
    const bool is_at_cut = left_is_singular && right_is_singular &&
                           !is_defined_over(left, ball(*left.x.upper, left.bits));
    const auto kind = [](bool is_part_singular, bool at_lower, bool at_upper) {
      if (!is_part_singular) return singular_point::none;
      if (at_lower) return singular_point::at_lower_end;
      return at_upper ? singular_point::at_upper_end : singular_point::inside;
    };
    left.singular = kind(left_is_singular, is_at_lower, is_at_cut);
    right.singular = kind(right_is_singular, is_at_cut, is_at_upper);
  }

  // -------------------------------------------------------------------------------------------
  // Structure

  /// The same test as in by_structure, in the box itself: f may be undefined beyond it.
  bool has_no_root_where_defined(const work_box& b) {
    const ball x = b.x.to_ball(b.bits);
    const auto s =
        structure(problem(b), function_structure::variable(x, ball(b.x.middle(), b.bits)));
    if (!s || (s->natural_range() && !is_certainly_not_zero(*s->natural_range()))) return false;
    result_.singular.push_back({x, 0});
    exclude(b.x, x);
    return true;
  }

  /// True where the box is done with.
  bool by_structure(const work_box& b) {
    const exact_box wide = widened(b.x);
    const ball x = wide.to_ball(b.bits);
    const ball middle(b.x.middle(), b.bits);
    const auto s = structure(problem(b), function_structure::variable(x, middle));
    if (!s) return false;
    const jet<ball, 1> over = s->over();
    const bool is_defined = !over[0].is_undefined();
    if (!s->natural_range() || is_certainly_not_zero(*s->natural_range())) {
      if (!is_defined) result_.singular.push_back({b.x.to_ball(b.bits), 0});
      exclude(b.x, x);
      return true;
    }
    const auto vanishing = [](const std::vector<function_structure::factor>& factors) {
      std::vector<const function_structure::factor*> r;
      for (const auto& g : factors) {
        if (!is_certainly_not_zero(g.over[0])) r.push_back(&g);
      }
      return r;
    };
    /// The enclosure of the only root of the factor in x; std::nullopt where that is not proved.
    const auto only_root = [&](const function_structure::factor& g) -> std::optional<ball> {
      if (g.over[0].is_undefined() || !is_certainly_not_zero(g.over[1])) return std::nullopt;
      const ball image = middle - g.at_point / g.over[1];
      if (!contains(x, image)) return std::nullopt;
      return image;
    };
    const auto zeros = vanishing(s->numerator().factors);
    const auto poles = s->denominator() ? vanishing(s->denominator()->factors)
                                        : std::vector<const function_structure::factor*>{};
    if (zeros.empty()) {
      // What the pole is a factor beside must be defined there: exp(1/x)/x has no pole at 0.
      const bool has_order = s->numerator().over[0].is_bounded() &&
                             (!s->denominator() || s->denominator()->over[0].is_bounded());
      if (poles.size() == 1 && has_order) {
        if (const auto pole = only_root(*poles.front())) {
          const real_function g = factor_of(*problem(b).g, poles.front()->id);
          const long order = poles.front()->is_branch ? 0 : poles.front()->power;
          result_.singular.push_back({refined_place(g, *pole, x), order});
          result_.known = {wide, x, std::nullopt};
          return true;
        }
      }
      if (poles.empty()) {
        if (!is_defined) result_.singular.push_back({b.x.to_ball(b.bits), 0});
        exclude(b.x, x);
        return true;
      }
      // The poles are told apart first; where they are no poles, the place is only made narrower.
      constexpr int few_halvings = 8;
      if (b.halvings < (has_order ? options_.most_halvings : few_halvings)) return false;
      result_.singular.push_back({b.x.to_ball(b.bits), 0});
      exclude(b.x, x);
      return true;
    }
    // Where f was divided by all that vanishes, it is defined at none of its zeros.
    if (poles.empty() && std::ranges::all_of(zeros, [&](const function_structure::factor* g) {
          return s->was_divided_by(*g);
        })) {
      const auto place = zeros.size() == 1 ? only_root(*zeros.front()) : std::optional<ball>();
      constexpr int few_halvings = 8;  // the places are told apart first
      if (!place && b.halvings < few_halvings) return false;
      result_.singular.push_back(
          {place ? refined_place(factor_of(*problem(b).g, zeros.front()->id), *place, x)
                 : b.x.to_ball(b.bits),
           0});
      exclude(b.x, x);
      return true;
    }
    if (zeros.size() == 1 && poles.empty() && zeros.front()->is_branch) {
      // f has the zeros of this factor, and is defined there.
      const bool is_defined_there =
          s->numerator().is_defined_at_zeros &&
          (!s->denominator() || is_certainly_not_zero(s->denominator()->over[0]));
      const auto root = is_defined_there ? only_root(*zeros.front()) : std::nullopt;
      if (root) {
        if (const auto zero = exact_zero_in(b)) {
          add_exact(b, wide, x, zero->at, 0);
        } else {
          add(b, wide, x, *root, 0, std::nullopt,
              std::make_shared<real_function>(factor_of(*problem(b).g, zeros.front()->id)));
        }
        return true;
      }
    } else if (zeros.size() == 1 && poles.empty() && is_defined && !over[1].is_undefined()) {
      // The quotient may be defined where f is not: 1/(1/x) is x/1.
      ++result_.evaluations;
      const jet<ball, 1> plain = evaluator(b.problem, b.bits).slope(x);
      const bool f_is_defined = !plain[0].is_undefined() && !plain[1].is_undefined();
      const auto root = f_is_defined ? only_root(*zeros.front()) : std::nullopt;
      if (root) {
        const long m = zeros.front()->power;
        const auto& f = *problem(b).g;
        add(b, wide, x, *root, m, std::nullopt,
            std::make_shared<real_function>(factor_of(f, zeros.front()->id)));
        return true;
      }
    }
    if (over[1].is_undefined() && is_turn_for_structure(b) && by_jumps(b, wide, x)) {
      return true;
    }
    const auto zero = exact_zero_in(b);
    if (zero) return by_exact_point(b, wide, x, *zero) || by_growth(b, wide, x, *zero);
    // Beside a pole narrower boxes tell more, and cost less.
    const bool is_worth_it = poles.empty() || is_turn_for_structure(b);
    return !is_defined && is_worth_it && by_removed_point(b, x);
  }

  /// f is not 0 at the simplest rational number in x, or the simplest rational multiple of pi, or
  /// not defined there, and its growth on both sides proves that x has no root: sin(x)/x and x^x at
  /// 0, sin(x)/(x-pi) at pi.
  bool by_removed_point(const work_box& b, const ball& x) {
    using has_none = std::optional<bool>;
    const auto removed_at = [&](const pi_combination& at) -> has_none {
      const ball point = at.at(b.bits);
      const auto s =
          structure(problem(b), at.is_rational() ? function_structure::variable(point, point)
                                                 : function_structure::variable_at(at, 0, b.bits));
      const bool is_known =
          s && (!s->natural_range() || is_certainly_not_zero(*s->natural_range()));
      std::optional<ball> value = is_known ? s->natural_range() : std::nullopt;
      if (!is_known) {
        if (const auto exact = value_at(b, at)) value = exact->enclosure();
      }
      if (value && !is_certainly_not_zero(*value)) return {};
      if (!grows_on_both_sides(b, x, at)) return {};
      const bool is_defined_there = value.has_value();
      result_.singular.push_back({is_defined_there ? x : point, 0});
      result_.excluded.push_back({b.x, x});
      return true;
    };
    return first_of_simple_points(b.x, b.bits, removed_at).has_value();
  }

  /// The formula at the point, where exact rules know more than balls; nothing where it certainly
  /// has no value there.
  std::optional<known_number> value_at(const work_box& b, const pi_combination& at) {
    const expression* const f = problem(b).g->formula();
    if (f == nullptr) return known_number(ball::undefined(b.bits));
    try {
      const symbol point = formula_of(end_point(at))->evaluate(std::span<const symbol>());
      return expression((*f)(point), f->names()).known_value(b.bits);
    } catch (const input_error&) {
      return std::nullopt;
    }
  }

  /// The only root of g in the box, to the digits that a place is worth.
  ball refined_place(const real_function& g, const ball& root, const ball& box) {
    constexpr precision p = 60;
    const auto value = [&](const ball& t) { return g.at(t.precision())->value(t); };
    const auto slope = [&](const ball& t) { return g.at(t.precision())->derivative(t); };
    const root_enclosure r =
        refine_root(value, slope, intersection(root.enlarged(root.radius()), box), p);
    result_.evaluations += r.evaluations_of_f + r.evaluations_of_derivative;
    const ball both = intersection(r.root, root);
    const ball place = both.is_undefined() ? root : both;
    // A root that is a simple number, such as a pole of gamma, is that number.
    const auto simple = simple_number_in(exact_ends(place));
    return simple && sign_of(value(ball(*simple, p))) == certain_sign::zero ? ball(*simple, p)
                                                                            : place;
  }

  /// The order of the zero of f at the simplest rational number in the box, or the simplest
  /// rational multiple of pi, or, in a narrow box, at a guessed point, where f is exactly 0 there.
  struct exact_zero {
    exact_point at;
    long multiplicity = 0;  // 0 where it was not found
  };
  std::optional<exact_zero> exact_zero_in(const work_box& b) {
    const auto zero_at = [&](const exact_point& at) { return exact_zero_at(at, b); };
    if (auto zero = first_of_simple_points(b.x, b.bits, zero_at)) return zero;
    const expression* const f = problem(b).g->formula();
    if (f == nullptr || b.halvings < cheap_halvings) return std::nullopt;
    for (const exact_point& at : guessed_points(*f, b.x, b.bits)) {
      if (auto zero = zero_at(at)) return zero;
    }
    return std::nullopt;
  }
  std::optional<exact_zero> exact_zero_at(const exact_point& at, const work_box& b) {
    exact_zero r{at, 0};
    // Where a value shows that there is none, at a small part of the cost.
    ++result_.evaluations;
    const ball value = evaluator(b.problem, b.bits).value(at.at(b.bits));
    if (is_certainly_not_zero(value)) return std::nullopt;
    for (const int order : {1, 8, 40}) {
      const auto s =
          structure(problem(b), function_structure::variable_at(r.at.known(b.bits), order));
      if (!s || !s->series() || (*s->series())[0].enclosure().is_undefined()) {
        return zero_at_branch_point(at, b);
      }
      const auto& t = *s->series();
      if (!settled(t[0]).is_zero()) return std::nullopt;
      int k = 1;
      while (k <= order && settled(t[k]).is_zero()) ++k;
      if (k > order) continue;
      if (is_certainly_not_zero(t[k].enclosure())) r.multiplicity = k;
      return r;
    }
    return r;
  }

  /// Where there is no series, as of x^pi and x^x at 0: by the formula at the point.
  std::optional<exact_zero> zero_at_branch_point(const exact_point& at, const work_box& b) {
    if (!at.form()) return std::nullopt;
    const auto value = value_at(b, *at.form());
    if (!value || !settled(*value).is_zero()) return std::nullopt;
    return exact_zero{at, 0};
  }

  /// The simplest rational number in the box, where f is exactly 0 there and has no known
  /// derivative.
  std::optional<rational> kink_in(const work_box& b) {
    const auto at = simple_number_in(b.x);
    if (!at) return std::nullopt;
    const auto s = structure(problem(b), function_structure::variable_at(*at, 1, b.bits));
    if (!s || !s->series()) return std::nullopt;
    const auto& t = *s->series();
    const bool is_kink = t[0].is_exactly(0) && t[1].enclosure().is_undefined();
    return is_kink ? at : std::nullopt;
  }

  /// f, ..., f^(m-1) are exactly 0 at c in x, and f^(m) has no zero in x: then c is the only root
  /// in x, m times, since m + 1 roots, counted with their multiplicities, would give f^(m) a zero
  /// (Rolle).
  bool by_exact_point(const work_box& b, const exact_box& wide, const ball& x,
                      const exact_zero& zero) {
    if (zero.multiplicity == 0) return false;
    const auto m = static_cast<int>(zero.multiplicity);
    if (m > problem(b).g->most_order()) return false;
    const series_type over = series(b, x, m);
    for (int k = 0; k <= m; ++k) {
      if (over[k].is_undefined()) return false;
    }
    if (contains_zero(over[m])) return false;
    add_exact(b, wide, x, zero.at, m);
    return true;
  }

  /// The root of the problem at the point, with which add is called.
  void add_exact(const work_box& b, const exact_box& wide, const ball& x, const exact_point& at,
                 long multiplicity) {
    if (const auto q = at.as_rational()) {
      return add(b, wide, x, ball(*q, b.bits), multiplicity, *q, problem(b).g);
    }
    // The same root, simple, to refine.
    expression_names names;
    if (const expression* const f = problem(b).g->formula()) names = f->names();
    names.variables = {"x"};
    const expression distance("x - (" + at.to_text() + ')', names);
    add(b, wide, x, at.at(b.bits), multiplicity, std::nullopt,
        std::make_shared<real_function>(distance));
  }

  /// True where the box is settled: it has no root, or none but an exact one at a jump of f.
  bool by_jumps(const work_box& b, const exact_box& wide, const ball& x) {
    const expression* const f = problem(b).g->formula();
    if (f == nullptr || problem(b).is_factor) return false;
    const jump_report r = examine_jumps(*f, b.x, x, b.bits);
    result_.evaluations += r.evaluations;
    if (r.has_no_root) exclude(b.x, x);
    if (r.only_root) add_exact(b, wide, x, *r.only_root, 0);
    return r.has_no_root || r.only_root;
  }

  /// f is 0 at c in x, and its growth on both sides of c proves that x has no other root.
  bool by_growth(const work_box& b, const exact_box& wide, const ball& x, const exact_zero& zero) {
    if (!zero.at.form() || !grows_on_both_sides(b, x, *zero.at.form())) return false;
    add_exact(b, wide, x, zero.at, zero.multiplicity);
    return true;
  }
  /// No root in x beside the point, which lies in it.
  bool grows_on_both_sides(const work_box& b, const ball& x, const pi_combination& at) {
    const real_function& f = *problem(b).g;
    const exact_box whole = exact_ends(x);
    const ball point = at.at(b.bits + 64);
    const rational above = upper_rational(ball(*whole.upper, b.bits + 64) - point);
    const rational below = lower_rational(ball(*whole.lower, b.bits + 64) - point);
    if (!(above > 0 && below < 0)) return false;
    // A proof takes long, and there is none where f changes its sign.
    if (has_two_signs(f, point, above) || has_two_signs(f, point, below)) return false;
    return f.has_no_root_beside(at, above) && f.has_no_root_beside(at, below);
  }
  /// f has values of both signs among a few between the point and point + width.
  static bool has_two_signs(const real_function& f, const ball& point, const rational& width) {
    const precision p = point.precision();
    const auto evaluator = f.at(p);
    bool has_positive = false;
    bool has_negative = false;
    for (const long halvings : {0L, 1L, 2L, 4L, 8L, 16L}) {
      const ball value = evaluator->value(point + scale(ball(width, p), -halvings));
      has_positive = has_positive || certainly_positive(value);
      has_negative = has_negative || certainly_negative(value);
    }
    return has_positive && has_negative;
  }

  // -------------------------------------------------------------------------------------------
  // Towards infinity

  /// f^(k) > 0 on [M, inf), f^(j)(M) >= 0 for j < k and f(M) > 0 prove f > 0 on [M, inf): going
  /// down from k, f^(j)(x) = f^(j)(M) + the integral of f^(j+1). Likewise for f < 0, and towards
  /// -infinity with f(-x).
  bool keeps_its_sign(const work_box& b, const series_type& over) {
    const bool rightward = b.x.lower.has_value();
    const ball end(rightward ? *b.x.lower : *b.x.upper, b.bits);
    const series_type at_end = series(b, end, over.order());
    const certain_sign first = sign_of(at_end[0]);
    if (first != certain_sign::positive && first != certain_sign::negative) return false;
    for (int k = 0; k <= over.order(); ++k) {
      // f^(k) may go on where f itself has a jump.
      if (over[k].is_undefined()) return false;
      // The k-th coefficient of f(-x), or of -f, where these take the place of f.
      const bool turned = (!rightward && k % 2 != 0) != (first == certain_sign::negative);
      if (certainly_positive(turned ? -over[k] : over[k])) return true;
      if (!is_not_negative(turned ? -at_end[k] : at_end[k])) return false;
    }
    return false;
  }

  void examine_tail(work_box b) {
    if (!b.x.lower && !b.x.upper) {
      work_box right = b;
      work_box left = b;
      b.x = {rational(-1), rational(1)};
      left.x.upper = -1;
      right.x.lower = 1;
      for (work_box* part : {&right, &b, &left}) result_.rest.push_back(std::move(*part));
      return;
    }
    const bool rightward = b.x.lower.has_value();
    const rational end = rightward ? *b.x.lower : *b.x.upper;
    const rational size = rightward ? end : rational(-end);
    const ball x = b.x.to_ball(b.bits);
    constexpr int order = 12;
    const int n = std::min(std::max(order, problem(b).g->best_order()), problem(b).g->most_order());
    const series_type over = series(b, x, n);
    if (is_certainly_not_zero(over[0])) return exclude(b.x, x);
    if (size >= 1) {
      if (keeps_its_sign(b, over)) return exclude(b.x, x);
      constexpr long far = 16;
      if (size >= far && problem(b).g->has_no_root_beyond(end)) return exclude(b.x, x);
      if (const auto s =
              structure(problem(b), function_structure::variable(x, ball(end, b.bits)))) {
        const bool nowhere = !s->natural_range() || is_certainly_not_zero(*s->natural_range());
        const auto& factors = s->numerator().factors;
        if (nowhere || std::all_of(factors.begin(), factors.end(), [](const auto& g) {
              return is_certainly_not_zero(g.over[0]);
            })) {
          if (s->over()[0].is_undefined()) result_.singular.push_back({x, 0});
          return exclude(b.x, x);
        }
      }
    }
    const rational farthest = rational(integer(1) << (1U << 17));
    if (size > farthest) {
      b.remark = "the sign towards infinity is not proved";
      result_.stuck.push_back(std::move(b));
      return;
    }
    const rational great = rational(integer(1) << 64U);
    const rational next_size = size < 1       ? rational(1)
                               : size < great ? rational(2 * size + 1)
                                              : rational(size * size);
    const rational cut = rightward ? next_size : rational(-next_size);
    work_box near = b;
    (rightward ? near.x.upper : near.x.lower) = cut;
    (rightward ? b.x.lower : b.x.upper) = cut;
    // Outward: the near part is on top.
    result_.rest.push_back(std::move(b));
    result_.rest.push_back(std::move(near));
  }

  // -------------------------------------------------------------------------------------------
  // Roots

  void add_simple_root(const work_box& b, const exact_box& done, const ball& x, const ball& image) {
    add(b, done, x, image, problem(b).multiplicity, std::nullopt, problem(b).g);
  }

  /// The only root of the problem in the box, of multiplicity 0 where it has none; `done`, which
  /// lies in the box, need not be searched any more.
  void add(const work_box& b, const exact_box& done, const ball& box, const ball& enclosure,
           long multiplicity, std::optional<rational> exact,
           std::shared_ptr<const real_function> simple) {
    root_region r;
    r.verdict = multiplicity == 0   ? root_verdict::isolated
                : multiplicity == 1 ? root_verdict::unique
                                    : root_verdict::multiple;
    r.box = box;
    r.enclosure = intersection(enclosure, box);
    r.multiplicity = multiplicity;
    r.exact = std::move(exact);
    r.function = problem(b).g;
    r.simple = std::move(simple);
    result_.known = {done, box, std::move(r)};
  }

  // -------------------------------------------------------------------------------------------
  // The end

  /// What is proved of a cluster.
  void conclude(const work_box& b) {
    root_region r;
    r.box = r.enclosure = b.x.to_ball(b.bits);
    r.remark = b.remark;
    r.function = r.simple = problem(b).g;
    if (b.has_endless_roots) r.verdict = root_verdict::infinitely_many;
    if (b.x.is_bounded() && !b.is_open_end && !b.has_endless_roots) {
      // A structure that no single one of its boxes had.
      const exact_box wide = widened(b.x);
      if (by_structure(b) || by_jumps(b, wide, wide.to_ball(b.bits))) return;
      if (const auto zero = exact_zero_in(b)) {
        r.verdict = root_verdict::at_least_one;
        r.exact = zero->at.as_rational();
      } else if (changes_sign(b)) {
        r.verdict = root_verdict::at_least_one;
      }
      const region over = problem(b).g->over(region(r.box));
      if (!over.is_analytic() && over.why() != obstacle::unknown) {
        r.remark = "the " + to_text(over.why()) + " of " + std::string(over.where());
      }
      if (!over.is_analytic() && problem(b).g->has_endless_roots_in(*b.x.lower, *b.x.upper)) {
        r.verdict = root_verdict::infinitely_many;
        r.exact.reset();
        r.remark.clear();
        result_.known = {b.x, r.box, std::move(r)};
        return;
      }
      const auto zeros = count_zeros(*problem(b).g, b.x.middle(), b.x.width() / 2, 2 * b.bits);
      if (zeros) {
        result_.evaluations += zeros->evaluations;
        const bool holds_box = 2 * zeros->radius >= b.x.width();
        if (zeros->count == 0 && holds_box) return exclude(b.x, r.box);
        const bool of_f = s_.problems.size() == 1 && problem(b).multiplicity == 1;
        if (of_f) r.complex_roots = zeros->count;
      }
    }
    result_.known = {b.x, r.box, std::move(r)};
  }

  /// f is continuously differentiable on the box and has opposite signs at its ends.
  bool changes_sign(const work_box& b) {
    const ball x = b.x.to_ball(b.bits);
    const series_type over = series(b, x, 1);
    if (over[0].is_undefined() || over[1].is_undefined()) return false;
    const auto sign_at = [&](const rational& end) {
      for (precision p = b.bits; p <= std::max(4 * b.bits, options_.most_precision); p *= 2) {
        ++result_.evaluations;
        const certain_sign s = sign_of(evaluator(b.problem, p).value(ball(end, p)));
        if (s != certain_sign::unknown) return s;
      }
      return certain_sign::unknown;
    };
    const certain_sign left = sign_at(*b.x.lower);
    const certain_sign right = sign_at(*b.x.upper);
    return (left == certain_sign::negative && right == certain_sign::positive) ||
           (left == certain_sign::positive && right == certain_sign::negative);
  }

  const root_search::state& s_;
  const isolate_options& options_;
  evaluators& evaluators_;
  outcome result_;
};

}  // namespace

outcome examine_box(const root_search::state& s, const isolate_options& options, evaluators& known,
                    work_box b) {
  return examination(s, options, known).of_box(std::move(b));
}

outcome examine_cluster(const root_search::state& s, const isolate_options& options,
                        evaluators& known, const work_box& b) {
  return examination(s, options, known).of_cluster(b);
}

}  // namespace polhode::detail
