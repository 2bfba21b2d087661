#include "count_option.hpp"

#include <charconv>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/output/errors.hpp"

namespace polhode::cli {

count_option::count_option(std::string name, long by_default, long least, long most)
    : name_(std::move(name)), text_(std::to_string(by_default)), least_(least), most_(most) {}

void count_option::declare(CLI::App& app, const std::string& description) {
  add_option(app, name_, text_, fmt::format("{} [{}]", description, text_)).type_name("N");
}

long count_option::value() const {
  long result = 0;
  const char* end = text_.data() + text_.size();
  const auto [rest, error] = std::from_chars(text_.data(), end, result);
  if (error != std::errc() || rest != end || result < least_ || result > most_) {
    throw usage_error(fmt::format("{} {}: it must be a whole number from {} to {}", name_,
                                  in_quotes(text_), least_, most_));
  }
  return result;
}

}  // namespace polhode::cli
