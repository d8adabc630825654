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
  worth        ///< By what it may still add to the picture, behind the first surface.
};

struct WalkRules {
  int max_bounces = 8;  ///< A path scatters at most once more than this.
  Roulette roulette = Roulette::worth;
  float lights_seen = 2;  ///< Lights that the first surface looks at; others look at one.
  LightSampler light_sampler = LightSampler::tree;
  float most = kFar;     ///< Light of one vertex beyond the first is cut to this radiance.
  float regularize = 0;  ///< Least roughness of faces that are seen by way of matte ones.
};

/// The light that a camera ray gathers. `tally` and `trail` may be null; for `beside` see
/// Integrator::trace.
PathResult walk(const World& world, const Ray& camera_ray, const WalkRules& rules,
                const Learned& learned, SampleCursor& numbers, Tally* tally, Trail* trail,
                std::span<const Ray> beside = {});

}  // namespace vug::render
