// SPDX-License-Identifier: Apache-2.0
// Internal to the turtle: builds axes, polygons and instances of a Drawing.
#pragma once

#include <vug/lsystem/turtle.h>

namespace vug::lsystem {

/// The turtle's state, saved and restored by brackets.
struct TurtleState {
  TurtlePose pose;
  double radius = 0;
  bool radius_set = false;  ///< The radius was set since the start of the branch.
  double age = 0;
  int colour = 0;
  double elasticity = 0;
  uint32_t axis = Axis::kNone;  ///< The axis that the next F extends.
  uint32_t parent = Axis::kNone;
  double parent_along = 0;
  int guide = -1;  ///< The guide curve that it follows; negative: none.
  double guide_along = 0;
  double guide_scale = 1;
  std::array<Vec3d, 3> guide_axes;  ///< World-space directions of the guide's x, y and z axes.
};

class DrawingBuilder {
 public:
  explicit DrawingBuilder(Drawing& drawing) : drawing_(drawing) {}

  /// Starts an axis at the state's pose unless there is a current one; `radius` is its start
  /// radius.
  void begin(TurtleState& state, double radius);
  /// Extends the axis by `length` to the state's pose.
  void extend(TurtleState& state, double length, double radius);
  void node(TurtleState& state, double size);
  void instance(const TurtleState& state, uint32_t name, std::span<const double> parameters);
  int order(const TurtleState& state) const;
  /// Current length of the state's axis.
  double length(const TurtleState& state) const { return drawing_.axes[state.axis].length(); }

  bool polygon_open() const { return !open_.empty(); }
  size_t open_polygons() const { return open_.size(); }
  void open(const TurtleState& state);
  void corner(const TurtleState& state);
  void close();

 private:
  Drawing& drawing_;
  std::vector<Polygon> open_;
};

}  // namespace vug::lsystem
