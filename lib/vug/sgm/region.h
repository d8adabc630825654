// SPDX-License-Identifier: Apache-2.0
// Local variants of intersection and morph: they act only near the new shape, so no production can
// remove distant parts of a cave.
#pragma once

#include <vug/field/blend.h>
#include <vug/field/field.h>

namespace vug::sgm {

/// base * (base + shape): eq. (5) whose target is the union of base and shape,
///   f = (1 - a) base + a min(base, shape).
/// Where the shape is nearer than the base this is the paper's base * shape; elsewhere it is the
/// base, bit-identical at the points where base <= shape. Amount 0 gives the base, 1 the union.
field::Field local_morph(const field::Field& base, const field::Field& shape, double amount,
                         const field::Blend& blend = {});

/// base & (shape + outside H): cuts the base to the shape inside the half ball H about `centre`, on
/// the side of `direction` (unit), with `radius` in metres. The base behind it is unchanged, so the
/// remaining end stays connected.
field::Field local_intersection(const field::Field& base, const field::Field& shape,
                                const Vec3d& centre, const Vec3d& direction, double radius,
                                const field::Blend& blend = {});

}  // namespace vug::sgm
