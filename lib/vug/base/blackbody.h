// SPDX-License-Identifier: Apache-2.0
// The colour of black bodies.
#pragma once

#include <vug/base/vec.h>

namespace vug {

/// The range of temperatures in kelvin for which scenes use the colour of a black body.
inline constexpr double kCoolestBlackbody = 800, kHottestBlackbody = 40000;

/// The second radiation constant hc/k in nm K.
inline constexpr double kSecondRadiation = 1.438776877e7;

/// Tristimulus values of Planck's law at `temperature` kelvin, relative to its value at 560 nm. The
/// colour matching functions are those of Wyman, Sloan, Shirley 2013, "Simple analytic
/// approximations to the CIE XYZ color matching functions" (cite wyman2013xyz), in steps of 5 nm.
Vec3d blackbody_xyz(double temperature);

/// Linear Rec.709 colour of a black body at `temperature` kelvin, scaled to luminance 1;
/// out-of-gamut components are set to 0.
Vec3d blackbody(double temperature);

}  // namespace vug
