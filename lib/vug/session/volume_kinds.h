// The kinds of volumes a scene can declare; made from the list in CMakeLists.txt.
#pragma once

#include <vug/session/objects.h>

namespace vug::session {

#define VUG_KIND(name) const Kind<VolumePtr>& name##_volume();
#include <vug/session/volumes_kinds.inc>
#undef VUG_KIND

const std::vector<const Kind<VolumePtr>*>& volume_kinds();

/// The parameters every volume has: field, voxel, half_width, half, from, to.
Schema<VolumePlan> volume_schema(std::string name, std::string doc);

/// A kind that binds the schema's parameters over `defaults`.
Kind<VolumePtr> volume_kind(Schema<VolumePlan> schema, bool fog);

}  // namespace vug::session
