#include "streams.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "errors.hpp"

namespace polhode::cli {
namespace {

bool is_closed(int descriptor) { return fcntl(descriptor, F_GETFD) == -1 && errno == EBADF; }

void give_to_dev_null(int descriptor) {
  const int null = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (null < 0 || null == descriptor) return;
  dup2(null, descriptor);
  close(null);
}

void wait_until_writable(int descriptor) noexcept {
  pollfd wanted{descriptor, POLLOUT, 0};
  poll(&wanted, 1, -1);
}

/// Some file systems tell only here that the data did not fit.
int close_copy_of(int descriptor) noexcept {
  const int copy = dup(descriptor);
  return copy >= 0 && close(copy) != 0 ? errno : 0;
}

}  // namespace

int write_all(int descriptor, std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      wait_until_writable(descriptor);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

void check_standard_streams() {
  const bool no_output = is_closed(STDOUT_FILENO);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (is_closed(descriptor)) give_to_dev_null(descriptor);
  }
  if (no_output) throw output_error("standard output is closed: give it a file or a pipe");
}

void silence_standard_streams() {
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) give_to_dev_null(descriptor);
}

void print(std::string_view text) {
  int error = write_all(STDOUT_FILENO, text);
  if (error == 0) error = close_copy_of(STDOUT_FILENO);
  if (error == 0) return;
  if (error == EPIPE) {  // SIGPIPE was being ignored
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  throw output_error("standard output cannot be written (" + system_message(error) +
                     "): give it a file or a pipe with room");
}

void print_error(std::string_view text) noexcept {
  static_cast<void>(write_all(STDERR_FILENO, text));
}

}  // namespace polhode::cli
