#pragma once

// Text for a terminal of 100 columns.

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::cli {

inline constexpr std::size_t terminal_columns = 100;

/// The text in lines of at most `width` columns, broken at spaces; only a longer word makes a
/// longer line.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// The cells below each other under their headings, each wrapped to its column's width, two spaces
/// between the columns and an empty line between the rows.
struct column {
  std::string heading;
  std::size_t width;
};
[[nodiscard]] std::string table(const std::vector<column>& columns,
                                const std::vector<std::vector<std::string>>& rows);

}  // namespace polhode::cli
