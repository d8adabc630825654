// SPDX-License-Identifier: Apache-2.0
#include <vug/lsystem/drawing_builder.h>

#include <cmath>

namespace vug::lsystem {
namespace {

Station station(const TurtleState& state, double radius, double along) {
  return {state.pose.position, state.pose.frame, radius, along, state.age};
}

}  // namespace

void DrawingBuilder::begin(TurtleState& state, double radius) {
  if (state.axis != Axis::kNone) {
    // A node may precede the stem's first segment, which sets the radius.
    Axis& begun = drawing_.axes[state.axis];
    if (begun.stations.size() == 1) begun.stations[0].radius = radius;
    return;
  }
  Axis axis;
  axis.parent = state.parent;
  axis.parent_along = state.parent_along;
  axis.colour = state.colour;
  if (axis.parent != Axis::kNone) {
    Axis& parent = drawing_.axes[axis.parent];
    axis.order = parent.order + 1;
    if (!parent.nodes.empty() && parent.nodes.back().along == axis.parent_along)
      parent.nodes.back().branches.push_back(state.pose.frame.tangent);
  }
  axis.stations.push_back(station(state, radius, 0));
  state.axis = static_cast<uint32_t>(drawing_.axes.size());
  drawing_.axes.push_back(std::move(axis));
}

void DrawingBuilder::extend(TurtleState& state, double length, double radius) {
  Axis& axis = drawing_.axes[state.axis];
  axis.stations.push_back(station(state, radius, axis.length() + length));
}

void DrawingBuilder::node(TurtleState& state, double size) {
  begin(state, state.radius);
  Axis& axis = drawing_.axes[state.axis];
  axis.nodes.push_back({axis.length(), size, {}});
}

int DrawingBuilder::order(const TurtleState& state) const {
  const uint32_t axis = state.axis != Axis::kNone ? state.axis : state.parent;
  return axis == Axis::kNone ? 0 : drawing_.axes[axis].order;
}

void DrawingBuilder::instance(const TurtleState& state, uint32_t name,
                              std::span<const double> parameters) {
  Instance out;
  out.name = name;
  out.position = state.pose.position;
  out.frame = state.pose.frame;
  out.age = state.age;
  out.order = order(state);
  out.colour = state.colour;
  if (!parameters.empty()) out.size = parameters[0];
  if (parameters.size() > 1) out.parameters.assign(parameters.begin() + 1, parameters.end());
  drawing_.instances.push_back(std::move(out));
}

void DrawingBuilder::open(const TurtleState& state) {
  open_.push_back({{}, state.colour, order(state)});
}

void DrawingBuilder::corner(const TurtleState& state) {
  std::vector<Vec3d>& corners = open_.back().corners;
  if (corners.empty() || corners.back() != state.pose.position)
    corners.push_back(state.pose.position);
}

void DrawingBuilder::close() {
  Polygon polygon = std::move(open_.back());
  open_.pop_back();
  std::vector<Vec3d>& corners = polygon.corners;
  // Drop the last corner if the outline returns to its start, up to rounding.
  if (corners.size() > 1) {
    const double size = (corners[1] - corners[0]).length();
    if ((corners.back() - corners.front()).length() <= 1e-9 * size) corners.pop_back();
  }
  if (corners.size() >= 3) drawing_.polygons.push_back(std::move(polygon));
}

}  // namespace vug::lsystem
