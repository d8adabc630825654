// SPDX-License-Identifier: Apache-2.0
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/paths/vertex.h>

namespace vug::render {
namespace {

/// Shadow rays end at this fraction of the distance to the light, before any wall that it touches.
constexpr float kAlmost = 0.9999f;

}  // namespace

float transmittance(const PreparedScene& world, const Ray& ray, float end, TrackingRng& numbers) {
  const Medium* medium = world.medium();
  return medium ? medium->transmittance(ray, medium->clip(ray, end), numbers) : 1;
}

Rgb unoccluded_radiance(const PreparedScene& world, const LightSample& s, uint32_t object) {
  return s.distance == kFar ? world.lights().sky_radiance(s.direction, object) : s.radiance;
}

bool occluded(const PreparedScene& world, const Ray& ray, float distance) {
  return world.occluded(ray, distance == kFar ? kFar : distance * kAlmost);
}

LightEmission light_emission(const PreparedScene& world, const Ray& ray, float end,
                             const PathVertex& from, TrackingRng& numbers,
                             LightPathRecorder* recorder) {
  LightEmission out;
  // In media, light sampling finds all light of finite lights.
  if (from.kind == PathVertex::medium) return out;
  world.lights().for_each_light_on(
      ray, end, from.point.object, [&](LightId id, const Light& source) {
        LightHit hit;
        if (!source.intersect(ray, end, hit)) return;
        float weight = 1;
        if (from.kind == PathVertex::camera) {
          if (!source.camera_visible()) return;
          out.opaque = true;
        } else if (from.kind == PathVertex::surface) {
          const float direct = world.lights().pmf(id, from.point, from.selection) *
                               source.pdf(from.point, ray.direction);
          weight = from.pdf / (from.pdf + direct);
        }
        const Rgb arriving =
            hit.radiance * (weight * transmittance(world, ray, hit.distance, numbers));
        if (recorder) recorder->record(world.lights().group(id), arriving);
        out.radiance += arriving;
      });
  return out;
}

Rgb surface_emission(const PreparedScene& world, const Ray& ray, const Hit& hit,
                     const PathVertex& from, TrackingRng& numbers, LightPathRecorder* recorder) {
  const LightSet& lights = world.lights();
  Rgb emission = hit.emission;
  if (lights.emission_varies() && !hit.surface.inside) {
    // Both sampling strategies must evaluate the same function, so both use full detail.
    const float footprint = from.kind == PathVertex::camera ? hit.surface.footprint : 0;
    emission = lights.emission(hit.object, hit.triangle, hit.surface.u, hit.surface.v, footprint);
  }
  if (is_black(emission)) return Rgb(0.0f);
  const LightId id = lights.emitter(hit.object, hit.triangle);
  if (from.kind == PathVertex::medium && lights.can_choose(id)) return Rgb(0.0f);
  float weight = 1;
  if (from.kind == PathVertex::surface) {
    const float pmf = lights.pmf(id, from.point, from.selection);
    const float direct = pmf > 0 ? pmf * lights.pdf(id, from.point, ray.direction) : 0;
    weight = from.pdf / (from.pdf + direct);
  }
  const Rgb arriving = emission * (weight * transmittance(world, ray, hit.distance, numbers));
  if (recorder) recorder->record(lights.group(id), arriving);
  return arriving;
}

Rgb camera_emission(const PreparedScene& world, const Ray& ray, TrackingRng& numbers,
                    LightPathRecorder* recorder) {
  const PathVertex camera;
  Hit hit;
  const bool found = world.intersect(ray, hit);
  if (found) hit.surface.footprint = ray.spread * hit.distance;
  const Rgb from_lights =
      light_emission(world, ray, found ? hit.distance : kFar, camera, numbers, recorder).radiance;
  return from_lights + (found ? surface_emission(world, ray, hit, camera, numbers, recorder)
                              : environment_emission(world, ray, camera, numbers, recorder));
}

Rgb environment_emission(const PreparedScene& world, const Ray& ray, const PathVertex& from,
                         TrackingRng& numbers, LightPathRecorder* recorder) {
  const LightSet& lights = world.lights();
  if (!lights.has_sky()) return Rgb(0.0f);
  float weight = 1;
  if (from.kind == PathVertex::surface) {
    const float direct = lights.sky_pdf(from.point, from.selection, ray.direction);
    weight = from.pdf / (from.pdf + direct);
  } else if (from.kind == PathVertex::medium) {
    // Light sampling finds the sky only where its density is not zero.
    for (const LightId id : lights.sampled_skies())
      if (lights.pdf(id, from.point, ray.direction) > 0) return Rgb(0.0f);
  }
  weight *= transmittance(world, ray, kFar, numbers);
  if (recorder) recorder->record_environment(world, from.point.object, ray.direction, Rgb(weight));
  return lights.sky_radiance(ray.direction, from.point.object) * weight;
}

}  // namespace vug::render
