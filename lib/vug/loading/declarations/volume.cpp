// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>

namespace vug::loading {
namespace {

/// The block of `on MESH { ... }`; the default voxel is that of the mesh's own level set.
struct OnMesh {
  double voxel = 0;
  double half_width = 3;
  bool half = false;
};

Schema<OnMesh> volume_schema() {
  Schema<OnMesh> s("volume", "declaration");
  s.param("voxel", &OnMesh::voxel, positive_length("edge of a voxel"))
      .param("half_width", &OnMesh::half_width,
             {.doc = "voxels kept on each side of the surface", .min = 3, .max = 100})
      .param("half", &OnMesh::half, {.doc = "store 16-bit floats"});
  return s;
}

/// The smallest voxel of the level sets of the mesh; 0 if it has none.
double voxel_of(const shot::MeshPlan& mesh) {
  double voxel = mesh.volume ? mesh.volume->voxel : 0;
  for (const auto& part : mesh.parts)
    if (const double own = voxel_of(*part); own > 0 && !(voxel > 0 && voxel < own)) voxel = own;
  return voxel;
}

shot::VolumePtr read_on_mesh(const scene::Declaration& declaration, ReadContext& context) {
  const auto block = read_block(volume_schema(), declaration, context);
  const shot::MeshPtr mesh = read_target<shot::MeshPtr>(declaration, context);
  if (!block || !mesh) return nullptr;
  shot::VolumePlan plan;
  plan.source_mesh = mesh;
  plan.voxel = block->voxel > 0 ? block->voxel : voxel_of(*mesh);
  plan.half_width = block->half_width;
  plan.half = block->half;
  if (plan.voxel > 0) return std::make_shared<const shot::VolumePlan>(std::move(plan));
  context.diagnostics.error(declaration.where, "'volume' needs 'voxel'",
                            "voxel: edge of a voxel, for instance 2cm");
  return nullptr;
}

}  // namespace

const DeclarationKind& volume_declaration() {
  static const DeclarationKind kind = {
      kind_declaration_info(
          "volume",
          "A grid of the scene's .vdb file: volume NAME = level_set(...), or a level set of "
          "a closed mesh: volume NAME on MESH { voxel 2cm }.",
          "volume", "level_set"),
      [](const scene::Declaration& declaration, ReadContext& context) -> Value {
        shot::VolumePtr plan;
        if (declaration.target) {
          plan = read_on_mesh(declaration, context);
        } else {
          const Value value = read_kind_declaration("volume", "level_set", declaration, context);
          if (const shot::VolumePtr* read = value.object<shot::VolumePtr>()) plan = *read;
        }
        if (!plan) return Value();
        auto named = std::make_shared<shot::VolumePlan>(*plan);
        named->name = declaration.name;
        named->where = declaration.where;
        context.shot.volumes.push_back(named);
        return Object{"volume", shot::VolumePtr(named)};
      },
      "mesh"};
  return kind;
}

}  // namespace vug::loading
