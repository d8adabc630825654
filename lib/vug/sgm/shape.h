// SPDX-License-Identifier: Apache-2.0
// A solid with its bonds.
#pragma once

#include <vug/base/transform.h>
#include <vug/field/field.h>
#include <vug/sgm/bond.h>

namespace vug::sgm {

struct Shape {
  std::string name;  ///< Name in trees and messages.
  field::Field field;
  std::vector<Bond> bonds;
};

/// A shape of a field with the bonds computed by bonds_of.
Shape make_shape(std::string name, field::Field field);

/// Computes the bonds of any field. Each of the six sides on which its bounds are finite gets one
/// bond: the point where the axis ray through the centre of the bounds, coming from outside, first
/// enters the solid, if that lies on its own side of the centre; otherwise (a torus seen along its
/// hole, an empty middle) the support point: the solid's extreme point in that direction, the
/// nearest to the axis among equally extreme ones. On an axis with infinite bounds the ray runs
/// through the finite end, or else through 0. A solid that is infinite on all sides (gyroid, tilted
/// half-space) has one bond with D = 0 at a surface point near the origin; an empty one has no
/// bonds.
std::vector<Bond> bonds_of(const field::Field& field);

/// The bond of one side, or nothing; see bonds_of.
std::optional<Bond> bond_on(const field::Field& field, Label side);
/// The bond at the support point of one side, or nothing.
std::optional<Bond> support_bond(const field::Field& field, Label side);

/// The length that scales tolerances: the diagonal of the bounds, 1 m if infinite.
double size_of(const field::Field& field);

/// Applies a rigid map to the shape and its bonds.
Shape transformed(const Shape& shape, const Transform& map);

}  // namespace vug::sgm
