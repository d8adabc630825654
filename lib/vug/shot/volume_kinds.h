// SPDX-License-Identifier: Apache-2.0
// The kinds of volumes and the parameters that they share.
#pragma once

#include <vug/shot/plan_values.h>

namespace vug::shot {

const Kinds<VolumePtr>& volume_kinds();

/// The schema of the parameters of all volumes: field, voxel, half_width, half, from, to,
/// caps.
Schema<VolumePlan> volume_schema(std::string name, std::string doc);

/// The kind of volume with that schema: a fog if `fog`, else a level set.
Kind<VolumePtr> volume_kind(Schema<VolumePlan> schema, bool fog);

}  // namespace vug::shot
