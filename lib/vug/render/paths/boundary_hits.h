// SPDX-License-Identifier: Apache-2.0
// Counts where rays leave the scene's bounding box.
#pragma once

#include <vug/render/lighting/rectangle_shape.h>
#include <vug/render/vectors.h>

#include <atomic>
#include <memory>
#include <vector>

namespace vug::render {

/// Counts on a grid over each face of the box. Thread-safe; the counts, and so the rectangles, do
/// not depend on the order of rays.
class BoundaryHits {
 public:
  explicit BoundaryHits(const Box3f& box);

  /// The ray starts in the box and must be known to leave it.
  void count(const Ray& ray);
  /// At most `most` rectangles in the faces, with inward normals, around connected groups of hit
  /// cells; the groups with the most rays come first. Each is enlarged by `margin` cells.
  std::vector<RectangleParams> rectangles(size_t most, int margin) const;

 private:
  static constexpr int kCells = 64;
  struct CellGroup {
    int face = 0;
    int u0 = kCells, v0 = kCells, u1 = -1, v1 = -1;  ///< Cell ranges; inclusive.
    uint64_t rays = 0;
  };
  uint64_t rays(int face, int u, int v) const;
  std::vector<CellGroup> groups() const;
  RectangleParams rectangle(const CellGroup& group, int margin) const;

  Box3f box_;
  std::unique_ptr<std::atomic<uint32_t>[]> counts_;
};

}  // namespace vug::render
