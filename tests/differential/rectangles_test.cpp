// Zeros in rectangles of products and quotients of factors with known zeros, some of them with
// branch cuts: all that are inside must be found, with their multiplicities, and no others. Where a
// divisor vanishes at a zero of the numerator the formula has no value, and there is no zero.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "maker.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/roots/zeros_in_rectangle.hpp"
#include "tally.hpp"

namespace polhode::differential {
namespace rectangles_test {

/// re + im i, with 0 for what is exactly 0.
struct known_zero {
  ball re;
  ball im;
  long multiplicity;
};

/// A formula of z and its zeros not far from 0, which are those of no other factor.
struct known_factor {
  std::string text;
  std::vector<known_zero> zeros;
  bool is_entire = true;
};

constexpr precision bits = 400;

ball exact(const rational& q) { return {q, bits}; }

/// A factor whose zeros depend on a, of which no two factors have the same.
known_factor any_factor(maker& m, const rational& a) {
  const std::string shift = fmt::format("(z-({}))", to_text(a));
  switch (m.between(0, 6)) {
    case 0:
      return {shift, {{exact(a), exact(0), 1}}};
    case 1: {
      const rational b(m.between(1, 30), 10);
      return {fmt::format("({}^2+({})^2)", shift, to_text(b)),
              {{exact(a), exact(b), 1}, {exact(a), exact(-b), 1}}};
    }
    case 2: {
      known_factor f{fmt::format("(exp({})-1)", shift), {}};
      for (long k = -2; k <= 2; ++k) f.zeros.push_back({exact(a), 2 * k * pi(bits), 1});
      return f;
    }
    case 3: {
      known_factor f{fmt::format("sin({})", shift), {}};
      for (long k = -4; k <= 4; ++k) f.zeros.push_back({exact(a) + k * pi(bits), exact(0), 1});
      return f;
    }
    case 4: {
      known_factor f{fmt::format("(cosh({})-1)", shift), {}};
      for (long k = -2; k <= 2; ++k) f.zeros.push_back({exact(a), 2 * k * pi(bits), 2});
      return f;
    }
    case 5:  // 4 from its branch point, with a cut to the left of that
      return {fmt::format("(sqrt({}+4)-2)", shift), {{exact(a), exact(0), 1}}, false};
    default:  // 1 from its branch point
      return {fmt::format("log({}+1)", shift), {{exact(a), exact(0), 1}}, false};
  }
}

struct rectangle_case {
  std::string formula;
  std::vector<known_zero> zeros;
  complex_rectangle where;
};

rectangle_case any_case(maker& m) {
  rectangle_case c;
  const auto end = [&](long least, long most) { return rational(m.between(least, most), 7); };
  c.where = {end(-28, -2), end(2, 28), end(-50, -2), end(2, 50)};
  if (m.one_in(6)) c.where.bottom = 0;
  if (m.one_in(6)) c.where.left = 0;
  std::string divisors;
  const long factors = m.between(1, 3);
  for (long k = 0; k < factors; ++k) {
    // Different real parts, unless the difference is a multiple of pi.
    const rational a = rational(m.between(-20, 20), 8) + rational(k, 97);
    const known_factor f = any_factor(m, a);
    const long power = m.one_in(4) ? m.between(2, 3) : 1;
    if (m.one_in(4)) {
      divisors += fmt::format("/{}^{}", f.text, power);
      if (!m.one_in(3)) continue;
      // A zero at which there is no value.
      c.formula += fmt::format("{}{}^{}", c.formula.empty() ? "" : "*", f.text, power);
      continue;
    }
    c.formula += fmt::format("{}{}^{}", c.formula.empty() ? "" : "*", f.text, power);
    for (known_zero z : f.zeros) {
      z.multiplicity *= power;
      c.zeros.push_back(z);
    }
  }
  if (c.formula.empty()) c.formula = "1";
  if (m.one_in(3)) c.formula += "*exp(z/3)";
  c.formula += divisors;
  if (m.one_in(5)) c.formula += "/(z^2+7)^2";
  return c;
}

bool overlap(const complex_ball& x, const known_zero& z) {
  return overlaps(x.re, z.re) && overlaps(x.im, z.im);
}
bool is_beyond(const known_zero& z, const complex_rectangle& r) {
  return certainly_less(z.re, exact(r.left)) || certainly_less(exact(r.right), z.re) ||
         certainly_less(z.im, exact(r.bottom)) || certainly_less(exact(r.top), z.im);
}
bool is_within(const known_zero& z, const complex_rectangle& r) {
  return certainly_less_equal(exact(r.left), z.re) && certainly_less_equal(z.re, exact(r.right)) &&
         certainly_less_equal(exact(r.bottom), z.im) && certainly_less_equal(z.im, exact(r.top));
}

/// What is wrong with an answer.
std::optional<std::string> error_in(const rectangle_case& c, const zeros_answer& found) {
  for (const known_zero& z : c.zeros) {
    if (!is_within(z, c.where)) continue;
    long times = 0;
    for (const complex_zero& f : found.zeros) times += overlap(f.enclosure, z) ? 1 : 0;
    bool is_open = false;
    for (const undecided_rectangle& u : found.undecided) {
      is_open = is_open || !is_beyond(z, u.where);
    }
    if (times == 0 && !is_open) return "a zero near " + to_decimal(z.re, 6) + " is missing";
    if (times > 1) return "a zero near " + to_decimal(z.re, 6) + " is there twice";
  }
  for (const complex_zero& f : found.zeros) {
    long count = 0;
    long different = 0;
    for (const known_zero& z : c.zeros) {
      if (!overlap(f.enclosure, z)) continue;
      count += z.multiplicity;
      ++different;
    }
    if (count != f.multiplicity) {
      return fmt::format("{} has {} zeros, not {}", to_decimal(f.enclosure, 6), count,
                         f.multiplicity);
    }
    if (f.is_one && different > 1) return to_decimal(f.enclosure, 6) + " is not one zero";
  }
  return std::nullopt;
}

TEST(rectangles, have_the_known_zeros_and_no_others) {
  run_cases("roots", "zeros in rectangles", 120, [](std::uint64_t seed, counts& c) {
    maker m(seed);
    const rectangle_case given = any_case(m);
    under_way(given.formula);
    const zeros_answer found =
        zeros_in_rectangle(parse(given.formula, {"z"}), given.where, {.digits = 15});
    ++c.cases;
    ++c.computed;
    (found.is_complete() ? c.certified : c.refused) += 1;
    c.checks += static_cast<long>(found.zeros.size() + given.zeros.size());
    if (const auto error = error_in(given, found)) {
      ++c.wrong;
      ADD_FAILURE() << given.formula << " in " << to_text(given.where.left) << ".."
                    << to_text(given.where.right) << ", " << to_text(given.where.bottom) << ".."
                    << to_text(given.where.top) << ": " << *error << "; seed " << seed;
    }
  });
}

TEST(rectangles, a_wrong_answer_is_seen) {
  const rectangle_case c{
      "(z-1)^2*(z+1)", {{exact(1), exact(0), 2}, {exact(-1), exact(0), 1}}, {-2, 2, -1, 1}};
  zeros_answer found = zeros_in_rectangle(parse(c.formula, {"z"}), c.where, {.digits = 15});
  EXPECT_EQ(error_in(c, found), std::nullopt);
  zeros_answer twice = found;
  twice.zeros.push_back(twice.zeros[0]);
  EXPECT_TRUE(error_in(c, twice));
  zeros_answer simple = found;
  simple.zeros[1].multiplicity = 1;
  EXPECT_TRUE(error_in(c, simple));
  found.zeros.pop_back();
  EXPECT_TRUE(error_in(c, found));
}

}  // namespace rectangles_test
}  // namespace polhode::differential
