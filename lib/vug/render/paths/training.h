// SPDX-License-Identifier: Apache-2.0
// Training of path guiding before rendering.
#pragma once

#include <vug/render/guiding/guide.h>
#include <vug/render/guiding/radiance_cache.h>
#include <vug/render/integrator.h>
#include <vug/render/paths/path_recorder.h>

#include <functional>

namespace vug::render {

/// Data that guides paths.
struct GuidingData {
  Guide guide;  ///< Towards bright surfaces; empty if none is much brighter than others.
  VisibilityCache
      light_visibility;    ///< Visibility of the branches of lights; empty if there is only one.
  RadianceCache radiance;  ///< Expected light at surfaces, for adjoint-driven Russian roulette.

  /// Calls `each` with every member, for files.
  template <class Self, class Each>
  static void visit(Self& self, const Each& each) {
    each(self.guide), each(self.light_visibility), each(self.radiance);
  }
  bool is_consistent() const {
    return guide.is_consistent() && light_visibility.is_consistent() && radiance.is_consistent();
  }
};

/// The number of training paths for a picture of that many samples: a share of them, within limits.
uint64_t training_paths(uint64_t samples);

/// Traces one training path with the guiding data so far (possibly empty) and records its vertices.
using TrainingPath =
    std::function<void(const Ray&, SampleCursor&, const GuidingData&, PathRecorder&)>;

/// Trains with this number of paths. Error(cancelled).
GuidingData train(const TrainingContext& context, uint64_t paths, const TrainingPath& trace,
                  Progress& progress);

}  // namespace vug::render
