// SPDX-License-Identifier: Apache-2.0
#include <vug/field/kind.h>
#include <vug/shot/volume_kinds.h>

namespace vug::shot {
namespace {

/// A wall that the lattice resolves and the band of a level set fits into.
constexpr double kCapVoxels = 3;

}  // namespace

std::string VolumePlan::fault() const {
  if (from.has_value() != to.has_value()) return "'from' and 'to' must be given together";
  if (caps.any() && !from) return "'caps' closes faces of the region, so it needs 'from' and 'to'";
  const Box3d& bounds = field.bounds();
  if (!from && !bounds.isEmpty() && !is_finite(bounds))
    return "an unbounded solid needs 'from' and 'to', or a box to clip it";
  if (!from) return {};
  for (int axis = 0; axis < 3; ++axis)
    if ((*from)[axis] >= (*to)[axis]) return "'to' must be greater than 'from' on every axis";
  return {};
}

Schema<VolumePlan> volume_schema(std::string name, std::string doc) {
  Schema<VolumePlan> s(std::move(name), "volume");
  s.doc(std::move(doc))
      .param("field", &VolumePlan::field, {.doc = "the solid", .required = true})
      .param("voxel", &VolumePlan::voxel, positive_length("edge of a voxel"))
      .param("half_width", &VolumePlan::half_width,
             {.doc = "voxels kept on each side of the surface", .min = 3, .max = 100})
      .param("half", &VolumePlan::half, {.doc = "store 16-bit floats"})
      .param("from", &VolumePlan::from, any_length("lowest corner of the region to keep"))
      .param("to", &VolumePlan::to, any_length("highest corner of the region to keep"))
      .param("caps", &VolumePlan::caps,
             {.doc = "faces of the region that a wall of rock, three voxels thick, closes, such as "
                     "[-X, +X]; at the others the air is open to the outside"});
  return s;
}

Kind<VolumePtr> volume_kind(Schema<VolumePlan> schema, bool fog) {
  return make_kind<VolumePtr>(std::move(schema), [fog](VolumePlan plan) {
    plan.fog = fog;
    if (plan.caps.any())
      plan.field =
          with_caps(plan.field, plan.caps, {*plan.from, *plan.to}, kCapVoxels * plan.voxel);
    return std::make_shared<const VolumePlan>(std::move(plan));
  });
}

}  // namespace vug::shot
