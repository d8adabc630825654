// SPDX-License-Identifier: Apache-2.0
// The angle from magnetic to grid north on the day of a leg.
#pragma once

#include <vug/survey/geodesy.h>
#include <vug/survey_files/svx/line.h>
#include <vug/survey_files/svx/settings.h>

#include <map>

namespace vug::survey::svx {

class North {
 public:
  /// Radians to add to bearings under these settings. `grid` is the coordinate system of the
  /// survey. Adds a warning for a leg without a date, at the words of the line from `start`: making
  /// their place for every leg would cost more than the angle.
  double correction(const Settings& settings, const std::string& grid, const Line& line,
                    size_t start, Diagnostics& warnings);
  /// The same for the bearings of cartesian data. Error(bad_input) if the angle between two norths
  /// depends on a place that is not known.
  double cartesian_correction(const Settings& settings, const std::string& grid, const Line& line,
                              size_t start, Diagnostics& warnings);
  Geodesy& geodesy() { return geodesy_; }

 private:
  Geodesy geodesy_;
  std::map<std::tuple<std::string, std::string, double, double, double, int>, double> known_;
};

}  // namespace vug::survey::svx
