#include "document.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace polhode::checker {
namespace {

constexpr std::size_t most_nesting = 16;
constexpr std::size_t most_values = 1'000'000;
constexpr std::size_t most_digits_of_integer = 2'000'000;

/// A key as a part of a JSON pointer (RFC 6901).
std::string escaped(std::string_view key) {
  std::string result;
  for (const char c : key.substr(0, 80)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte >= 0x7f) {  // nothing that a terminal would obey
      constexpr std::string_view hexadecimal = "0123456789abcdef";
      result += "\\x";
      result += hexadecimal[byte / 16];
      result += hexadecimal[byte % 16];
    } else {
      result += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    }
  }
  return result;
}

// NOLINTNEXTLINE(bugprone-exception-escape): its destructor is the library's
class limited_reader : public nlohmann::json_sax<json> {
 public:
  explicit limited_reader(budget& work) : work_(work) {}

  json result;

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t, const string_t& text) override {
    refuse("the number " + in_quotes(text) +
           " stands outside quotes: it must be whole and below 2^63");
  }
  bool string(string_t& value) override {
    work_.hold(static_cast<long>(value.size()));
    return add(std::move(value));
  }
  bool binary(binary_t&) override { refuse("binary data"); }
  bool start_object(std::size_t) override { return open(json::object()); }
  bool start_array(std::size_t) override { return open(json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    levels_.back().key = name;
    const budget::at here(work_, pointer());
    work_.spend(16 * static_cast<long>(levels_.back().value->size()));
    work_.hold(static_cast<long>(sizeof(json::object_t::value_type) + name.size()));
    constexpr std::size_t most_members = 1000;  // they are looked through one by one
    if (levels_.back().value->size() >= most_members) {
      refuse("more than " + std::to_string(most_members) + " members");
    }
    if (levels_.back().value->contains(name)) refuse("this key appears twice");
    return true;
  }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& problem) override {
    constexpr int number_overflow = 406;  // the library's number of it
    if (problem.id == number_overflow) refuse("a number outside quotes is too great");
    refuse("it is no JSON from byte " + std::to_string(position) + " on");
  }

 private:
  struct level {
    json* value;
    std::string key;  // of the member that is being read
  };

  [[nodiscard]] std::string pointer() const {
    std::string text;
    for (const level& l : levels_) {
      text += '/' + (l.value->is_array() ? std::to_string(l.value->size()) : escaped(l.key));
    }
    return text;
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw refusal(outcome::malformed, pointer(), what);
  }
  json* put(json value) {
    if (++values_ > most_values) refuse("more than a million values");
    const budget::at here(work_, pointer());
    work_.spend(400);
    work_.hold(2 * static_cast<long>(sizeof(json)));
    if (levels_.empty()) return &(result = std::move(value));
    json& parent = *levels_.back().value;
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return &parent.back();
    }
    return &(parent[levels_.back().key] = std::move(value));
  }
  bool add(json value) {
    put(std::move(value));
    return true;
  }
  bool open(json value) {
    if (levels_.size() >= most_nesting) {
      refuse("nested deeper than " + std::to_string(most_nesting) + " levels");
    }
    levels_.push_back({put(std::move(value)), ""});
    return true;
  }
  bool close() {
    levels_.pop_back();
    return true;
  }

  budget& work_;
  std::vector<level> levels_;
  std::size_t values_ = 0;
};

std::string kind_of(const json& value) { return value.type_name(); }

}  // namespace

json read_json(std::string_view text, budget& work) {
  if (text.size() > most_certificate_bytes) {
    throw refusal(outcome::malformed, "",
                  "it has " + std::to_string(text.size()) + " bytes; at most " +
                      std::to_string(most_certificate_bytes) + " are read");
  }
  // The library takes a NUL for the end of the text.
  if (const std::size_t end = text.find('\0'); end != std::string_view::npos) {
    throw refusal(outcome::malformed, "",
                  "it is no JSON from byte " + std::to_string(end + 1) + " on");
  }
  constexpr long units_of_a_byte = 40;
  work.spend(units_of_a_byte * static_cast<long>(text.size()));
  limited_reader reader(work);
  if (!json::sax_parse(text, &reader)) throw refusal(outcome::malformed, "", "it is no JSON");
  return std::move(reader.result);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t most = 60;
  constexpr const char* hex = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text.substr(0, most)) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x20 && code < 0x7f) {
      result += c;
    } else {
      result += std::string("\\x") + hex[code / 16U] + hex[code % 16U];
    }
  }
  return result + (text.size() > most ? "…\"" : "\"");
}

void place::malformed(const std::string& message) const {
  throw refusal(outcome::malformed, pointer_, message);
}
void place::refute(const std::string& message) const {
  throw refusal(outcome::refuted, pointer_, message);
}
void place::not_checkable(const std::string& message) const {
  throw refusal(outcome::not_checkable, pointer_, message);
}

bool place::has(const std::string& key) const {
  return value_->is_object() && value_->contains(key);
}
place place::operator[](const std::string& key) const {
  if (!value_->is_object())
    malformed("it is of type " + kind_of(*value_) + "; it must be an object");
  work_->spend(100 + 16 * static_cast<long>(value_->size()));
  const auto found = value_->find(key);
  place member(found == value_->end() ? *value_ : *found, pointer_ + '/' + escaped(key), *work_);
  if (found == value_->end()) member.malformed("it is missing");
  return member;
}
void place::expect_keys(std::initializer_list<const char*> keys) const {
  for (const char* key : keys) static_cast<void>((*this)[key]);
  for (const auto& [key, value] : value_->items()) {
    const std::string& name = key;
    if (std::none_of(keys.begin(), keys.end(), [&](const char* k) { return name == k; })) {
      place(value, pointer_ + '/' + escaped(name), *work_)
          .malformed("no certificate has this key here");
    }
  }
}
std::size_t place::size() const {
  if (!value_->is_array()) malformed("it is of type " + kind_of(*value_) + "; it must be an array");
  return value_->size();
}
place place::at(std::size_t index) const {
  const bool there = index < size();
  work_->spend(100);
  place element(there ? (*value_)[index] : *value_, pointer_ + '/' + std::to_string(index), *work_);
  if (!there) element.malformed("it is missing");
  return element;
}
const std::string& place::text() const {
  if (!value_->is_string())
    malformed("it is of type " + kind_of(*value_) + "; it must be a string");
  return value_->get_ref<const std::string&>();
}
long place::whole(long least, long most) const {
  const auto range = [&] {
    return "it must be a whole number from " + std::to_string(least) + " to " +
           std::to_string(most);
  };
  if (!value_->is_number_integer()) malformed("it is of type " + kind_of(*value_) + "; " + range());
  if (value_->is_number_unsigned() && value_->get<std::uint64_t>() > (std::uint64_t{1} << 62U)) {
    malformed("it is too great; " + range());
  }
  const auto value = value_->get<std::int64_t>();
  if (value < least || value > most) malformed("it is " + std::to_string(value) + "; " + range());
  return static_cast<long>(value);
}
bool place::may_be_read() const {
  if (text().size() > most_digits_of_integer) return false;
  const budget::at here = working();
  work_->decimals(bits_of_decimal(text()));
  return true;
}
integer place::big() const {
  integer value;
  if (!may_be_read() || !read_integer(text(), value)) {
    malformed("it is " + in_quotes(text()) + "; it must be a whole number in decimal digits");
  }
  return value;
}
rational place::fraction() const {
  rational value;
  if (!may_be_read() || !read_rational(text(), value)) {
    malformed("it is " + in_quotes(text()) +
              "; it must be a whole number or a fraction in lowest terms, as 253/20");
  }
  return value;
}
rational place::decimal_value() const {
  rational value;
  if (!may_be_read() || !read_decimal(text(), value)) {
    malformed("it is " + in_quotes(text()) + "; it must be a decimal number, as 0.028 or 2.8e-20");
  }
  return value;
}
void place::expect_text(std::string_view right) const {
  if (text() != right) refute("it is " + in_quotes(text()) + "; it must be " + in_quotes(right));
}
void place::expect_true() const {
  if (!value_->is_boolean()) malformed("it is of type " + kind_of(*value_) + "; it must be true");
  if (!value_->get<bool>()) refute("it is false; in a certificate that is certified it is true");
}
void place::expect_whole(long right) const {
  constexpr long most = 1L << 60U;
  const long value = whole(-most, most);
  if (value != right) {
    refute("it is " + std::to_string(value) + "; it must be " + std::to_string(right));
  }
}

}  // namespace polhode::checker
