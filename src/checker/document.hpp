#pragma once

// A certificate's JSON: read within limits, and walked with the place known at every step, so that
// an error can name it.

#include <initializer_list>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "exact.hpp"
#include "polhode/checker/check.hpp"

namespace polhode::checker {

using json = nlohmann::ordered_json;

/// Reads JSON of at most 16 levels in which no key appears twice and every number is whole; throws
/// refusal.
[[nodiscard]] json read_json(std::string_view text, budget& work);

/// "…" with what is long cut short and what is not printable escaped.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// A value, where it stands, and the budget that reading it is charged to.
class place {
 public:
  place(const json& value, std::string pointer, budget& work)
      : value_(&value), pointer_(std::move(pointer)), work_(&work) {}

  [[nodiscard]] const std::string& pointer() const { return pointer_; }
  [[nodiscard]] const json& value() const { return *value_; }
  [[nodiscard]] budget& work() const { return *work_; }
  /// What is done while it lives is done here.
  [[nodiscard]] budget::at working() const { return {*work_, pointer_}; }

  [[noreturn]] void malformed(const std::string& message) const;
  [[noreturn]] void refute(const std::string& message) const;
  [[noreturn]] void not_checkable(const std::string& message) const;

  /// The member; malformed where it is missing, or this is no object.
  [[nodiscard]] place operator[](const std::string& key) const;
  [[nodiscard]] bool has(const std::string& key) const;
  /// Malformed unless this is an object with these keys and no other, in any order.
  void expect_keys(std::initializer_list<const char*> keys) const;
  /// The elements' number; malformed unless this is an array.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] place at(std::size_t index) const;

  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] long whole(long least, long most) const;
  [[nodiscard]] integer big() const;             // decimal digits in a string
  [[nodiscard]] rational fraction() const;       // "253/20" in a string
  [[nodiscard]] rational decimal_value() const;  // "0.028" in a string
  /// Refutes a text that is not this one.
  void expect_text(std::string_view right) const;
  void expect_true() const;
  void expect_whole(long right) const;

 private:
  /// Charges for reading a number.
  [[nodiscard]] bool may_be_read() const;

  const json* value_;
  std::string pointer_;
  budget* work_;
};

}  // namespace polhode::checker
