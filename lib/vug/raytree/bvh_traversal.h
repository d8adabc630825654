// SPDX-License-Identifier: Apache-2.0
// Resumable ray queries on a WideBvh, and batches of them that advance in turn.
#pragma once

#include <vug/raytree/wide_bvh.h>

#include <array>
#include <cstdint>
#include <span>

namespace vug::raytree {

/// One ray query, advanced one node or leaf at a time. Steps have as few branches as possible: rays
/// are incoherent, so predictions of which child is hit or nearer fail every other time, and cost
/// more than sorting all eight.
class BvhTraversal {
 public:
  enum class Query : uint8_t { closest, any };
  /// The work of the next step: intersect the boxes of a node or the triangles of a leaf.
  enum Stage : uint8_t { node_closest, node_any, leaf_closest, leaf_any, ended };
  static constexpr size_t kStages = 4;

  /// Considers triangles at less than `distance`. The ray's direction must have unit length. With
  /// Query::any the traversal ends at the first triangle that is hit.
  BvhTraversal(const WideBvh& bvh, const Ray& ray, float distance, Query query);

  Stage stage() const { return stage_; }
  /// Takes all remaining steps.
  void run();

  bool hit() const { return leaf_ != kNone; }
  /// Distance to the hit; without one, the limit given to the constructor.
  float distance() const { return far_; }
  uint32_t triangle() const { return leaf().triangle[lane_]; }
  /// The mesh that was hit: WideBvh::Geometry::id.
  uint32_t geometry() const { return leaf().geometry[lane_] & ((1u << WideBvh::kTurnShift) - 1); }
  /// Corners of the hit triangle in the order of its mesh.
  std::array<Vec3f, 3> corners() const;

 private:
  friend class TraversalBatch;
  static constexpr uint32_t kNone = ~0u;
  const WideBvh::Leaf& leaf() const { return bvh_.leaf(leaf_); }
  /// Takes the next step, which must be of this stage; then determines the step after it and
  /// prefetches its memory.
  template <Stage stage>
  void step();
  template <Query query>
  void intersect_node(const WideBvh::Node& node);
  void intersect_leaf(uint32_t number);

  const WideBvh& bvh_;
  alignas(16) std::array<float, 4> origin_, inverse_, slack_;
  std::array<float, 3> shear_;  ///< Aligns the ray with the last of its axes.
  std::array<uint32_t, 3> axes_;
  std::array<uint32_t, 3> near_;  ///< Offsets of the planes through which the ray enters a box.
  float far_;
  uint32_t leaf_ = kNone, lane_ = 0;
  uint32_t next_ = 0;  ///< Node or leaf.
  uint32_t stack_size_ = 0;
  Stage stage_;
  // The stack: children that the ray meets, the nearest on top, and their distances.
  std::array<uint32_t, WideBvh::kStackSize> children_;
  std::array<int32_t, WideBvh::kStackSize> distances_;  ///< Bits of floats, which compare alike.
};

/// Traversals that advance in turn: while memory is fetched for one, others take their steps.
/// Traversals of the same stage step one after the other, so that no branch is mispredicted.
class TraversalBatch {
 public:
  static constexpr size_t kCapacity = 16;

  /// The traversal must not have ended; `slot` is below kCapacity and free.
  void add(size_t slot, BvhTraversal& traversal);
  /// Advances each traversal by one step. Returns the slots of those that have ended; these slots
  /// are free again.
  std::span<const uint8_t> step();

 private:
  struct Queue {
    std::array<uint8_t, kCapacity> slots{};
    size_t size = 0;
  };
  template <BvhTraversal::Stage stage>
  void step_all();

  std::array<BvhTraversal*, kCapacity> traversals_{};
  std::array<Queue, BvhTraversal::kStages + 1> now_{}, next_{};  ///< By stage.
};

}  // namespace vug::raytree
