// How a rendered picture is written: the EXR with its layers, and the PNG beside it.
#pragma once

#include <vug/image/deep.h>
#include <vug/image/io.h>
#include <vug/image/ocio_view.h>
#include <vug/render/film/partial_render.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vug::picture {

/// What writing a picture takes beyond its pixels.
struct OutputSettings {
  double exposure = 0;      ///< Stops, for the PNG.
  bool half = true;         ///< 16-bit colour channels in the EXR.
  bool multi_part = false;  ///< A part of the EXR for each layer.
  bool tiled = false;       ///< Tiles instead of lines.
  bool denoise = false;     ///< A further layer, which the PNG shows; see image::denoise.
  image::WorkingSpace space = image::WorkingSpace::rec709;  ///< That the light is in.
  image::ViewSelection view;                                ///< Of the PNG.
  image::Metadata metadata;
  std::optional<render::CameraMatrices> camera;
};

/// The look as notes of a part, so that merging writes the same files, and back.
std::vector<std::pair<std::string, std::string>> to_header_attributes(
    const OutputSettings& settings);
OutputSettings from_header_attributes(
    const std::vector<std::pair<std::string, std::string>>& notes);

/// A picture, or what one of two eyes sees of it.
struct PictureView {
  const image::Image& image;
  const render::PartialRenderHeader& header;  ///< Tells where in the picture the image lies, and its look.
  const image::DeepImage* deep = nullptr;
};

/// Writes `exr`, the PNG of the same name beside it, and where there are deep images the deep
/// picture; returns their paths. Of two views, left and right, the EXRs have parts for each and the
/// PNG shows them side by side.
std::vector<std::filesystem::path> write_picture(const std::filesystem::path& exr,
                                                 const std::vector<PictureView>& views);
/// Writes one of these files: NAME.exr, NAME.png or NAME.deep.exr. Error(bad_input) for other names
/// and for a deep picture of views without one.
void write_picture_file(const std::filesystem::path& file, const std::vector<PictureView>& views);
std::filesystem::path png_path(const std::filesystem::path& exr);
/// NAME.deep.exr.
std::filesystem::path deep_path(const std::filesystem::path& exr);

/// Only the PNG, as write_picture would write it.
void write_preview(const std::filesystem::path& png, const image::Image& image,
                   const render::PartialRenderHeader& header);

}  // namespace vug::picture
