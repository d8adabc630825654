#include <vug/mesh/format.h>
#include <vug/paint/kind.h>
#include <vug/session/reader.h>

namespace vug::session {
namespace {

std::vector<std::pair<std::string, std::string>> formats() {
  std::vector<std::pair<std::string, std::string>> names;
  for (const mesh::Format* format : mesh::formats())
    names.emplace_back(format->info.name, format->info.name);
  return names;
}

Schema<MeshPlan> schema() {
  Schema<MeshPlan> s("mesh", "declaration");
  s.doc("A triangle mesh of a level set, written beside the .vdb: mesh NAME on VOLUME { ... }.")
      .param("adaptivity", &MeshPlan::adaptivity,
             {.doc = "0 keeps every face, 1 merges faces that are nearly flat", .min = 0, .max = 1})
      .param("polish", &MeshPlan::polish,
             {.doc = "move vertices onto the exact field, keep creases"})
      .param("smallest_piece", &MeshPlan::smallest_piece,
             {.doc = "leave out crumbs and closed bubbles whose box has a shorter diagonal",
              .dimension = Dimension::length,
              .min = 0})
      .param("paint", &MeshPlan::paint, {.doc = "its vertex colours: a paint or one colour"})
      .choice("format", &MeshPlan::format, formats(), "the file that is written");
  return s;
}

}  // namespace

const DeclarationKind& mesh_declaration() {
  static const DeclarationKind kind = {
      schema().info(),
      [](const scene::Declaration& declaration, Reading& reading) -> Value {
        std::optional<MeshPlan> plan = read_block(schema(), declaration, reading);
        const VolumePtr volume = read_target<VolumePtr>(declaration, reading);
        if (!plan || !volume) return Value();
        if (volume->fog) {
          reading.diagnostics.error(declaration.where,
                                    "a mesh is made of a level set, not of a fog");
          return Value();
        }
        plan->name = declaration.name;
        plan->volume = volume;
        const MeshPtr made = std::make_shared<const MeshPlan>(std::move(*plan));
        reading.shot.meshes.push_back(made);
        return Object{"mesh", made};
      },
      "volume"};
  return kind;
}

}  // namespace vug::session
