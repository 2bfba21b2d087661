#pragma once

// Options that name a file to write; --certificate FILE: what was computed, with what `polhode check`
// needs to show it again.

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/cli_app.hpp"
#include "cli/output/output_directory.hpp"
#include "polhode/certificate/certificate.hpp"

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

class certificate_option : public file_option {
 public:
  certificate_option() : file_option("--certificate", "Write a certificate for `polhode check`") {}

  void write(const json& certificate) { file_option::write(certificate.dump(2) + '\n'); }
  /// Throws not_certified_error with --certificate: there is nothing to certify.
  void expect_certified(bool certified) const;
};

}  // namespace polhode::cli
