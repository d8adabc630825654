// SPDX-License-Identifier: Apache-2.0
// A tree with cached results: the areas of its nodes and the bits that each node costs.
#pragma once

#include <vug/fit/model/tree.h>

namespace vug::fit {

/// One instance of an area in the picture: repeated and mirrored parts have several.
struct AreaInstance {
  int16_t x = 0;  ///< Left edge in the picture.
  bool mirrored = false;
  bool operator==(const AreaInstance&) const = default;
};

/// The area of a node.
struct Area {
  int16_t width = 0, height = 0;
  int16_t y = 0;      ///< Top edge in the picture, the same for all instances.
  int16_t count = 0;  ///< Number of instances.
  /// Index of the first instance in TreeState::instances, which is never mirrored.
  int32_t first = 0;
  bool operator==(const Area&) const = default;
};

struct TreeState {
  Tree tree;

  // Caches that Model computes from the tree.
  std::vector<Area> areas;
  std::vector<AreaInstance> instances;
  /// Bits per node: its parameters and the pixels it accounts for.
  std::vector<double> bits;
  std::vector<uint8_t> bits_valid;  ///< Per node: whether `bits` is up to date.
  bool areas_valid = false;         ///< Whether `areas` and `instances` are up to date.

  const Area& area(int i) const { return areas[static_cast<size_t>(i)]; }
  const AreaInstance& instance(const Area& area, int number) const {
    return instances[static_cast<size_t>(area.first + number)];
  }
  /// Marks node i after a change of parameters that does not affect areas.
  void invalidate_bits(int i) { bits_valid[static_cast<size_t>(i)] = 0; }
  /// Marks the areas after a change that may affect them.
  void invalidate_areas() { areas_valid = false; }

  /// The operations of Tree; caches of unaffected nodes are kept.
  void grow(int i, int production, const std::vector<Node>& parts);
  void prune(int i);
  void insert(int i, int at, const Node& node);
  void erase(int i, int at);
  /// Replaces the subtree of node i.
  void replace(int i, const std::vector<Node>& nodes);
};

}  // namespace vug::fit
