// SPDX-License-Identifier: Apache-2.0
// Pictures without UVs: triplanar mapping (projection along the axes, blended by the normal), or
// projection along one axis.
#include <vug/base/error.h>
#include <vug/image/texture.h>
#include <vug/paint/kind.h>
#include <vug/paint/space.h>

#include <fmt/format.h>

namespace vug::paint {
namespace {

enum class Mapping { triplanar, x, y, z };
enum class Missing { stop, show };

struct Picture : InSpace {
  std::filesystem::path file;
  double size = 1;
  Mapping mapping = Mapping::triplanar;
  Missing missing = Missing::stop;

  static void describe(Schema<Picture>& s) {
    s.doc("A picture that repeats over the surface.")
        .param("file", &Picture::file, {.doc = "any picture file", .required = true})
        .param("size", &Picture::size, positive_length("width of one repeat"))
        .choice("mapping", &Picture::mapping,
                {{"triplanar", Mapping::triplanar},
                 {"along_x", Mapping::x},
                 {"along_y", Mapping::y},
                 {"along_z", Mapping::z}},
                "projected along all axes and blended by the normal, or along one axis through the "
                "solid")
        .choice("missing", &Picture::missing, {{"stop", Missing::stop}, {"show", Missing::show}},
                "a missing file is an error, or painted magenta");
    describe_space(s);
  }
};

/// Upright on vertical faces, as seen from the positive side of the axis.
Vec3d project(const image::Texture& texture, const Vec3d& p, int axis, double width) {
  if (axis == 0) return texture.at(-p.z, -p.y, width);
  if (axis == 1) return texture.at(p.x, p.z, width);
  return texture.at(p.x, -p.y, width);
}

Vec3d color_at(const Picture& picture, const image::Texture& texture, const EvalPoint& point) {
  const Vec3d p = point.position / picture.size;
  const double width = point.footprint / picture.size;
  if (picture.mapping != Mapping::triplanar)
    return project(texture, p, static_cast<int>(picture.mapping) - 1, width);
  Vec3d weight;
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double n = point.normal[axis] * point.normal[axis];
    weight[axis] = n * n;  // narrow blends
    sum += weight[axis];
  }
  Vec3d color(0.0);
  for (int axis = 0; axis < 3; ++axis)
    if (weight[axis] > 1e-3 * sum)
      color += project(texture, p, axis, width) * weight[axis];
    else
      sum -= weight[axis];
  return color / sum;
}

}  // namespace
}  // namespace vug::paint

VUG_PAINT_KIND(picture) {
  return paint_kind<Picture>("picture", [](const Picture& p) -> Paint {
    if (!std::filesystem::exists(p.file)) {
      if (p.missing == Missing::show)
        return make_paint([](const EvalPoint&) { return Vec3d(1, 0, 1); });
      throw Error(ErrorCode::bad_input,
                  fmt::format("the picture '{}' does not exist", p.file.string()), {},
                  "missing: show paints it magenta");
    }
    const auto evaluate = [p, texture = image::Texture(p.file)](const EvalPoint& point) {
      return color_at(p, texture, point);
    };
    return make_paint(in_space(p, evaluate), p.uses());
  });
}
