// A shot as the renderer sees it.
#pragma once

#include <vug/image/io.h>
#include <vug/render/render.h>
#include <vug/session/build.h>

namespace vug::session {

/// What the command line may change about a render plan.
struct PictureOptions {
  std::string render;  ///< Name of the plan; empty: the first, or defaults without any.
  std::string camera;  ///< Name of a camera; empty: the plan's, else the one named like the
                       ///< plan, else the first, else one that sees all from outside.
  std::optional<int> spp;
  std::optional<Vec2i> size;
  std::optional<uint64_t> seed;
};

struct Picture {
  image::Image image;
  RenderPlan plan;
  image::Metadata metadata;  ///< Recipe, seed, samples.
};

/// The plan with the options applied; Error(bad_input) with the nearest name for unknown ones.
RenderPlan render_plan(const Shot& shot, const PictureOptions& options);

/// Meshes, materials, lamps and air. A shot without objects shows its meshes in grey; one without
/// lights gets a soft sky.
render::Scene assemble(Builder& builder, const RenderPlan& plan);

/// Builds what is needed and renders it.
Picture render_picture(Builder& builder, const PictureOptions& options);

}  // namespace vug::session
