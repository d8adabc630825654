// SPDX-License-Identifier: Apache-2.0
// The ways of the water that drips into a cave, as plain data. World space in metres, y up.
#pragma once

#include <vug/base/vec.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vug::drips {

struct Water {
  double discharge = 0;    ///< m3/s
  double calcium = 0;      ///< mol/m3
  double temperature = 0;  ///< Degrees Celsius.
  double age = 0;          ///< Years for which it has flowed here.
};

enum class NodeKind {
  seep,        ///< Water leaves a joint, a bed or the pores of the roof.
  confluence,  ///< Two films meet.
  bend,        ///< A film passes from a roof to a wall, or from a wall to a floor.
  drop,        ///< Drops detach.
  landing,     ///< They land.
  pool,        ///< Water stands up to its spill level.
  sink,        ///< It leaves the region, or no lower way was found.
};

/// The name of the enumerator, for files: "seep".
const char* kind_name(NodeKind kind);

struct Node {
  NodeKind kind = NodeKind::seep;
  /// The number of the drip, for its seep, drop and landing; that of the drip that joined, for a
  /// confluence; that of the lattice's column, for pools. It depends on the seed, the box and the
  /// spacing, and not on density, masks, joints or ages.
  int64_t id = 0;
  Vec3d position{0.0};  ///< On the surface of the rock.
  Vec3d normal{0.0};    ///< Unit normal of the surface, into the air.
  Water water{};        ///< As it leaves the node.
  int plane = -1;       ///< Index into Graph::planes, of seeps on a joint, a fault or a bed.
  /// Length in metres of the stalactite at a drop, height of the stalagmite at a landing, if they
  /// have room.
  double growth = 0;
  double arriving = 0;  ///< At a drop: the calcium of the water above the stalactite, mol/m3.
  double longest = 0;   ///< At a drop with a straw: the length that the straw approaches, metres.
  /// At a landing: the years since stalactite and stalagmite met, if both grow, and the height of
  /// the stalagmite then in metres.
  double met = 0, met_at = 0;
  Vec3d tip{0.0};      ///< End of the stalactite at a drop, from which drops fall.
  bool straw = false;  ///< At a drop: the stalactite is a straw, whose canal is open.
  double scatter = 0;  ///< Radius in metres within which drops from the roof land.
  double level = 0;    ///< Height of the water of a pool.
};

enum class EdgeKind { ceiling_film, wall_film, fall, floor_film, overflow };

/// The name of the enumerator, for files: "ceiling_film".
const char* kind_name(EdgeKind kind);

struct Edge {
  EdgeKind kind = EdgeKind::ceiling_film;
  int from = 0, to = 0;       ///< Indices of nodes; water runs to `to`.
  std::vector<Vec3d> path{};  ///< From node to node, at least two points.
  Water water{};              ///< At its start.
};

/// The edges out of a node have larger indices than those into it.
struct Graph {
  std::vector<Node> nodes{};
  std::vector<Edge> edges{};
  std::vector<std::string> planes{};  ///< "joint 3", "bed 1": those at which water seeps.
  double drop = 0;                    ///< The volume of a drop in m3.

  /// Seconds from drop to drop at a node.
  double interval(const Node& node) const { return drop / node.water.discharge; }
};

}  // namespace vug::drips
