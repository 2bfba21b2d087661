#include "file_option.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "cli/output/errors.hpp"

namespace polhode::cli {

namespace fs = std::filesystem;

void file_option::declare(CLI::App& app) {
  add_option(app, option_, path, purpose_).type_name("FILE");
}

void file_option::prepare() {
  if (!path) return;
  const fs::path given(*path);
  name_ = given.filename().string();
  if (name_.empty() || name_ == "." || name_ == "..") {
    throw usage_error(fmt::format("{} {}: give the name of a file", option_, in_quotes(*path)));
  }
  std::error_code ignored;
  const fs::file_status there = fs::status(given, ignored);
  if (fs::exists(there) && !fs::is_regular_file(there)) {
    throw usage_error(
        fmt::format("{} {}: it is {}; give the name of a file", option_, in_quotes(*path),
                    fs::is_directory(there) ? "a directory" : "a pipe, a socket or a device"));
  }
  const std::string parent = given.parent_path().string();
  if (!parent.empty() && !fs::exists(fs::status(parent, ignored))) {
    throw usage_error(fmt::format("{} {}: there is no directory {}; create it first", option_,
                                  in_quotes(*path), in_quotes(parent)));
  }
  directory_ = std::make_shared<output_directory>(parent.empty() ? "." : parent,
                                                  std::vector<std::string>{name_}, option_);
}

void file_option::write(const std::string& text) {
  if (!path) return;
  directory_->write(name_, text);
  directory_->publish();
}

}  // namespace polhode::cli
