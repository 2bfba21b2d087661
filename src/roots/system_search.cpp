#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "boxes.hpp"
#include "by_substitution.hpp"
#include "hardware_system.hpp"
#include "place_of.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/symbol.hpp"
#include "polhode/roots/systems.hpp"
#include "polynomial/common_zeros.hpp"
#include "polynomial/elimination.hpp"
#include "settled_pieces.hpp"

namespace polhode {
namespace {

using namespace boxes;
using detail::expect;

ball side_of(const std::optional<rational>& low, const std::optional<rational>& high) {
  return detail::exact_interval{low, high}.to_ball(64);
}
bool ends_before(const vector& x, const vector& y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (certainly_less(x[i], y[i])) return true;
    if (certainly_less(y[i], x[i])) return false;
  }
  return false;
}

}  // namespace

/// The result of the examination of a box: the part where its roots can be, and what becomes of
/// that part. The rest has none.
struct system_outcome {
  enum class kind {
    no_root,
    known,   // all of the box is in that of a region found before
    proved,  // it is in the region's
    stuck,
    cut  // in two
  };
  kind what = kind::no_root;
  vector left_over;  // of the box
  std::size_t known = 0;
  system_region region = {};
  std::pair<vector, vector> parts = {};
};

/// One run of a search: run() proves of each outcome that it is about the whole box, and accounts
/// for the box.
class system_searcher {
 public:
  system_searcher(system_search& s, const system_options& options)
      : s_(s), options_(options), hardware_(s.f_.components()) {
    for (const auto& [low, high] : s.range_) whole_.push_back(side_of(low, high));
    if (is_bounded(whole_)) return;
    for (const auto& p : detail::eliminants(s.f_.components())) {
      const auto bound = p ? std::optional(root_bound(*p)) : std::nullopt;
      within_.push_back(bound ? side_of(-*bound, *bound) : side_of(std::nullopt, std::nullopt));
    }
  }

  [[nodiscard]] long evaluations_in_hardware() const { return hardware_.evaluations(); }

  /// Until no box is left, or a limit is reached.
  void run() {
    constexpr long between_looks = 64;
    for (long boxes = 0; !s_.pending_.empty(); ++boxes) {
      if (s_.stuck_.size() > options_.most_unresolved) {
        s_.limit_ = "too many boxes stay unresolved: there may be infinitely many roots";
        return;
      }
      s_.limit_ = "the limit on the number of boxes was reached";
      if (boxes >= options_.most_boxes) return;
      if (options_.progress && boxes % between_looks == 0 &&
          !options_.progress({s_.account_.boxes, static_cast<long>(s_.pending_.size()),
                              static_cast<long>(s_.found_.size())})) {
        s_.limit_ = "the search was ended";
        return;
      }
      const system_search::waiting box = std::move(s_.pending_.back());
      s_.pending_.pop_back();
      ++s_.account_.boxes;
      merge(box, examine(box.x));
    }
  }

 private:
  using kind = system_outcome::kind;

  void merge(const system_search::waiting& box, system_outcome o) {
    const auto settle = [&] { s_.settled_ += detail::share_of(box.halvings); };
    switch (o.what) {
      case kind::no_root:
        return settle();
      case kind::known:
        expect(o.known < s_.found_.size() && holds(s_.found_[o.known].box, box.x),
               "a box is not in the region where its roots are known");
        return settle();
      case kind::proved:
        expect(holds(o.region.box, o.left_over) && holds(o.region.box, o.region.enclosure),
               "a box is not in the region of its root");
        add(std::move(o.region));
        return settle();
      case kind::stuck:
        s_.stuck_.push_back({std::move(o.left_over), box.halvings});
        return;
      case kind::cut:
        detail::expect_cut(o.left_over, o.parts.first, o.parts.second);
        // The last is the next: of an infinite box, the part that is nearer.
        if (!is_bounded(whole_) && magnitude_of(o.parts.second) < magnitude_of(o.parts.first)) {
          std::swap(o.parts.first, o.parts.second);
        }
        s_.pending_.push_back({std::move(o.parts.second), box.halvings + 1});
        s_.pending_.push_back({std::move(o.parts.first), box.halvings + 1});
    }
  }

  void add(system_region r) {
    for (system_region& known : s_.found_) {
      if (is_the_same(known, r)) return;
    }
    s_.found_.push_back(std::move(r));
  }

  system_outcome examine(vector x) {
    for (std::size_t i = 0; i < s_.found_.size(); ++i) {
      if (holds(s_.found_[i].box, x)) return {.what = kind::known, .left_over = {}, .known = i};
    }
    for (std::size_t i = 0; i < within_.size(); ++i) {
      if (!overlaps(x[i], within_[i])) return {};
      if (!x[i].is_bounded()) x[i] = intersection(x[i], within_[i]);
    }
    using outcome = detail::hardware_system::outcome;
    const outcome in_hardware = cut(x);
    if (in_hardware == outcome::empty) return {};
    // Narrower boxes are too close to the resolution of doubles.
    constexpr int bits_of_doubles = 26;
    const bool is_wide =
        in_hardware == outcome::wide && widest(x) > scale(magnitude_of(x), -bits_of_doubles);
    if (is_wide || !is_bounded(x)) return halved(x);
    constexpr int most_steps = 8;
    for (int step = 0; step < most_steps; ++step) {
      const precision p = bits_for(x);
      s_.account_.most_bits = std::max(s_.account_.most_bits, p);
      x = with_precision(x, p);
      ++s_.account_.evaluations;
      const vector value = s_.f_(x);
      if (value.size() != x.size()) {
        throw input_error("a system of " + std::to_string(value.size()) + " equations in " +
                          std::to_string(x.size()) + " variables: there must be as many of both");
      }
      if (!is_undefined(value) && !holds_zero(value)) return {};
      if (is_undefined(value)) break;
      const magnitude before = widest(x);
      if (prune(x)) return {};
      if (widest(x) > scale(multiply_up(before, magnitude::from_integer_up(3)), -2)) break;
      if (step == 0) continue;
      if (auto root = prove(x)) return *std::move(root);
    }
    if (auto root = prove(x)) return *std::move(root);
    return halved(x);
  }

  static std::vector<double_interval> in_doubles(const vector& x) {
    std::vector<double_interval> box;
    for (const ball& t : x) box.push_back(double_interval::from_ball(t));
    return box;
  }
  /// Cuts x down in hardware doubles.
  detail::hardware_system::outcome cut(vector& x) {
    std::vector<double_interval> box = in_doubles(x);
    const auto outcome = hardware_.cut(box);
    if (outcome == detail::hardware_system::outcome::empty) return outcome;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const ball narrower = to_ball(box[i], x[i].precision());
      if (narrower.radius() < x[i].radius()) x[i] = intersection(x[i], narrower);
      if (x[i].is_undefined()) return detail::hardware_system::outcome::empty;
    }
    return outcome;
  }

  /// Bits that tell the ends apart, twice over: f may cancel. A side that is narrower than those
  /// that are left unresolved gets as many as these: steps of Newton's method that make one side
  /// ever narrower, while the others stay, would double them without end.
  [[nodiscard]] precision bits_for(const vector& x) const {
    constexpr long spare = 4;
    precision bits = 64;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const magnitude narrowest = scale(size_of(x, i), -options_.most_halvings - spare);
      const magnitude radius = max(x[i].radius(), narrowest);
      if (x[i].radius().is_zero()) continue;
      const magnitude size = max(x[i].magnitude_upper(), size_of(x, i));
      bits = std::max<precision>(bits, 64 + 2 * (size.log2_floor() - radius.log2_floor()));
    }
    return bits;
  }

  /// Makes x narrower by the mean value form and by Gauss-Seidel; true where nothing is left.
  bool prune(vector& x) {
    const vector m = middle_of(x);
    const auto over = s_.f_.linearise(x);
    const matrix& jacobian = over.jacobian;
    s_.account_.evaluations += static_cast<long>(x.size());
    // The mean value theorem needs f itself on the whole of x.
    if (is_undefined(over.value)) return false;
    const vector at_middle = s_.f_(m);
    ++s_.account_.evaluations;
    if (is_undefined(at_middle)) return false;
    for (const vector& row : jacobian) {
      if (is_undefined(row)) return false;
    }
    const vector difference = difference_of(x, m);
    const vector change = product(jacobian, difference);
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!contains_zero(at_middle[i] + change[i])) return true;
    }
    const matrix y = approximate_inverse(jacobian, 53);
    if (y.empty()) return false;
    const vector b = product(y, at_middle);
    const matrix a = product(y, jacobian);
    // Row i of Y (f(m) + A (x - m)) = 0, solved for x_i.
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (a[i][i].is_undefined() || contains_zero(a[i][i])) continue;
      ball sum = b[i];
      for (std::size_t j = 0; j < x.size(); ++j) {
        if (j != i) sum += a[i][j] * (x[j] - m[j]);
      }
      const ball image = m[i] - sum / a[i][i];
      if (image.is_undefined()) continue;
      if (!overlaps(image, x[i])) return true;
      x[i] = intersection(image, x[i]);
    }
    return false;
  }

  /// Exactly one root in a box around x?
  std::optional<system_outcome> prove(const vector& x) {
    constexpr precision most_bits = 2048;
    for (precision p = bits_for(x); p <= most_bits; p *= 2) {
      if (auto root = prove(x, p)) return root;
      // Another root may be nearer than the room that a face needs with so few bits.
      const bool is_room_of_bits = widest(x) < scale(max(magnitude_of(x), widest(x)), -p / 2);
      if (!is_room_of_bits) break;
    }
    return std::nullopt;
  }
  static magnitude magnitude_of(const vector& x) {
    magnitude r;
    for (const ball& t : x) r = max(r, t.magnitude_upper());
    return r;
  }
  std::optional<system_outcome> prove(const vector& x, precision p) {
    vector wide;
    for (const ball& t : with_precision(x, p)) {
      // No face is without room, be x a point.
      const magnitude size = max(t.magnitude_upper(), widest(x));
      const magnitude least =
          scale(size.is_zero() ? max(magnitude_of(x), magnitude::power_of_two(-p)) : size, -p / 2);
      wide.push_back(t.enlarged(max(scale(widest(x), -1), least)));
    }
    const krawczyk_step step = krawczyk(s_.f_, wide, p);
    s_.account_.evaluations += static_cast<long>(x.size()) + 1;
    if (is_undefined(step.image)) return std::nullopt;
    if (!holds_inside(wide, step.image)) return std::nullopt;
    system_outcome o{.what = kind::proved, .left_over = x};
    o.region.verdict = root_verdict::unique;
    o.region.box = wide;
    o.region.enclosure = common(step.image, wide);
    return o;
  }

  bool is_the_same(system_region& known, system_region& more) {
    if (known.verdict != root_verdict::unique || !all_overlap(known.box, more.box)) return false;
    for (long digits = 15; digits <= 15L << 6; digits *= 2) {
      if (holds(known.box, more.enclosure) || holds(more.box, known.enclosure)) return true;
      if (!all_overlap(known.enclosure, more.enclosure)) return false;
      known.enclosure = refine(s_.f_, known, digits).enclosure;
      more.enclosure = refine(s_.f_, more, digits).enclosure;
    }
    // What holds both boxes has corners that are in neither: nothing is known of roots there.
    known.box = known.enclosure = joined(known.box, more.box);
    known.verdict = root_verdict::at_least_one;
    known.remark = "one root or two";
    return true;
  }

  /// What the width of a side is measured by.
  [[nodiscard]] magnitude size_of(const vector& x, std::size_t i) const {
    if (whole_[i].is_bounded()) return whole_[i].radius();
    return max(x[i].magnitude_upper(), magnitude::power_of_two(0));
  }

  /// Cuts x in the direction in which the equations change most; or in which it is widest, where
  /// that is not known, or x is narrow there already.
  system_outcome halved(const vector& x) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i].is_bounded()) continue;
      const std::optional<rational> at = middle_of_unbounded(x[i]);
      return at ? cut_at(x, i, *at) : system_outcome{.what = kind::stuck, .left_over = x};
    }
    std::size_t widest_one = 0;
    magnitude most;
    const auto width = [&](std::size_t i) { return divide_up(x[i].radius(), size_of(x, i)); };
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i].radius().is_zero() || width(i) <= most) continue;
      most = width(i);
      widest_one = i;
    }
    if (most <= magnitude::power_of_two(-options_.most_halvings)) {
      return {.what = kind::stuck, .left_over = x};
    }
    // In narrow boxes, which are around roots that cannot be told apart, every side is to shrink.
    constexpr int most_by_change = 12;  // halvings
    if (most > magnitude::power_of_two(-most_by_change)) {
      const auto chosen = hardware_.direction(in_doubles(x));
      if (chosen && scale(width(*chosen), most_by_change) > most) widest_one = *chosen;
    }
    if (!whole_[widest_one].is_bounded()) {
      if (const auto at = middle_of_magnitudes(x[widest_one])) return cut_at(x, widest_one, *at);
    }
    const auto [low, high] = split(x[widest_one]);
    return parts_of(x, widest_one, low, high);
  }

  /// A place to cut a side that is not bounded; none far out.
  static std::optional<rational> middle_of_unbounded(const ball& x) {
    const double_interval ends = double_interval::from_ball(x);
    if (ends.upper() < detail::infinity) {
      const std::optional<rational> mirrored = middle_of_unbounded(-x);
      return mirrored ? std::optional<rational>(-*mirrored) : std::nullopt;
    }
    if (ends.lower() < 0) return 0;
    for (const unsigned exponent : {10U, 200U}) {
      if (ends.lower() < std::ldexp(1.0, static_cast<int>(exponent))) {
        return rational(integer(1) << exponent);
      }
    }
    return std::nullopt;
  }
  /// A power of two between the ends of x, where these have one sign and are of different sizes.
  static std::optional<rational> middle_of_magnitudes(const ball& x) {
    constexpr std::int64_t apart = 4;
    const magnitude low = x.magnitude_lower();
    if (low.is_zero()) return std::nullopt;
    const std::int64_t first = low.log2_floor();
    const std::int64_t last = x.magnitude_upper().log2_floor();
    if (last - first < apart) return std::nullopt;
    const ball power = scale(ball(1, least_precision), static_cast<long>((first + last) / 2));
    return lower_rational(certainly_positive(x) ? power : -power);
  }

  static system_outcome cut_at(const vector& x, std::size_t i, const rational& at) {
    return parts_of(x, i, intersection(x[i], side_of(std::nullopt, at)),
                    intersection(x[i], side_of(at, std::nullopt)));
  }
  static system_outcome parts_of(const vector& x, std::size_t i, const ball& low,
                                 const ball& high) {
    vector left = x;
    vector right = x;
    left[i] = low;
    right[i] = high;
    return {.what = kind::cut,
            .left_over = x,
            .known = 0,
            .region = {},
            .parts = {std::move(left), std::move(right)}};
  }

  system_search& s_;
  const system_options& options_;
  detail::hardware_system hardware_;
  vector whole_;
  vector within_;  // all solutions, of a box that is not bounded
};

system_search::system_search(real_system f, system_box box)
    : f_(std::move(f)), range_(std::move(box)) {
  if (range_.empty()) throw input_error("a system without variables: there must be at least one");
  waiting all;
  for (const auto& [low, high] : range_) {
    if (low && high && *low > *high) {
      throw input_error(
          "the box is the wrong way round: a lower end is greater than its upper end");
    }
    all.x.push_back(side_of(low, high));
    expect(detail::holds(all.x.back(), {low, high}), "the box is not the one that was asked for");
  }
  pending_.push_back(std::move(all));
}

void system_search::run(const system_options& options) {
  system_searcher searcher(*this, options);
  searcher.run();
  account_.evaluations += searcher.evaluations_in_hardware();
}

bool system_root_set::is_resolved() const {
  return complete && std::all_of(regions.begin(), regions.end(), [](const system_region& r) {
           return is_one_root(r.verdict) && !r.may_lie_outside;
         });
}

namespace {

using detail::place;
using detail::place_of;

/// A root in the box: a point of short rational numbers, at which each formula is 0 by exact rules.
std::optional<std::vector<rational>> exact_zero(const real_system& f, const vector& box) {
  const integer longest = integer(1) << 24U;  // denominator
  std::vector<rational> root;
  std::vector<symbol> point;
  for (const ball& x : box) {
    if (!x.is_bounded()) return std::nullopt;
    const rational q = simplest_between(lower_rational(x), upper_rational(x));
    if (denominator(q) > longest) return std::nullopt;
    root.push_back(q);
    point.emplace_back(q);
  }
  try {
    for (const expression& component : f.components()) {
      const expression value(component.evaluate(std::span<const symbol>(point)), component.names());
      if (value.rational_value() != rational(0)) return std::nullopt;
    }
  } catch (const input_error&) {
    return std::nullopt;  // one is not defined there
  }
  return root;
}

/// The root of a unique region where it is such a point: it is the only one in the region.
std::optional<std::vector<rational>> exact_root(const real_system& f, const system_region& r) {
  if (r.verdict != root_verdict::unique) return std::nullopt;
  constexpr long digits = 30;
  return exact_zero(f, refine(f, r, digits).enclosure);
}

/// Whether the point lies in the given box; nullopt where that is not decided.
std::optional<bool> is_in(detail::algebraic_point& x, const system_box& box) {
  bool is_decided = true;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::optional<bool> is_inside = x[i].is_in({box[i].first, box[i].second});
    if (is_inside == false) return false;
    is_decided = is_decided && is_inside;
  }
  return is_decided ? std::optional(true) : std::nullopt;
}

}  // namespace

/// A region for each solution in an open box, which is no root that was found before; nullopt where
/// they are not known.
std::optional<std::vector<system_region>> system_search::regions_of(detail::common_zeros& zeros,
                                                                    const vector& box) const {
  auto solutions = zeros.in(box);
  if (!solutions) return std::nullopt;
  constexpr precision most_bits = 4096;
  for (precision p = 128; p <= most_bits; p *= 2) {
    std::vector<system_region> result;
    bool is_told_apart = true;
    for (auto& [verdict, at] : *solutions) {
      system_region r;
      r.verdict = verdict;
      r.enclosure = detail::enclosure_of(at, p);
      r.enclose = [at = at](precision bits) {
        auto own = at;
        return detail::enclosure_of(own, bits);
      };
      r.box = solutions->size() == 1 ? box : r.enclosure;
      const auto is_near = [&](const system_region& other) {
        return all_overlap(other.box, r.enclosure);
      };
      const auto is_other = [&](const system_region& other) {
        return holds(other.box, r.enclosure);
      };
      // The one root of a region is simple.
      if (verdict == root_verdict::unique && std::ranges::any_of(found_, is_other)) continue;
      const bool is_apart =
          (verdict == root_verdict::multiple || std::ranges::none_of(found_, is_near)) &&
          (solutions->size() == 1 || std::ranges::none_of(result, is_near));
      is_told_apart = is_told_apart && is_apart;
      const std::optional<bool> is_inside = is_in(at, range_);
      if (is_inside == false) continue;
      r.may_lie_outside = !is_inside;
      result.push_back(std::move(r));
    }
    if (is_told_apart) return result;
  }
  return std::nullopt;
}

system_root_set system_search::result() const {
  std::vector<int> open_halvings;
  for (const auto* boxes : {&pending_, &stuck_}) {
    for (const waiting& b : *boxes) open_halvings.push_back(b.halvings);
  }
  detail::expect_all_shares(settled_, open_halvings);
  system_root_set result;
  result.complete = pending_.empty();
  result.account = account_;
  for (system_region r : found_) {
    place where = place_of(r.enclosure, range_);
    if (const auto exact = exact_root(f_, r)) {
      where = place_of(*exact, range_);
      for (std::size_t i = 0; i < exact->size(); ++i) {
        r.enclosure[i] = ball((*exact)[i], std::max(precision{64}, r.enclosure[i].precision()));
      }
    }
    for (long digits = 20; digits <= 320 && where == place::undecided; digits *= 4) {
      r.enclosure = refine(f_, r, digits).enclosure;
      where = place_of(r.enclosure, range_);
    }
    if (where == place::outside) continue;
    r.may_lie_outside = where == place::undecided;
    result.regions.push_back(std::move(r));
  }
  // Boxes that touch are one cluster.
  std::vector<vector> open;
  for (const auto* boxes : {&pending_, &stuck_}) {
    for (const waiting& b : *boxes) {
      const bool known = std::any_of(found_.begin(), found_.end(),
                                     [&](const system_region& r) { return holds(r.box, b.x); });
      if (!known) open.push_back(b.x);
    }
  }
  // Where the search has not ended, all that is left may be solved at once.
  std::optional<detail::common_zeros> zeros;
  if (!open.empty()) zeros.emplace(f_.components());
  if (!result.complete && !open.empty()) {
    vector all = open.front();
    for (const vector& x : open) all = joined(all, x);
    if (auto solved = is_bounded(all) ? regions_of(*zeros, all) : std::nullopt) {
      std::ranges::move(*solved, std::back_inserter(result.regions));
      result.complete = true;
      open = {all};
    }
  }
  const bool is_solved = result.complete && !pending_.empty();
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (std::size_t j = i + 1; j < open.size();) {
      if (!all_overlap(open[i], open[j])) {
        ++j;
        continue;
      }
      open[i] = joined(open[i], open[j]);
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;
    }
  }
  for (const auto* boxes : {&pending_, &stuck_}) {
    for (const waiting& b : *boxes) {
      const auto has_it = [&](const vector& x) { return holds(x, b.x); };
      expect(std::any_of(open.begin(), open.end(), has_it) ||
                 std::any_of(found_.begin(), found_.end(),
                             [&](const system_region& r) { return has_it(r.box); }),
             "an open box is in no region");
    }
  }
  if (is_solved) open.clear();
  for (vector& x : open) {
    if (is_bounded(x) && result.complete) {
      if (auto solved = regions_of(*zeros, x)) {
        std::ranges::move(*solved, std::back_inserter(result.regions));
        continue;
      }
    }
    system_region r;
    r.box = r.enclosure = std::move(x);
    if (!is_bounded(r.box)) {
      r.remark = "the roots have no proved bound";
    } else if (result.complete && exact_zero(f_, r.box)) {
      r.verdict = root_verdict::at_least_one;
      r.remark = "there is a root, exactly; others may be near";
    } else {
      r.remark = result.complete ? "not resolved by halving" : limit_;
    }
    result.regions.push_back(std::move(r));
  }
  std::stable_sort(result.regions.begin(), result.regions.end(),
                   [](const system_region& x, const system_region& y) {
                     return ends_before(x.enclosure, y.enclosure);
                   });
  return result;
}

system_root_set solve_system(const real_system& f, const system_box& box,
                             const system_options& options) {
  system_search s(f, box);
  // After some boxes another way may solve what is left: substitution, or elimination in result().
  constexpr long few = 1'000;
  constexpr long many = 20'000;
  long done = 0;
  system_root_set found;
  const auto run_to = [&](long boxes) {
    system_options part = options;
    part.most_boxes = std::min(options.most_boxes, boxes) - done;
    s.run(part);
    done += part.most_boxes;
    found = s.result();
    return found.is_resolved() || s.is_finished() || found.account.boxes < done;
  };
  if (detail::has_explicit_equation(f)) {
    (void)run_to(few);
    if (found.is_resolved()) return found;
    if (auto others = detail::solved_by_substitution(f, box, options)) {
      others->account.boxes += found.account.boxes;
      others->account.evaluations += found.account.evaluations;
      return *others;
    }
  }
  for (const long boxes : {many, options.most_boxes}) {
    if (done < std::min(boxes, options.most_boxes) && run_to(boxes)) break;
    if (found.complete) break;
  }
  return found;
}

}  // namespace polhode
