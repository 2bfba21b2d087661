#pragma once

// Values that are made when they are asked for first.

#include <mutex>
#include <optional>

namespace polhode::detail {

/// A value that several threads may ask for; the first of them makes it.
template <class T>
class on_first_use {
 public:
  /// The value; make() returns it, and is called once.
  template <class Make>
  [[nodiscard]] const T& made_by(const Make& make) const {
    std::call_once(once_, [&] { value_.emplace(make()); });
    return *value_;
  }

 private:
  mutable std::once_flag once_;
  mutable std::optional<T> value_;
};

}  // namespace polhode::detail
