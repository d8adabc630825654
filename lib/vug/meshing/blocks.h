// Work on many points of one field: grouped by place, so that each group sees only the operands
// that matter there.
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace vug::meshing {

struct BlockOptions {
  double edge = 1;    ///< Of the cubes that points are grouped by, metres.
  double margin = 0;  ///< How far from its points the body may evaluate the field, metres.
};

using BlockBody =
    std::function<void(const std::vector<uint32_t>& indices, const field::Field& field)>;

/// Calls body(indices, field) once for each group of points, groups in parallel, indices
/// ascending; `field` has the values of the given field within `margin` of each of the points.
/// The body writes only what belongs to its indices. Groups do not depend on the threads.
void for_each_block(const field::Field& field, const std::vector<Vec3d>& points,
                    const BlockOptions& options, const BlockBody& body, Progress& progress);

/// The points at the indices.
std::vector<Vec3d> gathered(const std::vector<Vec3d>& points, const std::vector<uint32_t>& indices);

}  // namespace vug::meshing
