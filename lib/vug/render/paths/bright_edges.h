// SPDX-License-Identifier: Apache-2.0
// The edges of bright areas in a picture: of lights, crystals and openings to the sky.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/film/region.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/sampler.h>

#include <functional>
#include <vector>

namespace vug::render {

/// The pixels at such edges. Most of their noise depends on the side of the edge on which a sample
/// falls; a few more camera rays remove it at a lower cost than more samples.
class BrightEdges {
 public:
  struct Sampling {
    uint32_t rays_per_pixel = 1;
    uint64_t seed = 0;
    std::function<Ray(const SampleId&)> camera_ray;  ///< The ray of a sample.
  };

  /// No edges.
  BrightEdges() = default;
  /// Examines the pixels of the region and their neighbours. `width_height` is the size of the
  /// whole picture. A pixel has the same result in any region. Error(cancelled).
  BrightEdges(const PreparedScene& world, const Region& region, const Vec2i& width_height,
              const Sampling& sampling, Progress& progress);

  /// Whether a pixel of the region is at an edge.
  bool at(int x, int y) const { return !edges_.empty() && edges_[region_.index(x, y)] != 0; }

 private:
  Region region_;
  std::vector<uint8_t> edges_;
};

}  // namespace vug::render
