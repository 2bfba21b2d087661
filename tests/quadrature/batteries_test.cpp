// The lists of tests/support/batteries.hpp: every integral is certified, and holds its closed form.

#include <gtest/gtest.h>

#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/batteries.hpp"

namespace polhode {
namespace batteries_test {
namespace {

constexpr long digits = 30;

end_point end_of(const std::string& text) {
  return text == "inf" ? end_point::infinity() : end_point_of(parse(text, {}));
}

void expect_certified(const test::battery& b) {
  for (const test::battery_integral& i : b.integrals) {
    SCOPED_TRACE(b.name + ' ' + i.number + ": " + i.formula);
    integrate_options options;
    options.digits = digits;
    const expression f(i.formula, {{"x"}, {}, library_functions()});
    const integral r = integrate(f, end_of(i.lower), end_of(i.upper), options);
    EXPECT_EQ(r.verdict, status::certified) << r.obstacle;
    if (!i.value.empty()) {
      EXPECT_TRUE(overlaps(r.enclosure, parse(i.value, {}).value(bits_for_digits(2 * digits))));
    }
  }
}

TEST(Batteries, OfBaileyAreCertified) { expect_certified(test::bailey()); }
TEST(Batteries, OfKahanerAreCertified) { expect_certified(test::kahaner()); }
TEST(Batteries, OfFlintAreCertified) {
  if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  expect_certified(test::flint());
}

}  // namespace
}  // namespace batteries_test
}  // namespace polhode
