#pragma once

// A certificate is data: what was claimed, of which inputs, what was proved, and what a checker
// needs to repeat the argument. docs/certificates.md describes its JSON form.

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/verdict.hpp"

namespace polhode {

/// Keys keep the order in which they were written.
using json = nlohmann::ordered_json;

/// A number and the enclosure that was proved for it.
struct enclosed_number {
  std::string name;
  ball enclosure;
  long digits = 0;  // how many significant digits were asked for
};

/// What a step of a proof rests on. The first two this program decides: in rationals or by
/// polynomials, or by enclosures. The third is a theorem of proofs/coq, which the kernel of Coq
/// accepts, not this program. The other two no machine decides: an argument in words, and a theorem
/// of others.
enum class step_kind { exact, enclosed, kernel, argued, cited };
/// "decided exactly", "enclosed", "proved in Coq", "argued in words", "cited".
[[nodiscard]] std::string to_text(step_kind k);

/// How much of a proof a machine decides.
enum class proof_tier {
  by_kernel,   // theorems of proofs/coq say it of all bodies; its steps decide the given one again
  by_machine,  // its steps, with what is cited, give the statement
  with_words,  // it decides every sign, bound and count; words lead from them to the statement
};
/// "by Coq's kernel", "by machine", "by machine, joined in words".
[[nodiscard]] std::string to_text(proof_tier t);

/// One condition that the proof rests on and that was decided, in words.
struct checked_fact {
  std::string statement;
  bool holds = false;
  step_kind kind = step_kind::exact;  // exact or enclosed
};

/// One step that this program does not decide.
struct stated_step {
  step_kind kind = step_kind::argued;  // kernel, argued or cited
  std::string statement;               // of kernel, the name of the theorem
};

struct certificate {
  std::string claim;      // its name, "beta"
  std::string statement;  // in words
  std::string formula;    // what is enclosed, or the identity or inequality
  std::string reference;  // where the paper says it
  std::vector<std::pair<std::string, rational>> inputs;
  std::vector<enclosed_number> numbers;
  std::vector<checked_fact> facts;
  std::string method;  // the argument, in words
  proof_tier tier = proof_tier::by_machine;
  std::vector<stated_step> argument;  // what is argued in words and cited
  json witness = json::object();
  status verdict = status::not_certified;
  reason why = reason::none;

  /// Certified if every fact holds and every number has the digits that were asked for (a number
  /// that is exact has them all), and there is at least one of either; otherwise not, with
  /// `otherwise` as the reason.
  void conclude(reason otherwise = reason::precision_limit);

  /// The kinds of its steps, each once, in the order of step_kind. Numbers are enclosed.
  [[nodiscard]] std::vector<step_kind> rests_on() const;
};

/// {"value", "radius", "lower", "upper", "digits"} as decimal_enclosure has them, "rounded": true
/// where the value is not cut off, and "exact": true where it is. An unbounded or undefined ball
/// gives nulls in place of decimals.
[[nodiscard]] json to_json(const ball& x, long digits);
/// {"real", "imaginary"}.
[[nodiscard]] json to_json(const complex_ball& z, long digits);

/// The exact ends: {"lower": {"mantissa": "...", "exponent": e}, "upper": ...}, mantissa *
/// 2^exponent with decimal integers in strings. Null for an unbounded or undefined ball.
[[nodiscard]] json to_dyadic_json(const ball& x);

/// The certificate's JSON form, versions included, and the digest of all the rest
/// (docs/certificates.md).
[[nodiscard]] json to_json(const certificate& c);
/// The same of a certificate whose inputs are texts: a formula, or the plane of a map.
[[nodiscard]] json to_json(const certificate& c,
                           const std::vector<std::pair<std::string, std::string>>& inputs);

/// The certificate as text for a terminal of 100 columns.
[[nodiscard]] std::string to_text(const certificate& c);

}  // namespace polhode
