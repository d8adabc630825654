// SPDX-License-Identifier: Apache-2.0
#include <vug/render/guiding/cone_mixture.h>
#include <vug/render/sampling.h>

#include <algorithm>

namespace vug::render {

void ConeMixture::normalize(float mixture_weight) {
  if (size_ == 0) return;
  mixture_weight_ = mixture_weight;
  const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  __m256 sum = _mm256_setzero_ps();
  for (size_t i = 0; i < size_; i += kLanes) {
    // Lanes behind the last cone hold cones that were not added.
    const __m256i left = _mm256_set1_epi32(static_cast<int>(size_ - i));
    const __m256 taken = _mm256_castsi256_ps(_mm256_cmpgt_epi32(left, lanes));
    const __m256 share = _mm256_and_ps(taken, _mm256_load_ps(&share_[i]));
    _mm256_store_ps(&share_[i], share);
    sum = _mm256_add_ps(sum, share);
  }
  const __m256 all = _mm256_set1_ps(1 / lane_sum(sum)), turn = _mm256_set1_ps(2 * kPif);
  for (size_t i = 0; i < size_; i += kLanes) {
    const __m256 share = _mm256_mul_ps(_mm256_load_ps(&share_[i]), all);
    const __m256 density = _mm256_div_ps(share, _mm256_mul_ps(turn, _mm256_load_ps(&open_[i])));
    const __m256 any = _mm256_cmp_ps(share, _mm256_setzero_ps(), _CMP_GT_OQ);
    _mm256_store_ps(&share_[i], share);
    _mm256_store_ps(&density_[i], _mm256_and_ps(any, density));
  }
}

ConeMixture::SelectedCone ConeMixture::find(float u) const {
  size_t i = 0;
  float before = 0;
  while (i + 1 < size_ && u >= before + share_[i]) before += share_[i++];
  return {i, std::clamp((u - before) / share_[i], 0.0f, 0.99999994f)};
}

Vec3f ConeMixture::sample(const Vec2f& u) const {
  const auto [i, within] = find(u.x);
  return Frame({x_[i], y_[i], z_[i]}).to_world(direction_off_axis(open_[i] * within, u.y));
}

}  // namespace vug::render
