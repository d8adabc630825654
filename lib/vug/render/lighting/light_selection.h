// What a choice between lights is asked for, and what it answers.
#pragma once

#include <vug/render/light.h>

#include <algorithm>
#include <array>

namespace vug::render {

/// By what lights are chosen.
enum class LightSampler {
  tree,    ///< What they may matter where they are looked at from.
  uniform  ///< Nothing: each is as likely as any other.
};

/// How next-event estimation at one place shares its samples out between branches of lights.
struct LightSelection {
  float samples = 1;  ///< At most so many lights are chosen, none twice.
  LightSampler sampler = LightSampler::tree;
  /// Of each branch a factor of its importance, by how often it is in sight (see VisibilityCache);
  /// null where nothing is known.
  const float* visibility = nullptr;
  float proportional = 0;  ///< Samples to expect for each unit of weight,
  float even = 0;          ///< and beside these for each branch that matters.

  /// Samples to expect for a branch of that weight, at most 1. Importance knows nothing of walls,
  /// so a light behind one must not take the choices from the one that shines: the even part
  /// keeps any branch's share above a least one (a defensive mixture: Hesterberg 1995, "Weighted
  /// average importance sampling and defensive mixture distributions", cite hesterberg1995).
  float expected_samples(float weight) const {
    return weight > 0 ? std::min(1.0f, proportional * weight + even) : 0;
  }
};

/// Which light next-event estimation turns to, and with what probability.
struct LightChoice {
  LightId light = kNoLight;
  float probability = 0;
  float visibility = 1;  ///< The factor of its branch, by how often that is in sight.
};

/// The lights that one place turns to.
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
