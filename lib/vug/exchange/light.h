// SPDX-License-Identifier: Apache-2.0
// A light as plain data for files of other programs.
#pragma once

#include <vug/base/transform.h>
#include <vug/image/image.h>

#include <filesystem>
#include <memory>
#include <string>

namespace vug::exchange {

/// Lights shine along their own -z, with x to the right and y up. A dome's environment map is in
/// longitude and latitude with y up; its middle column points to -z, and columns run to the right
/// seen from inside.
struct Light {
  enum class Shape { sphere, rectangle, disk, spot, sun, dome };

  std::string name;
  Shape shape = Shape::sphere;
  Transform place;          ///< From light space, by a transform that preserves lengths.
  Vec3d radiance{1, 1, 1};  ///< W/sr/m^2 of its front, linear Rec.709; multiplied by a dome's map.
  double radius = 0.1;      ///< Radius of spheres, disks and the sphere of a spot.
  double width = 1;         ///< Width of rectangles, along x.
  double height = 1;        ///< Height of rectangles, along y.
  double angle = 0;         ///< Full cone angle of a spot, or angular diameter of a sun. Radians.
  double edge =
      0;  ///< Fraction of the spot's cone, measured from its edge, over which light fades.
  std::filesystem::path profile;  ///< IES file of a measured light; otherwise empty.
  std::shared_ptr<const image::Image>
      picture;          ///< Environment map of a dome, R, G, B; null: constant.
  bool visible = true;  ///< Whether cameras see the light itself.
};

/// The transform of an object at `from` that looks or shines `along`, with `up` as close to upwards
/// as possible; any `up` not parallel to `along` is valid.
Transform look_along(const Vec3d& from, const Vec3d& along, const Vec3d& up = {0, 1, 0});

/// Luminance of a Rec.709 colour.
inline double luminance(const Vec3d& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

/// Total emitted power in watts per colour; 0 for suns and domes.
Vec3d power(const Light& light);
/// Radiant intensity of a small light along its axis in W/sr; for a sun the irradiance of a surface
/// that faces it in W/m^2.
Vec3d peak_intensity(const Light& light);

}  // namespace vug::exchange
