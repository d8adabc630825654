// SPDX-License-Identifier: Apache-2.0
#include <vug/raytree/path_scheduler.h>
#include <vug/render/camera.h>
#include <vug/render/kinds.h>
#include <vug/render/paths/automatic_portals.h>
#include <vug/render/paths/boundary_hits.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/sampling.h>

#include <algorithm>

namespace vug::render {
namespace {

constexpr uint64_t kPortalSalt = 0x6f70656e73ull;

constexpr size_t kPaths = 1u << 13;
constexpr size_t kPathPoints = 4;  ///< Points on one path.
constexpr size_t kRays = 4;        ///< Rays from one point.
/// If more than this fraction of the rays escapes, the scene is open.
constexpr double kOpen = 0.1;
constexpr size_t kMostPortals = 8;

/// A surface point on a camera path; without a normal the path had ended.
struct PathPoint {
  Vec3f origin;
  Vec3f normal{0, 0, 0};
};

std::vector<PathPoint> path_points(const TrainingContext& context, Progress& progress) {
  std::vector<PathPoint> all(kPaths * kPathPoints);
  raytree::parallel_interleaved(kPaths, [&](size_t path) {
    SampleCursor numbers(context.sampler, context.sample_id(kPortalSalt + 0, path, kPaths));
    const Vec2f film = numbers.pair(), lens = numbers.pair();
    Ray ray = context.camera.ray(film, context.aspect, lens);
    Hit hit;
    for (size_t i = 0; i < kPathPoints && context.world.intersect(ray, hit); ++i) {
      const Vec3f& normal = hit.surface.geometric_normal;
      all[path * kPathPoints + i] = {hit.origin, normal};
      ray = {hit.origin, Frame(normal).to_world(sample_cosine_hemisphere(numbers.pair()))};
    }
    progress.check();
  });
  return all;
}

/// Traces rays over the hemispheres of all points. Returns the fraction that escapes.
double sample_hemispheres(const TrainingContext& context, const std::vector<PathPoint>& from,
                          BoundaryHits& hits, Progress& progress) {
  std::atomic<uint64_t> sent{0}, out{0};
  raytree::parallel_interleaved(from.size(), [&](size_t i) {
    const PathPoint& point = from[i];
    if (point.normal == Vec3f(0.0f)) return;
    for (size_t ray = 0; ray < kRays; ++ray) {
      SampleCursor numbers(context.sampler, context.sample_id(kPortalSalt + 1, i * kRays + ray,
                                                              from.size() * kRays));
      const Vec3f way = Frame(point.normal).to_world(sample_cosine_hemisphere(numbers.pair()));
      if (context.world.occluded({point.origin, way}, kFar)) continue;
      hits.count({point.origin, way});
      out.fetch_add(1, std::memory_order_relaxed);
    }
    sent.fetch_add(kRays, std::memory_order_relaxed);
    progress.check();
  });
  return sent > 0 ? static_cast<double>(out) / static_cast<double>(sent) : 0;
}

/// Traces rays towards the neighbourhood of the known rectangles to find their full extent.
void refine_hits(const TrainingContext& context, const std::vector<PathPoint>& from,
                 const std::vector<RectangleParams>& known, BoundaryHits& hits,
                 Progress& progress) {
  std::vector<RectangleShape> shapes(known.begin(), known.end());
  raytree::parallel_interleaved(from.size(), [&](size_t i) {
    const PathPoint& point = from[i];
    if (point.normal == Vec3f(0.0f)) return;
    for (size_t k = 0; k < shapes.size(); ++k) {
      SampleCursor numbers(context.sampler, context.sample_id(kPortalSalt + 2 + k, i, from.size()));
      const LightSample s = shapes[k].sample(point.origin, numbers.pair());
      if (!(s.pdf > 0) || !(dot(s.direction, point.normal) > 0)) continue;
      const Ray ray{point.origin, s.direction};
      if (!context.world.occluded(ray, kFar)) hits.count(ray);
    }
    progress.check();
  });
}

}  // namespace

std::vector<RectangleParams> find_automatic_portals(const TrainingContext& context,
                                                    Progress& progress) {
  if (!context.world.lights().needs_portals()) return {};
  progress.begin("finding openings to the sky", 4);
  const std::vector<PathPoint> from = path_points(context, progress);
  progress.advance();
  BoundaryHits hits(context.world.bounds());
  const double out = sample_hemispheres(context, from, hits, progress);
  progress.advance();
  std::vector<RectangleParams> portals;
  if (out > 0 && out < kOpen) {
    for (int round = 0; round < 2; ++round) {
      refine_hits(context, from, hits.rectangles(kMostPortals, 2), hits, progress);
      progress.advance();
    }
    portals = hits.rectangles(kMostPortals, 0);
  }
  progress.end();
  return portals;
}

std::vector<LightPtr> portal_lights(const std::vector<RectangleParams>& portals) {
  std::vector<LightPtr> lights;
  for (const RectangleParams& r : portals)
    lights.push_back(make_light("portal", {{"center", r.center},
                                           {"normal", r.normal},
                                           {"up", r.up.value()},
                                           {"width", r.width},
                                           {"height", r.height}}));
  return lights;
}

}  // namespace vug::render
