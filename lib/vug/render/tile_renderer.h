// A scene ready to be sampled anywhere in the picture.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/film/film.h>
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/paths/bright_edges.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/render.h>

namespace vug::render {

/// Takes samples of pixels; any thread may ask for any of them, and gets the same ones.
class TileRenderer {
 public:
  /// The scene and the options must outlive it. Throws as `render` does.
  TileRenderer(const Scene& scene, const Options& options, Progress& progress);

  /// The pixels of the picture that are wanted: Options::crop, or all.
  const Region& region() const { return region_; }
  /// Samples begin <= i < end of each pixel of the region; `deep` is a picture of all that is
  /// wanted, or null.
  Film render_tile(const Region& region, uint32_t begin, uint32_t end,
                   image::DeepImage* deep = nullptr) const;
  /// Wall-clock seconds that `samples` will take, about, from a few taken now.
  double estimate_seconds(double samples) const;

 private:
  PathResult sample(int x, int y, uint32_t index, LightPathRecorder& recorder) const;
  Ray camera_ray(const SampleId& id, float time) const;
  /// The rays extra_rays those of a sample; see BrightEdges.
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
  bool is_static_;  ///< Nothing moves, and nobody asks how.
};

}  // namespace vug::render
