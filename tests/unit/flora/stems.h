// SPDX-License-Identifier: Apache-2.0
// Stems for tests of sweeps.
#pragma once

#include <vug/base/bezier.h>
#include <vug/flora/tube.h>

namespace vug::flora {

/// A culm of `nodes` internodes along a Bezier curve bent by gravity, with two branches at each
/// node of the upper half, on alternating sides.
inline lsystem::Axis bent_culm(double height = 3, double radius = 0.04, int nodes = 10,
                               double tip = 1.2) {
  const ArcBezier curve(drooping(height, 0.05, tip, 0.4, 0.5));
  lsystem::Axis axis;
  constexpr int kStations = 60;
  Frame frame = level_frame(curve.tangent(0));
  for (int i = 0; i <= kStations; ++i) {
    const double along = curve.length() * i / kStations;
    const Vec3d at = curve.point(along);
    if (i > 0) frame = transported(frame, axis.stations.back().position, at, curve.tangent(along));
    axis.stations.push_back({at, frame, radius * (1 - 0.9 * i / kStations), along, 3});
  }
  for (int i = 0; i < nodes; ++i) {
    lsystem::Node node{height * i / nodes, 1, {}};
    if (2 * i > nodes) {
      const Frame there = lsystem::station_at(axis, node.along).frame;
      node.branches = {(there.normal * (i % 2 ? 1 : -1) + there.tangent).normalized()};
    }
    axis.nodes.push_back(node);
  }
  return axis;
}

/// A branch with mitred bends: straight between bends of 25 degrees.
inline lsystem::Axis folded_branch() {
  lsystem::Axis axis;
  axis.order = 1;
  Vec3d at(0.3, 0, -0.2);
  Frame frame = level_frame({1, 0.4, 0.2});
  for (int i = 0; i <= 4; ++i) {
    axis.stations.push_back({at, frame, 0.012 * (1 - 0.2 * i), 0.3 * i, 1});
    at += frame.tangent * 0.3;
    if (i > 0) axis.nodes.push_back({0.3 * i, 1, {}});
    frame = frame.rotated(i % 2 ? frame.normal : frame.binormal, 0.43);
  }
  return axis;
}

inline SweepOptions plain_sweep() { return {}; }

/// Hollow and cut: one and a half internodes between open ends.
inline SweepOptions open_sweep() {
  SweepOptions options;
  options.wall = 0.25;
  options.open = true;
  return options;
}

inline SweepOptions hollow_sweep() {
  SweepOptions options;
  options.wall = 0.25;
  return options;
}

inline SweepOptions thick_sweep() {
  SweepOptions options = open_sweep();
  options.min_wall = 0.011;
  return options;
}

}  // namespace vug::flora
