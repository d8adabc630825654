#include <vug/session/reader.h>

namespace vug::session {
namespace {

Schema<RenderPlan> schema() {
  Schema<RenderPlan> s("render", "declaration");
  s.doc("How the picture is made: render NAME { size 1920x1080  spp 256 }.")
      .param("size", &RenderPlan::size,
             {.doc = "width and height in pixels, as 1920x1080", .min = 1, .max = 65535})
      .param("spp", &RenderPlan::spp, {.doc = "samples per pixel", .min = 1, .max = 1 << 20})
      .param("exposure", &RenderPlan::exposure,
             {.doc = "stops, for the PNG only", .min = -30, .max = 30})
      .param("half", &RenderPlan::half, {.doc = "store colours as 16-bit floats"})
      .param("camera", &RenderPlan::camera,
             {.doc = "a declared camera; else the one named like the render, else the first"})
      .param("sampler", &RenderPlan::sampler, {.doc = "where samples fall; else sobol"})
      .param("integrator", &RenderPlan::integrator,
             {.doc = "how light is followed, as path(max_bounces: 6); else path()"});
  return s;
}

}  // namespace

const DeclarationKind& render_declaration() {
  static const DeclarationKind kind = {
      schema().info(), [](const scene::Declaration& declaration, Reading& reading) -> Value {
        std::optional<RenderPlan> plan = read_block(schema(), declaration, reading);
        if (!plan) return Value();
        if (plan->size.size() != 2) {
          for (const scene::Entry& entry : declaration.entries)
            if (entry.key == "size")
              reading.diagnostics.error(entry.where, "'size' is a width and a height",
                                        "size 1920x1080");
          return Value();
        }
        plan->name = declaration.name;
        plan->where = declaration.where;
        reading.shot.renders.push_back(std::move(*plan));
        return Value(Value::Name{declaration.name});
      }};
  return kind;
}

}  // namespace vug::session
