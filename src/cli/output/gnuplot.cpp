#include "gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>

#include "errors.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

/// A file without a name: nothing is left of it, however the program ends.
class nameless_file {
 public:
  nameless_file() : file_(std::tmpfile(), std::fclose) {
    if (!file_) throw output_error("no temporary file: " + system_message(errno));
  }
  [[nodiscard]] int descriptor() const { return fileno(file_.get()); }
  void rewind() const { std::rewind(file_.get()); }
  [[nodiscard]] std::string contents() const {
    std::rewind(file_.get());
    std::string result;
    std::array<char, 4096> part{};
    while (const std::size_t n = std::fread(part.data(), 1, part.size(), file_.get())) {
      result.append(part.data(), n);
    }
    return result;
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace

std::string run_gnuplot(const std::string& program, const std::string& way_without) {
  const nameless_file in;
  const nameless_file out;
  if (const int error = write_all(in.descriptor(), program); error != 0) {
    throw output_error("a temporary file cannot be written: " + system_message(error));
  }
  in.rewind();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::string name = "gnuplot";
  std::string settings = "-d";  // not those of the user
  std::array<char*, 3> arguments{name.data(), settings.data(), nullptr};
  pid_t process = -1;
  const int error =
      posix_spawnp(&process, name.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw output_error("gnuplot, which draws the picture, does not start: " +
                       system_message(error) + "; install it, or " + way_without);
  }
  int state = 0;
  while (waitpid(process, &state, 0) < 0 && errno == EINTR) {
  }
  std::string picture = out.contents();
  if (!WIFEXITED(state) || WEXITSTATUS(state) != 0 || picture.empty()) {
    throw output_error("gnuplot did not draw the picture; " + way_without);
  }
  return picture;
}

void require_gnuplot(const std::string& way_without) {
  (void)run_gnuplot("set terminal svg\nset terminal pngcairo\nset print '-'\nprint 1\n",
                    way_without);
}

void require_pdf(const std::string& way_without) {
  require_gnuplot(way_without);
  try {
    (void)run_gnuplot("set terminal pdfcairo\nset print '-'\nprint 1\n", way_without);
  } catch (const output_error&) {
    throw output_error(
        "this gnuplot draws no PDF, for it was built without its terminal pdfcairo: "
        "install one with it, such as Debian's gnuplot-nox, or " +
        way_without);
  }
}

}  // namespace polhode::cli
