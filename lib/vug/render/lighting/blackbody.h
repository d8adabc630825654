// Light of what is hot.
#pragma once

#include <vug/render/vectors.h>

namespace vug::render {

/// Lumen in a watt of white light, by which radiance of red, green and blue is told in photometric
/// units: Ward 1994, "The RADIANCE lighting simulation and rendering system" (ward1994radiance).
inline constexpr double kLumenPerWatt = 179;

/// Linear Rec.709 of a black body at that temperature in kelvin, of luminance 1. From Planck's law
/// and the colour matching functions of Wyman, Sloan, Shirley 2013, "Simple analytic approximations
/// to the CIE XYZ color matching functions" (cite wyman2013xyz); parts outside of the gamut are 0.
Vec3d blackbody(double temperature);
/// What it sends out, W/sr/m^2 of luminance, of that colour and as bright as Planck's law says: at
/// the freezing point of platinum 60 cd/cm^2, which was once the definition of the candela.
Rgb thermal_radiance(float temperature);

}  // namespace vug::render
