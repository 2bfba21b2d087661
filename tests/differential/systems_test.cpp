// Systems of equations: products of factors in linear functions of the variables, mixed with one
// another, whose roots are known, of which all in the box must be found and no others, each in one
// region; and random ones with one root that was planted in them, which must not be lost, nor be
// found twice, and where a root is claimed the equations change their signs.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "maker.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/roots/systems.hpp"
#include "tally.hpp"

namespace polhode::differential {
namespace systems_test {

using point = std::vector<rational>;
using square_matrix = std::vector<point>;

/// A function of t that is 0 at 0 alone, where its slope is positive, but for the square.
enum class shape { line, exponential, hyperbolic_sine, cubic, arc_tangent, square };

struct system_factor {
  shape what = shape::line;
  rational root;
};

/// mixed * (product of the factors of u_i, for each i) = 0, where u = lower upper x + shift. The
/// matrices are triangular with ones in their diagonals, so that x is found from u.
struct system_case {
  square_matrix lower;
  square_matrix upper;
  point shift;
  square_matrix mixed;
  std::vector<std::vector<system_factor>> factors;
  system_box box;

  template <class T>
  std::vector<T> operator()(const std::vector<T>& x) const {
    const std::size_t n = x.size();
    std::vector<T> y;
    for (std::size_t i = 0; i < n; ++i) {
      T sum = x[i];
      for (std::size_t j = i + 1; j < n; ++j) sum = sum + x[j] * upper[i][j];
      y.push_back(sum);
    }
    std::vector<T> value;
    for (std::size_t i = 0; i < n; ++i) {
      T u = y[i] + shift[i];
      for (std::size_t j = 0; j < i; ++j) u = u + y[j] * lower[i][j];
      T all = at(factors[i][0], u);
      for (std::size_t k = 1; k < factors[i].size(); ++k) all = all * at(factors[i][k], u);
      value.push_back(all);
    }
    std::vector<T> result;
    for (std::size_t i = 0; i < n; ++i) {
      T sum = value[i];
      for (std::size_t j = 0; j < i; ++j) sum = sum + value[j] * mixed[i][j];
      result.push_back(sum);
    }
    return result;
  }

  struct known_root {
    point at;
    bool is_multiple;
  };
  /// Of all combinations of factors, in the box or not.
  [[nodiscard]] std::vector<known_root> roots() const {
    const std::size_t n = factors.size();
    std::vector<known_root> found;
    std::vector<std::size_t> which(n, 0);
    for (;;) {
      point y(n);
      bool is_multiple = false;
      for (std::size_t i = 0; i < n; ++i) {
        is_multiple = is_multiple || factors[i][which[i]].what == shape::square;
        y[i] = factors[i][which[i]].root - shift[i];
        for (std::size_t j = 0; j < i; ++j) y[i] -= lower[i][j] * y[j];
      }
      for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = i + 1; j < n; ++j) y[i] -= upper[i][j] * y[j];
      }
      found.push_back({std::move(y), is_multiple});
      std::size_t i = 0;
      while (i < n && ++which[i] == factors[i].size()) which[i++] = 0;
      if (i == n) return found;
    }
  }
  [[nodiscard]] bool is_in_box(const point& x) const {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto& [low, high] = box[i];
      if ((low && x[i] < *low) || (high && x[i] > *high)) return false;
    }
    return true;
  }

 private:
  template <class T>
  static T at(const system_factor& f, const T& u) {
    const T t = u - f.root;
    switch (f.what) {
      case shape::exponential:
        return exp(t) - 1;
      case shape::hyperbolic_sine:
        return sinh(t);
      case shape::cubic:
        return t * (1 + square(t));
      case shape::arc_tangent:
        return atan(t);
      case shape::square:
        return square(t);
      case shape::line:
        break;
    }
    return t;
  }
};

square_matrix any_matrix(maker& m, std::size_t n) {
  square_matrix a(n, point(n));
  for (point& row : a) {
    for (rational& q : row)
      q = m.one_in(2) ? rational(0) : rational(m.between(-6, 6), m.between(2, 5));
  }
  return a;
}

enum class kind { any, polynomials, multiple_roots };

/// Of polynomials alone, on the whole space, where so asked for; with squares of factors.
system_case any_system(maker& m, kind what = kind::any) {
  const bool polynomials = what != kind::any;
  const std::size_t n = m.one_in(what == kind::multiple_roots ? 10 : 4) ? 3 : 2;
  system_case c{any_matrix(m, n), any_matrix(m, n), {}, any_matrix(m, n), {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    c.shift.emplace_back(m.between(-8, 8), 8);
    std::vector<system_factor> own;
    const long count = m.between(1, what == kind::multiple_roots || n > 2 ? 2 : 3);
    for (long k = 0; k < count; ++k) {
      rational root(m.between(-20, 20), 10);
      // At times two roots are close together.
      if (k > 0 && m.one_in(4)) root = own[0].root + rational(1, 1L << m.between(2, 16));
      const bool is_new = std::none_of(own.begin(), own.end(),
                                       [&](const system_factor& f) { return f.root == root; });
      if (!is_new) continue;
      own.push_back({what == kind::multiple_roots && m.one_in(3) ? shape::square
                     : polynomials
                         ? shape::line
                         : m.any_of({shape::line, shape::line, shape::exponential,
                                     shape::hyperbolic_sine, shape::cubic, shape::arc_tangent}),
                     root});
    }
    c.factors.push_back(std::move(own));
    c.box.emplace_back(rational(m.between(-40, -1), 10), rational(m.between(1, 40), 10));
  }
  if (what == kind::polynomials || (polynomials && m.one_in(3))) {
    c.box.assign(n, {});
    return c;
  }
  // At times a root is on a face, or in a corner.
  if (m.one_in(4)) {
    const auto roots = c.roots();
    const point& x =
        roots[static_cast<std::size_t>(m.between(0, static_cast<long>(roots.size()) - 1))].at;
    for (std::size_t i = 0; i < n; ++i) {
      if (x[i] > *c.box[i].first && m.one_in(2)) c.box[i].second = x[i];
    }
  }
  for (system_side& side : c.box) {
    if (m.one_in(8)) side.first = std::nullopt;
    if (m.one_in(8)) side.second = std::nullopt;
  }
  return c;
}

std::string text_of(const point& x) {
  std::string text;
  for (const rational& q : x) text += (text.empty() ? "(" : ", ") + q.str();
  return text + ")";
}

bool holds(const std::vector<ball>& box, const point& x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!contains(box[i], x[i])) return false;
  }
  return true;
}

/// What is wrong in the answer, in words.
std::optional<std::string> error_in(const system_case& c, const system_root_set& s) {
  const auto roots = c.roots();
  for (const auto& [x, is_multiple] : roots) {
    long claimed = 0;
    long open = 0;
    for (const system_region& r : s.regions) {
      if (!is_one_root(r.verdict)) {
        if (holds(r.box, x)) ++open;
      } else if (holds(r.enclosure, x)) {
        ++claimed;
        if (is_multiple != (r.verdict == root_verdict::multiple)) {
          return "the root " + text_of(x) + " is said to be " + to_text(r.verdict);
        }
      }
    }
    if (claimed > 1)
      return "the root " + text_of(x) + " is counted " + std::to_string(claimed) + " times";
    // Where a limit was reached the boxes that are left are regions too.
    if (claimed + open == 0 && c.is_in_box(x)) {
      return "the root " + text_of(x) + " is missing";
    }
  }
  for (const system_region& r : s.regions) {
    if (!is_one_root(r.verdict)) continue;
    const auto count =
        std::ranges::count_if(roots, [&](const auto& x) { return holds(r.enclosure, x.at); });
    if (count != 1) return fmt::format("a region of one root holds {}", count);
    const refined_system_root fine = refine(real_system(c, c.box.size()), r, 60);
    const auto left =
        std::ranges::count_if(roots, [&](const auto& x) { return holds(fine.enclosure, x.at); });
    if (left != 1) return fmt::format("a region of one root, refined, holds {}", left);
  }
  return std::nullopt;
}

/// Polynomials of degree 2, multiples of sin(k (x_j - r_j)) and of e^(x_j - r_j) - 1, of which each
/// is 0 at the root r.
struct planted_case {
  struct monomial {
    rational factor;
    std::size_t i, j;  // x_i x_j, or x_i where j is none of the variables
  };
  struct wave {
    rational factor;
    long frequency;
    std::size_t j;
    bool is_exponential;
  };
  struct equation {
    std::vector<monomial> monomials;
    std::vector<wave> waves;
  };
  point root;
  std::vector<equation> equations;
  system_box box;

  template <class T>
  std::vector<T> operator()(const std::vector<T>& x) const {
    std::vector<T> result;
    for (const equation& e : equations) {
      T sum = x[0] * 0;
      for (const monomial& m : e.monomials) {
        if (m.j < x.size()) {
          sum = sum + (x[m.i] * x[m.j] - rational(root[m.i] * root[m.j])) * m.factor;
        } else {
          sum = sum + (x[m.i] - root[m.i]) * m.factor;
        }
      }
      for (const wave& w : e.waves) {
        const T t = x[w.j] - root[w.j];
        sum = sum + (w.is_exponential ? exp(t) - 1 : sin(t * w.frequency)) * w.factor;
      }
      result.push_back(sum);
    }
    return result;
  }
};

planted_case any_planted(maker& m) {
  const long n = m.one_in(4) ? 3 : 2;
  const auto any_variable = [&] { return static_cast<std::size_t>(m.between(0, n - 1)); };
  const auto any_factor = [&] {
    const rational q(m.between(1, 12), m.between(1, 5));
    return m.one_in(2) ? q : rational(-q);
  };
  planted_case c;
  for (long i = 0; i < n; ++i) {
    c.root.emplace_back(m.between(-30, 30), m.between(7, 16));
    planted_case::equation e;
    for (long k = m.between(1, 4); k > 0; --k) {
      e.monomials.push_back({any_factor(), any_variable(),
                             m.one_in(3) ? static_cast<std::size_t>(n) : any_variable()});
    }
    for (long k = m.between(0, 2); k > 0; --k) {
      e.waves.push_back({any_factor(), m.between(1, 3), any_variable(), m.one_in(2)});
    }
    c.equations.push_back(std::move(e));
    // At times the root is on a face.
    const rational& r = c.root.back();
    c.box.emplace_back(m.one_in(12) ? r : rational(r - rational(m.between(1, 40), 10)),
                       m.one_in(12) ? r : rational(r + rational(m.between(1, 40), 10)));
    if (m.one_in(10)) c.box.back().first = std::nullopt;
    if (m.one_in(10)) c.box.back().second = std::nullopt;
  }
  return c;
}

/// Numbers near the inverse of J at a point.
square_matrix near_inverse(const real_system& f, const std::vector<ball>& x) {
  square_matrix result;
  for (const std::vector<ball>& row : krawczyk(f, x, 120).preconditioner) {
    result.emplace_back();
    for (const ball& q : row) result.back().push_back(lower_rational(q.middle()));
  }
  return result;
}

enum class shown { root, no_root, nothing };

/// C. Miranda, 1940: g has a zero in a box if each g_i has opposite signs on the two faces x_i =
/// c_i +- r. Here g = Y f, which is nearly x - c where c is nearly a root, so that a part of a face
/// with the other sign shows that it is none. Each face is cut into so many parts in every
/// direction; nothing is shown where the signs on them are not all known.
shown by_signs(const real_system& f, const square_matrix& y, const std::vector<ball>& centre,
               const rational& r, long parts) {
  const std::size_t n = centre.size();
  long count = 1;
  for (std::size_t i = 1; i < n; ++i) count *= parts;
  for (std::size_t i = 0; i < n; ++i) {
    for (const long side : {-1L, 1L}) {
      for (long k = 0; k < count; ++k) {
        std::vector<ball> x = centre;
        long rest = k;
        for (std::size_t j = 0; j < n; ++j) {
          if (j == i) {
            x[j] += ball(rational(side * r), 160);
            continue;
          }
          const rational low = r * rational(2 * (rest % parts) - parts, parts);
          x[j] += hull(ball(low, 160), ball(rational(low + 2 * r / parts), 160));
          rest /= parts;
        }
        const std::vector<ball> value = f(x);
        ball g(0, 160);
        for (std::size_t j = 0; j < n; ++j) g += value[j] * y[i][j];
        if (side > 0) g = -g;
        if (certainly_positive(g)) return shown::no_root;
        if (!certainly_negative(g)) return shown::nothing;
      }
    }
  }
  return shown::root;
}

shown by_signs(const real_system& f, const std::vector<ball>& enclosure) {
  std::vector<ball> centre;
  for (const ball& x : enclosure) centre.push_back(x.with_precision(160).middle());
  const square_matrix y = near_inverse(f, centre);
  if (y.empty()) return shown::nothing;
  const long most_parts = centre.size() == 2 ? 2048 : 32;
  for (long parts = 2; parts <= most_parts; parts *= 4) {
    const shown found = by_signs(f, y, centre, rational(1, integer(1) << 80U), parts);
    if (found != shown::nothing) return found;
  }
  return shown::nothing;
}

void find_known_roots(const char* family, kind what) {
  run_cases("roots", family, 60, [what](std::uint64_t seed, counts& c) {
    maker m(seed);
    const system_case given = any_system(m, what);
    under_way(fmt::format("a system with the seed {}", seed));
    ++c.cases;
    const system_root_set s =
        solve_system(given, given.box, {.most_boxes = 3'000, .most_halvings = 30});
    ++c.computed;
    ++(s.is_resolved() ? c.certified : c.refused);
    c.checks += static_cast<long>(given.roots().size() + s.regions.size());
    if (const auto error = error_in(given, s)) {
      ++c.wrong;
      ADD_FAILURE() << "with the seed " << seed << ": " << *error;
    }
  });
}

TEST(systems, have_the_known_roots_and_no_others) {
  find_known_roots("systems with known roots", kind::any);
}
TEST(systems, of_polynomials_have_the_known_roots_and_no_others) {
  find_known_roots("polynomial systems on the whole space", kind::polynomials);
}
TEST(systems, of_polynomials_have_the_known_multiple_roots) {
  find_known_roots("polynomial systems with multiple roots", kind::multiple_roots);
}

/// p x^2 + q y^2 = s and x y = t, p q = k^2, in other variables: they touch where s = 2 k |t|, at
/// irrational points as a rule. With s a little greater there are four simple roots in two pairs,
/// with s a little less there is none.
TEST(systems, of_conics_that_touch_or_nearly_do) {
  run_cases("roots", "conics that touch", 60, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const auto any = [&] { return rational(m.between(1, 30), m.between(1, 12)); };
    const rational p = any();
    const rational k = any();
    const rational q = k * k / p;
    const rational t = m.one_in(2) ? any() : rational(-any());
    const long side = m.between(-1, 1);
    const rational near(integer(1),
                        integer(integer(1) << static_cast<unsigned>(m.between(2, 200))));
    const rational s = 2 * k * abs(t) * (1 + side * near);
    const rational turn(m.between(-3, 3), 2);
    const rational shift(m.between(-3, 3), m.between(1, 3));
    const auto f = [&](const auto& z) {
      const auto x = z[0] + turn * z[1];
      const auto y = z[1] - turn * z[0] + shift;
      using scalar = std::decay_t<decltype(z[0])>;
      return std::vector<scalar>{p * square(x) + q * square(y) - s, x * y - t};
    };
    ++c.cases;
    under_way(fmt::format("conics with the seed {}", seed));
    const system_box box(2);
    const system_root_set found = solve_system(f, box, {.most_boxes = 3'000});
    ++c.computed;
    ++(found.is_resolved() ? c.certified : c.refused);
    const long expected = side < 0 ? 0 : side == 0 ? 2 : 4;
    const auto verdict = side == 0 ? root_verdict::multiple : root_verdict::unique;
    long claimed = 0;
    long open = 0;
    for (const system_region& r : found.regions) {
      if (!is_one_root(r.verdict)) {
        ++open;
        continue;
      }
      ++claimed;
      ++c.checks;
      const refined_system_root fine = refine(real_system(f, 2), r, 80);
      const std::vector<ball> values = f(fine.enclosure);
      const bool is_root = r.verdict == verdict && std::ranges::all_of(values, [](const ball& v) {
                             return contains_zero(v) && v.radius() < magnitude::power_of_two(-200);
                           });
      if (is_root) continue;
      ++c.wrong;
      ADD_FAILURE() << "with the seed " << seed << ": " << to_text(r.verdict);
    }
    ++c.checks;
    if (open == 0 ? claimed == expected : claimed <= expected) return;
    ++c.wrong;
    ADD_FAILURE() << "with the seed " << seed << ": " << claimed << " roots, not " << expected;
  });
}

/// v = g(u), and a product of u - r_1, ..., or of their squares, with what is positive, or with a
/// multiple of v - g added: the zeros are the points (r_i, g(r_i)) at which g is defined.
struct explicit_case {
  enum class form { parabola, pole, kink, branch, exponential };
  form what = form::parabola;
  rational a, b, s;
  std::vector<std::pair<rational, bool>> roots;  // with a square
  long mixed = 0;
  bool turned = false;  // u is the second variable
  system_box box;

  template <class T>
  T g(const T& u) const {
    switch (what) {
      case form::pole:
        return a / (u - s) + b;
      case form::kink:
        return a * abs(u - s) + b;
      case form::branch:
        return a * sqrt(u - s) + b;
      case form::exponential:
        return a * exp(u - s) + b * u;
      case form::parabola:
        break;
    }
    return a * square(u) + b * u;
  }
  template <class T>
  std::vector<T> operator()(const std::vector<T>& x) const {
    const T& u = x[turned ? 1 : 0];
    const T& v = x[turned ? 0 : 1];
    T product = exp(u);
    for (const auto& [r, is_square] : roots) {
      product = product * (is_square ? square(u - r) : T(u - r));
    }
    const T difference = v - g(u);
    switch (mixed) {
      case 1:
        product = product * (1 + square(v));
        break;
      case 2:
        product = product * exp(v / 3);
        break;
      case 3:
        product = product + difference * (v + 3);
        break;
      default:
        break;
    }
    return {difference * rational(3, 2), product};
  }
};

explicit_case any_explicit(maker& m) {
  explicit_case c;
  c.what =
      m.any_of({explicit_case::form::parabola, explicit_case::form::pole, explicit_case::form::kink,
                explicit_case::form::branch, explicit_case::form::exponential});
  const auto any = [&] { return rational(m.between(-12, 12), m.between(1, 4)); };
  c.a = any() + rational(1, 5);
  c.b = any();
  c.s = rational(m.between(-3, 3), 2);
  for (long k = m.between(1, 3); k > 0; --k) {
    const rational r = m.one_in(5) ? c.s : rational(m.between(-40, 40), 10);
    const bool is_new = std::ranges::none_of(c.roots, [&](const auto& x) { return x.first == r; });
    if (is_new) c.roots.emplace_back(r, m.one_in(2));
  }
  c.mixed = m.one_in(8) ? 3 : m.between(0, 2);
  c.turned = m.one_in(2);
  for (int i = 0; i < 2; ++i) {
    c.box.emplace_back(rational(m.between(-60, -1), 10), rational(m.between(1, 60), 10));
    if (m.one_in(3)) c.box.back().first = std::nullopt;
    if (m.one_in(3)) c.box.back().second = std::nullopt;
  }
  return c;
}

TEST(systems, of_an_explicit_equation_have_the_known_roots) {
  run_cases("roots", "systems of an explicit equation", 60, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const explicit_case given = any_explicit(m);
    under_way(fmt::format("a system with the seed {}", seed));
    ++c.cases;
    const real_system f(given, 2);
    const system_root_set found = solve_system(f, given.box, {.most_boxes = 3'000});
    ++c.computed;
    ++(found.is_resolved() ? c.certified : c.refused);
    const auto fail = [&, seed = seed](const std::string& why) {
      ++c.wrong;
      ADD_FAILURE() << "with the seed " << seed << ": " << why;
    };
    long expected = 0;
    for (const auto& [r, is_square] : given.roots) {
      const ball v = given.g(ball(r, 200));
      if (!v.is_bounded()) continue;
      std::vector<ball> at{ball(r, 200), v};
      if (given.turned) std::swap(at[0], at[1]);
      bool is_inside = true;
      for (std::size_t i = 0; i < 2; ++i) {
        const auto& [low, high] = given.box[i];
        is_inside = is_inside && (!low || !certainly_less(at[i], ball(*low, 300))) &&
                    (!high || !certainly_less(ball(*high, 300), at[i]));
      }
      long claimed = 0;
      long open = 0;
      for (const system_region& region : found.regions) {
        const auto& set = is_one_root(region.verdict) ? region.enclosure : region.box;
        if (!overlaps(set[0], at[0]) || !overlaps(set[1], at[1])) continue;
        ++(is_one_root(region.verdict) ? claimed : open);
        // Beside a kink a root may be said to be isolated.
        const auto denied = is_square ? root_verdict::unique : root_verdict::multiple;
        if (r != given.s && region.verdict == denied) {
          fail("a root is said to be " + to_text(region.verdict));
        }
      }
      ++c.checks;
      expected += is_inside ? 1 : 0;
      if (claimed > 1) fail("a root is counted twice");
      if (is_inside && claimed + open == 0) fail("a root is missing");
      if (!is_inside && claimed > 0) fail("a root outside is counted");
    }
    const auto claimed = std::ranges::count_if(
        found.regions, [](const system_region& r) { return is_one_root(r.verdict); });
    ++c.checks;
    if (claimed > expected) fail("there are more roots than known");
    if (found.is_resolved() && claimed != expected) fail("a root is missing");
  });
}

TEST(systems, keep_the_root_that_was_planted) {
  run_cases("roots", "systems with a planted root", 60, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const planted_case given = any_planted(m);
    under_way(fmt::format("a system with the seed {}", seed));
    const real_system f(given, given.box.size());
    ++c.cases;
    const system_root_set s =
        solve_system(f, given.box, {.most_boxes = 1'000, .most_halvings = 30});
    ++c.computed;
    ++(s.is_resolved() ? c.certified : c.refused);
    const auto fail = [&, seed = seed](const std::string& why) {
      ++c.wrong;
      ADD_FAILURE() << "with the seed " << seed << ": " << why;
    };
    long claimed = 0;
    long open = 0;
    for (const system_region& r : s.regions) {
      if (!is_one_root(r.verdict)) {
        if (holds(r.box, given.root)) ++open;
        continue;
      }
      if (holds(r.enclosure, given.root)) ++claimed;
      if (r.verdict != root_verdict::unique) continue;
      ++c.checks;
      const refined_system_root fine = refine(f, r, 35);
      if (!std::ranges::all_of(f(fine.enclosure), [](const ball& y) { return contains_zero(y); })) {
        fail("a region of one root holds none");
      }
      const shown found = by_signs(f, fine.enclosure);
      if (found != shown::nothing) ++c.checks;
      if (found == shown::no_root) fail("a region of one root without a change of signs");
      const bool before = holds(r.enclosure, given.root);
      if (before != holds(fine.enclosure, given.root)) fail("refined, a region loses the root");
    }
    ++c.checks;
    if (claimed > 1) fail("the root is counted " + std::to_string(claimed) + " times");
    if (claimed + open == 0) fail("the root is lost");
  });
}

/// The judge of the test above is right: it says so where a root is taken away, or is there twice.
TEST(systems, a_wrong_answer_is_seen) {
  const point zero{0, 0};
  const square_matrix none{zero, zero};
  const system_case c{none,
                      none,
                      zero,
                      none,
                      {{{shape::line, 1}, {shape::line, -1}}, {{shape::exponential, 1}}},
                      {{-3, 2}, {-3, 2}}};
  system_root_set s = solve_system(c, c.box);
  EXPECT_EQ(error_in(c, s), std::nullopt);
  ASSERT_EQ(s.regions.size(), 2U);
  system_root_set twice = s;
  twice.regions.push_back(s.regions[0]);
  EXPECT_NE(error_in(c, twice).value_or("").find("2 times"), std::string::npos);
  system_root_set moved = s;
  for (ball& side : moved.regions[0].enclosure) side = side + 7;
  EXPECT_TRUE(error_in(c, moved));
  s.regions.pop_back();
  EXPECT_NE(error_in(c, s).value_or("").find("missing"), std::string::npos);
}

TEST(systems, signs_tell_roots_from_other_points) {
  const real_system f(
      [](const auto& x) {
        return std::vector{x[0] * x[1] - 2, x[0] - x[1] - 1};
      },
      2);
  const auto near = [](const rational& x, const rational& y) {
    return std::vector<ball>{ball(x, 160), ball(y, 160)};
  };
  EXPECT_EQ(by_signs(f, near(2, 1)), shown::root);
  EXPECT_EQ(by_signs(f, near(-1, -2)), shown::root);
  EXPECT_EQ(by_signs(f, near(2, rational(1'000'001, 1'000'000))), shown::no_root);
  EXPECT_EQ(by_signs(f, near(1, 2)), shown::no_root);
}

}  // namespace systems_test
}  // namespace polhode::differential
