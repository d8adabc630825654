// A shot as the renderer sees it.
#pragma once

#include <vug/building/flat_scene.h>
#include <vug/picture/picture_file.h>
#include <vug/render/film/partial_render.h>

#include <functional>

namespace vug::picture {

/// What the command line may change about a render plan.
struct PictureOptions {
  std::string render;  ///< Name of the plan; empty: the first, or defaults without any.
  std::string camera;  ///< Name of a camera; empty: the plan's, else the one named like the
                       ///< plan, else the first, else one that sees all from outside.
  std::optional<int> spp;
  std::optional<Vec2i> size;
  std::optional<uint64_t> seed;
  std::optional<double> noise;
  std::optional<double> exposure;  ///< Stops; for the PNG only.
  // Whatever the plan says:
  bool full_float = false;  ///< 32-bit colour channels.
  bool multi_part = false;
  bool tiled = false;
  bool denoise = false;
  bool deep = false;
  int eye = 0;  ///< Of a camera for stereo: -1 left, 1 right; 0: the middle between both.
  std::vector<std::string> layers;                   ///< Instead of the plan's.
  std::optional<image::WorkingSpace> working_space;  ///< Likewise, and so are these names.
  std::string view, display;
  std::filesystem::path config;  ///< Of OpenColorIO; empty: none.
  std::vector<int> crop;         ///< Likewise.
  /// The same scene at another frame, or between frames, with the same objects for what stands
  /// still (see Still): asked while the shutter is open. Without it nothing is blurred by motion.
  std::function<std::shared_ptr<const shot::Shot>(double frame)> shot_at_frame = nullptr;
};

/// The plan with the options applied; Error(bad_input) with the nearest name for unknown ones.
shot::RenderPlan render_plan(const shot::Shot& shot, const PictureOptions& options);

/// The name of the camera that the plan's picture is taken with; empty without any.
std::string camera_name(const shot::Shot& shot, const shot::RenderPlan& plan);

/// What a picture's header says of where it comes from: the text, the seed, the samples, the
/// version, the frame where the scene moves, and a hash of every other setting. Pictures that agree
/// in all of it show the same.
image::Metadata identifying_metadata(const shot::Shot& shot, const PictureOptions& options);

/// Whether the plan's camera is one for stereo.
bool is_stereo(const shot::Shot& shot, const PictureOptions& options);

/// Meshes, materials, lights and air. A shot without objects shows its meshes in grey; one without
/// lights gets a soft sky.
render::Scene build_scene(building::Builder& builder, const shot::RenderPlan& plan,
                          const building::TimeSamples& time_samples = {});

/// Everything that a picture needs, ready to be rendered.
struct PictureJob {
  render::Scene scene;
  render::Options options;
  OutputSettings output;
  /// What makes it this picture and no other, for parts of it. With everything in its notes that
  /// writing the picture takes.
  render::PartialRenderHeader header;
  SourceLocation where;  ///< The plan's name in the text.
};

/// Builds what is needed; `whole_film`: the rendering will hold the sums of all pixels. Refuses
/// what does not fit into memory.
PictureJob prepare_picture(building::Builder& builder, const PictureOptions& options,
                           bool whole_film);

}  // namespace vug::picture
