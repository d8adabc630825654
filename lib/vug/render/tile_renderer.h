// SPDX-License-Identifier: Apache-2.0
// A scene prepared for sampling any pixel of the picture.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/film/film.h>
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/paths/bright_edges.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/render.h>

namespace vug::render {

/// Renders tiles. Samples are independent of each other, so any thread may render any of them, with
/// identical results.
class TileRenderer {
 public:
  /// Keeps references to the scene and the options. Throws as `render` does. The constructor builds
  /// the BVH, finds automatic portals, trains the integrator and detects bright edges.
  TileRenderer(const Scene& scene, const Options& options, Progress& progress);

  /// The pixels to be rendered: Options::crop, or the whole picture.
  const Region& region() const { return region_; }
  /// Renders the samples begin <= i < end of each pixel of the tile. `deep` is a picture of
  /// region(), or null.
  Film render_tile(const Region& region, uint32_t begin, uint32_t end,
                   image::DeepImage* deep = nullptr) const;
  /// Estimates the wall-clock time in seconds of `samples` samples, from a few taken now.
  double estimate_seconds(double samples) const;

 private:
  PathResult sample(int x, int y, uint32_t index, LightPathRecorder& recorder) const;
  Ray camera_ray(const SampleId& id, float time) const;
  /// The additional rays of a sample; see BrightEdges.
  std::vector<Ray> extra_rays(SampleId id, float time) const;

  const Scene& scene_;
  const Options& options_;
  Progress& progress_;
  SamplerPtr sampler_;
  IntegratorPtr integrator_;
  std::unique_ptr<const PreparedScene> world_;
  LightPathPlan light_paths_;
  BrightEdges edges_;
  Region region_;
  float spread_;
  bool is_static_;  ///< True if nothing moves and no motion AOV is requested.
};

}  // namespace vug::render
