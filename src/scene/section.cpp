// A table of a scene's file, read key by key.

#include <algorithm>

#include "base/nearest_name.hpp"
#include "base/quoted.hpp"
#include "polhode/scene/document.hpp"

namespace polhode {
namespace {

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

measured_number parse_measured(const std::string& text) {
  measured_number result;
  std::string number = text;
  for (const std::string& sign : {std::string("±"), std::string("+-"), std::string("+/-")}) {
    const auto place = number.find(sign);
    if (place == std::string::npos) continue;
    result.sigma = parse_rational(stripped(number.substr(place + sign.size())));
    if (*result.sigma < 0) throw input_error("an uncertainty must not be negative");
    number = number.substr(0, place);
    break;
  }
  result.value = parse_rational(stripped(number));
  return result;
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
  try {
    if (value.type == kind::text) {
      result = parse_measured(value.text);
    } else {
      result.value = parse_rational(value.text);
    }
  } catch (const input_error& error) {
    refuse_value(value, path, error.what());
  }
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

bool section::flag(const std::string& key, bool by_default) {
  const document_value* value = find(key);
  if (!value) return by_default;
  if (value->type != document_value::kind::boolean)
    refuse(key, std::string("it is ") + name_of(value->type) + "; it must be true or false");
  return value->text == "true";
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
