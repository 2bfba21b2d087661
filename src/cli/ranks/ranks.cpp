#include "ranks.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "base/worker_threads.hpp"
#include "cli/interruption.hpp"
#include "cli/modules/message_passing.hpp"
#include "cli/modules/module.hpp"
#include "cli/output/streams.hpp"
#include "polhode/version.hpp"

namespace polhode::cli::ranks {
namespace {

std::unique_ptr<message_passing>& messages() {
  static std::unique_ptr<message_passing> joined;
  return joined;
}
/// The version of the program and its arguments.
std::string& own_command() {
  static std::string command;
  return command;
}

// From a rank to rank 0: `ready` with its command; `done` with a number and the result; or `failed`
// with the reason.
// From rank 0: `compute` with a number, or `stop`.
enum class kind : char { ready = 'r', done = 'd', failed = 'f', compute = 'c', stop = 's' };

std::string packed(kind what, const std::string& text = {}) {
  return static_cast<char>(what) + text;
}
std::string packed(kind what, std::size_t number, const std::string& text = {}) {
  const std::uint64_t n = number;
  std::string bytes(sizeof n, '\0');
  std::memcpy(bytes.data(), &n, sizeof n);
  return packed(what, bytes + text);
}
kind kind_of(const std::string& bytes) { return static_cast<kind>(bytes.at(0)); }
std::size_t number_in(const std::string& bytes) {
  std::uint64_t n = 0;
  std::memcpy(&n, bytes.data() + 1, sizeof n);
  return n;
}
std::string text_in(const std::string& bytes) { return bytes.substr(1 + sizeof(std::uint64_t)); }

/// A look at what has arrived takes some 10 microseconds.
constexpr std::chrono::milliseconds between_looks(1);

message next_message() {
  for (;;) {
    if (auto arrived = messages()->receive()) return *std::move(arrived);
    std::this_thread::sleep_for(between_looks);
  }
}

/// How many of this program a launcher says that it started; 0 where it does not say, nothing where
/// there is no launcher.
std::optional<long> launched() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    if (const char* size = std::getenv(name)) return std::strtol(size, nullptr, 10);
  }
  return std::getenv("PMIX_RANK") != nullptr ? std::optional(0L) : std::nullopt;
}

/// Ends when rank 0 says so.
[[noreturn]] void work(const std::function<std::string(std::size_t)>& part) {
  std::string answer = packed(kind::ready, own_command());
  for (;;) {
    messages()->send(0, answer);
    const message order = next_message();
    if (kind_of(order.bytes) == kind::stop) break;
    const std::size_t number = number_in(order.bytes);
    answer = packed(kind::done, number, part(number));
  }
  leave();
  std::_Exit(0);
}

/// What rank 0 computes itself, on a thread of its own: so that the others never wait for it.
class own_work {
 public:
  /// next() is the number of a part that nobody has yet.
  own_work(const std::function<std::string(std::size_t)>& part,
           std::function<std::optional<std::size_t>()> next)
      : part_(part), next_(std::move(next)), thread_(without_signals([this] { run(); })) {}
  ~own_work() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    thread_.join();
  }
  own_work(const own_work&) = delete;
  own_work& operator=(const own_work&) = delete;
  own_work(own_work&&) = delete;
  own_work& operator=(own_work&&) = delete;

  /// A result, waited for a short time. Rethrows what a part has thrown.
  [[nodiscard]] std::optional<std::pair<std::size_t, std::string>> result() {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, between_looks, [this] { return !results_.empty() || failure_; });
    if (failure_) std::rethrow_exception(failure_);
    if (results_.empty()) return std::nullopt;
    auto first = std::move(results_.front());
    results_.pop_front();
    return first;
  }

 private:
  void run() {
    detail::give_constants_back_at_end();
    try {
      while (const std::optional<std::size_t> number = next()) {
        std::string bytes = part_(*number);
        const std::lock_guard lock(mutex_);
        results_.emplace_back(*number, std::move(bytes));
        changed_.notify_one();
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
      changed_.notify_one();
    }
  }
  [[nodiscard]] std::optional<std::size_t> next() {
    const std::lock_guard lock(mutex_);
    return stop_ ? std::nullopt : next_();
  }

  const std::function<std::string(std::size_t)>& part_;
  std::function<std::optional<std::size_t>()> next_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::pair<std::size_t, std::string>> results_;
  std::exception_ptr failure_;
  bool stop_ = false;
  std::thread thread_;  // last: it uses the others
};

/// Rank 0: hands out the parts until all are done and all other ranks have stopped.
void serve(const std::vector<std::size_t>& parts,
           const std::function<std::string(std::size_t)>& part,
           const std::function<void(std::size_t, std::string)>& keep) {
  std::mutex mutex;
  std::size_t given = 0;
  const auto next = [&]() -> std::optional<std::size_t> {
    const std::lock_guard lock(mutex);
    return given < parts.size() ? std::optional(parts[given++]) : std::nullopt;
  };
  std::size_t done = 0;
  int working = count() - 1;
  own_work own(part, next);
  while (done < parts.size() || working > 0) {
    if (auto result = own.result()) {
      keep(result->first, std::move(result->second));
      ++done;
    }
    while (const auto arrived = messages()->receive()) {
      const kind what = kind_of(arrived->bytes);
      const auto refuse = [&](const std::string& why) {
        throw std::runtime_error(fmt::format("rank {}: {}", arrived->from, why));
      };
      if (what == kind::failed) refuse(arrived->bytes.substr(1));
      if (what == kind::ready && arrived->bytes.substr(1) != own_command()) {
        refuse("another command, or another version of polhode, than on rank 0");
      }
      const auto number = next();
      messages()->send(arrived->from, number ? packed(kind::compute, *number) : packed(kind::stop));
      if (!number) --working;
      if (what == kind::done) {
        keep(number_in(arrived->bytes), text_in(arrived->bytes));
        ++done;
      }
    }
  }
}

}  // namespace

void join(std::span<const char* const> arguments) {
  const std::optional<long> ranks = launched();
  if (!ranks || *ranks == 1) return;
  own_command() = POLHODE_VERSION;
  for (const char* const argument : arguments.subspan(1)) {
    own_command() += fmt::format("\n{}", argument);
  }
  using maker = message_passing* (*)();
  const auto make = reinterpret_cast<maker>(function_of_module("mpi", "polhode_message_passing"));
  if (make == nullptr) {
    throw usage_error(
        "MPI has started this program, which was built without MPI: install libopenmpi-dev and "
        "build it again, or run it without mpirun");
  }
  messages().reset(make());
  if (*ranks > 1 && count() == 1) {
    messages().reset();
    throw usage_error(
        fmt::format("{} processes were started together, but MPI knows of one: start them with the "
                    "mpirun of the "
                    "MPI that Polhode was built with, or unset OMPI_COMM_WORLD_SIZE and PMI_SIZE",
                    *ranks));
  }
  if (is_worker()) silence_standard_streams();
}

int count() { return messages() ? messages()->size() : 1; }

bool is_worker() { return messages() && messages()->rank() > 0; }

int threads(long given) {
  if (given == 0 && count() > 1) return 1;
  return static_cast<int>(given);
}

void distribute(const std::vector<std::size_t>& parts,
                const std::function<std::string(std::size_t)>& part,
                const std::function<void(std::size_t, std::string)>& keep) {
  if (is_worker()) work(part);
  if (count() > 1) {
    serve(parts, part, keep);
    return;
  }
  for (const std::size_t i : parts) keep(i, part(i));
}

void leave() { messages().reset(); }

void give_up(exit_status status) noexcept {
  if (!messages()) return;
  if (!is_worker()) messages()->abort(static_cast<int>(status));
  std::string reason = "an error of no known kind";
  try {
    if (std::current_exception()) throw;
  } catch (const std::exception& error) {
    reason = error.what();
  } catch (...) {  // the reason is not known
  }
  messages()->send(0, packed(kind::failed, reason));
  for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
}

}  // namespace polhode::cli::ranks
