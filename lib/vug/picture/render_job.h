// Pictures that take long: checkpoints, previews, and parts for a farm.
#pragma once

#include <vug/picture/picture.h>

#include <filesystem>
#include <functional>
#include <optional>

namespace vug::picture {

struct RenderOptions {
  PictureOptions picture;
  render::RenderSlice slice;                     ///< Which part; other than all of it only with `part`.
  std::filesystem::path part;              ///< Where a part goes; empty: the picture is wanted.
  std::filesystem::path checkpoint;        ///< Kept up to date while rendering; empty: none.
  std::optional<double> checkpoint_every;  ///< Seconds; none: see render::RenderCallbacks::save_every.
  bool resume = false;                     ///< Go on from the checkpoint if there is one.
  std::filesystem::path preview;           ///< A PNG that shows the picture so far; empty: none.
  /// Told before the rendering what it will take: seconds and bytes, about.
  std::function<void(double seconds, double bytes)> estimate = nullptr;
};

struct RenderResult {
  std::optional<image::Image> image;     ///< None when a part was written.
  std::optional<image::DeepImage> deep;  ///< Where the plan asks for it.
  render::PartialRenderHeader header;
  SourceLocation where;  ///< The plan's name in the text.
};

/// Builds what is needed and renders. A finished render removes its checkpoint only once
/// `remove_checkpoint` is called, when its files are safe. Error(bad_input): a slice without a
/// part; a checkpoint that is there without `resume`, or of another picture or slice.
RenderResult render_picture(building::Builder& builder, const RenderOptions& options);
void remove_checkpoint(const RenderOptions& options);

}  // namespace vug::picture
