// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/drawing.h>

#include <algorithm>
#include <cmath>

namespace vug::workbench {
namespace {

using facade::Placement;
using modeller::FacadeState;

void add(const FacadeState& state, int index, Shape::Kind kind, std::vector<Shape>& out) {
  const facade::Node& node = state.node(index);
  bool first = true;
  for (const Placement& place : facade::placements(state.tree(), index)) {
    out.push_back({kind, place(node.rect), index, first, node.symbol});
    first = false;
  }
}

}  // namespace

std::vector<Shape> shapes(const FacadeState& state) {
  std::vector<Shape> out;
  for (size_t i = 0; i < state.tree().nodes.size(); ++i) {
    const facade::Node& node = state.tree().nodes[i];
    add(state, static_cast<int>(i),
        node.element ? Shape::Kind::element
        : node.stuck ? Shape::Kind::open
                     : Shape::Kind::part,
        out);
  }
  return out;
}

std::vector<facade::Rect> instances(const FacadeState& state, int node) {
  std::vector<facade::Rect> out;
  if (node == FacadeState::kWhole) return {{0, 0, state.canvas().width, state.canvas().height}};
  for (const Placement& place : facade::placements(state.tree(), node))
    out.push_back(place(state.node(node).rect));
  return out;
}

std::vector<Shape> ghosts(const FacadeState& before, int node, const FacadeState& after) {
  std::vector<Shape> out;
  std::vector<int> left = {after.at(before.path_keys(node))};
  while (!left.empty()) {
    const int at = left.back();
    left.pop_back();
    if (at == FacadeState::kWhole) continue;
    for (const int part : after.parts(at)) {
      add(after, part, Shape::Kind::ghost, out);
      left.push_back(part);
    }
  }
  return out;
}

double snapped(double metres, double pixels_per_metre) {
  // Whole numbers of steps in a metre, so that results are the decimal numbers that users read.
  for (const double steps : {1000.0, 500.0, 200.0, 100.0, 50.0, 20.0, 10.0, 5.0, 2.0})
    if (steps <= pixels_per_metre) return std::round(steps * metres) / steps;
  return std::round(metres);
}

CanvasView CanvasView::zoomed(double factor, double at_x, double at_y) const {
  const double to = std::clamp(scale * factor, kMinScale, kMaxScale);
  const double by = to / scale;
  return {to, at_x - by * (at_x - x), at_y - by * (at_y - y)};
}

CanvasView CanvasView::whole(double width, double height, double canvas_width, double canvas_height,
                             double margin) {
  const double room_x = std::max(1.0, canvas_width - 2 * margin);
  const double room_y = std::max(1.0, canvas_height - 2 * margin);
  const double scale = std::clamp(std::min(room_x / width, room_y / height), kMinScale, kMaxScale);
  return {scale, (canvas_width - scale * width) / 2, (canvas_height + scale * height) / 2};
}

}  // namespace vug::workbench
