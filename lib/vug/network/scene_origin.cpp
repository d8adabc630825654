// SPDX-License-Identifier: Apache-2.0
#include <vug/network/scene_origin.h>

#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/network/survey_space.h>

namespace vug::network {
namespace {

Vec3d middle_of(const std::vector<NamedPoint>& points) {
  std::vector<Vec3d> positions;
  positions.reserve(points.size());
  for (const NamedPoint& point : points) positions.push_back(point.position);
  return rounded_middle(positions);
}

void require_near(const std::vector<NamedPoint>& points, const Vec3d& origin) {
  for (const NamedPoint& point : points) {
    const double distance = (point.position - origin).length();
    if (distance <= kFarthestStation) continue;
    const Vec3d middle = middle_of(points);
    throw Error(
        ErrorCode::bad_input,
        fmt::format("the station '{}' is {:.0f} km from the origin of the scene, but at most "
                    "{:.0f} km are possible, because meshes have single precision",
                    point.name, distance / 1000, kFarthestStation / 1000),
        {},
        fmt::format("use the middle of the stations, 'origin: ({:.0f}, {:.0f}, {:.0f})', or "
                    "a point near it that several networks share",
                    middle.x, middle.y, middle.z));
  }
}

}  // namespace

Vec3d scene_origin(const std::vector<NamedPoint>& points, const OriginOptions& options) {
  if (options.origin && !options.recenter)
    throw Error(ErrorCode::bad_input, "'recenter: false' and 'origin' exclude each other", {},
                "remove 'recenter: false', which is the same as 'origin: (0, 0, 0)'");
  if (options.recenter && !options.origin) return middle_of(points);
  const Vec3d origin = options.origin.value_or(Vec3d(0.0));
  require_near(points, origin);
  return origin;
}

}  // namespace vug::network
