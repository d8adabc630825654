// SPDX-License-Identifier: Apache-2.0
// Writes a rendered picture: the EXR with its AOVs, and the PNG next to it.
#pragma once

#include <vug/base/progress.h>
#include <vug/image/deep.h>
#include <vug/picture/picture_output.h>
#include <vug/render/film/partial_render.h>

#include <filesystem>
#include <vector>

namespace vug::picture {

/// A picture, or one view of a stereo picture.
struct PictureView {
  const image::Image& image;
  const render::PartialRenderHeader& header;  ///< Crop and AOVs.
  const PictureOutput& output;
  const image::DeepImage* deep = nullptr;
};

/// Writes `exr`, the PNG of the same name next to it, and the deep picture if there are deep
/// images; returns their paths. For two views, left and right, the EXRs have parts for each view
/// and the PNG shows them side by side. Error(cancelled).
std::vector<std::filesystem::path> write_picture(const std::filesystem::path& exr,
                                                 const std::vector<PictureView>& views,
                                                 Progress& progress = Progress::none());
/// Writes one of these files: NAME.exr, NAME.png or NAME.deep.exr. Error(bad_input) for other
/// names, and for NAME.deep.exr if the views have no deep image.
void write_picture_file(const std::filesystem::path& file, const std::vector<PictureView>& views);
/// NAME.png for NAME.exr.
std::filesystem::path png_path(const std::filesystem::path& exr);
/// NAME.deep.exr for NAME.exr.
std::filesystem::path deep_path(const std::filesystem::path& exr);

/// Writes only the PNG, in the same way as write_picture.
void write_preview(const std::filesystem::path& png, const image::Image& image,
                   const PictureOutput& output);

}  // namespace vug::picture
