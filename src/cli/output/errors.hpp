#pragma once

// How the program fails: with one line on standard error and an exit status.

#include <stdexcept>
#include <string>
#include <string_view>

namespace polhode::cli {

enum class exit_status : int {
  all_certified = 0,
  not_certified = 1,  // something was not certified, or was refuted
  bad_input = 2,      // bad usage, bad input, or no room for the output
  contradiction = 3   // two proofs contradict each other: a fault in Polhode
};

/// The command line cannot be used; what() says what was given and what would be right.
class usage_error : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The result cannot be written.
class output_error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The mathematics did not end in a proof.
class not_certified_error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A text as it may stand in a message: in double quotes, control characters escaped, and without
/// the middle of a long one.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// "No space left on device" for ENOSPC, and so on.
[[nodiscard]] std::string system_message(int error_number);

/// Prints the exception being handled as "polhode: ..." on standard error, in one line unless it is
/// a contradiction_error. To be called in a catch block; returns the status to exit with.
[[nodiscard]] exit_status report_current_exception() noexcept;

}  // namespace polhode::cli
