// How a rendered picture is written: the EXR with its layers, and the PNG beside it.
#pragma once

#include <vug/image/configured_view.h>
#include <vug/image/deep.h>
#include <vug/image/io.h>
#include <vug/render/part.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vug::session {

/// What writing a picture takes beyond its pixels.
struct PictureLook {
  double exposure = 0;      ///< Stops, for the PNG.
  bool half = true;         ///< 16-bit colour channels in the EXR.
  bool multi_part = false;  ///< A part of the EXR for each layer.
  bool tiled = false;       ///< Tiles instead of lines.
  bool denoise = false;     ///< A further layer, which the PNG shows; see image::denoise.
  image::WorkingSpace space = image::WorkingSpace::rec709;  ///< That the light is in.
  image::ViewChoice view;                                   ///< Of the PNG.
  image::Metadata metadata;
  std::optional<render::CameraMatrices> camera;
};

/// The look as notes of a part, so that merging writes the same files, and back.
std::vector<std::pair<std::string, std::string>> to_notes(const PictureLook& look);
PictureLook from_notes(const std::vector<std::pair<std::string, std::string>>& notes);

/// Writes `exr` and the PNG of the same name beside it; returns both paths. The header tells where
/// in the picture the image lies.
std::vector<std::filesystem::path> write_picture(const std::filesystem::path& exr,
                                                 const image::Image& image,
                                                 const render::PartHeader& header);
/// The same of the views of the left and of the right eye: the EXR has a part for each, the PNG
/// shows them side by side.
std::vector<std::filesystem::path> write_stereo(const std::filesystem::path& exr,
                                                const image::Image& left, const image::Image& right,
                                                const render::PartHeader& left_header,
                                                const render::PartHeader& right_header);
std::filesystem::path png_beside(const std::filesystem::path& exr);

/// The deep picture beside `exr`, as NAME.deep.exr; returns its name.
std::filesystem::path deep_beside(const std::filesystem::path& exr);
std::filesystem::path write_deep(const std::filesystem::path& exr, const image::DeepImage& deep,
                                 const render::PartHeader& header);

/// Only the PNG, as write_picture would write it.
void write_preview(const std::filesystem::path& png, const image::Image& image,
                   const render::PartHeader& header);

}  // namespace vug::session
