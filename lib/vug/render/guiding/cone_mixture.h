// SPDX-License-Identifier: Apache-2.0
// A density over directions: a mixture of a few cones, each uniform inside.
#pragma once

#include <vug/render/simd.h>
#include <vug/render/vectors.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace vug::render {

/// At most kMax weighted cones, built for each point that samples directions.
class ConeMixture {  // NOLINT: only what has been added is read
 public:
  static constexpr size_t kMax = 32;

  /// Eight candidate cones. Axis: unit; opening: 1 - cosine at the rim; opening, share > 0. `id` is
  /// the caller's id of the first; the others' ids follow it.
  struct Batch {
    __m256 x, y, z, opening, share;
    uint32_t id;
  };

  size_t size() const { return size_; }
  /// Adds the cones whose mask bits are set; at most kMax in all.
  void add(const Batch& all, unsigned mask) {
    const __m256i order = compressed_lanes(mask);
    const auto put = [&](Values& row, __m256 v) {
      _mm256_storeu_ps(&row[size_], _mm256_permutevar8x32_ps(v, order));
    };
    put(x_, all.x), put(y_, all.y), put(z_, all.z), put(open_, all.opening);
    put(share_, all.share);
    const __m256i ids = _mm256_add_epi32(order, _mm256_set1_epi32(static_cast<int>(all.id)));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(&ids_[size_]), ids);
    size_ += static_cast<size_t>(std::popcount(mask));
  }
  /// Normalizes the shares to a sum of 1, and sets the weight of the mixture among all sampling.
  void normalize(float mixture_weight);
  /// 0 to 1; 0 without cones.
  float mixture_weight() const { return mixture_weight_; }

  /// Chooses a cone by its share. This function, `id` and `sample` need at least one cone.
  size_t choose(float u) const { return find(u).cone; }
  uint32_t id(size_t cone) const { return ids_[cone]; }
  Vec3f sample(const Vec2f& u) const;
  /// With respect to solid angle.
  float pdf(const Vec3f& direction) const {
    const __m256 x = _mm256_set1_ps(direction.x), y = _mm256_set1_ps(direction.y),
                 z = _mm256_set1_ps(direction.z), one = _mm256_set1_ps(1);
    __m256 sum = _mm256_setzero_ps();
    for (size_t i = 0; i < size_; i += kLanes) {
      const auto row = [&](const Values& of) { return _mm256_load_ps(&of[i]); };
      const __m256 cosine =
          _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(row(x_), x), _mm256_mul_ps(row(y_), y)),
                        _mm256_mul_ps(row(z_), z));
      const __m256 within = _mm256_cmp_ps(_mm256_sub_ps(one, cosine), row(open_), _CMP_LE_OQ);
      sum = _mm256_add_ps(sum, _mm256_and_ps(within, row(density_)));
    }
    return lane_sum(sum);
  }

 private:
  static constexpr size_t kLanes = 8;
  using Values = std::array<float, kMax + kLanes>;  ///< One value per cone, with room for a full
                                                    ///< write of eight.
  struct SelectedCone {
    size_t cone;
    float within;  ///< Position of u within the cone's share, 0 to 1.
  };
  SelectedCone find(float u) const;

  alignas(32) Values x_, y_, z_, open_, share_, density_;
  std::array<uint32_t, kMax + kLanes> ids_;
  size_t size_ = 0;
  float mixture_weight_ = 0;
};

}  // namespace vug::render
