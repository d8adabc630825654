// SPDX-License-Identifier: Apache-2.0
// Terrain with the heights of an image: (y - H(x, z)) / sqrt(1 + s^2), where s is the maximum
// slope, never exceeds the distance to the ground; cut to a block with four walls.
#include <vug/field/heightmap.h>
#include <vug/field/opaque.h>
#include <vug/image/io.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Ground {
  Heightmap heightmap;
  Vec3d size;
  double base;
  double shrink = 1 / std::sqrt(1 + heightmap.max_slope() * heightmap.max_slope());

  Gradient sample(const Vec3d& p) const {
    const Heightmap::Height h = heightmap.at(p.x + 0.5 * size.x, p.z + 0.5 * size.z);
    const Gradient top = {(p.y - h.value) * shrink, Vec3d(-h.slope_u, 1, -h.slope_v) * shrink};
    const Vec3d facing(p.x < 0 ? -1 : 1, -1, p.z < 0 ? -1 : 1);
    const Vec3d wall = p * facing - Vec3d(0.5 * size.x, base, 0.5 * size.z);
    int nearest = 0;
    Vec3d off;
    for (int axis = 0; axis < 3; ++axis) {
      if (wall[axis] > wall[nearest]) nearest = axis;
      off[axis] = std::max(wall[axis], 0.0);
    }
    const double outside = off.length();
    const double cut = outside > 0 ? outside : wall[nearest];
    if (cut <= top.value) return top;
    Vec3d slope(0);
    slope[nearest] = 1;
    if (outside > 0) slope = off / outside;
    return {cut, slope * facing};
  }
};

struct Heightfield {
  std::filesystem::path file;
  Vec3d size{10, 1, 10};
  double base = 0.1;
  Sampling sampling = Sampling::bicubic;

  static void describe(Schema<Heightfield>& s) {
    s.doc(
         "A block of ground whose top follows the brightness of an image: black at y = 0, the top "
         "edge of the image towards -z.")
        .cite("catmull1974")
        .param(
            "file", &Heightfield::file,
            {.doc = "any image; one channel, or the mean of three, from 0 to 1", .required = true})
        .param("size", &Heightfield::size,
               positive_length("size of the ground along x and z, and along y from black to white"))
        .param("base", &Heightfield::base, positive_length("thickness of the block below black"))
        .choice("sampling", &Heightfield::sampling,
                {{"bilinear", Sampling::bilinear}, {"bicubic", Sampling::bicubic}},
                "interpolation of heights between pixels");
  }
};

Field ground(const Heightfield& params) {
  image::Image picture = image::read_grey(params.file);
  if (picture.width < 2 || picture.height < 2)
    throw Error(ErrorCode::bad_input,
                "'" + params.file.string() +
                    "' is too small for a heightfield: it needs at least 2 x 2 pixels");
  for (float& height : picture.pixels) {
    height *= static_cast<float>(params.size.y);
    if (!std::isfinite(height))
      throw Error(ErrorCode::bad_input,
                  "'" + params.file.string() + "' contains values that are not finite");
  }
  Ground source{Heightmap(picture.width, picture.height, std::move(picture.pixels), params.size.x,
                          params.size.z, params.sampling),
                params.size, params.base};
  Traits traits;
  traits.exactness = Exactness::bound;
  // Above the block f >= dy / sqrt(1 + s^2), next to it f >= dx; the two combine to a diagonal.
  traits.growth = source.shrink / std::sqrt(2.0);
  const double highest = std::max(source.heightmap.range().hi, -params.base);
  traits.bounds = {Vec3d(-0.5 * params.size.x, -params.base, -0.5 * params.size.z),
                   Vec3d(0.5 * params.size.x, highest, 0.5 * params.size.z)};
  return Field(std::make_shared<OpaqueNode<Ground>>("heightfield", traits, std::move(source)));
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(heightfield) { return field_kind<Heightfield>("heightfield", "primitive", ground); }
