#include "interruption.hpp"

#include <fcntl.h>
#include <gmp.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

#include "cli/output/errors.hpp"
#include "cli/output/streams.hpp"

namespace polhode::cli {
namespace {

// A signal handler can reach nothing but globals, and may only read lock-free ones.
constexpr std::size_t most_temporaries = 1024;
std::array<std::atomic<char*>, most_temporaries> temporaries;  // directories before what is in them
std::atomic<bool> progress_shown = false;

constexpr std::array ending_signals{SIGINT, SIGTERM, SIGHUP, SIGQUIT};

void remove_file_or_directory(const char* path) noexcept {
  if (unlink(path) != 0) rmdir(path);
}

/// Only calls that are safe in a signal handler.
void clean_up() noexcept {
  std::for_each(temporaries.rbegin(), temporaries.rend(), [](const std::atomic<char*>& entry) {
    if (const char* path = entry.load(); path != nullptr) remove_file_or_directory(path);
  });
  if (progress_shown) print_error("\r\x1b[K");
}

extern "C" void end_by_signal(int signal_number) {
  clean_up();
  // SA_RESETHAND has restored the default action, SA_NODEFER lets it happen now.
  raise(signal_number);
}

[[noreturn]] void end_for_want_of_memory() noexcept {
  clean_up();
  print_error("polhode: ");
  print_error(out_of_memory);
  print_error("\n");
  _exit(static_cast<int>(exit_status::bad_input));
}

extern "C" void* allocate(std::size_t size) {
  void* block = std::malloc(size);
  if (block == nullptr) end_for_want_of_memory();
  return block;
}

extern "C" void* reallocate(void* block, std::size_t /*old_size*/, std::size_t size) {
  void* moved = std::realloc(block, size);
  if (moved == nullptr) end_for_want_of_memory();
  return moved;
}

extern "C" void release(void* block, std::size_t /*size*/) { std::free(block); }

/// While it lives, this thread is not interrupted by the signals above.
class uninterrupted {
 public:
  uninterrupted() {
    sigset_t blocked;
    sigemptyset(&blocked);
    for (const int signal_number : ending_signals) sigaddset(&blocked, signal_number);
    pthread_sigmask(SIG_BLOCK, &blocked, &before_);
  }
  ~uninterrupted() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  uninterrupted(const uninterrupted&) = delete;
  uninterrupted& operator=(const uninterrupted&) = delete;
  uninterrupted(uninterrupted&&) = delete;
  uninterrupted& operator=(uninterrupted&&) = delete;

 private:
  sigset_t before_{};
};

void forget(const std::string& path) noexcept {
  for (auto& entry : temporaries) {
    char* known = entry.load();
    if (known != nullptr && path == known) {
      entry.store(nullptr);
      std::free(known);
      return;
    }
  }
}

/// Calls create(), which returns a negative number where it fails, and remembers the path where it
/// does not. Returns what create() returned, -1 with errno set where there is no room to remember.
template <class F>
int create_and_remember(const std::string& path, const F& create) {
  const auto entry = std::find(temporaries.begin(), temporaries.end(), nullptr);
  char* copy = entry == temporaries.end() ? nullptr : strdup(path.c_str());
  if (copy == nullptr) {
    errno = ENOMEM;
    return -1;
  }
  const uninterrupted guard;
  const int result = create();
  if (result < 0) {
    const int error = errno;
    std::free(copy);
    errno = error;
  } else {
    entry->store(copy);
  }
  return result;
}

}  // namespace

void handle_interruptions() {
  mp_set_memory_functions(allocate, reallocate, release);
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int signal_number : ending_signals) {
    struct sigaction action {};
    sigaction(signal_number, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;  // nohup
    action = {};
    action.sa_handler = end_by_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_NODEFER;
    sigaction(signal_number, &action, nullptr);
  }
}

void end_program(const std::string& line, exit_status status) noexcept {
  clean_up();
  print_error(line);
  _exit(static_cast<int>(status));
}

int create_temporary_file(const std::string& path) {
  constexpr mode_t readable_and_writable = 0666;  // less the umask
  return create_and_remember(path, [&path] {
    return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, readable_and_writable);
  });
}

int create_temporary_directory(const std::string& path) {
  constexpr mode_t open_to_all = 0777;  // less the umask
  return create_and_remember(path, [&path] { return mkdir(path.c_str(), open_to_all); }) < 0 ? errno
                                                                                             : 0;
}

int publish_temporary_file(const std::string& from, const std::string& to) {
  const uninterrupted guard;
  if (std::rename(from.c_str(), to.c_str()) != 0) return errno;
  forget(from);
  return 0;
}

void keep_temporary_directory(const std::string& path) noexcept { forget(path); }

void remove_temporary(const std::string& path) noexcept {
  const uninterrupted guard;
  remove_file_or_directory(path.c_str());
  forget(path);
}

std::thread without_signals(std::function<void()> run) {
  const uninterrupted guard;  // which the new thread inherits
  return std::thread(std::move(run));
}

void progress_line_is_shown(bool shown) noexcept { progress_shown = shown; }

}  // namespace polhode::cli
