#pragma once

// What must happen when the program is stopped in the middle: by Ctrl-C, by SIGTERM, for want of
// memory.

#include <functional>
#include <string>
#include <thread>

#include "cli/output/errors.hpp"

namespace polhode::cli {

/// From here on SIGINT, SIGTERM, SIGHUP and SIGQUIT (those that were not ignored) remove the
/// temporary files and end the program by that same signal; GMP's and MPFR's failing allocations
/// remove them and end it with one line on standard error and status 2 (they would end it with
/// SIGABRT); and a file that may not grow any more is an error of writing, not SIGXFSZ.
void handle_interruptions();

/// Removes the temporary files, prints the line on standard error and ends the program with the
/// status at once, whatever other threads are doing.
[[noreturn]] void end_program(const std::string& line, exit_status status) noexcept;

/// Creates a new file that an interruption removes, and returns its descriptor, or -1 with errno
/// set (EEXIST where there is such a file already).
[[nodiscard]] int create_temporary_file(const std::string& path);

/// Creates a directory that an interruption removes if it is empty then. Returns 0, or the errno
/// of the failure.
[[nodiscard]] int create_temporary_directory(const std::string& path);

/// Renames the file to its final place, where an interruption leaves it. Returns 0, or the errno of
/// the failure.
[[nodiscard]] int publish_temporary_file(const std::string& from, const std::string& to);

/// An interruption leaves the directory from now on.
void keep_temporary_directory(const std::string& path) noexcept;

/// Removes the file, or the directory if it is empty.
void remove_temporary(const std::string& path) noexcept;

/// A thread that none of those signals interrupts: they are left to the others.
[[nodiscard]] std::thread without_signals(std::function<void()> run);

/// Whether standard error holds an unfinished line of progress, which an interruption clears.
void progress_line_is_shown(bool shown) noexcept;

}  // namespace polhode::cli
