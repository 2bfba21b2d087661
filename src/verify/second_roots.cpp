#include "polhode/verify/second_roots.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "base/clock.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/verify/second_integral.hpp"

namespace polhode {

// ---------------------------------------------------------------------------------------------
// Two lists

namespace {

std::string place_of(const proved_root& r) {
  constexpr long few = 20;
  return to_decimal(r.enclosure, few);
}

std::string summary_of(const proved_roots& list) {
  if (list.identically_zero) return "the formula is 0 everywhere";
  std::string result =
      fmt::format("{} root{}", list.roots.size(), list.roots.size() == 1 ? "" : "s");
  constexpr std::size_t most = 8;
  for (std::size_t i = 0; i < std::min(list.roots.size(), most); ++i) {
    result += (i == 0 ? ": " : ", ") + place_of(list.roots[i]);
  }
  return result + (list.roots.size() > most ? ", ..." : "");
}

/// A root that one list proves has a place in the other, which has all roots.
void expect_places(const finding<proved_roots>& one, const finding<proved_roots>& other) {
  if (!other.enclosure.complete || other.enclosure.identically_zero) return;
  for (const proved_root& r : one.enclosure.roots) {
    const bool proved =
        r.is_resolved() || (r.verdict == root_verdict::at_least_one && !r.may_lie_outside);
    const bool has_place =
        std::any_of(other.enclosure.roots.begin(), other.enclosure.roots.end(),
                    [&](const proved_root& o) { return overlaps(o.enclosure, r.enclosure); });
    if (proved && !has_place) {
      contradict("the roots", {one.route, "there is a root at " + place_of(r)},
                 {other.route, "there is none there; in all " + summary_of(other.enclosure)});
    }
  }
}

void expect_same(std::size_t index, const finding<proved_root>& first,
                 const finding<proved_root>& second) {
  const std::string what = fmt::format("root {}", index + 1);
  expect_overlap(what, {first.route, first.enclosure.enclosure},
                 {second.route, second.enclosure.enclosure});
  if (first.enclosure.multiplicity != second.enclosure.multiplicity) {
    const auto said = [](const proved_root& r) {
      return fmt::format("multiplicity {} at {}", r.multiplicity, place_of(r));
    };
    contradict(what, {first.route, said(first.enclosure)}, {second.route, said(second.enclosure)});
  }
}

/// The regions that are proved to hold infinitely many roots.
std::vector<ball> endless_parts(const proved_roots& list) {
  std::vector<ball> result;
  for (const proved_root& r : list.roots) {
    if (r.verdict == root_verdict::infinitely_many) result.push_back(r.enclosure);
  }
  return result;
}
/// The roots that are certainly in none of these.
std::vector<proved_root> outside(std::vector<proved_root> roots, const std::vector<ball>& parts) {
  std::erase_if(roots, [&](const proved_root& r) {
    return std::ranges::any_of(parts, [&](const ball& x) { return overlaps(r.enclosure, x); });
  });
  return roots;
}

}  // namespace

std::optional<std::string> compare(const finding<proved_roots>& first,
                                   const finding<proved_roots>& second) {
  const proved_roots& one = first.enclosure;
  const proved_roots& other = second.enclosure;
  const auto contradict_as_a_whole = [&] {
    contradict("the roots", {first.route, summary_of(one)}, {second.route, summary_of(other)});
  };
  if (one.identically_zero != other.identically_zero) {
    // A function that is 0 everywhere has no root that is the only one in its place.
    const proved_roots& isolated = one.identically_zero ? other : one;
    if (isolated.is_resolved()) contradict_as_a_whole();
    return "it does not find the formula to be 0 everywhere";
  }
  if (one.identically_zero) return std::nullopt;
  expect_places(first, second);
  expect_places(second, first);
  const std::vector<ball> endless = endless_parts(one);
  const std::vector<ball> also_endless = endless_parts(other);
  if (endless.empty() != also_endless.empty()) return "it does not find infinitely many roots";
  const std::vector<proved_root> roots = outside(outside(one.roots, endless), also_endless);
  const std::vector<proved_root> others = outside(outside(other.roots, endless), also_endless);
  const auto is_resolved = [](const proved_root& r) { return r.is_resolved(); };
  if (!one.complete || !other.complete || !std::ranges::all_of(roots, is_resolved) ||
      !std::ranges::all_of(others, is_resolved)) {
    return "it leaves places open";
  }
  if (roots.size() != others.size()) {
    if (!endless.empty()) return "it finds another number of roots outside the endless parts";
    contradict_as_a_whole();
  }
  for (std::size_t i = 0; i < roots.size(); ++i) {
    expect_same(i, {first.route, roots[i]}, {second.route, others[i]});
  }
  return std::nullopt;
}

// ---------------------------------------------------------------------------------------------
// The second search

namespace {

/// A point between the ends at which f certainly has a sign, and so no root.
std::optional<rational> cut_of(const expression& f, const end_point& lower,
                               const end_point& upper) {
  constexpr precision bits = 256;
  constexpr int most_attempts = 4;
  const auto g = f.evaluator<ball>(bits);
  end_point end = upper;
  for (int i = 0; i < most_attempts; ++i) {
    std::optional<rational> cut = cut_between(lower, end);
    if (!cut) return std::nullopt;
    const ball value = g(ball(*cut, bits));
    if (certainly_positive(value) || certainly_negative(value)) return cut;
    end = end_point(*cut);
  }
  return std::nullopt;
}

struct search_result {
  proved_roots list;
  isolation_account account;
  bool has_digits = true;
};

/// The roots of g from lower to upper, refined, with their signs changed.
void search(const real_function& g, const end_point& lower, const end_point& upper, long digits,
            int threads, search_result& result) {
  isolate_options options;
  options.threads = threads;
  const root_set found = isolate_roots(g, lower, upper, options);
  result.list.complete = result.list.complete && found.complete;
  result.list.identically_zero = result.list.identically_zero || found.identically_zero;
  result.account.boxes += found.account.boxes;
  result.account.evaluations += found.account.evaluations;
  const std::vector<refined_root> fine = refine(found.regions, digits, threads);
  for (std::size_t i = 0; i < found.regions.size(); ++i) {
    const root_region& r = found.regions[i];
    const bool proved = is_one_root(r.verdict);
    result.has_digits = result.has_digits && (!proved || fine[i].verdict == status::certified);
    result.list.roots.push_back({r.verdict, r.multiplicity,
                                 -(proved ? fine[i].enclosure : r.enclosure), r.may_lie_outside});
  }
}

search_result search_backwards(const expression& f, const end_point& lower, const end_point& upper,
                               const std::optional<rational>& cut, long digits, int threads) {
  const real_function g([&f](const auto& x) { return f(-x); });
  search_result result;
  if (cut) {
    const end_point middle{rational(-*cut)};
    search(g, -upper, middle, digits, threads, result);
    search(g, middle, -lower, digits, threads, result);
  } else {
    search(g, -upper, -lower, digits, threads, result);
  }
  std::reverse(result.list.roots.begin(), result.list.roots.end());
  return result;
}

}  // namespace

second_opinion roots_again(const expression& f, const end_point& lower, const end_point& upper,
                           const proved_roots& first, const std::string& first_route, long digits,
                           int threads) {
  constexpr long more_digits = 5;
  const auto start = detail::clock::now();
  const std::optional<rational> cut = cut_of(f, lower, upper);
  const search_result found = search_backwards(f, lower, upper, cut, digits + more_digits, threads);
  route_report report;
  report.route = "a search backwards";
  if (cut) report.route += ", in two parts that meet at " + to_decimal(ball(*cut, 64), 6);
  report.work =
      fmt::format("{} boxes, {} evaluations", found.account.boxes, found.account.evaluations);
  report.seconds = detail::seconds_since(start);
  const auto obstacle = compare({first_route, first}, {report.route, found.list});
  if (obstacle) {
    report.obstacle = *obstacle;
  } else if (!found.has_digits) {
    report.obstacle = "it finds the roots to fewer digits";
  } else {
    report.enclosure = found.list;
  }
  second_opinion result;
  result.add(std::move(report));
  return result;
}

second_opinion roots_again(const expression& f, const end_point& lower, const end_point& upper,
                           const root_set& first, long digits, int threads) {
  proved_roots list;
  list.complete = first.complete;
  list.identically_zero = first.identically_zero;
  const std::vector<refined_root> fine = refine(first.regions, digits, threads);
  for (std::size_t i = 0; i < first.regions.size(); ++i) {
    const root_region& r = first.regions[i];
    list.roots.push_back({r.verdict, r.multiplicity,
                          is_one_root(r.verdict) ? fine[i].enclosure : r.enclosure,
                          r.may_lie_outside});
  }
  const auto& one = first.of_period;
  return roots_again(f, one ? one->lower : lower, one ? one->upper : upper, list,
                     fmt::format("the search, {} boxes", first.account.boxes), digits, threads);
}

}  // namespace polhode
