// A camera as plain data.
#pragma once

#include <vug/base/transform.h>
#include <vug/base/vec.h>

#include <string>

namespace vug::exchange {

/// Looks along its own -z, with x to the right and y up. Lengths are in the units of what it stands
/// in.
struct Camera {
  std::string name;
  Transform place;  ///< From its own space, whose axes keep their lengths.
  bool orthographic = false;
  double fov = kPi / 3;     ///< Full horizontal angle of view, radians.
  double span = 4;          ///< Of an orthographic view: what the picture's width shows.
  double aspect = 16. / 9;  ///< Width over height.
  double aperture = 0;      ///< Diameter of the lens opening; 0: all is sharp.
  double focus = 1;         ///< Distance of the sharp plane.
  Vec2i size{0, 0};         ///< Pixels of the picture it is asked for; 0: of none.
  double near = 0.01, far = 1000;
};

/// Millimetres: of film as wide as 36 mm, whose lens sees the angle.
inline constexpr double kFilmWidth = 36;
double focal_length(const Camera& camera);

}  // namespace vug::exchange
