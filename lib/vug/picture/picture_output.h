// SPDX-License-Identifier: Apache-2.0
// The data that the writer of a picture needs in addition to the pixels, and their form in partial
// renders.
#pragma once

#include <vug/image/io.h>
#include <vug/image/ocio_view.h>
#include <vug/render/camera.h>
#include <vug/shot/render_settings.h>

#include <filesystem>
#include <optional>

namespace vug::picture {

/// Names in the metadata of a picture with a noise limit: the noise that was reached and the mean
/// number of samples per pixel; see render::NoiseReport.
inline constexpr const char* kNoise = "vug:noise";
inline constexpr const char* kSamples = "vug:samples";

struct PictureOutput {
  shot::OutputSettings settings;
  std::filesystem::path config;  ///< OpenColorIO configuration; empty: none.
  image::Metadata metadata;
  std::optional<render::CameraMatrices> camera;

  image::ViewSelection view() const { return {settings.view, settings.display, config}; }
};

/// Converts the output to attributes of a partial render, so that merging writes the same files,
/// and back.
shot::NamedTexts to_header_attributes(const PictureOutput& output);
PictureOutput from_header_attributes(const shot::NamedTexts& attributes);

}  // namespace vug::picture
