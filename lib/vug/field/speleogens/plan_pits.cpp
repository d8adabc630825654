// SPDX-License-Identifier: Apache-2.0
#include <vug/field/lattice_hash.h>
#include <vug/field/speleogens/plan_pits.h>

namespace vug::field {
namespace {

// With these cells, few places are in no hollow. A hollow of the largest size reaches 0.9 from its
// centre before its depth is -1; the cells that are not visited are farther.
constexpr double kPlanPitPitch = 0.72;
constexpr double kPlanPitJitter = 0.24;
constexpr double kLogLargestPlanPit = 0.30010459245033805;  // ln kLargestPlanPit

template <class S>
PlanPit<S> find_plan_pit(const S& x, const S& y, uint32_t seed) {
  const S column = floor(x * S(1 / kPlanPitPitch)), row = floor(y * S(1 / kPlanPitPitch));
  PlanPit<S> best{S(1e3), S(0.0), S(1.0)};
  S most(-1.0);
  for (const double i : {0, -1, 1})
    for (const double j : {0, -1, 1}) {
      const S cell_x = column + S(i), cell_y = row + S(j);
      CellRandom<S> random(cell_x, cell_y, S(0.0), seed);
      PlanPit<S> pit;
      pit.x = x - (cell_x + random.position(kPlanPitJitter)) * S(kPlanPitPitch);
      pit.y = y - (cell_y + random.position(kPlanPitJitter)) * S(kPlanPitPitch);
      pit.size = exp((random.next() * S(2.0) - S(1.0)) * S(kLogLargestPlanPit));
      const S depth = pit.depth();
      const auto wins = depth > most;
      most = select(wins, depth, most);
      best = {select(wins, pit.x, best.x), select(wins, pit.y, best.y),
              select(wins, pit.size, best.size)};
    }
  return best;
}

}  // namespace

PlanPit<double> deepest_plan_pit(double x, double y, uint32_t seed) {
  return find_plan_pit(x, y, seed);
}
PlanPit<Pack> deepest_plan_pit(const Pack& x, const Pack& y, uint32_t seed) {
  return find_plan_pit(x, y, seed);
}

}  // namespace vug::field
