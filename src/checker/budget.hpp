#pragma once

// What a check may cost. Everything that takes time or memory by what a certificate says is charged
// here before it is done, by the sizes of its operands: never by a clock, so that the same
// certificate costs the same everywhere.

#include <concepts>
#include <stdexcept>
#include <string>
#include <utility>

#include "polhode/checker/check.hpp"

namespace polhode::checker {

/// Ends the check: what is wrong, where, and what would be right.
class refusal : public std::runtime_error {
 public:
  refusal(outcome what_it_is, std::string pointer, const std::string& message)
      : std::runtime_error(message), result(what_it_is), place(std::move(pointer)) {}
  outcome result;
  std::string place;
};

/// One unit of work is about one product of two 64-bit words, half a nanosecond. Charges that pass
/// the limits throw a refusal (not checkable) at the place that is being worked on.
class budget {
 public:
  explicit budget(const limits& most) : most_(most) {}
  budget(const budget&) = delete;
  budget& operator=(const budget&) = delete;
  budget(budget&&) = delete;
  budget& operator=(budget&&) = delete;
  ~budget() = default;

  void spend(long units) {
    if (units < 0 || units > most_.work - spent_) pass_work();
    spent_ += units;
  }
  /// Operations on whole numbers of so many words.
  void product(long x_words, long y_words) { spend(of_product(x_words, y_words)); }
  void quotient(long words, long divisor_words) {
    spend(2 * of_product(words > divisor_words ? words - divisor_words + 1 : 1, divisor_words) +
          words);
  }
  void root(long words) { spend(3 * of_product(words / 2 + 1, words / 2 + 1) + 100); }
  /// Operations on rationals of so many bits, numerator and denominator together: a product and a
  /// common divisor each.
  void rationals(long count, long bits) {
    const long words = bits / 64 + 1;
    spend(count * (200 + 4 * of_product(words, words)));
  }
  /// To or from decimal digits.
  void decimals(long bits) {
    const long words = bits / 64 + 1;
    spend(200 + 4 * of_product(words, words));
  }

  [[nodiscard]] long spent() const { return spent_; }
  [[nodiscard]] long most_held() const { return most_held_; }

  /// Work is done at this place for as long as it lives.
  class at {
   public:
    at(budget& work, std::string pointer) : work_(work), before_(std::move(pointer)) {
      std::swap(work_.place_, before_);
    }
    ~at() { std::swap(work_.place_, before_); }
    at(const at&) = delete;
    at& operator=(const at&) = delete;
    at(at&&) = delete;
    at& operator=(at&&) = delete;

   private:
    budget& work_;
    std::string before_;
  };

  /// So many bytes are held for as long as it lives.
  class memory {
   public:
    memory(budget& work, long bytes) : work_(work), bytes_(bytes) { work_.hold(bytes); }
    ~memory() { work_.held_ -= bytes_; }
    memory(const memory&) = delete;
    memory& operator=(const memory&) = delete;
    memory(memory&&) = delete;
    memory& operator=(memory&&) = delete;

   private:
    budget& work_;
    long bytes_;
  };
  /// So many bytes are held from now on.
  void hold(long bytes);

  /// That of school up to 32 words, Karatsuba's from there on, and a little more than a transform's
  /// from 4096 words on: about GMP's.
  static long of_product(long x_words, long y_words);

 private:
  [[noreturn]] void pass_work() const;
  [[noreturn]] void pass_memory() const;

  limits most_;
  long spent_ = 0;
  long held_ = 0;
  long most_held_ = 0;
  std::string place_;
};

/// Bits behind the point of the numbers of a computation, and what their operations are charged to.
class precision {
 public:
  precision(long bits, budget& work) : bits_(bits), work_(&work) {}
  // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions): a number of bits; none becomes a precision
  operator long() const { return bits_; }
  [[nodiscard]] budget& work() const { return *work_; }
  template <std::integral T>
  friend precision operator+(const precision& p, T more) {
    return {p.bits_ + static_cast<long>(more), *p.work_};
  }

 private:
  long bits_;
  budget* work_;
};

}  // namespace polhode::checker
