#include "errors.hpp"

#include <exception>
#include <new>
#include <system_error>

#include <fmt/format.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/verify/second_opinion.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

/// The text without line breaks and other control characters.
std::string in_one_line(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7f) {
      result += fmt::format("\\x{:02x}", code);
    } else {
      result += c;
    }
  }
  return result;
}

/// Without the middle of a text that is too long: what was given stands first, what would be right
/// last.
std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  return text.substr(0, most / 2) + " ... " + text.substr(text.size() - most / 2);
}

exit_status report(std::string_view message, exit_status status) {
  constexpr std::size_t longest_message = 1000;
  print_error("polhode: " + shortened(in_one_line(message), longest_message) + '\n');
  return status;
}

exit_status report_by_type() {
  try {
    throw;
  } catch (const contradiction_error& e) {
    print_error(fmt::format(
        "polhode: {}\n"
        "There is no result. This is a fault in Polhode: please report it with the whole command "
        "line.\n",
        e.what()));
    return exit_status::contradiction;
  } catch (const not_certified_error& e) {
    return report(e.what(), exit_status::not_certified);
  } catch (const std::domain_error& e) {  // the library: a number that is not defined here
    return report(e.what(), exit_status::not_certified);
  } catch (const std::bad_alloc&) {
    return report(out_of_memory, exit_status::bad_input);
  } catch (const std::exception& e) {
    return report(e.what(), exit_status::bad_input);
  } catch (...) {
    return report("an unknown error", exit_status::bad_input);
  }
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest_quotation = 60;
  return '"' + shortened(in_one_line(text), longest_quotation) + '"';
}

std::string system_message(int error_number) {
  return std::generic_category().message(error_number);
}

exit_status report_current_exception() noexcept {
  try {
    return report_by_type();
  } catch (...) {  // no memory even for the message
    return exit_status::bad_input;
  }
}

}  // namespace polhode::cli
