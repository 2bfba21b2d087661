#include "polhode/checker/check.hpp"

#include <exception>
#include <new>

#include "examination.hpp"
#include "formula_claims.hpp"
#include "statements/formulas.hpp"
#include "statements/map.hpp"

namespace polhode::checker {
namespace {

constexpr long version = 4;

void check_document(const json& certificate, report& result, budget& work) {
  const place root(certificate, "", work);
  if (root["format"].text() != "polhode certificate") {
    root["format"].malformed("it must be \"polhode certificate\"");
  }
  const long given = root["version"].whole(0, 1'000'000);
  if (given != version) {
    root["version"].malformed("it is " + std::to_string(given) + "; this checker reads version " +
                              std::to_string(version));
  }
  const std::string& name = root["claim"].text();
  // What follows from the inputs, and is no claim of the paper.
  void (*const check_inputs)(const place&, report&) =
      name == statements::roots_claim      ? check_roots
      : name == statements::system_claim   ? check_system
      : name == statements::integral_claim ? check_integral
      : name == statements::map_claim      ? check_map
                                           : nullptr;
  const claim* text = find_claim(name);
  if (text == nullptr && check_inputs == nullptr) {
    root["claim"].malformed("this version knows no claim " + in_quotes(name) +
                            "; `polhode certify --list` shows those that it knows");
  }
  result.claim = name;
  const std::string& verdict = root["verdict"].text();
  if (verdict == "not certified") {
    root["verdict"].not_checkable("it is a certificate of a claim that was not certified");
  }
  root["verdict"].expect_text("certified");
  root.expect_keys({"format", "version", "claim", "statement", "formula", "reference", "verdict",
                    "tier", "rests_on", "inputs", "numbers", "facts", "argument", "method",
                    "witness", "software", "digest"});
  for (const char* key : {"inputs", "numbers", "witness", "software"}) {
    if (!root[key].value().is_object()) root[key].malformed("it must be an object");
  }
  if (check_inputs != nullptr) {
    root["reference"].expect_text("");
    expect_software(root["software"]);
    return check_inputs(root, result);
  }
  examination e(root, *text, result);
  e.expect_words();
  text->check(e);
  e.finish();
}

}  // namespace

std::string to_text(outcome result) {
  switch (result) {
    case outcome::verified:
      return "verified";
    case outcome::verified_in_part:
      return "verified in part";
    case outcome::not_checkable:
      return "not checkable";
    case outcome::refuted:
      return "refuted";
    case outcome::malformed:
      break;
  }
  return "malformed";
}

report check(std::string_view certificate, const limits& most) {
  report result;
  budget work(most);
  try {
    work.hold(static_cast<long>(certificate.size()));
    check_document(read_json(certificate, work), result, work);
    result.result = result.left_out.empty() ? outcome::verified : outcome::verified_in_part;
  } catch (const refusal& problem) {
    result.result = problem.result;
    result.place = problem.place;
    result.message = problem.what();
  } catch (const undecided& problem) {
    result.result = outcome::not_checkable;
    result.message = problem.what();
  } catch (const std::bad_alloc&) {
    result.result = outcome::not_checkable;
    result.message = "there is not enough memory";
  }
  if (!result.is_verified()) {
    result.subject.clear();
    result.statement.clear();
    result.grounds.clear();
    result.tier.clear();
  }
  result.work = work.spent();
  result.memory = work.most_held();
  return result;
}

}  // namespace polhode::checker
