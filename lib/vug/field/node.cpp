// SPDX-License-Identifier: Apache-2.0
#include <vug/field/node.h>

#include <cmath>

namespace vug::field {

Box3d Traits::bounds_below(double level) const {
  if (level <= 0) return bounds;
  const double slope = growth_rate();
  return slope > 0 ? grown(bounds, level / slope) : infinite_box();
}

Interval Node::centre_form(double value, const Ball& ball) const {
  // Batches use single precision, whose rounding grows with the distance from the origin.
  const double slack = 1e-6 * (std::fabs(value) + ball.centre.length() + ball.radius);
  const double reach = traits_.lipschitz * ball.radius + slack;
  return {value - reach, value + reach};
}

Restriction Node::restrict_to(const Ball& ball) const {
  return {centre_form(eval(point(ball.centre)), ball), nullptr};
}

}  // namespace vug::field
