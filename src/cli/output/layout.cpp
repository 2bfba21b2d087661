#include "layout.hpp"

#include <algorithm>

namespace polhode::cli {
namespace {

/// Columns that UTF-8 text takes: bytes that continue a character take none.
std::size_t columns_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string table_row(const std::vector<column>& columns, const std::vector<std::string>& cells) {
  std::vector<std::vector<std::string>> lines;
  std::size_t height = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    lines.push_back(wrapped(cells[i], columns[i].width));
    height = std::max(height, lines.back().size());
  }
  std::string result;
  for (std::size_t row = 0; row < height; ++row) {
    std::string line;
    std::size_t start = 0;  // the column of the page where the cell begins
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (row < lines[i].size()) {
        const std::size_t reached = columns_of(line);
        if (reached < start) line.append(start - reached, ' ');
        line += lines[i][row];
      }
      start += columns[i].width + 2;
    }
    result += line + '\n';
  }
  return result;
}

}  // namespace

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (word.empty()) continue;
    if (!line.empty() && columns_of(line) + 1 + columns_of(word) > width) {
      lines.push_back(std::move(line));
      line.clear();
    }
    if (!line.empty()) line += ' ';
    line += word;
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

std::string table(const std::vector<column>& columns,
                  const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::string> headings;
  headings.reserve(columns.size());
  for (const column& c : columns) headings.push_back(c.heading);
  std::string result = table_row(columns, headings);
  for (const auto& cells : rows) result += '\n' + table_row(columns, cells);
  return result;
}

}  // namespace polhode::cli
