#include <vug/render/paths/vertex.h>
#include <vug/render/film/light_path_recorder.h>

namespace vug::render {
namespace {

/// Shadow rays stop this part of the way to the lamp, before any wall it may lie against.
constexpr float kAlmost = 0.9999f;

}  // namespace

float clear_part(const World& world, const Ray& ray, float end, TrackingNumbers& numbers) {
  const Medium* medium = world.medium();
  return medium ? medium->transmittance(ray, medium->clip(ray, end), numbers) : 1;
}

Rgb unshadowed(const World& world, const LightSample& s, uint32_t object) {
  return s.distance == kFar ? world.lights().sky_radiance(s.direction, object) : s.radiance;
}

bool shadowed(const World& world, const Ray& ray, float distance) {
  return world.occluded(ray, distance == kFar ? kFar : distance * kAlmost);
}

Rgb lamps_met(const World& world, const Ray& ray, float end, const PathVertex& from, float& alpha,
              TrackingNumbers& numbers, Tally* tally) {
  Rgb light(0.0f);
  // From a medium, direct sampling finds all of a lamp's light.
  if (from.kind == PathVertex::medium) return light;
  world.lights().each_lamp_on(ray, end, from.point.object, [&](LightId id, const Light& lamp) {
    LightHit hit;
    if (!lamp.intersect(ray, end, hit)) return;
    float weight = 1;
    if (from.kind == PathVertex::camera) {
      if (!lamp.camera_visible()) return;
      alpha = 1;
    } else if (from.kind == PathVertex::surface) {
      const float direct =
          world.lights().share(id, from.point, from.odds) * lamp.pdf(from.point, ray.direction);
      weight = from.pdf / (from.pdf + direct);
    }
    const Rgb arriving = hit.radiance * (weight * clear_part(world, ray, hit.distance, numbers));
    if (tally) tally->note(world.lights().group(id), arriving);
    light += arriving;
  });
  return light;
}

Rgb surface_met(const World& world, const Ray& ray, const Hit& hit, const PathVertex& from,
                TrackingNumbers& numbers, Tally* tally) {
  const LightSet& lights = world.lights();
  Rgb emission = hit.emission;
  if (lights.emission_varies() && !hit.surface.inside) {
    // Both ways to find light ask for all detail, or they would not weigh the same function.
    const float footprint = from.kind == PathVertex::camera ? hit.surface.footprint : 0;
    emission = lights.emission(hit.object, hit.triangle, hit.surface.u, hit.surface.v, footprint);
  }
  if (is_black(emission)) return Rgb(0.0f);
  const LightId id = lights.emitter(hit.object, hit.triangle);
  if (from.kind == PathVertex::medium && lights.can_choose(id)) return Rgb(0.0f);
  float weight = 1;
  if (from.kind == PathVertex::surface) {
    const float share = lights.share(id, from.point, from.odds);
    const float direct = share > 0 ? share * lights.pdf(id, from.point, ray.direction) : 0;
    weight = from.pdf / (from.pdf + direct);
  }
  const Rgb arriving = emission * (weight * clear_part(world, ray, hit.distance, numbers));
  if (tally) tally->note(lights.group(id), arriving);
  return arriving;
}

Rgb seen_by_camera(const World& world, const Ray& ray, TrackingNumbers& numbers, Tally* tally) {
  const PathVertex camera;
  Hit hit;
  float alpha = 0;
  const bool found = world.intersect(ray, hit);
  if (found) hit.surface.footprint = ray.spread * hit.distance;
  const Rgb lamps =
      lamps_met(world, ray, found ? hit.distance : kFar, camera, alpha, numbers, tally);
  return lamps + (found ? surface_met(world, ray, hit, camera, numbers, tally)
                        : sky_met(world, ray, camera, numbers, tally));
}

Rgb sky_met(const World& world, const Ray& ray, const PathVertex& from, TrackingNumbers& numbers,
            Tally* tally) {
  const LightSet& lights = world.lights();
  if (!lights.has_sky()) return Rgb(0.0f);
  float weight = 1;
  if (from.kind == PathVertex::surface) {
    const float direct = lights.sky_pdf(from.point, from.odds, ray.direction);
    weight = from.pdf / (from.pdf + direct);
  } else if (from.kind == PathVertex::medium) {
    // Direct sampling finds the sky only where it may turn to.
    for (const LightId id : lights.sampled_skies())
      if (lights.pdf(id, from.point, ray.direction) > 0) return Rgb(0.0f);
  }
  weight *= clear_part(world, ray, kFar, numbers);
  if (tally) tally->note_sky(world, from.point.object, ray.direction, Rgb(weight));
  return lights.sky_radiance(ray.direction, from.point.object) * weight;
}

}  // namespace vug::render
