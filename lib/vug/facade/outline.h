// Solids of a drawn outline: mouldings, gables, shafts of columns.
#pragma once

#include <vug/field/field.h>

#include <vector>

namespace vug::facade {

/// Corners of a simple polygon, counter-clockwise, metres.
using Outline = std::vector<Vec2d>;

/// Corners of an arc about `centre` from angle `from` to `to` (radians, counter-clockwise when `to`
/// is larger), both ends included, in `steps` chords.
Outline arc(const Vec2d& centre, double radius, double from, double to, int steps);

/// The outline in x and y drawn along z from `back` to `front`: the exact distance.
field::Field extruded(const Outline& outline, double back, double front);

/// The outline in z (its first coordinate, out of the wall) and y, drawn along x from `left` to
/// `right`: a moulding.
field::Field moulding(const Outline& outline, double left, double right);

/// The outline turned about the y axis: the exact distance. No corner may have x < 0.
field::Field revolved(const Outline& outline);

}  // namespace vug::facade
