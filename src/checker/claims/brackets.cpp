#include "brackets.hpp"

#include "checker/elliptic.hpp"
#include "shapes.hpp"
#include "statements/shared.hpp"

namespace polhode::checker {

tri passes_half_phase(const body& rigid, const rational& q, const range& u, precision bits) {
  if (u.lower <= 0 || u.upper >= 1) return false;
  const interval target = pi(bits) * exactly(q, bits);
  return all_of({below(target, half_phase(rigid.a, rigid.b, u.lower, bits)),
                 below(half_phase(rigid.a, rigid.b, u.upper, bits), target)});
}

tri passes_rotating_phase(const body& rigid, const rational& q, const range& s, precision bits) {
  if (s.lower <= 0 || s.upper >= 1) return false;
  const interval target = pi(bits) * exactly(q, bits);
  return all_of({below(target, rotating_phase(rigid.a, rigid.b, rigid.a * s.lower, bits)),
                 below(rotating_phase(rigid.a, rigid.b, rigid.a * s.upper, bits), target)});
}

long size_of(const range& r) { return bit_length(r.lower) + bit_length(r.upper); }

std::string counted(const integer& count) {
  if (count == 0) return "no k >= 1";
  return (count == 1 ? "k = 1" : "k = 1 ... " + count.str()) + " and no other k >= 1";
}

namespace {

void check_brackets(examination& e, const integer& count, const std::function<rational(int k)>& q,
                    const std::string& key,
                    const std::function<void(int k, const range& u)>& follow) {
  constexpr int most = 6;
  const body rigid = body_of(e);
  const int shown = count < most ? static_cast<int>(count) : most;
  const place all = e.witness(key);
  for (int k = 1; k <= shown; ++k) {
    const place one = all.at(static_cast<std::size_t>(k - 1));
    const std::string target = multiple_of_pi(q(k));
    if (one.value().is_null()) {
      if (!e.is_missing(statements::fill(statements::bracket_of_half_phase, {target})))
        one.malformed("it must be a bracket");
      continue;
    }
    const range u = examination::bracket(one);
    e.fact(statements::fill(statements::half_phase_passes, {target, in_decimals(u, e.work())}),
           [&](precision bits) { return passes_half_phase(rigid, q(k), u, bits + size_of(u)); });
    if (follow) follow(k, u);
  }
  if (all.size() > static_cast<std::size_t>(shown)) {
    all.at(static_cast<std::size_t>(shown)).malformed("there are not so many roots to bracket");
  }
}

void check_absence(examination& e, const rational& q) {
  const body rigid = body_of(e);
  e.fact(statements::fill(statements::half_phase_stays_above, {q.str(), multiple_of_pi(q)}),
         [&](precision bits) -> tri {
           if (rigid.is_above_I(q)) return false;
           return below(pi(bits) * exactly(q, bits),
                        half_phase(rigid.a, rigid.b, rational(1, 2), bits));
         });
}

}  // namespace

void check_values_of_half_phase(examination& e, const integer& count,
                                const std::function<rational(int k)>& q, const std::string& key,
                                const std::function<void(int k, const range& u)>& follow) {
  if (count > 0) {
    check_brackets(e, count, q, key, follow);
  } else {
    check_absence(e, q(1));
  }
}

}  // namespace polhode::checker
