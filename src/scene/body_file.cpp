#include "polhode/scene/body_file.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/quoted.hpp"

namespace polhode {
namespace {

using file_json = nlohmann::json;

constexpr const char* right =
    R"(it must be one of {"ab": [a, b]}, {"moments": [Ix, Iy, Iz]}, {"rotational": [A, B, C]}, )"
    R"({"tensor": [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]})";

/// Builds the value with every number as the text that it has in the file.
// NOLINTNEXTLINE(bugprone-exception-escape): its destructor is the library's
class exact_reader : public nlohmann::json_sax<file_json> {
 public:
  file_json result;
  std::string error;

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add(std::to_string(value)); }
  bool number_float(number_float_t, const string_t& text) override { return add(text); }
  bool string(string_t& value) override { return add(value); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(file_json::object()); }
  bool start_array(std::size_t) override { return open(file_json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    if (open_.back()->contains(name)) {
      error = fmt::format("{} appears twice", detail::quoted(name));
      return false;
    }
    key_ = name;
    return true;
  }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& problem) override {
    constexpr int number_overflow = 406;  // the library's number of it
    error = problem.id == number_overflow
                ? "a number has too great an exponent to stand without quotes"
                : fmt::format("it is no JSON from byte {} on", position);
    return false;
  }

 private:
  file_json* place(file_json value) {
    if (open_.empty()) return &(result = std::move(value));
    file_json& parent = *open_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return &parent.back();
    }
    return &(parent[key_] = std::move(value));
  }
  bool add(file_json value) {
    place(std::move(value));
    return true;
  }
  bool open(file_json value) {
    constexpr std::size_t most_nested = 8;
    if (open_.size() >= most_nested) {
      error = "it is nested too deeply";
      return false;
    }
    open_.push_back(place(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::vector<file_json*> open_;
  std::string key_;
};

[[noreturn]] void refuse(const std::string& what) { throw input_error(what + "; " + right); }

rational number_in(const file_json& value, const std::string& name) {
  if (!value.is_string()) refuse(fmt::format("\"{}\" must hold numbers", name));
  return parse_rational(value.get_ref<const std::string&>());
}

template <std::size_t Count>
std::array<rational, Count> numbers_in(const file_json& value, const std::string& name) {
  if (!value.is_array() || value.size() != Count) {
    refuse(fmt::format("\"{}\" must be an array of {} numbers", name, Count));
  }
  std::array<rational, Count> result;
  for (std::size_t i = 0; i < Count; ++i) result[i] = number_in(value[i], name);
  return result;
}

std::array<rational, 6> tensor_in(const file_json& value) {
  if (!value.is_array() || value.size() != 3) refuse(R"("tensor" must be an array of 3 rows)");
  std::array<std::array<rational, 3>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) rows[i] = numbers_in<3>(value[i], "tensor");
  if (rows[0][1] != rows[1][0] || rows[0][2] != rows[2][0] || rows[1][2] != rows[2][1]) {
    refuse(R"("tensor" must be symmetric)");
  }
  return {rows[0][0], rows[1][1], rows[2][2], rows[0][1], rows[0][2], rows[1][2]};
}

}  // namespace

std::string read_text_file(const std::string& path) {
  constexpr std::size_t longest = 4'000'000;
  std::error_code none;
  const std::filesystem::file_status what = std::filesystem::status(path, none);
  if (std::filesystem::is_directory(what)) throw input_error("a directory; it must be a file");
  if (std::filesystem::exists(what) && !std::filesystem::is_regular_file(what))
    throw input_error("a pipe, a socket or a device; it must be a regular file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw input_error(errno == 0 ? "it cannot be opened" : std::generic_category().message(errno));
  std::string text(longest + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw input_error("it cannot be read");
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.empty()) throw input_error("it is empty, or cannot be read");
  if (text.size() > longest) throw input_error(fmt::format("it is longer than {} bytes", longest));
  return text;
}

const std::string& text_files::operator[](const std::string& path) {
  const auto found = read_.find(path);
  if (found != read_.end()) return found->second;
  return read_.emplace(path, read_text_file(path)).first->second;
}

body_file read_body_file(const std::string& path) { return parse_body_file(read_text_file(path)); }

body_file parse_body_file(const std::string& text) {
  exact_reader reader;
  if (!file_json::sax_parse(text, &reader)) refuse(reader.error);
  if (!reader.result.is_object()) refuse("it is no JSON object");
  body_file result;
  int bodies = 0;
  for (const auto& [name, value] : reader.result.items()) {
    if (name == "name") continue;
    if (name != "sigma") ++bodies;
    if (name == "ab") {
      result.ab = numbers_in<2>(value, name);
    } else if (name == "moments") {
      result.moments = numbers_in<3>(value, name);
    } else if (name == "rotational") {
      result.rotational = numbers_in<3>(value, name);
    } else if (name == "sigma") {
      result.sigma = numbers_in<3>(value, name);
    } else if (name == "tensor") {
      result.tensor = tensor_in(value);
    } else {
      refuse(fmt::format("{} is not known", detail::quoted(name)));
    }
  }
  if (bodies != 1) refuse(bodies == 0 ? "there is no body" : "there are several bodies");
  if (result.sigma && !result.moments) refuse(R"("sigma" goes with "moments")");
  return result;
}

}  // namespace polhode
