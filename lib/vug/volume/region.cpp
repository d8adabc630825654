// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/field/enclosed.h>
#include <vug/volume/region.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::volume {
namespace {

bool holds(const Box3d& outer, const Box3d& inner) {
  return inner.isEmpty() || (outer.intersects(inner.min) && outer.intersects(inner.max));
}

void check_options(const VoxelizeOptions& options) {
  if (!(options.voxel > 0) || !std::isfinite(options.voxel))
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid voxel size {} m: it must be above 0", options.voxel));
  constexpr double kLargest = 1e9;  // Far from the limits of single precision.
  if (options.voxel > kLargest)
    throw Error(ErrorCode::bad_input,
                fmt::format("voxels of {} m are larger than {:.0e} m", options.voxel, kLargest));
  if (!(options.half_width >= 3 && options.half_width <= 1000))
    throw Error(ErrorCode::bad_input,
                fmt::format("a band of {} voxels is out of range", options.half_width), {},
                "the half-width of a level set must be between 3 and 1000 voxels");
}

/// Rejects an expression that would visit its nodes too often: its evaluation would never end, nor
/// could it be cancelled, because requests are checked between blocks of voxels.
void check_size(const field::Field& field) {
  constexpr double kMost = 1e7;
  constexpr size_t kDeepest = 10000;  // Nested calls, each of which needs stack space.
  const auto [visits, depth] = field::extent(field);
  if (depth > kDeepest)
    throw Error(ErrorCode::bad_input,
                fmt::format("the solid is nested {} levels deep, more than {}", depth, kDeepest),
                {}, "combine solids in one list: union([a, b, c])");
  if (visits <= kMost) return;
  throw Error(
      ErrorCode::bad_input,
      fmt::format("the solid has {:.3g} operands, more than the {:.0e} that can be evaluated",
                  visits, kMost),
      {}, "a solid that is used in several places counts once for each of them");
}

}  // namespace

Region region_of(const field::Field& field, const VoxelizeOptions& options) {
  check_options(options);
  check_size(field);
  const Box3d& bounds = field.bounds();
  if (bounds.isEmpty()) return {field, Box3d()};
  Region out{field, bounds};
  if (options.region && !holds(*options.region, bounds)) {
    out.box = intersection(*options.region, bounds);
    if (out.box.isEmpty() || !(out.box.min.x < out.box.max.x && out.box.min.y < out.box.max.y &&
                               out.box.min.z < out.box.max.z))
      return {field, Box3d()};
    if (is_finite(*options.region)) out.field = field::enclosed(field, *options.region);
  }
  if (!is_finite(out.box))
    throw Error(ErrorCode::bad_input, "an infinite solid cannot become a level set", {},
                "give a region, or intersect the solid with a box");
  return out;
}

field::Field field_in_region(const field::Field& field, const VoxelizeOptions& options) {
  return region_of(field, options).field;
}

}  // namespace vug::volume
