// SPDX-License-Identifier: Apache-2.0
// Traces a path from the camera: next-event estimation at every vertex, Russian roulette, media,
// subsurface scattering.
#pragma once

#include <vug/render/integrator.h>
#include <vug/render/paths/training.h>
#include <vug/render/prepared_scene.h>

namespace vug::render {

/// Survival probability of Russian roulette.
enum class Roulette {
  off,         ///< All paths continue.
  throughput,  ///< Square root of the throughput, from the first surface on.
  adjoint      ///< Expected contribution to the picture, after the first surface.
};

struct PathSettings {
  int max_bounces = 8;  ///< Largest number of scattering events minus one.
  Roulette roulette = Roulette::adjoint;
  float light_samples = 2;  ///< Light samples at the first surface; other vertices take one.
  LightSampler light_sampler = LightSampler::tree;
  float max_radiance = kFar;  ///< Upper limit of the light from one vertex after the first.
  float regularize = 0;       ///< Smallest roughness of surfaces seen after a diffuse bounce.
};

/// Radiance along a camera ray. `recorder` and `path_recorder` may be null; for `extra_rays` see
/// Integrator::trace.
PathResult trace_path(const PreparedScene& world, const Ray& camera_ray,
                      const PathSettings& settings, const GuidingData& guiding,
                      SampleCursor& numbers, LightPathRecorder* recorder,
                      PathRecorder* path_recorder, std::span<const Ray> extra_rays = {});

}  // namespace vug::render
