// SPDX-License-Identifier: Apache-2.0
// The viewport of a scene that is being edited: it builds texts and renders previews on threads of
// its own, and always has a picture to show.
#pragma once

#include <vug/viewport/preview_renderer.h>

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>

namespace vug::viewport {

struct ViewportOptions {
  loading::LoadOptions load;
  picture::PictureOptions picture;
  BuildOptionsOf build = nullptr;
  /// Adds faults of a text that evaluation does not find; called on the thread that builds.
  std::function<void(loading::Loaded&)> check = nullptr;
};

/// The work since the viewport began.
struct ViewportCounters {
  size_t texts = 0;     ///< Evaluated texts.
  size_t scenes = 0;    ///< Texts whose products were built.
  size_t products = 0;  ///< Level sets, meshes, surfaces and cell layers that were made or read.
  size_t pictures = 0;
  size_t trees = 0;      ///< BVHs that were built.
  uint64_t samples = 0;  ///< Sum over all pixels.
};

/// The state of a viewport at a time. Copies are cheap.
struct ViewportStatus {
  PreviewPtr picture;    ///< The last one; null before the first.
  uint64_t wanted = 0;   ///< The version of the last text.
  uint64_t checked = 0;  ///< The version to which the problems belong.
  uint64_t failed = 0;   ///< The last version that was not built, because of errors or by request.
  std::string report;    ///< The problems as printed by `vug check`.
  std::shared_ptr<const Diagnostics> problems = std::make_shared<const Diagnostics>();
  bool building = false;   ///< A text is evaluated, or its products are built.
  bool rendering = false;  ///< A finer picture, or one of another view, follows.
  bool stopped = false;    ///< `stop` was called after the last change.
  bool paused = false;     ///< Pictures stay coarse until the pause ends.
  std::string stage;       ///< The stage of the build.
  double fraction = 0;     ///< Finished share of the stage, 0..1.
  ViewportCounters counters;

  bool busy() const { return building || rendering; }
  /// Whether the picture does not show the last text.
  bool stale() const { return !picture || picture->scene.scene->version != wanted; }
};

/// Its functions return at once and may be called by one thread. A new text cancels the work for
/// the text before; a new view cancels only the refinement of the picture, never a build nor the
/// coarsest picture, so that pictures also appear during a motion.
class Viewport {
 public:
  /// `file`: see LiveText. `notify` is called on other threads after each change of the status.
  Viewport(std::filesystem::path file, ViewportOptions options, std::function<void()> notify = {});
  ~Viewport();
  Viewport(const Viewport&) = delete;
  Viewport& operator=(const Viewport&) = delete;

  /// Returns the number of the text, from 1.
  uint64_t set_text(std::string text);
  /// Builds the last text again, also after `stop`.
  void refresh();
  /// The view until the next call; none: the camera of the text.
  void set_view(const std::optional<View>& view);
  void set_mode(Mode mode);
  /// Pixels; at least 1.
  void set_size(int width, int height);
  /// Renders only this part of the picture until the next call; none: all of it. A box outside of
  /// the picture is moved to its edge.
  void set_region(const std::optional<RegionBox>& region);
  /// The display of the light, without new samples. A view must be a known one.
  void set_display(const DisplayChoice& display);
  /// A pause ends the refinement of the picture and keeps its samples; afterwards they continue.
  /// A paused picture is denoised if its display requests it.
  /// Changes of the text or the view still show their coarsest picture.
  void set_paused(bool paused);
  /// Ends all work soon. The last picture stays.
  void stop();

  const PreviewRequest& request() const { return request_; }
  /// The view of the next picture: the one that was set, or that of the text's camera. After the
  /// first picture, the target of the latter is the surface in the middle of the picture.
  View view() const;
  ViewportStatus status() const;
  /// Waits until all work has ended, for tests and for programs without an event loop.
  void wait() const;

 private:
  void build_texts();
  void render_pictures();
  void publish(Preview picture, const render::SessionCounters& counters);
  void update(const std::function<void(ViewportStatus&)>& change);
  void request_picture();

  const std::filesystem::path file_;
  const ViewportOptions options_;
  const std::function<void()> notify_;
  PreviewRequest request_;  ///< The request of the calling thread.

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  bool ended_ = false;
  ViewportStatus status_;
  // For the thread that builds.
  std::string text_;
  uint64_t orders_ = 0;  ///< Number of texts and refreshes.
  std::shared_ptr<Progress> build_ = std::make_shared<Progress>();
  // For the thread that renders.
  PreviewScenePtr scene_;
  PreviewRequest shown_;   ///< The latest request.
  uint64_t requests_ = 0;  ///< Number of requests and scenes.
  bool refining_ = false;
  std::shared_ptr<Progress> render_ = std::make_shared<Progress>();
  std::optional<View> home_;

  std::thread builder_, renderer_;
};

}  // namespace vug::viewport
