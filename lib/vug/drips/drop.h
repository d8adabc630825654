// SPDX-License-Identifier: Apache-2.0
// Drops of water that detach from straws and stalactites. SI units, degrees Celsius.
#pragma once

namespace vug::drips {

inline constexpr double kGravity = 9.81;
inline constexpr double kWaterDensity = 999.7;

/// N/m, of water against air (iapws2014).
double surface_tension(double temperature);

/// The outer diameter of soda straws: that at which drops detach with the Bond number 3.5, 5.15 mm
/// at 10 degrees (curl1973).
double straw_diameter(double temperature);

/// The volume in m3 of drops from a rim of that diameter: Tate's law with the share of the drop
/// that detaches (harkins1919), 76 mm3 for a straw.
double drop_volume(double temperature, double diameter);

/// The radius in metres within which drops land that fell `height` metres. They fall straight for
/// two metres, and scatter by some 5 cm after 20 m.
double scatter_radius(double height);

/// The wavelength in metres at which a film under a roof breaks into drops, 24 mm under a level
/// one: 2 pi sqrt(2) capillary lengths, over the square root of the slope's cosine.
double drip_spacing(double temperature, double cosine);

}  // namespace vug::drips
