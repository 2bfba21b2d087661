#include "output_directory.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include <fmt/format.h>

#include "cli/interruption.hpp"
#include "directory_lock.hpp"
#include "errors.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

bool is_directory(const std::string& path) {
  struct stat what {};
  return stat(path.c_str(), &what) == 0 && S_ISDIR(what.st_mode);
}

bool is_something_else(const std::string& path) {
  struct stat what {};
  return stat(path.c_str(), &what) == 0 && !S_ISDIR(what.st_mode);
}

/// Writes, and makes sure that it is on the disk: some file systems fail only then.
int write_and_close(int descriptor, const std::string& contents) {
  int error = write_all(descriptor, contents);
  if (error == 0 && fsync(descriptor) != 0 && errno != EINVAL && errno != ENOSYS) error = errno;
  if (close(descriptor) != 0 && error == 0 && errno != EINTR) error = errno;
  return error;
}

}  // namespace

void output_directory::cannot_write(const std::string& path, int error) const {
  throw output_error(
      fmt::format("{} cannot be written ({}): give {} a directory that can be written and has room",
                  in_quotes(path), system_message(error), option_));
}

output_directory::output_directory(std::string path, const std::vector<std::string>& names,
                                   std::string option)
    : path_(std::move(path)), option_(std::move(option)) {
  if (path_.empty()) {
    throw usage_error(fmt::format("{} \"\": give the name of a directory", option_));
  }
  try {
    create_missing_directories();
    // One file beside others, as --certificate writes it, needs no lock: it appears whole.
    const bool is_own_directory = option_ == "--out";
    if (is_own_directory) lock_directory(path_);
    sweep_temporary_files(path_, is_own_directory ? std::vector<std::string>{} : names);
    for (const std::string& name : names) {
      if (is_directory(in_directory(name))) cannot_write(in_directory(name), EISDIR);
      std::string temporary;
      const int descriptor = create_beside(name, temporary);
      close(descriptor);
      remove_temporary(temporary);
    }
  } catch (...) {
    take_back();
    throw;
  }
}

output_directory::~output_directory() { take_back(); }

void output_directory::create_missing_directories() {
  std::size_t end = 0;
  while (end != std::string::npos) {
    end = path_.find('/', end + 1);
    const std::string parent = path_.substr(0, end);
    if (is_directory(parent)) continue;
    if (is_something_else(parent)) {
      throw output_error(fmt::format("{} {}: {} is a file; give a directory", option_,
                                     in_quotes(path_), parent == path_ ? "it" : in_quotes(parent)));
    }
    const int error = create_temporary_directory(parent);
    if (error == 0) {
      created_.push_back(parent);
    } else if (error != EEXIST || !is_directory(parent)) {
      throw output_error(
          fmt::format("{} {}: the directory cannot be created ({}); give one that can be written",
                      option_, in_quotes(path_), system_message(error)));
    }
  }
}

std::string output_directory::in_directory(const std::string& name) const {
  return path_.back() == '/' ? path_ + name : path_ + '/' + name;
}

int output_directory::create_beside(const std::string& name, std::string& temporary) const {
  // Names may be taken: left behind by killed processes of this number.
  constexpr int most_attempts = 100;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    temporary = in_directory(temporary_name(name, getpid(), attempt));
    const int descriptor = create_temporary_file(temporary);
    if (descriptor >= 0) return descriptor;
    if (errno != EEXIST) break;
  }
  cannot_write(in_directory(name), errno);
}

void output_directory::write(const std::string& name, const std::string& contents) {
  pending_.reserve(pending_.size() + 1);
  pending_file file{"", name};
  const int descriptor = create_beside(name, file.temporary);
  pending_.push_back(std::move(file));
  const int error = write_and_close(descriptor, contents);
  if (error != 0) cannot_write(in_directory(name), error);
}

void output_directory::publish() {
  for (pending_file& file : pending_) {
    const std::string place = in_directory(file.name);
    const int error = publish_temporary_file(file.temporary, place);
    if (error != 0) cannot_write(place, error);
    file.temporary.clear();
  }
  for (const std::string& directory : created_) keep_temporary_directory(directory);
  pending_.clear();
  created_.clear();
}

void output_directory::take_back() noexcept {
  for (const pending_file& file : pending_) {
    if (!file.temporary.empty()) remove_temporary(file.temporary);
  }
  std::for_each(created_.rbegin(), created_.rend(), remove_temporary);  // children first
}

}  // namespace polhode::cli
