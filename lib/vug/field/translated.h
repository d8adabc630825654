// SPDX-License-Identifier: Apache-2.0
// Fields moved in double precision, for evaluation near the origin.
#pragma once

#include <vug/field/field.h>

namespace vug::field {

/// The solid moved by a vector, which nodes add to the positions of their parts in double precision
/// (Node::translated). A part that was far away and is near the origin now is then evaluated in
/// single precision as accurately as if it had always been there. Nodes that do not support this
/// are evaluated at moved points, rounded to single precision.
NodePtr translated(const NodePtr& node, const Vec3d& by);
Field translated(const Field& field, const Vec3d& by);

}  // namespace vug::field
