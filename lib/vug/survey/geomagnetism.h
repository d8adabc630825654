// SPDX-License-Identifier: Apache-2.0
// The Earth's main magnetic field after the International Geomagnetic Reference Field [@igrf14].
#pragma once

#include <vug/base/vec.h>
#include <vug/survey/geodesy.h>

namespace vug::survey {

/// The field in nT to the north, to the east and downwards, in the tangent plane of WGS 84. `year`
/// has a fraction. Error(bad_input) for years outside of 1900 to 2030.
Vec3d magnetic_field(const Geographic& place, double year);

/// The angle in radians from true to magnetic north, positive to the east.
double magnetic_declination(const Geographic& place, double year);

}  // namespace vug::survey
