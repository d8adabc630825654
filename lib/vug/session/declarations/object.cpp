#include <vug/session/reader.h>

#include <fmt/format.h>

namespace vug::session {
namespace {

Schema<ObjectPlan> schema() {
  Schema<ObjectPlan> s("object", "declaration");
  s.doc("A mesh as the picture shows it: object NAME on MESH { material ... }.")
      .param("material", &ObjectPlan::material, {.doc = "what it is made of"})
      .param("flat", &ObjectPlan::flat, {.doc = "shade every face flat"})
      .param("direct", &ObjectPlan::direct,
             {.doc = "trace the level set itself and make no mesh: a fraction of the memory"})
      .param(
          "emission", &ObjectPlan::emission,
          {.doc = "radiance that it shines with itself, in W/sr/m^2, from its outside", .min = 0})
      .param("light_group", &ObjectPlan::light_group,
             {.doc = "group of its light in the picture's layers of lights"});
  return s;
}

}  // namespace

const DeclarationKind& object_declaration() {
  static const DeclarationKind kind = {
      schema().info(),
      [](const scene::Declaration& declaration, Reading& reading) -> Value {
        std::optional<ObjectPlan> plan = read_block(schema(), declaration, reading);
        const MeshPtr mesh = read_target<MeshPtr>(declaration, reading);
        if (!plan || !mesh) return Value();
        const bool shines =
            plan->emission.length2() > 0 || (plan->material && plan->material->shines());
        if (plan->direct && shines) {
          reading.diagnostics.error(
              declaration.where,
              fmt::format("'{}' shines, for which it needs a mesh", declaration.name),
              "leave out 'direct'");
          return Value();
        }
        if (plan->direct && mesh->cells) {
          reading.diagnostics.error(
              declaration.where,
              fmt::format("'{}' wears cells, for which it needs a mesh", declaration.name),
              "leave out 'direct'");
          return Value();
        }
        plan->name = declaration.name;
        plan->mesh = mesh;
        reading.shot.objects.push_back(std::move(*plan));
        return Value(Value::Name{declaration.name});
      },
      "mesh"};
  return kind;
}

}  // namespace vug::session
