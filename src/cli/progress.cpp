#include "progress.hpp"

#include <unistd.h>

#include <cstdlib>
#include <string>

#include "interruption.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

constexpr std::string_view clear_line = "\r\x1b[K";

bool understands_escapes() {
  const char* terminal = std::getenv("TERM");
  return terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

progress::progress() : on_terminal_(isatty(STDERR_FILENO) == 1 && understands_escapes()) {}

progress::~progress() {
  if (!on_terminal_) return;
  print_error(clear_line);
  progress_line_is_shown(false);
}

void progress::show(std::string_view doing) const {
  if (!on_terminal_) return;
  progress_line_is_shown(true);
  print_error(std::string(clear_line).append(doing).append("..."));
}

}  // namespace polhode::cli
