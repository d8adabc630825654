// SPDX-License-Identifier: Apache-2.0
// Interface of samplers: the uniform numbers in [0, 1) of a path, addressed by dimension.
#pragma once

#include <vug/base/vec.h>

#include <array>
#include <cstdint>
#include <memory>

namespace vug::render {

/// Identifies a sample of a pixel. Samplers may use it in any way but must not keep state.
struct SampleId {
  uint32_t x = 0;
  uint32_t y = 0;
  uint32_t index = 0;  ///< 0 <= index < spp.
  uint32_t spp = 1;
  uint64_t seed = 0;
};

using FourPairs = std::array<Vec2f, 4>;

/// Stateless: the same id and dimension give the same bits, in any order and on any thread.
class Sampler {
 public:
  virtual ~Sampler() = default;
  /// Returns two numbers for dimension pair `dimension`.
  virtual Vec2f pair(const SampleId& id, uint32_t dimension) const = 0;
  /// Returns one number; `single` and `pair` share one count of dimensions.
  virtual float single(const SampleId& id, uint32_t dimension) const {
    return pair(id, dimension).x;
  }
  /// The pairs of this dimension and the next three.
  virtual FourPairs four_pairs(const SampleId& id, uint32_t dimension) const {
    return {pair(id, dimension), pair(id, dimension + 1), pair(id, dimension + 2),
            pair(id, dimension + 3)};
  }
};
using SamplerPtr = std::shared_ptr<const Sampler>;

/// Hands out dimensions in order along one path.
class SampleCursor {
 public:
  SampleCursor(const Sampler& sampler, const SampleId& id) : sampler_(sampler), id_(id) {}
  Vec2f pair() { return sampler_.pair(id_, dimension_++); }
  FourPairs four_pairs() {
    dimension_ += 4;
    return sampler_.four_pairs(id_, dimension_ - 4);
  }
  float single() { return sampler_.single(id_, dimension_++); }
  /// Skips to the first dimension of a bounce, so that earlier branches of the path do not shift
  /// the numbers that follow.
  void jump(uint32_t dimension) { dimension_ = dimension; }

 private:
  const Sampler& sampler_;
  SampleId id_;
  uint32_t dimension_ = 0;
};

}  // namespace vug::render
