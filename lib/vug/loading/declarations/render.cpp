// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>

namespace vug::loading {
namespace {

std::vector<std::pair<std::string, image::WorkingSpace>> spaces() {
  std::vector<std::pair<std::string, image::WorkingSpace>> names;
  for (const image::WorkingSpaceInfo& each : image::working_spaces())
    names.emplace_back(each.name, each.space);
  return names;
}

Schema<shot::RenderPlan> schema() {
  Schema<shot::RenderPlan> s("render", "declaration");
  s.doc("The settings of a picture: render NAME { size 1920x1080  spp 256 }.")
      .param("size", &shot::RenderPlan::size,
             {.doc = "width and height in pixels, as 1920x1080", .min = 1, .max = 65535})
      .param("spp", &shot::RenderPlan::spp, {.doc = "samples per pixel", .min = 1, .max = 1 << 20})
      .param("exposure", &shot::RenderPlan::exposure,
             {.doc = "exposure of the PNG in stops", .min = -30, .max = 30})
      .param("half", &shot::RenderPlan::half, {.doc = "store colours as 16-bit floats"})
      .param("multi_part", &shot::RenderPlan::multi_part,
             {.doc = "one part of the EXR per AOV, instead of a single part"})
      .param("tiled", &shot::RenderPlan::tiled, {.doc = "write a tiled EXR instead of scan lines"})
      .param("deep", &shot::RenderPlan::deep,
             {.doc = "write a deep EXR in addition, named .deep.exr"})
      .param("deep_tolerance", &shot::RenderPlan::deep_tolerance,
             {.doc = "merge surfaces of a pixel whose relative difference in depth is below this",
              .min = 0,
              .max = 1})
      .param("noise", &shot::RenderPlan::noise,
             {.doc = "stop sampling where the relative error is below this, such as 5%; 0: never",
              .min = 0,
              .max = 1})
      .param(
          "openings", &shot::RenderPlan::openings,
          {.doc = "sample the openings through which the sky shines in, if no portal is declared; "
                  "affects only the noise"})
      .param(
          "layers", &shot::RenderPlan::layers,
          {.doc =
               "names of AOVs, such as [\"beauty\", \"Z\"], or \"all\"; default: the usual AOVs"})
      .param("crop", &shot::RenderPlan::crop,
             {.doc = "left, top, right and bottom in pixels of the part to render",
              .min = 0,
              .max = 65535})
      .param("camera", &shot::RenderPlan::camera,
             {.doc = "a declared camera; default: the camera with the name of the render, else the "
                     "first"})
      .choice("working_space", &shot::RenderPlan::working_space, spaces(),
              "primaries of the light computation and of the EXR: those of linear Rec.709 or of "
              "ACEScg; colours in the text are always Rec.709")
      .param("view", &shot::RenderPlan::view,
             {.doc = "display transform of the PNG: filmic, standard, aces, or a view of the "
                     "OpenColorIO configuration; default: filmic, or that of the configuration"})
      .param("display", &shot::RenderPlan::display,
             {.doc = "a display of the OpenColorIO configuration; default: its default display"})
      .param("sampler", &shot::RenderPlan::sampler,
             {.doc = "sampler of random numbers; default: sobol"})
      .param("integrator", &shot::RenderPlan::integrator,
             {.doc = "integrator, such as path(max_bounces: 6); default: path()"});
  return s;
}

}  // namespace

const DeclarationKind& render_declaration() {
  static const DeclarationKind kind = {
      schema().info(), [](const scene::Declaration& declaration, ReadContext& context) -> Value {
        std::optional<shot::RenderPlan> plan = read_block(schema(), declaration, context);
        if (!plan) return Value();
        const auto refuse = [&](const char* key, const char* what, const char* hint) {
          for (const scene::Entry& entry : declaration.entries)
            if (entry.key == key) context.diagnostics.error(entry.where, what, hint);
          return Value();
        };
        if (plan->size.size() != 2)
          return refuse("size", "'size' must be a width and a height", "size 1920x1080");
        if (!plan->crop.empty() && plan->crop.size() != 4)
          return refuse("crop", "'crop' must be left, top, right and bottom",
                        "crop [0, 0, 960, 540]");
        plan->name = declaration.name;
        plan->where = declaration.where;
        context.shot.renders.push_back(std::move(*plan));
        return Value(Value::Name{declaration.name});
      }};
  return kind;
}

}  // namespace vug::loading
