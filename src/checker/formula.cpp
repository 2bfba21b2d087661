#include "formula.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace polhode::checker {
namespace {

constexpr int most_formula_levels = 500;
constexpr long most_exponent = 1'000'000;
/// Of a rational number that is worked out.
constexpr long most_exact_bits = 1L << 17U;
constexpr long units_of_a_character = 100;
constexpr long units_of_an_instruction = 400;
/// Before the point of any value.
constexpr long most_bits_before_point = 1L << 12U;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Functions by their names; the second half is made of the first.
constexpr std::array function_names{"sqrt", "exp",  "log",   "sin",   "cos",   "sinh",  "cosh",
                                    "atan", "tan",  "tanh",  "expm1", "log1p", "sinpi", "cospi",
                                    "asin", "acos", "asinh", "acosh", "atanh"};

std::string known_functions() {
  std::string result;
  for (const char* name : function_names)
    result += (result.empty() ? "" : ", ") + std::string(name);
  return result;
}

bool is_function(std::string_view name) {
  return std::any_of(function_names.begin(), function_names.end(),
                     [name](const char* known) { return name == known; });
}

}  // namespace

class formula_reader {
 public:
  formula_reader(const place& where, const std::vector<std::string>& variables)
      : where_(where), work_(where.work()), text_(where.text()), variables_(variables) {}

  formula read() {
    const budget::at here = where_.working();
    work_.spend(units_of_a_character * static_cast<long>(text_.size()));
    if (text_.size() > formula::most_characters) {
      where_.malformed("a formula of " + std::to_string(text_.size()) + " characters; at most " +
                       std::to_string(formula::most_characters) + " are read");
    }
    const id root = sum();
    if (at_ < text_.size()) fail("an operator or the end");
    // The result is the last; what an exact operation has left over goes unused.
    if (root + 1 != result_.code_.size()) {
      formula::instruction last = result_.code_[root];
      plain(std::move(last));
    }
    return std::move(result_);
  }

 private:
  using id = std::size_t;
  using operation = formula::operation;

  [[noreturn]] void fail(const std::string& expected) const {
    const std::string found = at_ < text_.size() ? "there is " + in_quotes(text_.substr(at_, 1))
                                                 : std::string("the formula ends");
    where_.malformed("column " + std::to_string(at_ + 1) + ": " + found + " where " + expected +
                     " must be");
  }
  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool takes(char c) {
    skip_spaces();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!takes(c)) fail(std::string("a \"") + c + "\"");
  }

  /// One more level for as long as it lives.
  class deeper {
   public:
    explicit deeper(formula_reader& reader) : levels_(reader.levels_) {
      if (++levels_ > most_formula_levels) {
        reader.where_.malformed("column " + std::to_string(reader.at_ + 1) + ": more than " +
                                std::to_string(most_formula_levels) + " levels inside each other");
      }
    }
    ~deeper() { --levels_; }
    deeper(const deeper&) = delete;
    deeper& operator=(const deeper&) = delete;
    deeper(deeper&&) = delete;
    deeper& operator=(deeper&&) = delete;

   private:
    int& levels_;
  };

  // Grammar ----------------------------------------------------------------------------------

  id sum() {
    const deeper level(*this);
    id left = product();
    for (;;) {
      if (takes('+')) {
        left = combine(operation::add, left, product());
      } else if (takes('-')) {
        left = combine(operation::subtract, left, product());
      } else {
        return left;
      }
    }
  }
  id product() {
    id left = with_sign();
    for (;;) {
      if (takes('*')) {
        left = combine(operation::multiply, left, with_sign());
      } else if (takes('/')) {
        left = combine(operation::divide, left, with_sign());
      } else {
        return left;
      }
    }
  }
  id with_sign() {
    bool negative = false;
    while (takes('-')) negative = !negative;
    const id value = power();
    return negative ? negated(value) : value;
  }
  id power() {
    const deeper level(*this);
    const id base = operand();
    if (!takes('^')) return base;
    bool negative = false;
    while (takes('-')) negative = !negative;
    const id exponent = power();
    return raised(base, negative ? negated(exponent) : exponent);
  }
  id operand() {
    skip_spaces();
    if (at_ == text_.size()) fail("a number, a name or a \"(\"");
    const std::size_t start = at_;
    if (takes('(')) {
      const id inside = sum();
      expect(')');
      return inside;
    }
    if (is_digit(text_[at_])) {
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
      work_.decimals(bits_of_decimal(text_.substr(start, at_ - start)));
      integer value;
      if (!read_integer(text_.substr(start, at_ - start), value)) {
        at_ = start;
        fail("a whole number without leading zeros");
      }
      return number(rational(value));
    }
    if (!is_letter(text_[at_])) fail("a number, a name or a \"(\"");
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const std::string_view name = text_.substr(start, at_ - start);
    const auto variable = std::find(variables_.begin(), variables_.end(), name);
    if (variable != variables_.end()) {
      return plain({operation::variable, static_cast<id>(variable - variables_.begin())});
    }
    if (name == "pi") return plain({operation::pi});
    if (!is_function(name)) {
      std::string known;
      for (const std::string& one : variables_) known += one + ", ";
      where_.malformed("column " + std::to_string(start + 1) + ": " + in_quotes(name) +
                       " is not known; this checker knows " + known + "pi, " + known_functions());
    }
    expect('(');
    const id argument = sum();
    expect(')');
    return call(name, argument);
  }

  // Operations -------------------------------------------------------------------------------

  id plain(formula::instruction i) {
    work_.spend(units_of_an_instruction);
    work_.hold(2 * static_cast<long>(sizeof i) + bit_length(i.number) / 8);
    result_.code_.push_back(std::move(i));
    return result_.code_.size() - 1;
  }
  id number(const rational& q) {
    formula::instruction i{operation::number};
    i.number = q;
    return plain(std::move(i));
  }
  const rational* value(id i) const {
    const formula::instruction& one = result_.code_[i];
    return one.what == operation::number ? &one.number : nullptr;
  }
  id of_one(operation what, id x) { return plain({what, x}); }
  id negated(id x) {
    const rational* q = value(x);
    return q != nullptr ? number(rational(-*q)) : of_one(operation::negate, x);
  }
  id combine(operation what, id x, id y) {
    const rational* p = value(x);
    const rational* q = value(y);
    if (what == operation::divide && q != nullptr && *q == 0) {
      where_.malformed("before column " + std::to_string(at_ + 1) + ": a division by 0");
    }
    if (p != nullptr && q != nullptr && bit_length(*p) + bit_length(*q) < most_exact_bits) {
      work_.rationals(2, bit_length(*p) + bit_length(*q));
      switch (what) {
        case operation::add:
          return number(*p + *q);
        case operation::subtract:
          return number(*p - *q);
        case operation::multiply:
          return number(*p * *q);
        default:
          return number(*p / *q);
      }
    }
    return plain({what, x, y});
  }
  id raised(id base, id exponent) {
    const rational* q = value(exponent);
    if (q == nullptr || denominator(*q) != 1) {
      return of_one(operation::exp,
                    combine(operation::multiply, exponent, of_one(operation::log, base)));
    }
    if (abs(*q) > most_exponent) {
      where_.malformed("before column " + std::to_string(at_ + 1) + ": an exponent beyond " +
                       std::to_string(most_exponent));
    }
    const long n = std::strtol(integer(numerator(*q)).str().c_str(), nullptr, 10);
    const rational* p = value(base);
    if (p != nullptr && *p == 0 && n < 0) {
      where_.malformed("before column " + std::to_string(at_ + 1) + ": a negative power of 0");
    }
    if (p != nullptr && bit_length(*p) * std::abs(n) < most_exact_bits) {
      work_.rationals(3, bit_length(*p) * std::abs(n));
      const auto power = [&](const integer& x) {
        return integer(pow(x, static_cast<unsigned>(std::abs(n))));
      };
      const rational result(power(numerator(*p)), power(denominator(*p)));
      return number(n < 0 ? rational(1 / result) : result);
    }
    formula::instruction i{operation::power, base};
    i.exponent = n;
    return plain(std::move(i));
  }
  id one() { return number(rational(1)); }
  id twice(id x) { return combine(operation::multiply, number(rational(2)), x); }
  id half_of(id x) { return combine(operation::multiply, number(rational(1, 2)), x); }
  id squared(id x) {
    formula::instruction i{operation::power, x};
    i.exponent = 2;
    return plain(std::move(i));
  }
  /// Each as a composition that is analytic where its parts are, and equal to the function on the
  /// real line where it is defined.
  id call(std::string_view name, id x) {
    using enum formula::operation;
    constexpr std::array direct{sqrt, exp, log, sin, cos, sinh, cosh, atan};
    for (std::size_t i = 0; i < direct.size(); ++i) {
      if (name == function_names[i]) return of_one(direct[i], x);
    }
    if (name == "tan") return combine(divide, of_one(sin, x), of_one(cos, x));
    if (name == "tanh") {
      // 1 - 2/(e^(2x) + 1): x stands in it once.
      const id power = of_one(exp, twice(x));
      return combine(subtract, one(), twice(combine(divide, one(), combine(add, power, one()))));
    }
    if (name == "expm1") return combine(subtract, of_one(exp, x), one());
    if (name == "log1p") return of_one(log, combine(add, one(), x));
    if (name == "sinpi") return of_one(sin, combine(multiply, plain({pi}), x));
    if (name == "cospi") return of_one(cos, combine(multiply, plain({pi}), x));
    if (name == "asin" || name == "acos") {
      // tan(t/2) = sin t/(1 + cos t): asin x = 2 arctan(x/(1 + sqrt(1 - x^2))), for -1 <= x <= 1.
      const id root = of_one(sqrt, combine(subtract, one(), squared(x)));
      const id half = of_one(atan, combine(divide, x, combine(add, one(), root)));
      const id sine = twice(half);
      return name == "asin" ? sine : combine(subtract, half_of(plain({pi})), sine);
    }
    if (name == "asinh") {
      return of_one(log, combine(add, x, of_one(sqrt, combine(add, squared(x), one()))));
    }
    if (name == "acosh") {
      const id roots = combine(multiply, of_one(sqrt, combine(subtract, x, one())),
                               of_one(sqrt, combine(add, x, one())));
      return of_one(log, combine(add, x, roots));
    }
    // atanh x = log((1 + x)/(1 - x))/2.
    return half_of(
        of_one(log, combine(divide, combine(add, one(), x), combine(subtract, one(), x))));
  }

  const place& where_;
  budget& work_;
  std::string_view text_;
  const std::vector<std::string>& variables_;
  std::size_t at_ = 0;
  int levels_ = 0;
  formula result_;
};

formula formula::read(const place& where, const std::vector<std::string>& variables) {
  return formula_reader(where, variables).read();
}

bool formula::is_variable(std::string_view text) {
  constexpr std::size_t longest = 100;
  if (text.empty() || text.size() > longest || !is_letter(text.front()) ||
      !std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); })) {
    return false;
  }
  std::string small(text);
  for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  constexpr std::array constants{"pi",       "e",   "i",           "inf",
                                 "infinity", "nan", "euler_gamma", "catalan"};
  if (is_function(small) || std::find(constants.begin(), constants.end(), small) != constants.end())
    return false;
  return text.find_first_not_of("lIOo_0123456789") != std::string_view::npos;
}

std::optional<rational> formula::exact_value() const {
  if (code_.back().what != operation::number) return std::nullopt;
  return code_.back().number;
}

namespace {

template <class T>
void refuse_great(const T& x) {
  if (bits_before_point(x) > most_bits_before_point) throw undecided("a value is too great");
}

/// x^n by squares.
template <class T>
T whole_power(const T& x, long n) {
  if (n < 0) return constant(rational(1), x) / whole_power(x, -n);
  if (n == 0) return constant(rational(1), x);
  T result = x;
  int bit = 62;
  while ((n >> bit) == 0) --bit;
  for (--bit; bit >= 0; --bit) {
    result = square(result);
    if (((n >> bit) & 1) != 0) result = result * x;
    refuse_great(result);
  }
  return result;
}

}  // namespace

template <class T>
T formula::operator()(const std::vector<T>& x) const {
  const T& like = x.front();
  const precision& bits = precision_of(like);
  const auto count = static_cast<long>(code_.size());
  constexpr long ends = 2 * sizeof(T) / sizeof(interval);
  const budget::memory held(bits.work(), count * (static_cast<long>(sizeof(T)) +
                                                  ends * (bits + most_bits_before_point) / 8));
  std::vector<T> values;
  values.reserve(code_.size());
  for (const instruction& i : code_) {
    bits.work().spend(units_of_an_instruction);
    const auto left = [&]() -> const T& { return values[i.left]; };
    const auto right = [&]() -> const T& { return values[i.right]; };
    values.push_back([&]() -> T {
      switch (i.what) {
        case operation::number:
          return constant(i.number, like);
        case operation::variable:
          return x[i.left];
        case operation::pi:
          return pi_like(like);
        case operation::negate:
          return -left();
        case operation::add:
          return left() + right();
        case operation::subtract:
          return left() - right();
        case operation::multiply:
          return left() * right();
        case operation::divide:
          return left() / right();
        case operation::power:
          return whole_power(left(), i.exponent);
        case operation::sqrt:
          return checker::sqrt(left());
        case operation::exp:
          return exp_over(left());
        case operation::log:
          return checker::log(left());
        case operation::sin:
          return checker::sin(left());
        case operation::cos:
          return checker::cos(left());
        case operation::sinh:
          return checker::sinh(left());
        case operation::cosh:
          return checker::cosh(left());
        case operation::atan:
          break;
      }
      return atan_over(left());
    }());
    refuse_great(values.back());
  }
  return std::move(values.back());
}

template interval formula::operator()(const std::vector<interval>& x) const;
template jet formula::operator()(const std::vector<jet>& x) const;
template rectangle formula::operator()(const std::vector<rectangle>& x) const;

}  // namespace polhode::checker
