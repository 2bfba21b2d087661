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

letter_ranges::letter_ranges(std::string_view text) {
  while (true) {
    const auto end = std::min(text.find(", "), text.size());
    const std::string_view one = text.substr(0, end);
    // "q = 1-b > 0": the letter, what it stands for, the relation.
    const auto relation = one.find(" >");
    if (relation == std::string_view::npos || one.front() < 'a' || one.front() > 'z') {
      throw std::invalid_argument("no ranges of letters");
    }
    const std::string_view sign = one.substr(relation);
    if (sign != " > 0" && sign != " >= 0") throw std::invalid_argument("no ranges of letters");
    const bool defined = one.substr(1).starts_with(" = ");
    const std::string_view quantity =
        defined ? one.substr(4, relation - 4) : one.substr(0, relation);
    ranges_.push_back({one.front(), defined, polynomial::read(quantity), sign == " > 0"});
    if (end == text.size()) return;
    text.remove_prefix(end + 2);
  }
}

polynomial letter_ranges::put_into(polynomial p) const {
  for (const range& r : ranges_) {
    if (r.defined) p = p.with(r.letter, r.quantity);
  }
  return p;
}

/// The claims speak of bodies, a > 0 and 0 < b < 1, physical ones with ab + 2b <= 1; of moments 0 <
/// z < y < x; and, apart from these, of x = cos^2, 0 < x < 1 but for the ends of ranges of
/// integration, where it may be 0 or 1; of 0 < u <= 1, of k = cos^2 and of c < a. At a = b = u =
/// 1/4, c = 1/8, k = 1/2, x = 3/4, y = 1/2, z = 1/4 all of it is so.
bool letter_ranges::is_hypothesis(const range& r) {
  for (const char* positive : {"a", "b", "u", "x", "z", "1-b", "1-x", "x-y", "y-z", "a-c"}) {
    if (polynomial::read(positive) == r.quantity) return true;
  }
  for (const char* not_negative : {"k", "1-u", "1-a*b-2*b"}) {
    if (polynomial::read(not_negative) == r.quantity) return !r.strict;
  }
  return false;
}

bool letter_ranges::are_hypotheses() const {
  const polynomial zero;
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    if (!is_hypothesis(ranges_[i])) return false;
    for (std::size_t j = 0; j < ranges_.size(); ++j) {
      if (i != j && ranges_[i].letter == ranges_[j].letter) return false;
      // What letters stand for is said in letters that stand for themselves.
      if (ranges_[i].defined && ranges_[j].defined &&
          !(ranges_[i].quantity.derivative(ranges_[j].letter) == zero)) {
        return false;
      }
    }
  }
  return true;
}

bool letter_ranges::show_sign(const polynomial& p, bool strict) const {
  if (!are_hypotheses()) return false;
  bool some_positive = false;
  for (const auto& [e, n] : p.terms()) {
    if (n < 0) return false;
    bool term_is_positive = true;
    for (std::size_t i = 0; i < e.size(); ++i) {
      if (e[i] == 0) continue;
      const auto it = std::find_if(ranges_.begin(), ranges_.end(), [&](const range& r) {
        return r.letter == static_cast<char>('a' + i);
      });
      if (it == ranges_.end()) return false;
      if (!it->strict) term_is_positive = false;
    }
    if (term_is_positive) some_positive = true;
  }
  return some_positive || !strict;
}

}  // namespace polhode::checker
