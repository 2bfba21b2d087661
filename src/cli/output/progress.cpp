#include "progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "cli/interruption.hpp"
#include "duration.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

using clock = std::chrono::steady_clock;

constexpr std::string_view clear_line = "\r\x1b[K";

bool understands_escapes() {
  const char* terminal = std::getenv("TERM");
  return terminal != nullptr && std::string_view(terminal) != "dumb";
}

/// What fits in a line of the terminal: of a line that it has broken only the last part could be
/// cleared.
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

/// What the line of progress says that lives now, for current_activity().
struct activity {
  std::mutex mutex;
  std::string doing;
};
activity& current() {
  static activity one;
  return one;
}

/// Seconds between two lines in a log.
double seconds_between_lines() {
  constexpr double usual = 60;
  const char* given = std::getenv("POLHODE_PROGRESS_SECONDS");
  if (given == nullptr) return usual;
  char* end = nullptr;
  const double seconds = std::strtod(given, &end);
  return end != given && *end == 0 && seconds > 0 ? seconds : usual;
}

}  // namespace

/// On a terminal shows the line, and anew every second while there is a time to count down to;
/// elsewhere writes a line a minute.
class progress::countdown {
 public:
  explicit countdown(bool on_terminal)
      : on_terminal_(on_terminal), thread_(without_signals([this] { run(); })) {}
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
    tell_current();
    if (on_terminal_) print();
  }
  void count(std::function<std::string()> counts) {
    const std::lock_guard lock(mutex_);
    counts_ = std::move(counts);
  }
  void expect(double seconds) {
    {
      const std::lock_guard lock(mutex_);
      end_ = clock::now() + of_seconds(seconds);
      if (on_terminal_) print();
    }
    changed_.notify_one();
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    const auto has_ended = [this] { return ended_; };
    if (!on_terminal_) {
      const clock::duration between = of_seconds(seconds_between_lines());
      while (!changed_.wait_for(lock, between, has_ended)) print_line();
      return;
    }
    changed_.wait(lock, [this] { return end_ || counts_ || ended_; });
    while (!changed_.wait_for(lock, std::chrono::seconds(1), has_ended)) print();
  }
  [[nodiscard]] std::string what_is_done() const {
    const std::string counts = counts_ ? counts_() : "";
    return doing_ + (counts.empty() ? "" : ": " + counts);
  }
  void tell_current() const {
    const std::lock_guard lock(current().mutex);
    current().doing = doing_;
  }
  [[nodiscard]] std::string time_left() const {
    if (!end_) return "";
    const double left = std::chrono::duration<double>(*end_ - clock::now()).count();
    return left > 0 ? fmt::format(", about {} left", duration_text(std::max(left, 1.0)))
                    : ", longer than estimated";
  }
  void print() const {
    if (doing_.empty()) return;
    print_error(std::string(clear_line) + shortened(what_is_done() + time_left() + "..."));
  }
  void print_line() const {
    if (doing_.empty()) return;
    const double taken = std::chrono::duration<double>(clock::now() - start_).count();
    print_error(fmt::format("polhode: {}, {} so far{}\n", what_is_done(), duration_text(taken),
                            time_left()));
  }

  bool on_terminal_;
  clock::time_point start_ = clock::now();
  std::function<std::string()> counts_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::string doing_;
  std::optional<clock::time_point> end_;
  std::thread thread_;  // last: it uses the others
};

std::string current_activity() {
  const std::lock_guard lock(current().mutex);
  return current().doing;
}

progress::progress()
    : on_terminal_(isatty(STDERR_FILENO) == 1 && understands_escapes()),
      countdown_(std::make_unique<countdown>(on_terminal_)) {}

progress::~progress() {
  countdown_.reset();
  if (!on_terminal_) return;
  print_error(clear_line);
  progress_line_is_shown(false);
}

void progress::show(std::string_view doing) const {
  if (on_terminal_) progress_line_is_shown(true);
  countdown_->show(doing);
}

void progress::count(std::function<std::string()> counts) const {
  countdown_->count(std::move(counts));
}

void progress::expect(std::optional<double> seconds) const {
  if (seconds) countdown_->expect(*seconds);
}

void progress::show_part(std::string_view doing, std::size_t done, std::size_t count) const {
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
