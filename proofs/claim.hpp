#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/certificate/certificate.hpp"
#include "polhode/rigid_body/body.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "statements/claim_text.hpp"

namespace polhode::proofs {

/// What a claim is asked for.
struct request {
  long digits = 50;  // significant digits of every number in the claim
  oscillating_motion motion{rational(1265, 100), rational(629, 10000), rational(1, 4)};
  /// The tensor of which a and b of the motion are, where these are irrational.
  std::shared_ptr<const inertia_tensor> tensor{};
};

/// What of the request the proof's numbers depend on: nothing, the body (a and b), or the body and
/// its motion (u).
enum class claim_subject { none, body, motion };

/// One statement of the paper and what proves it.
struct claim : statements::claim_text {
  /// Certificates without the claim's text, which all_claims() adds.
  std::function<certificate(const request&)> prove;
  claim_subject subject = claim_subject::none;  // as statements/list.hpp has it
};

/// All claims, in the order of the paper.
[[nodiscard]] const std::vector<claim>& all_claims();

/// The claim of that name, or nullptr.
[[nodiscard]] const claim* find_claim(std::string_view name);

/// The heading of the table of claims in proofs/README.md, in Markdown: two lines.
[[nodiscard]] std::string table_heading();
/// A claim's row, but for its last two cells, time and verdict: "| `beta` | eq. (40) | ... |
/// `polhode certify beta` |".
[[nodiscard]] std::string table_row(const claim& c);

/// A constant of the paper, to any number of digits.
struct constant {
  std::string name;
  std::string description;  // with its formula
  /// An enclosure computed with about p bits; its radius shrinks like 2^-p.
  std::function<ball(precision p)> enclose;
  /// Numbers of full length held at once, for estimating memory.
  int live_numbers = 0;
  /// The same by another formula with other functions, named in `second_route`.
  std::string second_route = {};
  std::function<ball(precision p)> enclose_again = {};
};

[[nodiscard]] const std::vector<constant>& all_constants();
[[nodiscard]] const constant* find_constant(const std::string& name);

/// An enclosure of the constant with at least `digits` certain significant digits: working
/// precision is raised until they are certain. Undefined if they are not at a precision of 16 times
/// that many bits.
[[nodiscard]] ball enclose_to_digits(const constant& c, long digits);

/// Bytes needed at most, about, to enclose the constant to that many digits. Measured, not proved.
[[nodiscard]] double estimated_memory(const constant& c, long digits);

}  // namespace polhode::proofs
