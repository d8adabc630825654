// SPDX-License-Identifier: Apache-2.0
// Affine transformation of fields.
#pragma once

#include <vug/base/transform.h>
#include <vug/field/field.h>

namespace vug::field {

/// Transforms the solid by `map`. Rigid maps and uniform scalings preserve exact distances; other
/// maps give a lower bound: the child's value times the smallest stretch of the map.
Field transformed(const Field& field, const Transform& map);

}  // namespace vug::field
