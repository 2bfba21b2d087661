#include "proofs/exact_polynomial.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace polhode::proofs {
namespace {

std::size_t index_of(char name) {
  if (name < 'a' || name > 'z') {
    throw std::invalid_argument(std::string("polynomial: no variable '") + name + "'");
  }
  return static_cast<std::size_t>(name - 'a');
}

exact_polynomial power(const exact_polynomial& x, int n) {
  exact_polynomial result(rational(1));
  for (int i = 0; i < n; ++i) result = result * x;
  return result;
}

/// sum = product (('+' | '-') product)*, product = factor ('*' factor)*, factor = ['-'] atom ['^'
/// whole number].
class reader {
 public:
  explicit reader(std::string_view text) : text_(text) {}

  exact_polynomial all() {
    exact_polynomial result = sum();
    if (next() != '\0') refuse();
    return result;
  }

 private:
  [[noreturn]] void refuse() const {
    throw std::invalid_argument("not a polynomial: \"" + std::string(text_) + "\" at position " +
                                std::to_string(at_));
  }
  /// The next character that is not a space, or 0 at the end.
  char next() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(char wanted) {
    if (next() != wanted) return false;
    ++at_;
    return true;
  }
  bool digit_follows() {
    const char c = next();
    return c >= '0' && c <= '9';
  }
  std::string digits() {
    if (!digit_follows()) refuse();
    std::string result;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') result += text_[at_++];
    return result;
  }
  exact_polynomial sum() {
    exact_polynomial result = product();
    while (true) {
      if (accept('+')) {
        result = result + product();
      } else if (accept('-')) {
        result = result - product();
      } else {
        return result;
      }
    }
  }
  exact_polynomial product() {
    exact_polynomial result = factor();
    while (accept('*')) result = result * factor();
    return result;
  }
  exact_polynomial factor() {
    if (accept('-')) return exact_polynomial() - factor();
    exact_polynomial base = atom();
    if (!accept('^')) return base;
    const std::string exponent = digits();
    if (exponent.size() > 2) refuse();
    return power(base, std::stoi(exponent));
  }
  exact_polynomial atom() {
    if (accept('(')) {
      exact_polynomial inside = sum();
      if (!accept(')')) refuse();
      return inside;
    }
    if (digit_follows()) return exact_polynomial(parse_rational(digits()));
    const char c = next();
    if (c < 'a' || c > 'z') refuse();
    ++at_;
    return exact_polynomial::variable(c);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// "q = 1-b > 0" or "a > 0": a letter, what it stands for, and the sign of that.
struct letter_range {
  char letter = 'a';
  bool defined = false;
  exact_polynomial quantity;
  bool strict = false;
};

[[noreturn]] void refuse_range(std::string_view text) {
  throw std::invalid_argument("not the range of a letter: \"" + std::string(text) +
                              R"("; it must be such as "b > 0" or "y = 1-x >= 0")");
}

letter_range range_in(std::string_view text) {
  const auto sign = text.find('>');
  const auto name = text.find_first_not_of(' ');
  if (sign == std::string_view::npos || name >= sign) refuse_range(text);
  letter_range result;
  std::string_view zero = text.substr(sign + 1);
  result.strict = !zero.starts_with('=');
  if (!result.strict) zero.remove_prefix(1);
  if (exact_polynomial::parse(zero) != exact_polynomial()) refuse_range(text);
  result.letter = text[name];
  const std::string_view before = text.substr(name + 1, sign - name - 1);
  const auto equals = before.find_first_not_of(' ');
  result.quantity = exact_polynomial::variable(result.letter);
  if (equals == std::string_view::npos) return result;
  if (before[equals] != '=') refuse_range(text);
  result.defined = true;
  result.quantity = exact_polynomial::parse(before.substr(equals + 1));
  return result;
}

std::vector<letter_range> ranges_in(std::string_view letters) {
  std::vector<letter_range> result;
  while (true) {
    const auto comma = letters.find(',');
    result.push_back(range_in(letters.substr(0, comma)));
    if (comma == std::string_view::npos) return result;
    letters.remove_prefix(comma + 1);
  }
}

bool is_hypothesis(const letter_range& range) {
  return std::any_of(hypotheses().begin(), hypotheses().end(), [&](const hypothesis& h) {
    return (h.strict || !range.strict) && exact_polynomial::parse(h.quantity) == range.quantity;
  });
}

/// Whether the ranges are hypotheses, each of another letter, and each letter is defined by letters
/// that stand for themselves.
bool are_usable(const std::vector<letter_range>& ranges) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!is_hypothesis(ranges[i])) return false;
    for (std::size_t j = 0; j < ranges.size(); ++j) {
      if (i != j && ranges[i].letter == ranges[j].letter) return false;
      if (ranges[i].defined && ranges[j].defined &&
          ranges[i].quantity.derivative(ranges[j].letter) != exact_polynomial()) {
        return false;
      }
    }
  }
  return true;
}

/// Whether p >= 0, and > 0 where `strict`, by the signs of its coefficients and of its letters.
bool sign_is_seen(const exact_polynomial& p, const std::vector<letter_range>& ranges, bool strict) {
  bool some_positive = false;
  for (const auto& [exponents, coefficient] : p.terms()) {
    if (coefficient < 0) return false;
    bool is_positive = true;
    for (std::size_t i = 0; i < exponents.size(); ++i) {
      if (exponents[i] == 0) continue;
      const auto range = std::find_if(ranges.begin(), ranges.end(), [i](const letter_range& r) {
        return index_of(r.letter) == i;
      });
      if (range == ranges.end()) return false;
      is_positive = is_positive && range->strict;
    }
    some_positive = some_positive || is_positive;
  }
  return some_positive || !strict;
}

}  // namespace

// ---------------------------------------------------------------------------------------------
// Arithmetic

exact_polynomial::exact_polynomial(const rational& q) { add({}, q); }

exact_polynomial exact_polynomial::variable(char name) {
  exact_polynomial result;
  exponents e{};
  e[index_of(name)] = 1;
  result.add(e, 1);
  return result;
}

exact_polynomial exact_polynomial::parse(std::string_view text) { return reader(text).all(); }

void exact_polynomial::add(const exponents& e, const rational& coefficient) {
  if (coefficient == 0) return;
  const auto [place, is_new] = terms_.try_emplace(e, coefficient);
  if (is_new) return;
  place->second += coefficient;
  if (place->second == 0) terms_.erase(place);
}

exact_polynomial operator+(const exact_polynomial& x, const exact_polynomial& y) {
  exact_polynomial result = x;
  for (const auto& [e, coefficient] : y.terms_) result.add(e, coefficient);
  return result;
}

exact_polynomial operator-(const exact_polynomial& x, const exact_polynomial& y) {
  exact_polynomial result = x;
  for (const auto& [e, coefficient] : y.terms_) result.add(e, -coefficient);
  return result;
}

exact_polynomial operator*(const exact_polynomial& x, const exact_polynomial& y) {
  exact_polynomial result;
  for (const auto& [e, p] : x.terms_) {
    for (const auto& [f, q] : y.terms_) {
      exact_polynomial::exponents sum{};
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = e[i] + f[i];
      result.add(sum, p * q);
    }
  }
  return result;
}

exact_polynomial exact_polynomial::derivative(char name) const {
  const std::size_t i = index_of(name);
  exact_polynomial result;
  for (const auto& [e, coefficient] : terms_) {
    if (e[i] == 0) continue;
    exponents lower = e;
    --lower[i];
    result.add(lower, coefficient * e[i]);
  }
  return result;
}

exact_polynomial exact_polynomial::with(char name, const exact_polynomial& replacement) const {
  const std::size_t i = index_of(name);
  exact_polynomial result;
  for (const auto& [e, coefficient] : terms_) {
    exact_polynomial rest;
    exponents without = e;
    without[i] = 0;
    rest.add(without, coefficient);
    result = result + rest * power(replacement, e[i]);
  }
  return result;
}

// ---------------------------------------------------------------------------------------------
// Steps of proofs

const std::vector<hypothesis>& hypotheses() {
  static const std::vector<hypothesis> all{
      {"a", true, "a body: a > 0"},
      {"b", true, "a body: b > 0"},
      {"1-b", true, "a body: b < 1"},
      {"1-a*b-2*b", false, "a physical body: ab + 2b <= 1"},
      {"z", true, "moments of inertia: I_z > 0"},
      {"y-z", true, "moments of inertia: I_z < I_y"},
      {"x-y", true, "moments of inertia: I_y < I_x"},
      {"x", true, "x = I_x > 0, or x = cos^2 psi > 0: all but the ends of the range of psi"},
      {"1-x", true, "x = cos^2 psi < 1: all but psi = 0"},
      {"u", true, "0 < u"},
      {"1-u", false, "u <= 1"},
      {"k", false, "k = cos^2(t/2)"},
      {"a-c", true, "motion that is no equilibrium: c < a"}};
  return all;
}

bool holds(const polynomial_step& step) {
  const exact_polynomial p = exact_polynomial::parse(step.left);
  const exact_polynomial r = exact_polynomial::parse(step.right);
  if (step.form == step_form::identity) return r == p;
  if (step.form == step_form::slope) {
    const exact_polynomial q = exact_polynomial::parse(step.over);
    const char x = step.variable.at(0);
    return p.derivative(x) * q - p * q.derivative(x) == r;
  }
  const std::vector<letter_range> ranges = ranges_in(step.letters);
  if (!are_usable(ranges) || !sign_is_seen(r, ranges, step.form == step_form::positive)) {
    return false;
  }
  exact_polynomial meant = r;
  for (const letter_range& range : ranges) {
    if (range.defined) meant = meant.with(range.letter, range.quantity);
  }
  return meant == p;
}

bool add_steps(certificate& c, const std::vector<polynomial_step>& steps) {
  bool all_hold = true;
  for (const polynomial_step& step : steps) {
    const bool it_holds = holds(step);
    all_hold = all_hold && it_holds;
    c.facts.push_back({sentence_of(step), it_holds, step_kind::exact});
    json one{{"kind", form_in_words(step)}, {"left", step.left}};
    if (step.form == step_form::slope) {
      one["over"] = step.over;
      one["variable"] = step.variable;
    }
    one["right"] = step.right;
    if (is_sign(step)) {
      one["letters"] = step.letters;
      one["conclusion"] = conclusion_of(step);
    }
    c.witness["polynomials"].push_back(std::move(one));
  }
  return all_hold;
}

}  // namespace polhode::proofs
