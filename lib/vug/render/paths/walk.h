// One path from the camera through a scene: next-event estimation at every vertex, Russian
// roulette, media, subsurface bodies.
#pragma once

#include <vug/render/integrator.h>
#include <vug/render/paths/rehearsal.h>
#include <vug/render/world.h>

namespace vug::render {

struct WalkRules {
  int max_bounces = 8;   ///< A path scatters at most once more than this.
  bool roulette = true;  ///< Ends dim paths at random.
  float most = kFar;     ///< Light of one vertex beyond the first is cut to this radiance.
  float regularize = 0;  ///< Least roughness of faces that are seen by way of matte ones.
};

/// The light that a camera ray gathers. `tally` and `trail` may be null; for `beside` see
/// Integrator::trace.
PathResult walk(const World& world, const Ray& camera_ray, const WalkRules& rules,
                const Learned& learned, SampleCursor& numbers, Tally* tally, Trail* trail,
                std::span<const Ray> beside = {});

}  // namespace vug::render
