#include "searcher.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include "base/worker_threads.hpp"
#include "clusters.hpp"
#include "examination.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polynomial.hpp"

namespace polhode::detail {

namespace {

/// One run of a search. Boxes are examined from left to right, each result before the next box;
/// more threads examine boxes before their turn, and what they find waits for it. So their number
/// changes nothing in the answer.
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
    const std::optional<double> whole = open_width();
    // Whether a limit ends the run, after so many boxes, or steps with polynomials.
    const auto is_over = [&](long boxes) {
      constexpr long between_looks = 64;
      if (boxes >= options_.most_boxes) {
        s_.limit = "the limit on the number of boxes";
      } else if (static_cast<long>(s_.stuck.size()) > options_.most_unresolved) {
        s_.limit = "the limit on unresolved boxes";
      } else if (options_.most_time &&
                 std::chrono::steady_clock::now() - start > *options_.most_time) {
        s_.limit = "the limit on the time";
      } else if (options_.progress && boxes % between_looks == 0 &&
                 !options_.progress({s_.account.boxes + boxes, static_cast<long>(s_.pending.size()),
                                     static_cast<long>(s_.found.size()), share_done(whole)})) {
        s_.limit = "a request to stop";
      }
      return !s_.limit.empty();
    };
    while (!s_.pending.empty() && s_.problems[s_.pending.back().problem].is_factor) {
      if (is_over(0) || !settle_polynomial(s_, s_.pending.back().problem,
                                           [&](long steps) { return !is_over(steps); })) {
        return;
      }
      s_.pending.pop_back();
    }
    for (long boxes = 0; !s_.pending.empty(); ++boxes) {
      if (is_over(boxes)) return;
      if (is_beside_unresolved(s_.pending.back()) && !s_.pending.back().is_left_whole) {
        forget_ahead(s_.pending.back());
        s_.pending.back().is_left_whole = true;
      }
      if (seems_endless(s_.pending.back())) {
        leave_open_end();
        continue;
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

  /// A row of unresolved boxes ends where the box begins: a function that is not defined there,
  /// say, at one end. Were all boxes beside it halved to the end, they would use up the limit on
  /// unresolved ones, and nothing to their right would be found.
  [[nodiscard]] bool is_beside_unresolved(const work_box& b) const {
    constexpr std::size_t long_row = 8;
    const auto& stuck = s_.stuck;
    if (stuck.size() < long_row) return false;
    const std::optional<rational>* end = &b.x.lower;
    for (std::size_t i = 0; i < long_row; ++i) {
      const work_box& left = stuck[stuck.size() - 1 - i];
      if (left.problem != b.problem || !left.x.upper || !*end || *left.x.upper != **end) {
        return false;
      }
      end = &left.x.lower;
    }
    return true;
  }

  // -------------------------------------------------------------------------------------------
  // Towards infinity

  /// Many roots, or places where f is not defined, were found on the way to an infinite end or to
  /// a singular point, b is next on that way, and f is not proved to have no root from some point
  /// on.
  /// To the left only whole parts are passed, as a part is examined from its left end.
  bool seems_endless(const work_box& b) {
    const auto most = static_cast<std::size_t>(options_.most_towards_end);
    if (s_.found.size() + s_.singular.size() < most || (!b.x.lower && !b.x.upper)) return false;
    if (b.singular != singular_point::none) {
      if (!roots_crowd_before(b)) return false;
      if (b.singular == singular_point::inside) return true;
      const bool is_upper = b.singular == singular_point::at_upper_end;
      const auto [known, is_new] =
          rootless_beside_.try_emplace({is_upper ? *b.x.upper : *b.x.lower, is_upper}, false);
      if (is_new) known->second = is_rootless_beside_end(b, is_upper);
      return !known->second;
    }
    const bool rightward = b.x.lower.has_value();
    std::optional<bool>& known = ends_somewhere_.at(rightward ? 1 : 0);
    if (known && *known) return false;
    const work_box& end = rightward ? s_.pending.front() : b;
    if (rightward ? end.x.upper.has_value() || *b.x.lower < 0 : b.x.lower.has_value()) return false;
    const auto is_on_this_side = [&](const double_interval& x) {
      return rightward ? x.upper() >= 0 : x.lower() <= 0;
    };
    const auto roots = std::ranges::count_if(
        s_.found, [&](const found_root& r) { return is_on_this_side(r.about); });
    const auto others = std::ranges::count_if(s_.singular, [&](const singular_place& p) {
      return is_on_this_side(double_interval::from_ball(p.place));
    });
    if (static_cast<std::size_t>(roots + others) < most) return false;
    if (!known) known = has_rootless_end(end);
    return !*known;
  }
  /// Parts of x, beside the box, are not examined yet.
  [[nodiscard]] bool is_open_beside(const work_box& b, const double_interval& x) const {
    return std::ranges::any_of(s_.pending, [&](const work_box& other) {
      return &other != &b && other.problem == b.problem &&
             (!other.x.lower || static_cast<double>(*other.x.lower) < x.upper()) &&
             (!other.x.upper || static_cast<double>(*other.x.upper) > x.lower());
    });
  }
  /// On a side of the box's singular point there are many roots at distances between the box's
  /// width and twice as much, and no more between twice and four times: they do not become fewer
  /// towards that point. Or the box is so small that they go on at all scales.
  [[nodiscard]] bool roots_crowd_before(const work_box& b) const {
    const exact_box& whole = s_.settled[b.problem].whole();
    constexpr unsigned scales = 200;
    const rational size = whole.is_bounded() ? whole.width() : rational(1);
    if (b.x.width() * rational(integer(1) << scales) < size) return true;
    const bool is_at_lower = b.singular == singular_point::at_lower_end;
    const bool is_at_upper = b.singular == singular_point::at_upper_end;
    const rational point = is_at_lower ? *b.x.lower : is_at_upper ? *b.x.upper : b.x.middle();
    const auto crowd = [&](bool rightward) {
      const rational width = rightward ? b.x.width() : rational(-b.x.width());
      if (!whole.contains(point + 4 * width)) return false;
      const double_interval searched =
          hull(double_interval(point), double_interval(rational(point + 4 * width)));
      if (is_open_beside(b, searched)) return false;
      // Of the roots and singular places beyond the box, from the point, in units of the width.
      const double edge = is_at_lower || is_at_upper ? 1 : 0.5;
      const auto from = static_cast<double>(point);
      const auto unit = static_cast<double>(width);
      std::vector<double> distances;
      const auto add = [&](double x) {
        const double distance = (x - from) / unit;
        if (edge <= distance && distance < 4) distances.push_back(distance);
      };
      for (const found_root& r : s_.found) add(r.about.midpoint());
      for (const singular_place& p : s_.singular) {
        add(double_interval::from_ball(p.place).midpoint());
      }
      std::ranges::sort(distances);
      const auto between = [&](double near, double far) {
        return std::ranges::lower_bound(distances, far) - std::ranges::lower_bound(distances, near);
      };
      constexpr std::size_t many = 16;
      if (between(1, 2) < static_cast<long>(many) || between(1, 2) < between(2, 4)) return false;
      // The nearest ones begin at the box, and do not become more away from it, towards another
      // singular point.
      const double first = distances.front();
      const double middle = distances[many / 2];
      const double last = distances[many - 1];
      return first - edge <= last - first && middle - first <= 1.5 * (last - middle);
    };
    return (!is_at_upper && crowd(true)) || (!is_at_lower && crowd(false));
  }
  /// f is proved to have no root in a part of the unbounded box, up to infinity.
  bool has_rootless_end(const work_box& b) {
    const bool rightward = b.x.lower.has_value();
    const rational size = std::max<rational>(rightward ? *b.x.lower : rational(-*b.x.upper), 1);
    constexpr unsigned most_doublings = 64;
    for (unsigned k = 4; k <= most_doublings; k += 4) {
      work_box far = b;
      const rational end = size * rational(integer(1) << k);
      (rightward ? far.x.lower : far.x.upper) = rightward ? end : rational(-end);
      const auto r = outcome_of(
          [&](evaluators& own) { return examine_box(s_, options_, own, std::move(far)); });
      if (r->error) return true;  // it will be met again
      s_.account.evaluations += r->evaluations;
      if (r->rest.empty() && r->stuck.empty()) return true;
    }
    return false;
  }
  /// f is proved to have no root in a part of the bounded box, up to its upper or lower end.
  [[nodiscard]] bool is_rootless_beside_end(const work_box& b, bool is_upper) const {
    const real_function& f = *s_.problems[b.problem].g;
    const pi_combination end{is_upper ? *b.x.upper : *b.x.lower, 0};
    constexpr unsigned most_halvings = 64;
    for (unsigned k = 4; k <= most_halvings; k += 4) {
      const rational width = b.x.width() / rational(integer(1) << k);
      if (f.has_no_root_beside(end, is_upper ? rational(-width) : width)) return true;
    }
    return false;
  }
  /// f is proved to have infinitely many roots in the box, towards its infinite end or its singular
  /// point.
  [[nodiscard]] bool has_endless_roots(const work_box& b) const {
    const real_function& f = *s_.problems[b.problem].g;
    if (b.singular == singular_point::none) return f.has_endless_roots(b.x.upper ? -1 : 1);
    return f.has_endless_roots_in(*b.x.lower, *b.x.upper);
  }
  /// Leaves the next box unresolved, and all that is beyond it on the way to an infinite end.
  void leave_open_end() {
    const work_box& next = s_.pending.back();
    const bool takes_all = next.singular == singular_point::none && next.x.lower.has_value();
    const bool is_endless = has_endless_roots(takes_all ? s_.pending.front() : next);
    const std::string remark =
        is_endless ? fmt::format("proved; {} roots or singular places were found before it",
                                 options_.most_towards_end)
                   : fmt::format(
                         "there may be infinitely many roots: {} roots or singular places were "
                         "found before it, and none is proved to be the last; in an interval that "
                         "ends before, all are found",
                         options_.most_towards_end);
    do {
      work_box b = std::move(s_.pending.back());
      s_.pending.pop_back();
      forget_ahead(b);
      b.remark = remark;
      b.is_open_end = true;
      b.has_endless_roots = is_endless && (!takes_all || s_.pending.empty());
      s_.stuck.push_back(std::move(b));
    } while (takes_all && !s_.pending.empty());
  }

  /// About the sum of the widths of the boxes that are left; nothing where one is unbounded.
  [[nodiscard]] std::optional<double> open_width() const {
    if (!options_.progress) return std::nullopt;
    double sum = 0;
    for (const work_box& b : s_.pending) {
      if (!b.x.is_bounded()) return std::nullopt;
      sum += b.x.width().convert_to<double>();
    }
    return sum;
  }
  [[nodiscard]] std::optional<double> share_done(const std::optional<double>& whole) const {
    const std::optional<double> left = open_width();
    if (!whole || !left || !(*whole > 0)) return std::nullopt;
    return std::clamp(1 - *left / *whole, 0.0, 1.0);
  }

  // -------------------------------------------------------------------------------------------
  // Examining

  /// The outcome of examine(evaluators), or the exception that it was left by.
  template <class Examine>
  std::shared_ptr<outcome> outcome_of(const Examine& examine) {
    auto r = std::make_shared<outcome>();
    try {
      *r = examine(evaluators_.local());
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
      b.ahead = outcome_of([&](evaluators& known) { return examine_box(s_, options_, known, b); });
    };
    const auto count = static_cast<long>(boxes.size());
    if (count == 1) {
      step(0);
    } else {
      workers_->for_each(count, step);
    }
    waiting_ += count;
  }

  /// The boxes that are to be examined, in the order in which the search will meet them, as far as
  /// that is known.
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

  /// Discards results computed ahead that the search will not use.
  void forget_ahead(work_box& b) {
    if (b.ahead == nullptr) return;
    --waiting_;
    for (work_box& part : b.ahead->rest) forget_ahead(part);
    b.ahead = nullptr;
  }

  // -------------------------------------------------------------------------------------------
  // Merging

  /// Proves that the outcome is about the whole box, and keeps it. Of the box, the parts are what
  /// was open until now.
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

  /// A cluster's outcome is about its hull, one set without a root or with known ones, and settles
  /// its parts.
  void settle(const work_box& b, const std::vector<const exact_box*>& parts, outcome& o) {
    settled_pieces& settled = s_.settled[b.problem];
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
    std::optional<rational> isolated_at;
    if (o.known->region && o.known->region->verdict == root_verdict::isolated) {
      isolated_at = o.known->region->exact;
    }
    const auto settle_all = [&](const auto& add_piece) {
      for (const exact_box* x : parts) add_piece(*x);
      take_out(b.problem, o.known->done, isolated_at, add_piece);
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
    // A search goes from left to right: mostly the root is beyond all others.
    const bool is_beyond = about.lower() > s_.end_of_found;
    s_.end_of_found = std::max(s_.end_of_found, about.upper());
    for (std::size_t i = is_beyond ? s_.found.size() : 0; i < s_.found.size(); ++i) {
      found_root& known = s_.found[i];
      if (is_one_root(r.verdict) && known.problem == problem && overlaps(known.about, about) &&
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
    if (!is_one_root(known.verdict) || !overlaps(known.box, more.box)) return false;
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

  /// Appends the box to a stack: beside an isolated root at c, in pieces whose distances from c
  /// grow by a constant factor, as there may be roots at any scale. Rightward: c is on the left.
  static void append_in_shells(std::vector<work_box>& stack, work_box b,
                               const std::optional<rational>& c, bool rightward) {
    if (!c) {
      stack.push_back(std::move(b));
      return;
    }
    constexpr long growth = 1L << 10;
    std::vector<work_box> shells;  // the nearest to c first
    const std::optional<rational>& last = rightward ? b.x.upper : b.x.lower;
    while (true) {
      const rational cut = *c + growth * ((rightward ? *b.x.lower : *b.x.upper) - *c);
      if (cut == *c || (last && (rightward ? cut >= *last : cut <= *last))) break;
      if (!last && abs(cut) > 1) break;  // the rest is a tail
      shells.push_back(b);
      (rightward ? shells.back().x.upper : shells.back().x.lower) = cut;
      (rightward ? b.x.lower : b.x.upper) = cut;
    }
    shells.push_back(std::move(b));
    if (rightward) std::reverse(shells.begin(), shells.end());
    stack.insert(stack.end(), std::make_move_iterator(shells.begin()),
                 std::make_move_iterator(shells.end()));
  }

  /// Settles `done`, in which all roots of the problem are known, and perhaps an isolated one.
  /// Gives what it takes out to add_piece.
  template <class AddPiece>
  void take_out(std::size_t problem, const exact_box& done,
                const std::optional<rational>& isolated_at, const AddPiece& add_piece) {
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
        b.halvings = std::min(b.halvings, halvings_beside_zero);
        add_piece(
            {!b.x.lower || (done.lower && *b.x.lower < *done.lower) ? done.lower : b.x.lower,
             !b.x.upper || (done.upper && *b.x.upper > *done.upper) ? done.upper : b.x.upper});
        // The right part first: the leftmost box is on top.
        if (!b.x.upper || *b.x.upper > *done.upper) {
          work_box right = b;
          right.x.lower = done.upper;
          append_in_shells(left, std::move(right), isolated_at, true);
        }
        if (!b.x.lower || *b.x.lower < *done.lower) {
          b.x.upper = done.lower;
          append_in_shells(left, std::move(b), isolated_at, false);
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
      outcomes[k] = outcome_of(
          [&](evaluators& known) { return examine_cluster(s_, options_, known, clusters[k]); });
    };
    const auto count = static_cast<long>(clusters.size());
    if (workers_) {
      workers_->for_each(count, step);
    } else {
      for (long i = 0; i < count; ++i) step(i);
    }
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      s_.has_open_end |= clusters[i].is_open_end && !clusters[i].has_endless_roots;
      merge(clusters[i], parts[i], std::move(*outcomes[i]));
    }
  }

  root_search::state& s_;
  const isolate_options& options_;
  std::optional<worker_threads> workers_;
  tbb::enumerable_thread_specific<evaluators> evaluators_;
  long most_at_a_time_ = 1;
  /// Whether f has no root from some point on, to the left and to the right, where it was asked.
  std::array<std::optional<bool>, 2> ends_somewhere_;
  /// Whether f has no root beside a point, below it (true) or above it, where it was asked.
  std::map<std::pair<rational, bool>, bool> rootless_beside_;
  long waiting_ = 0;  // boxes that were examined and not merged yet
};

}  // namespace

void search(root_search::state& s, const isolate_options& options) { searcher(s, options).run(); }

}  // namespace polhode::detail
