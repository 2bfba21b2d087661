#pragma once

// Certificates in files, checked and reported as `polhode check` and `polhode-check` print it.

#include <functional>
#include <string>
#include <vector>

#include "polhode/checker/check.hpp"

namespace polhode::checker {

struct files_request {
  std::vector<std::string>
      paths;             // of certificates, or of directories of which every .json file is one
  bool verbose = false;  // every fact and number that was shown again, and what the check cost
  limits most;           // the work of all certificates together; the memory of each
};

/// What became of one file.
struct file_report {
  std::string path;
  bool was_read = false;
  report result;         // where it was read
  std::string not_read;  // else why

  /// It was not read, or is no certificate.
  [[nodiscard]] bool is_unusable() const {
    return !was_read || result.result == outcome::malformed;
  }
};

struct files_report {
  std::string
      text;  // the lines to print: of each file that is a certificate, then how many are verified
  bool whole = false;  // all are verified, and leave nothing out
  /// Of each file that is malformed or was not read a line that says why: for standard error, as
  /// they are not in the text.
  std::vector<std::string> unusable;
  std::vector<file_report> files;  // in the order in which they were checked
};

/// Checks all files; what cannot be read costs the others nothing. Calls `begins` before each with
/// its path, fit to be shown, its number from 1 on, and the number of all.
[[nodiscard]] files_report check_files(
    const files_request& request,
    const std::function<void(const std::string& path, std::size_t number, std::size_t of)>& begins);

/// Of the JSON below: raised when a key gets another meaning or goes.
inline constexpr int json_version = 2;

/// What `polhode check` and `polhode-check` print with --format json: {"format": "polhode check",
/// "version": 2, "files": [...], "verified": ...}, the files in their order; with what each cost
/// where it is verbose.
[[nodiscard]] std::string json_text(const files_report& all, bool verbose);

/// A path as it may stand in a line of a terminal: as it is where it has letters, digits and
/// ._/+-,=@~% alone, else in quotes, with everything escaped that is not printable ASCII.
[[nodiscard]] std::string printable(const std::string& path);

}  // namespace polhode::checker
