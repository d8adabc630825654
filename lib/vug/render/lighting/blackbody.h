// SPDX-License-Identifier: Apache-2.0
// Colour and radiance of black bodies.
#pragma once

#include <vug/render/vectors.h>

namespace vug::render {

/// Luminous efficacy of white light in lm/W. Radiance of red, green and blue is converted to
/// photometric units by this factor: Ward 1994, "The RADIANCE lighting simulation and rendering
/// system" (ward1994radiance).
inline constexpr double kLumenPerWatt = 179;

/// Linear Rec.709 colour of a black body at `temperature` kelvin, scaled to luminance 1. From
/// Planck's law and the colour matching functions of Wyman, Sloan, Shirley 2013, "Simple analytic
/// approximations to the CIE XYZ color matching functions" (cite wyman2013xyz); out-of-gamut
/// components are set to 0.
Vec3d blackbody(double temperature);
/// Radiance of a black body, in W/sr/m^2 of luminance: the colour above with the luminance of
/// Planck's law. At the freezing point of platinum this is 60 cd/cm^2, once the definition of the
/// candela.
Rgb thermal_radiance(float temperature);

}  // namespace vug::render
