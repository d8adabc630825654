// SPDX-License-Identifier: Apache-2.0
// Flow directions of water: the distribution of a cell's outflow among its lower neighbours,
// and the cells without one (sinks).
// Several neighbours receive water (Freeman 1991), so the flow follows slopes between the
// directions of links.
#pragma once

#include <vug/cells/pass.h>

namespace vug::cells {

struct FlowOptions {
  int gather = 2;       ///< Exponent of the steepness in a lower neighbour's share.
  double wander = 0.3;  ///< Random offset of the cells on walls, in spacings.
  double cling = 0;     ///< Cohesion of water: reduces the share of dry neighbours.
};

/// The flow in one step. A neighbour is lower if its level is: its height above the origin plus the
/// attribute `height` (metres along N, raised or carved). On walls `height` does not change the
/// elevation, but half of it counts nevertheless, so that water stays in grooves. With cohesion,
/// water prefers neighbours with more of the attribute `water`: rivulets keep together and join.
class Flow {
 public:
  Flow(const Pass& pass, RandomKey key, const FlowOptions& options);

  /// Level in metres, for comparison between neighbours.
  float level(uint32_t cell) const { return level_[cell]; }
  /// Whether no reachable neighbour is lower: water falls off or soaks in.
  bool is_sink(uint32_t cell) const { return !(total_[cell] > 0); }
  /// Metres by which the lowest neighbour is above a sink; 0 for other cells.
  float sink_depth(uint32_t cell) const { return sink_depth_[cell]; }
  /// The steepest drop to a neighbour in metres per metre: 0 level, 1 vertical.
  float steepness(uint32_t cell) const { return steep_[cell]; }
  /// Total inflow from the neighbours above, if each gives away all of its `amount`.
  template <class Amount>
  float inflow(const Amount& amount, uint32_t cell) const {
    float sum = 0;
    for (uint32_t k = links_->begin[cell]; k < links_->begin[cell + 1]; ++k)
      if (share_[k] > 0) sum += share_[k] * amount(links_->to[k]);
    return sum;
  }

 private:
  const Links* links_;
  std::vector<float> level_, total_, steep_, sink_depth_;
  std::vector<float> share_;  ///< For each link, the share that its far end sends to its near end.
};

/// Number of moves from cell to cell in this step, at a speed in metres per step; at most 1000.
int moves_in_step(double speed, double spacing, int step);

}  // namespace vug::cells
