#pragma once

// The lists of integrals by which programs for quadrature are compared, as formulas.

#include <string>
#include <vector>

namespace polhode::test {

struct battery_integral {
  std::string number;  // in its list
  std::string formula;
  std::string lower;
  std::string upper;
  /// Its value in closed form, where there is one.
  std::string value = "";
  /// Where an end is not finite, or f is singular there: a range that is a part of it, and a bound
  /// of the absolute value of the rest, as formulas of p, a number of bits.
  struct part {
    std::string lower;
    std::string upper;
    std::string rest;
  };
  part cut = {};
  /// The integrand in the syntax of PARI's gp, where that is another; "-" where gp has it not.
  std::string in_gp = "";
};

struct battery {
  std::string name;
  std::string source;
  std::vector<battery_integral> integrals;
  /// What Polhode has not.
  std::vector<std::string> missing = {};
};

/// D. H. Bailey's fifteen.
[[nodiscard]] inline battery bailey() {
  return {
      "Bailey",
      "Bailey, Jeyabalan and Li, A comparison of three high-precision quadrature schemes (2005)",
      {{"1", "x*log(1+x)", "0", "1", "1/4"},
       {"2", "x^2*atan(x)", "0", "1", "(pi-2+2*log(2))/12"},
       {"3", "exp(x)*cos(x)", "0", "pi/2", "(exp(pi/2)-1)/2"},
       {"4", "atan(sqrt(2+x^2))/((1+x^2)*sqrt(2+x^2))", "0", "1", "5*pi^2/96"},
       {"5", "sqrt(x)*log(x)", "0", "1", "-4/9", {"2^(-p)", "1", "2^(-p)"}},
       {"6", "sqrt(1-x^2)", "0", "1", "pi/4"},
       {"7",
        "sqrt(x)/sqrt(1-x^2)",
        "0",
        "1",
        "2*sqrt(pi)*gamma(3/4)/gamma(1/4)",
        {"0", "1-4^(-p-2)", "2^(-p)"}},
       {"8", "log(x)^2", "0", "1", "2", {"2^(-2*p)", "1", "2^(-p)"}},
       {"9", "log(cos(x))", "0", "pi/2", "-pi*log(2)/2", {"0", "pi/2-2^(-2*p)", "2^(-p)"}},
       {"10", "sqrt(tan(x))", "0", "pi/2", "pi/sqrt(2)", {"0", "pi/2-4^(-p-2)", "2^(-p)"}},
       {"11", "1/(1+x^2)", "0", "inf", "pi/2", {"0", "2^p", "2^(-p)"}},
       {"12", "exp(-x)/sqrt(x)", "0", "inf", "sqrt(pi)", {"4^(-p-2)", "p", "2^(-p)"}},
       {"13", "exp(-x^2/2)", "0", "inf", "sqrt(pi/2)", {"0", "2*sqrt(p)", "2^(-p)"}},
       {"14", "exp(-x)*cos(x)", "0", "inf", "1/2", {"0", "p", "2^(-p)"}},
       {"15", "sin(x)/x", "0", "inf", "pi/2", {}, "sinc(x)"}}};
}

/// D. K. Kahaner's, as W. Gander and W. Gautschi have them, with their two more.
[[nodiscard]] inline battery kahaner() {
  return {
      "Kahaner",
      "Kahaner, Comparison of numerical quadrature formulas (1971), and Gander and Gautschi (2000)",
      {{"1", "exp(x)", "0", "1", "exp(1)-1"},
       {"2", "(1+sign(x-3/10))/2", "0", "1", "7/10"},
       {"3", "sqrt(x)", "0", "1", "2/3"},
       {"4", "23/25*cosh(x)-cos(x)", "-1", "1", "46/25*sinh(1)-2*sin(1)"},
       {"5", "1/(x^4+x^2+9/10)", "-1", "1"},
       {"6", "x*sqrt(x)", "0", "1", "2/5"},
       {"7", "1/sqrt(x)", "0", "1", "2", {"4^(-p-1)", "1", "2^(-p)"}},
       {"8", "1/(1+x^4)", "0", "1", "(pi+2*log(1+sqrt(2)))/(4*sqrt(2))"},
       {"9", "2/(2+sin(10*pi*x))", "0", "1", "2/sqrt(3)"},
       {"10", "1/(1+x)", "0", "1", "log(2)"},
       {"11", "1/(1+exp(x))", "0", "1", "1+log(2)-log(1+exp(1))"},
       {"12", "x/(exp(x)-1)", "0", "1", "", {"2^(-p)", "1", "2^(-p)"}},
       {"13", "sin(100*pi*x)/(pi*x)", "1/10", "1"},
       {"14", "sqrt(50)*exp(-50*pi*x^2)", "0", "10", "erf(10*sqrt(50*pi))/2"},
       {"15", "25*exp(-25*x)", "0", "10", "1-exp(-250)"},
       {"16", "50/(pi*(2500*x^2+1))", "0", "10", "atan(500)/pi"},
       {"17", "50*(sin(50*pi*x)/(50*pi*x))^2", "1/100", "1"},
       {"18", "cos(cos(x)+3*sin(x)+2*cos(2*x)+3*sin(2*x)+3*cos(3*x))", "0", "pi"},
       {"19", "log(x)", "0", "1", "-1", {"2^(-2*p)", "1", "2^(-p)"}},
       {"20", "1/(1.005+x^2)", "-1", "1", "2*atan(1/sqrt(1.005))/sqrt(1.005)"},
       {"21",
        "sech(20*(x-1/5))+sech(400*(x-2/5))+sech(8000*(x-3/5))",
        "0",
        "1",
        "",
        {},
        "1/cosh(20*(x-1/5))+1/cosh(400*(x-2/5))+1/cosh(8000*(x-3/5))"},
       {"22", "4*pi^2*x*sin(20*pi*x)*cos(2*pi*x)", "0", "1", "-20*pi/99"},
       {"23", "1/(1+(230*x-30)^2)", "0", "1", "(atan(200)+atan(30))/230"}}};
}

/// Those of FLINT's example program, as Arb's author chose them.
[[nodiscard]] inline battery flint() {
  return {
      "FLINT",
      "Johansson, Numerical integration in arbitrary-precision ball arithmetic (2018), and FLINT",
      {{"0", "sin(x)", "0", "100", "1-cos(100)"},
       {"1", "4/(1+x^2)", "0", "1", "pi"},
       {"2", "2/(1+x^2)", "0", "inf", "pi", {"0", "2^(p+1)", "2^(-p)"}},
       {"3", "4*sqrt(1-x^2)", "0", "1", "pi"},
       {"4", "sin(x+exp(x))", "0", "8"},
       {"5", "floor(x)", "1", "101", "5050"},
       {"6", "abs(x^4+10*x^3+19*x^2-6*x-6)*exp(x)", "0", "1"},
       {"8", "sin(1/x)", "0", "1"},
       {"9", "x*sin(1/x)", "0", "1"},
       {"10", "x^1000*exp(-x)", "0", "10000"},
       {"12", "sin(x)+exp(-200-x^2)", "-10", "10"},
       {"13", "exp(x)", "-1020", "-1010", "exp(-1010)-exp(-1020)"},
       {"14", "exp(-x^2)", "0", "inf", "sqrt(pi)/2", {"0", "sqrt(p)", "2^(-p)"}},
       {"15",
        "sech(10*x-2)^2+sech(100*x-40)^4+sech(1000*x-600)^6",
        "0",
        "1",
        "",
        {},
        "1/cosh(10*x-2)^2+1/cosh(100*x-40)^4+1/cosh(1000*x-600)^6"},
       {"16", "(exp(x)-floor(exp(x)))*sin(x+exp(x))", "0", "8"},
       {"17", "sech(x)", "0", "inf", "pi/2", {"0", "p+1", "2^(-p)"}, "1/cosh(x)"},
       {"18", "sech(x)^3", "0", "inf", "pi/4", {"0", "p/3+1", "2^(-p)"}, "1/cosh(x)^3"},
       {"19", "-log(x)/(1+x)", "0", "1", "pi^2/12", {"2^(-2*p)", "1", "2^(-p)"}},
       {"20", "x*exp(-x)/(1+exp(-x))", "0", "inf", "pi^2/12", {"0", "p", "2^(-p)"}},
       {"23", "lambertW(x)", "0", "1000", "", {}, "lambertw(x)"},
       {"24", "max(sin(x),cos(x))", "0", "pi", "1+sqrt(2)"},
       {"25",
        "erf(x*sqrt(1250)+3/2)*exp(-x)",
        "-1",
        "1",
        "",
        {},
        "(1-erfc(x*sqrt(1250)+3/2))*exp(-x)"},
       {"26", "airyAi(x)", "-10", "10", "", {}, "airy(x)[1]"},
       {"27", "(x-floor(x)-1/2)*max(sin(x),cos(x))", "0", "10"},
       {"29", "exp(-x^2)*cos(x)", "0", "inf", "sqrt(pi)/2*exp(-1/4)", {"0", "sqrt(p)", "2^(-p)"}},
       {"30", "exp(-x)*airyAi(-x)", "0", "inf", "", {"0", "p", "2^(-p)"}, "exp(-x)*airy(-x)[1]"},
       {"31", "x*sin(x)/(1+cos(x)^2)", "0", "pi", "pi^2/4"},
       {"32", "sin((1/1000+(1-x)^2)^(-3/2))", "0", "3"},
       {"33", "besselIx(0,x/3)^3", "0", "inf", "", {}, "exp(-x)*besseli(0,x/3)^3"},
       // From I_0(y) = (1/pi) int_0^pi e^(y cos t) dt and cos t <= 1 - 2 (t/pi)^2,
       // e^-y I_0(y) <= sqrt(pi/(8 y)), and the integral from n on is at most 10^5 n^(-13/2).
       {"34",
        "besselIx(0,x/15)^15",
        "0",
        "inf",
        "",
        {"0", "2^((p+17)*2/13)", "2^(-p)"},
        "exp(-x)*besseli(0,x/15)^15"},
       {"36", "1/gamma(x)", "0", "inf", "", {"2^(-p)", "p+8", "2^(-p)"}}},
      {"7, 11, 22, 28 and 35: along complex paths", "21: Weierstrass's p"}};
}

}  // namespace polhode::test
