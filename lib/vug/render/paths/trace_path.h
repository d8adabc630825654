// One path from the camera through a scene: next-event estimation at every vertex, Russian
// roulette, media, subsurface bodies.
#pragma once

#include <vug/render/integrator.h>
#include <vug/render/paths/training.h>
#include <vug/render/prepared_scene.h>

namespace vug::render {

/// What decides at random whether a path goes on.
enum class Roulette {
  off,         ///< All do.
  throughput,  ///< By the root of what it carries, from the first surface on.
  adjoint      ///< By what it may still add to the picture, behind the first surface.
};

struct PathSettings {
  int max_bounces = 8;  ///< A path scatters at most once more than this.
  Roulette roulette = Roulette::adjoint;
  float light_samples = 2;  ///< Lights that the first surface looks at; others look at one.
  LightSampler light_sampler = LightSampler::tree;
  float max_radiance = kFar;  ///< Light of one vertex beyond the first is cut to this radiance.
  float regularize = 0;       ///< Least roughness of faces that are seen by way of matte ones.
};

/// The light that a camera ray gathers. `tally` and `path_recorder` may be null; for `beside` see
/// Integrator::trace.
PathResult trace_path(const World& world, const Ray& camera_ray, const PathSettings& settings,
                      const GuidingData& guiding, SampleCursor& numbers, Tally* tally,
                      PathRecorder* path_recorder, std::span<const Ray> beside = {});

}  // namespace vug::render
