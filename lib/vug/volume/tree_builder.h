// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: builds an OpenVDB tree from nodes that many threads fill, and sets the
// grid's transform and class. The result does not depend on the order of the nodes.
#pragma once

#include <vug/volume/block.h>
#include <vug/volume/grid_access.h>

namespace vug::volume {

/// One node of 128^3 voxels while its 16^3 blocks are computed. Different blocks may be set from
/// different threads.
class Brick {
 public:
  static constexpr int64_t kSize = 128;

  explicit Brick(const Cell& cell);
  ~Brick();
  Brick(const Brick&) = delete;
  Brick& operator=(const Brick&) = delete;

  const Cell& cell() const { return cell_; }
  void set(const Cell& cell, const Block& block);
  void fill_inside(const Cell& cell);

 private:
  friend class TreeBuilder;
  struct Slots;
  size_t slot(const Cell& cell) const;

  Cell cell_;
  std::unique_ptr<Slots> slots_;
};

class TreeBuilder {
 public:
  TreeBuilder(double voxel, float background);
  ~TreeBuilder();
  TreeBuilder(const TreeBuilder&) = delete;
  TreeBuilder& operator=(const TreeBuilder&) = delete;

  void add(Brick& brick);              ///< Thread-safe; moves the brick's leaves into the tree.
  void fill_inside(const Cell& cell);  ///< Thread-safe; for a cell of 128^3 or more.
  std::shared_ptr<openvdb::GridBase> finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vug::volume
