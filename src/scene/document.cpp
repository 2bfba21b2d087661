#include "polhode/scene/document.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

// Its assertions end the program at some bad input, which it refuses without them.
#define TOML_ASSERT(condition) static_cast<void>(0)  // NOLINT(cppcoreguidelines-macro-usage)
#include <toml++/toml.h>

#include "base/nearest_name.hpp"
#include "base/quoted.hpp"

namespace polhode {
namespace {

[[noreturn]] void refuse_line(long line, const std::string& what) {
  throw input_error("line " + std::to_string(line) + ": " + what);
}

long line_of(const toml::node& node) { return static_cast<long>(node.source().begin.line); }

/// Where the lines of a text begin.
class line_index {
 public:
  explicit line_index(const std::string& text) : text_(&text) {
    begins_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') begins_.push_back(i + 1);
    }
  }

  /// From a place on, columns counted in characters from 1 on (each of UTF-8's bytes but the continuing ones begins one), what may
  /// belong to a decimal number.
  [[nodiscard]] std::string number_at(const toml::source_position& place) const {
    if (place.line < 1 || place.line > begins_.size()) return "";
    std::size_t at = begins_[place.line - 1];
    for (toml::source_index column = 1; column < place.column && at < text_->size(); ++column) {
      ++at;
      while (at < text_->size() && (static_cast<unsigned char>((*text_)[at]) & 0xc0U) == 0x80) ++at;
    }
    std::string result;
    for (; at < text_->size(); ++at) {
      const char c = (*text_)[at];
      if (c == '_') continue;
      const bool belongs =
          (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E';
      if (!belongs) break;
      result += c;
    }
    return result;
  }

 private:
  const std::string* text_;
  std::vector<std::size_t> begins_;
};

class converter {
 public:
  explicit converter(const std::string& text) : lines_(text) {}

  [[nodiscard]] document_value value_of(const toml::node& node) const {
    document_value result;
    result.line = line_of(node);
    if (const auto* table = node.as_table()) {
      result.type = document_value::kind::table;
      for (const auto& [key, member] : *table) {
        result.members.push_back({std::string(key.str()), value_of(member)});
      }
      // In the file's order: errors and reports follow it.
      std::stable_sort(result.members.begin(), result.members.end(),
                       [](const auto& x, const auto& y) { return x.value.line < y.value.line; });
    } else if (const auto* array = node.as_array()) {
      result.type = document_value::kind::array;
      result.items.reserve(array->size());
      for (const auto& item : *array) result.items.push_back(value_of(item));
    } else if (const auto* text = node.as_string()) {
      result.type = document_value::kind::text;
      result.text = text->get();
    } else if (const auto* whole = node.as_integer()) {
      result.type = document_value::kind::number;
      result.text = std::to_string(whole->get());
    } else if (const auto* number = node.as_floating_point()) {
      result.type = document_value::kind::number;
      result.text = text_of(number->get(), node);
    } else if (const auto* truth = node.as_boolean()) {
      result.type = document_value::kind::boolean;
      result.text = truth->get() ? "true" : "false";
    } else {
      refuse_line(result.line, "dates and times have no place in a scene; give a number or a text");
    }
    return result;
  }

 private:
  [[nodiscard]] std::string text_of(double value, const toml::node& node) const {
    if (!std::isfinite(value)) {
      refuse_line(line_of(node),
                  "a number must be finite; write one with an exponent of more than 308 in quotes");
    }
    std::string text = lines_.number_at(node.source().begin);
    // Both are the nearest double of the same decimal; strtod depends on the locale, from_chars does not.
    double again = 0;
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(begin, end, again);
    const bool same = rest == end && (error == std::errc::result_out_of_range ||
                                      !(again < value || again > value));
    if (!same) {
      refuse_line(line_of(node),
                  "a number was not found again in the text; write it in quotes, \"0.1\"");
    }
    return text;
  }

  line_index lines_;
};

const char* name_of(document_value::kind type) {
  switch (type) {
    case document_value::kind::number:
      return "a number";
    case document_value::kind::text:
      return "a text";
    case document_value::kind::boolean:
      return "a boolean";
    case document_value::kind::array:
      return "an array";
    case document_value::kind::table:
      break;
  }
  return "a table";
}

std::string stripped(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

std::string indexed(const std::string& path, std::size_t i) {
  return path + '[' + std::to_string(i) + ']';
}

}  // namespace

const document_value* document_value::find(std::string_view key) const {
  for (const auto& [name, value] : members) {
    if (name == key) return &value;
  }
  return nullptr;
}

namespace {

/// The parser limits how deep arrays and inline tables are nested, but not the parts of a dotted key, each of which is a table in a
/// table: a few bytes a level, and recursion over them would end at the end of the stack. Dots in quotes and comments don't count.
void refuse_long_keys(const std::string& text) {
  constexpr int most_parts = 16;
  long line = 1;
  int dots = 0;
  char quote = 0;           // of the string that is open
  bool many_lines = false;  // it began with three
  bool comment = false;
  const auto is_triple = [&](std::size_t i) {
    return i + 2 < text.size() && text[i + 1] == text[i] && text[i + 2] == text[i];
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      ++line;
      comment = false;
      if (many_lines) continue;
      dots = 0;
      quote = 0;
    } else if (comment) {
      continue;
    } else if (quote != 0) {
      if (c == '\\' && quote == '"') {
        if (i + 1 < text.size() && text[i + 1] != '\n') ++i;
      } else if (c == quote && many_lines) {
        if (!is_triple(i)) continue;
        i += 2;
        quote = 0;
        many_lines = false;
      } else if (c == quote) {
        quote = 0;
      }
    } else if (c == '"' || c == '\'') {
      quote = c;
      many_lines = is_triple(i);
      if (many_lines) i += 2;
    } else if (c == '#') {
      comment = true;
    } else if (c == '=' || c == ',' || c == '{' || c == '[') {
      dots = 0;
    } else if (c == '.' && ++dots >= most_parts) {
      refuse_line(line, "a key of more than " + std::to_string(most_parts) +
                            " parts; no scene has such a key");
    }
  }
}

}  // namespace

document_value parse_document(const std::string& text) {
  refuse_long_keys(text);
  toml::table root;
  try {
    root = toml::parse(text);
  } catch (const toml::parse_error& error) {
    const std::string what(error.description());
    const bool number = what.find("floating-point") != std::string::npos ||
                        what.find("integer") != std::string::npos;
    refuse_line(
        static_cast<long>(error.source().begin.line),
        "no TOML: " + what +
            (number ? "; a long number, or one with a great exponent, may stand in quotes" : ""));
  }
  return converter(text).value_of(root);
}

void refuse_value(const document_value& at, const std::string& key, const std::string& what) {
  refuse_line(at.line, key + ": " + what);
}

namespace {
/// The known word that is near, else all of them.
std::string nearest_or_all(const std::string& word, const std::vector<std::string>& known) {
  if (const auto near = near_name(word, known)) return "the nearest is \"" + *near + '"';
  std::string all;
  for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
  return "it must be one of " + all;
}
}  // namespace

void refuse_unless_known(const document_value& at, const std::string& key, const std::string& word,
                         const std::vector<std::string>& known, const std::string& what) {
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  refuse_value(at, key,
               what + " " + detail::quoted(word) + " is not known; " + nearest_or_all(word, known));
}

// ---------------------------------------------------------------------------------------------
// Sections

std::string section::path_of(const std::string& key) const {
  return path_.empty() ? key : path_ + '.' + key;
}

void section::refuse(const std::string& key, const std::string& what) const {
  const document_value* value = table_->find(key);
  refuse_value(value ? *value : *table_, path_of(key), what);
}
void section::refuse(const std::string& what) const {
  if (path_.empty()) throw input_error(what);
  refuse_value(*table_, path_, what);
}

const document_value* section::find(const std::string& key) {
  asked_.insert(key);
  return table_->find(key);
}

const document_value& section::at(const std::string& key) {
  const document_value* value = find(key);
  if (!value) refuse(detail::quoted(key) + " is missing");
  return *value;
}

rational section::number_at(const document_value& value, const std::string& path) {
  measured_number result = measured_at(value, path);
  if (result.sigma) refuse_value(value, path, "an uncertainty has no place here");
  return std::move(result.value);
}

measured_number section::measured_at(const document_value& value, const std::string& path) {
  using kind = document_value::kind;
  if (value.type != kind::number && value.type != kind::text) {
    refuse_value(
        value, path,
        std::string("it is ") + name_of(value.type) + "; it must be a number, 0.1 or \"1/3\"");
  }
  replaced_->seen.insert(path);
  measured_number result;
  std::string number = value.text;
  try {
    for (const std::string& sign : {std::string("±"), std::string("+-"), std::string("+/-")}) {
      const auto place = number.find(sign);
      if (place == std::string::npos || value.type != kind::text) continue;
      result.sigma = parse_rational(stripped(number.substr(place + sign.size())));
      number = number.substr(0, place);
      break;
    }
    result.value = parse_rational(stripped(number));
  } catch (const input_error& error) {
    refuse_value(value, path, error.what());
  }
  if (result.sigma && *result.sigma < 0)
    refuse_value(value, path, "an uncertainty must not be negative");
  const auto replaced = replaced_->numbers.find(path);
  if (replaced != replaced_->numbers.end()) result.value = replaced->second;
  return result;
}

rational section::number(const std::string& key) { return number_at(at(key), path_of(key)); }

std::optional<rational> section::optional_number(const std::string& key) {
  if (!find(key)) return std::nullopt;
  return number(key);
}

measured_number section::measured(const std::string& key) {
  return measured_at(at(key), path_of(key));
}

long section::count(const std::string& key, long by_default, long least, long most) {
  if (!find(key)) return by_default;
  const rational n = number(key);
  if (denominator(n) != 1 || n < least || n > most) {
    refuse(key, "it must be a whole number from " + std::to_string(least) + " to " +
                    std::to_string(most));
  }
  return static_cast<long>(numerator(n));
}

std::string section::text(const std::string& key) {
  const document_value& value = at(key);
  if (value.type != document_value::kind::text) {
    refuse(key, std::string("it is ") + name_of(value.type) + "; it must be a text in quotes");
  }
  return value.text;
}

std::optional<std::string> section::optional_text(const std::string& key) {
  if (!find(key)) return std::nullopt;
  return text(key);
}

namespace {
const std::vector<document_value>& items_of(const document_value& value, const std::string& path,
                                            std::size_t how_many, const char* what) {
  if (value.type != document_value::kind::array || value.items.size() != how_many) {
    refuse_value(value, path, "it must be an array of " + std::to_string(how_many) + ' ' + what);
  }
  return value.items;
}
}  // namespace

std::vector<measured_number> section::measured_numbers(const std::string& key,
                                                       std::size_t how_many) {
  const std::string path = path_of(key);
  const auto& items = items_of(at(key), path, how_many, "numbers");
  std::vector<measured_number> result;
  result.reserve(how_many);
  for (std::size_t i = 0; i < how_many; ++i)
    result.push_back(measured_at(items[i], indexed(path, i)));
  return result;
}

std::vector<rational> section::numbers(const std::string& key, std::size_t how_many) {
  const std::string path = path_of(key);
  const auto& items = items_of(at(key), path, how_many, "numbers");
  std::vector<rational> result;
  result.reserve(how_many);
  for (std::size_t i = 0; i < how_many; ++i)
    result.push_back(number_at(items[i], indexed(path, i)));
  return result;
}

std::vector<std::vector<rational>> section::matrix(const std::string& key, std::size_t rows) {
  const std::string path = path_of(key);
  const auto& all = items_of(at(key), path, rows, "rows");
  std::vector<std::vector<rational>> result(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::string row = indexed(path, i);
    const auto& items = items_of(all[i], row, rows, "numbers");
    result[i].reserve(rows);
    for (std::size_t k = 0; k < rows; ++k)
      result[i].push_back(number_at(items[k], indexed(row, k)));
  }
  return result;
}

std::vector<std::string> section::texts(const std::string& key) {
  const document_value& value = at(key);
  if (value.type != document_value::kind::array) refuse(key, "it must be an array of texts");
  std::vector<std::string> result;
  result.reserve(value.items.size());
  for (const document_value& item : value.items) {
    if (item.type != document_value::kind::text)
      refuse_value(item, path_of(key), "it must be an array of texts");
    result.push_back(item.text);
  }
  return result;
}

section section::table(const std::string& key) {
  const document_value& value = at(key);
  if (value.type != document_value::kind::table)
    refuse(key, "it must be a table, [" + path_of(key) + ']');
  return {value, path_of(key), *replaced_};
}

std::vector<section> section::tables(const std::string& key) {
  const document_value& value = at(key);
  const std::string path = path_of(key);
  const bool right =
      value.type == document_value::kind::array && !value.items.empty() &&
      std::all_of(value.items.begin(), value.items.end(), [](const document_value& item) {
        return item.type == document_value::kind::table;
      });
  if (!right) refuse(key, "it must be one or more tables, [[" + path + "]]");
  std::vector<section> result;
  result.reserve(value.items.size());
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    result.emplace_back(value.items[i], indexed(path, i), *replaced_);
  }
  return result;
}

void section::finish() const {
  for (const auto& [key, value] : table_->members) {
    if (asked_.contains(key)) continue;
    const std::vector<std::string> known(asked_.begin(), asked_.end());
    const std::string where = path_.empty() ? "a scene" : path_;
    refuse_value(value, detail::quoted(key),
                 "this key is not known in " + where + "; " + nearest_or_all(key, known));
  }
}

}  // namespace polhode
