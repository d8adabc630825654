// SPDX-License-Identifier: Apache-2.0
// The distance to the surface of a field along a ray, as a surveyor measures it.
#pragma once

#include <vug/field/field.h>

#include <optional>

namespace vug::passages {

/// Metres from `from` along the unit vector `direction` to the first point where the sign of the
/// field changes; empty if the surface is farther away than `reach`, or the field is not a number.
/// Steps are the value by the Lipschitz constant (sphere tracing, hart1996), but at least 1 mm, so
/// that thinner walls may be missed; the crossing is then bisected to a micrometre. Works on both
/// sides of the surface.
std::optional<double> distance_to_wall(const field::Field& field, const Vec3d& from,
                                       const Vec3d& direction, double reach);

}  // namespace vug::passages
