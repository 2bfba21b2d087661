#pragma once

// What is proved of one box.

#include <map>
#include <memory>
#include <utility>

#include "roots/contraction.hpp"
#include "state.hpp"

namespace polhode::detail {

/// The evaluators of one thread.
struct evaluators {
  /// By the number of the problem and the precision.
  std::map<std::pair<std::size_t, precision>, std::shared_ptr<const function_evaluator>> in_balls;
  /// By the number of the problem; nullptr where there is none.
  std::map<std::size_t, std::unique_ptr<contraction>> in_hardware;
};

/// Whether the box has a root, none, or has to be cut; it depends on the box and the options alone.
[[nodiscard]] outcome examine_box(const root_search::state& s, const isolate_options& options,
                                  evaluators& known, work_box b);

/// The region that a cluster of boxes is, which are as narrow as they get.
[[nodiscard]] outcome examine_cluster(const root_search::state& s, const isolate_options& options,
                                      evaluators& known, const work_box& b);

}  // namespace polhode::detail
