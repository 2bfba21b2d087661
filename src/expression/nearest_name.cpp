#include "polhode/expression/nearest_name.hpp"

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

}  // namespace polhode
