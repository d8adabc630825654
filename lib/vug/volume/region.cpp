#include <vug/base/error.h>
#include <vug/field/boolean.h>
#include <vug/field/primitive.h>
#include <vug/volume/region.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::volume {
namespace {

/// The exact distance to a box.
struct ClipBox {
  Box3d box;

  template <class T>
  T distance(const field::Point<T>& p) const {
    using field::max, field::min;
    const Vec3d half = 0.5 * box.size();
    const field::Point<T> q = abs(p - field::constant<T>(box.center())) - field::constant<T>(half);
    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), T(0.0));
  }
  Box3d bounds() const { return box; }
};

bool holds(const Box3d& outer, const Box3d& inner) {
  return inner.isEmpty() || (outer.intersects(inner.min) && outer.intersects(inner.max));
}

void check_options(const VoxelizeOptions& options) {
  if (!(options.voxel > 0) || !std::isfinite(options.voxel))
    throw Error(ErrorCode::bad_input, fmt::format("a voxel of {} m is no length", options.voxel));
  if (!(options.half_width >= 3 && options.half_width <= 1000))
    throw Error(ErrorCode::bad_input,
                fmt::format("a band of {} voxels is out of range", options.half_width), {},
                "the half-width of a level set lies between 3 and 1000 voxels");
}

}  // namespace

Region region_of(const field::Field& field, const VoxelizeOptions& options) {
  check_options(options);
  const Box3d& bounds = field.bounds();
  if (bounds.isEmpty()) return {field, Box3d()};
  Region out{field, bounds};
  if (options.region && !holds(*options.region, bounds)) {
    out.box = intersection(*options.region, bounds);
    if (out.box.isEmpty() || !(out.box.min.x < out.box.max.x && out.box.min.y < out.box.max.y &&
                               out.box.min.z < out.box.max.z))
      return {field, Box3d()};
    if (is_finite(*options.region)) {
      const field::Field clip(
          std::make_shared<field::PrimitiveNode<ClipBox>>("region", ClipBox{*options.region}));
      out.field = field::intersect({field, clip});
    }
  }
  if (!is_finite(out.box))
    throw Error(ErrorCode::bad_input, "a solid without an end cannot become a level set", {},
                "give a region, or intersect the solid with a box");
  return out;
}

}  // namespace vug::volume
