#pragma once

// The answer to a question for a number: an enclosure with its proof, or how far it got.

#include <string>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/verdict.hpp"

namespace polhode {

/// The verdict on a question and its reason. Answers of several numbers derive from it.
struct certification {
  status verdict = status::not_certified;
  reason why = reason::none;
  /// The obstacle and its place, in words; empty where it is certified or `why` says it all.
  std::string obstacle;
};

/// T: ball, or complex_ball. Answers of one kind derive from it and add what they alone have.
template <class T>
struct certified_answer : certification {
  /// Holds the number, whatever the verdict; undefined where nothing is proved.
  T enclosure = T::undefined(64);
};

}  // namespace polhode
