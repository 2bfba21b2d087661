#pragma once

// Numbers as decimals, for output.

#include <string>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/exact_real.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/certificate/certificate.hpp"

namespace polhode::cli {

/// The leading digits of a number's decimal expansion, cut off.
struct leading_digits {
  std::string value;
  long digits = 0;
  bool all = false;  // nothing but zeros would follow
};
[[nodiscard]] leading_digits leading_digits_of(const rational& q, long most);

/// Whether a rational number is written out in full: where a part has no more digits than were
/// asked for, or than a line.
[[nodiscard]] bool is_short(const rational& q, long digits);

/// Dots behind the digits, and before an exponent, where more digits would follow.
[[nodiscard]] std::string with_dots(const leading_digits& d);

/// All its decimals where these are at most so many, else the quotient.
[[nodiscard]] std::string exact_text(const rational& q, long digits);

/// In one line: "1/3 exactly", "1e-300 exactly"; "0.333..." where the quotient is long.
[[nodiscard]] std::string exact_number_text(const rational& q, long digits);

/// A command's answer, in lines: "1/3 exactly" and its decimals; only the decimals, said to be of a
/// number that is exactly known, where the quotient is long.
[[nodiscard]] std::string exact_answer(const rational& q, long digits);

/// Two cells for a table that other programs read: a decimal, cut off where it does not end, and
/// the quotient.
[[nodiscard]] std::string csv_cells(const rational& q);
/// The same; of an irrational number the decimal alone, and an empty cell.
[[nodiscard]] std::string csv_cells(const exact_real& x);
/// Their headers: "c,c_exact".
[[nodiscard]] std::string csv_header(const std::string& name);

/// All its decimals, where nothing else follows, as what every number is printed as.
[[nodiscard]] decimal_enclosure exact_decimals(const leading_digits& d);

/// Its decimals, as every number has them, with "exact": true and the quotient under "rational".
[[nodiscard]] json exact_json(const rational& q, long digits);
/// The same; of an irrational number its enclosure.
[[nodiscard]] json exact_json(const exact_real& x, long digits);

/// "real part ..." and "imaginary part ...", in two lines; "undefined" where it is not bounded.
[[nodiscard]] std::string text_of_parts(const complex_ball& z, long digits);

/// The decimal to so many digits, cut off.
[[nodiscard]] std::string decimal_of(const exact_real& x, long digits);

}  // namespace polhode::cli
