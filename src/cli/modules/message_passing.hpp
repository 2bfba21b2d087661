#pragma once

// Messages between the processes of one run.

#include <optional>
#include <string>

namespace polhode::cli {

struct message {
  int from = 0;
  std::string bytes;
};

/// The processes that MPI started together, of which this is one: ranks 0 to size() - 1. One thread
/// alone may call it. The destructor waits for all ranks.
class message_passing {
 public:
  message_passing() = default;
  virtual ~message_passing() = default;
  message_passing(const message_passing&) = delete;
  message_passing& operator=(const message_passing&) = delete;
  message_passing(message_passing&&) = delete;
  message_passing& operator=(message_passing&&) = delete;

  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  /// Throws std::length_error above 2 GB.
  virtual void send(int to, const std::string& bytes) = 0;
  /// A message that has arrived; nothing where there is none yet.
  [[nodiscard]] virtual std::optional<message> receive() = 0;
  /// Ends all ranks at once.
  [[noreturn]] virtual void abort(int status) noexcept = 0;
};

}  // namespace polhode::cli
