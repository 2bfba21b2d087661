#include "budget.hpp"

#include <algorithm>

namespace polhode::checker {

long budget::of_product(long x_words, long y_words) {
  constexpr long schoolbook = 32;
  constexpr long transform = 4096;
  const auto [less, more] = std::minmax(x_words, y_words);
  if (less <= schoolbook) return less * more;
  long size = schoolbook;
  long units = schoolbook * schoolbook;
  for (; 2 * size <= std::min(less, transform); size *= 2) units *= 3;
  if (less < transform) {
    units += 2 * units / size * (less - size);
  } else {
    for (; 2 * size <= less; size *= 2) units = units / 10 * 22;
    units += units / size * (less - size) / 10 * 12;
  }
  return units / less * more;
}

void budget::hold(long bytes) {
  if (bytes < 0 || bytes > most_.memory - held_) pass_memory();
  held_ += bytes;
  most_held_ = std::max(most_held_, held_);
}

void budget::pass_work() const {
  constexpr long million = 1'000'000;
  throw refusal(outcome::not_checkable, place_,
                "here the check passes its budget of " +
                    (most_.work % million == 0 ? std::to_string(most_.work / million) + " million"
                                               : std::to_string(most_.work)) +
                    " operations; --budget gives it more");
}
void budget::pass_memory() const {
  throw refusal(outcome::not_checkable, place_,
                "here the check passes its budget of " +
                    std::to_string(most_.memory / (1L << 20U)) +
                    " MB of memory; --memory gives it more");
}

}  // namespace polhode::checker
