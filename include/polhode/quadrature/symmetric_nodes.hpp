#pragma once

#include <vector>

#include "polhode/arithmetic/ball.hpp"

namespace polhode {

/// The n nodes and weights of a rule on [-1, 1] that is symmetric about 0: the nodes >= 0,
/// increasing, and the weights that belong to them. The others are their negatives, with the same
/// weights. Where n is odd, nodes[0] is 0, exactly, and counts once. Each ball holds the true node
/// or weight and has `bits` bits.
struct symmetric_nodes {
  long n = 0;
  precision bits = 0;
  std::vector<ball> nodes;
  std::vector<ball> weights;
};

}  // namespace polhode
