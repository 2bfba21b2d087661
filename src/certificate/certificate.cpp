#include "polhode/certificate/certificate.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <gmp.h>
#include <mpfr.h>
#include <boost/version.hpp>

#include "base/sha256.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/digest.hpp"
#include "polhode/version.hpp"

namespace polhode {
namespace {

/// q = mantissa * 2^exponent with an odd mantissa (0 is 0 * 2^0). Hypothesis: q is dyadic.
json dyadic(const rational& q) {
  integer mantissa = numerator(q);
  long exponent = -static_cast<long>(msb(integer(denominator(q))));
  if (mantissa != 0) {
    const auto twos = lsb(integer(abs(mantissa)));
    mantissa >>= twos;
    exponent += static_cast<long>(twos);
  } else {
    exponent = 0;
  }
  return json{{"mantissa", mantissa.str()}, {"exponent", exponent}};
}

bool has_digits(const enclosed_number& n) {
  if (!n.enclosure.is_bounded()) return false;
  return to_decimal_enclosure(n.enclosure, n.digits).has(n.digits);
}

/// Text in lines of at most `width` columns, broken at spaces, each indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width = 100) {
  std::string result;
  std::string line(indent, ' ');
  const std::string margin = line;
  std::size_t start = 0;
  while (start < text.size()) {
    auto end = text.find(' ', start);
    if (end == std::string::npos) end = text.size();
    const std::string word = text.substr(start, end - start);
    if (line.size() > indent && line.size() + 1 + word.size() > width) {
      result += line + '\n';
      line = margin;
    }
    if (line.size() > indent) line += ' ';
    line += word;
    start = end + 1;
  }
  if (line.size() > indent) result += line + '\n';
  return result;
}

/// "  [enclosed] " and the statement, in lines under each other.
std::string marked(const std::string& mark, const std::string& statement) {
  constexpr std::size_t margin = 13;
  std::string lines = wrapped(statement, margin);
  std::string first = "  [" + mark + ']';
  first.resize(margin, ' ');
  return lines.replace(0, margin, first);
}

/// A long decimal in rows of 90 characters.
std::string rows(const std::string& digits, std::size_t indent) {
  constexpr std::size_t width = 90;
  std::string result;
  for (std::size_t i = 0; i < digits.size(); i += width) {
    result += std::string(indent, ' ') + digits.substr(i, width) + '\n';
  }
  return result;
}

}  // namespace

std::string digest_of(const std::string& text) {
  std::string result = "sha256:";
  for (const std::uint8_t byte : sha256(std::as_bytes(std::span(text)))) {
    result += fmt::format("{:02x}", byte);
  }
  return result;
}

void certificate::conclude(reason otherwise) {
  const bool facts_hold =
      std::all_of(facts.begin(), facts.end(), [](const checked_fact& f) { return f.holds; });
  const bool digits_reached = std::all_of(numbers.begin(), numbers.end(), has_digits);
  const bool says_something = !facts.empty() || !numbers.empty();
  if (says_something && facts_hold && digits_reached) {
    verdict = status::certified;
    why = reason::none;
  } else {
    verdict = status::not_certified;
    why = otherwise;
  }
}

std::vector<step_kind> certificate::rests_on() const {
  std::vector<step_kind> result;
  for (const step_kind kind : {step_kind::exact, step_kind::enclosed, step_kind::kernel,
                               step_kind::argued, step_kind::cited}) {
    const auto is_it = [kind](const auto& step) { return step.kind == kind; };
    if ((kind == step_kind::enclosed && !numbers.empty()) ||
        std::any_of(facts.begin(), facts.end(), is_it) ||
        std::any_of(argument.begin(), argument.end(), is_it)) {
      result.push_back(kind);
    }
  }
  return result;
}

std::string to_text(step_kind k) {
  switch (k) {
    case step_kind::exact:
      return "decided exactly";
    case step_kind::enclosed:
      return "enclosed";
    case step_kind::kernel:
      return "proved in Coq";
    case step_kind::argued:
      return "argued in words";
    case step_kind::cited:
      break;
  }
  return "cited";
}

std::string to_text(proof_tier t) {
  switch (t) {
    case proof_tier::by_kernel:
      return "by Coq's kernel";
    case proof_tier::by_machine:
      return "by machine";
    case proof_tier::with_words:
      break;
  }
  return "by machine, joined in words";
}

json to_json(const ball& x, long digits) {
  if (!x.is_bounded()) {
    return json{{"value", nullptr},
                {"radius", nullptr},
                {"lower", nullptr},
                {"upper", nullptr},
                {"digits", 0}};
  }
  const decimal_enclosure d = to_decimal_enclosure(x, digits);
  json result{{"value", d.value},
              {"radius", d.radius},
              {"lower", d.lower},
              {"upper", d.upper},
              {"digits", d.digits}};
  if (!d.cut) result["rounded"] = true;
  if (d.exact) result["exact"] = true;
  return result;
}
json to_json(const complex_ball& z, long digits) {
  return {{"real", to_json(z.re, digits)}, {"imaginary", to_json(z.im, digits)}};
}

json to_dyadic_json(const ball& x) {
  if (!x.is_bounded()) return nullptr;
  return json{{"lower", dyadic(lower_rational(x))}, {"upper", dyadic(upper_rational(x))}};
}

json to_json(const certificate& c) {
  json result;
  result["format"] = "polhode certificate";
  result["version"] = 4;
  result["claim"] = c.claim;
  result["statement"] = c.statement;
  result["formula"] = c.formula;
  result["reference"] = c.reference;
  result["verdict"] = to_text(c.verdict);
  if (c.verdict != status::certified) result["reason"] = to_text(c.why);
  result["tier"] = to_text(c.tier);
  result["rests_on"] = json::array();
  for (const step_kind kind : c.rests_on()) result["rests_on"].push_back(to_text(kind));
  result["inputs"] = json::object();
  for (const auto& [name, value] : c.inputs) result["inputs"][name] = to_text(value);
  result["numbers"] = json::object();
  for (const auto& n : c.numbers) {
    json number = to_json(n.enclosure, n.digits);
    number["digits_asked"] = n.digits;
    number["dyadic"] = to_dyadic_json(n.enclosure);
    result["numbers"][n.name] = std::move(number);
  }
  result["facts"] = json::array();
  for (const auto& f : c.facts) {
    result["facts"].push_back(
        json{{"statement", f.statement}, {"holds", f.holds}, {"kind", to_text(f.kind)}});
  }
  result["argument"] = json::array();
  for (const auto& s : c.argument) {
    result["argument"].push_back(json{{"kind", to_text(s.kind)}, {"statement", s.statement}});
  }
  result["method"] = c.method;
  result["witness"] = c.witness;
  result["software"] =
      json{{"polhode", POLHODE_VERSION},
           {"mpfr", mpfr_get_version()},
           {"gmp", gmp_version},
           {"boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                                 BOOST_VERSION % 100)}};
  result["digest"] = digest_of(result.dump());
  return result;
}

json to_json(const certificate& c, const std::vector<std::pair<std::string, std::string>>& inputs) {
  json result = to_json(c);
  result["inputs"] = json::object();
  for (const auto& [name, text] : inputs) result["inputs"][name] = text;
  result.erase("digest");
  result["digest"] = digest_of(result.dump());
  return result;
}

std::string to_text(const certificate& c) {
  std::string result = c.claim + ": " + to_text(c.verdict);
  if (c.verdict != status::certified) {
    result += " (" + to_text(c.why) + ")";
  } else {
    result += ' ' + to_text(c.tier);
    if (c.tier == proof_tier::by_kernel) result += " (not run here: scripts/check-coq runs it)";
  }
  result += '\n' + wrapped(c.statement, 2) + wrapped(c.formula, 4) + wrapped(c.reference, 4);
  for (const auto& [name, value] : c.inputs) {
    result += fmt::format("    {} = {}\n", name, to_text(value));
  }
  for (const auto& n : c.numbers) {
    result += "  " + n.name + " =\n" + rows(to_decimal(n.enclosure, n.digits), 4);
  }
  for (const auto& f : c.facts) {
    result += marked(!f.holds                     ? "FAILS"
                     : f.kind == step_kind::exact ? "exact"
                                                  : "enclosed",
                     f.statement);
  }
  for (const auto& s : c.argument) {
    result += marked(s.kind == step_kind::kernel   ? "Coq"
                     : s.kind == step_kind::argued ? "in words"
                                                   : "cited",
                     s.statement);
  }
  result += "  method:\n" + wrapped(c.method, 4);
  std::string kinds;
  for (const step_kind kind : c.rests_on()) {
    kinds += (kinds.empty() ? "" : ", ") + to_text(kind);
  }
  return result + "  rests on: " + kinds + '\n';
}

}  // namespace polhode
