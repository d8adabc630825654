#include <vug/render/guiding/guide.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Edges of the cubes that brightness is averaged over and of the regions that share what they
/// see, in parts of the scene's diagonal.
constexpr float kCube = 1.0f / 64, kRegion = 1.0f / 16;
/// Where patches give less than this part of all light, they are not worth weighing.
constexpr float kLeastTrust = 0.02f;
/// Glances that the mean over all regions counts for in each.
constexpr float kPrior = 2;
/// A cone that is wider, beyond 45 degrees from its axis, says no more than the material does.
constexpr float kWidest = 0.3f;
/// Patches of less than this part of the best one's light are left out.
constexpr float kFaint = 0.02f;

float edge_of(const Box3f& bounds) { return std::max(length(bounds.size()), 1e-3f); }

}  // namespace

Guide::Guide(const std::vector<Sighting>& sightings, const Box3f& bounds)
    : patches_(find_bright_patches(sightings, kCube * edge_of(bounds), Cones::kMost)),
      bounds_(bounds) {
  double mean = 0;
  for (const Sighting& s : sightings) mean += static_cast<double>(s.luminance);
  elsewhere_ =
      kPif * static_cast<float>(mean / std::max(1.0, static_cast<double>(sightings.size())));
  for (size_t i = 0; i < patches_.size(); ++i) {
    x_[i] = patches_[i].centre.x, y_[i] = patches_[i].centre.y, z_[i] = patches_[i].centre.z;
    radius_[i] = patches_[i].radius, power_[i] = patches_[i].power;
  }
  chance_.front().fill(1);
  regions_per_metre_ = 1 / (kRegion * edge_of(bounds));
  const Vec3f size = bounds.size() * regions_per_metre_;
  for (int axis = 0; axis < 3; ++axis)
    regions_[static_cast<size_t>(axis)] = std::max(1, static_cast<int>(std::ceil(size[axis])));
  row_of_.assign(static_cast<size_t>(regions_[0]) * static_cast<size_t>(regions_[1]) *
                     static_cast<size_t>(regions_[2]),
                 0);
}

Guide::Guide(const Guide& patches, const std::vector<Glance>& glances) : Guide(patches) {
  std::fill(row_of_.begin(), row_of_.end(), 0);
  std::vector<Row> reached{Row{}}, tried{Row{}};
  for (const Glance& glance : glances) {
    uint32_t& row = row_of_[region(glance.from)];
    if (row == 0) {
      row = static_cast<uint32_t>(reached.size());
      reached.emplace_back(), tried.emplace_back();
    }
    for (const uint32_t at : {0u, row}) {
      tried[at][glance.patch] += 1;
      reached[at][glance.patch] += glance.reached ? 1.0f : 0.0f;
    }
  }
  chance_.resize(reached.size());
  for (size_t k = 0; k < Cones::kMost; ++k) {
    const float usual = (reached[0][k] + 1) / (tried[0][k] + 2);
    chance_[0][k] = std::sqrt(usual);
    for (size_t row = 1; row < reached.size(); ++row)
      chance_[row][k] = std::sqrt((reached[row][k] + kPrior * usual) / (tried[row][k] + kPrior));
  }
}

size_t Guide::region(const Vec3f& point) const {
  size_t index = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const int count = regions_[static_cast<size_t>(axis)];
    const float along = std::floor((point[axis] - bounds_.min[axis]) * regions_per_metre_);
    const float kept = std::clamp(along, 0.0f, static_cast<float>(count - 1));
    index = index * static_cast<size_t>(count) + static_cast<size_t>(kept);
  }
  return index;
}

Cones Guide::at(const Vec3f& point, const Vec3f& normal) const {
  Cones cones;
  if (empty()) return cones;
  const Row& chance = chance_[row_of_[region(point)]];
  Row light, x, y, z, opening;
  for (size_t i = 0; i < Cones::kMost; ++i) {
    x[i] = x_[i] - point.x, y[i] = y_[i] - point.y, z[i] = z_[i] - point.z;
    const float square = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
    const float distance = std::sqrt(square), scale = 1 / distance;
    // The cosine at the point of the ball that is highest over the surface.
    const float above = x[i] * normal.x + y[i] * normal.y + z[i] * normal.z + radius_[i];
    const float cosine = std::min(1.0f, std::max(0.0f, above * scale));
    x[i] *= scale, y[i] *= scale, z[i] *= scale;
    opening[i] = Cones::opening(radius_[i] * scale);
    light[i] = opening[i] < kWidest ? power_[i] * chance[i] * cosine / square : 0;
  }
  float most = 0, all = 0;
  for (const float each : light) most = std::max(most, each), all += each;
  const float trust = all / (all + elsewhere_);
  if (!(trust > kLeastTrust)) return cones;
  for (uint32_t i = 0; i < patches_.size(); ++i)
    if (light[i] > kFaint * most) cones.add({x[i], y[i], z[i]}, opening[i], light[i], i);
  cones.settle(trust);
  return cones;
}

}  // namespace vug::render
