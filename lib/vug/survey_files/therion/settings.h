// SPDX-License-Identifier: Apache-2.0
// The settings of a Therion centreline, which `group` saves and `endgroup` restores.
#pragma once

#include <vug/survey/measurement.h>
#include <vug/survey_files/data_items.h>
#include <vug/survey_files/therion/tokens.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace vug::survey::therion {

/// Quantities that have a unit, a calibration and a standard deviation. Back readings share those
/// of the quantity.
enum Quantity : size_t {
  kLength,
  kBearing,
  kGradient,
  kCounter,
  kDepth,
  kEasting,
  kNorthing,
  kAltitude,
  kPosition,
  kLeft,
  kRight,
  kUp,
  kDown,
  kPlumb,
  kLevel,
  kQuantities,
};

bool is_angle(Quantity quantity);

/// The quantities that a word names; several for "dimensions". Error(bad_input) for other words.
std::vector<Quantity> find_quantities(const Token& word);
/// Whether the word names a quantity.
bool is_quantity(const std::string& word);

struct Unit {
  double factor = 1;  ///< Metres or radians per unit.
  bool percent = false;
};

/// The unit of a length or an angle. Error(bad_input) for other words.
Unit find_unit(const Token& word, bool angle);

/// (reading - zero) * scale in the unit of readings, then converted.
struct Calibration {
  double zero = 0;
  double scale = 1;
  double factor = 1;  ///< The number of units, e.g. 2 for a tape of double length.
  Unit unit;

  double operator()(double reading) const;
};

using Variances = std::array<double, kQuantities>;
Variances default_variances();

/// Standard deviations by quantity, in metres and radians.
using Grade = std::map<Quantity, double>;
/// The grades that Therion knows.
const std::map<std::string, Grade>& known_grades();

/// Reads "quantities value unit" from `at` on and adds them to a grade.
void read_deviations(const std::vector<Token>& line, size_t at, Grade& grade);

/// A finite number. Error(bad_input) for other words.
double read_number(const Token& word);

struct Order {
  DataStyle style = DataStyle::none;
  std::vector<Item> items;
  bool interleaved = false;  ///< Stations and readings have lines of their own.
};

/// Reads "data STYLE readings...". Error(bad_input) for readings that the style lacks or does not
/// have.
Order read_order(const std::vector<Token>& line);

struct Settings {
  std::array<Calibration, kQuantities> calibrations;
  Variances variances = default_variances();
  double declination = 0;  ///< Radians, added to bearings.
  bool surface = false, duplicate = false, splay = false;
  bool infer_plumbs = false, infer_equates = false;
  std::optional<DateRange> date;
  std::string prefix, suffix;  ///< Added to the names of stations.
  Order order;

  Settings();
};

}  // namespace vug::survey::therion
