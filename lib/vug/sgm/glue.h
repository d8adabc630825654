// Gluing: moving a shape so that one of its bonds and one of another shape's make a label.
#pragma once

#include <vug/sgm/shape.h>

namespace vug::sgm {

/// The rigid map that brings bond `moving` onto bond `fixed`: points coincide, directions are
/// opposite. Turns only where they are not opposite yet, by the shortest way; where one of them
/// is 0 it only moves.
Transform glue_transform(const Bond& fixed, const Bond& moving);

/// The index of the bond of `shape` that is to meet a side `side` of another shape: one on the
/// opposite side (the first with D = 0 when there is no other there), else any, chosen by `key`
/// and to be turned. Nothing when the shape has no bond.
std::optional<size_t> opposite_bond(const Shape& shape, Label side, RandomKey key);

/// How far a shape reaches along the direction of its bond, metres; 0 when infinite.
double extent_along(const Shape& shape, const Bond& bond);

/// Pieces glued one after the other onto what is there (the paper's P_S: primitives become a
/// compound shape): each is joined at a bond on the side `label` and pressed in by `overlap`
/// times its extent, so that the pieces are one solid. The compound's bonds are computed anew.
Shape compound(const std::vector<Shape>& pieces, Label label, double overlap, RandomKey key);

}  // namespace vug::sgm
