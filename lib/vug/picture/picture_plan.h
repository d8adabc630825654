// SPDX-License-Identifier: Apache-2.0
// The choice of a picture, its camera and its settings, resolved once before the work starts.
#pragma once

#include <vug/image/io.h>
#include <vug/loading/scene_source.h>
#include <vug/shot/shot.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace vug::picture {

/// Chooses a picture of a scene.
struct PictureOptions {
  std::string render;  ///< Name of the render block; empty: the first, else defaults.
  std::string camera;  ///< Name of a camera; empty: the plan's, else the camera with the
                       ///< plan's name, else the first, else an outside view of all.
  int eye = 0;         ///< View of a stereo camera: -1 left, 1 right, 0 the centre between both.
  std::optional<uint64_t> seed;  ///< Seed of the samples; none: that of the scene.
  std::filesystem::path config;  ///< OpenColorIO configuration; empty: none.
  /// Settings that replace those of the render block, such as {{"spp", 16}, {"tiled", true}}; see
  /// shot::RenderSettings.
  NamedValues settings;
  /// The source of the same shot at other frames, used for motion blur; null: nothing is blurred.
  const loading::SceneSource* source = nullptr;
};

/// A render block in which all options have been applied.
struct PicturePlan {
  shot::RenderPlan render;
  PictureOptions options;
  std::shared_ptr<const shot::Shot> shown;  ///< The part of the shot that the picture shows.

  /// The option that replaced a setting, such as "--layers"; empty if it has the scene's value.
  std::string option_for(const std::string& setting) const;
};

/// The shot must outlive the plan. Error(bad_input), with the nearest name, for unknown names and
/// for invalid settings.
PicturePlan plan_picture(const shot::Shot& shot, const PictureOptions& options = {});

/// The camera of the same picture in another shot of the scene; null for an outside view.
render::CameraPtr camera_in(const shot::Shot& shot, const PicturePlan& plan);

/// The name of the camera of the plan; empty if the scene has none.
std::string camera_name(const shot::Shot& shot, const shot::RenderPlan& plan);

/// Whether the plan's camera is a stereo camera.
bool is_stereo(const PicturePlan& plan);

/// The provenance in a picture's header: the scene text, the seed, the samples per pixel, the
/// version, the frame of an animated scene, and a hash of all other settings. Pictures with equal
/// metadata are equal.
image::Metadata identifying_metadata(const shot::Shot& shot, const PicturePlan& plan);

}  // namespace vug::picture
