// SPDX-License-Identifier: Apache-2.0
// The size of a survey: counts, lengths and ranges, as cavern reports them.
#pragma once

#include <vug/survey/survey.h>

#include <map>

namespace vug::survey {

/// The extent of the stations in one direction.
struct Extent {
  double low = 0;
  double high = 0;
  int low_station = -1;  ///< Index in Survey::stations; -1 without stations.
  int high_station = -1;
  double size() const { return high - low; }
};

struct Statistics {
  int stations = 0;    ///< Equated stations count each, and so do the ends of splays.
  int legs = 0;        ///< Legs and equates; without legs of the style nosurvey.
  int equates = 0;     ///< Those of them that are equates, without redundant ones.
  int splays = 0;      ///< Those of them that are splays.
  int components = 0;  ///< Sets of stations that are connected by legs and equates.
  int loops = 0;
  /// As Survex's cavern counts them; no number for coordinates without measurements.
  std::optional<int> survex_components, survex_loops;
  /// Metres of all legs but surface legs, duplicates and splays: as measured, between the adjusted
  /// stations, and the horizontal and the vertical part of the measured ones.
  double length = 0, adjusted_length = 0, plan_length = 0, vertical_length = 0;
  double surface_length = 0;     ///< As measured, in metres.
  double duplicate_length = 0;   ///< As measured, in metres.
  Extent east, north, altitude;  ///< Named stations, without those on the surface.
  std::map<int, int> degrees;    ///< The number of stations with each number of legs and equates.
  int cross_sections = 0;
};

Statistics measure(const Survey& survey);

}  // namespace vug::survey
