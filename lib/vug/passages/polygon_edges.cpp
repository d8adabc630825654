// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/polygon_edges.h>
#include <vug/passages/sweep/batch_box.h>
#include <vug/passages/sweep/capsule_list.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr float kFarAway = 1e30f;

PlaneRectangle rectangle(const Vec2d& low, const Vec2d& high) {
  return {0.5 * (low + high), 0.5 * (high - low)};
}

}  // namespace

PlaneRectangle rectangle_around(const Pack* u, const Pack* v, int count) {
  Pack low_u = u[0], high_u = u[0], low_v = v[0], high_v = v[0];
  for (int i = 1; i < count; ++i) {
    low_u = min(low_u, u[i]);
    high_u = max(high_u, u[i]);
    low_v = min(low_v, v[i]);
    high_v = max(high_v, v[i]);
  }
  return rectangle({static_cast<double>(lowest(low_u)), static_cast<double>(lowest(low_v))},
                   {static_cast<double>(highest(high_u)), static_cast<double>(highest(high_v))});
}

PlaneRectangle rectangle_around(const double* u, const double* v, int count) {
  const auto [low_u, high_u] = std::minmax_element(u, u + count);
  const auto [low_v, high_v] = std::minmax_element(v, v + count);
  return rectangle({*low_u, *low_v}, {*high_u, *high_v});
}

EdgeLanes::EdgeLanes(const std::vector<Edge>& edges) {
  if (edges.size() < kFewest || edges.size() > kMost) return;
  lanes_.resize((edges.size() + Pack::kLanes - 1) / Pack::kLanes);
  for (size_t i = 0; i < Pack::kLanes * lanes_.size(); ++i) {
    Lanes& lanes = lanes_[i / Pack::kLanes];
    const size_t lane = i % Pack::kLanes;
    const bool rest = i >= edges.size();  // Far from all points, and never crossed.
    const Edge& edge = edges[std::min(i, edges.size() - 1)];
    for (int axis = 0; axis < 2; ++axis) {
      lanes.a[axis][lane] = rest ? kFarAway : static_cast<float>(edge.a[axis]);
      lanes.along[axis][lane] = rest ? 0 : static_cast<float>(edge.along[axis]);
    }
    lanes.inverse[lane] = static_cast<float>(edge.inverse);
    lanes.low[lane] = rest ? kFarAway : static_cast<float>(std::min(edge.a.y, edge.b.y));
    lanes.high[lane] = rest ? -kFarAway : static_cast<float>(std::max(edge.a.y, edge.b.y));
    size_ = std::max(size_, edge.a.length());
  }
}

/// The distance of each edge from a point differs from that at the centre by at most the radius.
EdgeLanes::Selection EdgeLanes::select(const PlaneRectangle& points) const {
  using field::clamp, field::square;
  constexpr double kRounding = 1e-5;
  const Vec2d& centre = points.centre;
  const double margin = kRounding * (size_ + centre.length() + points.half.length());
  const Pack u(centre.x), v(centre.y), zero(0.0), one(1.0);
  const Pack low(centre.y - points.half.y - margin), high(centre.y + points.half.y + margin);
  Selection out;
  out.packs_ = lanes_.size();
  Pack squares[sizeof(out.near_)], least(1e30);
  for (size_t k = 0; k < lanes_.size(); ++k) {
    const Lanes& lanes = lanes_[k];
    const Pack pu = u - Pack::load(lanes.a[0]), pv = v - Pack::load(lanes.a[1]),
               along_u = Pack::load(lanes.along[0]), along_v = Pack::load(lanes.along[1]);
    const Pack t = clamp((pu * along_u + pv * along_v) * Pack::load(lanes.inverse), zero, one);
    squares[k] = square(pu - along_u * t) + square(pv - along_v * t);
    least = min(least, squares[k]);
    out.crossed_[k] = static_cast<uint8_t>(
        bits_of(both(Pack::load(lanes.low) <= high, Pack::load(lanes.high) >= low)));
  }
  const double nearest = std::sqrt(static_cast<double>(lowest(least)));
  const Pack most(square(nearest + 2 * points.half.length() + margin));
  for (size_t k = 0; k < lanes_.size(); ++k) {
    out.near_[k] = static_cast<uint8_t>(bits_of(squares[k] <= most));
    out.crossed_[k] &= static_cast<uint8_t>(~out.near_[k]);
  }
  return out;
}

}  // namespace vug::passages
