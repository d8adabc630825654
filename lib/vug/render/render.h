// From a scene to a picture.
#pragma once

#include <vug/base/progress.h>
#include <vug/image/image.h>
#include <vug/render/film/aovs.h>
#include <vug/render/film/deep.h>
#include <vug/render/film/motion_step.h>
#include <vug/render/integrator.h>
#include <vug/render/sampler.h>
#include <vug/render/scene.h>

#include <cstdint>
#include <functional>
#include <optional>

namespace vug::render {

struct Options {
  int width = 960;
  int height = 540;
  int spp = 64;  ///< Samples per pixel; powers of 4 give the sobol sampler its best spread.
  uint64_t seed = 0;
  int threads = 0;      ///< 0: as many as parallel work may use already.
  int max_bounces = 8;  ///< At most this + 1 scatterings; ignored when `integrator` is given.
  int tile_size = 16;   ///< Pixels on a side of what one task renders; no effect on the picture.
  SamplerPtr sampler;   ///< Null: sobol.
  IntegratorPtr integrator;  ///< Null: path.
  AovPlan aovs = plan_aovs({}, {});
  bool openings = true;       ///< Find where the sky shines in; no effect on the picture's mean.
  bool bright_edges = true;   ///< More camera rays where what shines ends; nor has this.
  Region crop;                ///< Which pixels of the picture; empty: all.
  MotionStepPtr motion_step;  ///< For the layer `motion`; null: nothing moves.
  /// Also a deep picture, and how; only where all samples of a pixel are taken at once: without
  /// `noise` and a RenderCallbacks that wants passes or saving.
  std::optional<DeepOptions> deep;
  double noise = 0;  ///< Blocks whose noise is below this get no more samples; 0: `spp` for all.
};

struct RenderState;

/// Who follows the work. Each is called on a working thread, one at a time, while nothing changes
/// the state; the state may be written to disk then.
struct RenderCallbacks {
  std::function<void(double seconds)> estimate = nullptr;  ///< Before the work: how long, about.
  std::function<void(const RenderState&)> pass =
      nullptr;  ///< All pixels have the same samples or enough.
  std::function<void(const RenderState&)> save = nullptr;  ///< From time to time and when stopped.
  /// Seconds; none: a hundred times as long as saving took the last time, but two to five minutes.
  std::optional<double> save_every = std::nullopt;
  /// At the end, if there were any: samples left out because they are no number, and those clamped
  /// for being brighter than kMaxLight.
  std::function<void(uint64_t invalid, uint64_t clamped)> invalid_samples = nullptr;
};

/// The picture with the layers of the plan, 32-bit channels, means over the samples; see layers().
/// The same bytes for any number of threads. Error(bad_input): no camera, sizes or spp below 1,
/// a mesh with indices out of range or positions that are not finite. Error(cancelled).
/// `deep`: takes what Options::deep asks for.
image::Image render(const Scene& scene, const Options& options,
                    Progress& progress = Progress::none(), const RenderCallbacks& callbacks = {},
                    image::DeepImage* deep = nullptr);

/// Options::crop or all of the picture; Error(bad_input) when it lies beyond.
Region render_region(const Options& options);

/// Bytes that `render` will need beyond the scene itself: acceleration structure and film;
/// with a deep picture its largest size;
/// `whole_film`: the sums of all pixels are held, not those of one block for each thread.
double memory_estimate(const Scene& scene, const Options& options, bool whole_film = false);

}  // namespace vug::render
