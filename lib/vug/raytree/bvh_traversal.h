// Rays on their way through a RayTree.
#pragma once

#include <vug/raytree/wide_bvh.h>

#include <array>
#include <cstdint>
#include <span>

namespace vug::render {

/// Steps have as few branches as can be: rays are incoherent, so a guess at which child is met or
/// nearer is wrong every other time, and costs more than sorting all eight.
class RaySearch {
 public:
  enum class Aim : uint8_t { nearest, any };
  /// What the next step does: look at the boxes of a node or at the triangles of a leaf; or that
  /// there is none.
  enum Stage : uint8_t {
    boxes_for_nearest,
    boxes_for_any,
    triangles_for_nearest,
    triangles_for_any,
    ended
  };
  static constexpr size_t kStages = 4;

  /// For triangles before `distance`; direction: unit. With Aim::any the search ends with the first
  /// that is met.
  RaySearch(const RayTree& tree, const Ray& ray, float distance, Aim aim);

  Stage stage() const { return stage_; }
  /// All steps.
  void go();

  bool found() const { return leaf_ != kNone; }
  /// Of what was found, or as it was given.
  float distance() const { return far_; }
  uint32_t triangle() const { return leaf().triangle[lane_]; }
  /// Its mesh: RayTree::Part::number.
  uint32_t part() const { return leaf().part[lane_] & ((1u << RayTree::kTurn) - 1); }
  /// In the order of the mesh.
  std::array<Vec3f, 3> corners() const;

 private:
  friend class RayBatch;
  static constexpr uint32_t kNone = ~0u;
  const RayTree::Leaf& leaf() const { return tree_.leaf(leaf_); }
  /// The next step, which is known to be of that stage; makes the one after it known, and calls for
  /// what that will read.
  template <Stage stage>
  void step();
  template <Aim aim>
  void enter(const RayTree::Node& node);
  void meet(uint32_t number);

  const RayTree& tree_;
  alignas(16) std::array<float, 4> origin_, inverse_, slack_;
  std::array<float, 3> shear_;  ///< Makes the ray run along the last of its axes.
  std::array<uint32_t, 3> axes_;
  std::array<uint32_t, 3> near_;  ///< Offsets of the planes where the ray enters a box.
  float far_;
  uint32_t leaf_ = kNone, lane_ = 0;
  uint32_t next_ = 0;  ///< Node or leaf.
  uint32_t waiting_ = 0;
  Stage stage_;
  // Children that the ray meets, the nearest last, and where it does.
  std::array<uint32_t, RayTree::kMostWaiting> children_;
  std::array<int32_t, RayTree::kMostWaiting> distances_;  ///< Bits of floats, which compare alike.
};

/// Searches that go on together: while memory fetches what one of them will read, others take their
/// step. Those of one stage take it one after the other, so that no branch needs to be guessed.
class RayBatch {
 public:
  static constexpr size_t kMost = 16;

  /// Which is not at its end; `slot` is below kMost and free.
  void add(size_t slot, RaySearch& search);
  /// One step of each. The slots of those that came to their end, which are free again.
  std::span<const uint8_t> step();

 private:
  struct Queue {
    std::array<uint8_t, kMost> slots{};
    size_t size = 0;
  };
  template <RaySearch::Stage stage>
  void step_all();

  std::array<RaySearch*, kMost> searches_{};
  std::array<Queue, RaySearch::kStages + 1> now_{}, next_{};  ///< By stage.
};

}  // namespace vug::render
