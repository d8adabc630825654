// SPDX-License-Identifier: Apache-2.0
#include <vug/lsystem/drawing.h>

#include <algorithm>

namespace vug::lsystem {

Mat44d Instance::to_world() const {
  const Vec3d x = frame.normal * -size, y = frame.tangent * size, z = frame.binormal * size;
  return {x.x, x.y, x.z, 0, y.x,        y.y,        y.z,        0,
          z.x, z.y, z.z, 0, position.x, position.y, position.z, 1};
}

Box3d Drawing::bounds() const {
  Box3d box;
  for (const Axis& axis : axes)
    for (const Station& s : axis.stations) box = united(box, grown(Box3d(s.position), s.radius));
  for (const Polygon& polygon : polygons)
    for (const Vec3d& corner : polygon.corners) box.extendBy(corner);
  for (const Instance& instance : instances) box.extendBy(instance.position);
  return box;
}

Station station_at(const Axis& axis, double along) {
  const std::vector<Station>& all = axis.stations;
  const auto next = std::upper_bound(all.begin() + 1, all.end() - 1, along,
                                     [](double s, const Station& each) { return s < each.along; });
  const Station &a = *(next - 1), &b = *next;
  const double span = b.along - a.along;
  const double t = span > 0 ? std::clamp((along - a.along) / span, 0.0, 1.0) : 0;
  const auto mix = [t](const auto& x, const auto& y) { return x * (1 - t) + y * t; };
  Station out;
  out.position = mix(a.position, b.position);
  out.frame =
      Frame{mix(a.frame.tangent, b.frame.tangent), mix(a.frame.normal, b.frame.normal), Vec3d(0)}
          .orthonormalized();
  out.radius = mix(a.radius, b.radius);
  out.along = mix(a.along, b.along);
  out.age = mix(a.age, b.age);
  return out;
}

}  // namespace vug::lsystem
