#include "breaks.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "polhode/arithmetic/interval.hpp"
#include "quadrature/formula/recorded_formula.hpp"

namespace polhode::detail {

namespace {

using kind = recorded_node::kind;

bool not_negative(const ball& x) { return certainly_less_equal(ball(0, 64), x); }
bool not_positive(const ball& x) { return certainly_less_equal(x, ball(0, 64)); }

/// The greatest integer that is at most x's lower end; nothing where that is not a moderate number.
std::optional<long> integer_below(const ball& x) {
  constexpr long most = 1L << 40;
  if (!x.is_bounded() || magnitude::power_of_two(40) <= x.magnitude_upper()) return std::nullopt;
  const rational q = lower_rational(x);
  integer n;
  mpz_fdiv_q(n.backend().data(), numerator(q).backend().data(), denominator(q).backend().data());
  if (abs(n) >= most) return std::nullopt;
  return static_cast<long>(n);
}

// ---------------------------------------------------------------------------------------------
// Which branch holds.

/// The branch for the whole range of the decider; `strictly`: it is strictly monotone, so that of the range's ends each is
/// reached at one point at most, which does not matter to an integral.
std::optional<long> branch_over(kind what, const ball& range, bool strictly) {
  if (range.is_undefined()) return std::nullopt;
  if (what == kind::ceil) {
    const std::optional<long> below = branch_over(kind::floor, -range, strictly);
    return below ? std::optional(-*below) : std::nullopt;
  }
  if (what == kind::floor) {
    const std::optional<long> n = integer_below(range);
    if (!n) return std::nullopt;
    const ball next(*n + 1, 64);
    const bool same = strictly ? certainly_less_equal(range, next) : certainly_less(range, next);
    return same ? n : std::nullopt;
  }
  if (not_negative(range)) return 1;
  return not_positive(range) ? std::optional(-1L) : std::nullopt;
}

/// The branch for a decider between n and the next integer in the direction of the sign; for other kinds than floor and
/// ceil n is 0.
long branch_beside(kind what, long n, int side) {
  if (what == kind::floor) return side > 0 ? n : n - 1;
  if (what == kind::ceil) return side > 0 ? n + 1 : n;
  return side;
}

/// A decider goes through n strictly monotonely.
struct crossing {
  std::size_t decider = 0;
  long n = 0;
  bool ascending = true;
};

/// The integer at which alone the branch may change where the decider has values in this range; nothing where there may
/// be more.
std::optional<long> only_change(kind what, const ball& range) {
  if (what != kind::floor && what != kind::ceil) return 0;
  const std::optional<long> below = integer_below(range);
  if (!below) return std::nullopt;
  // Or *below itself, where the range starts at it.
  const bool at_start = !certainly_greater(range, *below);
  const long n = at_start && certainly_less(range, *below + 1) ? *below : *below + 1;
  if (n == *below + 1 && !certainly_less_equal(range, ball(n + 1, 64))) return std::nullopt;
  return n;
}

/// An interval of x, with what was found out about f on it.
struct interval {
  rational low;
  rational high;
  long level = 0;
  [[nodiscard]] rational width() const { return high - low; }
  /// About that.
  [[nodiscard]] std::int64_t log2_width() const {
    return ball(width(), 64).magnitude_upper().log2_floor();
  }
  [[nodiscard]] rational middle() const { return (low + high) / 2; }
  [[nodiscard]] ball set(precision p) const { return hull(ball(low, p), ball(high, p)); }
  /// What it takes to tell its points apart.
  [[nodiscard]] precision bits() const { return 96 + 2 * level; }
};

struct traced {
  choices chosen;
  bool decided = true;  // all of them
  // Of the first that is not, where its decider is strictly monotone and has one n at most to go through:
  std::optional<crossing> suspect;
  ball slope;
  bool crosses = false;  // it does
};

/// The branches over a set with these ends; `side` of a given crossing (-1: before it), or 0.
traced trace(const formula& f, const ball& x, const ball& low, const ball& high,
             const crossing* given, int side) {
  const recorded_nodes& nodes = f.at(x.precision());
  evaluation<slope_jet> over(nodes, slope_jet::variable(x));
  evaluation<slope_jet> at_low(nodes, slope_jet::variable(low));
  evaluation<slope_jet> at_high(nodes, slope_jet::variable(high));
  traced result;
  result.chosen.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!f.needs(i)) continue;
    std::optional<long>& branch = result.chosen[i];
    if (nodes[i].is_piecewise()) {
      const std::size_t d = nodes[i].decider;
      const auto& [range, slope] = std::pair(over[d][0], over[d][1]);
      const bool ascending = certainly_positive(slope);
      const bool monotone = !range.is_undefined() && (ascending || certainly_negative(slope));
      const ball& start = (ascending ? at_low : at_high)[d][0];
      const ball& end = (ascending ? at_high : at_low)[d][0];
      const ball between = monotone ? intersection(range, hull(start, end)) : range;
      const ball& values = between.is_undefined() ? range : between;
      branch = branch_over(nodes[i].what, values, monotone);
      std::optional<crossing> suspect;
      if (monotone && !branch) {
        if (const auto n = only_change(nodes[i].what, values)) suspect = crossing{d, *n, ascending};
      }
      const bool crosses =
          suspect && certainly_less(start, suspect->n) && certainly_greater(end, suspect->n);
      if (crosses && given != nullptr && given->decider == d && given->n == suspect->n) {
        branch = branch_beside(nodes[i].what, given->n, ascending ? side : -side);
      }
      if (!branch && result.decided) {
        result.decided = false;
        result.suspect = suspect;
        result.slope = slope;
        result.crosses = crosses;
      }
    }
    over.step(i, branch);
    at_low.step(i, branch);
    at_high.step(i, branch);
  }
  return result;
}

// ---------------------------------------------------------------------------------------------
// A break as a number.

/// The zero of decider - n in an interval in which there is exactly one, a simple one.
class break_point {
 public:
  break_point(std::shared_ptr<const formula> f, crossing c, choices chosen, const interval& x)
      : f_(std::move(f)),
        crossing_(c),
        chosen_(std::move(chosen)),
        x_(x),
        size_(x.set(64).magnitude_upper()),
        enclosure_(x.set(x.bits())) {}

  /// An enclosure to about p bits of its size; where the formula's constants do not allow that, a wider one.
  [[nodiscard]] ball at(precision p) {
    const std::lock_guard lock(mutex_);
    refine(p);
    return enclosure_.with_precision(p);
  }

  /// The same as a rational number with a small denominator, where f is proved to break there.
  [[nodiscard]] std::optional<rational> as_rational() {
    constexpr long greatest_denominator = 10'000;
    const ball r = at(128);
    if (!r.is_bounded()) return std::nullopt;
    const rational q = simplest_rational(lower_rational(r), upper_rational(r));
    if (denominator(q) > greatest_denominator || q < x_.low || q > x_.high) return std::nullopt;
    for (const double reach : {0x1p-8, 0x1p-32}) {
      const end_series x =
          end_series::argument(known_number(q), known_number(rational(1)), 1, reach);
      const end_series t =
          evaluate(*f_, 192, x, chosen_, crossing_.decider)[crossing_.decider] - crossing_.n;
      // 0 at q, exactly: and there is one zero only in the interval.
      if (!t.is_blocked() && t.simplified().exponent() > 0) return q;
    }
    return std::nullopt;
  }

 private:
  /// Newton's steps N(X) = m - t(m)/t'(X), which hold every zero in X (R. E. Moore, 1966: 0 = t(r) = t(m) + t'(s) (r - m)
  /// with s in X), and halvings by the sign at the middle where these do not contract.
  void refine(precision p) {
    int stalls = 0;
    long extra = 64;
    while (stalls < 4) {
      const magnitude radius = enclosure_.radius();
      const magnitude size = contains_zero(enclosure_) ? size_ : enclosure_.magnitude_upper();
      if (radius <= scale(size, -p - 1)) return;
      const auto bits = std::max<std::int64_t>(size.log2_floor() - radius.log2_floor(), 1);
      const precision working = std::min<precision>(2 * bits, p) + extra;
      const ball current = enclosure_.with_precision(working);
      const ball middle = current.middle();
      const ball value = decider_at(middle)[0] - crossing_.n;
      ball next = intersection(middle - value / decider_at(current)[1], current);
      if (next.is_undefined() || next.radius() > scale(radius, -1)) {
        const sign s = sign_of(value);
        if (s == sign::positive || s == sign::negative) {
          const bool beyond = (s == sign::positive) == crossing_.ascending;
          const ball half =
              beyond ? hull(lower_end(current), middle) : hull(middle, upper_end(current));
          const ball both = next.is_undefined() ? half : intersection(next, half);
          if (!both.is_undefined()) next = both;
        }
      }
      if (!next.is_undefined() && next.radius() < radius) enclosure_ = next;
      const bool contracted = enclosure_.radius() <= scale(radius, -1);
      stalls = contracted ? 0 : stalls + 1;
      extra = contracted ? 64 : 2 * extra;
    }
  }
  [[nodiscard]] slope_jet decider_at(const ball& x) const {
    return evaluate(*f_, x.precision(), slope_jet::variable(x), chosen_,
                    crossing_.decider)[crossing_.decider];
  }
  static ball lower_end(const ball& x) { return {lower_rational(x), x.precision()}; }
  static ball upper_end(const ball& x) { return {upper_rational(x), x.precision()}; }

  std::shared_ptr<const formula> f_;
  crossing crossing_;
  choices chosen_;
  interval x_;
  magnitude size_;
  ball enclosure_;
  std::mutex mutex_;
};

// ---------------------------------------------------------------------------------------------
// The range, covered.

/// A part of the range: with one set of branches; or with a break in it, and the branches before and beyond it; or
/// so short that it is left out; or unresolved.
struct stretch {
  enum class form : std::uint8_t { plain, broken, short_one, unresolved };
  interval x;
  form what = form::plain;
  choices before;
  choices beyond;
  std::optional<crossing> crosses;
};

class covering {
 public:
  covering(const formula& f, const integrand& g, const interval& whole, long bits)
      : f_(f),
        g_(g),
        least_log2_width_(whole.log2_width() - bits),
        most_effort_(1e6 + static_cast<double>(bits) * static_cast<double>(bits) / 2) {
    cover(whole);
  }

  /// In order; none where that took too much effort.
  [[nodiscard]] std::vector<stretch>& stretches() { return stretches_; }
  [[nodiscard]] bool has_branches() const {
    return std::any_of(stretches_.begin(), stretches_.end(), [](const stretch& s) {
      return s.what == stretch::form::plain || s.what == stretch::form::broken;
    });
  }

 private:
  void cover(const interval& whole) {
    std::vector<interval> open{whole};
    while (!open.empty()) {
      const interval x = open.back();
      open.pop_back();
      stretch s;
      s.x = x;
      if (effort_ > most_effort_ || breaks_ > most_breaks) {
        stretches_.clear();
        return;
      }
      const precision p = x.bits();
      const traced t = traced_over(x, nullptr, 0);
      if (t.decided) {
        s.before = t.chosen;
        stretches_.push_back(std::move(s));
        continue;
      }
      if (t.crosses) {
        traced before = traced_over(x, &*t.suspect, -1);
        traced beyond = traced_over(x, &*t.suspect, 1);
        if (before.decided && beyond.decided) {
          s.what = stretch::form::broken;
          s.before = std::move(before.chosen);
          s.beyond = std::move(beyond.chosen);
          s.crosses = t.suspect;
          stretches_.push_back(std::move(s));
          ++breaks_;
          continue;
        }
      }
      const bool is_short = x.log2_width() < least_log2_width_;
      const bool hopeless = x.level >= 40 && !g_.evaluator(p)(x.set(p)).is_bounded();
      if (is_short || hopeless) {
        s.what = is_short && !hopeless ? stretch::form::short_one : stretch::form::unresolved;
        stretches_.push_back(std::move(s));
        // Near such a point breaks may crowd.
        if (hopeless) most_effort_ = std::min(most_effort_, effort_ + 5e4);
        continue;
      }
      split(x, p, t, open);
    }
  }

  /// Into halves; or, where the decider can only be n within a short interval, into that and what is beside it.
  void split(const interval& x, precision p, const traced& t, std::vector<interval>& open) const {
    std::vector<rational> cuts{x.middle()};
    if (t.suspect) {
      // As in break_point::refine.
      const std::size_t d = t.suspect->decider;
      const ball middle(x.middle(), p);
      const ball value =
          evaluate(f_, p, slope_jet::variable(middle), t.chosen, d)[d][0] - t.suspect->n;
      const ball zero = intersection(middle - value / t.slope, x.set(p));
      if (zero.is_bounded()) {
        // A little wider, so that the signs at the ends can be told.
        const magnitude margin = scale(ball(x.width(), 64).magnitude_upper(), -p / 4);
        const ball grown = zero.enlarged(margin);
        const rational low = lower_rational(grown);
        const rational high = upper_rational(grown);
        if (high - low < x.width() / 8) {
          cuts.clear();
          if (low > x.low) cuts.push_back(low);
          if (high < x.high) cuts.push_back(high);
        }
      }
    }
    cuts.push_back(x.high);
    std::vector<interval> parts;
    rational start = x.low;
    for (const rational& end : cuts) {
      interval part{start, end, 0};
      part.level = x.level + std::max(1L, static_cast<long>(x.log2_width() - part.log2_width()));
      parts.push_back(part);
      start = end;
    }
    open.insert(open.end(), parts.rbegin(), parts.rend());
  }

  traced traced_over(const interval& x, const crossing* given, int side) {
    const precision p = x.bits();
    effort_ += static_cast<double>(f_.size()) * (1 + static_cast<double>(p) / 256);
    return trace(f_, x.set(p), ball(x.low, p), ball(x.high, p), given, side);
  }

  static constexpr long most_breaks = 4000;
  const formula& f_;
  const integrand& g_;
  std::int64_t least_log2_width_;
  double effort_ = 0;  // in evaluations of a node with few bits
  double most_effort_;
  long breaks_ = 0;
  std::vector<stretch> stretches_;
};

// ---------------------------------------------------------------------------------------------
// The pieces.

/// A bound of |g| and of f with these branches over x; infinite where one is not bounded.
magnitude bound_over(const formula& f, const integrand& g, const ball& x,
                     std::initializer_list<const choices*> branches) {
  const precision p = x.precision();
  magnitude bound = g.evaluator(p)(x).magnitude_upper();
  for (const choices* c : branches) {
    if (c->empty()) continue;
    const slope_jet value = evaluate(f, p, slope_jet::variable(x), *c, f.result())[f.result()];
    bound = max(bound, value[0].magnitude_upper());
  }
  return bound;
}

/// The point between two pieces.
struct cut {
  end_point at;
  std::optional<crossing> crosses;
};

/// g, with f's branches in place of what it is made of; and what is known at an end of the piece.
integrand with_branches(const std::shared_ptr<const formula>& f, const integrand& g,
                        const std::shared_ptr<const choices>& chosen,
                        const std::optional<crossing>& at_end) {
  integrand result = g;
  result.record = nullptr;
  if (chosen->empty()) return result;
  // f's symmetries are not those of one of its pieces, continued: |sin| is even about 0.
  result.under = nullptr;
  result.angle_evaluator = nullptr;
  result.over = [f, chosen](const region& x) {
    return evaluate(*f, x.precision(), x, *chosen, f->result())[f->result()];
  };
  // A step function may have another value at points where its operand touches an integer.
  bool steps = false;
  for (std::size_t i = 0; i < f->size(); ++i) {
    const kind what = f->node(i).what;
    steps = steps || (f->needs(i) && (what == kind::floor || what == kind::ceil));
  }
  if (steps) {
    result.evaluator = [f, chosen](precision p) -> std::function<ball(const ball&)> {
      evaluation<ball> constants(f->at(p), ball(0, p));
      for (std::size_t i = 0; i < f->size(); ++i) {
        if (f->node(i).what == kind::constant) constants.step(i, std::nullopt);
      }
      return [f, chosen, constants](const ball& x) {
        evaluation<ball> values = constants;
        values.set_argument(x);
        for (std::size_t i = 0; i <= f->result(); ++i) {
          if (f->needs(i) && f->node(i).what != kind::constant) values.step(i, (*chosen)[i]);
        }
        return values[f->result()];
      };
    };
  }
  result.near_end = [f, chosen, at_end](const end_series& x) {
    evaluation<end_series> values(f->at(192), x);
    for (std::size_t i = 0; i <= f->result(); ++i) {
      if (!f->needs(i)) continue;
      values.step(i, (*chosen)[i]);
      if (at_end && at_end->decider == i) values[i] = values[i].with_value_at_0(at_end->n);
    }
    return values[f->result()];
  };
  return result;
}

}  // namespace

unsigned long exponent_beyond_breaks(const integrand& g, unsigned long e, int sign) {
  if (!g.record) return e;
  const formula f(g.record);
  if (!f.has_breaks()) return e;
  constexpr unsigned long most = 16;
  constexpr precision p = 96;
  mpfr_float unbounded = zero_of_precision(p);
  mpfr_set_inf(unbounded.backend().data(), 1);
  for (unsigned long n = e; n <= e + most; ++n) {
    const ball start = scale(ball(1, p), static_cast<long>(n));
    const ball x = from_end_points(midpoint(start), unbounded, p);
    const ball undefined = ball::undefined(p);
    const bool decided = (sign > 0 ? trace(f, x, start, undefined, nullptr, 0)
                                   : trace(f, -x, undefined, -start, nullptr, 0))
                             .decided;
    if (decided) return n;
  }
  return e;
}

rational simplest_rational(const rational& low, const rational& high) {
  if (low <= 0 && high >= 0) return 0;
  if (high < 0) return -simplest_rational(-high, -low);
  const integer whole = numerator(low) / denominator(low);
  if (rational(whole) == low) return low;
  if (rational(whole + 1) <= high) return whole + 1;
  return whole + 1 / simplest_rational(1 / (high - whole), 1 / (low - whole));
}

pieces_of_range analytic_pieces(const integrand& g, const end_point& a, const end_point& b,
                                long bits) {
  pieces_of_range result;
  const auto as_it_is = [&] {
    result.pieces.push_back({a, b, g, g, g});
    return result;
  };
  if (!g.record) return as_it_is();
  const auto f = std::make_shared<const formula>(g.record);
  if (!f->has_breaks()) return as_it_is();
  const precision fine = bits + bits / 16 + 64;
  const ball start = a.at(fine);
  const ball end = b.at(fine);
  if (!certainly_less(start, end)) return as_it_is();
  interval whole{lower_rational(start), upper_rational(end)};
  if (a.exact()) whole.low = *a.exact();
  if (b.exact()) whole.high = *b.exact();
  if (g.over(region(ball(whole.middle(), 64))).why() == obstacle::unknown) return as_it_is();

  covering cover(*f, g, whole, fine);
  if (!cover.has_branches()) return as_it_is();

  // Pieces are what lies between cuts, and have one set of branches each.
  std::vector<cut> cuts;
  std::vector<choices> branches;
  const auto continued = [&](const stretch& s) {
    if (!branches.empty() && branches.back() == s.before) return;
    if (!branches.empty()) cuts.push_back({end_point(s.x.low), std::nullopt});
    branches.push_back(s.before);
  };
  // False where f or what stands for it is not bounded there.
  const auto leave_out = [&](const ball& x, const choices& before, const choices& beyond) {
    const magnitude bound = bound_over(*f, g, x, {&before, &beyond});
    if (bound.is_infinite()) return false;
    const ball width(rational(upper_rational(x) - lower_rational(x)), 64);
    result.remainder =
        result.remainder.enlarged(multiply_up(width.magnitude_upper(), scale(bound, 1)));
    result.has_remainder = true;
    return true;
  };
  const std::vector<stretch>& stretches = cover.stretches();
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const stretch& s = stretches[i];
    if (s.what == stretch::form::short_one) {
      interval gap = s.x;
      while (i + 1 < stretches.size() && stretches[i + 1].what == stretch::form::short_one) {
        gap.high = stretches[++i].x.high;
      }
      const bool is_last = i + 1 == stretches.size();
      const choices none;
      const choices& before = branches.empty() ? none : branches.back();
      const choices beyond = is_last ? none : stretches[i + 1].before;
      if (!leave_out(gap.set(fine), before, beyond)) return as_it_is();
      if (is_last || branches.empty() || before == beyond) continue;
      cuts.push_back({end_point(gap.middle()), std::nullopt});
      branches.push_back(beyond);
      continue;
    }
    continued(s);  // of an unresolved one, without branches
    if (s.what == stretch::form::broken) {
      const auto point = std::make_shared<break_point>(f, *s.crosses, s.before, s.x);
      const std::optional<rational> q = point->as_rational();
      cuts.push_back({q ? end_point(*q) : end_point([point](precision p) { return point->at(p); }),
                      s.crosses});
      branches.push_back(s.beyond);
    }
  }
  if (branches.empty()) return as_it_is();

  // A cut that may be at or beyond an end of the range.
  while (!cuts.empty() && !certainly_less(cuts.back().at.at(fine), end)) {
    const ball last = cuts.back().at.at(fine);
    const std::size_t n = branches.size();
    if (!certainly_less(end, last) &&
        !leave_out(hull(last, end), branches[n - 2], branches[n - 1])) {
      return as_it_is();
    }
    cuts.pop_back();
    branches.pop_back();
  }
  while (!cuts.empty() && !certainly_less(start, cuts.front().at.at(fine))) {
    const ball first = cuts.front().at.at(fine);
    if (!certainly_less(first, start) && !leave_out(hull(start, first), branches[0], branches[1])) {
      return as_it_is();
    }
    cuts.erase(cuts.begin());
    branches.erase(branches.begin());
  }

  for (std::size_t i = 0; i < branches.size(); ++i) {
    const auto chosen = std::make_shared<const choices>(std::move(branches[i]));
    const bool has_left = i > 0;
    const bool has_right = i < cuts.size();
    const std::optional<crossing> left = has_left ? cuts[i - 1].crosses : std::nullopt;
    const std::optional<crossing> right = has_right ? cuts[i].crosses : std::nullopt;
    result.pieces.push_back({has_left ? cuts[i - 1].at : a, has_right ? cuts[i].at : b,
                             with_branches(f, g, chosen, std::nullopt),
                             with_branches(f, g, chosen, left),
                             with_branches(f, g, chosen, right)});
  }
  return result;
}

}  // namespace polhode::detail
