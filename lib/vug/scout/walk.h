// SPDX-License-Identifier: Apache-2.0
// The places of a scene where a person can stand.
#pragma once

#include <vug/render/prepared_scene.h>

#include <vector>

namespace vug::scout {

/// A place to stand.
struct Stand {
  Vec3d floor;
  double headroom = 0;  ///< Metres to the ceiling above the floor; infinite in the open.
};

struct WalkOptions {
  double step = 1;        ///< Metres between neighbours.
  double climb = 0.9;     ///< The greatest step up in metres.
  double drop = 1.2;      ///< The greatest step down in metres.
  double headroom = 0.9;  ///< The least height to crouch through in metres.
  size_t most = 6000;     ///< The number of places at which the search ends.
};

/// The places that a person can reach from the floor below any of the starts, at most 30 m below.
/// Neighbours lie on a square grid; the way between them is free at the height of the chest. The
/// order depends on the starts only.
std::vector<Stand> walkable_floor(const render::PreparedScene& world,
                                  const std::vector<Vec3d>& starts,
                                  const WalkOptions& options = {});

/// Points in the air of the scene's bounds, for scenes without a camera or a network: those of a
/// grid with at least half a metre of free space around them.
std::vector<Vec3d> points_in_air(const render::PreparedScene& world);

}  // namespace vug::scout
