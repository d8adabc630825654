// SPDX-License-Identifier: Apache-2.0
#include <vug/field/lattice_hash.h>
#include <vug/field/speleogens/scallop_pits.h>

namespace vug::field {
namespace {

// Columns of cells along the flow, each shifted by a random phase. With these widths and jitters
// the Sauter mean of the lengths on planes along the flow is 1. A hollow reaches 1.71 downstream of
// its deepest point, 0.80 upstream and 0.91 across before it is shallower than -kScallopRim; the
// cells that are not visited are farther.
constexpr double kScallopAcross = 0.7;
constexpr double kScallopJitter = 0.2;
constexpr double kLogLongestScallop = 0.33647223662121293;  // ln kLongestScallop

constexpr double kScallopColumns[9][2] = {{0, 0},   {-1, 0}, {1, 0},  {0, -1}, {0, 1},
                                          {-1, -1}, {-1, 1}, {1, -1}, {1, 1}};
constexpr double kScallopCells[4] = {0, -1, 1, -2};

/// The square of the distance to the cells one step along an axis; `x` is the position in the cell.
template <class S>
S scallop_gap(const S& x, double step) {
  return step == 0 ? S(0.0) : square((step > 0 ? S(1.0) - x : x) + S(0.5 - kScallopJitter));
}

template <class S>
ScallopPit<S> find_scallop(const Point<S>& p, uint32_t seed) {
  const S y = p.y * S(1 / kScallopAcross), z = p.z * S(1 / kScallopAcross);
  const S row = floor(y), layer = floor(z);
  ScallopPit<S> best{{S(0.0), S(1e3), S(0.0)}, S(1.0)};
  S most(-kScallopRim);
  for (const auto& column : kScallopColumns) {
    const S apart = (scallop_gap(y - row, column[0]) + scallop_gap(z - layer, column[1])) *
                    S(kScallopAcross * kScallopAcross);
    const S highest = S(kScallopDepth * kLongestScallop) - apart * S(0.5 / kLongestScallop);
    if (!any_lane(highest > most)) continue;
    const S j = row + S(column[0]), k = layer + S(column[1]);
    const S along = p.x + CellRandom<S>(S(0.0), j, k, seed ^ 0x3c6ef372u).next();
    const S first = floor(along);
    for (const double step : kScallopCells) {
      const S i = first + S(step);
      CellRandom<S> random(i, j, k, seed);
      ScallopPit<S> pit;
      pit.length = exp((random.next() * S(2.0) - S(1.0)) * S(kLogLongestScallop));
      pit.offset.y = p.y - (j + random.position(kScallopJitter)) * S(kScallopAcross);
      pit.offset.z = p.z - (k + random.position(kScallopJitter)) * S(kScallopAcross);
      const S across = square(pit.offset.y) + square(pit.offset.z);
      const S top = pit.length * S(kScallopDepth) - across / (pit.length * S(2.0));
      if (!any_lane(top > most)) continue;
      pit.offset.x = along - (i + random.position(kScallopJitter));
      const S depth = pit.depth();
      const auto wins = depth > most;
      most = select(wins, depth, most);
      best.offset = {select(wins, pit.offset.x, best.offset.x),
                     select(wins, pit.offset.y, best.offset.y),
                     select(wins, pit.offset.z, best.offset.z)};
      best.length = select(wins, pit.length, best.length);
    }
  }
  return best;
}

}  // namespace

ScallopPit<double> deepest_scallop(const Point<double>& p, uint32_t seed) {
  return find_scallop(p, seed);
}
ScallopPit<Pack> deepest_scallop(const Point<Pack>& p, uint32_t seed) {
  return find_scallop(p, seed);
}

}  // namespace vug::field
