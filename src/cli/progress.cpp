#include "progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>

#include <fmt/format.h>

#include "duration.hpp"
#include "interruption.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

using clock = std::chrono::steady_clock;

constexpr std::string_view clear_line = "\r\x1b[K";

bool understands_escapes() {
  const char* terminal = std::getenv("TERM");
  return terminal != nullptr && std::string_view(terminal) != "dumb";
}

/// What fits in a line of the terminal: of a line that it has broken only the last part could be cleared.
std::string shortened(std::string line) {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return line;
  if (line.size() < size.ws_col) return line;
  std::size_t length = size.ws_col - 1U;
  // Not within a character.
  while (length > 0 && (static_cast<unsigned char>(line[length]) & 0xc0U) == 0x80U) --length;
  line.resize(length);
  return line;
}

clock::duration of_seconds(double seconds) {
  // Some hundred years: a clock does not count much farther.
  constexpr double most = 3e9;
  return std::chrono::duration_cast<clock::duration>(
      std::chrono::duration<double>(std::min(seconds, most)));
}

}  // namespace

/// Shows the line, and anew every second while there is a time to count down to.
class progress::countdown {
 public:
  countdown() : thread_(without_signals([this] { run(); })) {}
  ~countdown() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }
  countdown(const countdown&) = delete;
  countdown& operator=(const countdown&) = delete;
  countdown(countdown&&) = delete;
  countdown& operator=(countdown&&) = delete;

  void show(std::string_view doing) {
    const std::lock_guard lock(mutex_);
    doing_ = doing;
    print();
  }
  void expect(double seconds) {
    {
      const std::lock_guard lock(mutex_);
      end_ = clock::now() + of_seconds(seconds);
      print();
    }
    changed_.notify_one();
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return end_ || ended_; });
    while (!changed_.wait_for(lock, std::chrono::seconds(1), [this] { return ended_; })) print();
  }
  void print() const {
    if (doing_.empty()) return;
    std::string line = doing_;
    if (end_) {
      const double left = std::chrono::duration<double>(*end_ - clock::now()).count();
      line += left > 0 ? fmt::format(", about {} left", duration_text(std::max(left, 1.0)))
                       : ", longer than estimated";
    }
    print_error(std::string(clear_line) + shortened(line + "..."));
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::string doing_;
  std::optional<clock::time_point> end_;
  std::thread thread_;  // last: it uses the others
};

progress::progress() : on_terminal_(isatty(STDERR_FILENO) == 1 && understands_escapes()) {
  if (on_terminal_) countdown_ = std::make_unique<countdown>();
}

progress::~progress() {
  if (!on_terminal_) return;
  countdown_.reset();
  print_error(clear_line);
  progress_line_is_shown(false);
}

void progress::show(std::string_view doing) const {
  if (!on_terminal_) return;
  progress_line_is_shown(true);
  countdown_->show(doing);
}

void progress::expect(std::optional<double> seconds) const {
  if (on_terminal_ && seconds) countdown_->expect(*seconds);
}

void progress::show_part(std::string_view doing, std::size_t done, std::size_t count) const {
  if (!on_terminal_) return;
  const clock::time_point now = clock::now();
  // A terminal is slower than many parts are.
  constexpr std::chrono::milliseconds between(100);
  if (done > 0 && now - last_part_ < between) return;
  last_part_ = now;
  constexpr double enough_seconds = 1;
  const double taken = std::chrono::duration<double>(now - start_).count();
  if (done > 0 && taken > enough_seconds) {
    expect(taken * static_cast<double>(count - done) / static_cast<double>(done));
  }
  show(fmt::format("{} ({}/{})", doing, done + 1, count));
}

}  // namespace polhode::cli
