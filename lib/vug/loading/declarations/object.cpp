// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>
#include <vug/render/lighting/light_output.h>
#include <vug/shot/cells_plan.h>

#include <fmt/format.h>

namespace vug::loading {
namespace {

struct ObjectBlock : shot::ObjectPlan {
  shot::MeshOrLevelSet of;
};

Schema<ObjectBlock> object_schema() {
  Schema<ObjectBlock> s("object", "declaration");
  s.doc("A mesh with a material, for rendering: object NAME on MESH { material ... }.")
      .param("material", &ObjectBlock::material, {.doc = "material of the surface"})
      .param("flat", &ObjectBlock::flat, {.doc = "shade every face flat"})
      .param(
          "direct", &ObjectBlock::direct,
          {.doc = "trace the level set itself instead of a mesh; needs a fraction of the memory"})
      .param("floating", &ObjectBlock::floating,
             {.doc = "it hangs in mid-air on purpose, e.g. on a rope: no check reports it"})
      .param("emission", &ObjectBlock::emission,
             {.doc = "emitted radiance in W/sr/m^2, on its outer side",
              .min = 0,
              .max = render::kMaxRadiance})
      .param("light_group", &ObjectBlock::light_group,
             {.doc = "light group of its emission, for light group AOVs"})
      .param(
          "detail", &ObjectBlock::detail,
          {.doc = "micro-displacement: dice(...) divides the mesh down to the size of pixels and "
                  "moves it onto the field"})
      .param("of", &ObjectBlock::of,
             {.doc = "one of several meshes with the same cells; default: all of them"});
  return s;
}

/// A conflict of the object with its mesh or material, and a hint; empty if there is none.
std::pair<std::string, std::string> fault(const shot::ObjectPlan& plan, const std::string& name) {
  const bool shines =
      plan.emission.length2() > 0 || (plan.material && plan.material->is_emissive());
  const bool holes = plan.material && plan.material->cut_out();
  if (shines && holes)
    return {fmt::format("'{}' is emissive and its material has an opacity mask", name),
            "split it into two objects, or use emission_mask"};
  if (!plan.direct) return {};
  const std::string hint = "remove 'direct'";
  if (plan.mesh->file_mesh)
    return {fmt::format("'{}' has 'direct', but '{}' is not a mesh of a level set", name,
                        plan.mesh->name),
            hint};
  const char* what = shines             ? "is emissive"
                     : holes            ? "has a material with an opacity mask"
                     : plan.mesh->cells ? "has a cell layer"
                                        : nullptr;
  if (!what) return {};
  return {fmt::format("'{}' {}, for which it needs a mesh", name, what), hint};
}

/// A conflict of the object's detail with its mesh, and a hint; empty if there is none.
std::pair<std::string, std::string> detail_fault(const shot::ObjectPlan& plan) {
  if (!plan.detail) return {};
  if (plan.direct)
    return {fmt::format("'{}' has both 'direct' and 'detail'", plan.name),
            "remove 'direct': detail needs a mesh"};
  if (plan.mesh->cells && plan.mesh->cells->move)
    return {fmt::format("'{}' has 'detail', but cells displace its mesh", plan.name),
            "set 'move false' in the cells, or remove 'detail'"};
  const bool has_field = plan.mesh->volume && !plan.mesh->volume->source_mesh;
  if (!has_field && !plan.detail->field)
    return {fmt::format("'{}' has 'detail', but its mesh is not made from a field", plan.name),
            "name the field: detail dice(field: NAME)"};
  return {};
}

/// The parts of the mesh to show; empty, with a diagnostic, if `of` is not one of them.
std::vector<shot::MeshPtr> shown(const shot::MeshPtr& mesh, const shot::MeshPtr& of,
                                 const scene::Declaration& declaration, ReadContext& context) {
  if (!of) return shot::parts_of(mesh);
  if (const shot::MeshPtr part = shot::part_with_support(mesh, of)) return {part};
  std::vector<std::string> names;
  for (const shot::MeshPtr& part : shot::parts_of(mesh))
    if (part->cells) names.push_back(shot::mesh_without_cells(*part)->name);
  context.diagnostics.error(declaration.find_entry("of")->values.at(0)->where,
                            fmt::format("'{}' is not part of '{}'", of->name, mesh->name),
                            suggestion(of->name, names));
  return {};
}

}  // namespace

const DeclarationKind& object_declaration() {
  static const DeclarationKind kind = {
      object_schema().info(),
      [](const scene::Declaration& declaration, ReadContext& context) -> Value {
        std::optional<ObjectBlock> block = read_block(object_schema(), declaration, context);
        const shot::MeshPtr mesh = read_target<shot::MeshPtr>(declaration, context);
        if (!block || !mesh) return Value();
        for (const shot::MeshPtr& part : shown(mesh, block->of.mesh, declaration, context)) {
          shot::ObjectPlan plan = *block;
          plan.name = declaration.name;
          plan.mesh = part;
          plan.where = declaration.where;
          for (const auto& [problem, hint] : {fault(plan, plan.name), detail_fault(plan)}) {
            if (problem.empty()) continue;
            context.diagnostics.error(declaration.where, problem, hint);
            return Value();
          }
          context.shot.objects.push_back(std::move(plan));
        }
        return Value(Value::Name{declaration.name});
      },
      "mesh"};
  return kind;
}

}  // namespace vug::loading
