// SPDX-License-Identifier: Apache-2.0
// The cluster image that a tree is fitted to when no pixel classifier has been trained.
#pragma once

#include <vug/base/rng.h>
#include <vug/fit/evidence/evidence.h>
#include <vug/fit/evidence/features.h>

namespace vug::fit {

struct ClusterImageOptions {
  int photo_clusters = 2;  ///< 2 to kMaxLanes.
  int depth_clusters = 3;  ///< 2 to kMaxLanes - 1: holes are one more cluster.
  /// Depths further than this from the median depth, in metres, do not belong to the facade:
  /// interiors behind panes, people, trees.
  double depth_range = 1;
  /// Clusters of depths closer than this, in metres, are merged, such as a pane and its frame.
  double min_step = 0.05;
  /// If the deviation of the depths is below this, in metres, the facade counts as flat and the
  /// photo decides.
  double min_relief = 0.01;
};

/// The cluster of each pixel. The first cluster is the most likely window: in a photo the pixels
/// that look like glass, in depths the deepest ones and the holes.
struct ClusterImage {
  int width = 0, height = 0;
  int clusters = 1;
  std::vector<uint8_t> labels;

  Evidence evidence() const { return Evidence::from_clusters(width, height, clusters, labels); }
};

/// One plane with lower values where a pixel looks more like window glass than its surroundings (a
/// box of a seventh of the picture's height): glass reflects the sky, so it is bluer and darker
/// than stone, and frames are vertical edges. Each cue is divided by its standard deviation over
/// the picture, which removes the influence of lighting and camera.
Planes glass_cue(const image::Image& linear);

/// Clusters a photo (linear R, G, B), a plane of depths, or both; with both, depth decides unless
/// the facade is flat. Depths are in metres, larger further away, NaN without a return.
/// Error(bad_input) if both are missing or the sizes differ. Expects pictures of a working_size,
/// because the statistics cover the whole picture.
ClusterImage cluster_image(const image::Image* linear, const image::Image* depth,
                           const ClusterImageOptions& options, RandomKey key);

}  // namespace vug::fit
