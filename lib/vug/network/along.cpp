// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/network/along.h>
#include <vug/network/reduction.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::network {
namespace {

constexpr double kMostPoints = 1e6;  ///< As many as iterations of a loop in a scene.

/// Appends `count` points that divide the branch evenly, each in the middle of its share.
void add_points(const Network& network, const Branch& branch, size_t count,
                std::vector<Vec3d>& points) {
  const double step = branch.length / static_cast<double>(count);
  double passed = 0;  // Metres up to the current leg.
  size_t leg = 0;
  const auto station = [&](size_t i) {
    return network.stations[static_cast<size_t>(branch.stations[i])].position;
  };
  for (size_t i = 0; i < count; ++i) {
    const double at = step * (static_cast<double>(i) + 0.5);
    double length = (station(leg + 1) - station(leg)).length();
    while (passed + length < at && leg + 2 < branch.stations.size()) {
      passed += length;
      ++leg;
      length = (station(leg + 1) - station(leg)).length();
    }
    const double share = length > 0 ? std::clamp((at - passed) / length, 0.0, 1.0) : 0;
    points.push_back(station(leg) + (station(leg + 1) - station(leg)) * share);
  }
}

}  // namespace

std::vector<Vec3d> points_along(const Network& network, double spacing) {
  if (!(spacing > 0))
    throw Error(ErrorCode::bad_input,
                fmt::format("the spacing along the network is {} m; it must be positive", spacing),
                {}, "use a distance such as 5m");
  const Reduction reduction = reduce(network);
  double total = 0;
  for (const Branch& branch : reduction.branches) total += branch.length / spacing;
  if (!(total <= kMostPoints))
    throw Error(
        ErrorCode::too_large,
        fmt::format("a spacing of {} m gives {:.3g} points along the network; at most {:.0f} "
                    "are possible",
                    spacing, total, kMostPoints),
        {},
        fmt::format("use a spacing of at least {:.2g} m", 1.01 * spacing * total / kMostPoints));
  std::vector<Vec3d> points;
  for (const Branch& branch : reduction.branches) {
    const double shares = std::max(1.0, std::round(branch.length / spacing));
    add_points(network, branch, static_cast<size_t>(shares), points);
  }
  return points;
}

}  // namespace vug::network
