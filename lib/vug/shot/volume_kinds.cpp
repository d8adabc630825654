// SPDX-License-Identifier: Apache-2.0
#include <vug/field/kind.h>
#include <vug/shot/volume_kinds.h>

namespace vug::shot {

std::string VolumePlan::fault() const {
  if (from.has_value() != to.has_value()) return "'from' and 'to' must be given together";
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
      .param("to", &VolumePlan::to, any_length("highest corner of the region to keep"));
  return s;
}

Kind<VolumePtr> volume_kind(Schema<VolumePlan> schema, bool fog) {
  return make_kind<VolumePtr>(std::move(schema), [fog](VolumePlan plan) {
    plan.fog = fog;
    return std::make_shared<const VolumePlan>(std::move(plan));
  });
}

}  // namespace vug::shot
