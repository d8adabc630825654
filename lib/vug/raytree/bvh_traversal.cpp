// SPDX-License-Identifier: Apache-2.0
#include <vug/raytree/bvh_traversal.h>
#include <vug/raytree/simd.h>

#include <bit>
#include <cmath>

namespace vug::raytree {
namespace {

/// Compare-exchange of lane pairs: the lesser value goes to the lanes of the mask.
template <int lanes>
__m256i exchanged(__m256i v, __m256i with) {
  const __m256i other = _mm256_permutevar8x32_epi32(v, with);
  return _mm256_blend_epi32(_mm256_max_epi32(v, other), _mm256_min_epi32(v, other), lanes);
}

/// Sorts in descending order with Batcher's network (Knuth 1998, "The art of computer programming",
/// volume 3, section 5.3.4).
__m256i sorted(__m256i v) {
  v = exchanged<0b10101010>(v, _mm256_setr_epi32(1, 0, 3, 2, 5, 4, 7, 6));
  v = exchanged<0b11001100>(v, _mm256_setr_epi32(2, 3, 0, 1, 6, 7, 4, 5));
  v = exchanged<0b01000100>(v, _mm256_setr_epi32(0, 2, 1, 3, 4, 6, 5, 7));
  v = exchanged<0b11110000>(v, _mm256_setr_epi32(4, 5, 6, 7, 0, 1, 2, 3));
  v = exchanged<0b00110000>(v, _mm256_setr_epi32(0, 1, 4, 5, 2, 3, 6, 7));
  return exchanged<0b01010100>(v, _mm256_setr_epi32(0, 2, 1, 4, 3, 6, 5, 7));
}

template <int lanes>
__m128i exchanged(__m128i v, __m128i other) {
  return _mm_blend_epi32(_mm_max_epi32(v, other), _mm_min_epi32(v, other), lanes);
}
/// Sorts the first `count` of four lanes in descending order, with half the steps.
__m128i sorted(__m128i v, int count) {
  v = _mm_or_si128(v, _mm_cmpgt_epi32(_mm_setr_epi32(1, 2, 3, 4), _mm_set1_epi32(count)));
  v = exchanged<0b1010>(v, _mm_shuffle_epi32(v, 0b10110001));
  v = exchanged<0b1100>(v, _mm_shuffle_epi32(v, 0b00011011));
  return exchanged<0b1010>(v, _mm_shuffle_epi32(v, 0b10110001));
}

template <int lane>
__m256 broadcast(__m128 v) {
  return _mm256_broadcastss_ps(_mm_permute_ps(v, lane * 0x55));
}

/// Distances along the ray to eight planes.
template <int axis>
__m256 distances(const uint8_t* planes, __m128 step, __m128 first) {
  const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(planes));
  const __m256 numbers = _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(bytes));
  return _mm256_fmadd_ps(numbers, broadcast<axis>(step), broadcast<axis>(first));
}

/// One corner of four triangles, relative to the origin of a ray along z.
struct Corner {
  __m128 x, y, z;
  /// Swaps the two pairs of triangles.
  Corner swapped() const {
    return {_mm_permute_ps(x, 0x4e), _mm_permute_ps(y, 0x4e), _mm_permute_ps(z, 0x4e)};
  }
};
/// Twice the signed area between the ray and an edge; exactly the negative of that of the reversed
/// edge.
__m128 area(const Corner& from, const Corner& to) {
  return _mm_sub_ps(_mm_mul_ps(from.x, to.y), _mm_mul_ps(from.y, to.x));
}

}  // namespace

// NOLINTNEXTLINE: the stack is written before it is read, all other members below
BvhTraversal::BvhTraversal(const WideBvh& bvh, const Ray& ray, float distance, Query query)
    : bvh_(bvh),
      far_(distance),
      stage_(bvh.empty()           ? ended
             : query == Query::any ? node_any
                                   : node_closest) {
  // Bound of the rounding errors of the subtractions and multiplications below.
  float extent = bvh.extent();
  for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, std::fabs(ray.origin[axis]));
  const float slack = extent * 0x1p-20f;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<size_t>(axis);
    const float along = ray.direction[axis];
    origin_[i] = ray.origin[axis];
    inverse_[i] = 1 / (std::fabs(along) < 1e-18f ? std::copysign(1e-18f, along) : along);
    slack_[i] = std::fabs(inverse_[i]) * slack;
    near_[i] = static_cast<uint32_t>(8 * i) + (inverse_[i] < 0 ? 24 : 0);
  }
  origin_[3] = inverse_[3] = slack_[3] = 0;
  const auto steep = [&](int axis) { return std::fabs(ray.direction[axis]); };
  const int z = steep(0) > steep(1) ? (steep(0) > steep(2) ? 0 : 2) : (steep(1) > steep(2) ? 1 : 2);
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  axes_ = {static_cast<uint32_t>(x), static_cast<uint32_t>(y), static_cast<uint32_t>(z)};
  shear_[2] = 1 / ray.direction[z];
  shear_[0] = ray.direction[x] * shear_[2], shear_[1] = ray.direction[y] * shear_[2];
}

std::array<Vec3f, 3> BvhTraversal::corners() const {
  const WideBvh::Leaf& in = leaf();
  const size_t lane = lane_, turn = in.geometry[lane] >> WideBvh::kTurnShift;
  const auto at = [](const std::array<std::array<float, 4>, 3>& v, size_t i) {
    return Vec3f(v[0][i], v[1][i], v[2][i]);
  };
  const std::array<Vec3f, 3> first{at(in.v0, lane), at(in.v1, lane), at(in.v1, lane ^ 2u)};
  return {first[(3 - turn) % 3], first[(4 - turn) % 3], first[(5 - turn) % 3]};
}

template <BvhTraversal::Stage stage>
inline void BvhTraversal::step() {
  constexpr bool any = stage == node_any || stage == leaf_any;
  if constexpr (stage == node_closest) intersect_node<Query::closest>(bvh_.node(next_));
  if constexpr (stage == node_any) intersect_node<Query::any>(bvh_.node(next_));
  if constexpr (stage >= leaf_closest) {
    intersect_leaf(next_);
    if (any && hit()) stack_size_ = 0;
  }
  const auto far = std::bit_cast<int32_t>(far_);
  do {
    if (stack_size_ == 0) {
      stage_ = ended;
      return;
    }
    --stack_size_;
  } while (!any && distances_[stack_size_] > far);
  next_ = children_[stack_size_];
  const bool is_leaf = (next_ & WideBvh::kLeaf) != 0;
  const void* const memory = bvh_.address(next_);
  __builtin_prefetch(memory);
  __builtin_prefetch(static_cast<const char*>(memory) + 64);
  stage_ = static_cast<Stage>((is_leaf ? leaf_closest : node_closest) + (any ? 1 : 0));
}

void BvhTraversal::run() {
  while (stage_ != ended) switch (stage_) {
      case node_closest:
        step<node_closest>();
        break;
      case node_any:
        step<node_any>();
        break;
      case leaf_closest:
        step<leaf_closest>();
        break;
      default:
        step<leaf_any>();
    }
}

void TraversalBatch::add(size_t slot, BvhTraversal& traversal) {
  traversals_[slot] = &traversal;
  Queue& queue = now_[traversal.stage()];
  queue.slots[queue.size++] = static_cast<uint8_t>(slot);
}

template <BvhTraversal::Stage stage>
void TraversalBatch::step_all() {
  Queue& queue = now_[stage];
  for (size_t i = 0; i < queue.size; ++i) {
    const uint8_t slot = queue.slots[i];
    BvhTraversal& traversal = *traversals_[slot];
    traversal.step<stage>();
    Queue& then = next_[traversal.stage()];
    then.slots[then.size++] = slot;
  }
  queue.size = 0;
}

std::span<const uint8_t> TraversalBatch::step() {
  next_[BvhTraversal::ended].size = 0;
  step_all<BvhTraversal::node_closest>();
  step_all<BvhTraversal::node_any>();
  step_all<BvhTraversal::leaf_closest>();
  step_all<BvhTraversal::leaf_any>();
  std::swap(now_, next_);
  const Queue& back = now_[BvhTraversal::ended];
  return {back.slots.data(), back.size};
}

/// Williams, Barrus, Morley, Shirley 2005, "An efficient and robust ray-box intersection algorithm"
/// (cite williams2005boxes), for eight boxes.
template <BvhTraversal::Query query>
inline void BvhTraversal::intersect_node(const WideBvh::Node& node) {
  const __m128 inverse = _mm_load_ps(inverse_.data()), slack = _mm_load_ps(slack_.data());
  const __m128 from = _mm_sub_ps(_mm_load_ps(node.origin.data()), _mm_load_ps(origin_.data()));
  const __m128 first = _mm_mul_ps(from, inverse);
  const __m128 step = _mm_mul_ps(_mm_load_ps(node.step.data()), inverse);
  const __m128 in = _mm_sub_ps(first, slack), out = _mm_add_ps(first, slack);
  const uint8_t* const planes = node.planes[0].data();
  const __m256 in_x = distances<0>(planes + near_[0], step, in);
  const __m256 in_y = distances<1>(planes + near_[1], step, in);
  const __m256 in_z = distances<2>(planes + near_[2], step, in);
  // The opposite planes are 24 bytes after or before.
  const __m256 out_x = distances<0>(planes + (24 - near_[0]), step, out);
  const __m256 out_y = distances<1>(planes + (40 - near_[1]), step, out);
  const __m256 out_z = distances<2>(planes + (56 - near_[2]), step, out);
  const __m256 enters =
      _mm256_max_ps(_mm256_max_ps(in_x, in_y), _mm256_max_ps(in_z, _mm256_setzero_ps()));
  const __m256 leaves =
      _mm256_min_ps(_mm256_min_ps(out_x, out_y), _mm256_min_ps(out_z, _mm256_broadcast_ss(&far_)));
  const __m256 met = _mm256_cmp_ps(enters, leaves, _CMP_LE_OQ);
  const auto mask = static_cast<unsigned>(_mm256_movemask_ps(met));
  const int count = std::popcount(mask);
  __m256i order = compressed_lanes(mask);
  if (query == Query::closest) {
    // The child index replaces the last bits of the distance, so both are sorted together.
    __m256i all = _mm256_and_si256(_mm256_castps_si256(enters), _mm256_set1_epi32(~7));
    all = _mm256_or_si256(all, _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    if (count <= 4) [[likely]] {
      const __m256i few = _mm256_permutevar8x32_epi32(all, order);
      order = _mm256_zextsi128_si256(sorted(_mm256_castsi256_si128(few), count));
    } else {
      const __m256i none = _mm256_set1_epi32(-1);
      order = sorted(_mm256_blendv_epi8(none, all, _mm256_castps_si256(met)));
    }
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(&distances_[stack_size_]), order);
  }
  const __m256i children = _mm256_load_si256(reinterpret_cast<const __m256i*>(node.child.data()));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(&children_[stack_size_]),
                      _mm256_permutevar8x32_epi32(children, order));
  stack_size_ += static_cast<uint32_t>(count);
}

/// Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection" (cite woop2013watertight): by
/// the signs of areas projected along the ray. All triangles that share a corner compute the same
/// projection. Rounding may make an area zero but never changes its sign, and zero counts as inside
/// on both sides. So no ray passes between two triangles, and the paper's fallback to double
/// precision is not needed.
inline void BvhTraversal::intersect_leaf(uint32_t number) {
  const WideBvh::Leaf& leaf = bvh_.leaf(number);
  // A shear aligns the ray with z.
  const __m128 shear_x = _mm_broadcast_ss(&shear_[0]), shear_y = _mm_broadcast_ss(&shear_[1]);
  const auto project = [&](const std::array<std::array<float, 4>, 3>& corners) {
    const auto along = [&](size_t axis) {
      return _mm_sub_ps(_mm_load_ps(corners[axes_[axis]].data()),
                        _mm_broadcast_ss(&origin_[axes_[axis]]));
    };
    const __m128 z = along(2);
    return Corner{_mm_fnmadd_ps(shear_x, z, along(0)), _mm_fnmadd_ps(shear_y, z, along(1)), z};
  };
  const Corner a = project(leaf.v0), b = project(leaf.v1), c = b.swapped();
  const __m128 u = area(b, c), v = area(c, a), w = area(a, b);
  const __m128 zero = _mm_setzero_ps();
  const __m128 least = _mm_min_ps(_mm_min_ps(u, v), w), most = _mm_max_ps(_mm_max_ps(u, v), w);
  const __m128 inside =
      _mm_or_ps(_mm_cmp_ps(least, zero, _CMP_GE_OQ), _mm_cmp_ps(most, zero, _CMP_LE_OQ));
  const __m128 all = _mm_add_ps(_mm_add_ps(u, v), w);
  const __m128 depth = _mm_fmadd_ps(u, a.z, _mm_fmadd_ps(v, b.z, _mm_mul_ps(w, c.z)));
  const __m128 distance = _mm_div_ps(_mm_mul_ps(depth, _mm_broadcast_ss(&shear_[2])), all);
  const __m128 ahead = _mm_and_ps(_mm_cmp_ps(distance, zero, _CMP_GE_OQ),
                                  _mm_cmp_ps(distance, _mm_broadcast_ss(&far_), _CMP_LT_OQ));
  const __m128 met = _mm_and_ps(_mm_and_ps(inside, ahead), _mm_cmp_ps(all, zero, _CMP_NEQ_OQ));
  alignas(16) std::array<float, 4> distances{};
  _mm_store_ps(distances.data(), distance);
  for (auto mask = static_cast<unsigned>(_mm_movemask_ps(met)); mask != 0; mask &= mask - 1) {
    const auto lane = static_cast<uint32_t>(std::countr_zero(mask));
    if (distances[lane] < far_) far_ = distances[lane], leaf_ = number, lane_ = lane;
  }
}

}  // namespace vug::raytree
