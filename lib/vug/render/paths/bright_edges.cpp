// SPDX-License-Identifier: Apache-2.0
#include <vug/raytree/path_scheduler.h>
#include <vug/render/paths/bright_edges.h>
#include <vug/render/paths/vertex.h>

#include <algorithm>

namespace vug::render {
namespace {

constexpr uint64_t kEdgeSalt = 0x65646765ull;
/// A difference above this fraction of the brightest value is an edge, not a gradient of the sky.
constexpr float kDifference = 0.2f;

struct ValueRange {
  float min = kFar, max = 0;
  void include(const ValueRange& other) {
    min = std::min(min, other.min), max = std::max(max, other.max);
  }
};

}  // namespace

BrightEdges::BrightEdges(const PreparedScene& world, const Region& region,
                         const Vec2i& width_height, const Sampling& sampling, Progress& progress)
    : region_(region) {
  const Region wide = Region{region.x0 - 1, region.y0 - 1, region.x1 + 1, region.y1 + 1}.overlap(
      {0, 0, width_height.x, width_height.y});
  std::vector<ValueRange> seen(wide.pixels());
  progress.begin("looking for bright edges", static_cast<uint64_t>(wide.height()));
  const auto width = static_cast<size_t>(wide.width());
  raytree::parallel_interleaved(wide.pixels(), [&](size_t pixel) {
    if (pixel % width == 0) progress.check();
    SampleId id;
    id.seed = sampling.seed ^ kEdgeSalt, id.spp = sampling.rays_per_pixel;
    id.x = static_cast<uint32_t>(wide.x0) + static_cast<uint32_t>(pixel % width);
    id.y = static_cast<uint32_t>(wide.y0) + static_cast<uint32_t>(pixel / width);
    for (id.index = 0; id.index < sampling.rays_per_pixel; ++id.index) {
      TrackingRng tracking(Vec2f(static_cast<float>(id.index), static_cast<float>(id.x)));
      const float bright =
          luminance(camera_emission(world, sampling.camera_ray(id), tracking, nullptr));
      seen[pixel].include({bright, bright});
    }
    if (pixel % width == width - 1) progress.advance();
  });
  progress.end();
  edges_.resize(region.pixels());
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) {
      ValueRange around;
      const Region across = Region{x - 1, y, x + 2, y + 1}.overlap(wide);
      const Region along = Region{x, y - 1, x + 1, y + 2}.overlap(wide);
      for (int u = across.x0; u < across.x1; ++u) around.include(seen[wide.index(u, y)]);
      for (int v = along.y0; v < along.y1; ++v) around.include(seen[wide.index(x, v)]);
      edges_[region.index(x, y)] = around.max - around.min > kDifference * around.max;
    }
}

}  // namespace vug::render
