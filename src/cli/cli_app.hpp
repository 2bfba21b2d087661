#pragma once

// CLI11's reader of command lines, as the subcommands use it. <CLI/CLI.hpp> costs four seconds in
// each source that includes it, so command_line.cpp and cli_app.cpp alone do.

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace polhode::cli {

/// An option or argument that has been declared.
class declared_option {
 public:
  explicit declared_option(CLI::Option* option) : option_(option) {}

  /// What stands for the value in the help; nothing where it is "".
  declared_option& type_name(const std::string& name);
  declared_option& required();
  /// Of a list: the option takes one value each time, and may be given several times.
  declared_option& one_value_each_time();

 private:
  CLI::Option* option_;
};

/// Declares an option, "--name", or an argument, "NAME". Its value is kept as it was given.
declared_option add_option(CLI::App& app, const std::string& name, std::string& value,
                           const std::string& description);
declared_option add_option(CLI::App& app, const std::string& name,
                           std::optional<std::string>& value, const std::string& description);
declared_option add_option(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                           const std::string& description);
/// Declares an option without a value.
void add_flag(CLI::App& app, const std::string& name, bool& given, const std::string& description);

}  // namespace polhode::cli
