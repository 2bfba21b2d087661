#include "boost_methods.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::cost {
namespace {

/// Boost's mpfr_float takes the thread's precision for what has none of its own: so many decimal
/// digits while this lives.
class digits_of_thread {
 public:
  explicit digits_of_thread(long digits) : before_(mpfr_float::thread_default_precision()) {
    mpfr_float::thread_default_precision(static_cast<unsigned>(digits));
  }
  ~digits_of_thread() { mpfr_float::thread_default_precision(before_); }
  digits_of_thread(const digits_of_thread&) = delete;
  digits_of_thread& operator=(const digits_of_thread&) = delete;
  digits_of_thread(digits_of_thread&&) = delete;
  digits_of_thread& operator=(digits_of_thread&&) = delete;

 private:
  unsigned before_;
};

constexpr long guard_digits = 5;

/// log10 of |error/value|, nothing where it is not a number.
std::optional<double> log10_of_ratio(const mpfr_float& error, const mpfr_float& value) {
  if (value == 0 || !isfinite(error)) return std::nullopt;
  if (error == 0) return -1e9;
  return static_cast<double>(log10(abs(mpfr_float(error / value))));
}

using rule = uncertified_value (*)(const uncertified_integral& x, const mpfr_float& tolerance);

estimate integrate_by(rule by, const integral_maker& make, long digits) {
  const digits_of_thread scope(digits + guard_digits);
  uncertified_integral what = make();
  estimate result;
  what.f = [f = std::move(what.f), &result](const mpfr_float& x) {
    ++result.evaluations;
    return f(x);
  };
  const uncertified_value found = by(what, pow(mpfr_float(10), -static_cast<int>(digits)));
  result.value = ball(found.value);
  result.log10_claimed = log10_of_ratio(found.error, found.value);
  return result;
}

}  // namespace

method boost_tanh_sinh(integral_maker make) {
  return {
      "boost tanh-sinh", "Boost.Math's double exponential rule over mpfr_float", false, 3000,
      [make = std::move(make)](long digits) { return integrate_by(by_tanh_sinh, make, digits); }};
}

method boost_gauss_kronrod(integral_maker make) {
  return {"boost gauss-kronrod", "Boost.Math's adaptive 61 point rule over mpfr_float", false, 300,
          [make = std::move(make)](long digits) {
            return integrate_by(by_gauss_kronrod, make, digits);
          }};
}

method in_mpfr_float(std::string name, std::string description, long most_digits,
                     std::function<mpfr_float()> compute) {
  return {std::move(name), std::move(description), false, most_digits,
          [compute = std::move(compute)](long digits) {
            const digits_of_thread scope(digits + guard_digits);
            return estimate{ball(compute()), std::nullopt, 0};
          }};
}

method in_double(std::string description, std::function<double()> compute) {
  return {"double", std::move(description), false, 16, [compute = std::move(compute)](long) {
            return estimate{ball::exactly(compute()), std::nullopt, 0};
          }};
}

}  // namespace polhode::cost
