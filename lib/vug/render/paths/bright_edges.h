// SPDX-License-Identifier: Apache-2.0
// Where in a picture something that shines ends: the rims of lights, of crystals, of holes to the
// sky.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/film/region.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/sampler.h>

#include <functional>
#include <vector>

namespace vug::render {

/// There most of the noise is whether a sample falls on one side or the other, and a few more
/// camera rays take it away for less than more samples would.
class BrightEdges {
 public:
  struct Sampling {
    uint32_t looks = 1;  ///< Camera rays for each pixel.
    uint64_t seed = 0;
    std::function<Ray(const SampleId&)> camera_ray;  ///< The ray of a sample.
  };

  /// None.
  BrightEdges() = default;
  /// Looks through each pixel of the region, and through those around it. `width_height` of the
  /// whole picture. The same pixels for any region that they are in. Error(cancelled).
  BrightEdges(const PreparedScene& world, const Region& region, const Vec2i& width_height,
              const Sampling& sampling, Progress& progress);

  /// Whether a pixel is one; not for pixels outside of the region.
  bool at(int x, int y) const { return !edges_.empty() && edges_[region_.index(x, y)] != 0; }

 private:
  Region region_;
  std::vector<uint8_t> edges_;
};

}  // namespace vug::render
