// SPDX-License-Identifier: Apache-2.0
// The settings of a .svx file that *begin saves and *end restores.
#pragma once

#include <vug/survey/observations.h>
#include <vug/survey_files/svx/orders.h>
#include <vug/survey_files/svx/quantities.h>

#include <memory>

namespace vug::survey::svx {

enum class LetterCase { lower, upper, preserve };

/// The correction from magnetic to grid north.
struct Declination {
  double value = 0;        ///< Radians; added to bearings.
  bool automatic = false;  ///< Computed from the date and the place instead.
  Vec3d place{0.0};        ///< In `coordinate_system`.
  std::string coordinate_system;
};

/// The north of cartesian data.
enum class CartesianNorth {
  output,    ///< That of the grid of the survey.
  grid,      ///< That of the grid of *cs.
  magnetic,  ///< That of compasses.
  geographic,
};

struct Settings {
  std::string survey;  ///< The full name of the current survey; empty at the top.
  std::shared_ptr<const Order> order = default_order();
  std::shared_ptr<const Characters> characters = std::make_shared<Characters>();
  std::array<Calibration, kQuantities> calibrations = default_calibrations();
  std::array<double, kQuantities> variances = default_variances();
  Declination declination;
  CartesianNorth cartesian = CartesianNorth::output;
  std::string coordinate_system;  ///< The system of *fix; empty: local metres.
  std::optional<DateRange> date;
  LetterCase letter_case = LetterCase::lower;
  size_t truncate = SIZE_MAX;  ///< Bytes of each part of a name that count.
  bool surface = false;
  bool duplicate = false;
  bool splay = false;
  bool infer_plumbs = false;
  bool infer_equates = false;
  bool infer_exports = false;
  bool hyphen_is_wall = false;  ///< The station "-" is an anonymous point on the wall (*alias).
};

}  // namespace vug::survey::svx
