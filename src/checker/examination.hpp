#pragma once

// One certificate under examination: its parts in the order in which a claim's check asks for them.
// Whatever is left over at the end is refused too.

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "body.hpp"
#include "claim.hpp"
#include "document.hpp"
#include "interval.hpp"

namespace polhode::checker {

/// Two rationals, lower <= upper.
struct range {
  rational lower;
  rational upper;
};

/// So many bits tell apart numbers of so many decimal digits.
[[nodiscard]] long bits_for_digits(long digits);
/// That `where` is a decimal of at most `digits` significant digits within two units of the last of
/// them from the end, outward.
void expect_outward(const place& where, const rational& end, long digits, rounding way);
/// That the decimals `lower` and `upper` are outward of the exact ends, by no more than these are
/// apart and a unit of the third digit beyond those asked for.
void expect_near(const place& number, const range& exact, long digits);
/// That value - radius <= lower and upper <= value + radius, exactly, of the decimals at `where`,
/// and that the radius is not twice what it must be.
void expect_radius(const place& where);
/// Of a value that is rounded: that its radius is at most one unit of the last of its `digits`.
void expect_rounded_digits(const place& where, long digits);
/// That f(bits) lies in the range for some bits from `bits` on. Returns its ends.
range expect_inside(const place& where, const range& r, long bits,
                    const std::function<interval(precision bits)>& f);
/// "it is between 3.1415 and 3.1416": the ends rounded outward, to few more digits than they share.
[[nodiscard]] std::string in_between(const std::string& it, const range& r, long digits,
                                     budget& work);
/// The versions: that they are texts.
void expect_software(const place& software);

/// How a fact was decided: the kinds of a certificate's facts.
inline constexpr const char* decided_exactly = "decided exactly";
inline constexpr const char* enclosed = "enclosed";

/// That a certificate says of its proof that it is of this tier and rests on this: the kinds of its
/// steps, and what is argued and cited.
void expect_grounds(const place& certificate, std::string_view tier,
                    const std::vector<stated_text>& argument);
/// The kinds of steps that a certificate rests on, after expect_grounds.
[[nodiscard]] std::vector<std::string> grounds_of(const place& certificate);

class examination {
 public:
  examination(place certificate, const claim& text, report& result)
      : root_(std::move(certificate)), text_(text), report_(result) {}

  [[nodiscard]] budget& work() const { return root_.work(); }

  /// Statement, formula and reference are the claim's.
  void expect_words();

  // Inputs ------------------------------------------------------------------------------------
  /// a > 0 and 0 < b < 1, or an inertia tensor, and u in (0, 1] where it is asked for; no other
  /// inputs.
  void read_body();
  void read_motion();
  void read_no_inputs();
  [[nodiscard]] const body& rigid() const { return body_; }
  [[nodiscard]] const rational& u() const { return u_; }
  /// What the inputs cost in bits beside those of the result.
  [[nodiscard]] long input_bits() const;

  // Facts -------------------------------------------------------------------------------------
  /// The next fact: its words must be these, and it must hold.
  place fact(const std::string& statement, const char* kind);
  /// The next fact, and that `shown` shows it: tried with more and more bits while it throws
  /// undecided or returns nothing; false refutes the fact.
  void fact(const std::string& statement,
            const std::function<std::optional<bool>(precision bits)>& shown);
  /// The same of what is decided exactly here; `kind` is how the prover decided it.
  void fact(const std::string& statement, bool shown, const char* kind = decided_exactly);
  /// Whether the method says that `what` was not found for the given body: then there is no such
  /// fact.
  bool is_missing(const std::string& what);
  void add_to_method(const std::string& sentence) { notes_ += sentence; }
  /// The claim's polynomial steps: decided again, and compared with facts and witness.
  void steps();

  // Numbers -----------------------------------------------------------------------------------
  /// The next number, of that name, which must hold all of f(bits) for some bits. Returns its exact
  /// ends.
  range number(const std::string& name, const std::function<interval(precision bits)>& f);
  /// The next number, the root of a function with these signs at the number's ends: f is certainly
  /// positive at the lower and negative at the upper end if it decreases, and the other way round.
  range root_number(const std::string& name, bool decreases,
                    const std::function<interval(const rational& x, precision bits)>& f);
  /// The digits that all numbers so far were asked for.
  [[nodiscard]] long digits() const { return digits_; }

  // Witness -----------------------------------------------------------------------------------
  [[nodiscard]] place witness(const std::string& key);
  /// {"lower": "p/q", "upper": "r/s"}, lower < upper.
  static range bracket(const place& where);
  /// {"lower": {"mantissa", "exponent"}, "upper": ...}.
  static range dyadic_range(const place& where);
  /// {"value", "radius", "lower", "upper", "digits"}, and perhaps "rounded": decimals that hold
  /// f(bits) for some bits.
  static range decimals(const place& where, const std::function<interval(precision bits)>& f);

  /// The method, that nothing is left of facts, numbers and witness, and the digest.
  void finish();

 private:
  struct ends {
    place where;
    range exact;
    long bits;  // that tell the ends apart
  };
  void read_a_and_b();
  void read_tensor();
  ends next_number(const std::string& name);

  place root_;
  const claim& text_;
  report& report_;
  body body_{1, 1};
  rational u_;
  std::size_t facts_ = 0;
  std::size_t numbers_ = 0;
  long digits_ = 0;
  std::string notes_;
  std::vector<std::string> witness_keys_;
};

/// lower < q pi < upper in words of the claims: "2 pi/3", "pi".
[[nodiscard]] std::string multiple_of_pi(const rational& q);
/// "0.1234567890123 and 0.1234567890124": both ends, rounded outward.
[[nodiscard]] std::string in_decimals(const range& r, budget& work);

}  // namespace polhode::checker
