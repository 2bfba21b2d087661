#pragma once

// Certificates, checked again by a program that shares no mathematics with the one that wrote them:
// whole numbers and rationals of GMP, and a reader of JSON. It knows by its name what each claim
// says, repeats the argument from the certificate's inputs and witness, and compares.
// docs/certificates.md describes the form, and what is repeated how.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::checker {

enum class outcome {
  verified,  // every step of it that a program decides was shown again
  // So was what the certificate says; but it leaves out a part of its claim (report::left_out).
  verified_in_part,
  not_checkable,  // this checker cannot repeat some of it; nothing was found wrong
  refuted,        // something in it is not so, or is not what a certificate of this claim says
  malformed,      // it is no certificate of a form and a claim that this version knows
};

/// "verified", "verified in part", "not checkable", "refuted", "malformed".
[[nodiscard]] std::string to_text(outcome result);

/// What one check may cost. Both are counted from the sizes of operands, never measured: a
/// certificate costs the same on every machine.
struct limits {
  long work = 20'000'000'000;  // operations on 64-bit words; more than a thousand million a second
  long memory = long{1024} << 20U;  // bytes
};

struct report {
  outcome result = outcome::malformed;
  std::string claim;    // empty where it was not read
  std::string place;    // JSON pointer of what is wrong, "/numbers/beta/lower"
  std::string message;  // what is wrong there and what would be right
  /// Of a verified one: what it is of, in words ("integral"; "claim \"crossing\" for the
  /// non-physical body a = 3, b = 1/4").
  std::string subject;
  /// Of a verified one: what was shown, a sentence a line, with all inputs and all numbers, in the
  /// checker's own words.
  std::vector<std::string> statement;
  /// Of a verified one: the kinds of its steps, each of "decided exactly", "enclosed", "argued in
  /// words" and "cited" that occurs, in this order.
  std::vector<std::string> grounds;
  /// Of a verified claim: how much of its proof a machine decides, "by machine", "by machine,
  /// joined in words", "by Coq's kernel".
  std::string tier;
  std::vector<std::string> checks;  // what was shown again on the way, in words
  /// What the certificate leaves out of the claim's numbers and facts, as not found by the prover.
  std::vector<std::string> left_out;
  long work = 0;    // what the check cost, in the units of `limits`
  long memory = 0;  // the most bytes that were held at a time

  /// What the certificate says was shown again, be it all that its claim says or not.
  [[nodiscard]] bool is_verified() const {
    return result == outcome::verified || result == outcome::verified_in_part;
  }
};

/// The greatest certificate that is read, in bytes.
inline constexpr std::size_t most_certificate_bytes = std::size_t{64} << 20U;

/// Checks one certificate, given as JSON text. Never throws for what the text holds. Where it would
/// cost more than `most`, and where numbers have more than 100,000 digits, it is not checkable, and
/// the report names the place.
[[nodiscard]] report check(std::string_view certificate, const limits& most = {});

}  // namespace polhode::checker
