// Certificates of what was found of a formula.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/certificate/certificate_of.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/roots/isolate.hpp"

namespace polhode::test {
namespace certificate_of_test {

std::string refusal(const formula_over_range& what, const root_set& found) {
  try {
    (void)certificate_of(what, found, 10);
  } catch (const input_error& error) {
    return error.what();
  }
  return "";
}

formula_over_range range(const std::string& f, const std::string& from, const std::string& to) {
  return {parse(f), parse(from, {}), parse(to, {})};
}

TEST(FormulaCertificate, HoldsTheIntegral) {
  const formula_over_range what = range("4/(1+x^2)", "0", "1");
  const integral found = integrate(what.f, 0, 1, {.digits = 25});
  const json c = certificate_of(what, found, 20);
  EXPECT_EQ(c, integral_certificate(what, found.enclosure, 20));
  integral open = found;
  open.verdict = status::not_certified;
  EXPECT_THROW((void)certificate_of(what, open, 20), input_error);
}

TEST(FormulaCertificate, HoldsTheRoots) {
  const formula_over_range what = range("(x^2-2)*(x-1/2)", "-2", "2");
  const root_set found = isolate_roots(what.f, -2, 2);
  const json c = certificate_of(what, found, 20);
  EXPECT_EQ(c.at("claim"), "roots");
  EXPECT_EQ(c.at("witness").at("boxes").size(), 3U) << c.dump(2);
}

TEST(FormulaCertificate, RootsThatNoneCanHoldAreRefused) {
  const auto refused = [](const char* f) {
    return refusal(range(f, "-2", "2"), isolate_roots(parse(f), -2, 2));
  };
  EXPECT_NE(refused("(x-1)^2").find("multiple root"), std::string::npos);
  EXPECT_NE(refused("x - x").find("0 everywhere"), std::string::npos);
  EXPECT_NE(refused("(x-1)/x").find("not defined everywhere"), std::string::npos);
  root_set open = isolate_roots(parse("x^2-2"), -2, 2);
  open.complete = false;
  EXPECT_NE(refusal(range("x^2-2", "-2", "2"), open).find("not every place"), std::string::npos);
}

}  // namespace certificate_of_test
}  // namespace polhode::test
