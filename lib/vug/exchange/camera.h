// SPDX-License-Identifier: Apache-2.0
// A camera as plain data.
#pragma once

#include <vug/base/transform.h>
#include <vug/base/vec.h>

#include <string>

namespace vug::exchange {

/// Looks along its own -z, with x to the right and y up. Lengths are in the units of the assembly.
struct Camera {
  std::string name;
  Transform place;  ///< From camera space, by a transform that preserves lengths.
  bool orthographic = false;
  double fov = kPi / 3;     ///< Full horizontal angle of view, radians.
  double span = 4;          ///< Orthographic views: width of the visible region.
  double aspect = 16. / 9;  ///< Width over height.
  double aperture = 0;      ///< Diameter of the lens opening; 0: everything is in focus.
  double focus = 1;         ///< Distance of the plane in focus.
  Vec2i size{0, 0};         ///< Resolution in pixels; 0: not specified.
  double near = 0.01, far = 1000;
};

/// Millimetres: the film width that defines the focal length for the field of view.
inline constexpr double kFilmWidth = 36;
double focal_length(const Camera& camera);

}  // namespace vug::exchange
