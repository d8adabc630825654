// SPDX-License-Identifier: Apache-2.0
// Solids from outlines: mouldings, gables, shafts of columns.
#pragma once

#include <vug/field/field.h>

#include <vector>

namespace vug::facade {

/// Corners of a simple polygon, counter-clockwise, metres.
using Outline = std::vector<Vec2d>;

/// Corners of an arc about `centre` from angle `from` to `to` (radians, counter-clockwise if `to`
/// is larger), both ends included, with `steps` chords.
Outline arc(const Vec2d& centre, double radius, double from, double to, int steps);

/// The outline in x and y extruded along z from `back` to `front`; exact distance.
field::Field extruded(const Outline& outline, double back, double front);

/// A moulding: the outline in z (its first coordinate, out of the wall) and y, extruded along x
/// from `left` to `right`.
field::Field moulding(const Outline& outline, double left, double right);

/// The solid of revolution of the outline about the y axis; exact distance. No corner may have x <
/// 0.
field::Field revolved(const Outline& outline);

}  // namespace vug::facade
