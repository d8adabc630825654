// SPDX-License-Identifier: Apache-2.0
// What surveyors wrote down, after calibration and conversion to metres: the input of `adjust`.
// The readers of .svx, .th, .dat, .srv and .top files produce it.
#pragma once

#include <vug/survey/survey.h>

namespace vug::survey {

/// A symmetric 3x3 covariance in square metres.
struct Covariance {
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
};

/// A measured vector between two stations with its covariance.
struct ObservedLeg {
  Leg leg;
  Vec3d vector{0.0};
  Covariance covariance;
};

/// A station with given coordinates; without a covariance it does not move.
struct Fix {
  int station = 0;
  Vec3d position{0.0};
  std::optional<Covariance> covariance;
  SourceLocation where;
  size_t legs_before = 0, equates_before = 0;  ///< Numbers of those before it in the text.
};

struct Observations {
  std::string title;
  std::string coordinate_system;
  std::vector<Station> stations;  ///< Positions are unused.
  std::vector<ObservedLeg> legs;
  std::vector<Equate> equates;
  std::vector<Fix> fixes;
  std::vector<Tube> tubes;
  std::vector<std::filesystem::path> files;  ///< As Survey::files, if there are several.

  /// Appends an equate or a fix that follows the legs so far.
  void add(Equate equate) {
    equate.legs_before = legs.size();
    equates.push_back(std::move(equate));
  }
  void add(Fix fix) {
    fix.legs_before = legs.size();
    fix.equates_before = equates.size();
    fixes.push_back(std::move(fix));
  }
};

}  // namespace vug::survey
