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

/// sum = product (('+' | '-') product)*, product = factor ('*' factor)*, factor = ['-'] atom ['^' whole number].
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

/// "q = 1-b, y = 1-x" put into p, one after another.
exact_polynomial with_letters(exact_polynomial p, std::string_view letters) {
  while (!letters.empty()) {
    const auto comma = letters.find(',');
    const std::string_view one = letters.substr(0, comma);
    letters = comma == std::string_view::npos ? std::string_view() : letters.substr(comma + 1);
    const auto name = one.find_first_not_of(' ');
    const auto equals = one.find('=');
    if (name == std::string_view::npos || equals == std::string_view::npos) {
      throw std::invalid_argument("not a definition of a letter: \"" + std::string(one) + '"');
    }
    p = p.with(one[name], exact_polynomial::parse(one.substr(equals + 1)));
  }
  return p;
}

std::string in_words(polynomial_step::kind what) {
  switch (what) {
    case polynomial_step::kind::identity:
      return "identity";
    case polynomial_step::kind::positive:
      return "positive coefficients";
    case polynomial_step::kind::slope:
      break;
  }
  return "derivative of a quotient";
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

bool exact_polynomial::has_positive_coefficients() const {
  return !terms_.empty() && std::all_of(terms_.begin(), terms_.end(),
                                        [](const auto& term) { return term.second > 0; });
}

// ---------------------------------------------------------------------------------------------
// Steps of proofs

polynomial_step identity(std::string left, std::string right, std::string meaning) {
  return {polynomial_step::kind::identity,
          std::move(left),
          "",
          std::move(right),
          "",
          'x',
          std::move(meaning)};
}

polynomial_step positive(std::string left, std::string right, std::string letters,
                         std::string meaning) {
  return {polynomial_step::kind::positive,
          std::move(left),
          "",
          std::move(right),
          std::move(letters),
          'x',
          std::move(meaning)};
}

polynomial_step slope(char variable, std::string numerator, std::string denominator,
                      std::string result, std::string meaning) {
  return {polynomial_step::kind::slope,
          std::move(numerator),
          std::move(denominator),
          std::move(result),
          "",
          variable,
          std::move(meaning)};
}

bool polynomial_step::holds() const {
  const exact_polynomial p = exact_polynomial::parse(left);
  const exact_polynomial r = exact_polynomial::parse(right);
  if (what == kind::slope) {
    const exact_polynomial q = exact_polynomial::parse(over);
    return p.derivative(variable) * q - p * q.derivative(variable) == r;
  }
  if (what == kind::positive && !r.has_positive_coefficients()) return false;
  return with_letters(r, letters) == p;
}

std::string polynomial_step::statement() const {
  if (what == kind::slope) {
    return std::string("d/d") + variable + " of (" + left + ")/(" + over + ") = (" + right + ")/(" +
           over + ")^2, expanded over Q: " + meaning;
  }
  std::string result = left + " = " + right;
  if (!letters.empty()) result += " with " + letters;
  result += ", expanded over Q";
  if (what == kind::positive) result += ", and no coefficient of the right side is negative";
  return result + ": " + meaning;
}

bool add_steps(certificate& c, const std::vector<polynomial_step>& steps) {
  bool all_hold = true;
  for (const polynomial_step& step : steps) {
    const bool holds = step.holds();
    all_hold = all_hold && holds;
    c.facts.push_back({step.statement(), holds});
    json one{{"kind", in_words(step.what)}, {"left", step.left}};
    if (step.what == polynomial_step::kind::slope) {
      one["over"] = step.over;
      one["variable"] = std::string(1, step.variable);
    }
    one["right"] = step.right;
    if (!step.letters.empty()) one["letters"] = step.letters;
    c.witness["polynomials"].push_back(std::move(one));
  }
  return all_hold;
}

}  // namespace polhode::proofs
