#include "nearest_name.hpp"

#include <algorithm>
#include <numeric>

namespace polhode {

std::size_t edit_distance(std::string_view x, std::string_view y) {
  std::vector<std::size_t> row(y.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < y.size(); ++j) {
      const std::size_t replaced = diagonal + (x[i] == y[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

std::string nearest_name(std::string_view given, const std::vector<std::string>& known) {
  return *std::min_element(known.begin(), known.end(),
                           [given](const std::string& x, const std::string& y) {
                             return edit_distance(given, x) < edit_distance(given, y);
                           });
}

std::optional<std::string> near_name(std::string_view given,
                                     const std::vector<std::string>& known) {
  const auto lower = [](std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return result;
  };
  const std::string in_lower_case = lower(given);
  for (const std::string& name : known) {
    if (lower(name) == in_lower_case) return name;
  }
  for (const std::string& name : known) {
    std::string exchanged(given);
    for (std::size_t i = 1; i < exchanged.size(); ++i) {
      std::swap(exchanged[i - 1], exchanged[i]);
      if (exchanged == name) return name;
      std::swap(exchanged[i - 1], exchanged[i]);
    }
  }
  if (known.empty()) return std::nullopt;
  std::string nearest = nearest_name(given, known);
  const std::size_t length = std::min(given.size(), nearest.size());
  const std::size_t allowed = length < 3 ? 0 : length < 4 ? 1 : length < 8 ? 2 : 3;
  if (edit_distance(given, nearest) > allowed) return std::nullopt;
  return nearest;
}

}  // namespace polhode
