// The kinds of volumes a scene can declare; made from the list in CMakeLists.txt.
#pragma once

#include <vug/shot/plan_values.h>

namespace vug::shot {

const Kinds<VolumePtr>& volume_kinds();

/// The parameters every volume has: field, voxel, half_width, half, from, to.
Schema<VolumePlan> volume_schema(std::string name, std::string doc);

/// The kind that declares what the schema binds, as a level set or as a fog.
Kind<VolumePtr> volume_kind(Schema<VolumePlan> schema, bool fog);

}  // namespace vug::shot
