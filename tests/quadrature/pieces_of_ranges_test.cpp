// Integrals of abs, min and max of rational functions, by a piece of the range after the other.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/integrals_as_text.hpp"

namespace polhode {
namespace pieces_of_ranges_test {

using support::expect_values;
using support::number;
using known = support::integral_as_text;

TEST(PiecesOfRanges, HaveTheKnownValues) {
  const std::vector<known> all{
      {"exp(-abs(x))", "-inf", "inf", "2"},
      {"exp(-abs(x))*cos(1000*x)", "-inf", "inf", "2/(1+10^6)"},
      {"exp(-abs(x-1/3))", "inf", "-inf", "-2"},
      {"abs(x^2-1)*exp(-x)", "0", "inf", "8/e-1"},
      {"abs(100*x^2-1)*exp(-x)", "0", "inf", "exp(-1/10)*(2*10+2*100)*2+1-200"},
      {"abs(x^2-100)*exp(-abs(x))", "-inf", "inf", "2*(2*exp(-10)*22+98)"},
      {"exp(-max(x,1)^2)", "0", "inf", "1/e+sqrt(pi)/2*erfc(1)"},
      {"exp(-abs(x))*min(1,1/x^2)*x^2", "-inf", "inf", "2*(2-4/e)"},
      {"abs(abs(x)-1)*exp(-abs(x))", "-inf", "inf", "4/e"},
      {"min(x,-x)*exp(x)", "-inf", "0", "-1"},
      // Steps to infinity.
      {"floor(x)*exp(-x)", "0", "inf", "1/(e-1)"},
      {"exp(-floor(x))", "0", "inf", "e/(e-1)"},
      {"floor(x)^2*exp(-x)", "0", "inf", "(e+1)/(e-1)^2"},
      {"2^(-ceil(2*x))", "0", "inf", "1/2"},
      {"floor(x)*exp(x)", "-inf", "0", "-e/(e-1)"},
      // An end beyond all points, and on one of them.
      {"abs(x+5)*exp(-x)", "-1", "inf", "5*e"},
      {"abs(x+5)*exp(x)", "-inf", "-5", "exp(-5)"},
      {"abs(x-2)*cos(x)", "sqrt(2)", "3",
       "(sqrt(2)-2)*sin(sqrt(2))+cos(sqrt(2))-2*cos(2)+sin(3)+cos(3)"},
      {"abs(x-1)*cos(x)", "0", "sqrt(5)",
       "-cos(1)+1-2*sin(1)+sin(1)+(sqrt(5)-1)*sin(sqrt(5))+cos(sqrt(5))-cos(1)+sin(1)"},
      // Beyond the last kink, without it.
      {"max(exp(x)-2,0)*exp(-x^2)", "-inf", "inf",
       "sqrt(pi)/2*(exp(1/4)*erfc(log(2)-1/2)-2*erfc(log(2)))"},
      {"max(2-exp(x),0)*exp(-x^2)", "-inf", "inf",
       "sqrt(pi)/2*(2*erfc(-log(2))-exp(1/4)*erfc(1/2-log(2)))"},
      {"max(exp(x)-2,0)*exp(-2*x)", "0", "inf", "1/4"},
      {"max(exp(x)-exp(20),0)*exp(-2*x)", "0", "inf", "exp(-20)/2"},
      {"min(1,exp(3-x))", "0", "inf", "4"},
      {"max(x^5,exp(x))*exp(-2*x)", "15", "inf", "exp(-15)"},
      {"max(exp(-x)*(x-20),1/x^2)", "1", "inf", "1"},
      {"min(log(x)^2,sqrt(x))/x^2", "6000", "inf", "(log(6000)^2+2*log(6000)+2)/6000"},
  };
  expect_values(all);
}

TEST(PiecesOfRanges, AreExactWhereTheirSumIsRational) {
  const auto value = [](const std::string& f, const std::string& a, const std::string& b) {
    return exact_integral(parse(f), number(a), number(b));
  };
  EXPECT_EQ(value("min(1,1/x^2)", "-inf", "inf"), rational(4));
  EXPECT_EQ(value("1/(1+abs(x-7))^3", "-inf", "inf"), rational(1));
  EXPECT_EQ(value("max(0,1-abs(x)/9)", "-inf", "inf"), rational(9));
  EXPECT_EQ(value("1/max(x,2)^3", "inf", "0"), rational(-3, 8));
  EXPECT_EQ(value("1/(1+abs(x))", "-inf", "inf"), std::nullopt);
  EXPECT_EQ(value("floor(x)/(1+abs(x))^4", "-inf", "inf"), std::nullopt);
}

TEST(PiecesOfRanges, DivergentTwinsAreNotCertified) {
  for (const char* const f : {"1/(1+abs(x))", "abs(x)", "min(1,1/abs(x))", "max(1/x^2,1/(1+x^2))",
                              "exp(-min(abs(x),3))", "floor(x)*exp(-min(x^2,1))"}) {
    EXPECT_NE(support::integral_of(f, "-inf", "inf", 10).verdict, status::certified) << f;
  }
}

// A kink nearer to an irrational end than 64 bits tell, inside and outside of the range.
TEST(PiecesOfRanges, AKinkBesideAnIrrationalEndIsOnItsSide) {
  for (const std::string& q :
       std::vector<std::string>{"141421356237309504880168872420969807856967187537694/10^50",
                                "141421356237309504880168872420969807856967187537695/10^50"}) {
    const bool inside = q.find("695") != std::string::npos;
    const std::string before = inside ? "(" + q + "-sqrt(2))^2/2" : "0";
    const std::string from = inside ? q : "sqrt(2)";
    const ball expected =
        parse(before + "+(2-" + q + ")^2/2-(" + from + "-" + q + ")^2/2", {}).value(800);
    for (const std::string& f :
         std::vector<std::string>{"abs(x-" + q + ")", "exp(0*x)*abs(x-" + q + ")+0*sin(x)"}) {
      const integral i = support::integral_of(f, "sqrt(2)", "2", 150);
      if (i.enclosure.is_bounded()) {
        EXPECT_TRUE(overlaps(i.enclosure, expected)) << f;
      }
    }
  }
}

}  // namespace pieces_of_ranges_test
}  // namespace polhode
