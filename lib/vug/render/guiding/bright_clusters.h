// Where a scene's surfaces are much brighter than most: shaft walls under an opening, rock beside
// a lamp. They light the rest as lamps do, but paths find them by chance alone.
#pragma once

#include <vug/render/guiding/radiance_sample.h>

#include <cstddef>
#include <vector>

namespace vug::render {

/// A ball around surfaces that are bright.
struct BrightCluster {
  Vec3f center{0, 0, 0};
  float radius = 0;
  float power = 0;  ///< Luminance times area, as if each cube with surface had one face of it.
};

/// At most `most` patches from what paths have seen, by averages over cubes of edge `cube` metres.
/// Cubes far brighter than the mean of all radiance_samples are kept, and parted where that makes
/// balls of much light small. The same patches for the same radiance_samples.
std::vector<BrightCluster> find_bright_clusters(const std::vector<RadianceSample>& radiance_samples,
                                                float cube, size_t most);

}  // namespace vug::render
