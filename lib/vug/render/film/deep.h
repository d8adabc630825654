// SPDX-License-Identifier: Apache-2.0
// Deep pixels: merges the samples of a pixel into a few samples with depth.
#pragma once

#include <vug/image/deep.h>
#include <vug/render/film/region.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vug::render {

class Film;

struct DeepOptions {
  double tolerance = 0.01;  ///< Surfaces within this relative difference of depth are merged.
  size_t max_samples = 16;  ///< Per pixel; beyond this, the samples closest in depth are merged.

  bool operator==(const DeepOptions&) const = default;
};

inline constexpr float kDeepSky = 1e10f;

/// One valid sample of a deep pixel. Only surfaces have a depth: light scattered by a medium is
/// stored with the surface behind it, and light from the environment, or from a light in front of
/// it, at kDeepSky. Films keep the fragments until they are developed, because merging some of them
/// earlier would round differently.
struct DeepFragment {
  uint32_t sample = 0;  ///< Index of the sample in its pixel.
  float depth = kDeepSky;
  float alpha = 0;
  float r = 0, g = 0, b = 0;  ///< Radiance, limited to +-kMaxLight.

  bool operator==(const DeepFragment&) const = default;
};

/// The samples of a deep pixel from its fragments in the order of sample indices. Compositing them
/// gives the means of the fragments: each sample covers its share of the pixel as seen through the
/// samples in front, so its alpha is that share divided by the share that they leave visible.
std::vector<image::DeepSample> merge_fragments(std::span<const DeepFragment> fragments,
                                               const DeepOptions& options);

/// Writes the deep pixels of a film into the picture, whose pixel (0, 0) is the top left corner of
/// `origin`.
void develop(const Film& film, const DeepOptions& options, const Region& origin,
             image::DeepImage& picture);

}  // namespace vug::render
