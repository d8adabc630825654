// SPDX-License-Identifier: Apache-2.0
// The calcium of cave water, and the calcite that it deposits (dreybrodt1980, kaufmann2003).
// Temperatures are in degrees Celsius, concentrations in mol/m3, times in seconds or years.
#pragma once

namespace vug::drips {

inline constexpr double kSecondsPerYear = 365.25 * 86400;
/// The volume of calcite of a mole of calcium, in m3: 0.1001 kg/mol at 2700 kg/m3.
inline constexpr double kCalciteVolume = 0.1001 / 2700;

/// The range of temperatures for which the rates below were fitted.
inline constexpr double kColdest = 0, kWarmest = 30;

/// The rate alpha in m/s at which a film of 0.1 mm deposits: the flux of calcium is alpha times the
/// concentration above equilibrium.
double deposition_rate(double temperature);

/// Calcium in equilibrium with the air of a cave (400 ppm of CO2).
double equilibrium_calcium(double temperature);

/// Calcium of the water that enters a cave below soil with 3 % of CO2. `mixing` is 0 for water that
/// dissolved the rock while in contact with the air of the soil, and 1 for water that had left it.
double seep_calcium(double temperature, double mixing = 0.5);

/// Growth in metres per year of a surface whose film is renewed by a drop every `interval` seconds.
double growth_rate(double calcium, double temperature, double interval);

/// The radius in metres of the trunk of a stalagmite under drops of `volume` m3: on its top the
/// film loses as much as a drop brings.
double trunk_radius(double volume, double temperature, double interval);

/// Calcium of water with a `discharge` in m3/s after it has wetted `area` m2 of rock.
double calcium_after(double calcium, double temperature, double area, double discharge);

}  // namespace vug::drips
