// A place where a path scattered, and how light that its next ray meets is weighed.
#pragma once

#include <vug/render/prepared_scene.h>

namespace vug::render {

class Tally;

/// Lights are found both by choosing them and by following the path, weighed by the balance
/// heuristic (Veach 1997, "Robust Monte Carlo methods for light transport simulation", section 9.2,
/// veach1997).
struct PathVertex {
  /// `transmission`: behind a surface that lets light through, where lights are not sampled; behind
  /// one that is lit from behind, too, they are, and the vertex is a `surface`.
  enum { camera, surface, transmission, medium } kind = camera;
  LightSampleContext point;
  float pdf = 0;             ///< Of the direction taken, over solid angle.
  LightSelection selection;  ///< By which lights were sampled.
};

/// Emission of lamps between the ray's origin and `end`, as the vertex that the ray comes from
/// may count it. A lamp that the camera sees is opaque: it sets `alpha` to 1. `numbers` are for the
/// way through the medium; `tally` may be null.
Rgb light_emission(const World& world, const Ray& ray, float end, const PathVertex& from,
                   float& alpha, TrackingRng& numbers, Tally* tally);
/// What the surface that the ray meets sends out itself; as with lamps, but it ends the ray.
Rgb surface_emission(const World& world, const Ray& ray, const Hit& hit, const PathVertex& from,
                     TrackingRng& numbers, Tally* tally);
/// The sky, for a ray that escapes.
Rgb environment_emission(const World& world, const Ray& ray, const PathVertex& from,
                         TrackingRng& numbers, Tally* tally);

/// What a camera ray sees shine by itself: lamps, or what it ends at.
Rgb camera_emission(const World& world, const Ray& ray, TrackingRng& numbers, Tally* tally);

/// Part of the light that the medium lets through, up to `end` (may be kFar).
float transmittance(const World& world, const Ray& ray, float end, TrackingRng& numbers);
/// Light of a sampled light before walls and medium, as far as it lights the object.
Rgb unoccluded_radiance(const World& world, const LightSample& sample, uint32_t object);
bool occluded(const World& world, const Ray& ray, float distance);

}  // namespace vug::render
