#pragma once

#include <string>
#include <string_view>

namespace polhode::detail {

/// A text for an error message of one line: between quotes, whole where short, else its beginning;
/// control characters as question marks.
[[nodiscard]] inline std::string quoted(std::string_view text) {
  constexpr std::size_t most = 60;
  std::string shown(text.substr(0, most));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  if (text.size() <= most) return '"' + shown + '"';
  return '"' + shown + "...\" (" + std::to_string(text.size()) + " characters)";
}

}  // namespace polhode::detail
