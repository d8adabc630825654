#include <vug/session/reader.h>

namespace vug::session {
namespace {

Schema<ObjectPlan> schema() {
  Schema<ObjectPlan> s("object", "declaration");
  s.doc("A mesh as the picture shows it: object NAME on MESH { material ... }.")
      .param("material", &ObjectPlan::material, {.doc = "what it is made of"})
      .param("flat", &ObjectPlan::flat, {.doc = "shade every face flat"})
      .param(
          "emission", &ObjectPlan::emission,
          {.doc = "radiance that it shines with itself, in W/sr/m^2, from its outside", .min = 0});
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
        plan->name = declaration.name;
        plan->mesh = mesh;
        reading.shot.objects.push_back(std::move(*plan));
        return Value(Value::Name{declaration.name});
      },
      "mesh"};
  return kind;
}

}  // namespace vug::session
