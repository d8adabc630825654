// SPDX-License-Identifier: Apache-2.0
// Internal to meshing/: evaluation of a field at the points of one pass of the polish, but for
// groups of points at which an earlier mesh had the same points and the same field.
#pragma once

#include <vug/meshing/blocks.h>
#include <vug/meshing/polish_cache.h>
#include <vug/meshing/polygonize.h>

#include <functional>
#include <memory>
#include <vector>

namespace vug::meshing {

/// A pass: one result for each point, which the field around it and the inputs determine.
struct PolishPass {
  int number = 0;  ///< Distinguishes the passes.
  const field::Field& field;
  const std::vector<Vec3d>& points;
  BlockOptions blocks;
  /// Adds everything else that determines the result of a point, and the point itself.
  std::function<void(uint32_t index, std::vector<double>& inputs)> add_inputs;
};

/// Adds the coordinates of a point.
inline void add_numbers(const Vec3d& p, std::vector<double>& inputs) {
  inputs.insert(inputs.end(), {p.x, p.y, p.z});
}

/// The passes of the polish of one mesh.
class PolishPasses {
 public:
  /// `cache` may be null.
  PolishPasses(PolishCache* cache, double voxel, const PolygonizeOptions& options);

  /// Sets all results, as for_each_block with a body that sets those of its indices.
  template <class Result>
  void run(const PolishPass& pass, const BlockBody& body, std::vector<Result>& results,
           Progress& progress) const {
    const auto find = [&](const std::vector<uint32_t>& indices, const field::Field& local) {
      const Digest key = key_of(pass, indices, local);
      if (const auto found = cache_->find(key)) {
        const auto& known = *static_cast<const std::vector<Result>*>(found.get());
        for (size_t i = 0; i < known.size(); ++i) results[indices[i]] = known[i];
        return;
      }
      body(indices, local);
      auto made = std::make_shared<std::vector<Result>>();
      made->reserve(indices.size());
      for (const uint32_t i : indices) made->push_back(results[i]);
      const uint64_t bytes = sizeof(*made) + made->size() * sizeof(Result);
      cache_->insert(key, std::move(made), bytes);
    };
    for_each_block(pass.field, pass.points, pass.blocks, cache_ ? BlockBody(find) : body, progress);
  }

 private:
  Digest key_of(const PolishPass& pass, const std::vector<uint32_t>& indices,
                const field::Field& local) const;

  PolishCache* cache_;
  Digest settings_;
};

}  // namespace vug::meshing
