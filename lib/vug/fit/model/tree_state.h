// A tree with what is known of it: where its areas lie and how many bits each node costs.
#pragma once

#include <vug/fit/model/tree.h>

namespace vug::fit {

/// One of the places that an area has in the picture: repetitions and mirror images have several.
struct AreaInstance {
  int16_t x = 0;  ///< Of its left edge in the picture.
  bool mirrored = false;
  bool operator==(const AreaInstance&) const = default;
};

/// A node's area.
struct Area {
  int16_t width = 0, height = 0;
  int16_t y = 0;      ///< Of its top in the picture, the same in all places.
  int16_t count = 0;  ///< How many places it has,
  int32_t first = 0;  ///< and the first of them among State::frames; that one is not mirrored.
  bool operator==(const Area&) const = default;
};

struct TreeState {
  Tree tree;

  // What follows is made of the tree by Model and kept as long as it holds.
  std::vector<Area> areas;
  std::vector<AreaInstance> instances;
  std::vector<double> bits;         ///< Of each node: its parameters and the pixels it answers for.
  std::vector<uint8_t> bits_valid;  ///< Whether they hold.
  bool areas_valid = false;         ///< Whether the areas hold.

  const Area& area(int i) const { return areas[static_cast<size_t>(i)]; }
  const AreaInstance& instance(const Area& area, int number) const {
    return instances[static_cast<size_t>(area.first + number)];
  }
  /// Says that parameters of node i have changed that no area depends on.
  void invalidate_bits(int i) { bits_valid[static_cast<size_t>(i)] = 0; }
  /// Says that areas may have changed.
  void invalidate_areas() { areas_valid = false; }

  /// The tree's own, keeping what is known of the nodes that stay.
  void grow(int i, int production, const std::vector<Node>& parts);
  void prune(int i);
  void insert(int i, int at, const Node& node);
  void erase(int i, int at);
  /// Puts other nodes, a whole subtree, in place of that of node i.
  void replace(int i, const std::vector<Node>& nodes);
};

}  // namespace vug::fit
