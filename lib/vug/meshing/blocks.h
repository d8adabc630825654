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
  double margin = 0;  ///< How far from its point the body may evaluate the field, metres.
};

/// Calls body(index, field) once for each point, groups in parallel; `field` has the values of
/// the given field within `margin` of the point. The body writes only what belongs to its index.
void for_each_in_blocks(const field::Field& field, const std::vector<Vec3d>& points,
                        const BlockOptions& options,
                        const std::function<void(uint32_t, const field::Field&)>& body,
                        Progress& progress);

}  // namespace vug::meshing
