#pragma once

// A formula as a tree, so that tests can build one from pieces, put one into another, differentiate
// it and make it smaller. The library itself only ever gets its text.

#include <memory>
#include <string>
#include <vector>

#include "polhode/expression/expression.hpp"

namespace polhode::differential {

class term {
 public:
  /// 0.
  term() : term("0") {}
  /// A number or a name as it is written: "3", "1/7", "2.5e-3", "pi", "x".
  term(std::string leaf);  // NOLINT(google-explicit-constructor): its text
  term(const char* leaf) : term(std::string(leaf)) {}  // NOLINT(google-explicit-constructor)
  term(long n) : term(std::to_string(n)) {}            // NOLINT(google-explicit-constructor)
  term(int n) : term(std::to_string(n)) {}             // NOLINT(google-explicit-constructor)
  /// An operator (+ - * / ^ and neg) or a function of other terms.
  term(std::string head, std::vector<term> parts);

  [[nodiscard]] const std::string& head() const { return node_->head; }
  [[nodiscard]] const std::vector<term>& parts() const { return node_->parts; }
  [[nodiscard]] bool is_leaf() const { return node_->parts.empty(); }
  [[nodiscard]] bool is(const char* leaf) const { return is_leaf() && node_->head == leaf; }
  /// Whether the name occurs.
  [[nodiscard]] bool has(const std::string& name) const;
  /// How many nodes there are, and characters in the leaves.
  [[nodiscard]] long size() const;
  [[nodiscard]] std::string text() const;

 private:
  struct node {
    std::string head;
    std::vector<term> parts;
  };
  std::shared_ptr<const node> node_;
};

// With 0 and 1 left out where they do nothing.
[[nodiscard]] term operator+(const term& a, const term& b);
[[nodiscard]] term operator-(const term& a, const term& b);
[[nodiscard]] term operator*(const term& a, const term& b);
[[nodiscard]] term operator/(const term& a, const term& b);
[[nodiscard]] term operator-(const term& a);
[[nodiscard]] term power(const term& base, const term& exponent);
[[nodiscard]] term call(const std::string& function, const term& x);
[[nodiscard]] term call(const std::string& function, const term& x, const term& y);

/// The term of a formula in the grammar of docs/expressions.md, but for factorials. Throws
/// std::invalid_argument for other texts.
[[nodiscard]] term parsed(const std::string& text);

/// t with the replacement wherever the name is.
[[nodiscard]] term substituted(const term& t, const std::string& name, const term& replacement);

/// dt/dx. Throws std::invalid_argument where a function has no derivative here.
[[nodiscard]] term derivative(const term& t, const std::string& x = "x");

/// Terms that are smaller than t in one place: a part in place of the whole, a shorter number.
[[nodiscard]] std::vector<term> smaller(const term& t);

/// The formula as the program reads it, with the elliptic functions. Throws input_error as it does.
[[nodiscard]] expression read(const term& t, const std::vector<std::string>& variables = {});

/// About the value of a constant term; a NaN where it is not defined.
[[nodiscard]] double approximately(const term& t);

}  // namespace polhode::differential
