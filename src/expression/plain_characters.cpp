#include "plain_characters.hpp"

#include <algorithm>
#include <array>

#include "polhode/expression/expression.hpp"

namespace polhode::detail {
namespace {

struct character {
  std::string_view typeset;
  std::string_view plain;
};

constexpr std::array<character, 9> operators{{{"\u2212", "-"},
                                              {"\u00D7", "*"},
                                              {"\u00B7", "*"},
                                              {"\u22C5", "*"},
                                              {"\u2217", "*"},
                                              {"\u00F7", "/"},
                                              {"\u2215", "/"},
                                              {"\u03C0", " pi "},
                                              {"\u00A0", " "}}};

constexpr std::array<character, 11> superscripts{{{"\u2070", "0"},
                                                  {"\u00B9", "1"},
                                                  {"\u00B2", "2"},
                                                  {"\u00B3", "3"},
                                                  {"\u2074", "4"},
                                                  {"\u2075", "5"},
                                                  {"\u2076", "6"},
                                                  {"\u2077", "7"},
                                                  {"\u2078", "8"},
                                                  {"\u2079", "9"},
                                                  {"\u207B", "-"}}};

constexpr std::string_view root_sign = "\u221A";

template <std::size_t Count>
const character* begins_with(std::string_view text, const std::array<character, Count>& known) {
  const auto found = std::find_if(known.begin(), known.end(), [&](const character& one) {
    return text.starts_with(one.typeset);
  });
  return found == known.end() ? nullptr : &*found;
}

/// Without those at the beginning.
std::string_view without_spaces(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t\n\v\f\r"), text.size()));
}

class translator {
 public:
  explicit translator(std::string_view given) : given_(given) {}

  plain_formula result() {
    while (at_ < given_.size()) {
      const std::string_view rest = given_.substr(at_);
      const auto byte = static_cast<unsigned char>(rest.front());
      if (byte < 0x80) {
        put(rest.substr(0, 1), 1);
      } else if (const character* one = begins_with(rest, operators)) {
        put(one->plain, one->typeset.size());
      } else if (begins_with(rest, superscripts) != nullptr) {
        superscript();
      } else if (rest.starts_with(root_sign)) {
        root();
      } else {
        throw expression_error(at_ + 1, foreign_character);
      }
    }
    made_.columns.push_back(given_.size() + 1);
    return std::move(made_);
  }

 private:
  /// In place of so many bytes of what is given.
  void put(std::string_view plain, std::size_t bytes) {
    made_.text += plain;
    made_.columns.insert(made_.columns.end(), plain.size(), at_ + 1);
    at_ += bytes;
  }
  void superscript() {
    const std::size_t begin = at_;
    put("^(", 0);
    const std::size_t first = made_.text.size();
    while (const character* one = begins_with(given_.substr(at_), superscripts)) {
      put(one->plain, one->typeset.size());
    }
    const std::string_view number = std::string_view(made_.text).substr(first);
    if (number == "-" || number.rfind('-') + 1 > 1) {
      throw expression_error(begin + 1, "a superscript must be a whole number");
    }
    put(")", 0);
    const std::string_view rest = without_spaces(given_.substr(at_));
    if (rest.starts_with('^') || rest.starts_with('!') || rest.starts_with("**") ||
        begins_with(rest, superscripts) != nullptr) {
      throw expression_error(begin + 1,
                             "a power of a power, or a factorial of one, needs parentheses");
    }
  }
  void root() {
    if (!without_spaces(given_.substr(at_ + root_sign.size())).starts_with('(')) {
      throw expression_error(at_ + 1, "a root is written sqrt(x)");
    }
    put("sqrt", root_sign.size());
  }

  std::string_view given_;
  std::size_t at_ = 0;
  plain_formula made_;
};

}  // namespace

plain_formula in_plain_characters(std::string_view formula) { return translator(formula).result(); }

}  // namespace polhode::detail
