// SPDX-License-Identifier: Apache-2.0
// The output of a turtle: axes of stems with their nodes, polygons, and instances of named objects
// such as leaves. This is the representation between words and geometry, in metres and radians,
// right-handed. Value types.
#pragma once

#include <vug/base/frames.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vug::lsystem {

/// A cross-section of a stem. Between stations a stem is straight and its radius changes linearly.
struct Station {
  Vec3d position;
  Frame frame;        ///< Tangent: the turtle's heading; normal: its left; binormal: its up.
  double radius = 0;  ///< Metres; 0 if no width was set.
  double along = 0;   ///< Arc length from the start of the axis, metres.
  double age = 0;

  bool operator==(const Station&) const = default;
};

/// A node of an axis, at which leaves and branches are attached and a bamboo has its ring.
struct Node {
  double along = 0;
  double size = 1;              ///< Relative size of its relief.
  std::vector<Vec3d> branches;  ///< Initial directions of the attached axes, in order.

  bool operator==(const Node&) const = default;
};

/// One stem, drawn without lifting the pen or entering a branch. It has two or more stations, or
/// one if it consists only of a node.
struct Axis {
  static constexpr uint32_t kNone = UINT32_MAX;

  int order = 0;            ///< Branching order; 0 for independent stems.
  uint32_t parent = kNone;  ///< The parent axis, always an earlier one.
  double parent_along = 0;  ///< Arc length of the attachment on the parent, metres.
  int colour = 0;
  std::vector<Station> stations;
  std::vector<Node> nodes;

  double length() const { return stations.back().along; }
  bool operator==(const Axis&) const = default;
};

struct Polygon {
  std::vector<Vec3d> corners;  ///< At least three.
  int colour = 0;
  int order = 0;

  bool operator==(const Polygon&) const = default;
};

/// An instance of a named object. The object's y axis points along the frame's tangent, its x axis
/// against the normal (to the turtle's right) and its z axis along the binormal.
struct Instance {
  uint32_t name = 0;  ///< Index into Drawing::names.
  Vec3d position;
  Frame frame;
  double size = 1;  ///< The first parameter; default 1.
  double age = 0;
  int order = 0;  ///< Order of the axis that it is attached to.
  int colour = 0;
  std::vector<double> parameters;  ///< The parameters after the first.

  Mat44d to_world() const;  ///< Row vectors: p * to_world().
  bool operator==(const Instance&) const = default;
};

struct Drawing {
  std::vector<Axis> axes;
  std::vector<Polygon> polygons;
  std::vector<std::string> names;  ///< Names of the instanced objects.
  std::vector<Instance> instances;

  /// Bounds of all stations with their radii, of polygons and of the positions of instances
  /// (without their extent); empty if nothing is drawn.
  Box3d bounds() const;
  bool operator==(const Drawing&) const = default;
};
using DrawingPtr = std::shared_ptr<const Drawing>;

/// The interpolated station at an arc length, which is clamped to the axis. The axis must have at
/// least two stations.
Station station_at(const Axis& axis, double along);

}  // namespace vug::lsystem
