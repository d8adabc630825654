// What paths can learn of a scene before the picture begins.
#pragma once

#include <vug/render/guiding/guide.h>
#include <vug/render/integrator.h>
#include <vug/render/paths/trail.h>

#include <functional>

namespace vug::render {

/// How a path gathers light, led by a guide that may know nothing yet; it tells the trail.
using TrailedPath = std::function<void(const Ray&, SampleCursor&, const Guide&, Trail&)>;

/// A guide for the picture, learned from so many paths. It is empty where no surface is much
/// brighter than others. Error(cancelled).
Guide learn_guide(const Rehearsal& rehearsal, uint64_t paths, const TrailedPath& gather,
                  Progress& progress);

}  // namespace vug::render
