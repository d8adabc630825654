// SPDX-License-Identifier: Apache-2.0
#include <vug/render/guiding/guide.h>
#include <vug/render/sampling.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Edges of the cubes that average luminance and of the regions that share visibility, as fractions
/// of the scene's diagonal.
constexpr float kCube = 1.0f / 64, kVisibilityRegion = 1.0f / 16;
/// Clusters that give less than this fraction of all light are ignored.
constexpr float kMinMixtureWeight = 0.02f;
/// A wider cone, beyond 45 degrees from its axis, is no better than BSDF sampling.
constexpr float kWidest = 0.3f;
/// Clusters with less than this fraction of the best one's light are left out.
constexpr float kFaint = 0.02f;
/// Number of clusters weighted at a time.
constexpr size_t kLanes = 8;

}  // namespace

Guide::Guide(const std::vector<RadianceSample>& radiance_samples, const Box3f& bounds)
    : clusters_(
          find_bright_clusters(radiance_samples, kCube * diagonal_of(bounds), ConeMixture::kMax)),
      bounds_(bounds) {
  elsewhere_ = kPif * static_cast<float>(mean_luminance(radiance_samples));
  for (size_t i = 0; i < clusters_.size(); ++i) {
    x_[i] = clusters_[i].center.x, y_[i] = clusters_[i].center.y, z_[i] = clusters_[i].center.z;
    radius_[i] = clusters_[i].radius, power_[i] = clusters_[i].power;
  }
}

void Guide::update_visibility(const std::vector<VisibilitySample>& visibility_samples) {
  visibility_ = VisibilityCache(bounds_, kVisibilityRegion, ConeMixture::kMax, visibility_samples);
}

ConeMixture Guide::at(const Vec3f& point, const Vec3f& normal) const {
  ConeMixture cones;
  if (empty()) return cones;
  static constexpr Values kAll = [] {
    Values all{};
    for (float& each : all) each = 1;
    return all;
  }();
  const float* const chance = visibility_.empty() ? kAll.data() : visibility_.at(point);
  const size_t size = clusters_.size();
  Values light, x, y, z, opening;
  __m256 most = _mm256_setzero_ps(), all = _mm256_setzero_ps();
  for (size_t first = 0; first < size; first += kLanes) {
    for (size_t i = first; i < first + kLanes; ++i) {
      x[i] = x_[i] - point.x, y[i] = y_[i] - point.y, z[i] = z_[i] - point.z;
      const float square = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
      const float distance = std::sqrt(square), scale = 1 / distance;
      // Cosine at the sphere's highest point above the surface.
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
  const float sum = lane_sum(all), mixture_weight = sum / (sum + elsewhere_);
  if (!(mixture_weight > kMinMixtureWeight)) return cones;
  const __m256 faint = _mm256_set1_ps(kFaint * lane_max(most));
  for (size_t i = 0; i < size; i += kLanes) {
    const auto row = [&](const Values& of) { return _mm256_load_ps(&of[i]); };
    const __m256 bright = _mm256_cmp_ps(row(light), faint, _CMP_GT_OQ);
    cones.add({row(x), row(y), row(z), row(opening), row(light), static_cast<uint32_t>(i)},
              static_cast<unsigned>(_mm256_movemask_ps(bright)));
  }
  cones.normalize(mixture_weight);
  return cones;
}

}  // namespace vug::render
