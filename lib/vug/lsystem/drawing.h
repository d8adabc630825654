// What a turtle leaves behind: axes of stems with their nodes, polygons, and places of named things
// (leaves). The data between words and geometry, in metres and radians, right-handed. A value.
#pragma once

#include <vug/base/frames.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vug::lsystem {

/// A cross-section of a stem. Between stations a stem runs straight, its radius changes evenly.
struct Station {
  Vec3d position;
  Frame frame;        ///< Tangent: where the turtle headed; normal: its left; binormal: its up.
  double radius = 0;  ///< 0 where nothing said how thick it is.
  double along = 0;   ///< Arc length from the axis' start.
  double age = 0;

  bool operator==(const Station&) const = default;
};

/// Where leaves and branches leave an axis and a bamboo has its ring.
struct Node {
  double along = 0;
  double size = 1;              ///< Of its relief, against others.
  std::vector<Vec3d> branches;  ///< Directions in which axes leave, in order.

  bool operator==(const Node&) const = default;
};

/// One stem: what is drawn without lifting the pen or going into a branch. It has one station where
/// it is only a node so far, else two or more.
struct Axis {
  static constexpr uint32_t kNone = UINT32_MAX;

  int order = 0;            ///< 0 for stems on their own, one more for each branching.
  uint32_t parent = kNone;  ///< The axis it leaves, always an earlier one.
  double parent_along = 0;  ///< Where on that.
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

/// A place where a thing of that name stands, its y axis along the frame's tangent, its x axis
/// against the normal (the turtle's right) and its z axis along the binormal.
struct Instance {
  uint32_t name = 0;  ///< Index into Drawing::names.
  Vec3d position;
  Frame frame;
  double size = 1;  ///< The first parameter, 1 without.
  double age = 0;
  int order = 0;  ///< Of the axis it stands on.
  int colour = 0;
  std::vector<double> parameters;  ///< Those after the first.

  Mat44d to_world() const;  ///< Row vectors: p * to_world().
  bool operator==(const Instance&) const = default;
};

struct Drawing {
  std::vector<Axis> axes;
  std::vector<Polygon> polygons;
  std::vector<std::string> names;  ///< Of instances.
  std::vector<Instance> instances;

  /// Around all stations with their radii, polygons and places of instances (without their
  /// extent); empty when nothing is drawn.
  Box3d bounds() const;
  bool operator==(const Drawing&) const = default;
};
using DrawingPtr = std::shared_ptr<const Drawing>;

/// The station at an arc length, between those of an axis that has two; kept within its ends.
Station station_at(const Axis& axis, double along);

}  // namespace vug::lsystem
