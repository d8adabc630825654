// SPDX-License-Identifier: Apache-2.0
// Solids of revolution: a polygon in the plane of radius and height, turned about the y axis.
#pragma once

#include <vug/field/field.h>

#include <string>
#include <vector>

namespace vug::field {

/// The exact distance to a turned polygon. `outline` contains its corners, x the radius and y the
/// height, in order; the last corner is joined to the first. Sides on the axis are not part of the
/// surface. Where sides of the polygon cross, its inside follows the even-odd rule.
Field lathe(const std::string& name, const std::vector<Vec2d>& outline);

/// What is wrong with an outline, or an empty string.
std::string lathe_fault(const std::vector<Vec2d>& outline);

}  // namespace vug::field
