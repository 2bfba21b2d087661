#pragma once

// Runs the program as its users do: as a process, its output and its errors apart.

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/scratch_directory.hpp"

namespace polhode::test {

using support::scratch_directory;

inline std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// All names in a directory, hidden ones included.
inline std::vector<std::string> names_in(const std::string& directory) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

struct outcome {
  int status = -1;  // of the exit, -1 where a signal ended the process
  int signal = 0;   // that ended it
  std::string out;
  std::string err;
};

inline pid_t start(const std::vector<std::string>& command, const std::string& out_path,
                   const std::string& err_path) {
  std::vector<char*> argv;
  argv.reserve(command.size() + 1);
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr int create = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_path.c_str(), create, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err_path.c_str(), create, 0600);
  pid_t process = -1;
  const int error = posix_spawn(&process, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error(command.front() + " does not start");
  return process;
}

/// Runs a command; where a delay in microseconds is given, sends it the signal after that.
inline outcome run_command(const std::vector<std::string>& command, int signal_to_send = 0,
                           useconds_t delay = 0) {
  const scratch_directory scratch;
  const std::string out = scratch.path("out");
  const std::string err = scratch.path("err");
  const pid_t process = start(command, out, err);
  if (signal_to_send != 0) {
    usleep(delay);
    kill(process, signal_to_send);
  }
  int state = 0;
  waitpid(process, &state, 0);
  outcome result;
  if (WIFEXITED(state)) result.status = WEXITSTATUS(state);
  if (WIFSIGNALED(state)) result.signal = WTERMSIG(state);
  result.out = contents(out);
  result.err = contents(err);
  return result;
}

inline std::vector<std::string> polhode_command(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{POLHODE_CLI_PATH};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

/// Runs polhode with these arguments.
inline outcome run(const std::vector<std::string>& arguments) {
  return run_command(polhode_command(arguments));
}

/// Runs a shell script that finds the program as `polhode`, in the given directory.
inline outcome run_script(const std::string& script, const std::string& directory = "/") {
  const std::string program_directory =
      std::filesystem::path(POLHODE_CLI_PATH).parent_path().string();
  return run_command({"/bin/sh", "-c", R"(PATH="$1:$PATH"; cd "$2"; eval "$3")", "sh",
                      program_directory, directory, script});
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (start < text.size()) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

/// Sanitizers keep so much address space that its limit cannot be set.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace polhode::test
