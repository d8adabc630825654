// SPDX-License-Identifier: Apache-2.0
// Path vertices, and the MIS weights (balance heuristic) of the emission that the next ray of a
// path hits.
#pragma once

#include <vug/render/prepared_scene.h>

namespace vug::render {

class LightPathRecorder;

/// Light is found both by light sampling and by BSDF sampling, combined by the balance heuristic
/// (Veach 1997, "Robust Monte Carlo methods for light transport simulation", section 9.2,
/// veach1997).
struct PathVertex {
  /// `transmission`: behind a transmissive surface, where lights are not sampled. Behind a surface
  /// that is lit from behind they are sampled, and the vertex is a `surface`.
  enum { camera, surface, transmission, medium } kind = camera;
  LightSampleContext point;
  float pdf = 0;             ///< Density of the sampled direction, over solid angle.
  LightSelection selection;  ///< The selection by which lights were sampled.
};

struct LightEmission {
  Rgb radiance{0, 0, 0};
  bool opaque = false;  ///< Whether the camera sees one of the lights.
};

/// Emission of finite lights between the ray's origin and `end`, with the MIS weight of the vertex
/// that the ray comes from. `numbers` are for tracking through the medium; `recorder` may be null.
LightEmission light_emission(const PreparedScene& world, const Ray& ray, float end,
                             const PathVertex& from, TrackingRng& numbers,
                             LightPathRecorder* recorder);
/// Emission of the surface that the ray hits; weighted in the same way.
Rgb surface_emission(const PreparedScene& world, const Ray& ray, const Hit& hit,
                     const PathVertex& from, TrackingRng& numbers, LightPathRecorder* recorder);
/// Radiance of the sky, for a ray that escapes; weighted in the same way.
Rgb environment_emission(const PreparedScene& world, const Ray& ray, const PathVertex& from,
                         TrackingRng& numbers, LightPathRecorder* recorder);

/// Emission that a camera ray sees directly: of lights, and of the surface or sky where it ends.
Rgb camera_emission(const PreparedScene& world, const Ray& ray, TrackingRng& numbers,
                    LightPathRecorder* recorder);

/// Transmittance of the medium up to `end` (may be kFar).
float transmittance(const PreparedScene& world, const Ray& ray, float end, TrackingRng& numbers);
/// Radiance of a light sample before occlusion and medium; black if light linking excludes the
/// object.
Rgb unoccluded_radiance(const PreparedScene& world, const LightSample& sample, uint32_t object);
bool occluded(const PreparedScene& world, const Ray& ray, float distance);

}  // namespace vug::render
