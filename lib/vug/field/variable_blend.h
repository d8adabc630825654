// SPDX-License-Identifier: Apache-2.0
// The smooth union of two fields with a radius that varies in space.
#pragma once

#include <vug/field/field.h>

#include <vector>

namespace vug::field {

/// One summand of the radius: the weight of a material of the first solid, and the radius in metres
/// where it meets the materials of the second one.
struct RadiusTerm {
  Field weight;
  Field radius;
};
/// The sum of weight * radius, within `range`; the weights sum to 1. Without terms it is range.lo.
struct VariableRadius {
  std::vector<RadiusTerm> terms;
  Interval range;
};

/// min(a, b) - k h^2 / 4 with h = max(0, 1 - |a - b| / k) (quilez2013smin). Materials mix by the
/// same h. The stated Lipschitz constant is that of the solids plus a quarter of that of the
/// radius.
Field variable_blend(const Field& a, const Field& b, VariableRadius radius);

}  // namespace vug::field
