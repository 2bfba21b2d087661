#include "directory_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "errors.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

namespace fs = std::filesystem;

using identity = std::pair<dev_t, ino_t>;

/// The directories that this process has.
std::set<identity>& locked() {
  static std::set<identity> all;
  return all;
}

/// Waits for the lock, if it must. False where there are no locks.
bool wait_for_lock(int descriptor, const std::string& path, bool& said) {
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return true;
  if (errno != EWOULDBLOCK) return false;
  if (!said) {
    print_error(fmt::format("polhode: another run writes into {}; waiting until it ends\n",
                            in_quotes(path)));
    said = true;
  }
  while (flock(descriptor, LOCK_EX) != 0) {
    if (errno != EINTR) return false;
  }
  return true;
}

struct temporary {
  std::string_view name;
  long process = 0;
};

/// What temporary_name made it from; nothing for other names.
std::optional<temporary> read_temporary_name(std::string_view text) {
  constexpr std::string_view end = ".tmp";
  if (!text.starts_with('.') || !text.ends_with(end)) return std::nullopt;
  text.remove_prefix(1);
  text.remove_suffix(end.size());
  const auto take_number = [&text]() -> std::optional<long> {
    const std::size_t point = text.rfind('.');
    if (point == std::string_view::npos) return std::nullopt;
    const std::string_view digits = text.substr(point + 1);
    long result = 0;
    const auto [rest, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), result);
    if (error != std::errc() || rest != digits.data() + digits.size() || result < 0) {
      return std::nullopt;
    }
    text = text.substr(0, point);
    return result;
  };
  if (!take_number()) return std::nullopt;
  const std::optional<long> process = take_number();
  if (!process || *process == 0 || text.empty()) return std::nullopt;
  return temporary{text, *process};
}

bool is_alive(long process) { return kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM; }

}  // namespace

void lock_directory(const std::string& path) {
  bool said = false;
  for (;;) {
    const int descriptor = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    struct stat opened {};
    struct stat there {};
    const bool known = fstat(descriptor, &opened) == 0;
    if (!known || locked().contains({opened.st_dev, opened.st_ino}) ||
        !wait_for_lock(descriptor, path, said)) {
      close(descriptor);
      return;
    }
    // The other run may have taken its new directory back in the meantime.
    if (stat(path.c_str(), &there) == 0 && there.st_dev == opened.st_dev &&
        there.st_ino == opened.st_ino) {
      locked().insert({opened.st_dev, opened.st_ino});
      return;  // the descriptor, and with it the lock, stays until the process ends
    }
    close(descriptor);
    if (mkdir(path.c_str(), 0777) != 0 && errno != EEXIST) return;
  }
}

std::string temporary_name(const std::string& name, long process, int attempt) {
  return fmt::format(".{}.{}.{}.tmp", name, process, attempt);
}

void sweep_temporary_files(const std::string& directory, const std::vector<std::string>& names) {
  std::error_code error;
  std::vector<fs::path> left;
  for (fs::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const std::optional<temporary> one = read_temporary_name(name);
    if (!one || is_alive(one->process)) continue;
    if (!names.empty() && std::find(names.begin(), names.end(), one->name) == names.end()) continue;
    std::error_code ignored;
    if (fs::is_regular_file(entry->symlink_status(ignored))) left.push_back(entry->path());
  }
  for (const fs::path& path : left) {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
}

}  // namespace polhode::cli
