// Where light comes from, for every place of a scene: learned from paths and followed by later
// ones, so that they find the light that falls in through holes.
#pragma once

#include <vug/render/guiding/direction_tree.h>
#include <vug/render/vectors.h>

#include <atomic>
#include <memory>
#include <vector>

namespace vug::render {

/// Space in regions, halved along x, y and z in turn where many paths come by, and a density over
/// directions for each: the SD-tree of Mueller, Gross, Novak 2017 (mueller2017guiding).
class Guide {
 public:
  /// One region that knows nothing. `bounds` of the scene; points beyond count as on its border.
  explicit Guide(const Box3f& bounds);

  /// Null where too few paths came by to tell.
  const DirectionTree* at(const Vec3f& point) const;
  size_t region_count() const { return regions_.size(); }
  /// About what it takes, in bytes.
  size_t bytes() const;

 private:
  friend class GuideTraining;
  struct Node {
    uint32_t child = 0;  ///< The first of two nodes beside each other; 0: a leaf.
    uint32_t region = 0;
  };
  struct Region {
    DirectionTree directions;
    bool known = false;
  };
  struct Place {
    uint32_t region = 0;
    Vec3f size;  ///< Of the region, metres.
  };
  Place locate(const Vec3f& point) const;
  void halve(uint32_t node, uint64_t records, int depth);

  Box3f bounds_;
  std::vector<Node> nodes_;
  std::vector<Region> regions_;
};

/// One round of learning. `record` may be called by many threads at once and in any order: what is
/// gathered is counted in integers, so the outcome has the same bits.
class GuideTraining {
 public:
  /// Learns into the regions and squares that `last` found worth telling apart.
  explicit GuideTraining(const Guide& last);

  /// Light that came to `point` along `direction` (unit, pointing away from the point): what it is
  /// worth there, over the density with which the direction was chosen; >= 0.
  void record(const Vec3f& point, const Vec3f& direction, float worth);
  /// What was learned in this round.
  Guide finish() const;

 private:
  Guide structure_;
  std::vector<size_t> first_;  ///< For each region the first of its leaves in gathered_.
  std::unique_ptr<std::atomic<int64_t>[]> gathered_;
  std::unique_ptr<std::atomic<uint64_t>[]> records_;
};

}  // namespace vug::render
