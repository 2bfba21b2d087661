#include "figure.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cli/output/exact_decimals.hpp"
#include "cli/output/gnuplot.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode::cli {
namespace {

/// Longer decimals of an exact number are written as an enclosure.
constexpr long digits_of_exact = 100;

decimal_enclosure decimals(const coordinate& x, long digits) {
  if (const auto* exact = std::get_if<rational>(&x)) {
    const leading_digits d = leading_digits_of(*exact, digits_of_exact);
    if (d.all) return exact_decimals(d);
    return to_decimal_enclosure(ball(*exact, bits_for_digits(digits) + 64), digits);
  }
  return to_decimal_enclosure(std::get<ball>(x), digits);
}

std::string csv_cells(const coordinate& x, long digits) {
  const decimal_enclosure d = decimals(x, digits);
  return fmt::format("{},{},{}", d.value, d.lower, d.upper);
}

rational width_of(const coordinate& x, long digits) {
  const decimal_enclosure d = decimals(x, digits);
  return parse_rational(d.upper) - parse_rational(d.lower);
}

/// Two significant digits, rounded up.
std::string rounded_up(const rational& q) {
  if (q == 0) return "0";
  rational unit = 1;
  long exponent = 0;
  for (; q >= 10 * unit; ++exponent) unit *= 10;
  for (; q < unit; --exponent) unit /= 10;
  integer digits = ceil_of(rational(10 * q / unit));
  if (digits == 100) {
    digits = 10;
    ++exponent;
  }
  return fmt::format("{}.{}e{}", integer(digits / 10).str(), integer(digits % 10).str(), exponent);
}

/// Enough for a picture; gnuplot reads hardware doubles.
std::string drawn(const coordinate& x) {
  constexpr long digits = 12;
  return decimals(x, digits).value;
}

std::string data_of(const figure_curve& curve) {
  std::string result;
  for (const auto& part : curve.parts) {
    for (const figure_point& p : part) result += drawn(p.x) + ' ' + drawn(p.y) + '\n';
    result += '\n';  // gnuplot joins nothing across an empty line
  }
  return result;
}

std::string terminal(picture_format format) {
  return format == picture_format::svg
             ? "set terminal svg size 900,700 font 'Helvetica,15' background 'white'\n"
             : "set terminal pngcairo size 1350,1050 font 'Sans,16' linewidth 1.5 pointscale 2 "
               "background "
               "'white'\n";
}

}  // namespace

std::string csv_of(const figure& f, const figure_content& content, long digits) {
  std::string result =
      fmt::format("curve,part,{0},{0}_lower,{0}_upper,{1},{1}_lower,{1}_upper\n", f.x, f.y);
  for (const figure_curve& curve : content.curves) {
    for (std::size_t part = 0; part < curve.parts.size(); ++part) {
      for (const figure_point& p : curve.parts[part]) {
        result += fmt::format("{},{},{},{}\n", curve.name, part + 1, csv_cells(p.x, digits),
                              csv_cells(p.y, digits));
      }
    }
  }
  return result;
}

std::string greatest_width(const figure_content& content, long digits) {
  rational greatest = 0;
  for (const figure_curve& curve : content.curves) {
    for (const auto& part : curve.parts) {
      for (const figure_point& p : part) {
        greatest = std::max({greatest, width_of(p.x, digits), width_of(p.y, digits)});
      }
    }
  }
  return rounded_up(greatest);
}

std::string draw(const figure& f, const figure_content& content, const std::string& width,
                 picture_format format) {
  std::string csv_name;  // an underscore would lower the next letter
  for (const char c : f.name) csv_name += c == '_' ? std::string("\\\\_") : std::string(1, c);
  std::string program = terminal(format) + "set encoding utf8\nset grid lc rgb '#dddddd'\n";
  program += fmt::format(
      "set title \"F{}: {}{}\\n{{/*0.85 Every coordinate certified to within {}: {}.csv has the "
      "enclosures.}}\"\n",
      f.place.substr(1), f.shows, f.note.empty() ? "" : "\\n" + f.note, width, csv_name);
  // The legend is beneath the frame, where no curve runs, in two columns. gnuplot takes letters for
  // wider than they are.
  std::size_t entries = 0;
  std::size_t longest = 0;
  for (const figure_curve& curve : content.curves) {
    for (const auto& [style, title] : curve.drawings) {
      entries += title.empty() ? 0 : 1;
      const auto begins_letter = [](char c) { return (c & 0xc0) != 0x80; };  // of UTF-8
      const auto letters = std::count_if(title.begin(), title.end(), begins_letter);
      longest = std::max(longest, static_cast<std::size_t>(letters));
    }
  }
  program += fmt::format(
      "set key bmargin center vertical maxrows {} height 1 reverse Left samplen 3 width -{}\n",
      std::max<std::size_t>(2, (entries + 1) / 2), longest / 5);
  program += content.settings;
  std::string plots;
  for (std::size_t i = 0; i < content.curves.size(); ++i) {
    const figure_curve& curve = content.curves[i];
    program += fmt::format("$curve{} << EOD\n{}EOD\n", i, data_of(curve));
    for (const auto& [style, title] : curve.drawings) {
      plots += fmt::format("{}$curve{} with {} {}", plots.empty() ? "plot " : ", ", i, style,
                           title.empty() ? "notitle" : "title \"" + title + '"');
    }
  }
  return run_gnuplot(program + plots + '\n', "give --data-only");
}

}  // namespace polhode::cli
