#pragma once

// --certificate FILE: what was computed, with what `polhode check` needs to show it again.

#include <memory>
#include <optional>
#include <string>

#include "cli/cli_app.hpp"
#include "cli/output/output_directory.hpp"
#include "polhode/certificate/certificate.hpp"

namespace polhode::cli {

struct certificate_option {
  std::optional<std::string> path;

  void declare(CLI::App& app);
  [[nodiscard]] bool is_given() const { return path.has_value(); }
  /// Makes sure, before any work, that the file can be written. Throws usage_error or output_error.
  void prepare();
  /// Writes the file, whole; without --certificate nothing. After prepare().
  void write(const json& certificate);
  /// Throws not_certified_error with --certificate: there is nothing to certify.
  void expect_certified(bool certified) const;

 private:
  std::string name_;
  std::shared_ptr<output_directory> directory_;
};

}  // namespace polhode::cli
