#include "values.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "polhode/arithmetic/text.hpp"

namespace polhode::differential {
namespace {

/// An enclosure of the value, by one route.
struct known_value {
  std::string how;
  ball enclosure;
};

ball from_doubles(double lower, double upper) {
  const auto at = [](double v) {
    detail::mpfr_cell cell(53);
    mpfr_set_d(cell.get(), v, MPFR_RNDN);
    return cell;
  };
  return ball::from_end_points(at(lower).get(), at(upper).get(), 53);
}

/// The first number in t that is not 0 or 1: in its place a variable is put, so that nothing of it
/// is worked out in advance.
std::optional<term> first_number(const term& t) {
  if (t.is_leaf()) {
    const bool is_number = t.head().find_first_not_of("0123456789./e-") == std::string::npos &&
                           t.head() != "e" && !t.is("0") && !t.is("1");
    return is_number ? std::optional(t) : std::nullopt;
  }
  // Whole exponents and orders stay what they are.
  const bool is_order = t.head() == "^" || t.head() == "root" || t.head() == "zeta";
  for (std::size_t i = 0; i < (is_order ? 1 : t.parts().size()); ++i) {
    if (auto found = first_number(t.parts()[i])) return found;
  }
  return std::nullopt;
}

/// t with v for the first number, and for no other.
term with_variable(const term& t, bool& done) {
  if (t.is_leaf()) {
    if (done || !first_number(t)) return t;
    done = true;
    return "v";
  }
  const bool is_order = t.head() == "^" || t.head() == "root" || t.head() == "zeta";
  std::vector<term> parts = t.parts();
  for (std::size_t i = 0; i < (is_order ? 1 : parts.size()); ++i) {
    parts[i] = with_variable(parts[i], done);
  }
  return {t.head(), std::move(parts)};
}

/// Whether the continuation to complex numbers is the function itself on all of the real line.
bool is_its_continuation(const term& t) {
  for (const char* name :
       {"cbrt", "root", "abs", "min", "max", "floor", "ceil", "atan2", "hypot", "^"}) {
    if (t.head() == name && !t.is_leaf()) return false;
  }
  return std::all_of(t.parts().begin(), t.parts().end(), is_its_continuation);
}

/// With a variable for one of its numbers: in balls, complex balls, regions, double intervals and
/// jets.
void add_other_arithmetics(const term& t, precision p, std::vector<known_value>& values) {
  const auto number = first_number(t);
  if (!number) return;
  bool done = false;
  const term of_v = with_variable(t, done);
  const expression f = read(of_v, {"v"});
  const ball v = read(*number).value(p);
  values.push_back({"in balls, with a variable for " + number->text(), f.evaluator<ball>(p)(v)});
  if (is_its_continuation(of_v)) {
    const complex_ball z = f.evaluator<complex_ball>(p)(complex_ball(v));
    values.push_back({"in complex balls", z.re});
  }
  const double_interval hardware = double_interval::from_ball(v);
  const double_interval d = f.evaluator<double_interval>(64)(hardware);
  if (!d.is_undefined()) {
    values.push_back({"in double intervals", from_doubles(d.lower(), d.upper())});
  }
  const region r = f.evaluator<region>(64)(region(hardware, double_interval(0)));
  if (r.is_analytic()) values.push_back({"in regions", r.to_complex_ball().re});
  const auto series = f.evaluator<jet<ball, 1>>(p)(jet<ball, 1>::variable(v));
  values.push_back({"in jets", series[0]});
}

/// The value of t by several routes.
std::vector<known_value> values_of(const term& t, precision most_bits, std::uint64_t seed) {
  maker m(seed);
  const long rare = most_bits > value_case::usual_most_bits ? 2 : 10;
  const auto some_precision = [&] {
    return m.one_in(rare) ? m.between(400, most_bits) : m.between(24, 300);
  };
  std::vector<known_value> values;
  try {
    const expression f = read(t);
    for (int k = 0; k < 2; ++k) {
      const precision p = some_precision();
      values.push_back({fmt::format("with {} bits", p), f.value(p)});
    }
    const expression again = read(term(f.to_text()));
    values.push_back({"read again from its own text", again.value(some_precision())});
    add_other_arithmetics(t, some_precision(), values);
  } catch (const input_error&) {
    return values;
  } catch (const std::length_error&) {
    return values;
  }
  return values;
}

/// Whether a decimal is neither too large nor too small to be worked with as a rational number.
bool is_moderate(const std::string& decimal) {
  const auto mark = decimal.find('e');
  if (mark == std::string::npos) return decimal.size() < 100'000;
  return std::abs(std::strtol(decimal.c_str() + mark + 1, nullptr, 10)) < 100'000;
}

/// Whether the decimals that are printed of x hold it.
std::optional<std::string> error_in_decimals(const ball& x, long digits) {
  if (!(x.magnitude_upper() <= magnitude::power_of_two(300'000))) return std::nullopt;
  const decimal_enclosure d = to_decimal_enclosure(x, digits);
  if (!is_moderate(d.lower) || !is_moderate(d.upper)) return std::nullopt;
  if (parse_rational(d.lower) > lower_rational(x)) return "the lower decimal is above the set";
  if (parse_rational(d.upper) < upper_rational(x)) return "the upper decimal is below the set";
  return std::nullopt;
}

struct failure {
  value_case c;
  std::string what;
};

std::optional<failure> failing(const value_case& c, std::uint64_t seed, counts* tally) {
  std::vector<known_value> values = values_of(c.left, c.most_bits, seed);
  const std::size_t of_left = values.size();
  if (c.left.text() != c.right.text()) {
    for (known_value& v : values_of(c.right, c.most_bits, seed + 1)) values.push_back(std::move(v));
  }
  const auto name = [&](std::size_t i) {
    return fmt::format("{} {}: {}", i < of_left ? c.left.text() : c.right.text(), values[i].how,
                       to_decimal(values[i].enclosure, 40));
  };
  bool is_certified = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (tally != nullptr) ++tally->computed;
    if (!values[i].enclosure.is_bounded()) continue;
    is_certified = true;
    if (const auto error = error_in_decimals(values[i].enclosure, 20)) {
      return failure{c, *error + "\n  " + name(i)};
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!values[j].enclosure.is_bounded()) continue;
      if (tally != nullptr) ++tally->checks;
      if (!overlaps(values[i].enclosure, values[j].enclosure)) {
        return failure{c, "the enclosures are disjoint\n  " + name(j) + "\n  " + name(i)};
      }
    }
  }
  if (tally != nullptr) ++(is_certified ? tally->certified : tally->refused);
  return std::nullopt;
}

failure shrunk(failure f, std::uint64_t seed) {
  if (f.c.left.text() != f.c.right.text()) return f;  // an identity holds as it is
  int tries = 600;
  for (bool is_smaller = true; is_smaller && tries > 0;) {
    is_smaller = false;
    for (const term& less : smaller(f.c.left)) {
      if (--tries < 0) break;
      if (less.size() >= f.c.left.size()) continue;
      if (auto still = failing({less, less, f.c.most_bits}, seed, nullptr)) {
        f = std::move(*still);
        is_smaller = true;
        break;
      }
    }
  }
  return f;
}

}  // namespace

void examine(const value_case& given, std::uint64_t seed, counts& c) {
  ++c.cases;
  under_way(fmt::format("polhode eval \"{}\"; polhode eval \"{}\"", given.left.text(),
                        given.right.text()));
  const auto f = failing(given, seed, &c);
  if (!f) return;
  ++c.wrong;
  // Where one of the two formulas contradicts itself, that is shrunk.
  std::optional<failure> own = failing({given.left, given.left, given.most_bits}, seed, nullptr);
  if (!own) own = failing({given.right, given.right, given.most_bits}, seed + 1, nullptr);
  const failure less =
      shrunk(own ? *own : *f, own && own->c.left.text() == given.right.text() ? seed + 1 : seed);
  ADD_FAILURE() << f->what << "\nshrunk: " << less.what << "\n  polhode eval \""
                << less.c.left.text() << "\" --digits 30\n  polhode eval \"" << less.c.right.text()
                << "\" --digits 30\n";
}

}  // namespace polhode::differential
