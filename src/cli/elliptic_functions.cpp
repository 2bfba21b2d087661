#include "elliptic_functions.hpp"

#include <algorithm>

#include "polhode/elliptic/carlson.hpp"
#include "polhode/elliptic/jacobi.hpp"
#include "polhode/elliptic/legendre.hpp"
#include "polhode/elliptic/theta.hpp"

namespace polhode::cli {
namespace {

using balls = std::span<const ball>;
using numbers = std::span<const rational>;

template <std::size_t Count>
std::vector<ball> listed(const std::array<ball, Count>& x) {
  return {x.begin(), x.end()};
}

bool carlson_domain(numbers x) {
  const auto zeros = std::count(x.begin(), x.begin() + 3, 0);
  return zeros <= 1 &&
         std::all_of(x.begin(), x.begin() + 3, [](const rational& q) { return q >= 0; });
}
bool below_one(numbers x) { return x[0] < 1; }
bool up_to_one(numbers x) { return x[0] <= 1; }
bool in_unit(numbers x) { return x[0] >= 0 && x[0] <= 1; }
bool nome_in_unit(numbers x) { return x[1] >= 0 && x[1] < 1; }
bool parameter_in_unit(numbers x) { return x[1] >= 0 && x[1] <= 1; }

/// A function of Jacobi's, with the slopes in u and m where there are any.
further_function jacobi(const std::string& name, const std::string& description,
                        const std::string& domain,
                        ball (*f)(const ball&, const elliptic_parameter<ball>&),
                        std::array<ball, 2> jacobi_gradient_values::*slopes = nullptr) {
  further_function result{
      {name, "u, m", description, domain}, 2, [f](balls x) { return f(x[0], x[1]); }};
  if (slopes != nullptr) {
    result.gradient = [slopes](balls x) { return listed(jacobi_gradient(x[0], x[1]).*slopes); };
  }
  return result;
}
further_function inverse(const std::string& name, const std::string& of, const std::string& domain,
                         ball (*f)(const ball&, const elliptic_parameter<ball>&)) {
  return {{name, "x, m", "inverse of " + of, domain + ", 0 <= m <= 1"},
          2,
          [f](balls x) { return f(x[0], x[1]); },
          nullptr,
          parameter_in_unit};
}
further_function theta_function(int j, bool derivative) {
  const std::string name = "jacobiTheta" + std::to_string(j);
  const std::string of = "theta_" + std::to_string(j);
  if (derivative) {
    return {{name + "Prime", "z, q", "derivative of " + of + " in z, q the nome", "0 <= q < 1"},
            2,
            [j](balls x) { return theta(j, x[0], x[1]).derivative; },
            nullptr,
            nome_in_unit};
  }
  return {{name, "z, q", of + " of the nome q", "0 <= q < 1"},
          2,
          [j](balls x) { return theta(j, x[0], x[1]).value; },
          [j](balls x) {
            return std::vector<ball>{theta(j, x[0], x[1]).derivative,
                                     ball::undefined(x[0].precision())};
          },
          nome_in_unit};
}

further_functions make() {
  const std::string amplitude = "m sin^2 <= 1 up to phi";
  further_functions f{
      {{"ellipticK", "m", "complete, of the first kind", "m < 1"},
       1,
       [](balls x) { return elliptic_k(x[0]); },
       [](balls x) { return std::vector<ball>{elliptic_k_derivative(x[0])}; },
       below_one},
      {{"ellipticE", "m", "complete, of the second kind", "m <= 1"},
       1,
       [](balls x) { return elliptic_e(elliptic_parameter<ball>(x[0])); },
       [](balls x) { return std::vector<ball>{elliptic_e_derivative(x[0])}; },
       up_to_one},
      {{"ellipticE", "phi, m", "second kind, amplitude phi", amplitude},
       2,
       [](balls x) { return elliptic_e(x[0], x[1]); },
       [](balls x) { return listed(elliptic_e_gradient(x[0], x[1])); }},
      {{"ellipticD", "m", "(K - E)/m", "m < 1"},
       1,
       [](balls x) { return elliptic_d(elliptic_parameter<ball>(x[0])); },
       nullptr,
       below_one},
      {{"ellipticD", "phi, m", "(F - E)/m, amplitude phi", amplitude},
       2,
       [](balls x) { return elliptic_d(x[0], x[1]); }},
      {{"ellipticF", "phi, m", "first kind, amplitude phi", amplitude},
       2,
       [](balls x) { return elliptic_f(x[0], x[1]); },
       [](balls x) { return listed(elliptic_f_gradient(x[0], x[1])); }},
      {{"ellipticPi", "n, m", "complete, of the third kind",
        "m < 1, n != 1; n > 1: principal value"},
       2,
       [](balls x) { return elliptic_pi(x[0], elliptic_parameter<ball>(x[1])); },
       [](balls x) { return listed(elliptic_pi_gradient(x[0], x[1])); },
       [](numbers x) { return x[0] != 1 && x[1] < 1; }},
      {{"ellipticPi", "n, phi, m", "third kind, amplitude phi", amplitude + ", n sin(phi)^2 != 1"},
       3,
       [](balls x) { return elliptic_pi(x[0], x[1], x[2]); },
       [](balls x) { return listed(elliptic_pi_gradient(x[0], x[1], x[2])); }},
      {{"bulirschCel", "kc, p, a, b", "Bulirsch's complete integral", "kc != 0, p != 0"},
       4,
       [](balls x) { return bulirsch_cel(x[0], x[1], x[2], x[3]); },
       nullptr,
       [](numbers x) { return x[0] != 0 && x[1] != 0; }},
      {{"ellipticNome", "m", "exp(-pi K(1-m)/K(m))", "0 <= m <= 1"},
       1,
       [](balls x) { return elliptic_nome(x[0]); },
       nullptr,
       in_unit},
      {{"carlsonRF", "x, y, z", "R_F, symmetric", "x, y, z >= 0, at most one 0"},
       3,
       [](balls x) { return carlson_rf(x[0], x[1], x[2]); },
       [](balls x) { return listed(carlson_rf_gradient(x[0], x[1], x[2])); },
       carlson_domain},
      {{"carlsonRC", "x, y", "R_F(x, y, y)", "x >= 0, y != 0; y < 0: principal value"},
       2,
       [](balls x) { return carlson_rc(x[0], x[1]); },
       [](balls x) { return listed(carlson_rc_gradient(x[0], x[1])); },
       [](numbers x) { return x[0] >= 0 && x[1] != 0; }},
      {{"carlsonRD", "x, y, z", "R_J(x, y, z, z)", "x, y >= 0, not both 0, z > 0"},
       3,
       [](balls x) { return carlson_rd(x[0], x[1], x[2]); },
       [](balls x) { return listed(carlson_rd_gradient(x[0], x[1], x[2])); },
       [](numbers x) { return carlson_domain(x) && x[2] > 0; }},
      {{"carlsonRG", "x, y, z", "R_G, symmetric", "x, y, z >= 0"},
       3,
       [](balls x) { return carlson_rg(x[0], x[1], x[2]); },
       [](balls x) { return listed(carlson_rg_gradient(x[0], x[1], x[2])); },
       [](numbers x) { return x[0] >= 0 && x[1] >= 0 && x[2] >= 0; }},
      {{"carlsonRJ", "x, y, z, p", "R_J, of the third kind", "x, y, z >= 0, at most one 0, p != 0"},
       4,
       [](balls x) { return carlson_rj(x[0], x[1], x[2], x[3]); },
       [](balls x) { return listed(carlson_rj_gradient(x[0], x[1], x[2], x[3])); },
       [](numbers x) { return carlson_domain(x) && x[3] != 0; }},
  };
  using slopes = jacobi_gradient_values;
  const std::string everywhere = "all u and m";
  const auto divisor = [](const char* name) { return std::string(name) + " != 0"; };
  f.push_back(jacobi("jacobiAM", "amplitude, inverse of F", "m <= 1", jacobi_am, &slopes::am));
  f.push_back(jacobi("jacobiSN", "sin am", everywhere, jacobi_sn, &slopes::sn));
  f.push_back(jacobi("jacobiCN", "cos am", everywhere, jacobi_cn, &slopes::cn));
  f.push_back(jacobi("jacobiDN", "sqrt(1 - m sn^2)", everywhere, jacobi_dn, &slopes::dn));
  f.push_back(jacobi("jacobiNS", "1/sn", divisor("sn"), jacobi_ns));
  f.push_back(jacobi("jacobiNC", "1/cn", divisor("cn"), jacobi_nc));
  f.push_back(jacobi("jacobiND", "1/dn", divisor("dn"), jacobi_nd));
  f.push_back(jacobi("jacobiSC", "sn/cn", divisor("cn"), jacobi_sc));
  f.push_back(jacobi("jacobiSD", "sn/dn", divisor("dn"), jacobi_sd));
  f.push_back(jacobi("jacobiCS", "cn/sn", divisor("sn"), jacobi_cs));
  f.push_back(jacobi("jacobiCD", "cn/dn", divisor("dn"), jacobi_cd));
  f.push_back(jacobi("jacobiDS", "dn/sn", divisor("sn"), jacobi_ds));
  f.push_back(jacobi("jacobiDC", "dn/cn", divisor("cn"), jacobi_dc));
  f.push_back(inverse("jacobiArcSN", "sn", "-1 <= x <= 1", jacobi_arcsn));
  f.push_back(inverse("jacobiArcCN", "cn", "-1 <= x <= 1", jacobi_arccn));
  f.push_back(inverse("jacobiArcDN", "dn", "sqrt(1-m) <= x <= 1", jacobi_arcdn));
  f.push_back(inverse("jacobiArcNS", "ns", "x >= 1", jacobi_arcns));
  f.push_back(inverse("jacobiArcNC", "nc", "x >= 1", jacobi_arcnc));
  f.push_back(inverse("jacobiArcND", "nd", "1 <= x <= 1/sqrt(1-m)", jacobi_arcnd));
  f.push_back(inverse("jacobiArcSC", "sc", "all x", jacobi_arcsc));
  f.push_back(inverse("jacobiArcSD", "sd", "|x| <= 1/sqrt(1-m)", jacobi_arcsd));
  f.push_back(inverse("jacobiArcCS", "cs", "all x", jacobi_arccs));
  f.push_back(inverse("jacobiArcCD", "cd", "-1 <= x <= 1", jacobi_arccd));
  f.push_back(inverse("jacobiArcDS", "ds", "x >= sqrt(1-m)", jacobi_arcds));
  f.push_back(inverse("jacobiArcDC", "dc", "x >= 1", jacobi_arcdc));
  for (const int j : {1, 2, 3, 4}) f.push_back(theta_function(j, false));
  for (const int j : {1, 2, 3, 4}) f.push_back(theta_function(j, true));
  return f;
}

}  // namespace

std::shared_ptr<const further_functions> elliptic_functions() {
  static const auto functions = std::make_shared<const further_functions>(make());
  return functions;
}

}  // namespace polhode::cli
