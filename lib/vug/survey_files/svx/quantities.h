// SPDX-License-Identifier: Apache-2.0
// The quantities of .svx files, their units and their calibration.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey_files/svx/line.h>

#include <array>
#include <cstddef>
#include <vector>

namespace vug::survey::svx {

enum Quantity : size_t {
  kTape,
  kBackTape,
  kCompass,
  kBackCompass,
  kClino,
  kBackClino,
  kCount,
  kDepth,
  kDeclination,
  kEasting,
  kNorthing,
  kAltitude,
  kPosition,
  kLeft,
  kRight,
  kUp,
  kDown,
  kLevel,
  kPlumb,
  kQuantities,
};

/// Whether a quantity is an angle, as opposed to a length.
bool is_angle(Quantity quantity);
/// Reads the names of quantities; empty if the next word is DEFAULT, which is skipped.
std::vector<Quantity> read_quantities(Line& line);

enum class Scale { linear, percent, quadrants };

struct Unit {
  double factor = 1;  ///< Metres or radians per unit.
  bool angle = false;
  Scale scale = Scale::linear;
};

/// Reads a unit of the quantity; nothing if the next word is not a unit of any quantity.
/// `warnings` receives a note about "mils".
std::optional<Unit> try_unit(Line& line, Quantity quantity, Diagnostics& warnings);
/// Reads a unit of the quantity.
Unit read_unit(Line& line, Quantity quantity, Diagnostics& warnings);

/// The conversion of readings to metres or radians: (reading * unit - zero) * scale.
struct Calibration {
  Unit unit;
  double zero = 0;  ///< Metres or radians.
  double scale = 1;

  double operator()(double reading) const;
  /// The reading in metres or radians without calibration.
  double converted(double reading) const;
};

/// The calibrations of the start of a file.
std::array<Calibration, kQuantities> default_calibrations();
/// Variances in square metres or radians at the start of a file.
std::array<double, kQuantities> default_variances();

}  // namespace vug::survey::svx
