// SPDX-License-Identifier: Apache-2.0
// Renders successive versions of a scene, and keeps what a change leaves as it was.
#pragma once

#include <vug/render/film/render_state.h>
#include <vug/render/prepare.h>

#include <chrono>
#include <memory>
#include <optional>

namespace vug::render {

/// What is kept when the camera changes.
enum class Learning {
  /// Only what a new render would find as well: the picture has the bytes of render::render.
  exact,
  /// Guiding and automatic portals of the last camera: while the objects, lights, medium and
  /// integrator are the same, a new camera starts at once. The expected picture is the same, its
  /// bytes are not.
  kept,
};

/// The work of a session since it began.
struct SessionCounters {
  TreeCounts trees;      ///< BVHs; see PreparedScene.
  size_t scenes = 0;     ///< Preparations of the trees and lights of a scene.
  size_t trainings = 0;  ///< Searches for openings and trainings of the guiding.
  size_t restarts = 0;   ///< Pictures that were begun from their first sample.
  uint64_t samples = 0;  ///< Samples of all pixels.
};

/// A scene, options and the picture so far. After any sequence of changes, the complete picture has
/// the bytes of `render` for the same scene and options, unless Learning::kept is chosen. Changes
/// take effect at the next `proceed`; one that changes nothing keeps the samples. Objects are
/// compared by the identity of their meshes, materials and other shared parts. Not thread-safe.
class Session {
 public:
  explicit Session(Learning learning = Learning::exact) : learning_(learning) {}

  void set_scene(Scene scene);
  void set_camera(CameraPtr camera);
  void set_lights(std::vector<LightPtr> lights);
  void set_options(const Options& options);

  /// Prepares the scene for rendering, as far as it is not; throws as `prepare` does.
  const PreparedRender& prepared(Progress& progress = Progress::none());
  /// Renders until each pixel has `samples` samples or the noise is low enough; at most
  /// Options::spp. Returns whether the picture is complete. Throws as `render` does; after
  /// Error(cancelled), complete tiles are kept.
  bool proceed(uint32_t samples, Progress& progress = Progress::none(),
               const RenderCallbacks& callbacks = {});
  /// Renders passes of 1, 2, 4, ... samples until one ends after the time; at least one.
  bool proceed(std::chrono::duration<double> time, Progress& progress = Progress::none());

  bool has_samples() const { return !state_.done.empty(); }
  bool is_complete() const { return has_samples() && state_.complete(); }
  /// The picture of the samples so far; all channels are 0 before the first.
  image::Image image() const;
  /// See Options::deep.
  image::DeepImage deep() const;
  const RenderState& state() const { return state_; }
  const Scene& scene() const { return *scene_; }
  const SessionCounters& counters() const { return counters_; }

 private:
  void discard_picture();

  Learning learning_;
  std::shared_ptr<const Scene> scene_ = std::make_shared<const Scene>();
  Options options_;
  std::shared_ptr<const PreparedScene> world_;  ///< Without automatic portals.
  bool is_current_ = false;                     ///< `world_` is that of `scene_`.
  LearnedLightPtr learned_;                     ///< For these lights and objects.
  std::optional<PreparedRender> prepared_;
  RenderState state_;
  SessionCounters counters_;
};

}  // namespace vug::render
