#include <vug/render/camera.h>
#include <vug/render/kinds.h>
#include <vug/render/paths/boundary_hits.h>
#include <vug/render/paths/automatic_portals.h>
#include <vug/render/sampling.h>
#include <vug/raytree/path_scheduler.h>
#include <vug/render/prepared_scene.h>

#include <algorithm>

namespace vug::render {
namespace {

constexpr uint64_t kSalt = 0x6f70656e73ull;

constexpr size_t kPaths = 1u << 13;
constexpr size_t kPlaces = 4;  ///< On one path.
constexpr size_t kRays = 4;    ///< From one place.
/// More rays than this part of all get out: the scene lies open.
constexpr double kOpen = 0.1;
constexpr size_t kMostPortals = 8;

/// A surface point that a camera path came to; no normal: the path had ended.
struct Place {
  Vec3f origin;
  Vec3f normal{0, 0, 0};
};

std::vector<Place> places(const Rehearsal& rehearsal, Progress& progress) {
  std::vector<Place> all(kPaths * kPlaces);
  parallel_together(kPaths, [&](size_t path) {
    SampleCursor numbers(rehearsal.sampler, rehearsal.sample_id(kSalt + 0, path, kPaths));
    const Vec2f film = numbers.pair(), lens = numbers.pair();
    Ray ray = rehearsal.camera.ray(film, rehearsal.aspect, lens);
    Hit hit;
    for (size_t i = 0; i < kPlaces && rehearsal.world.intersect(ray, hit); ++i) {
      const Vec3f& normal = hit.surface.geometric_normal;
      all[path * kPlaces + i] = {hit.origin, normal};
      ray = {hit.origin, Frame(normal).to_world(sample_cosine_hemisphere(numbers.pair()))};
    }
    progress.check();
  });
  return all;
}

/// Lets rays out over the hemispheres of all places. The part of them that got out.
double look_around(const Rehearsal& rehearsal, const std::vector<Place>& from, Exits& exits,
                   Progress& progress) {
  std::atomic<uint64_t> sent{0}, out{0};
  parallel_together(from.size(), [&](size_t i) {
    const Place& place = from[i];
    if (place.normal == Vec3f(0.0f)) return;
    for (size_t ray = 0; ray < kRays; ++ray) {
      SampleCursor numbers(rehearsal.sampler,
                           rehearsal.sample_id(kSalt + 1, i * kRays + ray, from.size() * kRays));
      const Vec3f way = Frame(place.normal).to_world(sample_cosine_hemisphere(numbers.pair()));
      if (rehearsal.world.occluded({place.origin, way}, kFar)) continue;
      exits.count({place.origin, way});
      out.fetch_add(1, std::memory_order_relaxed);
    }
    sent.fetch_add(kRays, std::memory_order_relaxed);
    progress.check();
  });
  return sent > 0 ? static_cast<double>(out) / static_cast<double>(sent) : 0;
}

/// Lets rays out through the neighbourhood of known exits, to see how far these reach.
void look_closer(const Rehearsal& rehearsal, const std::vector<Place>& from,
                 const std::vector<RectangleParams>& known, Exits& exits, Progress& progress) {
  std::vector<Rectangle> shapes(known.begin(), known.end());
  parallel_together(from.size(), [&](size_t i) {
    const Place& place = from[i];
    if (place.normal == Vec3f(0.0f)) return;
    for (size_t k = 0; k < shapes.size(); ++k) {
      SampleCursor numbers(rehearsal.sampler, rehearsal.sample_id(kSalt + 2 + k, i, from.size()));
      const LightSample s = shapes[k].sample(place.origin, numbers.pair());
      if (!(s.pdf > 0) || !(dot(s.direction, place.normal) > 0)) continue;
      const Ray ray{place.origin, s.direction};
      if (!rehearsal.world.occluded(ray, kFar)) exits.count(ray);
    }
    progress.check();
  });
}

}  // namespace

std::vector<LightPtr> find_openings(const Rehearsal& rehearsal, Progress& progress) {
  const LightSet& lights = rehearsal.world.lights();
  if (!lights.has_sky() || !lights.sky_is_plain()) return {};
  progress.begin("finding the openings to the sky", 4);
  const std::vector<Place> from = places(rehearsal, progress);
  progress.advance();
  Exits exits(rehearsal.world.bounds());
  const double out = look_around(rehearsal, from, exits, progress);
  progress.advance();
  std::vector<LightPtr> portals;
  if (out > 0 && out < kOpen) {
    for (int round = 0; round < 2; ++round) {
      look_closer(rehearsal, from, exits.rectangles(kMostPortals, 2), exits, progress);
      progress.advance();
    }
    for (const RectangleParams& r : exits.rectangles(kMostPortals, 0))
      portals.push_back(make_light("portal", {{"center", r.center},
                                              {"normal", r.normal},
                                              {"up", r.up.value()},
                                              {"width", r.width},
                                              {"height", r.height}}));
  }
  progress.end();
  return portals;
}

}  // namespace vug::render
