// Every row of the table of named functions: it has a value in each arithmetic
// that has the function, the same in all, and is refused by its name in the
// others.

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "polhode/expression/evaluation.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/function_table.hpp"

namespace polhode {
namespace function_table_test {

using detail::named;
using detail::operation;
using slope = jet<ball, 1>;

struct row {
  std::string name;
  std::string domain;
  bool takes_two;
  bool complex_has_it;
  bool regions_have_it;
  bool jets_have_it;

  /// In the domain, and within the cuts, of each function.
  [[nodiscard]] rational point() const {
    return domain.starts_with("-1 <") ? rational(1, 3) : rational(3, 2);
  }
  [[nodiscard]] std::string call() const { return name + (takes_two ? "(x, 5/4)" : "(x)"); }
  [[nodiscard]] expression formula() const { return expression(call(), {{"x"}, {}}); }
};

std::vector<row> rows() {
#define POLHODE_ROW(f, arguments, description, domain, kind, reader)     \
  {#f,                                                                   \
   domain,                                                               \
   std::string(arguments) == "x, y" || std::string(arguments) == "y, x", \
   named<operation::f>::is_own<complex_ball>,                            \
   named<operation::f>::is_own<region>,                                  \
   named<operation::f>::is_own<slope>},
  return {POLHODE_FUNCTION_TABLE(POLHODE_ROW, POLHODE_ROW, POLHODE_ROW, POLHODE_NO_ROW)};
#undef POLHODE_ROW
}

/// The names of the rows for which `is_lacking` holds.
template <class F>
std::set<std::string> names_where(F is_lacking) {
  std::set<std::string> result;
  for (const row& r : rows()) {
    if (is_lacking(r)) result.insert(r.name);
  }
  return result;
}

TEST(FunctionTable, EveryRowIsAFunctionThatIsWrittenByItsName) {
  std::set<std::string> known;
  for (const expression_function& f : expression_functions()) {
    EXPECT_TRUE(known.insert(f.name).second) << f.name << " is there twice";
  }
  EXPECT_GE(rows().size(), 30U);
  for (const row& r : rows()) {
    EXPECT_EQ(known.count(r.name), 1U) << r.name;
    EXPECT_EQ(r.formula().to_text(), r.call());
  }
}

TEST(FunctionTable, EveryRowHasOneValueOverAllRealArithmetics) {
  const ball rounding_errors = to_ball(double_interval(-0x1p-40, 0x1p-40), 90);
  for (const row& r : rows()) {
    const expression f = r.formula();
    const ball x(r.point(), 90);
    const ball value = f(x);
    ASSERT_TRUE(value.is_bounded()) << r.call();
    const ball near = value + rounding_errors;
    EXPECT_TRUE(overlaps(f(complex_ball(x)).re, value)) << r.call();
    EXPECT_TRUE(overlaps(f(slope::variable(x))[0], value)) << r.call();
    EXPECT_TRUE(overlaps(to_ball(f(double_interval::from_ball(x)), 90), value)) << r.call();
    EXPECT_TRUE(overlaps(ball(f(midpoint(x))), near)) << r.call();
    EXPECT_TRUE(overlaps(ball::exactly(f(r.point().convert_to<double>()), 90), near)) << r.call();
  }
}

TEST(FunctionTable, AResultMayTakeThePlaceOfItsOperand) {
#define POLHODE_ROW(f, arguments, description, domain, kind, reader)                         \
  for (const ball& x : {ball(rational(3, 2), 90), ball(rational(1, 3), 90),                  \
                        ball(rational(1, 3), 90) * ball(rational(7, 5), 90),                 \
                        to_ball(double_interval(-0.25, 0.75), 90)}) {                        \
    ball r = x;                                                                              \
    named<operation::f>::put(r, r);                                                          \
    const ball expected = named<operation::f>::over(x);                                      \
    EXPECT_EQ(r.is_undefined(), expected.is_undefined()) << #f;                              \
    EXPECT_TRUE(r.is_undefined() || (contains(r, expected) && contains(expected, r))) << #f; \
  }
  POLHODE_FUNCTION_TABLE(POLHODE_ROW, POLHODE_NO_ROW, POLHODE_NO_ROW, POLHODE_NO_ROW)
#undef POLHODE_ROW
}

TEST(FunctionTable, AComplexBallHasEveryFunction) {
  EXPECT_EQ(names_where([](const row& r) { return !r.complex_has_it; }), std::set<std::string>{});
  for (const row& r : rows()) {
    const complex_ball z(ball(r.point(), 90), ball(rational(1, 64), 90));
    EXPECT_FALSE(r.formula()(z).is_undefined()) << r.call();
  }
}

TEST(FunctionTable, ARegionHasEveryFunction) {
  EXPECT_EQ(names_where([](const row& r) { return !r.regions_have_it; }), std::set<std::string>{});
  for (const row& r : rows()) {
    const double_interval re = double_interval::from_ball(ball(r.point(), 90));
    const region value = r.formula()(region(re, double_interval(-1, 1) / 64));
    EXPECT_TRUE(value.is_analytic()) << r.call();
  }
}

TEST(FunctionTable, EveryFunctionHasADerivative) {
  EXPECT_EQ(names_where([](const row& r) { return !r.jets_have_it; }), std::set<std::string>{});
  for (const row& r : rows()) {
    const slope value = r.formula()(slope::variable(ball(r.point(), 90)));
    EXPECT_TRUE(value[1].is_bounded()) << r.call();
    EXPECT_TRUE(value[0].is_bounded()) << r.call();
  }
}

/// A number that has the operators, and no function.
struct bare {
  std::string text;
  [[nodiscard]] bare blocked(const char* name) const { return {name}; }
};

TEST(FunctionTable, AnArithmeticWithoutFunctionsRefusesEachByItsName) {
  const bare x{"x"};
#define POLHODE_ROW(f, ...)                        \
  EXPECT_FALSE(named<operation::f>::is_own<bare>); \
  EXPECT_EQ(named<operation::f>::over(x).text, #f);
#define POLHODE_ROW_OF_TWO(f, ...)                 \
  EXPECT_FALSE(named<operation::f>::is_own<bare>); \
  EXPECT_EQ(named<operation::f>::over(x, x).text, #f);
  POLHODE_FUNCTION_TABLE(POLHODE_ROW, POLHODE_ROW_OF_TWO, POLHODE_ROW_OF_TWO, POLHODE_NO_ROW)
#undef POLHODE_ROW
#undef POLHODE_ROW_OF_TWO
}

}  // namespace function_table_test
}  // namespace polhode
