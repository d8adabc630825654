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

/// The ray of a camera sample; for the extra rays see Integrator::trace.
struct CameraRays {
  Ray first;
  std::span<const Ray> extra{};
};

/// The recorders of a path; null if nothing is recorded.
struct PathRecorders {
  LightPathRecorder* light = nullptr;
  PathRecorder* training = nullptr;
};

/// Radiance along a camera ray.
PathResult trace_path(const PreparedScene& world, const CameraRays& rays,
                      const PathSettings& settings, const GuidingData& guiding,
                      SampleCursor& numbers, const PathRecorders& recorders);

}  // namespace vug::render
