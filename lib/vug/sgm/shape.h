// A solid with its bonds.
#pragma once

#include <vug/base/transform.h>
#include <vug/field/field.h>
#include <vug/sgm/bond.h>

namespace vug::sgm {

struct Shape {
  std::string name;  ///< What trees and messages call it.
  field::Field field;
  std::vector<Bond> bonds;
};

/// The shape of a field, its bonds computed by bonds_of.
Shape make_shape(std::string name, field::Field field);

/// Bonds of any field, found on the field itself. For each of the six sides on which its bounds
/// are finite: the point where the axis ray through the centre of the bounds, coming from
/// outside, first enters the solid, if that lies on its own side of the centre; otherwise (a
/// torus seen along its hole, an empty middle) the support point: the solid's extreme point in
/// that direction, of equally extreme ones the nearest to the axis. Where bounds are infinite on
/// an axis the ray runs through the finite end, or else through 0. A solid that is infinite
/// on all sides (gyroid, tilted half-space) has one bond with D = 0 at a surface point near the
/// origin; an empty one has none.
std::vector<Bond> bonds_of(const field::Field& field);

/// The bond of one side, or nothing; see bonds_of.
std::optional<Bond> bond_on(const field::Field& field, Label side);
/// The support point's bond of one side, or nothing.
std::optional<Bond> support_bond(const field::Field& field, Label side);

/// The length that tolerances are scaled by: the diagonal of the bounds, 1 m where infinite.
double size_of(const field::Field& field);

/// Shape and bonds carried along by a rigid map.
Shape transformed(const Shape& shape, const Transform& map);

}  // namespace vug::sgm
