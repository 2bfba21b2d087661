#pragma once

// A TOML file as a tree of values whose numbers are kept as they are written, with the line of
// each.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "polhode/arithmetic/exact.hpp"

namespace polhode {

/// A value of a TOML file. A number's text is what stands in the file, without underscores: nothing
/// is rounded.
struct document_member;
struct document_value {
  enum class kind { number, text, boolean, array, table };
  kind type = kind::table;
  std::string text;                      // of a number or a text; "true" or "false"
  std::vector<document_value> items;     // of an array
  std::vector<document_member> members;  // of a table
  long line = 0;

  [[nodiscard]] const document_value* find(std::string_view key) const;
};
struct document_member {
  std::string key;
  document_value value;
};

/// Reads TOML 1.0. Throws input_error, "line 3: ...", for anything else, and for dates and
/// infinities, which no scene has. A number written with a point or an exponent is taken from its
/// place in the text; that it is the one which the parser read there is checked against the
/// parser's double.
[[nodiscard]] document_value parse_document(const std::string& text);

/// The document with other values in the place of its own, each given as "KEY = VALUE" in TOML
/// ("state.omega = [0, 1, 0.1]"); tables are joined. "KEY =" takes the key away. Their line is 0,
/// and messages say "--set" for it. Throws input_error for a setting that is no TOML.
[[nodiscard]] document_value with_settings(document_value document,
                                           const std::vector<std::string>& settings);

/// Throws input_error "line N: KEY: what".
[[noreturn]] void refuse_value(const document_value& at, const std::string& key,
                               const std::string& what);

/// Numbers that stand in the place of those in the file, by their keys ("state.omega[0]"), as a
/// sweep gives them; and all the keys of numbers that were read, so that a key that is none can be
/// told.
struct replacements {
  std::map<std::string, rational> numbers;
  std::set<std::string> seen;
};

/// A number with its uncertainty, where it has one: 2.6, "13/5", "2.6 ± 0.1", "2.6 +- 0.1".
struct measured_number {
  rational value;
  std::optional<rational> sigma;
};

/// Throws input_error where it is none, or its uncertainty is negative.
[[nodiscard]] measured_number parse_measured(const std::string& text);

/// A table being read key by key. Every key has to be read, or finish() refuses it.
class section {
 public:
  section(const document_value& table, std::string path, replacements& replaced)
      : table_(&table), path_(std::move(path)), replaced_(&replaced) {}

  [[nodiscard]] bool has(std::string_view key) const { return table_->find(key) != nullptr; }
  /// The value; input_error where it is missing.
  const document_value& at(const std::string& key);
  const document_value* find(const std::string& key);

  rational number(const std::string& key);
  std::optional<rational> optional_number(const std::string& key);
  measured_number measured(const std::string& key);
  /// A whole number from least to most.
  long count(const std::string& key, long by_default, long least, long most);
  /// true or false.
  bool flag(const std::string& key, bool by_default);
  std::string text(const std::string& key);
  std::optional<std::string> optional_text(const std::string& key);
  std::vector<rational> numbers(const std::string& key, std::size_t how_many);
  std::vector<measured_number> measured_numbers(const std::string& key, std::size_t how_many);
  /// Square, of so many rows.
  std::vector<std::vector<rational>> matrix(const std::string& key, std::size_t rows);
  std::vector<std::string> texts(const std::string& key);
  section table(const std::string& key);
  std::vector<section> tables(const std::string& key);

  [[noreturn]] void refuse(const std::string& key, const std::string& what) const;
  [[noreturn]] void refuse(const std::string& what) const;
  /// Throws input_error for a key that was not read, with the nearest one that may stand here.
  void finish() const;

  [[nodiscard]] const document_value& value() const { return *table_; }
  [[nodiscard]] std::string path_of(const std::string& key) const;

 private:
  measured_number measured_at(const document_value& value, const std::string& path);
  rational number_at(const document_value& value, const std::string& path);

  const document_value* table_;
  std::string path_;
  replacements* replaced_;
  std::set<std::string> asked_;
};

/// A word among those known, or input_error with the nearest one.
void refuse_unless_known(const document_value& at, const std::string& key, const std::string& word,
                         const std::vector<std::string>& known, const std::string& what);

}  // namespace polhode
