#pragma once

// Standard output and standard error. They are written here and nowhere else.

#include <string_view>

namespace polhode::cli {

inline constexpr std::string_view out_of_memory =
    "out of memory: ask for fewer digits, or run where more memory is free";

/// To be called before any file is opened. Throws output_error where standard output is closed;
/// gives closed standard input and error to /dev/null, so that no file of ours takes their place.
void check_standard_streams();

/// From here on nothing is written to them.
void silence_standard_streams();

/// Writes all of it to standard output; throws output_error where that is not possible. Where
/// nobody reads any more the program ends at once, as by SIGPIPE.
void print(std::string_view text);

/// Writes it to standard error, as far as that is possible.
void print_error(std::string_view text) noexcept;

/// Writes all of it to the file descriptor. Returns 0, or the errno of the failure.
[[nodiscard]] int write_all(int descriptor, std::string_view text) noexcept;

}  // namespace polhode::cli
