#include "polhode/arithmetic/verdict.hpp"

namespace polhode {

std::string to_text(status s) {
  switch (s) {
    case status::certified:
      return "certified";
    case status::not_certified:
      return "not certified";
  }
  return "not certified";
}

std::string to_text(reason r) {
  switch (r) {
    case reason::none:
      return "none";
    case reason::precision_limit:
      return "precision limit";
    case reason::evaluation_limit:
      return "evaluation limit";
    case reason::not_analytic:
      return "not analytic";
    case reason::not_integrable:
      return "not integrable";
    case reason::not_convergent:
      return "not convergent";
    case reason::not_applicable:
      return "not applicable";
    case reason::not_defined:
      return "not defined";
    case reason::refuted:
      return "refuted";
  }
  return "unknown";
}

}  // namespace polhode
