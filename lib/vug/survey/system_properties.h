// SPDX-License-Identifier: Apache-2.0
// Axes, units and heights of a coordinate system, and the height of the geoid, from PROJ
// [@proj2022].
#pragma once

#include <vug/survey/geodesy.h>

#include <optional>
#include <string>

namespace vug::survey {

struct SystemProperties {
  std::string name;            ///< E.g. "ETRS89 / UTM zone 30N".
  std::string horizontal;      ///< The system without its heights above the geoid, for Geodesy.
  bool geographic = false;     ///< Longitude and latitude, rather than easting and northing.
  double metres_per_unit = 1;  ///< Unit of easting and northing.
  bool ellipsoidal = false;    ///< Heights are stated, above the ellipsoid.
};

/// The properties of a system with a name as in Geodesy. Throws Error(bad_input) for systems that
/// PROJ does not know, and for local ones.
SystemProperties system_properties(const std::string& name);

/// The reason why the coordinates of a survey cannot be in a system: it is not projected, or its
/// unit is not the metre. Empty for projected systems in metres, for local ones, and for names that
/// coordinate_system does not know.
std::string fault_of_survey_system(const std::string& name);

/// Metres of the geoid EGM96 above the ellipsoid of WGS 84; nothing if PROJ has no grid of it.
std::optional<double> geoid_above_ellipsoid(const Geographic& place);

/// The first grid that the most accurate transformation between two systems needs and PROJ lacks,
/// so that another one is used, whose places may be metres away; nothing if none is missing.
std::optional<std::string> missing_grid(const std::string& from, const std::string& to);

}  // namespace vug::survey
