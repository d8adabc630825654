// SPDX-License-Identifier: Apache-2.0
// Trunks of stalagmites, whose drip changed its rate while they grew.
#pragma once

#include <vug/base/rng.h>
#include <vug/drips/forms.h>

#include <array>
#include <vector>

namespace vug::drips {

/// The rate of a drip in the past, by the height that the stalagmite had. It depends on the drip
/// and not on the present height, so that girdles stay in place while the stalagmite grows.
class DripHistory {
 public:
  DripHistory(RandomKey key, double radius, double scatter);

  /// The radius of the trunk that grew when the apex was at this height, relative to its mean.
  double radius_at(double height) const;
  /// A smooth function of the height with values of -1..1.
  double wave(double height) const;
  /// The factor on the radius of the trunk at a height above the floor: the foot is wider.
  double flare(double height) const;

 private:
  std::array<double, 4> phases_{};
  double pitch_ = 0.1, amount_ = 0, foot_ = 0, foot_height_ = 0.1;
  double taper_ = 0, taper_height_ = 1;
  double plates_ = 0, plate_pitch_ = 0.05;
};

/// The outline from the apex down to the floor, x the radius and y the height above the floor: the
/// envelope of the profiles with which the apex passed each height. Films do not thicken walls far
/// below the apex, so that slow times leave waists and fast ones girdles.
std::vector<Vec2d> grown_trunk(const Form& form, double height, const DripHistory& history);

/// The radius at a height of an outline that is listed from the top down, 0 above it.
double radius_at(const std::vector<Vec2d>& outline, double y);

}  // namespace vug::drips
