#pragma once

// What the claims about a given body share.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/rigid_body/body.hpp"
#include "proofs/claim.hpp"

namespace polhode::proofs {

/// The body that is asked for; its a and b go to the certificate's inputs, or where these are
/// irrational its tensor.
[[nodiscard]] body requested_body(certificate& c, const request& wanted);

/// Adds a number to the digits asked for. Where none of the precisions tried has them it is
/// undefined, and the certificate will not be certified.
void add_number(certificate& c, const std::string& name, const enclosing_function& f, long digits,
                const body& rigid);

/// Adds I or J: as a fact where it is rational, else as a number.
void add_geometric_constant(certificate& c, const body& rigid, long digits);
void add_second_geometric_constant(certificate& c, const body& rigid, long digits);

/// Whether condition(p), a conclusion from enclosures of about p bits, is reached for one of p =
/// 128, 512, 2048, 8192.
[[nodiscard]] bool is_decided(const std::function<bool(precision p)>& condition);

/// G(u) = F(-b u, u), half the Montgomery phase of oscillating motion, to about p bits; 0 < u < 1.
[[nodiscard]] ball half_phase(const body& rigid, const rational& u, precision p);

/// Two rational numbers in (0, 1), lower < upper, between which a decreasing function passes a
/// value.
struct root_bracket {
  rational lower;  // f(lower) > target, proved
  rational upper;  // f(upper) < target, proved
};

/// A number between lower and upper, 0 < lower < upper < 1: in the middle of the exponents while
/// the distances from 0, or from 1, are of different orders, then the mean.
[[nodiscard]] rational between(const rational& lower, const rational& upper);

/// A bracket with upper - lower of about 2^-bits of the distances from 0 and 1, for a function that
/// decreases strictly on (0, 1). Nothing where none was found (no proof that there is none): the
/// ends are sought among 2^-k and 1 - 2^-k, k <= 4096.
[[nodiscard]] std::optional<root_bracket> bracket_root(
    const std::function<ball(const rational& s, precision p)>& f,
    const std::function<ball(precision p)>& target, int bits = 40);

/// Says at the end of the method that the theorem stands without this witness for the given body.
void note_missing_witness(certificate& c, const std::string& what);

/// Adds a number that illustrates a theorem and that its proof does not need: a note where it has
/// not the digits asked for.
void add_number_or_note(certificate& c, const std::string& name, const enclosing_function& f,
                        long digits, const body& rigid);

/// Encloses the certificate's last two numbers, f and g, with more bits until they are apart: the
/// checker compares what the certificate holds. Does nothing where it has not both, and leaves them
/// as they are where no number of bits that the checker takes is enough.
void part_last_numbers(certificate& c, const std::string& f_name, const enclosing_function& f,
                       const std::string& g_name, const enclosing_function& g);

/// less < greater, as enclosures.
struct comparison {
  ball less;
  ball greater;
};

/// Adds the fact that all comparisons hold, which illustrates a theorem and which its proof does
/// not need. A certain opposite makes it a fact that does not hold; where 128, 512, 2048, 8192 bits
/// decide neither, there is a note that `what` is missing.
void add_comparisons(certificate& c, const std::string& statement, const std::string& what,
                     const std::function<std::vector<comparison>(precision p)>& comparisons);

/// "0.1234567890 and 0.1234567891": both ends, each rounded outward.
[[nodiscard]] std::string in_decimals(const root_bracket& bracket);
[[nodiscard]] json as_json(const root_bracket& bracket);

}  // namespace polhode::proofs
