// Which way water goes: how what leaves a cell is shared among its lower neighbours. More than one
// gets some (Freeman 1991), so that flow follows slopes between the directions of links.
#pragma once

#include <vug/cells/pass.h>

namespace vug::cells {

struct FlowOptions {
  int gather = 2;       ///< Power of the steepness that a lower neighbour's share goes with.
  double wander = 0.3;  ///< Spacings by which cells of a wall are higher or lower by chance.
  double cling = 0;     ///< How much water follows water: dry neighbours get so much less.
};

/// Of one step. A neighbour is lower when its level is: its height above the origin and what the
/// attribute `height` (metres along N) has raised or carved; on walls, whose height that does not
/// change, half of it counts all the same, so that water stays in grooves. Water that clings
/// prefers neighbours that carry more of the attribute `water`: rivulets keep together and join.
class Flow {
 public:
  Flow(const Pass& pass, RandomKey key, const FlowOptions& options);

  /// Metres, for comparing neighbours.
  float level(uint32_t cell) const { return level_[cell]; }
  /// Whether no neighbour that can be reached is lower: water falls off or soaks in.
  bool is_sink(uint32_t cell) const { return !(total_[cell] > 0); }
  /// Metres by which the lowest neighbour stands above a cell where water ends; 0 elsewhere.
  float sink_depth(uint32_t cell) const { return sink_depth_[cell]; }
  /// The greatest drop to a neighbour, metres a metre: 0 level, 1 straight down.
  float steepness(uint32_t cell) const { return steep_[cell]; }
  /// What the neighbours above send to a cell if each gives away all of its `amount`.
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
  std::vector<float> share_;  ///< For each link, what its far end sends to its near end.
};

/// Moves from cell to cell in this step at a speed of so many metres a step; 1000 at most.
int moves_in_step(double speed, double spacing, int step);

}  // namespace vug::cells
