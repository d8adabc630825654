// SPDX-License-Identifier: Apache-2.0
// Parameters and result of the choice of lights, which light_set.h makes.
#pragma once

#include <vug/render/light.h>
#include <vug/render/lighting/light_tree.h>

#include <algorithm>
#include <array>

namespace vug::render {

/// How lights are chosen.
enum class LightSampler {
  tree,    ///< By their estimated contribution at the shading point.
  uniform  ///< All lights with the same probability.
};

/// Number of light samples at one shading point and their distribution over the branches of the
/// light set.
struct LightSelection {
  float samples = 1;  ///< Largest number of lights chosen; no light is chosen twice.
  LightSampler sampler = LightSampler::tree;
  /// For each branch a factor on its importance from its visibility (see VisibilityCache); null if
  /// nothing is known.
  const float* visibility = nullptr;
  float proportional = 0;  ///< Expected samples per unit of weight; set by the choice.
  float even = 0;  ///< Expected samples added to each branch of nonzero weight; set by the choice.

  /// Expected number of samples of a branch of that weight, at most 1. Importance ignores
  /// occlusion, so a light behind a wall must not take all samples from a visible one: the uniform
  /// part gives each branch a minimum share (a defensive mixture: Hesterberg 1995, "Weighted
  /// average importance sampling and defensive mixture distributions", cite hesterberg1995).
  float expected_samples(float weight) const {
    return weight > 0 ? std::min(1.0f, proportional * weight + even) : 0;
  }
};

/// A light chosen for next-event estimation and its probability.
struct LightChoice {
  LightId light = kNoLight;
  float probability = 0;
  float visibility = 1;  ///< The visibility factor of its branch.
};

/// The lights chosen at one shading point.
class LightChoices {
 public:
  static constexpr size_t kMax = 8;
  void add(const LightChoice& choice) {
    if (size_ < kMax) choices_[size_++] = choice;
  }
  size_t size() const { return size_; }
  const LightChoice* begin() const { return choices_.data(); }
  const LightChoice* end() const { return choices_.data() + size_; }

 private:
  std::array<LightChoice, kMax> choices_;
  size_t size_ = 0;
};

}  // namespace vug::render
