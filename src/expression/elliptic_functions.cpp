#include "polhode/expression/library_functions.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/elliptic/carlson.hpp"
#include "polhode/elliptic/complex.hpp"
#include "polhode/elliptic/jacobi.hpp"
#include "polhode/elliptic/legendre.hpp"
#include "polhode/elliptic/theta.hpp"

namespace polhode {
namespace {

using balls = std::span<const ball>;
using numbers = std::span<const rational>;
using formula = std::optional<std::string>;

template <std::size_t Count>
std::vector<ball> listed(const std::array<ball, Count>& x) {
  return {x.begin(), x.end()};
}

// ---------------------------------------------------------------------------------------------
// Domains, where the arguments are known.

using predicate = std::function<bool(known_arguments)>;

/// A condition on rational numbers, taken to hold where not all arguments are.
predicate of_rationals(bool (*f)(numbers)) {
  return [f](known_arguments x) {
    std::vector<rational> values;
    values.reserve(x.size());
    for (const auto& argument : x) {
      if (!argument || !argument->is_rational()) return true;
      values.push_back(argument->q);
    }
    return f(values);
  };
}
bool is_number(const std::optional<pi_combination>& x) { return x && x->is_rational(); }
bool is_zero(const std::optional<pi_combination>& x) { return x && x->is_zero(); }
bool is_exactly(const std::optional<pi_combination>& x, const rational& q) {
  return is_number(x) && x->q == q;
}
/// The j of x = j pi/2.
std::optional<integer> quarter_turns(const std::optional<pi_combination>& x) {
  if (!x || x->q != 0 || denominator(rational(2 * x->r)) != 1) return std::nullopt;
  return numerator(rational(2 * x->r));
}
bool is_odd(const integer& n) { return n % 2 != 0; }

/// What F (and E, for which m = 1 is nothing particular) needs: m sin^2 <= 1 up to phi.
bool amplitude_domain(const std::optional<pi_combination>& phi,
                      const std::optional<pi_combination>& m, bool one_is_allowed) {
  if (!phi || !is_number(m) || m->q < 1 || (m->q == 1 && one_is_allowed)) return true;
  const auto turns = quarter_turns(phi);
  if (turns && *turns != 0) return false;
  for (const precision bits : {256, 4096, 65536}) {
    const ball angle = abs(phi->at(bits));
    const ball beyond = angle - scale(pi(bits), -1);
    const ball square_of_modulus = square(sin(angle)) * m->q;
    if (certainly_positive(beyond) || certainly_greater(square_of_modulus, 1)) return false;
    if (certainly_negative(beyond) && certainly_less(square_of_modulus, 1)) return true;
  }
  return true;  // not known
}

bool carlson_domain(numbers x) {
  const auto zeros = std::count(x.begin(), x.begin() + 3, 0);
  return zeros <= 1 &&
         std::all_of(x.begin(), x.begin() + 3, [](const rational& q) { return q >= 0; });
}
bool below_one(numbers x) { return x[0] < 1; }
bool up_to_one(numbers x) { return x[0] <= 1; }
bool in_unit(numbers x) { return x[0] >= 0 && x[0] <= 1; }

// Of an inverse function at x: that there is such a value, and that it is taken at one finite
// argument.
bool parameter_in_unit(numbers x) { return x[1] >= 0 && x[1] <= 1; }
bool of_sine(numbers x) {
  return parameter_in_unit(x) && abs(x[0]) <= 1 && !(x[1] == 1 && abs(x[0]) == 1);
}
bool of_cosine(numbers x) {
  return parameter_in_unit(x) && abs(x[0]) <= 1 && !(x[1] == 1 && x[0] <= 0);
}
bool of_delta(numbers x) {
  return parameter_in_unit(x) && x[0] > 0 && x[0] <= 1 && x[0] * x[0] >= 1 - x[1] && x[1] > 0;
}
bool above_one(numbers x) { return parameter_in_unit(x) && x[0] >= 1; }
bool above_one_or_infinite(numbers x) { return above_one(x) && !(x[1] == 1 && x[0] == 1); }
bool of_inverse_delta(numbers x) {
  return above_one(x) && (1 - x[1]) * x[0] * x[0] <= 1 && x[1] > 0;
}
bool of_sine_over_delta(numbers x) { return parameter_in_unit(x) && (1 - x[1]) * x[0] * x[0] <= 1; }
bool of_cotangent(numbers x) { return parameter_in_unit(x) && !(x[1] == 1 && x[0] <= 0); }
bool of_shifted_sine(numbers x) { return parameter_in_unit(x) && abs(x[0]) <= 1 && x[1] < 1; }
bool of_delta_over_sine(numbers x) {
  return parameter_in_unit(x) && x[0] >= 0 && x[0] * x[0] >= 1 - x[1] && x[0] > 0;
}
// The value is K: x is dn K = ds K, or nd K = sd K, or -sd K. Of rational numbers; others are not
// known to be at the edge.
bool is_delta_at_k(const rational& x, const rational& m) { return x * x == 1 - m; }
bool is_inverse_delta_at_k(const rational& x, const rational& m) { return x * x * (1 - m) == 1; }
bool above_one_below_unit_parameter(numbers x) { return above_one(x) && x[1] < 1; }

// ---------------------------------------------------------------------------------------------
// Values in simpler terms, where an argument is 0 or 1 or several are the same.

/// sn, cn and dn, where they are known to be 0, 1 or -1.
struct known_triple {
  std::optional<int> sn, cn, dn;
};
known_triple triple_of(known_arguments x) {
  if (is_zero(x[0])) return {0, 1, 1};
  if (!is_zero(x[1])) return {};
  known_triple result;
  result.dn = 1;
  if (const auto turns = quarter_turns(x[0])) {  // sin and cos
    const bool half = is_odd(*turns);
    const integer pairs = (half ? *turns - 1 : *turns) / 2;
    const int sign = is_odd(pairs) ? -1 : 1;
    result.sn = half ? sign : 0;
    result.cn = half ? 0 : sign;
  }
  return result;
}
std::optional<int> part_of(const known_triple& t, char letter) {
  switch (letter) {
    case 's':
      return t.sn;
    case 'c':
      return t.cn;
    case 'd':
      return t.dn;
    default:
      return 1;
  }
}
/// Jacobi's pq, p and q of the letters s, c, d and n.
formula simpler_jacobi(const std::string& letters, known_arguments x) {
  const known_triple triple = triple_of(x);
  const auto above = part_of(triple, letters[0]);
  const auto below = part_of(triple, letters[1]);
  if (above && below && *below != 0) return std::to_string(*above * *below);
  if (is_zero(x[1])) {
    const std::string over = letters[1] == 's' ? "sin(u)" : letters[1] == 'c' ? "cos(u)" : "1";
    const std::string what = letters[0] == 's' ? "sin(u)" : letters[0] == 'c' ? "cos(u)" : "1";
    return what + "/" + over;
  }
  if (is_exactly(x[1], 1)) {  // sn = tanh, cn = dn = 1/cosh
    const bool sine_above = letters[0] == 's';
    const bool sine_below = letters[1] == 's';
    if (letters[1] == 'n') return sine_above ? "tanh(u)" : "1/cosh(u)";
    if (letters[0] == 'n') return sine_below ? "1/tanh(u)" : "cosh(u)";
    if (sine_above) return "sinh(u)";
    return sine_below ? "1/sinh(u)" : "1";
  }
  return std::nullopt;
}
bool may_be_defined_jacobi(char divisor, known_arguments x) {
  const auto below = part_of(triple_of(x), divisor);
  return !below || *below != 0;
}

formula simpler_first_kind(known_arguments x) {
  if (is_zero(x[0])) return "0";
  if (is_zero(x[1])) return "phi";
  return std::nullopt;
}
/// E(j pi/2 | 1) = j.
formula simpler_second_kind(known_arguments x) {
  const auto turns = quarter_turns(x[0]);
  if (turns && is_exactly(x[1], 1)) return turns->str();
  return simpler_first_kind(x);
}
formula simpler_theta(int j, bool derivative, known_arguments x) {
  if (is_zero(x[1])) return j >= 3 && !derivative ? "1" : "0";
  const auto turns = quarter_turns(x[0]);
  if (!turns) return std::nullopt;
  // theta_1 is odd and theta_2 even about the multiples of pi, and the other way round about those
  // of pi between; theta_3 and theta_4 are even about all of them.
  const bool odd = j <= 2 && (is_odd(*turns) == (j == 2));
  return odd != derivative ? formula("0") : std::nullopt;
}
bool are_equal(known_arguments x, std::size_t count) {
  return is_number(x[0]) && std::all_of(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(count),
                                        [&](const auto& y) { return is_exactly(y, x[0]->q); });
}
/// For kc^2 = 1 and p > 0: pi/2 (a + b/sqrt p)/(1 + sqrt p).
formula simpler_cel(known_arguments x) {
  if (is_zero(x[2]) && is_zero(x[3])) return "0";
  const bool circular = is_exactly(x[0], 1) || is_exactly(x[0], -1);
  if (!circular || !is_number(x[1]) || x[1]->q <= 0) return std::nullopt;
  return "pi/2*(a + b/sqrt(p))/(1 + sqrt(p))";
}
formula simpler_complete_third_kind(known_arguments x) {
  if (is_zero(x[0])) return "ellipticK(m)";
  if (!is_zero(x[1]) || !is_number(x[0])) return std::nullopt;
  return x[0]->q < 1 ? "pi/(2*sqrt(1 - n))" : "0";
}

// --------------------------------------------------------------------------------------------- The
// tables. Each function has its value over balls, its derivatives over balls where there are any,
// where it may be defined, a simpler formula where there is one, and its continuation, written once
// for regions and complex balls.

template <class F>
further_function continued(further_function f, const F& continuation) {
  f.over_regions = [continuation](std::span<const region> x) { return continuation(x); };
  f.over_complex = [continuation](std::span<const complex_ball> x) { return continuation(x); };
  return f;
}

constexpr const char* amplitude = "m sin^2 <= 1 up to phi";
constexpr const char* bounded = "m sin^2 <= 1 up to phi; m=1: |phi| < pi/2";

bool has_first_kind(known_arguments x) { return amplitude_domain(x[0], x[1], false); }

further_functions legendre_functions() {
  return {
      continued({{"ellipticK", "m", "complete, of the first kind", "m < 1"},
                 1,
                 [](balls x) { return elliptic_k(x[0]); },
                 [](balls x) { return std::vector<ball>{elliptic_k_derivative(x[0])}; },
                 of_rationals(below_one),
                 [](known_arguments x) { return is_zero(x[0]) ? formula("pi/2") : std::nullopt; }},
                [](auto x) { return elliptic_k(x[0]); }),
      continued({{"ellipticE", "m", "complete, of the second kind", "m <= 1"},
                 1,
                 [](balls x) { return elliptic_e(elliptic_parameter<ball>(x[0])); },
                 [](balls x) { return std::vector<ball>{elliptic_e_derivative(x[0])}; },
                 of_rationals(up_to_one),
                 [](known_arguments x) -> formula {
                   if (is_exactly(x[0], 1)) return "1";
                   return is_zero(x[0]) ? formula("pi/2") : std::nullopt;
                 }},
                [](auto x) { return elliptic_e(x[0]); }),
      continued({{"ellipticE", "phi, m", "second kind, amplitude phi", amplitude},
                 2,
                 [](balls x) { return elliptic_e(x[0], x[1]); },
                 [](balls x) { return listed(elliptic_e_gradient(x[0], x[1])); },
                 [](known_arguments x) { return amplitude_domain(x[0], x[1], true); },
                 simpler_second_kind},
                [](auto x) { return elliptic_e(x[0], x[1]); }),
      continued({{"ellipticD", "m", "(K - E)/m", "m < 1"},
                 1,
                 [](balls x) { return elliptic_d(elliptic_parameter<ball>(x[0])); },
                 nullptr,
                 of_rationals(below_one),
                 [](known_arguments x) { return is_zero(x[0]) ? formula("pi/4") : std::nullopt; }},
                [](auto x) { return elliptic_d(x[0]); }),
      continued({{"ellipticD", "phi, m", "(F - E)/m, amplitude phi", bounded},
                 2,
                 [](balls x) { return elliptic_d(x[0], x[1]); },
                 nullptr,
                 has_first_kind,
                 [](known_arguments x) { return is_zero(x[0]) ? formula("0") : std::nullopt; }},
                [](auto x) { return elliptic_d(x[0], x[1]); }),
      continued({{"ellipticF", "phi, m", "first kind, amplitude phi", bounded},
                 2,
                 [](balls x) { return elliptic_f(x[0], x[1]); },
                 [](balls x) { return listed(elliptic_f_gradient(x[0], x[1])); },
                 has_first_kind,
                 simpler_first_kind},
                [](auto x) { return elliptic_f(x[0], x[1]); }),
      continued({{"ellipticPi", "n, m", "complete, of the third kind",
                  "m < 1, n != 1; n > 1: principal value"},
                 2,
                 [](balls x) { return elliptic_pi(x[0], elliptic_parameter<ball>(x[1])); },
                 [](balls x) { return listed(elliptic_pi_gradient(x[0], x[1])); },
                 of_rationals([](numbers x) { return x[0] != 1 && x[1] < 1; }),
                 simpler_complete_third_kind},
                [](auto x) { return elliptic_pi(x[0], x[1]); }),
      continued({{"ellipticPi", "n, phi, m", "third kind, amplitude phi",
                  "as ellipticF, n sin(phi)^2 != 1"},
                 3,
                 [](balls x) { return elliptic_pi(x[0], x[1], x[2]); },
                 [](balls x) { return listed(elliptic_pi_gradient(x[0], x[1], x[2])); },
                 [](known_arguments x) {
                   const auto turns = quarter_turns(x[1]);
                   if (is_exactly(x[0], 1) && turns && is_odd(*turns)) return false;
                   return amplitude_domain(x[1], x[2], false);
                 },
                 [](known_arguments x) -> formula {
                   if (is_zero(x[1])) return "0";
                   if (is_zero(x[0])) return "ellipticF(phi, m)";
                   return std::nullopt;
                 }},
                [](auto x) { return elliptic_pi(x[0], x[1], x[2]); }),
      continued({{"bulirschCel", "kc, p, a, b", "Bulirsch's complete integral", "kc != 0, p != 0"},
                 4,
                 [](balls x) { return bulirsch_cel(x[0], x[1], x[2], x[3]); },
                 nullptr,
                 of_rationals([](numbers x) { return x[0] != 0 && x[1] != 0; }),
                 simpler_cel},
                [](auto x) {  // R_F and R_J of 0, kc^2, 1 and p
                  const auto square_of_kc = square(x[0]);
                  const auto zero = x[0] * 0;
                  return x[2] * carlson_rf(zero, square_of_kc, zero + 1) +
                         (x[3] - x[2] * x[1]) * carlson_rj(zero, square_of_kc, zero + 1, x[1]) / 3;
                }),
      continued({{"ellipticNome", "m", "exp(-pi K(1-m)/K(m))", "0 <= m <= 1"},
                 1,
                 [](balls x) { return elliptic_nome(x[0]); },
                 nullptr,
                 of_rationals(in_unit),
                 [](known_arguments x) {
                   return is_zero(x[0]) || is_exactly(x[0], 1) ? formula("m") : std::nullopt;
                 }},
                [](auto x) { return elliptic_nome(x[0]); }),
  };
}

further_functions carlson_functions() {
  return {
      continued(
          {{"carlsonRF", "x, y, z", "R_F, symmetric", "x, y, z >= 0, at most one 0"},
           3,
           [](balls x) { return carlson_rf(x[0], x[1], x[2]); },
           [](balls x) { return listed(carlson_rf_gradient(x[0], x[1], x[2])); },
           of_rationals(carlson_domain),
           [](known_arguments x) { return are_equal(x, 3) ? formula("1/sqrt(x)") : std::nullopt; }},
          [](auto x) { return carlson_rf(x[0], x[1], x[2]); }),
      continued({{"carlsonRC", "x, y", "R_F(x, y, y)", "x >= 0, y != 0; y < 0: principal value"},
                 2,
                 [](balls x) { return carlson_rc(x[0], x[1]); },
                 [](balls x) { return listed(carlson_rc_gradient(x[0], x[1])); },
                 of_rationals([](numbers x) { return x[0] >= 0 && x[1] != 0; }),
                 [](known_arguments x) -> formula {
                   if (is_zero(x[0]) && is_number(x[1]) && x[1]->q < 0) return "0";
                   // DLMF 19.2.20, which is analytic in x.
                   if (is_number(x[1]) && x[1]->q < 0)
                     return "sqrt(x/(x - y))*carlsonRC(x - y, -y)";
                   return are_equal(x, 2) ? formula("1/sqrt(x)") : std::nullopt;
                 }},
                [](auto x) { return carlson_rc(x[0], x[1]); }),
      continued(
          {{"carlsonRD", "x, y, z", "R_J(x, y, z, z)", "x, y >= 0, not both 0, z > 0"},
           3,
           [](balls x) { return carlson_rd(x[0], x[1], x[2]); },
           [](balls x) { return listed(carlson_rd_gradient(x[0], x[1], x[2])); },
           of_rationals([](numbers x) { return carlson_domain(x) && x[2] > 0; }),
           [](known_arguments x) { return are_equal(x, 3) ? formula("x^(-3/2)") : std::nullopt; }},
          [](auto x) { return carlson_rd(x[0], x[1], x[2]); }),
      continued({{"carlsonRG", "x, y, z", "R_G, symmetric", "x, y, z >= 0"},
                 3,
                 [](balls x) { return carlson_rg(x[0], x[1], x[2]); },
                 [](balls x) { return listed(carlson_rg_gradient(x[0], x[1], x[2])); },
                 of_rationals([](numbers x) { return x[0] >= 0 && x[1] >= 0 && x[2] >= 0; }),
                 [](known_arguments x) -> formula {
                   if (are_equal(x, 3)) return "sqrt(x)";
                   if (is_zero(x[0]) && is_zero(x[1])) return "sqrt(z)/2";
                   if (is_zero(x[0]) && is_zero(x[2])) return "sqrt(y)/2";
                   if (is_zero(x[1]) && is_zero(x[2])) return "sqrt(x)/2";
                   return std::nullopt;
                 }},
                [](auto x) { return carlson_rg(x[0], x[1], x[2]); }),
      continued(
          {{"carlsonRJ", "x, y, z, p", "R_J, of the third kind",
            "x, y, z >= 0, at most one 0, p != 0"},
           4,
           [](balls x) { return carlson_rj(x[0], x[1], x[2], x[3]); },
           [](balls x) { return listed(carlson_rj_gradient(x[0], x[1], x[2], x[3])); },
           of_rationals([](numbers x) { return carlson_domain(x) && x[3] != 0; }),
           [](known_arguments x) { return are_equal(x, 4) ? formula("x^(-3/2)") : std::nullopt; }},
          [](auto x) { return carlson_rj(x[0], x[1], x[2], x[3]); }),
  };
}

// Jacobi's functions, by the letters of their names.

using of_parameter = ball (*)(const ball&, const elliptic_parameter<ball>&);

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

struct jacobi_row {
  const char* letters;
  const char* description;
  const char* domain;
  of_parameter f;
  std::array<ball, 2> jacobi_gradient_values::*slopes = nullptr;  // in u and m
};
constexpr std::array jacobi_rows{
    jacobi_row{"sn", "sin am", "all u and m", jacobi_sn, &jacobi_gradient_values::sn},
    jacobi_row{"cn", "cos am", "all u and m", jacobi_cn, &jacobi_gradient_values::cn},
    jacobi_row{"dn", "sqrt(1 - m sn^2)", "all u and m", jacobi_dn, &jacobi_gradient_values::dn},
    jacobi_row{"ns", "1/sn", "sn != 0", jacobi_ns},
    jacobi_row{"nc", "1/cn", "cn != 0", jacobi_nc},
    jacobi_row{"nd", "1/dn", "dn != 0", jacobi_nd},
    jacobi_row{"sc", "sn/cn", "cn != 0", jacobi_sc},
    jacobi_row{"sd", "sn/dn", "dn != 0", jacobi_sd},
    jacobi_row{"cs", "cn/sn", "sn != 0", jacobi_cs},
    jacobi_row{"cd", "cn/dn", "dn != 0", jacobi_cd},
    jacobi_row{"ds", "dn/sn", "sn != 0", jacobi_ds},
    jacobi_row{"dc", "dn/cn", "cn != 0", jacobi_dc},
};

struct jacobi_inverse_row {
  const char* letters;
  const char* domain;
  of_parameter f;
  bool (*may_be_defined)(numbers);
  std::optional<int> zero = std::nullopt;                        // the argument at which it is 0
  bool (*is_k)(const rational& x, const rational& m) = nullptr;  // it is K, or -K for x < 0
};
constexpr std::array jacobi_inverse_rows{
    jacobi_inverse_row{"sn", "|x| <= 1, 0 <= m <= 1, |x| < 1 if m = 1", jacobi_arcsn, of_sine, 0},
    jacobi_inverse_row{"cn", "|x| <= 1, 0 <= m <= 1, x > 0 if m = 1", jacobi_arccn, of_cosine, 1},
    jacobi_inverse_row{"dn", "sqrt(1-m) <= x <= 1, x > 0, 0 < m <= 1", jacobi_arcdn, of_delta, 1,
                       is_delta_at_k},
    jacobi_inverse_row{"ns", "x >= 1, 0 <= m <= 1, x > 1 if m = 1", jacobi_arcns,
                       above_one_or_infinite},
    jacobi_inverse_row{"nc", "x >= 1, 0 <= m <= 1", jacobi_arcnc, above_one, 1},
    jacobi_inverse_row{"nd", "1 <= x <= 1/sqrt(1-m), 0 < m <= 1", jacobi_arcnd, of_inverse_delta, 1,
                       is_inverse_delta_at_k},
    jacobi_inverse_row{"sc", "all x, 0 <= m <= 1", jacobi_arcsc, parameter_in_unit, 0},
    jacobi_inverse_row{"sd", "|x| <= 1/sqrt(1-m), 0 <= m <= 1", jacobi_arcsd, of_sine_over_delta, 0,
                       is_inverse_delta_at_k},
    jacobi_inverse_row{"cs", "0 <= m <= 1, x > 0 if m = 1", jacobi_arccs, of_cotangent},
    jacobi_inverse_row{"cd", "|x| <= 1, 0 <= m < 1", jacobi_arccd, of_shifted_sine, 1},
    jacobi_inverse_row{"ds", "x >= sqrt(1-m), x > 0, 0 <= m <= 1", jacobi_arcds, of_delta_over_sine,
                       std::nullopt, is_delta_at_k},
    jacobi_inverse_row{"dc", "x >= 1, 0 <= m < 1", jacobi_arcdc, above_one_below_unit_parameter, 1},
};

further_function amplitude_function() {
  return continued({{"jacobiAM", "u, m", "amplitude, inverse of F", "m <= 1"},
                    2,
                    [](balls x) { return jacobi_am(x[0], x[1]); },
                    [](balls x) { return listed(jacobi_gradient(x[0], x[1]).am); },
                    [](known_arguments x) { return !is_number(x[1]) || x[1]->q <= 1; },
                    [](known_arguments x) -> formula {
                      if (is_zero(x[0])) return "0";
                      if (is_zero(x[1])) return "u";
                      if (is_exactly(x[1], 1)) return "2*atan(tanh(u/2))";  // Gudermann's function
                      return std::nullopt;
                    }},
                   [](auto x) { return jacobi_am(x[0], x[1]); });
}
further_function function_of(const jacobi_row& row) {
  const std::string letters = row.letters;
  further_function result{{"jacobi" + upper_case(letters), "u, m", row.description, row.domain},
                          2,
                          [f = row.f](balls x) { return f(x[0], x[1]); }};
  if (row.slopes != nullptr) {
    result.gradient = [slopes = row.slopes](balls x) {
      return listed(jacobi_gradient(x[0], x[1]).*slopes);
    };
  }
  result.may_be_defined = [divisor = letters[1]](known_arguments x) {
    return may_be_defined_jacobi(divisor, x);
  };
  result.simpler = [letters](known_arguments x) { return simpler_jacobi(letters, x); };
  return continued(std::move(result), [p = letters[0], q = letters[1]](auto x) {
    return jacobi_quotient(p, q, x[0], x[1]);
  });
}
further_function function_of(const jacobi_inverse_row& row) {
  const std::string letters = row.letters;
  return continued(
      {{"jacobiArc" + upper_case(letters), "x, m", "inverse of " + letters, row.domain},
       2,
       [f = row.f](balls x) { return f(x[0], x[1]); },
       nullptr,
       of_rationals(row.may_be_defined),
       [zero = row.zero, is_k = row.is_k](known_arguments x) -> formula {
         if (zero && is_exactly(x[0], *zero)) return "0";
         if (is_k == nullptr || !is_number(x[0]) || !is_number(x[1])) {
           return std::nullopt;
         }
         if (!is_k(x[0]->q, x[1]->q)) return std::nullopt;
         return x[0]->q < 0 ? "-ellipticK(m)" : "ellipticK(m)";
       }},
      [p = letters[0], q = letters[1]](auto x) { return jacobi_inverse(p, q, x[0], x[1]); });
}

bool is_nome(known_arguments x) { return !is_number(x[1]) || (x[1]->q >= 0 && x[1]->q < 1); }

further_function theta_function(int j) {
  const std::string number = std::to_string(j);
  return continued(
      {{"jacobiTheta" + number, "z, q", "theta_" + number + " of the nome q", "0 <= q < 1"},
       2,
       [j](balls x) { return theta(j, x[0], x[1]).value; },
       [j](balls x) {
         return std::vector<ball>{theta(j, x[0], x[1]).derivative,
                                  ball::undefined(x[0].precision())};
       },
       is_nome,
       [j](known_arguments x) { return simpler_theta(j, false, x); }},
      [j](auto x) { return theta_value(j, x[0], x[1]); });
}
further_function theta_derivative_function(int j) {
  const std::string number = std::to_string(j);
  return continued({{"jacobiTheta" + number + "Prime", "z, q",
                     "derivative of theta_" + number + " in z", "0 <= q < 1"},
                    2,
                    [j](balls x) { return theta(j, x[0], x[1]).derivative; },
                    nullptr,
                    is_nome,
                    [j](known_arguments x) { return simpler_theta(j, true, x); }},
                   [j](auto x) { return theta_derivative(j, x[0], x[1]); });
}

// Of the first arguments of f, the parts that lie in the domain, up to a power of two from its end:
// such a ball has exactly these ends.

/// The part from 0 on.
std::optional<ball> from_zero(const ball& x) {
  const ball zero(0, x.precision());
  if (certainly_negative(x)) return std::nullopt;
  if (!x.is_bounded() || certainly_less_equal(zero, x)) return x;
  const auto log2_middle = static_cast<int>(x.magnitude_upper().log2_floor());
  const ball middle = scale(ball(1, x.precision()), log2_middle);
  return middle.enlarged(magnitude::power_of_two(log2_middle));
}
/// The part up to 1.
std::optional<ball> up_to_one(const ball& x) {
  const ball one(1, x.precision());
  if (certainly_less_equal(x, one)) return x;
  const std::optional<ball> distance = from_zero(one - x);
  return distance ? std::optional(one - *distance) : std::nullopt;
}
void restrict_to(std::optional<ball> (*part)(const ball&), std::size_t count, further_function& f) {
  f.natural_range = [=, value = f.value](balls x) -> std::optional<ball> {
    std::vector<ball> inside(x.begin(), x.end());
    for (std::size_t k = 0; k < count; ++k) {
      const std::optional<ball> known = part(x[k]);
      if (!known) return std::nullopt;
      inside[k] = *known;
    }
    return value(inside);
  };
}

/// In the order that people see.
further_functions make() {
  further_functions all = legendre_functions();
  for (further_function& f : all) {
    const std::string& name = f.what.name;
    const bool ends_at_one = name == "ellipticK" || name == "ellipticE" || name == "ellipticD";
    if (ends_at_one && f.arity == 1) restrict_to(up_to_one, 1, f);
  }
  further_functions carlson = carlson_functions();
  for (further_function& f : carlson) {
    restrict_to(from_zero, f.what.name == "carlsonRC" ? 1 : 3, f);
  }
  all.insert(all.end(), carlson.begin(), carlson.end());
  all.push_back(amplitude_function());
  for (const jacobi_row& row : jacobi_rows) all.push_back(function_of(row));
  for (const jacobi_inverse_row& row : jacobi_inverse_rows) all.push_back(function_of(row));
  for (const int j : {1, 2, 3, 4}) all.push_back(theta_function(j));
  for (const int j : {1, 2, 3, 4}) all.push_back(theta_derivative_function(j));
  return all;
}

}  // namespace

std::shared_ptr<const further_functions> elliptic_functions() {
  static const auto functions = std::make_shared<const further_functions>(make());
  return functions;
}

}  // namespace polhode
