// SPDX-License-Identifier: Apache-2.0
#include <vug/field/lattice_hash.h>
#include <vug/field/speleogens/plan_columns.h>

namespace vug::field {
namespace {

// Rows of cells, of which every other one is shifted by half a cell. The two nearest centres are
// less than 1.35 away, those of the rows and cells that are not visited more than 1.4.
constexpr double kColumnRow = 0.8660254037844386;
constexpr double kColumnJitter = 0.22;

template <class S>
PlanColumn<S> find_column(const S& x, const S& y, uint32_t seed) {
  const S row = floor(y * S(1 / kColumnRow)), far(1e3);
  PlanColumn<S> best{far, far, far, far, S(0.0), S(0.0)};
  S first(2e6), second(2e6);
  for (const double j : {0, -1, 1, -2, 2}) {
    const S line = row + S(j);
    const S shift = (line * S(0.5) - floor(line * S(0.5)));
    const S along = floor(x - shift);
    for (const double i : {0, -1, 1, -2, 2}) {
      const S cell = along + S(i);
      CellRandom<S> random(cell, line, S(0.0), seed);
      const S dx = x - shift - cell - random.position(kColumnJitter);
      const S dy = y - (line + random.position(kColumnJitter)) * S(kColumnRow);
      const S apart = square(dx) + square(dy);
      const auto wins = apart < first;
      const auto follows = apart < second;
      best.other_x = select(wins, best.x, select(follows, dx, best.other_x));
      best.other_y = select(wins, best.y, select(follows, dy, best.other_y));
      second = select(wins, first, select(follows, apart, second));
      best.x = select(wins, dx, best.x);
      best.y = select(wins, dy, best.y);
      first = select(wins, apart, first);
      best.first_random = select(wins, random.next(), best.first_random);
      best.second_random = select(wins, random.next(), best.second_random);
    }
  }
  return best;
}

}  // namespace

PlanColumn<double> plan_column(double x, double y, uint32_t seed) {
  return find_column(x, y, seed);
}
PlanColumn<Pack> plan_column(const Pack& x, const Pack& y, uint32_t seed) {
  return find_column(x, y, seed);
}

}  // namespace vug::field
