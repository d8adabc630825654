// SPDX-License-Identifier: Apache-2.0
// Prepares a shot for the renderer.
#pragma once

#include <vug/building/flat_scene.h>
#include <vug/picture/picture_file.h>
#include <vug/render/film/partial_render.h>

#include <functional>

namespace vug::picture {

/// Settings that override a render plan.
struct PictureOptions {
  std::string render;  ///< Name of the plan; empty: the first, else defaults.
  std::string camera;  ///< Name of a camera; empty: the plan's, else the camera with the
                       ///< plan's name, else the first, else an outside view of all.
  std::optional<int> spp;
  std::optional<Vec2i> size;
  std::optional<uint64_t> seed;
  std::optional<double> noise;
  std::optional<double> exposure;  ///< Exposure of the PNG in stops.
  // These switch a setting on, whatever the plan says:
  bool full_float = false;  ///< 32-bit colour channels.
  bool multi_part = false;
  bool tiled = false;
  bool denoise = false;
  bool deep = false;
  int eye = 0;  ///< View of a stereo camera: -1 left, 1 right, 0 the centre between both.
  std::vector<std::string> layers;                   ///< Names of AOVs; empty: those of the plan.
  std::optional<image::WorkingSpace> working_space;  ///< Default: that of the plan.
  std::string view, display;
  std::filesystem::path config;  ///< OpenColorIO configuration; empty: none.
  std::vector<int> crop;         ///< Left, top, right and bottom; empty: that of the plan.
  /// Evaluates the same scene at another, possibly fractional, frame, with identical objects for
  /// static plans (see loading::StaticCache). Used for motion blur; without it, nothing is blurred.
  std::function<std::shared_ptr<const shot::Shot>(double frame)> shot_at_frame = nullptr;
};

/// The plan with the options applied. Error(bad_input), with the nearest name, for unknown names.
shot::RenderPlan render_plan(const shot::Shot& shot, const PictureOptions& options);

/// The name of the camera of the plan; empty if the scene has none.
std::string camera_name(const shot::Shot& shot, const shot::RenderPlan& plan);

/// The provenance in a picture's header: the scene text, the seed, the samples per pixel, the
/// version, the frame of an animated scene, and a hash of all other settings. Pictures with equal
/// metadata are equal.
image::Metadata identifying_metadata(const shot::Shot& shot, const PictureOptions& options);

/// Whether the plan's camera is a stereo camera.
bool is_stereo(const shot::Shot& shot, const PictureOptions& options);

/// Builds the renderer's scene: objects, lights, medium and camera. A shot without objects shows
/// its meshes with a grey material; a shot without lights gets a uniform sky.
render::Scene build_scene(building::Builder& builder, const shot::RenderPlan& plan,
                          const building::TimeSamples& time_samples = {});

/// All inputs of a rendering.
struct PictureJob {
  render::Scene scene;
  render::Options options;
  OutputSettings output;
  /// Identifies the picture in partial renders and checkpoints; contains the output settings as
  /// header attributes.
  render::PartialRenderHeader header;
  SourceLocation where;  ///< Location of the plan's name in the text.
};

/// Builds all inputs. `whole_film`: the rendering keeps the sums of all pixels in memory.
/// Error(too_large) for a picture that does not fit into memory.
PictureJob prepare_picture(building::Builder& builder, const PictureOptions& options,
                           bool whole_film);

}  // namespace vug::picture
