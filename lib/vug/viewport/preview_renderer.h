// SPDX-License-Identifier: Apache-2.0
// Renders previews of a scene step by step: a coarse picture at once, then finer ones.
#pragma once

#include <vug/render/film/region.h>
#include <vug/render/session.h>
#include <vug/viewport/display_choice.h>
#include <vug/viewport/pick.h>
#include <vug/viewport/preview_modes.h>

#include <cstdint>
#include <optional>

namespace vug::viewport {

/// The picture that a viewport shows. Immutable.
struct Preview {
  int width = 0, height = 0;  ///< Its pixels; fewer than the viewport while it is coarse.
  std::vector<uint8_t> rgb;   ///< Display values (sRGB), row by row from the top.
  /// The pixels that were rendered. The others are those of the last whole picture, or black.
  render::Region region;
  std::shared_ptr<const image::Image> light;  ///< The linear values of the region.
  /// The light that an automatic exposure meters: a region has that of the last whole picture.
  std::shared_ptr<const image::Image> metered;
  /// R, G and B of the region, denoised from `denoised_samples` samples; null before.
  std::shared_ptr<const image::Image> denoised;
  int denoised_samples = 0;
  DisplayChoice display;
  Mode mode = Mode::clay;
  View view;
  int samples = 0;        ///< Per pixel.
  bool complete = false;  ///< No finer one follows.
  PickScene scene;
};
using PreviewPtr = std::shared_ptr<const Preview>;

/// A part of a picture, from (0, 0) at its top left corner to (1, 1) at the bottom right.
struct RegionBox {
  double x0 = 0, y0 = 0, x1 = 1, y1 = 1;

  bool operator==(const RegionBox&) const = default;
};
/// All pixels that the box touches; at least one.
render::Region pixels_of(const RegionBox& box, int width, int height);

struct PreviewRequest {
  std::optional<View> view;  ///< None: the camera of the text.
  Mode mode = Mode::clay;
  int width = 320, height = 180;
  DisplayChoice display = {};
  std::optional<RegionBox> region = {};  ///< Only these pixels are rendered; none: all.

  bool operator==(const PreviewRequest&) const = default;
  /// Whether both have the same samples: only their displays differ.
  bool same_samples(const PreviewRequest& other) const {
    return view == other.view && mode == other.mode && width == other.width &&
           height == other.height && region == other.region;
  }
};

/// A step of refinement.
struct PreviewStep {
  int divider = 1;  ///< The size of the picture is divided by it.
  int samples = 1;
  bool occlusion = false;

  bool operator==(const PreviewStep&) const = default;
};

/// Trees are built once for a scene and shared by all modes and cameras. Not thread-safe; the work
/// itself is parallel. The same steps give the same bytes for any number of threads.
class PreviewRenderer {
 public:
  /// The next picture renders this scene.
  void set_scene(PreviewScenePtr scene);
  bool has_scene() const { return scene_ != nullptr; }

  /// The steps for a request; the first one has a divider for which it takes about `first` seconds,
  /// as far as earlier steps have shown.
  std::vector<PreviewStep> steps(const PreviewRequest& request, double first = 0.05) const;
  /// Throws as render::Session::proceed does; after Error(cancelled) it can be called again.
  Preview render(const PreviewRequest& request, const PreviewStep& step, bool last,
                 Progress& progress = Progress::none());

  /// The picture of the last step with its light denoised; finer ones keep this light until they
  /// are denoised themselves. It is that of the layer `denoised` of `vug render --denoise` with the
  /// same samples. Throws as image::denoise does.
  Preview denoised(const Preview& picture, Progress& progress = Progress::none());

  /// The picture with another display, from the same samples.
  static Preview displayed(const Preview& picture, const DisplayChoice& display);

  const render::SessionCounters& counters() const { return session_.counters(); }

 private:
  /// The last whole picture.
  struct Backdrop {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;
    std::shared_ptr<const image::Image> light;  ///< Null unless it was rendered in Mode::path.
  };

  const render::CameraPtr& camera(const PreviewRequest& request);
  render::Options options(const PreviewRequest& request, const PreviewStep& step) const;

  PreviewScenePtr scene_;
  render::Session session_{render::Learning::kept};
  bool is_new_ = false;  ///< The session does not know the scene yet.
  std::optional<View> camera_view_;
  render::CameraPtr camera_;
  Backdrop backdrop_;
  std::shared_ptr<const image::Image> denoised_;
  int denoised_samples_ = 0;
  double seconds_per_pixel_ = 0;  ///< Measured with one sample; 0: unknown.
};

}  // namespace vug::viewport
