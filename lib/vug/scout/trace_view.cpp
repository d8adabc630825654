// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/exchange/look.h>
#include <vug/scout/trace_view.h>

#include <algorithm>

namespace vug::scout {
namespace {

constexpr float kWalkable = 0.64f;  // cosine of 50 degrees

Seen seen_by(const render::PreparedScene& world, const render::Ray& ray) {
  render::Hit hit;
  Seen seen;
  if (!world.intersect(ray, hit)) return seen;
  seen.distance = hit.distance;
  seen.object = hit.object;
  seen.normal = hit.surface.geometric_normal;
  seen.origin = hit.origin;
  seen.inside = hit.surface.inside;
  seen.emission = render::luminance(hit.emission);
  seen.albedo = 0.5f;
  if (hit.material) {
    const exchange::Look look = hit.material->look(hit.surface);
    seen.albedo = static_cast<float>(render::luminance(look.base_color) *
                                     (1 - std::min(1.0, look.transmission)));
  }
  return seen;
}

}  // namespace

Seen look_along(const render::PreparedScene& world, const Vec3d& from, const Vec3d& direction) {
  return seen_by(world, {Vec3f(from), Vec3f(direction.normalized())});
}

View trace_view(const render::PreparedScene& world, const render::Camera& camera, int width,
                int height) {
  View view(width, height);
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  parallel_for(static_cast<size_t>(height), [&](size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      const Vec2f film((static_cast<float>(x) + 0.5f) / w, (static_cast<float>(y) + 0.5f) / h);
      view.at(x, y) = seen_by(world, camera.ray(film, w / h, {0.5f, 0.5f}));
    }
  });
  return view;
}

double clearance(const render::PreparedScene& world, const Vec3d& p) {
  double nearest = kInfinity;
  int backs = 0, hits = 0;
  for (int code = 0; code < 27; ++code) {
    if (code == 13) continue;  // no direction
    const int column = code % 3 - 1, row = code / 3 % 3 - 1, slice = code / 9 - 1;
    const Seen seen = look_along(world, p, Vec3d(column, row, slice));
    if (seen.object == kSky) continue;
    ++hits;
    if (seen.inside) ++backs;
    nearest = std::min(nearest, static_cast<double>(seen.distance));
  }
  return 2 * backs > std::max(hits, 13) ? 0 : nearest;
}

std::optional<Vec3d> floor_below(const render::PreparedScene& world, const Vec3d& p, double reach) {
  const Seen seen = look_along(world, p, {0, -1, 0});
  if (seen.object == kSky || seen.inside || static_cast<double>(seen.distance) > reach ||
      seen.normal.y < kWalkable)
    return std::nullopt;
  return p - Vec3d(0, static_cast<double>(seen.distance), 0);
}

}  // namespace vug::scout
