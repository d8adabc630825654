// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the leaves around a leaf. An accessor of the whole tree takes longer for the
// 26 neighbours of a leaf than most filters do, and most neighbours have the same parent.
#pragma once

#include <vug/base/parallel.h>

#include <openvdb/openvdb.h>

#include <algorithm>
#include <vector>

namespace vug::volume {

class LeafFinder {
 public:
  using Tree = openvdb::FloatTree;
  using Leaf = Tree::LeafNodeType;

  explicit LeafFinder(const Tree& tree) : accessor_(tree) {}

  /// Declares the leaf whose neighbours are asked for next.
  void move_to(const Leaf& leaf) {
    const openvdb::Coord node = origin_of_parent(leaf.origin());
    if (!parent_ || node != origin_) parent_ = accessor_.probeConstNode<Parent>(node);
    origin_ = node;
  }
  /// The leaf with this origin, or null.
  const Leaf* leaf(const openvdb::Coord& origin) {
    const bool sibling = parent_ && origin_of_parent(origin) == origin_;
    return sibling ? parent_->probeConstLeaf(origin) : accessor_.probeConstLeaf(origin);
  }
  float value(const openvdb::Coord& at) { return accessor_.getValue(at); }

 private:
  using Parent = Tree::RootNodeType::ChildNodeType::ChildNodeType;
  static openvdb::Coord origin_of_parent(const openvdb::Coord& at) {
    return at & ~static_cast<int>(Parent::DIM - 1);
  }

  openvdb::tree::ValueAccessor<const Tree, false> accessor_;
  const Parent* parent_ = nullptr;
  openvdb::Coord origin_;
};

/// Calls body(n, finder) for each leaf of the list in parallel, with a finder that was moved to it.
template <class Body>
void for_each_leaf(const LeafFinder::Tree& tree, const std::vector<LeafFinder::Leaf*>& leaves,
                   const Body& body) {
  constexpr size_t kChunk = 64;
  parallel_for((leaves.size() + kChunk - 1) / kChunk, [&](size_t chunk) {
    LeafFinder finder(tree);
    for (size_t n = chunk * kChunk; n < std::min((chunk + 1) * kChunk, leaves.size()); ++n) {
      finder.move_to(*leaves[n]);
      body(n, finder);
    }
  });
}

}  // namespace vug::volume
