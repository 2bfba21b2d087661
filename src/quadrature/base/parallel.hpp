#pragma once

// Sums of many terms on several threads, with the same bits whatever their number.

#include <functional>

#include "polhode/arithmetic/ball.hpp"

namespace polhode::detail {

/// Adds the terms first ... last-1 to the sum.
using add_terms = std::function<void(long first, long last, ball& sum)>;

/// The sum of `count` terms with p bits. They are added in chunks of a length that depends on the
/// count alone, and the chunks' sums in order. make() gives each thread an adder of its own, which
/// is not called from another thread; it is called on several threads at a time. threads: 0 for as
/// many as the machine has processors. Work of few bits stays on this thread. What an adder throws
/// is thrown here.
[[nodiscard]] ball sum_in_chunks(long count, precision p, int threads,
                                 const std::function<add_terms()>& make);

}  // namespace polhode::detail
