#include "polynomial.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace polhode::checker {
namespace {

std::size_t place_of(char letter) { return static_cast<std::size_t>(letter - 'a'); }

/// The texts are those of the checker's own table of claims, so that depth and size are bounded.
class reader {
 public:
  explicit reader(std::string_view text) : rest_(text) {}

  polynomial whole() {
    polynomial p = sum();
    if (peek() != '\0') fail();
    return p;
  }

 private:
  [[noreturn]] void fail() const {
    throw std::invalid_argument("no polynomial: \"" + std::string(rest_) + '"');
  }
  char peek() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    return rest_.empty() ? '\0' : rest_.front();
  }
  char take() {
    const char c = peek();
    rest_.remove_prefix(c == '\0' ? 0 : 1);
    return c;
  }
  polynomial sum() {
    polynomial p = product();
    for (char c = peek(); c == '+' || c == '-'; c = peek()) {
      take();
      p = c == '+' ? p + product() : p - product();
    }
    return p;
  }
  polynomial product() {
    polynomial p = power();
    while (peek() == '*') {
      take();
      p = p * power();
    }
    return p;
  }
  polynomial power() {
    if (peek() == '-') {
      take();
      return polynomial() - power();
    }
    polynomial base = single();
    if (peek() != '^') return base;
    take();
    const integer exponent = number();
    if (exponent > 99) fail();
    polynomial p(integer(1));
    for (integer i(0); i < exponent; ++i) p = p * base;
    return p;
  }
  polynomial single() {
    const char c = peek();
    if (c == '(') {
      take();
      polynomial p = sum();
      if (take() != ')') fail();
      return p;
    }
    if (c >= '0' && c <= '9') return polynomial(number());
    if (c < 'a' || c > 'z') fail();
    take();
    return polynomial::read(std::string_view(&c, 1));
  }
  integer number() {
    peek();
    const auto end = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
    integer n;
    if (!read_integer(rest_.substr(0, end), n)) fail();
    rest_.remove_prefix(end);
    return n;
  }

  std::string_view rest_;
};

}  // namespace

polynomial::polynomial(const integer& n) { add({}, n); }

polynomial polynomial::read(std::string_view text) {
  if (text.size() == 1 && text.front() >= 'a' && text.front() <= 'z') {
    polynomial p;
    exponents e{};
    e[place_of(text.front())] = 1;
    p.add(e, integer(1));
    return p;
  }
  return reader(text).whole();
}

void polynomial::add(const exponents& e, const integer& coefficient) {
  const integer sum = (terms_[e] += coefficient);
  if (sum == 0) terms_.erase(e);
}

polynomial operator+(const polynomial& x, const polynomial& y) {
  polynomial sum = x;
  for (const auto& [e, n] : y.terms_) sum.add(e, n);
  return sum;
}
polynomial operator-(const polynomial& x, const polynomial& y) {
  polynomial difference = x;
  for (const auto& [e, n] : y.terms_) difference.add(e, integer(-n));
  return difference;
}
polynomial operator*(const polynomial& x, const polynomial& y) {
  polynomial product;
  for (const auto& [e, n] : x.terms_) {
    for (const auto& [f, m] : y.terms_) {
      polynomial::exponents sum = e;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += f[i];
      product.add(sum, n * m);
    }
  }
  return product;
}

polynomial polynomial::derivative(char letter) const {
  const std::size_t i = place_of(letter);
  polynomial result;
  for (const auto& [e, n] : terms_) {
    exponents lower = e;
    --lower[i];
    if (e[i] > 0) result.add(lower, n * e[i]);
  }
  return result;
}

polynomial polynomial::with(char letter, const polynomial& other) const {
  const std::size_t i = place_of(letter);
  polynomial result;
  for (const auto& [e, n] : terms_) {
    polynomial term;
    exponents rest = e;
    rest[i] = 0;
    term.add(rest, n);
    for (int k = 0; k < e[i]; ++k) term = term * other;
    result = result + term;
  }
  return result;
}

bool polynomial::has_positive_coefficients() const {
  return !terms_.empty() &&
         std::all_of(terms_.begin(), terms_.end(), [](const auto& t) { return t.second > 0; });
}

polynomial with_letters(polynomial p, std::string_view letters) {
  while (!letters.empty()) {
    const auto end = std::min(letters.find(", "), letters.size());
    p = p.with(letters.front(), polynomial::read(letters.substr(4, end - 4)));
    letters.remove_prefix(std::min(end + 2, letters.size()));
  }
  return p;
}

}  // namespace polhode::checker
