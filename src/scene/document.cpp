#include "polhode/scene/document.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "base/quoted.hpp"

// Its assertions end the program at some bad input, which it refuses without them.
#define TOML_ASSERT(condition) static_cast<void>(0)  // NOLINT(cppcoreguidelines-macro-usage)
#include <toml++/toml.h>

namespace polhode {
namespace {

[[noreturn]] void refuse_line(long line, const std::string& what) {
  if (line == 0) throw input_error("--set: " + what);
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

  /// From a place on, columns counted in characters from 1 on (each of UTF-8's bytes but the
  /// continuing ones begins one), what may belong to a decimal number.
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
    // Both are the nearest double of the same decimal; strtod depends on the locale, from_chars
    // does not.
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

}  // namespace

const document_value* document_value::find(std::string_view key) const {
  for (const auto& [name, value] : members) {
    if (name == key) return &value;
  }
  return nullptr;
}

namespace {

/// The parser limits how deep arrays and inline tables are nested, but not the parts of a dotted
/// key, each of which is a table in a table: a few bytes a level, and recursion over them would end
/// at the end of the stack. Dots in quotes and comments don't count.
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

namespace {

void forget_lines(document_value& value) {
  value.line = 0;
  for (document_value& item : value.items) forget_lines(item);
  for (document_member& member : value.members) forget_lines(member.value);
}

void join(document_value& base, document_value more) {
  for (document_member& member : more.members) {
    const auto found = std::ranges::find(base.members, member.key, &document_member::key);
    if (found == base.members.end()) {
      base.members.push_back(std::move(member));
    } else if (found->value.type == document_value::kind::table &&
               member.value.type == document_value::kind::table) {
      join(found->value, std::move(member.value));
    } else {
      found->value = std::move(member.value);
    }
  }
}

/// Takes away what the only chain of tables in `key` leads to.
void remove(document_value& base, const document_value& key) {
  const document_member& next = key.members.front();
  const auto found = std::ranges::find(base.members, next.key, &document_member::key);
  if (found == base.members.end()) return;
  if (next.value.members.empty()) {
    base.members.erase(found);
  } else {
    remove(found->value, next.value);
  }
}

}  // namespace

document_value with_settings(document_value document, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const auto equals = setting.find('=');
    const bool removes = equals != std::string::npos &&
                         setting.find_first_not_of(" \t", equals + 1) == std::string::npos;
    document_value change;
    try {
      change = parse_document(removes ? setting + "{}" : setting);
    } catch (const input_error& error) {
      throw input_error("--set " + detail::quoted(setting) +
                        ": it must be KEY=VALUE as in a scene, such as "
                        "\"state.omega=[0, 1, 0.1]\" (" +
                        error.what() + ")");
    }
    if (change.members.empty()) {
      throw input_error("--set " + detail::quoted(setting) + ": there is no key in it");
    }
    forget_lines(change);
    if (removes) {
      remove(document, change);
    } else {
      join(document, std::move(change));
    }
  }
  return document;
}

void refuse_value(const document_value& at, const std::string& key, const std::string& what) {
  refuse_line(at.line, key + ": " + what);
}

}  // namespace polhode
