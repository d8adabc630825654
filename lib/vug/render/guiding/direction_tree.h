// A density over directions as a quadtree: coarse where little light comes from, fine where much.
#pragma once

#include <vug/render/vectors.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vug::render {

/// The square of directions (`place_of` in sampling.h) cut into four again and again: Mueller,
/// Gross, Novak 2017, "Practical path guiding for efficient light-transport simulation", section
/// 3.2 (mueller2017guiding). Every leaf has an even density.
class DirectionTree {
 public:
  /// A tree of one uncut square, even over all directions.
  DirectionTree();

  /// The leaf a direction lies in, numbered 0 <= leaf < leaf_count().
  size_t leaf(const Vec3f& direction) const;
  size_t leaf_count() const { return 4 * nodes_.size(); }

  /// The same squares with a density in proportion to what each leaf has gathered (leaf_count()
  /// values, >= 0; entries of squares that are cut further do not count). Even without any.
  DirectionTree weighed(const std::vector<double>& gathered) const;
  /// The squares for the next round: those cut that hold more than `share` of the whole density,
  /// at most `deepest` times; the others joined. Its own density is meaningless until weighed.
  DirectionTree recut(double share, int deepest) const;

  Vec3f sample(const Vec2f& u) const;
  /// Over solid angle.
  float pdf(const Vec3f& direction) const;

 private:
  struct Node {
    std::array<uint32_t, 4> child{0, 0, 0, 0};  ///< 0: a leaf. Quarter = right + 2 * upper.
    std::array<float, 4> part{0.25f, 0.25f, 0.25f, 0.25f};  ///< Of the node's own density.
  };
  double gather(uint32_t node, const std::vector<double>& gathered);
  void cut(const DirectionTree& from, uint32_t source, uint32_t node, double held, double share,
           int deeper);

  std::vector<Node> nodes_;
};

}  // namespace vug::render
