#pragma once

// Options that name a file to write.

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/cli_app.hpp"
#include "cli/output/output_directory.hpp"

namespace polhode::cli {

/// An option whose value is a file that the program writes.
class file_option {
 public:
  file_option(std::string option, std::string purpose)
      : option_(std::move(option)), purpose_(std::move(purpose)) {}

  std::optional<std::string> path;

  void declare(CLI::App& app);
  [[nodiscard]] bool is_given() const { return path.has_value(); }
  /// Makes sure, before any work, that the file can be written. Throws usage_error or output_error.
  void prepare();
  /// Writes the file, whole; without the option nothing. After prepare().
  void write(const std::string& text);

 private:
  std::string option_;
  std::string purpose_;
  std::string name_;
  std::shared_ptr<output_directory> directory_;
};

}  // namespace polhode::cli
