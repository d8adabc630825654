// Where rays leave the box around a scene.
#pragma once

#include <vug/render/lighting/rectangle_shape.h>
#include <vug/render/vectors.h>

#include <atomic>
#include <memory>
#include <vector>

namespace vug::render {

/// Counts on a grid over each face of the box. Any threads may count at once; the counts, and so
/// the rectangles, do not depend on their order.
class BoundaryHits {
 public:
  explicit BoundaryHits(const Box3f& box);

  /// The ray starts in the box and is known to leave it.
  void count(const Ray& ray);
  /// At most `most` rectangles in the faces, their normals turned inwards, around the cells where
  /// rays left that touch each other; those with the most rays. Each is wider by `margin` cells.
  std::vector<RectangleParams> rectangles(size_t most, int margin) const;

 private:
  static constexpr int kCells = 64;
  struct CellGroup {
    int face = 0;
    int u0 = kCells, v0 = kCells, u1 = -1, v1 = -1;  ///< Cells; the last ones are in it.
    uint64_t rays = 0;
  };
  uint64_t rays(int face, int u, int v) const;
  std::vector<CellGroup> groups() const;
  RectangleParams rectangle(const CellGroup& group, int margin) const;

  Box3f box_;
  std::unique_ptr<std::atomic<uint32_t>[]> counts_;
};

}  // namespace vug::render
