#include "term.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "polhode/expression/library_functions.hpp"

namespace polhode::differential {
namespace {

/// How tightly a text holds together: 1 a sum, 2 a product or a sign, 4 what needs no parentheses.
int strength(const term& t) {
  if (t.is_leaf()) {
    if (t.head().front() == '-') return 1;
    return t.head().find('/') == std::string::npos ? 4 : 2;
  }
  if (t.head() == "+" || t.head() == "-") return 1;
  if (t.head() == "*" || t.head() == "/" || t.head() == "neg") return 2;
  return t.head() == "^" ? 3 : 4;
}

std::string held(const term& t, int least) {
  return strength(t) < least ? '(' + t.text() + ')' : t.text();
}

bool is_number(const term& t) {
  if (!t.is_leaf()) return false;
  const char first = t.head()[t.head().front() == '-' ? 1 : 0];
  return first >= '0' && first <= '9';
}

/// Reads what parsed() does, from left to right.
class reader {
 public:
  explicit reader(const std::string& text) : text_(text) {}

  term all() {
    term result = sum();
    skip_spaces();
    if (at_ != text_.size()) fail();
    return result;
  }

 private:
  term sum() {
    term result = product();
    for (;;) {
      if (takes('+')) {
        result = result + product();
      } else if (takes('-')) {
        result = result - product();
      } else {
        return result;
      }
    }
  }
  term product() {
    term result = with_sign();
    for (;;) {
      if (takes('*')) {
        result = result * with_sign();
      } else if (takes('/')) {
        result = result / with_sign();
      } else {
        return result;
      }
    }
  }
  term with_sign() {
    if (takes('-')) return -with_sign();
    return takes('+') ? with_sign() : to_a_power();
  }
  term to_a_power() {
    const term base = operand();
    if (!takes('^')) return base;
    return power(base, takes('-') ? -to_a_power() : to_a_power());
  }
  term operand() {
    skip_spaces();
    if (takes('(')) {
      term inside = sum();
      if (!takes(')')) fail();
      return inside;
    }
    const std::size_t start = at_;
    const bool is_number = at_ < text_.size() && (std::isdigit(byte()) != 0 || byte() == '.');
    while (at_ < text_.size() && (std::isalnum(byte()) != 0 || byte() == '_' || byte() == '.' ||
                                  (is_number && text_[at_ - 1] == 'e' && is_sign(byte())))) {
      ++at_;
    }
    if (at_ == start) fail();
    const std::string name = text_.substr(start, at_ - start);
    if (is_number || !takes('(')) return name;
    std::vector<term> arguments{sum()};
    while (takes(',')) arguments.push_back(sum());
    if (!takes(')')) fail();
    return {name, std::move(arguments)};
  }

  static bool is_sign(int c) { return c == '+' || c == '-'; }
  [[nodiscard]] int byte() const { return static_cast<unsigned char>(text_[at_]); }
  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool takes(char c) {
    skip_spaces();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail() const {
    throw std::invalid_argument("not a formula at " + std::to_string(at_) + ": " + text_);
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

term parsed(const std::string& text) { return reader(text).all(); }

term::term(std::string leaf) : node_(std::make_shared<const node>(node{std::move(leaf), {}})) {}
term::term(std::string head, std::vector<term> parts)
    : node_(std::make_shared<const node>(node{std::move(head), std::move(parts)})) {}

bool term::has(const std::string& name) const {
  if (is_leaf()) return head() == name;
  return std::any_of(parts().begin(), parts().end(), [&](const term& t) { return t.has(name); });
}

long term::size() const {
  if (is_leaf()) return static_cast<long>(head().size());
  long result = 1;
  for (const term& t : parts()) result += t.size();
  return result;
}

std::string term::text() const {
  if (is_leaf()) return head();
  const std::vector<term>& p = parts();
  if (head() == "+") return held(p[0], 1) + " + " + held(p[1], 1);
  if (head() == "-") return held(p[0], 1) + " - " + held(p[1], 2);
  if (head() == "*") return held(p[0], 2) + '*' + held(p[1], 2);
  if (head() == "/") return held(p[0], 2) + '/' + held(p[1], 3);
  if (head() == "^") return held(p[0], 4) + '^' + held(p[1], 4);
  if (head() == "neg") return '-' + held(p[0], 3);
  std::string result = head() + '(';
  for (std::size_t i = 0; i < p.size(); ++i) result += (i == 0 ? "" : ", ") + p[i].text();
  return result + ')';
}

term operator+(const term& a, const term& b) {
  if (a.is("0")) return b;
  if (b.is("0")) return a;
  return {"+", {a, b}};
}
term operator-(const term& a, const term& b) {
  if (b.is("0")) return a;
  if (a.is("0")) return -b;
  return {"-", {a, b}};
}
term operator*(const term& a, const term& b) {
  if (a.is("0") || b.is("0")) return 0;
  if (a.is("1")) return b;
  if (b.is("1")) return a;
  return {"*", {a, b}};
}
term operator/(const term& a, const term& b) {
  if (a.is("0")) return 0;
  if (b.is("1")) return a;
  return {"/", {a, b}};
}
term operator-(const term& a) {
  if (a.is("0")) return 0;
  if (a.is("inf")) return "-inf";
  if (a.is("-inf")) return "inf";
  return {"neg", {a}};
}
term power(const term& base, const term& exponent) {
  if (exponent.is("0")) return 1;
  if (exponent.is("1")) return base;
  return {"^", {base, exponent}};
}
term call(const std::string& function, const term& x) { return {function, {x}}; }
term call(const std::string& function, const term& x, const term& y) { return {function, {x, y}}; }

term substituted(const term& t, const std::string& name, const term& replacement) {
  if (t.is_leaf()) return t.head() == name ? replacement : t;
  std::vector<term> parts;
  for (const term& p : t.parts()) parts.push_back(substituted(p, name, replacement));
  return {t.head(), std::move(parts)};
}

term derivative(const term& t, const std::string& x) {
  if (!t.has(x)) return 0;
  if (t.is_leaf()) return 1;
  const std::vector<term>& p = t.parts();
  const std::string& f = t.head();
  const term u = p[0];
  const term du = derivative(u, x);
  if (f == "+") return du + derivative(p[1], x);
  if (f == "-") return du - derivative(p[1], x);
  if (f == "neg") return -du;
  if (f == "*") return du * p[1] + u * derivative(p[1], x);
  if (f == "/") {
    if (!p[1].has(x)) return du / p[1];
    return (du * p[1] - u * derivative(p[1], x)) / power(p[1], 2);
  }
  if (f == "^") {
    if (p[1].has(x)) return t * (derivative(p[1], x) * call("log", u) + p[1] * du / u);
    return p[1] * power(u, p[1] - 1) * du;
  }
  static const std::map<std::string, std::function<term(const term&)>> slopes{
      {"exp", [](const term& v) { return call("exp", v); }},
      {"expm1", [](const term& v) { return call("exp", v); }},
      {"log", [](const term& v) { return 1 / v; }},
      {"log1p", [](const term& v) { return 1 / (1 + v); }},
      {"sqrt", [](const term& v) { return 1 / (2 * call("sqrt", v)); }},
      {"cbrt", [](const term& v) { return 1 / (3 * power(call("cbrt", v), 2)); }},
      {"sin", [](const term& v) { return call("cos", v); }},
      {"cos", [](const term& v) { return -call("sin", v); }},
      {"tan", [](const term& v) { return 1 / power(call("cos", v), 2); }},
      {"sinh", [](const term& v) { return call("cosh", v); }},
      {"cosh", [](const term& v) { return call("sinh", v); }},
      {"tanh", [](const term& v) { return 1 / power(call("cosh", v), 2); }},
      {"asin", [](const term& v) { return 1 / call("sqrt", 1 - power(v, 2)); }},
      {"acos", [](const term& v) { return -(1 / call("sqrt", 1 - power(v, 2))); }},
      {"atan", [](const term& v) { return 1 / (1 + power(v, 2)); }},
      {"asinh", [](const term& v) { return 1 / call("sqrt", 1 + power(v, 2)); }},
      {"acosh", [](const term& v) { return 1 / call("sqrt", power(v, 2) - 1); }},
      {"atanh", [](const term& v) { return 1 / (1 - power(v, 2)); }},
      {"erf", [](const term& v) { return 2 / call("sqrt", "pi") * call("exp", -power(v, 2)); }},
      {"erfc", [](const term& v) { return -2 / call("sqrt", "pi") * call("exp", -power(v, 2)); }},
      {"sinpi", [](const term& v) { return term("pi") * call("cospi", v); }},
      {"cospi", [](const term& v) { return -(term("pi") * call("sinpi", v)); }}};
  const auto slope = slopes.find(f);
  if (slope == slopes.end() || p.size() != 1) throw std::invalid_argument("no derivative of " + f);
  return slope->second(u) * du;
}

std::vector<term> smaller(const term& t) {
  std::vector<term> result;
  if (t.is_leaf()) {
    if (!is_number(t)) return result;
    std::vector<std::string> shorter{"0", "1", "2"};
    const std::string& text = t.head();
    for (const char mark : {'/', 'e', '.'}) {
      const auto at = text.find(mark);
      if (at != std::string::npos && at > 0) shorter.push_back(text.substr(0, at));
    }
    if (text.find_first_not_of("0123456789") == std::string::npos && text.size() > 1) {
      shorter.push_back(text.substr(0, 1) + std::string(text.size() - 1, '0'));
      shorter.push_back(text.substr(0, text.size() - 1));
    }
    for (const std::string& s : shorter) {
      if (s != text && s.size() <= text.size()) result.emplace_back(s);
    }
    return result;
  }
  for (const term& p : t.parts()) result.push_back(p);
  for (std::size_t i = 0; i < t.parts().size(); ++i) {
    for (const term& less : smaller(t.parts()[i])) {
      std::vector<term> parts = t.parts();
      parts[i] = less;
      result.emplace_back(t.head(), std::move(parts));
    }
  }
  return result;
}

expression read(const term& t, const std::vector<std::string>& variables) {
  expression_names names;
  names.variables = variables;
  names.further = library_functions();
  return expression(t.text(), names);
}

double approximately(const term& t) {
  if (t.is("inf")) return std::numeric_limits<double>::infinity();
  if (t.is("-inf")) return -std::numeric_limits<double>::infinity();
  try {
    const ball x = read(t).value(64);
    detail::mpfr_cell middle(64);
    x.midpoint(middle.get());
    return mpfr_get_d(middle.get(), MPFR_RNDN);
  } catch (const input_error&) {
    return std::nan("");
  }
}

}  // namespace polhode::differential
