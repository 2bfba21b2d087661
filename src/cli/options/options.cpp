#include "options.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.hpp"
#include "cli/output/errors.hpp"

namespace polhode::cli {

void digits_option::declare(CLI::App& app) {
  add_option(app, "--digits", text,
             fmt::format("Significant digits of every number, at least 1 [{}]", text))
      .type_name("N");
}

long digits_option::value() const {
  long result = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, result);
  if (error != std::errc() || rest != end || result < 1 || result > most_digits) {
    throw usage_error(fmt::format("--digits {}: it must be a whole number from 1 to {}",
                                  in_quotes(text), most_digits));
  }
  return result;
}

void format_option::declare(CLI::App& app) {
  add_option(app, "--format", text,
             fmt::format("{} [{}]", fmt::join(choices, ", "), choices.front()))
      .type_name("FORMAT");
}

const std::string& format_option::value() const {
  const auto chosen = std::find(choices.begin(), choices.end(), text);
  if (chosen == choices.end()) {
    throw usage_error(fmt::format("--format {}: it must be one of {}", in_quotes(text),
                                  fmt::join(choices, ", ")));
  }
  return *chosen;
}

std::vector<std::string> known_names(const std::vector<std::string>& given,
                                     const std::vector<std::string>& known, std::string_view kind,
                                     std::string_view list_command) {
  std::vector<std::string> result;
  for (const std::string& name : given) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const std::optional<std::string> near = near_name(name, known);
      throw usage_error(fmt::format("there is no {} {}{} (`{}` shows all)", kind, in_quotes(name),
                                    near ? "; the nearest is " + *near : "", list_command));
    }
    if (std::find(result.begin(), result.end(), name) == result.end()) result.push_back(name);
  }
  return result;
}

}  // namespace polhode::cli
