#include "range_option.hpp"

#include <fmt/format.h>

#include "cli/output/errors.hpp"
#include "polhode/expression/functions.hpp"

namespace polhode::cli {
namespace {

/// An end in the form that range_option::ends gives it. Throws usage_error.
std::string read_end(const std::string& text, const let_option& let) {
  const int sign = infinite_sign_of(text);
  if (sign != 0) return sign > 0 ? "inf" : "-inf";
  std::string given = without_margins(text);
  (void)read_formula(given, {}, let);
  return given;
}

std::pair<std::string, std::string> both(const std::optional<std::string>& lower,
                                         const std::optional<std::string>& upper,
                                         const char* lower_name, const char* upper_name,
                                         const let_option& let) {
  if (!lower || !upper) {
    throw usage_error(fmt::format("there is {} and no {}; give both limits",
                                  lower ? lower_name : upper_name,
                                  lower ? upper_name : lower_name));
  }
  return {read_end(*lower, let), read_end(*upper, let)};
}

}  // namespace

// A number may end or begin with a point (1...5), so every ".." is tried.
std::pair<std::string, std::string> range_option::ends_of(const std::string& option,
                                                          const std::string& text,
                                                          const let_option& let) {
  std::optional<usage_error> first_error;
  for (std::size_t at = text.find(".."); at != std::string::npos; at = text.find("..", at + 1)) {
    try {
      return {read_end(text.substr(0, at), let), read_end(text.substr(at + 2), let)};
    } catch (const usage_error& error) {
      if (!first_error) first_error = error;
    }
  }
  if (first_error) {
    throw usage_error(fmt::format("{}{}: {}", option, in_quotes(text), first_error->what()));
  }
  throw usage_error(fmt::format("{}{}: it must be LO..HI, such as 0..1, -pi..pi or 0..inf", option,
                                in_quotes(text)));
}

int infinite_sign_of(const std::string& text) {
  std::string given = without_margins(text);
  constexpr std::string_view typeset_minus = "\u2212";
  if (given.starts_with(typeset_minus)) given.replace(0, typeset_minus.size(), "-");
  const bool has_sign = !given.empty() && (given.front() == '-' || given.front() == '+');
  const int sign = has_sign && given.front() == '-' ? -1 : 1;
  if (has_sign) given = without_margins(given.substr(1));
  return is_infinity(given) ? sign : 0;
}

void range_option::declare(CLI::App& app) {
  add_option(app, "A", first,
             "The lower limit: a formula without variables, or -inf;\n"
             "or both limits, as LO..HI")
      .type_name("");
  add_option(app, "B", second, "The upper limit: a formula without variables, or inf")
      .type_name("");
  add_option(app, "--from", from, "The lower limit, in place of A").type_name("A");
  add_option(app, "--to", to, "The upper limit, in place of B").type_name("B");
  add_option(app, "--in", in, "Both limits, in place of A and B")
      .type_name("LO..HI")
      .one_value_each_time();
}

int range_option::ways() const {
  return int{first || second} + int{from || to} + static_cast<int>(in.size());
}

std::pair<std::string, std::string> range_option::ends(const let_option& let) const {
  if (!in.empty()) return ends_of("--in ", in.front(), let);
  if (first && !second && first->find("..") != std::string::npos) {
    return ends_of("", *first, let);
  }
  if (from || to) return both(from, to, "--from", "--to", let);
  return both(first, second, "a limit A", "B", let);
}

}  // namespace polhode::cli
