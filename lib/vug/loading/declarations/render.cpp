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
  s.doc("How the picture is made: render NAME { size 1920x1080  spp 256 }.")
      .param("size", &shot::RenderPlan::size,
             {.doc = "width and height in pixels, as 1920x1080", .min = 1, .max = 65535})
      .param("spp", &shot::RenderPlan::spp, {.doc = "samples per pixel", .min = 1, .max = 1 << 20})
      .param("exposure", &shot::RenderPlan::exposure,
             {.doc = "stops, for the PNG only", .min = -30, .max = 30})
      .param("half", &shot::RenderPlan::half, {.doc = "store colours as 16-bit floats"})
      .param("multi_part", &shot::RenderPlan::multi_part,
             {.doc = "a part of the EXR for each layer, instead of all in one"})
      .param("tiled", &shot::RenderPlan::tiled, {.doc = "tiles in the EXR, instead of lines"})
      .param("deep", &shot::RenderPlan::deep,
             {.doc = "also a deep EXR, named .deep.exr: what is seen at which depth"})
      .param("deep_tolerance", &shot::RenderPlan::deep_tolerance,
             {.doc = "surfaces of a pixel this far apart, as a part of their depth, are one there",
              .min = 0,
              .max = 1})
      .param("noise", &shot::RenderPlan::noise,
             {.doc = "stop sampling where the relative error is below this, as 5%; 0: never",
              .min = 0,
              .max = 1})
      .param("openings", &shot::RenderPlan::openings,
             {.doc = "look first where an even sky shines in, when no portal tells; only the noise "
                     "depends on it"})
      .param(
          "layers", &shot::RenderPlan::layers,
          {.doc = "names of layers, as [\"beauty\", \"Z\"], or \"all\"; without, the usual ones"})
      .param(
          "crop", &shot::RenderPlan::crop,
          {.doc = "left, top, right and bottom in pixels: only that part", .min = 0, .max = 65535})
      .param("camera", &shot::RenderPlan::camera,
             {.doc = "a declared camera; else the one named like the render, else the first"})
      .choice("working_space", &shot::RenderPlan::working_space, spaces(),
              "the primaries that light is computed with and the EXR holds: those of linear "
              "Rec.709, or ACEScg's; colours of the text stay Rec.709")
      .param("view", &shot::RenderPlan::view,
             {.doc = "how the PNG shows the light: filmic, standard, aces, or a view of the "
                     "OpenColorIO configuration; else filmic, or the configuration's default"})
      .param("display", &shot::RenderPlan::display,
             {.doc = "a display of the OpenColorIO configuration; else its default"})
      .param("sampler", &shot::RenderPlan::sampler, {.doc = "where samples fall; else sobol"})
      .param("integrator", &shot::RenderPlan::integrator,
             {.doc = "how light is followed, as path(max_bounces: 6); else path()"});
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
          return refuse("size", "'size' is a width and a height", "size 1920x1080");
        if (!plan->crop.empty() && plan->crop.size() != 4)
          return refuse("crop", "'crop' is left, top, right and bottom", "crop [0, 0, 960, 540]");
        plan->name = declaration.name;
        plan->where = declaration.where;
        context.shot.renders.push_back(std::move(*plan));
        return Value(Value::Name{declaration.name});
      }};
  return kind;
}

}  // namespace vug::loading
