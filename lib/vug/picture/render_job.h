// SPDX-License-Identifier: Apache-2.0
// Renders a picture at once or in parts: handles `--checkpoint`, `--resume` and `--part` with their
// files, and previews.
#pragma once

#include <vug/picture/picture.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace vug::render {
struct PreparedRender;
class Session;
}  // namespace vug::render

namespace vug::picture {

struct RenderOptions {
  render::RenderSlice slice;         ///< The slice to render; a proper slice requires `part`.
  std::filesystem::path part;        ///< File of the partial render; empty: render the picture.
  std::filesystem::path checkpoint;  ///< Updated while rendering; empty: none.
  std::optional<double>
      checkpoint_every;  ///< Interval in seconds; default: see render::RenderCallbacks::save_every.
  bool resume = false;   ///< Continue from the checkpoint if it exists.
  std::filesystem::path preview;  ///< PNG of the picture so far; empty: none.
  /// File of the learned light, for all parts of the picture: read if it exists, else written.
  /// Empty: none.
  std::filesystem::path guiding;
  /// Called before the rendering with its approximate time in seconds and memory in bytes.
  std::function<void(double seconds, double bytes)> estimate = nullptr;
  /// With a noise limit: see render::RenderCallbacks::noise.
  std::function<void(const render::NoiseReport& report, double seconds)> noise = nullptr;
  /// Renders the picture and keeps trees, learned light and samples for the next one, whose picture
  /// has the same bytes with and without it. Null: none; else without files of parts, checkpoints,
  /// previews and guiding.
  render::Session* session = nullptr;
  /// With a session: called with a small picture of one sample per pixel, scaled to the size of the
  /// picture, and then with the picture after 4, 8, 16, ... samples; not if it is known already.
  std::function<void(const image::Image& image, const PictureOutput& output)> unfinished = nullptr;
  /// Called before the rendering with all that it reads.
  std::function<void(const render::PreparedRender&)> inspect = nullptr;
};

/// A rendered picture; without an image if a partial render was written.
struct RenderResult {
  std::optional<image::Image> image;     ///< None if a partial render was written.
  std::optional<image::DeepImage> deep;  ///< Only if the plan requests it.
  render::PartialRenderHeader header;    ///< Crop and AOVs; without the identity.
  PictureOutput output;
  SourceLocation where;  ///< Location of the plan's name in the text.
};

/// Builds the scene and renders it. Call `remove_checkpoint` after the files of a finished render
/// have been written. Error(bad_input): a slice without `part`; a checkpoint that exists without
/// `resume`, or that belongs to another picture or slice; a guiding file of another picture.
RenderResult render_picture(building::Builder& builder, const PicturePlan& plan,
                            const RenderOptions& options = {});
void remove_checkpoint(const RenderOptions& options);

/// Learns the light of the picture and writes it to the guiding file, unless the file exists and
/// belongs to this picture. Throws as render_picture does.
void learn_light(building::Builder& builder, const PicturePlan& plan,
                 const std::filesystem::path& guiding);

/// Renders several parts of one picture, which share its scene, ray trees, learned light and bright
/// edges. Each file has the bytes that render_picture writes.
class PartRenderer {
 public:
  /// Builds the scene. `guiding`: see RenderOptions. The builder must outlive this object. Throws
  /// as render_picture does.
  PartRenderer(building::Builder& builder, const PicturePlan& plan,
               const std::filesystem::path& guiding);
  ~PartRenderer();
  PartRenderer(const PartRenderer&) = delete;
  PartRenderer& operator=(const PartRenderer&) = delete;

  /// Renders the slice of the options, writes its part, and removes its checkpoint. The options
  /// have neither a session nor a preview nor a guiding file of their own. Throws as render_picture
  /// does; other parts can be rendered after an error.
  void render(const RenderOptions& options);

  /// Times that the ray trees, light and edges were prepared: once for all parts of equal pixels.
  size_t preparations() const;

 private:
  struct Picture;
  std::unique_ptr<Picture> picture_;
};

}  // namespace vug::picture
