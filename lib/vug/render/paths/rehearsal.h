// What paths can learn of a scene before the picture begins.
#pragma once

#include <vug/render/guiding/guide.h>
#include <vug/render/integrator.h>
#include <vug/render/paths/trail.h>

#include <functional>

namespace vug::render {

/// How a path gathers light, which it tells the trail.
using TrailedPath = std::function<void(const Ray&, SampleCursor&, Trail&)>;

/// A guide for the picture, learned from `paths` gathering paths, which tell how bright surfaces
/// are, and about as many that only look where the brightness is. Error(cancelled).
Guide learn_guide(const Rehearsal& rehearsal, uint64_t paths, int max_bounces,
                  const TrailedPath& gather, Progress& progress);

}  // namespace vug::render
