// SPDX-License-Identifier: Apache-2.0
#include <vug/field/node.h>

#include <cmath>
#include <typeinfo>

namespace vug::field {

Box3d Traits::bounds_below(double level) const {
  if (level <= 0) return bounds;
  const double slope = growth_rate();
  return slope > 0 ? grown(bounds, level / slope) : infinite_box();
}

Traits Traits::translated(const Vec3d& by) const {
  Traits out = *this;
  if (!bounds.isEmpty()) out.bounds = {bounds.min + by, bounds.max + by};
  return out;
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

Digest Node::digest() const {
  if (digest_known_.load(std::memory_order_acquire)) return {digest_high_, digest_low_};
  Digester digester;
  digester(std::string_view(typeid(*this).name()));
  add_to(digester);
  const Digest out = digester.finish();
  digest_high_.store(out.high, std::memory_order_relaxed);
  digest_low_.store(out.low, std::memory_order_relaxed);
  digest_known_.store(true, std::memory_order_release);
  return out;
}

}  // namespace vug::field
