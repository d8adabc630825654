// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/handles.h>

#include <algorithm>
#include <cmath>

namespace vug::workbench {
namespace {

using facade::Placement;
using facade::Rect;
using modeller::FacadeState;

/// The rectangle of an instance, and whether its frame runs from right to left on the plane.
struct Frame {
  Rect rect;
  bool turned = false;

  double x(double own) const { return turned ? rect.right() - own : rect.x + own; }
  double own(double x) const { return turned ? rect.right() - x : x - rect.x; }
};

Frame frame_of(const FacadeState& state, int node, const Placement& place) {
  return {place(state.node(node).rect), place.mirrored != state.planned(node).mirrored};
}

const facade::FreeNumber* number(const FacadeState& state, int node, const std::string& name) {
  for (const facade::FreeNumber& each : state.planned(node).free)
    if (each.name == name) return &each;
  return nullptr;
}

/// Edges of the lower left window of a grid whose size is free.
void add_sizes(const FacadeState& state, int node, std::vector<Handle>& out) {
  if (state.node(node).split != "grid") return;
  for (const auto& [size, start] : {std::pair("width", "x"), std::pair("height", "y")}) {
    const facade::FreeNumber* extent = number(state, node, size);
    const facade::FreeNumber* from = number(state, node, start);
    if (!extent || !from || extent->values.empty() || from->values.empty()) continue;
    Handle made;
    made.line = false, made.upright = start[0] == 'x', made.number = size;
    made.origin = from->values[0];
    made.at = made.origin + extent->values[0];
    out.push_back(made);
  }
}

/// Sets the segment of a handle, along the whole instance, or along the window for a size.
void place_segment(const FacadeState& state, int node, const Frame& frame, Handle& handle) {
  double low = 0, high = handle.upright ? frame.rect.height : frame.rect.width;
  if (!handle.line) {
    const facade::FreeNumber* start = number(state, node, handle.upright ? "y" : "x");
    const facade::FreeNumber* size = number(state, node, handle.upright ? "height" : "width");
    if (start && size) low = start->values[0], high = low + size->values[0];
  }
  if (handle.upright) {
    handle.x0 = handle.x1 = frame.x(handle.at);
    handle.y0 = frame.rect.y + low, handle.y1 = frame.rect.y + high;
  } else {
    handle.y0 = handle.y1 = frame.rect.y + handle.at;
    handle.x0 = std::min(frame.x(low), frame.x(high));
    handle.x1 = std::max(frame.x(low), frame.x(high));
  }
}

double distance(const Handle& handle, double x, double y) {
  const double dx = std::max({handle.x0 - x, 0.0, x - handle.x1});
  const double dy = std::max({handle.y0 - y, 0.0, y - handle.y1});
  return std::hypot(dx, dy);
}

}  // namespace

int numbers_node(const FacadeState& state, int node) {
  if (node == FacadeState::kWhole) return node;
  for (int below = node;; below = state.parts(below)[0]) {
    if (!state.planned(below).free.empty()) return below;
    if (state.parts(below).size() != 1) break;
  }
  for (int above = state.node(node).parent; above >= 0; above = state.node(above).parent)
    if (!state.planned(above).free.empty()) return above;
  return FacadeState::kWhole;
}

std::vector<Handle> handles(const FacadeState& state, int node) {
  if (node == FacadeState::kWhole) return {};
  std::vector<Handle> own;
  for (const modeller::Line& line : modeller::lines(state, node)) {
    Handle made;
    made.upright = line.upright, made.number = line.number, made.at = line.at;
    own.push_back(made);
  }
  add_sizes(state, node, own);
  std::vector<Handle> out;
  const std::vector<Placement> places = facade::placements(state.tree(), node);
  for (size_t instance = 0; instance < places.size(); ++instance)
    for (size_t index = 0; index < own.size(); ++index) {
      Handle made = own[index];
      made.index = index, made.instance = instance;
      place_segment(state, node, frame_of(state, node, places[instance]), made);
      out.push_back(made);
    }
  return out;
}

std::optional<Handle> handle_at(const std::vector<Handle>& handles, double x, double y,
                                double tolerance) {
  const Handle* best = nullptr;
  for (const Handle& each : handles) {
    const double apart = distance(each, x, y);
    if (apart > tolerance) continue;
    const bool nearer =
        !best || (each.line == best->line ? apart < distance(*best, x, y) : best->line);
    if (nearer) best = &each;
  }
  return best ? std::optional(*best) : std::nullopt;
}

double own_position(const FacadeState& state, int node, const Handle& handle, double x, double y) {
  const std::vector<Placement> places = facade::placements(state.tree(), node);
  const Frame frame = frame_of(state, node, places.at(handle.instance));
  return handle.upright ? frame.own(x) : y - frame.rect.y;
}

modeller::Edit drag_edit(const FacadeState& state, int node, const Handle& handle, double to) {
  modeller::Edit out;
  out.node = state.path(node);
  if (handle.line) {
    out.kind = "move";
    out.numbers = {{"line", {static_cast<double>(handle.index)}}, {"to", {to}}};
  } else {
    out.kind = "set";
    out.numbers = {{handle.number, {to - handle.origin}}};
  }
  return out;
}

}  // namespace vug::workbench
