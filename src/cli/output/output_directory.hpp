#pragma once

#include <string>
#include <vector>

namespace polhode::cli {

/// A set of files that appear in a directory together and whole, or not at all.
///
/// Each is written beside its place under a hidden name and renamed by publish(). Until then
/// whatever ends the program (an exception, a signal, a full disk) leaves neither files nor
/// directories behind; only SIGKILL and a loss of power can leave a hidden temporary file, which
/// the next run with that directory removes. A directory of --out belongs to one process until it
/// ends; others wait.
class output_directory {
 public:
  /// Creates the directory where it is missing, and its parents, and makes sure that files of these
  /// names can be created in it. Throws output_error otherwise, in which `option` is what gave the
  /// path.
  output_directory(std::string path, const std::vector<std::string>& names,
                   std::string option = "--out");
  ~output_directory();
  output_directory(const output_directory&) = delete;
  output_directory& operator=(const output_directory&) = delete;
  output_directory(output_directory&&) = delete;
  output_directory& operator=(output_directory&&) = delete;

  /// Writes a file under its temporary name; throws output_error where that fails.
  void write(const std::string& name, const std::string& contents);

  /// Gives all written files their names, replacing files that had them.
  void publish();

 private:
  struct pending_file {
    std::string temporary;
    std::string name;
  };

  void create_missing_directories();
  [[nodiscard]] int create_beside(const std::string& name, std::string& temporary) const;
  [[nodiscard]] std::string in_directory(const std::string& name) const;
  void take_back() noexcept;
  [[noreturn]] void cannot_write(const std::string& path, int error) const;

  std::string path_;
  std::string option_;
  std::vector<std::string> created_;  // directories, parents first
  std::vector<pending_file> pending_;
};

}  // namespace polhode::cli
