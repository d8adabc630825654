// SPDX-License-Identifier: Apache-2.0
// Polygonal columns in the plane across an axis: the cells of a jittered hexagonal lattice.
#pragma once

#include <vug/field/point.h>

#include <cstdint>

namespace vug::field {

/// The column at a place: the vectors from the two nearest centres, and random numbers of the
/// nearest. The unit is the mean distance between centres.
template <class S>
struct PlanColumn {
  S x, y, other_x, other_y;
  S first_random, second_random;

  /// 0 on the joint between the two; it grows by up to 2 per unit.
  S inside() const { return length(other_x, other_y) - length(x, y); }
};

PlanColumn<double> plan_column(double x, double y, uint32_t seed);
PlanColumn<Pack> plan_column(const Pack& x, const Pack& y, uint32_t seed);
template <class S>
PlanColumn<Dual<S>> plan_column(const Dual<S>& x, const Dual<S>& y, uint32_t seed) {
  const PlanColumn<S> c = plan_column(x.v, y.v, seed);
  auto moving = [](const S& v, const Dual<S>& p) { return Dual<S>(v, p.dx, p.dy, p.dz); };
  const S zero(0.0);
  return {moving(c.x, x),
          moving(c.y, y),
          moving(c.other_x, x),
          moving(c.other_y, y),
          {c.first_random, zero, zero, zero},
          {c.second_random, zero, zero, zero}};
}

}  // namespace vug::field
