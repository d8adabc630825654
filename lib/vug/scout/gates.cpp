// SPDX-License-Identifier: Apache-2.0
#include <vug/render/vectors.h>
#include <vug/scout/gates.h>
#include <vug/scout/regions.h>

#include <algorithm>

namespace vug::scout {
namespace {

constexpr float kSamePlane = 0.9848f;  // cosine of 10 degrees
constexpr float kLevel = 0.7f;         // of the normals of a floor

double share(const View& view, bool (*counts)(const Seen&)) {
  const auto n = std::count_if(view.pixels.begin(), view.pixels.end(), counts);
  return static_cast<double>(n) / static_cast<double>(view.pixels.size());
}

}  // namespace

std::string gate_text(Gate gate) {
  static const char* const kTexts[kGates] = {
      "the eye is at least 0.3 m from all surfaces",
      "nothing in the picture is nearer than 0.7 m",
      "less than 25 % of the picture is nearer than 2 m",
      "no plane covers 45 % of the picture",
      "the median distance is 4 times that to the nearest surface around the eye",
      "the floor covers 8 to 45 % of the picture",
      "the sky covers at most 25 % of the picture, and a hole without light 2 %"};
  return kTexts[static_cast<size_t>(gate)];
}

bool is_strict(Gate gate) {
  return gate == Gate::clearance || gate == Gate::nearest || gate == Gate::sky;
}

double largest_plane(const View& view) {
  // Each region grows around its first pixel, so that a curved wall does not become one plane.
  const std::vector<Region> regions =
      connected_regions(view, [&](const Seen& seed, const Seen&, const Seen& next) {
        return next.object != kSky && render::dot(seed.normal, next.normal) > kSamePlane;
      });
  size_t largest = 0;
  for (const Region& each : regions)
    if (!each.sky) largest = std::max(largest, each.pixels);
  return static_cast<double>(largest) / static_cast<double>(view.pixels.size());
}

std::vector<Gate> failed_gates(const View& view, double clearance, const GateLimits& limits) {
  std::vector<Gate> failed;
  const auto require = [&](bool holds, Gate gate) {
    if (!holds) failed.push_back(gate);
  };
  double nearest = kInfinity, near = 0;
  for (const Seen& each : view.pixels) {
    const double distance = static_cast<double>(each.distance);
    nearest = std::min(nearest, distance);
    if (distance < limits.near) ++near;
  }
  near /= static_cast<double>(view.pixels.size());
  const double floor =
      share(view, [](const Seen& each) { return each.object != kSky && each.normal.y > kLevel; });
  const double sky = share(view, [](const Seen& each) { return each.object == kSky; });
  require(clearance > limits.clearance, Gate::clearance);
  require(nearest > limits.nearest, Gate::nearest);
  require(near < limits.near_share, Gate::obstruction);
  require(largest_plane(view) < limits.plane, Gate::flat);
  require(median_distance(view) > limits.depth_ratio * clearance, Gate::shallow);
  require(floor >= limits.least_floor && floor <= limits.most_floor, Gate::floor);
  constexpr double kHole = 0.02;
  require(sky == 0 ||
              (limits.sky_shines ? sky >= limits.least_sky && sky <= limits.most_sky : sky < kHole),
          Gate::sky);
  return failed;
}

}  // namespace vug::scout
