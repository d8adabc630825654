// What paths can learn of a scene before the picture begins.
#pragma once

#include <vug/render/guiding/guide.h>
#include <vug/render/guiding/radiance_cache.h>
#include <vug/render/integrator.h>
#include <vug/render/paths/path_recorder.h>

#include <functional>

namespace vug::render {

/// What paths are led by.
struct GuidingData {
  Guide guide;  ///< To bright surfaces; empty where none is much brighter than others.
  VisibilityCache light_visibility;  ///< That branches of lights are in sight; empty where lights
                                     ///< are no choice.
  RadianceCache radiance;            ///< How much is worth looking for.
};

/// How a path gathers light, led by what may be nothing yet; it tells the path_recorder.
using TrainingPath =
    std::function<void(const Ray&, SampleCursor&, const GuidingData&, PathRecorder&)>;

/// Learns for the picture from so many paths. Error(cancelled).
GuidingData train(const TrainingContext& context, uint64_t paths, const TrainingPath& trace,
                  Progress& progress);

}  // namespace vug::render
