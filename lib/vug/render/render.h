// SPDX-License-Identifier: Apache-2.0
// Renders a scene to a picture at once; checkpoints and partial renders use film/render_state.h.
#pragma once

#include <vug/base/progress.h>
#include <vug/image/image.h>
#include <vug/render/film/aovs.h>
#include <vug/render/film/deep.h>
#include <vug/render/film/motion_step.h>
#include <vug/render/film/noise_report.h>
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
  int spp = 64;  ///< Samples per pixel; powers of 4 suit the sobol sampler best.
  uint64_t seed = 0;
  int threads = 0;  ///< 0: the current limit of parallel work.
  int max_bounces =
      8;  ///< Paths scatter at most max_bounces + 1 times; ignored if `integrator` is given.
  int tile_size =
      16;  ///< Side in pixels of the tile (bucket) of one task; no effect on the picture.
  SamplerPtr sampler;        ///< Null: `sobol`.
  IntegratorPtr integrator;  ///< Null: `path`.
  AovPlan aovs = plan_aovs({}, {});
  bool openings = true;      ///< Find openings to the sky and treat them as portals; the expected
                             ///< picture is unchanged.
  bool bright_edges = true;  ///< Trace extra camera rays at the edges of bright areas; the expected
                             ///< picture is unchanged.
  Region crop;               ///< The pixels to be rendered; empty: all.
  MotionStepPtr motion_step;        ///< For the AOV `motion`; null: nothing moves.
  std::optional<DeepOptions> deep;  ///< Options of a deep picture; none: no deep picture.
  double noise =
      0;  ///< Tiles whose noise is below this get no more samples; 0: `spp` samples everywhere.
};

struct PreparedRender;
struct RenderState;

/// Callbacks of a render. Each is called on a worker thread, one at a time, while nothing changes
/// the state, so that the state can be written to disk.
struct RenderCallbacks {
  std::function<void(double seconds)> estimate =
      nullptr;  ///< Estimated duration, before the render.
  std::function<void(const RenderState&)> pass =
      nullptr;  ///< All tiles have the same number of samples or have converged.
  std::function<void(const RenderState&)> save =
      nullptr;  ///< Periodically, and when the render is cancelled.
  /// Seconds between saves; none: one hundred times the duration of the last save, clamped to two
  /// to five minutes.
  std::optional<double> save_every = std::nullopt;
  /// With Options::noise, after 16, 32, 64, ... samples and at the end: the noise so far, and the
  /// estimated remaining seconds, 0 at the end.
  std::function<void(const NoiseReport& report, double seconds)> noise = nullptr;
  /// At the end, if any samples were invalid: the number of samples that were discarded as NaN or
  /// infinite, and of samples clamped to kMaxLight.
  std::function<void(uint64_t invalid, uint64_t clamped)> invalid_samples = nullptr;
};

/// Renders a picture with the AOVs of the plan, see aovs(): 32-bit channels, means over the
/// samples. The same bytes for any number of threads. Throws Error(bad_input) without a camera, for
/// sizes or spp below 1, and for meshes with indices out of range or positions that are not finite;
/// Error(cancelled). `deep`: receives the picture of Options::deep.
image::Image render(const Scene& scene, const Options& options,
                    Progress& progress = Progress::none(), const RenderCallbacks& callbacks = {},
                    image::DeepImage* deep = nullptr);
/// Renders what `prepare` returned, with its options.
image::Image render(const PreparedRender& prepared, Progress& progress = Progress::none(),
                    const RenderCallbacks& callbacks = {}, image::DeepImage* deep = nullptr);

/// The data that a film must accumulate for the AOVs and the deep picture.
FilmLayout film_layout(const Options& options);

/// Options::crop or the whole picture. Throws Error(bad_input) if the crop exceeds the picture.
Region render_region(const Options& options);

/// Bytes of a triangle in the acceleration structure while it is built, for meshes that are not
/// instances; 86 were measured with 4 10^6 triangles.
inline constexpr double kTriangleBytes = 110;

/// Bytes that `render` needs in addition to the scene itself: acceleration structures, film and, if
/// requested, the deep picture at its largest size. `whole_film`: the sums of all pixels are kept,
/// not only those of one tile per thread.
double memory_estimate(const Scene& scene, const Options& options, bool whole_film = false);

}  // namespace vug::render
