#include <vug/render/guiding/guide.h>
#include <vug/render/sampling.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Edges of the cubes that brightness is averaged over and of the regions that share what they
/// see, in parts of the scene's diagonal.
constexpr float kCube = 1.0f / 64, kRegion = 1.0f / 16;
/// Where patches give less than this part of all light, they are not worth weighing.
constexpr float kLeastTrust = 0.02f;
/// A cone that is wider, beyond 45 degrees from its axis, says no more than the material does.
constexpr float kWidest = 0.3f;
/// Patches of less than this part of the best one's light are left out.
constexpr float kFaint = 0.02f;
/// Patches are weighed so many at a time.
constexpr size_t kLanes = 8;

}  // namespace

Guide::Guide(const std::vector<Sighting>& sightings, const Box3f& bounds)
    : patches_(find_bright_patches(sightings, kCube * diagonal_of(bounds), Cones::kMost)),
      bounds_(bounds) {
  elsewhere_ = kPif * static_cast<float>(mean_luminance(sightings));
  for (size_t i = 0; i < patches_.size(); ++i) {
    x_[i] = patches_[i].centre.x, y_[i] = patches_[i].centre.y, z_[i] = patches_[i].centre.z;
    radius_[i] = patches_[i].radius, power_[i] = patches_[i].power;
  }
}

void Guide::learn(const std::vector<Glance>& glances) {
  chances_ = Chances(bounds_, kRegion, Cones::kMost, glances);
}

Cones Guide::at(const Vec3f& point, const Vec3f& normal) const {
  Cones cones;
  if (empty()) return cones;
  static constexpr Row kAll = [] {
    Row all{};
    for (float& each : all) each = 1;
    return all;
  }();
  const float* const chance = chances_.empty() ? kAll.data() : chances_.at(point);
  const size_t size = patches_.size();
  Row light, x, y, z, opening;
  __m256 most = _mm256_setzero_ps(), all = _mm256_setzero_ps();
  for (size_t first = 0; first < size; first += kLanes) {
    for (size_t i = first; i < first + kLanes; ++i) {
      x[i] = x_[i] - point.x, y[i] = y_[i] - point.y, z[i] = z_[i] - point.z;
      const float square = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
      const float distance = std::sqrt(square), scale = 1 / distance;
      // The cosine at the point of the ball that is highest over the surface.
      const float above = x[i] * normal.x + y[i] * normal.y + z[i] * normal.z + radius_[i];
      const float cosine = std::min(1.0f, std::max(0.0f, above * scale));
      x[i] *= scale, y[i] *= scale, z[i] *= scale;
      const float sine = radius_[i] * scale;
      opening[i] = one_minus_cosine(sine * sine);
      light[i] = opening[i] < kWidest ? power_[i] * chance[i] * cosine / square : 0;
    }
    most = _mm256_max_ps(most, _mm256_load_ps(&light[first]));
    all = _mm256_add_ps(all, _mm256_load_ps(&light[first]));
  }
  const float sum = sum_of_lanes(all), trust = sum / (sum + elsewhere_);
  if (!(trust > kLeastTrust)) return cones;
  const __m256 faint = _mm256_set1_ps(kFaint * most_of_lanes(most));
  for (size_t i = 0; i < size; i += kLanes) {
    const auto row = [&](const Row& of) { return _mm256_load_ps(&of[i]); };
    const __m256 bright = _mm256_cmp_ps(row(light), faint, _CMP_GT_OQ);
    cones.add({row(x), row(y), row(z), row(opening), row(light), static_cast<uint32_t>(i)},
              static_cast<unsigned>(_mm256_movemask_ps(bright)));
  }
  cones.settle(trust);
  return cones;
}

}  // namespace vug::render
