#include "polhode/formulas/elliptic_functions.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

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

// Of an inverse function at x: that there is such a value, and that it is taken at one finite argument.
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
// The value is K: x is dn K = ds K, or nd K = sd K, or -sd K. Of rational numbers; others are not known to be at the edge.
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
  // theta_1 is odd and theta_2 even about the multiples of pi, and the other way round about those of pi between;
  // theta_3 and theta_4 are even about all of them.
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

// ---------------------------------------------------------------------------------------------

/// A function of Jacobi's, with the slopes in u and m where there are any.
further_function jacobi(const std::string& letters, const std::string& description,
                        const std::string& domain,
                        ball (*f)(const ball&, const elliptic_parameter<ball>&),
                        std::array<ball, 2> jacobi_gradient_values::*slopes = nullptr) {
  std::string name = "jacobi";
  for (const char letter : letters) name += static_cast<char>(std::toupper(letter));
  further_function result{
      {name, "u, m", description, domain}, 2, [f](balls x) { return f(x[0], x[1]); }};
  if (slopes != nullptr) {
    result.gradient = [slopes](balls x) { return listed(jacobi_gradient(x[0], x[1]).*slopes); };
  }
  if (letters == "am") {
    result.may_be_defined = [](known_arguments x) { return !is_number(x[1]) || x[1]->q <= 1; };
    result.simpler = [](known_arguments x) -> formula {
      if (is_zero(x[0])) return "0";
      if (is_zero(x[1])) return "u";
      if (is_exactly(x[1], 1)) return "2*atan(tanh(u/2))";  // Gudermann's function
      return std::nullopt;
    };
    return result;
  }
  result.may_be_defined = [divisor = letters[1]](known_arguments x) {
    return may_be_defined_jacobi(divisor, x);
  };
  result.simpler = [letters](known_arguments x) { return simpler_jacobi(letters, x); };
  return result;
}
further_function inverse(const std::string& name, const std::string& of, const std::string& domain,
                         ball (*f)(const ball&, const elliptic_parameter<ball>&),
                         bool (*may_be_defined)(numbers), std::optional<int> zero = std::nullopt,
                         bool (*at_k)(const rational&, const rational&) = nullptr) {
  return {{name, "x, m", "inverse of " + of, domain},
          2,
          [f](balls x) { return f(x[0], x[1]); },
          nullptr,
          of_rationals(may_be_defined),
          [zero, at_k](known_arguments x) -> formula {
            if (zero && is_exactly(x[0], *zero)) return "0";
            if (at_k == nullptr || !is_number(x[0]) || !is_number(x[1])) return std::nullopt;
            if (!at_k(x[0]->q, x[1]->q)) return std::nullopt;
            return x[0]->q < 0 ? "-ellipticK(m)" : "ellipticK(m)";
          }};
}
further_function theta_function(int j, bool derivative) {
  const std::string name = "jacobiTheta" + std::to_string(j);
  const std::string of = "theta_" + std::to_string(j);
  const auto simpler = [j, derivative](known_arguments x) {
    return simpler_theta(j, derivative, x);
  };
  const auto may_be_defined = [](known_arguments x) {
    return !is_number(x[1]) || (x[1]->q >= 0 && x[1]->q < 1);
  };
  if (derivative) {
    return {{name + "Prime", "z, q", "derivative of " + of + " in z", "0 <= q < 1"},
            2,
            [j](balls x) { return theta(j, x[0], x[1]).derivative; },
            nullptr,
            may_be_defined,
            simpler};
  }
  return {{name, "z, q", of + " of the nome q", "0 <= q < 1"},
          2,
          [j](balls x) { return theta(j, x[0], x[1]).value; },
          [j](balls x) {
            return std::vector<ball>{theta(j, x[0], x[1]).derivative,
                                     ball::undefined(x[0].precision())};
          },
          may_be_defined,
          simpler};
}

/// Gives the function of that name and number of arguments its continuation, written once for regions and complex balls.
template <class F>
void continue_analytically(further_functions& all, const std::string& name, std::size_t arity,
                           const F& f) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const further_function& g) {
    return g.what.name == name && g.arity == arity;
  });
  found->over_regions = [f](std::span<const region> x) { return f(x); };
  found->over_complex = [f](std::span<const complex_ball> x) { return f(x); };
}

void continue_analytically(further_functions& all) {
  const auto of = [&](const char* name, std::size_t arity, const auto& f) {
    continue_analytically(all, name, arity, f);
  };
  of("ellipticK", 1, [](auto x) { return elliptic_k(x[0]); });
  of("ellipticE", 1, [](auto x) { return elliptic_e(x[0]); });
  of("ellipticE", 2, [](auto x) { return elliptic_e(x[0], x[1]); });
  of("ellipticD", 1, [](auto x) { return elliptic_d(x[0]); });
  of("ellipticD", 2, [](auto x) { return elliptic_d(x[0], x[1]); });
  of("ellipticF", 2, [](auto x) { return elliptic_f(x[0], x[1]); });
  of("ellipticPi", 2, [](auto x) { return elliptic_pi(x[0], x[1]); });
  of("ellipticPi", 3, [](auto x) { return elliptic_pi(x[0], x[1], x[2]); });
  of("bulirschCel", 4, [](auto x) {  // R_F and R_J of 0, kc^2, 1 and p
    const auto square_of_kc = square(x[0]);
    const auto zero = x[0] * 0;
    return x[2] * carlson_rf(zero, square_of_kc, zero + 1) +
           (x[3] - x[2] * x[1]) * carlson_rj(zero, square_of_kc, zero + 1, x[1]) / 3;
  });
  of("ellipticNome", 1, [](auto x) { return elliptic_nome(x[0]); });
  of("carlsonRF", 3, [](auto x) { return carlson_rf(x[0], x[1], x[2]); });
  of("carlsonRC", 2, [](auto x) { return carlson_rc(x[0], x[1]); });
  of("carlsonRD", 3, [](auto x) { return carlson_rd(x[0], x[1], x[2]); });
  of("carlsonRG", 3, [](auto x) { return carlson_rg(x[0], x[1], x[2]); });
  of("carlsonRJ", 4, [](auto x) { return carlson_rj(x[0], x[1], x[2], x[3]); });
  of("jacobiAM", 2, [](auto x) { return jacobi_am(x[0], x[1]); });
  for (const char p : {'s', 'c', 'd', 'n'}) {
    for (const char q : {'s', 'c', 'd', 'n'}) {
      if (p == q) continue;
      const std::string name = {'j',
                                'a',
                                'c',
                                'o',
                                'b',
                                'i',
                                static_cast<char>(std::toupper(p)),
                                static_cast<char>(std::toupper(q))};
      of(name.c_str(), 2, [p, q](auto x) { return jacobi_quotient(p, q, x[0], x[1]); });
      const std::string inverse_name = "jacobiArc" + name.substr(name.size() - 2);
      of(inverse_name.c_str(), 2, [p, q](auto x) { return jacobi_inverse(p, q, x[0], x[1]); });
    }
  }
  for (const int j : {1, 2, 3, 4}) {
    const std::string name = "jacobiTheta" + std::to_string(j);
    of(name.c_str(), 2, [j](auto x) { return theta_value(j, x[0], x[1]); });
    of((name + "Prime").c_str(), 2, [j](auto x) { return theta_derivative(j, x[0], x[1]); });
  }
}

further_functions make() {
  const std::string amplitude = "m sin^2 <= 1 up to phi";
  const std::string bounded = amplitude + "; m=1: |phi| < pi/2";
  const auto of_first_kind = [](known_arguments x) { return amplitude_domain(x[0], x[1], false); };
  further_functions f{
      {{"ellipticK", "m", "complete, of the first kind", "m < 1"},
       1,
       [](balls x) { return elliptic_k(x[0]); },
       [](balls x) { return std::vector<ball>{elliptic_k_derivative(x[0])}; },
       of_rationals(below_one),
       [](known_arguments x) { return is_zero(x[0]) ? formula("pi/2") : std::nullopt; }},
      {{"ellipticE", "m", "complete, of the second kind", "m <= 1"},
       1,
       [](balls x) { return elliptic_e(elliptic_parameter<ball>(x[0])); },
       [](balls x) { return std::vector<ball>{elliptic_e_derivative(x[0])}; },
       of_rationals(up_to_one),
       [](known_arguments x) -> formula {
         if (is_exactly(x[0], 1)) return "1";
         return is_zero(x[0]) ? formula("pi/2") : std::nullopt;
       }},
      {{"ellipticE", "phi, m", "second kind, amplitude phi", amplitude},
       2,
       [](balls x) { return elliptic_e(x[0], x[1]); },
       [](balls x) { return listed(elliptic_e_gradient(x[0], x[1])); },
       [](known_arguments x) { return amplitude_domain(x[0], x[1], true); },
       simpler_second_kind},
      {{"ellipticD", "m", "(K - E)/m", "m < 1"},
       1,
       [](balls x) { return elliptic_d(elliptic_parameter<ball>(x[0])); },
       nullptr,
       of_rationals(below_one),
       [](known_arguments x) { return is_zero(x[0]) ? formula("pi/4") : std::nullopt; }},
      {{"ellipticD", "phi, m", "(F - E)/m, amplitude phi", bounded},
       2,
       [](balls x) { return elliptic_d(x[0], x[1]); },
       nullptr,
       of_first_kind,
       [](known_arguments x) { return is_zero(x[0]) ? formula("0") : std::nullopt; }},
      {{"ellipticF", "phi, m", "first kind, amplitude phi", bounded},
       2,
       [](balls x) { return elliptic_f(x[0], x[1]); },
       [](balls x) { return listed(elliptic_f_gradient(x[0], x[1])); },
       of_first_kind,
       simpler_first_kind},
      {{"ellipticPi", "n, m", "complete, of the third kind",
        "m < 1, n != 1; n > 1: principal value"},
       2,
       [](balls x) { return elliptic_pi(x[0], elliptic_parameter<ball>(x[1])); },
       [](balls x) { return listed(elliptic_pi_gradient(x[0], x[1])); },
       of_rationals([](numbers x) { return x[0] != 1 && x[1] < 1; }),
       simpler_complete_third_kind},
      {{"ellipticPi", "n, phi, m", "third kind, amplitude phi", "as ellipticF, n sin(phi)^2 != 1"},
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
      {{"bulirschCel", "kc, p, a, b", "Bulirsch's complete integral", "kc != 0, p != 0"},
       4,
       [](balls x) { return bulirsch_cel(x[0], x[1], x[2], x[3]); },
       nullptr,
       of_rationals([](numbers x) { return x[0] != 0 && x[1] != 0; }),
       simpler_cel},
      {{"ellipticNome", "m", "exp(-pi K(1-m)/K(m))", "0 <= m <= 1"},
       1,
       [](balls x) { return elliptic_nome(x[0]); },
       nullptr,
       of_rationals(in_unit),
       [](known_arguments x) {
         return is_zero(x[0]) || is_exactly(x[0], 1) ? formula("m") : std::nullopt;
       }},
      {{"carlsonRF", "x, y, z", "R_F, symmetric", "x, y, z >= 0, at most one 0"},
       3,
       [](balls x) { return carlson_rf(x[0], x[1], x[2]); },
       [](balls x) { return listed(carlson_rf_gradient(x[0], x[1], x[2])); },
       of_rationals(carlson_domain),
       [](known_arguments x) { return are_equal(x, 3) ? formula("1/sqrt(x)") : std::nullopt; }},
      {{"carlsonRC", "x, y", "R_F(x, y, y)", "x >= 0, y != 0; y < 0: principal value"},
       2,
       [](balls x) { return carlson_rc(x[0], x[1]); },
       [](balls x) { return listed(carlson_rc_gradient(x[0], x[1])); },
       of_rationals([](numbers x) { return x[0] >= 0 && x[1] != 0; }),
       [](known_arguments x) -> formula {
         if (is_zero(x[0]) && is_number(x[1]) && x[1]->q < 0) return "0";
         // DLMF 19.2.20, which is analytic in x.
         if (is_number(x[1]) && x[1]->q < 0) return "sqrt(x/(x - y))*carlsonRC(x - y, -y)";
         return are_equal(x, 2) ? formula("1/sqrt(x)") : std::nullopt;
       }},
      {{"carlsonRD", "x, y, z", "R_J(x, y, z, z)", "x, y >= 0, not both 0, z > 0"},
       3,
       [](balls x) { return carlson_rd(x[0], x[1], x[2]); },
       [](balls x) { return listed(carlson_rd_gradient(x[0], x[1], x[2])); },
       of_rationals([](numbers x) { return carlson_domain(x) && x[2] > 0; }),
       [](known_arguments x) { return are_equal(x, 3) ? formula("x^(-3/2)") : std::nullopt; }},
      {{"carlsonRG", "x, y, z", "R_G, symmetric", "x, y, z >= 0"},
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
      {{"carlsonRJ", "x, y, z, p", "R_J, of the third kind", "x, y, z >= 0, at most one 0, p != 0"},
       4,
       [](balls x) { return carlson_rj(x[0], x[1], x[2], x[3]); },
       [](balls x) { return listed(carlson_rj_gradient(x[0], x[1], x[2], x[3])); },
       of_rationals([](numbers x) { return carlson_domain(x) && x[3] != 0; }),
       [](known_arguments x) { return are_equal(x, 4) ? formula("x^(-3/2)") : std::nullopt; }},
  };
  using slopes = jacobi_gradient_values;
  const std::string everywhere = "all u and m";
  const auto divisor = [](const char* name) { return std::string(name) + " != 0"; };
  f.push_back(jacobi("am", "amplitude, inverse of F", "m <= 1", jacobi_am, &slopes::am));
  f.push_back(jacobi("sn", "sin am", everywhere, jacobi_sn, &slopes::sn));
  f.push_back(jacobi("cn", "cos am", everywhere, jacobi_cn, &slopes::cn));
  f.push_back(jacobi("dn", "sqrt(1 - m sn^2)", everywhere, jacobi_dn, &slopes::dn));
  f.push_back(jacobi("ns", "1/sn", divisor("sn"), jacobi_ns));
  f.push_back(jacobi("nc", "1/cn", divisor("cn"), jacobi_nc));
  f.push_back(jacobi("nd", "1/dn", divisor("dn"), jacobi_nd));
  f.push_back(jacobi("sc", "sn/cn", divisor("cn"), jacobi_sc));
  f.push_back(jacobi("sd", "sn/dn", divisor("dn"), jacobi_sd));
  f.push_back(jacobi("cs", "cn/sn", divisor("sn"), jacobi_cs));
  f.push_back(jacobi("cd", "cn/dn", divisor("dn"), jacobi_cd));
  f.push_back(jacobi("ds", "dn/sn", divisor("sn"), jacobi_ds));
  f.push_back(jacobi("dc", "dn/cn", divisor("cn"), jacobi_dc));
  f.push_back(inverse("jacobiArcSN", "sn", "|x| <= 1, 0 <= m <= 1, |x| < 1 if m = 1", jacobi_arcsn,
                      of_sine, 0));
  f.push_back(inverse("jacobiArcCN", "cn", "|x| <= 1, 0 <= m <= 1, x > 0 if m = 1", jacobi_arccn,
                      of_cosine, 1));
  f.push_back(inverse("jacobiArcDN", "dn", "sqrt(1-m) <= x <= 1, x > 0, 0 < m <= 1", jacobi_arcdn,
                      of_delta, 1, is_delta_at_k));
  f.push_back(inverse("jacobiArcNS", "ns", "x >= 1, 0 <= m <= 1, x > 1 if m = 1", jacobi_arcns,
                      above_one_or_infinite));
  f.push_back(inverse("jacobiArcNC", "nc", "x >= 1, 0 <= m <= 1", jacobi_arcnc, above_one, 1));
  f.push_back(inverse("jacobiArcND", "nd", "1 <= x <= 1/sqrt(1-m), 0 < m <= 1", jacobi_arcnd,
                      of_inverse_delta, 1, is_inverse_delta_at_k));
  f.push_back(
      inverse("jacobiArcSC", "sc", "all x, 0 <= m <= 1", jacobi_arcsc, parameter_in_unit, 0));
  f.push_back(inverse("jacobiArcSD", "sd", "|x| <= 1/sqrt(1-m), 0 <= m <= 1", jacobi_arcsd,
                      of_sine_over_delta, 0, is_inverse_delta_at_k));
  f.push_back(
      inverse("jacobiArcCS", "cs", "0 <= m <= 1, x > 0 if m = 1", jacobi_arccs, of_cotangent));
  f.push_back(
      inverse("jacobiArcCD", "cd", "|x| <= 1, 0 <= m < 1", jacobi_arccd, of_shifted_sine, 1));
  f.push_back(inverse("jacobiArcDS", "ds", "x >= sqrt(1-m), x > 0, 0 <= m <= 1", jacobi_arcds,
                      of_delta_over_sine, std::nullopt, is_delta_at_k));
  f.push_back(inverse("jacobiArcDC", "dc", "x >= 1, 0 <= m < 1", jacobi_arcdc,
                      above_one_below_unit_parameter, 1));
  for (const int j : {1, 2, 3, 4}) f.push_back(theta_function(j, false));
  for (const int j : {1, 2, 3, 4}) f.push_back(theta_function(j, true));
  continue_analytically(f);
  return f;
}

}  // namespace

std::shared_ptr<const further_functions> elliptic_functions() {
  static const auto functions = std::make_shared<const further_functions>(make());
  return functions;
}

}  // namespace polhode
