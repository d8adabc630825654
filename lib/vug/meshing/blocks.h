// SPDX-License-Identifier: Apache-2.0
// Evaluation of one field at many points, grouped by position, so that each group sees only the
// operands that matter there.
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace vug::meshing {

struct BlockOptions {
  double edge = 1;  ///< Edge of the cubes that group the points, metres.
  double margin =
      0;  ///< Distance from its points within which the body may evaluate the field, metres.
};

using BlockBody =
    std::function<void(const std::vector<uint32_t>& indices, const field::Field& field)>;

/// Calls body(indices, field) once for each group of points, with groups in parallel and indices
/// ascending; `field` equals the given field within `margin` of each point. The body writes only
/// the data of its indices. Groups and fields do not depend on the number of threads, nor a group
/// on points outside of its cube.
void for_each_block(const field::Field& field, const std::vector<Vec3d>& points,
                    const BlockOptions& options, const BlockBody& body, Progress& progress);

/// The points with these indices.
std::vector<Vec3d> gathered(const std::vector<Vec3d>& points, const std::vector<uint32_t>& indices);

}  // namespace vug::meshing
