// The local readings of intersection and morph: they act where the new shape is, and no
// production can take away a cave that lies elsewhere.
#pragma once

#include <vug/field/blend.h>
#include <vug/field/field.h>

namespace vug::sgm {

/// base * (base + shape): eq. (5) with the base on which the shape was united as its target,
///   f = (1 - a) base + a min(base, shape).
/// Where the shape is nearer than the base this is the paper's base * shape; elsewhere the base,
/// bit for bit at the points where base <= shape. Amount 0 gives the base, 1 the union.
field::Field local_morph(const field::Field& base, const field::Field& shape, double amount,
                         const field::Blend& blend = {});

/// base & (shape + outside H): the base is cut to the shape inside the half ball H about
/// `centre`, on the side of `direction` (unit), with `radius` in metres; behind it stays whole, so
/// that what is left of the end hangs on the rest.
field::Field local_intersection(const field::Field& base, const field::Field& shape,
                                const Vec3d& centre, const Vec3d& direction, double radius,
                                const field::Blend& blend = {});

}  // namespace vug::sgm
