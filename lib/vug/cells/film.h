// SPDX-License-Identifier: Apache-2.0
// Thin films of water on rock (nusselt1916). Temperatures are in degrees Celsius.
#pragma once

namespace vug::cells {

inline constexpr double kGravity = 9.81;  ///< m/s^2.

/// The kinematic viscosity of water in m2/s by Vogel's equation with a density of 1000 kg/m3:
/// within 1.2 % of tables from 10 to 40 degrees and 3 % at 0.
double kinematic_viscosity(double temperature);

/// The cube root of a number of at least 0 within 1e-11, with the same bits on every machine.
double cube_root(double x);

/// The laminar film of Nusselt, (3 nu q / (g sin theta))^(1/3) metres thick, for a flow of q m2/s
/// per metre of width down a slope with the sine `steepness`.
double film_thickness(double flow, double steepness, double viscosity);

/// Its mean speed in m/s: flow / thickness.
double film_speed(double flow, double steepness, double viscosity);

}  // namespace vug::cells
