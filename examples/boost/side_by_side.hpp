#pragma once

// What the ports print: Boost's answer and Polhode's, one below the other, with the error that each
// says, the error that there is, and the time.

#include <chrono>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>

#include <polhode/real/integrate.hpp>
#include <polhode/real/roots.hpp>

namespace ports {

/// A result of Boost's: its value, the error that it claims (a NaN where it claims none), and what
/// it threw instead.
template <class Real>
struct boost_answer {
  Real value = std::numeric_limits<Real>::quiet_NaN();
  Real claimed = std::numeric_limits<Real>::quiet_NaN();
  std::string thrown;
};

template <class Work>
double seconds_of(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Real, class Error>
void print_row(const std::string& who, const Real& value, const std::string& says,
               const Error& error, double seconds) {
  std::cout << std::left << std::setw(9) << who << std::setprecision(20) << std::setw(28) << value
            << std::setprecision(2) << std::setw(22) << says << "off by " << std::setw(10) << error
            << std::fixed << std::setprecision(0) << std::right << std::setw(9) << seconds * 1e6
            << " us\n"
            << std::defaultfloat;
}

template <class Real>
std::string in_words(const char* before, const Real& x) {
  std::ostringstream out;
  out << before << std::setprecision(2) << x;
  return out.str();
}

/// How far the value is from the integral, at least: the distance from an enclosure of it.
template <class Real>
double distance(const Real& value, const polhode::ball& truth) {
  const polhode::ball off = polhode::ball_of(value) - truth;
  return polhode::upper_as<double>(polhode::abs(off));
}

/// Runs both and prints them. `by_boost` returns a boost_answer; f is the integrand for Polhode.
/// Returns 0 where Polhode's integral is proved.
template <class Real, class ByBoost, class F>
int integral(const char* title, const ByBoost& by_boost, const F& f,
             const polhode::range_limit<Real>& a, const polhode::range_limit<Real>& b) {
  std::cout << title << '\n';
  boost_answer<Real> boost;
  const double boost_seconds = seconds_of([&] {
    try {
      boost = by_boost();
    } catch (const std::exception& error) {
      boost.thrown = "threw an exception";
    }
  });
  polhode::rounded_integral<Real> ours;
  const double seconds = seconds_of([&] { ours = polhode::integrate<Real>(f, a, b); });
  const polhode::ball truth =
      polhode::integrate<polhode::ball>(f, a.point(), b.point(), {.digits = 60}).enclosure;
  print_row("Boost", boost.value,
            boost.thrown.empty() ? in_words("claims ", boost.claimed) : boost.thrown,
            distance(boost.value, truth), boost_seconds);
  print_row("Polhode", ours.value, in_words("proves ", ours.truncation_error),
            distance(ours.value, truth), seconds);
  return ours.verdict == polhode::truncation_verdict::proved ? 0 : 1;
}

/// The same of a root in [a, b].
template <class Real, class ByBoost, class F>
int root(const char* title, const ByBoost& by_boost, const F& f,
         const polhode::range_limit<Real>& a, const polhode::range_limit<Real>& b) {
  std::cout << title << '\n';
  boost_answer<Real> boost;
  const double boost_seconds = seconds_of([&] { boost = by_boost(); });
  polhode::certified_root<Real> ours;
  const double seconds = seconds_of([&] { ours = polhode::find_root<Real>(f, a, b); });
  const polhode::ball truth =
      polhode::find_root<polhode::ball>(f, a.point(), b.point(), {.digits = 60}).value;
  print_row("Boost", boost.value, "claims nothing", distance(boost.value, truth), boost_seconds);
  print_row("Polhode", ours.value, in_words("bracket of ", Real(ours.upper - ours.lower)),
            distance(ours.value, truth), seconds);
  return ours.verdict == polhode::root_verdict::unique && ours.reached ? 0 : 1;
}

}  // namespace ports
