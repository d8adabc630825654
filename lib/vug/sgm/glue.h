// SPDX-License-Identifier: Apache-2.0
// Gluing: moves a shape such that one of its bonds and a bond of another shape make a label.
#pragma once

#include <vug/sgm/shape.h>

namespace vug::sgm {

/// The rigid map that brings bond `moving` onto bond `fixed`: points coincide and directions are
/// opposite. It rotates by the smallest angle, and not at all if the directions are already
/// opposite or one of them is 0.
Transform glue_transform(const Bond& fixed, const Bond& moving);

/// The index of the bond of `shape` to be joined to the side `side` of another shape: a bond on the
/// opposite side (the first with D = 0 if there is no directed one), otherwise any bond, selected
/// by `key`, which requires a rotation. Nothing if the shape has no bonds.
std::optional<size_t> opposite_bond(const Shape& shape, Label side, RandomKey key);

/// Extent of a shape along the direction of its bond, metres; 0 if infinite.
double extent_along(const Shape& shape, const Bond& bond);

/// Glues the pieces one after another (the paper's P_S: primitives become a compound shape). Each
/// is joined at a bond on the side `label` and pressed in by `overlap` times its extent, so the
/// pieces form one solid. The compound's bonds are recomputed.
Shape compound(const std::vector<Shape>& pieces, Label label, double overlap, RandomKey key);

}  // namespace vug::sgm
