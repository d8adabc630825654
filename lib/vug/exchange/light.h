// A light as plain data: what files of other programs are told of it.
#pragma once

#include <vug/base/transform.h>
#include <vug/image/image.h>

#include <filesystem>
#include <memory>
#include <string>

namespace vug::exchange {

/// Lamps shine along their own -z, with x to the right and y up; a dome's picture is in longitude
/// and latitude with y up, its middle column towards -z, and columns run to the right seen from
/// inside.
struct Light {
  enum class Shape { sphere, rectangle, disk, spot, sun, dome };

  std::string name;
  Shape shape = Shape::sphere;
  Transform place;          ///< From its own space, whose axes keep their lengths.
  Vec3d radiance{1, 1, 1};  ///< W/sr/m^2 of its front, linear Rec.709; times a dome's picture.
  double radius = 0.1;      ///< Of spheres, disks and of the ball of a spot.
  double width = 1;         ///< Of rectangles, along x.
  double height = 1;        ///< Of rectangles, along y.
  double angle = 0;         ///< Of a spot from side to side; how wide a sun looks. Radians.
  double edge = 0;  ///< Prototype of the spot's cone, from its edge on, in which light fades.
  std::filesystem::path profile;                ///< Of a measured light (IES); else empty.
  std::shared_ptr<const image::Image> picture;  ///< Of a dome, R, G, B; null: of one colour.
  bool visible = true;                          ///< Whether cameras see the light itself.
};

/// Where something stands that looks or shines `along`, with `up` upwards as far as that goes: any
/// direction that is not the same will do.
Transform look_along(const Vec3d& from, const Vec3d& along, const Vec3d& up = {0, 1, 0});

/// Of red, green and blue in Rec.709.
inline double luminance(const Vec3d& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

/// All that it sends out, in watts of each colour; nothing for suns and domes.
Vec3d power(const Light& light);
/// What a small light sends along its axis, in W/sr; a sun: what reaches a surface that faces it,
/// in W/m^2.
Vec3d peak_intensity(const Light& light);

}  // namespace vug::exchange
