// Functions whose roots are known by the way they are made, drawn to be hard: clusters,
// multiplicities, irrational roots beside rational ones, roots at the ends, poles, and systems on
// faces. No root may be lost, none claimed that is not there, no multiplicity be wrong.

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/roots/isolate.hpp"
#include "polhode/roots/systems.hpp"
#include "support/random.hpp"

namespace polhode {
namespace adversary_test {

using support::random_source;
using support::repeat;

constexpr precision truth_bits = 1200;

rational ten_to_minus(long e) {
  rational r = 1;
  for (long k = 0; k < e; ++k) r /= 10;
  return r;
}

/// A root of the function, known to any precision; exactly where it is rational.
struct known_root {
  std::function<ball(precision)> at;
  std::optional<rational> exact;
  long multiplicity = 1;
};

known_root exactly(const rational& q, long multiplicity) {
  return {[q](precision p) { return ball(q, p); }, q, multiplicity};
}

// ---------------------------------------------------------------------------------------------
// The functions: (g(x) - r)^m ... times a factor without a zero, divided by a power of x - pole

enum class inner {
  identity,
  exponential,
  cube,
  inverse,
  sinus_hyperbolicus,
  logarithm,
  arc_tangent
};
enum class disguise { none, exponential, quadratic, cosine };

struct made_function {
  std::vector<std::pair<rational, long>> factors;
  inner g = inner::identity;
  disguise by = disguise::none;
  std::optional<rational> square_root;  // one more factor x^2 - this
  std::optional<std::pair<rational, long>> pole;

  template <class T>
  T argument(const T& x) const {
    switch (g) {
      case inner::exponential:
        return exp(x);
      case inner::cube:
        return T(pow(x, 3));
      case inner::inverse:
        return T(1 / x);
      case inner::sinus_hyperbolicus:
        return sinh(x);
      case inner::logarithm:
        return log(x);
      case inner::arc_tangent:
        return atan(x);
      default:
        return x;
    }
  }
  template <class T>
  T operator()(const T& x) const {
    T value = T(x * 0 + 1);
    const T y = argument(x);
    for (const auto& [r, m] : factors) value = T(value * pow(T(y - r), m));
    if (square_root) value = T(value * T(square(x) - *square_root));
    if (by == disguise::exponential) value = T(value * exp(x));
    if (by == disguise::quadratic) value = T(value * T(square(x) + 1));
    if (by == disguise::cosine) value = T(value * T(2 + cos(x)));
    if (pole) value = T(value / pow(T(x - pole->first), pole->second));
    return value;
  }

  [[nodiscard]] std::vector<known_root> roots() const {
    std::vector<known_root> result;
    for (const auto& [q, m] : factors) {
      const rational r = q;
      const auto add = [&, m = m](std::function<ball(const ball&)> inverse) {
        result.push_back({[r, inverse](precision p) { return inverse(ball(r, p)); }, {}, m});
      };
      switch (g) {
        case inner::identity:
          result.push_back(exactly(r, m));
          break;
        case inner::exponential:
          if (r > 0) add([](const ball& t) { return log(t); });
          break;
        case inner::cube:
          if (r == 0) {
            result.push_back(exactly(0, 3 * m));
          } else {
            add([](const ball& t) { return root(t, 3); });
          }
          break;
        case inner::inverse:
          if (r != 0) result.push_back(exactly(1 / r, m));
          break;
        case inner::sinus_hyperbolicus:
          add([](const ball& t) { return asinh(t); });
          break;
        case inner::logarithm:
          add([](const ball& t) { return exp(t); });
          break;
        case inner::arc_tangent:
          if (abs(r) < rational(157, 100)) add([](const ball& t) { return tan(t); });
          break;
      }
    }
    if (square_root) {
      const rational a = *square_root;
      result.push_back({[a](precision p) { return sqrt(ball(a, p)); }, {}, 1});
      result.push_back({[a](precision p) { return -sqrt(ball(a, p)); }, {}, 1});
    }
    return result;
  }

  [[nodiscard]] std::string described() const {
    std::ostringstream text;
    for (const auto& [r, m] : factors) text << "(g - " << to_text(r) << ")^" << m << ' ';
    if (square_root) text << "(x^2 - " << to_text(*square_root) << ") ";
    if (pole) text << "/ (x - " << to_text(pole->first) << ")^" << pole->second;
    text << " g " << static_cast<int>(g) << " by " << static_cast<int>(by);
    return text.str();
  }
};

struct made_problem {
  made_function f;
  end_point lower = 0;
  end_point upper = 1;
  std::vector<known_root> roots;  // of f, in the interval or not
  std::string text;
};

class problem_maker {
 public:
  explicit problem_maker(random_source& random) : random_(random) {}

  made_problem any() {
    made_problem p;
    made_function& f = p.f;
    f.g = static_cast<inner>(random_.between(0, 6));
    f.by = static_cast<disguise>(random_.between(0, 3));
    const rational centre = any_number();
    for (long n = random_.between(1, 4); n > 0; --n) {
      const rational r = random_.one_in(3) ? any_number() : near(centre);
      const auto same = [&](const auto& known) { return known.first == r; };
      if (std::any_of(f.factors.begin(), f.factors.end(), same)) continue;
      f.factors.emplace_back(r, random_.one_in(2) ? 1 : random_.between(1, 6));
    }
    if (f.g == inner::identity && random_.one_in(3)) {
      // An irrational root with a rational one beside it, which is short.
      f.square_root = random_.choose(std::array{rational(2), rational(3), rational(7, 5)});
      const ball s = sqrt(ball(*f.square_root, 400));
      const rational by = ten_to_minus(random_.between(1, 30));
      const rational beside = simplest_between(lower_rational(s) - by, upper_rational(s) + by);
      const auto same = [&](const auto& known) { return known.first == beside; };
      if (std::none_of(f.factors.begin(), f.factors.end(), same)) {
        f.factors.emplace_back(beside, random_.between(1, 4));
      }
    }
    if (random_.one_in(4)) {
      const rational at = any_number();
      const auto same = [&](const auto& known) { return known.first == at; };
      // A pole at a root is a removable singularity: another matter.
      if (f.g == inner::identity && std::none_of(f.factors.begin(), f.factors.end(), same)) {
        f.pole.emplace(at, random_.between(1, 3));
      }
    }
    p.roots = f.roots();
    p.lower = any_end(p.roots);
    p.upper = any_end(p.roots);
    if (certainly_less(p.upper.at(truth_bits), p.lower.at(truth_bits))) std::swap(p.lower, p.upper);
    p.text = f.described() + " in " + to_decimal(p.lower.at(200), 40) + " .. " +
             to_decimal(p.upper.at(200), 40);
    return p;
  }

 private:
  rational any_number() { return {random_.between(-30, 30), random_.between(1, 12)}; }
  rational near(const rational& x) {
    return x + random_.between(-3, 3) * ten_to_minus(random_.between(0, 40));
  }
  end_point any_end(const std::vector<known_root>& roots) {
    if (roots.empty() || random_.one_in(2)) {
      return {rational(random_.between(-4000, 4000), 100)};
    }
    const known_root& r = random_.choose(roots);
    const rational by = random_.between(-1, 1) * ten_to_minus(random_.between(1, 30));
    if (r.exact) return {rational(*r.exact + by)};
    return end_point([at = r.at, by](precision p) { return at(p) + by; });
  }

  random_source& random_;
};

enum class side { inside, outside, at_an_end };
side side_of(const known_root& r, const end_point& lower, const end_point& upper) {
  const ball x = r.at(truth_bits);
  const ball low = lower.at(truth_bits);
  const ball high = upper.at(truth_bits);
  if (certainly_less(x, low) || certainly_less(high, x)) return side::outside;
  const bool in = r.exact && lower.exact() && upper.exact();
  return in || (certainly_less(low, x) && certainly_less(x, high)) ? side::inside : side::at_an_end;
}

/// What is wrong with the answer; empty where nothing is.
std::string fault_of(const root_set& s, const std::vector<known_root>& roots,
                     const end_point& lower, const end_point& upper) {
  if (s.identically_zero) return "said to be 0 everywhere";
  std::vector<bool> is_listed(roots.size(), false);
  for (std::size_t i = 0; i < s.regions.size(); ++i) {
    const root_region& r = s.regions[i];
    const bool is_proved = r.multiplicity > 0;
    std::vector<std::size_t> held;
    for (std::size_t k = 0; k < roots.size(); ++k) {
      if (!overlaps(r.enclosure, roots[k].at(truth_bits))) continue;
      held.push_back(k);
      if (is_proved && is_listed[k]) return "a root is listed twice";
      is_listed[k] = true;
    }
    if (r.verdict == root_verdict::at_least_one && held.empty()) return "no root where one is said";
    if (r.complex_roots && *r.complex_roots < static_cast<long>(held.size())) {
      return "fewer complex roots than real ones";
    }
    if (!is_proved) continue;
    if (held.size() != 1) return "not one root in the region of one";
    const known_root& known = roots[held.front()];
    const ball x = known.at(truth_bits);
    if (known.multiplicity != r.multiplicity) return "another multiplicity";
    if (side_of(known, lower, upper) == side::outside) return "a root beyond the interval";
    const refined_root refined = refine(r, 40);
    if (!overlaps(refined.enclosure, x)) return "refined to another number";
    if (refined.exact && !contains(x, *refined.exact)) return "another exact root";
    if (i > 0 && s.regions[i - 1].multiplicity > 0 &&
        overlaps(s.regions[i - 1].enclosure, r.enclosure)) {
      return "enclosures overlap";
    }
  }
  for (std::size_t k = 0; k < roots.size(); ++k) {
    if (!is_listed[k] && side_of(roots[k], lower, upper) == side::inside) return "a root is lost";
  }
  return {};
}

TEST(RootAdversary, FunctionsWithKnownRoots) {
  random_source random(20);
  long resolved = 0;
  long all = 0;
  for (repeat trial(250); trial.again(); ++all) {
    const made_problem p = problem_maker(random).any();
    const root_set s =
        isolate_roots(p.f, p.lower, p.upper, {.most_boxes = 2000, .most_unresolved = 200});
    EXPECT_EQ(fault_of(s, p.roots, p.lower, p.upper), "") << p.text;
    for (const singular_place& place : s.singular) {
      if (place.pole_order == 0) continue;
      const bool is_pole = p.f.pole && contains(place.place, p.f.pole->first) &&
                           place.pole_order == p.f.pole->second;
      EXPECT_TRUE(is_pole || p.f.g == inner::inverse) << p.text;
    }
    if (s.is_resolved()) ++resolved;
  }
  EXPECT_GE(2 * resolved, all);  // it is no test of the refusals
}

/// sin, cos or tan of kx, squared or not, between multiples of pi.
TEST(RootAdversary, RootsAtMultiplesOfPi) {
  random_source random(21);
  for (repeat trial(60); trial.again();) {
    const rational k(random.between(1, 20), random.between(1, 5));
    const long m = random.between(1, 4);
    const int which = static_cast<int>(random.between(0, 2));
    const rational shift = which == 1 ? rational(1, 2) : rational(0);
    const long first = random.between(-6, 3);
    const long last = first + random.between(0, 8);
    const auto end = [&](long n) { return end_point(pi_combination{0, (n + shift) / k}); };
    const auto f = [&](const auto& x) {
      using T = std::remove_cvref_t<decltype(x)>;
      const T y = T(k * x);
      return pow(which == 0 ? T(sin(y)) : (which == 1 ? T(cos(y)) : T(tan(y))), m);
    };
    const root_set s = isolate_roots(f, end(first), end(last), {.most_boxes = 5000});
    std::vector<known_root> roots;
    for (long n = first - 3; n <= last + 3; ++n) {
      roots.push_back({[=](precision p) { return (n + shift) / k * pi(p); }, std::nullopt, m});
    }
    EXPECT_EQ(fault_of(s, roots, end(first), end(last)), "") << k << ' ' << first << ' ' << last;
    if (!s.is_resolved()) continue;
    EXPECT_EQ(s.regions.size(), static_cast<std::size_t>(last - first + 1));
  }
}

// ---------------------------------------------------------------------------------------------
// What was wrong once

// The root of one factor lies in the first enclosure of another's, at an end of the interval.
TEST(RootAdversary, AnEndThatIsARootOfAnotherFactor) {
  const rational end(14143, 10000);
  const root_set s =
      isolate_roots([&](const auto& x) { return (square(x) - 2) * square(x - end); }, 0, end);
  ASSERT_EQ(s.regions.size(), 2U);
  EXPECT_TRUE(s.is_resolved());
  EXPECT_TRUE(overlaps(s.regions[0].enclosure, sqrt(ball(2, 300))));
  EXPECT_FALSE(s.regions[0].exact.has_value());
  EXPECT_EQ(s.regions[1].exact, end);
  EXPECT_EQ(s.regions[1].multiplicity, 2);
}

// A short rational root 1e-40 beside the one that is refined, which has another multiplicity.
TEST(RootAdversary, ARootBesideIsNotTheRoot) {
  const rational beside(25, 4);
  const rational r = beside - ten_to_minus(40);
  for (const long digits : {1L, 20L, 30L, 60L}) {
    const root_set s =
        isolate_roots([&](const auto& x) { return cosh(x) * (x - beside) * pow(x - r, 4); }, 0, 10);
    ASSERT_EQ(s.regions.size(), 2U);
    const refined_root low = refine(s.regions[0], digits);
    EXPECT_EQ(s.regions[0].multiplicity, 4);
    EXPECT_TRUE(contains(low.enclosure, r)) << digits;
    EXPECT_TRUE(!low.exact || *low.exact == r) << digits;
    const refined_root high = refine(s.regions[1], digits);
    EXPECT_TRUE(contains(high.enclosure, beside));
    EXPECT_TRUE(!high.exact || *high.exact == beside);
  }
}

TEST(RootAdversary, AnEssentialSingularityIsNoPole) {
  for (const root_set& s :
       {isolate_roots([](const auto& x) { return exp(1 / x) / x; }, -1, 1),
        isolate_roots([](const auto& x) { return exp(-1 / square(x)) / x; }, -1, 1),
        isolate_roots([](const auto& x) { return 1 / (x * exp(1 / x)); }, -1, 1)}) {
    EXPECT_TRUE(s.is_resolved());
    EXPECT_TRUE(s.regions.empty());
    ASSERT_FALSE(s.singular.empty());
    for (const singular_place& place : s.singular) EXPECT_EQ(place.pole_order, 0);
  }
}

// 2x + 10 arctan(1/(5 - x)) falls by 10 pi at 5, and has there no derivative; that of its pieces is
// positive.
TEST(RootAdversary, AJumpTowardsInfinityBetweenWhichItRises) {
  const auto f =
      real_function::with_derivative([](const ball& x) { return 2 * x + 10 * atan(1 / (5 - x)); },
                                     [](const ball& x) { return 2 + 10 / (square(5 - x) + 1); });
  const root_set s = isolate_roots(f, 1, end_point::infinity());
  const ball about = ball(rational(552, 100), 64).enlarged(magnitude::power_of_two(-5));
  EXPECT_TRUE(std::any_of(s.regions.begin(), s.regions.end(),
                          [&](const root_region& r) { return overlaps(r.enclosure, about); }));
}

TEST(RootAdversary, InexactEndsInTheWrongOrder) {
  const auto end = [](const rational& by) {
    return end_point([by](precision p) { return sqrt(ball(2, p)) + by; });
  };
  const auto f = [](const auto& x) { return x; };
  EXPECT_THROW((void)isolate_roots(f, end(ten_to_minus(60)), end(0)), input_error);
  EXPECT_NO_THROW((void)isolate_roots(f, end(0), end(ten_to_minus(60))));
  EXPECT_NO_THROW((void)isolate_roots(f, end(0), end(0)));
}

// ---------------------------------------------------------------------------------------------
// Systems

/// p(x) = 0 and y = q(x), mixed by a regular matrix: the solutions are (r, q(r)) for the roots r of
/// p.
struct made_system {
  std::vector<rational> roots;
  std::array<rational, 3> q;
  std::array<long, 4> matrix{};

  [[nodiscard]] rational y_of(const rational& x) const { return q[0] + x * (q[1] + x * q[2]); }
  template <class X>
  X operator()(const X& x) const {
    auto p = x[0] - roots.front();
    for (std::size_t k = 1; k < roots.size(); ++k) p = p * (x[0] - roots[k]);
    const auto y = x[1] - (q[0] + x[0] * (q[1] + x[0] * q[2]));
    return {matrix[0] * p + matrix[1] * y, matrix[2] * p + matrix[3] * y};
  }
};

TEST(RootAdversary, SystemsWithKnownSolutions) {
  random_source random(22);
  long resolved = 0;
  long all = 0;
  for (repeat trial(60); trial.again(); ++all) {
    made_system f;
    const rational centre(random.between(-12, 12), random.between(1, 6));
    for (long n = random.between(1, 3); n > 0; --n) {
      const rational r = random.one_in(2)
                             ? rational(random.between(-12, 12), random.between(1, 6))
                             : centre + random.between(-2, 2) * ten_to_minus(random.between(0, 8));
      if (std::find(f.roots.begin(), f.roots.end(), r) == f.roots.end()) f.roots.push_back(r);
    }
    if (random.one_in(8)) f.roots.push_back(f.roots.front());  // singular
    for (rational& c : f.q) c = rational(random.between(-6, 6), random.between(1, 4));
    do {
      for (long& a : f.matrix) a = random.between(-3, 3);
    } while (f.matrix[0] * f.matrix[3] == f.matrix[1] * f.matrix[2]);
    // The faces go through solutions now and then.
    const auto any_end = [&](const std::function<rational(const rational&)>& of, long most) {
      return random.one_in(3) ? of(random.choose(f.roots))
                              : rational(random.between(-10 * most, 10 * most), 10);
    };
    std::pair<rational, rational> x{any_end([](const rational& r) { return r; }, 14),
                                    any_end([](const rational& r) { return r; }, 14)};
    std::pair<rational, rational> y{any_end([&](const rational& r) { return f.y_of(r); }, 400),
                                    any_end([&](const rational& r) { return f.y_of(r); }, 400)};
    if (x.second < x.first) std::swap(x.first, x.second);
    if (y.second < y.first) std::swap(y.first, y.second);
    const system_root_set s = solve_system(f, {x, y}, {.most_boxes = 3000, .most_halvings = 30});
    if (s.is_resolved()) ++resolved;
    std::ostringstream text;
    for (const rational& r : f.roots) text << r << ' ';
    text << "in " << x.first << ' ' << x.second << ' ' << y.first << ' ' << y.second;
    std::sort(f.roots.begin(), f.roots.end());
    const bool is_singular = std::adjacent_find(f.roots.begin(), f.roots.end()) != f.roots.end();
    f.roots.erase(std::unique(f.roots.begin(), f.roots.end()), f.roots.end());
    std::vector<long> proved(f.roots.size(), 0);
    std::vector<bool> held(f.roots.size(), false);
    for (const system_region& r : s.regions) {
      long here = 0;
      for (std::size_t k = 0; k < f.roots.size(); ++k) {
        if (!contains(r.enclosure[0], f.roots[k]) ||
            !contains(r.enclosure[1], f.y_of(f.roots[k]))) {
          continue;
        }
        ++here;
        held[k] = true;
        if (r.verdict == root_verdict::unique) ++proved[k];
      }
      EXPECT_TRUE(r.verdict != root_verdict::unique || here == 1) << text.str();
    }
    for (std::size_t k = 0; k < f.roots.size(); ++k) {
      const rational at = f.y_of(f.roots[k]);
      const bool inside =
          x.first <= f.roots[k] && f.roots[k] <= x.second && y.first <= at && at <= y.second;
      EXPECT_TRUE(!inside || held[k]) << f.roots[k] << " is lost: " << text.str();
      EXPECT_LE(proved[k], 1) << text.str();
      EXPECT_TRUE(!is_singular || f.roots.size() > 1 || proved[k] == 0) << text.str();
    }
  }
  EXPECT_GE(3 * resolved, all);
}

TEST(RootAdversary, LinearSystems) {
  random_source random(23);
  for (repeat trial(40); trial.again();) {
    const auto n = static_cast<std::size_t>(random.between(2, 4));
    std::vector<std::vector<rational>> a(n, std::vector<rational>(n));
    std::vector<rational> solution(n);
    std::vector<rational> b(n);
    for (std::size_t i = 0; i < n; ++i) {
      solution[i] = rational(random.between(-30, 30), random.between(1, 9));
      for (rational& entry : a[i]) entry = rational(random.between(-9, 9), random.between(1, 3));
      a[i][i] += random.one_in(2) ? 40 : -40;  // regular
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) b[i] += a[i][j] * solution[j];
    }
    const auto f = [&](const auto& x) {
      using T = std::remove_cvref_t<decltype(x[0])>;
      std::vector<T> r;
      for (std::size_t i = 0; i < n; ++i) {
        T sum = T(x[0] * a[i][0] - b[i]);
        for (std::size_t j = 1; j < n; ++j) sum = T(sum + x[j] * a[i][j]);
        r.push_back(sum);
      }
      return r;
    };
    system_box box;
    bool inside = true;
    bool on_face = false;
    for (const rational& s : solution) {
      rational low(random.between(-400, 100), 10);
      rational high = low + rational(random.between(1, 800), 10);
      if (random.one_in(10)) low = std::min(s, high);
      inside = inside && low <= s && s <= high;
      on_face = on_face || low == s || s == high;
      box.emplace_back(low, high);
    }
    const system_root_set s = solve_system(f, box);
    EXPECT_TRUE(s.complete);
    ASSERT_EQ(s.regions.size(), inside ? 1U : s.regions.size());
    EXPECT_TRUE(inside || on_face || s.regions.empty());
    for (const system_region& r : s.regions) {
      EXPECT_EQ(r.verdict, root_verdict::unique);
      for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(contains(r.enclosure[i], solution[i]));
    }
  }
}

TEST(RootAdversary, ACurveOfSolutionsIsLeftOpenAsAWhole) {
  const auto f = [](const auto& x) {
    const auto circle = square(x[0]) + square(x[1]) - 1;
    return std::vector{circle, circle * (x[0] + 3)};
  };
  for (const long most_boxes : {20L, 500L}) {
    const system_root_set s =
        solve_system(f, {{-2, 2}, {-2, 2}}, {.most_boxes = most_boxes, .most_halvings = 5});
    EXPECT_FALSE(s.is_resolved());
    // Points with rational coordinates.
    for (long t = -20; t <= 20; ++t) {
      const rational u(t, 7);
      const rational x = (1 - u * u) / (1 + u * u);
      const rational y = 2 * u / (1 + u * u);
      EXPECT_TRUE(std::any_of(s.regions.begin(), s.regions.end(), [&](const system_region& r) {
        return contains(r.box[0], x) && contains(r.box[1], y);
      })) << u;
    }
  }
}

}  // namespace adversary_test
}  // namespace polhode
