// SPDX-License-Identifier: Apache-2.0
// Prepares a scene for rendering any tile of its picture: prepared scene, portals, guiding data and
// bright edges.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/paths/bright_edges.h>
#include <vug/render/paths/learned_light.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/render.h>

#include <memory>
#include <optional>

namespace vug::render {

/// Wall-clock time in seconds of each step of `prepare`; 0 for steps that are not needed.
struct PreparationTimings {
  double bvh = 0;           ///< Acceleration structures and lights.
  double portals = 0;       ///< Search for automatic portals, and the light set with them.
  double training = 0;      ///< Training of path guiding.
  double bright_edges = 0;  ///< Detection of bright edges.

  double total() const { return bvh + portals + training + bright_edges; }
};

/// Everything that rendering reads. It does not change while tiles are rendered.
struct PreparedRender {
  const Scene* scene = nullptr;  ///< Must outlive this value.
  Options options;
  SamplerPtr sampler;
  IntegratorPtr integrator;  ///< With its guiding data.
  LearnedLightPtr learned;   ///< For other parts of the picture.
  std::shared_ptr<const PreparedScene> world;
  LightPathPlan light_paths;
  BrightEdges edges;
  Region region;          ///< The pixels to be rendered.
  float spread = 0;       ///< The angle subtended by a pixel, in radians.
  bool is_static = true;  ///< True if nothing moves and no motion AOV is requested.
  PreparationTimings timings;

  /// The camera ray of a sample. `time`: see PreparedScene::at.
  Ray camera_ray(const SampleId& id, float time) const;
};

/// The work of `prepare` that is needed for a part of a picture.
struct PrepareOptions {
  LearnedLightPtr learned;       ///< From another part of the picture; null: it is learned now.
  std::optional<Region> region;  ///< The pixels to be rendered; none: see render_region.
  /// The scene as another picture has prepared it, with the same objects, medium and lights; null:
  /// it is prepared now.
  std::shared_ptr<const PreparedScene> world = nullptr;
};

/// Builds the BVH, finds automatic portals, trains the integrator and detects bright edges. The
/// result is the same for any number of threads, and that of a pixel for any region. Throws as
/// `render` does.
PreparedRender prepare(const Scene& scene, const Options& options, const PrepareOptions& part,
                       Progress& progress);
PreparedRender prepare(const Scene& scene, const Options& options,
                       Progress& progress = Progress::none());

}  // namespace vug::render
