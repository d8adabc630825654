// SPDX-License-Identifier: Apache-2.0
#include <vug/base/cell.h>
#include <vug/base/parallel.h>
#include <vug/base/parallel_sort.h>
#include <vug/meshing/blocks.h>

#include <cmath>
#include <utility>

namespace vug::meshing {
namespace {

using Key = std::pair<Cell, uint32_t>;

}  // namespace

void for_each_block(const field::Field& field, const std::vector<Vec3d>& points,
                    const BlockOptions& options, const BlockBody& body, Progress& progress) {
  std::vector<Key> keys(points.size());
  parallel_for(
      points.size(),
      [&](size_t i) {
        keys[i] = {cell_at(points[i], options.edge), static_cast<uint32_t>(i)};
      },
      4096);
  parallel_sort(keys.begin(), keys.end());
  std::vector<size_t> starts;
  for (size_t i = 0; i < keys.size(); ++i)
    if (i == 0 || keys[i].first != keys[i - 1].first) starts.push_back(i);
  starts.push_back(keys.size());
  parallel_for(starts.size() - 1, [&](size_t block) {
    progress.check();
    std::vector<uint32_t> indices;
    indices.reserve(starts[block + 1] - starts[block]);
    for (size_t i = starts[block]; i < starts[block + 1]; ++i) indices.push_back(keys[i].second);
    // The cube, not a box around its points: an equal cube has an equal field.
    Vec3d centre;
    for (int axis = 0; axis < 3; ++axis)
      centre[axis] =
          options.edge *
          (static_cast<double>(keys[starts[block]].first[static_cast<size_t>(axis)]) + 0.5);
    const double radius = 0.5 * std::sqrt(3.0) * options.edge + options.margin;
    const field::Field local = field.restricted({centre, radius * (1 + 1e-9)}).field;
    body(indices, local);
    progress.advance(indices.size());
  });
}

std::vector<Vec3d> gathered(const std::vector<Vec3d>& points,
                            const std::vector<uint32_t>& indices) {
  std::vector<Vec3d> some;
  some.reserve(indices.size());
  for (const uint32_t i : indices) some.push_back(points[i]);
  return some;
}

}  // namespace vug::meshing
