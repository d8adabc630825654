// SPDX-License-Identifier: Apache-2.0
// Clusters of surfaces that are much brighter than average: shaft walls under an opening, rock next
// to a light. They act as virtual area lights, which paths would otherwise find only by chance.
#pragma once

#include <vug/render/guiding/radiance_sample.h>

#include <cstddef>
#include <vector>

namespace vug::render {

/// Bounding sphere of a cluster of bright surfaces.
struct BrightCluster {
  Vec3f center{0, 0, 0};
  float radius = 0;
  float power = 0;  ///< Luminance times area; each cube with surface counts as one of its faces.
};

/// Returns at most `most` clusters, from averages of the samples over cubes of edge `cube` metres.
/// Cubes far brighter than the mean of all samples are kept, and groups of cubes are split where
/// that makes bright spheres smaller. The same samples give the same clusters.
std::vector<BrightCluster> find_bright_clusters(const std::vector<RadianceSample>& radiance_samples,
                                                float cube, size_t most);

}  // namespace vug::render
