#include "body_option.hpp"

#include <vector>

#include <fmt/format.h>

#include "errors.hpp"
#include "formula.hpp"

namespace polhode::cli {
namespace {

/// Runs the reader; what it refuses becomes a usage error that begins with the option.
template <class F>
auto reading(const std::string& option, const std::string& text, const F& read) {
  try {
    return read();
  } catch (const input_error& error) {
    throw usage_error(fmt::format("{} {}: {}", option, in_quotes(text), error.what()));
  }
}

std::string without_spaces_around(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

template <std::size_t Count>
std::array<rational, Count> read_numbers(const std::string& option, const std::string& text,
                                         const char* right) {
  const std::vector<std::string> parts = parts_between_commas(text);
  if (parts.size() != Count) {
    throw usage_error(fmt::format("{} {}: it must be {} numbers between commas, such as {}", option,
                                  in_quotes(text), Count, right));
  }
  std::array<rational, Count> result;
  for (std::size_t i = 0; i < Count; ++i) {
    result[i] =
        reading(option, text, [&] { return parse_rational(without_spaces_around(parts[i])); });
  }
  return result;
}

}  // namespace

void body_option::declare(CLI::App& app) {
  app.add_option("--ab", ab, "The body by a = I_y/I_z - 1 > 0 and b = 1 - I_y/I_x in (0, 1)")
      ->type_name("A,B");
  app.add_option("--moments", moments,
                 "The body by its principal moments of inertia, in any order and unit")
      ->type_name("IX,IY,IZ");
}

body body_option::value() const {
  if (ab.has_value() == moments.has_value()) {
    throw usage_error(ab ? "--ab and --moments: give one of them"
                         : "there is no body; give --ab 12.65,0.0629 or --moments 3,2,1");
  }
  if (ab) {
    const auto [a, b] = read_numbers<2>("--ab", *ab, "12.65,0.0629");
    return reading("--ab", *ab, [&a = a, &b = b] { return body(a, b); });
  }
  return reading("--moments", *moments,
                 [&] { return body::from_moments(read_triple("--moments", *moments)); });
}

std::array<rational, 3> read_triple(const std::string& option, const std::string& text) {
  return read_numbers<3>(option, text, "3,2,1");
}

rational read_number(const std::string& option, const std::string& text) {
  return reading(option, text, [&] { return parse_rational(text); });
}

std::string described(body_kind kind) {
  switch (kind) {
    case body_kind::physical:
      return "physical (ab + 2b < 1)";
    case body_kind::planar:
      return "planar (ab + 2b = 1): physical, with all mass in a plane";
    case body_kind::non_physical:
      return "non-physical (ab + 2b > 1): no mass distribution has these moments";
    case body_kind::undecided:
      break;
  }
  return "undecided: within the ranges given there are physical bodies and others";
}

}  // namespace polhode::cli
