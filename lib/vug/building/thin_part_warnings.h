// SPDX-License-Identifier: Apache-2.0
// The text of warnings about parts of a volume that its voxels do not resolve; field/thin_parts.h
// finds them.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/shot/shot.h>

namespace vug::building {

/// A warning for each text that made parts thinner than a voxel, at most five, with the name,
/// place and thickness of the thinnest part. `where_of` is the text that made a node; where it is
/// null or does not know the node, the location is that of the volume.
Diagnostics thin_part_warnings(
    const shot::VolumePlan& plan,
    const std::function<SourceLocation(const field::NodePtr&)>& where_of);

}  // namespace vug::building
