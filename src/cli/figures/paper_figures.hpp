#pragma once

// What the figures of the paper have in common: styles of gnuplot, numbers to so many certain
// digits, sets of motions, curves. All that takes `digits` throws not_certified_error where so many
// are not reached.

#include <string>
#include <vector>

#include "figure.hpp"
#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/tennis_racket.hpp"

namespace polhode::cli::paper {

// ---------------------------------------------------------------------------------------------
// Styles

inline constexpr const char* black = "black";
inline constexpr const char* blue = "#1f4fa0";
inline constexpr const char* green = "#2e8b3d";
inline constexpr const char* grey = "#888888";
inline constexpr const char* magenta = "#b0209a";
inline constexpr const char* purple = "#7030a0";
inline constexpr const char* red = "#c02a1e";

[[nodiscard]] std::string solid(const char* colour);
[[nodiscard]] std::string dashed(const char* colour);
[[nodiscard]] std::string thin(const char* colour);
[[nodiscard]] std::string discs(const char* colour);
[[nodiscard]] std::string circles(const char* colour);

inline constexpr const char* axis_of_c = "set xlabel \"c = 2 I_y H/J^2 − 1\"\n";
inline constexpr const char* axis_of_epsilon = "set ylabel \"ε (radians)\"\n";

// ---------------------------------------------------------------------------------------------
// Numbers

inline constexpr long digits_of_names = 20;

[[nodiscard]] inline rational number(const char* text) { return parse_rational(text); }

/// Where nothing cancels: the precision is raised until the digits are certain.
[[nodiscard]] ball enclosed(const enclosing_function& f, const std::string& what, long digits);

[[nodiscard]] coordinate negated(const coordinate& x);
[[nodiscard]] coordinate multiple_of_pi(const rational& factor, long digits);
/// x + pi
[[nodiscard]] coordinate shifted_by_pi(const coordinate& x, long digits);

/// n + 1 numbers at equal distances, both ends included.
[[nodiscard]] std::vector<rational> equally_spaced(const rational& low, const rational& high,
                                                   long n);
/// end (k/n)^2 for k = 1, ..., n - 1: dense near 0.
[[nodiscard]] std::vector<rational> dense_near_zero(const rational& end, long n);
/// start + side 10^-k {1, 2, 5}, down to 10^-smallest, where that is in the range.
[[nodiscard]] std::vector<rational> approaching(const rational& start, int side, long smallest,
                                                const rational& low, const rational& high);
/// All numbers of the sets, ascending, each once.
[[nodiscard]] std::vector<rational> merged(std::vector<std::vector<rational>> sets);

// ---------------------------------------------------------------------------------------------
// Curves

[[nodiscard]] figure_curve straight(const std::string& name, const std::string& style,
                                    const figure_point& from, const figure_point& to,
                                    const std::string& title = "");

/// S from epsilon = 0 to pi/2, and its mirror up to pi: c = -b sin^2 epsilon. For b = 1 it is beta
/// over epsilon.
[[nodiscard]] figure_curve turning_curve(const rational& b, bool with_mirror,
                                         const std::string& title, long digits);

/// (c, epsilon(c))
[[nodiscard]] std::vector<figure_point> twists(const body& rigid,
                                               const std::vector<rational>& motions, long digits);
/// (c, the Montgomery phase)
[[nodiscard]] std::vector<figure_point> phases(const body& rigid,
                                               const std::vector<rational>& motions, long digits);
[[nodiscard]] ball phase_limit(const body& rigid, const rational& c, long digits);

/// "1.0479..."
[[nodiscard]] std::string geometric_constant_of(const body& rigid);
[[nodiscard]] std::string second_geometric_constant_of(const body& rigid);
/// "a = 12.65 (physical): I = 1.0479..."
[[nodiscard]] std::string with_constant(const std::string& a, const body& rigid);

// ---------------------------------------------------------------------------------------------
// The figures

/// Figures 2, 4 and 5 are schematic in print; here they are of the body with moments 4, 3, 2.
[[nodiscard]] body schematic_body();

[[nodiscard]] figure_content reduced_phase_space(long digits);     // figure 2
[[nodiscard]] figure_content montgomery_oscillating(long digits);  // figure 3 (a)
[[nodiscard]] figure_content montgomery_rotating(long digits);     // figure 3 (b)
[[nodiscard]] figure_content phase_space(long digits);             // figure 4
[[nodiscard]] figure_content first_equation(long digits);          // figure 5
[[nodiscard]] figure_content injectivity(long digits);             // figure 6
[[nodiscard]] figure_content varying_a(long digits);               // figure 7
[[nodiscard]] figure_content varying_a_as_printed(long digits);    // figure 7
[[nodiscard]] figure_content limit(long digits);                   // figure 8

}  // namespace polhode::cli::paper
