// A shot as the renderer sees it.
#pragma once

#include <vug/render/part.h>
#include <vug/session/build.h>
#include <vug/session/picture_file.h>

namespace vug::session {

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
  std::vector<std::string> layers;                   ///< Instead of the plan's.
  std::optional<image::WorkingSpace> working_space;  ///< Likewise, and so are these names.
  std::string view, display;
  std::filesystem::path config;  ///< Of OpenColorIO; empty: none.
  std::vector<int> crop;         ///< Likewise.
};

/// The plan with the options applied; Error(bad_input) with the nearest name for unknown ones.
RenderPlan render_plan(const Shot& shot, const PictureOptions& options);

/// Meshes, materials, lamps and air. A shot without objects shows its meshes in grey; one without
/// lights gets a soft sky.
render::Scene assemble(Builder& builder, const RenderPlan& plan);

/// Everything that a picture needs, ready to be rendered.
struct PictureJob {
  render::Scene scene;
  render::Options options;
  PictureLook look;
  /// What makes it this picture and no other, for parts of it. With everything in its notes that
  /// writing the picture takes.
  render::PartHeader header;
  SourceLocation where;  ///< The plan's name in the text.
};

/// Builds what is needed; `whole_film`: the rendering will hold the sums of all pixels. Refuses
/// what does not fit into memory.
PictureJob prepare_picture(Builder& builder, const PictureOptions& options, bool whole_film);

}  // namespace vug::session
