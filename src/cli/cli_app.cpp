#include "cli_app.hpp"

#include <CLI/CLI.hpp>

namespace polhode::cli {

declared_option& declared_option::type_name(const std::string& name) {
  option_->type_name(name);
  return *this;
}

declared_option& declared_option::required() {
  option_->required();
  return *this;
}

declared_option& declared_option::one_value_each_time() {
  option_->allow_extra_args(false);
  return *this;
}

declared_option add_option(CLI::App& app, const std::string& name, std::string& value,
                           const std::string& description) {
  return declared_option(app.add_option(name, value, description));
}

declared_option add_option(CLI::App& app, const std::string& name,
                           std::optional<std::string>& value, const std::string& description) {
  return declared_option(app.add_option(name, value, description));
}

declared_option add_option(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                           const std::string& description) {
  return declared_option(app.add_option(name, values, description));
}

void add_flag(CLI::App& app, const std::string& name, bool& given, const std::string& description) {
  app.add_flag(name, given, description);
}

}  // namespace polhode::cli
