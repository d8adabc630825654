// SPDX-License-Identifier: Apache-2.0
// Radiance of black bodies.
#pragma once

#include <vug/base/blackbody.h>
#include <vug/render/vectors.h>

namespace vug::render {

/// Luminous efficacy of white light in lm/W. Radiance of red, green and blue is converted to
/// photometric units by this factor: Ward 1994, "The RADIANCE lighting simulation and rendering
/// system" (ward1994radiance).
inline constexpr double kLumenPerWatt = 179;

/// Radiance of a black body, in W/sr/m^2 of luminance: the colour of vug::blackbody with the
/// luminance of Planck's law. At the freezing point of platinum this is 60 cd/cm^2, once the
/// definition of the candela.
Rgb thermal_radiance(float temperature);

}  // namespace vug::render
