// SPDX-License-Identifier: Apache-2.0
#include <vug/render/paths/boundary_hits.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Face 2a + s is the low (s = 0) or high side of axis a; its grid spans the two following axes.
int axis_of(int face) { return face / 2; }
int across(int face) { return (axis_of(face) + 1) % 3; }
int next_axis_of(int face) { return (axis_of(face) + 2) % 3; }

}  // namespace

BoundaryHits::BoundaryHits(const Box3f& box)
    : box_(box), counts_(std::make_unique<std::atomic<uint32_t>[]>(6 * kCells * kCells)) {}

void BoundaryHits::count(const Ray& ray) {
  float nearest = kFar;
  int face = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float d = ray.direction[axis];
    if (d == 0) continue;
    const float t = ((d > 0 ? box_.max : box_.min)[axis] - ray.origin[axis]) / d;
    if (t < nearest) nearest = t, face = 2 * axis + (d > 0 ? 1 : 0);
  }
  const Vec3f at = ray.at(std::max(nearest, 0.0f));
  const auto cell = [&](int axis) {
    const float size = box_.max[axis] - box_.min[axis];
    const float part = size > 0 ? (at[axis] - box_.min[axis]) / size : 0;
    return std::clamp(static_cast<int>(part * kCells), 0, kCells - 1);
  };
  const int place = (face * kCells + cell(next_axis_of(face))) * kCells + cell(across(face));
  counts_[static_cast<size_t>(place)].fetch_add(1, std::memory_order_relaxed);
}

uint64_t BoundaryHits::rays(int face, int u, int v) const {
  return counts_[static_cast<size_t>((face * kCells + v) * kCells + u)].load();
}

std::vector<BoundaryHits::CellGroup> BoundaryHits::groups() const {
  std::vector<CellGroup> found;
  std::vector<bool> seen(6 * kCells * kCells, false);
  for (int start = 0; start < 6 * kCells * kCells; ++start) {
    std::vector<int> open = {start};
    CellGroup group;
    group.face = start / (kCells * kCells);
    while (!open.empty()) {
      const int place = open.back();
      open.pop_back();
      const int u = place % kCells, v = place / kCells % kCells;
      if (seen[static_cast<size_t>(place)] || rays(group.face, u, v) == 0) continue;
      seen[static_cast<size_t>(place)] = true;
      group.u0 = std::min(group.u0, u), group.u1 = std::max(group.u1, u);
      group.v0 = std::min(group.v0, v), group.v1 = std::max(group.v1, v);
      group.rays += rays(group.face, u, v);
      // Cells two apart count as connected, since a few rays leave gaps.
      for (int dv = -2; dv <= 2; ++dv)
        for (int du = -2; du <= 2; ++du)
          if (u + du >= 0 && u + du < kCells && v + dv >= 0 && v + dv < kCells)
            open.push_back(place + dv * kCells + du);
    }
    if (group.rays > 0) found.push_back(group);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const CellGroup& a, const CellGroup& b) { return a.rays > b.rays; });
  return found;
}

RectangleParams BoundaryHits::rectangle(const CellGroup& group, int margin) const {
  const int axis = axis_of(group.face), a = across(group.face), b = next_axis_of(group.face);
  const Vec3d low(box_.min), size(box_.max - box_.min);
  const auto edge = [&](int on, int cell) {
    return low[on] + size[on] * std::clamp(cell, 0, kCells) / kCells;
  };
  const double a0 = edge(a, group.u0 - margin), a1 = edge(a, group.u1 + 1 + margin);
  const double b0 = edge(b, group.v0 - margin), b1 = edge(b, group.v1 + 1 + margin);
  RectangleParams r;
  const bool high = group.face % 2 == 1;
  r.center[axis] = high ? static_cast<double>(box_.max[axis]) : low[axis];
  r.center[a] = 0.5 * (a0 + a1);
  r.center[b] = 0.5 * (b0 + b1);
  r.normal = Vec3d(0);
  r.normal[axis] = high ? -1 : 1;
  r.up.emplace(0.0)[b] = 1;
  r.width = a1 - a0;
  r.height = b1 - b0;
  return r;
}

std::vector<RectangleParams> BoundaryHits::rectangles(size_t most, int margin) const {
  std::vector<RectangleParams> all;
  for (const CellGroup& group : groups())
    if (all.size() < most) all.push_back(rectangle(group, margin));
  return all;
}

}  // namespace vug::render
