// SPDX-License-Identifier: Apache-2.0
// Conditions that a view must meet to be a shot, whatever its score.
#pragma once

#include <vug/scout/view.h>

#include <string>
#include <vector>

namespace vug::scout {

enum class Gate { clearance, nearest, obstruction, flat, shallow, floor, sky, count };

inline constexpr size_t kGates = static_cast<size_t>(Gate::count);

/// The condition in words, for messages: "less than 25 % of the picture is nearer than 2 m".
std::string gate_text(Gate gate);

/// Whether every shot must pass the gate. A view that fails one of the others may be chosen if too
/// few views pass all of them.
bool is_strict(Gate gate);

/// Limits of the gates. Lengths are in metres, shares are fractions of the picture.
struct GateLimits {
  double clearance = 0.3;  ///< The least distance from the eye to any surface.
  double nearest = 0.7;    ///< The least distance in the picture.
  double near = 2;         ///< At most `near_share` of the picture is nearer than this.
  double near_share = 0.25;
  double plane = 0.45;     ///< Share of the largest plane: connected pixels of one normal.
  double depth_ratio = 4;  ///< The least ratio of the median distance to the clearance.
  double least_floor = 0.08, most_floor = 0.45;
  double least_sky = 0.01, most_sky = 0.25;  ///< Share of the sky, if any is seen.
  bool sky_shines = true;  ///< False: the sky is a black hole, of which less than 2 % may be seen.
};

/// The gates that a view with this clearance does not pass; empty: it may be a shot.
std::vector<Gate> failed_gates(const View& view, double clearance, const GateLimits& limits = {});

/// The share of the largest connected region whose normals deviate by less than 10 degrees from
/// that of its first pixel.
double largest_plane(const View& view);

}  // namespace vug::scout
