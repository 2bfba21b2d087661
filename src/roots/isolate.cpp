#include "polhode/roots/isolate.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <iterator>
#include <map>
#include <utility>

#include <tbb/enumerable_thread_specific.h>

#include "base/worker_threads.hpp"
#include "count_zeros.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/text.hpp"
#include "tiling.hpp"

namespace polhode {
namespace {

constexpr precision first_bits = 64;

using series_type = jet<ball, dynamic_order>;

using exact_box = detail::exact_interval;
using detail::expect;
using detail::holds;
using detail::precedes;

exact_box exact_ends(const ball& x) { return {lower_rational(x), upper_rational(x)}; }

/// The box and half of its width more on either side; a point, and a little.
exact_box widened(const exact_box& b) {
  rational more = b.width() / 2;
  if (more == 0) more = (abs(*b.lower) + 1) / (1L << 40);
  return {*b.lower - more, *b.upper + more};
}

struct outcome;

struct work_box {
  exact_box x;
  int halvings = 0;
  precision bits = first_bits;
  std::size_t problem = 0;
  std::string remark;  // why it is left unresolved
  /// What its examination gives, where it was examined before its turn.
  std::shared_ptr<outcome> ahead = nullptr;
};

/// What the examination of a box gives, of pieces that make up the box. It depends on the box and the options alone.
struct outcome {
  struct without_root {
    exact_box x;
    ball over;  // has no root in this set
  };
  /// All roots in `done`, which holds the box, are known: the region's, or none where there is no region.
  struct known_part {
    exact_box done;
    ball over;  // what the proof is about: the region's box
    std::optional<root_region> region;
  };
  std::vector<work_box> rest;  // left to do, in the order of a stack
  std::vector<work_box> stuck;
  std::vector<without_root> excluded;
  std::optional<known_part> known;
  std::vector<singular_place> singular;
  long evaluations = 0;
  precision most_bits = 0;
  std::exception_ptr error;  // what f threw
};

/// Proves that the outcome is about the whole box: the pieces make it up, and what was proved was proved over them.
void expect_whole(const exact_box& box, const outcome& o) {
  detail::interval_tiling pieces(box);
  for (const work_box& b : o.rest) pieces.add(b.x);
  for (const work_box& b : o.stuck) pieces.add(b.x);
  for (const auto& e : o.excluded) {
    pieces.add(e.x);
    expect(holds(e.over, e.x), "a piece without a root is not in the set that has none");
  }
  if (o.known) {
    pieces.add(box);
    expect(holds(o.known->done, box), "a box is not in the part where the roots are known");
    expect(holds(o.known->over, o.known->done), "a part is not in the set that the proof is about");
    if (const auto& r = o.known->region) {
      expect(contains(r->box, r->enclosure), "an enclosure is not in the box of its region");
    }
  }
  pieces.expect_complete();
}

/// A function whose roots are looked for: f, or a factor of the polynomial f with simple roots only.
struct root_problem {
  std::shared_ptr<const real_function> g;
  long multiplicity = 1;  // of its roots, as roots of f
  bool square_free = false;
};

struct found_root {
  root_region region;
  std::size_t problem = 0;
  double_interval about;  // holds the region's box
};

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

bool is_certainly_not_zero(const ball& x) { return !x.is_undefined() && !contains_zero(x); }
bool is_not_negative(const ball& x) {
  const sign s = sign_of(x);
  return s == sign::positive || s == sign::zero;
}

/// Bits of the longer part of q.
std::size_t height(const rational& q) { return rational_polynomial({q}).height(); }

}  // namespace

struct root_search::state {
  std::shared_ptr<const real_function> f;
  end_point lower = 0;
  end_point upper = 0;
  std::vector<root_problem> problems;
  std::vector<detail::settled_pieces> settled;  // of each problem
  std::vector<work_box> pending;                // a stack, the leftmost box on top
  std::vector<work_box> stuck;
  std::vector<found_root> found;
  std::vector<singular_place> singular;
  bool identically_zero = false;
  bool concluded = false;
  std::string limit;  // the one that ended the last run
  isolation_account account;
};

namespace {

/// f and f' over X by Taylor's formula about m, cut with what is known of them:
///   f(x) = sum over k < n of f_k(m) h^k + f_n(t) h^n, h = x - m, t in X, and f'(x) = sum of k f_k(m) h^(k-1)
///   + n f_n(t') h^(n-1): the derivative's coefficients are k f_k, and f_n over X bounds its last one.
struct enclosed_function {
  ball value;
  ball slope;
};
enclosed_function taylor(const series_type& at_middle, const series_type& over, const ball& h) {
  const int n = over.order();
  enclosed_function r{over[n] * pow(h, n), n * over[n] * pow(h, n - 1)};
  for (int k = n - 1; k >= 0; --k) {
    r.value += at_middle[k] * pow(h, k);
    if (k >= 1) r.slope += k * at_middle[k] * pow(h, k - 1);
  }
  const auto cut = [](const ball& plain, const ball& formula) {
    if (formula.is_undefined()) return plain;
    const ball both = intersection(plain, formula);
    return both.is_undefined() ? plain : both;
  };
  return {cut(over[0], r.value), cut(over[1], r.slope)};
}

/// f' over x, by Taylor's formula too where plain evaluation does not tell its sign.
ball slope_over(const function_evaluator& e, const ball& x, const real_function& f) {
  ball plain = e.derivative(x);
  if (plain.is_undefined() || !contains_zero(plain)) return plain;
  const int n = f.best_order();
  const ball middle = x.middle();
  const series_type over = e.series(x, n);
  if (over[n].is_undefined()) return plain;
  return taylor(e.series(middle, n), over, x - middle).slope;
}

bool are_neighbours(const work_box& b, const work_box& c, const std::vector<found_root>& found) {
  if (!b.x.upper || !c.x.lower) return true;
  if (*c.x.lower <= *b.x.upper) return true;
  if (!b.x.is_bounded() || !c.x.is_bounded() ||
      *c.x.lower - *b.x.upper > 4 * (b.x.width() + c.x.width())) {
    return false;
  }
  const ball gap = exact_box{*b.x.upper, *c.x.lower}.to_ball(b.bits);
  return std::none_of(found.begin(), found.end(), [&](const found_root& r) {
    return r.problem == b.problem && overlaps(r.region.enclosure, gap);
  });
}

/// Neighbours become one cluster, where no root that is known lies between them.
std::vector<work_box> joined(std::vector<work_box> boxes, const std::vector<found_root>& found) {
  std::sort(boxes.begin(), boxes.end(), [](const work_box& x, const work_box& y) {
    return x.problem != y.problem ? x.problem < y.problem : precedes(x.x, y.x);
  });
  std::vector<work_box> result;
  for (work_box& b : boxes) {
    if (!result.empty() && result.back().problem == b.problem &&
        are_neighbours(result.back(), b, found)) {
      exact_box& x = result.back().x;
      if (x.upper && (!b.x.upper || *x.upper < *b.x.upper)) x.upper = b.x.upper;
      result.back().bits = std::max(result.back().bits, b.bits);
    } else {
      result.push_back(std::move(b));
    }
  }
  return result;
}

/// The boxes that each cluster, made by `joined`, has in it. Proves that every box is in one.
std::vector<std::vector<const exact_box*>> parts_of(const std::vector<work_box>& clusters,
                                                    const std::vector<work_box>& boxes) {
  std::vector<std::vector<const exact_box*>> parts(clusters.size());
  for (const work_box& b : boxes) {
    // The last cluster that does not begin after it.
    const auto next = std::upper_bound(
        clusters.begin(), clusters.end(), b, [](const work_box& x, const work_box& y) {
          return x.problem != y.problem ? x.problem < y.problem : precedes(x.x, y.x);
        });
    expect(next != clusters.begin(), "an open box is in no cluster");
    const work_box& cluster = *std::prev(next);
    expect(cluster.problem == b.problem && holds(cluster.x, b.x), "an open box is in no cluster");
    parts[static_cast<std::size_t>(std::prev(next) - clusters.begin())].push_back(&b.x);
  }
  return parts;
}

/// The evaluators of one thread.
using evaluators =
    std::map<std::pair<std::size_t, precision>, std::shared_ptr<const function_evaluator>>;

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
    auto& known = evaluators_[{problem, p}];
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
    const ball x = b.x.to_ball(b.bits);
    const int n = problem(b).g->best_order();
    series_type over = series(b, x, n);
    if (is_certainly_not_zero(over[0])) return exclude(b.x, x);
    if (over[0].is_undefined() || over[1].is_undefined()) {
      if (!has_no_root_where_defined(b) && !by_structure(b)) halve(b);
      return;
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
    if (is_turn_for_structure(b.halvings) && by_structure(b)) return;
    halve(b);
  }

  /// There is no root in x, nor in the set, which holds it.
  void exclude(const exact_box& x, const ball& over) { result_.excluded.push_back({x, over}); }

  /// What is spent on cancellation grows with the depth: a function that is 0 on an interval is not to cost
  /// the most everywhere.
  [[nodiscard]] precision most_bits(const work_box& b) const {
    return std::min<precision>(options_.most_precision, 512 + 32L * b.halvings);
  }

  static bool is_turn_for_structure(int halvings) {
    constexpr std::array turns = {8, 12, 16, 24, 32, 48, 64, 96, 128, 160, 192};
    return std::find(turns.begin(), turns.end(), halvings) != turns.end();
  }

  /// True where the box is settled: it has no root, its root was found, or a narrower box takes its place.
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
    work_box rest = b;
    rest.x = exact_ends(left);
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

  void halve(work_box b) {
    if (b.halvings >= options_.most_halvings || b.x.width() == 0) {
      b.remark = "not resolved by " + std::to_string(b.halvings) + " halvings";
      result_.stuck.push_back(std::move(b));
      return;
    }
    ++b.halvings;
    work_box right = b;
    right.x.lower = b.x.middle();
    b.x.upper = right.x.lower;
    result_.rest.push_back(std::move(right));
    result_.rest.push_back(std::move(b));
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
    if (problem(b).square_free) return false;
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
          result_.singular.push_back({refined_place(g, *pole, x), poles.front()->power});
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
    if (zeros.size() == 1 && poles.empty() && is_defined && !over[1].is_undefined()) {
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
    return by_exact_point(b, wide, x);
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
    return both.is_undefined() ? root : both;
  }

  /// The order of the zero of f at the simplest rational number in the box, where f is exactly 0 there.
  struct exact_zero {
    rational at;
    long multiplicity = 0;  // 0 where it was not found
  };
  std::optional<exact_zero> exact_zero_in(const work_box& b) {
    exact_zero r{simplest_between(*b.x.lower, *b.x.upper), 0};
    constexpr std::size_t simple_height = 200;
    if (height(r.at) > simple_height) return std::nullopt;
    for (const int order : {1, 8, 40}) {
      const auto s = structure(problem(b), function_structure::variable_at(r.at, order, b.bits));
      if (!s || !s->series()) return std::nullopt;
      const auto& t = *s->series();
      if (!t[0].is_exactly(0)) return std::nullopt;
      int k = 1;
      while (k <= order && t[k].is_exactly(0)) ++k;
      if (k > order) continue;
      if (is_certainly_not_zero(t[k].enclosure())) r.multiplicity = k;
      return r;
    }
    return r;
  }

  /// f, ..., f^(m-1) are exactly 0 at c in x, and f^(m) has no zero in x: then c is the only root in x, m
  /// times, since m + 1 roots, counted with their multiplicities, would give f^(m) a zero (Rolle).
  bool by_exact_point(const work_box& b, const exact_box& wide, const ball& x) {
    const auto zero = exact_zero_in(b);
    if (!zero || zero->multiplicity == 0) return false;
    const auto m = static_cast<int>(zero->multiplicity);
    if (m > problem(b).g->most_order()) return false;
    const series_type over = series(b, x, m);
    for (int k = 0; k <= m; ++k) {
      if (over[k].is_undefined()) return false;
    }
    if (contains_zero(over[m])) return false;
    add(b, wide, x, ball(zero->at, b.bits), m, zero->at, problem(b).g);
    return true;
  }

  // -------------------------------------------------------------------------------------------
  // Towards infinity

  /// f^(k) > 0 on [M, inf), f^(j)(M) >= 0 for j < k and f(M) > 0 prove f > 0 on [M, inf): going down from k,
  /// f^(j)(x) = f^(j)(M) + the integral of f^(j+1). Likewise for f < 0, and towards -infinity with f(-x).
  bool keeps_its_sign(const work_box& b, const series_type& over) {
    const bool rightward = b.x.lower.has_value();
    const ball end(rightward ? *b.x.lower : *b.x.upper, b.bits);
    const series_type at_end = series(b, end, over.order());
    const sign first = sign_of(at_end[0]);
    if (first != sign::positive && first != sign::negative) return false;
    for (int k = 0; k <= over.order(); ++k) {
      // f^(k) may go on where f itself has a jump.
      if (over[k].is_undefined()) return false;
      // The k-th coefficient of f(-x), or of -f, where these take the place of f.
      const bool turned = (!rightward && k % 2 != 0) != (first == sign::negative);
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
    const rational farthest = rational(integer(1) << 1024U);
    if (size > farthest) {
      b.remark = "the sign towards infinity is not proved";
      result_.stuck.push_back(std::move(b));
      return;
    }
    const rational next_size = size < 1 ? rational(1) : rational(2 * size + 1);
    const rational cut = rightward ? next_size : rational(-next_size);
    work_box near = b;
    (rightward ? near.x.upper : near.x.lower) = cut;
    (rightward ? b.x.lower : b.x.upper) = cut;
    if (rightward) std::swap(near, b);
    result_.rest.push_back(std::move(near));
    result_.rest.push_back(std::move(b));
  }

  // -------------------------------------------------------------------------------------------
  // Roots

  void add_simple_root(const work_box& b, const exact_box& done, const ball& x, const ball& image) {
    add(b, done, x, image, problem(b).multiplicity, std::nullopt, problem(b).g);
  }

  /// The only root of the problem in the box; `done`, which lies in the box, need not be searched any more.
  void add(const work_box& b, const exact_box& done, const ball& box, const ball& enclosure,
           long multiplicity, std::optional<rational> exact,
           std::shared_ptr<const real_function> simple) {
    root_region r;
    r.verdict = multiplicity == 1 ? root_verdict::unique : root_verdict::multiple;
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
    if (b.x.is_bounded()) {
      // A structure that no single one of its boxes had.
      if (by_structure(b)) return;
      if (const auto zero = exact_zero_in(b)) {
        r.verdict = root_verdict::at_least_one;
        r.exact = zero->at;
      } else if (changes_sign(b)) {
        r.verdict = root_verdict::at_least_one;
      }
      const region over = problem(b).g->over(region(r.box));
      if (!over.is_analytic() && over.why() != obstacle::unknown) {
        r.remark = "the " + to_text(over.why()) + " of " + std::string(over.where());
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
        const sign s = sign_of(evaluator(b.problem, p).value(ball(end, p)));
        if (s != sign::unknown) return s;
      }
      return sign::unknown;
    };
    const sign left = sign_at(*b.x.lower);
    const sign right = sign_at(*b.x.upper);
    return (left == sign::negative && right == sign::positive) ||
           (left == sign::positive && right == sign::negative);
  }

  const root_search::state& s_;
  const isolate_options& options_;
  evaluators& evaluators_;
  outcome result_;
};

/// One run of a search. Boxes are examined from left to right, each result before the next box; more threads examine
/// boxes before their turn, and what they find waits for it. So their number changes nothing in the answer.
class searcher {
 public:
  searcher(root_search::state& s, const isolate_options& options) : s_(s), options_(options) {
    if (options.threads == 1) return;
    workers_.emplace(options.threads);
    constexpr long boxes_for_each = 16;
    most_at_a_time_ =
        boxes_for_each * (options.threads == 0 ? workers_->processors() : options.threads);
  }

  void run() {
    search();
    for (work_box& b : s_.pending) b.ahead = nullptr;
  }

 private:
  void search() {
    const auto start = std::chrono::steady_clock::now();
    s_.limit.clear();
    constexpr long between_looks = 64;
    for (long boxes = 0; !s_.pending.empty(); ++boxes) {
      if (boxes >= options_.most_boxes) {
        s_.limit = "the limit on the number of boxes";
        return;
      }
      if (static_cast<long>(s_.stuck.size()) > options_.most_unresolved) {
        s_.limit = "the limit on unresolved boxes";
        return;
      }
      if (options_.most_time && std::chrono::steady_clock::now() - start > *options_.most_time) {
        s_.limit = "the limit on the time";
        return;
      }
      if (options_.progress && boxes % between_looks == 0 &&
          !options_.progress({s_.account.boxes, static_cast<long>(s_.pending.size()),
                              static_cast<long>(s_.found.size())})) {
        s_.limit = "a request to stop";
        return;
      }
      if (s_.pending.back().ahead == nullptr) examine_next();
      const work_box b = std::move(s_.pending.back());
      s_.pending.pop_back();
      ++s_.account.boxes;
      --waiting_;
      merge(b, {&b.x}, std::move(*b.ahead));
    }
    if (!s_.concluded) conclude();
    s_.concluded = true;
  }

  // -------------------------------------------------------------------------------------------
  // Examining

  /// The outcome of examine(of an examination), or the exception that it was left by.
  template <class Examine>
  std::shared_ptr<outcome> outcome_of(const Examine& examine) {
    auto r = std::make_shared<outcome>();
    try {
      *r = examine(examination(s_, options_, evaluators_.local()));
    } catch (...) {
      r->error = std::current_exception();
    }
    return r;
  }

  /// The next box, and with more threads some of those that come after it.
  void examine_next() {
    std::vector<work_box*> boxes;
    collect(s_.pending, boxes);
    const auto step = [&](long i) {
      work_box& b = *boxes[static_cast<std::size_t>(i)];
      b.ahead = outcome_of([&b](examination e) { return std::move(e).of_box(b); });
    };
    const auto count = static_cast<long>(boxes.size());
    if (count == 1) {
      step(0);
    } else {
      workers_->for_each(count, step);
    }
    waiting_ += count;
  }

  /// The boxes that are to be examined, in the order in which the search will meet them, as far as that is known.
  void collect(std::vector<work_box>& stack, std::vector<work_box*>& boxes) const {
    constexpr long most_waiting = 4096;  // they take memory
    const long most = workers_ && waiting_ < most_waiting ? most_at_a_time_ : 1;
    for (std::size_t i = stack.size(); i-- > 0 && static_cast<long>(boxes.size()) < most;) {
      if (stack[i].ahead == nullptr) {
        boxes.push_back(&stack[i]);
      } else {
        collect(stack[i].ahead->rest, boxes);
      }
    }
  }

  /// What it is worth if the search goes another way.
  void forget_ahead(work_box& b) {
    if (b.ahead == nullptr) return;
    --waiting_;
    for (work_box& part : b.ahead->rest) forget_ahead(part);
    b.ahead = nullptr;
  }

  // -------------------------------------------------------------------------------------------
  // Merging

  /// Proves that the outcome is about the whole box, and keeps it. Of the box, the parts are what was open until now.
  void merge(const work_box& b, const std::vector<const exact_box*>& parts, outcome o) {
    if (o.error) std::rethrow_exception(o.error);
    expect_whole(b.x, o);
    s_.account.evaluations += o.evaluations;
    s_.account.most_bits = std::max(s_.account.most_bits, o.most_bits);
    const auto append = [](auto& to, auto& from) {
      to.insert(to.end(), std::make_move_iterator(from.begin()),
                std::make_move_iterator(from.end()));
    };
    append(s_.singular, o.singular);
    settle(b, parts, o);
    append(s_.stuck, o.stuck);
    append(s_.pending, o.rest);
  }

  /// A cluster's outcome is about its hull, one set without a root or with known ones, and settles its parts.
  void settle(const work_box& b, const std::vector<const exact_box*>& parts, outcome& o) {
    detail::settled_pieces& settled = s_.settled[b.problem];
    const bool is_cluster = parts.size() != 1 || parts.front() != &b.x;
    expect(!is_cluster || (o.rest.empty() && o.stuck.empty()), "a cluster is not concluded");
    if (!o.known) {
      if (is_cluster) {
        for (const exact_box* x : parts) settled.add_without_root(*x);
      } else {
        for (const auto& e : o.excluded) settled.add_without_root(e.x);
      }
      return;
    }
    const auto settle_all = [&](const auto& add_piece) {
      for (const exact_box* x : parts) add_piece(*x);
      take_out(b.problem, o.known->done, add_piece);
    };
    if (!o.known->region) {
      settle_all([&](const exact_box& x) { settled.add_without_root(x); });
      return;
    }
    const std::size_t region = add(b.problem, std::move(*o.known->region));
    settle_all([&](const exact_box& x) { settled.add_known(x, region); });
  }

  /// The number of the region in the list.
  std::size_t add(std::size_t problem, root_region r) {
    const auto about = double_interval::from_ball(r.box);
    for (std::size_t i = 0; i < s_.found.size(); ++i) {
      found_root& known = s_.found[i];
      if (r.multiplicity > 0 && known.problem == problem && overlaps(known.about, about) &&
          is_the_same(known.region, r)) {
        known.about = double_interval::from_ball(known.region.box);
        return i;
      }
    }
    s_.found.push_back({std::move(r), problem, about});
    return s_.found.size() - 1;
  }

  /// Whether the roots of the two regions are one. Each is the only one in its box.
  static bool is_the_same(root_region& known, root_region& more) {
    if (known.multiplicity == 0 || !overlaps(known.box, more.box)) return false;
    for (long digits = 15; digits <= 15L << 8; digits *= 2) {
      if (contains(known.box, more.enclosure) || contains(more.box, known.enclosure)) return true;
      if (!overlaps(known.enclosure, more.enclosure)) return false;
      known.enclosure = refine(known, digits).enclosure;
      more.enclosure = refine(more, digits).enclosure;
    }
    // One root or two, at the common end of both boxes: neither is claimed.
    known.enclosure = hull(known.enclosure, more.enclosure);
    known.box = hull(known.box, more.box);
    known.verdict = root_verdict::at_least_one;
    known.multiplicity = 0;
    known.remark = "one root or two";
    return true;
  }

  /// Settles `done`, in which all roots of the problem are known. Gives what it takes out to add_piece.
  template <class AddPiece>
  void take_out(std::size_t problem, const exact_box& done, const AddPiece& add_piece) {
    for (auto* boxes : {&s_.pending, &s_.stuck}) {
      std::vector<work_box> left;
      left.reserve(boxes->size());
      for (work_box& b : *boxes) {
        const bool apart = b.problem != problem || (b.x.upper && *b.x.upper < *done.lower) ||
                           (b.x.lower && *b.x.lower > *done.upper);
        if (apart) {
          left.push_back(std::move(b));
          continue;
        }
        // It may only touch.
        const bool is_whole = (b.x.lower && *b.x.lower == *done.upper && b.x.lower != b.x.upper) ||
                              (b.x.upper && *b.x.upper == *done.lower && b.x.lower != b.x.upper);
        if (is_whole) {
          left.push_back(std::move(b));
          continue;
        }
        forget_ahead(b);
        add_piece(
            {!b.x.lower || (done.lower && *b.x.lower < *done.lower) ? done.lower : b.x.lower,
             !b.x.upper || (done.upper && *b.x.upper > *done.upper) ? done.upper : b.x.upper});
        // The right part first: the leftmost box is on top.
        if (!b.x.upper || *b.x.upper > *done.upper) {
          left.push_back(b);
          left.back().x.lower = done.upper;
        }
        if (!b.x.lower || *b.x.lower < *done.lower) {
          left.push_back(std::move(b));
          left.back().x.upper = done.lower;
        }
      }
      *boxes = std::move(left);
    }
  }

  /// What is proved of the boxes that stay unresolved.
  void conclude() {
    const std::vector<work_box> boxes = std::move(s_.stuck);
    s_.stuck.clear();
    const std::vector<work_box> clusters = joined(boxes, s_.found);
    const auto parts = parts_of(clusters, boxes);
    std::vector<std::shared_ptr<outcome>> outcomes(clusters.size());
    const auto step = [&](long i) {
      const auto k = static_cast<std::size_t>(i);
      outcomes[k] = outcome_of([&](examination e) { return std::move(e).of_cluster(clusters[k]); });
    };
    const auto count = static_cast<long>(clusters.size());
    if (workers_) {
      workers_->for_each(count, step);
    } else {
      for (long i = 0; i < count; ++i) step(i);
    }
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      merge(clusters[i], parts[i], std::move(*outcomes[i]));
    }
  }

  root_search::state& s_;
  const isolate_options& options_;
  std::optional<detail::worker_threads> workers_;
  tbb::enumerable_thread_specific<evaluators> evaluators_;
  long most_at_a_time_ = 1;
  long waiting_ = 0;  // boxes that were examined and not merged yet
};

// ---------------------------------------------------------------------------------------------
// The interval's ends

enum class side { inside, outside, undecided };

/// On which side of the lower (or upper) end of the interval the root of the region lies.
side side_of(const root_region& given, const end_point& end, bool is_lower, const real_function& f,
             root_region& sharper) {
  if (end.infinite_sign() != 0) return side::inside;
  const bool is_proved =
      given.verdict == root_verdict::unique || given.verdict == root_verdict::multiple;
  for (const long digits : {0L, 40L, 300L}) {
    if (digits > 0 && !is_proved) break;
    if (digits > 0) {
      const ball finer = intersection(refine(sharper, digits).enclosure, sharper.enclosure);
      if (!finer.is_undefined()) sharper.enclosure = finer;
    }
    const precision p = sharper.enclosure.precision() + 64;
    if (end.exact() && sharper.exact) {
      const bool in = is_lower ? *sharper.exact >= *end.exact() : *sharper.exact <= *end.exact();
      return in ? side::inside : side::outside;
    }
    const ball e = end.at(p);
    const ball& x = sharper.enclosure;
    if (is_lower ? certainly_less(x, e) : certainly_less(e, x)) return side::outside;
    if (is_lower ? certainly_less_equal(e, x) : certainly_less_equal(x, e)) return side::inside;
    // The end itself, exactly a root?
    const bool is_in_region = end.exact() ? contains(x, *end.exact()) : contains(x, e);
    if (end.form() && is_proved && is_in_region) {
      const auto s = f.structure(function_structure::variable_at(*end.form(), 0, p));
      if (s && s->series() && (*s->series())[0].is_exactly(0)) {
        sharper.exact = end.exact();
        return side::inside;
      }
    }
  }
  return side::undecided;
}

/// The rational numbers around an end, so that the interval is not cut short.
std::optional<rational> outer_end(const end_point& end, bool is_lower) {
  if (end.infinite_sign() != 0) return std::nullopt;
  if (end.exact()) return end.exact();
  const ball x = end.at(128);
  if (!x.is_bounded()) {
    throw input_error(
        "an end of the interval is not defined: it must be a real number, or an infinity");
  }
  return is_lower ? lower_rational(x) : upper_rational(x);
}

/// Ends that are not exact, and are nearer to each other than the numbers of outer_end show.
void expect_in_order(const end_point& lower, const end_point& upper) {
  if (lower.infinite_sign() != 0 || upper.infinite_sign() != 0) return;
  if (lower.exact() && upper.exact()) return;
  constexpr precision most = 1024;
  for (precision p = 128; p <= most; p *= 2) {
    const ball low = lower.at(p);
    const ball high = upper.at(p);
    if (certainly_less(high, low)) {
      throw input_error(
          "the interval is the wrong way round: its lower end is greater than its upper end");
    }
    if (certainly_less_equal(low, high)) return;
  }
}

void require_threads(const std::string& function, int threads) {
  if (threads >= 0) return;
  throw std::invalid_argument(function + ": threads must be at least 0 (0: all processors)");
}

void in_order(std::vector<root_region>& regions) {
  std::sort(regions.begin(), regions.end(), [](const root_region& x, const root_region& y) {
    return mpfr_less_p(lower(x.enclosure).backend().data(), lower(y.enclosure).backend().data()) !=
           0;
  });
}

/// Roots of different factors, neither in the other's enclosure, may have enclosures that overlap: they are made narrower.
void keep_apart(std::vector<root_region>& regions) {
  constexpr long most_digits = 1L << 14;
  for (std::size_t i = 1; i < regions.size(); ++i) {
    root_region& x = regions[i - 1];
    root_region& y = regions[i];
    if (x.multiplicity == 0 || y.multiplicity == 0) continue;
    for (long digits = 15; overlaps(x.enclosure, y.enclosure) && digits < most_digits;
         digits *= 2) {
      x.enclosure = refine(x, digits).enclosure;
      y.enclosure = refine(y, digits).enclosure;
    }
  }
  in_order(regions);
}

/// Proves that the interval that was asked for, from end to end, is in the one that is searched, and that every point of
/// it is settled or open: for every problem.
void expect_whole(const root_search::state& s) {
  constexpr precision p = 192;  // other than that which the ends were made with
  for (std::size_t i = 0; i < s.problems.size(); ++i) {
    const exact_box& whole = s.settled[i].whole();
    const auto is_outside = [&](const std::optional<rational>& end, const end_point& asked,
                                bool is_lower) {
      if (asked.infinite_sign() != 0) return !end;
      if (asked.exact()) return end == asked.exact();
      if (!end) return false;
      const ball e = asked.at(p);
      const ball b(*end, p);
      return is_lower ? !certainly_less(e, b) : !certainly_less(b, e);
    };
    expect(is_outside(whole.lower, s.lower, true) && is_outside(whole.upper, s.upper, false),
           "the interval is not the one that was asked for");
    std::vector<const exact_box*> open;
    for (const auto* boxes : {&s.pending, &s.stuck}) {
      for (const work_box& b : *boxes) {
        if (b.problem == i) open.push_back(&b.x);
      }
    }
    s.settled[i].expect_whole(open, s.found.size());
  }
}

/// The boxes of the regions of a polynomial's factors hold roots of other factors: they are made narrower.
void keep_out_other_roots(root_region& r, std::size_t problem,
                          const std::vector<root_problem>& problems) {
  if (problems.size() < 2 || r.multiplicity == 0) return;
  constexpr long most_digits = 1L << 20;
  for (long digits = 15; digits <= most_digits; digits *= 2) {
    bool apart = true;
    for (std::size_t i = 0; i < problems.size(); ++i) {
      if (i == problem) continue;
      const ball value = problems[i].g->at(r.enclosure.precision())->value(r.enclosure);
      apart = apart && is_certainly_not_zero(value);
    }
    if (apart) {
      r.box = r.enclosure;
      return;
    }
    r.enclosure = refine(r, digits).enclosure;
  }
  r.box = r.enclosure;
  r.verdict = root_verdict::at_least_one;
  r.multiplicity = 0;
  r.remark = "not told from a root of another multiplicity";
}

}  // namespace

root_search::root_search(const real_function& f, const end_point& lower, const end_point& upper) {
  auto s = std::make_shared<state>();
  s->f = std::make_shared<real_function>(f);
  s->lower = lower;
  s->upper = upper;
  if (lower.infinite_sign() > 0 || upper.infinite_sign() < 0) {
    throw input_error(
        "the interval is the wrong way round: an infinite lower end must be -inf, an infinite "
        "upper end inf");
  }
  exact_box range{outer_end(lower, true), outer_end(upper, false)};
  if (range.is_bounded() && *range.lower > *range.upper) {
    throw input_error(
        "the interval is the wrong way round: its lower end is greater than its upper end");
  }
  expect_in_order(lower, upper);
  // A polynomial is made free of multiple roots.
  const ball any(0, first_bits);
  const auto shape = f.structure(function_structure::variable(ball::undefined(first_bits), any));
  const std::optional<rational_polynomial> p = shape ? shape->polynomial() : std::nullopt;
  s->account.evaluations = 1;
  if (!p) {
    s->problems.push_back({s->f, 1, false});
    s->settled.emplace_back(range);
    s->pending.push_back({range, 0, first_bits, 0, {}});
  } else if (p->is_zero()) {
    s->identically_zero = true;
  } else {
    for (const repeated_factor& factor : square_free_decomposition(*p)) {
      if (factor.factor.degree() == 1) {
        root_region r;
        r.exact = -factor.factor.coefficients()[0] / factor.factor.leading();
        r.verdict = factor.multiplicity == 1 ? root_verdict::unique : root_verdict::multiple;
        r.box = r.enclosure = ball(*r.exact, first_bits);
        r.multiplicity = factor.multiplicity;
        r.function = s->f;
        r.simple = std::make_shared<real_function>(real_function::of(factor.factor));
        s->settled.emplace_back(range);
        s->settled.back().add_known(range, s->found.size());
        s->found.push_back({r, s->problems.size(), double_interval::from_ball(r.box)});
        s->problems.push_back({r.simple, factor.multiplicity, true});
        continue;
      }
      const rational bound = root_bound(factor.factor);
      exact_box part = range;
      if (!part.lower) part.lower = part.upper ? std::min(rational(-bound), *part.upper) : -bound;
      if (!part.upper) part.upper = std::max(bound, *part.lower);
      // Beyond the bound there is no root.
      s->settled.emplace_back(range);
      if (!range.lower) s->settled.back().add_without_root({std::nullopt, part.lower});
      if (!range.upper) s->settled.back().add_without_root({part.upper, std::nullopt});
      s->pending.push_back({part, 0, first_bits, s->problems.size(), {}});
      s->problems.push_back({std::make_shared<real_function>(real_function::of(factor.factor)),
                             factor.multiplicity, true});
    }
  }
  state_ = std::move(s);
}

void root_search::run(const isolate_options& options) {
  require_threads("isolate_roots", options.threads);
  auto next = std::make_shared<state>(*state_);
  searcher(*next, options).run();
  state_ = std::move(next);
}

bool root_search::is_finished() const { return state_->pending.empty() && state_->concluded; }

bool root_set::is_resolved() const {
  return complete && std::all_of(regions.begin(), regions.end(), [](const root_region& r) {
           return (r.verdict == root_verdict::unique || r.verdict == root_verdict::multiple) &&
                  !r.may_lie_outside;
         });
}

root_set root_search::result() const {
  const state& s = *state_;
  expect_whole(s);
  root_set result;
  result.identically_zero = s.identically_zero;
  result.complete = s.pending.empty();
  result.account = s.account;
  result.singular = s.singular;
  for (const found_root& known : s.found) {
    root_region r = known.region;
    const real_function& g = *s.problems[known.problem].g;
    const side at_lower = side_of(r, s.lower, true, g, r);
    const side at_upper = side_of(r, s.upper, false, g, r);
    if (at_lower == side::outside || at_upper == side::outside) continue;
    r.may_lie_outside = (at_lower == side::undecided || at_upper == side::undecided) &&
                        r.verdict != root_verdict::unresolved;
    keep_out_other_roots(r, known.problem, s.problems);
    r.function = s.f;
    result.regions.push_back(std::move(r));
  }
  std::vector<work_box> open = s.pending;
  open.insert(open.end(), s.stuck.begin(), s.stuck.end());
  const std::vector<work_box> clusters = joined(open, s.found);
  (void)parts_of(clusters, open);
  for (const work_box& b : clusters) {
    root_region r;
    r.box = r.enclosure = b.x.to_ball(b.bits);
    r.remark = s.limit.empty() ? "not examined yet" : s.limit + " was reached";
    r.function = s.f;
    r.simple = s.problems[b.problem].g;
    result.regions.push_back(std::move(r));
  }
  in_order(result.regions);
  keep_apart(result.regions);
  std::sort(result.singular.begin(), result.singular.end(),
            [](const singular_place& x, const singular_place& y) {
              return mpfr_less_p(lower(x.place).backend().data(),
                                 lower(y.place).backend().data()) != 0;
            });
  // Neighbouring places where f is not defined are one.
  std::vector<singular_place> places;
  for (singular_place& place : result.singular) {
    const bool joins = !places.empty() && places.back().pole_order == 0 && place.pole_order == 0 &&
                       overlaps(places.back().place, place.place);
    const bool again = !places.empty() && places.back().pole_order > 0 &&
                       overlaps(places.back().place, place.place);
    if (joins) {
      places.back().place = hull(places.back().place, place.place);
    } else if (!again) {
      places.push_back(std::move(place));
    }
  }
  result.singular = std::move(places);
  return result;
}

root_set isolate_roots(const real_function& f, const end_point& lower, const end_point& upper,
                       const isolate_options& options) {
  root_search s(f, lower, upper);
  s.run(options);
  return s.result();
}

namespace {

/// The half of the enclosure that holds the root of f, which is simple and the only one in it: on either side of
/// it f has one sign. std::nullopt where the signs are not certain.
std::optional<ball> half_with_root(const real_function& f, const ball& enclosure, precision p) {
  const exact_box whole = exact_ends(enclosure);
  const auto sign_at = [&](const rational& x) { return sign_of(f.at(p)->value(ball(x, p))); };
  const auto is_certain = [](sign s) { return s == sign::negative || s == sign::positive; };
  const ball middle = enclosure.middle();
  const sign at_middle =
      sign_of(f.at(p)->value(middle.with_precision(std::max(p, middle.precision()))));
  const sign at_upper = sign_at(*whole.upper);
  if (!is_certain(at_middle) || !is_certain(at_upper)) return std::nullopt;
  const rational cut = lower_rational(middle);
  const exact_box half =
      at_middle == at_upper ? exact_box{whole.lower, cut} : exact_box{cut, whole.upper};
  return half.to_ball(std::max(p, enclosure.precision()));
}

}  // namespace

refined_root refine(const root_region& region, long digits) {
  if (digits < 1) throw std::invalid_argument("refine: at least one digit must be asked for");
  refined_root result;
  result.enclosure = region.enclosure;
  const precision p = bits_for_digits(digits) + 8;
  if (region.exact) {
    result.enclosure = ball(*region.exact, p);
    result.exact = region.exact;
    result.verdict = status::certified;
    return result;
  }
  if (region.multiplicity == 0 || !region.simple || !region.function) return result;
  const real_function& f = *region.simple;
  const auto is_narrow = [&](const ball& x) {
    const magnitude size = (contains_zero(x) ? region.box : x).magnitude_upper();
    return x.radius() <= scale(size, -(static_cast<std::int64_t>(p) - 5));
  };
  // Bits beside those of x that f is evaluated with, because it cancels.
  precision more = 0;
  const precision most = 8 * p + (1L << 14);
  constexpr int most_halvings = 60;
  int halvings = 0;
  while (true) {
    const auto raised = [&](const ball& x) { return x.with_precision(x.precision() + more); };
    const auto value = [&](const ball& x) { return f.at(x.precision() + more)->value(raised(x)); };
    const auto slope = [&](const ball& x) {
      return slope_over(*f.at(x.precision() + more), raised(x), f);
    };
    // A little room, so that a root at the end of its enclosure is inside.
    const ball known = result.enclosure;
    const magnitude before = known.radius();
    const ball room = intersection(known.enlarged(known.radius()), region.box);
    const root_enclosure r = refine_root(value, slope, room.is_undefined() ? known : room, p);
    if (r.verdict == root_verdict::none) {
      throw std::logic_error("refine: the enclosures of f and its derivative contradict");
    }
    result.evaluations_of_f += r.evaluations_of_f;
    result.evaluations_of_derivative += r.evaluations_of_derivative;
    const ball both = intersection(r.root, known);
    result.enclosure = (both.is_undefined() ? r.root : both).with_precision(p + 16);
    if (is_narrow(result.enclosure)) break;
    // Newton's method may not contract yet on a wide enclosure.
    if (result.enclosure.radius() > scale(before, -1) && halvings < most_halvings) {
      ++halvings;
      if (const auto half = half_with_root(f, result.enclosure, p + more)) {
        result.enclosure = *half;
        continue;
      }
    }
    if (more >= most) break;
    more = std::min(std::max<precision>(2 * more, 64), most);
  }
  const ball& x = result.enclosure;
  if (is_narrow(x)) result.verdict = status::certified;
  // A short rational number in the enclosure, and exactly a root. It shows in few bits.
  if (result.verdict == status::certified) {
    constexpr precision few = 128;
    constexpr int few_terms = 16;
    constexpr std::size_t most_height = 48;
    const ball coarse = x.with_precision(std::min(few, x.precision()));
    const auto short_one =
        simplest_between(lower_rational(coarse), upper_rational(coarse), few_terms);
    // Rounded to p bits the enclosure may hold a root beside the box; in the box there is one only.
    if (short_one && height(*short_one) <= most_height && contains(x, *short_one) &&
        contains(region.box, *short_one)) {
      const rational& q = *short_one;
      const auto s = region.function->structure(function_structure::variable_at(q, 0, p));
      if (s && s->series() && (*s->series())[0].is_exactly(0)) {
        result.exact = q;
        result.enclosure = ball(q, p);
      }
    }
  }
  return result;
}

std::vector<refined_root> refine(const std::vector<root_region>& regions, long digits,
                                 int threads) {
  require_threads("refine", threads);
  std::vector<refined_root> result(regions.size());
  const auto step = [&](long i) {
    const auto k = static_cast<std::size_t>(i);
    result[k] = refine(regions[k], digits);
  };
  const auto count = static_cast<long>(regions.size());
  if (threads == 1 || count < 2) {
    for (long i = 0; i < count; ++i) step(i);
  } else {
    detail::worker_threads(threads).for_each(count, step);
  }
  return result;
}

std::optional<rational> refute_derivative(const real_function& f,
                                          const std::function<ball(const ball&)>& derivative,
                                          const rational& lower, const rational& upper,
                                          int points) {
  constexpr precision p = 128;
  const auto at_p = f.at(p);
  const function_evaluator& e = *at_p;
  for (int k = 0; k <= points; ++k) {
    const rational x = lower + (upper - lower) * rational(k, points);
    const ball known = e.derivative(ball(x, p));
    const ball given = derivative(ball(x, p));
    if (!known.is_undefined() && !given.is_undefined() && !overlaps(known, given)) return x;
  }
  return std::nullopt;
}

}  // namespace polhode
