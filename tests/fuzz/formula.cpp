// libFuzzer's target for the checker's formulas: whatever the bytes, it reads a formula in x, or
// says what is wrong; and evaluates it over sets, or leaves it undecided.

#include <cstddef>
#include <cstdint>
#include <string>

#include "checker/formula.hpp"
#include "processor_time.hpp"

namespace {

using polhode::checker::interval;
using polhode::checker::rational;

template <class T>
void evaluate(const polhode::checker::formula& f, const T& x) {
  try {
    static_cast<void>(f(x));
  } catch (const polhode::checker::undecided&) {  // no answer
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const polhode::fuzz::processor_time_limit limit;
  const polhode::checker::json text = std::string(reinterpret_cast<const char*>(data), size);
  polhode::checker::limits most;
  most.work = 300'000'000;
  polhode::checker::budget work(most);
  try {
    const polhode::checker::place where(text, "/formula", work);
    const auto f = polhode::checker::formula::read(where, {"x"});
    const polhode::checker::precision bits(64, work);
    const interval x = interval::between(rational(1, 3), rational(1, 2), bits);
    evaluate(f, x);
    evaluate(f, polhode::checker::jet{x, interval(rational(1), bits)});
    evaluate(f, polhode::checker::rectangle{x, x});
  } catch (const polhode::checker::refusal&) {  // it says what is wrong
  }
  return 0;
}
