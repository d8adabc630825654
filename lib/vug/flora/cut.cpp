// SPDX-License-Identifier: Apache-2.0
#include <vug/flora/cut.h>

#include <algorithm>

namespace vug::flora {
namespace {

using lsystem::Axis;

/// The part of the axis between two lengths; without stations if it is empty.
Axis between(const Axis& axis, double from, double to) {
  Axis out = axis;
  out.stations.clear();
  from = std::max(from, axis.stations.front().along);
  to = std::min(to, axis.length());
  if (!(from < to)) return out;
  out.stations.push_back(lsystem::station_at(axis, from));
  for (const lsystem::Station& s : axis.stations)
    if (s.along > from && s.along < to) out.stations.push_back(s);
  out.stations.push_back(lsystem::station_at(axis, to));
  std::erase_if(out.nodes, [&](const lsystem::Node& n) { return n.along < from || n.along > to; });
  return out;
}

}  // namespace

lsystem::Drawing cut(const lsystem::Drawing& drawing, const CutOptions& options) {
  lsystem::Drawing out;
  std::vector<uint32_t> kept(drawing.axes.size(), Axis::kNone);
  for (size_t i = 0; i < drawing.axes.size(); ++i) {
    const Axis& axis = drawing.axes[i];
    if (axis.order >= options.orders || axis.stations.size() < 2) continue;
    const bool culm = axis.order == 0;
    if (axis.parent != Axis::kNone) {
      if (kept[axis.parent] == Axis::kNone) continue;
      const Axis& parent = out.axes[kept[axis.parent]];
      if (axis.parent_along < parent.stations.front().along || axis.parent_along > parent.length())
        continue;
    }
    Axis piece = culm ? between(axis, options.from, options.to) : axis;
    if (piece.stations.empty()) continue;
    if (axis.parent != Axis::kNone) piece.parent = kept[axis.parent];
    kept[i] = static_cast<uint32_t>(out.axes.size());
    out.axes.push_back(std::move(piece));
  }
  return out;
}

}  // namespace vug::flora
