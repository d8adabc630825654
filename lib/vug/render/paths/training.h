// What paths can learn of a scene before the picture begins.
#pragma once

#include <vug/render/guiding/radiance_cache.h>
#include <vug/render/guiding/guide.h>
#include <vug/render/integrator.h>
#include <vug/render/paths/path_recorder.h>

#include <functional>

namespace vug::render {

/// What paths are led by.
struct Learned {
  Guide guide;          ///< To bright surfaces; empty where none is much brighter than others.
  Chances lights;       ///< That branches of lights are in sight; empty where lights are no choice.
  Brightness surfaces;  ///< How much is worth looking for.
};

/// How a path gathers light, led by what may be nothing yet; it tells the trail.
using TrailedPath = std::function<void(const Ray&, SampleCursor&, const Learned&, Trail&)>;

/// Learns for the picture from so many paths. Error(cancelled).
Learned learn(const Rehearsal& rehearsal, uint64_t paths, const TrailedPath& gather,
              Progress& progress);

}  // namespace vug::render
