#include "foreign_names.hpp"

#include <algorithm>
#include <array>

namespace polhode::detail {
namespace {

struct foreign_name {
  std::string_view name;
  std::string_view here;
};

/// In alphabetical order.
constexpr std::array names = std::to_array<foreign_name>({
    {"Ai", "airyAi(x)"},
    {"B", "euler_beta(x, y)"},
    {"Beta", "euler_beta(x, y)"},
    {"Bi", "airyBi(x)"},
    {"C", "binomial(n, k) or fresnelC(x)"},
    {"CubeRoot", "cbrt(x)"},
    {"E", "ellipticE(m), ellipticE(phi, m) or expint(n, x)"},
    {"E1", "expint(1, x)"},
    {"F", "ellipticF(phi, m)"},
    {"H", "heaviside(x) or hermiteH(n, x)"},
    {"I", "besselI(nu, x)"},
    {"I0", "besselI(0, x)"},
    {"I1", "besselI(1, x)"},
    {"J", "besselJ(nu, x)"},
    {"J0", "besselJ(0, x)"},
    {"J1", "besselJ(1, x)"},
    {"K", "ellipticK(m) or besselK(nu, x)"},
    {"K0", "besselK(0, x)"},
    {"K1", "besselK(1, x)"},
    {"L", "laguerreL(n, x)"},
    {"Li", "Ei(log(x)) - Ei(log(2)) or polylog(s, x)"},
    {"Li2", "dilog(x)"},
    {"Li3", "polylog(3, x)"},
    {"LogIntegral", "Ei(log(x))"},
    {"P", "legendreP(n, x)"},
    {"Phi", "erfc(-x/sqrt(2))/2"},
    {"ProductLog", "lambertW(x)"},
    {"S", "fresnelS(x)"},
    {"Surd", "root(x, n)"},
    {"T", "chebyshevT(n, x)"},
    {"U", "chebyshevU(n, x)"},
    {"UnitStep", "heaviside(x)"},
    {"W", "lambertW(x)"},
    {"Y", "besselY(nu, x)"},
    {"Y0", "besselY(0, x)"},
    {"Y1", "besselY(1, x)"},
    {"airy", "airyAi(x) or airyBi(x)"},
    {"arcctg", "acot(x)"},
    {"arctg", "atan(x)"},
    {"besseli0", "besselI(0, x)"},
    {"besselj0", "besselJ(0, x)"},
    {"besselk0", "besselK(0, x)"},
    {"bessely0", "besselY(0, x)"},
    {"beta", "euler_beta(x, y)"},
    {"binom", "binomial(n, k)"},
    {"ch", "cosh(x)"},
    {"choose", "binomial(n, k)"},
    {"comb", "binomial(n, k)"},
    {"coshint", "Chi(x)"},
    {"cosint", "Ci(x)"},
    {"cotg", "cot(x)"},
    {"ctg", "cot(x)"},
    {"cth", "coth(x)"},
    {"e1", "expint(1, x)"},
    {"eint1", "expint(1, x)"},
    {"ellipe", "ellipticE(m) or ellipticE(phi, m)"},
    {"ellipeinc", "ellipticE(phi, m)"},
    {"ellipf", "ellipticF(phi, m)"},
    {"ellipk", "ellipticK(m)"},
    {"ellipkinc", "ellipticF(phi, m)"},
    {"ellippi", "ellipticPi(n, m) or ellipticPi(n, phi, m)"},
    {"erfinv", "the root y of erf(y) - x, by polhode roots"},
    {"eta", "(1 - 2^(1 - s))*zeta(s)"},
    {"exp1", "expint(1, x)"},
    {"exp10", "10^x"},
    {"exp2", "2^x"},
    {"expi", "Ei(x)"},
    {"expn", "expint(n, x)"},
    {"fmod", "x - y*trunc(x/y)"},
    {"gammainc", "gammaUpper(s, x) or gammaLower(s, x)"},
    {"gammaincc", "gammaUpper(s, x)/gamma(s)"},
    {"gd", "atan(sinh(x))"},
    {"i0", "besselI(0, x)"},
    {"i0e", "besselIx(0, x)"},
    {"i1", "besselI(1, x)"},
    {"i1e", "besselIx(1, x)"},
    {"incgam", "gammaUpper(s, x)"},
    {"int", "trunc(x) or floor(x)"},
    {"iv", "besselI(nu, x)"},
    {"ive", "besselIx(nu, x)"},
    {"j0", "besselJ(0, x)"},
    {"j1", "besselJ(1, x)"},
    {"jn", "besselJ(nu, x)"},
    {"jv", "besselJ(nu, x)"},
    {"k0", "besselK(0, x)"},
    {"k0e", "besselKx(0, x)"},
    {"k1", "besselK(1, x)"},
    {"k1e", "besselKx(1, x)"},
    {"kv", "besselK(nu, x)"},
    {"kve", "besselKx(nu, x)"},
    {"lb", "log2(x)"},
    {"lg", "log10(x)"},
    {"li", "Ei(log(x))"},
    {"lngamma", "log_gamma(x)"},
    {"nCr", "binomial(n, k)"},
    {"normcdf", "erfc(-x/sqrt(2))/2"},
    {"normpdf", "exp(-x^2/2)/sqrt(2*pi)"},
    {"nthroot", "root(x, n)"},
    {"phi", "exp(-x^2/2)/sqrt(2*pi)"},
    {"productlog", "lambertW(x)"},
    {"psi", "digamma(x) or polygamma(n, x)"},
    {"sh", "sinh(x)"},
    {"sinhint", "Shi(x)"},
    {"sinint", "Si(x)"},
    {"step", "heaviside(x)"},
    {"surd", "root(x, n)"},
    {"tg", "tan(x)"},
    {"th", "tanh(x)"},
    {"theta", "heaviside(x)"},
    {"trigamma", "polygamma(1, x)"},
    {"unit_step", "heaviside(x)"},
    {"y0", "besselY(0, x)"},
    {"y1", "besselY(1, x)"},
    {"yn", "besselY(nu, x)"},
    {"yv", "besselY(nu, x)"},
});

static_assert(std::is_sorted(names.begin(), names.end(),
                             [](const foreign_name& x, const foreign_name& y) {
                               return x.name < y.name;
                             }));

}  // namespace

std::optional<std::string_view> written_here(std::string_view foreign_name) {
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const auto& one) { return one.name == foreign_name; });
  if (found == names.end()) return std::nullopt;
  return found->here;
}

}  // namespace polhode::detail
