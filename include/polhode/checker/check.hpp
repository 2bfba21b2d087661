#pragma once

// Certificates, checked again by a program that shares nothing with the one that wrote them: whole numbers and rationals of GMP, and a
// reader of JSON. It knows by its name what each claim says, repeats the argument from the certificate's inputs and witness, and
// compares. docs/certificates.md describes the form, and what is repeated how.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::checker {

enum class outcome {
  verified,       // everything that the certificate says was shown again
  not_checkable,  // this checker cannot repeat some of it; nothing was found wrong
  refuted,        // something in it is not so, or is not what a certificate of this claim says
  malformed,      // it is no certificate of a form and a claim that this version knows
};

/// "verified", "not checkable", "refuted", "malformed".
[[nodiscard]] std::string to_text(outcome result);

struct report {
  outcome result = outcome::malformed;
  std::string claim;                // empty where it was not read
  std::string place;                // JSON pointer of what is wrong, "/numbers/beta/lower"
  std::string message;              // what is wrong there and what would be right
  std::vector<std::string> checks;  // what was shown, in words
  /// What the certificate leaves out of the claim's numbers and facts, as not found by the prover. The claim is shown without.
  std::vector<std::string> left_out;
};

/// The greatest certificate that is read, in bytes.
inline constexpr std::size_t most_certificate_bytes = std::size_t{64} << 20U;

/// Checks one certificate, given as JSON text. Never throws for what the text holds; time and memory are bounded by a
/// power of its length. Numbers of more than 100,000 digits are not checkable.
[[nodiscard]] report check(std::string_view certificate);

}  // namespace polhode::checker
