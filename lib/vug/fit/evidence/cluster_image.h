// The cluster image that a tree is fitted to where nobody has trained looks.
#pragma once

#include <vug/base/rng.h>
#include <vug/fit/evidence/evidence.h>
#include <vug/fit/evidence/features.h>

namespace vug::fit {

struct ClusterImageOptions {
  int photo_clusters = 2;  ///< 2 to kMostLanes.
  int depth_clusters = 3;  ///< 2 to kMostLanes - 1: holes are one more.
  /// Depths further than this from the middle one, in metres, are no facade's: interiors that shine
  /// through panes, people, trees.
  double depth_range = 1;
  /// Depths that are apart by less than this, in metres, as a pane and its frame, are of one
  /// cluster.
  double min_step = 0.05;
  /// Where depths deviate by less than this, in metres, the facade is flat, and the photo decides.
  double min_relief = 0.01;
};

/// Which cluster each pixel is of. The first one is what windows are most likely made of: of a
/// photo what looks like glass, of depths what lies deepest or has none.
struct ClusterImage {
  int width = 0, height = 0;
  int clusters = 1;
  std::vector<uint8_t> labels;

  Evidence evidence() const { return Evidence::from_clusters(width, height, clusters, labels); }
};

/// One plane, lower where a pixel looks more like a window's than what is around it, a seventh of
/// the picture's height across: glass mirrors the sky, so that it is bluer and darker than stone,
/// and frames are upright edges. Each of these in deviations of its own over the picture, so that
/// light and camera do not matter.
Planes glass_cue(const image::Image& linear);

/// Of a photo (linear R, G, B), or of a plane of depths in metres, larger further away, NaN where
/// nothing came back, or both: then depth decides, unless the facade is flat.
/// Error(bad_input) where neither is given or sizes differ. Work with pictures of a
/// working_size, as statistics are of the whole picture.
ClusterImage cluster_image(const image::Image* linear, const image::Image* depth,
                           const ClusterImageOptions& options, RandomKey key);

}  // namespace vug::fit
